use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::{
    Bounds, ConstraintValue, Domain, Evaluation, LocalMinimum, Observers, Problem, Solution,
    Status, minimize_from, starts,
};
use crate::parameters::{LAW, NO_CLUB, Parameter, Setup};
use crate::repeated::first_repeated;
use crate::study::cancellable::stopped_before;
use crate::study::goal::limit_rounding;
use crate::study::optimum::{OptimumSearch, stopped_of};
use crate::study::problem::SearchProblem;
use crate::study::{ConstraintAtEnd, Optimum, Search};
use crate::units::{DisplayUnit, Message};
use std::sync::atomic::{AtomicBool, Ordering};

/// One of several models of impact and flight: the setup with some changes.
#[derive(Clone, Debug)]
pub struct Model {
    /// Text of the changes.
    pub name: String,
    /// Setup with the changes.
    pub setup: Setup<f64>,
    /// Evidence for the model; empty for a model given by the user.
    pub reason: &'static str,
}

/// Default models: known uncertainties of impact and flight as changes of a setup
/// (docs/sources.md).
const DEFAULTS: [([(&str, &str); 1], &str); 4] = [
    ([(LAW, "launch-monitor")], "a launch monitor's predictions"),
    (
        [(LAW, "ferguson")],
        "fitted to radar flights of a ball of 2021, independently of the default law",
    ),
    (
        [("impact.gear_scale", "0.5")],
        "the smaller of two measured gear effects is 0.52",
    ),
    (
        [("impact.gear_scale", "1")],
        "the gear effect of rigid bodies; the larger measured one is up to 0.93",
    ),
];

impl Model {
    /// The setup without changes.
    pub fn as_set_up(setup: &Setup<f64>) -> Self {
        Self {
            name: "as set up".into(),
            setup: *setup,
            reason: "",
        }
    }

    /// Reads changes: `NAME=VALUE,NAME=VALUE`.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a text that is not such a list, and for a change of the club if
    /// the launch is given; the errors of [`Setup::set_all`] and [`Setup::validate`].
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let mut pairs: Vec<(&str, &str)> = vec![];
        for part in text.split(',') {
            let Some((name, value)) = part.split_once('=') else {
                let source = "write NAME=VALUE, several of them with commas between, for example \
                              aero.law=ferguson,impact.gear_scale=0.5";
                return Err(Error::unreadable(
                    format!("`model {}`", text.trim()),
                    source,
                ));
            };
            pairs.push((name.trim(), value.trim()));
        }
        if let Some([_, again]) = first_repeated(&pairs, |a, b| a.0 == b.0) {
            return Err(Error::unreadable(
                format!("`model {}`", text.trim()),
                format!("it gives {} twice; keep one value", pairs[again].0),
            ));
        }
        let mut changed = *setup;
        changed.set_all(pairs.iter().copied())?;
        // the setup may lack a varied parameter: the search validates its start
        if setup.validate().is_ok() {
            changed.validate()?;
        }
        let acts_on_the_club =
            |(name, _): &&(&str, &str)| setup.parameter(name).is_ok_and(Parameter::is_of_strike);
        if let Some((name, _)) = pairs
            .iter()
            .find(acts_on_the_club)
            .filter(|_| setup.launch.is_given())
        {
            return Err(Error::unreadable(
                format!("`model {}`", text.trim()),
                format!("{name} changes nothing: {NO_CLUB}"),
            ));
        }
        Ok(Self {
            name: text.trim().into(),
            setup: changed,
            reason: "",
        })
    }

    /// True if the text of the changes names this parameter.
    pub fn names(&self, parameter: &str) -> bool {
        let mut changes = self.name.split(',');
        changes.any(|change| change.split('=').next().map(str::trim) == Some(parameter))
    }

    /// The setup, and the default models that differ from it.
    ///
    /// # Errors
    /// The errors of [`Setup::set_all`]; a test shows that the built-in changes give none.
    pub fn defaults(setup: &Setup<f64>) -> Result<Vec<Self>> {
        let mut all = vec![Self::as_set_up(setup)];
        for (changes, reason) in DEFAULTS {
            let mut changed = *setup;
            changed.set_all(changes)?;
            // a given launch replaces the impact, so a change of the impact has no effect
            let is_idle = setup.launch.is_given()
                && changes.iter().any(|(name, _)| name.starts_with("impact."));
            if changed != *setup && !is_idle {
                let name = changes
                    .map(|(name, value)| format!("{name}={value}"))
                    .join(",");
                all.push(Self {
                    name,
                    setup: changed,
                    reason,
                });
            }
        }
        Ok(all)
    }
}

