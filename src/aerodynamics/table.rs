use super::gridded::grid_coefficients;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, RangeEnd, Stream};
use crate::number::Numbers;
use crate::parameters::{LawVariable, Table};

/// All ends of the axes of a table.
const HELD: &[(LawVariable, RangeEnd)] = &[
    (LawVariable::SpinRatio, RangeEnd::Low),
    (LawVariable::SpinRatio, RangeEnd::High),
    (LawVariable::Spin, RangeEnd::Low),
    (LawVariable::Spin, RangeEnd::High),
    (LawVariable::Reynolds, RangeEnd::Low),
    (LawVariable::Reynolds, RangeEnd::High),
    (LawVariable::Speed, RangeEnd::Low),
    (LawVariable::Speed, RangeEnd::High),
];
/// All ends except the lower end of the axis of spin or spin ratio.
const HELD_ABOVE_LEAST_SPIN: &[(LawVariable, RangeEnd)] = &[
    (LawVariable::SpinRatio, RangeEnd::High),
    (LawVariable::Spin, RangeEnd::High),
    (LawVariable::Reynolds, RangeEnd::Low),
    (LawVariable::Reynolds, RangeEnd::High),
    (LawVariable::Speed, RangeEnd::Low),
    (LawVariable::Speed, RangeEnd::High),
];

/// C_D = cd_factor D, C_L = cl_factor L, with the splines D and L through a user's own table,
/// `aero.table`.
impl<T: Numbers> AerodynamicLaw<T> for Table<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        grid_coefficients(
            &self.table.grid,
            [self.factors.cd_factor, self.factors.cl_factor],
            stream,
        )
    }

    fn properties(&self) -> LawProperties {
        let range = |variable| {
            self.table
                .axes()
                .find(|axis| axis.variable == variable)
                .map(|axis| axis.ends)
        };
        LawProperties {
            published: Published {
                authors: "your own table",
                year: None,
                ball: None,
                source: &self.table.file,
            },
            fitted: Fitted {
                spin_ratio: range(LawVariable::SpinRatio),
                spin: range(LawVariable::Spin),
                reynolds: range(LawVariable::Reynolds),
                speed: range(LawVariable::Speed),
                to: &self.table.description,
                held: match self.table.grid.lift_onset {
                    // below the least spin the lift falls to 0
                    Some(_) => HELD_ABOVE_LEAST_SPIN,
                    None => HELD,
                },
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: self.table.grid.has_slope_at_zero_spin(),
        }
    }
}
