use super::declare::Parameter;
use super::table::FlightConditions;
use crate::error::{Error, Result};

/// Steps of a flight that someone still waits for: tens of seconds.
const MOST: f64 = 1e8;

impl<T> FlightConditions<T> {
    /// A flight of more steps than anyone waits for is refused before it begins.
    ///
    /// # Errors
    /// [`Error::OutOfRange`], [`Error::NotANumber`].
    #[inline]
    pub(crate) fn check_steps(&self) -> Result<()> {
        let is_short = self.step > 0.0 && self.time_limit / self.step <= MOST;
        if is_short {
            Ok(())
        } else {
            Err(refusal(self.step, self.time_limit))
        }
    }
}

/// Why there would be too many steps, or an endless number of them.
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
            value: format!("{step:e} s"),
            range: format!(
                "{:e} s <= …: at most {MOST:e} steps up to flight.time_limit = {limit} \
                            s",
                limit / MOST
            ),
            advice: "take a longer step or a shorter time limit (10 ms, the default, keeps carry \
                     within 10 µm)"
                .into(),
        })
}
