//! The longest golf drive, with exact derivatives.
//!
//! longdrive solves
//!
//! ```text
//!   maximize   carry(x)          x: loft λ, attack angle ε, or any other parameters, rad, m, kg, s
//!   subject to low ≤ x ≤ high    limits of club and golfer
//! ```
//!
//! where carry is the distance to the landing point of the ball. A rigid clubhead strikes the ball
//! ([`impact`]), and the ball flies through air with drag, lift and spin decay ([`flight`]). Impact
//! and flight are written once, generic over a [`Number`](number::Number): `f64` gives values, dual
//! numbers give exact gradients and Hessians ([`derivative`]). The optimizer ([`optimize`]) and
//! every study ([`study`]) use these derivatives. Without default features the library has
//! [`integration`] and the modules below it in the table; the features `studies` and `reports` add
//! the others.
//!
//! ```
//! use longdrive::{Outcome, Setup, derivative};
//!
//! let setup = Setup::preset("mae494").unwrap();
//! let wrt = setup.variables_named(["club.loft", "swing.attack_angle"]).unwrap();
//! let carry = derivative::gradient(&setup, Outcome::Carry, &wrt).unwrap();
//! assert!((carry.value - 114.312855130798).abs() < 1e-9); // m, at loft 10°, attack 0°
//! assert!((carry.gradient[0] - 336.769746388603).abs() < 1e-8); // m per radian of loft
//! ```
//!
//! Debug builds should optimize the library, by `[profile.dev.package.longdrive] opt-level = 1` in
//! the `Cargo.toml` of the program: without it, derivatives need more stack than a thread has.
//!
//! # Frame
//! X up, Y right of the target line, Z downrange; right-handed. SI units and radians inside;
//! degrees, mph and yards only in texts ([`units`]) and reports.
//!
//! # Modules
//! A module imports only from modules below it in this table, without cycles; docs/architecture.md
//! lists all modules.
//!
//! | | |
//! |---|---|
//! | the commands of the program (feature `commands`) | `command` |
//! | the parts of a sweep that is divided among processes and machines (feature `parquet`) | `parts` |
//! | results to bytes (feature `reports`) | [`report`] |
//! | published studies, computed anew (feature `reports`) | [`reproduce`] |
//! | studies of a drive; measured shots (feature `studies`) | [`study`], [`shots`] |
//! | tables of points; statistics of a sweep (feature `studies`) | [`table`], [`statistics`] |
//! | method and step of the integration for a tolerance | [`integration`] |
//! | batches of drives | [`batch`] |
//! | a constrained optimizer, independent of golf; derivatives by name | [`optimize`], [`derivative`] |
//! | setup → impact → flight → outcomes | [`drive`] |
//! | rigid bodies; equation of motion and landing | [`impact`], [`flight`] |
//! | bounces and rolling | [`ground`] |
//! | launch of the ball; laws of drag and lift; wind | [`launch`], [`aerodynamics`], [`atmosphere`] |
//! | every parameter, declared once | [`parameters`] |
//! | numbers, quantity strings, errors | [`number`], [`units`], [`error`] |

#![warn(clippy::missing_errors_doc, missing_docs)]
// without the feature `commands`, some items are unused
#![cfg_attr(not(feature = "commands"), allow(dead_code, unused_imports))]

#[macro_use]
mod variant_names;

pub mod aerodynamics;
pub mod atmosphere;
mod atomic_file;
pub mod batch;
#[cfg(feature = "commands")]
pub mod command;
mod csv_dialect;
pub mod derivative;
pub mod drive;
pub mod error;
mod external_errors;
pub mod features;
mod fingerprint;
pub mod flight;
pub mod ground;
pub mod impact;
mod input_file;
pub mod integration;
mod json;
pub mod launch;
mod lock;
pub mod number;
pub mod optimize;
pub mod parameters;
#[cfg(feature = "parquet")]
pub mod parts;
mod repeated;
#[cfg(feature = "reports")]
pub mod report;
#[cfg(feature = "reports")]
pub mod reproduce;
#[cfg(feature = "studies")]
pub mod shots;
#[cfg(feature = "studies")]
pub mod statistics;
#[cfg(feature = "studies")]
pub mod study;
#[cfg(feature = "studies")]
pub mod table;
mod thread_stack;
pub mod units;

pub use drive::{Drive, Outcome};
pub use error::{Error, Result};
pub use parameters::Setup;

/// Runs the examples of README, docs/library.md and docs/plots.md as doctests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
#[doc = include_str!("../docs/library.md")]
#[doc = include_str!("../docs/plots.md")]
struct ExamplesOfDocs;
