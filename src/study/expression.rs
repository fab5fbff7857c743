//! The grammar of goals and constraints.
//!
//! ```text
//!   constraint = [NAME ":"] (goal SIGN LIMIT | LIMIT SIGN goal | LIMIT SIGN goal SIGN LIMIT)
//!   SIGN       = "<=" | ">=" | "=="
//!   goal       = term {("+" | "-") term}
//!   term       = OUTCOME                                 of one drive; a single term
//!              | [WEIGHT "*"] MEASURE "(" arguments ")"  over swings
//!              | AMOUNT | [AMOUNT "*"] PARAMETER         of a relation, which has a NAME
//! ```

use super::goal::{Constraint, Goal};
use super::swings::{Measure, Strokes};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::units::{Amount, DisplayUnit, Quantity};
use std::ops::Range;

const SIGNS: [&str; 5] = ["<=", ">=", "==", "≤", "≥"];

const MEASURES: &str = "mean(OUTCOME), std(OUTCOME), rms(OUTCOME), lowest(OUTCOME, 10%), \
                        highest(OUTCOME, 10%), \
                        within(OUTCOME, 15yd) and strokes(400yd)";

const RELATION: &str = "write NAME: AMOUNT + AMOUNT*PARAMETER <= LIMIT, for example \"volume: 120 \
                        cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3\"";

impl Goal {
    /// Parses a weighted sum of measures. A weight is a number. The weight of `within` or `strokes`
    /// may also be an amount with a unit, as in `mean(carry) + 30yd*within(lateral, 15yd)`.
    /// `strokes` is the table that `strokes(HOLE)` needs.
    ///
    /// ```
    /// use longdrive::study::{Goal, swings::Measure};
    /// use longdrive::Outcome;
    /// let goal = Goal::read("mean(carry) - 0.5*std(lateral)", None).unwrap();
    /// assert_eq!(goal.terms[1], (-0.5, Measure::Deviation(Outcome::Lateral)));
    /// let error = Goal::read("mean(carry) + std(descent_angle)", None).unwrap_err().to_string();
    /// assert!(error.contains("an angle"), "{error}");
    /// assert!(Goal::read("carry", None).unwrap_err().to_string().contains("mean(carry)"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Constraint`] with the position in the expression.
    pub fn read(expression: &str, strokes: Option<&Strokes>) -> Result<Self> {
        let whole = Piece::whole(expression);
        Scope::Swings(strokes).goal(whole.slice(0..expression.len()))
    }
}

impl Constraint {
    /// Reads a constraint of one drive: `OUTCOME >= LIMIT`, `OUTCOME <= LIMIT`, `OUTCOME == VALUE`
    /// or `LOW <= OUTCOME <= HIGH`. A limit is a number with its unit.
    ///
    /// ```
    /// use longdrive::study::Constraint;
    /// let steep = Constraint::read("descent_angle >= 38 deg").unwrap();
    /// assert_eq!((steep.low, steep.high), (38.0_f64.to_radians(), f64::INFINITY));
    /// let flat = Constraint::read("10 yd <= apex_height <= 35 yd").unwrap();
    /// assert_eq!((flat.low, flat.high), (9.144, 32.004));
    /// let error = Constraint::read("descent_angel >= 38 deg").unwrap_err().to_string();
    /// assert!(error.contains("did you mean 'descent_angle'?"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Constraint`] with the position in the expression.
    pub fn read(expression: &str) -> Result<Self> {
        if Self::is_relation(expression) {
            let reason = "a relation of parameters limits a search over many swings (`swings` or \
                          `distribution`) or `design()`; for one \
                          drive, give the range of a parameter with `vary`, or limit an outcome";
            return Err(Piece::whole(expression).error(reason));
        }
        read(Piece::whole(expression), &Scope::Drive)
    }

    /// Reads a constraint over swings: `GOAL >= LIMIT`, `GOAL <= LIMIT`, `GOAL == VALUE` or
    /// `LOW <= GOAL <= HIGH`.
    ///
    /// # Errors
    /// [`Error::Constraint`] with the position in the expression.
    pub fn read_over_swings(expression: &str, strokes: Option<&Strokes>) -> Result<Self> {
        read(Piece::whole(expression), &Scope::Swings(strokes))
    }

    /// True if a text is a relation of parameters: it has a name before a colon.
    pub fn is_relation(expression: &str) -> bool {
        expression.contains(':')
    }

