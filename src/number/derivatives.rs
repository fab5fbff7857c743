use super::{Jet, Mixed, Number};

/// A number that tells derivatives by the directions it was seeded with.
pub(crate) trait Derivatives: Number {
    /// First derivative in a direction.
    fn first(&self, direction: usize) -> f64;
    /// Second derivative in directions 0 and 1, where it is held.
    fn second(&self) -> Option<f64> {
        None
    }
}

impl Derivatives for f64 {
    fn first(&self, _: usize) -> f64 {
        0.0
    }
}

impl<const K: usize> Derivatives for Jet<K> {
    fn first(&self, direction: usize) -> f64 {
        self.gradient[direction]
    }
}

impl Derivatives for Mixed {
    fn first(&self, direction: usize) -> f64 {
        if direction == 0 { self.gradient[0].re } else { self.re.gradient[0] }
    }

    fn second(&self) -> Option<f64> {
        Some(self.gradient[0].gradient[0])
    }
}
