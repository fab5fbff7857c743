use super::domain::Bounds;
use super::problem::Evaluation;
use super::scaling::EvaluatedPoint;

/// Number of other points that are compared if f is undefined at the start; the search begins at
/// the point with the smallest f. If f is undefined at all of them, more points are tried until f
/// is defined at one, or until the limit in the options is reached.
const MIN_COMPARED_POINTS: u32 = 8;

/// Finds the first iterate: the start, or another point of the box if f is undefined at the start.
/// Returns the iterate (`None` if no point was found), and the reason why f is undefined at the
/// start. `evaluate` returns `None` once the search is interrupted; no further points are tried.
pub(super) fn first_point(
    bounds: &Bounds,
    start: &[f64],
    trials: u32,
    mut evaluate: impl FnMut(&[f64]) -> Option<Result<Evaluation, String>>,
) -> (Option<EvaluatedPoint>, Option<String>) {
    let why = match evaluate(start) {
        None => return (None, None),
        Some(Ok(f)) => {
            return (
                Some(EvaluatedPoint {
                    x: start.to_vec(),
                    f,
                }),
                None,
            );
        }
        Some(Err(why)) => why,
    };
    let mut best: Option<EvaluatedPoint> = None;
    for trial in 0..trials {
        if trial >= MIN_COMPARED_POINTS && best.is_some() {
            break;
        }
        let x = low_discrepancy_point(bounds, start, trial);
        let Some(found) = evaluate(&x) else { break };
        if let Ok(f) = found
            && best
                .as_ref()
                .is_none_or(|best| f.objective.value < best.f.objective.value)
        {
            best = Some(EvaluatedPoint { x, f });
        }
    }
    (best, Some(why))
}

/// Point `k` of a low-discrepancy sequence. Coordinate i, counted from 1, is 0.5 + k/gⁱ modulo 1,
/// with the generalized golden ratio g (Roberts 2018). The sequence covers the part of the bounds
/// that is at most one scale length from `start`; point 0 is the centre of this part. Unlike a
/// Sobol sequence, it needs no table of direction numbers, which would limit the number of
/// variables.
pub(super) fn low_discrepancy_point(bounds: &Bounds, start: &[f64], k: u32) -> Vec<f64> {
    let n = start.len();
    let scale = bounds.scale(start);
    let golden = (0..64).fold(1.5_f64, |g, _| (1.0 + g).powf(1.0 / (n as f64 + 1.0)));
    let coordinate = |i: usize| {
        let part = (0.5 + f64::from(k) * golden.powi(-(i as i32 + 1))).fract();
        let low = bounds.low[i].max(start[i] - scale[i]);
        let high = bounds.high[i].min(start[i] + scale[i]);
        low + part * (high - low)
    };
    (0..n).map(coordinate).collect()
}
