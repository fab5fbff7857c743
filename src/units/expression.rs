//! The grammar of units: products of symbols with powers, as a size, a dimension and perhaps a
//! zero.

use super::dimension::Dimension;
use super::symbols::symbol;

/// The SI size of a unit as a fraction, so that decimal units (g, cm², %) divide by whole numbers:
/// 5679 g cm² is 5679/10⁷ kg m² to the last bit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size {
    times: f64,
    over: f64,
}

impl Size {
    const ONE: Self = Self {
        times: 1.0,
        over: 1.0,
    };

    fn new(size: f64) -> Self {
        let inverse = size.recip();
        if (inverse - inverse.round()).abs() <= 1e-12 * inverse {
            Self {
                times: 1.0,
                over: inverse.round(),
            }
        } else {
            Self {
                times: size,
                over: 1.0,
            }
        }
    }

    fn times(self, other: Self) -> Self {
        Self {
            times: self.times * other.times,
            over: self.over * other.over,
        }
    }

    fn inverse(self) -> Self {
        Self {
            times: self.over,
            over: self.times,
        }
    }

    pub fn of(self, number: f64) -> f64 {
        number * self.times / self.over
    }
}

/// A unit: how numbers in it become SI.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    size: Size,
    pub(super) dimension: Dimension,
    /// Where its zero lies, SI, for a scale of temperature that begins elsewhere.
    zero: Option<f64>,
}

impl Unit {
    /// So many of it, as a quantity: 25 degC is 298.15 K.
    pub fn value(&self, number: f64) -> f64 {
        let above = self.difference(number);
        self.zero.map_or(above, |zero| zero + above)
    }

    /// So many of it, as a difference of two quantities: 25 degC is 25 K.
    pub fn difference(&self, number: f64) -> f64 {
        self.size.of(number)
    }
}

/// The unit that a product of units is: factors separated by spaces, `*`, `·`, `.` or `/` (which
/// divides by the one factor that follows), each perhaps with a power: `kg/m^3`, `g cm²`, `m s^-2`,
/// `Pa.s`. A scale with a zero of its own stands alone.
pub(super) fn read_unit(text: &str) -> Option<Unit> {
    let spaced = text.replace('/', " / ").replace(['*', '·', '⋅', '.'], " ");
    let (mut size, mut dimension, mut zero) = (Size::ONE, Dimension::NONE, None);
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
        zero = known.zero;
        let one = if power > 0 {
            Size::new(known.size)
        } else {
            Size::new(known.size).inverse()
        };
        for _ in 0..power.unsigned_abs() {
            size = size.times(one);
        }
        dimension = dimension.times(known.dimension, power);
        divide = false;
    }
    (!divide && !spaced.trim().is_empty()).then_some(Unit {
        size,
        dimension,
        zero,
    })
}

fn split_power(factor: &str) -> Option<(&str, i8)> {
    if let Some((symbol, power)) = factor.split_once('^') {
        return power
            .parse()
            .ok()
            .filter(|p: &i8| p.abs() <= 9)
            .map(|power| (symbol, power));
    }
    let powers = [('²', 2), ('³', 3)];
    let found = powers
        .iter()
        .find_map(|&(sign, power)| Some((factor.strip_suffix(sign)?, power)));
    Some(found.unwrap_or((factor, 1)))
}
