//! The grammar of units: products of symbols with powers, as a size and a dimension.

use super::dimension::Dimension;
use super::symbols::symbol_size;

/// The SI size of a unit as a fraction, so that decimal units (g, cm², %) divide by whole numbers: 5679 g cm² is
/// 5679/10⁷ kg m² to the last bit.
#[derive(Clone, Copy)]
pub(super) struct Size {
    times: f64,
    over: f64,
}

impl Size {
    const ONE: Self = Self { times: 1.0, over: 1.0 };

    fn new(size: f64) -> Self {
        let inverse = size.recip();
        if (inverse - inverse.round()).abs() <= 1e-12 * inverse {
            Self { times: 1.0, over: inverse.round() }
        } else {
            Self { times: size, over: 1.0 }
        }
    }

    fn times(self, other: Self) -> Self {
        Self { times: self.times * other.times, over: self.over * other.over }
    }

    fn inverse(self) -> Self {
        Self { times: self.over, over: self.times }
    }

    pub fn of(self, number: f64) -> f64 {
        number * self.times / self.over
    }
}

/// The SI size and the dimension of a product of units: factors separated by spaces, `*`, `·`, `.` or `/` (which
/// divides by the one factor that follows), each perhaps with a power: `kg/m^3`, `g cm²`, `m s^-2`, `Pa.s`.
pub(super) fn read_unit(text: &str) -> Option<(Size, Dimension)> {
    let spaced = text.replace('/', " / ").replace(['*', '·', '⋅', '.'], " ");
    let (mut size, mut dimension) = (Size::ONE, Dimension::NONE);
    let mut divide = false;
    for factor in spaced.split_whitespace() {
        if factor == "/" {
            if divide {
                return None;
            }
            divide = true;
            continue;
        }
        let (symbol, power) = split_power(factor)?;
        let (one, kind) = symbol_size(symbol)?;
        let power = if divide { -power } else { power };
        let one = if power > 0 { Size::new(one) } else { Size::new(one).inverse() };
        for _ in 0..power.unsigned_abs() {
            size = size.times(one);
        }
        dimension = dimension.times(kind, power);
        divide = false;
    }
    (!divide && !spaced.trim().is_empty()).then_some((size, dimension))
}

fn split_power(factor: &str) -> Option<(&str, i8)> {
    if let Some((symbol, power)) = factor.split_once('^') {
        return power.parse().ok().filter(|p: &i8| p.abs() <= 9).map(|power| (symbol, power));
    }
    let powers = [('²', 2), ('³', 3)];
    let found = powers.iter().find_map(|&(sign, power)| Some((factor.strip_suffix(sign)?, power)));
    Some(found.unwrap_or((factor, 1)))
}
