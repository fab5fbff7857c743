use super::convex::convex;
use super::program::{SparseActive, SparseProgram, SparseRow};
use super::symmetric::Symmetric;
use crate::optimize::known::SparseDerivatives;
use crate::optimize::plan::{Around, NORMAL_PART, Plan, Program};
use crate::optimize::qp::{End, Step};
use crate::optimize::scaling::{Point, Scaling, norm};
use nalgebra::DVector;

/// Weight that keeps the step of least violation short, against the squared violations.
const SHORT: f64 = 1e-8;
/// Where the Hessian is 0 a curvature is one that over the whole box changes the slope by this part of itself.
const LITTLE: f64 = 1e-6;

/// The quadratic model around a point of a sparse problem.
pub(in crate::optimize) struct SparseModel<'a> {
    pub around: Around<'a>,
    pub derivatives: &'a SparseDerivatives,
    pub multipliers: &'a [f64],
}

impl SparseModel<'_> {
    /// Minimises the model within the bounds, the linearised constraints and the trust region; where a point was tried, with the
    /// constraints as they turned out there, so that their curvature along the way is made up for (Fletcher 1982).
    pub fn plan(&self, tried: Option<&Point>) -> Plan {
        let way = tried.map(|tried| self.around.steps_to(&tried.x));
        let value = |j: usize| match (tried, &way) {
            (Some(tried), Some(way)) => {
                tried.f.constraints[j].value - self.row(j, 0.0).value(way) * self.around.scaling.gamma[j]
            }
            _ => self.around.at.f.constraints[j].value,
        };
        let program = self.posed(value);
        let descent = |d: &DVector<f64>| -program.value(&program.hessian, d);
        self.around.plan(&program, || self.least_violation(&program), descent)
    }

    fn posed(&self, value: impl Fn(usize) -> f64) -> SparseProgram {
        let Around { scaling, at, radius } = self.around;
        let n = at.x.len();
        let gradient = DVector::from_fn(n, |i, _| at.f.objective.gradient[i] * scaling.scale[i]);
        let hessian = lagrangian_hessian(scaling, self.derivatives, self.multipliers);
        let (convex, shift) = convex(&hessian, LITTLE * gradient.amax() / radius);
        let (low, high): (Vec<f64>, Vec<f64>) = (0..n).map(|i| self.around.ends(i)).unzip();
        SparseProgram {
            low: DVector::from_vec(low),
            high: DVector::from_vec(high),
            rows: (0..self.multipliers.len()).map(|j| self.row(j, value(j))).collect(),
            guess: self.guess(),
            hessian,
            convex,
            shift,
            gradient,
        }
    }

    /// A constraint linearised, where its function would have this value without a step.
    fn row(&self, j: usize, value: f64) -> SparseRow {
        let scaling = self.around.scaling;
        let slopes = self.derivatives.constraints[j].gradient.iter();
        let (low, high) = self.around.row_limits(j, value);
        SparseRow {
            normal: slopes.map(|(i, slope)| (*i, slope * scaling.scale[*i] / scaling.gamma[j])).collect(),
            low,
            high,
        }
    }

    /// What holds the point.
    fn guess(&self) -> SparseActive {
        let Around { scaling, at, .. } = self.around;
        let bounds = &scaling.domain.variables;
        let mut guess =
            SparseActive { ends: vec![End::Free; at.x.len()], rows: vec![End::Free; self.multipliers.len()] };
        for i in scaling.held_variables(at, self.multipliers) {
            guess.ends[i] = if at.x[i] <= bounds.low[i] { End::Low } else { End::High };
        }
        for j in scaling.held_rows(self.multipliers) {
            guess.rows[j] = if self.multipliers[j] > 0.0 { End::High } else { End::Low };
        }
        guess
    }

    /// The step of least squared violation within part of the trust region, and what it leaves of each row: what
    /// is missing > 0, what is too much < 0. Where to second order that step would raise the violation, the constraints' curvature is
    /// taken in.
    fn least_violation(&self, program: &SparseProgram) -> (Step, Vec<f64>) {
        let Around { scaling, at, radius } = self.around;
        let (n, m) = (at.x.len(), program.rows.len());
        let reach = NORMAL_PART * radius;
        let wide = |(j, row): (usize, &SparseRow)| {
            let mut row = row.clone();
            row.normal.push((n + j, 1.0));
            row
        };
        let far = |row: &SparseRow| {
            let slopes: f64 = row.normal.iter().map(|(_, a)| a.abs()).sum();
            row.low.max(0.0).max(-row.high.min(0.0)) + slopes * reach + 1.0
        };
        let farthest = program.rows.iter().map(far).fold(1.0, f64::max);
        let squares = Symmetric::sum(n + m, (0..n + m).map(|i| (i, i, if i < n { SHORT } else { 1.0 })));
        let mut elastic = SparseProgram {
            hessian: squares.clone(),
            convex: squares.clone(),
            shift: 0.0,
            gradient: DVector::zeros(n + m),
            low: DVector::from_fn(n + m, |i, _| if i < n { program.low[i].max(-reach) } else { -farthest }),
            high: DVector::from_fn(n + m, |i, _| if i < n { program.high[i].min(reach) } else { farthest }),
            rows: program.rows.iter().enumerate().map(wide).collect(),
            guess: SparseActive { ends: vec![End::Free; n + m], rows: vec![End::Free; m] },
        };
        let mut step = elastic.solve().unwrap_or_else(|| Step::none(n + m, m));
        let own = |step: &Step| step.d.rows(0, n).into_owned();
        let left: Vec<f64> = scaling.violations(&at.f).collect();
        let bend = violation_bend(scaling, self.derivatives, &left);
        let before = 0.5 * norm(left).powi(2);
        let after = 0.5 * step.d.rows(n, m).norm_squared() + 0.5 * bend.quadratic_form(&own(&step));
        if bend.largest() > 0.0 && after > before {
            let (bend, _) = convex(&bend, 0.0);
            elastic.convex = Symmetric::sum(n + m, squares.entries().chain(bend.entries()));
            elastic.hessian = elastic.convex.clone();
            step = elastic.solve().unwrap_or_else(|| Step::none(n + m, m));
        }
        step.d = own(&step);
        step.ends.truncate(n);
        let left = program.left_over(&step.d).map(|left| -left).collect();
        (step, left)
    }
}

