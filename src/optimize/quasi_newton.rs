use super::scaling::{Point, Scaling};
use nalgebra::{DMatrix, DVector};

/// The search's own Hessian of the Lagrangian, in scaled variables, after a step: the damped BFGS update (Powell 1978;
/// Nocedal & Wright 2006, procedure 18.2). It stays positive definite.
pub(super) fn updated(
    before: &DMatrix<f64>,
    scaling: &Scaling,
    from: &Point,
    to: &Point,
    multipliers: &[f64],
    is_first: bool,
) -> DMatrix<f64> {
    let n = from.x.len();
    let (start, end) = (from.lagrangian_gradient(multipliers), to.lagrangian_gradient(multipliers));
    let step = DVector::from_fn(n, |i, _| (to.x[i] - from.x[i]) / scaling.scale[i]);
    let change = DVector::from_fn(n, |i, _| (end[i] - start[i]) * scaling.scale[i]);
    let curvature = step.dot(&change);
    if step.norm() == 0.0 {
        return before.clone();
    }
    let first = change.norm_squared() / curvature;
    let before = if is_first && curvature > 0.0 && first.is_finite() {
        // the size that the first step saw (ibid., eq. 6.20)
        DMatrix::identity(n, n) * first
    } else {
        before.clone()
    };
    let carried = &before * &step;
    let expected = step.dot(&carried);
    let damping = if curvature >= 0.2 * expected { 1.0 } else { 0.8 * expected / (expected - curvature) };
    let change = change * damping + &carried * (1.0 - damping);
    let updated =
        &before - &carried * carried.transpose() / expected + &change * change.transpose() / step.dot(&change);
    if updated.iter().all(|x| x.is_finite()) { updated } else { before }
}

/// The Hessian to begin with: f changes by its slope over the whole scale.
pub(super) fn initial(scaling: &Scaling, at: &Point) -> DMatrix<f64> {
    let n = at.x.len();
    let slope = scaling.largest(at.f.objective.gradient.iter().copied()).max(f64::MIN_POSITIVE);
    DMatrix::identity(n, n) * slope
}
