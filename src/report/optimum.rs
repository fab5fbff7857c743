//! The best drive, or the best design over swings: JSON, text, and setup file.

use super::document::{Detail, Document, Line, Table};
use super::drive::{LaunchReport, LawRanges, extrapolated, flight, launch, law_range};
use super::json::{ByName, Number, Settings, settings};
use super::limits::{self, Limit, Objective, ended_at};
use super::swings::{OverSwings, StudiesReport, goals, nominal_design, notes};
use super::uncertainty::distribution_text;
use super::{Reply, setup_toml, shown};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::optimize::{ConstraintValue, Effort, Iteration, Status};
use crate::parameters::Preset;
use crate::study::swings::Swings;
use crate::study::{
    ClubAlone, Constraint, Limit as WindowLimit, LocalOptimum, Optima, Optimum, Sample, Search,
    Sense, Vary, Window,
};
use crate::units::{Message, Quantity, System, counted, counted_of, fixed, signed, with_unit};
use serde::Serialize;
use std::collections::BTreeMap;

/// An optimum as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OptimumReport {
    /// The objective: an outcome, or for swings a sum of statistics.
    pub objective: String,
    /// The direction: `maximize` or `minimize`.
    #[cfg_attr(test, schemars(with = "Sense"))]
    pub sense: &'static str,
    /// The value of the objective, SI; `null` if no drive flies.
    pub value: Number,
    /// The varied parameters at the optimum, SI.
    pub optimum: Option<ByName<Number>>,
    /// The varied parameters at the start, if no point of the search has a value; otherwise
    /// omitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<ByName<Number>>,
    /// The gradient of the objective at the optimum by the varied parameters, SI.
    pub gradient: Option<ByName<Number>>,
    /// The multipliers of the bounds of each varied parameter, SI.
    pub multipliers: Option<BTreeMap<&'static str, Multipliers>>,
    /// The constraints.
    pub constraints: Vec<ConstraintReport>,
    /// The relative KKT residual.
    pub kkt_residual: Number,
    /// Iterations of the optimizer.
    pub iterations: u64,
    /// Evaluations of objective and constraints with derivatives.
    pub evaluations: u64,
    /// Counters of the quadratic programs that were solved for the steps.
    pub steps: Effort,
    /// The local optima of a search from several starts, best first; `null` for a single
    /// start.
    pub optima: Option<Vec<LocalReport>>,
    /// The sample of the ranges for comparison with the optimum; `null` for swings, and after an
    /// interruption.
    pub sample: Option<Sample>,
    /// Every parameter at the optimum. Like launch and flight, it is `null` if no drive flies.
    pub setup: Option<Settings>,
    /// The launch of the optimal drive; `null` for swings.
    pub launch: Option<LaunchReport>,
    /// The flight of the optimal drive; `null` for swings.
    #[cfg_attr(test, schemars(schema_with = "super::drive::flight_schema"))]
    pub flight: Option<ByName<Number>>,
    /// The fitted range of the law, and the fraction of the optimal drive's flight outside of it.
    pub law_range: Option<LawRanges>,
    /// For each varied parameter, its range when it alone varies and costs at most the loss; `null`
    /// for swings, and without an optimum.
    pub window: Option<ByName<WindowReport>>,
    /// The loss of the windows, SI.
    pub window_loss: Number,
    /// The part of the gain that needs no other swing; `null` unless club and swing are varied.
    pub club_alone: Option<ClubAloneReport>,
    /// The setup file that was written; `null` without one.
    pub file: Option<String>,
    /// Parameters that the request states, so that the default search does not vary them; omitted
    /// if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub held: Vec<&'static str>,
    /// Results over swings; omitted for a single drive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swings: Option<StudiesReport>,
    /// The limits of a design; omitted for other searches.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub design: Option<DesignReport>,
}

/// The limits of a design, and its changes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DesignReport {
    /// The rules that limit the design: `golf`, the Rules of Golf, or `none`.
    #[cfg_attr(test, schemars(extend("enum" = ["golf", "none"])))]
    pub rules: &'static str,
    /// The assumptions, in sentences.
    pub notes: Vec<String>,
    /// The values of the varied parameters before the search.
    pub as_set_up: ByName<Number>,
    /// The goals before the search and with the best design, over all swings; empty without a best
    /// design.
    pub parts: Vec<GoalReport>,
    /// The rules and limits.
    pub held: Vec<LimitReport>,
}

