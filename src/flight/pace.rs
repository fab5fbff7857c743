use crate::parameters::{Method, Setup};

/// How a flight is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pace {
    pub method: Method,
    /// h, s.
    pub step: f64,
    /// s.
    pub time_limit: f64,
}

impl Pace {
    /// How the flights of a setup are followed.
    #[inline(always)]
    pub fn of<T>(setup: &Setup<T>) -> Self {
        Self { method: setup.method, step: setup.flight.step, time_limit: setup.flight.time_limit }
    }
}
