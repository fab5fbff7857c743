//! The loop: sequential quadratic programming as an argmin `Solver`.

use super::convex::convexified;
use super::kink::{self, Kink};
use super::problem::{Bounds, Evaluation, Options, Problem};
use super::qp::{End, Piece, QuadraticProgram, Step};
use super::status::{Status, Verdict, corner_test, gradient_test, progress_test, radius_test};
use argmin::core::{Error, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus};
use argmin::kv;
use nalgebra::{DMatrix, DVector};

/// argmin's state for this solver: point, gradient and Hessian as plain vectors.
pub type SqpState = IterState<Vec<f64>, Vec<f64>, (), Vec<Vec<f64>>, (), f64>;

/// Steps kept where the function falls by at least this part of what the model promised (Conn, Gould & Toint
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
/// Steps shorter than this, in units of the scale, that fail against the model point to a corner, whose other
/// side then becomes a piece of the model.
const NEARBY: f64 = 0.05;

/// The solver. [`minimize`](super::minimize) builds and runs it.
pub struct Sqp {
    bounds: Bounds,
    options: Options,
    /// What a sensible change of each variable is.
    scale: Vec<f64>,
    /// φ: what a sensible size of the function is.
    phi: f64,
    radius: f64,
    /// The last evaluated points on other sides of corners nearby.
    others: Vec<Point>,
    idle: u32,
    residual: f64,
    verdict: Option<Verdict>,
    kink: Option<Kink>,
    /// Why f was not defined at the start, and where the search began instead.
    undefined: Option<String>,
    begun_at: Vec<f64>,
}
/// Points of another side are trusted to rule out further progress only within this distance.
const CLOSE: f64 = 1e-4;
/// Promises below this, relative to φ, are none.
const LITTLE: f64 = 1e-13;

#[derive(Clone)]
struct Point {
    x: Vec<f64>,
    f: Evaluation,
}

impl Sqp {
    pub(super) fn new(bounds: Bounds, options: Options) -> Self {
        let radius = options.initial_radius;
        Self {
            bounds,
            options,
            scale: vec![],
            phi: 0.0,
            radius,
            others: vec![],
            idle: 0,
            residual: f64::INFINITY,
            verdict: None,
            kink: None,
            undefined: None,
            begun_at: vec![],
        }
    }

    pub(super) fn residual(&self) -> f64 {
        self.residual
    }

    pub(super) fn kink(&self) -> Option<Kink> {
        self.kink
    }

    pub(super) fn start(&self) -> (Vec<f64>, Option<String>) {
        (self.begun_at.clone(), self.undefined.clone())
    }

    pub(super) fn into_verdict(self, iterations: u64) -> Verdict {
        let residual = self.residual;
        self.verdict.unwrap_or_else(|| Verdict::iteration_limit(iterations, residual))
    }

    /// The gradient's component where a move inside the bounds can use it, 0 elsewhere.
    fn projected(&self, x: &[f64], gradient: &[f64]) -> Vec<f64> {
        let component = |i: usize| match gradient[i] {
            _ if self.bounds.low[i] == self.bounds.high[i] => 0.0,
            slope if slope > 0.0 && x[i] <= self.bounds.low[i] => 0.0,
            slope if slope < 0.0 && x[i] >= self.bounds.high[i] => 0.0,
            slope => slope,
        };
        (0..x.len()).map(component).collect()
    }

    fn kkt_residual(&self, at: &Point) -> f64 {
        let projected = self.projected(&at.x, &at.f.gradient);
        projected.iter().zip(&self.scale).map(|(p, s)| (p * s).abs()).fold(0.0, f64::max) / self.phi
    }

