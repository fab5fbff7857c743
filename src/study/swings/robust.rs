use super::optimum::{SwingsOptimum, SwingsSearch, posed, swings_optima};
use super::problem::SwingsProblem;
use super::scenarios::Scenarios;
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::{
    Bounds, Constrained, Domain, Evaluation, Follow, Problem, Solution, Status, minimize_from,
    starts,
};
use crate::parameters::{LAW, NO_CLUB, Parameter, Setup};
use crate::study::optimum::stopped_of;
use crate::study::stoppable::stopped;
use std::sync::atomic::{AtomicBool, Ordering};

/// One of several ways in which drives may be computed: the setup with some changes.
#[derive(Clone, Debug)]
pub struct Model {
    /// What is changed, as it was given.
    pub name: String,
    /// The setup with it.
    pub setup: Setup<f64>,
    /// Why it is one that may be true; empty where it was given.
    pub reason: &'static str,
}

/// What is not known of the impact and the flight, as usual changes of a setup (docs/sources.md).
const USUAL: [([(&str, &str); 1], &str); 4] = [
    ([(LAW, "launch-monitor")], "what a launch monitor predicts"),
    (
        [(LAW, "ferguson")],
        "radar flights of a ball of 2021: the independent alternative",
    ),
    (
        [("impact.friction", "0.3")],
        "the least friction of a driver's face that is published, 0.3 to 0.5",
    ),
    (
        [("impact.gear_scale", "0.5")],
        "measured gear effects differ by a factor of two",
    ),
];

