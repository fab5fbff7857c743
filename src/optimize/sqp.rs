//! The loop: sequential quadratic programming as an argmin `Solver`.

use super::frame::{Frame, Point};
use super::kink::{self, Kink};
use super::model::Plan;
use super::problem::{Bounds, Evaluation, Options, Problem};
use super::sides::Sides;
use super::start::first_point;
use super::status::{Status, Verdict, corner_test, gradient_test, progress_test, radius_test};
use argmin::core::{Error, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus};
use argmin::kv;

/// argmin's state for this solver: point, gradient and Hessian as plain vectors.
pub type SqpState = IterState<Vec<f64>, Vec<f64>, (), Vec<Vec<f64>>, (), f64>;

/// Steps are kept where the function falls by at least this part of what the model promised (Conn, Gould & Toint
/// 2000, §6.1: any small positive number).
const KEEP: f64 = 1e-4;
/// The trust region shrinks to this part of the step where less than a quarter was kept of the promise …
const SHRINK: f64 = 0.25;
/// … and grows by this factor where more than three quarters were, by a step that it limited (ibid., §17.1).
const GROW: f64 = 2.0;
/// Largest trust region, in units of the variables' scale.
const LARGEST_RADIUS: f64 = 1e3;
/// Rounding of the function, relative to φ.
const NOISE: f64 = 1e-14;
/// Promises below this, relative to φ, are none.
const LITTLE: f64 = 1e-13;

/// The solver. [`minimize`](super::minimize) builds and runs it.
pub struct Sqp {
    bounds: Bounds,
    options: Options,
    search: Option<Search>,
    verdict: Option<Verdict>,
    /// Why f is not defined at the start, if so.
    pub(super) undefined_at_start: Option<String>,
    /// Where the search began.
    pub(super) begun_at: Vec<f64>,
    /// The corner it ended at, if it did.
    pub(super) kink: Option<Kink>,
}

/// What changes from one iteration to the next, beside the point.
struct Search {
    frame: Frame,
    radius: f64,
    sides: Sides,
    residual: f64,
    /// Iterations without progress.
    idle: u32,
}

impl Sqp {
    pub(super) fn new(bounds: Bounds, options: Options) -> Self {
        Self { bounds, options, search: None, verdict: None, undefined_at_start: None, begun_at: vec![], kink: None }
    }

    /// The KKT residual where the search ended.
    pub(super) fn residual(&self) -> f64 {
        self.search.as_ref().map_or(f64::INFINITY, |search| search.residual)
    }

    pub(super) fn into_verdict(self, iterations: u64) -> Verdict {
        let residual = self.residual();
        self.verdict.unwrap_or_else(|| Verdict::iteration_limit(iterations, residual))
    }

    /// The verdict on a point, if one of the stopping tests passes. One that is not of plain convergence is checked
    /// for a corner.
    fn judge<P: Problem>(&mut self, problem: &mut Counted<P>, at: &Point, step: Option<&Plan>) -> Result<(), Error> {
        let Some(search) = &mut self.search else { return Ok(()) };
        let promised = step.map_or(f64::INFINITY, |step| step.promised / search.frame.phi);
        let before = std::mem::replace(&mut search.residual, search.frame.kkt_residual(at));
        let is_idle = promised <= NOISE && search.residual > 0.5 * before;
        search.idle = if is_idle { search.idle + 1 } else { 0 };

        let verdict = gradient_test(search.residual, self.options.kkt_tolerance)
            .or_else(|| radius_test(search.radius, search.residual))
            .or_else(|| corner_test(step.map_or(1, |step| step.sides), promised, search.residual))
            .or_else(|| progress_test(search.idle, promised, search.residual));
        let Some(verdict) = verdict else { return Ok(()) };
        if verdict.status != Status::Converged || kink::is_suspected(&search.frame, at) {
            let mut failure = None;
            self.kink = kink::find(&search.frame, at, |x| match evaluate(problem, x) {
                Ok(evaluated) => evaluated.ok(),
                Err(error) => {
                    failure = Some(error);
                    None
                }
            });
            if let Some(error) = failure {
                return Err(error);
            }
        }
        let at_kink = self.kink.map(|kink| Verdict::kink(&kink, at.x[kink.variable], search.residual));
        self.verdict = Some(at_kink.unwrap_or(verdict));
        Ok(())
    }
}

