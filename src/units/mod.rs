//! Conversion of quantity strings to and from SI: `"110 mph"`, `"10.5 deg"`, `"5679 g cm^2"`. No
//! other module converts units.
//!
//! The sizes of the units are their definitions; tests compare them with NIST's tables and with
//! Python's library pint. A grammar combines units (`kg/m^3`, `g cm^2`), and the dimension of the
//! result is checked.

mod amount;
mod decimals;
mod derivative_unit;
mod display_unit;
mod error;
mod expression;
mod message;
mod spelling;
mod symbols;
mod system;
mod table_units;

pub(crate) use amount::Amount;
pub use decimals::{counted, counted_of};
pub(crate) use decimals::{fixed, is_zero, signed};
pub use derivative_unit::DerivativeUnit;
pub use display_unit::DisplayUnit;
pub use error::UnitError;
pub(crate) use expression::Unit;
pub use message::{Digits, Message};
pub(crate) use spelling::{leading_number, typed, with_unit};
pub use spelling::{one, per, printed, ratio, typeset};
#[cfg(feature = "studies")]
pub(crate) use symbols::DEGREE;
pub(crate) use symbols::{MPH, RPM, YARD};
pub use system::System;
pub use table_units::TableUnits;

use expression::read_unit;
use symbols::{Dimension, SYMBOLS};

/// Physical quantity of a parameter or an outcome.
///
/// ```
/// use longdrive::units::Quantity;
/// assert_eq!(Quantity::ANGLE.read("180 deg").unwrap(), std::f64::consts::PI);
/// assert_eq!(Quantity::SPEED.read("110 mph").unwrap(), 49.1744);
/// assert!(Quantity::ANGLE.read("10 kg").is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Name with its article: "an angle".
    pub name: &'static str,
    /// SI unit: "rad".
    pub si: &'static str,
    dimension: Dimension,
    /// Usual units, separated by commas; the first unit is for examples.
    usual: &'static str,
    /// Decimals by display unit. A number in another unit has five significant digits.
    decimals: &'static [(&'static str, usize)],
    /// Pairs of metric and US display units. Another unit belongs to both systems.
    metric_and_us: &'static [(&'static str, &'static str)],
}

