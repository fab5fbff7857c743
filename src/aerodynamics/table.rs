use super::gridded::gridded;
use super::{AerodynamicLaw, Coefficients, Fitted, Published, Stream};
use crate::number::Numbers;
use crate::parameters::{Along, Table};

/// C_D = cd_factor D, C_L = cl_factor L: splines through a user's own table, `aero.table`.
impl<T: Numbers> AerodynamicLaw<T> for Table<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        gridded(
            self.table.grid(),
            [self.factors.cd_factor, self.factors.cl_factor],
            stream,
        )
    }

    fn has_corner_at_zero_spin(&self) -> bool {
        // C_D is held below the least spin of a table, unless that is 0
        self.table.grid().begins.is_none()
    }

    fn continuous_derivatives(&self) -> Option<u32> {
        Some(2)
    }

    fn fitted(&self) -> Fitted {
        let grid = self.table.grid();
        let range = |along| {
            grid.axes()
                .find(|axis| axis.along == along)
                .map(|axis| axis.ends)
        };
        Fitted {
            spin_ratio: range(Along::SpinRatio),
            spin: range(Along::Spin),
            reynolds: range(Along::Reynolds),
            speed: range(Along::Speed),
            to: self.table.told(),
            held: [[true; 2]; 4],
        }
    }

    fn published(&self) -> Published {
        Published {
            authors: "your own table",
            year: None,
            ball: None,
            source: self.table.file(),
        }
    }
}