impl Model {
    /// The setup as it is.
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
    /// [`Error::Unreadable`]; as [`Setup::set_all`]; what [`Setup::validate`] refuses.
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let pair = |part: &'_ str| {
            part.split_once('=')
                .map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()))
        };
        let pairs = text.split(',').map(pair).collect::<Option<Vec<_>>>();
        let pairs = pairs.ok_or_else(|| Error::Unreadable {
            name: format!("`model` {}", text.trim()),
            source: "write NAME=VALUE, several of them with commas between, for example \
                     aero.law=ferguson,impact.gear_scale=0.5"
                .into(),
        })?;
        let pairs: Vec<(&str, &str)> = pairs
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let mut changed = *setup;
        changed.set_all(pairs.iter().copied())?;
        changed.validate()?;
        let acts_on_the_club =
            |(name, _): &&(&str, &str)| setup.parameter(name).is_ok_and(Parameter::is_of_strike);
        if let Some((name, _)) = pairs
            .iter()
            .find(acts_on_the_club)
            .filter(|_| setup.launch.is_given())
        {
            let (model, source) = (
                text.trim(),
                format!("{name} changes nothing: {NO_CLUB}").into(),
            );
            return Err(Error::Unreadable {
                name: format!("`model {model}`"),
                source,
            });
        }
        Ok(Self {
            name: text.trim().into(),
            setup: changed,
            reason: "",
        })
    }

    /// The setup as it is and with each of the usual changes, without those that change nothing.
    ///
    /// # Errors
    /// None that a test does not rule out.
    pub fn usual(setup: &Setup<f64>) -> Result<Vec<Self>> {
        let mut all = vec![Self::as_set_up(setup)];
        for (changes, reason) in USUAL {
            let mut changed = *setup;
            changed.set_all(changes)?;
            // a launch that is given has no impact
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

/// The design whose greatest loss over several models is the smallest.
#[derive(Clone, Debug)]
pub struct Robust {
    /// What was asked.
    pub search: SwingsSearch,
    /// The models, each with the design that is best for it alone.
    pub models: Vec<(Model, SwingsOptimum)>,
    /// What each model (a row) loses at the best design of each (a column), beside its own best;
    /// `None` where a limit is not met or a swing does not fly.
    pub matrix: Vec<Vec<Option<f64>>>,
    /// How the search for the smallest greatest loss ended. Its variables are those of the design
    /// and the greatest loss t.
    pub solution: Solution,
    /// The design.
    pub design: Vec<f64>,
    /// The first model's setup with this design.
    pub setup: Setup<f64>,
    /// The goals of each model with this design: the objective, then what is limited.
    pub goals: Vec<Vec<f64>>,
    /// What each model loses with this design.
    pub losses: Vec<f64>,
    /// How much each model limits the design: the multiplier of its loss. They add up to 1, and are
    /// 0 for models that lose less than the greatest loss.
    pub shares: Vec<f64>,
    /// What each model loses with the design as set up, `None` where a limit is not met or a swing
    /// does not fly.
    pub as_set_up: Vec<Option<f64>>,
    /// How many searches for the smallest greatest loss there were.
    pub searches: usize,
    /// How many of them were stopped from outside before they ended.
    pub stopped: usize,
}

impl Robust {
    /// Each limit with the model that it is of, where the search ended: the number of the model,
    /// that of the limit, its value by the goal's definition, its multiplier by the search, and its
    /// gradient by the design and the greatest loss.
    pub fn limits(&self) -> impl Iterator<Item = (usize, usize, Constrained, &[f64])> {
        // each model's first constraint is its loss
        let each = 1 + self.search.subject_to.len();
        let all = self
            .solution
            .constraints
            .iter()
            .zip(&self.solution.jacobian)
            .enumerate();
        let limits = all.filter(move |(i, _)| i % each > 0);
        limits.map(move |(i, (at, slopes))| {
            let (model, limit) = (i / each, i % each - 1);
            let value = self.goals[model][1 + limit];
            let violation = self.search.subject_to[limit].violation(value);
            (
                model,
                limit,
                Constrained {
                    value,
                    violation,
                    ..*at
                },
                &slopes[..],
            )
        })
    }

    /// What the greatest loss falls by for each unit that the lower bound of a variable is lowered,
    /// and that its upper one is raised: their multipliers, less what the best design of each model
    /// alone gains by it, as far as that model decides.
    pub fn bound_prices(&self, variable: usize) -> [f64; 2] {
        let price = |multipliers: fn(&Solution) -> &[f64]| {
            let of_bests = self.shares.iter().zip(&self.models);
            let gained =
                of_bests.map(|(share, (_, best))| share * multipliers(&best.solution)[variable]);
            multipliers(&self.solution)[variable] - gained.sum::<f64>()
        };
        [
            price(|found| &found.lower_multipliers),
            price(|found| &found.upper_multipliers),
        ]
    }

    /// The same of a limit of a model, as [`limits`](Self::limits) numbers them, for each unit that
    /// it is relaxed; of an equation, that it is raised.
    pub fn limit_price(&self, model: usize, limit: usize, at: &Constrained) -> f64 {
        let is_equation = self.search.subject_to[limit].low == self.search.subject_to[limit].high;
        let of_best = self.models[model]
            .1
            .solution
            .constraints
            .get(limit)
            .map_or(0.0, |best| best.multiplier);
        match at.multiplier {
            own if is_equation => own - self.shares[model] * of_best,
            // of two limits, the best design keeps to the other one
            own if own * of_best < 0.0 => own.abs(),
            own => own.abs() - self.shares[model] * of_best.abs(),
        }
    }

    /// The greatest loss.
    pub fn greatest(&self) -> f64 {
        self.losses
            .iter()
            .copied()
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether all searches ended, the best of them at an optimum.
    pub fn is_found(&self) -> bool {
        self.solution.status == Status::Converged && self.stopped == 0
    }

    /// How far the searches came, if any was stopped from outside before it ended.
    pub fn interrupted(&self) -> Option<String> {
        stopped_of(self.stopped, self.searches, || {
            self.solution.message.clone()
        })
    }

    /// The status in a word.
    pub fn status(&self) -> &'static str {
        if self.stopped > 0 {
            Status::Interrupted.name()
        } else {
            self.solution.status.name()
        }
    }
}

/// The design that loses least, beside the best design for each model, with the model that loses
/// most: min t subject to f*ₖ − fₖ(x) ≤ t for every model k, which is smooth, with exact
/// derivatives. Limits hold for all models. Each search is from `count` starts: the setup's own
/// design and others spread evenly over the ranges; that for t also from the best design of each
/// model and their mean.
///
/// # Errors
/// [`Error::Unreadable`] for fewer than two models; [`Error::NotConverged`] where the best design
/// of a model is not found, or the search for all of them is stopped before it has begun; as
/// [`swings_optima`].
pub fn robust(
    models: Vec<Model>,
    search: SwingsSearch,
    scenarios: &Scenarios,
    count: usize,
    follow: &Follow,
) -> Result<Robust> {
    if models.len() < 2 {
        let source =
            "one design for several models needs two or more; give `model` once for each beside \
             the setup"
                .into();
        return Err(Error::Unreadable {
            name: "`model`".into(),
            source,
        });
    }
    let mut found = vec![];
    for model in models {
        let best = swings_optima(
            &model.setup,
            search.clone(),
            scenarios.clone(),
            count,
            follow,
        )?;
        if let Some(interrupted) = best.interrupted() {
            let message = format!("with the model '{}': {interrupted}", model.name).into();
            return Err(Error::NotConverged {
                status: Status::Interrupted.name(),
                message,
            });
        }
        if best.solution.status != Status::Converged {
            let message = format!("with the model '{}': {}", model.name, best.message()).into();
            return Err(Error::NotConverged {
                status: best.status(),
                message,
            });
        }
        found.push((model, best));
    }
    let problems = found
        .iter()
        .map(|(model, _)| posed(&model.setup, &search, scenarios.clone(), &follow.interrupt));
    let problems = problems.collect::<Result<Vec<_>>>()?;
    let sign = search.sense.sign();
    let least: Vec<f64> = found
        .iter()
        .map(|(_, best)| sign * best.value().unwrap_or(f64::NAN))
        .collect();
    let loss = |k: usize, x: &[f64]| {
        problems[k]
            .values(x)
            .ok()
            .map(|values| sign * values[0] - least[k])
    };
    let designs: Vec<&[f64]> = found.iter().map(|(_, best)| &best.solution.x[..]).collect();
    // a design that breaks a limit is no rival
    let keeps = |values: &[f64]| {
        search
            .subject_to
            .iter()
            .zip(values)
            .all(|(limit, value)| limit.is_met(*value))
    };
    let rival = |k: usize, values: &[f64]| keeps(&values[1..]).then(|| sign * values[0] - least[k]);
    let at = |k: usize, x: &[f64]| rival(k, &problems[k].values(x).ok()?);
    let matrix: Vec<Vec<Option<f64>>> = (0..problems.len())
        .map(|k| designs.iter().map(|x| at(k, x)).collect())
        .collect();
    // from each model's own design, their mean, the setup's own and others, well inside of the
    // greatest loss there: at least a tenth of a unit
    let unit = search.of.quantity.size_of(search.of.unit).unwrap_or(1.0);
    let of = designs.len() as f64;
    let mean = (0..search.vary.len())
        .map(|i| designs.iter().map(|x| x[i]).sum::<f64>() / of)
        .collect::<Vec<_>>();
    let spread = starts(&problems[0].domain, &problems[0].start(), count.max(1))?;
    let starts = designs
        .iter()
        .copied()
        .chain([&mean[..]])
        .chain(spread.iter().map(|x| &x[..]))
        .filter_map(|x| {
            let greatest =
                (0..problems.len()).try_fold(0.0_f64, |most, k| Some(most.max(loss(k, x)?)))?;
            Some(
                x.iter()
                    .copied()
                    .chain([greatest + greatest.max(0.1 * unit)])
                    .collect::<Vec<_>>(),
            )
        });
    let starts: Vec<_> = starts.collect();
    if starts.is_empty() && !follow.interrupt.load(Ordering::Relaxed) {
        let message =
            "with the best design of each model some swing of another does not fly; vary less"
                .into();
        return Err(Error::NotConverged {
            status: "no-flight",
            message,
        });
    }
    let own = |k: usize| problems[k].as_set_up().ok();
    let as_set_up = (0..problems.len()).map(|k| rival(k, &own(k)?)).collect();
    if follow.interrupt.load(Ordering::Relaxed) {
        return Err(stopped("the search for one design for all models began"));
    }
    let smoothed = found
        .iter()
        .map(|(_, best)| best.solution.value.unwrap_or(f64::NAN))
        .collect();
    let greatest = GreatestLoss {
        problems: &problems,
        least: smoothed,
    };
    let ends = minimize_from(
        &greatest,
        &greatest.domain()?,
        &starts,
        &search.options,
        follow,
    )?;
    let stopped = ends
        .iter()
        .filter(|end| end.solution.status == Status::Interrupted)
        .map(|end| end.starts.len())
        .sum();
    let searches = starts.len();
    let solution = ends
        .into_iter()
        .next()
        .ok_or(Error::Nothing {
            doing: "search from",
            what: "start",
        })?
        .solution;
    if solution.value.is_none() {
        let message = solution.message.into();
        return Err(Error::NotConverged {
            status: solution.status.name(),
            message,
        });
    }
    let design = solution.x[..search.vary.len()].to_vec();
    // also after a stop: what was found until then is told
    let never = AtomicBool::new(false);
    let goals = problems
        .iter()
        .map(|problem| problem.values_until(&design, &never))
        .collect::<Result<Vec<_>>>()?;
    let losses = goals
        .iter()
        .zip(&least)
        .map(|(values, least)| sign * values[0] - least)
        .collect();
    // each model's first constraint is its loss less t
    let each = 1 + search.subject_to.len();
    let shares = solution
        .constraints
        .iter()
        .step_by(each)
        .map(|at| at.multiplier.max(0.0))
        .collect();
    let setup = problems[0].moved(&design)?;
    Ok(Robust {
        search,
        models: found,
        matrix,
        solution,
        design,
        setup,
        goals,
        losses,
        shares,
        as_set_up,
        searches,
        stopped,
    })
}

/// t, and for each model its loss less t and what is limited, as functions of (x, t).
struct GreatestLoss<'a> {
    problems: &'a [SwingsProblem],
    /// The least value of each model that its own search found, with smoothed edges as here.
    least: Vec<f64>,
}

impl GreatestLoss<'_> {
    fn domain(&self) -> Result<Domain> {
        let Bounds { mut low, mut high } = self.problems[0].domain.variables.clone();
        low.push(f64::NEG_INFINITY);
        high.push(f64::INFINITY);
        let of = |problem: &SwingsProblem| {
            let Bounds { low, high } = problem.domain.constraints.clone();
            let low = [f64::NEG_INFINITY].into_iter().chain(low);
            low.zip([0.0].into_iter().chain(high)).collect::<Vec<_>>()
        };
        let (least, most) = self.problems.iter().flat_map(of).unzip();
        Domain::new(low, high)?.subject_to(least, most)
    }
}

impl Problem for GreatestLoss<'_> {
    fn evaluate(&self, xt: &[f64]) -> std::result::Result<Evaluation, String> {
        let n = xt.len() - 1;
        // a function of x alone, with t as a variable more
        let lifted = |mut f: Taylor| {
            f.gradient.push(0.0);
            f.hessian.iter_mut().for_each(|row| row.push(0.0));
            f.hessian.push(vec![0.0; n + 1]);
            f
        };
        let mut greatest = Taylor {
            value: xt[n],
            gradient: vec![0.0; n + 1],
            hessian: vec![vec![0.0; n + 1]; n + 1],
        };
        greatest.gradient[n] = 1.0;
        let mut constraints = vec![];
        for (problem, least) in self.problems.iter().zip(&self.least) {
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
