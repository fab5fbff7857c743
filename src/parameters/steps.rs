use super::choices::METHOD;
use super::declare::Parameter;
use super::table::FlightConditions;
use crate::error::{Error, Result};

/// True for `flight.method` and `flight.step`.
pub fn is_of_step(name: &str) -> bool {
    matches!(name, METHOD | "flight.step")
}

/// Largest number of steps of a flight. Such a flight takes tens of seconds.
const MOST_STEPS: f64 = 1e8;

impl<T> FlightConditions<T> {
    /// Refuses a flight of more than 1e8 steps, and a step that is not positive.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the step or the time limit is outside its range, or if there are
    /// too many steps; [`Error::NotANumber`] if one of the two is NaN.
    #[inline]
    pub(crate) fn check_steps(&self) -> Result<()> {
        let is_short = self.step > 0.0 && self.time_limit / self.step <= MOST_STEPS;
        if is_short {
            Ok(())
        } else {
            Err(refusal(self.step, self.time_limit))
        }
    }
}

/// The error for a step or a time limit outside of its range, and for too many steps.
#[cold]
fn refusal(step: f64, limit: f64) -> Error {
    let row = |name: &str| {
        FlightConditions::<f64>::rows()
            .iter()
            .find(|row| row.name == name)
    };
    let check = |(name, value)| row(name).and_then(|row: &Parameter| row.check(value).err());
    [("flight.step", step), ("flight.time_limit", limit)]
        .into_iter()
        .find_map(check)
        .unwrap_or_else(|| Error::OutOfRange {
            name: "flight.step".into(),
            si: step,
            value: format!("{step:e} s"),
            range: format!(
                "{:e} s ≤ …: at most {MOST_STEPS:e} steps up to flight.time_limit = {limit} s",
                limit / MOST_STEPS
            ),
            advice: "take a longer step or a shorter time limit (10 ms, the default, keeps carry \
                     within 10 µm)"
                .into(),
        })
}
