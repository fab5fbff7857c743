//! Texts about the result of a search: status, message, active bounds and constraints.

use super::goal::{Constraint, Goal};
use super::optimum::{LocalOptimum, Optimum};
use super::search::Sense;
use crate::drive::Drive;
use crate::optimize::sensitivity::ActiveSet;
use crate::optimize::{Solution, Status};
use crate::parameters::Vary;
use crate::units::{self, Digits, Message, Quantity};
use std::fmt;

/// An active bound or constraint of an optimum: `club.loft at its upper bound`, or the text of the
/// constraint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Active {
    /// The name of the varied parameter, or the text of the constraint.
    pub name: String,
    /// The bound; `None` for a constraint.
    pub end: Option<BoundSide>,
}

/// The lower or the upper bound of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundSide {
    /// The lower bound.
    Lower,
    /// The upper bound.
    Upper,
}

variant_names! {
    /// Name in JSON, such as `lower`.
    BoundSide as "BoundSide" {
        Lower = "lower",
        Upper = "upper",
    }
}

impl fmt::Display for Active {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.end {
            Some(end) => write!(f, "{} at its {} bound", self.name, end.name()),
            None => f.write_str(&self.name),
        }
    }
}

impl Active {
    /// This bound, or this constraint of `constraints`, as a message.
    pub(super) fn message(&self, constraints: &[Constraint]) -> Message {
        let mut constraints = constraints.iter();
        match constraints.find(|constraint| constraint.expression == self.name) {
            Some(constraint) if self.end.is_none() => constraint.message(),
            _ => self.to_string().into(),
        }
    }
}

/// The active bounds and constraints of `these` that are not in `others`.
pub(super) fn only_in(these: &[Active], others: &[Active]) -> Vec<Active> {
    let these = these.iter();
    these
        .filter(|active| !others.contains(active))
        .cloned()
        .collect()
}

/// The active bounds and constraints of `held`. For a variable at a bound, `is_lower` returns true
/// at the lower and false at the upper bound.
pub(super) fn active(
    vary: &[Vary],
    constraints: &[Constraint],
    held: &ActiveSet,
    is_lower: impl Fn(usize) -> bool,
) -> Vec<Active> {
    let is_bounded = |i: &usize| held.variables[*i] && vary[*i].low < vary[*i].high;
    let bounds = (0..vary.len()).filter(is_bounded).map(|i| Active {
        name: vary[i].parameter.name.into(),
        end: Some(if is_lower(i) {
            BoundSide::Lower
        } else {
            BoundSide::Upper
        }),
    });
    let limits = held.active_constraints().into_iter();
    let limits = limits
        .filter_map(|j| constraints.get(j))
        .map(|constraint| Active {
            name: constraint.expression.clone(),
            end: None,
        });
    bounds.chain(limits).collect()
}

/// The name of [`Status::Undefined`] for a search over drives.
const NO_FLIGHT: &str = "no-flight";

pub(super) fn status_name(status: Status) -> &'static str {
    match status {
        Status::Undefined => NO_FLIGHT,
        status => status.name(),
    }
}

/// Text about the constraints that the final point of a search violates. The text has the exact
/// values `goals`. If `goals` is missing or meets all limits, it has the smoothed values of the
/// search.
pub(super) fn violated(
    constraints: &[Constraint],
    found: &Solution,
    goals: Option<&[f64]>,
) -> Message {
    let is_violated =
        |(constraint, value): (&Constraint, &f64)| constraint.violation(*value) != 0.0;
    let exact = goals
        .map(|goals| &goals[1..])
        .filter(|values| constraints.iter().zip(*values).any(is_violated));
    let value = |j: usize| exact.map_or(found.constraints[j].value, |values| values[j]);
    let missed = constraints
        .iter()
        .enumerate()
        .filter_map(|(j, constraint)| {
            let violation = constraint.violation(value(j));
            let (quantity, unit) = (constraint.goal.quantity, constraint.goal.unit);
            let is_fixed = found.jacobian[j].iter().all(|slope| *slope == 0.0);
            let fixed = if is_fixed {
                "no varied parameter changes it here: "
            } else {
                ""
            };
            (violation != 0.0).then(|| {
                let name = constraint.message();
                name.words(format!(" ({fixed}its value is "))
                    .quantity(quantity, unit, value(j), Digits::Fine)
                    .words(", outside by ")
                    .quantity(quantity, unit, violation.abs(), Digits::Difference)
                    .words(")")
            })
        });
    Message::joined(missed, " and ")
}

pub(super) fn violated_by_design(
    constraints: &[Constraint],
    found: &Solution,
    goals: Option<&[f64]>,
) -> Message {
    Message::from("no design was found that meets the limits; the nearest one violates ")
        .message(violated(constraints, found, goals))
}

