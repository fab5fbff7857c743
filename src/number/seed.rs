use super::{Jet, Jet2, Number};
use num_dual::{Dual2_64, Dual64};

/// A number that can be an independent variable, and tells derivatives by it. The one place that knows how
/// each kind stores them.
pub(crate) trait Seeded: Number {
    /// The independent variable of this direction.
    fn seeded(value: f64, direction: usize) -> Self;
    /// First derivative in a direction.
    fn first(&self, direction: usize) -> f64;
    /// Second derivative in two directions, 0 for a number that holds none.
    fn second(&self, _i: usize, _j: usize) -> f64 {
        0.0
    }
}

impl Seeded for f64 {
    fn seeded(value: f64, _: usize) -> Self {
        value
    }

    fn first(&self, _: usize) -> f64 {
        0.0
    }
}

impl Seeded for Dual64 {
    fn seeded(value: f64, _: usize) -> Self {
        Self::from(value).derivative()
    }

    fn first(&self, _: usize) -> f64 {
        self.eps
    }
}

impl Seeded for Dual2_64 {
    fn seeded(value: f64, _: usize) -> Self {
        Self::from(value).derivative()
    }

    fn first(&self, _: usize) -> f64 {
        self.v1
    }

    fn second(&self, _: usize, _: usize) -> f64 {
        self.v2
    }
}

impl<const N: usize> Seeded for Jet<N> {
    fn seeded(value: f64, direction: usize) -> Self {
        Self::variable(value, direction)
    }

    fn first(&self, direction: usize) -> f64 {
        self.gradient[direction]
    }
}

impl<const N: usize, const M: usize> Seeded for Jet2<N, M> {
    fn seeded(value: f64, direction: usize) -> Self {
        Self::variable(value, direction)
    }

    fn first(&self, direction: usize) -> f64 {
        self.gradient[direction]
    }

    fn second(&self, i: usize, j: usize) -> f64 {
        Jet2::second(self, i, j)
    }
}