/// A goal before the search and with the best design.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct GoalReport {
    /// The goal.
    pub goal: String,
    /// The value of the goal before the search, SI; `null` if a swing does not fly.
    pub as_set_up: Number,
    /// The value of the goal with the best design, SI.
    pub best: Number,
}

/// A rule or limit of a design.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LimitReport {
    /// The name of the rule or limit.
    pub name: String,
    /// The limited expression.
    pub expression: String,
    /// The source of the rule; `null` for a limit of the user.
    pub source: Option<&'static str>,
    /// The kind of enforcement: `bound` of a varied parameter, `limit` of the search, `value` that
    /// no varied parameter changes, or `unknown`: its value is unknown.
    #[cfg_attr(test, schemars(extend("enum" = ["bound", "limit", "value", "unknown"])))]
    pub by: &'static str,
    /// The lower limit, SI; `null` without one.
    pub low: Number,
    /// The upper limit, SI; `null` without one.
    pub high: Number,
    /// The value of the expression, SI.
    pub value: Number,
    /// The distance from the nearer limit, SI; negative if the limit is violated.
    pub margin: Number,
    /// The multiplier of an active limit: the gain of the goal per SI unit by which the limit is
    /// relaxed; `null` if the limit is inactive.
    pub price: Number,
}

/// A constraint at an optimum.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ConstraintReport {
    /// The text of the constraint.
    pub expression: String,
    /// The value of the limited goal, SI.
    pub value: f64,
    /// The distance of the value from the limits, SI; 0 within them.
    pub violation: f64,
    /// The gain of the objective for each SI unit by which the limit is relaxed, ≥ 0; for an
    /// equation, by which its value is raised. `robust`: the decrease of the greatest loss,
    /// negative if the best design gains more.
    pub multiplier: f64,
}

impl ConstraintReport {
    pub(super) fn new(constraint: &Constraint, at: &ConstraintValue) -> Self {
        // a decrease of the minimized function is a gain of the objective
        let multiplier = if constraint.is_equation() {
            at.multiplier
        } else {
            at.multiplier.abs()
        };
        Self {
            expression: constraint.expression.clone(),
            value: at.value,
            violation: at.violation.abs(),
            multiplier,
        }
    }
}

/// A local optimum from a search with several starts.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LocalReport {
    /// The status of the searches that ended here.
    pub status: &'static str,
    /// The objective, SI; `null` if no drive flies.
    pub value: Number,
    /// The varied parameters, SI.
    pub optimum: ByName<Number>,
    /// The number of starts that reached this optimum.
    pub starts: usize,
}

impl LocalReport {
    /// The local optima. Interrupted searches are omitted.
    fn all(optima: &Optima) -> Vec<Self> {
        let vary = &optima.best.search.vary;
        let one = |local: &LocalOptimum| {
            let names = vary.iter().map(|vary| vary.parameter.name);
            let x = local.solution.x.iter().copied();
            Self {
                status: local.status(),
                value: local.value.into(),
                optimum: names.zip(x).collect(),
                starts: local.starts.len(),
            }
        };
        optima.ended().map(one).collect()
    }
}

/// The multipliers of a parameter's bounds.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Multipliers {
    /// The gain of the objective for each SI unit by which the lower bound is lowered.
    pub lower: f64,
    /// The gain of the objective for each SI unit by which the upper bound is raised.
    pub upper: f64,
}

impl OptimumReport {
    /// The answer of `optimize`.
    pub fn reply(optima: &Optima, over: OverSwings<'_>, warnings: Vec<Message>) -> Reply<Self> {
        let body = Self {
            swings: StudiesReport::new(&optima.best, over),
            ..Self::of_many(optima)
        };
        let reply = Reply::done("optimize", warnings, body);
        let best = &optima.best;
        match optima.interrupted() {
            None => reply.ended(best.status(), Some(best.message().to_string())),
            interrupted => reply.ended("interrupted", interrupted),
        }
    }

    /// The report of the best optimum. For several starts it contains all local optima.
    pub(super) fn of_many(optima: &Optima) -> Self {
        Self {
            optima: (optima.starts > 1).then(|| LocalReport::all(optima)),
            ..Self::new(&optima.best)
        }
    }