/// The message of the optimizer. At a kink of the objective, a text with the slopes on both sides in
/// the names and units of the search.
pub(super) fn solver_message(
    found: &Solution,
    (goal, sense): (&Goal, Sense),
    vary: &[Vary],
) -> Message {
    let Some(kink) = found.kink else {
        return found.message.as_str().into();
    };
    let parameter = vary[kink.variable].parameter;
    let by = parameter.name;
    let of = match goal.expression.contains(' ') {
        true => format!("({})", goal.expression),
        false => goal.expression.clone(),
    };
    let unit = units::per(goal.quantity.si, parameter.quantity.si);
    let slope = |slope: Option<f64>| {
        slope.map_or("not computed (out of range)".into(), |slope| {
            let slope = sense.sign() * slope;
            format!("{} {unit}", units::signed(slope, units::fixed(slope, 4)))
        })
    };
    Message::from(format!("{of} has a corner at {by} = "))
        .quantity(
            parameter.quantity,
            parameter.unit,
            found.x[kink.variable],
            Digits::Significant(7),
        )
        .words(format!(
            ": d {of}/d {by} is {} below it and {} above",
            slope(kink.slope_below),
            slope(kink.slope_above),
        ))
}

impl LocalOptimum {
    /// Name of the status; `no-flight` if the optimizer reports `undefined`.
    pub fn status(&self) -> &'static str {
        status_name(self.solution.status)
    }
}

impl Optimum {
    /// The names of all statuses.
    #[cfg(test)]
    pub(crate) const STATUSES: [&'static str; Status::ALL.len()] = {
        let mut names = Status::NAMES;
        names[Status::Undefined as usize] = NO_FLIGHT;
        names
    };

