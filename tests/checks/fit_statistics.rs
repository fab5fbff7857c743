//! Covariance and identifiability of fitted parameters, for Jacobians of a few rows.

use longdrive::optimize::least_squares::{Loss, Rows};
use longdrive::study::calibrate::{FitRange, FitStatistics, SigmaOrigin};

fn of(rows: &Rows, fitted: &[FitRange], origin: SigmaOrigin) -> FitStatistics {
    FitStatistics::new(rows, fitted, origin, 1e-12, Loss::Squares).unwrap()
}

fn free(width: f64) -> FitRange {
    FitRange {
        is_free: true,
        width,
    }
}

/// A line is fitted to values of unit uncertainty at t = 0, 1, 2. The expected covariance is
/// (JᵀJ)⁻¹, computed by hand. A third column proportional to the second is confounded with it, and
/// affects neither the first parameter nor χ².
#[test]
fn exact_covariance_of_a_line_and_confounded_columns_named() {
    let jacobian: Vec<Vec<f64>> = [0.0, 1.0, 2.0].iter().map(|t| vec![1.0, *t]).collect();
    let rows = Rows {
        residuals: vec![0.5, -1.0, 0.5],
        jacobian,
    };
    let line = of(&rows, &[free(1e9); 2], SigmaOrigin::Stated);
    let expected = [(0, 0, 5.0 / 6.0), (0, 1, -0.5), (1, 0, -0.5), (1, 1, 0.5)];
    for (a, b, exact) in expected {
        assert!((line.covariance[a][b].unwrap() - exact).abs() < 1e-12);
    }
    assert_eq!((line.degrees_of_freedom, line.chi_square), (1, 1.5));
    // P(χ²₁ > 1.5) = erfc(√0.75)
    assert!((line.probability.unwrap() - 0.220_671_361_916_928_7).abs() < 1e-9);
    let scaled = of(&rows, &[free(1e9); 2], SigmaOrigin::Instruments);
    assert!((scaled.covariance[1][1].unwrap() - 0.75).abs() < 1e-12);
    assert!((scaled.coverage_factor - 12.706_204_736).abs() < 1e-6); // Student's t, one degree of freedom

    let doubled = rows
        .jacobian
        .iter()
        .map(|row| vec![row[0], row[1], 3.0 * row[1]])
        .collect();
    let rows = Rows {
        jacobian: doubled,
        ..rows
    };
    let both = of(&rows, &[free(1e9); 3], SigmaOrigin::Stated);
    assert_eq!(both.undetermined.len(), 1);
    let places: Vec<usize> = both.undetermined[0]
        .parts
        .iter()
        .map(|(at, _)| *at)
        .collect();
    assert_eq!(places, [1, 2]);
    assert!((both.undetermined[0].parts[0].1 / both.undetermined[0].parts[1].1 + 3.0).abs() < 1e-9);
    assert!((both.standard_error(0).unwrap() - (5.0_f64 / 6.0).sqrt()).abs() < 1e-9);
    assert_eq!((both.standard_error(1), both.degrees_of_freedom), (None, 1));
}
/// Two points and a line: zero degrees of freedom, but every direction is determined.
#[test]
fn parameters_with_as_many_values_are_determined() {
    let rows = Rows {
        residuals: vec![0.0, 1e-15],
        jacobian: vec![vec![1.0, 0.0], vec![1.0, 1.0]],
    };
    for (uncertainties, scale) in [
        (SigmaOrigin::Stated, Some(1.0)),
        (SigmaOrigin::Instruments, Some(1.0)),
        (SigmaOrigin::Weights, None),
    ] {
        let line = of(&rows, &[free(1e9); 2], uncertainties);
        assert!(
            line.undetermined.is_empty() && line.is_exact && !line.is_scaled,
            "{line:?}"
        );
        assert_eq!(
            (line.scale, line.degrees_of_freedom, line.probability),
            (scale, 0, None)
        );
        // the slope is the difference of two values of variance 1, so its variance is 2
        assert_eq!(
            line.covariance[1][1].map(|variance| (variance - 2.0).abs() < 1e-12),
            scale.map(|_| true)
        );
        assert!(line.determines(0) && line.determines(1));
    }
}