    /// The quadratic model around a point, in scaled variables: its own piece, and those of the other sides of
    /// corners nearby.
    fn model(&self, at: &Point) -> QuadraticProgram {
        let (n, s) = (at.x.len(), &self.scale);
        let scaled = |gradient: &[f64]| DVector::from_fn(n, |i, _| gradient[i] * s[i]);
        let hessian = |point: &Point| DMatrix::from_fn(n, n, |i, j| point.f.hessian[i][j] * s[i] * s[j]);
        // the sides' curvature: the mildest, for in the rounded tip of a smoothed corner it is that of no side
        let mildest = |least: DMatrix<f64>, point: &Point| {
            let other = hessian(point);
            if other.amax() < least.amax() { other } else { least }
        };
        let sides = self.others.iter().fold(hessian(at), mildest);

        let mut pieces = vec![Piece { offset: 0.0, gradient: scaled(&at.f.gradient) }];
        for other in &self.others {
            // the other side's function, carried to here by its second-order expansion; at most f, for at a
            // corner that holds a search f is the largest of its sides
            let way = DVector::from_fn(n, |i, _| (at.x[i] - other.x[i]) / s[i]);
            let (slope, bend) = (scaled(&other.f.gradient), &sides * &way);
            let offset = other.f.value - at.f.value + slope.dot(&way) + 0.5 * bend.dot(&way);
            pieces.push(Piece { offset: offset.min(0.0), gradient: slope + bend });
        }

        let projected = self.projected(&at.x, &at.f.gradient);
        let held: Vec<bool> = (0..n).map(|i| projected[i] == 0.0 && self.is_at_a_bound(at.x[i], i)).collect();
        let limit = |i: usize, bound: f64| ((bound - at.x[i]) / s[i]).clamp(-self.radius, self.radius);
        QuadraticProgram {
            curvature: convexified(&hessian(at), &held),
            pieces,
            low: DVector::from_fn(n, |i, _| limit(i, self.bounds.low[i])),
            high: DVector::from_fn(n, |i, _| limit(i, self.bounds.high[i])),
        }
    }

    /// The step that the model at a point leads to, and what that promises.
    fn plan(&self, at: &Point) -> (Step, f64) {
        let model = self.model(at);
        let step = model.solve();
        let promised = self.promised(at, &model, &step);
        (step, promised)
    }

    fn is_at_a_bound(&self, x: f64, i: usize) -> bool {
        x <= self.bounds.low[i] || x >= self.bounds.high[i]
    }

    /// The point a step leads to; one that ends at a bound is there exactly.
    fn stepped(&self, x: &[f64], step: &Step) -> Vec<f64> {
        let coordinate = |i: usize| {
            let to = x[i] + step.d[i] * self.scale[i];
            let (low, high) = (self.bounds.low[i], self.bounds.high[i]);
            match step.ends[i] {
                End::Low if step.d[i] > -self.radius => low,
                End::High if step.d[i] < self.radius => high,
                _ => to.clamp(low, high),
            }
        };
        (0..x.len()).map(coordinate).collect()
    }

    /// What the model says f falls by: with the true Hessian where there is one piece, for it promises at
    /// least as much as the convex stand-in.
    fn promised(&self, at: &Point, model: &QuadraticProgram, step: &Step) -> f64 {
        if model.pieces.len() > 1 {
            return -model.value(&step.d);
        }
        let d = self.unscaled(step);
        let bend: Vec<f64> = at.f.hessian.iter().map(|row| dot(row, &d)).collect();
        -(dot(&at.f.gradient, &d) + 0.5 * dot(&bend, &d))
    }

    /// A step in the variables' own units.
    fn unscaled(&self, step: &Step) -> Vec<f64> {
        step.d.iter().zip(&self.scale).map(|(d, s)| d * s).collect()
    }

    /// The distance of two points, in units of the scale.
    fn distance(&self, a: &Point, b: &Point) -> f64 {
        a.x.iter().zip(&b.x).zip(&self.scale).map(|((a, b), s)| ((a - b) / s).abs()).fold(0.0, f64::max)
    }

