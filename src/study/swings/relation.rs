//! Relations of a design that a user states, linear in parameters:
//! `volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3`.

use super::measure::Measure;
use super::read::{Goal, GoalLimit, summands};
use crate::drive::{self, Outcome};
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::study::comparison::{Compared, Part, at, compared};
use crate::units::{Amount, Quantity};
use std::cell::Cell;

const HOW: &str = "write NAME: AMOUNT + AMOUNT*PARAMETER <= LIMIT, for example \"volume: 120 cm^3 \
                   + 80 cm^2*club.cg_depth <= 460 cm^3\"";

impl GoalLimit {
    /// Whether a limit is a relation: it has a name before a colon.
    pub fn is_relation(expression: &str) -> bool {
        expression.contains(':')
    }

    /// Reads a relation: a name, and a sum of amounts and of amounts times parameters between
    /// limits. All terms must be of one kind.
    ///
    /// ```
    /// use longdrive::{Setup, study::swings::GoalLimit};
    /// let text = "volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3";
    /// let volume = GoalLimit::read_relation(&Setup::default(), text).unwrap();
    /// assert_eq!((volume.goal.expression.as_str(), volume.high), ("volume", 460e-6));
    /// let wrong = GoalLimit::read_relation(&Setup::default(), "volume: 8 cm*club.cg_depth <= 460 cm^3");
    /// assert!(wrong.unwrap_err().to_string().contains("m^3"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Constraint`], which points into the expression: for a relation without a name, with
    /// that of an outcome, or without a parameter, and for what cannot be read.
    pub fn read_relation(setup: &Setup<f64>, expression: &str) -> Result<Self> {
        let (name, rest) = expression.split_once(':').unwrap_or(("", expression));
        let before = name.chars().count() + usize::from(rest.len() < expression.len());
        if name.trim().is_empty() {
            return Err(at(
                expression,
                &Part {
                    text: name,
                    column: 0,
                },
                &format!("the relation has no name; {HOW}"),
            ));
        }
        refuse_outcome(expression, name)?;
        let is_sum = |text: &str| {
            text.contains('*') || text.contains(" + ") || setup.parameter(text).is_ok()
        };
        let typed = Cell::new(None);
        let read = compared(
            rest,
            "volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3",
            is_sum,
            |part| {
                let goal = sum(setup, rest, name.trim(), part)?;
                let (quantity, typed) = (goal.quantity, &typed);
                Ok((goal, move |limit: &Part<'_>| {
                    let amount =
                        Amount::read(limit.text).map_err(|error| at(rest, limit, &error))?;
                    same_kind(rest, limit, amount, quantity)?;
                    let unit = quantity
                        .split(limit.text)
                        .ok()
                        .and_then(|(_, unit)| quantity.known_unit(unit));
                    typed.set(typed.get().or(unit));
                    Ok(amount.value)
                }))
            },
        );
        let Compared {
            of: goal,
            low,
            high,
        } = read.map_err(|error| match error {
            // the columns are counted behind the name
            Error::Constraint { column, reason, .. } => Error::Constraint {
                expression: expression.into(),
                column: column + before,
                reason,
            },
            error => error,
        })?;
        // as the user thinks of it: in the unit of the limit
        let goal = Goal {
            unit: typed.get().unwrap_or(goal.unit),
            ..goal
        };
        Ok(Self {
            expression: expression.trim().into(),
            goal,
            low,
            high,
        })
    }
}

/// Refuses a relation with the name of an outcome, which would be taken for a limit of it.
fn refuse_outcome(expression: &str, name: &str) -> Result<()> {
    let Ok(of) = Outcome::named(name.trim()) else {
        return Ok(());
    };
    let limit = if of.group() == drive::OutcomeGroup::Head {
        of.name().to_owned()
    } else {
        format!("mean({})", of.name())
    };
    let reason = format!(
        "a relation cannot have the name of an outcome: to limit the outcome, write it without a \
         colon, for example \"{limit} <= …\"; else give \
         the relation another name"
    );
    Err(at(
        expression,
        &Part {
            text: name,
            column: 0,
        },
        &reason,
    ))
}

fn sum(setup: &Setup<f64>, expression: &str, name: &str, part: &Part<'_>) -> Result<Goal> {
    let mut terms = vec![];
    let mut kind: Option<Quantity> = None;
    for (sign, term) in summands(part) {
        if term.text.is_empty() {
            return Err(at(
                expression,
                &term,
                &format!("a term is missing here; {HOW}"),
            ));
        }
        let wrong = |error: String| at(expression, &term, &error);
        let (amount, parameter) = match term.text.rsplit_once('*') {
            Some((amount, name)) => (Some(amount), Some(name.trim())),
            None if setup.parameter(term.text).is_ok() => (None, Some(term.text)),
            None => (Some(term.text), None),
        };
        let amount = Amount::read(amount.unwrap_or("1").trim()).map_err(wrong)?;
        let (amount, measure) = match parameter {
            None => (amount, Measure::One),
            Some(name) => {
                let unset = setup
                    .column(name)
                    .ok()
                    .filter(|parameter| parameter.unset.is_some());
                let parameter = unset
                    .map_or_else(|| setup.variable(name), Ok)
                    .map_err(|error| wrong(error.to_string()))?;
                (
                    amount.times(parameter.quantity),
                    Measure::Parameter(parameter),
                )
            }
        };
        match kind {
            None => {
                let quantity = amount.quantity();
                kind = Some(quantity.ok_or_else(|| {
                    wrong(
                        "this is no kind of quantity that is known, such as a mass, a length or \
                           a volume; check the units"
                            .into(),
                    )
                })?);
            }
            Some(kind) => same_kind(expression, &term, amount, kind)?,
        }
        terms.push((sign * amount.value, measure));
    }
    if terms.iter().all(|(_, measure)| *measure == Measure::One) {
        let reason = format!(
            "no parameter stands in it, so that nothing that is varied can change it; {HOW}"
        );
        return Err(at(expression, part, &reason));
    }
    let quantity = kind.unwrap_or(Quantity::NUMBER);
    Ok(Goal {
        expression: name.into(),
        terms,
        quantity,
        unit: quantity.usual_unit(),
    })
}

fn same_kind(expression: &str, part: &Part<'_>, amount: Amount, kind: Quantity) -> Result<()> {
    match amount.quantity() {
        Some(quantity) if quantity == kind => Ok(()),
        found => {
            let found = found.map_or("a quantity of another kind", |quantity| quantity.name);
            let reason = format!(
                "this is {found}, and the first term is {} (in SI {}): all terms and limits must \
                 be of one kind; check the units",
                kind.name, kind.si
            );
            Err(at(expression, part, &reason))
        }
    }
}
