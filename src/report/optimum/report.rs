//! An optimum as JSON.

use super::super::drive::{LaunchReport, LawRanges, flight, launch, law_range};
use super::super::json::{ByName, JsonNumber, Settings, settings};
use crate::drive::Outcome;
use crate::optimize::Effort;
#[cfg(test)]
use crate::study::Sense;
use crate::study::design::Improvement;
use crate::study::{ConstraintAtEnd, LocalOptimum, Optima, Optimum, Sample};
use serde::Serialize;

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
    pub value: JsonNumber,
    /// The varied parameters at the optimum, SI.
    pub optimum: Option<ByName<JsonNumber>>,
    /// The varied parameters at the start, if no point of the search has a value; otherwise
    /// omitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<ByName<JsonNumber>>,
    /// The drive before the search; `null` for swings.
    pub as_set_up: Option<StartReport>,
    /// The gradient of the objective at the optimum by the varied parameters, SI.
    pub gradient: Option<ByName<JsonNumber>>,
    /// The multipliers of the bounds of each varied parameter, SI.
    pub multipliers: Option<ByName<Multipliers>>,
    /// The constraints.
    pub constraints: Vec<ConstraintReport>,
    /// The relative KKT residual.
    pub kkt_residual: JsonNumber,
    /// Iterations of the optimizer.
    pub iterations: u64,
    /// Evaluations of objective and constraints with derivatives.
    pub evaluations: u64,
    /// Counters of the quadratic programs that were solved for the steps.
    pub steps: Effort,
    /// The sample of the ranges for comparison with the optimum; `null` for swings, and after an
    /// interruption.
    pub sample: Option<Sample>,
    /// Every parameter at the optimum. `setup`, `launch` and `flight` are `null` if no drive flies.
    pub setup: Option<Settings>,
    /// The launch of the optimal drive; `null` for swings.
    pub launch: Option<LaunchReport>,
    /// The flight of the optimal drive; `null` for swings.
    #[cfg_attr(test, schemars(schema_with = "super::super::drive::flight_schema"))]
    pub flight: Option<ByName<JsonNumber>>,
    /// The fitted ranges of the law, each with the range that the optimal flight covers; `null` if
    /// there is no air or no flight, and for swings.
    pub law_range: Option<LawRanges>,
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
    /// The gain of the objective for each SI unit by which the limit is relaxed, ≥ 0. An equation
    /// has the gain for each SI unit by which its right side is raised. For `robust`, the gain is
    /// the decrease of the greatest loss. This decrease is negative if relaxing the limit helps the
    /// best design of a model more than the robust design.
    pub multiplier: f64,
}

impl ConstraintReport {
    pub(in crate::report) fn new(limit: &ConstraintAtEnd<'_>) -> Self {
        Self {
            expression: limit.constraint.expression.clone(),
            value: limit.at.value,
            violation: limit.at.violation.abs(),
            multiplier: limit.gain,
        }
    }
}

/// A local optimum from a search with several starts.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LocalReport {
    /// The status of the searches that reached this optimum.
    pub status: &'static str,
    /// The objective, SI; `null` if no drive flies.
    pub value: JsonNumber,
    /// The varied parameters, SI.
    pub optimum: ByName<JsonNumber>,
    /// The number of starts that reached this optimum.
    pub starts: usize,
}

impl LocalReport {
    /// The local optima. The results of interrupted searches are omitted.
    pub(super) fn all(optima: &Optima) -> Vec<Self> {
        let vary = &optima.best.search.vary;
        let one = |local: &LocalOptimum| Self {
            status: local.status(),
            value: local.value.into(),
            optimum: ByName::of_varied(vary, &local.solution.x),
            starts: local.starts.len(),
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

/// The drive before a search over one drive, SI.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct StartReport {
    /// The varied parameters before the search, SI; `null` for a parameter without a value.
    pub parameters: ByName<JsonNumber>,
    /// The carry, m; `null` if the drive does not fly.
    pub carry: JsonNumber,
    /// The total, m; `null` if the ball does not come to rest.
    pub total: JsonNumber,
}

impl StartReport {
    fn new(optimum: &Optimum) -> Option<Self> {
        if !optimum.search.scenarios.is_one_drive() {
            return None;
        }
        let vary = optimum.search.parameters();
        let parameters = vary.map(|parameter| (parameter.name, optimum.start.value(parameter)));
        let drive = optimum.drive_as_set_up.as_ref();
        let outcome = |of: Outcome| JsonNumber(drive.and_then(|drive| of.value(drive)));
        Some(Self {
            parameters: parameters.collect(),
            carry: outcome(Outcome::Carry),
            total: outcome(Outcome::Total),
        })
    }
}

impl OptimumReport {
    /// The report of an optimum.
    pub fn new(optimum: &Optimum) -> Self {
        let (solution, vary) = (&optimum.solution, &optimum.search.vary);
        let found = optimum.value().is_some();
        let by_name = |values: &[f64]| ByName::of_varied(vary, values);
        let multipliers = |i: usize| {
            let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
            (vary[i].parameter.name, Multipliers { lower, upper })
        };
        let drive = optimum.drive.as_ref();
        let constraints = optimum.constraints();
        Self {
            objective: optimum.search.of.expression.clone(),
            sense: optimum.search.sense.name(),
            value: optimum.value().into(),
            optimum: found.then(|| by_name(&solution.x)),
            start: (!found).then(|| by_name(&solution.x)),
            as_set_up: StartReport::new(optimum),
            gradient: found.then(|| by_name(&optimum.gradient())),
            multipliers: found.then(|| (0..vary.len()).map(multipliers).collect()),
            constraints: constraints.iter().map(ConstraintReport::new).collect(),
            kkt_residual: found.then_some(solution.residual.largest()).into(),
            iterations: solution.iterations,
            evaluations: solution.effort.evaluations,
            steps: solution.effort,
            sample: optimum.sample,
            setup: found.then(|| settings(&optimum.setup)),
            launch: drive.map(launch),
            flight: drive.and_then(flight),
            law_range: drive.and_then(|drive| law_range(&optimum.setup, drive)),
        }
    }
}

/// The limits of a design, and its changes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DesignLimits {
    /// The rules that limit the design: `golf`, the Rules of Golf, or `none`.
    #[cfg_attr(test, schemars(extend("enum" = ["golf", "none"])))]
    pub rules: &'static str,
    /// The assumptions, in sentences.
    pub notes: Vec<String>,
    /// The values of the varied parameters before the search.
    pub as_set_up: ByName<JsonNumber>,
    /// The goals before the search and with the best design, over all swings; empty without a best
    /// design.
    pub parts: Vec<Improvement>,
    /// The rules and limits.
    pub held: Vec<LimitReport>,
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
    /// How the search enforces the limit: as `bound` of a varied parameter, or as `limit` in a
    /// constraint. `value` if no varied parameter changes the limited expression; `unknown` if the
    /// value of the expression is unknown.
    #[cfg_attr(test, schemars(extend("enum" = ["bound", "limit", "value", "unknown"])))]
    pub by: &'static str,
    /// The lower limit, SI; `null` without one.
    pub low: JsonNumber,
    /// The upper limit, SI; `null` without one.
    pub high: JsonNumber,
    /// The value of the expression, SI; `null` if it is unknown.
    pub value: JsonNumber,
    /// The distance from the nearer limit, SI; negative if the limit is violated.
    pub margin: JsonNumber,
    /// The multiplier of an active limit: the gain of the goal per SI unit by which the limit is
    /// relaxed; `null` if the limit is inactive.
    pub price: JsonNumber,
}
