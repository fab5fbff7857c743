use super::ending::Flight;
use super::inputs::Inputs;
use super::result::RequestedOutputs;
use super::step::Observer;
use crate::error::Result;
use crate::launch::Launch;
use crate::number::Number;
use crate::parameters::Setup;

/// Flies the ball from launch to landing (docs/model.md, eqs. 12–18). No heap memory is used.
///
/// # Errors
/// [`Error::Diverged`](crate::Error::Diverged) where drag and lift change the airspeed too much
/// within a step, or numbers overflow; [`Error::OutOfRange`](crate::Error::OutOfRange) and
/// [`Error::NotANumber`](crate::Error::NotANumber) for a step that makes no steps, or more than 1e8
/// up to the time limit.
pub fn fly<T: Number>(setup: &Setup<T>, launch: &Launch<T>) -> Result<Flight<T>> {
    setup.flight.check_steps()?;
    Inputs::new(setup, launch, true).fly(None)
}

impl<T: Number> Inputs<T> {
    /// Flies one ball.
    ///
    /// # Errors
    /// [`Error::Diverged`] where drag and lift change the airspeed too much within a step, or
    /// numbers overflow.
    pub(crate) fn fly(&self, observer: Observer<'_, T>) -> Result<Flight<T>> {
        let ended = self.integrate(
            true,
            RequestedOutputs {
                apex: true,
                defect: true,
            },
            observer,
        );
        Ok(match ended.no_landing_reason(self, T::re)? {
            None => Flight::Landed(ended.landed),
            Some(why) => Flight::None(why),
        })
    }
}