    /// Parses a relation between parameters of a design: a name, a colon, and a linear expression
    /// between limits. Each term is an amount, or an amount times a parameter. All terms must have
    /// the same kind of quantity.
    ///
    /// ```
    /// use longdrive::{Setup, study::Constraint};
    /// let text = "volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3";
    /// let volume = Constraint::read_relation(&Setup::modern_driver(), text).unwrap();
    /// assert_eq!((volume.goal.expression.as_str(), volume.high), ("volume", 460e-6));
    /// let wrong = Constraint::read_relation(&Setup::modern_driver(), "volume: 8 cm*club.cg_depth <= 460 cm^3");
    /// assert!(wrong.unwrap_err().to_string().contains("m^3"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Constraint`], with the position in the expression, for a relation without a name,
    /// with the name of an outcome, or without a parameter, and for text that cannot be parsed.
    pub fn read_relation(setup: &Setup<f64>, expression: &str) -> Result<Self> {
        let whole = Piece::whole(expression);
        let colon = expression.find(':');
        let name = colon.map_or("", |colon| expression[..colon].trim());
        if name.is_empty() {
            return Err(whole.error(format!("the relation has no name; {RELATION}")));
        }
        if let Ok(of) = Outcome::named(name) {
            // the user may mean a limit of the outcome
            let limit = match of.group() {
                OutcomeGroup::Head => of.name().to_owned(),
                _ => format!("mean({})", of.name()),
            };
            return Err(whole.error(format!(
                "a relation cannot have the name of an outcome: to limit the outcome, write it \
                 without a colon, for example \"{limit} <= …\"; else give the relation another name"
            )));
        }
        let sum = colon.map_or(0, |colon| colon + 1);
        let sum = Piece {
            text: &expression[sum..],
            column: expression[..sum].chars().count(),
            ..whole
        };
        read(sum, &Scope::Relation { setup, name })
    }
}

/// A piece of an expression, without the white space around it.
#[derive(Clone, Copy)]
struct Piece<'a> {
    /// The whole expression.
    whole: &'a str,
    text: &'a str,
    /// Column of the piece in the whole expression, in characters from 0.
    column: usize,
}

impl<'a> Piece<'a> {
    fn whole(expression: &'a str) -> Self {
        Self {
            whole: expression,
            text: expression,
            column: 0,
        }
    }

    /// The part of the piece within a byte range, trimmed.
    fn slice(self, range: Range<usize>) -> Self {
        let part = &self.text[range.clone()];
        let lead = part.len() - part.trim_start().len();
        Self {
            text: part.trim(),
            column: self.column + self.text[..range.start + lead].chars().count(),
            ..self
        }
    }

    /// An error that points at the beginning of the piece.
    fn error(self, reason: impl Into<String>) -> Error {
        Error::Constraint {
            expression: self.whole.into(),
            column: self.column,
            reason: reason.into(),
        }
    }
}

/// The terms that a goal may have.
enum Scope<'a> {
    /// An outcome of one drive.
    Drive,
    /// Measures over swings, with the table that `strokes(HOLE)` needs.
    Swings(Option<&'a Strokes>),
    /// Amounts, and amounts times parameters of a setup.
    Relation {
        setup: &'a Setup<f64>,
        /// The text before the colon.
        name: &'a str,
    },
}

/// A term of a sum.
struct Term {
    weight: f64,
    measure: Measure,
    /// Quantity of the weight times the measure; `None` if the unit of this product belongs to no
    /// known quantity.
    quantity: Option<Quantity>,
    unit: &'static str,
}

/// A limit, SI. The limit of a relation also has the unit in which the user gave it, if that unit
/// is known.
#[derive(Clone, Copy)]
struct Limit {
    value: f64,
    unit: Option<&'static str>,
}

impl Limit {
    /// No limit: `value` is −∞ in place of a lower limit, and ∞ in place of an upper limit.
    fn none(value: f64) -> Self {
        Self { value, unit: None }
    }
}

