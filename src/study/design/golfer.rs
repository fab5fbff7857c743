//! The default golfer of a design study.

use crate::error::Result;
use crate::parameters::Setup;
use crate::study::swings::{Correlation, Swings};
use crate::study::uncertainty::{Distribution, Uncertain};

/// Standard deviations from swing to swing; the setup gives the means.
const SCATTER: [(&str, &str); 6] = [
    ("swing.speed", "3.29 mph"),
    ("swing.attack_angle", "2.05 deg"),
    ("swing.path", "2.28 deg"),
    ("swing.face_angle", "4.17 deg"),
    ("strike.toe", "8.2 mm"),
    ("strike.high", "6 mm"),
];

/// Correlation of path and face angle. It gives the measured scatter of face to path (face angle −
/// path), 4.07°.
const PATH_WITH_FACE: f64 = 0.317;

/// Distance of the truncation from the mean, in standard deviations. Swings beyond it hit the
/// ground, or send the ball far off the fairway.
const WITHIN: f64 = 2.0;

/// The standard deviations of the scatter, with their sources.
pub const GOLFER: &str = "speed 3.29 mph, attack angle 2.05°, path 2.28°, face angle 4.17°, face \
                          to path 4.07° (58 drives of one golfer, Bliss & Langdown 2026); strike \
                          8.2 mm to heel and toe, 6 mm up and down (8 drives of another golfer); \
                          truncated at two standard deviations";

/// Swings with the scatter of a measured golfer, about the swing of a setup.
///
/// # Errors
/// The errors of [`Setup::variable`] if the setup gives the launch, so that it has no club.
pub fn golfer(setup: &Setup<f64>) -> Result<Swings> {
    let inputs = SCATTER.iter().map(|(name, deviation)| {
        let parameter = setup.variable(name)?;
        let (mean, deviation) = (
            setup.value(parameter).unwrap_or_default(),
            parameter.quantity.read(deviation).unwrap_or_default(),
        );
        Ok(Uncertain {
            parameter,
            distribution: truncated_with_deviation(mean, deviation),
        })
    });
    let inputs = inputs.collect::<Result<Vec<_>>>()?;
    let between = [
        setup.variable("swing.path")?,
        setup.variable("swing.face_angle")?,
    ];
    Swings::distributed(inputs, &[Correlation::new(between, PATH_WITH_FACE)?])
}

/// Truncated normal distribution that has the standard deviation `deviation` after truncation.
/// Bisection finds its larger standard deviation before truncation.
fn truncated_with_deviation(mean: f64, deviation: f64) -> Distribution {
    let of = |mean: f64, deviation: f64, wider: f64| {
        let [low, high] = [mean - WITHIN * deviation, mean + WITHIN * deviation];
        Distribution::Truncated {
            mean,
            deviation: wider * deviation,
            low,
            high,
        }
    };
    // bisect the deviation before truncation: the deviation after truncation increases with it, up
    // to WITHIN/√3 (a uniform distribution)
    let (mut narrow, mut wide) = (1.0, 4.0);
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = 0.5 * (narrow + wide);
        if of(0.0, 1.0, middle).deviation() < 1.0 {
            narrow = middle;
        } else {
            wide = middle;
        }
    }
    of(mean, deviation, narrow)
}

#[cfg(test)]
mod tests {
    use super::{PATH_WITH_FACE, SCATTER, golfer};
    use crate::parameters::Setup;
    use crate::study::swings::Swings;

    #[test]
    fn the_golfer_scatters_as_measured() {
        let Swings::Distributed { inputs, .. } = golfer(&Setup::modern_driver()).unwrap() else {
            unreachable!()
        };
        for (input, (name, deviation)) in inputs.iter().zip(SCATTER) {
            let published = input.parameter.quantity.read(deviation).unwrap();
            let found = input.distribution.deviation();
            assert!(
                (found / published - 1.0).abs() < 1e-10,
                "{name}: {found} {published}"
            );
        }
    }

    #[test]
    fn published_scatter_of_face_to_path_follows_from_the_correlation() {
        let (path, face) = (2.28_f64, 4.17_f64);
        let variance = path * path + face * face - 2.0 * PATH_WITH_FACE * path * face;
        assert!(
            (variance.sqrt() - 4.07).abs() < 0.005,
            "{}",
            variance.sqrt()
        );
    }
}
