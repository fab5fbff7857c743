//! A design with its limits and its changes as JSON.

use super::super::json::{ByName, Number};
use serde::Serialize;

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