    /// The report of an optimum.
    pub fn new(optimum: &Optimum) -> Self {
        let (solution, vary) = (&optimum.solution, &optimum.search.vary);
        let found = optimum.value().is_some();
        let by_name = |values: &[f64]| -> ByName<Number> {
            let names = vary.iter().map(|vary| vary.parameter.name);
            names.zip(values.iter().copied()).collect()
        };
        let multipliers = |i: usize| {
            let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
            (vary[i].parameter.name, Multipliers { lower, upper })
        };
        let drive = optimum.drive.as_ref();
        Self {
            objective: optimum.search.of.expression.clone(),
            sense: optimum.search.sense.name(),
            value: optimum.value().into(),
            optimum: found.then(|| by_name(&solution.x)),
            start: (!found).then(|| by_name(&solution.x)),
            gradient: found.then(|| by_name(&optimum.gradient())),
            multipliers: found.then(|| (0..vary.len()).map(multipliers).collect()),
            constraints: constraints(optimum),
            kkt_residual: found.then_some(solution.kkt_residual).into(),
            iterations: solution.iterations,
            evaluations: solution.evaluations,
            steps: solution.effort,
            optima: None,
            sample: optimum.sample,
            setup: found.then(|| settings(&optimum.setup)),
            launch: drive.map(launch),
            flight: drive.and_then(flight),
            law_range: drive.and_then(|drive| law_range(&optimum.setup, drive)),
            window: None,
            window_loss: Number(None),
            club_alone: None,
            file: None,
            held: vec![],
            swings: None,
            design: None,
        }
    }
}

impl OptimumReport {
    /// Adds the flatness of the optimum, and the gain of the club alone.
    #[must_use]
    pub fn with_surroundings(self, optimum: &Optimum, around: &Surroundings<'_>) -> Self {
        let vary = optimum.search.vary.iter();
        let window = vary.zip(around.windows).map(|(vary, window)| {
            let report = WindowReport::new(optimum, window);
            (vary.parameter.name, report)
        });
        Self {
            window: Some(window.collect()),
            window_loss: around.loss.into(),
            club_alone: around.club_alone.map(ClubAloneReport::new),
            ..self
        }
    }
}

/// The surroundings of an optimum of one drive.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// The allowed loss, SI.
    pub loss: f64,
    /// The window of each varied parameter for this loss.
    pub windows: &'a [Window],
    /// The best value with the swing as set up.
    pub club_alone: Option<&'a ClubAlone>,
}

/// The range of a parameter that alone varies and costs at most the stated loss.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WindowReport {
    /// Lower end, SI.
    pub low: f64,
    /// Upper end, SI.
    pub high: f64,
    /// The reason for the lower end: `loss`, `bound`, `no flight`, or a constraint.
    pub low_limit: String,
    /// The reason for the upper end.
    pub high_limit: String,
}

impl WindowReport {
    fn new(optimum: &Optimum, window: &Window) -> Self {
        Self {
            low: window.low,
            high: window.high,
            low_limit: limit_name(optimum, window.low_limit),
            high_limit: limit_name(optimum, window.high_limit),
        }
    }
}

/// The reason for an end of a window.
fn limit_name(optimum: &Optimum, limit: WindowLimit) -> String {
    match limit {
        WindowLimit::Loss => "loss".into(),
        WindowLimit::Bound => "bound".into(),
        WindowLimit::Constraint(j) => optimum.search.subject_to[j].expression.clone(),
        WindowLimit::NoFlight => "no flight".into(),
    }
}

/// The part of a gain that needs no other swing, SI.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ClubAloneReport {
    /// The gain of the best club with the swing as set up, SI.
    pub club_gain: f64,
    /// The further gain if the swing is changed too, SI.
    pub swing_gain: f64,
    /// The best club with the swing as set up, SI.
    pub optimum: ByName<Number>,
}

impl ClubAloneReport {
    fn new(club: &ClubAlone) -> Self {
        let vary = club.optimum.search.vary.iter();
        let names = vary.map(|vary| vary.parameter.name);
        Self {
            club_gain: club.value - club.as_set_up,
            swing_gain: club.rest,
            optimum: names.zip(club.optimum.solution.x.iter().copied()).collect(),
        }
    }
}

