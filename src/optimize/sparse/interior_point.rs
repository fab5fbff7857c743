use super::program::{SparseActive, SparseProgram};
use super::symmetric::Symmetric;
use crate::optimize::qp::{End, Method, Step, clamp};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::DVector;

/// Clarabel's tolerances, tighter than its own 1e-8: of many constraints the active ones are then told better.
const TIGHT: f64 = 1e-10;

impl SparseProgram {
    /// Clarabel's solution with B, good to about 1e-10, and its active set; `None` where it finds none.
    pub(super) fn clarabel(&self) -> Option<(Step, SparseActive)> {
        let (n, m) = (self.dimension(), self.rows.len());
        // steps in units of the box, the objective in units of its slope over the box: Clarabel's tolerances are absolute
        let reach = self.high.amax().max(self.low.amax()).max(f64::MIN_POSITIVE);
        let bend = self.convex.largest() * reach * reach;
        let unit = (self.gradient.amax() * reach).max(bend).max(f64::MIN_POSITIVE);
        let p = Symmetric::sum(n, self.convex.entries().map(|(i, j, value)| (i, j, value * (reach * reach / unit))));
        let q: Vec<f64> = self.gradient.iter().map(|slope| slope * reach / unit).collect();

        // equations first, then rows and ends to each side: sign · normal · d ≤ sign · limit
        let is_equation = |j: &usize| self.rows[*j].low == self.rows[*j].high;
        let equations: Vec<usize> = (0..m).filter(is_equation).collect();
        let sides = |low: f64, high: f64| {
            [(1.0, high, End::High), (-1.0, low, End::Low)].into_iter().filter(|(_, limit, _)| limit.is_finite())
        };
        let mut whose: Vec<(usize, f64, f64, End)> = vec![];
        for i in 0..n {
            whose.extend(sides(self.low[i], self.high[i]).map(|(sign, limit, end)| (i, sign, limit, end)));
        }
        for j in (0..m).filter(|j| !is_equation(j)) {
            let row = &self.rows[j];
            whose.extend(sides(row.low, row.high).map(|(sign, limit, end)| (n + j, sign, limit, end)));
        }
        let longest = |j: usize| self.rows[j].largest().max(f64::MIN_POSITIVE);
        let (mut at, mut of, mut entries, mut limits) = (vec![], vec![], vec![], vec![]);
        let all =
            equations.iter().map(|&j| (n + j, 1.0, self.rows[j].low)).chain(whose.iter().map(|w| (w.0, w.1, w.2)));
        for (k, (holder, sign, limit)) in all.enumerate() {
            let (normal, length) = match holder.checked_sub(n) {
                None => (&[(holder, 1.0)][..], 1.0),
                Some(j) => (&self.rows[j].normal[..], longest(j)),
            };
            limits.push(sign * limit / (reach * length));
            for (i, a) in normal {
                at.push(k);
                of.push(*i);
                entries.push(sign * a / length);
            }
        }
        let a = CscMatrix::new_from_triplets(limits.len(), n, at, of, entries);
        let cones = [SupportedConeT::ZeroConeT(equations.len()), SupportedConeT::NonnegativeConeT(whose.len())];
        let settings = DefaultSettings {
            verbose: false,
            presolve_enable: false,
            tol_gap_abs: TIGHT,
            tol_gap_rel: TIGHT,
            tol_feas: TIGHT,
            ..DefaultSettings::default()
        };
        let mut solver = DefaultSolver::new(p.upper(), &q, &a, &limits, &cones, settings).ok()?;
        solver.solve();
        let solution = &solver.solution;
        if !matches!(solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved) {
            return None;
        }

        let mut active = self.equations();
        let mut multipliers = vec![0.0; m];
        let in_units = |z: f64, j: usize| z * unit / (reach * longest(j));
        for (k, &j) in equations.iter().enumerate() {
            multipliers[j] = in_units(solution.z[k], j);
        }
        for (k, &(holder, sign, _, end)) in whose.iter().enumerate() {
            let k = equations.len() + k;
            // at a solution a constraint's multiplier or its slack vanishes: the larger says which
            if solution.z[k] > solution.s[k] {
                match holder.checked_sub(n) {
                    None if self.low[holder] < self.high[holder] => active.ends[holder] = end,
                    None => {}
                    Some(j) => {
                        active.rows[j] = end;
                        multipliers[j] = sign * in_units(solution.z[k], j);
                    }
                }
            }
        }
        let d = DVector::from_fn(n, |i, _| (solution.x[i] * reach).clamp(self.low[i], self.high[i]));
        let mut step = Step { d, ends: vec![], weights: vec![1.0], multipliers, by: Method::Clarabel };
        step.ends.resize(n, End::Free);
        clamp(&self.low, &self.high, &mut step);
        Some((step, active))
    }

    /// The active set of what holds any step: fixed variables and equations.
    pub(super) fn equations(&self) -> SparseActive {
        let fixed = |is_fixed: bool| if is_fixed { End::Low } else { End::Free };
        SparseActive {
            ends: (0..self.dimension()).map(|i| fixed(self.low[i] == self.high[i])).collect(),
            rows: self.rows.iter().map(|row| fixed(row.low == row.high)).collect(),
        }
    }
}
