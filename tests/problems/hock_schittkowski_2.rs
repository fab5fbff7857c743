//! Hock, W. & Schittkowski, K. (1981), Test Examples for Nonlinear Programming Codes, Lecture Notes
//! in Economics and Mathematical Systems 187, Springer; Nos. 63–92. An inequality has the book's
//! form g(x) ≥ 0, or the constant of g is its limit. The book has other signs and names of the
//! variables. Optima have the digits of the authors' own test programs. Two problems are omitted:
//! No. 67 (an inner iteration without a fixed point in parts of the box) and No. 87 (a
//! discontinuous objective). There is no No. 82.

#![allow(clippy::approx_constant)] // No. 70 has 6.2832 for 2π

use longdrive::number::Number;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_2_SQRT_PI, PI, SQRT_2};

const INF: f64 = f64::INFINITY;

pub fn sum<T: Number>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::zero(), |s, term| s + term)
}

pub fn dot<T: Number>(a: &[f64], x: &[T]) -> T {
    sum(x.iter().zip(a).map(|(&x, &a)| x * a))
}

/// The distribution function of the standard normal distribution: by a series for |t| ≤ 4, else by
/// a continued fraction.
fn normal<T: Number>(t: T) -> T {
    let density = (t * t * -0.5).exp() * (0.5 * FRAC_2_SQRT_PI * FRAC_1_SQRT_2);
    if t.re() < -4.0 {
        let fraction = (1..=80).rev().fold(-t, |f, n| f.recip() * f64::from(n) - t);
        return density / fraction;
    }
    if t.re() > 4.0 {
        return -normal(-t) + 1.0;
    }
    let (mut term, mut series) = (t, t);
    for n in 1..80 {
        term = term * t * t / f64::from(2 * n + 1);
        series = series + term;
    }
    density * series + 0.5
}

fn inspection_plan<T: Number>(a: f64, b: f64, n: f64, x: &[T]) -> (T, Vec<T>) {
    let growth = x[0].exp() - 1.0;
    let cost = (-(growth * b - x[2]) * x[3] / (growth + x[3]) + a * n) / x[0];
    let shift = n.sqrt();
    (
        cost,
        vec![
            x[2] - normal(-x[1]) * 2.0,
            x[3] - normal(-x[1] + shift) - normal(-x[1] - shift),
        ],
    )
}

/// No. 70: times and measurements.
const TIMES: [f64; 19] = [
    0.1, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0,
    17.0, 18.0,
];
const MEASURED: [f64; 19] = [
    0.00189, 0.1038, 0.268, 0.506, 0.577, 0.604, 0.725, 0.898, 0.947, 0.845, 0.702, 0.528, 0.385,
    0.257, 0.159, 0.0869, 0.0453, 0.01509, 0.00189,
];

fn three_generators<T: Number>(x: &[T]) -> (T, Vec<T>) {
    let cost = x[0] * 3.0 + x[0].powi(3) * 1e-6 + x[1] * 2.0 + x[1].powi(3) * (2e-6 / 3.0);
    let flow = |angle: T| (angle - 0.25).sin() * 1000.0;
    let balance = vec![
        x[3] - x[2],
        flow(-x[2]) + flow(-x[3]) + 894.8 - x[0],
        flow(x[2]) + flow(x[2] - x[3]) + 894.8 - x[1],
        flow(x[3]) + flow(x[3] - x[2]) + 1294.8,
    ];
    (cost, balance)
}

/// Objective and equations of Nos. 78, 80 and 81.
fn product_of_five<T: Number>(x: &[T]) -> (T, Vec<T>) {
    let squares = sum(x.iter().map(|&x| x * x));
    let equations = vec![
        squares,
        x[1] * x[2] - x[3] * x[4] * 5.0,
        x[0].powi(3) + x[1].powi(3),
    ];
    (x[0] * x[1] * x[2] * x[3] * x[4], equations)
}

/// No. 84: coefficients aₖ. Objective and constraint functions are computed from the four numbers
/// x₁ (aₖ · (1, x₂, …, x₅)).
const SUGAR: [[f64; 5]; 4] = [
    [
        -8720288.849,
        150512.5253,
        -156.6950325,
        476470.3222,
        729482.8271,
    ],
    [-145421.402, 2931.1506, -40.427932, 5106.192, 15711.36],
    [-155011.1084, 4360.53352, 12.9492344, 10236.884, 13176.786],
    [-326669.5104, 7390.68412, -27.8986976, 16643.076, 30988.146],
];

