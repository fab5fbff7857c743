use super::drive::{flight, launch, law_range};
use super::limits::{self, Limit, Sought, ended_at};
use super::lines::paragraph;
use super::table::table;
use super::{Reply, json, setup_toml, shown};
use crate::drive::Outcome;
use crate::error::Result;
use crate::optimize::{Constrained, Effort, Iteration, Status};
use crate::parameters::Preset;
use crate::study::swings::GoalLimit;
use crate::study::{Optima, Optimum, Sample, Search, Sense, Vary};
use crate::units::{Message, Quantity, System, counted, counted_of, fixed, signed, with_unit};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// An optimum as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct OptimumReport {
    /// The outcome that is sought; over many swings what of it.
    pub objective: String,
    /// Which value of it: `maximize` or `minimize`.
    pub sense: &'static str,
    /// Its value; `null` where nothing flew.
    pub value: Value,
    /// Where it is, by parameter.
    pub optimum: Option<Map<String, Value>>,
    /// Where the search began, by parameter, if no point of it has a value; left out elsewhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<Map<String, Value>>,
    /// The outcome's gradient there.
    pub gradient: Option<Map<String, Value>>,
    /// The price of each bound, ≥ 0: what a unit beyond it would bring.
    pub multipliers: Option<BTreeMap<&'static str, Multipliers>>,
    /// The constraints on outcomes.
    pub constraints: Vec<ConstraintReport>,
    /// The KKT residual, relative.
    pub kkt_residual: Value,
    /// Iterations taken.
    pub iterations: u64,
    /// Drives with derivatives evaluated.
    pub evaluations: u64,
    /// How the quadratic programs of the steps were solved.
    pub steps: Effort,
    /// The local optima of a search from many starts, best first; `null` after a search from one.
    pub optima: Option<Vec<LocalReport>>,
    /// The sample of the ranges that the optimum was compared with; `null` where there was none.
    pub sample: Option<Sample>,
    /// Every parameter of the best drive; `null`, as its launch and flight, where nothing flew.
    pub setup: Option<Map<String, Value>>,
    /// Its launch.
    pub launch: Option<Map<String, Value>>,
    /// Its flight.
    pub flight: Option<Map<String, Value>>,
    /// What the law was fitted to, and how much of the best drive's flight is outside.
    pub law_range: Option<Map<String, Value>>,
    /// The setup file that was written; `null` where none was.
    pub file: Option<String>,
    /// What was found over many swings; left out where the search is of one drive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swings: Option<Value>,
    /// What holds a design; left out where none is sought.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub design: Option<Value>,
}

/// A constraint at an optimum.
#[derive(Clone, Debug, Serialize)]
pub struct ConstraintReport {
    /// As it was given.
    pub expression: String,
    /// The outcome's value, SI.
    pub value: f64,
    /// How far it is beyond its limits, SI; 0 where it keeps them.
    pub violation: f64,
    /// What the objective would gain per unit that the limit is relaxed, ≥ 0; for an equation, that
    /// it is raised.
    pub multiplier: f64,
}

impl ConstraintReport {
    /// The report of a limit of a goal.
    pub(super) fn of_goal(limit: &GoalLimit, at: &Constrained) -> Self {
        Self::new(&limit.expression, limit.low == limit.high, at)
    }

    fn new(expression: &str, is_equation: bool, at: &Constrained) -> Self {
        // what f falls by, the outcome gains
        let multiplier = if is_equation {
            at.multiplier
        } else {
            at.multiplier.abs()
        };
        Self {
            expression: expression.into(),
            value: at.value,
            violation: at.violation.abs(),
            multiplier,
        }
    }
}

/// A local optimum of a search from many starts.
#[derive(Clone, Debug, Serialize)]
pub struct LocalReport {
    /// How the searches ended here.
    pub status: &'static str,
    /// The outcome's value; `null` where nothing flew.
    pub value: Value,
    /// Where it is, by parameter.
    pub optimum: Map<String, Value>,
    /// How many starts ended here.
    pub starts: usize,
}

impl LocalReport {
    /// The reports of local optima: of searches that came to an end.
    pub fn all(optima: &Optima) -> Vec<Self> {
        let one = |(best, starts): &(Optimum, Vec<usize>)| {
            let names = best.search.vary.iter().map(|vary| vary.parameter.name);
            Self {
                status: best.status(),
                value: json::number(best.value()),
                optimum: json::named(names.zip(best.solution.x.iter().map(|x| Some(*x)))),
                starts: starts.len(),
            }
        };
        optima.ended().map(one).collect()
    }
}

