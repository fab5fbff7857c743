use super::histogram::{Bins, Histogram};
use super::moments::Moments;
use super::ranking::{Ranking, Sought};
use crate::batch::{Batch, Block, Status, Tally};
use crate::drive::{ExceededCount, Outcome};
use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What is summarized of the rows of a batch.
#[derive(Clone, Debug)]
pub struct Summarized {
    bins: Vec<(usize, Bins)>,
    sought: Vec<(usize, Sought)>,
    columns: Vec<String>,
    parameters: Vec<&'static str>,
}

/// What the rows of a batch are like in all: how they ended, the moments of every outcome and
/// derivative, histograms and the best rows. It merges with that of other rows of the same batch,
/// without a look at the rows. What is merged in the same order is the same to the last bit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// How many drives ended how.
    pub statuses: BTreeMap<Status, u64>,
    /// Of the drives that landed: how many begin with what the law was not fitted to, how many were
    /// struck beside any face, and how many landed flatter than any bounce that was measured.
    pub beyond: [u64; 3],
    /// The moments of each outcome and derivative, by the names of the columns.
    pub moments: BTreeMap<String, Moments>,
    /// The histograms that were asked for.
    pub histograms: Vec<Histogram>,
    /// The rows with the highest and lowest values that were asked for.
    pub best: Vec<Ranking>,
}

impl Summarized {
    /// The tally and the moments of a batch, with these histograms and best rows.
    ///
    /// # Errors
    /// [`Error::Together`] for a histogram or best rows of an outcome that is not computed, and for
    /// what is asked for twice.
    pub fn new(batch: &Batch, bins: &[Bins], sought: &[Sought]) -> Result<Self> {
        let column = |of: Outcome| {
            batch
                .outcomes()
                .iter()
                .position(|known| *known == of)
                .ok_or_else(|| Error::Together {
                    given: of.name().into(),
                    reason: "it is not among the outcomes that are computed; add it to `outcomes`"
                        .into(),
                })
        };
        let twice = |what: &str, of: Outcome| Error::Together {
            given: format!("{what} of {}", of.name()),
            reason: "it is asked for twice; keep one".into(),
        };
        for (at, one) in bins.iter().enumerate() {
            if bins[..at].iter().any(|other| other.of == one.of) {
                return Err(twice("the histogram", one.of));
            }
        }
        for (at, one) in sought.iter().enumerate() {
            if sought[..at]
                .iter()
                .any(|other| other.of == one.of && other.highest == one.highest)
            {
                return Err(twice("the rows", one.of));
            }
        }
        Ok(Self {
            bins: bins
                .iter()
                .map(|bins| Ok((column(bins.of)?, *bins)))
                .collect::<Result<_>>()?,
            sought: sought
                .iter()
                .map(|sought| Ok((column(sought.of)?, *sought)))
                .collect::<Result<_>>()?,
            columns: batch.columns(),
            parameters: batch
                .parameters()
                .iter()
                .map(|parameter| parameter.name)
                .collect(),
        })
    }

    /// The histograms and best rows in words that tell them from any others.
    pub fn identity(&self) -> String {
        let bins = self
            .bins
            .iter()
            .map(|(_, bins)| format!("histogram {}", bins.identity()));
        bins.chain(self.sought.iter().map(|(_, sought)| sought.identity()))
            .collect::<Vec<_>>()
            .join(", ")
    }

    /// The summary of no rows.
    pub fn none(&self) -> Summary {
        Summary {
            statuses: Tally::default().counts().collect(),
            beyond: [0; 3],
            moments: self
                .columns
                .iter()
                .map(|name| (name.clone(), Moments::default()))
                .collect(),
            histograms: self
                .bins
                .iter()
                .map(|(_, bins)| Histogram::new(bins))
                .collect(),
            best: self
                .sought
                .iter()
                .map(|(_, sought)| Ranking::new(sought))
                .collect(),
        }
    }

    /// The summary of a block.
    pub fn of(&self, block: &Block) -> Summary {
        let mut summary = self.none();
        let mut tally = Tally::default();
        tally.add(block);
        summary.statuses = tally.counts().collect();
        let ExceededCount {
            law, face, flat, ..
        } = tally.beyond();
        summary.beyond = [law, face, flat];
        for (column, name) in self.columns.iter().enumerate() {
            summary
                .moments
                .insert(name.clone(), Moments::of(block.result(column).flatten()));
        }
        for ((column, _), histogram) in self.bins.iter().zip(&mut summary.histograms) {
            block
                .result(*column)
                .flatten()
                .for_each(|value| histogram.add(value));
        }
        for ((column, _), ranking) in self.sought.iter().zip(&mut summary.best) {
            for (row, value) in block.result(*column).enumerate() {
                if let Some(value) = value {
                    let point = self
                        .parameters
                        .iter()
                        .copied()
                        .zip(block.point(row).iter().copied());
                    ranking.add(block.first_row() + row as u64, value, point);
                }
            }
        }
        summary
    }
}

impl Summary {
    /// Adds that of rows that come after, of the same batch.
    pub fn merge(&mut self, after: &Self) {
        for (status, count) in &after.statuses {
            *self.statuses.entry(*status).or_default() += count;
        }
        self.beyond
            .iter_mut()
            .zip(after.beyond)
            .for_each(|(ours, theirs)| *ours += theirs);
        for (column, moments) in &after.moments {
            self.moments
                .entry(column.clone())
                .or_default()
                .merge(moments);
        }
        self.histograms
            .iter_mut()
            .zip(&after.histograms)
            .for_each(|(ours, theirs)| ours.merge(theirs));
        self.best
            .iter_mut()
            .zip(&after.best)
            .for_each(|(ours, theirs)| ours.merge(theirs));
    }

    /// How the drives ended, as a tally.
    pub fn tally(&self) -> Tally {
        let [law, face, flat] = self.beyond;
        let all = self
            .statuses
            .get(&Status::Landed)
            .copied()
            .unwrap_or_default();
        Tally::of(
            &self.statuses,
            ExceededCount {
                all,
                law,
                face,
                flat,
            },
        )
    }

    /// How many rows there are.
    pub fn rows(&self) -> u64 {
        self.statuses.values().sum()
    }
}