/// The columns differ by 1e-4. The standard error is then 1e4/√2, more than
/// the width of a narrow range.
#[test]
fn standard_errors_beyond_the_range_are_no_answers() {
    let rows = Rows {
        residuals: vec![0.3, -0.3, 0.3, -0.3],
        jacobian: vec![
            vec![1.0, 1.0001],
            vec![1.0, 0.9999],
            vec![1.0, 1.0],
            vec![1.0, 1.0],
        ],
    };
    let wide = of(&rows, &[free(1e6); 2], SigmaOrigin::Stated);
    assert!(
        wide.undetermined.is_empty()
            && (wide.standard_error(1).unwrap() / 7071.0 - 1.0).abs() < 1e-3,
        "{wide:?}"
    );
    let narrow = of(&rows, &[free(3.0); 2], SigmaOrigin::Stated);
    assert_eq!(narrow.undetermined.len(), 1);
    assert!(
        narrow.undetermined[0].standard_error.unwrap() > 1e3,
        "{narrow:?}"
    );
    assert_eq!(
        (narrow.standard_error(0), narrow.standard_error(1)),
        (None, None)
    );
}

/// The columns have a correlation of 0.6. Standard errors of 1.12 and 0.56 along two directions
/// combine to 1.25.
#[test]
fn standard_errors_of_two_directions_combine() {
    let rows = Rows {
        residuals: vec![0.3, -0.3],
        jacobian: vec![vec![1.0, 0.6], vec![0.0, 0.8]],
    };
    let wide = of(&rows, &[free(1.3), free(100.0)], SigmaOrigin::Stated);
    assert!(
        wide.determines(0) && (wide.standard_error(0).unwrap() - 1.25).abs() < 1e-12,
        "{wide:?}"
    );
    let narrow = of(&rows, &[free(1.2), free(100.0)], SigmaOrigin::Stated);
    assert!(
        !narrow.determines(0) && narrow.undetermined.len() == 1,
        "{narrow:?}"
    );
}

#[test]
fn parameters_without_influence_are_undetermined_on_a_bound_too() {
    let held = FitRange {
        is_free: false,
        width: 1.0,
    };
    let blind = Rows {
        residuals: vec![0.5, -0.5],
        jacobian: vec![vec![1.0, 0.0], vec![1.0, 0.0]],
    };
    let found = of(&blind, &[free(1e9), held], SigmaOrigin::Stated);
    assert!(found.determines(0) && !found.determines(1), "{found:?}");
    // the gradient presses the second parameter against its bound
    let pressed = Rows {
        residuals: vec![0.5, -0.5],
        jacobian: vec![vec![1.0, 40.0], vec![1.0, -40.0]],
    };
    assert!(
        of(&pressed, &[free(1e9), held], SigmaOrigin::Stated)
            .undetermined
            .is_empty()
    );
}

/// The mean of five values with Huber's loss (k = 1.345): ψ = −1.345, −0.5, 0, 0.5, 1.345, so
/// Σψ²/ν = 4.11805/4 and mean ψ′ = 3/5. The covariance is Σψ²/ν/(mean ψ′)²/5 (Huber 1981, section
/// 7.6), also for stated uncertainties.
#[test]
fn published_covariance_of_a_mean_with_hubers_loss() {
    let rows = Rows {
        residuals: vec![-3.0, -0.5, 0.0, 0.5, 4.0],
        jacobian: vec![vec![1.0]; 5],
    };
    for origin in [SigmaOrigin::Stated, SigmaOrigin::Weights] {
        let mean = FitStatistics::new(&rows, &[free(1e9)], origin, 1e-12, Loss::HUBER).unwrap();
        let exact = 4.11805 / 4.0 / 0.36 / 5.0;
        assert!((mean.covariance[0][0].unwrap() - exact).abs() < 1e-12);
        assert!(mean.is_scaled && mean.probability.is_none(), "{mean:?}");
    }
    // the size of every residual exceeds k: the loss has no curvature
    let rows = Rows {
        residuals: vec![-3.0, -2.0, 2.0, 4.0],
        jacobian: vec![vec![1.0]; 4],
    };
    let origin = SigmaOrigin::Stated;
    let mean = FitStatistics::new(&rows, &[free(1e9)], origin, 1e-12, Loss::HUBER).unwrap();
    assert_eq!((mean.scale, mean.covariance[0][0]), (None, None));
}
