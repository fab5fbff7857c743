use super::problem::DriveProblem;
use super::sample::{Resampled, Sample, resample};
use super::search::Search;
use crate::drive::Drive;
use crate::error::{Error, Result};
use crate::optimize::sensitivity::Held;
use crate::optimize::{
    Follow, Local, Observer, Solution, Status, minimize_from, minimize_observed, starts,
};
use crate::parameters::Setup;
use crate::units::{self, Digits, Message};
use std::fmt;

/// An active bound or constraint of an optimum. It reads `club.loft at its upper bound`, or as the
/// constraint was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Active {
    /// The varied parameter, or the constraint's expression.
    pub name: String,
    /// The bound, `lower` or `upper`; `None` for a constraint.
    pub end: Option<&'static str>,
}

impl fmt::Display for Active {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.end {
            Some(end) => write!(f, "{} at its {end} bound", self.name),
            None => f.write_str(&self.name),
        }
    }
}

/// The best drive found.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// What was asked.
    pub search: Search,
    /// How the search ended; its objective is the outcome times
    /// [`Sense::sign`](super::Sense::sign).
    pub solution: Solution,
    /// The setup at the optimum.
    pub setup: Setup<f64>,
    /// The drive there; `None` where nothing flew.
    pub drive: Option<Drive<f64>>,
    /// The sample of the ranges that the optimum was compared with; `None` for a local search
    /// alone, and for one that was interrupted.
    pub sample: Option<Sample>,
}

impl Optimum {
    /// The outcome's value at the optimum, SI.
    pub fn value(&self) -> Option<f64> {
        self.solution
            .value
            .map(|value| self.search.sense.sign() * value)
    }

    /// The outcome's gradient at the optimum by the parameters varied, SI.
    pub fn gradient(&self) -> Vec<f64> {
        self.solution
            .gradient
            .iter()
            .map(|slope| self.search.sense.sign() * slope)
            .collect()
    }

    /// How the search ended, in a sentence, in terms of the drive.
    pub fn message(&self) -> Message {
        let of = self.search.of.name();
        match (&self.solution.kink, self.solution.status) {
            (Some(kink), _) => {
                let (parameter, outcome) =
                    (self.search.vary[kink.variable].parameter, self.search.of);
                let (by, si) = (
                    parameter.name,
                    units::per(outcome.quantity().si, parameter.quantity.si),
                );
                let sign = self.search.sense.sign();
                let slope = |slope: Option<f64>| {
                    slope.map_or("not computed (out of range)".into(), |slope| {
                        let slope = sign * slope;
                        format!("{} {si}", units::signed(slope, units::fixed(slope, 4)))
                    })
                };
                let at = self.solution.x[kink.variable];
                Message::from(format!("{of} has a corner at {by} = "))
                    .quantity(
                        parameter.quantity,
                        parameter.unit,
                        at,
                        Digits::Significant(7),
                    )
                    .words(format!(
                        ": d {of}/d {by} is {} below it and {} above",
                        slope(kink.slope_below),
                        slope(kink.slope_above),
                    ))
            }
            (None, Status::Infeasible) => {
                let missed = self
                    .search
                    .subject_to
                    .iter()
                    .zip(&self.solution.constraints);
                let missed: Vec<_> = missed
                    .filter(|(_, constrained)| constrained.violation != 0.0)
                    .map(|(constraint, constrained)| {
                        let (quantity, unit) =
                            (constraint.outcome.quantity(), constraint.outcome.unit());
                        Message::from(format!("{} (its value is ", constraint.expression))
                            .quantity(quantity, unit, constrained.value, Digits::Fine)
                            .words(", outside by ")
                            .quantity(
                                quantity,
                                unit,
                                constrained.violation.abs(),
                                Digits::Difference,
                            )
                            .words(")")
                    })
                    .collect();
                let tried = self.sample.map_or(String::new(), |sample| {
                    format!(
                        " (the search and {} other points in the ranges were tried)",
                        sample.points
                    )
                });
                Message::from(format!(
                    "no point was found that meets the constraints{tried}; the nearest one \
                     violates "
                ))
                .message(Message::joined(missed, " and "))
            }
            (None, Status::Converged) if !self.idle().is_empty() => {
                let (idle, varied) = (
                    self.idle(),
                    self.search.vary.iter().filter(|vary| vary.low < vary.high),
                );
                let alone = format!(
                    "{of} does not depend on the parameters varied here: every drive is equally \
                     good"
                );
                let in_part = || {
                    let found = &self.solution.message;
                    format!(
                        "{found}; {of} does not depend on {}: every value is equally good",
                        idle.join(", ")
                    )
                };
                if idle.len() == varied.count() {
                    alone
                } else {
                    in_part()
                }
                .into()
            }
            (None, Status::Interrupted) if self.solution.value.is_none() => {
                "stopped before a drive that flies was found".into()
            }
            (None, Status::Undefined) => {
                let trials = self.search.options.start_trials as usize;
                let trials = trials + self.sample.map_or(0, |sample| sample.points);
                Message::from(format!(
                    "no drive of the search flies, neither at the start nor at the other points of \
                     the ranges that were tried ({trials}); at \
                     the start: "
                ))
                .message(self.undefined_at_start())
            }
            _ => self.solution.message.clone().into(),
        }
    }

