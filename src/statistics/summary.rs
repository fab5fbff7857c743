use super::histogram::Histogram;
use super::moments::Moments;
use super::ranking::Ranking;
use crate::batch::{Batch, Block, StatusCounts};
use crate::error::{Error, Result};
use crate::repeated::first_repeated;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Specification of a batch's summary: its histograms and rankings.
#[derive(Clone, Debug)]
pub struct SummarySpec {
    /// Empty histograms.
    histograms: Vec<Histogram>,
    /// Empty rankings.
    best: Vec<Ranking>,
    columns: Vec<String>,
    parameters: Vec<&'static str>,
}

/// Summary of a batch's rows: status counts, moments of every outcome and derivative, histograms
/// and best rows. Summaries of the same batch merge without access to the rows. Merging in the same
/// order gives the same bits.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Summary {
    /// Number of drives by status.
    #[serde(flatten)]
    pub status_counts: StatusCounts,
    /// Moments of each outcome and derivative, by column name.
    pub moments: BTreeMap<String, Moments>,
    /// Requested histograms.
    pub histograms: Vec<Histogram>,
    /// Requested rows with the highest and lowest values.
    pub best: Vec<Ranking>,
}

/// Refuses histograms and rankings that already have values. The summary of each block starts as a
/// copy of them: their values would count once for each block.
fn refuse_filled(histograms: &[Histogram], best: &[Ranking]) -> Result<()> {
    let has_values = |histogram: &&Histogram| {
        let outside = [histogram.below, histogram.above];
        histogram
            .counts
            .iter()
            .chain(&outside)
            .any(|count| *count > 0)
    };
    let filled = histograms.iter().find(has_values);
    let filled = filled.map(|histogram| format!("the histogram of {}", histogram.of));
    let ranked = best.iter().find(|ranking| !ranking.rows.is_empty());
    let ranked = ranked.map(|ranking| format!("the rows of {}", ranking.of));
    match filled.or(ranked) {
        None => Ok(()),
        Some(given) => Err(Error::Together {
            given,
            reason: "there are values in it already; give an empty one".into(),
        }),
    }
}

impl SummarySpec {
    /// Specifies histograms and rankings, which must be empty. Every summary also has status counts
    /// and moments.
    ///
    /// # Errors
    /// [`Error::Together`] for an outcome that is not computed, for repeated requests, and for a
    /// histogram or a ranking that is not empty.
    pub fn new(batch: &Batch, histograms: Vec<Histogram>, best: Vec<Ranking>) -> Result<Self> {
        let twice = |what: &str, of: &str| Error::Together {
            given: format!("{what} of {of}"),
            reason: "it is requested twice; keep one".into(),
        };
        if let Some([_, again]) = first_repeated(&histograms, |a, b| a.of == b.of) {
            return Err(twice("the histogram", &histograms[again].of));
        }
        let is_same = |a: &Ranking, b: &Ranking| a.of == b.of && a.highest == b.highest;
        if let Some([_, again]) = first_repeated(&best, is_same) {
            return Err(twice("the rows", &best[again].of));
        }
        refuse_filled(&histograms, &best)?;
        let of_histograms = histograms.iter().map(|histogram| &histogram.of);
        let mut of = of_histograms.chain(best.iter().map(|ranking| &ranking.of));
        let is_computed = |of: &str| batch.outcomes().iter().any(|outcome| outcome.name() == of);
        if let Some(missing) = of.find(|of| !is_computed(of)) {
            return Err(Error::Together {
                given: missing.clone(),
                reason: "it is not among the outcomes that are computed; add it to `outcomes`"
                    .into(),
            });
        }
        Ok(Self {
            columns: batch.columns(),
            parameters: batch
                .parameters()
                .iter()
                .map(|parameter| parameter.name)
                .collect(),
            histograms,
            best,
        })
    }

    /// Text that identifies the histograms and rankings: equal requests have equal texts.
    pub fn identity(&self) -> String {
        let histograms = self.histograms.iter().map(|histogram| {
            let [low, high] = histogram.range;
            let bins = histogram.counts.len();
            format!("histogram {}={low:?}..{high:?}:{bins}", histogram.of)
        });
        let rankings = self.best.iter().map(|ranking| {
            let which = if ranking.highest { "highest" } else { "lowest" };
            format!("{which} {}:{}", ranking.of, ranking.most)
        });
        histograms.chain(rankings).collect::<Vec<_>>().join(", ")
    }

    /// Empty summary.
    pub fn empty(&self) -> Summary {
        Summary {
            status_counts: StatusCounts::default(),
            moments: self
                .columns
                .iter()
                .map(|name| (name.clone(), Moments::default()))
                .collect(),
            histograms: self.histograms.clone(),
            best: self.best.clone(),
        }
    }

    /// Summary of a block.
    pub fn of(&self, block: &Block) -> Summary {
        let mut summary = self.empty();
        summary.status_counts.add(block);
        for (column, name) in self.columns.iter().enumerate() {
            summary
                .moments
                .insert(name.clone(), Moments::of(block.result(column).flatten()));
        }
        let values = |of: &str| {
            let column = self.columns.iter().position(|column| column == of);
            column.into_iter().flat_map(|column| block.result(column))
        };
        for histogram in &mut summary.histograms {
            values(&histogram.of)
                .flatten()
                .for_each(|value| histogram.add(value));
        }
        for ranking in &mut summary.best {
            for (row, value) in values(&ranking.of).enumerate() {
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
    /// Adds the summary of later rows of the same batch.
    pub fn merge(&mut self, after: &Self) {
        self.status_counts.merge(&after.status_counts);
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
}
