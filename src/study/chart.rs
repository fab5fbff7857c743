//! The optimum as a function of a parameter, by continuation.

use super::Vary;
use super::goal::limit_rounding;
use super::optimum::{Optimum, OptimumSearch, optimum};
use super::search::Search;
use super::sensitivity::sensitivity;
use super::verdict::{Active, only_in};
use crate::drive::{CheckScope, ExceededCount, ExceededLimits};
use crate::error::{Error, Result};
use crate::optimize::continuation::{
    AdaptiveStep, LONGEST, RADIUS, TOO_FAR, locate_change, predicted, relative_distance,
};
use crate::optimize::{Iteration, Observer, Options};
use crate::parameters::Setup;
use crate::units::Message;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Optima along a parameter.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The parameter and its range.
    pub along: Vary,
    /// The optima, in ascending order of the parameter.
    pub points: Vec<ChartPoint>,
    /// Reason why the chart starts after the low end of the range, if it does.
    pub begun: Option<Message>,
    /// Reason why the chart ends before the high end of the range, if it does.
    pub ended: Option<Message>,
    /// True if the chart was interrupted.
    pub interrupted: bool,
}

/// The optimum at one value of the parameter.
#[derive(Clone, Debug)]
pub struct ChartPoint {
    /// The parameter's value, SI.
    pub at: f64,
    /// The optimum.
    pub best: Optimum,
    /// Active bounds and constraints.
    pub active: Vec<Active>,
    /// Change of the active set, or a jump to another local optimum, if either occurs at this
    /// point.
    pub event: Option<ChartEvent>,
}

/// An event on a chart, for example `swing.attack_angle at its upper bound begins, apex_height <=
/// 30 yd ends`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChartEvent {
    /// The active set changes.
    Changed {
        /// Newly active bounds and constraints.
        begins: Vec<Active>,
        /// Bounds and constraints that are no longer active.
        ends: Vec<Active>,
    },
    /// Another local optimum becomes better.
    Jump,
}

impl ChartEvent {
    /// The change from the active set `before` to `after`.
    pub(super) fn between(before: &[Active], after: &[Active]) -> Self {
        Self::Changed {
            begins: only_in(after, before),
            ends: only_in(before, after),
        }
    }

    /// The event in words, such as "club.loft at its upper bound from here on"; `name` formats
    /// each bound and constraint.
    pub fn words(&self, name: impl Fn(&Active) -> String) -> String {
        match self {
            Self::Changed { begins, ends } => {
                let begins = begins
                    .iter()
                    .map(|active| format!("{} from here on", name(active)));
                let ends = ends
                    .iter()
                    .map(|active| format!("{} no longer", name(active)));
                begins.chain(ends).collect::<Vec<_>>().join(", ")
            }
            Self::Jump => "the optimum jumps: the local optimum followed so far ends here".into(),
        }
    }
}

impl std::fmt::Display for ChartEvent {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.words(Active::to_string))
    }
}

impl Chart {
    /// Warnings about optima outside the validity limits and about strikes off the face, each with
    /// the affected parts of the range.
    pub fn warnings(&self) -> Vec<Message> {
        let Some(first) = self.points.first() else {
            return vec![];
        };
        let exceeded = |ChartPoint { at, best, .. }: &ChartPoint| {
            let drive = best.drive.as_ref()?;
            let of = best.search.outcomes();
            Some((
                *at,
                drive.exceeded_limits(
                    &best.setup,
                    CheckScope::Flight,
                    &of,
                    &AtomicBool::new(false),
                ),
            ))
        };
        let exceeded: Vec<_> = self.points.iter().filter_map(exceeded).collect();
        let mut count = ExceededCount::default();
        exceeded.iter().for_each(|(_, limits)| count.add(*limits));
        let warnings = count.warnings(
            &first.best.setup.law,
            ["optimum", "optima"],
            CheckScope::Flight,
        );
        // `warnings` is in this order, without the limits that no optimum exceeds
        let is_exceeded: [fn(&ExceededLimits) -> bool; 3] = [
            |limits| limits.law,
            |limits| limits.face,
            |limits| limits.flat,
        ];
        let parts = is_exceeded.map(|is_exceeded| {
            let points = exceeded.iter();
            intervals(points.map(|(at, limits)| (*at, is_exceeded(limits))))
        });
        let parts = parts.iter().filter(|parts| !parts.is_empty());
        let of_drives = warnings
            .into_iter()
            .zip(parts)
            .map(|(warning, parts)| with_intervals(warning, parts, &self.along));
        let search = &first.best.search;
        let of_side = search.sense.side_warning(&search.of);
        of_side.into_iter().chain(of_drives).collect()
    }

