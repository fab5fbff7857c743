//! The optimum as a function of a parameter, followed by continuation.

use super::Vary;
use super::optimum::{Active, Optimum, Search, optimum};
use super::sensitivity::sensitivity;
use crate::drive::{BeyondCount, Looked};
use crate::error::{Error, Result};
use crate::optimize::{Options, Status, Watch};
use crate::parameters::Setup;
use crate::units::Message;

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
    pub event: Option<String>,
}

impl Chart {
    /// How many of its points lie beyond what the law was fitted to, or beside any face.
    pub fn beyond(&self) -> BeyondCount {
        let mut count = BeyondCount::default();
        for best in self.points.iter().map(|point| &point.best) {
            if let Some(drive) = &best.drive {
                count.add(drive.beyond(&best.setup, Looked::AtFlight));
            }
        }
        count
    }
}

/// The longest step, as a part of the range.
const LONGEST: f64 = 1.0 / 16.0;
/// The shortest.
const SHORTEST: f64 = 1.0 / 65_536.0;
/// Events are located to this part of the range.
const LOCATED: f64 = 1e-10;
/// Steps whose predicted optimum is farther than this from the one found, in units of the ranges, are halved …
const TOO_FAR: f64 = 0.02;
/// … and those nearer than this are followed by longer ones.
const NEAR: f64 = 0.002;
/// The trust region of a corrector: it stays with the optimum it follows.
const RADIUS: f64 = 0.05;

/// Follows the optimum along a parameter: from each optimum the next is predicted by d x*/dp and corrected by a search
/// from there; steps adapt to how far the two lie apart, and changes of the active bounds and constraints are located.
/// `watch` is shown every point as it is found.
///
/// # Errors
/// [`Error::NotConverged`] where no optimum is found to begin with; [`Error::NotVariable`] for a parameter that
/// is itself varied; as [`optimum`].
pub fn chart(
    setup: &Setup<f64>,
    search: &Search,
    along: Vary,
    watch: impl FnMut(&ChartPoint) -> bool,
) -> Result<Chart> {
    chart_at(setup, search, along, &[], watch)
}

