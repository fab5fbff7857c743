//! Grammar of units: products of symbols with powers.

use super::symbols::{Dimension, spelled, symbol};

/// A unit: size, dimension and zero. The SI size is a fraction. Decimal units (g, cm², %) have a
/// whole number as denominator: 5679 g cm² is 5679/10⁷ kg m² to the last bit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    numerator: f64,
    denominator: f64,
    pub(super) dimension: Dimension,
    /// SI value of the scale's zero, for a temperature scale.
    pub(super) zero: Option<f64>,
}

impl Unit {
    /// SI value of a quantity in this unit: 25 degC is 298.15 K.
    pub fn value(&self, number: f64) -> f64 {
        let above = self.difference(number);
        self.zero.map_or(above, |zero| zero + above)
    }

    /// An SI value as a number in this unit. On a temperature scale the number counts from the zero
    /// of the scale: 298.15 K is 25 degC.
    pub fn number(&self, value: f64) -> f64 {
        (value - self.zero.unwrap_or(0.0)) / self.difference(1.0)
    }

    /// SI value of a difference in this unit: 25 degC is 25 K.
    pub fn difference(&self, number: f64) -> f64 {
        number * self.numerator / self.denominator
    }
}

/// Parses a product of units: factors separated by spaces, `*`, `·`, `.`, a hyphen before a letter,
/// or `/` (which applies to the next factor), each with an optional power: `kg/m^3`, `g cm²`,
/// `g-cm2`, `m s^-2`, `Pa.s`. A temperature scale with its own zero cannot be a factor.
pub(super) fn read_unit(text: &str) -> Option<Unit> {
    // fast path for a single symbol: a table of shots converts several values in every row
    if let Some(symbol) = spelled(text) {
        let [numerator, denominator] = fraction(symbol.size);
        return Some(Unit {
            numerator,
            denominator,
            dimension: symbol.dimension,
            zero: symbol.zero,
        });
    }
    let spaced = text.replace('/', " / ").replace(['*', '·', '⋅', '.'], " ");
    let spaced = without_hyphens(&spaced);
    let mut unit = Unit {
        numerator: 1.0,
        denominator: 1.0,
        dimension: Dimension::NONE,
        zero: None,
    };
    let is_alone = spaced.split_whitespace().count() == 1;
    let mut divide = false;
    for factor in spaced.split_whitespace() {
        if factor == "/" {
            if divide {
                return None;
            }
            divide = true;
            continue;
        }
        let (name, power) = split_power(factor)?;
        let known = symbol(name)?;
        let power = if divide { -power } else { power };
        if known.zero.is_some() && !(is_alone && power == 1) {
            return None;
        }
        unit.zero = known.zero;
        let [mut numerator, mut denominator] = fraction(known.size);
        if power < 0 {
            std::mem::swap(&mut numerator, &mut denominator);
        }
        for _ in 0..power.unsigned_abs() {
            unit.numerator *= numerator;
            unit.denominator *= denominator;
        }
        unit.dimension = unit.dimension.times(known.dimension, power);
        divide = false;
    }
    (!divide && !spaced.trim().is_empty()).then_some(unit)
}

/// The text with a space in place of each hyphen between letters, as in `g-cm²`.
fn without_hyphens(text: &str) -> String {
    let is_letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
    text.char_indices()
        .map(|(at, c)| {
            let joins = is_letter(text[..at].chars().next_back())
                && is_letter(text[at + c.len_utf8()..].chars().next());
            if c == '-' && joins { ' ' } else { c }
        })
        .collect()
}

/// A size as [numerator, denominator]. A size of 1/n with a whole number n has the denominator n,
/// so that decimal units have no rounding error. Other sizes have the denominator 1.
fn fraction(size: f64) -> [f64; 2] {
    let inverse = size.recip();
    let is_decimal = (inverse - inverse.round()).abs() <= 1e-12 * inverse;
    if is_decimal {
        [1.0, inverse.round()]
    } else {
        [size, 1.0]
    }
}

fn split_power(factor: &str) -> Option<(&str, i8)> {
    if let Some((symbol, power)) = factor.split_once('^') {
        return power
            .parse()
            .ok()
            .filter(|power| (-9..=9).contains(power))
            .map(|power| (symbol, power));
    }
    let powers = [('²', 2), ('³', 3), ('2', 2), ('3', 3)];
    let found = powers.iter().find_map(|&(sign, power)| {
        let symbol = factor.strip_suffix(sign)?;
        // the 2 of 12 is no power
        symbol
            .ends_with(char::is_alphabetic)
            .then_some((symbol, power))
    });
    Some(found.unwrap_or((factor, 1)))
}