/// A model, its best design, and its losses.
#[derive(Clone, Debug)]
pub struct ModelResult {
    /// The model.
    pub model: Model,
    /// The best design of this model alone.
    pub best: Optimum,
    /// Loss of this model with the best design of each model, SI. `None` if the design violates a
    /// constraint with this model, or if the ball does not fly in one of the swings.
    pub losses_of_bests: Vec<Option<f64>>,
    /// The values of the goals at the minimax design, SI: first the objective, then the limited
    /// goals.
    pub goals: Vec<f64>,
    /// The loss with the minimax design, SI.
    pub loss: f64,
    /// Multiplier of the constraint loss ≤ greatest loss. The multipliers of all models sum to 1.
    /// It is 0 if the loss is below the greatest loss.
    pub multiplier: f64,
    /// The loss with the design as set up; `None` if a constraint is violated or the ball does not
    /// fly in one of the swings.
    pub loss_as_set_up: Option<f64>,
}

/// Minimax design: the design whose greatest loss over several models is smallest. Each model has a
/// best design. The loss of any other design with this model is the amount by which its objective
/// is worse.
#[derive(Clone, Debug)]
pub struct Robust {
    /// The search.
    pub search: Search,
    /// The models.
    pub models: Vec<ModelResult>,
    /// Result of the search for the minimax design. Its variables are the design parameters and the
    /// greatest loss t.
    pub solution: Solution,
    /// The minimax design.
    pub design: Vec<f64>,
    /// The first model's setup with the minimax design.
    pub setup: Setup<f64>,
    /// The number of searches for the minimax design.
    pub searches: usize,
    /// Number of interrupted searches.
    pub stopped: usize,
}