/// The prices of a parameter's bounds.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Multipliers {
    /// Of the lower bound.
    pub lower: f64,
    /// Of the upper bound.
    pub upper: f64,
}

impl OptimumReport {
    /// The answer of `optimize`: the status and the message are the search's. The local optima are
    /// listed where there was more than one start.
    ///
    /// # Errors
    /// As [`Optima::best`].
    pub fn reply(optima: &Optima, warnings: Vec<Message>) -> Result<Reply<Self>> {
        let best = optima.best()?;
        let reply = Reply::done("optimize", warnings, Self::of_many(best, optima));
        Ok(match optima.interrupted() {
            None => reply.ended(best.status(), Some(best.message().to_string())),
            interrupted => reply.ended("interrupted", interrupted),
        })
    }

    /// The report of the best of some searches.
    pub(super) fn of_many(best: &Optimum, optima: &Optima) -> Self {
        Self {
            optima: (optima.starts > 1).then(|| LocalReport::all(optima)),
            ..Self::new(best)
        }
    }

    /// The report of a search.
    pub fn new(optimum: &Optimum) -> Self {
        let (solution, vary) = (&optimum.solution, &optimum.search.vary);
        let found = optimum.value().is_some();
        let by_name = |values: &[f64]| {
            let names = vary.iter().map(|vary| vary.parameter.name);
            json::named(names.zip(values.iter().map(|value| Some(*value))))
        };
        let multipliers = |i: usize| {
            let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
            (vary[i].parameter.name, Multipliers { lower, upper })
        };
        Self {
            objective: optimum.search.of.name().into(),
            sense: optimum.search.sense.name(),
            value: json::number(optimum.value()),
            optimum: found.then(|| by_name(&solution.x)),
            start: (!found).then(|| by_name(&solution.x)),
            gradient: found.then(|| by_name(&optimum.gradient())),
            multipliers: found.then(|| (0..vary.len()).map(multipliers).collect()),
            constraints: constraints(optimum),
            kkt_residual: json::number(found.then_some(solution.kkt_residual)),
            iterations: solution.iterations,
            evaluations: solution.evaluations,
            steps: solution.effort,
            optima: None,
            sample: optimum.sample,
            setup: optimum.drive.as_ref().map(|_| json::setup(&optimum.setup)),
            launch: optimum.drive.as_ref().map(launch),
            flight: optimum.drive.as_ref().and_then(flight),
            law_range: optimum
                .drive
                .as_ref()
                .and_then(|drive| law_range(&optimum.setup, drive)),
            file: None,
            swings: None,
            design: None,
        }
    }
}

pub(super) fn constraints(optimum: &Optimum) -> Vec<ConstraintReport> {
    let constraints = optimum
        .search
        .subject_to
        .iter()
        .zip(&optimum.solution.constraints);
    constraints
        .map(|(of, at)| ConstraintReport::new(&of.expression, of.is_equation(), at))
        .collect()
}