macro_rules! quantities {
    ($($(#[doc = $doc:literal])* $id:ident { $($field:ident: $fact:expr,)+ })*) => {
        impl Quantity {
            $($(#[doc = $doc])* pub const $id: Self = Self { $($field: $fact,)+ };)*

            /// All quantities.
            pub(crate) const ALL: &'static [Self] = &[$(Self::$id),*];
        }
    };
}

quantities! {
    /// Speed, m/s.
    SPEED {
        name: "a speed",
        si: "m/s",
        dimension: Dimension([1, 0, -1, 0, 0]),
        usual: "mph, m/s, km/h, ft/s",
        decimals: &[("mph", 1), ("m/s", 1)],
        metric_and_us: &[("m/s", "mph")],
    }

    /// Angle, rad.
    ANGLE {
        name: "an angle",
        si: "rad",
        dimension: Dimension([0, 0, 0, 1, 0]),
        usual: "deg, rad",
        decimals: &[("deg", 1)],
        metric_and_us: &[],
    }

    /// Angular velocity, rad/s.
    ANGULAR_VELOCITY {
        name: "an angular velocity",
        si: "rad/s",
        dimension: Dimension([0, 0, -1, 1, 0]),
        usual: "rpm, rad/s, deg/s",
        decimals: &[("rpm", 0), ("rad/s", 1)],
        metric_and_us: &[],
    }

    /// Length, m.
    LENGTH {
        name: "a length",
        si: "m",
        dimension: Dimension([1, 0, 0, 0, 0]),
        usual: "m, mm, yd, in",
        decimals: &[("yd", 1), ("m", 1), ("ft", 0), ("mm", 1), ("in", 2)],
        metric_and_us: &[("m", "yd"), ("m", "ft"), ("mm", "in")],
    }

    /// Mass, kg.
    MASS {
        name: "a mass",
        si: "kg",
        dimension: Dimension([0, 1, 0, 0, 0]),
        usual: "g, kg, oz",
        decimals: &[("g", 1)],
        metric_and_us: &[],
    }

    /// Moment of inertia, kg m².
    INERTIA {
        name: "a moment of inertia",
        si: "kg m^2",
        dimension: Dimension([2, 1, 0, 0, 0]),
        usual: "g cm^2, kg m^2",
        decimals: &[("g cm^2", 0)],
        metric_and_us: &[],
    }

    /// Density, kg/m³.
    DENSITY {
        name: "a density",
        si: "kg/m^3",
        dimension: Dimension([-3, 1, 0, 0, 0]),
        usual: "kg/m^3, g/L, lb/ft^3",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Dynamic viscosity, Pa s.
    VISCOSITY {
        name: "a dynamic viscosity",
        si: "Pa s",
        dimension: Dimension([-1, 1, -1, 0, 0]),
        usual: "Pa s, cP",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Temperature, K.
    TEMPERATURE {
        name: "a temperature",
        si: "K",
        dimension: Dimension([0, 0, 0, 0, 1]),
        usual: "degC, degF, K",
        decimals: &[],
        metric_and_us: &[("degC", "degF")],
    }

    /// Pressure, Pa.
    PRESSURE {
        name: "a pressure",
        si: "Pa",
        dimension: Dimension([-1, 1, -2, 0, 0]),
        usual: "hPa, kPa, mbar, inHg, mmHg",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Acceleration, m/s².
    ACCELERATION {
        name: "an acceleration",
        si: "m/s^2",
        dimension: Dimension([1, 0, -2, 0, 0]),
        usual: "m/s^2, ft/s^2",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Time, s.
    TIME {
        name: "a time",
        si: "s",
        dimension: Dimension([0, 0, 1, 0, 0]),
        usual: "s, ms, min",
        decimals: &[("s", 2)],
        metric_and_us: &[],
    }

    /// Rate of decay, 1/s.
    RATE {
        name: "a rate",
        si: "1/s",
        dimension: Dimension([0, 0, -1, 0, 0]),
        usual: "1/s, %/s",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Reciprocal of an angular velocity, s/rad.
    PER_ANGULAR_VELOCITY {
        name: "a quantity per angular velocity",
        si: "s/rad",
        dimension: Dimension([0, 0, 1, -1, 0]),
        usual: "s/rad, 1/rpm",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Reciprocal of a speed, s/m.
    PER_SPEED {
        name: "a quantity per speed",
        si: "s/m",
        dimension: Dimension([-1, 0, 1, 0, 0]),
        usual: "s/m, 1/mph",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Area, m².
    AREA {
        name: "an area",
        si: "m^2",
        dimension: Dimension([2, 0, 0, 0, 0]),
        usual: "cm^2, mm^2, m^2",
        decimals: &[],
        metric_and_us: &[],
    }

    /// Volume, m³.
    VOLUME {
        name: "a volume",
        si: "m^3",
        dimension: Dimension([3, 0, 0, 0, 0]),
        usual: "cm^3, m^3, L",
        decimals: &[],
        metric_and_us: &[],
    }

    /// First moment of a mass, kg m.
    MASS_MOMENT {
        name: "a mass times a length",
        si: "kg m",
        dimension: Dimension([1, 1, 0, 0, 0]),
        usual: "g mm, kg m",
        decimals: &[],
        metric_and_us: &[],
    }

    /// A number without unit.
    NUMBER {
        name: "a plain number",
        si: "",
        dimension: Dimension([0, 0, 0, 0, 0]),
        usual: "no unit, or %",
        // two decimals, for ratios of measured numbers such as the smash factor
        decimals: &[("", 2)],
        metric_and_us: &[],
    }
}

impl Quantity {
    /// Parses a string with a unit to SI. `inf` and plain numbers need no unit.
    ///
    /// # Errors
    /// [`UnitError`] if there is no number, if the unit is missing or unknown, or if it is a unit
    /// of another quantity.
    pub fn read(self, text: &str) -> Result<f64, UnitError> {
        self.read_as(text, Unit::value)
    }

    /// Parses a difference of two values, such as an uncertainty. Unlike [`read`](Self::read), it
    /// does not add the zero of a temperature scale.
    ///
    /// ```
    /// use longdrive::units::Quantity;
    /// assert_eq!(Quantity::TEMPERATURE.read("2 degC").unwrap(), 275.15);
    /// assert_eq!(Quantity::TEMPERATURE.read_difference("2 degC").unwrap(), 2.0);
    /// ```
    ///
    /// # Errors
    /// The errors of [`read`](Self::read).
    pub fn read_difference(self, text: &str) -> Result<f64, UnitError> {
        self.read_as(text, Unit::difference)
    }

    fn read_as(self, text: &str, of: fn(&Unit, f64) -> f64) -> Result<f64, UnitError> {
        match self.split(text)? {
            (number, "") if number.is_finite() && self.dimension != Dimension::NONE => {
                Err(UnitError::NoUnit {
                    text: text.into(),
                    wanted: self.name,
                    examples: self.units(),
                })
            }
            (number, "") => Ok(number),
            (number, unit) => self.unit(unit, text).map(|unit| of(&unit, number)),
        }
    }

    /// Like [`read`](Self::read), but a number without a unit is SI.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read), except a missing unit.
    pub fn read_bare(self, text: &str) -> Result<f64, UnitError> {
        match self.split(text)? {
            (number, "") => Ok(number),
            _ => self.read(text),
        }
    }

    /// Splits a string into number and unit; the unit may be empty.
    ///
    /// # Errors
    /// [`UnitError::NoNumber`] if the string does not start with a number, and
    /// [`UnitError::NotANumber`] if the number is NaN.
    pub fn split(self, text: &str) -> Result<(f64, &str), UnitError> {
        let unit = self.usual_unit();
        match split_number(text.trim()) {
            Some((number, _)) if number.is_nan() => Err(UnitError::NotANumber {
                text: text.into(),
                unit,
            }),
            Some(found) => Ok(found),
            None => Err(UnitError::NoNumber {
                text: text.into(),
                unit,
            }),
        }
    }

    /// `text` with its unit, or with the unit of `other` if `text` has none: the low end of
    /// `4..20deg` is 4 deg.
    ///
    /// # Errors
    /// The errors of [`split`](Self::split), for both texts.
    pub(crate) fn with_unit_of(self, text: &str, other: &str) -> Result<String, UnitError> {
        let (_, unit) = self.split(text)?;
        let (_, other_unit) = self.split(other)?;
        Ok(if unit.is_empty() {
            format!("{text} {other_unit}")
        } else {
            text.into()
        })
    }

    /// SI size of `unit`; for a temperature scale, the size of a degree. `None` for a unit of
    /// another quantity.
    ///
    /// ```
    /// use longdrive::units::Quantity;
    /// assert_eq!(Quantity::LENGTH.size_of("yd"), Some(0.9144));
    /// assert_eq!(Quantity::LENGTH.size_of("kg"), None);
    /// ```
    pub fn size_of(self, unit: &str) -> Option<f64> {
        self.unit_named(unit).map(|unit| unit.difference(1.0))
    }

    /// An SI value as a number in `unit`; a temperature counts from the zero of its scale. For a
    /// difference, divide by [`size_of`](Self::size_of) instead.
    ///
    /// ```
    /// use longdrive::units::Quantity;
    /// assert!((Quantity::TEMPERATURE.number_in(298.15, "degF") - 77.0).abs() < 1e-12);
    /// ```
    pub fn number_in(self, value: f64, unit: &str) -> f64 {
        self.unit_named(unit)
            .map_or(value, |unit| unit.number(value))
    }

    /// The first of the usual units; empty for a plain number.
    pub(crate) fn usual_unit(self) -> &'static str {
        if self.si.is_empty() {
            ""
        } else {
            self.usual.split(", ").next().unwrap_or_default()
        }
    }

    /// The unit with the spelling `written`, if it is a unit of this quantity: a usual unit or
    /// another unit symbol. `None` otherwise.
    pub(crate) fn known_unit(self, written: &str) -> Option<&'static str> {
        let symbols = SYMBOLS.iter().flat_map(|symbol| symbol.names).copied();
        let known = self
            .usual
            .split(", ")
            .chain(symbols)
            .find(|unit| *unit == written)?;
        self.size_of(known).map(|_| known)
    }

    /// Parses a unit, so that it can convert many numbers. `None` if it is not a unit of this
    /// quantity.
    pub(crate) fn unit_named(self, unit: &str) -> Option<Unit> {
        read_unit(unit).filter(|unit| unit.dimension == self.dimension)
    }

    /// An SI value as text in `unit`, spelled as a user types it.
    ///
    /// ```
    /// use longdrive::units::Quantity;
    /// assert_eq!(Quantity::SPEED.show(49.1744, "mph"), "110 mph");
    /// ```
    pub fn show(self, value: f64, unit: &str) -> String {
        typed(&significant(self.number_in(value, unit), 7), unit)
    }

    /// List of the valid units for messages: the usual units, then the other symbols of this
    /// quantity.
    ///
    /// ```
    /// use longdrive::units::Quantity;
    /// assert_eq!(Quantity::LENGTH.units(), "m, mm, yd, in, um, cm, km, ft, mi");
    /// ```
    pub fn units(self) -> String {
        let mut units: Vec<&str> = self.usual.split(", ").collect();
        let of_its_kind = SYMBOLS
            .iter()
            .filter(|symbol| symbol.dimension == self.dimension && symbol.names[0] != "1");
        for symbol in of_its_kind {
            let name = symbol.names[0];
            if !units
                .iter()
                .any(|unit| unit.trim_start_matches("or ") == name)
            {
                units.push(name);
            }
        }
        units.join(", ")
    }

    /// Hint for an unknown unit: a known unit that differs in case or by a missing `deg`, or the
    /// advice to write no comma. Empty without a hint.
    fn hint(self, unit: &str) -> String {
        if unit
            .strip_prefix(',')
            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
        {
            return " (leave out commas between thousands, and write a decimal point)".into();
        }
        let is_meant = |known: &&str| {
            [unit, &format!("deg{unit}")]
                .iter()
                .any(|text| known.eq_ignore_ascii_case(text))
        };
        let units = self.units();
        let meant = units.split(", ").find(is_meant);
        meant.map_or(String::new(), |known| format!(" (did you mean '{known}'?)"))
    }

    /// Parses `unit`; errors quote the whole `text`.
    ///
    /// # Errors
    /// [`UnitError`] for an unknown unit, and a unit of another quantity.
    fn unit(self, unit: &str, text: &str) -> Result<Unit, UnitError> {
        let found = read_unit(unit).ok_or_else(|| UnitError::UnknownUnit {
            text: text.into(),
            unit: unit.into(),
            hint: self.hint(unit),
            wanted: self.name,
            examples: self.units(),
        })?;
        if found.dimension == self.dimension {
            Ok(found)
        } else {
            Err(UnitError::WrongKind {
                text: text.into(),
                wanted: self.name,
                examples: self.units(),
            })
        }
    }
}

/// A number with at most `digits` significant digits, without trailing zeros.
///
/// ```
/// assert_eq!(longdrive::units::significant(0.25 + 1e-12, 7), "0.25");
/// assert_eq!(longdrive::units::significant(1.81e-5, 7), "1.81e-5");
/// ```
pub fn significant(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1))
        .parse()
        .unwrap_or(value);
    let plain = rounded == 0.0 || !rounded.is_finite() || (1e-3..1e9).contains(&rounded.abs());
    if plain {
        format!("{}", rounded + 0.0)
    } else {
        format!("{rounded:e}")
    }
}

/// The longest number at the start of a text, and the rest.
fn split_number(text: &str) -> Option<(f64, &str)> {
    let ends = text.char_indices().map(|(at, _)| at).chain([text.len()]);
    let number = |end: usize| {
        let prefix = text.get(..end)?;
        // "inf", "infinity" and "nan" parse too; "in" of "inch" does not
        let value = prefix.replace('\u{2212}', "-").parse::<f64>().ok()?;
        Some((value, end))
    };
    let (value, end) = ends.rev().find_map(number)?;
    Some((value, text[end..].trim()))
}

#[cfg(test)]
mod tests {
    use super::Quantity;

    #[test]
    fn display_units_are_units_of_their_quantity() {
        for quantity in Quantity::ALL {
            let with_decimals = quantity.decimals.iter().map(|(unit, _)| *unit);
            let of_systems = quantity.metric_and_us.iter().flat_map(|(m, us)| [*m, *us]);
            for unit in with_decimals
                .chain(of_systems)
                .filter(|unit| !unit.is_empty())
            {
                assert!(
                    quantity.size_of(unit).is_some(),
                    "{}: {unit}",
                    quantity.name
                );
            }
        }
    }
}
