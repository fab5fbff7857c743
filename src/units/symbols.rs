use std::collections::HashMap;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// A yard, m.
pub const YARD: f64 = 0.9144;
/// A mile per hour, m/s.
pub const MPH: f64 = 0.44704;
/// A degree, rad.
pub const DEGREE: f64 = TAU / 360.0;
/// A revolution per minute, rad/s.
pub const RPM: f64 = TAU / 60.0;

/// Exponents of length, mass, time, angle and temperature. The angle is a dimension, so that 10 rpm
/// are not 10 per minute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dimension(pub [i8; 5]);

impl Dimension {
    pub const NONE: Self = Self([0, 0, 0, 0, 0]);
    pub const LENGTH: Self = Self([1, 0, 0, 0, 0]);
    pub const MASS: Self = Self([0, 1, 0, 0, 0]);
    pub const TIME: Self = Self([0, 0, 1, 0, 0]);
    pub const ANGLE: Self = Self([0, 0, 0, 1, 0]);
    pub const TEMPERATURE: Self = Self([0, 0, 0, 0, 1]);

    pub fn times(self, other: Self, power: i8) -> Self {
        let Self(mut exponents) = self;
        for (mine, theirs) in exponents.iter_mut().zip(other.0) {
            *mine = mine.saturating_add(theirs.saturating_mul(power));
        }
        Self(exponents)
    }
}

/// A unit symbol.
pub(super) struct Symbol {
    /// Spellings; the first spelling is for output.
    pub names: &'static [&'static str],
    /// SI size.
    pub size: f64,
    pub dimension: Dimension,
    /// SI value of the zero of a temperature scale.
    pub zero: Option<f64>,
}

/// All unit symbols.
pub(super) static SYMBOLS: LazyLock<Vec<Symbol>> = LazyLock::new(symbols);

/// The unit symbols by their spellings.
static BY_NAME: LazyLock<HashMap<&str, &Symbol>> = LazyLock::new(|| {
    let spellings = |symbol: &'static Symbol| symbol.names.iter().map(move |name| (*name, symbol));
    SYMBOLS.iter().flat_map(spellings).collect()
});

/// The unit symbol with exactly this spelling.
pub(super) fn spelled(name: &str) -> Option<&'static Symbol> {
    BY_NAME.get(name).copied()
}

/// Minimum length of a name whose case does not matter. Shorter names may differ by case alone:
/// "Mm" and "mm", "MG" and "mg".
const LEAST_LETTERS: usize = 3;

/// The unit symbol with this name. The case of a name of at least three letters does not matter:
/// "MPH", "Yards".
pub(super) fn symbol(name: &str) -> Option<&'static Symbol> {
    let is_word = name.len() >= LEAST_LETTERS;
    let is_meant = |known: &&Symbol| known.names.iter().any(|own| own.eq_ignore_ascii_case(name));
    spelled(name).or_else(|| SYMBOLS.iter().filter(|_| is_word).find(is_meant))
}

/// The unit symbols. Their sizes are exact definitions. Sources: SI brochure, 9th edition; the yard
/// and the pound of 1959, which define inch, foot, mile and ounce; for inHg and mmHg, mercury with
/// a density of 13 595.1 kg/m³ at standard gravity.
fn symbols() -> Vec<Symbol> {
    use Dimension as D;
    let symbol = |names, size, dimension| Symbol {
        names,
        size,
        dimension,
        zero: None,
    };
    let scale = |names, size, zero| Symbol {
        names,
        size,
        dimension: D::TEMPERATURE,
        zero: Some(zero),
    };
    let speed = D::LENGTH.times(D::TIME, -1);
    let force = speed.times(D::MASS, 1).times(D::TIME, -1);
    let pressure = force.times(D::LENGTH, -2);
    let viscosity = D::MASS.times(D::LENGTH, -1).times(D::TIME, -1);
    vec![
        symbol(&["1"], 1.0, D::NONE),
        symbol(&["%"], 1e-2, D::NONE),
        symbol(&["m", "metre", "metres", "meter", "meters"], 1.0, D::LENGTH),
        symbol(&["um", "µm", "μm"], 1e-6, D::LENGTH),
        symbol(&["mm"], 1e-3, D::LENGTH),
        symbol(&["cm"], 1e-2, D::LENGTH),
        symbol(&["km"], 1e3, D::LENGTH),
        symbol(&["in", "inch", "inches"], 0.0254, D::LENGTH),
        symbol(&["ft", "foot", "feet"], 0.3048, D::LENGTH),
        symbol(&["yd", "yard", "yards"], YARD, D::LENGTH),
        symbol(&["mi", "mile", "miles"], 1609.344, D::LENGTH),
        symbol(&["L", "l"], 1e-3, D::NONE.times(D::LENGTH, 3)),
        symbol(&["kg"], 1.0, D::MASS),
        symbol(&["g", "gram", "grams"], 1e-3, D::MASS),
        symbol(&["mg"], 1e-6, D::MASS),
        symbol(&["oz"], 0.028_349_523_125, D::MASS),
        symbol(&["lb", "lbs"], 0.453_592_37, D::MASS),
        symbol(&["s", "sec", "second", "seconds"], 1.0, D::TIME),
        symbol(&["ms"], 1e-3, D::TIME),
        symbol(&["min", "minute", "minutes"], 60.0, D::TIME),
        symbol(&["h", "hour", "hours"], 3600.0, D::TIME),
        symbol(&["rad", "radian", "radians"], 1.0, D::ANGLE),
        symbol(&["mrad"], 1e-3, D::ANGLE),
        symbol(&["deg", "°", "degree", "degrees"], DEGREE, D::ANGLE),
        symbol(&["rev"], TAU, D::ANGLE),
        symbol(&["rpm"], RPM, D::ANGLE.times(D::TIME, -1)),
        symbol(&["mph"], MPH, speed),
        symbol(&["kph", "kmh"], 1.0 / 3.6, speed),
        symbol(&["kn", "kt", "knot", "knots"], 1852.0 / 3600.0, speed),
        symbol(&["N"], 1.0, force),
        symbol(&["Pa"], 1.0, pressure),
        symbol(&["hPa"], 100.0, pressure),
        symbol(&["kPa"], 1000.0, pressure),
        symbol(&["bar"], 1e5, pressure),
        symbol(&["mbar", "mb"], 100.0, pressure),
        symbol(
            &["psi"],
            0.453_592_37 * 9.80665 / (0.0254 * 0.0254),
            pressure,
        ),
        symbol(&["mmHg"], 133.322_387_415, pressure),
        symbol(&["inHg"], 3_386.388_640_341, pressure),
        symbol(&["K", "kelvin"], 1.0, D::TEMPERATURE),
        scale(&["degC", "°C", "C", "celsius"], 1.0, 273.15),
        scale(
            &["degF", "°F", "F", "fahrenheit"],
            5.0 / 9.0,
            459.67 * 5.0 / 9.0,
        ),
        symbol(&["P"], 0.1, viscosity),
        symbol(&["cP"], 1e-3, viscosity),
    ]
}

