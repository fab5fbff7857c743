use super::agreement::{Agreement, by_num_dual};
use super::scale::{scale, size_of_terms};
use crate::aerodynamics::AerodynamicLaw;
use crate::derivative::check::{
    Check, Demand, FEW_STEP_EXPONENTS, Ladder, STEP_EXPONENTS, Verdict, taylor_slopes,
};
use crate::derivative::{Evaluator, Order, Taylor, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};

/// Derivatives of an outcome by a parameter, checked by differences and by num-dual.
#[derive(Clone, Debug)]
pub struct DerivativeRow {
    /// The outcome.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Samples of the outcome at several step sizes.
    pub ladder: Ladder,
    /// ∂/∂p compared with differences of values.
    pub first: Check,
    /// ∂/∂p compared with num-dual.
    pub num_dual: Agreement,
    /// ∂²/∂p² compared with differences of ∂/∂p; `None` if it does not exist or is discontinuous.
    pub second: Option<Check>,
    /// Orders of the Taylor remainders of degree 0, 1 and 2. With exact derivatives they are at
    /// least 1, 2 and 3. `None` if too few remainders exceed rounding.
    pub slopes: [Option<f64>; 3],
}

impl DerivativeRow {
    /// Verdict on the row: the verdict on the first derivative, or `Fail` if num-dual or the second
    /// derivative fails. A corner of the second derivative does not count.
    pub fn verdict(&self) -> Verdict {
        if self.num_dual_fails() {
            return Verdict::Fail;
        }
        if self.first.verdict == Verdict::Pass && self.second_fails() {
            Verdict::Fail
        } else {
            self.first.verdict
        }
    }

    /// True if num-dual shows that the derivative is wrong. False at a corner, where each method
    /// may return either one-sided slope.
    pub fn num_dual_fails(&self) -> bool {
        self.first.verdict != Verdict::Corner && self.num_dual.verdict == Verdict::Fail
    }

    /// True if differences of gradients show that the second derivative is wrong.
    pub fn second_fails(&self) -> bool {
        self.second.as_ref().is_some_and(Check::failed)
    }

    /// Largest ratio of an error to its tolerance, over the comparisons of the row. If the ratio is
    /// above 1, a derivative is wrong.
    pub fn severity(&self) -> f64 {
        let ratio = |error: f64, tolerance: f64| {
            if error == 0.0 { 0.0 } else { error / tolerance }
        };
        let of = |check: &Check| ratio(check.error, check.tolerance);
        let of_second = self.second.as_ref().map_or(0.0, of);
        of(&self.first)
            .max(of_second)
            .max(ratio(self.num_dual.difference, self.num_dual.tolerance))
    }
}

/// Required accuracy of differences of outcomes, which must detect a relative error of 1e-6.
/// Extrapolation leaves larger errors in two cases: with a law with joins (third derivatives jump),
/// and in a logarithmic wind (the last steps end at different heights). The smallest tolerance is
/// then 1e-7.
pub(super) fn demand(setup: &Setup<f64>) -> Demand {
    let is_rough =
        setup.wind.roughness.is_some() || setup.law.properties().continuous_derivatives.is_some();
    if is_rough {
        Demand {
            least_tolerance: 1e-7,
            ..Demand::FIRST
        }
    } else {
        Demand::FIRST
    }
}

/// The rows for the derivatives of several outcomes by one parameter; `None` once `is_stopped` is
/// true. `exact` are the derivatives to certify, from the original evaluation.
///
/// # Errors
/// The errors of [`Evaluator::new`]. A neighbouring drive that lacks an outcome is no error, but
/// gives no sample.
pub(super) fn rows(
    setup: &Setup<f64>,
    drive: &Drive<f64>,
    of: &[Outcome],
    parameter: &'static Parameter,
    exact: &[f64],
    is_stopped: &dyn Fn() -> bool,
) -> Result<Option<Vec<DerivativeRow>>> {
    let neighbours = Neighbours {
        setup,
        drive,
        of,
        at: setup.value(parameter).unwrap_or_default(),
        scale: scale(setup, parameter),
        values: Evaluator::new(setup, of, &[parameter], Order::Value)?,
        gradients: Evaluator::new(setup, of, &[parameter], Order::First)?,
        has_corners: !drive.corners(setup).is_empty(),
        is_stopped,
    };
    let curvatures: Option<Vec<f64>> = evaluate(setup, of, &[parameter], Order::Second)
        .ok()
        .map(|taylors| taylors.iter().map(|taylor| taylor.hessian[0][0]).collect());
    let values = neighbours.value_ladders();
    let seconds = neighbours.second_checks(curvatures.as_deref(), &values);
    if is_stopped() {
        return Ok(None);
    }
    let over_num_dual = by_num_dual(setup, of, parameter)?;
    let row = |(i, (ladder, second)): (usize, (Ladder, Option<Check>))| DerivativeRow {
        of: of[i],
        parameter,
        first: neighbours.first_check(of[i], &ladder, exact[i]),
        num_dual: Agreement::new(exact[i], over_num_dual[i], &ladder),
        second,
        slopes: taylor_slopes(
            &ladder,
            exact[i],
            curvatures.as_ref().map_or(0.0, |curvatures| curvatures[i]),
        ),
        ladder,
    };
    let ladders = values.into_iter().zip(seconds);
    Ok(Some(ladders.enumerate().map(row).collect()))
}

