//! Minimization of smooth functions with exact Hessians, within bounds and nonlinear constraints.
//! The module contains nothing about golf.
//!
//! ```text
//!   minimize f(x)  subject to  low ≤ x ≤ high  and  least ≤ c(x) ≤ most
//! ```
//!
//! by sequential quadratic programming (SQP) with a trust region. Each iteration minimizes the
//! quadratic model of the Lagrangian within the bounds, the linearized constraints and a box-shaped
//! trust region (`qp`). The step is accepted if the merit function falls by a sufficient fraction
//! of the predicted reduction. The search ends where the KKT conditions hold ([`status`]). The SQP
//! loop (`sqp`) is an argmin `Solver`, run by argmin's `Executor`.
//!
//! A problem is any implementation of [`Problem`] with gradients and, optionally, Hessians. For
//! [`Functions`] written over a generic number type, [`Exact`] computes exact derivatives.
//!
//! ```
//! use longdrive::number::Number;
//! use longdrive::optimize::{Domain, Evaluation, Exact, Functions, Options, Status, minimize};
//!
//! /// f = (x − 3)² + (x − y)²
//! struct Valley;
//!
//! impl Functions for Valley {
//!     fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
//!         let objective = (x[0] - 3.0).powi(2) + (x[0] - x[1]).powi(2);
//!         Ok(Evaluation::unconstrained(objective))
//!     }
//! }
//!
//! // on [0, 2]²: x ends on its bound 2 with multiplier 2 (3 − 2), and y = x
//! let domain = Domain::new(vec![0.0, 0.0], vec![2.0, 2.0]).unwrap();
//! let optimum = minimize(&Exact(Valley), &domain, &[0.5, 1.0], &Options::default()).unwrap();
//! assert_eq!(optimum.status, Status::Converged);
//! assert_eq!(optimum.x[0], 2.0);
//! assert!((optimum.x[1] - 2.0).abs() < 1e-12 && (optimum.upper_multipliers[0] - 2.0).abs() < 1e-9);
//! ```

mod bundle;
mod checkpoint;
pub(crate) mod continuation;
mod convex;
mod domain;
pub mod front;
mod functions;
mod iteration;
mod kink;
pub mod least_squares;
mod minimize;
mod model;
mod multistart;
mod null_space;
mod observer;
mod options;
mod problem;
mod qp;
mod quadratic_model;
mod quasi_newton;
mod redundant;
mod restoration;
mod saddle;
mod scaling;
pub mod sensitivity;
pub(crate) mod sobol;
mod solution;
mod sqp;
mod start;
mod state;
pub mod status;
mod termination;
mod trial_step;

pub use crate::number::Taylor;
pub use checkpoint::{Checkpoint, SavedSearch};
pub use domain::{Bounds, Domain};
pub use functions::{Exact, Functions, Gradients};
pub use iteration::Iteration;
pub use kink::Kink;
pub use minimize::{minimize, minimize_observed};
pub use multistart::{Callback, LocalMinimum, Observers, minimize_from, starts};
pub use observer::{Observer, SaveSnapshot, Snapshot};
pub use options::Options;
pub use problem::{Evaluation, Problem};
pub use quadratic_model::QuadraticModel;
pub use scaling::KktResidual;
pub use solution::{ConstraintValue, Solution};
pub use state::Effort;
pub use status::Status;