    /// Why the outcome has no value at the start, where a search that found none stays. The
    /// optimizer kept only the words.
    fn undefined_at_start(&self) -> Message {
        let words = self
            .solution
            .undefined_at_start
            .as_deref()
            .unwrap_or_default();
        let again = Drive::new(&self.setup)
            .and_then(|drive| self.search.of.of(&drive))
            .err();
        let again = again
            .map(|error| error.message())
            .filter(|message| message.to_string() == words);
        again.unwrap_or_else(|| words.into())
    }

    /// The bounds and constraints that are active at the optimum.
    pub fn active(&self) -> Vec<Active> {
        let Ok(problem) = DriveProblem::new(&self.setup, &self.search) else {
            return vec![];
        };
        if self.solution.value.is_none() {
            return vec![];
        }
        let held = Held::new(&self.solution, &problem.domain);
        let bound = |i: usize| {
            let end = if self.solution.lower_multipliers[i] > 0.0 {
                "lower"
            } else {
                "upper"
            };
            Active {
                name: self.search.vary[i].parameter.name.into(),
                end: Some(end),
            }
        };
        let is_bounded = |i: &usize| held.variables[*i] && !problem.domain.variables.is_fixed(*i);
        let bounds = (0..self.search.vary.len()).filter(is_bounded).map(bound);
        let limits = held.tight().into_iter();
        let limits = limits.map(|j| Active {
            name: self.search.subject_to[j].expression.clone(),
            end: None,
        });
        bounds.chain(limits).collect()
    }

    /// Whether the outcome does not depend on a varied parameter: within its range it changes, to
    /// second order, by rounding alone.
    pub fn is_idle(&self, i: usize) -> bool {
        const ROUNDING: f64 = 1e-12;
        let width = |i: usize| self.search.vary[i].high - self.search.vary[i].low;
        let Solution {
            gradient,
            hessian,
            value,
            ..
        } = &self.solution;
        let (Some(slope), Some(bends)) = (gradient.get(i), hessian.get(i)) else {
            return false;
        };
        let bends: f64 = bends
            .iter()
            .enumerate()
            .map(|(j, bend)| (bend * width(j)).abs())
            .sum();
        width(i) > 0.0
            && (slope.abs() + bends) * width(i) <= ROUNDING * value.unwrap_or_default().abs()
    }