/// Reads a constraint, which is a goal between limits. `text` is the expression without the name of
/// a relation.
fn read(text: Piece<'_>, scope: &Scope<'_>) -> Result<Constraint> {
    let pieces = split(text)?;
    let (mut goal, low, high) = match pieces.as_slice() {
        [left, sign, right] => {
            let is_turned = !scope.is_goal(left.text) && scope.is_goal(right.text);
            let (goal, limit) = if is_turned {
                (right, left)
            } else {
                (left, right)
            };
            let goal = scope.goal(*goal)?;
            let limit = scope.limit(*limit, &goal)?;
            match is_at_most(sign.text) {
                None => (goal, limit, limit),
                Some(is_at_most) if is_at_most != is_turned => {
                    (goal, Limit::none(f64::NEG_INFINITY), limit)
                }
                Some(_) => (goal, limit, Limit::none(f64::INFINITY)),
            }
        }
        [left, first, middle, second, right] => {
            let goal = scope.goal(*middle)?;
            let left = scope.limit(*left, &goal)?;
            let right = scope.limit(*right, &goal)?;
            match (is_at_most(first.text), is_at_most(second.text)) {
                (Some(true), Some(true)) => (goal, left, right),
                (Some(false), Some(false)) => (goal, right, left),
                _ => {
                    let reason = "a range needs the same comparison twice: LOW <= OUTCOME <= HIGH";
                    return Err(second.error(reason));
                }
            }
        }
        _ => {
            let place = pieces.get(1).or(pieces.first()).unwrap_or(&text);
            return Err(place.error(format!(
                "there is no comparison (<=, >= or ==) with something on both sides; write for \
                 example {}",
                scope.example()
            )));
        }
    };
    if low.value > high.value {
        let reason = "the range is reversed: its lower limit is above its upper limit";
        return Err(pieces[0].error(reason));
    }
    // show a relation in the unit of its limit
    if matches!(scope, Scope::Relation { .. }) {
        goal.unit = low.unit.or(high.unit).unwrap_or(goal.unit);
    }
    Ok(Constraint {
        expression: text.whole.trim().into(),
        goal,
        low: low.value,
        high: high.value,
    })
}

fn is_at_most(sign: &str) -> Option<bool> {
    match sign {
        "<=" | "≤" => Some(true),
        ">=" | "≥" => Some(false),
        _ => None,
    }
}

/// Splits a constraint at its comparison signs, and returns the texts and the signs in their order.
fn split(text: Piece<'_>) -> Result<Vec<Piece<'_>>> {
    let mut pieces = vec![];
    let mut from = 0;
    let next = |from: usize| {
        SIGNS
            .iter()
            .filter_map(|sign| Some((from + text.text[from..].find(sign)?, *sign)))
            .min()
    };
    while let Some((place, sign)) = next(from) {
        pieces.push(text.slice(from..place));
        pieces.push(text.slice(place..place + sign.len()));
        from = place + sign.len();
    }
    pieces.push(text.slice(from..text.text.len()));
    for piece in &pieces {
        let stray = piece
            .text
            .find(['<', '>', '='])
            .filter(|_| !SIGNS.contains(&piece.text));
        if let Some(stray) = stray {
            let rest = piece.slice(stray..piece.text.len());
            return Err(rest.error("this is not a comparison; write <=, >= or =="));
        }
        if piece.text.is_empty() {
            return Err(piece.error("something is missing here; write OUTCOME >= LIMIT"));
        }
    }
    Ok(pieces)
}

/// The terms between the signs + and − outside of parentheses, each with its sign.
fn summands(sum: Piece<'_>) -> Vec<(f64, Piece<'_>)> {
    let mut depth = 0;
    let mut from = 0;
    let mut sign = 1.0;
    let mut terms = vec![];
    for (at, c) in sum.text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            '+' | '-' if depth == 0 && !is_before_exponent(&sum.text[..at]) => {
                let term = sum.slice(from..at);
                if !(term.text.is_empty() && terms.is_empty()) {
                    terms.push((sign, term));
                }
                sign = if c == '-' { -1.0 } else { 1.0 };
                from = at + 1;
            }
            _ => {}
        }
    }
    terms.push((sign, sum.slice(from..sum.text.len())));
    terms
}

/// True if a sign after this text belongs to an exponent. The text then ends with `^`, or with a
/// number and `e`.
fn is_before_exponent(text: &str) -> bool {
    let text = text.trim_end();
    let is_end_of_number =
        |mantissa: &str| mantissa.ends_with(|c: char| c.is_ascii_digit() || c == '.');
    text.ends_with('^') || text.strip_suffix(['e', 'E']).is_some_and(is_end_of_number)
}

