use super::polish::ActiveSet;
use super::{End, QuadraticProgram};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};

impl QuadraticProgram {
    /// Clarabel's active set; `None` where it does not answer "solved".
    pub(super) fn clarabel(&self) -> Option<ActiveSet> {
        let (n, pieces) = (self.dimension(), self.pieces.len());
        // with several pieces their maximum is one more variable t ≥ offsetₖ + gradientₖ · d
        let epigraph = usize::from(pieces > 1);
        let size = n + epigraph;
        // steps in units of the box, the objective in units of its slope over the box: Clarabel's tolerances
        // are absolute
        let reach = self.high.amax().max(self.low.amax()).max(f64::MIN_POSITIVE);
        let slope = self.pieces.iter().map(|piece| piece.gradient.amax()).fold(0.0, f64::max);
        let unit = (slope * reach).max(f64::MIN_POSITIVE);

        let mut p = vec![vec![0.0; size]; size];
        for (i, row) in p.iter_mut().enumerate().take(n) {
            // upper triangle
            for (j, entry) in row.iter_mut().enumerate().take(n).skip(i) {
                *entry = self.curvature[(i, j)] * (reach * reach / unit);
            }
        }
        let mut q = vec![0.0; size];
        if epigraph == 1 {
            q[n] = 1.0;
        } else {
            q.copy_from_slice((&self.pieces[0].gradient * (reach / unit)).as_slice());
        }

        let mut rows = Vec::with_capacity(2 * n + pieces);
        let mut limits = Vec::with_capacity(2 * n + pieces);
        for i in 0..n {
            for (sign, limit) in [(1.0, self.high[i]), (-1.0, -self.low[i])] {
                let mut row = vec![0.0; size];
                row[i] = sign;
                rows.push(row);
                limits.push(limit / reach);
            }
        }
        if epigraph == 1 {
            for piece in &self.pieces {
                let mut row: Vec<f64> = piece.gradient.iter().map(|g| g * (reach / unit)).collect();
                row.push(-1.0);
                rows.push(row);
                limits.push(-piece.offset / unit);
            }
        }

        let cones = [SupportedConeT::NonnegativeConeT(rows.len())];
        let settings = DefaultSettings { verbose: false, presolve_enable: false, ..DefaultSettings::default() };
        let (p, a) = (CscMatrix::from(&p), CscMatrix::from(&rows));
        let mut solver = DefaultSolver::new(&p, &q, &a, &limits, &cones, settings).ok()?;
        solver.solve();
        let solution = &solver.solution;
        if !matches!(solution.status, SolverStatus::Solved) {
            return None;
        }
        // at a solution a constraint's multiplier or its slack vanishes: the larger says which
        let is_active = |row: usize| solution.z[row] > solution.s[row];
        let end = |i: usize| match (is_active(2 * i + 1), is_active(2 * i)) {
            _ if self.low[i] == self.high[i] => End::Low,
            (true, _) => End::Low,
            (_, true) => End::High,
            _ => End::Free,
        };
        let mut held: Vec<bool> = (0..pieces).map(|k| epigraph == 0 || is_active(2 * n + k)).collect();
        if !held.contains(&true) {
            held[0] = true;
        }
        Some(ActiveSet { ends: (0..n).map(end).collect(), pieces: held })
    }
}
