use super::active_set::{ActiveConstraint, ActiveSet};
use super::program::{End, QuadraticProgram};
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
        let bend = if self.rows.is_empty() { 0.0 } else { self.curvature.amax() * reach * reach };
        let unit = (slope * reach).max(bend).max(f64::MIN_POSITIVE);

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

        let mut equations = Vec::new();
        let mut inequalities = Vec::new();
        let mut whose = Vec::new();
        let mut add = |normal: Vec<f64>, limit: f64, is_equation: bool, holder: ActiveConstraint| {
            if is_equation {
                equations.push((normal, limit));
            } else if limit.is_finite() {
                inequalities.push((normal, limit));
                whose.push(holder);
            }
        };
        let wide = |normal: &mut dyn Iterator<Item = f64>| normal.chain(vec![0.0; epigraph]).collect::<Vec<_>>();
        for i in 0..n {
            for (sign, limit, end) in [(1.0, self.high[i], End::High), (-1.0, -self.low[i], End::Low)] {
                let normal = wide(&mut (0..n).map(|k| if k == i { sign } else { 0.0 }));
                add(normal, limit / reach, false, ActiveConstraint::Variable(i, end));
            }
        }
        for (j, row) in self.rows.iter().enumerate() {
            let longest = row.normal.amax().max(f64::MIN_POSITIVE);
            for (sign, limit, end) in [(1.0, row.high, End::High), (-1.0, -row.low, End::Low)] {
                let is_equation = row.low == row.high;
                if !(is_equation && end == End::Low) {
                    let normal = wide(&mut row.normal.iter().map(|a| sign * a / longest));
                    add(normal, limit / (reach * longest), is_equation, ActiveConstraint::Row(j, end));
                }
            }
        }
        if epigraph == 1 {
            for (k, piece) in self.pieces.iter().enumerate() {
                let mut row: Vec<f64> = piece.gradient.iter().map(|g| g * (reach / unit)).collect();
                row.push(-1.0);
                add(row, -piece.offset / unit, false, ActiveConstraint::Piece(k));
            }
        }

        let first_inequality = equations.len();
        let mut cones = vec![SupportedConeT::NonnegativeConeT(inequalities.len())];
        if first_inequality > 0 {
            cones.insert(0, SupportedConeT::ZeroConeT(first_inequality));
        }
        let (rows, limits): (Vec<_>, Vec<_>) = equations.into_iter().chain(inequalities).unzip();
        let settings = DefaultSettings { verbose: false, presolve_enable: false, ..DefaultSettings::default() };
        let (p, a) = (CscMatrix::from(&p), CscMatrix::from(&rows));
        let mut solver = DefaultSolver::new(&p, &q, &a, &limits, &cones, settings).ok()?;
        solver.solve();
        let solution = &solver.solution;
        if !matches!(solution.status, SolverStatus::Solved) {
            return None;
        }

        // at a solution a constraint's multiplier or its slack vanishes: the larger says which
        let holds = |row: usize| solution.z[row] > solution.s[row];
        let holders = whose.into_iter().enumerate().filter(|(at, _)| holds(first_inequality + at));
        Some(self.held_by(holders.map(|(_, holder)| holder)))
    }
}