impl Scope<'_> {
    fn example(&self) -> &'static str {
        match self {
            Self::Drive => "descent_angle >= 38deg, lateral == 0m or 20yd <= apex_height <= 35yd",
            Self::Swings(_) => "std(lateral) <= 12yd or mean(carry) >= 240yd",
            Self::Relation { .. } => "volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3",
        }
    }

    /// True if a text is a goal, false if it is a limit.
    fn is_goal(&self, text: &str) -> bool {
        match self {
            Self::Drive => Outcome::named(text).is_ok(),
            Self::Swings(_) => text.contains('(') || Outcome::named(text).is_ok(),
            Self::Relation { .. } => Amount::read(text).is_err(),
        }
    }

    fn goal(&self, piece: Piece<'_>) -> Result<Goal> {
        let (expression, terms) = match self {
            Self::Drive => {
                let of = Outcome::named(piece.text).map_err(|error| {
                    piece
                        .error(advice_on_parameter(piece.text).unwrap_or_else(|| error.to_string()))
                })?;
                return Ok(of.into());
            }
            Self::Swings(strokes) => {
                let terms = self.sum(piece, |piece| swings_term(piece, *strokes))?;
                (piece.text, terms)
            }
            Self::Relation { setup, name } => {
                let terms = self.sum(piece, |piece| relation_term(setup, piece))?;
                (*name, terms)
            }
        };
        let quantity = terms[0].quantity.unwrap_or(Quantity::NUMBER);
        let unit = terms[0].unit;
        let is_constant = terms.iter().all(|term| term.measure == Measure::One);
        if is_constant {
            return Err(piece.error(format!(
                "it contains no parameter, so no varied parameter can change it; {RELATION}"
            )));
        }
        let terms = terms.into_iter().map(|term| (term.weight, term.measure));
        Ok(Goal {
            expression: expression.into(),
            terms: terms.collect(),
            quantity,
            unit,
        })
    }

    /// Parses the terms of a sum, which must have the same kind of quantity.
    fn sum(
        &self,
        piece: Piece<'_>,
        read_term: impl Fn(Piece<'_>) -> Result<Term>,
    ) -> Result<Vec<Term>> {
        let mut terms: Vec<Term> = vec![];
        for (sign, piece) in summands(piece) {
            if piece.text.is_empty() {
                return Err(piece.error(match self {
                    Self::Relation { .. } => format!("a term is missing here; {RELATION}"),
                    _ => "a term is missing here; write for example mean(carry) - \
                          0.5*std(lateral)"
                        .into(),
                }));
            }
            let mut term = read_term(piece)?;
            term.weight *= sign;
            let first = terms.first().unwrap_or(&term).quantity;
            let Some(first) = first else {
                return Err(piece.error(
                    "the units of this term give no known quantity, such as a mass, a length or a \
                     volume; check them",
                ));
            };
            self.check_kind(piece, term.quantity, first)?;
            terms.push(term);
        }
        Ok(terms)
    }

    /// Refuses the quantity `found` if its kind differs from the kind of the first term.
    fn check_kind(&self, piece: Piece<'_>, found: Option<Quantity>, first: Quantity) -> Result<()> {
        let name = found.map_or("a quantity of another kind", |quantity| quantity.name);
        match self {
            Self::Relation { .. } if found != Some(first) => Err(piece.error(format!(
                "this is {name}, and the first term is {} (in SI {}): all terms and limits must be \
                 of one kind; check the units",
                first.name, first.si
            ))),
            Self::Swings(_) if found.is_none_or(|found| found.si != first.si) => {
                Err(piece.error(format!(
                    "this is {name}, and the first term is {}: terms that are added must be of one \
                     kind; weight a share with an amount, for \
                     example 30yd*within(lateral, 15yd)",
                    first.name
                )))
            }
            _ => Ok(()),
        }
    }

    fn limit(&self, piece: Piece<'_>, goal: &Goal) -> Result<Limit> {
        let quantity = goal.quantity;
        if let Self::Relation { .. } = self {
            let amount = Amount::read(piece.text).map_err(|error| piece.error(error))?;
            self.check_kind(piece, amount.quantity(), quantity)?;
            let is_one_parameter =
                matches!(goal.terms[..], [(weight, Measure::Parameter(_))] if weight == 1.0);
            if amount.is_on_scale && !is_one_parameter {
                return Err(piece.error(TEMPERATURE_IN_SUM));
            }
            let unit = quantity.split(piece.text).ok();
            return Ok(Limit {
                value: amount.value,
                unit: unit.and_then(|(_, unit)| quantity.known_unit(unit)),
            });
        }
        let value = quantity
            .read(piece.text)
            .map_err(|error| piece.error(error.to_string()))?;
        if !value.is_finite() {
            let reason = "a limit must be a finite number; leave out a side without a limit";
            return Err(piece.error(reason));
        }
        Ok(Limit { value, unit: None })
    }
}