/// An optimum as a short text: where it is, which bounds it lies on and what moving them would
/// bring, and the drive.
pub fn optimum_text(optimum: &Optimum, system: System) -> String {
    let (search, solution) = (&optimum.search, &optimum.solution);
    let of = search.of;
    let ending = paragraph(&format!(
        "{}: {} ({}, {})",
        optimum.status(),
        optimum.message().in_units(system),
        counted(solution.iterations, "iteration"),
        counted(solution.evaluations, "evaluation")
    ));
    let (Some(value), Some(drive)) = (optimum.value(), &optimum.drive) else {
        return ending;
    };
    let ending = ending + &sample_text(optimum);

    let rows = search.vary.iter().enumerate().map(|(i, vary)| {
        vec![
            vary.parameter.name.into(),
            shown::within(vary, solution.x[i], system),
            shown::range(vary, system),
            bound_in_words(optimum, i, system),
        ]
    });
    let place = table(
        &["vary", ended_at(solution.status, "optimum"), "range", ""],
        &[1],
        rows,
    ) + &constraints_text(optimum, system);

    let launch = [
        Outcome::BallSpeed,
        Outcome::LaunchAngle,
        Outcome::Backspin,
        Outcome::SmashFactor,
    ];
    let flight = [
        Outcome::ApexHeight,
        Outcome::DescentAngle,
        Outcome::FlightTime,
        Outcome::Lateral,
    ];
    let line = |outcomes: [Outcome; 4]| {
        let one = |outcome: Outcome| {
            let value = shown::outcome_or_dash(outcome, outcome.value(drive), system);
            format!("{} {value}", shown::words(outcome.name()))
        };
        outcomes.map(one).join(", ")
    };
    let row = |name: &str, text: &str| format!("  {name:<8}{text}\n");
    let carry = Outcome::Carry
        .value(drive)
        .map(|carry| row("carry", &shown::both(Outcome::Carry, carry, system)));
    let objective = (of != Outcome::Carry).then(|| {
        row(
            &format!("{} ", shown::words(of.name())),
            &shown::both(of, value, system),
        )
    });
    // what is sought of the run is told with the rest of it
    let run = [Outcome::Total, Outcome::Run]
        .into_iter()
        .filter(|other| of.needs_run() && *other != of);
    let run = run.filter_map(|other| {
        Some(row(
            other.name(),
            &shown::both(other, other.value(drive)?, system),
        ))
    });
    format!(
        "{ending}\n{place}\n{}{}{}{}{}",
        objective.unwrap_or_default(),
        carry.unwrap_or_default(),
        run.collect::<String>(),
        row("launch", &line(launch)),
        row("flight", &line(flight))
    )
}

/// How the optimum compares with the sample of the ranges; empty without one, and where the message
/// says it.
fn sample_text(optimum: &Optimum) -> String {
    let is_told = optimum.solution.status == Status::Infeasible;
    let Some(Sample {
        points,
        feasible,
        better,
        improved,
    }) = optimum.sample.filter(|_| !is_told)
    else {
        return String::new();
    };
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
    paragraph(&format!("{found}{is_better}{met}"))
}

/// The constraints with their prices, as a table; empty without any.
fn constraints_text(optimum: &Optimum, system: System) -> String {
    let reports = constraints(optimum);
    if reports.is_empty() {
        return String::new();
    }
    let rows = optimum
        .search
        .subject_to
        .iter()
        .zip(reports)
        .enumerate()
        .map(|(j, (constraint, report))| {
            let value = shown::outcome(constraint.outcome, report.value, system);
            vec![
                shown::constraint(constraint, system),
                value,
                constraint_in_words(optimum, j, system),
            ]
        });
    format!("\n{}", table(&["subject to", "value", ""], &[1], rows))
}

/// "active: +0.52 yd for each degree that the limit is relaxed".
pub(super) fn constraint_in_words(optimum: &Optimum, j: usize, system: System) -> String {
    let (of, constraint) = (optimum.search.of, &optimum.search.subject_to[j]);
    let sought = Sought {
        of: (of.quantity(), of.unit()),
        value: optimum.value().unwrap_or_default(),
        sense: optimum.search.sense,
        is_converged: optimum.solution.status == Status::Converged,
    };
    let limit = Limit::new(
        (constraint.outcome.quantity(), constraint.outcome.unit()),
        [constraint.low, constraint.high],
        &optimum.solution.constraints[j],
        optimum.solution.jacobian.get(j).map_or(&[], Vec::as_slice),
    );
    sought.limit(limit, system)
}

/// The setup at the best of some optima as a setup file in TOML, to the last digit.
///
/// # Errors
/// As [`setup_toml`]; as [`Optima::best`].
pub fn optimum_toml(optima: &Optima, preset: &Preset) -> Result<String> {
    best_toml(optima.best()?, optima.interrupted(), preset)
}

/// The same of one optimum, and how its search was interrupted.
pub(super) fn best_toml(
    optimum: &Optimum,
    interrupted: Option<String>,
    preset: &Preset,
) -> Result<String> {
    let search = &optimum.search;
    let of = search.of;
    let value = optimum.value().map_or("–".into(), |value| {
        shown::both(of, value, System::default())
    });
    let mut about = vec![format!(
        "{}, {} {}: {value}",
        preset.name,
        search.sense.adjective(),
        of.name()
    )];
    about.extend(
        search
            .subject_to
            .iter()
            .map(|constraint| format!("subject to {}", constraint.expression)),
    );
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
            (
                vary.parameter,
                format!(
                    "optimum: {best} in {} .. {}",
                    show(vary.low),
                    show(vary.high)
                ),
            )
        });
    setup_toml(&optimum.setup, preset, &about, &remarks.collect::<Vec<_>>())
}