pub(super) fn constraints(optimum: &Optimum) -> Vec<ConstraintReport> {
    let all = optimum.constraints();
    all.iter()
        .map(|(constraint, at)| ConstraintReport::new(constraint, at))
        .collect()
}

/// The optimum for readers: the varied parameters with the gains of their bounds, the constraints,
/// the drive or the goals over the swings, and for several starts the results of all searches.
pub fn optimize_document(
    optima: &Optima,
    over: OverSwings<'_>,
    around: Option<&Surroundings<'_>>,
    system: System,
) -> Document {
    // the text of a single search already states its interruption or an improvement from a sample
    let sample = optima.best.sample;
    let from_sample = usize::from(sample.is_some_and(|sample| sample.improved));
    let several = optima.starts > 1 + from_sample;
    let mut document = Document::default();
    if let Some(stopped) = optima.interrupted().filter(|_| several) {
        let stopped = format!("interrupted: {stopped}; the best so far:");
        document.list([Line::flush(stopped)]);
    }
    document.append(optimum_document(&optima.best, over, around, system));
    if several {
        document.append(optima_document(optima, system));
    }
    document
}

/// One optimum for readers: the result first, the convergence last. Without an optimum, the status
/// is the answer.
pub fn optimum_document(
    optimum: &Optimum,
    over: OverSwings<'_>,
    around: Option<&Surroundings<'_>>,
    system: System,
) -> Document {
    let mut document = Document::default();
    let is_converged = optimum.solution.status == Status::Converged;
    if !is_converged {
        let ended = ended_line(optimum, system);
        let sample = optimum.value().and_then(|_| sample_line(optimum));
        document.list([ended].into_iter().chain(sample));
    }
    let Some(value) = optimum.value() else {
        return document;
    };
    if let Some(drive) = &optimum.drive {
        if is_converged {
            document.list(gain_lines(optimum, drive, system));
        }
        add_place(&mut document, optimum, around, system);
        document.list(drive_lines(optimum, value, drive, system));
    } else {
        document.add(goals(optimum, over.price, system));
        document.add(place(optimum, over, system));
        add_constraints(&mut document, optimum, system);
        document.list(notes(optimum, over, system));
    }
    if is_converged {
        add_convergence(&mut document, optimum, system);
    }
    document
}

/// Adds the varied parameters of an optimum of one drive with its surroundings, and the constraints.
pub(super) fn add_place(
    document: &mut Document,
    optimum: &Optimum,
    around: Option<&Surroundings<'_>>,
    system: System,
) {
    let mut place = place(optimum, OverSwings::default(), system);
    for text in around
        .iter()
        .flat_map(|around| around.lines(optimum, system))
    {
        place.remark(text);
    }
    document.add(place);
    add_constraints(document, optimum, system);
}

impl Surroundings<'_> {
    /// "each alone loses less than 1.00 yd: club.loft 5.36° to 6.94°", and the gain of the club
    /// alone.
    fn lines(&self, optimum: &Optimum, system: System) -> Vec<String> {
        let loss = shown::spread(optimum.search.outcome(), self.loss, system);
        let vary = optimum.search.vary.iter().zip(self.windows);
        let windows: Vec<_> = vary
            .filter(|(vary, _)| vary.low < vary.high)
            .map(|(vary, window)| window_text(optimum, vary, window, system))
            .collect();
        let windows = format!(
            "within {loss} of the best, each alone with the others at the optimum: {}",
            windows.join(", ")
        );
        let club = self.club_alone.map(|club| club_text(optimum, club, system));
        [windows].into_iter().chain(club).collect()
    }
}

/// "club.loft 5.36° to 6.94°", with the reason for each end that is not due to the loss.
fn window_text(optimum: &Optimum, vary: &Vary, window: &Window, system: System) -> String {
    let end = |value: f64, limit: WindowLimit| {
        let value = shown::parameter(vary.parameter, value, system);
        match limit {
            WindowLimit::Loss => value,
            WindowLimit::Constraint(j) => {
                let constraint = shown::constraint(&optimum.search.subject_to[j], system);
                format!("{value} ({constraint})")
            }
            other => format!("{value} ({})", limit_name(optimum, other)),
        }
    };
    format!(
        "{} {} to {}",
        vary.parameter.name,
        end(window.low, window.low_limit),
        end(window.high, window.high_limit)
    )
}

