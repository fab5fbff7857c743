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
        // below the least spin the lift falls to 0
        let lift_onset = self.table.grid.lift_onset.map(|(variable, _)| variable);
        let is_held_below = |variable| lift_onset != Some(variable);
        let held = [
            [is_held_below(AxisVariable::SpinRatio), true],
            [is_held_below(AxisVariable::Spin), true],
            [true; 2],
            [true; 2],
        ];
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
                held,
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: self.table.grid.has_slope_at_zero_spin(),
        }
    }
}
