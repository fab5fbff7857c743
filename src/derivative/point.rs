use super::Taylor;
use crate::drive::{Outcome, Part, Shown};
use crate::error::{Error, Result};
use crate::flight::Inputs;
use crate::impact::strike;
use crate::launch::Launch;
use crate::number::{Lanes, Level, Mask, Number, inlined};
use crate::parameters::{Parameter, Setup};

/// A point at which outcomes and their derivatives are taken.
pub(super) struct Point<'a> {
    /// The setup at this point.
    pub setup: &'a Setup<f64>,
    pub of: &'a [Outcome],
    pub wrt: &'a [&'static Parameter],
    /// The parameters' values.
    pub x: &'a [f64],
    /// Whether an outcome is of the flight, whether one is of its apex, and whether one is of the run after it.
    pub flies: bool,
    pub has_apex: bool,
    pub has_run: bool,
    /// The most that is used of what the processor can do.
    pub level: Level,
}

impl Point<'_> {
    /// Flies a ball that leaves like this, whose drive `lanes` lanes hold, and shows each lane's outcomes to `take`, with their indices.
    #[inline(always)]
    pub fn fly<J: Lanes>(
        &self,
        setup: &Setup<J>,
        launch: &Launch<J>,
        lanes: usize,
        mut take: impl FnMut(usize, usize, J::Lane),
    ) -> Result<()> {
        let inputs = Inputs::new(setup, launch, self.has_run);
        let ended = inputs.follow(J::Mask::first(lanes), self.has_apex, &mut |_, _| ());
        // the drive is the same in all lanes
        if let Some(why) = ended.missing(&inputs, 0, |number| number.lane(0).re())? {
            return Err(Error::NoFlight { reason: why.message() });
        }
        for lane in 0..lanes {
            let in_lane = inlined!(|number: J| number.lane(lane));
            let (launch, landed) = (launch.map(in_lane), ended.landed.map(in_lane));
            let shown = Shown { launch: &launch, club_speed: None, landed: Some(&landed), head: None };
            for (i, outcome) in self.of.iter().enumerate().filter(|(_, outcome)| outcome.part() == Part::Flight) {
                take(lane, i, outcome.shown(&shown).ok_or_else(|| outcome.missing())?);
            }
        }
        Ok(())
    }

    /// Why there is no drive, where a pass has found none.
    pub fn refusal(&self) -> Error {
        strike(self.setup).err().unwrap_or_else(|| Error::Undefined {
            what: "the impact".into(),
            reason: "it lies on the edge of where the club strikes the ball".into(),
        })
    }
}

/// Taylor polynomials to be filled in, with so many columns and rows of second derivatives.
pub(super) fn blank(count: usize, columns: usize, rows: usize) -> Vec<Taylor> {
    let blank = || Taylor { value: 0.0, gradient: vec![0.0; columns], hessian: vec![vec![0.0; columns]; rows] };
    std::iter::repeat_with(blank).take(count).collect()
}
