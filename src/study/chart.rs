//! The optimum as a function of a parameter, followed by continuation.

use super::Vary;
use super::optimum::{Optimum, local_optimum, optimum};
use super::search::Search;
use super::sensitivity::sensitivity;
use super::verdict::Active;
use crate::drive::{CheckScope, ExceededCount};
use crate::error::{Error, Result};
use crate::optimize::continuation::{LONGEST, RADIUS, Stride, TOO_FAR, apart, located, predicted};
use crate::optimize::{Bounds, Iteration, Observer, Options, Status};
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
    /// The optima, in order.
    pub points: Vec<ChartPoint>,
    /// Why it begins after the range does, if it does.
    pub begun: Option<Message>,
    /// Why it ends before the range does, if it does.
    pub ended: Option<Message>,
    /// Whether it was stopped from outside before its end.
    pub interrupted: bool,
}

/// The optimum at one value of the parameter.
#[derive(Clone, Debug)]
pub struct ChartPoint {
    /// The parameter's value, SI.
    pub at: f64,
    /// The optimum.
    pub best: Optimum,
    /// What holds it.
    pub active: Vec<Active>,
    /// What happens here: an active bound or constraint comes or goes, or the optimum jumps.
    pub event: Option<ChartEvent>,
}

/// What happens at a point of a chart. It reads `swing.attack_angle at its upper bound begins,
/// apex_height <= 30 yd ends`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChartEvent {
    /// Other bounds and constraints are active from here on.
    Changed {
        /// Those that become active.
        begins: Vec<Active>,
        /// Those that are active no longer.
        ends: Vec<Active>,
    },
    /// Another local optimum is better from here on.
    Jump,
}