/// As [`chart`], with a point at each of these values of the parameter (SI, within its range) and no others; with none, wherever the
/// optimum was followed.
///
/// # Errors
/// As [`chart`]; [`Error::SearchRange`] for a value outside the range.
pub fn chart_at(
    setup: &Setup<f64>,
    search: &Search,
    along: Vary,
    at: &[f64],
    mut watch: impl FnMut(&ChartPoint) -> bool,
) -> Result<Chart> {
    if let Some(outside) = at.iter().find(|at| !(along.low..=along.high).contains(*at)) {
        let show = |value: f64| along.parameter.show(Some(value));
        let reason = format!("{} is outside {} .. {}", show(*outside), show(along.low), show(along.high));
        return Err(Error::SearchRange { name: along.parameter.name.into(), reason });
    }
    if search.vary.iter().any(|vary| vary.parameter == along.parameter) {
        let reason = "it is one of the parameters varied; a chart runs along another parameter".into();
        return Err(Error::NotVariable { name: along.parameter.name.into(), reason });
    }
    let follower = Follower { setup, search, along };
    let (first, begun) = follower.first()?;
    let mut chart = Chart { along, points: vec![], begun, ended: None };
    let width = along.high - along.low;
    let mut step = LONGEST * width;
    let mut goes_on = watch(&first);
    chart.points.push(first);
    while let Some(here) = chart.points.last()
        && here.at < along.high
    {
        if !goes_on {
            chart.ended = Some(along.parameter.place("stopped at ".into(), here.at));
            break;
        }
        let to = if here.at + 1.001 * step >= along.high { along.high } else { here.at + step };
        // a step meant to end at zero ends there
        let to = if to.abs() < LOCATED * width { 0.0 } else { to };
        // and none goes past a value that was asked for
        let to = at.iter().copied().filter(|at| *at > here.at).fold(to, f64::min);
        let (next, apart) = match follower.next(here, to) {
            Ok(found) if found.1 <= TOO_FAR || step <= SHORTEST * width => found,
            Ok(_) => {
                step *= 0.5;
                continue;
            }
            Err(_) if step > SHORTEST * width => {
                step *= 0.5;
                continue;
            }
            Err(error) => {
                let place = along.parameter.place("no optimum was found beyond ".into(), here.at);
                chart.ended = Some(place.words(": ").message(error.message()));
                break;
            }
        };
        let next = if apart > TOO_FAR {
            let event = Some("the optimum jumps: the local optimum followed so far ends here".into());
            ChartPoint { event, ..next }
        } else if next.active != here.active {
            follower.located(here, next)
        } else {
            next
        };
        if apart < NEAR {
            step = (2.0 * step).min(LONGEST * width);
        }
        goes_on = watch(&next);
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
}

impl Follower<'_> {
    /// The optimum at the range's low end, or at the first of a few places where there is one; and why not before.
    fn first(&self) -> Result<(ChartPoint, Option<Message>)> {
        let Vary { parameter, low, high } = self.along;
        let mut why = None;
        for place in 0..=(1.0 / LONGEST) as u32 {
            let at = low + f64::from(place) * LONGEST * (high - low);
            let mut setup = *self.setup;
            setup.set_value(parameter, Some(at))?;
            let found = optimum(&setup, self.search.clone(), Watch::default()).and_then(|best| point(at, best));
            match found {
                Ok(point) => {
                    let begun = why.map(|why: Error| {
                        let begins = parameter.place("the chart begins at ".into(), at);
                        let without = parameter.place(begins.words(": no optimum was found at "), low);
                        without.words(": ").message(why.message())
                    });
                    return Ok((point, begun));
                }
                Err(error) if error.is_an_outcome() => why = why.or(Some(error)),
                Err(error) => return Err(error),
            }
        }
        Err(why.unwrap_or(Error::Nothing { doing: "chart", what: "optimum" }))
    }

    /// The optimum at another value, and how far it is from where it was predicted, in units of the ranges.
    fn next(&self, here: &ChartPoint, to: f64) -> Result<(ChartPoint, f64)> {
        let rates = match sensitivity(&here.best, self.along.parameter) {
            Ok(sensitivity) => sensitivity.optimum,
            // where an optimum has no sensitivity (the edge of an active set), staying is the best guess
            Err(_) => vec![0.0; self.search.vary.len()],
        };
        let predicted = here.best.solution.x.iter().zip(&rates).zip(&self.search.vary);
        let predicted: Vec<f64> =
            predicted.map(|((x, rate), vary)| (x + rate * (to - here.at)).clamp(vary.low, vary.high)).collect();
        let mut setup = here.best.setup;
        setup.set_value(self.along.parameter, Some(to))?;
        for (vary, x) in self.search.vary.iter().zip(&predicted) {
            setup.set_value(vary.parameter, Some(*x))?;
        }
        let options = Options { initial_radius: RADIUS, ..self.search.options.clone() };
        let found = point(to, optimum(&setup, Search { options, ..self.search.clone() }, Watch::default())?)?;
        let widths = self.search.vary.iter().map(|vary| vary.high - vary.low);
        let apart = found.best.solution.x.iter().zip(&predicted).zip(widths);
        let apart = apart.map(|((x, predicted), width)| if width > 0.0 { (x - predicted).abs() / width } else { 0.0 });
        let apart = apart.fold(0.0, f64::max);
        Ok((found, apart))
    }

    /// The first place between two optima where another bound or constraint holds than at the first.
    fn located(&self, here: &ChartPoint, there: ChartPoint) -> ChartPoint {
        let (mut before, mut after) = (here.clone(), there);
        while after.at - before.at > LOCATED * (self.along.high - self.along.low) {
            let middle = 0.5 * (before.at + after.at);
            match self.next(&before, middle) {
                Ok((found, _)) if found.active == here.active => before = found,
                Ok((found, _)) => after = found,
                Err(_) => break,
            }
        }
        let come = after.active.iter().filter(|name| !here.active.contains(name)).map(|name| format!("{name} begins"));
        let gone = here.active.iter().filter(|name| !after.active.contains(name)).map(|name| format!("{name} ends"));
        let event = Some(come.chain(gone).collect::<Vec<_>>().join(", "));
        ChartPoint { event, ..after }
    }
}

fn point(at: f64, best: Optimum) -> Result<ChartPoint> {
    if best.solution.status != Status::Converged {
        return Err(Error::NotConverged { status: best.status(), message: best.message() });
    }
    Ok(ChartPoint { at, active: best.active(), best, event: None })
}
