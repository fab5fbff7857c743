//! What a search knows between two iterations, and what it does with a step.

use super::bundle::Bundle;
use super::model::{Model, sum_hessians};
use super::plan::Plan;
use super::problem::Evaluation;
use super::qp::{Method, QuadraticProgram};
use super::quasi_newton;
use super::scaling::{Point, Residual, Scaling, norm};
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

/// Steps are kept where the merit falls by at least this part of what the model promised (Conn, Gould & Toint
/// 2000, §6.1: any small positive number).
const KEEP: f64 = 1e-4;
/// The trust region shrinks to this part of the step where less than a quarter was kept of the promise …
const SHRINK: f64 = 0.25;
/// … and grows by this factor where more than three quarters were, by a step that it limited (ibid., §17.1).
const GROW: f64 = 2.0;
/// A step that fails is corrected up to so often, while that makes it better and not yet good.
const MOST_CORRECTIONS: u32 = 3;
/// Largest trust region, in units of the variables' scale.
const LARGEST_RADIUS: f64 = 1e16;
/// Rounding of the functions, relative to φ and γ.
pub(super) const NOISE: f64 = 1e-14;
/// Promises below this, relative to φ, are none.
const LITTLE: f64 = 1e-13;
/// Of what the violations fall by, the model's merit must fall by at least this part (Nocedal & Wright 2006,
/// eq. 18.36: ρ).
const MERIT_SHARE: f64 = 0.1;
/// What is added when the penalty is raised, so that it is not raised again at once.
const PENALTY_MARGIN: f64 = 1.5;

/// How often each method solved the quadratic program of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Effort {
    /// Evaluations of the functions with their derivatives.
    pub evaluations: u64,
    /// Quadratic programs of bounds alone, solved from face to face of their box.
    pub faces: u64,
    /// Those with constraints or corners that the dual active-set method solved.
    pub dual: u64,
    /// Those that Clarabel solved.
    pub clarabel: u64,
    /// Those it solved only after their rows were rescaled.
    pub rescaled: u64,
    /// Those that nothing solved: the step ran down the slope.
    pub descent: u64,
    /// Steps whose linearised constraints contradicted each other and were relaxed.
    pub relaxed: u64,
    /// Second-order corrections tried.
    pub corrections: u64,
}

/// The state of a search.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Search {
    pub scaling: Scaling,
    pub at: Point,
    pub multipliers: Vec<f64>,
    /// ν of the merit f + ν ‖v‖₂.
    pub penalty: f64,
    pub radius: f64,
    pub bundle: Bundle,
    pub residual: Residual,
    /// Iterations without progress.
    pub idle: u32,
    /// Times the search left a saddle.
    pub escapes: u32,
    /// Times the search went on from another point that meets the constraints better.
    pub restorations: u32,
    pub effort: Effort,
    /// Why the functions were not defined where the last step that failed for it led.
    pub edge: Option<String>,
    #[serde(skip)]
    workspace: Workspace,
    /// The search's own Hessian by rows, where the problem gives none, and how often it was updated.
    own_hessian: Option<(Vec<Vec<f64>>, u32)>,
}

/// What every iteration writes anew, in the same room.
#[derive(Clone, Debug, Default)]
struct Workspace {
    /// The Hessian of the Lagrangian in scaled variables, exact or the search's own.
    hessian: DMatrix<f64>,
    program: QuadraticProgram,
}

/// Evaluates a problem's functions; the outer error is argmin's.
pub(super) type Evaluate<'a> = dyn FnMut(&[f64]) -> Result<Result<Evaluation, String>, argmin::core::Error> + 'a;

/// What became of a step.
struct Outcome {
    /// What the merit fell by.
    fell: f64,
    /// What the model promised.
    promised: f64,
    /// The merit's rounding.
    noise: f64,
}

impl Outcome {
    fn is_kept(&self) -> bool {
        self.fell + self.noise >= KEEP * (self.promised + self.noise)
    }

    fn is_poor(&self) -> bool {
        self.fell + self.noise < 0.25 * (self.promised + self.noise)
    }

    fn is_good(&self) -> bool {
        self.fell > 0.75 * self.promised
    }
}

impl Search {
    /// Whether it is one for `n` variables and `m` constraints, in all that it holds.
    pub fn is_of(&self, n: usize, m: usize) -> bool {
        let Self { scaling: Scaling { scale, gamma, .. }, at, multipliers, bundle, own_hessian, .. } = self;
        let own = own_hessian.iter().flat_map(|(rows, _)| rows);
        let is_square =
            own_hessian.as_ref().is_none_or(|(rows, _)| rows.len() == n) && own.clone().all(|row| row.len() == n);
        let points = at.is_of(n, m) && bundle.is_of(n, m);
        [scale.len(), gamma.len(), multipliers.len()] == [n, m, m] && is_square && points
    }

