//! A bound-constrained minimiser for smooth functions with exact Hessians. It knows no golf.
//!
//! ```text
//!   minimise f(x)  subject to  low ≤ x ≤ high
//! ```
//!
//! by sequential quadratic programming: at each iterate the quadratic model of f is minimised over the bounds
//! and a box-shaped trust region ([`qp`], solved by Clarabel and polished so that active bounds are exact),
//! the step is kept if f falls as the model promises, and the search ends where the projected gradient
//! vanishes ([`status`]). The loop ([`sqp`]) is an argmin `Solver`, run by argmin's `Executor`.
//!
//! ```
//! use longdrive::optimize::{Bounds, Evaluation, Options, Status, minimize};
//!
//! // f = (x − 3)² + (x − y)² on [0, 2]²: x ends on its bound 2 with multiplier 2 (3 − 2), and y = x
//! let f = |x: &[f64]| -> Result<Evaluation, String> {
//!     let (a, b) = (x[0] - 3.0, x[0] - x[1]);
//!     Ok(Evaluation {
//!         value: a * a + b * b,
//!         gradient: vec![2.0 * a + 2.0 * b, -2.0 * b],
//!         hessian: vec![vec![4.0, -2.0], vec![-2.0, 2.0]],
//!     })
//! };
//! let bounds = Bounds::new(vec![0.0, 0.0], vec![2.0, 2.0]).unwrap();
//! let optimum = minimize(f, &bounds, &[0.5, 1.0], &Options::default()).unwrap();
//! assert_eq!(optimum.status, Status::Converged);
//! assert_eq!(optimum.x[0], 2.0);
//! assert!((optimum.x[1] - 2.0).abs() < 1e-12 && (optimum.upper_multipliers[0] - 2.0).abs() < 1e-9);
//! ```

mod convex;
mod frame;
mod kink;
mod model;
mod problem;
pub mod qp;
mod sides;
mod solution;
pub mod sqp;
mod start;
pub mod status;

pub use kink::Kink;
pub use problem::{Bounds, Evaluation, Options, Problem};
pub use solution::{Iteration, Solution, minimize, minimize_watched};
pub use status::Status;
