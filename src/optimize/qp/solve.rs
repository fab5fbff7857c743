use super::active_set::ActiveSet;
use super::dual::Dual;
use super::ends::clamp;
use super::program::{End, Method, QuadraticProgram, Row, Step};

/// Curvature that is little: over the whole box the slope changes by this part of itself.
const LITTLE: f64 = 1e-6;

/// Limits that a step misses by no more than this may be meant to meet in it.
const NEAR: f64 = 1e-8;

impl QuadraticProgram {
    /// Solves the program; `None` where the rows cannot be met within the ends. All numbers of the program must be finite, but for ends of
    /// rows, and no lower end may exceed its upper one.
    ///
    /// # Panics
    /// Where there is no piece, or lengths differ.
    ///
    /// The faces of the box come first: where they end the answer is proven and exact. For all else the dual active-set method tells
    /// which ends, rows and pieces are active, and its factors give the step to rounding. Where they are not accurate enough the polish solves
    /// the remaining equations, and corrects the active set where they disagree with it. A program without curvature is given a little, and its
    /// corner taken where the multipliers there are the only ones. Where the method does not end, or what it says cannot be polished, Clarabel is
    /// asked, whose answer is good to about 1e-8 and may lie that far outside, and then asked again with every row at length 1.
    pub fn solve(&self) -> Option<Step> {
        if let Some(step) = self.by_faces() {
            return Some(step);
        }
        let mut second_best = None;
        let mut exact = |active: Option<ActiveSet>, implied, method| match self.polished(active?, implied, method) {
            Ok(step) => Some(step),
            Err(step) => {
                second_best = second_best.take().or(step);
                None
            }
        };
        let by_corner = self.corner();
        if let Some(step) = by_corner.as_ref().filter(|step| self.has_one_set_of_multipliers(step)) {
            return Some(step.clone());
        }
        let by_dual = match self.dual_active_set() {
            Dual::Active(active, implied) => exact(Some(active), implied, Method::Dual),
            Dual::Infeasible => return None,
            Dual::Undecided => None,
        };
        let has_rows = !self.rows.is_empty();
        let by_any = by_dual
            .or_else(|| exact(self.clarabel(), None, Method::Clarabel))
            .or_else(|| if has_rows { exact(self.rescaled().clarabel(), None, Method::Rescaled) } else { None })
            .or(second_best)
            .or(by_corner);
        if has_rows { by_any } else { Some(by_any.unwrap_or_else(|| self.steepest())) }
    }

    /// The solution of a program without curvature by the dual method, with a little curvature in every direction: a corner of
    /// what ends and rows leave, which an interior point cannot tell from one beside it where two limits lie as near as its own tolerance.
    fn corner(&self) -> Option<Step> {
        if self.curvature.amax().is_normal() || self.rows.is_empty() {
            return None;
        }
        let reach = self.high.amax().max(self.low.amax());
        let slope = self.pieces.iter().map(|piece| piece.gradient.amax()).fold(0.0, f64::max);
        let least = LITTLE * if slope > 0.0 { slope / reach } else { 1.0 };
        let mut bent = self.clone();
        for i in 0..self.dimension() {
            bent.curvature[(i, i)] += least;
        }
        match bent.dual_active_set() {
            Dual::Active(active, _) => self.polished(active, None, Method::Dual).ok(),
            Dual::Infeasible | Dual::Undecided => None,
        }
    }

    /// Whether as many limits meet at a corner as there are variables, and no more: then there is one set of multipliers. Where there are
    /// several, those in the middle, which an interior point finds, serve a search best.
    fn has_one_set_of_multipliers(&self, corner: &Step) -> bool {
        let is_met = |row: &&Row| {
            let value = row.normal.dot(&corner.d);
            (value - row.low).min(row.high - value) <= NEAR * (1.0 + row.normal.amax() * corner.d.amax())
        };
        let ends = corner.ends.iter().filter(|end| **end != End::Free).count();
        self.pieces.len() == 1 && ends + self.rows.iter().filter(is_met).count() == self.dimension()
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
