use super::{Jet, Number};

/// Access to derivatives by direction. The directions of the outer jet come first, the directions
/// of its inner jets follow.
pub(crate) trait Derivatives: Number {
    /// First derivative in one direction.
    fn first(&self, direction: usize) -> f64;
    /// Second derivative in directions 0 and 1; 0 if the type has none.
    fn second(&self) -> f64;
}

impl Derivatives for f64 {
    fn first(&self, _: usize) -> f64 {
        0.0
    }

    fn second(&self) -> f64 {
        0.0
    }
}

impl<const K: usize, B: Derivatives> Derivatives for Jet<K, B> {
    fn first(&self, direction: usize) -> f64 {
        if direction < K {
            self.gradient[direction].re()
        } else {
            self.re.first(direction - K)
        }
    }

    fn second(&self) -> f64 {
        self.gradient[0].first(0)
    }
}
