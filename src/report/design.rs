use super::json::Number;
use super::limits::ended_at;
use super::lines::paragraph;
use super::optimum::{DesignReport, GoalReport, LimitReport, OptimumReport};
use super::table::table;
use super::{Reply, shown};
use crate::parameters::{Parameter, Setup};
use crate::study::Optimum;
use crate::study::Sense;
use crate::study::design::{ConstraintState, Design, Enforcement, Improvement};
use crate::units::{System, signed};

/// Values below this fraction of the limit's step are displayed as 0.
const ROUNDING: f64 = 1e-6;

/// A design with its limits and its changes.
#[derive(Clone, Copy, Debug)]
pub struct Designed<'a> {
    /// The search with its rules and limits.
    pub design: &'a Design,
    /// The setup before the search.
    pub setup: &'a Setup<f64>,
    /// The best design.
    pub best: &'a Optimum,
    /// The goals before and after.
    pub improvements: &'a [Improvement],
    /// The assumptions, in sentences.
    pub notes: &'a [String],
}

impl Designed<'_> {
    /// The answer of `design`: the answer of the search, with the rules and limits.
    pub fn reply(&self, swings: Reply<OptimumReport>) -> Reply<OptimumReport> {
        let before = self
            .best
            .search
            .vary
            .iter()
            .map(|vary| (vary.parameter.name, self.own(vary.parameter)));
        let part = |part: &Improvement| GoalReport {
            goal: part.goal.expression.clone(),
            as_set_up: part.as_set_up.into(),
            best: part.best.into(),
        };
        let states = self.design.constraint_states(self.best);
        let design = DesignReport {
            rules: if self.design.is_under_rules {
                "golf"
            } else {
                "none"
            },
            notes: self.notes.to_vec(),
            as_set_up: before.collect(),
            parts: self.improvements.iter().map(part).collect(),
            held: states.iter().map(limit_report).collect(),
        };
        let body = OptimumReport {
            design: Some(design),
            ..swings.body
        };
        Reply {
            command: Some("design"),
            body,
            ..swings
        }
    }

    /// The design as text, which follows the text of the search.
    pub fn text(&self, system: System) -> String {
        let solution = &self.best.solution;
        let change = |text: String, amount: f64| signed(amount, text);
        let own = self
            .best
            .search
            .vary
            .iter()
            .zip(&solution.x)
            .map(|(vary, x)| {
                let before = self.own(vary.parameter);
                let show = |value: f64| shown::within(vary, value, system);
                let difference = before.map_or(String::new(), |before| {
                    let unit = system.unit(vary.parameter.unit);
                    change(
                        vary.parameter
                            .quantity
                            .read_off_difference(x - before, unit),
                        x - before,
                    )
                });
                vec![
                    vary.parameter.name.into(),
                    before.map_or(shown::NONE.into(), show),
                    show(*x),
                    difference,
                ]
            });
        let parts = self.improvements.iter().map(|part| {
            let show = |value: Option<f64>| {
                value.map_or(shown::NONE.into(), |value| {
                    shown::goal(&part.goal, value, system)
                })
            };
            let both = part.as_set_up.zip(part.best);
            let difference = both.map_or(String::new(), |(before, best)| {
                change(
                    shown::goal_difference(&part.goal, best - before, system),
                    best - before,
                )
            });
            vec![
                part.goal.expression.clone(),
                show(part.as_set_up),
                show(part.best),
                difference,
            ]
        });
        let rows: Vec<_> = if self.best.value().is_some() {
            own.chain(parts).collect()
        } else {
            vec![]
        };
        let mut text = String::new();
        if !rows.is_empty() {
            let found = ended_at(solution.status, "best");
            text += &format!(
                "\n{}",
                table(&["design", "as set up", found, "change"], &[1, 2, 3], rows)
            );
            let rows = self
                .design
                .constraint_states(self.best)
                .into_iter()
                .map(|state| self.row(&state, system));
            let rows: Vec<_> = rows.collect();
            if !rows.is_empty() {
                text += &format!("\n{}", table(&["rule or limit", "", found, ""], &[2], rows));
            }
        }
        let rules = if self.design.is_under_rules {
            "under the Rules of Golf (docs/design.md has their sources)"
        } else {
            "without the Rules of Golf (`rules none`)"
        };
        let lines = std::iter::once(rules).chain(self.notes.iter().map(String::as_str));
        text + "\n" + &lines.map(paragraph).collect::<String>()
    }

    /// The value of a parameter in the setup; for an unset parameter, its equivalent number if any.
    fn own(&self, parameter: &Parameter) -> Option<f64> {
        self.setup.value(parameter).or(parameter.unset)
    }

    /// The cells of a rule or limit: its value, and its margin or multiplier.
    fn row(&self, state: &ConstraintState, system: System) -> Vec<String> {
        let ConstraintState {
            constraint,
            value,
            margin,
            price,
        } = state;
        let show = |value: f64| {
            let value = if value.abs() < ROUNDING * constraint.step {
                0.0
            } else {
                value
            };
            shown::given(constraint.quantity, constraint.unit, value, system, 5)
        };
        let goal = &self.best.search.of;
        let told = match (constraint.by, price, margin) {
            (Enforcement::Unknown, ..) => "not checked; it can be stated as a relation".into(),
            (Enforcement::Value(_), _, Some(_)) => "met; no varied parameter changes it".into(),
            (_, Some(price), _) => {
                let amount = price
                    * constraint.step
                    * if self.best.search.sense == Sense::Maximize {
                        1.0
                    } else {
                        -1.0
                    };
                let is_upper = value.is_some_and(|value| {
                    constraint.range[1] - value <= value - constraint.range[0]
                });
                let way = if is_upper { "raised" } else { "lowered" };
                let gain = signed(amount, shown::goal_difference(goal, amount, system));
                format!(
                    "{gain} for each {} that the limit is {way}",
                    constraint.quantity.show(constraint.step, constraint.unit)
                )
            }
            (_, None, Some(margin)) if *margin < -ROUNDING * constraint.step => {
                format!("violated by {}", show(-margin))
            }
            (_, None, Some(margin)) => format!("{} to spare", show(margin.max(0.0))),
            (_, None, None) => String::new(),
        };
        vec![
            constraint.name.clone(),
            constraint.expression.clone(),
            value.map_or(shown::NONE.into(), show),
            told,
        ]
    }
}

/// The report of a rule or limit.
fn limit_report(state: &ConstraintState) -> LimitReport {
    let constraint = &state.constraint;
    let end = |end: f64| Number(Some(end).filter(|end| end.is_finite()));
    LimitReport {
        name: constraint.name.clone(),
        expression: constraint.expression.clone(),
        source: constraint.rule.map(|rule| rule.source),
        by: match constraint.by {
            Enforcement::Bound(_) => "bound",
            Enforcement::Limit(_) => "limit",
            Enforcement::Value(_) => "value",
            Enforcement::Unknown => "unknown",
        },
        low: end(constraint.range[0]),
        high: end(constraint.range[1]),
        value: state.value.into(),
        margin: state.margin.into(),
        price: state.price.into(),
    }
}