/// Advice for a text that is the name of a parameter: limit the parameter's range instead.
fn advice_on_parameter(text: &str) -> Option<String> {
    let found = Setup::<f64>::modern_driver().parameter(text);
    let is_parameter = matches!(found, Ok(_) | Err(Error::OtherLaw { .. }));
    is_parameter.then(|| {
        format!(
            "{text} is a parameter, and limits are of outcomes; give its range with `vary \
                 {text}=LOW..HIGH`"
        )
    })
}

/// Message for a temperature such as 20 degC, which may be a temperature or a difference.
const TEMPERATURE_IN_SUM: &str = "a sum of terms takes temperatures and their differences in K; \
                                  write for example 293.15 K in place of 20 degC";

/// Parses `AMOUNT` or `[AMOUNT *] PARAMETER`.
fn relation_term(setup: &Setup<f64>, piece: Piece<'_>) -> Result<Term> {
    let (amount, parameter) = match piece.text.rsplit_once('*') {
        Some((amount, name)) => (amount.trim(), Some(name.trim())),
        None if setup.parameter(piece.text).is_ok() => ("1", Some(piece.text)),
        None => (piece.text, None),
    };
    let mut amount = Amount::read(amount).map_err(|error| piece.error(error))?;
    if amount.is_on_scale {
        return Err(piece.error(TEMPERATURE_IN_SUM));
    }
    let mut measure = Measure::One;
    let weight = amount.value;
    if let Some(name) = parameter {
        let unset = setup
            .column(name)
            .ok()
            .filter(|parameter| parameter.unset.is_some());
        let parameter = unset
            .map_or_else(|| setup.variable(name), Ok)
            .map_err(|error| piece.error(error.to_string()))?;
        amount = amount.times(parameter.quantity);
        measure = Measure::Parameter(parameter);
    }
    let quantity = amount.quantity();
    Ok(Term {
        weight,
        measure,
        quantity,
        unit: quantity.map_or("", Quantity::usual_unit),
    })
}

/// Parses `[WEIGHT *] MEASURE(OUTCOME[, AMOUNT])`, or an outcome of the club head.
fn swings_term(piece: Piece<'_>, strokes: Option<&Strokes>) -> Result<Term> {
    let (weight, call) = match piece.text.split_once('*') {
        Some((weight, call)) if !weight.contains('(') => (Some(weight.trim()), call.trim()),
        _ => (None, piece.text),
    };
    let measure = match MeasureCall::read(piece, call)? {
        Some(call) => call.measure(strokes)?,
        None => Measure::Mean(head_outcome(piece, call)?),
    };
    let DisplayUnit { quantity, unit } = measure.unit();
    let term = Term {
        weight: 1.0,
        quantity: Some(quantity),
        unit,
        measure,
    };
    match weight {
        Some(weight) => weighted(piece, weight, term),
        None => Ok(term),
    }
}

/// Multiplies a term by a weight. The weight is a number. For `within` and `strokes` it may also be
/// an amount with a unit.
fn weighted(piece: Piece<'_>, weight: &str, term: Term) -> Result<Term> {
    if let Ok(weight) = weight.parse::<f64>()
        && weight.is_finite()
    {
        return Ok(Term { weight, ..term });
    }
    let amount = |of: Outcome| {
        let weight = of.quantity().read_difference(weight).ok()?;
        Some((weight, of))
    };
    let is_number = term.measure.unit().quantity.si.is_empty();
    let found = is_number.then(|| Outcome::OF_DRIVES.iter().copied().find_map(amount));
    if let Some((weight, of)) = found.flatten() {
        return Ok(Term {
            weight,
            quantity: Some(of.quantity()),
            unit: of.unit(),
            ..term
        });
    }
    Err(piece.error(format!(
        "'{weight}' is no weight; write a number, or for a share an amount with its unit, for \
         example 30yd"
    )))
}

/// Parses an outcome of the club head. It is equal for all swings and needs no measure.
fn head_outcome(piece: Piece<'_>, name: &str) -> Result<Outcome> {
    match Outcome::named(name) {
        Ok(of) if of.group() == OutcomeGroup::Head => Ok(of),
        Ok(_) => Err(piece.error(format!(
            "over many swings an outcome has many values; write a statistic of them, for example \
             mean({name}): {MEASURES}"
        ))),
        Err(_) => Err(piece.error(
            advice_on_parameter(name)
                .unwrap_or_else(|| format!("'{name}' is no measure; use {MEASURES}")),
        )),
    }
}