#[cfg(test)]
mod tests {
    use super::{SYMBOLS, symbol};
    use std::f64::consts::TAU;

    /// Relative tolerance for a size that is exact by definition.
    const EXACT: f64 = f64::EPSILON;
    /// Relative tolerance for a size that NIST prints with seven digits.
    const SEVEN_DIGITS: f64 = 5e-7;

    /// The sizes in NIST Special Publication 811 (Thompson & Taylor 2008), tables 5 to 7 and
    /// appendix B.8. For sizes that NIST prints with fewer than seven digits, a test of the Python
    /// package compares with the library pint.
    #[test]
    fn published_sizes_are_those_of_nist_sp_811() {
        let sizes = [
            ("1", 1.0, EXACT),
            ("%", 0.01, EXACT),
            ("m", 1.0, EXACT),
            ("um", 1e-6, EXACT),
            ("mm", 1e-3, EXACT),
            ("cm", 1e-2, EXACT),
            ("km", 1e3, EXACT),
            ("in", 2.54e-2, EXACT),
            ("ft", 3.048e-1, EXACT),
            ("yd", 9.144e-1, EXACT),
            ("mi", 1.609344e3, EXACT),
            ("L", 1e-3, EXACT),
            ("kg", 1.0, EXACT),
            ("g", 1e-3, EXACT),
            ("mg", 1e-6, EXACT),
            ("oz", 2.834952e-2, SEVEN_DIGITS),
            ("lb", 4.535924e-1, SEVEN_DIGITS),
            ("s", 1.0, EXACT),
            ("ms", 1e-3, EXACT),
            ("min", 60.0, EXACT),
            ("h", 3600.0, EXACT),
            ("rad", 1.0, EXACT),
            ("mrad", 1e-3, EXACT),
            ("deg", 1.745329e-2, SEVEN_DIGITS),
            ("rev", TAU, EXACT),
            ("rpm", 1.047198e-1, SEVEN_DIGITS),
            ("mph", 4.4704e-1, EXACT),
            ("kph", 2.777778e-1, SEVEN_DIGITS),
            ("kn", 5.144444e-1, SEVEN_DIGITS),
            ("N", 1.0, EXACT),
            ("Pa", 1.0, EXACT),
            ("hPa", 100.0, EXACT),
            ("kPa", 1000.0, EXACT),
            ("bar", 1e5, EXACT),
            ("mbar", 100.0, EXACT),
            ("psi", 6.894757e3, SEVEN_DIGITS),
            ("mmHg", 1.333224e2, SEVEN_DIGITS),
            ("inHg", 3.386389e3, SEVEN_DIGITS),
            ("K", 1.0, EXACT),
            ("degC", 1.0, EXACT),
            ("degF", 5.555556e-1, SEVEN_DIGITS),
            ("P", 0.1, EXACT),
            ("cP", 1e-3, EXACT),
        ];
        assert_eq!(sizes.len(), SYMBOLS.len(), "every symbol is here");
        for (name, theirs, within) in sizes {
            let ours = symbol(name).unwrap().size;
            assert!(
                (ours - theirs).abs() <= within * theirs,
                "{name}: {ours:e} against {theirs:e}"
            );
        }
    }

    /// NIST SP 811, appendix B.7: t/°C = T/K − 273.15 and t/°F = 1.8 T/K − 459.67.
    #[test]
    fn published_zeros_are_those_of_nist_sp_811() {
        let zeros = [("degC", 273.15), ("degF", 459.67 / 1.8)];
        for (name, theirs) in zeros {
            let ours = symbol(name).unwrap().zero.unwrap();
            assert!(
                (ours - theirs).abs() <= f64::EPSILON * theirs,
                "{name}: {ours:e} against {theirs:e}"
            );
        }
        assert_eq!(
            SYMBOLS
                .iter()
                .filter(|symbol| symbol.zero.is_some())
                .count(),
            zeros.len()
        );
    }
}
