//! Shots of launch monitors: read from exports or GSPro Open Connect, flown with a setup's ball and
//! air, and compared with their measurements.
//!
//! ```text
//!   file ──records──▶ shots ──in batches──▶ flown shots ──in order──▶ sink
//! ```
//!
//! Rows are processed in chunks, in the order of the file, so that memory does not grow with the
//! number of rows. No row is dropped: a row that cannot be flown has a [`Refusal`].
//!
//! ```
//! use longdrive::shots::{Flying, Shots};
//! use longdrive::{Outcome, Setup};
//!
//! let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yds]\n\
//!             167,10.9,2686,275\n,11,2500,\n";
//! let setup = Setup::modern_driver();
//! let mut shots = Shots::read(&setup, "shots.csv", text.as_bytes()).unwrap();
//! let flying = Flying::new(&setup, &[], &[Outcome::CarryDistance]).unwrap();
//! let (mut carries, mut refused) = (vec![], vec![]);
//! let statistics = flying
//!     .fly(&mut shots, &Default::default(), |flown| flown, |flown| {
//!         carries.extend((0..flown.shots.len()).map(|row| flown.predicted(row, 0)));
//!         for shot in &flown.shots {
//!             refused.extend(shot.refusal().map(|refusal| (shot.line, refusal.reason.clone())));
//!         }
//!         Ok(())
//!     })
//!     .unwrap();
//! assert!((carries[0].unwrap() / 0.9144 - 275.0).abs() < 8.0 && carries[1].is_none());
//! let reason = "Ball Speed: the cell is empty; every launch needs this value";
//! assert_eq!(refused, [(3, reason.to_owned())]);
//! assert_eq!((statistics.rows, statistics.flown), (2, 1));
//! ```

mod columns;
mod export;
mod flown;
mod fly;
mod objects;
mod open_connect;
mod shot;
mod source;
mod statistics;

mod unit_checks;
mod written;

pub use crate::table::Refusal;
pub use columns::ShotColumns;
pub use flown::Flown;
pub use fly::Flying;
pub use objects::Objects;
pub(crate) use open_connect::ASSUMED;
pub use shot::{Club, Origin, Shot, StatedValue};
pub(crate) use source::is_json;
pub use source::{Section, Shots};
pub use statistics::{BANDS, Band, ClubShots, Refused, ShotStatistics, Sums, instrument_deviation};
