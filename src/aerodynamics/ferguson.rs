use super::origin::{horner, polynomial};
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, RangeEnd, Stream};
use crate::number::{Numbers, inlined, smooth_clamp_above};
use crate::parameters::{Ferguson, LawVariable};

/// Spin ratios of the measured shots. Below this range a cubic replaces the lift coefficient,
/// because the formula gives lift without spin.
const MEASURED: [f64; 2] = [0.02, 0.75];
/// Width of the upper clamp of the spin ratio. Without the clamp, the lift would be negative above
/// s = 1.09, and the drag above s = 1.25.
const UPPER_CLAMP_WIDTH: f64 = 0.2;

/// C_D = cd0 + cd1 s + cd2 s², C_L = cl0 + cl1 s + cl2 s²: Ferguson, McNally & McPhee (2022),
/// fitted to 1040 radar flights with 0.02 < s < 0.75.
impl<T: Numbers> AerodynamicLaw<T> for Ferguson<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        T::not_inlined(inlined!(move || {
            let [low, high] = MEASURED;
            let s = smooth_clamp_above(stream.spin_ratio(), high, UPPER_CLAMP_WIDTH);
            let (drag, lift) = (
                [self.cd0, self.cd1, self.cd2],
                [self.cl0, self.cl1, self.cl2],
            );
            Coefficients {
                drag: horner(drag, s),
                lift: polynomial(lift, low, s),
            }
        }))
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Ferguson, McNally & McPhee",
                year: Some(2022),
                ball: Some("Pro V1 (2021)"),
                source: "ISEA 2022, doi 10.5703/1288284317493",
            },
            fitted: Fitted {
                spin_ratio: Some(MEASURED),
                to: "1040 radar flights, Ferguson, McNally & McPhee 2022",
                held: &[(LawVariable::SpinRatio, RangeEnd::High)],
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: true,
        }
    }
}