impl Search {
    /// The step to try. Where what is known of another side, from too far away, leaves nothing to gain, that is
    /// forgotten and looked at again.
    fn plan(&mut self, at: &Point) -> Plan {
        loop {
            let plan = Plan::new(&self.frame, &self.sides, at, self.radius);
            let is_hopeless = plan.promised <= LITTLE * self.frame.phi;
            if !(is_hopeless && self.sides.forget_one_too_far(&self.frame, at)) {
                return plan;
            }
        }
    }

    /// The ratio test, without a division and with the function's rounding on both sides: whether a step is kept, and
    /// the trust region for the next.
    fn keeps(&mut self, plan: &Plan, fell: f64) -> bool {
        let noise = NOISE * self.frame.phi;
        let (fell_at_most, promised) = (fell + noise, plan.promised + noise);
        if fell_at_most < 0.25 * promised {
            self.radius = SHRINK * plan.length.min(self.radius);
        } else if fell > 0.75 * plan.promised && plan.length >= 0.99 * self.radius {
            self.radius = (GROW * self.radius).min(LARGEST_RADIUS);
        }
        fell_at_most >= KEEP * promised
    }

    fn report(&self, kept: bool) -> KV {
        kv!("kkt_residual" => self.residual; "radius" => self.radius; "kept" => kept;)
    }
}

impl<P: Problem> Solver<P, SqpState> for Sqp {
    fn name(&self) -> &str {
        "bound-constrained SQP"
    }

    fn init(&mut self, problem: &mut Counted<P>, mut state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let start = self.bounds.project(&state.take_param().unwrap_or_default());
        let trials = self.options.start_trials;
        let (first, why) = first_point(&self.bounds, &start, trials, |x| evaluate(problem, x))?;
        self.undefined_at_start.clone_from(&why);
        let Some(at) = first else {
            self.verdict = why.map(|why| Verdict::undefined(trials, &why));
            return Ok((state.param(start), None));
        };
        self.begun_at.clone_from(&at.x);
        let frame = Frame::new(self.bounds.clone(), self.bounds.scale(&start), &at);
        let (radius, residual) = (self.options.initial_radius, f64::INFINITY);
        self.search = Some(Search { frame, radius, sides: Sides::default(), residual, idle: 0 });
        self.judge(problem, &at, None)?;
        let report = self.search.as_ref().map(|search| search.report(true));
        Ok((stored(state, at), report))
    }

    fn next_iter(&mut self, problem: &mut Counted<P>, mut state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let (Some(search), Some(at)) = (&mut self.search, current(&mut state)) else { return Ok((state, None)) };
        let plan = search.plan(&at);
        let tried = evaluate(problem, &plan.x)?.ok().map(|f| Point { x: plan.x.clone(), f });
        let fell = tried.as_ref().map_or(f64::NEG_INFINITY, |tried| at.f.value - tried.f.value);
        let kept = search.keeps(&plan, fell);
        let (at, other) = match tried {
            Some(tried) if kept => (tried, Some(at)),
            tried => (at, tried),
        };
        // another side of a corner is left behind by a step that crossed it, or met by one that failed at it
        search.sides.keep(&search.frame, &at, other);

        self.judge(problem, &at, Some(&plan))?;
        let report = self.search.as_ref().map(|search| search.report(kept));
        Ok((stored(state, at), report))
    }

    fn terminate(&mut self, _: &SqpState) -> TerminationStatus {
        match &self.verdict {
            None => TerminationStatus::NotTerminated,
            Some(verdict) if verdict.status == Status::Converged => {
                TerminationStatus::Terminated(TerminationReason::SolverConverged)
            }
            Some(verdict) => TerminationStatus::Terminated(TerminationReason::SolverExit(verdict.message.clone())),
        }
    }
}

/// Counts and evaluates. What is not finite or not of the right shape counts as not defined. The outer error is
/// argmin's.
fn evaluate<P: Problem>(problem: &mut Counted<P>, x: &[f64]) -> Result<Result<Evaluation, String>, Error> {
    problem.problem("evaluations", |p| Ok(p.evaluate(x).and_then(|f| f.checked(x.len()))))
}

fn stored(state: SqpState, at: Point) -> SqpState {
    state.param(at.x).cost(at.f.value).gradient(at.f.gradient).hessian(at.f.hessian)
}

fn current(state: &mut SqpState) -> Option<Point> {
    let (x, gradient, hessian) = (state.take_param()?, state.take_gradient()?, state.take_hessian()?);
    Some(Point { x, f: Evaluation { value: state.get_cost(), gradient, hessian } })
}
