//! Flight of the ball: equation of motion, integration with a fixed step, landing (docs/model.md,
//! eqs. 12–18).

mod held;
mod inputs;
mod landing;
mod motion;
mod result;
mod septic;
mod step;
mod tableau;
mod trajectory;

pub(crate) use held::{change_by_holding, stays_within};
pub(crate) use inputs::Inputs;
pub use result::{Apex, Flight, Landed, NoFlight};
pub(crate) use result::{FlightResult, RequestedOutputs};
pub use trajectory::{Trajectory, TrajectoryPoint, trajectory, trajectory_until};

use crate::error::Result;
use crate::launch::Launch;
use crate::number::Number;
use crate::parameters::Setup;
use step::StepObserver;

/// Flies the ball from launch to landing (docs/model.md, eqs. 12–18). Allocates no heap memory,
/// except for the splines of a law in the first flight with this law.
///
/// # Errors
/// [`Error::Diverged`](crate::Error::Diverged) if drag and lift change the airspeed too much within
/// a step, or if a number overflows; [`Error::OutOfRange`](crate::Error::OutOfRange) and
/// [`Error::NotANumber`](crate::Error::NotANumber) for a step that is not positive, or so short
/// that the time limit contains more than 1e8 steps.
pub fn fly<T: Number>(setup: &Setup<T>, launch: &Launch<T>) -> Result<Flight<T>> {
    setup.flight.check_steps()?;
    Inputs::new(setup, launch).fly(RequestedOutputs::all(None), None)
}

impl<T: Number> Inputs<T> {
    /// Computes the flight of one ball. The observer receives each step.
    ///
    /// # Errors
    /// [`Error::Diverged`](crate::Error::Diverged) if drag and lift change the airspeed too much
    /// within a step, or if a number overflows; [`Error::Stopped`](crate::Error::Stopped) after an
    /// interrupt.
    pub(crate) fn fly(
        &self,
        outputs: RequestedOutputs<'_>,
        observer: StepObserver<'_, T>,
    ) -> Result<Flight<T>> {
        let result = self.integrate(true, outputs, observer);
        Ok(match result.no_landing_reason(self, T::re)? {
            None => Flight::Landed(result.landed),
            Some(reason) => Flight::None(reason),
        })
    }
}
