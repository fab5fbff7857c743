//! Alternative parameters of the air and the wind, and their conflicts.

use super::declare::{Parameter, is_unset};
use super::table::{Air, Setup};
use crate::error::{Error, Result};
use crate::units::{Digits, Message, Quantity, YARD};

/// Temperature, K, that is used if pressure, altitude or humidity is given without a temperature:
/// 25 °C, TrackMan's normalized air.
pub(crate) const DEFAULT_TEMPERATURE: f64 = 273.15 + 25.0;

/// Temperature of the standard atmosphere at sea level, K (ISO 2533:1975).
pub(crate) const SEA_LEVEL_TEMPERATURE: f64 = 288.15;

/// Temperature lapse rate of the standard atmosphere, K/m (ISO 2533:1975).
pub(crate) const LAPSE_RATE: f64 = 0.0065;

/// Two sets of parameters for the same quantity. If a parameter of `by` is set, the parameters of
/// `replaced` follow from the parameters of `by`.
#[derive(Debug, PartialEq)]
pub struct Alternatives {
    /// Name of the described quantity: `air`, `wind`.
    pub name: &'static str,
    by: &'static [&'static str],
    replaced: &'static [&'static str],
    pub(super) rule: &'static str,
}

static ALTERNATIVES: [Alternatives; 2] = [
    Alternatives {
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
    Alternatives {
        name: "wind",
        by: &["wind.speed", "wind.from"],
        replaced: &["wind.right", "wind.downrange"],
        rule: "wind.right and wind.downrange follow from wind.speed and wind.from",
    },
];

impl Alternatives {
    /// True if a parameter is in `by` or in `replaced`.
    pub(crate) fn concerns(&self, parameter: &Parameter) -> bool {
        [self.by, self.replaced]
            .iter()
            .any(|names| names.contains(&parameter.name))
    }

    /// The parameters that describe the quantity in a setup: the set parameters of `by`, or the
    /// parameters of `replaced` if no parameter of `by` is set.
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

/// The quantities, air or wind, that the two setups describe by different parameters.
pub(crate) fn described_differently([a, b]: &[Setup<f64>; 2]) -> Vec<&'static Alternatives> {
    ALTERNATIVES
        .iter()
        .filter(|one| one.given_in(a) != one.given_in(b))
        .collect()
}

/// True if the parameter describes the air or the wind (see [`Alternatives`]), and both setups
/// describe this quantity by the same parameters with the same values.
pub(crate) fn is_given_alike([a, b]: [&Setup<f64>; 2], parameter: &Parameter) -> bool {
    let Some(alternatives) = ALTERNATIVES.iter().find(|one| one.concerns(parameter)) else {
        return false;
    };
    let given = alternatives.given_in(a);
    given == alternatives.given_in(b) && given.into_iter().all(|row| a.value(row) == b.value(row))
}

impl<T> Air<T> {
    /// True if a weather parameter is set. Density and viscosity then follow from the weather.
    #[inline(always)]
    pub fn has_weather(&self) -> bool {
        self.temperature.is_some()
            || self.pressure.is_some()
            || self.altitude.is_some()
            || self.humidity.is_some()
    }
}

/// The alternatives that may replace the parameter `name`.
pub(super) fn replacing(name: &str) -> Option<&'static Alternatives> {
    ALTERNATIVES.iter().find(|one| one.replaced.contains(&name))
}

/// True if this text resets a parameter to its default: `none` for a parameter that others may
/// replace, such as `air.density`.
pub(crate) fn is_reset(name: &str, text: &str) -> bool {
    is_unset(text) && replacing(name).is_some()
}

/// True if `other`, once set, determines the parameter `name`.
pub(crate) fn follows_from(name: &str, other: &str) -> bool {
    replacing(name).is_some_and(|alternatives| alternatives.by.contains(&other))
}

/// A parameter that was given together with a parameter that replaces it.
pub(super) struct Conflict<'a> {
    pub given: &'a str,
    pub by: &'static str,
    alternatives: &'static Alternatives,
}

