//! Moré, J. J., Garbow, B. S. & Hillstrom, K. E. (1981), Testing Unconstrained Optimization
//! Software, ACM Transactions on Mathematical Software 7(1), 17–41: the 35 problems, each a sum of
//! squares; No. 20 in two sizes. Optima that are not known in closed form have the six digits that
//! the paper prints; most of these are truncated, not rounded. Points that the paper prints to a
//! few digits are only in the descriptions. If the number of variables is free, it is a size from
//! the paper, or ten (No. 22: twelve). The problems MGH09, MGH10 and MGH17 of NIST's collection of
//! regression problems are Nos. 15, 10 and 17 here.

use super::hock_schittkowski_2::sum;
use longdrive::number::Number;
use std::f64::consts::TAU;

const INF: f64 = f64::INFINITY;

fn squares<T: Number>(residuals: impl IntoIterator<Item = T>) -> (T, Vec<T>) {
    (sum(residuals.into_iter().map(|r| r * r)), vec![])
}

/// The pairs (i, yᵢ) of a table of measurements y, with i from 1.
fn numbered(measured: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    (1..).map(f64::from).zip(measured.iter().copied())
}

/// The numbers 1, …, n.
fn to(n: u32) -> impl Iterator<Item = f64> + Clone {
    (1..=n).map(f64::from)
}

fn weighted<T: Number>(x: &[T]) -> T {
    sum(x.iter().zip(to(u32::MAX)).map(|(&x, j)| x * j))
}

const BARD: [f64; 15] = [
    0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39, 0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39,
];
const GAUSSIAN: [f64; 15] = [
    0.0009, 0.0044, 0.0175, 0.0540, 0.1295, 0.2420, 0.3521, 0.3989, 0.3521, 0.2420, 0.1295, 0.0540,
    0.0175, 0.0044, 0.0009,
];
const MEYER: [f64; 16] = [
    34780.0, 28610.0, 23650.0, 19630.0, 16370.0, 13720.0, 11540.0, 9744.0, 8261.0, 7030.0, 6005.0,
    5147.0, 4427.0, 3820.0, 3307.0, 2872.0,
];
/// No. 15: pairs of y and u.
const KOWALIK_OSBORNE: [(f64, f64); 11] = [
    (0.1957, 4.0),
    (0.1947, 2.0),
    (0.1735, 1.0),
    (0.1600, 0.5),
    (0.0844, 0.25),
    (0.0627, 0.167),
    (0.0456, 0.125),
    (0.0342, 0.1),
    (0.0323, 0.0833),
    (0.0235, 0.0714),
    (0.0246, 0.0625),
];
const OSBORNE_1: [f64; 33] = [
    0.844, 0.908, 0.932, 0.936, 0.925, 0.908, 0.881, 0.850, 0.818, 0.784, 0.751, 0.718, 0.685,
    0.658, 0.628, 0.603, 0.580, 0.558, 0.538, 0.522, 0.506, 0.490, 0.478, 0.467, 0.457, 0.448,
    0.438, 0.431, 0.424, 0.420, 0.414, 0.411, 0.406,
];
const OSBORNE_2: [f64; 65] = [
    1.366, 1.191, 1.112, 1.013, 0.991, 0.885, 0.831, 0.847, 0.786, 0.725, 0.746, 0.679, 0.608,
    0.655, 0.616, 0.606, 0.602, 0.626, 0.651, 0.724, 0.649, 0.649, 0.694, 0.644, 0.624, 0.661,
    0.612, 0.558, 0.533, 0.495, 0.500, 0.423, 0.395, 0.375, 0.372, 0.391, 0.396, 0.405, 0.428,
    0.429, 0.523, 0.562, 0.607, 0.653, 0.672, 0.708, 0.633, 0.668, 0.645, 0.632, 0.591, 0.559,
    0.597, 0.625, 0.739, 0.710, 0.729, 0.720, 0.636, 0.581, 0.428, 0.292, 0.162, 0.098, 0.054,
];

fn rosenbrock<T: Number>(x: &[T]) -> (T, Vec<T>) {
    squares(
        x.chunks(2)
            .flat_map(|x| [(x[1] - x[0] * x[0]) * 10.0, -x[0] + 1.0]),
    )
}

fn powell_singular<T: Number>(x: &[T]) -> (T, Vec<T>) {
    squares(x.chunks(4).flat_map(|x| {
        let (a, b) = (x[1] - x[2] * 2.0, x[0] - x[3]);
        [
            x[0] + x[1] * 10.0,
            (x[2] - x[3]) * 5f64.sqrt(),
            a * a,
            b * b * 10f64.sqrt(),
        ]
    }))
}