impl Robust {
    /// The constraints of a model at the minimax design. The slopes are those by the design
    /// parameters, then by the greatest loss. The gain is the decrease of the greatest loss.
    pub fn constraints(&self, model: usize) -> impl Iterator<Item = ConstraintAtEnd<'_>> {
        let limits = self.search.subject_to.iter().enumerate();
        limits.filter_map(move |(limit, constraint)| {
            // each model's first constraint is its loss
            let row = model * (1 + self.search.subject_to.len()) + 1 + limit;
            let at = self.solution.constraints.get(row)?;
            let at = constraint.exactly(self.models[model].goals[1 + limit], at);
            Some(ConstraintAtEnd {
                constraint,
                at,
                slopes: self.solution.jacobian.get(row)?,
                gain: self.gain(model, limit, &at),
            })
        })
    }

    /// If the lower or the upper bound of a variable is widened by one unit, the greatest loss
    /// decreases by this amount, to first order. It is the multiplier of the bound at the minimax
    /// design, minus a mean of the multipliers of the bound at the best design of each model. The
    /// weights of this mean are the [multipliers](ModelResult::multiplier) of the models. The
    /// subtraction is necessary because the wider bound also improves the best designs.
    pub fn bound_prices(&self, variable: usize) -> [f64; 2] {
        let price = |multipliers: fn(&Solution) -> &[f64]| {
            let of_best = |of: &ModelResult| multipliers(&of.best.solution)[variable];
            let gained = self.models.iter().map(|of| of.multiplier * of_best(of));
            multipliers(&self.solution)[variable] - gained.sum::<f64>()
        };
        [
            price(|found| &found.lower_multipliers),
            price(|found| &found.upper_multipliers),
        ]
    }

    /// [`ConstraintAtEnd::gain`] for constraint `limit` of a model.
    fn gain(&self, model: usize, limit: usize, at: &ConstraintValue) -> f64 {
        let ModelResult {
            best,
            multiplier: share,
            ..
        } = &self.models[model];
        let of_best = best.solution.constraints.get(limit);
        let of_best = of_best.map_or(0.0, |best| best.multiplier);
        match at.multiplier {
            own if self.search.subject_to[limit].is_equation() => own - share * of_best,
            // the best design of the model is at the opposite limit, so the relaxed limit does not
            // improve it
            own if own * of_best < 0.0 => own.abs(),
            own => own.abs() - share * of_best.abs(),
        }
    }

    /// The design that is best for a model, if it is better than the best design that the search of
    /// this model found. The candidates are the best designs of all models and the minimax design.
    fn better_design<'a>(&'a self, of: &ModelResult) -> Option<&'a [f64]> {
        let bests = of.losses_of_bests.iter().zip(&self.models);
        let bests = bests.filter_map(|(loss, other)| Some(((*loss)?, &other.best.solution.x[..])));
        let mut limits = self.search.subject_to.iter().zip(&of.goals[1..]);
        let is_feasible = limits.all(|(limit, value)| limit.is_met(*value));
        let minimax = is_feasible.then_some((of.loss, &self.design[..]));
        let (loss, design) = bests
            .chain(minimax)
            .min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        (loss < 0.0).then_some(design)
    }

    /// The models after new searches for the models that have a better design. `None` if no search
    /// improves the best design of a model.
    fn with_better_bests(&self, follow: &Observers) -> Result<Option<Vec<(Model, Optimum)>>> {
        if self.stopped > 0 {
            return Ok(None);
        }
        let sign = self.search.sense.sign();
        let pairs = self.models.iter();
        let pairs = pairs.map(|of| (of.model.clone(), of.best.clone()));
        let mut models: Vec<(Model, Optimum)> = pairs.collect();
        let mut is_improved = false;
        for (of, (model, best)) in self.models.iter().zip(&mut models) {
            let Some(design) = self.better_design(of) else {
                continue;
            };
            let solver = OptimumSearch::comparable(&best.start, &best.search, follow)?;
            let again = solver.local_optimum(design, follow.of_search(0), best.sample)?;
            if again.solution.status == Status::Interrupted {
                return Err(not_found(model, again.status(), again.message()));
            }
            let [old, new] = [&*best, &again]
                .map(|optimum| optimum.value().map_or(f64::INFINITY, |value| sign * value));
            let is_better = new < old - rounding(&self.search, old);
            if again.is_converged() && is_better {
                *best = again;
                is_improved = true;
            }
        }
        Ok(is_improved.then_some(models))
    }

    /// The greatest loss.
    pub fn greatest(&self) -> f64 {
        self.models
            .iter()
            .map(|of| of.loss)
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// True if no search was interrupted and the best search converged.
    pub fn is_found(&self) -> bool {
        self.solution.status == Status::Converged && self.stopped == 0
    }

    /// Message on the progress of the searches, if any was interrupted.
    pub fn interrupted(&self) -> Option<String> {
        stopped_of(self.stopped, self.searches, || {
            self.solution.message.clone()
        })
    }

    /// Name of the status.
    pub fn status(&self) -> &'static str {
        if self.stopped > 0 {
            Status::Interrupted.name()
        } else {
            self.solution.status.name()
        }
    }
}

