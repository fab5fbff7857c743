use super::document::{Detail, Document, DocumentTable, Line};
use super::json::JsonNumber;
use super::limits::{change_of, ended_at};
use super::optimum::{
    DesignLimits, LimitReport, OptimizeReport, add_convergence, bound_in_words, ended_line,
    varied_table,
};
use super::reply::{Ending, Report};
use super::shown;
use super::swings::{goals, nominal, notes};
use crate::parameters::Setup;
use crate::study::Optimum;
use crate::study::design::{ConstraintState, Design, DesignConstraint, Enforcement, Improvement};
use crate::units::{System, signed};
use serde::Serialize;

/// A value is displayed as 0 if it is smaller than this fraction of
/// `DesignConstraint::reported_change`: it is a rounding error.
const ROUNDING: f64 = 1e-6;

/// An optimum as JSON, SI and radians.
///
/// The answer of `design`: the best design, with its limits and its changes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DesignReport<'a> {
    #[serde(skip)]
    problem: &'a Design,
    #[serde(skip)]
    setup: &'a Setup<f64>,
    #[serde(skip)]
    best: &'a Optimum,
    /// The optimum.
    #[serde(flatten)]
    pub search: OptimizeReport<'a>,
    /// The limits of the design, and its changes.
    pub design: DesignLimits,
}

impl<'a> DesignReport<'a> {
    /// The best design that `search` found, with the rules and limits of `problem`. `setup` is the
    /// setup before the search; `parts` are the goals before the search and with the best design;
    /// `notes` are the assumptions, in sentences.
    pub fn new(
        search: OptimizeReport<'a>,
        problem: &'a Design,
        setup: &'a Setup<f64>,
        parts: Vec<Improvement>,
        notes: Vec<String>,
    ) -> Self {
        let best = &search.found.best;
        let before = best.search.parameters();
        let before = before.map(|parameter| (parameter.name, setup.value_or_unset(parameter)));
        let states = problem.constraint_states(best);
        let design = DesignLimits {
            rules: if problem.is_under_rules {
                "golf"
            } else {
                "none"
            },
            notes,
            as_set_up: before.collect(),
            parts,
            held: states.iter().map(limit_report).collect(),
        };
        Self {
            problem,
            setup,
            best,
            search,
            design,
        }
    }
}

impl Report for DesignReport<'_> {
    const COMMAND: &'static str = "design";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = OptimizeReport::STATUSES;

    fn ending(&self) -> Ending {
        self.search.ending()
    }

    /// The design for readers: the values before and after the search, the rules and limits, the
    /// notes, and the convergence.
    fn document(&self, system: System) -> Document {
        let analysis = self.search.analysis;
        let mut document = Document::default();
        let is_converged = self.best.is_converged();
        if !is_converged {
            document.list([ended_line(self.best, system)]);
        }
        let assumptions = self.assumptions();
        if self.best.value().is_none() {
            document.list(assumptions);
            return document;
        }
        document.add(self.changes(system));
        let rows: Vec<_> = self
            .problem
            .constraint_states(self.best)
            .into_iter()
            .map(|state| self.row(&state, system))
            .collect();
        if !rows.is_empty() {
            let found = ended_at(self.best.solution.status, "best");
            document.add(DocumentTable::new(["rule or limit", "", found, ""], rows).right([2]));
        }
        let notes = notes(self.best, analysis, system);
        document.list(notes.into_iter().chain(assumptions));
        let mut ranges = Document::default();
        ranges.add(goals(self.best, analysis, system));
        ranges.add(varied_table(self.best, nominal(analysis), system));
        document.append_detail(ranges, Detail::WithAll);
        if is_converged {
            add_convergence(&mut document, self.best, system);
        }
        document
    }
}

