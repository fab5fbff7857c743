//! Method and step of the integration for a tolerance on lengths.

mod accuracy;
mod choice;

pub use accuracy::{Accuracy, accuracy};
pub use choice::{Integration, StepChoice};
#[cfg(feature = "studies")]
pub(crate) use choice::{neighbourhood, of_the_flight};
