use super::{Jet, Mixed, Number};

/// A number that can be an independent variable, and tells derivatives by it.
pub(crate) trait Seeded: Number {
    /// The number that changes like its value in the directions that are so told.
    fn seeded(value: f64, changes_in: impl Fn(usize) -> bool) -> Self;
    /// First derivative in a direction.
    fn first(&self, direction: usize) -> f64;
    /// Second derivative in directions 0 and 1, where it is held.
    fn second(&self) -> Option<f64> {
        None
    }
}

impl Seeded for f64 {
    fn seeded(value: f64, _: impl Fn(usize) -> bool) -> Self {
        value
    }

    fn first(&self, _: usize) -> f64 {
        0.0
    }
}

impl<const K: usize> Seeded for Jet<K> {
    fn seeded(value: f64, changes_in: impl Fn(usize) -> bool) -> Self {
        Self { re: value, gradient: std::array::from_fn(|k| f64::from(u8::from(changes_in(k)))) }
    }

    fn first(&self, direction: usize) -> f64 {
        self.gradient[direction]
    }
}

impl Seeded for Mixed {
    fn seeded(value: f64, changes_in: impl Fn(usize) -> bool) -> Self {
        let change = f64::from(u8::from(changes_in(1)));
        Self { re: Jet::seeded(value, |_| changes_in(0)), gradient: [Jet { re: change, gradient: [0.0] }] }
    }

    fn first(&self, direction: usize) -> f64 {
        if direction == 0 { self.re.gradient[0] } else { self.gradient[0].re }
    }

    fn second(&self) -> Option<f64> {
        Some(self.gradient[0].gradient[0])
    }
}
