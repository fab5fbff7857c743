use crate::error::{Error, Result};
#[cfg(test)]
use crate::json::JsonRange;
use crate::json::range;
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::{Sigma, refuse_given_twice};
use serde::Serialize;

/// An unknown parameter of the delivery with its prior, SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Unknown {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The prior value, SI.
    #[serde(rename = "before")]
    pub prior: f64,
    /// The prior standard uncertainty, SI.
    #[serde(rename = "standard_uncertainty_before")]
    pub sigma: f64,
    /// The source of the prior uncertainty; `null` if the user stated it.
    pub source: Option<&'static str>,
    /// The range of the search.
    // the lower and the upper bound, SI
    #[serde(serialize_with = "range")]
    #[cfg_attr(test, schemars(with = "JsonRange"))]
    pub range: [f64; 2],
}

const GOLFERS: &str = "assumed: how golfers differ from each other";
const STRIKES: &str = "assumed: how far amateurs strike from the middle of the face";
const EVENLY: &str =
    "assumed: normal, with the standard deviation of an even spread over the range";
const CLUB: &str = "assumed: the error of a launch monitor's club values";
const UNKNOWN_ERROR: &str = "assumed: as uncertain as without a measurement, since the error of \
                             its measurement is not known";

/// Default unknowns: name, prior standard uncertainty, and the source of the uncertainty.
const DEFAULT_UNKNOWNS: [(&str, &str, &str); 7] = [
    ("swing.speed", "15 mph", GOLFERS),
    ("swing.attack_angle", "3 deg", GOLFERS),
    ("swing.shaft_lean", "3 deg", GOLFERS),
    ("swing.path", "4 deg", GOLFERS),
    ("swing.face_angle", "4 deg", GOLFERS),
    ("strike.toe", "10 mm", STRIKES),
    ("strike.high", "8 mm", STRIKES),
];

/// Measurement uncertainties of a launch monitor's club values.
const CLUB_UNCERTAINTIES: [(&str, &str); 4] = [
    ("swing.speed", "1.5 mph"),
    ("swing.attack_angle", "1 deg"),
    ("swing.path", "1 deg"),
    ("swing.face_angle", "1 deg"),
];

/// Half-width of the search range in prior standard uncertainties.
const REACH: f64 = 4.0;

impl Unknown {
    /// True if the prior is a measured value with an assumed uncertainty.
    pub fn has_assumed_error(&self) -> bool {
        [Some(CLUB), Some(UNKNOWN_ERROR)].contains(&self.source)
    }

    /// True if the user gave the value or its uncertainty.
    pub fn is_stated(&self) -> bool {
        self.source.is_none() || self.has_assumed_error()
    }

    /// The distance of a value from the prior, in prior standard uncertainties.
    pub(super) fn residual(&self, value: f64) -> f64 {
        (value - self.prior) / self.sigma
    }

    /// The unknown with a measured value as its prior. A stated uncertainty stays. A default
    /// uncertainty is replaced by the uncertainty of a launch monitor, if that is known. The search
    /// range is widened to include the search range around `value`.
    pub fn with_measured_prior(self, value: f64) -> Self {
        let Self {
            parameter,
            sigma,
            source,
            range: [low, high],
            ..
        } = self;
        let monitor = CLUB_UNCERTAINTIES
            .iter()
            .find(|(name, _)| *name == parameter.name);
        let stated = monitor.and_then(|(_, sigma)| parameter.quantity.read_difference(sigma).ok());
        let (sigma, source) = match (source, stated) {
            (Some(_), Some(stated)) => (stated, Some(CLUB)),
            (Some(_), None) => (sigma, Some(UNKNOWN_ERROR)),
            (None, _) => (sigma, None),
        };
        let range = search_range(parameter, value, sigma).map_or([low, high], |[least, most]| {
            [low.min(least), high.max(most)]
        });
        Self {
            prior: value,
            sigma,
            source,
            range,
            parameter,
        }
    }
}

