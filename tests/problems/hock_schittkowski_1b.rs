//! Hock, W. & Schittkowski, K. (1981), Test Examples for Nonlinear Programming Codes, Lecture Notes
//! in Economics and Mathematical Systems 187, Springer; Nos. 41–62. An inequality has the book's
//! form g(x) ≥ 0, or the constant of g is its limit. The book has other names of the variables.
//! There is no No. 58.

use super::hock_schittkowski_2::{dot, sum};
use longdrive::number::Number;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, SQRT_2};

const INF: f64 = f64::INFINITY;

/// The objective of Nos. 51–53; `factor` is the factor of x₁.
fn least_squares<T: Number>(factor: f64, x: &[T]) -> T {
    (x[0] * factor - x[1]).powi(2)
        + (x[1] + x[2] - 2.0).powi(2)
        + (x[3] - 1.0).powi(2)
        + (x[4] - 1.0).powi(2)
}

fn three_equations<T: Number>(x: &[T]) -> Vec<T> {
    vec![x[0] + x[1] * 3.0, x[2] + x[3] - x[4] * 2.0, x[1] - x[4]]
}

/// Coordinates of No. 56. Start: arcsin √(1/4.2) and arcsin √(5/7.2). Solution: arcsin √(4/7) and
/// arcsin √(2/7).
const START_A: f64 = 0.509739678831507;
const START_B: f64 = 0.9851107833377457;
const AT_C: f64 = 0.8570719478501309;
const AT_D: f64 = 0.5639426413606289;

/// No. 57: pairs of ages and measurements.
const DECAY: [(f64, f64); 44] = [
    (8.0, 0.49),
    (8.0, 0.49),
    (10.0, 0.48),
    (10.0, 0.47),
    (10.0, 0.48),
    (10.0, 0.47),
    (12.0, 0.46),
    (12.0, 0.46),
    (12.0, 0.45),
    (12.0, 0.43),
    (14.0, 0.45),
    (14.0, 0.43),
    (14.0, 0.43),
    (16.0, 0.44),
    (16.0, 0.43),
    (16.0, 0.43),
    (18.0, 0.46),
    (18.0, 0.45),
    (20.0, 0.42),
    (20.0, 0.42),
    (20.0, 0.43),
    (22.0, 0.41),
    (22.0, 0.41),
    (22.0, 0.40),
    (24.0, 0.42),
    (24.0, 0.40),
    (24.0, 0.40),
    (26.0, 0.41),
    (26.0, 0.40),
    (26.0, 0.41),
    (28.0, 0.41),
    (28.0, 0.40),
    (30.0, 0.40),
    (30.0, 0.40),
    (30.0, 0.38),
    (32.0, 0.41),
    (32.0, 0.40),
    (34.0, 0.40),
    (36.0, 0.41),
    (36.0, 0.38),
    (38.0, 0.40),
    (38.0, 0.40),
    (40.0, 0.39),
    (42.0, 0.39),
];

