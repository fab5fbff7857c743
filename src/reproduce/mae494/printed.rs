//! Values printed in the MAE 494 report, in its units. Only printed values are stored: a
//! reproduction computes its own results.

use crate::reproduce::delivery::Ranges;

/// Table 1: swing elevation, deg; optimal loft, deg; distance, m.
pub const TABLE_1: [[f64; 3]; 13] = [
    [-10.0, 11.5713, 131.08],
    [-5.0, 4.3575, 134.47],
    [-4.0, 4.4011, 135.41],
    [-3.0, 4.4368, 137.47],
    [-2.0, 4.4644, 140.24],
    [-1.0, 4.4824, 143.33],
    [0.0, 4.4946, 147.09],
    [1.0, 19.2683, 246.05],
    [2.0, 18.605, 246.44],
    [3.0, 18.02, 246.96],
    [4.0, 17.6815, 248.48],
    [5.0, 9.4692, 200.83],
    [10.0, 4.4166, 187.59],
];

/// Table 2: loft, deg; optimal swing elevation, deg; distance, m.
pub const TABLE_2: [[f64; 3]; 9] = [
    [5.0, 7.5236, 182.3],
    [7.0, 7.4428, 194.68],
    [8.0, 7.4111, 201.31],
    [9.0, 7.3827, 207.7],
    [10.0, 7.3428, 213.93],
    [11.0, 7.3060, 220.20],
    [12.0, 7.2875, 226.2],
    [13.0, 7.2593, 232.24],
    [15.0, 7.2053, 243.43],
];

/// The recommended optimum: loft, deg, from Table 1; swing elevation, deg, from Table 2; distance,
/// m, the longest of Table 1.
pub const OPTIMUM: [f64; 3] = [17.68, 7.3, 248.48];

/// Search ranges of loft and swing elevation, deg. Table 1 has this range of swing elevation.
pub const RANGES: Ranges = Ranges {
    loft: [0.0, 20.0],
    attack_angle: [-10.0, 10.0],
};

/// Data of the regression in the listing, at swing elevation 10°: loft, deg, and distance, m.
pub const REGRESSION: [[f64; 2]; 5] = [
    [0.0, 9.7],
    [5.0, 191.2],
    [10.0, 222.5],
    [15.0, 249.0],
    [20.0, 98.3],
];

/// The swing elevation of [`REGRESSION`], deg.
pub const REGRESSION_ATTACK: f64 = 10.0;

/// Lofts of the third study, deg.
pub const AVERAGED_LOFTS: [f64; 11] = [
    8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0,
];

/// The printed loft of the longest mean carry, deg.
pub const AVERAGE_LOFT: f64 = 16.0;
