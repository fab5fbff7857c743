//! Turfs by name: presets of the parameters of the ground.

use super::presets::{Preset, PresetEntry, entry};
use super::table::Setup;
use crate::error::{Error, Result};

/// Name of the setting that selects a turf: `ground.turf = "firm"`.
pub const TURF: &str = "ground.turf";

/// Prefix of the names of the parameters of the ground.
const GROUP: &str = "ground.";
/// The parameter of the ground that the flight depends on.
const HEIGHT: &str = "ground.height";

const PENNER: &str = "Penner (2002)";
const ROLLING: &str = "Penner (2001)";
const FIRM: &str = "chosen to agree with TrackMan's chart of 2010: runs of its 60 drives within \
                    6 yd (rms), docs/sources.md";
const SOFT: &str =
    "assumed, so that a drive of the PGA tour runs 10 yd, as FlightScope states, docs/sources.md";
const SOFT_ROLLING: &str =
    "assumed: half as much again as Penner (2001) fits on a fairway, docs/sources.md";
const EMBEDS: &str = "the ball embeds";

/// The turfs. None of them is measured: the run is uncertain by at least 10 yd.
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
    /// True if the parameter affects the run only, not the flight.
    pub fn affects_only_run(&self) -> bool {
        self.name.starts_with(GROUP) && self.name != HEIGHT
    }
}

/// Refuses a turf if all of its numbers are also given: the turf would have no effect.
///
/// # Errors
/// [`Error::Together`] for a turf without effect.
pub(super) fn refuse_idle_turf(is_given: impl Fn(&str) -> bool) -> Result<()> {
    let names: Vec<_> = TURFS[0].entries.iter().map(|entry| entry.name).collect();
    if !is_given(TURF) || !names.iter().all(|name| is_given(name)) {
        return Ok(());
    }
    let names = names.join(", ");
    let given = format!("{TURF} is given together with all of its numbers ({names})");
    let reason = format!(
        "stated numbers override the turf's, so the turf has no effect; delete {TURF}, or delete \
         the numbers that it should give"
    );
    Err(Error::Together { given, reason })
}

impl Setup<f64> {
    /// Sets the numbers of a turf: restitution, friction, compliance and rolling; not the slopes.
    ///
    /// # Errors
    /// [`Error::Unknown`], with the nearest name, if no turf has this name.
    pub fn set_turf(&mut self, name: &str) -> Result<()> {
        let name = name.trim();
        let turf = TURFS.iter().find(|turf| turf.name == name).ok_or_else(|| {
            let names = TURFS.iter().map(|turf| turf.name);
            let advice = format!(
                "the turfs are {}",
                names.clone().collect::<Vec<_>>().join(", ")
            );
            Error::unknown("turf", name, names, advice)
        })?;
        for entry in turf.entries {
            let parameter = self.parameter(entry.name)?;
            self.set_value(parameter, parameter.read(entry.value, false)?)?;
        }
        Ok(())
    }

    /// The turf whose numbers this setup has; `None` if no turf has them.
    pub fn turf(&self) -> Option<&'static Preset> {
        let matches = |entry: &PresetEntry| {
            let Ok(parameter) = self.parameter(entry.name) else {
                return false;
            };
            parameter
                .read(entry.value, false)
                .is_ok_and(|value| value == self.value(parameter))
        };
        // without a restitution the ball embeds, as on the turf "wet", and the other numbers have
        // no effect
        let embeds = |turf: &Preset| self.ground.restitution.is_none() && turf.name == "wet";
        TURFS
            .iter()
            .find(|turf| embeds(turf) || turf.entries.iter().all(matches))
    }
}

#[cfg(test)]
mod tests {
    use super::super::file::SetupFile;
    use super::{Setup, TURFS};

    #[test]
    fn every_turf_is_recognised_by_its_numbers() {
        assert_eq!(
            Setup::default().turf().map(|turf| turf.name),
            Some("average")
        );
        for turf in TURFS {
            let mut setup = Setup::default();
            setup.set("ground.turf", turf.name).unwrap();
            setup.validate().unwrap();
            assert_eq!(setup.turf().map(|found| found.name), Some(turf.name));
            setup.ground.restitution = Some(0.3);
            assert!(setup.turf().is_none());
        }
        let message = Setup::default()
            .set("ground.turf", "frim")
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("unknown turf 'frim'; did you mean 'firm'?")
                && message.contains("the turfs are firm, average, soft, wet"),
            "{message}"
        );
    }

    #[test]
    fn the_turf_is_set_before_its_numbers() {
        let mut setup = Setup::default();
        setup
            .set_all([("ground.rolling", "0.4"), ("ground.turf", "firm")])
            .unwrap();
        assert_eq!(
            (setup.ground.rolling, setup.ground.compliance),
            (0.4, 15.4_f64.to_radians())
        );
        let text = "preset = 'modern-driver'\n[ground]\nrolling = 0.4\nturf = 'firm'";
        assert_eq!(SetupFile::read(text, "a.toml").unwrap().setup, setup);
        assert!(setup.variable("ground.turf").is_err());
    }

    #[test]
    fn a_turf_beside_all_of_its_numbers_is_refused() {
        let numbers = "friction = '0.4'\ncompliance = '15.4 deg'\nrolling = '1'\nslope = '0 deg'\n";
        let text = |restitution: &str| {
            format!("[ground]\nrestitution = '{restitution}'\nturf = 'firm'\n{numbers}")
        };
        for restitution in ["0.51", "none"] {
            let message = SetupFile::read(&text(restitution), "a.toml")
                .unwrap_err()
                .to_string();
            let says = "ground.turf is given together with all of its numbers \
                        (ground.restitution, ground.friction, ground.compliance, \
                        ground.rolling): stated numbers override the turf's, so the turf has no \
                        effect; delete ground.turf, or delete the numbers that it should give";
            assert_eq!(message, format!("a.toml:3:1: {says}"));
            let remedied = text(restitution).replace("turf = 'firm'\n", "");
            assert!(SetupFile::read(&remedied, "a.toml").is_ok());
        }
        let firm = SetupFile::read("[ground]\nturf = 'firm'\nslope = '0 deg'", "a.toml")
            .unwrap()
            .setup;
        assert_eq!(firm.turf().unwrap().name, "firm");
        let all = ["restitution", "friction", "compliance", "rolling"]
            .map(|name| format!("ground.{name}"));
        let all = all
            .iter()
            .map(|name| (&**name, if name.ends_with("e") { "15 deg" } else { "0.5" }));
        let mut settings: Vec<(&str, &str)> = all.chain([("ground.turf", "firm")]).collect();
        assert!(
            Setup::default()
                .set_all(settings.clone())
                .unwrap_err()
                .to_string()
                .contains("the turf has no effect")
        );
        settings.remove(0);
        assert!(Setup::default().set_all(settings).is_ok());
    }
}
