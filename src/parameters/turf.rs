//! Turfs by name: presets of the parameters of the ground.

use super::declare::{Parameter, ParameterGroup};
use super::presets::{Preset, PresetEntry, entry};
use super::table::Setup;
use crate::error::{Error, Result};

/// Name of the setting that selects a turf: `ground.turf = "firm"`.
pub const TURF: &str = "ground.turf";

/// The only parameter of the ground that changes the flight.
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

impl Parameter {
    /// True if the parameter affects the run only, not the flight.
    pub fn affects_only_run(&self) -> bool {
        self.group == ParameterGroup::Ground && self.name != HEIGHT
    }
}

/// The names of the parameters that a turf sets, the same for every turf.
fn turf_parameters() -> impl Iterator<Item = &'static str> {
    TURFS[0].entries.iter().map(|entry| entry.name)
}

/// Refuses a turf if all of its numbers are also given: the turf would have no effect.
///
/// # Errors
/// [`Error::Together`] for a turf without effect.
pub(super) fn refuse_idle_turf(is_given: impl Fn(&str) -> bool) -> Result<()> {
    let names: Vec<_> = turf_parameters().collect();
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

    /// The parameters that the setting `name` sets: the numbers of the ground for a turf, otherwise
    /// the parameter of this name. The other choices set none.
    pub fn set_by(&self, name: &str) -> Vec<&'static Parameter> {
        let names = if name == TURF {
            turf_parameters().collect()
        } else {
            vec![name]
        };
        names
            .into_iter()
            .filter_map(|name| self.parameter(name).ok())
            .collect()
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
