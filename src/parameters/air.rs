//! Which ways to give the air and the wind go together.

use super::declare::{Parameter, is_unset};
use super::table::{Air, Setup};
use crate::error::{Error, Result};
use crate::units::Message;

/// Parameters that may be given in two ways: where one of `by` is given, those of `replaced` follow
/// from them.
#[derive(Debug, PartialEq)]
pub struct Ways {
    /// What they are together: `air`, `wind`.
    pub name: &'static str,
    by: &'static [&'static str],
    replaced: &'static [&'static str],
    rule: &'static str,
}

static WAYS: [Ways; 2] = [
    Ways {
        name: "air",
        by: &[
            "air.temperature",
            "air.pressure",
            "air.altitude",
            "air.humidity",
        ],
        replaced: &["air.density", "air.viscosity"],
        rule: "density and viscosity follow from the weather (air.temperature, air.pressure, \
               air.altitude, air.humidity)",
    },
    Ways {
        name: "wind",
        by: &["wind.speed", "wind.from"],
        replaced: &["wind.right", "wind.downrange"],
        rule: "wind.right and wind.downrange follow from wind.speed and wind.from",
    },
];

impl Ways {
    /// Whether a parameter is one of them.
    pub(crate) fn has(&self, parameter: &Parameter) -> bool {
        [self.by, self.replaced]
            .iter()
            .any(|names| names.contains(&parameter.name))
    }

    /// Those by which a setup gives it: what is set of `by`, or `replaced` where nothing is.
    pub(crate) fn given_in(&self, setup: &Setup<f64>) -> Vec<&'static Parameter> {
        let set = |names: &[&str]| -> Vec<&'static Parameter> {
            let rows = names.iter().filter_map(|name| setup.parameter(name).ok());
            rows.filter(|row| setup.value(row).is_some()).collect()
        };
        let by = set(self.by);
        if by.is_empty() {
            set(self.replaced)
        } else {
            by
        }
    }
}

/// What two setups give by different parameters.
pub(crate) fn given_otherwise([a, b]: &[Setup<f64>; 2]) -> Vec<&'static Ways> {
    WAYS.iter()
        .filter(|ways| ways.given_in(a) != ways.given_in(b))
        .collect()
}

impl<T> Air<T> {
    /// Whether the weather is given, from which density and viscosity follow.
    #[inline(always)]
    pub fn has_weather(&self) -> bool {
        self.temperature.is_some()
            || self.pressure.is_some()
            || self.altitude.is_some()
            || self.humidity.is_some()
    }
}

/// Whether `none` takes this parameter back: another way can give what it gives.
pub(crate) fn is_taken_back(name: &str, text: &str) -> bool {
    is_unset(text) && WAYS.iter().any(|ways| ways.replaced.contains(&name))
}

/// Whether a parameter follows from this other one, where that is given.
#[cfg(feature = "cli")]
pub(crate) fn follows_from(name: &str, other: &str) -> bool {
    WAYS.iter()
        .any(|ways| ways.replaced.contains(&name) && ways.by.contains(&other))
}

/// What else may be given in place of this parameter, as the end of a sentence; empty where nothing
/// else may.
pub(super) fn instead(name: &str) -> String {
    let ways = WAYS.iter().find(|ways| ways.replaced.contains(&name));
    ways.map_or_else(String::new, |ways| {
        format!(", or give what it follows from as well: {}", ways.rule)
    })
}

/// Whether nothing of these names, in the order in which they were given, is replaced by something
/// else of them, or by what is set.
///
/// # Errors
/// [`Error::Together`], with how to take back what was given first.
pub(crate) fn refuse_replaced(names: &[&str], is_set: impl Fn(&str) -> bool) -> Result<()> {
    for Ways {
        by: by_all,
        replaced,
        rule,
        ..
    } in &WAYS
    {
        let Some(given) = replaced.iter().find(|name| names.contains(name)) else {
            continue;
        };
        if let Some(by) = by_all
            .iter()
            .find(|name| names.contains(name) || is_set(name))
        {
            let place = |name: &&&str| names.iter().position(|given| *given == **name);
            // what is set and not named was given before
            let is_by_first = place(&by) < place(&given);
            let is_given = |name: &&&str| names.contains(*name) || is_by_first && is_set(name);
            let first = if is_by_first { by_all } else { replaced };
            let back: Vec<_> = first
                .iter()
                .filter(is_given)
                .map(|name| format!("`set {name}=none`"))
                .collect();
            let reason = format!(
                "{rule}; keep one of the two: leave one out, or take back what the setup gives \
                 with {}",
                back.join(" ")
            );
            return Err(Error::Together {
                given: format!("{given} and {by} are both given"),
                reason,
            });
        }
    }
    Ok(())
}

