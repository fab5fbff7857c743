use super::quadrature::{Integrals, integrals};
use super::way::{Cause, Share, Way};
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::Result;
use std::collections::HashMap;

/// The derivatives of some outcomes at a place of the way, times the lengths of it; `None` where
/// not all of the outcomes have any there.
type Slopes = Option<Vec<Vec<f64>>>;

/// The shares of some outcomes along a way. A place of it is flown once, with the derivatives of
/// all outcomes.
pub(super) struct Split<'a> {
    way: &'a Way,
    of: Vec<Outcome>,
    /// With all that is changed at once as in each of the drives.
    sides: [Side; 2],
}

/// What has been flown with all that is changed at once as in one of the drives.
#[derive(Default)]
struct Side {
    evaluator: Option<Evaluator>,
    /// By the bits of the place.
    flown: HashMap<u64, Slopes>,
}

/// The shares of an outcome, and how far one may be off by the quadrature.
pub(super) struct Found {
    pub shares: Vec<Share>,
    pub error: f64,
}

impl<'a> Split<'a> {
    /// Of these outcomes, which both ends of the way have.
    pub fn new(way: &'a Way, of: Vec<Outcome>) -> Self {
        Self {
            way,
            of,
            sides: Default::default(),
        }
    }

    /// The share of each cause in the difference of one of the outcomes; `size` is that of the
    /// outcome, of which rounding is a part. An outcome has the same shares whatever the others
    /// are.
    pub fn shares(&mut self, of: Outcome, size: f64) -> Result<Found> {
        let halves: &[(usize, [f64; 2])] = if self.way.has_any_at_once() {
            &[(0, [0.0, 0.5]), (1, [0.5, 1.0])]
        } else {
            &[(0, [0.0, 1.0])]
        };
        let mut amounts = vec![0.0; self.way.numbers.len()];
        let mut error = 0.0;
        for (side, range) in halves {
            let found = self.along(*side, *range, of, size)?;
            amounts
                .iter_mut()
                .zip(&found.values)
                .for_each(|(sum, more)| *sum += more);
            error += found.error;
        }
        let numbers = self.way.numbers.iter().zip(amounts);
        let mut shares: Vec<Share> = numbers
            .map(|(parameter, amount)| Share {
                cause: Cause::Number(parameter),
                amount,
            })
            .collect();
        shares.extend(self.way.halfway(of)?);
        Ok(Found { shares, error })
    }

    /// The shares of the numbers along a part of the way, with all else as in one of the drives: ∫
    /// ∂f/∂p dp.
    fn along(&mut self, side: usize, range: [f64; 2], of: Outcome, size: f64) -> Result<Integrals> {
        if self.way.numbers.is_empty() {
            return Ok(Integrals {
                values: vec![],
                error: 0.0,
            });
        }
        integrals(range, size, |at| self.slopes(side, of, at))
    }

    fn slopes(&mut self, side: usize, of: Outcome, at: f64) -> Result<Vec<f64>> {
        let way = self.way;
        let [from, to] = [0.0, 1.0].map(|end| way.values(end));
        let evaluator =
            |of: &[Outcome]| Evaluator::new(&way.ends[side], of, &way.numbers, Order::First);
        let flown = |evaluator: &Evaluator| -> Result<Vec<Vec<f64>>> {
            let times_lengths = |slopes: &[f64]| {
                slopes
                    .iter()
                    .zip(from.iter().zip(&to))
                    .map(|(slope, (from, to))| slope * (to - from))
                    .collect()
            };
            Ok(evaluator
                .at(&way.values(at))?
                .iter()
                .map(|taylor| times_lengths(&taylor.gradient))
                .collect())
        };
        let Side {
            evaluator: of_all,
            flown: places,
        } = &mut self.sides[side];
        let of_all = match of_all {
            Some(of_all) => of_all,
            none => none.insert(evaluator(&self.of)?),
        };
        let here = places
            .entry(at.to_bits())
            .or_insert_with(|| flown(of_all).ok());
        let place = self.of.iter().position(|one| *one == of);
        match (here, place) {
            (Some(all), Some(place)) => Ok(all[place].clone()),
            // another of the outcomes does not exist here
            _ => Ok(flown(&evaluator(&[of])?)?.swap_remove(0)),
        }
    }
}