/// The ends of the searches as a table, best first, and how many searches were stopped before
/// theirs.
pub fn optima_text(optima: &Optima, system: System) -> String {
    let Some((first, _)) = optima.locals.first() else {
        return String::new();
    };
    let search = &first.search;
    let rows = optima.ended().map(|(best, starts)| {
        let value = shown::outcome_or_dash(search.of, best.value(), system);
        (value, &best.solution.x[..], starts.len(), best.status())
    });
    ends_text(
        (search.of.name(), &search.vary),
        rows,
        (optima.starts, optima.stopped()),
        system,
    )
}

/// The ends of searches for what is named, each with its value, place, number of starts and status,
/// as a table, and how many of all searches were stopped before theirs.
pub(super) fn ends_text<'a>(
    (of, vary): (&str, &[Vary]),
    ends: impl Iterator<Item = (String, &'a [f64], usize, &'static str)>,
    (all, stopped): (usize, usize),
    system: System,
) -> String {
    let names = vary.iter().map(|vary| vary.parameter.name);
    let head: Vec<&str> = [of]
        .into_iter()
        .chain(names)
        .chain(["starts", ""])
        .collect();
    let rows = ends.map(|(value, x, starts, status)| {
        let x = vary
            .iter()
            .zip(x)
            .map(|(vary, x)| shown::parameter(vary.parameter, *x, system));
        std::iter::once(value)
            .chain(x)
            .chain([format!("{starts} of {all}"), status.into()])
            .collect()
    });
    let right: Vec<usize> = (0..head.len() - 1).collect();
    let rows: Vec<Vec<String>> = rows.collect();
    let listed = if rows.is_empty() {
        String::new()
    } else {
        format!("\n{}", table(&head, &right, rows))
    };
    let stopped = match stopped {
        0 => String::new(),
        stopped => format!(
            "\nnot listed: {} stopped before the end\n",
            counted_of(stopped as u64, all as u64, ["search", "searches"])
        ),
    };
    listed + &stopped
}

/// "at its upper bound: +2.11 yd for each degree that it is raised".
pub(super) fn bound_in_words(optimum: &Optimum, i: usize, system: System) -> String {
    let (vary, of) = (optimum.search.vary[i], optimum.search.of);
    let (lower, upper) = (
        optimum.solution.lower_multipliers[i],
        optimum.solution.upper_multipliers[i],
    );
    let value = optimum.value().unwrap_or_default();
    let gain = if optimum.search.sense == Sense::Maximize {
        1.0
    } else {
        -1.0
    };
    let price = |amount: f64| {
        let by = vary.parameter;
        let amount = shown::settled(gain * amount, value, (of.quantity(), of.unit()), &[by]);
        signed(
            amount,
            shown::price(
                (of.quantity(), of.unit()),
                amount,
                (by.quantity, by.unit),
                system,
            ),
        )
    };
    let is_corner = optimum.solution.kink.is_some_and(|kink| kink.variable == i);
    if vary.low == vary.high {
        "fixed".into()
    } else if optimum.solution.status != Status::Converged {
        // a multiplier is a price at an optimum only
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

/// One iteration as a line of progress.
pub fn iteration_line(search: &Search, iteration: &Iteration, system: System) -> String {
    let of = search.of;
    let number = |quantity: Quantity, unit: &'static str, value: f64| {
        let unit = system.unit(unit);
        with_unit(
            &fixed(value / quantity.size_of(unit).unwrap_or(1.0), 6),
            unit,
        )
    };
    let x = search.vary.iter().zip(&iteration.x).map(|(vary, x)| {
        format!(
            "{} {}",
            vary.parameter.name,
            number(vary.parameter.quantity, vary.parameter.unit, *x)
        )
    });
    format!(
        "{:>3}  {} {}  KKT {:.1e}{}  trust region {:.1e}{}  {}",
        iteration.number,
        of.name(),
        number(
            of.quantity(),
            of.unit(),
            search.sense.sign() * iteration.value
        ),
        iteration.kkt_residual,
        if search.subject_to.is_empty() {
            String::new()
        } else {
            format!("  violation {:.1e}", iteration.violation)
        },
        iteration.radius,
        if iteration.kept { "" } else { "  step refused" },
        x.collect::<Vec<_>>().join(", ")
    )
}
