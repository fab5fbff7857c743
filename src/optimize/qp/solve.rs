use super::active_set::ActiveSet;
use super::dual::Dual;
use super::ends::clamp;
use super::program::{End, Method, QuadraticProgram, Row, Step};

/// Curvature that is little: over the whole box the slope changes by this part of itself.
const LITTLE: f64 = 1e-6;

impl QuadraticProgram {
    /// Solves the program; `None` where the rows cannot be met within the ends.
    ///
    /// The faces of the box come first: where they end the answer is proven and exact. For all else the dual active-set method tells
    /// which ends, rows and pieces are active. The polish then solves the remaining equations to rounding, and corrects the active set
    /// where they disagree with it. Where the method does not end, or what it says cannot be polished, Clarabel is asked, whose answer is
    /// good to about 1e-8 and may lie that far outside, and then asked again with every row at length 1; last the dual method, with a
    /// little curvature added.
    pub fn solve(&self) -> Option<Step> {
        if let Some(step) = self.by_faces() {
            return Some(step);
        }
        let mut second_best = None;
        let mut exact = |active: Option<ActiveSet>, method: Method| match self.polished(active?, method) {
            Ok(step) => Some(step),
            Err(step) => {
                second_best = second_best.take().or(step);
                None
            }
        };
        let by_dual = match self.dual_active_set() {
            Dual::Active(active) => exact(Some(active), Method::Dual),
            Dual::Infeasible => return None,
            Dual::Undecided => None,
        };
        let has_rows = !self.rows.is_empty();
        let by_any = by_dual
            .or_else(|| exact(self.clarabel(), Method::Clarabel))
            .or_else(|| if has_rows { exact(self.rescaled().clarabel(), Method::Rescaled) } else { None })
            .or(second_best)
            .or_else(|| self.polished(self.corner().filter(|_| has_rows)?, Method::Dual).ok());
        if has_rows { by_any } else { Some(by_any.unwrap_or_else(|| self.steepest())) }
    }

    /// The active set of a program without curvature by the dual method, with a little curvature in every direction. Its solution is a corner of
    /// what ends and rows leave, which an interior point cannot tell from one beside it where two limits lie as near as its own tolerance.
    fn corner(&self) -> Option<ActiveSet> {
        if self.curvature.amax().is_normal() {
            return None;
        }
        let reach = self.high.amax().max(self.low.amax());
        let slope = self.pieces.iter().map(|piece| piece.gradient.amax()).fold(0.0, f64::max);
        let least = LITTLE * slope / reach;
        let mut bent = self.clone();
        for i in 0..self.dimension() {
            bent.curvature[(i, i)] += least;
        }
        match bent.dual_active_set() {
            Dual::Active(active) => Some(active),
            Dual::Infeasible | Dual::Undecided => None,
        }
    }

    /// The same program with rows of length 1.
    fn rescaled(&self) -> Self {
        let mut scaled = self.clone();
        for row in &mut scaled.rows {
            let length = row.normal.norm();
            if length > 0.0 {
                *row = Row { normal: &row.normal / length, low: row.low / length, high: row.high / length };
            }
        }
        scaled
    }

    /// The best step down the first piece's slope alone, for when no active set can be solved.
    fn steepest(&self) -> Step {
        let slope = &self.pieces[0].gradient;
        let bend = slope.dot(&(&self.curvature * slope));
        let length = if bend > 0.0 { slope.norm_squared() / bend } else { 1.0 };
        let mut step = Step {
            d: -slope * length,
            ends: vec![End::Free; self.dimension()],
            weights: vec![0.0; self.pieces.len()],
            multipliers: vec![0.0; self.rows.len()],
            by: Method::Descent,
        };
        step.weights[0] = 1.0;
        clamp(&self.low, &self.high, &mut step);
        step
    }
}