problems! {
    HS41 {
        start: [2.0; 4], low: [0.0; 4], high: [1.0, 1.0, 1.0, 2.0], least: [0.0], most: [0.0],
        optimum: 52.0 / 27.0, at: [2.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 2.0],
        |x| (-x[0] * x[1] * x[2] + 2.0, vec![dot(&[1.0, 2.0, 2.0, -1.0], x)])
    }
    HS42 {
        start: [1.0; 4], low: [-INF; 4], high: [INF; 4], least: [2.0, 2.0], most: [2.0, 2.0],
        optimum: 28.0 - 10.0 * SQRT_2, at: [2.0, 2.0, 0.6 * SQRT_2, 0.8 * SQRT_2],
        |x| {
            let f = (x[0] - 1.0).powi(2) + (x[1] - 2.0).powi(2) + (x[2] - 3.0).powi(2) + (x[3] - 4.0).powi(2);
            (f, vec![x[0], x[2] * x[2] + x[3] * x[3]])
        }
    }
    HS43 {
        start: [0.0; 4], low: [-INF; 4], high: [INF; 4], least: [0.0; 3], most: [INF; 3],
        optimum: -44.0, at: [0.0, 1.0, 2.0, -1.0],
        |x| {
            let squares: Vec<T> = x.iter().map(|&x| x * x).collect();
            let g = vec![
                -dot(&[1.0, 1.0, 1.0, 1.0], &squares) - dot(&[1.0, -1.0, 1.0, -1.0], x) + 8.0,
                -dot(&[1.0, 2.0, 1.0, 2.0], &squares) + dot(&[1.0, 0.0, 0.0, 1.0], x) + 10.0,
                -dot(&[2.0, 1.0, 1.0, 0.0], &squares) - dot(&[2.0, -1.0, 0.0, -1.0], x) + 5.0,
            ];
            (dot(&[1.0, 1.0, 2.0, 1.0], &squares) - dot(&[5.0, 5.0, 21.0, -7.0], x), g)
        }
    }
    HS44 {
        start: [0.0; 4], low: [0.0; 4], high: [INF; 4], least: [0.0; 6], most: [INF; 6],
        optimum: -15.0, at: [0.0, 3.0, 0.0, 4.0],
        |x| {
            let f = x[0] - x[1] - x[2] - x[0] * x[2] + x[0] * x[3] + x[1] * x[2] - x[1] * x[3];
            let g = vec![
                -x[0] - x[1] * 2.0 + 8.0,
                x[0] * -4.0 - x[1] + 12.0,
                x[0] * -3.0 - x[1] * 4.0 + 12.0,
                x[2] * -2.0 - x[3] + 8.0,
                -x[2] - x[3] * 2.0 + 8.0,
                -x[2] - x[3] + 5.0,
            ];
            (f, g)
        }
    }
    HS45 {
        start: [2.0; 5], low: [0.0; 5], high: [1.0, 2.0, 3.0, 4.0, 5.0], least: [], most: [],
        optimum: 1.0, at: [1.0, 2.0, 3.0, 4.0, 5.0],
        |x| (-x[0] * x[1] * x[2] * x[3] * x[4] / 120.0 + 2.0, vec![])
    }
    HS46 {
        start: [FRAC_1_SQRT_2, 1.75, 0.5, 2.0, 2.0], low: [-INF; 5], high: [INF; 5],
        least: [1.0, 2.0], most: [1.0, 2.0],
        optimum: 0.0, at: [1.0; 5],
        |x| {
            let f = (x[0] - x[1]).powi(2) + (x[2] - 1.0).powi(2) + (x[3] - 1.0).powi(4) + (x[4] - 1.0).powi(6);
            (f, vec![x[0] * x[0] * x[3] + (x[3] - x[4]).sin(), x[1] + x[2].powi(4) * x[3] * x[3]])
        }
    }
    HS47 {
        start: [2.0, SQRT_2, -1.0, 2.0 - SQRT_2, 0.5], low: [-INF; 5], high: [INF; 5],
        least: [3.0, 1.0, 1.0], most: [3.0, 1.0, 1.0],
        optimum: 0.0, at: [1.0; 5],
        |x| {
            let f = (x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(3) + (x[2] - x[3]).powi(4) + (x[3] - x[4]).powi(4);
            (f, vec![x[0] + x[1] * x[1] + x[2].powi(3), x[1] - x[2] * x[2] + x[3], x[0] * x[4]])
        }
    }
    HS48 {
        start: [3.0, 5.0, -3.0, 2.0, -2.0], low: [-INF; 5], high: [INF; 5], least: [5.0, -3.0], most: [5.0, -3.0],
        optimum: 0.0, at: [1.0; 5],
        |x| {
            let f = (x[0] - 1.0).powi(2) + (x[1] - x[2]).powi(2) + (x[3] - x[4]).powi(2);
            (f, vec![sum(x.iter().copied()), x[2] - (x[3] + x[4]) * 2.0])
        }
    }
    HS49 {
        start: [10.0, 7.0, 2.0, -3.0, 0.8], low: [-INF; 5], high: [INF; 5], least: [7.0, 6.0], most: [7.0, 6.0],
        optimum: 0.0, at: [1.0; 5],
        |x| {
            let f = (x[0] - x[1]).powi(2) + (x[2] - 1.0).powi(2) + (x[3] - 1.0).powi(4) + (x[4] - 1.0).powi(6);
            (f, vec![x[0] + x[1] + x[2] + x[3] * 4.0, x[2] + x[4] * 5.0])
        }
    }
    HS50 {
        start: [35.0, -31.0, 11.0, 5.0, -5.0], low: [-INF; 5], high: [INF; 5], least: [6.0; 3], most: [6.0; 3],
        optimum: 0.0, at: [1.0; 5],
        |x| {
            let f = (x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(2) + (x[2] - x[3]).powi(4) + (x[3] - x[4]).powi(2);
            let row = |i: usize| dot(&[1.0, 2.0, 3.0], &x[i..i + 3]);
            (f, vec![row(0), row(1), row(2)])
        }
    }
    HS51 {
        start: [2.5, 0.5, 2.0, -1.0, 0.5], low: [-INF; 5], high: [INF; 5],
        least: [4.0, 0.0, 0.0], most: [4.0, 0.0, 0.0],
        optimum: 0.0, at: [1.0; 5],
        |x| (least_squares(1.0, x), three_equations(x))
    }
    HS52 {
        start: [2.0; 5], low: [-INF; 5], high: [INF; 5], least: [0.0; 3], most: [0.0; 3],
        optimum: 1859.0 / 349.0,
        at: [-33.0 / 349.0, 11.0 / 349.0, 180.0 / 349.0, -158.0 / 349.0, 11.0 / 349.0],
        |x| (least_squares(4.0, x), three_equations(x))
    }
    HS53 {
        start: [2.0; 5], low: [-10.0; 5], high: [10.0; 5], least: [0.0; 3], most: [0.0; 3],
        optimum: 176.0 / 43.0, at: [-33.0 / 43.0, 11.0 / 43.0, 27.0 / 43.0, -5.0 / 43.0, 11.0 / 43.0],
        |x| (least_squares(1.0, x), three_equations(x))
    }
    HS54 {
        start: [6e3, 1.5, 4e6, 2.0, 3e-3, 5e7], low: [0.0, -10.0, 0.0, 0.0, -1.0, 0.0],
        high: [2e4, 10.0, 1e7, 20.0, 1.0, 2e8], least: [1.76e4], most: [1.76e4],
        optimum: -0.908074754547, at: [91600.0 / 7.0, 79.0 / 70.0, 2e6, 10.0, 1e-3, 1e8],
        |x| {
            let (a, b) = (x[0] - 1e4, x[1] - 1.0);
            let h = (a * a / 6.4e7 + a * b / 2e4 + b * b) / 0.96
                + (x[2] - 2e6).powi(2) / 4.9e13
                + (x[3] - 10.0).powi(2) / 2.5e3
                + (x[4] - 1e-3).powi(2) / 2.5e-3
                + (x[5] - 1e8).powi(2) / 2.5e17;
            (-(h * -0.5).exp(), vec![x[0] + x[1] * 4e3])
        }
    }
    HS55 {
        start: [1.0, 2.0, 0.0, 0.0, 0.0, 2.0], low: [0.0; 6], high: [1.0, INF, INF, 1.0, INF, INF],
        least: [6.0, 3.0, 2.0, 1.0, 2.0, 2.0], most: [6.0, 3.0, 2.0, 1.0, 2.0, 2.0],
        optimum: 19.0 / 3.0, at: [0.0, 4.0 / 3.0, 5.0 / 3.0, 1.0, 2.0 / 3.0, 1.0 / 3.0],
        |x| {
            let g = vec![
                x[0] + x[1] * 2.0 + x[4] * 5.0,
                x[0] + x[1] + x[2],
                x[3] + x[4] + x[5],
                x[0] + x[3],
                x[1] + x[4],
                x[2] + x[5],
            ];
            (x[0] + x[1] * 2.0 + x[4] * 4.0 + (x[0] * x[3]).exp(), g)
        }
    }
    HS56 {
        start: [1.0, 1.0, 1.0, START_A, START_A, START_A, START_B], low: [-INF; 7], high: [INF; 7],
        least: [0.0; 4], most: [0.0; 4],
        optimum: -3.456, at: [2.4, 1.2, 1.2, AT_C, AT_D, AT_D, FRAC_PI_2],
        |x| {
            let g = vec![
                x[0] - x[3].sin().powi(2) * 4.2,
                x[1] - x[4].sin().powi(2) * 4.2,
                x[2] - x[5].sin().powi(2) * 4.2,
                x[0] + x[1] * 2.0 + x[2] * 2.0 - x[6].sin().powi(2) * 7.2,
            ];
            (-x[0] * x[1] * x[2], g)
        }
    }
    HS57 {
        start: [0.42, 5.0], low: [0.4, -4.0], high: [INF; 2], least: [0.0], most: [INF],
        optimum: 0.0284596697213, at: [0.419952674511, 1.28484562930],
        |x| {
            let f = sum(DECAY.iter().map(|&(a, b)| {
                let fit = x[0] + (-x[0] + 0.49) * (x[1] * (8.0 - a)).exp();
                (-fit + b).powi(2)
            }));
            (f, vec![x[1] * 0.49 - x[0] * x[1] - 0.09])
        }
    }
    HS59 {
        start: [90.0, 10.0], low: [0.0; 2], high: [75.0, 65.0], least: [0.0; 3], most: [INF; 3],
        optimum: -7.80422632408, at: [13.5501042366, 51.6601812877],
        |x| {
            let (a, b) = (x[0], x[1]);
            let f = a * 3.8112 - a.powi(2) * 0.12694 + a.powi(3) * 2.0567e-3 - a.powi(4) * 1.0345e-5 + b * 6.8306
                - b.powi(2) * 0.25645
                + b.powi(3) * 3.4604e-3
                - b.powi(4) * 1.3514e-5
                - a * b * 0.030234
                + a.powi(2) * b * 1.28134e-3
                - a.powi(3) * b * 3.5256e-5
                + a.powi(4) * b * 2.266e-7
                - a * b.powi(2) * 3.4054e-4
                + a.powi(2) * b.powi(2) * 5.2375e-6
                + a.powi(3) * b.powi(2) * 6.3e-8
                - a.powi(3) * b.powi(3) * 7e-10
                + a * b.powi(3) * 1.6638e-6
                + (a * b * 5e-4).exp() * 2.8673
                + (b + 1.0).recip() * 28.106
                - 75.196;
            let g = vec![a * b - 700.0, b - a * a / 125.0, (b - 50.0).powi(2) - (a - 55.0) * 5.0];
            (f, g)
        }
    }
    HS60 {
        start: [2.0; 3], low: [-10.0; 3], high: [10.0; 3], least: [4.0 + 3.0 * SQRT_2], most: [4.0 + 3.0 * SQRT_2],
        optimum: 0.0325682002513, at: [1.10485902423, 1.19667419413, 1.53526225739],
        |x| {
            let f = (x[0] - 1.0).powi(2) + (x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(4);
            (f, vec![x[0] * (x[1] * x[1] + 1.0) + x[2].powi(4)])
        }
    }
    HS61 {
        start: [0.0; 3], low: [-INF; 3], high: [INF; 3], least: [7.0, 11.0], most: [7.0, 11.0],
        optimum: -143.646142201, at: [5.32677015744, -2.11899863998, 3.21046423906],
        |x| {
            let f = x[0] * x[0] * 4.0 + x[1] * x[1] * 2.0 + x[2] * x[2] * 2.0 - dot(&[33.0, -16.0, 24.0], x);
            (f, vec![x[0] * 3.0 - x[1] * x[1] * 2.0, x[0] * 4.0 - x[2] * x[2]])
        }
    }
    HS62 {
        start: [0.7, 0.2, 0.1], low: [0.0; 3], high: [1.0; 3], least: [1.0], most: [1.0],
        optimum: -26272.5144873, at: [0.617813298210, 0.328202155786, 0.0539845460119],
        |x| {
            let rest = [x[0] + x[1] + x[2] + 0.03, x[1] + x[2] + 0.03, x[2] + 0.03];
            let f = (rest[0] / (x[0] * 0.09 + rest[1])).ln() * 255.0
                + (rest[1] / (x[1] * 0.07 + rest[2])).ln() * 280.0
                + (rest[2] / (x[2] * 0.13 + 0.03)).ln() * 290.0;
            (f * -32.174, vec![x[0] + x[1] + x[2]])
        }
    }
}
