//! Parameters without an effect in a setup, because of the values of other parameters.

use super::table::Setup;
use crate::units::Message;

/// A parameter that has no effect in some setups.
struct Idle {
    name: &'static str,
    /// True for a setup in which no drive depends on the parameter.
    is_idle: fn(&Setup<f64>) -> bool,
    reason: &'static str,
}

const IDLE: [Idle; 10] = [
    Idle {
        name: "wind.reference_height",
        is_idle: |setup| setup.wind.roughness.is_none(),
        reason: "without wind.roughness the wind is the same at every height",
    },
    Idle {
        name: "wind.roughness",
        is_idle: |setup| {
            let wind = &setup.wind;
            let level = wind.right.hypot(wind.downrange);
            wind.speed.unwrap_or(level) == 0.0 && wind.up == 0.0
        },
        reason: "there is no wind; give wind.downrange and wind.right, or wind.speed and wind.from",
    },
    Idle {
        name: "wind.from",
        is_idle: |setup| setup.wind.speed == Some(0.0),
        reason: "wind.speed is 0",
    },
    Idle {
        name: "swing.shaft_growth",
        is_idle: |setup| {
            let bends = [setup.swing.shaft_bend, setup.swing.shaft_droop];
            bends.iter().all(|bend| bend.is_none_or(|bend| bend == 0.0))
        },
        reason: "the shaft neither bends nor droops; set swing.shaft_bend or swing.shaft_droop too",
    },
    Idle {
        name: "impact.tangential_restitution",
        is_idle: |setup| setup.impact.friction == Some(0.0),
        reason: "impact.friction is 0",
    },
    Idle {
        name: "ground.friction",
        is_idle: embeds,
        reason: EMBEDS,
    },
    Idle {
        name: "ground.compliance",
        is_idle: embeds,
        reason: EMBEDS,
    },
    Idle {
        name: "ground.rolling",
        is_idle: embeds,
        reason: EMBEDS,
    },
    Idle {
        name: "ground.slope",
        is_idle: embeds,
        reason: EMBEDS,
    },
    Idle {
        name: "ground.side_slope",
        is_idle: embeds,
        reason: EMBEDS,
    },
];

const EMBEDS: &str =
    "the ball stays where it lands; give ground.restitution or another ground.turf";

fn embeds(setup: &Setup<f64>) -> bool {
    setup.ground.restitution.is_none()
}

/// Warnings about those of the parameters `names` that have no effect in any of these setups. A
/// parameter with its default value has no warning. Parameters with the same reason share a
/// warning.
///
/// ```
/// use longdrive::{Setup, parameters::idle_warnings};
/// let mut setup = Setup::modern_driver();
/// setup.set("wind.reference_height", "3 m").unwrap();
/// let warnings = idle_warnings(["wind.reference_height"], &[setup]);
/// assert!(warnings[0].to_string().contains("without wind.roughness"));
/// ```
pub fn idle_warnings<'a>(
    names: impl IntoIterator<Item = &'a str>,
    setups: &[Setup<f64>],
) -> Vec<Message> {
    let has_own_value = |setup: &Setup<f64>, name: &str| {
        let parameter = setup.parameter(name);
        parameter.is_ok_and(|parameter| setup.value(parameter) != parameter.default_value())
    };
    let names: Vec<_> = names.into_iter().collect();
    let idle: Vec<_> = IDLE
        .iter()
        .filter(|idle| names.contains(&idle.name))
        .filter(|idle| setups.iter().any(|setup| has_own_value(setup, idle.name)))
        .filter(|idle| setups.iter().all(idle.is_idle))
        .collect();
    let warning = |of_reason: &[&Idle]| {
        let names: Vec<_> = of_reason.iter().map(|idle| idle.name).collect();
        let have = if names.len() == 1 { "has" } else { "have" };
        let (names, reason) = (names.join(", "), of_reason[0].reason);
        Message::from(format!("{names} {have} no effect: {reason}"))
    };
    idle.chunk_by(|a, b| a.reason == b.reason)
        .map(warning)
        .collect()
}
