use crate::drive::Outcome;
use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Rows where their number is not given, and the most: every part of a sweep keeps them all.
const USUAL: usize = 10;
const MOST: usize = 10_000;

/// Which rows are kept by themselves: those with the highest or the lowest values of an outcome.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sought {
    /// The outcome.
    pub of: Outcome,
    /// Whether the highest are kept, and not the lowest.
    pub highest: bool,
    /// How many.
    pub most: usize,
}

impl Sought {
    /// Reads `OUTCOME:N`, for example `carry:10`; without a number there are 10.
    ///
    /// # Errors
    /// [`Error::SearchRange`] for a number that is none, [`Error::Unknown`].
    pub fn read(text: &str, highest: bool) -> Result<Self> {
        let (name, most) = match text.rsplit_once(':') {
            None => (text, Some(USUAL)),
            Some((name, count)) => (name, count.trim().parse().ok()),
        };
        let of = Outcome::named(name.trim())?;
        match most {
            Some(most) if (1..=MOST).contains(&most) => Ok(Self { of, highest, most }),
            _ => {
                let reason = format!(
                    "the number of rows must be from 1 to {MOST}; write for example {name}:{USUAL}"
                );
                Err(Error::SearchRange {
                    name: format!("of the rows to keep, {}", text.trim()),
                    reason,
                })
            }
        }
    }

    /// The rows in words that tell them from any others.
    pub fn identity(&self) -> String {
        format!(
            "{} {}:{}",
            if self.highest { "highest" } else { "lowest" },
            self.of.name(),
            self.most
        )
    }
}

/// A row with its number, its value of the outcome, and its point, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RankedRow {
    /// The row of the whole sweep, from 0.
    pub row: u64,
    /// The value of the outcome.
    pub value: f64,
    /// The values of the swept parameters, by their names. A value that is missing in a table of
    /// points is `None`, an infinite one (a flat face) the text `inf`.
    pub point: BTreeMap<String, Option<Coordinate>>,
}

/// A value of a swept parameter. JSON has no infinity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Coordinate {
    /// A finite one.
    Finite(f64),
    /// An infinite one.
    Infinite(Infinite),
}

/// `inf`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Infinite {
    /// Above every number.
    #[serde(rename = "inf")]
    Above,
    /// Below every number.
    #[serde(rename = "-inf")]
    Below,
}

impl Coordinate {
    fn of(value: f64) -> Option<Self> {
        match value {
            value if value.is_nan() => None,
            f64::INFINITY => Some(Self::Infinite(Infinite::Above)),
            f64::NEG_INFINITY => Some(Self::Infinite(Infinite::Below)),
            value => Some(Self::Finite(value)),
        }
    }
}

/// The rows with the highest or the lowest values of an outcome, the best first; of equal values
/// the first row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ranking {
    /// The outcome.
    pub of: String,
    /// Whether the highest are kept, and not the lowest.
    pub highest: bool,
    /// How many are kept at most.
    pub most: usize,
    /// The rows.
    pub rows: Vec<RankedRow>,
}

impl Ranking {
    /// No rows yet.
    pub fn new(sought: &Sought) -> Self {
        Self {
            of: sought.of.name().into(),
            highest: sought.highest,
            most: sought.most,
            rows: vec![],
        }
    }

    /// Looks at a row with a finite value.
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
                .map(|(name, value)| (name.to_owned(), Coordinate::of(value)))
                .collect();
            self.insert(RankedRow { row, value, point });
        }
    }

    /// Takes the best of other rows in.
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
