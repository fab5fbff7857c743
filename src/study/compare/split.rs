use super::path::{Cause, SetupPath, Share, Shares};
use super::quadrature::integrals;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::Result;
use std::collections::HashMap;

/// Relative rounding error of a share, which is a sum of derivatives.
const OF_SHARES: f64 = 1e-11;

/// Shares of several outcomes along a path. One drive at each point gives the derivatives of all
/// outcomes.
pub(super) struct DifferenceSplit<'a> {
    path: &'a SetupPath,
    of: Vec<Outcome>,
    /// First with the discrete parameters of drive a, then with those of drive b.
    evaluators: [Option<Evaluator>; 2],
    /// The derivatives of the outcomes, times the parameter differences, at each flown position on
    /// the path; `None` if one of the outcomes does not exist there. The key is the index in
    /// `evaluators` and the position, as bits.
    flown: HashMap<(usize, u64), Option<Vec<Vec<f64>>>>,
}

impl<'a> DifferenceSplit<'a> {
    /// Splits differences of the outcomes `of`, which the drives at both ends of the path have.
    pub fn new(path: &'a SetupPath, of: Vec<Outcome>) -> Self {
        Self {
            path,
            of,
            evaluators: [None, None],
            flown: HashMap::new(),
        }
    }

    /// Share of each cause in the difference `amount` of the outcome `of`. The rounding error is
    /// relative to `size`, the outcome's magnitude. The shares are independent of the other
    /// outcomes of the split.
    pub fn shares(&mut self, of: Outcome, amount: f64, size: f64) -> Result<Shares> {
        let path = self.path;
        let halves: &[(usize, [f64; 2])] = match (path.continuous.is_empty(), path.discrete.len()) {
            (true, _) => &[],
            (false, 0) => &[(0, [0.0, 1.0])],
            (false, _) => &[(0, [0.0, 0.5]), (1, [0.5, 1.0])],
        };
        let mut amounts = vec![0.0; self.path.continuous.len()];
        let mut error = 0.0;
        for (side, range) in halves {
            // ∫ ∂f/∂p dp over the range in which the discrete parameters are those of one end
            let found = integrals(*range, size, |at| self.slopes(*side, of, at))?;
            amounts
                .iter_mut()
                .zip(&found.values)
                .for_each(|(sum, more)| *sum += more);
            error += found.error;
        }
        let continuous = self.path.continuous.iter().zip(amounts);
        let mut shares: Vec<Share> = continuous
            .map(|(parameter, amount)| self.path.share(Cause::Continuous(parameter), amount))
            .collect();
        shares.extend(self.path.halfway(of)?);
        let sum: f64 = shares.iter().map(|share| share.amount).sum();
        Ok(Shares {
            shares,
            remainder: amount - sum,
            error: error + OF_SHARES * size,
        })
    }

    fn slopes(&mut self, side: usize, of: Outcome, at: f64) -> Result<Vec<f64>> {
        let path = self.path;
        let [from, to] = [0.0, 1.0].map(|end| path.values(end));
        let evaluator =
            |of: &[Outcome]| Evaluator::new(&path.ends[side], of, &path.continuous, Order::First);
        let flown = |evaluator: &Evaluator| -> Result<Vec<Vec<f64>>> {
            let times_lengths = |slopes: &[f64]| {
                slopes
                    .iter()
                    .zip(from.iter().zip(&to))
                    .map(|(slope, (from, to))| slope * (to - from))
                    .collect()
            };
            Ok(evaluator
                .at(&path.values(at))?
                .iter()
                .map(|taylor| times_lengths(&taylor.gradient))
                .collect())
        };
        let of_all = match &mut self.evaluators[side] {
            Some(of_all) => of_all,
            none => none.insert(evaluator(&self.of)?),
        };
        let here = self
            .flown
            .entry((side, at.to_bits()))
            .or_insert_with(|| flown(of_all).ok());
        let place = self.of.iter().position(|one| *one == of);
        match (here, place) {
            (Some(all), Some(place)) => Ok(all[place].clone()),
            // another outcome does not exist at this point: evaluate `of` alone
            _ => Ok(flown(&evaluator(&[of])?)?.swap_remove(0)),
        }
    }
}