    /// The loss of the followed optimum, compared with `own`, another optimum of the same search at
    /// one value of the parameter. `None` if both are equal up to the rounding of a search, or if
    /// the chart does not contain this value.
    pub fn loss_at(&self, own: &Optimum) -> Option<f64> {
        let at = own.setup.value(self.along.parameter)?;
        let [first, last] = [self.points.first()?, self.points.last()?];
        let distance = |point: &&ChartPoint| (point.at - at).abs();
        let nearest = self.points.iter();
        let nearest = nearest.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        if !(first.at..=last.at).contains(&at) {
            return None;
        }
        let follower = Follower {
            setup: &own.setup,
            search: &own.search,
            along: self.along,
            observer: &ChartObserver::default(),
        };
        let (followed, apart) = follower.next(nearest, at).ok()?;
        let (followed, value) = (followed.best.value()?, own.value()?);
        let rounding = limit_rounding(value, own.search.outcome().into());
        let lost = own.search.sense.sign() * (followed - value);
        (apart <= TOO_FAR && lost.abs() > rounding).then_some(lost)
    }
}

/// Intervals in which a condition holds, from points in ascending order.
fn intervals(points: impl Iterator<Item = (f64, bool)>) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = vec![];
    let mut held_before = false;
    for (at, holds) in points {
        match all.last_mut() {
            Some([_, end]) if holds && held_before => *end = at,
            _ if holds => all.push([at; 2]),
            _ => {}
        }
        held_before = holds;
    }
    all
}

/// Appends intervals of a parameter to a warning.
fn with_intervals(warning: Message, intervals: &[[f64; 2]], along: &Vary) -> Message {
    let parameter = along.parameter;
    let begun = warning.words(format!("; {} =", parameter.name));
    let all = intervals.iter().enumerate();
    all.fold(begun, |text, (i, [low, high])| {
        let first = parameter.append_value(text.words(if i == 0 { " " } else { ", and " }), *low);
        if low == high {
            first
        } else {
            parameter.append_value(first.words(" to "), *high)
        }
    })
}

/// Tolerance of event locations, relative to the range.
const LOCATED: f64 = 1e-10;

/// Callback that receives one value of a chart.
type ChartCallback<T> = Rc<dyn Fn(&T)>;

/// Callbacks and cancellation flag of a chart.
#[derive(Clone, Default)]
pub struct ChartObserver {
    /// Cancellation flag: once true, the chart ends with its points so far, even within a search.
    pub interrupt: Arc<AtomicBool>,
    /// Receives each parameter value at which the chart tries to begin: the low end of the range,
    /// then further values if the low end has no optimum.
    pub beginning: Option<Rc<dyn Fn(f64)>>,
    /// Receives every iteration of every search.
    pub iteration: Option<ChartCallback<Iteration>>,
    /// Receives every point of the continuation.
    pub point: Option<ChartCallback<ChartPoint>>,
}

impl ChartObserver {
    fn search(&self) -> Observer {
        let shown = self.iteration.clone();
        let iteration = move |iteration: &Iteration| {
            if let Some(shown) = &shown {
                shown(iteration);
            }
        };
        Observer {
            interrupt: self.interrupt.clone(),
            ..Observer::showing(iteration)
        }
    }

    fn show(&self, point: &ChartPoint) {
        if let Some(show) = &self.point {
            show(point);
        }
    }

    fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }
}