/// Search range around a value, within the allowed range; `None` if it is empty.
fn search_range(parameter: &Parameter, value: f64, sigma: f64) -> Option<[f64; 2]> {
    let range = parameter.range;
    let (low, high) = (
        (value - REACH * sigma).max(range.low),
        (value + REACH * sigma).min(range.high),
    );
    // move an excluded end inside the range
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

/// The unknowns with their priors: the parameters of `vary`, or the default unknowns if `vary` is
/// empty. `sigmas` overrides the default uncertainties.
///
/// # Errors
/// [`Error::Delivery`] if a parameter of `vary` does not affect the launch, or if a search range is
/// empty; [`Error::Unreadable`] if `sigmas` contains a parameter twice, or a parameter that is not
/// among the unknowns.
pub fn unknowns(setup: &Setup<f64>, vary: &[Vary], sigmas: &[Sigma]) -> Result<Vec<Unknown>> {
    refuse_given_twice(sigmas.iter().map(|sigma| sigma.parameter))?;
    let all = if vary.is_empty() {
        default_unknowns(setup, sigmas)?
    } else {
        varied_unknowns(setup, vary, sigmas)?
    };
    let is_missing = |sigma: &&Sigma| {
        !all.iter()
            .any(|unknown| unknown.parameter == sigma.parameter)
    };
    if let Some(unused) = sigmas.iter().find(is_missing) {
        let names: Vec<_> = all.iter().map(|unknown| unknown.parameter.name).collect();
        let source = format!(
            "it is not an unknown, so its uncertainty has no effect; the unknowns are {}",
            names.join(", ")
        );
        return Err(Error::unreadable(
            format!("`sigma {}`", unused.parameter.name),
            source,
        ));
    }
    Ok(all)
}

fn refuse(reason: String) -> Error {
    Error::Delivery { reason }
}

/// Prior standard uncertainty of a parameter, with its source. The user's uncertainty (source
/// `None`) takes precedence over the default one. `None` if there is neither.
fn prior_sigma(
    parameter: &'static Parameter,
    sigmas: &[Sigma],
) -> Option<(f64, Option<&'static str>)> {
    if let Some(given) = sigmas.iter().find(|sigma| sigma.parameter == parameter) {
        return Some((given.value, None));
    }
    let (_, sigma, source) = DEFAULT_UNKNOWNS
        .iter()
        .find(|(name, ..)| *name == parameter.name)?;
    let sigma = parameter.quantity.read_difference(sigma).ok()?;
    Some((sigma, Some(*source)))
}

fn default_unknowns(setup: &Setup<f64>, sigmas: &[Sigma]) -> Result<Vec<Unknown>> {
    let mut all = vec![];
    for (name, ..) in DEFAULT_UNKNOWNS {
        let parameter = setup.variable(name)?;
        let prior = setup.value(parameter).unwrap_or_default();
        let Some((sigma, source)) = prior_sigma(parameter, sigmas) else {
            continue;
        };
        let range = search_range(parameter, prior, sigma).ok_or_else(|| {
            let (name, value) = (parameter.name, parameter.show(Some(prior)));
            refuse(format!(
                "the search range around {name} = {value} is empty; give {name} another value"
            ))
        })?;
        all.push(Unknown {
            parameter,
            prior,
            sigma,
            source,
            range,
        });
    }
    Ok(all)
}

fn varied_unknowns(setup: &Setup<f64>, vary: &[Vary], sigmas: &[Sigma]) -> Result<Vec<Unknown>> {
    let mut all: Vec<Unknown> = vec![];
    for &Vary {
        parameter,
        low,
        high,
    } in vary
    {
        let name = parameter.name;
        if !parameter.is_of_strike() {
            return Err(refuse(format!(
                "no launch depends on {name}; vary parameters of swing, strike, club or impact"
            )));
        }
        if all.iter().any(|other| other.parameter == parameter) {
            return Err(refuse(format!(
                "{name} is to be varied twice; name it once"
            )));
        }
        if low == high {
            return Err(refuse(format!(
                "the range of {name} is a single value; give a wider range, or fix its value with \
                 `set`"
            )));
        }
        let prior = setup.value(parameter).unwrap_or(0.5 * (low + high));
        if !(low..=high).contains(&prior) {
            let (value, ends) = (
                parameter.show(Some(prior)),
                [low, high].map(|end| parameter.show(Some(end))),
            );
            return Err(refuse(format!(
                "{name} = {value} is outside of its search range {} .. {}; `set` it to a value in \
                 this range",
                ends[0], ends[1]
            )));
        }
        // standard deviation of a uniform distribution
        let uniform = || ((high - low) / 12.0_f64.sqrt(), Some(EVENLY));
        let (sigma, source) = prior_sigma(parameter, sigmas).unwrap_or_else(uniform);
        all.push(Unknown {
            parameter,
            prior,
            sigma,
            source,
            range: [low, high],
        });
    }
    Ok(all)
}
