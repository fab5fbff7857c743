use super::points::{Points, refuse_repeated};
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::{Parameter, Vary};

/// Scrambled Sobol sequence over the ranges of several parameters (Owen 1995; Burley 2020). The
/// first n points are evenly spread for every n. The scrambling changes after every 65,536 points.
#[derive(Clone, Debug)]
pub struct Sequence {
    over: Vec<Vary>,
    parameters: Vec<&'static Parameter>,
    rows: u64,
    seed: u32,
    next: u64,
}

impl Sequence {
    /// Sequence of the first `rows` points over the ranges `over`. Different seeds give different
    /// points.
    ///
    /// # Errors
    /// [`Error::SearchRange`] if `over` repeats a parameter or has too many parameters;
    /// [`Error::Nothing`] if `over` is empty.
    pub fn new(over: Vec<Vary>, rows: u64, seed: u32) -> Result<Self> {
        let parameters: Vec<_> = over.iter().map(|vary| vary.parameter).collect();
        refuse_repeated(&parameters)?;
        if over.len() > sobol::MOST_VARIABLES {
            let reason = format!(
                "a sample can vary at most {}; remove some of the ranges `over`",
                sobol::MOST_VARIABLES
            );
            return Err(Error::SearchRange {
                name: format!("of {} parameters", over.len()),
                reason,
            });
        }
        Ok(Self {
            over,
            parameters,
            rows,
            seed,
            next: 0,
        })
    }
}

impl Points for Sequence {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    fn ranges(&self) -> Vec<Vary> {
        self.over.clone()
    }

    fn rows(&self) -> u64 {
        self.rows
    }

    fn seek(&mut self, row: u64) -> Result<()> {
        self.next = row;
        Ok(())
    }

    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize> {
        let rows = self.rows.saturating_sub(self.next).min(most as u64);
        for row in self.next..self.next + rows {
            let value = |(i, vary): (usize, &Vary)| {
                vary.low + sobol::coordinate(row, i, self.seed) * (vary.high - vary.low)
            };
            values.extend(self.over.iter().enumerate().map(value));
        }
        self.next += rows;
        Ok(rows as usize)
    }

    fn identity(&self) -> String {
        let range =
            |vary: &Vary| format!("{}={:?}..{:?}", vary.parameter.name, vary.low, vary.high);
        let ranges: Vec<_> = self.over.iter().map(range).collect();
        format!(
            "{} points, seed {}, of {}",
            self.rows,
            self.seed,
            ranges.join(" ")
        )
    }
}
