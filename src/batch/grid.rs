use super::points::{Points, refuse_repeated};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Vary};

/// Equally spaced values of a parameter over a range, both ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridAxis {
    /// Parameter and range, SI.
    pub over: Vary,
    /// Number of values; a count of 1 gives only the lower end.
    pub count: u64,
}

impl GridAxis {
    /// Reads `NAME=LOW..HIGH:COUNT`, for example `club.loft=5deg..15deg:101`.
    ///
    /// ```
    /// use longdrive::{Setup, batch::GridAxis};
    /// let axis = GridAxis::read(&Setup::modern_driver(), "swing.speed=40..50m/s:6").unwrap();
    /// assert_eq!((axis.value(0), axis.value(1), axis.value(5)), (40.0, 42.0, 50.0));
    /// ```
    ///
    /// # Errors
    /// [`Error::SearchRange`] if the count in `text` is missing or zero, or 1 for two different
    /// ends; errors of [`Vary::read`].
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let refuse = |reason: String| Error::SearchRange {
            name: text.trim().into(),
            reason,
        };
        let Some((range, count)) = text.rsplit_once(':') else {
            // report an invalid range before a missing count
            Vary::read_column(setup, text)?;
            return Err(refuse(format!(
                "the number of values is missing; write for example {}:101",
                text.trim()
            )));
        };
        let over = Vary::read_column(setup, range)?;
        match count.trim().parse() {
            Ok(0) => Err(refuse(
                "the number of values must be at least 1; write for example :101".into(),
            )),
            Ok(1) if over.low < over.high => Err(refuse(
                "one value does not include both ends; write for example :2, or the same value \
                 for both ends"
                    .into(),
            )),
            Ok(count) => Ok(Self { over, count }),
            Err(_) => Err(refuse(format!(
                "'{count}' is not a number of values; write for example {range}:101"
            ))),
        }
    }

    /// Value i, from 0, SI: low + (high − low) i/(count − 1).
    pub fn value(&self, i: u64) -> f64 {
        let Vary { low, high, .. } = self.over;
        match i {
            0 => low,
            // the exact end, without rounding
            i if i + 1 >= self.count => high,
            i => low + (high - low) * i as f64 / (self.count - 1) as f64,
        }
    }
}

/// Cartesian grid of several axes. The first axis varies slowest, the last axis varies fastest.
#[derive(Clone, Debug)]
pub struct Grid {
    axes: Vec<GridAxis>,
    parameters: Vec<&'static Parameter>,
    rows: u64,
    next: u64,
}

impl Grid {
    /// Grid of these axes.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if the number of rows overflows; [`Error::SearchRange`] if an axis has
    /// no values or a parameter is repeated; [`Error::Nothing`] if `axes` is empty.
    pub fn new(axes: Vec<GridAxis>) -> Result<Self> {
        let parameters: Vec<_> = axes.iter().map(|axis| axis.over.parameter).collect();
        refuse_repeated(&parameters)?;
        if let Some(axis) = axes.iter().find(|axis| axis.count == 0) {
            let reason = "the number of values must be at least 1".into();
            return Err(Error::SearchRange {
                name: axis.over.parameter.name.into(),
                reason,
            });
        }
        let rows = axes
            .iter()
            .try_fold(1_u64, |rows, axis| rows.checked_mul(axis.count));
        let rows = rows.ok_or_else(|| {
            let rows: f64 = axes.iter().map(|axis| axis.count as f64).product();
            Error::TooLarge {
                rows: format!("{rows:.1e}"),
                size: format!("{:.1e} GB", rows * 8.0 * (axes.len() + 1) as f64 / 1e9),
                limit: "any disk".into(),
                advice: "take fewer values, or `sample` points of the same ranges".into(),
            }
        })?;
        Ok(Self {
            axes,
            parameters,
            rows,
            next: 0,
        })
    }
}

impl Points for Grid {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    fn ranges(&self) -> Vec<Vary> {
        self.axes.iter().map(|axis| axis.over).collect()
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
            // number of consecutive rows in which an axis has the same value
            let mut stride = self.rows;
            values.extend(self.axes.iter().map(|axis| {
                stride /= axis.count;
                axis.value(row / stride % axis.count)
            }));
        }
        self.next += rows;
        Ok(rows as usize)
    }

    fn identity(&self) -> String {
        let axis = |axis: &GridAxis| {
            format!(
                "{}={:?}..{:?}:{}",
                axis.over.parameter.name, axis.over.low, axis.over.high, axis.count
            )
        };
        self.axes.iter().map(axis).collect::<Vec<_>>().join(" ")
    }
}
