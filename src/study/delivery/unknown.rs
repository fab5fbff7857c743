use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::{Sigma, given_twice};

/// A parameter of the delivery that is sought, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unknown {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Its value as far as it is known before the shot.
    pub before: f64,
    /// The standard uncertainty of that.
    pub sigma: f64,
    /// Where the uncertainty comes from; `None` where it was given.
    pub source: Option<&'static str>,
    /// Least value.
    pub low: f64,
    /// Greatest value.
    pub high: f64,
}

const GOLFERS: &str = "assumed: how golfers differ from each other";
const STRIKES: &str = "assumed: how far amateurs strike from the middle of the face";
const EVENLY: &str = "assumed: spread evenly over its range";
const CLUB: &str = "assumed: what launch monitors state of a club";

/// What is sought where nothing else is named, with how far it may be from the setup's value.
const SOUGHT: [(&str, &str, &str); 7] = [
    ("swing.speed", "15 mph", GOLFERS),
    ("swing.attack_angle", "3 deg", GOLFERS),
    ("swing.shaft_lean", "3 deg", GOLFERS),
    ("swing.path", "4 deg", GOLFERS),
    ("swing.face_angle", "4 deg", GOLFERS),
    ("strike.toe", "10 mm", STRIKES),
    ("strike.high", "8 mm", STRIKES),
];

/// How well a launch monitor measures what it states of the club.
const MEASURED: [(&str, &str); 4] = [
    ("swing.speed", "1.5 mph"),
    ("swing.attack_angle", "1 deg"),
    ("swing.path", "1 deg"),
    ("swing.face_angle", "1 deg"),
];

/// A parameter is sought within so many standard uncertainties of its value before.
const REACH: f64 = 4.0;

impl Unknown {
    /// The same parameter where a launch monitor has measured it, with the monitor's uncertainty;
    /// one that was given stays.
    pub fn measured_as(self, value: f64) -> Self {
        let Self {
            parameter,
            sigma,
            source,
            low,
            high,
            ..
        } = self;
        let monitor = MEASURED.iter().find(|(name, _)| *name == parameter.name);
        let stated = monitor.and_then(|(_, sigma)| parameter.quantity.read_difference(sigma).ok());
        let (sigma, source) = match (source, stated) {
            (Some(_), Some(stated)) => (stated, Some(CLUB)),
            _ => (sigma, source),
        };
        let Some([least, most]) = around(parameter, value, sigma) else {
            return Self {
                before: value,
                sigma,
                source,
                ..self
            };
        };
        Self {
            before: value,
            sigma,
            source,
            low: low.min(least),
            high: high.max(most),
            parameter,
        }
    }
}

/// The values within reach of one.
fn around(parameter: &Parameter, value: f64, sigma: f64) -> Option<[f64; 2]> {
    let range = parameter.range;
    let (low, high) = (
        (value - REACH * sigma).max(range.low),
        (value + REACH * sigma).min(range.high),
    );
    // an end that does not belong to the range is left by a part of the way
    let inside = |end: f64| {
        if range.contains(end) {
            end
        } else {
            end + 1e-6 * (value - end)
        }
    };
    let (low, high) = (inside(low), inside(high));
    (low < high && range.contains(low) && range.contains(high)).then_some([low, high])
}

/// What is sought: of `vary`, or of the usual parameters of a delivery and its strike where that is
/// empty, with the uncertainties that `sigmas` give.
///
/// # Errors
/// [`Error::Delivery`] for a parameter on which no launch depends, or without room to move;
/// [`Error::Unreadable`] for an uncertainty given twice or of a parameter that is not sought.
pub fn unknowns(setup: &Setup<f64>, vary: &[Vary], sigmas: &[Sigma]) -> Result<Vec<Unknown>> {
    let refuse = |reason: String| Error::Delivery { reason };
    let usual = |parameter: &Parameter| {
        let found = SOUGHT.iter().find(|(name, ..)| *name == parameter.name)?;
        Some((parameter.quantity.read_difference(found.1).ok()?, found.2))
    };
    for (i, sigma) in sigmas.iter().enumerate() {
        if sigmas[..i]
            .iter()
            .any(|other| other.parameter == sigma.parameter)
        {
            return Err(given_twice(sigma.parameter));
        }
    }
    let given = |parameter: &Parameter| sigmas.iter().find(|sigma| sigma.parameter == parameter);
    let mut all = vec![];
    if vary.is_empty() {
        for (name, ..) in SOUGHT {
            let parameter = setup.variable(name)?;
            let before = setup.value(parameter).unwrap_or_default();
            let (sigma, source) = match (given(parameter), usual(parameter)) {
                (Some(sigma), _) => (sigma.value, None),
                (None, Some((sigma, source))) => (sigma, Some(source)),
                (None, None) => continue,
            };
            let [low, high] = around(parameter, before, sigma).ok_or_else(|| {
                let (name, value) = (parameter.name, parameter.show(Some(before)));
                refuse(format!(
                    "{name} = {value} leaves no room to move; set it to another value"
                ))
            })?;
            all.push(Unknown {
                parameter,
                before,
                sigma,
                source,
                low,
                high,
            });
        }
    }
    for (
        i,
        &Vary {
            parameter,
            low,
            high,
        },
    ) in vary.iter().enumerate()
    {
        let name = parameter.name;
        if !parameter.is_of_strike() {
            return Err(refuse(format!(
                "no launch depends on {name}; vary parameters of swing, strike, club or impact"
            )));
        }
        if vary[..i].iter().any(|other| other.parameter == parameter) {
            return Err(refuse(format!(
                "{name} is to be varied twice; name it once"
            )));
        }
        if low == high {
            return Err(refuse(format!(
                "the range of {name} is a single value; give a wider one, or `set` it"
            )));
        }
        let before = setup.value(parameter).unwrap_or(0.5 * (low + high));
        if !(low..=high).contains(&before) {
            let (value, ends) = (
                parameter.show(Some(before)),
                [low, high].map(|end| parameter.show(Some(end))),
            );
            return Err(refuse(format!(
                "{name} = {value} is outside of the range {} .. {} that it is sought in; `set` it \
                 to a value within",
                ends[0], ends[1]
            )));
        }
        let (sigma, source) = match (given(parameter), usual(parameter)) {
            (Some(sigma), _) => (sigma.value, None),
            (None, Some((sigma, source))) => (sigma, Some(source)),
            // the standard deviation of a uniform distribution
            (None, None) => ((high - low) / 12.0_f64.sqrt(), Some(EVENLY)),
        };
        all.push(Unknown {
            parameter,
            before,
            sigma,
            source,
            low,
            high,
        });
    }
    let is_sought = |sigma: &&Sigma| {
        !all.iter()
            .any(|unknown| unknown.parameter == sigma.parameter)
    };
    if let Some(unused) = sigmas.iter().find(is_sought) {
        let names: Vec<_> = all.iter().map(|unknown| unknown.parameter.name).collect();
        let source = format!(
            "it is not sought, so that this has no effect; sought are {}",
            names.join(", ")
        );
        return Err(Error::Unreadable {
            name: format!("`sigma` {}", unused.parameter.name),
            source: source.into(),
        });
    }
    Ok(all)
}