/// Follows the optimum along a parameter by continuation: each optimum is predicted with d x*/dp
/// and corrected by a search. The step adapts to the prediction error; changes of the active set
/// are located by bisection. The chart has points at the values `at` (SI, within the range), or at
/// all values of the continuation if `at` is empty.
///
/// # Errors
/// [`Error::NotConverged`] if no first optimum is found; [`Error::Unreadable`] if the search varies
/// the parameter of `along`, and for a search over swings; [`Error::SearchRange`] for a value
/// outside the range; the errors of [`optimum`].
pub fn chart(
    setup: &Setup<f64>,
    search: &Search,
    along: Vary,
    at: &[f64],
    observer: &ChartObserver,
) -> Result<Chart> {
    check(search, along, at)?;
    let follower = Follower {
        setup,
        search,
        along,
        observer,
    };
    let (first, begun) = follower.first()?;
    let mut chart = Chart {
        along,
        points: vec![],
        begun,
        ended: None,
        interrupted: false,
    };
    let width = along.high - along.low;
    let mut stride = AdaptiveStep::new(width);
    observer.show(&first);
    chart.points.push(first);
    while let Some(here) = chart.points.last()
        && here.at < along.high
    {
        if observer.is_interrupted() {
            chart.ended = Some(
                along
                    .parameter
                    .append_value("interrupted: the chart ends at ".into(), here.at),
            );
            chart.interrupted = true;
            break;
        }
        let to = target(stride.to(here.at, along.high), here.at, at, width);
        let next = match follower.step(here, to, &mut stride) {
            Ok(Some(next)) => next,
            Ok(None) => continue,
            Err(reason) => {
                chart.ended = Some(reason);
                break;
            }
        };
        observer.show(&next);
        chart.points.push(next);
    }
    if !at.is_empty() {
        chart.points.retain(|point| at.contains(&point.at));
    }
    Ok(chart)
}

/// Refuses a search that varies the parameter of `along`, a search over swings, and values outside
/// the range.
fn check(search: &Search, along: Vary, at: &[f64]) -> Result<()> {
    along.check()?;
    search.refuse_swings()?;
    if let Some(outside) = at.iter().find(|at| !(along.low..=along.high).contains(*at)) {
        let show = |value: f64| along.parameter.show(Some(value));
        let reason = format!(
            "{} is outside {} .. {}; leave it out, or give a wider range",
            show(*outside),
            show(along.low),
            show(along.high)
        );
        return Err(Error::SearchRange {
            name: along.parameter.name.into(),
            reason,
        });
    }
    if search.parameters().any(|varied| varied == along.parameter) {
        let name = along.parameter.name;
        let source = format!(
            "{name} is a varied parameter, so the search chooses it; take it out of `vary`, or \
             follow the optimum along another parameter"
        );
        return Err(Error::unreadable(format!("the chart along {name}"), source));
    }
    Ok(())
}

/// End of the next step: the nearer of `to` and the next value in `at`. If `to` differs from 0 only
/// by rounding, it becomes 0.
fn target(to: f64, from: f64, at: &[f64], width: f64) -> f64 {
    let to = if to.abs() < LOCATED * width { 0.0 } else { to };
    at.iter()
        .copied()
        .filter(|at| *at > from)
        .fold(to, f64::min)
}

struct Follower<'a> {
    setup: &'a Setup<f64>,
    search: &'a Search,
    along: Vary,
    observer: &'a ChartObserver,
}