/// "the club alone, with the swing as set up: +2.60 yd (club.loft 10.40°); the swing too: +11.90
/// yd".
fn club_text(optimum: &Optimum, club: &ClubAlone, system: System) -> String {
    let goal = &optimum.search.of;
    let gain = |amount: f64| signed(amount, shown::goal_difference(goal, amount, system));
    let vary = club.optimum.search.vary.iter();
    let values = vary.zip(&club.optimum.solution.x).map(|(vary, x)| {
        let value = shown::within(vary, *x, system);
        format!("{} {value}", vary.parameter.name)
    });
    let values = values.collect::<Vec<_>>().join(", ");
    let club_gain = gain(club.value - club.as_set_up);
    format!(
        "the club alone, with the swing as set up: {club_gain} ({values}); the swing too: {} more",
        gain(club.rest)
    )
}

/// Adds the comparison with the sample and the convergence of an optimum.
pub(super) fn add_convergence(document: &mut Document, optimum: &Optimum, system: System) {
    let message = optimum.message();
    let is_of_solver = message.to_string() == optimum.solution.message;
    let ended = match is_of_solver {
        true => Line::flush(format!("{}: {}", optimum.status(), effort(optimum))),
        false => ended_line(optimum, system),
    };
    document.list(sample_line(optimum).into_iter().chain([ended]));
    if is_of_solver {
        let mut residual = Document::default();
        residual.paragraph(message.in_units(system));
        document.append_detail(residual, Detail::Computation);
    }
}

/// The status of a search with its message: the numbers of the solver, or what it means for the
/// drive.
pub(super) fn ended_line(optimum: &Optimum, system: System) -> Line {
    Line::flush(format!(
        "{}: {} ({})",
        optimum.status(),
        optimum.message().in_units(system),
        effort(optimum)
    ))
}

/// "4 iterations, 5 evaluations of 64 swings".
fn effort(optimum: &Optimum) -> String {
    let scenarios = &optimum.search.scenarios;
    let swings = match scenarios.is_one_drive() {
        true => String::new(),
        false => format!(" of {}", counted(scenarios.points.len() as u64, "swing")),
    };
    format!(
        "{}, {}{swings}",
        counted(optimum.solution.iterations, "iteration"),
        counted(optimum.solution.evaluations, "evaluation")
    )
}

/// "carry 286.0 yd → 300.4 yd: +14.4 yd" with the change of the total. If carry and total disagree
/// about the better drive, it adds advice.
pub(super) fn gain_lines(optimum: &Optimum, drive: &Drive<f64>, system: System) -> Vec<Line> {
    let objective = optimum.search.of.outcome().unwrap_or(Outcome::Carry);
    let start = optimum.start_drive.as_ref();
    let before = |of: Outcome| start.and_then(|start| of.value(start));
    let change = |of: Outcome| Some(of.value(drive)? - before(of)?);
    let line = |of: Outcome| {
        let best = shown::outcome(of, of.value(drive)?, system);
        let name = shown::words(of.name());
        let (Some(before), Some(gain)) = (before(of), change(of)) else {
            return Some(format!("{name} {best}"));
        };
        let before = shown::outcome(of, before, system);
        let unit = system.unit(of.unit());
        let gain = signed(gain, of.quantity().read_off(gain, unit));
        Some(format!("{name} {before} → {best}: {gain}"))
    };
    let rolls = Outcome::Run.value(drive).is_some_and(|run| run != 0.0);
    let is_distance = [Outcome::Carry, Outcome::Total].contains(&objective);
    if !is_distance || !rolls {
        return line(objective).map(Line::flush).into_iter().collect();
    }
    let other = match objective {
        Outcome::Total => Outcome::Carry,
        _ => Outcome::Total,
    };
    let lines: Vec<_> = [objective, other].into_iter().filter_map(line).collect();
    let text = format!("{} (totals are known to 10 yd)", lines.join("; "));
    let falls = |of: Outcome| change(of).is_some_and(|change| change < 0.0);
    let advice = match objective {
        Outcome::Carry if !falls(Outcome::Carry) && falls(Outcome::Total) => {
            "the carry grows and the total falls: `maximize total` finds the longest total"
        }
        _ => "",
    };
    let advice = (!advice.is_empty()).then(|| Line::flush(advice));
    let beyond = extrapolated(&optimum.setup, drive, system).map(Line::flush);
    [Line::flush(text)]
        .into_iter()
        .chain(beyond)
        .chain(advice)
        .collect()
}

