//! Limits of something that a drive has: `THING >= LIMIT`, `THING <= LIMIT`, `THING == VALUE` or
//! `LOW <= THING <= HIGH`.

use crate::error::{Error, Result};
use crate::units::Quantity;

/// The signs between a thing and its limits.
const SIGNS: [&str; 5] = ["<=", ">=", "==", "≤", "≥"];

/// What stands between its limits.
pub(super) struct Compared<T> {
    pub of: T,
    /// Least value, SI, or −∞.
    pub low: f64,
    /// Greatest value, SI, or ∞.
    pub high: f64,
}

/// Reads a comparison. `is_thing` tells the thing from a limit; `read` reads it, and what reads its
/// limits.
///
/// # Errors
/// [`Error::Constraint`], which points into the expression.
pub(super) fn compared<T, L: Fn(&Part<'_>) -> Result<f64>>(
    expression: &str,
    example: &str,
    is_thing: impl Fn(&str) -> bool,
    read: impl Fn(&Part<'_>) -> Result<(T, L)>,
) -> Result<Compared<T>> {
    let parts = split(expression)?;
    let (low, of, high) = match parts.as_slice() {
        [left, sign, right] => {
            let is_turned = !is_thing(left.text) && is_thing(right.text);
            let (thing, limit) = if is_turned {
                (right, left)
            } else {
                (left, right)
            };
            let (of, limit_of) = read(thing)?;
            let value = limit_of(limit)?;
            match is_at_most(sign) {
                None => (value, of, value),
                Some(is_at_most) if is_at_most != is_turned => (f64::NEG_INFINITY, of, value),
                Some(_) => (value, of, f64::INFINITY),
            }
        }
        [left, first, middle, second, right] => {
            let (of, limit_of) = read(middle)?;
            let (left, right) = (limit_of(left)?, limit_of(right)?);
            match (is_at_most(first), is_at_most(second)) {
                (Some(true), Some(true)) => (left, of, right),
                (Some(false), Some(false)) => (right, of, left),
                _ => {
                    let reason = "a range needs the same comparison twice: LOW <= OUTCOME <= HIGH";
                    return Err(at(expression, second, reason));
                }
            }
        }
        _ => {
            let place = parts.get(1).or(parts.first());
            return Err(Error::Constraint {
                expression: expression.into(),
                column: place.map_or(0, |part| part.column),
                reason: format!(
                    "there is no comparison (<=, >= or ==) with something on both sides; write for \
                     example {example}"
                ),
            });
        }
    };
    if low > high {
        let reason = "the range is reversed: its lower limit is above its upper limit";
        return Err(at(expression, &parts[0], reason));
    }
    Ok(Compared { of, low, high })
}

/// A piece of an expression, and where it stands, in characters from 0.
pub(super) struct Part<'a> {
    pub text: &'a str,
    pub column: usize,
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
        Part {
            text: text.trim(),
            column: expression[..from + lead].chars().count(),
        }
    };
    while let Some((place, sign)) = SIGNS
        .iter()
        .filter_map(|sign| {
            expression[from..]
                .find(sign)
                .map(|place| (from + place, *sign))
        })
        .min()
    {
        parts.push(part(from, place));
        parts.push(part(place, place + sign.len()));
        from = place + sign.len();
    }
    parts.push(part(from, expression.len()));
    for part in &parts {
        let stray = part
            .text
            .find(['<', '>', '='])
            .filter(|_| !SIGNS.contains(&part.text));
        if let Some(stray) = stray {
            let column = part.column + part.text[..stray].chars().count();
            let reason = "this is not a comparison; write <=, >= or ==".into();
            return Err(Error::Constraint {
                expression: expression.into(),
                column,
                reason,
            });
        }
        if part.text.is_empty() {
            return Err(at(
                expression,
                part,
                "something is missing here; write OUTCOME >= LIMIT",
            ));
        }
    }
    Ok(parts)
}

/// A limit, SI.
pub(super) fn value(expression: &str, part: &Part<'_>, quantity: Quantity) -> Result<f64> {
    let value = quantity
        .read(part.text)
        .map_err(|e| at(expression, part, &e.to_string()))?;
    if value.is_finite() {
        return Ok(value);
    }
    Err(at(
        expression,
        part,
        "a limit must be a finite number; leave out the side that has none",
    ))
}

/// What is wrong at a place of an expression.
pub(super) fn at(expression: &str, part: &Part<'_>, reason: &str) -> Error {
    Error::Constraint {
        expression: expression.into(),
        column: part.column,
        reason: reason.into(),
    }
}
