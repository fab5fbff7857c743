use super::origin::CubicOrigin;
use super::{AerodynamicLaw, Coefficients, Fitted, Published, Stream};
use crate::number::{Numbers, inlined};
use crate::parameters::SmitsSmith;
use std::f64::consts::PI;

/// Below this spin ratio s^cl_exp is replaced: its slope at zero spin is infinite.
const SMOOTH_BELOW: f64 = 0.001;

/// C_D = cd1 + cd2 s + cd3 sin(π (Re − re1)/re2), C_L = cl1 s^cl_exp: Smits & Smith (1994), fitted for
/// 7e4 < Re < 2.1e5 and 0.08 < s < 0.2.
impl<T: Numbers> AerodynamicLaw<T> for SmitsSmith<T> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        let s = stream.spin_ratio;
        let phase = (stream.reynolds - self.re1) * PI / self.re2;
        let drag = self.cd1 + self.cd2 * s + self.cd3 * phase.sin();
        let p = self.cl_exp;
        let smooth = inlined(
            #[inline(always)]
            || {
                let value = self.cl1 * (p * SMOOTH_BELOW.ln()).exp();
                let slope = value * p;
                let origin = CubicOrigin { join: SMOOTH_BELOW, value, slope, curvature: slope * (p - 1.0) };
                origin.lift(s)
            },
        );
        let lift = T::choose(
            s.below(SMOOTH_BELOW),
            smooth,
            #[inline(always)]
            || self.cl1 * (p * s.ln()).exp(),
        );
        Coefficients { drag, lift }
    }

    fn fitted(&self) -> Fitted {
        Fitted {
            spin_ratio: Some([0.08, 0.2]),
            spin: None,
            reynolds: Some([7e4, 2.1e5]),
            speed: None,
            to: "a wind tunnel, Smits & Smith 1994",
        }
    }

    fn published(&self) -> Published {
        Published { authors: "Smits & Smith", year: Some(1994), ball: None, source: "wind tunnel; docs/sources.md" }
    }
}
