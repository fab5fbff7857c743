//! The dual active-set method of Goldfarb & Idnani (1983), for small strictly convex programs: from the unconstrained
//! minimum, the most violated constraint is added again and again, and what then pulls the wrong way is dropped. It
//! needs no tolerance to tell active from inactive, and it proves infeasibility.

use super::active_set::{ActiveSet, Holder};
use super::program::{End, QuadraticProgram};
use nalgebra::{DMatrix, DVector};

/// normal · z ≥ limit.
struct Constraint {
    normal: DVector<f64>,
    limit: f64,
    is_equation: bool,
    holder: Holder,
}

/// Curvature given to the pieces' common value, which has none of its own.
const LEVEL_CURVATURE: f64 = 1e-7;
/// Constraints are held to this, in units of their normal's length.
const TOLERANCE: f64 = 1e-11;

impl QuadraticProgram {
    /// The active set by the dual method; `None` where the program is infeasible or the method does not end.
    pub(super) fn dual_active_set(&self) -> Option<ActiveSet> {
        let (hessian, slope) = self.objective();
        let constraints = self.constraints();
        let mut z = -hessian.clone().cholesky()?.solve(&slope);
        let mut active: Vec<usize> = vec![];
        let mut multipliers: Vec<f64> = vec![];
        // an equation that is missed from above is turned round
        let mut signs = vec![1.0; constraints.len()];
        let slack =
            |z: &DVector<f64>, k: usize, sign: f64| sign * (constraints[k].normal.dot(z) - constraints[k].limit);

        for _ in 0..20 * (constraints.len() + 1) {
            let reach = 1.0 + z.amax();
            let missed = |k: usize| match slack(&z, k, 1.0) {
                s if constraints[k].is_equation => -s.abs(),
                s => s,
            };
            let tolerated = |k: usize| {
                let rounding = TOLERANCE * reach * constraints[k].normal.norm().max(f64::MIN_POSITIVE);
                missed(k) >= -rounding
            };
            let candidates = (0..constraints.len()).filter(|k| !active.contains(k) && !tolerated(*k));
            let length = |k: usize| constraints[k].normal.norm().max(f64::MIN_POSITIVE);
            // equations first, then the most violated
            let worst = candidates.min_by(|&a, &b| {
                let rank = |k: usize| (!constraints[k].is_equation, missed(k) / length(k));
                rank(a).0.cmp(&rank(b).0).then(rank(a).1.total_cmp(&rank(b).1))
            });
            let Some(added) = worst else { return Some(self.held_by(active.iter().map(|&k| constraints[k].holder))) };
            if constraints[added].is_equation {
                signs[added] = if slack(&z, added, 1.0) > 0.0 { -1.0 } else { 1.0 };
            }
            let mut weight = 0.0;
            loop {
                let (along, against) = directions(&hessian, &constraints, &active, &signs, added)?;
                let curvature = along.dot(&constraints[added].normal) * signs[added];
                // as many normals as there are directions leave none
                let is_dependent = active.len() >= z.len()
                    || curvature <= 1e-12 * length(added).powi(2) / hessian.amax().max(f64::MIN_POSITIVE);
                let blocking = (0..active.len())
                    .filter(|&at| !constraints[active[at]].is_equation && against[at] > 0.0)
                    .map(|at| (multipliers[at] / against[at], at))
                    .min_by(|a, b| a.0.total_cmp(&b.0));
                let full = if is_dependent { f64::INFINITY } else { -slack(&z, added, signs[added]) / curvature };
                let partial = blocking.map_or(f64::INFINITY, |(step, _)| step);
                let step = full.min(partial);
                if !step.is_finite() {
                    return None;
                }
                for (multiplier, down) in multipliers.iter_mut().zip(against.iter()) {
                    *multiplier -= step * down;
                }
                weight += step;
                if !is_dependent {
                    z += &along * step;
                }
                if step == full {
                    active.push(added);
                    multipliers.push(weight);
                    break;
                }
                if let Some((_, at)) = blocking {
                    active.remove(at);
                    multipliers.remove(at);
                }
            }
        }
        None
    }

    /// Curvature and slope in d, and in the pieces' common value where there are several.
    fn objective(&self) -> (DMatrix<f64>, DVector<f64>) {
        let n = self.dimension();
        if self.pieces.len() == 1 {
            return (self.curvature.clone(), self.pieces[0].gradient.clone());
        }
        let mut hessian = self.curvature.clone().resize(n + 1, n + 1, 0.0);
        hessian[(n, n)] = LEVEL_CURVATURE;
        let mut slope = DVector::zeros(n + 1);
        slope[n] = 1.0;
        (hessian, slope)
    }

    fn constraints(&self) -> Vec<Constraint> {
        let (n, has_level) = (self.dimension(), self.pieces.len() > 1);
        let size = n + usize::from(has_level);
        let mut all = vec![];
        for i in 0..n {
            for (sign, limit, end) in [(1.0, self.low[i], End::Low), (-1.0, -self.high[i], End::High)] {
                let mut normal = DVector::zeros(size);
                normal[i] = sign;
                all.push(Constraint { normal, limit, is_equation: false, holder: Holder::Variable(i, end) });
            }
        }
        for (j, row) in self.rows.iter().enumerate() {
            let is_equation = row.low == row.high;
            for (sign, limit, end) in [(1.0, row.low, End::Low), (-1.0, -row.high, End::High)] {
                if limit.is_finite() && !(is_equation && end == End::High) {
                    let normal = (&row.normal * sign).resize_vertically(size, 0.0);
                    all.push(Constraint { normal, limit, is_equation, holder: Holder::Row(j, end) });
                }
            }
        }
        for (k, piece) in self.pieces.iter().enumerate().filter(|_| has_level) {
            // t − gradient · d ≥ offset
            let mut normal = (-&piece.gradient).resize_vertically(size, 0.0);
            normal[n] = 1.0;
            all.push(Constraint { normal, limit: piece.offset, is_equation: false, holder: Holder::Piece(k) });
        }
        all
    }
}

/// The way z moves, and what the active multipliers lose, for a unit of the added constraint's multiplier.
fn directions(
    hessian: &DMatrix<f64>,
    constraints: &[Constraint],
    active: &[usize],
    signs: &[f64],
    added: usize,
) -> Option<(DVector<f64>, DVector<f64>)> {
    let (n, q) = (hessian.nrows(), active.len());
    let mut matrix = DMatrix::zeros(n + q, n + q);
    matrix.view_mut((0, 0), (n, n)).copy_from(hessian);
    for (at, &k) in active.iter().enumerate() {
        let normal = &constraints[k].normal * signs[k];
        matrix.view_mut((0, n + at), (n, 1)).copy_from(&normal);
        matrix.view_mut((n + at, 0), (1, n)).copy_from(&normal.transpose());
    }
    let right = (&constraints[added].normal * signs[added]).resize_vertically(n + q, 0.0);
    let solution = matrix.lu().solve(&right)?;
    solution.iter().all(|x| x.is_finite()).then(|| (solution.rows(0, n).into_owned(), solution.rows(n, q).into_owned()))
}