    /// Whether two points lie on different sides of a corner: the gradient changes between them, and neither
    /// Hessian accounts for it.
    fn are_sides_of_a_corner(&self, a: &Point, b: &Point) -> bool {
        let d: Vec<f64> = b.x.iter().zip(&a.x).map(|(to, from)| to - from).collect();
        let (mut change, mut unexplained) = (0.0_f64, [0.0_f64; 3]);
        for i in 0..d.len() {
            let jump = b.f.gradient[i] - a.f.gradient[i];
            let (here, there) = (dot(&a.f.hessian[i], &d), dot(&b.f.hessian[i], &d));
            change = change.max((jump * self.scale[i]).abs());
            for (most, bend) in unexplained.iter_mut().zip([here, there, 0.5 * (here + there)]) {
                *most = most.max(((jump - bend) * self.scale[i]).abs());
            }
        }
        change > 1e-6 * self.phi && unexplained.iter().all(|rest| *rest > 0.5 * change)
    }

    /// Keeps, of the points known around `at`, the nearest of each other side of a corner nearby.
    fn keep_other_sides(&mut self, at: &Point, candidate: Option<Point>) {
        let mut known = std::mem::take(&mut self.others);
        known.extend(candidate);
        known.retain(|point| self.distance(point, at) <= NEARBY);
        known.sort_by(|a, b| self.distance(a, at).total_cmp(&self.distance(b, at)));
        for point in known {
            let is_new = |side: &Point| self.are_sides_of_a_corner(side, &point);
            if is_new(at) && self.others.iter().all(is_new) {
                self.others.push(point);
            }
        }
    }

    /// Judges the point after a step that promised `promised` (relative to φ) and that pieces of so many sides of
    /// a corner held.
    fn judge(&mut self, problem: &impl Problem, at: &Point, promised: f64, sides: usize) {
        let before = self.residual;
        self.residual = self.kkt_residual(at);
        let idle = promised <= NOISE && self.residual > 0.5 * before;
        self.idle = if idle { self.idle + 1 } else { 0 };
        let converged = gradient_test(self.residual, self.options.kkt_tolerance);
        let suspicious = converged.is_some() && kink::is_suspected(&at.f, &self.scale, self.phi);
        let verdict = converged
            .or_else(|| radius_test(self.radius, self.residual))
            .or_else(|| corner_test(sides, promised, self.residual))
            .or_else(|| progress_test(self.idle, promised, self.residual));
        self.verdict = verdict.map(|verdict| {
            if verdict.status == Status::Converged && !suspicious {
                return verdict;
            }
            let corner = kink::find(problem, &self.bounds, &at.x, self.phi);
            self.kink = corner;
            corner.map_or(verdict, |kink| Verdict::kink(&kink, at.x[kink.variable], self.residual))
        });
    }

    /// f at the start, or at another point of the box where it is not defined there.
    fn first_point<P: Problem>(&mut self, problem: &mut Counted<P>, start: Vec<f64>) -> Result<Option<Point>, Error> {
        let why = match evaluate(problem, &start)? {
            Ok(f) => return Ok(Some(Point { x: start, f })),
            Err(why) => why,
        };
        let mut best: Option<Point> = None;
        for trial in 0..self.options.start_trials {
            // look for the best of a few, then for any
            if trial >= 8 && best.is_some() {
                break;
            }
            let x = self.spread(&start, trial);
            if let Ok(f) = evaluate(problem, &x)?
                && best.as_ref().is_none_or(|best| f.value < best.f.value)
            {
                best = Some(Point { x, f });
            }
        }
        if best.is_none() {
            self.verdict = Some(Verdict::undefined(self.options.start_trials, &why));
        }
        self.undefined = Some(why);
        Ok(best)
    }

