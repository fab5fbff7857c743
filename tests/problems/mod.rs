//! Published test problems of nonlinear programming, each written once over the number.

mod case;
pub mod hock_schittkowski;

pub use case::Case;