/// The varied parameters as a table; for swings, with the best design for the mean swing.
pub(super) fn place(optimum: &Optimum, over: OverSwings<'_>, system: System) -> Table {
    let (search, solution) = (&optimum.search, &optimum.solution);
    let is_one_drive = search.scenarios.is_one_drive();
    let nominal = nominal_design(over.price);
    let rows = search.vary.iter().enumerate().map(|(i, vary)| {
        let mean_swing = nominal.map_or(shown::NONE.into(), |design| {
            shown::within(vary, design[i], system)
        });
        let mean_swing = (!is_one_drive).then_some(mean_swing);
        let start = is_one_drive.then(|| {
            let value = optimum.start.value(vary.parameter);
            value.map_or(shown::NONE.into(), |value| {
                shown::within(vary, value, system)
            })
        });
        let name: String = vary.parameter.name.into();
        let found = shown::within(vary, solution.x[i], system);
        std::iter::once(name)
            .chain(start)
            .chain([found])
            .chain(mean_swing)
            .chain([
                shown::range(vary, system),
                bound_in_words(optimum, i, system),
            ])
            .collect::<Vec<String>>()
    });
    if is_one_drive {
        let found = ended_at(solution.status, "optimum");
        Table::new(["vary", "as set up", found, "range", ""], rows).right([1, 2])
    } else {
        let found = ended_at(solution.status, "best");
        let head = ["vary", found, "for the mean swing", "range", ""];
        Table::new(head, rows).right([1, 2])
    }
}

/// The optimal drive: objective, carry, roll-out, launch and flight.
pub(super) fn drive_lines(
    optimum: &Optimum,
    value: f64,
    drive: &Drive<f64>,
    system: System,
) -> Vec<Line> {
    const LAUNCH: [Outcome; 4] = [
        Outcome::BallSpeed,
        Outcome::LaunchAngle,
        Outcome::Backspin,
        Outcome::SmashFactor,
    ];
    const FLIGHT: [Outcome; 4] = [
        Outcome::ApexHeight,
        Outcome::DescentAngle,
        Outcome::FlightTime,
        Outcome::Lateral,
    ];
    let of = optimum.search.of.outcome();
    let line = |outcomes: [Outcome; 4]| {
        let one = |outcome: Outcome| {
            let value = shown::outcome_or_dash(outcome, outcome.value(drive), system);
            format!("{} {value}", shown::words(outcome.name()))
        };
        outcomes.map(one).join(", ")
    };
    let row = |name: &str, text: &str| Line::item(format!("{name:<8}{text}"));
    let both = |of: Outcome| {
        let value = of.value(drive)?;
        Some(row(of.name(), &shown::both(of, value, system)))
    };
    let objective = match of {
        Some(Outcome::Carry) => None,
        Some(of) => Some(row(
            &format!("{} ", shown::words(of.name())),
            &shown::both(of, value, system),
        )),
        None => Some(row(
            &format!("{} ", optimum.search.of.expression),
            &shown::goal(&optimum.search.of, value, system),
        )),
    };
    // an objective of the roll-out is shown with the other outcomes of the roll-out
    let run = [Outcome::Total, Outcome::Run]
        .into_iter()
        .filter(|other| of.is_some_and(|of| of.needs_run() && *other != of))
        .filter_map(both);
    objective
        .into_iter()
        .chain(both(Outcome::Carry))
        .chain(run)
        .chain([row("launch", &line(LAUNCH)), row("flight", &line(FLIGHT))])
        .collect()
}

/// The comparison of the optimum with the sample of the ranges. `None` without a sample, and if the
/// message of the search already contains the comparison.
fn sample_line(optimum: &Optimum) -> Option<Line> {
    let is_told = optimum.solution.status == Status::Infeasible;
    let Sample {
        points,
        feasible,
        better,
        improved,
    } = optimum.sample.filter(|_| !is_told)?;
    let found = if improved {
        "found from a point of a sample of the ranges; "
    } else {
        ""
    };
    let is_better = match better {
        0 => format!("none of {points} other points in the ranges is better"),
        _ => format!(
            "{better} of {points} other points in the ranges are better; search from more starts, \
             for example `starts 32`"
        ),
    };
    let met = match (optimum.search.subject_to.is_empty(), feasible) {
        (true, _) => String::new(),
        (false, 0) => " (none meets the constraints)".into(),
        (false, 1) => " (1 meets the constraints)".into(),
        (false, _) => format!(" ({feasible} meet the constraints)"),
    };
    Some(Line::flush(format!("{found}{is_better}{met}")))
}

