use super::active_set::{ActiveSet, Holder};
use super::program::{End, Method, QuadraticProgram, Row, Step};

impl QuadraticProgram {
    /// Solves the program; `None` where the rows cannot be met within the ends.
    pub fn solve(&self) -> Option<Step> {
        self.solve_from([])
    }

    /// As [`solve`](Self::solve), with a guess at what holds the step; right or wrong, it changes the time alone.
    ///
    /// The faces of the box come first, then the guess: where one of them ends its answer is proven, exact, and found in
    /// a fraction of the time that Clarabel takes. For all else, Clarabel's answer is good to about 1e-8 and may lie that far outside;
    /// it tells which ends, rows and pieces are active. The polish then solves the remaining equations to rounding, and
    /// corrects the active set where they disagree with it. Where Clarabel answers anything but "solved", or what it
    /// says cannot be polished, it is asked again with every row at length 1; then the dual active-set method decides.
    pub(in crate::optimize) fn solve_from(&self, guess: impl IntoIterator<Item = Holder>) -> Option<Step> {
        let quickly = self.by_faces().or_else(|| self.warm_started(self.held_by(guess)));
        if quickly.is_some() {
            return quickly;
        }
        let mut second_best = None;
        let mut exact = |active: Option<ActiveSet>, method: Method| match self.polished(active?, method) {
            Ok(step) => Some(step),
            Err(step) => {
                second_best = second_best.take().or(step);
                None
            }
        };
        let by_clarabel = exact(self.clarabel(), Method::Clarabel);
        let has_rows = !self.rows.is_empty();
        let by_either =
            by_clarabel.or_else(|| if has_rows { exact(self.rescaled().clarabel(), Method::Rescaled) } else { None });
        if by_either.is_some() {
            return by_either;
        }
        let by_dual = self.dual_active_set();
        if by_dual.is_none() && has_rows {
            return None;
        }
        let by_any = exact(by_dual, Method::Dual).or(second_best);
        if has_rows { by_any } else { Some(by_any.unwrap_or_else(|| self.steepest())) }
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
        self.clamp(&mut step);
        step
    }
}