impl DesignReport<'_> {
    /// The varied parameters and the goals, before the search and with the best design.
    fn changes(&self, system: System) -> DocumentTable {
        let solution = &self.best.solution;
        let own = self.best.search.vary.iter().zip(&solution.x).enumerate();
        let own = own.map(|(i, (vary, x))| {
            let before = self.setup.value_or_unset(vary.parameter);
            let show = |value: f64| shown::within(vary, value, system);
            let change = before.map_or(String::new(), |before| {
                shown::change(vary.parameter, x - before, system)
            });
            vec![
                vary.parameter.name.into(),
                before.map_or(shown::NONE.into(), show),
                show(*x),
                change,
                bound_in_words(self.best, i, system),
            ]
        });
        let objective = Improvement {
            goal: self.best.search.of.clone(),
            as_set_up: self.best.as_set_up.as_ref().map(|goals| goals[0]),
            best: self.best.value(),
        };
        let mut listed = self.design.parts.iter();
        let is_listed = listed.any(|part| part.goal.expression == objective.goal.expression);
        let goals = (!is_listed).then_some(&objective).into_iter();
        let goals = goals
            .chain(&self.design.parts)
            .map(|goal| goal_row(goal, system));
        let found = ended_at(solution.status, "best");
        let head = ["design", "as set up", found, "change", ""];
        DocumentTable::new(head, own.chain(goals)).right([1, 2, 3])
    }

    /// The rules that apply, then the assumptions.
    fn assumptions(&self) -> Vec<Line> {
        let rules = if self.problem.is_under_rules {
            "the rules above are the Rules of Golf (sources: docs/design.md)"
        } else {
            "without the Rules of Golf (`rules none`)"
        };
        std::iter::once(rules)
            .chain(self.design.notes.iter().map(String::as_str))
            .map(Line::flush)
            .collect()
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
            let value = if value.abs() < ROUNDING * constraint.reported_change {
                0.0
            } else {
                value
            };
            shown::with_digits(constraint.unit, value, system, 5)
        };
        let goal = &self.best.search.of;
        let text = match (constraint.enforcement, price, margin) {
            (Enforcement::Unknown, ..) => {
                "not checked: no parameter gives it (docs/design.md says how to state it)".into()
            }
            (Enforcement::Value(_), _, Some(_)) => "met; not varied".into(),
            (_, Some(price), _) => {
                let amount = change_of(self.best.search.sense, price * constraint.reported_change);
                let is_upper = value.is_some_and(|value| {
                    constraint.range[1] - value <= value - constraint.range[0]
                });
                let way = if is_upper { "raised" } else { "lowered" };
                let gain = signed(amount, shown::goal_difference(goal, amount, system));
                format!(
                    "{gain} for each {} that the limit is {way}",
                    constraint.unit.show(constraint.reported_change)
                )
            }
            (_, None, Some(margin)) if *margin < -ROUNDING * constraint.reported_change => {
                format!("violated by {}", show(-margin))
            }
            (_, None, Some(margin)) => format!("{} to spare", show(margin.max(0.0))),
            (_, None, None) => String::new(),
        };
        vec![
            constraint.name.clone(),
            limits_text(constraint, system),
            value.map_or(shown::NONE.into(), show),
            text,
        ]
    }
}

/// The cells of a goal: its value before the search, with the best design, and the change.
fn goal_row(part: &Improvement, system: System) -> Vec<String> {
    let show = |value: Option<f64>| shown::goal_or_dash(&part.goal, value, system);
    let both = part.as_set_up.zip(part.best);
    let change = both.map_or(String::new(), |(before, best)| {
        let change = best - before;
        signed(change, shown::goal_difference(&part.goal, change, system))
    });
    vec![
        part.goal.expression.clone(),
        show(part.as_set_up),
        show(part.best),
        change,
        String::new(),
    ]
}

/// The limits of a constraint: "≤ 6000 g cm²".
fn limits_text(constraint: &DesignConstraint, system: System) -> String {
    let [low, high] = constraint.range;
    let show = |value: f64| shown::with_digits(constraint.unit, value, system, 5);
    match [low, high].map(f64::is_finite) {
        [true, true] if low == high => format!("= {}", show(low)),
        [true, true] => format!("{} .. {}", show(low), show(high)),
        [true, false] => format!("≥ {}", show(low)),
        _ => format!("≤ {}", show(high)),
    }
}

fn limit_report(state: &ConstraintState) -> LimitReport {
    let constraint = &state.constraint;
    let end = |end: f64| JsonNumber(Some(end).filter(|end| end.is_finite()));
    LimitReport {
        name: constraint.name.clone(),
        expression: constraint.expression.clone(),
        source: constraint.rule.map(|rule| rule.source),
        by: match constraint.enforcement {
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