/// Adds a table of the constraints with their gains if there are any. For swings, the table of the
/// goals has their values.
fn add_constraints(document: &mut Document, optimum: &Optimum, system: System) {
    let is_one_drive = optimum.search.scenarios.is_one_drive();
    let all = optimum.constraints();
    let rows = all.iter().enumerate().map(|(j, (constraint, at))| {
        let price = constraint_in_words(optimum, j, system);
        if is_one_drive {
            let text = shown::constraint(constraint, system);
            vec![text, shown::goal(&constraint.goal, at.value, system), price]
        } else {
            vec![constraint.expression.clone(), price]
        }
    });
    // for swings, a row without a gain has no content
    let rows: Vec<_> = rows
        .filter(|row| is_one_drive || !row[1].is_empty())
        .collect();
    if rows.is_empty() {
        return;
    }
    document.add(match is_one_drive {
        true => Table::new(["subject to", "value", ""], rows).right([1]),
        false => Table::new(["subject to", ""], rows).right([]),
    });
}

fn objective(optimum: &Optimum) -> Objective {
    let goal = &optimum.search.of;
    Objective {
        of: (goal.quantity, goal.unit),
        value: optimum.value().unwrap_or_default(),
        sense: optimum.search.sense,
        is_converged: optimum.solution.status == Status::Converged,
    }
}

/// "active: +0.52 yd for each degree that the limit is relaxed".
pub(super) fn constraint_in_words(optimum: &Optimum, j: usize, system: System) -> String {
    let all = optimum.constraints();
    let Some((constraint, at)) = all.get(j) else {
        return String::new();
    };
    let slopes = optimum.solution.jacobian.get(j);
    let limit = Limit::new(constraint, at, slopes.map_or(&[], Vec::as_slice));
    objective(optimum).limit(limit, system)
}

/// "at its upper bound: +2.11 yd for each degree that it is raised".
pub(super) fn bound_in_words(optimum: &Optimum, i: usize, system: System) -> String {
    let vary = optimum.search.vary[i];
    let goal = &optimum.search.of;
    let lower = optimum.solution.lower_multipliers[i];
    let upper = optimum.solution.upper_multipliers[i];
    let value = optimum.value().unwrap_or_default();
    let gain = if optimum.search.sense == Sense::Maximize {
        1.0
    } else {
        -1.0
    };
    let of = (goal.quantity, goal.unit);
    let by = vary.parameter;
    let price = |amount: f64| {
        let amount = shown::settled(gain * amount, value, of, &[by]);
        let text = shown::price(of, amount, (by.quantity, by.unit), system);
        signed(amount, text)
    };
    let is_corner = optimum.solution.kink.is_some_and(|kink| kink.variable == i);
    if vary.low == vary.high {
        "fixed".into()
    } else if optimum.solution.status != Status::Converged {
        // multipliers have a meaning only at an optimum
        String::new()
    } else if is_corner && upper + lower > 0.0 {
        let (bound, side) = if lower > 0.0 {
            ("lower", "above")
        } else {
            ("upper", "below")
        };
        format!(
            "at its {bound} bound, a corner: {} {side} it",
            price(-(upper + lower))
        )
    } else if optimum.is_idle(i) {
        "no effect".into()
    } else {
        limits::bound([lower, upper], [lower, upper], price)
    }
}