fn watson<T: Number>(x: &[T]) -> (T, Vec<T>) {
    let fit = to(29).map(|i| {
        let t = i / 29.0;
        let (mut value, mut slope) = (T::zero(), T::zero());
        for &x in x.iter().rev() {
            slope = slope * t + value;
            value = value * t + x;
        }
        slope - value * value - 1.0
    });
    squares(fit.chain([x[0], x[1] - x[0] * x[0] - 1.0]))
}

/// Nos. 28 and 29: for each variable x at its point t, the pair of t and (x + t + 1)³.
fn cubes<T: Number>(x: &[T]) -> Vec<(f64, T)> {
    let h = 1.0 / (x.len() as f64 + 1.0);
    to(u32::MAX)
        .zip(x)
        .map(|(i, &x)| (i * h, (x + i * h + 1.0).powi(3)))
        .collect()
}

/// Nos. 28 and 29: the start t (t − 1) at the points t = 1/11, …, 10/11.
const PARABOLA: [f64; 10] = [
    -10.0 / 121.0,
    -18.0 / 121.0,
    -24.0 / 121.0,
    -28.0 / 121.0,
    -30.0 / 121.0,
    -30.0 / 121.0,
    -28.0 / 121.0,
    -24.0 / 121.0,
    -18.0 / 121.0,
    -10.0 / 121.0,
];