/// The Hessian of the Lagrangian in scaled variables.
pub(super) fn lagrangian_hessian(scaling: &Scaling, derivatives: &SparseDerivatives, multipliers: &[f64]) -> Symmetric {
    let objective = derivatives.bend.iter().map(|entry| (entry, 1.0));
    weighted(scaling, objective.chain(of_constraints(derivatives, multipliers)))
}

/// What the curvature of violated constraints adds to the Hessian of ½‖v‖², in scaled variables, with v in units of γ.
pub(super) fn violation_bend(scaling: &Scaling, derivatives: &SparseDerivatives, violations: &[f64]) -> Symmetric {
    let weights: Vec<f64> = violations.iter().zip(&scaling.gamma).map(|(v, gamma)| v / gamma).collect();
    weighted(scaling, of_constraints(derivatives, &weights))
}

/// The second derivatives of the constraints, each with its weight.
fn of_constraints<'a>(
    derivatives: &'a SparseDerivatives,
    weights: &'a [f64],
) -> impl Iterator<Item = (&'a (usize, usize, f64), f64)> {
    let each = derivatives.constraints.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
    each.flat_map(|(constraint, weight)| constraint.hessian.iter().map(|entry| (entry, *weight)))
}

fn weighted<'a>(scaling: &Scaling, all: impl Iterator<Item = (&'a (usize, usize, f64), f64)>) -> Symmetric {
    let scale = &scaling.scale;
    Symmetric::sum(scale.len(), all.map(|(&(i, j, bend), weight)| (i, j, weight * bend * scale[i] * scale[j])))
}
