//! Hock, W. & Schittkowski, K. (1981), Test Examples for Nonlinear Programming Codes, Lecture Notes
//! in Economics and Mathematical Systems 187, Springer; Nos. 1–40. An inequality has the book's
//! form g(x) ≥ 0, or the constant of g is its limit. The book has other names of the variables.

use super::hock_schittkowski_2::{dot, sum};
use longdrive::number::Number;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_3, LN_10, PI, SQRT_2};

const INF: f64 = f64::INFINITY;
const SQRT_3: f64 = 1.7320508075688772;
const LN_LN_10: f64 = 0.834032445247956;
const SQRT_7: f64 = 2.6457513110645906;

fn rosenbrock<T: Number>(x: &[T]) -> T {
    (x[1] - x[0] * x[0]).powi(2) * 100.0 + (-x[0] + 1.0).powi(2)
}

fn squares<T: Number>(x: &[T]) -> T {
    sum(x.iter().map(|&x| x * x))
}

problems! {
    HS1 {
        start: [-2.0, 1.0], low: [-INF, -1.5], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [1.0, 1.0],
        |x| (rosenbrock(x), vec![])
    }
    HS2 {
        start: [-2.0, 1.0], low: [-INF, 1.5], high: [INF; 2], least: [], most: [],
        optimum: 0.0504261878936, at: [1.22437074874, 1.5],
        |x| (rosenbrock(x), vec![])
    }
    HS3 {
        start: [10.0, 1.0], low: [-INF, 0.0], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [0.0, 0.0],
        |x| (x[1] + (x[1] - x[0]).powi(2) * 1e-5, vec![])
    }
    HS4 {
        start: [1.125, 0.125], low: [1.0, 0.0], high: [INF; 2], least: [], most: [],
        optimum: 8.0 / 3.0, at: [1.0, 0.0],
        |x| ((x[0] + 1.0).powi(3) / 3.0 + x[1], vec![])
    }
    HS5 {
        start: [0.0, 0.0], low: [-1.5, -3.0], high: [4.0, 3.0], least: [], most: [],
        optimum: -SQRT_3 / 2.0 - FRAC_PI_3, at: [0.5 - FRAC_PI_3, -0.5 - FRAC_PI_3],
        |x| {
            let f = (x[0] + x[1]).sin() + (x[0] - x[1]).powi(2) - x[0] * 1.5 + x[1] * 2.5 + 1.0;
            (f, vec![])
        }
    }
    HS6 {
        start: [-1.2, 1.0], low: [-INF; 2], high: [INF; 2], least: [0.0], most: [0.0],
        optimum: 0.0, at: [1.0, 1.0],
        |x| ((-x[0] + 1.0).powi(2), vec![(x[1] - x[0] * x[0]) * 10.0])
    }
    HS7 {
        start: [2.0, 2.0], low: [-INF; 2], high: [INF; 2], least: [4.0], most: [4.0],
        optimum: -SQRT_3, at: [0.0, SQRT_3],
        |x| {
            let one = x[0] * x[0] + 1.0;
            (one.ln() - x[1], vec![one * one + x[1] * x[1]])
        }
    }
    HS8 {
        start: [2.0, 1.0], low: [-INF; 2], high: [INF; 2], least: [25.0, 9.0], most: [25.0, 9.0],
        optimum: -1.0, at: [4.60159491768, 1.95584360662],
        |x| (T::constant(-1.0), vec![squares(x), x[0] * x[1]])
    }
    HS9 {
        start: [0.0, 0.0], low: [-INF; 2], high: [INF; 2], least: [0.0], most: [0.0],
        optimum: -0.5, at: [-3.0, -4.0],
        |x| ((x[0] * (PI / 12.0)).sin() * (x[1] * (PI / 16.0)).cos(), vec![x[0] * 4.0 - x[1] * 3.0])
    }
    HS10 {
        start: [-10.0, 10.0], low: [-INF; 2], high: [INF; 2], least: [0.0], most: [INF],
        optimum: -1.0, at: [0.0, 1.0],
        |x| (x[0] - x[1], vec![x[0] * x[0] * -3.0 + x[0] * x[1] * 2.0 - x[1] * x[1] + 1.0])
    }
    HS11 {
        start: [4.9, 0.1], low: [-INF; 2], high: [INF; 2], least: [0.0], most: [INF],
        optimum: -8.49846422315, at: [1.23477282505, 1.52466392949],
        |x| ((x[0] - 5.0).powi(2) + x[1] * x[1] - 25.0, vec![-x[0] * x[0] + x[1]])
    }
    HS12 {
        start: [0.0, 0.0], low: [-INF; 2], high: [INF; 2], least: [0.0], most: [INF],
        optimum: -30.0, at: [2.0, 3.0],
        |x| {
            let f = x[0] * x[0] * 0.5 + x[1] * x[1] - x[0] * x[1] - x[0] * 7.0 - x[1] * 7.0;
            (f, vec![x[0] * x[0] * -4.0 - x[1] * x[1] + 25.0])
        }
    }
    HS13 {
        start: [-2.0, -2.0], low: [0.0; 2], high: [INF; 2], least: [0.0], most: [INF],
        optimum: 1.0, at: [1.0, 0.0],
        |x| ((x[0] - 2.0).powi(2) + x[1] * x[1], vec![(-x[0] + 1.0).powi(3) - x[1]])
    }
    HS14 {
        start: [2.0, 2.0], low: [-INF; 2], high: [INF; 2], least: [0.0, 0.0], most: [INF, 0.0],
        optimum: 9.0 - 2.875 * SQRT_7, at: [0.5 * (SQRT_7 - 1.0), 0.25 * (SQRT_7 + 1.0)],
        |x| {
            let g = vec![x[0] * x[0] * -0.25 - x[1] * x[1] + 1.0, x[0] - x[1] * 2.0 + 1.0];
            ((x[0] - 2.0).powi(2) + (x[1] - 1.0).powi(2), g)
        }
    }
    HS15 {
        start: [-2.0, 1.0], low: [-INF; 2], high: [0.5, INF], least: [0.0; 2], most: [INF; 2],
        optimum: 306.5, at: [0.5, 2.0],
        |x| (rosenbrock(x), vec![x[0] * x[1] - 1.0, x[0] + x[1] * x[1]])
    }
    HS16 {
        start: [-2.0, 1.0], low: [-0.5, -INF], high: [0.5, 1.0], least: [0.0; 2], most: [INF; 2],
        optimum: 0.25, at: [0.5, 0.25],
        |x| (rosenbrock(x), vec![x[0] + x[1] * x[1], x[0] * x[0] + x[1]])
    }
    HS17 {
        start: [-2.0, 1.0], low: [-0.5, -INF], high: [0.5, 1.0], least: [0.0; 2], most: [INF; 2],
        optimum: 1.0, at: [0.0, 0.0],
        |x| (rosenbrock(x), vec![x[1] * x[1] - x[0], x[0] * x[0] - x[1]])
    }
    HS18 {
        start: [2.0, 2.0], low: [2.0, 0.0], high: [50.0; 2], least: [0.0; 2], most: [INF; 2],
        optimum: 5.0, at: [15.811388300841896, 1.5811388300841898],
        |x| (x[0] * x[0] * 0.01 + x[1] * x[1], vec![x[0] * x[1] - 25.0, squares(x) - 25.0])
    }
    HS19 {
        start: [20.1, 5.84], low: [13.0, 0.0], high: [100.0; 2], least: [0.0; 2], most: [INF; 2],
        optimum: -6961.81387558, at: [14.095, 0.842960789215],
        |x| {
            let g = vec![
                (x[0] - 5.0).powi(2) + (x[1] - 5.0).powi(2) - 100.0,
                -(x[0] - 6.0).powi(2) - (x[1] - 5.0).powi(2) + 82.81,
            ];
            ((x[0] - 10.0).powi(3) + (x[1] - 20.0).powi(3), g)
        }
    }
    HS20 {
        start: [-2.0, 1.0], low: [-0.5, -INF], high: [0.5, INF], least: [0.0; 3], most: [INF; 3],
        optimum: 81.5 - 25.0 * SQRT_3, at: [0.5, 0.5 * SQRT_3],
        |x| (rosenbrock(x), vec![x[0] + x[1] * x[1], x[0] * x[0] + x[1], squares(x) - 1.0])
    }
    HS21 {
        start: [-1.0, -1.0], low: [2.0, -50.0], high: [50.0; 2], least: [0.0], most: [INF],
        optimum: -99.96, at: [2.0, 0.0],
        |x| (x[0] * x[0] * 0.01 + x[1] * x[1] - 100.0, vec![x[0] * 10.0 - x[1] - 10.0])
    }
    HS22 {
        start: [2.0, 2.0], low: [-INF; 2], high: [INF; 2], least: [0.0; 2], most: [INF; 2],
        optimum: 1.0, at: [1.0, 1.0],
        |x| {
            let g = vec![-x[0] - x[1] + 2.0, -x[0] * x[0] + x[1]];
            ((x[0] - 2.0).powi(2) + (x[1] - 1.0).powi(2), g)
        }
    }
    HS23 {
        start: [3.0, 1.0], low: [-50.0; 2], high: [50.0; 2], least: [0.0; 5], most: [INF; 5],
        optimum: 2.0, at: [1.0, 1.0],
        |x| {
            let g = vec![
                x[0] + x[1] - 1.0,
                squares(x) - 1.0,
                x[0] * x[0] * 9.0 + x[1] * x[1] - 9.0,
                x[0] * x[0] - x[1],
                x[1] * x[1] - x[0],
            ];
            (squares(x), g)
        }
    }
    HS24 {
        start: [1.0, 0.5], low: [0.0; 2], high: [INF; 2], least: [0.0; 3], most: [INF; 3],
        optimum: -1.0, at: [3.0, SQRT_3],
        |x| {
            let f = ((x[0] - 3.0).powi(2) - 9.0) * x[1].powi(3) / (27.0 * SQRT_3);
            (f, vec![x[0] / SQRT_3 - x[1], x[0] + x[1] * SQRT_3, -x[0] - x[1] * SQRT_3 + 6.0])
        }
    }
    HS25 {
        start: [100.0, 12.5, 3.0], low: [0.1, 0.0, 0.0], high: [100.0, 25.6, 5.0], least: [], most: [],
        optimum: 0.0, at: [50.0, 25.0, 1.5],
        |x| {
            let f = sum((1..100).map(|i| {
                let share = 0.01 * f64::from(i);
                let u = 25.0 + (-50.0 * share.ln()).powf(2.0 / 3.0);
                let power = ((-x[1] + u).ln() * x[2]).exp();
                ((-power / x[0]).exp() - share).powi(2)
            }));
            (f, vec![])
        }
    }
    HS26 {
        start: [-2.6, 2.0, 2.0], low: [-INF; 3], high: [INF; 3], least: [3.0], most: [3.0],
        optimum: 0.0, at: [1.0; 3],
        |x| ((x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(4), vec![(x[1] * x[1] + 1.0) * x[0] + x[2].powi(4)])
    }
    HS27 {
        start: [2.0; 3], low: [-INF; 3], high: [INF; 3], least: [-1.0], most: [-1.0],
        optimum: 0.04, at: [-1.0, 1.0, 0.0],
        |x| ((x[0] - 1.0).powi(2) * 0.01 + (x[1] - x[0] * x[0]).powi(2), vec![x[0] + x[2] * x[2]])
    }
    HS28 {
        start: [-4.0, 1.0, 1.0], low: [-INF; 3], high: [INF; 3], least: [1.0], most: [1.0],
        optimum: 0.0, at: [0.5, -0.5, 0.5],
        |x| ((x[0] + x[1]).powi(2) + (x[1] + x[2]).powi(2), vec![dot(&[1.0, 2.0, 3.0], x)])
    }
    HS29 {
        start: [1.0; 3], low: [-INF; 3], high: [INF; 3], least: [0.0], most: [INF],
        optimum: -16.0 * SQRT_2, at: [4.0, 2.0 * SQRT_2, 2.0],
        |x| (-x[0] * x[1] * x[2], vec![-x[0] * x[0] - x[1] * x[1] * 2.0 - x[2] * x[2] * 4.0 + 48.0])
    }
    HS30 {
        start: [1.0; 3], low: [1.0, -10.0, -10.0], high: [10.0; 3], least: [0.0], most: [INF],
        optimum: 1.0, at: [1.0, 0.0, 0.0],
        |x| (squares(x), vec![squares(&x[..2]) - 1.0])
    }
    HS31 {
        start: [1.0; 3], low: [-10.0, 1.0, -10.0], high: [10.0, 10.0, 1.0], least: [0.0], most: [INF],
        optimum: 6.0, at: [1.0 / SQRT_3, SQRT_3, 0.0],
        |x| (x[0] * x[0] * 9.0 + x[1] * x[1] + x[2] * x[2] * 9.0, vec![x[0] * x[1] - 1.0])
    }
    HS32 {
        start: [0.1, 0.7, 0.2], low: [0.0; 3], high: [INF; 3], least: [0.0, 1.0], most: [INF, 1.0],
        optimum: 1.0, at: [0.0, 0.0, 1.0],
        |x| {
            let f = (x[0] + x[1] * 3.0 + x[2]).powi(2) + (x[0] - x[1]).powi(2) * 4.0;
            (f, vec![x[1] * 6.0 + x[2] * 4.0 - x[0].powi(3) - 3.0, x[0] + x[1] + x[2]])
        }
    }
    HS33 {
        start: [0.0, 0.0, 3.0], low: [0.0; 3], high: [INF, INF, 5.0], least: [0.0; 2], most: [INF; 2],
        optimum: SQRT_2 - 6.0, at: [0.0, SQRT_2, SQRT_2],
        |x| {
            let f = (x[0] - 1.0) * (x[0] - 2.0) * (x[0] - 3.0) + x[2];
            (f, vec![x[2] * x[2] - squares(&x[..2]), squares(x) - 4.0])
        }
    }
    HS34 {
        start: [0.0, 1.05, 2.9], low: [0.0; 3], high: [100.0, 100.0, 10.0], least: [0.0; 2], most: [INF; 2],
        optimum: -LN_LN_10, at: [LN_LN_10, LN_10, 10.0],
        |x| (-x[0], vec![x[1] - x[0].exp(), x[2] - x[1].exp()])
    }
    HS35 {
        start: [0.5; 3], low: [0.0; 3], high: [INF; 3], least: [0.0], most: [INF],
        optimum: 1.0 / 9.0, at: [4.0 / 3.0, 7.0 / 9.0, 4.0 / 9.0],
        |x| {
            let f = x[0] * x[0] * 2.0 + x[1] * x[1] * 2.0 + x[2] * x[2] + x[0] * x[1] * 2.0 + x[0] * x[2] * 2.0
                - dot(&[8.0, 6.0, 4.0], x)
                + 9.0;
            (f, vec![-dot(&[1.0, 1.0, 2.0], x) + 3.0])
        }
    }
    HS36 {
        start: [10.0; 3], low: [0.0; 3], high: [20.0, 11.0, 42.0], least: [0.0], most: [INF],
        optimum: -3300.0, at: [20.0, 11.0, 15.0],
        |x| (-x[0] * x[1] * x[2], vec![-dot(&[1.0, 2.0, 2.0], x) + 72.0])
    }
    HS37 {
        start: [10.0; 3], low: [0.0; 3], high: [42.0; 3], least: [0.0; 2], most: [INF; 2],
        optimum: -3456.0, at: [24.0, 12.0, 12.0],
        |x| {
            let girth = dot(&[1.0, 2.0, 2.0], x);
            (-x[0] * x[1] * x[2], vec![-girth + 72.0, girth])
        }
    }
    HS38 {
        start: [-3.0, -1.0, -3.0, -1.0], low: [-10.0; 4], high: [10.0; 4], least: [], most: [],
        optimum: 0.0, at: [1.0; 4],
        |x| {
            let f = rosenbrock(&x[..2])
                + (x[3] - x[2] * x[2]).powi(2) * 90.0
                + (-x[2] + 1.0).powi(2)
                + ((x[1] - 1.0).powi(2) + (x[3] - 1.0).powi(2)) * 10.1
                + (x[1] - 1.0) * (x[3] - 1.0) * 19.8;
            (f, vec![])
        }
    }
    HS39 {
        start: [2.0; 4], low: [-INF; 4], high: [INF; 4], least: [0.0; 2], most: [0.0; 2],
        optimum: -1.0, at: [1.0, 1.0, 0.0, 0.0],
        |x| (-x[0], vec![x[1] - x[0].powi(3) - x[2] * x[2], x[0] * x[0] - x[1] - x[3] * x[3]])
    }
    HS40 {
        start: [0.8; 4], low: [-INF; 4], high: [INF; 4], least: [1.0, 0.0, 0.0], most: [1.0, 0.0, 0.0],
        optimum: -0.25, at: [0.7937005259840998, FRAC_1_SQRT_2, 0.5297315471796476, 0.8408964152537145],
        |x| {
            let g = vec![x[0].powi(3) + x[1] * x[1], x[0] * x[0] * x[3] - x[2], x[3] * x[3] - x[1]];
            (-x[0] * x[1] * x[2] * x[3], g)
        }
    }
}