/// The results of the searches as a table, best first, and the number of interrupted searches.
pub fn optima_document(optima: &Optima, system: System) -> Document {
    let search = &optima.best.search;
    let all = optima.starts;
    let names = search.vary.iter().map(|vary| vary.parameter.name);
    let head: Vec<&str> = [search.of.expression.as_str()]
        .into_iter()
        .chain(names)
        .chain(["starts", ""])
        .collect();
    let rows: Vec<Vec<String>> = optima
        .ended()
        .map(|local| {
            let value = local.value.map_or(shown::NONE.into(), |value| {
                shown::goal(&search.of, value, system)
            });
            let x = search.vary.iter().zip(&local.solution.x);
            let x = x.map(|(vary, x)| shown::parameter(vary.parameter, *x, system));
            let starts = format!("{} of {all}", local.starts.len());
            std::iter::once(value)
                .chain(x)
                .chain([starts, local.status().into()])
                .collect()
        })
        .collect();
    let right: Vec<usize> = (0..head.len() - 1).collect();
    let mut document = Document::default();
    if !rows.is_empty() {
        document.add(Table::new(head, rows).right(right));
    }
    if optima.stopped() > 0 {
        let stopped = counted_of(optima.stopped() as u64, all as u64, ["search", "searches"]);
        document.paragraph(format!("not listed: {stopped} stopped before the end"));
    }
    document
}

/// The setup at the best optimum as a setup file in TOML, with full precision.
///
/// # Errors
/// The errors of [`setup_toml`].
pub fn optimum_toml(optima: &Optima, swings: Option<&Swings>, preset: &Preset) -> Result<String> {
    best_toml(&optima.best, swings, optima.interrupted(), preset)
}

/// The setup at an optimum, with a note on interrupted searches.
pub(super) fn best_toml(
    optimum: &Optimum,
    swings: Option<&Swings>,
    interrupted: Option<String>,
    preset: &Preset,
) -> Result<String> {
    let search = &optimum.search;
    let value = optimum
        .value()
        .map_or(shown::NONE.into(), |value| match search.of.outcome() {
            Some(of) => shown::both(of, value, System::default()),
            None => shown::goal(&search.of, value, System::default()),
        });
    let over = match search.scenarios.is_one_drive() {
        true => String::new(),
        false => {
            let count = search.scenarios.points.len() as u64;
            format!(" over {}", counted(count, "swing"))
        }
    };
    let mut about = vec![format!(
        "{}, {} {}{over}: {value}",
        preset.name,
        search.sense.adjective(),
        search.of.expression
    )];
    match swings {
        None => {}
        Some(Swings::Recorded { .. }) => about.push("over recorded swings".into()),
        Some(Swings::Distributed { inputs, .. }) => about.extend(inputs.iter().map(|input| {
            let distribution = distribution_text(input, System::default());
            format!("over swings: {} {distribution}", input.parameter.name)
        })),
    }
    let limits = search.subject_to.iter();
    about.extend(limits.map(|constraint| format!("subject to {}", constraint.expression)));
    about.extend(
        interrupted.map(|interrupted| format!("interrupted: {interrupted}; the best so far:")),
    );
    about.push(format!("{}: {}", optimum.status(), optimum.message()));
    let remarks = search
        .vary
        .iter()
        .zip(&optimum.solution.x)
        .map(|(vary, x)| {
            let show = |value: f64| vary.parameter.show(Some(value));
            let best = shown::as_declared(vary.parameter, *x);
            let (low, high) = (show(vary.low), show(vary.high));
            (
                vary.parameter,
                format!("optimum: {best} in {low} .. {high}"),
            )
        });
    setup_toml(&optimum.setup, preset, &about, &remarks.collect::<Vec<_>>())
}

/// The progress line of an iteration.
pub fn iteration_line(search: &Search, iteration: &Iteration, system: System) -> String {
    let number = |quantity: Quantity, unit: &'static str, value: f64| {
        let unit = system.unit(unit);
        with_unit(
            &fixed(value / quantity.size_of(unit).unwrap_or(1.0), 6),
            unit,
        )
    };
    let x = search.vary.iter().zip(&iteration.x).map(|(vary, x)| {
        let parameter = vary.parameter;
        let value = number(parameter.quantity, parameter.unit, *x);
        format!("{} {value}", parameter.name)
    });
    let of = &search.of;
    let violation = if search.subject_to.is_empty() {
        String::new()
    } else {
        format!("  violation {:.1e}", iteration.violation)
    };
    format!(
        "{:>3}  {} {}  KKT {:.1e}{violation}  trust region {:.1e}{}  {}",
        iteration.number,
        of.expression,
        number(of.quantity, of.unit, search.sense.sign() * iteration.value),
        iteration.kkt_residual,
        iteration.radius,
        if iteration.accepted {
            ""
        } else {
            "  step refused"
        },
        x.collect::<Vec<_>>().join(", ")
    )
}