/// The minimax design of several models (see [`Robust`]).
///
/// First, a search finds the best design of each model k, which has the value f*ₖ of the goal fₖ.
/// Then the minimax search minimizes t, subject to fₖ(x) − f*ₖ ≤ t for every model k. Goals are
/// minimized here, so a goal to be maximized is negated. The problem is smooth, with exact
/// derivatives. The constraints hold for all models.
///
/// Each search has `count` starts: the setup's own design, and others spread evenly over the
/// ranges. The minimax search also starts at the best design of each model and at their mean. For
/// one drive, the search for the best design of a model also has a sample of the ranges, as in
/// [`optima`](crate::study::optima). If another design is better for a model than its best design,
/// the model is searched again from there, and the minimax search is repeated.
///
/// # Errors
/// [`Error::Unreadable`] for fewer than two models; [`Error::NotConverged`] if the best design of a
/// model is not found, or if the minimax search is interrupted before it begins; the errors of
/// [`optima`](crate::study::optima).
pub fn robust(
    models: Vec<Model>,
    search: Search,
    count: usize,
    follow: &Observers,
) -> Result<Robust> {
    if models.len() < 2 {
        let reason = "one design for several models needs two models or more; give `model` once \
                      for each model other than the setup";
        return Err(Error::unreadable("`model`", reason));
    }
    let mut found = minimax(
        best_of_each(models, &search, count, follow)?,
        search,
        count,
        follow,
    )?;
    while let Some(models) = found.with_better_bests(follow)? {
        found = minimax(models, found.search, count, follow)?;
    }
    Ok(found)
}

/// The minimax search for models with known best designs.
fn minimax(
    models: Vec<(Model, Optimum)>,
    search: Search,
    count: usize,
    follow: &Observers,
) -> Result<Robust> {
    let losses = Losses::new(&search, &models, follow)?;
    let designs: Vec<&[f64]> = models
        .iter()
        .map(|(_, best)| &best.solution.x[..])
        .collect();
    let matrix = losses.matrix(&designs);
    let starts = losses.starts(&designs, count)?;
    let is_stopped = || follow.interrupt.load(Ordering::Relaxed);
    if starts.is_empty() && !is_stopped() {
        let message = "the search for one design for all models has no start: no design that \
                       was tried lets the ball fly in every swing with every model (tried: the \
                       best design of each model, their mean, the setup's own design, and designs \
                       spread over the ranges); vary fewer parameters, or over smaller ranges";
        return Err(Error::NotConverged {
            status: "no-flight",
            message: message.into(),
        });
    }
    let as_set_up = losses.as_set_up();
    if is_stopped() {
        return Err(stopped_before(
            "the search for one design for all models began",
        ));
    }
    let ends = minimize_from(&losses, &losses.domain()?, &starts, &search.options, follow)?;
    let stopped = ends
        .iter()
        .filter(|end| end.solution.status == Status::Interrupted)
        .map(|end| end.starts.len())
        .sum();
    let solution = least_loss(ends)?;
    // the first constraint of each model limits its loss
    let of_losses = solution
        .constraints
        .iter()
        .step_by(1 + search.subject_to.len());
    let multipliers: Vec<f64> = of_losses.map(|at| at.multiplier.max(0.0)).collect();
    let design = solution.x[..search.vary.len()].to_vec();
    let setup = losses.problems[0].setup_at(&design)?;
    let mut results = vec![];
    for (k, (model, best)) in models.into_iter().enumerate() {
        // also after an interrupt
        let goals = losses.problems[k].goals_at(&design, &AtomicBool::new(false))?;
        results.push(ModelResult {
            model,
            best,
            losses_of_bests: matrix[k].clone(),
            loss: losses.loss(k, &goals),
            goals,
            multiplier: multipliers.get(k).copied().unwrap_or_default(),
            loss_as_set_up: as_set_up[k],
        });
    }
    Ok(Robust {
        setup,
        models: results,
        solution,
        design,
        searches: starts.len(),
        stopped,
        search,
    })
}

