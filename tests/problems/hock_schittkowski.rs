//! Hock, W. & Schittkowski, K. (1981), Test Examples for Nonlinear Programming Codes, Lecture Notes in Economics and
//! Mathematical Systems 187, Springer. Inequalities stand as they are printed, g(x) ≥ 0; signs and letters are ours.

use crate::problems;
use std::f64::consts::PI;

const INF: f64 = f64::INFINITY;

problems! {
    /// No. 71.
    HS71 {
        start: [1.0, 5.0, 5.0, 1.0], low: [1.0; 4], high: [5.0; 4], least: [25.0, 40.0], most: [INF, 40.0],
        optimum: 17.0140173, at: [1.0, 4.7429994, 3.8211503, 1.3794082],
        |x| {
            let squares = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
            (x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2], vec![x[0] * x[1] * x[2] * x[3], squares])
        }
    }
}
