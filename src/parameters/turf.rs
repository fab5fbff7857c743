//! Kinds of ground by name: a choice that sets the numbers of the ground.

use super::presets::{Preset, PresetEntry, entry};
use super::table::Setup;
use crate::error::{Error, Result};

/// Group of the parameters of the ground, and the one of them that the flight depends on too.
const GROUP: &str = "ground.";
const HEIGHT: &str = "ground.height";

const PENNER: &str = "Penner (2002)";
const ROLLING: &str = "Penner (2001)";
const FIRM: &str = "chosen beside TrackMan's chart of 2010: runs of its 60 drives within 6 yd (rms), docs/sources.md";
const SOFT: &str = "assumed, so that a drive of the PGA tour runs 10 yd, as FlightScope has it, docs/sources.md";
const SOFT_ROLLING: &str = "assumed: half as much again as Penner (2001) fits on a fairway, docs/sources.md";
const EMBEDS: &str = "the ball embeds";

/// The kinds of ground. None of them is measured: a run is known to 10 yd at best.
pub static TURFS: &[Preset] = &[
    Preset {
        name: "firm",
        about: "a firm, dry fairway",
        entries: &[
            entry("ground.restitution", "0.65", FIRM),
            entry("ground.friction", "0.4", PENNER),
            entry("ground.compliance", "15.4 deg", PENNER),
            entry("ground.rolling", "0.7", FIRM),
        ],
    },
    Preset {
        name: "average",
        about: "Penner's numbers",
        entries: &[
            entry("ground.restitution", "0.51", PENNER),
            entry("ground.friction", "0.4", PENNER),
            entry("ground.compliance", "15.4 deg", PENNER),
            entry("ground.rolling", "1", ROLLING),
        ],
    },
    Preset {
        name: "soft",
        about: "a soft fairway",
        entries: &[
            entry("ground.restitution", "0.4", SOFT),
            entry("ground.friction", "0.4", PENNER),
            entry("ground.compliance", "26 deg", SOFT),
            entry("ground.rolling", "1.5", SOFT_ROLLING),
        ],
    },
    Preset {
        name: "wet",
        about: "wet ground, in which the ball embeds: no run, as in Winfield & Tan (1994)",
        entries: &[
            entry("ground.restitution", "none", EMBEDS),
            entry("ground.friction", "0.4", PENNER),
            entry("ground.compliance", "15.4 deg", PENNER),
            entry("ground.rolling", "1", ROLLING),
        ],
    },
];

impl super::Parameter {
    /// Whether only the run of the ball on the ground depends on it, and nothing before.
    pub fn is_of_the_run(&self) -> bool {
        self.name.starts_with(GROUP) && self.name != HEIGHT
    }
}

impl Setup<f64> {
    /// Sets the numbers of a kind of ground: restitution, friction, compliance and rolling. The slopes stay.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn set_turf(&mut self, name: &str) -> Result<()> {
        let name = name.trim();
        let turf = TURFS.iter().find(|turf| turf.name == name).ok_or_else(|| {
            let names = TURFS.iter().map(|turf| turf.name);
            let advice = format!("the kinds are {}", names.clone().collect::<Vec<_>>().join(", "));
            Error::unknown("kind of ground", name, names, advice)
        })?;
        for entry in turf.entries {
            let parameter = self.parameter(entry.name)?;
            self.set_value(parameter, parameter.read(entry.value, false)?)?;
        }
        Ok(())
    }

    /// The kind of ground whose numbers these are; `None` where they are others.
    pub fn turf(&self) -> Option<&'static Preset> {
        let is_so = |entry: &PresetEntry| {
            let Ok(parameter) = self.parameter(entry.name) else { return false };
            parameter.read(entry.value, false).is_ok_and(|value| value == self.value(parameter))
        };
        // a ball that embeds does not ask for the rest
        let embeds = |turf: &Preset| self.ground.restitution.is_none() && turf.name == "wet";
        TURFS.iter().find(|turf| embeds(turf) || turf.entries.iter().all(is_so))
    }
}

#[cfg(test)]
mod tests {
    use super::{Setup, TURFS};

    #[test]
    fn every_kind_of_ground_is_told_by_its_numbers() {
        assert_eq!(Setup::default().turf().map(|turf| turf.name), Some("average"));
        for turf in TURFS {
            let mut setup = Setup::default();
            setup.set("ground.turf", turf.name).unwrap();
            setup.validate().unwrap();
            assert_eq!(setup.turf().map(|found| found.name), Some(turf.name));
            setup.ground.restitution = Some(0.3);
            assert!(setup.turf().is_none());
        }
        let message = Setup::default().set("ground.turf", "frim").unwrap_err().to_string();
        assert!(message.contains("did you mean 'firm'?") && message.contains("firm, average, soft, wet"), "{message}");
    }

    #[test]
    fn the_kind_of_ground_is_set_before_its_numbers() {
        let mut setup = Setup::default();
        setup.set_all([("ground.rolling", "0.4"), ("ground.turf", "firm")]).unwrap();
        assert_eq!((setup.ground.rolling, setup.ground.compliance), (0.4, 15.4_f64.to_radians()));
        let text = "[ground]\nrolling = 0.4\nturf = 'firm'";
        assert_eq!(Setup::from_toml(text, "a.toml").unwrap(), setup);
        assert!(setup.variable("ground.turf").is_err());
    }
}