    /// The varied parameters that the outcome does not depend on.
    fn idle(&self) -> Vec<&'static str> {
        let vary = self.search.vary.iter().enumerate();
        vary.filter(|(i, _)| self.is_idle(*i))
            .map(|(_, vary)| vary.parameter.name)
            .collect()
    }

    /// Where the search began instead, if the start does not fly.
    pub fn moved_start(&self) -> Option<String> {
        let why = self
            .solution
            .undefined_at_start
            .as_ref()
            .filter(|_| !self.solution.begun_at.is_empty())?;
        let begun = self.search.vary.iter().zip(&self.solution.begun_at);
        let begun: Vec<_> = begun
            .map(|(vary, x)| format!("{} {}", vary.parameter.name, vary.parameter.show(Some(*x))))
            .collect();
        Some(format!(
            "the start does not fly ({why}); the search began at {} instead",
            begun.join(", ")
        ))
    }

    /// The status in a word; where the optimizer says undefined, nothing flew.
    pub fn status(&self) -> &'static str {
        match self.solution.status {
            Status::Undefined => "no-flight",
            status => status.name(),
        }
    }
}

/// Finds the parameters that make an outcome largest or smallest: by a local search from the
/// setup's own values, moved into the ranges, and by further ones from points of a [`Sample`] of
/// the ranges that are better than its end.
///
/// ```
/// use longdrive::{Setup, optimize::Observer, study::{Search, Vary, optimum}};
/// let setup = Setup::preset("mae494").unwrap();
/// let vary = ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"];
/// let search = Search {
///     vary: vary.map(|text| Vary::read(&setup, text).unwrap()).to_vec(),
///     ..Search::longest_drive(&setup).unwrap()
/// };
/// let best = optimum(&setup, search, Observer::default()).unwrap();
/// assert!((best.value().unwrap() - 153.333552731).abs() < 1e-8);
/// assert!((best.solution.upper_multipliers[1] - 60.2924949).abs() < 1e-6); // m per radian of attack angle
/// ```
///
/// # Errors
/// [`Error::Nothing`] without parameters to vary, or where every range is a single value;
/// [`Error::SearchRange`] for one that is varied twice; what [`Setup::validate`] refuses.
pub fn optimum(setup: &Setup<f64>, search: Search, observer: Observer) -> Result<Optimum> {
    let problem = posed(setup, &search)?;
    let interrupt = observer.interrupt.clone();
    let end = minimize_observed(
        &problem,
        &problem.domain,
        &problem.start(),
        &search.options,
        observer,
    )?;
    if end.status == Status::Interrupted {
        return found(&problem, search, end, None);
    }
    let again = |start: &[f64]| {
        let observer = Observer {
            interrupt: interrupt.clone(),
            ..Observer::default()
        };
        minimize_observed(&problem, &problem.domain, start, &search.options, observer)
    };
    match resample(&problem, &end, &interrupt, again)? {
        Some(Resampled { sample, solution }) => {
            found(&problem, search, solution.unwrap_or(end), Some(sample))
        }
        None => found(&problem, search, end, None),
    }
}

/// The local optimum that a search from the setup's own values ends at.
///
/// # Errors
/// As [`optimum`].
pub(super) fn local_optimum(
    setup: &Setup<f64>,
    search: Search,
    observer: Observer,
) -> Result<Optimum> {
    let problem = posed(setup, &search)?;
    let solution = minimize_observed(
        &problem,
        &problem.domain,
        &problem.start(),
        &search.options,
        observer,
    )?;
    found(&problem, search, solution, None)
}

/// Local optima, best first, each with the numbers of the starts that ended there.
#[derive(Clone, Debug)]
pub struct Optima {
    /// The optima.
    pub locals: Vec<(Optimum, Vec<usize>)>,
    /// How many starts there were, including the point of the [`Sample`] that the best optimum was
    /// found from, if so.
    pub starts: usize,
}

impl Optima {
    /// The ends of the searches that came to one, best first, each with the numbers of its starts.
    pub fn ended(&self) -> impl Iterator<Item = &(Optimum, Vec<usize>)> {
        self.locals
            .iter()
            .filter(|(best, _)| best.solution.status != Status::Interrupted)
    }

    /// How many searches were stopped from outside before they ended.
    pub fn stopped(&self) -> usize {
        self.starts - self.ended().map(|(_, starts)| starts.len()).sum::<usize>()
    }

    /// How far the searches came, if any was stopped from outside before it ended.
    pub fn interrupted(&self) -> Option<String> {
        stopped_of(self.stopped(), self.starts, || match self.locals.first() {
            None => "stopped before it began".into(),
            Some((best, _)) => best.message().to_string(),
        })
    }

