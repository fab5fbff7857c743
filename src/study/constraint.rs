use crate::drive::Outcome;
use crate::error::{Error, Result};

/// Limits of an outcome: `descent_angle >= 38 deg`.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    /// As it was given.
    pub expression: String,
    /// The outcome.
    pub outcome: Outcome,
    /// Least value, SI, or −∞.
    pub low: f64,
    /// Greatest value, SI, or ∞.
    pub high: f64,
}

/// The signs between an outcome and its limits.
const SIGNS: [&str; 5] = ["<=", ">=", "==", "≤", "≥"];

impl Constraint {
    /// Whether it is an equation, which holds wherever it is met.
    pub fn is_equation(&self) -> bool {
        self.low == self.high
    }

    /// Reads `OUTCOME >= LIMIT`, `OUTCOME <= LIMIT`, `OUTCOME == VALUE` or `LOW <= OUTCOME <= HIGH`; a limit is a number
    /// with its unit.
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
    /// [`Error::Constraint`], which points into the expression.
    pub fn read(expression: &str) -> Result<Self> {
        let parts = split(expression)?;
        let (low, outcome, high) = match parts.as_slice() {
            [left, sign, right] => {
                let is_turned = Outcome::named(left.text).is_err() && Outcome::named(right.text).is_ok();
                let (name, limit) = if is_turned { (right, left) } else { (left, right) };
                let outcome = outcome(expression, name)?;
                let value = value(expression, limit, outcome)?;
                match is_at_most(sign) {
                    None => (value, outcome, value),
                    Some(is_at_most) if is_at_most != is_turned => (f64::NEG_INFINITY, outcome, value),
                    Some(_) => (value, outcome, f64::INFINITY),
                }
            }
            [left, first, middle, second, right] => {
                let outcome = outcome(expression, middle)?;
                let (left, right) = (value(expression, left, outcome)?, value(expression, right, outcome)?);
                match (is_at_most(first), is_at_most(second)) {
                    (Some(true), Some(true)) => (left, outcome, right),
                    (Some(false), Some(false)) => (right, outcome, left),
                    _ => {
                        return Err(at(
                            expression,
                            second,
                            "a range needs the same comparison twice: LOW <= OUTCOME <= HIGH",
                        ));
                    }
                }
            }
            _ => {
                let place = parts.get(1).or(parts.first());
                let how = "write for example descent_angle >= 38deg, lateral == 0m or 20yd <= apex_height <= 35yd";
                return Err(Error::Constraint {
                    expression: expression.into(),
                    column: place.map_or(0, |part| part.column),
                    reason: format!("there is no comparison (<=, >= or ==) with something on both sides; {how}"),
                });
            }
        };
        if low > high {
            let reason = "the range is reversed: its lower limit is above its upper limit";
            return Err(at(expression, &parts[0], reason));
        }
        Ok(Self { expression: expression.trim().into(), outcome, low, high })
    }
}

/// A piece of an expression, and where it stands, in characters from 0.
struct Part<'a> {
    text: &'a str,
    column: usize,
}

fn is_at_most(sign: &Part<'_>) -> Option<bool> {
    match sign.text {
        "<=" | "≤" => Some(true),
        ">=" | "≥" => Some(false),
        _ => None,
    }
}

/// What stands between the signs, and the signs.
fn split(expression: &str) -> Result<Vec<Part<'_>>> {
    let mut parts = vec![];
    let mut from = 0;
    let part = |from: usize, to: usize| {
        let text = &expression[from..to];
        let lead = text.len() - text.trim_start().len();
        Part { text: text.trim(), column: expression[..from + lead].chars().count() }
    };
    while let Some((place, sign)) =
        SIGNS.iter().filter_map(|sign| expression[from..].find(sign).map(|place| (from + place, *sign))).min()
    {
        parts.push(part(from, place));
        parts.push(part(place, place + sign.len()));
        from = place + sign.len();
    }
    parts.push(part(from, expression.len()));
    for part in &parts {
        let stray = part.text.find(['<', '>', '=']).filter(|_| !SIGNS.contains(&part.text));
        if let Some(stray) = stray {
            let column = part.column + part.text[..stray].chars().count();
            let reason = "this is not a comparison; write <=, >= or ==".into();
            return Err(Error::Constraint { expression: expression.into(), column, reason });
        }
        if part.text.is_empty() {
            return Err(at(expression, part, "something is missing here; write OUTCOME >= LIMIT"));
        }
    }
    Ok(parts)
}

fn outcome(expression: &str, part: &Part<'_>) -> Result<Outcome> {
    Outcome::named(part.text).map_err(|e| at(expression, part, &e.to_string()))
}

fn value(expression: &str, part: &Part<'_>, outcome: Outcome) -> Result<f64> {
    let value = outcome.quantity().read(part.text).map_err(|e| at(expression, part, &e.to_string()))?;
    if value.is_finite() {
        return Ok(value);
    }
    Err(at(expression, part, "a limit must be a finite number; leave out the side that has none"))
}

fn at(expression: &str, part: &Part<'_>, reason: &str) -> Error {
    Error::Constraint { expression: expression.into(), column: part.column, reason: reason.into() }
}