/// A measure with its arguments in parentheses.
struct MeasureCall<'a> {
    piece: Piece<'a>,
    name: &'a str,
    inside: &'a str,
    arguments: Vec<&'a str>,
}

impl<'a> MeasureCall<'a> {
    /// Parses a call; `None` if the text has no parentheses.
    fn read(piece: Piece<'a>, text: &'a str) -> Result<Option<Self>> {
        let Some((name, rest)) = text.split_once('(') else {
            return Ok(None);
        };
        let name = name.trim();
        let Some((inside, behind)) = rest.split_once(')') else {
            return Err(piece.error("its closing ) is missing"));
        };
        let weight_before =
            format!("a weight comes before the measure, for example 0.5*{name}({inside})");
        match behind.trim() {
            "" => {}
            behind if behind.starts_with('/') => {
                return Err(piece.error(format!("there is no division; {weight_before}")));
            }
            behind if behind.contains('(') => {
                return Err(piece.error(format!("a + or - is missing before '{behind}'")));
            }
            behind => {
                let reason = format!("'{behind}' follows the ); {weight_before}");
                return Err(piece.error(reason));
            }
        }
        Ok(Some(Self {
            piece,
            name,
            inside,
            arguments: inside.split(',').map(str::trim).collect(),
        }))
    }

    fn measure(&self, strokes: Option<&Strokes>) -> Result<Measure> {
        Ok(match (self.name, self.arguments.as_slice()) {
            ("mean", [of]) => Measure::Mean(self.outcome(of)?),
            ("std", [of]) => Measure::Deviation(self.outcome(of)?),
            ("rms", [of]) => Measure::RootMeanSquare(self.outcome(of)?),
            ("lowest", [of, share]) => Measure::Lowest(self.outcome(of)?, self.share(share)?),
            ("highest", [of, share]) => Measure::Highest(self.outcome(of)?, self.share(share)?),
            ("within", [of, half]) => {
                let of = self.outcome(of)?;
                Measure::Within(of, self.amount(of.quantity(), half)?)
            }
            ("strokes", [hole]) => {
                let Some(strokes) = strokes else {
                    let reason = "expected strokes need a table; give its file with `strokes FILE`";
                    return Err(self.piece.error(reason));
                };
                Measure::Strokes(strokes.clone(), self.amount(Quantity::LENGTH, hole)?)
            }
            ("mean" | "std" | "rms" | "lowest" | "highest" | "within" | "strokes", _) => {
                return Err(self.piece.error(format!(
                    "{} does not have the arguments that it needs; use {MEASURES}",
                    self.name
                )));
            }
            _ => return Err(self.unknown()),
        })
    }

    fn outcome(&self, name: &str) -> Result<Outcome> {
        Outcome::named(name).map_err(|error| self.piece.error(error.to_string()))
    }

    fn share(&self, text: &str) -> Result<f64> {
        let share = match text.strip_suffix('%') {
            Some(percent) => percent.trim().parse::<f64>().map(|percent| percent / 100.0),
            None => text.parse(),
        };
        share
            .ok()
            .filter(|share| *share > 0.0 && *share < 1.0)
            .ok_or_else(|| {
                self.piece.error(format!(
                    "'{text}' must be a share above 0 and below 100%, for example 10%"
                ))
            })
    }

    fn amount(&self, quantity: Quantity, text: &str) -> Result<f64> {
        let amount = quantity
            .read_difference(text)
            .map_err(|error| self.piece.error(error.to_string()))?;
        if amount > 0.0 && amount.is_finite() {
            return Ok(amount);
        }
        Err(self.piece.error(format!("'{text}' must be above 0")))
    }

    /// Error for an unknown measure, or for a weight without the multiplication sign: `0.5 std(…)`.
    fn unknown(&self) -> Error {
        let weighted = self
            .name
            .split_once(char::is_whitespace)
            .filter(|(weight, _)| weight.parse::<f64>().is_ok());
        self.piece.error(match weighted {
            Some((weight, name)) => format!(
                "a * is missing between a weight and its measure; write {weight}*{}({})",
                name.trim(),
                self.inside
            ),
            None => format!("'{}' is no measure; use {MEASURES}", self.name),
        })
    }
}
