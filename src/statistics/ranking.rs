use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::json::JsonNumber;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Default number of ranked rows.
const DEFAULT_ROWS: usize = 10;
/// Maximum number of ranked rows. Every part of a sweep stores its own ranked rows.
const MOST_ROWS: usize = 10_000;

/// A row with its number, its value of the outcome, and its point, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RankedRow {
    /// Row number in the whole sweep, from 0.
    pub row: u64,
    /// Value of the outcome.
    pub value: f64,
    /// Values of the swept parameters, by name. A value missing in a table of points is `null`; an
    /// infinite value (a flat face) is the text `inf`.
    pub point: BTreeMap<String, JsonNumber>,
}

/// Rows with the highest or lowest values of an outcome, best first. Equal values are sorted by row
/// number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Ranking {
    /// The outcome.
    pub of: String,
    /// True for the highest values, false for the lowest.
    pub highest: bool,
    /// Maximum number of rows.
    pub most: usize,
    /// Rows.
    pub rows: Vec<RankedRow>,
}

impl Ranking {
    /// Reads `OUTCOME:N`, for example `carry:10`, as an empty ranking of N rows. The default of N
    /// is 10.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if N is invalid, and [`Error::Unknown`] if the outcome is unknown.
    pub fn read(text: &str, highest: bool) -> Result<Self> {
        let (name, most) = match text.rsplit_once(':') {
            None => (text, Some(DEFAULT_ROWS)),
            Some((name, count)) => (name, count.trim().parse().ok()),
        };
        let of = Outcome::named(name.trim())?;
        match most {
            Some(most) if (1..=MOST_ROWS).contains(&most) => Ok(Self {
                of: of.name().into(),
                highest,
                most,
                rows: vec![],
            }),
            _ => {
                let reason = format!(
                    "the number of rows must be from 1 to {MOST_ROWS}; write for example \
                     {name}:{DEFAULT_ROWS}"
                );
                let option = if highest { "`highest`" } else { "`lowest`" };
                Err(Error::unreadable(
                    format!("{option} {}", text.trim()),
                    reason,
                ))
            }
        }
    }

    /// Adds a row if its `value`, which is finite, is among the `most` best values.
    pub fn add<'a>(
        &mut self,
        row: u64,
        value: f64,
        point: impl IntoIterator<Item = (&'a str, f64)>,
    ) {
        let better = |other: &RankedRow| {
            self.order((row, value), (other.row, other.value)) == Ordering::Less
        };
        if self.rows.len() < self.most || self.rows.last().is_some_and(better) {
            let point = point
                .into_iter()
                .map(|(name, value)| {
                    (
                        name.to_owned(),
                        Some(value).filter(|value| !value.is_nan()).into(),
                    )
                })
                .collect();
            self.insert(RankedRow { row, value, point });
        }
    }

    /// Merges another ranking.
    pub fn merge(&mut self, other: &Self) {
        other.rows.iter().for_each(|row| self.insert(row.clone()));
    }

    fn insert(&mut self, row: RankedRow) {
        let place = |other: &RankedRow| {
            self.order((other.row, other.value), (row.row, row.value)) == Ordering::Less
        };
        let at = self.rows.partition_point(place);
        self.rows.insert(at, row);
        self.rows.truncate(self.most);
    }

    fn order(&self, a: (u64, f64), b: (u64, f64)) -> Ordering {
        // 0 and −0 are equal values
        let values = a.1.partial_cmp(&b.1).unwrap_or(Ordering::Equal);
        (if self.highest {
            values.reverse()
        } else {
            values
        })
        .then(a.0.cmp(&b.0))
    }
}
