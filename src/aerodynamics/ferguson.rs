use super::origin::CubicOrigin;
use super::{AerodynamicLaw, Coefficients, Fitted, Published, Stream};
use crate::number::{Numbers, held_above, inlined};
use crate::parameters::Ferguson;

/// The spin ratios of the measured shots. Below, the lift is replaced: the formula would leave lift without spin, in no direction.
const MEASURED: [f64; 2] = [0.02, 0.75];
/// Above, the spin ratio is held over this width: the parabolas would fall below no lift at s = 1.09, and below no drag at s = 1.25.
const HELD_OVER: f64 = 0.2;

/// C_D = cd0 + cd1 s + cd2 s², C_L = cl0 + cl1 s + cl2 s²: Ferguson, McNally & McPhee (2022), fitted to 1040
/// radar flights with 0.02 < s < 0.75.
impl<T: Numbers> AerodynamicLaw<T> for Ferguson<T> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        T::outlined(inlined!(|| {
            let [low, high] = MEASURED;
            let s = held_above(stream.spin_ratio, high, HELD_OVER);
            let drag = self.cd2.mul_add(s, self.cd1).mul_add(s, self.cd0);
            let smooth = inlined!(|| {
                let (linear, quadratic) = (self.cl1 * low, self.cl2 * (low * low));
                let origin = CubicOrigin {
                    join: low,
                    value: self.cl0 + linear + quadratic,
                    slope: linear + quadratic * 2.0,
                    curvature: quadratic * 2.0,
                };
                origin.lift(s)
            });
            let lift = T::choose(s.below(low), smooth, inlined!(|| self.cl2.mul_add(s, self.cl1).mul_add(s, self.cl0)));
            Coefficients { drag, lift }
        }))
    }

    fn fitted(&self) -> Fitted {
        Fitted {
            spin_ratio: Some(MEASURED),
            to: "1040 radar flights, Ferguson, McNally & McPhee 2022",
            held: [[false, true], [false; 2], [false; 2], [false; 2]],
            ..Fitted::UNKNOWN
        }
    }

    fn published(&self) -> Published {
        Published {
            authors: "Ferguson, McNally & McPhee",
            year: Some(2022),
            ball: Some("Pro V1 (2021)"),
            source: "ISEA 2022, doi 10.5703/1288284317493",
        }
    }
}
