//! Batches of millions of drives: outcomes, and their exact derivatives, at every point of a grid,
//! a quasi-random sequence or a table of points ([`table`](crate::table)).
//!
//! ```text
//!   points ──chunks──▶ drives, side by side ──in order──▶ sink
//! ```
//!
//! Points are read in chunks of [`CHUNK`] rows. The number of chunks computed at a time is bounded,
//! so memory use is independent of the size of the batch. Results are delivered in the order of the
//! points, so the output is independent of the number of threads.
//!
//! ```
//! use longdrive::batch::{Batch, Grid, GridAxis, Points, Run};
//! use longdrive::{Outcome, Setup};
//!
//! let setup = Setup::modern_driver();
//! let axis = |text| GridAxis::read(&setup, text).unwrap();
//! let axes = vec![axis("club.loft=8deg..12deg:3"), axis("swing.speed=40..50 m/s:2")];
//! let mut grid = Grid::new(axes).unwrap();
//! let batch = Batch::new(&setup, grid.parameters(), &[Outcome::BallSpeed], &[]).unwrap();
//! let mut rows = vec![];
//! batch.run(&mut grid, &Run::default(), |block| block, |block| {
//!     rows.extend((0..block.rows()).map(|row| (block.point(row).to_vec(), block.outcome(row, 0))));
//!     Ok(())
//! })
//! .unwrap();
//! // the first axis is outermost, ends are included
//! assert_eq!((rows.len(), rows[1].0[0]), (6, 8.0_f64.to_radians()));
//! assert_eq!((rows[1].0[1], rows[5].0[0]), (50.0, 12.0_f64.to_radians()));
//! // ball speed is in proportion to club speed
//! assert!((rows[1].1.unwrap() / rows[0].1.unwrap() - 50.0 / 40.0).abs() < 1e-12);
//! ```

mod block;
mod definition;
mod evaluate;
mod grid;
mod in_order;
mod lane_batch;
mod points;
mod run;
mod sequence;
#[cfg(any(feature = "commands", feature = "parquet"))]
mod sweep_definition;

pub use block::{Block, Status, StatusCounts};
pub use definition::Batch;
pub use grid::{Grid, GridAxis};
pub(crate) use in_order::{HAS_THREADS, in_order, processors};
pub use points::Points;
pub(crate) use points::refuse_repeated;
pub use run::{CHUNK, Run};
pub use sequence::Sequence;
#[cfg(any(feature = "commands", feature = "parquet"))]
pub use sweep_definition::SweepDefinition;
