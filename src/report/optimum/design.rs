//! A design with its limits and its changes as JSON.

use super::super::json::{ByName, Number};
use serde::Serialize;

/// The limits of a design, and its changes.
#[derive(Clone, Debug, Serialize)]
pub struct DesignReport {
    /// The rules: `golf` or `none`.
    pub rules: &'static str,
    /// The assumptions, in sentences.
    pub notes: Vec<String>,
    /// The values of the varied parameters before the search.
    pub as_set_up: ByName<Number>,
    /// The goals before the search and with the best design.
    pub parts: Vec<GoalReport>,
    /// The rules and limits.
    pub held: Vec<LimitReport>,
}

/// A goal before the search and with the best design.
#[derive(Clone, Debug, Serialize)]
pub struct GoalReport {
    /// The goal.
    pub goal: String,
    /// The value of the goal before the search.
    pub as_set_up: Number,
    /// The value of the goal with the best design.
    pub best: Number,
}

/// A rule or limit of a design.
#[derive(Clone, Debug, Serialize)]
pub struct LimitReport {
    /// The name of the rule or limit.
    pub name: String,
    /// The limited expression.
    pub expression: String,
    /// The source of the rule; `null` for a limit of the user.
    pub source: Option<&'static str>,
    /// The kind of enforcement: `bound`, `limit`, `value` or `unknown`.
    pub by: &'static str,
    /// The lower limit; `null` without one.
    pub low: Number,
    /// The upper limit; `null` without one.
    pub high: Number,
    /// The value of the expression.
    pub value: Number,
    /// The distance from the nearer limit.
    pub margin: Number,
    /// The multiplier of an active limit.
    pub price: Number,
}