    /// The best of them.
    ///
    /// # Errors
    /// [`Error::Nothing`] where no search was run.
    pub fn best(&self) -> Result<&Optimum> {
        let first = self.locals.first().map(|(best, _)| best);
        first.ok_or(Error::Nothing {
            doing: "search from",
            what: "start",
        })
    }
}

/// How far searches came of which some were stopped from outside; `only` says it where there was
/// one.
pub(super) fn stopped_of(
    stopped: usize,
    all: usize,
    only: impl FnOnce() -> String,
) -> Option<String> {
    (stopped > 0).then(|| match all {
        1 => only(),
        _ => format!(
            "{} of {all} searches ended, and {stopped} were stopped before their end",
            all - stopped
        ),
    })
}

/// Searches from the setup's own values and from starts spread evenly over the ranges, side by
/// side; then, as [`optimum`], from points of a [`Sample`] that are better.
///
/// # Errors
/// As [`optimum`]; [`Error::Nothing`] for no start; more starts than can be spread.
pub fn optima(
    setup: &Setup<f64>,
    search: &Search,
    count: usize,
    follow: &Follow,
) -> Result<Optima> {
    if count == 0 {
        return Err(Error::Nothing {
            doing: "search from",
            what: "start",
        });
    }
    let problem = posed(setup, search)?;
    let starts = starts(&problem.domain, &problem.start(), count)?;
    let mut locals = minimize_from(&problem, &problem.domain, &starts, &search.options, follow)?;
    let is_interrupted = |local: &Local| local.solution.status == Status::Interrupted;
    let mut sample = None;
    let mut count = starts.len();
    if let Some(best) = locals
        .first()
        .filter(|_| !locals.iter().any(is_interrupted))
    {
        let again = |start: &[f64]| {
            let mut observer = Observer {
                interrupt: follow.interrupt.clone(),
                ..Observer::default()
            };
            if let Some(show) = follow.iteration.clone() {
                observer.iteration = Box::new(move |iteration| show(count, iteration));
            }
            minimize_observed(&problem, &problem.domain, start, &search.options, observer)
        };
        if let Some(resampled) = resample(&problem, &best.solution, &follow.interrupt, again)? {
            sample = Some(resampled.sample);
            if let Some(solution) = resampled.solution {
                locals.insert(
                    0,
                    Local {
                        solution,
                        starts: vec![count],
                    },
                );
                count += 1;
            }
        }
    }
    let whole = |Local { solution, starts }| {
        Ok((found(&problem, search.clone(), solution, sample)?, starts))
    };
    Ok(Optima {
        locals: locals.into_iter().map(whole).collect::<Result<_>>()?,
        starts: count,
    })
}

/// The search as a problem, if it makes sense.
pub(super) fn posed(setup: &Setup<f64>, search: &Search) -> Result<DriveProblem> {
    if search.vary.iter().all(|vary| vary.low == vary.high) {
        return Err(Error::Nothing {
            doing: "vary",
            what: "parameter with a range wider than a single value",
        });
    }
    for (i, vary) in search.vary.iter().enumerate() {
        if search.vary[..i]
            .iter()
            .any(|before| before.parameter == vary.parameter)
        {
            return Err(Error::SearchRange {
                name: vary.parameter.name.into(),
                reason: "it is varied twice; give it one range".into(),
            });
        }
    }
    let problem = DriveProblem::new(setup, search)?;
    problem
        .moved(&problem.domain.variables.project(&problem.start()))?
        .validate()?;
    Ok(problem)
}

fn found(
    problem: &DriveProblem,
    search: Search,
    solution: Solution,
    sample: Option<Sample>,
) -> Result<Optimum> {
    let setup = problem.moved(&solution.x)?;
    let drive = if solution.value.is_none() {
        None
    } else {
        Some(Drive::new(&setup)?)
    };
    Ok(Optimum {
        search,
        solution,
        setup,
        drive,
        sample,
    })
}