fn best_of_each(
    models: Vec<Model>,
    search: &Search,
    count: usize,
    follow: &Observers,
) -> Result<Vec<(Model, Optimum)>> {
    let best = |model: Model| {
        let solver = OptimumSearch::comparable(&model.setup, search, follow)?;
        let optima = solver.optima(count, follow)?;
        if let Some(interrupted) = optima.interrupted() {
            let status = Status::Interrupted.name();
            return Err(not_found(&model, status, interrupted.into()));
        }
        let best = optima.best;
        if !best.is_converged() {
            return Err(not_found(&model, best.status(), best.message()));
        }
        Ok((model, best))
    };
    models.into_iter().map(best).collect()
}

/// Rounding of a loss of a model whose best design has this value.
fn rounding(search: &Search, least: f64) -> f64 {
    limit_rounding(least, (&search.of).into())
}

/// The error for a model whose best design was not found.
fn not_found(model: &Model, status: &'static str, message: Message) -> Error {
    Error::NotConverged {
        status,
        message: format!("with the model '{}': {message}", model.name).into(),
    }
}

/// The solution of the first of `ends`, which is the best end.
///
/// # Errors
/// [`Error::NotConverged`] if no search reached a point at which the goals have values.
fn least_loss(ends: Vec<LocalMinimum>) -> Result<Solution> {
    let best = ends.into_iter().next().ok_or(Error::Nothing {
        doing: "search from",
        what: "start",
    })?;
    let solution = best.solution;
    if solution.value.is_some() {
        return Ok(solution);
    }
    Err(Error::NotConverged {
        status: solution.status.name(),
        message: solution.message.into(),
    })
}

/// The loss of each model k as a function of the design x: fₖ(x) − f*ₖ, with the minimized goal fₖ
/// and its smallest value f*ₖ.
///
/// The [`Problem`] has the variables (x, t) and the objective t. Its constraints are, for each
/// model, the loss minus t, then the limited goals.
struct Losses<'a> {
    search: &'a Search,
    problems: Vec<SearchProblem>,
    /// f*ₖ of each model.
    least: Vec<f64>,
    /// f*ₖ of each model, computed with the smoothed goal of the model's own search.
    smoothed_least: Vec<f64>,
}

impl<'a> Losses<'a> {
    fn new(search: &'a Search, models: &[(Model, Optimum)], follow: &Observers) -> Result<Self> {
        let sign = search.sense.sign();
        let problem = |(model, _): &(Model, Optimum)| {
            SearchProblem::new(&model.setup, search.clone(), &follow.interrupt)
        };
        let least = |(_, best): &(Model, Optimum)| sign * best.value().unwrap_or(f64::NAN);
        Ok(Self {
            search,
            problems: models.iter().map(problem).collect::<Result<_>>()?,
            least: models.iter().map(least).collect(),
            smoothed_least: models
                .iter()
                .map(|(_, best)| best.solution.value.unwrap_or(f64::NAN))
                .collect(),
        })
    }

    /// The loss of a model whose goals have these values. A negative loss within rounding is 0.
    fn loss(&self, model: usize, goals: &[f64]) -> f64 {
        let loss = self.search.sense.sign() * goals[0] - self.least[model];
        let rounding = rounding(self.search, self.least[model]);
        if (-rounding..0.0).contains(&loss) {
            0.0
        } else {
            loss
        }
    }

    /// The loss of a model whose goals have these values; `None` if the values violate a
    /// constraint.
    fn feasible_loss(&self, model: usize, goals: &[f64]) -> Option<f64> {
        let mut limits = self.search.subject_to.iter().zip(&goals[1..]);
        let is_feasible = limits.all(|(limit, value)| limit.is_met(*value));
        is_feasible.then(|| self.loss(model, goals))
    }

