use super::gridded::grid_coefficients;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, Stream};
use crate::number::Numbers;
use crate::parameters::{AxisVariable, Table};

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
                spin_ratio: range(AxisVariable::SpinRatio),
                spin: range(AxisVariable::Spin),
                reynolds: range(AxisVariable::Reynolds),
                speed: range(AxisVariable::Speed),
                to: &self.table.description,
                held: [[true; 2]; 4],
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: self.table.grid.has_slope_at_zero_spin(),
        }
    }
}
