use super::origin::CubicOrigin;
use super::{AerodynamicLaw, Coefficients, Fitted, Published, Stream};
use crate::number::{Numbers, held_above, inlined};
use crate::parameters::NaruoMizota;

/// The spin ratios of the measurements. Below, the lift is replaced: the formula would leave lift without spin, in no direction.
const MEASURED: [f64; 2] = [0.03, 1.13];
/// Above, the spin ratio is held over this width: the fourth powers would grow without end.
const HELD_OVER: f64 = 0.2;

/// C_D = cd0 + cd1 s + … + cd4 s⁴, C_L = cl0 + cl1 s + … + cl4 s⁴: Naruo, Mizota & Shimozono (2004), in a wind tunnel for
/// 0.03 < s < 1.13 and Re > 7.1e4.
impl<T: Numbers> AerodynamicLaw<T> for NaruoMizota<T> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        T::outlined(inlined!(|| {
            let [low, high] = MEASURED;
            let s = held_above(stream.spin_ratio, high, HELD_OVER);
            let drag = self.cd4.mul_add(s, self.cd3).mul_add(s, self.cd2).mul_add(s, self.cd1).mul_add(s, self.cd0);
            let smooth = inlined!(|| {
                let powers = [low, low * low, low * low * low, low * low * low * low];
                let [one, two, three, four] =
                    [self.cl1 * powers[0], self.cl2 * powers[1], self.cl3 * powers[2], self.cl4 * powers[3]];
                let origin = CubicOrigin {
                    join: low,
                    value: self.cl0 + one + two + three + four,
                    slope: one + two * 2.0 + three * 3.0 + four * 4.0,
                    curvature: two * 2.0 + three * 6.0 + four * 12.0,
                };
                origin.lift(s)
            });
            let lift = T::choose(
                s.below(low),
                smooth,
                inlined!(|| self
                    .cl4
                    .mul_add(s, self.cl3)
                    .mul_add(s, self.cl2)
                    .mul_add(s, self.cl1)
                    .mul_add(s, self.cl0)),
            );
            Coefficients { drag, lift }
        }))
    }

    fn fitted(&self) -> Fitted {
        Fitted {
            spin_ratio: Some(MEASURED),
            reynolds: Some([7.1e4, f64::INFINITY]),
            to: "a wind tunnel, Naruo, Mizota & Shimozono 2004",
            held: [[false, true], [false; 2], [false; 2], [false; 2]],
            ..Fitted::UNKNOWN
        }
    }

    fn published(&self) -> Published {
        Published {
            authors: "Naruo, Mizota & Shimozono",
            year: Some(2004),
            ball: Some("Bridgestone Skyway SD432"),
            source: "wind tunnel; the polynomials as others transcribe them, docs/sources.md",
        }
    }
}