    /// The loss of each model (row) with each design (column); `None` if a constraint is violated
    /// or the ball does not fly in one of the swings.
    fn matrix(&self, designs: &[&[f64]]) -> Vec<Vec<Option<f64>>> {
        let at = |model: usize, x: &[f64]| {
            let problem = &self.problems[model];
            let goals = problem.goals_at(x, &problem.stop).ok()?;
            self.feasible_loss(model, &goals)
        };
        (0..self.problems.len())
            .map(|model| designs.iter().map(|x| at(model, x)).collect())
            .collect()
    }

    /// The loss of each model with the design as set up; `None` as in [`matrix`](Self::matrix).
    fn as_set_up(&self) -> Vec<Option<f64>> {
        let own = |model: usize| {
            let goals = self.problems[model].goals_as_set_up().ok()?;
            self.feasible_loss(model, &goals)
        };
        (0..self.problems.len()).map(own).collect()
    }

    /// The starts (x, t) of the search. The designs x are `designs`, their mean, the setup's own
    /// design and points spread over the ranges. A design for which a goal has no value is left
    /// out. t exceeds the greatest loss of x by at least a tenth of a display unit.
    fn starts(&self, designs: &[&[f64]], count: usize) -> Result<Vec<Vec<f64>>> {
        let margin = 0.1 * DisplayUnit::from(&self.search.of).size();
        let models = self.problems.len();
        let first = &self.problems[0];
        let mean: Vec<f64> = (0..self.search.vary.len())
            .map(|i| designs.iter().map(|x| x[i]).sum::<f64>() / designs.len() as f64)
            .collect();
        let spread = starts(&first.domain, &first.start(), count)?;
        let loss = |model: usize, x: &[f64]| {
            let problem = &self.problems[model];
            let goals = problem.goals_at(x, &problem.stop).ok()?;
            Some(self.loss(model, &goals))
        };
        let start = |x: &[f64]| {
            let mut losses = (0..models).map(|model| loss(model, x));
            let greatest = losses.try_fold(0.0_f64, |most, loss| Some(most.max(loss?)))?;
            Some([x, &[greatest + greatest.max(margin)]].concat())
        };
        let spread = spread.iter().map(Vec::as_slice);
        let all = designs.iter().copied().chain([&mean[..]]).chain(spread);
        Ok(all.filter_map(start).collect())
    }

    fn domain(&self) -> Result<Domain> {
        let Bounds { mut low, mut high } = self.problems[0].domain.variables.clone();
        low.push(f64::NEG_INFINITY);
        high.push(f64::INFINITY);
        let of = |problem: &SearchProblem| {
            let Bounds { low, high } = problem.domain.constraints.clone();
            let low = [f64::NEG_INFINITY].into_iter().chain(low);
            low.zip([0.0].into_iter().chain(high)).collect::<Vec<_>>()
        };
        let (least, most) = self.problems.iter().flat_map(of).unzip();
        Domain::new(low, high)?.with_constraints(least, most)
    }
}

impl Problem for Losses<'_> {
    fn evaluate(&self, xt: &[f64]) -> std::result::Result<Evaluation, String> {
        let n = xt.len() - 1;
        // converts a function of x to a function of (x, t)
        let lifted = |mut f: Taylor| {
            f.gradient.push(0.0);
            f.hessian.iter_mut().for_each(|row| row.push(0.0));
            f.hessian.push(vec![0.0; n + 1]);
            f
        };
        let mut greatest = Taylor {
            value: xt[n],
            ..Taylor::zero(n + 1, n + 1)
        };
        greatest.gradient[n] = 1.0;
        let mut constraints = vec![];
        for (problem, least) in self.problems.iter().zip(&self.smoothed_least) {
            let Evaluation {
                objective,
                constraints: limited,
            } = problem.evaluate(&xt[..n])?;
            let mut loss = lifted(objective);
            loss.value -= least + xt[n];
            loss.gradient[n] = -1.0;
            constraints.push(loss);
            constraints.extend(limited.into_iter().map(lifted));
        }
        Ok(Evaluation {
            objective: greatest,
            constraints,
        })
    }
}
