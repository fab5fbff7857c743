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

/// Largest violation of a row by a solution of Clarabel that is accepted, relative to the size of
/// the step.
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

    /// Solves a program; `None` if its rows are infeasible within the bounds, or if all four
    /// attempts fail.
    ///
    /// 1. Warm start: the previous active set, solved as equations. If the KKT conditions hold at
    ///    the result, it is the solution, because the program is convex.
    /// 2. Clarabel: it proves infeasibility or finds an active set, which is polished to an exact
    ///    KKT point.
    /// 3. If polishing fails, for example because normals of active constraints are linearly
    ///    dependent: the exact point of Clarabel's active set with Clarabel's multipliers, if this
    ///    point is near Clarabel's solution and meets the rows.
    /// 4. Otherwise: Clarabel's own solution, projected on the bounds, if it meets the rows.
    ///
    /// # Panics
    /// If there is no term of the maximum, or lengths differ.
    pub fn solve(&mut self, program: &QuadraticProgram) -> Option<QpStep> {
        let previous = self
            .active_set
            .as_ref()
            .filter(|active| active.fits(program));
        if let Some(step) = previous.and_then(|active| program.exact_step(active)) {
            return Some(QpStep {
                source: StepSource::WarmStart,
                ..step
            });
        }
        self.active_set = None;
        let ClarabelResult { active, step } = self.interior_point.solve(program)?;
        let active = program.consistent_working_set(active);
        if let Some((active, step)) = program.polished(active.clone()) {
            self.active_set = Some(active);
            return Some(QpStep {
                source: StepSource::Clarabel,
                ..step
            });
        }
        let approximate = step?;
        let most_violation =
            MOST_VIOLATION * (program.largest_bound().min(1.0) + approximate.d.amax());
        program
            .with_multipliers_of(&active, &approximate)
            .or_else(|| {
                (program.violation(&approximate.d) <= most_violation).then_some(approximate)
            })
            .map(|step| QpStep {
                source: StepSource::Unpolished,
                ..step
            })
    }
}