problems! {
    /// No. 1, Rosenbrock.
    MGH01 {
        start: [-1.2, 1.0], low: [-INF; 2], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [1.0, 1.0],
        |x| rosenbrock(x)
    }
    /// No. 2, Freudenstein and Roth; a local minimum 48.9842 is at (11.41, −0.8968).
    MGH02 {
        start: [0.5, -2.0], low: [-INF; 2], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [5.0, 4.0],
        |x| squares([
            x[0] + ((-x[1] + 5.0) * x[1] - 2.0) * x[1] - 13.0,
            x[0] + ((x[1] + 1.0) * x[1] - 14.0) * x[1] - 29.0,
        ])
    }
    /// No. 3, Powell badly scaled; its minimum is at (1.098e-5, 9.106).
    MGH03 {
        start: [0.0, 1.0], low: [-INF; 2], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [],
        |x| squares([x[0] * x[1] * 1e4 - 1.0, (-x[0]).exp() + (-x[1]).exp() - 1.0001])
    }
    /// No. 4, Brown badly scaled.
    MGH04 {
        start: [1.0; 2], low: [-INF; 2], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [1e6, 2e-6],
        |x| squares([x[0] - 1e6, x[1] - 2e-6, x[0] * x[1] - 2.0])
    }
    /// No. 5, Beale.
    MGH05 {
        start: [1.0; 2], low: [-INF; 2], high: [INF; 2], least: [], most: [],
        optimum: 0.0, at: [3.0, 0.5],
        |x| squares([(1, 1.5), (2, 2.25), (3, 2.625)].map(|(i, y)| x[0] * (x[1].powi(i) - 1.0) + y))
    }
    /// No. 6, Jennrich and Sampson, m = 10; its minimum is at (0.2578, 0.2578).
    MGH06 {
        start: [0.3, 0.4], low: [-INF; 2], high: [INF; 2], least: [], most: [],
        optimum: 124.362, at: [],
        |x| squares(to(10).map(|i| -(x[0] * i).exp() - (x[1] * i).exp() + (2.0 + 2.0 * i)))
    }
    /// No. 7, helical valley.
    MGH07 {
        start: [-1.0, 0.0, 0.0], low: [-INF; 3], high: [INF; 3], least: [], most: [],
        optimum: 0.0, at: [1.0, 0.0, 0.0],
        |x| {
            // the angle of (x₁, x₂) in turns, from −1/4 to 3/4
            let turn = if x[0].re() < 0.0 { (-x[1]).atan2(-x[0]) / TAU + 0.5 } else { x[1].atan2(x[0]) / TAU };
            squares([(x[2] - turn * 10.0) * 10.0, ((x[0] * x[0] + x[1] * x[1]).sqrt() - 1.0) * 10.0, x[2]])
        }
    }
    /// No. 8, Bard; a second minimum 17.4286 is at (0.8406, −∞, −∞).
    MGH08 {
        start: [1.0; 3], low: [-INF; 3], high: [INF; 3], least: [], most: [],
        optimum: 8.21487e-3, at: [],
        |x| squares(numbered(&BARD).map(|(u, y)| {
            let v = 16.0 - u;
            -x[0] - (x[1] * v + x[2] * u.min(v)).recip() * u + y
        }))
    }
    /// No. 9, Gaussian.
    MGH09 {
        start: [0.4, 1.0, 0.0], low: [-INF; 3], high: [INF; 3], least: [], most: [],
        optimum: 1.12793e-8, at: [],
        |x| squares(numbered(&GAUSSIAN).map(|(i, y)| {
            let off = -x[2] + (8.0 - i) / 2.0;
            x[0] * (-x[1] * off * off / 2.0).exp() - y
        }))
    }
    /// No. 10, Meyer; NIST certifies 87.945855171.
    MGH10 {
        start: [0.02, 4000.0, 250.0], low: [-INF; 3], high: [INF; 3], least: [], most: [],
        optimum: 87.9458, at: [],
        |x| squares(numbered(&MEYER).map(|(i, y)| x[0] * (x[1] / (x[2] + (45.0 + 5.0 * i))).exp() - y))
    }
    /// No. 11, Gulf research and development, m = 99, with |yᵢ − x₂|: the paper has a misprint
    /// there.
    MGH11 {
        start: [5.0, 2.5, 0.15], low: [-INF; 3], high: [INF; 3], least: [], most: [],
        optimum: 0.0, at: [50.0, 25.0, 1.5],
        |x| squares(to(99).map(|i| {
            let t = i / 100.0;
            let off = -x[1] + (25.0 + (-50.0 * t.ln()).powf(2.0 / 3.0));
            let size = if off.re() < 0.0 { -off } else { off };
            (-(size.ln() * x[2]).exp() / x[0]).exp() - t
        }))
    }
    /// No. 12, Box three-dimensional, m = 10; f is also zero at (10, 1, −1), and wherever x₁ = x₂
    /// and x₃ = 0.
    MGH12 {
        start: [0.0, 10.0, 20.0], low: [-INF; 3], high: [INF; 3], least: [], most: [],
        optimum: 0.0, at: [1.0, 10.0, 1.0],
        |x| squares(to(10).map(|i| {
            let t = -0.1 * i;
            (x[0] * t).exp() - (x[1] * t).exp() - x[2] * (t.exp() - (10.0 * t).exp())
        }))
    }
    /// No. 13, Powell singular.
    MGH13 {
        start: [3.0, -1.0, 0.0, 1.0], low: [-INF; 4], high: [INF; 4], least: [], most: [],
        optimum: 0.0, at: [0.0; 4],
        |x| powell_singular(x)
    }
    /// No. 14, Wood.
    MGH14 {
        start: [-3.0, -1.0, -3.0, -1.0], low: [-INF; 4], high: [INF; 4], least: [], most: [],
        optimum: 0.0, at: [1.0; 4],
        |x| squares([
            (x[1] - x[0] * x[0]) * 10.0,
            -x[0] + 1.0,
            (x[3] - x[2] * x[2]) * 90f64.sqrt(),
            -x[2] + 1.0,
            (x[1] + x[3] - 2.0) * 10f64.sqrt(),
            (x[1] - x[3]) / 10f64.sqrt(),
        ])
    }
    /// No. 15, Kowalik and Osborne; NIST certifies 3.0750560385e-4. A second minimum of 1.02734e-3
    /// is at (∞, −14.07, −∞, −∞).
    MGH15 {
        start: [0.25, 0.39, 0.415, 0.39], low: [-INF; 4], high: [INF; 4], least: [], most: [],
        optimum: 3.07505e-4, at: [],
        |x| squares(KOWALIK_OSBORNE.map(|(y, u)| {
            -x[0] * (x[1] * u + u * u) / (x[2] * u + x[3] + u * u) + y
        }))
    }
    /// No. 16, Brown and Dennis, m = 20.
    MGH16 {
        start: [25.0, 5.0, -5.0, -1.0], low: [-INF; 4], high: [INF; 4], least: [], most: [],
        optimum: 85822.2, at: [],
        |x| squares(to(20).map(|i| {
            let t: f64 = i / 5.0;
            let (a, b) = (x[0] + x[1] * t - t.exp(), x[2] + x[3] * t.sin() - t.cos());
            a * a + b * b
        }))
    }
    /// No. 17, Osborne 1; NIST certifies 5.4648946975e-5.
    MGH17 {
        start: [0.5, 1.5, -1.0, 0.01, 0.02], low: [-INF; 5], high: [INF; 5], least: [], most: [],
        optimum: 5.46489e-5, at: [],
        |x| squares(numbered(&OSBORNE_1).map(|(i, y)| {
            let t = -10.0 * (i - 1.0);
            -x[0] - x[1] * (x[3] * t).exp() - x[2] * (x[4] * t).exp() + y
        }))
    }
    /// No. 18, Biggs EXP6, m = 13; a local minimum is 5.65565e-3.
    MGH18 {
        start: [1.0, 2.0, 1.0, 1.0, 1.0, 1.0], low: [-INF; 6], high: [INF; 6], least: [], most: [],
        optimum: 0.0, at: [1.0, 10.0, 1.0, 5.0, 4.0, 3.0],
        |x| squares(to(13).map(|i| {
            let t = -0.1 * i;
            let y = t.exp() - 5.0 * (10.0 * t).exp() + 3.0 * (4.0 * t).exp();
            x[2] * (x[0] * t).exp() - x[3] * (x[1] * t).exp() + x[5] * (x[4] * t).exp() - y
        }))
    }
    /// No. 19, Osborne 2.
    MGH19 {
        start: [1.3, 0.65, 0.65, 0.7, 0.6, 3.0, 5.0, 7.0, 2.0, 4.5, 5.5],
        low: [-INF; 11], high: [INF; 11], least: [], most: [],
        optimum: 4.01377e-2, at: [],
        |x| squares(numbered(&OSBORNE_2).map(|(i, y)| {
            let t = (i - 1.0) / 10.0;
            let peak = |k: usize| {
                let off = -x[k + 7] + t;
                x[k] * (-off * off * x[k + 4]).exp()
            };
            -x[0] * (-x[4] * t).exp() - peak(1) - peak(2) - peak(3) + y
        }))
    }
    /// No. 20, Watson, n = 6.
    MGH20N6 {
        start: [0.0; 6], low: [-INF; 6], high: [INF; 6], least: [], most: [],
        optimum: 2.28767e-3, at: [],
        |x| watson(x)
    }
    /// No. 20, Watson, n = 9.
    MGH20N9 {
        start: [0.0; 9], low: [-INF; 9], high: [INF; 9], least: [], most: [],
        optimum: 1.39976e-6, at: [],
        |x| watson(x)
    }
    /// No. 21, extended Rosenbrock, n = 10.
    MGH21 {
        start: [-1.2, 1.0, -1.2, 1.0, -1.2, 1.0, -1.2, 1.0, -1.2, 1.0],
        low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [1.0; 10],
        |x| rosenbrock(x)
    }
    /// No. 22, extended Powell singular, n = 12.
    MGH22 {
        start: [3.0, -1.0, 0.0, 1.0, 3.0, -1.0, 0.0, 1.0, 3.0, -1.0, 0.0, 1.0],
        low: [-INF; 12], high: [INF; 12], least: [], most: [],
        optimum: 0.0, at: [0.0; 12],
        |x| powell_singular(x)
    }
    /// No. 23, penalty I, n = 4.
    MGH23 {
        start: [1.0, 2.0, 3.0, 4.0], low: [-INF; 4], high: [INF; 4], least: [], most: [],
        optimum: 2.24997e-5, at: [],
        |x| {
            let ball = sum(x.iter().map(|&x| x * x)) - 0.25;
            squares(x.iter().map(|&x| (x - 1.0) * 1e-5f64.sqrt()).chain([ball]))
        }
    }
    /// No. 24, penalty II, n = 4.
    MGH24 {
        start: [0.5; 4], low: [-INF; 4], high: [INF; 4], least: [], most: [],
        optimum: 9.37629e-6, at: [],
        |x| {
            let (a, e) = (1e-5f64.sqrt(), |t: f64| (t / 10.0).exp());
            let pairs = x.windows(2).zip(to(3)).map(|(x, i)| {
                ((x[1] / 10.0).exp() + (x[0] / 10.0).exp() - (e(i + 1.0) + e(i))) * a
            });
            let single = x[1..].iter().map(|&x| ((x / 10.0).exp() - e(-1.0)) * a);
            let ball = sum(x.iter().rev().zip(to(4)).map(|(&x, j)| x * x * j)) - 1.0;
            squares(pairs.chain(single).chain([x[0] - 0.2, ball]))
        }
    }
    /// No. 25, variably dimensioned, n = 10.
    MGH25 {
        start: [0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.0],
        low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [1.0; 10],
        |x| {
            let off: Vec<T> = x.iter().map(|&x| x - 1.0).collect();
            let all = weighted(&off);
            squares(off.into_iter().chain([all, all * all]))
        }
    }
    /// No. 26, trigonometric, n = 10; a local minimum is 2.79506e-5.
    MGH26 {
        start: [0.1; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [0.0; 10],
        |x| {
            let all = sum(x.iter().map(|&x| -x.cos() + 1.0));
            squares(x.iter().zip(to(10)).map(|(&x, i)| all + (-x.cos() + 1.0) * i - x.sin()))
        }
    }
    /// No. 27, Brown almost-linear, n = 10; f is also zero at a second point, and has a local
    /// minimum of 1 at (0, …, 0, 11).
    MGH27 {
        start: [0.5; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [1.0; 10],
        |x| {
            let (total, product) = (sum(x.iter().copied()), x.iter().fold(T::constant(1.0), |p, &x| p * x));
            squares(x[..9].iter().map(|&x| x + total - 11.0).chain([product - 1.0]))
        }
    }
    /// No. 28, discrete boundary value, n = 10.
    MGH28 {
        start: PARABOLA, low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [],
        |x| {
            let at = |i: usize| x.get(i).copied().unwrap_or(T::zero());
            squares(cubes(x).into_iter().enumerate().map(|(i, (_, cube))| {
                x[i] * 2.0 - at(i.wrapping_sub(1)) - at(i + 1) + cube / (2.0 * 121.0)
            }))
        }
    }
    /// No. 29, discrete integral equation, n = 10.
    MGH29 {
        start: PARABOLA, low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [],
        |x| {
            let points = cubes(x);
            squares(x.iter().zip(&points).map(|(&x, &(t, _))| {
                let kernel = |s: f64| if s <= t { (1.0 - t) * s } else { t * (1.0 - s) };
                x + sum(points.iter().map(|&(s, cube)| cube * kernel(s))) / (2.0 * 11.0)
            }))
        }
    }
    /// No. 30, Broyden tridiagonal, n = 10.
    MGH30 {
        start: [-1.0; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [],
        |x| {
            let at = |i: usize| x.get(i).copied().unwrap_or(T::zero());
            squares((0..10).map(|i| {
                (-x[i] * 2.0 + 3.0) * x[i] - at(i.wrapping_sub(1)) - at(i + 1) * 2.0 + 1.0
            }))
        }
    }
    /// No. 31, Broyden banded, n = 10.
    MGH31 {
        start: [-1.0; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 0.0, at: [],
        |x| squares((0..10usize).map(|i| {
            let band = (i.saturating_sub(5)..=(i + 1).min(9)).filter(|&j| j != i);
            x[i] * (x[i] * x[i] * 5.0 + 2.0) + 1.0 - sum(band.map(|j| x[j] * (x[j] + 1.0)))
        }))
    }
    /// No. 32, linear of full rank, n = 10, m = 20.
    MGH32 {
        start: [1.0; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 10.0, at: [-1.0; 10],
        |x| {
            let mean = sum(x.iter().copied()) / 10.0;
            squares(x.iter().map(|&x| x - mean - 1.0).chain([-mean - 1.0; 10]))
        }
    }
    /// No. 33, linear of rank 1, n = 10, m = 20; every point with Σ j xⱼ = 3/41 is a minimum.
    MGH33 {
        start: [1.0; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 190.0 / 41.0, at: [3.0 / 41.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        |x| squares(to(20).map(|i| weighted(x) * i - 1.0))
    }
    /// No. 34, linear of rank 1 with zero columns and rows, n = 10, m = 20; every point with 2 x₂ +
    /// … + 9 x₉ = 3/37 is a minimum.
    MGH34 {
        start: [1.0; 10], low: [-INF; 10], high: [INF; 10], least: [], most: [],
        optimum: 227.0 / 37.0, at: [0.0, 1.5 / 37.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        |x| {
            let inner = weighted(&x[..9]) - x[0];
            squares(to(18).map(|i| inner * i - 1.0).chain([T::constant(-1.0); 2]))
        }
    }
    /// No. 35, Chebyquad, n = 8.
    MGH35 {
        start: [1.0 / 9.0, 2.0 / 9.0, 3.0 / 9.0, 4.0 / 9.0, 5.0 / 9.0, 6.0 / 9.0, 7.0 / 9.0, 8.0 / 9.0],
        low: [-INF; 8], high: [INF; 8], least: [], most: [],
        optimum: 3.51687e-3, at: [],
        |x| {
            let mut means = [T::zero(); 8];
            for &x in x {
                let y = x * 2.0 - 1.0; // shifted to [0, 1]
                let (mut before, mut now) = (T::constant(1.0), y);
                for mean in &mut means {
                    *mean = *mean + now / 8.0;
                    (before, now) = (now, y * now * 2.0 - before);
                }
            }
            // the integral of the polynomial of degree i over [0, 1] is −1/(i² − 1) for even i
            squares((1..).zip(means).map(|(i, mean)| if i % 2 == 0 { mean + 1.0 / f64::from(i * i - 1) } else { mean }))
        }
    }
}