    /// Point `k` of an even spread over the box: multiples of powers of the generalised golden ratio
    /// (Roberts 2018), from the middle on.
    fn spread(&self, start: &[f64], k: u32) -> Vec<f64> {
        let n = start.len();
        let golden = (0..64).fold(1.5_f64, |g, _| (1.0 + g).powf(1.0 / (n as f64 + 1.0)));
        let coordinate = |i: usize| {
            let part = (0.5 + f64::from(k) * golden.powi(-(i as i32 + 1))).fract();
            let low = self.bounds.low[i].max(start[i] - self.scale[i]);
            let high = self.bounds.high[i].min(start[i] + self.scale[i]);
            low + part * (high - low)
        };
        (0..n).map(coordinate).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Counts and evaluates. The outer error is argmin's, which never occurs here.
fn evaluate<P: Problem>(problem: &mut Counted<P>, x: &[f64]) -> Result<Result<Evaluation, String>, Error> {
    problem.problem("evaluations", |p| {
        Ok(p.evaluate(x)
            .and_then(|f| if f.is_finite() { Ok(f) } else { Err("it or a derivative is not finite".into()) }))
    })
}

fn stored(state: SqpState, at: Point) -> SqpState {
    state.param(at.x).cost(at.f.value).gradient(at.f.gradient).hessian(at.f.hessian)
}

fn current(state: &mut SqpState) -> Option<Point> {
    let (x, gradient, hessian) = (state.take_param()?, state.take_gradient()?, state.take_hessian()?);
    Some(Point { x, f: Evaluation { value: state.get_cost(), gradient, hessian } })
}

impl<P: Problem> Solver<P, SqpState> for Sqp {
    fn name(&self) -> &str {
        "bound-constrained SQP"
    }

    fn init(&mut self, problem: &mut Counted<P>, mut state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let start = self.bounds.project(&state.take_param().unwrap_or_default());
        self.scale = self.bounds.scale(&start);
        let Some(at) = self.first_point(problem, start.clone())? else {
            return Ok((state.param(start), None));
        };
        self.begun_at.clone_from(&at.x);
        let slopes = at.f.gradient.iter().zip(&self.scale).map(|(g, s)| (g * s).abs());
        self.phi = slopes.fold(at.f.value.abs(), f64::max).max(f64::MIN_POSITIVE);
        if let Some(p) = &problem.problem {
            self.judge(p, &at, f64::INFINITY, 1);
        }
        let report = kv!("kkt_residual" => self.residual; "radius" => self.radius; "kept" => true;);
        Ok((stored(state, at), Some(report)))
    }

    fn next_iter(&mut self, problem: &mut Counted<P>, mut state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let Some(at) = current(&mut state) else { return Ok((state, None)) };
        let (mut step, mut promised) = self.plan(&at);
        while promised <= LITTLE * self.phi
            && let Some(farthest) = self.others.last()
            && self.distance(farthest, &at) > CLOSE
        {
            // what is known of that side, from too far away, leaves nothing to gain: look again
            self.others.pop();
            (step, promised) = self.plan(&at);
        }
        let x = self.stepped(&at.x, &step);
        let length = step.d.amax();

        // ratio test without a division, and with the function's rounding on both sides
        let noise = NOISE * self.phi;
        let tried = evaluate(problem, &x)?.ok().map(|f| Point { x, f });
        let fell = tried.as_ref().map_or(f64::NEG_INFINITY, |tried| at.f.value - tried.f.value);
        let kept = fell + noise >= KEEP * (promised + noise);
        if fell + noise < 0.25 * (promised + noise) {
            self.radius = SHRINK * length.min(self.radius);
        } else if fell > 0.75 * promised && length >= 0.99 * self.radius {
            self.radius = (GROW * self.radius).min(LARGEST_RADIUS);
        }
        let (at, other) = match tried {
            Some(tried) if kept => (tried, Some(at)),
            tried => (at, tried),
        };
        // a side is left behind by a step that crossed the corner, or met by one that failed at it
        self.keep_other_sides(&at, other);

        let sides = step.weights.iter().filter(|weight| **weight > 1e-6).count();
        if let Some(p) = &problem.problem {
            self.judge(p, &at, promised / self.phi, sides);
        }
        let report = kv!("kkt_residual" => self.residual; "radius" => self.radius; "kept" => kept;);
        Ok((stored(state, at), Some(report)))
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