impl<'a> Conflict<'a> {
    /// The first parameter of `names` with a parameter that replaces it, which is also in `names`,
    /// or already set.
    pub fn find(names: &[&'a str], is_set: impl Fn(&str) -> bool) -> Option<Self> {
        ALTERNATIVES.iter().find_map(|alternatives| {
            let place_of = |name: &&str| names.iter().position(|given| given == name);
            let place = alternatives.replaced.iter().find_map(place_of)?;
            let is_given = |name: &&&str| names.contains(*name) || is_set(name);
            Some(Self {
                given: names[place],
                by: alternatives.by.iter().find(is_given)?,
                alternatives,
            })
        })
    }

    /// The error. `advice` is the end of a sentence that says how to leave out one of the two.
    pub fn error(&self, advice: &str) -> Error {
        let rule = self.alternatives.rule;
        Error::Together {
            given: format!("{} and {} are both given", self.given, self.by),
            reason: format!("{rule}; leave out one of the two{advice}"),
        }
    }

    /// Advice to unset the parameter that was given first. `names` are in the order in which they
    /// were given.
    pub fn unset_advice(&self, names: &[&str], is_set: impl Fn(&str) -> bool) -> String {
        let place = |name: &str| names.iter().position(|given| *given == name);
        // a parameter that is set but not in `names` was given before all of `names`
        let is_by_first = place(self.by) < place(self.given);
        let is_given = |name: &&&str| names.contains(*name) || is_by_first && is_set(name);
        let first = if is_by_first {
            self.alternatives.by
        } else {
            self.alternatives.replaced
        };
        let back: Vec<_> = first
            .iter()
            .filter(is_given)
            .map(|name| format!("`set {name}=none`"))
            .collect();
        format!(", or unset the value of the setup with {}", back.join(" "))
    }
}

/// Refuses a parameter of `names` if a parameter that replaces it is also in `names`, or already
/// set. `names` are in the order in which they were given.
///
/// # Errors
/// [`Error::Together`] for a replaced parameter. The advice says how to unset the parameter that
/// was given first.
pub(crate) fn refuse_replaced(names: &[&str], is_set: impl Fn(&str) -> bool) -> Result<()> {
    match Conflict::find(names, &is_set) {
        Some(conflict) => Err(conflict.error(&conflict.unset_advice(names, is_set))),
        None => Ok(()),
    }
}

/// Published changes of a driver's carry, m, if air and ball become 10 °F warmer: from 1.3 to 2 yd
/// (docs/limitations.md).
const PUBLISHED_PER_TEN_DEGREES: [f64; 2] = [1.3 * YARD, 2.0 * YARD];

/// 10 °F, K.
const TEN_DEGREES: f64 = 10.0 / 1.8;

/// Largest difference of temperatures without a warning, in units of 10 °F. By the published
/// changes, this difference changes the carry by 0.3 to 0.5 yd.
const LEAST_WARNED_APART: f64 = 0.25;

/// Temperature of the balls whose restitution was measured, K: 25 °C.
const BALL_TEMPERATURE: f64 = 298.15;

impl Setup<f64> {
    /// Refuses a parameter of `names` that another parameter, set or in `names`, replaces. Any
    /// weather parameter replaces density and viscosity. Speed and direction of the wind replace
    /// its horizontal components.
    ///
    /// ```
    /// let mut setup = longdrive::Setup::modern_driver();
    /// setup.set("air.temperature", "30 degC").unwrap();
    /// assert!(setup.refuse_replaced(&["club.loft"]).is_ok());
    /// assert!(setup.refuse_replaced(&["air.density"]).is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::Together`] for a replaced parameter.
    pub fn refuse_replaced(&self, names: &[&str]) -> Result<()> {
        refuse_replaced(names, |name| self.is_set(name))
    }

    /// True if the parameter `name` exists and has a value.
    pub(super) fn is_set(&self, name: &str) -> bool {
        self.row(name)
            .is_some_and(|parameter| self.value(parameter).is_some())
    }

    /// Warnings about weather outside the range in which the equation of the density is validated
    /// (docs/sources.md): there the equation is extrapolated. The range begins at 15 °C, but colder
    /// air causes no warning: cold air holds little vapour, and the density of dry air is known.
    pub(super) fn weather_warnings(&self) -> Vec<Message> {
        const PRESSURE: [f64; 2] = [60_000.0, 110_000.0];
        // altitudes, m, at which the standard atmosphere has about these pressures
        const ALTITUDE: [f64; 2] = [-700.0, 4200.0];
        const TEMPERATURE: [f64; 2] = [0.0, 273.15 + 40.0];
        let rows = [
            ("air.pressure", PRESSURE),
            ("air.altitude", ALTITUDE),
            ("air.temperature", TEMPERATURE),
        ];
        let warning = |(name, [low, high]): (&str, [f64; 2])| {
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
                .append_value(format!("{name} = ").into(), value)
                .words(format!(" is {before}"));
            let message = parameter.append_value(message, end);
            Some(message.words(
                ": there the equation of the air's density (CIPM-2007) is extrapolated, and its \
                 error is not known",
            ))
        };
        rows.into_iter()
            .filter_map(warning)
            .chain(self.altitude_warning())
            .chain(self.ball_temperature_warning())
            .collect()
    }