impl Follower<'_> {
    /// Steps from `here` to the parameter value `to`, and adapts the step size. `None` if the step
    /// was rejected; the next step is then shorter, unless the search was interrupted.
    ///
    /// The new point has the event of the step, if any: a jump if the optimum is far from its
    /// prediction, or a change of the active set. In the second case bisection locates the change,
    /// and the new point is the located point.
    ///
    /// # Errors
    /// The reason why no optimum was found.
    fn step(
        &self,
        here: &ChartPoint,
        to: f64,
        stride: &mut AdaptiveStep,
    ) -> std::result::Result<Option<ChartPoint>, Message> {
        let corrected = stride.accept_or_halve(self.next(here, to), self.observer.is_interrupted());
        let none_beyond = |error| {
            let parameter = self.along.parameter;
            let place = parameter.append_value("no optimum was found beyond ".into(), here.at);
            place.words(": ").message(why_none(&error))
        };
        let Some((point, apart)) = corrected.map_err(none_beyond)? else {
            return Ok(None);
        };
        let next = if apart > TOO_FAR {
            ChartPoint {
                event: Some(ChartEvent::Jump),
                ..point
            }
        } else if point.active != here.active {
            self.located(here, point)
        } else {
            point
        };
        stride.adapt(apart);
        Ok(Some(next))
    }

    /// The first optimum of the chart. If the low end of the range has no optimum, a few further
    /// values are tried, and bisection locates where the optima begin. The message is the reason
    /// why the chart begins after the low end; `None` if it begins there.
    fn first(&self) -> Result<(ChartPoint, Option<Message>)> {
        let Vary {
            parameter,
            low,
            high,
        } = self.along;
        let (mut why, mut without) = (None, low);
        for place in 0..=(1.0 / LONGEST) as u32 {
            let at = low + f64::from(place) * LONGEST * (high - low);
            let mut setup = *self.setup;
            setup.set_value(parameter, Some(at))?;
            if let Some(beginning) = &self.observer.beginning {
                beginning(at);
            }
            let found = optimum(&setup, self.search.clone(), self.observer.search())
                .and_then(|best| point(at, best));
            match found {
                Ok(point) => {
                    let Some(why) = why else {
                        return Ok((point, None));
                    };
                    let first = self.begin(without, point);
                    let begins = parameter.append_value("the chart begins at ".into(), first.at);
                    let none =
                        parameter.append_value(begins.words(": no optimum was found at "), low);
                    return Ok((first, Some(none.words(": ").message(why_none(&why)))));
                }
                Err(error) if self.observer.is_interrupted() => return Err(error),
                Err(error) if error.has_valid_input() => (why, without) = (why.or(Some(error)), at),
                Err(error) => return Err(error),
            }
        }
        Err(why.unwrap_or(Error::Nothing {
            doing: "chart",
            what: "optimum",
        }))
    }

    /// Bisects for the first optimum, between a value without an optimum and a known optimum.
    fn begin(&self, mut without: f64, mut first: ChartPoint) -> ChartPoint {
        let tolerance = LOCATED * (self.along.high - self.along.low);
        while first.at - without > tolerance && !self.observer.is_interrupted() {
            let middle = 0.5 * (without + first.at);
            match self.next(&first, middle) {
                Ok((corrected, _)) => first = corrected,
                Err(_) => without = middle,
            }
        }
        first
    }

    /// The optimum at the parameter value `to`, predicted from `here` and corrected by a search.
    /// The number is the distance from the predicted to the corrected optimum, in units of the
    /// ranges.
    fn next(&self, here: &ChartPoint, to: f64) -> Result<(ChartPoint, f64)> {
        let rates = match sensitivity(&here.best, self.along.parameter) {
            Ok(sensitivity) => sensitivity.optimum,
            // there is no sensitivity at a change of the active set: predict no change
            Err(_) => vec![0.0; self.search.vary.len()],
        };
        let bounds = self.search.domain()?.variables;
        let predicted = predicted(&here.best.solution.x, &rates, to - here.at, &bounds);
        let mut setup = here.best.setup;
        setup.set_value(self.along.parameter, Some(to))?;
        let varied: Vec<_> = self.search.parameters().collect();
        let setup = setup.with_values(&varied, &predicted)?;
        let options = Options {
            initial_radius: RADIUS,
            ..self.search.options.clone()
        };
        let search = Search {
            options,
            ..self.search.clone()
        };
        let solver = OptimumSearch::new(&setup, search, &self.observer.interrupt)?;
        let start = solver.problem.start();
        let best = solver.local_optimum(&start, self.observer.search(), None)?;
        let apart = relative_distance(&best.solution.x, &predicted, &bounds);
        Ok((point(to, best)?, apart))
    }

    /// Bisects for the first change of the active set between two optima.
    fn located(&self, here: &ChartPoint, there: ChartPoint) -> ChartPoint {
        let tolerance = LOCATED * (self.along.high - self.along.low);
        let next = |before: &ChartPoint, at: f64| Some(self.next(before, at).ok()?.0);
        let is_as_before = |found: &ChartPoint| found.active == here.active;
        let after = locate_change(
            [here.clone(), there],
            tolerance,
            |point| point.at,
            |_, _| None,
            next,
            is_as_before,
        );
        ChartPoint {
            event: Some(ChartEvent::between(&here.active, &after.active)),
            ..after
        }
    }
}

/// Reason of the error, without repeating that there is no optimum.
fn why_none(error: &Error) -> Message {
    match error {
        Error::NotConverged { status, message } => {
            Message::from(format!("{status}: ")).message(message.clone())
        }
        other => other.message(),
    }
}

fn point(at: f64, best: Optimum) -> Result<ChartPoint> {
    best.check_converged()?;
    Ok(ChartPoint {
        at,
        active: best.active(),
        best,
        event: None,
    })
}
