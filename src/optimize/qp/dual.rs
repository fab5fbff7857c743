//! The dual active-set method of Goldfarb & Idnani (1983), for strictly convex programs: from the unconstrained minimum, the
//! most violated constraint is added again and again, and what then pulls the wrong way is dropped. It needs no tolerance to
//! tell active from inactive, and it proves infeasibility. The factors of what is active are updated by plane rotations, so
//! that a change of the active set costs the square of the number of variables.

use super::active_set::{ActiveConstraint, ActiveSet};
use super::polish::Candidate;
use super::program::{End, QuadraticProgram};
use super::walk::{Constraints, Held, Walk, dot};
use crate::optimize::cholesky::factorise;
use nalgebra::{DMatrix, DVector};

/// What the method says of a program.
pub(super) enum Dual {
    /// What holds the minimum; and that itself, where the method's own factors give it exactly.
    Active(ActiveSet, Option<Candidate>),
    /// The rows cannot be met within the ends.
    Infeasible,
    /// It cannot begin, or did not end.
    Undecided,
}

/// Curvature given to the pieces' common value, which has none of its own.
const LEVEL_CURVATURE: f64 = 1e-7;

impl QuadraticProgram {
    /// The active set by the dual method. A program without curvature is undecided: there is no unconstrained minimum to begin at.
    pub(super) fn dual_active_set(&self) -> Dual {
        let all = self.constraints();
        let Some((factors, slope)) = self.objective() else { return Dual::Undecided };
        let Some(mut walk) = Walk::from_minimum(&all, &factors, &slope) else { return Dual::Undecided };
        for _ in 0..40 * (all.limits.len() + 1) {
            let Some((added, sign)) = walk.most_violated() else {
                let active = self.held_by(walk.active.iter().map(|held| self.holder(held)));
                let is_smooth = self.pieces.len() == 1;
                return Dual::Active(active, if is_smooth { walk.refined(&self.curvature, &slope) } else { None });
            };
            if !walk.hold(added, sign) {
                return Dual::Infeasible;
            }
        }
        Dual::Undecided
    }

    /// The factors of the curvature, if there is any, and the slope in d, and in the pieces' common value where there are several.
    fn objective(&self) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let n = self.dimension();
        if !self.curvature.amax().is_normal() {
            return None;
        }
        let (mut hessian, slope) = if self.pieces.len() == 1 {
            (self.curvature.clone(), self.pieces[0].gradient.clone())
        } else {
            let mut hessian = self.curvature.clone().resize(n + 1, n + 1, 0.0);
            hessian[(n, n)] = LEVEL_CURVATURE;
            (hessian, DVector::from_fn(n + 1, |i, _| f64::from(i == n)))
        };
        factorise(&mut hessian).then_some((hessian, slope))
    }

    /// The limits of the variables, then of the rows, then of the pieces where there are several.
    fn constraints(&self) -> Constraints {
        let (n, has_level) = (self.dimension(), self.pieces.len() > 1);
        let size = n + usize::from(has_level);
        let pieces = if has_level { &self.pieces[..] } else { &[] };
        let mut dense = Vec::with_capacity(size * (self.rows.len() + pieces.len()));
        let mut limits: Vec<_> = self.low.iter().copied().zip(self.high.iter().copied()).collect();
        for row in &self.rows {
            dense.extend_from_slice(row.normal.as_slice());
            dense.extend(has_level.then_some(0.0));
            limits.push((row.low, row.high));
        }
        for piece in pieces {
            // t − gradient · d ≥ offset
            dense.extend(piece.gradient.iter().map(|slope| -slope));
            dense.push(1.0);
            limits.push((piece.offset, f64::INFINITY));
        }
        let length = |normal: &[f64]| dot(normal, normal).sqrt().max(f64::MIN_POSITIVE);
        let lengths = std::iter::repeat_n(1.0, n).chain(dense.chunks_exact(size).map(length)).collect();
        Constraints { size, variables: n, dense, limits, lengths }
    }

    fn holder(&self, held: &Held) -> ActiveConstraint {
        let (n, rows) = (self.dimension(), self.rows.len());
        let end = if held.sign > 0.0 { End::Low } else { End::High };
        match held.constraint {
            i if i < n => ActiveConstraint::Variable(i, end),
            j if j < n + rows => ActiveConstraint::Row(j - n, end),
            k => ActiveConstraint::Piece(k - n - rows),
        }
    }
}