    pub fn new(scaling: Scaling, at: Point, radius: f64) -> Self {
        let multipliers = vec![0.0; at.f.constraints.len()];
        let residual = scaling.residual(&at, &multipliers);
        Self {
            multipliers,
            penalty: 0.0,
            radius,
            bundle: Bundle::default(),
            residual,
            idle: 0,
            escapes: 0,
            restorations: 0,
            effort: Effort::default(),
            edge: None,
            workspace: Workspace::default(),
            own_hessian: None,
            scaling,
            at,
        }
    }

    /// One step: plan it, try it, correct it where the constraints' curvature may have spoilt it, and keep it or not.
    pub fn step(&mut self, evaluate: &mut Evaluate<'_>) -> Result<(Plan, bool), argmin::core::Error> {
        let mut plan = self.plan();
        self.raise_penalty(&plan);
        self.limit_multipliers(&mut plan);
        let mut tried = self.tried(std::mem::take(&mut plan.x), evaluate)?;
        let mut outcome = self.outcome(&plan, tried.as_ref());

        if !outcome.is_kept() {
            for _ in 0..MOST_CORRECTIONS {
                if outcome.is_good() {
                    break;
                }
                let corrected = tried.as_ref().and_then(|tried| self.corrected(&plan, tried));
                let Some(corrected) = corrected else { break };
                let again = self.tried(corrected.x, evaluate)?;
                let now = self.outcome(&plan, again.as_ref());
                if now.fell <= outcome.fell {
                    break;
                }
                (tried, outcome) = (again, now);
                plan.multipliers = corrected.multipliers;
            }
        }

        let kept =
            outcome.is_kept() || tried.as_ref().is_some_and(|tried| self.halves_the_residual(&plan, tried, &outcome));
        if outcome.is_kept() || !kept {
            self.resize(&plan, &outcome);
        }
        let other = match tried {
            Some(tried) if kept => Some(self.move_to(tried, plan.multipliers.clone())),
            tried => tried,
        };
        // another side of a corner is left behind by a step that crossed it, or met by one that failed at it
        self.bundle.keep(&self.scaling, &self.at, other);
        Ok((plan, kept))
    }

    /// The step to try. Where what is known of another side, from too far away, leaves nothing to gain, that is
    /// forgotten and looked at again.
    fn plan(&mut self) -> Plan {
        loop {
            let plan = self.planned(None);
            let is_hopeless = self.promised(&plan) <= LITTLE * self.scaling.size(&self.at);
            if !(is_hopeless && self.bundle.forget_one_too_far(&self.scaling, &self.at)) {
                return plan;
            }
        }
    }

    /// A plan by the model around the point, counted; made up for the constraints' curvature where a point was tried.
    fn planned(&mut self, tried: Option<&Point>) -> Plan {
        let plan = self.densely_planned(tried);
        self.count(&plan);
        plan
    }

    fn densely_planned(&mut self, tried: Option<&Point>) -> Plan {
        let mut workspace = std::mem::take(&mut self.workspace);
        let Workspace { hessian, program } = &mut workspace;
        if !sum_hessians(&self.scaling, &self.at, &self.multipliers, hessian) {
            *hessian = self.own().0;
        }
        let Self { scaling, bundle, at, multipliers, radius, .. } = &*self;
        let model = Model { scaling, bundle, at, multipliers, hessian, radius: *radius };
        let plan = match tried {
            None => model.plan(program),
            Some(tried) => model.corrected(tried, program),
        };
        self.workspace = workspace;
        plan
    }

    /// The plan made up for the constraints' curvature, where that may be what a step failed by.
    fn corrected(&mut self, plan: &Plan, tried: &Point) -> Option<Plan> {
        let missed = norm(self.scaling.violations(&tried.f)) - plan.violation_left;
        if self.at.f.constraints.is_empty() || missed <= NOISE {
            return None;
        }
        self.effort.corrections += 1;
        Some(self.planned(Some(tried)))
    }

    /// The point at the end of a plan; where the functions are not defined there, why is remembered.
    fn tried(&mut self, x: Vec<f64>, evaluate: &mut Evaluate<'_>) -> Result<Option<Point>, argmin::core::Error> {
        self.effort.evaluations += 1;
        Ok(match evaluate(&x)? {
            Ok(f) => Some(Point { x, f }),
            Err(why) => {
                self.edge = Some(why);
                None
            }
        })
    }

    /// Raises the penalty, so that a step that meets the constraints better lowers the model's merit.
    fn raise_penalty(&mut self, plan: &Plan) {
        if !plan.is_relaxed {
            // an exact penalty is at least the multipliers' norm; one that was too large sinks towards it
            let scaled = plan.multipliers.iter().zip(&self.scaling.gamma).map(|(m, gamma)| m * gamma);
            let exact = norm(scaled);
            self.penalty = exact.max(0.5 * (self.penalty + exact));
        }
        let gained = plan.violation - plan.violation_left;
        if gained > NOISE {
            let needed = -plan.descent / ((1.0 - MERIT_SHARE) * gained);
            if needed > self.penalty {
                self.penalty = PENALTY_MARGIN * needed;
            }
        }
    }

