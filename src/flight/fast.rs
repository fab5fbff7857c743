use super::landing::{Flight, Wanted};
use super::pace::Pace;
use super::shot::Shot;
use crate::error::Result;
use crate::number::{Counterpart, Factor, Fast, Level, Numbers, Task, Vector};
use std::marker::PhantomData;

impl<T: Fast> Shot<T> {
    /// The flight over the number that does for this one what the machine does fastest.
    pub(crate) fn fly_fast(&self, pace: &Pace, wanted: Wanted) -> Result<Flight<T>> {
        let quick = match Level::here() {
            Level::Eight => Level::run_eight(Launched::<T, T::Eight>::new(self, pace, wanted)),
            Level::Four => Level::run_four(Launched::<T, T::Four>::new(self, pace, wanted)),
            // other processors have no higher level, and no other copy of this
            Level::Baseline if cfg!(not(target_arch = "x86_64")) => Some(self.fly_shortest::<T::Value>(pace, wanted)),
            Level::Baseline => None,
        };
        quick.unwrap_or_else(|| self.fly::<Vector<T>>(pace, wanted, |_| ()))
    }
}

/// A flight differentiated, for the most part, by how the ball leaves alone.
type Launched<'a, T, F> = Over<'a, T, F, <F as Numbers>::Value>;

/// A flight over another number than it is asked for in, its constants kept in `C`.
pub(crate) struct Over<'a, T, F, C = F> {
    shot: &'a Shot<T>,
    pace: &'a Pace,
    wanted: Wanted,
    number: PhantomData<(F, C)>,
}

impl<'a, T, F, C> Over<'a, T, F, C> {
    pub fn new(shot: &'a Shot<T>, pace: &'a Pace, wanted: Wanted) -> Self {
        Self { shot, pace, wanted, number: PhantomData }
    }
}

impl<T: Numbers, F: Counterpart<T>, C: Factor<F>> Task for Over<'_, T, F, C> {
    type Output = Result<Flight<T>>;

    #[inline(always)]
    fn run(self) -> Self::Output {
        let flight = self.shot.map(F::made_of).fly_shortest::<C>(self.pace, self.wanted)?;
        Ok(match flight {
            Flight::Landed(landed) => Flight::Landed(landed.map(F::plain)),
            Flight::None(why) => Flight::None(why),
        })
    }
}
