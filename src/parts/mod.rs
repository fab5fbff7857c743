//! A sweep divided into parts, for many processes or machines: each part is a Parquet file of its
//! own, whose content follows from the question and its number alone.
//!
//! ```text
//!   rows of a sweep, in blocks of 1024:  |  part 1  |  part 2  |  …  |  part M  |
//!
//!   write(K)  ──▶  part-0000K.parquet  ──footer──▶  question, rows, tally, moments, histograms, best rows
//!   check     ──▶  what is missing; all of that merged, without a look at the rows
//! ```
//!
//! Whoever computes a part, on however many threads, how often and in what order, gets the same
//! bytes. A file takes its place once it is whole, so a part is there or it is not.
//!
//! ```
//! use longdrive::batch::{Axis, Batch, Grid, Run};
//! use longdrive::parts::{Dataset, Written, check};
//! use longdrive::{Outcome, Setup};
//!
//! let setup = Setup::default();
//! let axis = Axis::read(&setup, "club.loft=5deg..15deg:3000").unwrap();
//! let mut points = Grid::new(vec![axis]).unwrap();
//! let batch = Batch::new(&setup, &[axis.over.parameter], &[Outcome::BallSpeed], &[]).unwrap();
//! let dataset = Dataset::new(batch, &points, 2, &[], &[]).unwrap();
//! let folder = tempfile::tempdir().unwrap();
//!
//! // the second part first: 3000 rows are three blocks, of which it has two
//! let mut write = |part| dataset.write(&mut points, part, folder.path(), &Run::default(), false, |_| ()).unwrap();
//! let Written::New(second) = write(2) else { panic!() };
//! assert_eq!((second.file.as_str(), second.part.first_row, second.part.rows), ("part-00002.parquet", 1024, 1976));
//! assert_eq!(check(folder.path(), None, false).unwrap().missing, [1]);
//! write(1);
//! let whole = check(folder.path(), None, false).unwrap();
//! assert!(whole.is_complete());
//! assert_eq!(whole.summary.moments["ball_speed"].count, 3000);
//! ```

mod check;
mod elementary;
mod footer;
mod hash;
mod question;
mod share;
mod write;

pub use check::{Checked, Fault, FaultKind, check, merge};
pub use footer::{Manifest, Part};
pub use question::Question;
pub use share::{file_name, most_parts, rows_of};
pub use write::{Dataset, Written};
