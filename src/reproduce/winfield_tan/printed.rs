//! Values printed by Winfield & Tan (1994), in their units, with misprints corrected. Only printed
//! values are stored: a reproduction computes its own results.

/// Single shot: carry, yd; flight time, s; apex, yd; time of apex, s.
pub const SHOT: [f64; 4] = [197.31, 4.75, 14.18, 2.48];
/// Impact of the single shot: ball speed upwards and downrange, mph; backspin, rev/s; club speed
/// downrange after impact, mph; launch angle, deg.
pub const IMPACT: [f64; 5] = [19.84, 139.16, 38.57, 71.39, 8.29];
/// Delivery of the single shot: speed, mph; loft, deg; attack angle, deg.
pub const SHOT_DELIVERY: [f64; 3] = [103.0, 10.0, 0.0];
/// Optimum: loft, deg; attack angle, deg; carry, yd.
pub const OPTIMUM: [f64; 3] = [2.74, 27.44, 250.09];
/// Table 1: loft, deg; best attack angle, deg; carry, yd.
pub const TABLE_1: [[f64; 3]; 9] = [
    [5.0, 22.09, 248.48],
    [7.0, 17.53, 245.11],
    [8.0, 15.47, 242.74],
    [9.0, 13.54, 239.93],
    [10.0, 11.71, 236.68],
    [11.0, 9.96, 233.04],
    [12.0, 8.29, 229.04],
    [13.0, 6.68, 224.75],
    [15.0, 3.68, 215.74],
];
/// Table 2: attack angle, deg; best loft, deg; carry, yd.
pub const TABLE_2: [[f64; 3]; 13] = [
    [-10.0, 17.14, 188.93],
    [-5.0, 14.51, 206.08],
    [-4.0, 14.03, 209.02],
    [-3.0, 13.55, 211.84],
    [-2.0, 13.11, 214.52],
    [-1.0, 12.64, 217.09],
    [0.0, 12.21, 219.55],
    [1.0, 11.79, 221.92],
    [2.0, 11.38, 224.17],
    [3.0, 10.99, 226.33],
    [4.0, 10.60, 228.38],
    [5.0, 10.22, 230.32],
    [10.0, 8.39, 238.55],
];
/// The loft with the best mean carry over attack angles of 0–10°, deg, and this mean carry, yd.
pub const AVERAGE: [f64; 2] = [10.68, 228.01];
/// Lofts for which the paper computes a mean carry, deg.
pub const AVERAGED_LOFTS: [f64; 6] = [7.0, 8.0, 9.0, 10.0, 11.0, 12.0];
/// Robot "Iron Byron" with the delivery of the single shot: mean and standard deviation of twenty
/// distances, yd.
pub const ROBOT: [f64; 2] = [200.3, 3.61];
/// Corrected misprints: table, row (by its first number), number as scanned, and number used.
pub const MISPRINTS: [(u8, f64, f64, f64); 3] = [
    (1, 8.0, 242.14, 242.74),
    (1, 13.0, 224.15, 224.75),
    (2, -3.0, 13.65, 13.55),
];
