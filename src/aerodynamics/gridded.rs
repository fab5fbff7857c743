//! Laws that interpolate C_D and C_L in a grid by splines. The grid is published, or a user's own
//! table.

use super::{Coefficients, Stream};
use crate::number::{Numbers, inlined, smooth_clamp_above, smooth_clamp_below};
use crate::parameters::{CoefficientGrid, DRAG_START, LIFT_START, LawTableAxis, bicubic};

/// C_D and C_L of a grid, multiplied by `cd_factor` and `cl_factor`. Beyond the edges of the grid,
/// speed and spin are clamped. `lift_onset` has a limit x₁ of the spin or spin ratio x. For x < x₁
/// the lift is multiplied by 1 − (1 − x/x₁)³, which is 0 without spin.
#[inline(always)]
pub(super) fn grid_coefficients<T: Numbers>(
    grid: &'static CoefficientGrid,
    [cd_factor, cl_factor]: [T; 2],
    stream: Stream<T>,
) -> Coefficients<T> {
    T::not_inlined(inlined!(move || {
        let speed = coordinate(&grid.speed, &stream);
        let spin = coordinate(&grid.spin, &stream);
        let c = speed.gather(spin, inlined!(|speed, spin| grid.surface.cell(speed, spin)));
        // u and w: speed and spin within the cell
        let (u, w) = ((speed - c[0]) * c[1], (spin - c[2]) * c[3]);
        let drag = bicubic(&c, DRAG_START, u, w);
        let mut lift = cl_factor * bicubic(&c, LIFT_START, u, w);
        if let Some((variable, per_least)) = grid.lift_onset {
            let part = stream.value(variable) * per_least;
            let short = T::constant(1.0) - part.select(T::constant(1.0), part.below(1.0));
            lift = lift * (T::constant(1.0) - short * short * short);
        }
        Coefficients {
            drag: cd_factor * drag,
            lift,
        }
    }))
}

/// The variable of an axis, clamped beyond the ends of the axis; 0 if `axis` is `None`.
#[inline(always)]
fn coordinate<T: Numbers>(axis: &Option<LawTableAxis>, stream: &Stream<T>) -> T {
    let Some(LawTableAxis {
        variable,
        ends: [first, last],
        over: [under, over],
    }) = *axis
    else {
        return T::zero();
    };
    smooth_clamp_above(
        smooth_clamp_below(stream.value(variable), first, under),
        last,
        over,
    )
}
