mod grid;

use super::gridded::grid_coefficients;
use super::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Published, RangeEnd, Stream};
use crate::number::Numbers;
use crate::parameters::{
    BearmanHarvey, CoefficientGrid, LawTableAxis, LawVariable, Surface, cells,
};
use crate::units::RPM;
use grid::{DRAG, LIFT, SPEEDS, SPINS};
use std::sync::LazyLock;

/// Widths of the smooth clamps of the speed below and above the grid, m/s. The lower width is
/// small, because C_D and C_L change steeply with the speed near 13.7 m/s.
const SPEED_OVER: [f64; 2] = [1.0, 4.0];
/// Width of the smooth clamps of the spin below and above the grid, rpm.
const SPIN_OVER: f64 = 100.0;

/// Measured speeds, m/s. The last column of the grid, 88.1 m/s, is not measured: its drag is that
/// of the column before.
const MEASURED: [f64; 2] = [13.7, 80.2];

static GRID: LazyLock<CoefficientGrid> = LazyLock::new(|| {
    let [least, most] = SPINS.map(|rpm| rpm * RPM);
    let [slowest, .., fastest] = SPEEDS;
    let intervals = DRAG.len() - 1;
    let spins: Vec<f64> = (0..DRAG.len())
        .map(|row| least + (most - least) / intervals as f64 * row as f64)
        .collect();
    let tables = [&DRAG, &LIFT].map(|table| table.as_flattened());
    let cells = cells(&SPEEDS, &spins, tables);
    CoefficientGrid {
        spin: Some(LawTableAxis {
            variable: LawVariable::Spin,
            ends: [least, most],
            over: [SPIN_OVER * RPM; 2],
        }),
        speed: Some(LawTableAxis {
            variable: LawVariable::Speed,
            ends: [slowest, fastest],
            over: SPEED_OVER,
        }),
        lift_onset: Some((LawVariable::Spin, 1.0 / least)),
        surface: Surface::new(&SPEEDS, spins.leak(), cells.leak()),
    }
});

/// C_D = cd_factor D(v, |ω|), C_L = cl_factor L(v, |ω|): bicubic splines through a grid read off
/// the curves of Bearman & Harvey (1976). Below 2000 rpm, the least spin of the grid, the lift is
/// the lift at 2000 rpm times 1 − (1 − |ω|/2000 rpm)³.
impl<T: Numbers> AerodynamicLaw<T> for BearmanHarvey<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        grid_coefficients(&GRID, [self.cd_factor, self.cl_factor], stream)
    }

    fn properties(&self) -> LawProperties {
        LawProperties {
            published: Published {
                authors: "Bearman & Harvey",
                year: Some(1976),
                ball: Some("conventional and hexagonal dimples of the 1970s"),
                source: "wind tunnel; grid of 10 speeds and 21 spins as tkt4140 has it \
                         (cdclgolfball.py), docs/sources.md",
            },
            fitted: Fitted {
                spin: Some(SPINS.map(|rpm| rpm * RPM)),
                speed: Some(MEASURED),
                to: "a wind tunnel, Bearman & Harvey 1976",
                // below the least spin the lift falls to 0; above 80.2 m/s the law is extrapolated:
                // the speed is clamped only above the last column of the grid, 88.1 m/s
                held: &[
                    (LawVariable::Spin, RangeEnd::High),
                    (LawVariable::Speed, RangeEnd::Low),
                ],
                ..Fitted::UNKNOWN
            },
            continuous_derivatives: Some(2),
            has_corner_at_zero_spin: false,
        }
    }
}
