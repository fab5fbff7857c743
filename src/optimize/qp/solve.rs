use super::interior_point::{ClarabelResult, InteriorPoint};
use super::program::{Activity, QpStep, QuadraticProgram, StepSource};
use super::working_set::WorkingSet;
use serde::{Deserialize, Serialize};

/// Solves the quadratic programs of one search, each warm-started from the previous active set.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(in crate::optimize) struct QpSolver {
    /// Active set of the last solution.
    pub active_set: Option<WorkingSet>,
    #[serde(skip)]
    interior_point: InteriorPoint,
}

/// Largest relative row violation with which Clarabel's own solution is accepted.
const MOST_VIOLATION: f64 = 1e-6;

impl QpSolver {
    /// Solver for programs of `n` variables without rows. Its first warm start has no active bound.
    pub fn from_no_active_bound(n: usize) -> Self {
        let active_set = WorkingSet {
            bounds: vec![Activity::Inactive; n],
            rows: vec![],
            max_terms: vec![true],
        };
        Self {
            active_set: Some(active_set),
            ..Self::default()
        }
    }

    /// Solves a program; `None` if its rows are infeasible within the bounds.
    ///
    /// 1. Warm start: the previous active set, solved as equations. If the KKT conditions hold at
    ///    the result, it is the solution, because the program is convex.
    /// 2. Clarabel: it proves infeasibility or finds an active set, which is polished to an exact
    ///    KKT point.
    /// 3. If no exact KKT point is found near Clarabel's solution: that solution, projected on the
    ///    bounds.
    ///
    /// # Panics
    /// If there is no term of the maximum, or lengths differ.
    pub fn solve(&mut self, program: &QuadraticProgram) -> Option<QpStep> {
        let previous = self
            .active_set
            .as_ref()
            .filter(|active| active.fits(program));
        let warm = previous.and_then(|active| program.exact_step(active, StepSource::WarmStart));
        if warm.is_some() {
            return warm;
        }
        self.active_set = None;
        let ClarabelResult { active, step: own } = self.interior_point.solve(program)?;
        let active = program.consistent_working_set(active);
        let degenerate = own
            .as_ref()
            .and_then(|own| program.with_multipliers_of(&active, own));
        if let Some((active, step)) = program.polished(active, StepSource::Clarabel) {
            self.active_set = Some(active);
            return Some(step);
        }
        let is_feasible = |own: &QpStep| {
            program.violation(&own.d)
                <= MOST_VIOLATION * (program.largest_bound().min(1.0) + own.d.amax())
        };
        degenerate.or(own.filter(is_feasible))
    }
}
