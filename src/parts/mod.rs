//! A sweep divided into parts, for many processes or machines. Each part is a Parquet file, whose
//! content depends only on the definition of the sweep and the number of the part.
//!
//! ```text
//!   rows of a sweep, in blocks of 1024:  |  part 1  |  part 2  |  …  |  part M  |
//!
//!   write(K)  ──▶  part-0000K.parquet  ──footer──▶  definition, rows, status counts, moments,
//!                                                   histograms, best rows
//!   check     ──▶  missing parts; the merged summary, without reading the rows
//! ```
//!
//! The bytes of a part depend neither on the number of threads nor on the order in which the parts
//! are written; a repetition gives the same bytes. A file is renamed to its final name when it is
//! complete.
//!
//! ```
//! use longdrive::batch::{GridAxis, Batch, Grid, Run};
//! use longdrive::parts::{Dataset, PartResult, check};
//! use longdrive::{Outcome, Setup};
//!
//! let setup = Setup::modern_driver();
//! let axis = GridAxis::read(&setup, "club.loft=5deg..15deg:3000").unwrap();
//! let mut points = Grid::new(vec![axis]).unwrap();
//! let batch = Batch::new(&setup, &[axis.over.parameter], &[Outcome::BallSpeed], &[]).unwrap();
//! let dataset = Dataset::new(batch, &points, 2, vec![], vec![]).unwrap();
//! let folder = tempfile::tempdir().unwrap();
//!
//! // the second part first: the 3000 rows are three blocks, and it has two of them
//! let run = Run::default();
//! let mut write =
//!     |part| dataset.write(&mut points, part, folder.path(), &run, false, |_| ()).unwrap();
//! let PartResult::New(second) = write(2) else { panic!() };
//! assert_eq!(second.file, "part-00002.parquet");
//! assert_eq!((second.part.first_row, second.part.rows), (1024, 1976));
//! assert_eq!(check(folder.path(), None, false).unwrap().missing, [1]);
//! write(1);
//! let whole = check(folder.path(), None, false).unwrap();
//! assert!(whole.is_complete());
//! assert_eq!(whole.summary.moments["ball_speed"].count, 3000);
//! ```

mod check;
mod footer;
mod share;
mod write;

pub use check::{Checked, Fault, FaultKind, check, merge};
pub use footer::{Manifest, Part};

pub use share::{file_name, rows_of};
pub use write::{Dataset, PartResult};
