//! Finite differences of known functions by `derivative::check`: samples, error estimates, and the
//! verdict on remainders.

use longdrive::derivative::check::{Ladder, STEP_EXPONENTS, Side, taylor_slopes};

fn ladder(at: f64, scale: f64, f: impl Fn(f64) -> f64) -> Ladder {
    Ladder::sample(at, scale, STEP_EXPONENTS, &mut |x| vec![f(x)])
        .pop()
        .unwrap()
}

#[test]
fn exact_truth_is_within_the_error_estimates_of_differences() {
    type Case = (&'static str, fn(f64) -> f64, f64, f64);
    let cases: [Case; 7] = [
        ("exp", f64::exp, 0.7, 0.7_f64.exp()),
        (
            "a polynomial, of which four steps leave nothing",
            |x| x.powi(7),
            1.0,
            7.0,
        ),
        (
            "sin at a top",
            f64::sin,
            std::f64::consts::FRAC_PI_2,
            std::f64::consts::FRAC_PI_2.cos(),
        ),
        ("large offset", |x| 1e8 + x * x, 1.5, 3.0),
        (
            "steep",
            |x| (20.0 * x).tanh(),
            0.02,
            20.0 / 0.4_f64.cosh().powi(2),
        ),
        ("constant", |_| 3.0, 1.0, 0.0),
        (
            "a ripple far below the first step",
            |x| x + 1e-7 * (1e4 * x).sin(),
            0.0,
            1.001,
        ),
    ];
    for (name, f, at, exact) in cases {
        let scale = if at == 0.0 { 1.0 } else { at };
        for side in [Side::Both, Side::Below, Side::Above] {
            let found = ladder(at, scale, f).slope(side, 0.0).unwrap();
            assert!(
                (found.value - exact).abs() <= 2.0 * found.uncertainty,
                "{name}, {side:?}: {found:?}, not {exact}"
            );
            let most = if side == Side::Both { 1e-6 } else { 1e-4 };
            assert!(
                found.uncertainty <= most * exact.abs().max(1.0),
                "{name}, {side:?}: {found:?}"
            );
        }
    }
}

/// The function has noise in its last digits, and the point is at the end of its range. One-sided
/// differences detect the noise as well as central differences.
#[test]
fn rounding_is_detected_from_one_side() {
    let noise = |x: f64| 1e-12 * ((x * 1e15).sin() * 43_758.545_3).fract();
    let rounding = |lowest: f64| {
        let f = |x: f64| {
            if x < lowest {
                f64::NAN
            } else {
                1.0 + x + x * x + noise(x)
            }
        };
        ladder(1.0, 1.0, f).rounding()
    };
    for rounding in [rounding(1.0), rounding(0.0)] {
        assert!((1e-13..3e-12).contains(&rounding), "{rounding}");
    }
    let smooth = ladder(1.0, 1.0, |x| if x < 1.0 { f64::NAN } else { 1.0 + x });
    assert!(smooth.rounding() < 5e-15, "{}", smooth.rounding());
}

/// sin x as the difference of two terms, each a hundred thousand times as large. At 0 both terms
/// are exact.
#[test]
fn rounding_of_cancelling_parts_is_no_remainder_and_a_wrong_slope_is() {
    let ladder =
        ladder(0.0, 1.0, |x| 100_001.0 * x.sin() - 100_000.0 * x.sin()).with_rounding_size(1e5);
    for (first, expected) in [(1.0, [1.0, 3.0, 3.0]), (1.0 + 1e-6, [1.0, 1.0, 1.0])] {
        for (found, exact) in taylor_slopes(&ladder, first, 0.0)
            .map(Option::unwrap)
            .into_iter()
            .zip(expected)
        {
            assert!((found - exact).abs() < 0.05, "{found} {exact}");
        }
    }
}
