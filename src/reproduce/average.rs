//! Mean carry over the attack angles 0, 1 … 10°, which both reproduced studies optimize.

use super::delivery::{ATTACK_ANGLE, LOFT, LoftCarry};
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::{Domain, Evaluation, Options, Status, Taylor, minimize};
use crate::parameters::Setup;
use serde::Serialize;

/// Attack angles of the mean, deg.
const AVERAGED: [f64; 11] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0];

/// Mean carry over the attack angles 0, 1 … 10°, by loft.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Average {
    /// Best loft as printed, rad.
    #[serde(skip)]
    pub printed: f64,
    /// The best loft and its average carry.
    #[serde(flatten)]
    pub best: LoftCarry,
    /// The average carry of each loft of the study.
    pub rows: Vec<LoftCarry>,
}

impl Average {
    /// Computes the mean carry of each of `lofts`, deg, and searches for the best loft within
    /// `range`, deg. The search starts at `printed_loft`, deg.
    pub(super) fn new(
        setup: &Setup<f64>,
        lofts: &[f64],
        printed_loft: f64,
        range: [f64; 2],
    ) -> Result<Self> {
        let loft = setup.variable(LOFT)?;
        let evaluators = AVERAGED.map(|degrees| {
            let mut at = *setup;
            at.set_value(setup.variable(ATTACK_ANGLE)?, Some(degrees.to_radians()))?;
            Evaluator::new(&at, &[Outcome::Carry], &[loft], Order::Second)
        });
        let evaluators = evaluators.into_iter().collect::<Result<Vec<_>>>()?;
        let average = |x: &[f64]| average(&evaluators, x);
        let rows = lofts.iter().map(|degrees| {
            let loft = degrees.to_radians();
            let carry = average(&[loft])?.value;
            Ok(LoftCarry { loft, carry })
        });
        let rows = rows.collect::<Result<_>>()?;

        let problem = |x: &[f64]| {
            let mean = average(x).map_err(|error| error.to_string())?;
            Ok(Evaluation::unconstrained(mean.negated()))
        };
        let [low, high] = range.map(f64::to_radians);
        let printed = printed_loft.to_radians();
        let found = minimize(
            &problem,
            &Domain::new(vec![low], vec![high])?,
            &[printed],
            &Options::default(),
        )?;
        match found.value {
            Some(value) if found.status == Status::Converged => Ok(Self {
                printed,
                rows,
                best: LoftCarry {
                    loft: found.x[0],
                    carry: -value,
                },
            }),
            _ => Err(Error::NotConverged {
                status: found.status.name(),
                message: found.message.into(),
            }),
        }
    }
}

/// The mean carry of the evaluators at the loft `x`, with its derivatives.
fn average(evaluators: &[Evaluator], x: &[f64]) -> Result<Taylor> {
    let carry = |evaluator: &Evaluator| Ok(evaluator.at(x)?.swap_remove(0));
    let carries = evaluators.iter().map(carry).collect::<Result<Vec<_>>>()?;
    let part = 1.0 / carries.len() as f64;
    Ok(Taylor::sum(carries.iter().map(|carry| (carry, part))))
}