/// Neighbouring drives, which differ in one parameter.
struct Neighbours<'a> {
    setup: &'a Setup<f64>,
    drive: &'a Drive<f64>,
    of: &'a [Outcome],
    /// Value of the parameter.
    at: f64,
    /// Characteristic size of the parameter.
    scale: f64,
    values: Evaluator,
    gradients: Evaluator,
    /// True if the drive lies on a non-differentiable point.
    has_corners: bool,
    is_stopped: &'a dyn Fn() -> bool,
}

impl Neighbours<'_> {
    /// Applies `number` to the Taylor expansion of each outcome at the parameter value `x`. All
    /// numbers are NaN if the drive lacks an outcome. The result is empty once `is_stopped` returns
    /// true.
    fn sample(
        &self,
        evaluator: &Evaluator,
        x: f64,
        number: impl Fn(usize, &Taylor) -> f64,
    ) -> Vec<f64> {
        if (self.is_stopped)() {
            return vec![];
        }
        let Ok(taylors) = evaluator.at(&[x]) else {
            return vec![f64::NAN; self.of.len()];
        };
        let taylors = taylors.iter().enumerate();
        taylors.map(|(i, taylor)| number(i, taylor)).collect()
    }

    /// Samples of the values of all outcomes.
    fn value_ladders(&self) -> Vec<Ladder> {
        let own: Vec<f64> = self
            .of
            .iter()
            .map(|of| of.value(self.drive).unwrap_or_default())
            .collect();
        let ladders = Ladder::sample(self.at, self.scale, STEP_EXPONENTS, &mut |x| {
            self.sample(&self.values, x, |i, taylor| {
                self.of[i].unwrap_angle(taylor.value, own[i])
            })
        });
        ladders
            .into_iter()
            .zip(self.of)
            .map(|(ladder, of)| {
                ladder.with_rounding_size(size_of_terms(*of, self.setup, self.drive))
            })
            .collect()
    }

    /// Compares a first derivative with differences of values.
    fn first_check(&self, of: Outcome, values: &Ladder, exact: f64) -> Check {
        let is_at_zero_spin = of == Outcome::Spin && self.drive.is_without_spin();
        let judge = if self.has_corners || is_at_zero_spin {
            Ladder::judge_on_a_corner
        } else {
            Ladder::judge
        };
        judge(values, exact, demand(self.setup))
    }

    /// Compares the second derivatives with differences of gradients; `None` without second
    /// derivatives.
    fn second_checks(&self, curvatures: Option<&[f64]>, values: &[Ladder]) -> Vec<Option<Check>> {
        let sample = |steps| {
            Ladder::sample(self.at, self.scale, steps, &mut |x| {
                self.sample(&self.gradients, x, |_, taylor| taylor.gradient[0])
            })
        };
        let judge = |(i, gradients): (usize, Ladder)| {
            let curvature = curvatures?[i];
            let gradients = gradients
                .with_least_size(values[i].size / self.scale)
                .with_rounding_size(values[i].rounding_size / self.scale);
            Some(gradients.judge(curvature, Demand::SECOND))
        };
        let fails = |second: &Option<Check>| second.as_ref().is_some_and(Check::failed);
        in_few_steps(sample, judge, fails)
    }
}

/// Compares with differences over a few step sizes. If a comparison fails, repeats all comparisons
/// with all step sizes: the outcome may have an extremum within the smallest of the few steps.
pub(super) fn in_few_steps<T>(
    sample: impl Fn(Vec<i32>) -> Vec<Ladder>,
    judge: impl Fn((usize, Ladder)) -> T,
    fails: impl Fn(&T) -> bool,
) -> Vec<T> {
    let by = |steps: Vec<i32>| {
        sample(steps)
            .into_iter()
            .enumerate()
            .map(&judge)
            .collect::<Vec<T>>()
    };
    let few = by(FEW_STEP_EXPONENTS.to_vec());
    if few.iter().any(fails) {
        by(STEP_EXPONENTS.collect())
    } else {
        few
    }
}
