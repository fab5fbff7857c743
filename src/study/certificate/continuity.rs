use super::scale::{scale, size_of_terms};
use crate::derivative::check::Verdict;
use crate::derivative::{Order, Taylor, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::flight::Flight;
use crate::parameters::{Parameter, Setup};
use serde::Serialize;

/// Largest change of the parameter in the search for another number of time steps, in units of the
/// parameter's scale.
const FARTHEST: f64 = 0.1;

/// The search begins at the change `FARTHEST` / 2^`DOUBLED`, and doubles the change.
const DOUBLED: i32 = 9;

/// Number of samples on each side of the change of the number of time steps. The scatter of the
/// samples is a measure of the rounding.
const NEIGHBOURS: usize = 8;

/// Distance between neighbouring samples, in units of the parameter's scale. Adjacent
/// floating-point numbers would be too close: they may give the same outcome. For example, the spin
/// decay e^(−δ h) in a time step h is rounded to 1e-16, so an outcome is a step function of δ.
/// [`sample`] extrapolates the outcome back over the distance.
const SPACING: f64 = 1e-12;

/// Tolerance of a jump, in multiples of the scatter of the samples.
const SCATTER_FACTOR: f64 = 4.0;

/// Smallest relative tolerances of the jumps of value, gradient and Hessian. The scatter of so few
/// samples may be smaller than the rounding.
const LEAST_TOLERANCE: [f64; 3] = [1e-13, 1e-12, 1e-10];

/// An outcome at a parameter value where the number of time steps changes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ContinuityCheck"))]
pub struct Continuity {
    /// The outcome.
    pub of: Outcome,
    /// The parameter that varies.
    pub parameter: &'static Parameter,
    /// Value of the parameter just before the number of time steps changes, SI.
    pub at: f64,
    /// Number of time steps before and after the change.
    pub steps: [usize; 2],
    /// Jumps of value, gradient and Hessian with respect to scaled parameters. Each jump is divided
    /// by the largest entry of the value, gradient or Hessian, or by the magnitude of the outcome's
    /// terms if that is larger.
    pub jumps: [f64; 3],
    /// Tolerances of the jumps of value, gradient and Hessian: 1e-13, 1e-12 and 1e-10, or more if
    /// rounding makes the samples scatter more.
    pub tolerances: [f64; 3],
    /// `pass` or `fail`.
    pub verdict: Verdict,
}

/// Varies `wrt[0]` until the number of time steps changes, and measures there the jumps of the
/// outcomes and of their derivatives by `wrt`. Empty if the number of time steps does not change up
/// to [`FARTHEST`], or if `goes_on` returns false.
///
/// # Errors
/// The errors of [`evaluate`].
pub(super) fn continuity(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<Continuity>> {
    let Some(&parameter) = wrt.first() else {
        return Ok(vec![]);
    };
    let Some([low, high]) = change(setup, parameter, goes_on) else {
        return Ok(vec![]);
    };
    let spacing = SPACING * scale(setup, parameter);
    let neighbours = |from: f64, sign: f64| {
        let offsets = (0..NEIGHBOURS).map(|k| sign * spacing * k as f64);
        offsets
            .filter(|offset| parameter.range.contains(from + offset))
            .take_while(|_| goes_on())
            .map(|offset| sample(setup, of, wrt, from, offset))
            .collect::<Result<Vec<Vec<Taylor>>>>()
    };
    let (before, after) = (neighbours(low, -1.0)?, neighbours(high, 1.0)?);
    if !goes_on() {
        return Ok(vec![]);
    }
    let steps = [low, high].map(|value| steps(setup, parameter, value).unwrap_or_default());
    let scales: Vec<f64> = wrt
        .iter()
        .map(|parameter| scale(setup, parameter))
        .collect();
    let drive = Drive::new(setup)?;
    let continuity = |(i, of): (usize, &Outcome)| {
        let size = size_of_terms(*of, setup, &drive);
        let pairs = [0, 1, 2].map(|order| {
            let [before, after] = [&before, &after].map(|side| {
                side.iter()
                    .map(|taylors| entries(&taylors[i], &scales, order))
                    .collect::<Vec<_>>()
            });
            jump(&before, &after, size, LEAST_TOLERANCE[order])
        });
        Continuity {
            of: *of,
            parameter,
            at: low,
            steps,
            jumps: pairs.map(|(jump, _)| jump),
            tolerances: pairs.map(|(_, tolerance)| tolerance),
            verdict: Verdict::of(pairs.iter().all(|(jump, bar)| jump <= bar)),
        }
    };
    Ok(of.iter().enumerate().map(continuity).collect())
}

/// The outcomes with `wrt[0]` at `from + offset`, extrapolated to `from`. The gradient extrapolates
/// the value, and the Hessian extrapolates the gradient.
fn sample(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    from: f64,
    offset: f64,
) -> Result<Vec<Taylor>> {
    let value = from + offset;
    let at = setup.with_values(&wrt[..1], &[value])?;
    let offset = value - from;
    let mut taylors = evaluate(&at, of, wrt, Order::Second)?;
    for taylor in &mut taylors {
        taylor.value -= taylor.gradient[0] * offset;
        for (slope, row) in taylor.gradient.iter_mut().zip(&taylor.hessian) {
            *slope -= row[0] * offset;
        }
    }
    Ok(taylors)
}

/// The value (`order` 0), the entries of the gradient (1) or the entries of the Hessian (2), by
/// scaled parameters.
fn entries(taylor: &Taylor, scales: &[f64], order: usize) -> Vec<f64> {
    match order {
        0 => vec![taylor.value],
        1 => taylor
            .gradient
            .iter()
            .zip(scales)
            .map(|(d, scale)| d * scale)
            .collect(),
        _ => {
            let row = |(row, scale): (&Vec<f64>, &f64)| -> Vec<f64> {
                row.iter()
                    .zip(scales)
                    .map(|(d, other)| d * scale * other)
                    .collect()
            };
            taylor.hessian.iter().zip(scales).flat_map(row).collect()
        }
    }
}

/// The largest difference between the means of `before` and `after`, and its tolerance, which
/// follows from the scatter of the samples. Both are divided by the largest entry, or by `size`
/// (the magnitude of the outcome's terms) if that is larger.
fn jump(before: &[Vec<f64>], after: &[Vec<f64>], size: f64, least_tolerance: f64) -> (f64, f64) {
    let (mut jump, mut scatter, mut size) = (0.0_f64, 0.0_f64, size);
    for entry in 0..before[0].len() {
        let [a, b] = [before, after].map(|side| {
            let values = side.iter().map(|one| one[entry]);
            let mean = values.clone().sum::<f64>() / side.len() as f64;
            (
                mean,
                values.fold(0.0_f64, |most, value| most.max((value - mean).abs())),
            )
        });
        jump = jump.max((a.0 - b.0).abs());
        scatter = scatter.max(a.1).max(b.1);
        size = size.max(a.0.abs());
    }
    if size == 0.0 {
        (jump, 0.0)
    } else {
        (
            jump / size,
            least_tolerance.max(SCATTER_FACTOR * scatter / size),
        )
    }
}

fn steps(setup: &Setup<f64>, parameter: &'static Parameter, value: f64) -> Option<usize> {
    match Drive::new(&setup.with_values(&[parameter], &[value]).ok()?)
        .ok()?
        .flight
    {
        Flight::Landed(landed) => Some(landed.steps),
        Flight::None(_) => None,
    }
}

/// Finds two adjacent floating-point values of the parameter, in ascending order, that give
/// different numbers of time steps. Of all such pairs, it is the nearest to the setup's value.
/// `None` if the number does not change up to [`FARTHEST`], or once `goes_on` returns false.
fn change(
    setup: &Setup<f64>,
    parameter: &'static Parameter,
    goes_on: &dyn Fn() -> bool,
) -> Option<[f64; 2]> {
    let at = setup.value(parameter)?;
    let here = steps(setup, parameter, at)?;
    let between = |mut same: f64, mut other: f64| loop {
        let middle = same + 0.5 * (other - same);
        if middle == same || middle == other {
            return Some([same, other]);
        }
        if steps(setup, parameter, middle)? == here {
            same = middle
        } else {
            other = middle
        }
    };
    let mut distance = FARTHEST * scale(setup, parameter) / 2.0_f64.powi(DOUBLED);
    let mut to_each_side = [at; 2];
    for _ in (0..=DOUBLED).take_while(|_| goes_on()) {
        let mut found = vec![];
        for (same, sign) in to_each_side.iter_mut().zip([1.0, -1.0]) {
            let other = at + sign * distance;
            match steps(setup, parameter, other) {
                Some(there) if there == here => *same = other,
                Some(_) => found.extend(between(*same, other)),
                None => {}
            }
        }
        let nearest = found
            .into_iter()
            .min_by(|a, b| (a[0] - at).abs().total_cmp(&(b[0] - at).abs()));
        if let Some([same, other]) = nearest {
            return Some([same.min(other), same.max(other)]);
        }
        distance *= 2.0;
    }
    None
}