/// The coefficients of Nos. 86 and 117, Colville's primal and dual problem.
pub const COLVILLE_A: [[f64; 5]; 10] = [
    [-16.0, 2.0, 0.0, 1.0, 0.0],
    [0.0, -2.0, 0.0, 0.4, 2.0],
    [-3.5, 0.0, 2.0, 0.0, 0.0],
    [0.0, -2.0, 0.0, -4.0, -1.0],
    [0.0, -9.0, -2.0, 1.0, -2.8],
    [2.0, 0.0, -4.0, 0.0, 0.0],
    [-1.0, -1.0, -1.0, -1.0, -1.0],
    [-1.0, -2.0, -3.0, -2.0, -1.0],
    [1.0, 2.0, 3.0, 4.0, 5.0],
    [1.0, 1.0, 1.0, 1.0, 1.0],
];
pub const COLVILLE_B: [f64; 10] = [-40.0, -2.0, -0.25, -4.0, -4.0, -1.0, -40.0, -60.0, 5.0, 1.0];
pub const COLVILLE_C: [[f64; 5]; 5] = [
    [30.0, -20.0, -10.0, 32.0, -10.0],
    [-20.0, 39.0, -6.0, -31.0, 32.0],
    [-10.0, -6.0, 10.0, -6.0, -10.0],
    [32.0, -31.0, -6.0, 39.0, -20.0],
    [-10.0, 32.0, -10.0, -20.0, 30.0],
];
pub const COLVILLE_D: [f64; 5] = [4.0, 8.0, 10.0, 6.0, 2.0];
pub const COLVILLE_E: [f64; 5] = [-15.0, -27.0, -36.0, -18.0, -12.0];

/// Nos. 88–92: a heating process with switching times. The book's double sum over pairs of
/// eigenfunctions is omitted: it is zero, because the eigenfunctions are orthogonal.
fn heating<T: Number>(x: &[T]) -> (T, Vec<T>) {
    let mut miss = T::constant(2.0 / 15.0);
    for j in 0..30 {
        // fixed-point iteration for the root of µ tan µ = 1 above `whole`
        let whole = PI * f64::from(j);
        let mu = (0..80).fold(whole + 0.5, |mu, _| whole + (1.0 / mu).atan());
        let (sin, cos) = mu.sin_cos();
        let (mut time, mut state) = (T::zero(), T::constant(1.0));
        for i in (0..x.len()).rev() {
            time = time + x[i] * x[i];
            state = (time * (-mu * mu)).exp() * if i == 0 { 1.0 } else { 2.0 } - state;
        }
        let rho = -state / (mu * mu);
        let weight = mu * mu * 2.0 * sin / (mu + sin * cos);
        miss = miss + rho * (rho * (mu * sin) - 2.0 * (sin / mu - cos) / (mu * mu)) * weight;
    }
    (sum(x.iter().map(|&x| x * x)), vec![-miss + 1e-4])
}