    /// Where rows contradict each other, their multipliers may be anything. The merit's own, ν v/‖v‖, are no larger than the
    /// penalty, and so are those that a step leaves behind: else they rise without end, and with them the Hessian of the Lagrangian.
    fn limit_multipliers(&self, plan: &mut Plan) {
        if plan.is_relaxed {
            let size = norm(plan.multipliers.iter().zip(&self.scaling.gamma).map(|(m, gamma)| m * gamma));
            let part = if size > self.penalty { self.penalty / size } else { 1.0 };
            plan.multipliers.iter_mut().for_each(|multiplier| *multiplier *= part);
        }
    }

    /// What became of a step that the model planned.
    fn outcome(&self, plan: &Plan, tried: Option<&Point>) -> Outcome {
        let fell = tried.map_or(f64::NEG_INFINITY, |tried| {
            let violation = norm(self.scaling.violations(&tried.f));
            self.at.f.objective.value - tried.f.objective.value + self.penalty * (self.violation() - violation)
        });
        let noise = NOISE * (self.scaling.size(&self.at) + self.penalty);
        Outcome { fell, promised: self.promised(plan), noise }
    }

    /// Whether a step that changes the merit by little more than rounding makes the KKT residual half as large: near a
    /// solution the gradient is known to more digits than the merit (Hager & Zhang 2005, SIAM J. Optim. 16, section 2).
    fn halves_the_residual(&self, plan: &Plan, tried: &Point, outcome: &Outcome) -> bool {
        const QUIET: f64 = 1e-10;
        let most = QUIET * (self.scaling.size(&self.at) + self.penalty);
        let residual = self.scaling.residual(tried, &plan.multipliers);
        outcome.promised <= most && outcome.fell.abs() <= most && residual.largest() <= 0.5 * self.residual.largest()
    }

    /// The trust region for the next step.
    fn resize(&mut self, plan: &Plan, outcome: &Outcome) {
        if outcome.is_poor() {
            self.radius = SHRINK * plan.length.min(self.radius);
        } else if outcome.is_good() && plan.is_limited_by(self.radius) {
            self.radius = (GROW * self.radius).min(LARGEST_RADIUS);
        }
    }

    /// Goes on from a point with the multipliers that led there; returns the point left.
    pub fn move_to(&mut self, to: Point, multipliers: Vec<f64>) -> Point {
        self.multipliers = multipliers;
        if to.f.objective.hessian.is_empty() {
            let (before, updates) = self.own();
            let after = quasi_newton::updated(&before, &self.scaling, &self.at, &to, &self.multipliers, updates == 0);
            self.own_hessian = Some((rows(&after), updates + 1));
        }
        std::mem::replace(&mut self.at, to)
    }

    /// Begins anew at a point, with nothing kept of what was known elsewhere.
    pub fn begin_at(&mut self, at: Point, radius: f64) {
        self.multipliers.fill(0.0);
        (self.penalty, self.radius, self.idle) = (0.0, radius, 0);
        (self.bundle, self.own_hessian) = (Bundle::default(), None);
        self.residual = self.scaling.residual(&at, &self.multipliers);
        self.at = at;
    }

    /// What the model says the merit falls by.
    pub fn promised(&self, plan: &Plan) -> f64 {
        plan.descent + self.penalty * (plan.violation - plan.violation_left)
    }

    /// ‖v‖₂, in units of γ.
    pub fn violation(&self) -> f64 {
        norm(self.scaling.violations(&self.at.f))
    }

    /// The Lagrangian of a point, with the multipliers of this one.
    pub fn lagrangian(&self, at: &Point) -> f64 {
        let pulls = at.f.constraints.iter().zip(&self.multipliers).map(|(constraint, m)| m * constraint.value);
        at.f.objective.value + pulls.sum::<f64>()
    }

    fn own(&self) -> (DMatrix<f64>, u32) {
        let n = self.at.x.len();
        match &self.own_hessian {
            Some((rows, updates)) => (DMatrix::from_fn(n, n, |i, j| rows[i][j]), *updates),
            None => (quasi_newton::initial(&self.scaling, &self.at), 0),
        }
    }

    fn count(&mut self, plan: &Plan) {
        let counted = match plan.by {
            Method::Faces => &mut self.effort.faces,
            Method::Clarabel => &mut self.effort.clarabel,
            Method::Rescaled => &mut self.effort.rescaled,
            Method::Dual => &mut self.effort.dual,
            Method::Descent => &mut self.effort.descent,
        };
        *counted += 1;
        self.effort.relaxed += u64::from(plan.is_relaxed);
    }
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}
