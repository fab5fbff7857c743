use super::active_set::ActiveSet;
use super::interior_point::{Answer, InteriorPoint};
use super::program::{QuadraticProgram, Side, Step, StepSource};
use serde::{Deserialize, Serialize};

/// Solves the quadratic programs of one search, each from what is known of the one before.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(in crate::optimize) struct QpSolver {
    /// The active set of the last solution.
    pub active_set: Option<ActiveSet>,
    #[serde(skip)]
    interior_point: InteriorPoint,
}

/// A violation of a row, relative to the step, up to which Clarabel's own solution is a step.
const MOST_VIOLATION: f64 = 1e-6;

impl QpSolver {
    /// A solver whose first program begins, of `n` variables and no rows, where no bound is active.
    pub fn from_no_active_bound(n: usize) -> Self {
        let active_set = ActiveSet {
            bounds: vec![Side::Inactive; n],
            rows: vec![],
            max_terms: vec![true],
        };
        Self {
            active_set: Some(active_set),
            ..Self::default()
        }
    }

    /// Solves a program; `None` where its rows cannot be met within the bounds.
    ///
    /// 1. Warm start: the active set of the program before, solved as equations. Where the KKT
    ///    conditions hold at the result, it is the solution (the program is convex).
    /// 2. Clarabel: it proves infeasibility, or finds an active set, which is polished to an exact
    ///    KKT point.
    /// 3. Where no active set near Clarabel's is exact, its own solution, moved inside the bounds.
    ///
    /// # Panics
    /// Where there is no term of the maximum, or lengths differ.
    pub fn solve(&mut self, program: &QuadraticProgram) -> Option<Step> {
        if let Some(step) = self.warm_start(program) {
            return Some(step);
        }
        self.active_set = None;
        let (ranked, own) = match self.interior_point.solve(program) {
            Some(Answer::Found(ranked, own)) => (ranked, own),
            Some(Answer::Infeasible) | None => return None,
        };
        let active = program.consistent_part(ranked);
        let degenerate = own
            .as_ref()
            .and_then(|own| program.with_multipliers_of(&active, own));
        if let Some((active, step)) = program.polished(active, StepSource::Clarabel) {
            self.active_set = Some(active);
            return Some(step);
        }
        let is_feasible = |own: &Step| {
            program.violation(&own.d) <= MOST_VIOLATION * (program.reach().min(1.0) + own.d.amax())
        };
        degenerate.or(own.filter(is_feasible))
    }

    fn warm_start(&self, program: &QuadraticProgram) -> Option<Step> {
        let active = self
            .active_set
            .as_ref()
            .filter(|active| active.fits(program))?;
        program.exact_step(active, StepSource::WarmStart)
    }
}