    /// Name of the status; `no-flight` if the optimizer reports `undefined`.
    pub fn status(&self) -> &'static str {
        status_name(self.solution.status)
    }

    /// Result of the search in a sentence, in terms of the drive or the design.
    pub fn message(&self) -> Message {
        if !self.search.scenarios.is_one_drive() {
            return self.message_over_swings();
        }
        let found = self.solver_message();
        match self.solution.status {
            _ if self.solution.kink.is_some() => found,
            Status::Infeasible => self.violated_by_drive(),
            Status::Undefined => self.no_flight(),
            Status::Converged => self.with_idle_parameters(&found),
            Status::Interrupted if self.solution.value.is_none() => {
                "stopped before a drive that flies was found".into()
            }
            _ => found,
        }
    }

    fn solver_message(&self) -> Message {
        let search = &self.search;
        solver_message(&self.solution, (&search.of, search.sense), &search.vary)
    }

    fn message_over_swings(&self) -> Message {
        let found = self.solver_message();
        match self.solution.status {
            _ if self.solution.kink.is_some() => found,
            Status::Undefined => {
                let start = self.solution.undefined_at_start.as_deref();
                format!(
                    "no design was found with which every swing flies; truncate the distributions \
                     or leave such swings out, or change the ranges; at the start: {}",
                    start.unwrap_or("no drive flies")
                )
                .into()
            }
            Status::Infeasible => violated_by_design(
                &self.search.subject_to,
                &self.solution,
                self.goals.as_deref(),
            ),
            Status::Interrupted if self.solution.value.is_none() => {
                "stopped before a design was found with which the ball flies in every swing".into()
            }
            Status::Converged => self.with_idle_parameters(&found),
            _ => found,
        }
    }

    fn violated_by_drive(&self) -> Message {
        let tried = self.sample.map_or(String::new(), |sample| {
            format!(
                " (the search and {} other points in the ranges were tried)",
                sample.points
            )
        });
        Message::from(format!(
            "no point was found that meets the constraints{tried}; the nearest one violates "
        ))
        .message(violated(
            &self.search.subject_to,
            &self.solution,
            self.goals.as_deref(),
        ))
    }

    /// Message for a search in which no drive flies. It gives the reason for the drive at the
    /// start.
    fn no_flight(&self) -> Message {
        let trials = self.search.options.start_trials as usize;
        let trials = trials + self.sample.map_or(0, |sample| sample.points);
        Message::from(format!(
            "no drive of the search flies, neither at the start nor at the other points of the \
             ranges that were tried ({trials}); at the start: "
        ))
        .message(self.undefined_at_start())
    }

    /// Reason why the drive at the start does not fly. The optimizer stores the reason as plain
    /// text. The drive is computed again for a message whose values can be shown in other units.
    fn undefined_at_start(&self) -> Message {
        let start = self.solution.undefined_at_start.as_deref();
        let text = start.unwrap_or_default();
        let again = Drive::new(&self.setup).and_then(|drive| self.search.outcome().of(&drive));
        again
            .err()
            .map(|error| error.message())
            .filter(|message| message.to_string() == text)
            .unwrap_or_else(|| text.into())
    }

    /// The message `found` of a converged search, with the varied parameters that have a negligible
    /// effect.
    fn with_idle_parameters(&self, found: &Message) -> Message {
        let goal = &self.search.of.expression;
        let vary = &self.search.vary;
        let idle = vary.iter().enumerate().filter(|(i, _)| self.is_idle(*i));
        let idle: Vec<&str> = idle.map(|(_, vary)| vary.parameter.name).collect();
        let varied = vary.iter().filter(|vary| vary.low < vary.high).count();
        if idle.len() == varied || self.is_flat() {
            let every = match self.search.scenarios.is_one_drive() {
                true => "drive",
                false => "design",
            };
            let text = format!(
                "{goal} depends on no varied parameter here: every {every} is equally good"
            );
            return text.into();
        }
        let little = match self.search.of.quantity {
            Quantity::LENGTH => "1 mm",
            _ => "a millionth of it",
        };
        match idle.as_slice() {
            [] => found.clone(),
            [one] => format!(
                "{found}; {one} has a negligible effect: within its range it changes {goal} by \
                 less than {little}"
            )
            .into(),
            all => format!(
                "{found}; {} have a negligible effect: within its own range each of them changes \
                 {goal} by less than {little}",
                all.join(" and ")
            )
            .into(),
        }
    }

    /// True if the varied parameter `i` has a negligible effect. If this parameter alone changes
    /// within its range, then:
    ///
    /// - the objective changes, to second order, by at most 1 mm, or by at most 1e-6 of its value
    ///   if it is not a length;
    /// - each active constraint changes by no more than this, if its change is multiplied by its
    ///   price;
    /// - the other constraints are still met.
    ///
    /// The optimal value of such a parameter is arbitrary, or lies at a bound.
    pub fn is_idle(&self, i: usize) -> bool {
        let Vary { low, high, .. } = self.search.vary[i];
        let width = high - low;
        let solution = &self.solution;
        let (Some(slope), Some(row)) = (solution.gradient.get(i), solution.hessian.get(i)) else {
            return false;
        };
        let negligible = self.search.of.negligible(self.value().unwrap_or_default());
        // the Hessian of the Lagrangian also has the curvature of the active constraints
        let change = (slope.abs() + row[i].abs() * width) * width;
        let limits = self.search.subject_to.iter().zip(&solution.constraints);
        let is_limited = limits.zip(&solution.jacobian).any(|((limit, at), row)| {
            let change = row[i].abs() * width;
            match at.multiplier {
                0.0 => change > (at.value - limit.low).min(limit.high - at.value),
                price => price.abs() * change > negligible,
            }
        });
        width > 0.0 && change <= negligible && !is_limited
    }

    /// True if the objective is constant over the ranges: to second order, it changes by rounding
    /// only.
    fn is_flat(&self) -> bool {
        const ROUNDING: f64 = 1e-10;
        let width = |i: usize| self.search.vary[i].high - self.search.vary[i].low;
        let slopes = self.solution.gradient.iter().enumerate();
        let slopes = slopes.map(|(i, slope)| slope * width(i));
        let rows = self.solution.hessian.iter().enumerate();
        let curvatures = rows.flat_map(|(i, row)| {
            let row = row.iter().enumerate();
            row.map(move |(j, curvature)| curvature * width(i) * width(j))
        });
        slopes
            .chain(curvatures)
            .all(|change| change.abs() < ROUNDING)
    }

    /// Message with the point at which the search began, if the ball does not fly at the setup's
    /// own values. `None` if the search began at the setup's own values.
    pub fn moved_start(&self) -> Option<String> {
        let why = self.solution.undefined_at_start.as_ref();
        let why = why.filter(|_| !self.solution.initial_point.is_empty())?;
        let begun = self.search.vary.iter().zip(&self.solution.initial_point);
        let begun: Vec<_> = begun
            .map(|(vary, x)| format!("{} {}", vary.parameter.name, vary.parameter.show(Some(*x))))
            .collect();
        Some(format!(
            "the start does not fly ({why}); the search began at {} instead",
            begun.join(", ")
        ))
    }

    /// The active bounds and constraints; none if no drive flies.
    pub fn active(&self) -> Vec<Active> {
        let solution = &self.solution;
        let domain = self.search.domain().ok();
        let Some(domain) = domain.filter(|_| solution.value.is_some()) else {
            return vec![];
        };
        let held = ActiveSet::new(solution, &domain);
        active(&self.search.vary, &self.search.subject_to, &held, |i| {
            solution.lower_multipliers[i] > 0.0
        })
    }
}
