use super::agreement::{Agreement, by_num_dual};
use super::scale::{scale, size};
use crate::aerodynamics::AerodynamicLaw;
use crate::derivative::check::{Check, Demand, FEW_STEPS, Ladder, STEPS, Verdict, taylor_slopes};
use crate::derivative::{Evaluator, Order, Taylor, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};

/// Derivatives of an outcome by a parameter, compared with differences.
#[derive(Clone, Debug)]
pub struct Row {
    /// The outcome.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Samples of the outcome.
    pub ladder: Ladder,
    /// ∂/∂p compared with differences of values.
    pub first: Check,
    /// ∂/∂p compared with num-dual.
    pub num_dual: Agreement,
    /// ∂²/∂p² compared with differences of ∂/∂p; `None` if it does not exist or is discontinuous.
    pub second: Option<Check>,
    /// Orders of the Taylor remainders: at least 1, 2 and 3.
    pub slopes: [Option<f64>; 3],
}

impl Row {
    /// Verdict on both derivatives. A discontinuous second derivative is not a corner of the
    /// outcome.
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

    /// True if num-dual shows that the derivative is wrong. At a corner both methods may return
    /// either one-sided slope.
    pub fn num_dual_fails(&self) -> bool {
        self.first.verdict != Verdict::Corner && !self.num_dual.holds()
    }

    /// True if differences of gradients show that the second derivative is wrong.
    pub fn second_fails(&self) -> bool {
        self.second.as_ref().is_some_and(Check::failed)
    }

    /// Error divided by tolerance: above 1 the derivative is wrong.
    pub fn severity(&self) -> f64 {
        let bars = |error: f64, bar: f64| if error == 0.0 { 0.0 } else { error / bar };
        let of = |check: &Check| bars(check.error, check.bar);
        let of_second = self.second.as_ref().map_or(0.0, of);
        of(&self.first)
            .max(of_second)
            .max(bars(self.num_dual.difference, self.num_dual.tolerance))
    }
}

/// Required accuracy of differences of outcomes. Extrapolation does not cancel all errors if third
/// derivatives jump where stages cross joins of the law, or if the last steps end at different
/// heights in a logarithmic wind. In these cases the required accuracy is a tenth of the detectable
/// error.
pub(super) fn demand(setup: &Setup<f64>) -> Demand {
    let is_rough = setup.wind.roughness.is_some() || setup.law.continuous_derivatives().is_some();
    if is_rough {
        Demand {
            least_bar: 1e-7,
            ..Demand::FIRST
        }
    } else {
        Demand::FIRST
    }
}

/// The rows of several outcomes by one parameter; `None` once `is_stopped` is true. `exact` are the
/// derivatives to certify, from the original evaluation.
///
/// # Errors
/// The errors of [`Evaluator::new`]. A neighbouring drive without an outcome gives no sample.
pub(super) fn rows(
    setup: &Setup<f64>,
    drive: &Drive<f64>,
    of: &[Outcome],
    parameter: &'static Parameter,
    exact: &[f64],
    is_stopped: &dyn Fn() -> bool,
) -> Result<Option<Vec<Row>>> {
    let (has_corners, is_without_spin) =
        (!drive.corners(setup).is_empty(), drive.is_without_spin());
    let judge = |of: Outcome, ladder: &Ladder, exact: f64| {
        let is_on_a_corner = has_corners || of == Outcome::Spin && is_without_spin;
        let judge = if is_on_a_corner {
            Ladder::judge_on_a_corner
        } else {
            Ladder::judge
        };
        judge(ladder, exact, demand(setup))
    };
    let (at, scale) = (
        setup.value(parameter).unwrap_or_default(),
        scale(setup, parameter),
    );
    let evaluator = |order| Evaluator::new(setup, of, &[parameter], order);
    let (values, gradients) = (evaluator(Order::Value)?, evaluator(Order::First)?);
    let curvatures = evaluate(setup, of, &[parameter], Order::Second).ok();
    let own: Vec<f64> = of
        .iter()
        .map(|of| of.value(drive).unwrap_or_default())
        .collect();
    let sample = |evaluator: &Evaluator, x: f64, f: &dyn Fn(usize, &Taylor) -> f64| {
        if is_stopped() {
            return vec![];
        }
        evaluator.at(&[x]).map_or(vec![f64::NAN; of.len()], |all| {
            all.iter()
                .enumerate()
                .map(|(i, taylor)| f(i, taylor))
                .collect()
        })
    };
    let unwrapped = |i: usize, taylor: &Taylor| of[i].unwrap_angle(taylor.value, own[i]);
    let of_values = Ladder::sample(at, scale, STEPS, &mut |x| sample(&values, x, &unwrapped));
    let of_values: Vec<Ladder> = of_values
        .into_iter()
        .zip(of)
        .map(|(ladder, of)| ladder.rounded_as(size(*of, setup, drive)))
        .collect();
    let curvature = |i: usize| curvatures.as_ref().map(|taylors| taylors[i].hessian[0][0]);
    let seconds = in_few_steps(
        |steps| {
            Ladder::sample(at, scale, steps, &mut |x| {
                sample(&gradients, x, &|_, taylor| taylor.gradient[0])
            })
        },
        |(i, gradients)| {
            let (size, rounded) = (of_values[i].size / scale, of_values[i].rounded / scale);
            curvature(i).map(|d| {
                gradients
                    .made_of(size)
                    .rounded_as(rounded)
                    .judge(d, Demand::SECOND)
            })
        },
        |second| second.as_ref().is_some_and(Check::failed),
    );
    if is_stopped() {
        return Ok(None);
    }
    let over_num_dual = by_num_dual(setup, of, parameter)?;
    let row = |(i, (ladder, second)): (usize, (Ladder, Option<Check>))| Row {
        of: of[i],
        parameter,
        first: judge(of[i], &ladder, exact[i]),
        num_dual: Agreement::new(exact[i], over_num_dual[i], &ladder),
        second,
        slopes: taylor_slopes(&ladder, exact[i], curvature(i).unwrap_or_default()),
        ladder,
    };
    Ok(Some(
        of_values
            .iter()
            .cloned()
            .zip(seconds)
            .enumerate()
            .map(row)
            .collect(),
    ))
}

/// Compares with few steps first. If a comparison fails, it is repeated with all steps, because the
/// outcome may have an extremum within the smallest of the few steps.
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
    let few = by(FEW_STEPS.to_vec());
    if few.iter().any(fails) {
        by(STEPS.collect())
    } else {
        few
    }
}