    /// Warning that a temperature changes the air only: the ball keeps its restitution at 25 °C.
    /// `None` for a given launch, which a cold ball has already left.
    fn ball_temperature_warning(&self) -> Option<Message> {
        let apart = (self.air.temperature? - BALL_TEMPERATURE) / TEN_DEGREES;
        if self.launch.is_given() || apart.abs() <= LEAST_WARNED_APART {
            return None;
        }
        let [least, most] = PUBLISHED_PER_TEN_DEGREES;
        let ball = match apart < 0.0 {
            true => "a cold ball is slower",
            false => "a warm ball is faster",
        };
        let message = Message::from(format!(
            "air.temperature changes the air alone: {ball} too, which is not modelled; by \
             published rules for air and ball together the carry changes by "
        ));
        let yards = |message: Message, value: f64| {
            message.quantity(Quantity::LENGTH, "yd", value, Digits::Significant(2))
        };
        let message = yards(message, least).words(" to ");
        Some(yards(message, most).words(" per 10 °F (5.6 °C)"))
    }

    /// Warning about an altitude without a temperature. The default of 25 °C is warmer than the
    /// standard atmosphere at that altitude, so that the computed density is lower.
    fn altitude_warning(&self) -> Option<Message> {
        let altitude = self.air.altitude?;
        if self.air.temperature.is_some() || altitude <= 0.0 {
            return None;
        }
        let row = self.parameter("air.temperature").ok()?;
        let message = self
            .parameter("air.altitude")
            .ok()?
            .append_value("air.altitude = ".into(), altitude);
        let standard = SEA_LEVEL_TEMPERATURE - LAPSE_RATE * altitude;
        let denser = 100.0 * (DEFAULT_TEMPERATURE / standard - 1.0);
        let message = message.words(" is given without air.temperature, which is then ");
        let message = row.append_value(message, DEFAULT_TEMPERATURE);
        let message = message.words("; the standard atmosphere has ").quantity(
            Quantity::TEMPERATURE,
            "degC",
            standard,
            Digits::Significant(2),
        );
        Some(message.words(format!(
            " there, so its air is {denser:.0} % denser; give air.temperature too"
        )))
    }

    /// Reason why the value of a parameter is not used: a set parameter replaces it. `None` if the
    /// value is used.
    pub fn why_replaced(&self, parameter: &Parameter) -> Option<String> {
        let alternatives = replacing(parameter.name)?;
        let by = alternatives.by.iter().find(|name| self.is_set(name))?;
        Some(format!(
            "{by} is given, and {}; name a parameter that determines it instead",
            alternatives.rule
        ))
    }

    /// Checks that weather and wind are complete and given only once. A parameter counts as given
    /// if it is set or among `names`.
    ///
    /// # Errors
    /// [`Error::Together`] for weather or wind that is incomplete or given twice.
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
                "the altitude gives a pressure too, by the standard atmosphere; leave out one of \
                 the two, or unset the value of the setup with `set air.altitude=none` or \
                 `set air.pressure=none`",
            );
        }
        match [has("wind.speed", wind.speed), has("wind.from", wind.from)] {
            [true, false] => refuse(
                "wind.speed is given without wind.from",
                "say where the wind comes from, clockwise from the target line: `set \
                 wind.from=0deg` is a head wind, 90 deg is from the right, 180 deg is a tail wind",
            ),
            [false, true] => refuse(
                "wind.from is given without wind.speed",
                "give the speed of the wind too",
            ),
            [true, true] if wind.right != 0.0 || wind.downrange != 0.0 => refuse(
                "wind.speed and a component of the wind along the ground are both given",
                "wind.right and wind.downrange follow from wind.speed and wind.from; keep one of \
                 the two: set the components to 0 m/s, or wind.speed and wind.from to none",
            ),
            _ => self.refuse_replaced(names),
        }
    }

    /// Warning about a reference height of the wind that is not above the roughness length.
    pub(super) fn reference_height_warning(&self) -> Option<Message> {
        let wind = &self.wind;
        if wind.reference_height > wind.roughness? {
            return None;
        }
        let stated = self.parameter("wind.reference_height").ok()?;
        let message = "wind.reference_height = ".into();
        let message = stated.append_value(message, wind.reference_height);
        Some(message.words(
            " is not above wind.roughness: a logarithmic profile does not define the wind there",
        ))
    }
}
