use super::origin::polynomial;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::{Numbers, inlined};
use crate::parameters::MacdonaldHanzely;

/// Spin ratio below which a cubic replaces the lift coefficient, because the law gives lift without
/// spin. Usual drives have larger spin ratios.
const SMOOTH_BELOW: f64 = 0.02;

/// C_D = cd_speed/v, C_L = cl_speed/v: forces proportional to the speed, independent of the spin
/// (MacDonald & Hanzely 1991).
impl<T: Numbers> AerodynamicLaw<T> for MacdonaldHanzely<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        T::not_inlined(inlined!(move || {
            let per_speed = stream.speed.recip();
            let lift = polynomial(
                [self.cl_speed * per_speed],
                SMOOTH_BELOW,
                stream.spin_ratio(),
            );
            Coefficients {
                drag: self.cd_speed * per_speed,
                lift,
            }
        }))
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "MacDonald & Hanzely",
                year: Some(1991),
                ball: None,
                source: "The physics of the drive in golf, Am. J. Phys. 59; as golfmodel \
                         (golf_ballstics.py) quotes it",
            },
            fitted: Fitted::UNKNOWN,
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: false,
        }
    }
}