problems! {
    HS63 {
        start: [2.0; 3], low: [0.0; 3], high: [INF; 3], least: [56.0, 25.0], most: [56.0, 25.0],
        optimum: 961.715172127, at: [3.51211841492, 0.216988174172, 3.55217403459],
        |x| {
            let f = -x[0] * x[0] - x[1] * x[1] * 2.0 - x[2] * x[2] - x[0] * x[1] - x[0] * x[2] + 1000.0;
            (f, vec![dot(&[8.0, 14.0, 7.0], x), x[0] * x[0] + x[1] * x[1] + x[2] * x[2]])
        }
    }
    HS64 {
        start: [1.0; 3], low: [1e-5; 3], high: [INF; 3], least: [0.0], most: [INF],
        optimum: 6299.84242821, at: [108.734717597, 85.1261394257, 204.324707858],
        |x| {
            let over = |a: f64, x: T| x.recip() * a;
            let f = dot(&[5.0, 20.0, 10.0], x) + over(50000.0, x[0]) + over(72000.0, x[1]) + over(144000.0, x[2]);
            (f, vec![-over(4.0, x[0]) - over(32.0, x[1]) - over(120.0, x[2]) + 1.0])
        }
    }
    HS65 {
        start: [-5.0, 5.0, 0.0], low: [-4.5, -4.5, -5.0], high: [4.5, 4.5, 5.0], least: [0.0], most: [INF],
        optimum: 0.953528856757, at: [3.6504618, 3.6504617, 4.6204175],
        |x| {
            let f = (x[0] - x[1]).powi(2) + ((x[0] + x[1] - 10.0) / 3.0).powi(2) + (x[2] - 5.0).powi(2);
            (f, vec![-x[0] * x[0] - x[1] * x[1] - x[2] * x[2] + 48.0])
        }
    }
    HS66 {
        start: [0.0, 1.05, 2.9], low: [0.0; 3], high: [100.0, 100.0, 10.0], least: [0.0; 2], most: [INF; 2],
        optimum: 0.518163274159, at: [0.184126487951, 1.20216787321, 3.32732232258],
        |x| (x[2] * 0.2 - x[0] * 0.8, vec![x[1] - x[0].exp(), x[2] - x[1].exp()])
    }
    HS68 {
        start: [1.0; 4], low: [1e-4, 0.0, 0.0, 0.0], high: [100.0, 100.0, 2.0, 2.0], least: [0.0; 2], most: [0.0; 2],
        optimum: -0.920425020704, at: [0.0678587452312, 3.64617174165, 0.000266175189694, 0.894862212037],
        |x| inspection_plan(1e-4, 1.0, 24.0, x)
    }
    HS69 {
        start: [1.0; 4], low: [1e-4, 0.0, 0.0, 0.0], high: [100.0, 100.0, 2.0, 2.0], least: [0.0; 2], most: [0.0; 2],
        optimum: -956.712887064, at: [0.0293714180830, 1.19025343488, 0.233946796758, 0.791667815694],
        |x| inspection_plan(0.1, 1000.0, 4.0, x)
    }
    HS70 {
        start: [2.0, 4.0, 0.04, 2.0], low: [1e-5; 4], high: [100.0, 100.0, 1.0, 100.0], least: [0.0], most: [INF],
        optimum: 0.00749846356143, at: [12.2769537557, 4.63178796886, 0.312862470961, 2.02929031570],
        |x| {
            let mean = x[2] + (-x[2] + 1.0) * x[3];
            let peak = |share: T, order: T, rate: T, c: f64| {
                let scale = share * (order / 6.2832).sqrt() / ((order * 12.0).recip() + 1.0);
                let time = T::constant(c / 7.658);
                scale * (order * rate.ln() + (order - 1.0) * time.ln() + order - rate * order * time).exp()
            };
            let f = sum(TIMES.iter().zip(MEASURED).map(|(&c, y)| {
                (peak(x[2], x[1], mean, c) + peak(-x[2] + 1.0, x[0], mean / x[3], c) - y).powi(2)
            }));
            (f, vec![mean])
        }
    }
    HS71 {
        start: [1.0, 5.0, 5.0, 1.0], low: [1.0; 4], high: [5.0; 4], least: [25.0, 40.0], most: [INF, 40.0],
        optimum: 17.0140172895, at: [1.0, 4.74299937545, 3.82115032617, 1.37940824585],
        |x| {
            let squares = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
            (x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2], vec![x[0] * x[1] * x[2] * x[3], squares])
        }
    }
    HS72 {
        start: [1.0; 4], low: [0.001; 4], high: [400000.0, 300000.0, 200000.0, 100000.0],
        least: [0.0; 2], most: [INF; 2],
        optimum: 727.679376021, at: [193.407050141, 179.547504555, 185.018587841, 168.706233485],
        |x| {
            let inverse: Vec<T> = x.iter().map(|x| x.recip()).collect();
            let g = vec![
                -dot(&[4.0, 2.25, 1.0, 0.25], &inverse) + 0.0401,
                -dot(&[0.16, 0.36, 0.64, 0.64], &inverse) + 0.010085,
            ];
            (x[0] + x[1] + x[2] + x[3] + 1.0, g)
        }
    }
    HS73 {
        start: [1.0; 4], low: [0.0; 4], high: [INF; 4], least: [0.0, 0.0, 1.0], most: [INF, INF, 1.0],
        optimum: 29.8943781573, at: [0.635521568605, 0.0, 0.312701880754, 0.0517765506011],
        |x| {
            let squares: Vec<T> = x.iter().map(|&x| x * x).collect();
            let spread = dot(&[0.28, 0.19, 20.5, 0.62], &squares).sqrt();
            let g = vec![
                dot(&[2.3, 5.6, 11.1, 1.3], x) - 5.0,
                dot(&[12.0, 11.9, 41.8, 52.1], x) - spread * 1.645 - 21.0,
                x[0] + x[1] + x[2] + x[3],
            ];
            (dot(&[24.55, 26.75, 39.0, 40.5], x), g)
        }
    }
    HS74 {
        start: [0.0; 4], low: [0.0, 0.0, -0.55, -0.55], high: [1200.0, 1200.0, 0.55, 0.55],
        least: [-0.55, 0.0, 0.0, 0.0], most: [0.55, 0.0, 0.0, 0.0],
        optimum: 5126.49810934, at: [679.945319802, 1026.06713256, 0.118876364490, -0.396233553180],
        |x| three_generators(x)
    }
    HS75 {
        start: [0.0; 4], low: [0.0, 0.0, -0.48, -0.48], high: [1200.0, 1200.0, 0.48, 0.48],
        least: [-0.48, 0.0, 0.0, 0.0], most: [0.48, 0.0, 0.0, 0.0],
        optimum: 5174.41288686, at: [776.159220293, 925.194939196, 0.0511087936804, -0.428891137432],
        |x| three_generators(x)
    }
    HS76 {
        start: [0.5; 4], low: [0.0; 4], high: [INF; 4], least: [0.0; 3], most: [INF; 3],
        optimum: -103.0 / 22.0, at: [3.0 / 11.0, 23.0 / 11.0, 0.0, 6.0 / 11.0],
        |x| {
            let f = x[0] * x[0] + x[1] * x[1] * 0.5 + x[2] * x[2] + x[3] * x[3] * 0.5 - x[0] * x[2] + x[2] * x[3]
                - dot(&[1.0, 3.0, -1.0, 1.0], x);
            let g = vec![
                -dot(&[1.0, 2.0, 1.0, 1.0], x) + 5.0,
                -dot(&[3.0, 1.0, 2.0, -1.0], x) + 4.0,
                x[1] + x[2] * 4.0 - 1.5,
            ];
            (f, g)
        }
    }
    HS77 {
        start: [2.0; 5], low: [-INF; 5], high: [INF; 5],
        least: [2.0 * SQRT_2, 8.0 + SQRT_2], most: [2.0 * SQRT_2, 8.0 + SQRT_2],
        optimum: 0.241505128786, at: [1.16617219726, 1.18211138813, 1.38025704044, 1.50603627961, 0.610920257517],
        |x| {
            let f = (x[0] - 1.0).powi(2) + (x[0] - x[1]).powi(2) + (x[2] - 1.0).powi(2) + (x[3] - 1.0).powi(4)
                + (x[4] - 1.0).powi(6);
            (f, vec![x[0] * x[0] * x[3] + (x[3] - x[4]).sin(), x[1] + x[2].powi(4) * x[3] * x[3]])
        }
    }
    HS78 {
        start: [-2.0, 1.5, 2.0, -1.0, -1.0], low: [-INF; 5], high: [INF; 5],
        least: [10.0, 0.0, -1.0], most: [10.0, 0.0, -1.0],
        optimum: -2.91970040911, at: [-1.71714234230, 1.59570826805, 1.82724803488, -0.763642946600, -0.763643482853],
        |x| product_of_five(x)
    }
    HS79 {
        start: [2.0; 5], low: [-INF; 5], high: [INF; 5],
        least: [2.0 + 3.0 * SQRT_2, 2.0 * SQRT_2 - 2.0, 2.0], most: [2.0 + 3.0 * SQRT_2, 2.0 * SQRT_2 - 2.0, 2.0],
        optimum: 0.0787768208538, at: [1.19112745626, 1.36260316492, 1.47281793150, 1.63501661894, 1.67908143619],
        |x| {
            let f = (x[0] - 1.0).powi(2) + (x[0] - x[1]).powi(2) + (x[1] - x[2]).powi(2) + (x[2] - x[3]).powi(4)
                + (x[3] - x[4]).powi(4);
            (f, vec![x[0] + x[1] * x[1] + x[2].powi(3), x[1] - x[2] * x[2] + x[3], x[0] * x[4]])
        }
    }
    HS80 {
        start: [-2.0, 2.0, 2.0, -1.0, -1.0], low: [-2.3, -2.3, -3.2, -3.2, -3.2], high: [2.3, 2.3, 3.2, 3.2, 3.2],
        least: [10.0, 0.0, -1.0], most: [10.0, 0.0, -1.0],
        optimum: 0.0539498477624,
        at: [-1.71714294417, 1.59570896503, 1.82724691654, -0.763641279311, -0.763645016315],
        |x| {
            let (product, equations) = product_of_five(x);
            (product.exp(), equations)
        }
    }
    HS81 {
        start: [-2.0, 2.0, 2.0, -1.0, -1.0], low: [-2.3, -2.3, -3.2, -3.2, -3.2], high: [2.3, 2.3, 3.2, 3.2, 3.2],
        least: [10.0, 0.0, -1.0], most: [10.0, 0.0, -1.0],
        optimum: 0.0539498477749,
        at: [-1.71714240091, 1.59570833592, 1.82724792592, -0.763647440817, -0.763638975604],
        |x| {
            let (product, equations) = product_of_five(x);
            (product.exp() - (equations[2] + 1.0).powi(2) * 0.5, equations)
        }
    }
    HS83 {
        start: [78.0, 33.0, 27.0, 27.0, 27.0], low: [78.0, 33.0, 27.0, 27.0, 27.0],
        high: [102.0, 45.0, 45.0, 45.0, 45.0], least: [0.0, 90.0, 20.0], most: [92.0, 110.0, 25.0],
        optimum: -30665.5386717, at: [78.0, 33.0, 29.9952560253, 45.0, 36.7758129081],
        |x| {
            let f = x[2] * x[2] * 5.3578547 + x[0] * x[4] * 0.8356891 + x[0] * 37.293239 - 40792.141;
            let g = vec![
                x[1] * x[4] * 0.0056858 + x[0] * x[3] * 0.0006262 - x[2] * x[4] * 0.0022053 + 85.334407,
                x[1] * x[4] * 0.0071317 + x[0] * x[1] * 0.0029955 + x[2] * x[2] * 0.0021813 + 80.51249,
                x[2] * x[4] * 0.0047026 + x[0] * x[2] * 0.0012547 + x[2] * x[3] * 0.0019085 + 9.300961,
            ];
            (f, g)
        }
    }
    HS84 {
        start: [2.52, 2.0, 37.5, 9.25, 6.8], low: [0.0, 1.2, 20.0, 9.0, 6.5], high: [1000.0, 2.4, 60.0, 9.3, 7.0],
        least: [0.0; 3], most: [294000.0, 294000.0, 277200.0],
        optimum: -5280335.13306, at: [4.53743097466, 2.4, 60.0, 9.3, 7.0],
        |x| {
            let yields = SUGAR.map(|a| x[0] * (dot(&a[1..], &x[1..]) + a[0]));
            (-yields[0] + 24345.0, yields[1..].to_vec())
        }
    }
    /// No. 85, with the book's intermediate functions c and y. The book prints -1.90513375, not
    /// quite optimal.
    HS85 {
        start: [900.0, 80.0, 115.0, 267.0, 27.0], low: [704.4148, 68.6, 0.0, 193.0, 25.0],
        high: [906.3855, 288.88, 134.75, 287.0966, 84.1988],
        least: [
            0.0, 213.1, 17.505, 11.275, 214.228, 7.458, 0.961, 1.612, 0.146, 107.99, 922.693, 926.832, 18.766,
            1072.163, 8961.448, 0.063, 71084.33, 2802713.0, 0.0, 0.0, 0.0
        ],
        most: [
            INF, 405.23, 1053.6667, 35.03, 665.585, 584.463, 265.916, 7.046, 0.222, 273.366, 1286.105, 1444.046,
            537.141, 3247.039, 26844.086, 0.386, 140000.0, 12146108.0, INF, INF, INF
        ],
        optimum: -1.90515525853,
        at: [
            705.17453707, 68.6, 102.9, 282.324931594, 37.5841164258
        ],
        |x| {
            let y1 = x[1] + x[2] + 41.6;
            let c1 = x[3] * 0.024 - 4.62;
            let y2 = c1.recip() * 12.5 + 12.0;
            let c2 = x[0] * x[0] * 0.0003535 + x[0] * 0.5311 + y2 * x[0] * 0.08705;
            let c3 = x[0] * 0.052 + 78.0 + y2 * x[0] * 0.002377;
            let y3 = c2 / c3;
            let y4 = y3 * 19.0;
            let rest = x[0] - y3;
            let c4 = rest * 0.04782 + rest * rest * 0.1956 / x[1] + y4 * 0.6376 + y3 * 1.594;
            let c5 = x[1] * 100.0;
            let c6 = rest - y4;
            let c7 = -c4 / c5 + 0.95;
            let y5 = c6 * c7;
            let y6 = rest - y5 - y4;
            let c8 = (y5 + y4) * 0.995;
            let y7 = c8 / y1;
            let y8 = c8 / 3798.0;
            let c9 = y7 - y7 * 0.0663 / y8 - 0.3153;
            let y9 = c9.recip() * 96.82 + y1 * 0.321;
            let y10 = y5 * 1.29 + y4 * 1.258 + y3 * 2.29 + y6 * 1.71;
            let y11 = x[0] * 1.71 - y4 * 0.452 + y3 * 0.58;
            let c10 = 12.3 / 752.3;
            let c11 = y2 * x[0] * (1.75 * 0.995);
            let c12 = y10 * 0.995 + 1998.0;
            let y12 = x[0] * c10 + c11 / c12;
            let y13 = c12 - y2 * 1.75;
            let c17 = y9 + x[4];
            let y14 = x[1] * 64.4 + x[2] * 58.4 + c17.recip() * 146312.0 + 3623.0;
            let c13 = y10 * 0.995 + x[1] * 60.8 + x[3] * 48.0 - y14 * 0.1121 - 5095.0;
            let y15 = y13 / c13;
            let y16 = -y15 * 331000.0 + y13 * 40.0 - y15 * y13 * 61.0 + 148000.0;
            let c14 = y10 * 2324.0 - y2 * 28740000.0;
            let y17 = -y10 * 1328.0 - y11 * 531.0 + c14 / c12 + 14130000.0;
            let c15 = y13 / y15 - y13 / 0.52;
            let c16 = -y15 * 0.72 + 1.104;
            let f = -y17 * 5.843e-7 + y14 * 1.17e-4 + y13 * 2.358e-5 + y16 * 1.502e-6 + y12 * 0.0321 + y5 * 0.004324
                + c15 / c16 * 1e-4 + y2 / c12 * 37.48 + 0.1365;
            let mut g = vec![x[1] * 1.5 - x[2]];
            g.extend([y1, y2, y3, y4, y5, y6, y7, y8, y9, y10, y11, y12, y13, y14, y15, y16, y17]);
            g.extend([y4 - y5 * (0.28 / 0.72), -y2 * 3496.0 / c12 + 21.0, c17.recip() * 62212.0 - y1 - 110.6]);
            (f, g)
        }
    }
    HS86 {
        start: [0.0, 0.0, 0.0, 0.0, 1.0], low: [0.0; 5], high: [INF; 5], least: COLVILLE_B, most: [INF; 10],
        optimum: -32.3486789716, at: [0.3, 0.333467606492, 0.4, 0.428310104740, 0.223964873676],
        |x| {
            let squares = sum((0..5).map(|j| x[j] * dot(&COLVILLE_C[j], x)));
            let cubes = sum((0..5).map(|j| x[j].powi(3) * COLVILLE_D[j]));
            (dot(&COLVILLE_E, x) + squares + cubes, COLVILLE_A.iter().map(|a| dot(a, x)).collect())
        }
    }
    HS88 {
        start: [0.5, -0.5], low: [-INF; 2], high: [INF; 2], least: [0.0], most: [INF],
        optimum: 1.36265681, at: [1.07431872940, -0.456613707247],
        |x| heating(x)
    }
    HS89 {
        start: [0.5, -0.5, 0.5], low: [-INF; 3], high: [INF; 3], least: [0.0], most: [INF],
        optimum: 1.36265681, at: [1.07431872754, -0.456613706239, 0.0],
        |x| heating(x)
    }
    HS90 {
        start: [0.5, -0.5, 0.5, -0.5], low: [-INF; 4], high: [INF; 4], least: [0.0], most: [INF],
        optimum: 1.36265681, at: [0.708479399007, 2.37919269592e-5, 0.807599939006, -0.456613723294],
        |x| heating(x)
    }
    HS91 {
        start: [0.5, -0.5, 0.5, -0.5, 0.5], low: [-INF; 5], high: [INF; 5], least: [0.0], most: [INF],
        optimum: 1.36265681, at: [0.701892928031, 0.0, 0.813330836201, 0.456613707134, 0.0],
        |x| heating(x)
    }
    HS92 {
        start: [0.5, -0.5, 0.5, -0.5, 0.5, -0.5], low: [-INF; 6], high: [INF; 6], least: [0.0], most: [INF],
        optimum: 1.36265681,
        at: [0.494144465323, -1.03530473697e-5, 0.614950839550, -2.42186612731e-6, 0.729258528936, -0.456613099133],
        |x| heating(x)
    }
}