impl ChartEvent {
    /// The event with each bound and constraint as `name` writes it.
    pub fn words(&self, name: impl Fn(&Active) -> String) -> String {
        match self {
            Self::Changed { begins, ends } => {
                let begins = begins
                    .iter()
                    .map(|active| format!("{} begins", name(active)));
                let ends = ends.iter().map(|active| format!("{} ends", name(active)));
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
    /// Warnings about its optima: how many lie outside of what the law was fitted to, or are struck
    /// beside any face, and where along the parameter.
    pub fn warnings(&self) -> Vec<Message> {
        let Some(first) = self.points.first() else {
            return vec![];
        };
        let mut count = ExceededCount::default();
        let (mut law, mut face, mut flat) = (Reach::default(), Reach::default(), Reach::default());
        for ChartPoint { at, best, .. } in &self.points {
            if let Some(drive) = &best.drive {
                let beyond =
                    drive.exceeded_limits(&best.setup, CheckScope::Flight, &best.search.outcomes());
                count.add(beyond);
                law.add(*at, beyond.law);
                face.add(*at, beyond.face);
                flat.add(*at, beyond.flat);
            }
        }
        let warnings = count.warnings(
            &first.best.setup.law,
            ["optimum", "optima"],
            CheckScope::Flight,
        );
        // in their order, those that there are
        let reaches = [law, face, flat]
            .into_iter()
            .filter(|reach| !reach.parts.is_empty());
        warnings
            .into_iter()
            .zip(reaches)
            .map(|(warning, reach)| reach.told(warning, &self.along))
            .collect()
    }
}

/// The parts of a range in which something is so, of points in their order.
#[derive(Clone, Default)]
struct Reach {
    parts: Vec<[f64; 2]>,
    /// Whether it was so at the last point.
    goes_on: bool,
}

impl Reach {
    fn add(&mut self, at: f64, is_so: bool) {
        match self.parts.last_mut() {
            Some([_, end]) if is_so && self.goes_on => *end = at,
            _ if is_so => self.parts.push([at; 2]),
            _ => {}
        }
        self.goes_on = is_so;
    }

    fn told(&self, warning: Message, along: &Vary) -> Message {
        let parameter = along.parameter;
        let begun = warning.words(format!("; {} =", parameter.name));
        self.parts
            .iter()
            .enumerate()
            .fold(begun, |told, (i, [low, high])| {
                let first = parameter.place(told.words(if i == 0 { " " } else { ", and " }), *low);
                if low == high {
                    first
                } else {
                    parameter.place(first.words(" to "), *high)
                }
            })
    }
}

/// Events are located to this part of the range.
const LOCATED: f64 = 1e-10;

/// Follows the optimum along a parameter: from each optimum the next is predicted by d x*/dp and
/// corrected by a search from there; steps adapt to how far the two lie apart, and changes of the
/// active bounds and constraints are located. `on_point` is shown every point as it is found, and
/// says whether the chart goes on.
///
/// # Errors
/// [`Error::NotConverged`] where no optimum is found to begin with; [`Error::Unreadable`] for a
/// parameter that is itself varied; as [`optimum`].
pub fn chart(
    setup: &Setup<f64>,
    search: &Search,
    along: Vary,
    on_point: &mut dyn FnMut(&ChartPoint) -> bool,
) -> Result<Chart> {
    chart_at(
        setup,
        search,
        along,
        &[],
        &ChartObserver::default(),
        on_point,
    )
}

/// Shows an iteration.
type Show = Rc<dyn Fn(&Iteration)>;

/// What the searches of a chart report to, and what stops them.
#[derive(Clone, Default)]
pub struct ChartObserver {
    /// Ends the chart with the points so far once it is true, also within a search.
    pub interrupt: Arc<AtomicBool>,
    /// Is shown each value at which the first optimum is searched for: the low end of the range,
    /// and others where it has none.
    pub beginning: Option<Rc<dyn Fn(f64)>>,
    /// Is shown every iteration of every search.
    pub iteration: Option<Show>,
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

    fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }
}

/// As [`chart`], with a point at each of these values of the parameter (SI, within its range) and
/// no others; with none, wherever the optimum was followed. `observer` can stop it within a search.
///
/// # Errors
/// As [`chart`]; [`Error::SearchRange`] for a value outside the range; [`Error::Unreadable`] for a
/// search over swings.
pub fn chart_at(
    setup: &Setup<f64>,
    search: &Search,
    along: Vary,
    at: &[f64],
    observer: &ChartObserver,
    on_point: &mut dyn FnMut(&ChartPoint) -> bool,
) -> Result<Chart> {
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
    if search
        .vary
        .iter()
        .any(|vary| vary.parameter == along.parameter)
    {
        let name = along.parameter.name;
        let source = format!(
            "{name} is one of the parameters varied, so that the search chooses it; take it out of \
             those (`vary`), or follow the optimum \
             along another parameter"
        );
        return Err(Error::Unreadable {
            name: format!("the chart along {name}"),
            source: source.into(),
        });
    }
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
    let mut stride = Stride::new(width);
    let mut goes_on = on_point(&first);
    chart.points.push(first);
    while let Some(here) = chart.points.last()
        && here.at < along.high
    {
        if !goes_on || observer.is_interrupted() {
            chart.ended = Some(
                along
                    .parameter
                    .place("interrupted: the chart ends at ".into(), here.at),
            );
            chart.interrupted = true;
            break;
        }
        let to = stride.to(here.at, along.high);
        // a step meant to end at zero ends there
        let to = if to.abs() < LOCATED * width { 0.0 } else { to };
        // and none goes past a value that was asked for
        let to = at
            .iter()
            .copied()
            .filter(|at| *at > here.at)
            .fold(to, f64::min);
        let (next, apart) = match follower.next(here, to) {
            Ok(found) if found.1 <= TOO_FAR || !stride.halve() => found,
            Ok(_) => continue,
            // an interrupted search is no reason for shorter steps
            Err(_) if observer.is_interrupted() => continue,
            Err(_) if stride.halve() => continue,
            Err(error) => {
                let place = along
                    .parameter
                    .place("no optimum was found beyond ".into(), here.at);
                chart.ended = Some(place.words(": ").message(why_none(&error)));
                break;
            }
        };
        let next = if apart > TOO_FAR {
            ChartPoint {
                event: Some(ChartEvent::Jump),
                ..next
            }
        } else if next.active != here.active {
            follower.located(here, next)
        } else {
            next
        };
        stride.adapt(apart);
        goes_on = on_point(&next);
        chart.points.push(next);
    }
    if !at.is_empty() {
        chart.points.retain(|point| at.contains(&point.at));
    }
    Ok(chart)
}

/// What is followed.
struct Follower<'a> {
    setup: &'a Setup<f64>,
    search: &'a Search,
    along: Vary,
    observer: &'a ChartObserver,
}

impl Follower<'_> {
    /// The optimum at the range's low end or, where there is none, the first one: from the first of
    /// a few places that has one, located as events are; and why not before.
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
                    let begins = parameter.place("the chart begins at ".into(), first.at);
                    let none = parameter.place(begins.words(": no optimum was found at "), low);
                    return Ok((first, Some(none.words(": ").message(why_none(&why)))));
                }
                Err(error) if self.observer.is_interrupted() => return Err(error),
                Err(error) if error.is_an_outcome() => (why, without) = (why.or(Some(error)), at),
                Err(error) => return Err(error),
            }
        }
        Err(why.unwrap_or(Error::Nothing {
            doing: "chart",
            what: "optimum",
        }))
    }

    /// The first optimum between a place without one and an optimum that was found.
    fn begin(&self, mut without: f64, mut first: ChartPoint) -> ChartPoint {
        let tolerance = LOCATED * (self.along.high - self.along.low);
        while first.at - without > tolerance && !self.observer.is_interrupted() {
            let middle = 0.5 * (without + first.at);
            match self.next(&first, middle) {
                Ok((found, _)) => first = found,
                Err(_) => without = middle,
            }
        }
        first
    }

    /// The optimum at another value, and how far it is from where it was predicted, in units of the
    /// ranges.
    fn next(&self, here: &ChartPoint, to: f64) -> Result<(ChartPoint, f64)> {
        let rates = match sensitivity(&here.best, self.along.parameter) {
            Ok(sensitivity) => sensitivity.optimum,
            // where an optimum has no sensitivity (the edge of an active set), staying is the best
            // guess
            Err(_) => vec![0.0; self.search.vary.len()],
        };
        let ends = |end: fn(&Vary) -> f64| self.search.vary.iter().map(end).collect::<Vec<_>>();
        let bounds = Bounds::new(ends(|vary| vary.low), ends(|vary| vary.high))?;
        let predicted = predicted(&here.best.solution.x, &rates, to - here.at, &bounds);
        let mut setup = here.best.setup;
        setup.set_value(self.along.parameter, Some(to))?;
        for (vary, x) in self.search.vary.iter().zip(&predicted) {
            setup.set_value(vary.parameter, Some(*x))?;
        }
        let options = Options {
            initial_radius: RADIUS,
            ..self.search.options.clone()
        };
        let found = point(
            to,
            local_optimum(
                &setup,
                Search {
                    options,
                    ..self.search.clone()
                },
                self.observer.search(),
            )?,
        )?;
        let apart = apart(&found.best.solution.x, &predicted, &bounds);
        Ok((found, apart))
    }

    /// The first place between two optima where another bound or constraint holds than at the
    /// first.
    fn located(&self, here: &ChartPoint, there: ChartPoint) -> ChartPoint {
        let tolerance = LOCATED * (self.along.high - self.along.low);
        let next = |before: &ChartPoint, at: f64| Some(self.next(before, at).ok()?.0);
        let is_as_before = |found: &ChartPoint| found.active == here.active;
        let after = located(
            [here.clone(), there],
            tolerance,
            |point| point.at,
            |_, _| None,
            next,
            is_as_before,
        );
        let only = |these: &[Active], others: &[Active]| {
            these
                .iter()
                .filter(|active| !others.contains(active))
                .cloned()
                .collect::<Vec<_>>()
        };
        let (begins, ends) = (
            only(&after.active, &here.active),
            only(&here.active, &after.active),
        );
        ChartPoint {
            event: Some(ChartEvent::Changed { begins, ends }),
            ..after
        }
    }
}

/// Why there is no optimum, where that there is none is said already.
fn why_none(error: &Error) -> Message {
    match error {
        Error::NotConverged { status, message } => {
            Message::from(format!("{status}: ")).message(message.clone())
        }
        other => other.message(),
    }
}

fn point(at: f64, best: Optimum) -> Result<ChartPoint> {
    if best.solution.status != Status::Converged {
        return Err(Error::NotConverged {
            status: best.status(),
            message: best.message(),
        });
    }
    Ok(ChartPoint {
        at,
        active: best.active(),
        best,
        event: None,
    })
}
