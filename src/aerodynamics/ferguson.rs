use super::origin::CubicOrigin;
use super::{AerodynamicLaw, Coefficients, Stream};
use crate::number::Number;
use crate::parameters::Ferguson;

/// Below this spin ratio, the lowest of the measured shots, the lift is replaced: the formula would leave
/// lift without spin, in no direction.
const SMOOTH_BELOW: f64 = 0.02;

/// C_D = cd0 + cd1 s + cd2 s², C_L = cl0 + cl1 s + cl2 s²: Ferguson, McNally & McPhee (2022), fitted to 1040
/// radar flights with 0.02 < s < 0.75.
impl<T: Number> AerodynamicLaw<T> for Ferguson<T> {
    #[inline]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        let s = stream.spin_ratio();
        let drag = self.cd0 + (self.cd1 + self.cd2 * s) * s;
        let lift = if s.re() < SMOOTH_BELOW {
            let (linear, quadratic) = (self.cl1 * SMOOTH_BELOW, self.cl2 * (SMOOTH_BELOW * SMOOTH_BELOW));
            let origin = CubicOrigin {
                join: SMOOTH_BELOW,
                value: self.cl0 + linear + quadratic,
                slope: linear + quadratic * 2.0,
                curvature: quadratic * 2.0,
            };
            origin.lift(s)
        } else {
            self.cl0 + (self.cl1 + self.cl2 * s) * s
        };
        Coefficients { drag, lift }
    }
}
