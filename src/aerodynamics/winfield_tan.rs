use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::Numbers;
use crate::parameters::WinfieldTan;

/// Middle v₀ of the speeds of the flights in Winfield & Tan (1994), m/s.
const MIDDLE: f64 = 50.0;
/// Divisor of v − v₀ in u, m/s: about half the range of speeds in Winfield & Tan (1994).
const SPREAD: f64 = 20.0;

/// With x = s √(v/v₀) and u = (v − v₀)/20 m/s: C_D = (cd0 + cd1 x + cd2 x² + cd3 x³)(1 + cd_v1 u +
/// cd_v2 u²), C_L = (cl_hill x/(x + cl_half) + cl_slope x)/(1 + ((v − cl_speed)/cl_width)²).
/// Winfield & Tan (1994) use curves of Aoyama (1990), which they do not print. This law is fitted
/// to their tables for 25 < v < 68 m/s and 0.02 < s < 0.35. It is smooth everywhere. C_L is 0
/// without spin, and rises with the spin.
impl<T: Numbers> AerodynamicLaw<T> for WinfieldTan<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        let x = stream.spin_ratio() * (stream.speed * (1.0 / MIDDLE)).sqrt();
        let u = (stream.speed - MIDDLE) * (1.0 / SPREAD);
        let by_spin = self
            .cd3
            .mul_add(x, self.cd2)
            .mul_add(x, self.cd1)
            .mul_add(x, self.cd0);
        let by_speed = self
            .cd_v2
            .mul_add(u, self.cd_v1)
            .mul_add(u, T::constant(1.0));
        let off = (stream.speed - self.cl_speed) / self.cl_width;
        let rise = self.cl_hill / (x + self.cl_half) + self.cl_slope;
        Coefficients {
            drag: by_spin * by_speed,
            lift: x * rise / off.mul_add(off, T::constant(1.0)),
        }
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Winfield & Tan, from curves by Aoyama (1990)",
                year: Some(1994),
                ball: None,
                source: "longdrive: recovered from the paper's tables, docs/validation.md",
            },
            fitted: Fitted {
                spin_ratio: Some([0.02, 0.35]),
                speed: Some([25.0, 68.0]),
                to: "the tables of Winfield & Tan 1994",
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: None,
            has_corner_at_zero_spin: true,
        }
    }
}
