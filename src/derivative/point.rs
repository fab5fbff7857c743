use super::Taylor;
use crate::drive::{Outcome, Part, Shown};
use crate::error::{Error, Result};
use crate::flight::{Discretization, Inputs};
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

/// The variables, by their indices, that a pass differentiates by: the lanes all hold the same drive, each with directions of its own.
#[derive(Clone, Copy)]
pub(super) enum Directions<'a> {
    /// By none.
    None,
    /// By one after the other, as many in each lane as its number has directions.
    Each(&'a [usize]),
    /// By a pair in each lane, twice.
    Pairs(&'a [[usize; 2]]),
}

impl Directions<'_> {
    /// How many there are, and at least one.
    fn count(&self) -> usize {
        match self {
            Self::None => 1,
            Self::Each(indices) => indices.len(),
            Self::Pairs(pairs) => pairs.len(),
        }
    }

    /// The indices of the variables in a lane.
    #[inline(always)]
    pub fn in_lane(&self, lane: usize, per_lane: usize) -> &[usize] {
        match self {
            Self::None => &[],
            Self::Each(indices) => indices.chunks(per_lane).nth(lane).unwrap_or_default(),
            Self::Pairs(pairs) => pairs.get(lane).map_or(&[], |pair| pair),
        }
    }

    /// How many lanes have any, and at least one.
    pub fn lanes(&self, per_lane: usize) -> usize {
        match self {
            Self::None => 1,
            Self::Each(indices) => indices.len().div_ceil(per_lane).max(1),
            Self::Pairs(pairs) => pairs.len().max(1),
        }
    }

    /// Shows the index of each variable with its number to `put`: its value, in each lane the independent variable of the direction that it has there.
    #[inline(always)]
    pub fn seeded<J: Lanes>(&self, per_lane: usize, value: impl Fn(usize) -> f64, mut put: impl FnMut(usize, J)) {
        match self {
            Self::None => (),
            Self::Each(indices) => {
                for (at, &index) in indices.iter().enumerate() {
                    let (in_lane, in_direction) = (at / per_lane, at % per_lane);
                    let changes_in = inlined!(|direction: usize| {
                        if direction == in_direction { J::Mask::only(in_lane) } else { J::Mask::none() }
                    });
                    put(index, J::constant(value(index)).seeded(&changes_in, 0));
                }
            }
            // a variable in several pairs is passed once for each
            Self::Pairs(pairs) => {
                for &index in pairs.iter().flatten() {
                    let changes_in = inlined!(|direction: usize| {
                        let mut lanes = J::Mask::none();
                        for (lane, pair) in pairs.iter().enumerate() {
                            if pair[direction] == index {
                                lanes = lanes | J::Mask::only(lane);
                            }
                        }
                        lanes
                    });
                    put(index, J::constant(value(index)).seeded(&changes_in, 0));
                }
            }
        }
    }
}

impl Point<'_> {
    /// The level for these directions.
    pub fn level_of(&self, directions: Directions<'_>) -> Level {
        self.level.of(directions.count())
    }

    /// Puts the parameters of a pass into the setup over its numbers.
    #[inline(always)]
    pub fn seed<J: Lanes>(&self, setup: &mut Setup<J>, directions: Directions<'_>, per_lane: usize) {
        directions.seeded(
            per_lane,
            |index| self.x[index],
            inlined!(|index, number| setup.put(&self.wrt[index..=index], |_| number)),
        );
    }

    /// Flies a ball that leaves like this, whose drive `lanes` lanes hold, and shows each lane's outcomes to `take`, with their indices.
    #[inline(always)]
    pub fn fly<J: Lanes>(
        &self,
        setup: &Setup<J>,
        launch: &Launch<J>,
        lanes: usize,
        mut take: impl FnMut(usize, usize, J::Lane),
    ) -> Result<()> {
        let how = Discretization::of(self.setup);
        let inputs = Inputs::new(setup, launch, self.has_run);
        let ended = inputs.follow(&how, J::Mask::first(lanes), self.has_apex, &mut |_, _| ());
        // the drive is the same in all lanes
        if let Some(why) = ended.missing(&how, &inputs, 0, |number| number.lane(0).re())? {
            return Err(Error::NoFlight { reason: why.message() });
        }
        for lane in 0..lanes {
            let in_lane = inlined!(|number: J| number.lane(lane));
            let (launch, landed) = (launch.map(in_lane), ended.landed.map(in_lane));
            let shown = Shown { launch: &launch, club_speed: None, landed: Some(&landed), head: None };
            for (i, outcome) in self.of.iter().enumerate().filter(|(_, outcome)| outcome.part() == Part::Flight) {
                take(lane, i, read(*outcome, &shown)?);
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

/// An outcome of a drive as far as it is there.
pub(super) fn read<J: Number>(outcome: Outcome, drive: &Shown<'_, J>) -> Result<J> {
    outcome.shown(drive).ok_or_else(|| Error::Undefined {
        what: outcome.name().into(),
        reason: match outcome.part() {
            Part::Launch | Part::Head => "no club strikes the ball: the launch is given".into(),
            Part::Flight => "the flight was not followed for it".into(),
        },
    })
}
