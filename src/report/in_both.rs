//! A value for readers of either system of units.

use crate::units::System;

/// A value in metric and in US units.
#[derive(Clone, Debug)]
pub struct InBoth<T> {
    /// The value in metric units.
    pub metric: T,
    /// The value in US units.
    pub us: T,
}

impl<T> InBoth<T> {
    /// The value that `make` returns for each system.
    pub fn of(make: impl Fn(System) -> T) -> Self {
        Self {
            metric: make(System::Metric),
            us: make(System::Us),
        }
    }

    /// The value in a system.
    pub fn get(&self, system: System) -> &T {
        match system {
            System::Metric => &self.metric,
            System::Us => &self.us,
        }
    }
}
