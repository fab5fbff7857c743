//! Problems of many variables, where each function depends on few of them.
//!
//! A [`SparseProblem`] gives each function with the derivatives that are not 0; [`Terms`] written once over the number make one whose
//! derivatives are exact by themselves. [`minimize_sparse`](super::minimize_sparse) runs the same search as
//! [`minimize`](super::minimize()): the same merit, tests and statuses. What differs is the algebra, in which no matrix is ever dense: the
//! quadratic program of a step is solved by a primal-dual active-set method over sparse LDLᵀ factors, or by Clarabel.

mod convex;
mod curvature;
mod interior_point;
mod kkt;
mod model;
mod multipliers;
mod polish;
mod problem;
mod program;
mod solve;
mod symmetric;
mod terms;

pub(super) use curvature::{of_lagrangian, of_violation};
pub(super) use model::SparseModel;
pub(super) use multipliers::first_multipliers;
pub use problem::{SparseEvaluation, SparseProblem, SparseTaylor};
pub use terms::{Function, Term, Terms};