impl Setup<f64> {
    /// Whether nothing of these names, which are given, is replaced by something else that is
    /// given: density and viscosity follow from the weather where any of it is set, and the
    /// components of the wind from its speed and direction.
    ///
    /// ```
    /// let mut setup = longdrive::Setup::default();
    /// setup.set("air.temperature", "30 degC").unwrap();
    /// assert!(setup.refuse_replaced(&["club.loft"]).is_ok());
    /// assert!(setup.refuse_replaced(&["air.density"]).is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::Together`].
    pub fn refuse_replaced(&self, names: &[&str]) -> Result<()> {
        refuse_replaced(names, |name| self.is_set(name))
    }

    /// Whether an optional parameter is set.
    pub(super) fn is_set(&self, name: &str) -> bool {
        self.parameter(name)
            .is_ok_and(|parameter| self.value(parameter).is_some())
    }

    /// The weather that is given outside of what the equation of the density was made for or
    /// compared in (docs/sources.md): the density follows from it by extrapolation. Below 15 °C
    /// there is little vapour in the air, and that of dry air is known.
    pub(super) fn unproven_weather(&self) -> Vec<Message> {
        const PRESSURE: [f64; 2] = [60_000.0, 110_000.0];
        // where the standard atmosphere has about these pressures, m
        const ALTITUDE: [f64; 2] = [-700.0, 4200.0];
        const TEMPERATURE: [f64; 2] = [0.0, 273.15 + 40.0];
        let rows = [
            ("air.pressure", PRESSURE),
            ("air.altitude", ALTITUDE),
            ("air.temperature", TEMPERATURE),
        ];
        let told = |(name, [low, high]): (&str, [f64; 2])| {
            let parameter = self.parameter(name).ok()?;
            let value = self
                .value(parameter)
                .filter(|value| !(low..=high).contains(value))?;
            let (before, end) = if value < low {
                ("below ", low)
            } else {
                ("above ", high)
            };
            let message = parameter
                .place(format!("{name} = ").into(), value)
                .words(format!(" is {before}"));
            let message = parameter.place(message, end);
            Some(message.words(
                ": there the equation of the air's density (CIPM-2007) is extrapolated, and its \
                 error is not known",
            ))
        };
        rows.into_iter().filter_map(told).collect()
    }

    /// Why the value of a parameter is not used, if something that is set replaces it.
    pub fn why_replaced(&self, parameter: &Parameter) -> Option<String> {
        let ways = WAYS
            .iter()
            .find(|ways| ways.replaced.contains(&parameter.name))?;
        let by = ways.by.iter().find(|name| self.is_set(name))?;
        Some(format!(
            "{by} is given, and {}; name one of these",
            ways.rule
        ))
    }

    /// Whether the weather and the wind that are set, and those of these names, are each given once
    /// and wholly.
    ///
    /// # Errors
    /// [`Error::Together`].
    pub(crate) fn check_air(&self, names: &[&str]) -> Result<()> {
        let (air, wind) = (&self.air, &self.wind);
        let has = |name: &str, value: Option<f64>| value.is_some() || names.contains(&name);
        let refuse = |given: &str, reason: &str| {
            Err(Error::Together {
                given: given.into(),
                reason: reason.into(),
            })
        };
        if has("air.pressure", air.pressure) && has("air.altitude", air.altitude) {
            return refuse(
                "air.pressure and air.altitude are both given",
                "the altitude gives a pressure too, that of the standard atmosphere; keep one of \
                 the two: \
                 leave one out, or take back what the setup gives with `set air.altitude=none` or \
                 `set air.pressure=none`",
            );
        }
        match [has("wind.speed", wind.speed), has("wind.from", wind.from)] {
            [true, false] => refuse(
                "wind.speed is given without wind.from",
                "say where the wind comes from, clockwise from the target line: 0 deg is a head \
                 wind, 90 deg is from the right, \
                 180 deg is a tail wind",
            ),
            [false, true] => refuse(
                "wind.from is given without wind.speed",
                "give the speed of the wind too",
            ),
            [true, true] if wind.right != 0.0 || wind.downrange != 0.0 => refuse(
                "wind.speed and a component of the wind along the ground are both given",
                "wind.right and wind.downrange follow from wind.speed and wind.from; keep one of \
                 the two (0 m/s for the \
                 components, none for wind.speed and wind.from)",
            ),
            _ => self.refuse_replaced(names),
        }
    }
}
