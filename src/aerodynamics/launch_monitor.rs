use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::Numbers;
use crate::parameters::LaunchMonitor;

/// C_D = cd0 + cd1 s_c + cd2 s_c² + cd_re (Re/10⁵ − 1.5), s_c = s_cap tanh(s/s_cap); C_L = cl_max
/// cl_rate s/(1 + cl_rate s). The law is fitted to the predictions of a launch monitor for 0.06 < s
/// < 0.33 and 7e4 < Re < 2.3e5. It is smooth everywhere, and gives no lift without spin.
impl<T: Numbers> AerodynamicLaw<T> for LaunchMonitor<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        let s = stream.spin_ratio();
        // s_c/s_cap
        let capped = (s * self.s_cap.recip()).tanh();
        let (linear, square) = (self.cd1 * self.s_cap, self.cd2 * self.s_cap * self.s_cap);
        let base = self.cd_re.mul_add(stream.reynolds() * 1e-5 - 1.5, self.cd0);
        let drag = square.mul_add(capped, linear).mul_add(capped, base);
        let hill = self.cl_rate * s;
        Coefficients {
            drag,
            lift: self.cl_max * hill / (hill + 1.0),
        }
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "longdrive",
                year: None,
                ball: None,
                source: "fit to 400 shots of TrackMan's indoor flight model, docs/sources.md",
            },
            fitted: Fitted {
                spin_ratio: Some([0.06, 0.33]),
                reynolds: Some([7e4, 2.3e5]),
                to: "a launch monitor's predictions for 400 shots",
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: None,
            has_corner_at_zero_spin: true,
        }
    }
}
