//! The solvers, one file each.

mod basin_lbfgsb;
mod basin_slsqp;
mod longdrive;
mod ripopt;
mod slsqp;

use crate::oracle::Oracle;
use crate::problems::Case;

/// Tolerance of gradients, KKT residuals and steps, for every solver with such an option.
pub const TOLERANCE: f64 = 1e-10;
/// Tolerance for the decrease of f, for solvers that stop at a small decrease. It is smaller,
/// because near a minimum f − f* is proportional to the square of the error of x.
pub const DECREASE_TOLERANCE: f64 = 1e-14;
pub const ITERATIONS: u64 = 1000;

/// Last point of a solver.
pub struct End {
    pub x: Vec<f64>,
    pub status: String,
    pub iterations: Option<u64>,
}

pub struct Peer {
    pub name: &'static str,
    pub is_for_bounds_only: bool,
    pub solve: fn(&Oracle) -> Result<End, String>,
}

impl Peer {
    pub fn takes(&self, case: &Case) -> bool {
        !self.is_for_bounds_only || case.least.is_empty()
    }
}

pub const PEERS: [Peer; 5] = [
    Peer {
        name: "longdrive",
        is_for_bounds_only: false,
        solve: longdrive::solve,
    },
    Peer {
        name: "basin SLSQP",
        is_for_bounds_only: false,
        solve: basin_slsqp::solve,
    },
    Peer {
        name: "basin L-BFGS-B",
        is_for_bounds_only: true,
        solve: basin_lbfgsb::solve,
    },
    Peer {
        name: "slsqp",
        is_for_bounds_only: false,
        solve: slsqp::solve,
    },
    Peer {
        name: "ripopt",
        is_for_bounds_only: false,
        solve: ripopt::solve,
    },
];
