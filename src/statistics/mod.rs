//! Statistics of a sweep, computed together with its rows: status counts, moments of each column,
//! histograms, and the rows with the highest and lowest values.
//!
//! A [`Summary`] covers some rows. Summaries merge without access to the rows, so that many
//! processes can share a sweep. [`SummarySpec`] defines the contents.
//!
//! ```
//! use longdrive::batch::Batch;
//! use longdrive::statistics::{Ranking, SummarySpec};
//! use longdrive::{Outcome, Setup};
//!
//! let setup = Setup::modern_driver();
//! let speed = setup.variable("swing.speed").unwrap();
//! let batch = Batch::new(&setup, &[speed], &[Outcome::BallSpeed], &[]).unwrap();
//! let fastest = SummarySpec::new(&batch, vec![], vec![Ranking::read("ball_speed:1", true).unwrap()]).unwrap();
//! // two blocks of rows, and their merged summary
//! let mut summary = fastest.of(&batch.evaluate(0, vec![40.0, 50.0]));
//! summary.merge(&fastest.of(&batch.evaluate(2, vec![45.0])));
//! assert_eq!((summary.status_counts.total(), summary.best[0].rows[0].row), (3, 1));
//! // ball speed is in proportion to club speed
//! let ball_speed = &summary.moments["ball_speed"];
//! assert!((ball_speed.mean.unwrap() / ball_speed.greatest.unwrap() - 45.0 / 50.0).abs() < 1e-12);
//! ```

mod extent;
mod histogram;
mod median;
mod moments;
mod ranking;
mod summary;

pub use crate::json::JsonNumber;
pub(crate) use extent::{extent, largest_magnitude};
pub use histogram::Histogram;
pub(crate) use median::median;
pub use moments::Moments;
pub use ranking::{RankedRow, Ranking};
pub use summary::{Summary, SummarySpec};
