use super::drive::readable;
use super::{json, table::table};
use crate::drive::Outcome;
use crate::optimize::Iteration;
use crate::study::{Optimum, Search};
use crate::units::{Quantity, per, significant};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// An optimum as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct OptimumReport {
    /// `converged`, `stalled-at-kink`, `stalled`, `iteration-limit` or `no-flight`.
    pub status: &'static str,
    /// The same in a sentence, with numbers.
    pub message: String,
    /// The outcome made large.
    pub objective: &'static str,
    /// Its value; `null` where nothing flew.
    pub value: Value,
    /// Where it is, by parameter.
    pub optimum: Option<Map<String, Value>>,
    /// The outcome's gradient there.
    pub gradient: Option<Map<String, Value>>,
    /// The price of each bound, ≥ 0: what a unit beyond it would bring.
    pub multipliers: Option<BTreeMap<&'static str, Multipliers>>,
    /// Constraints on outcomes: none yet.
    pub constraints: [(); 0],
    /// The KKT residual, relative.
    pub kkt_residual: Value,
    /// Iterations taken.
    pub iterations: u64,
    /// Drives with derivatives evaluated.
    pub evaluations: u64,
    /// What deserves a word.
    pub warnings: Vec<String>,
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
    /// The report of a search.
    pub fn new(optimum: &Optimum, warnings: Vec<String>) -> Self {
        let (solution, vary) = (&optimum.solution, &optimum.search.vary);
        let found = optimum.value().is_some();
        let by_name = |values: &[f64]| {
            let names = vary.iter().map(|vary| vary.parameter.name);
            found.then(|| json::named(names.zip(values.iter().map(|value| Some(*value)))))
        };
        let multipliers = |i: usize| {
            let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
            (vary[i].parameter.name, Multipliers { lower, upper })
        };
        Self {
            status: optimum.status(),
            message: optimum.message(),
            objective: optimum.search.maximize.name(),
            value: json::number(optimum.value()),
            optimum: by_name(&solution.x),
            gradient: by_name(&optimum.gradient()),
            multipliers: found.then(|| (0..vary.len()).map(multipliers).collect()),
            constraints: [],
            kkt_residual: json::number(found.then_some(solution.kkt_residual)),
            iterations: solution.iterations,
            evaluations: solution.evaluations,
            warnings,
        }
    }
}

/// An optimum as a short text: where it is, what holds it there and what more would bring, and the drive.
pub fn optimum_text(optimum: &Optimum) -> String {
    let (search, solution) = (&optimum.search, &optimum.solution);
    let of = search.maximize;
    let ending = format!(
        "{}: {} ({} iterations, {} evaluations)\n",
        optimum.status(),
        optimum.message(),
        solution.iterations,
        solution.evaluations
    );
    let (Some(value), Some(drive)) = (optimum.value(), &optimum.drive) else { return ending };

    let rows = search.vary.iter().enumerate().map(|(i, vary)| {
        let show = |value: f64| vary.parameter.show(Some(value));
        vec![
            vary.parameter.name.into(),
            show(solution.x[i]),
            format!("{} .. {}", show(vary.low), show(vary.high)),
            bound_in_words(optimum, i),
        ]
    });
    let place = table(&["vary", "optimum", "range", ""], &[1], rows);

    let launch = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Backspin, Outcome::SmashFactor];
    let flight = [Outcome::ApexHeight, Outcome::DescentAngle, Outcome::FlightTime, Outcome::Lateral];
    let line = |outcomes: [Outcome; 4]| {
        let one = |outcome: Outcome| {
            let value = outcome.value(drive).map_or("–".into(), |v| readable(outcome, v));
            format!("{} {value}", outcome.name().replace('_', " "))
        };
        outcomes.map(one).join(", ")
    };
    let carry = Outcome::Carry
        .value(drive)
        .map_or(String::new(), |carry| format!("  {:<8}{}\n", "carry", length_both_ways(carry)));
    let objective =
        if of == Outcome::Carry { String::new() } else { format!("  {:<8}{}\n", format!("{} ", of.name().replace('_', " ")), of.show(value)) };
    format!(
        "{ending}\n{place}\n{objective}{carry}  {:<8}{}\n  {:<8}{}\n",
        "launch",
        line(launch),
        "flight",
        line(flight)
    )
}

/// "at its upper bound: +2.11 yd per deg beyond it".
fn bound_in_words(optimum: &Optimum, i: usize) -> String {
    let (vary, of) = (optimum.search.vary[i], optimum.search.maximize);
    let size = vary.parameter.quantity.size_of(vary.parameter.unit).unwrap_or(1.0);
    let unit = of.quantity().size_of(of.unit()).unwrap_or(1.0);
    let (lower, upper) = (optimum.solution.lower_multipliers[i], optimum.solution.upper_multipliers[i]);
    let at = |bound: &str, multiplier: f64| {
        let price = significant(multiplier * size / unit, 3);
        format!("at its {bound} bound: +{price} {} beyond it", per(of.unit(), vary.parameter.unit))
    };
    if vary.low == vary.high {
        "fixed".into()
    } else if upper > 0.0 {
        at("upper", upper)
    } else if lower > 0.0 {
        at("lower", lower)
    } else {
        "free".into()
    }
}

fn length_both_ways(metres: f64) -> String {
    let yard = Quantity::LENGTH.size_of("yd").unwrap_or(1.0);
    format!("{:.1} m = {:.1} yd", metres, metres / yard)
}

/// One iteration as a line of progress.
pub fn iteration_line(search: &Search, iteration: &Iteration) -> String {
    let of = search.maximize;
    let x = search.vary.iter().zip(&iteration.x).map(|(vary, x)| {
        let size = vary.parameter.quantity.size_of(vary.parameter.unit).unwrap_or(1.0);
        format!("{} {:.6} {}", vary.parameter.name, x / size, vary.parameter.unit).trim_end().to_owned()
    });
    format!(
        "{:>3}  {} {:.6} {}  KKT {:.1e}  trust region {:.1e}{}  {}",
        iteration.number,
        of.name(),
        -iteration.value,
        of.quantity().si,
        iteration.kkt_residual,
        iteration.radius,
        if iteration.kept { "" } else { "  step refused" },
        x.collect::<Vec<_>>().join(", ")
    )
}
