//! Laws that are splines through a grid: of a publication, or of a user's own table.

use super::{Coefficients, Stream};
use crate::number::{Numbers, held_above, held_below, inlined};
use crate::parameters::{Along, Axis, Grid};

/// C_D and C_L of a grid at its place for this stream, times their factors. Beyond its edges speed
/// and spin are held; with less spin than its least, the lift is that at its edge times 1 − (1 −
/// ω/ω_least)³.
#[inline(always)]
pub(super) fn gridded<T: Numbers>(
    grid: &'static Grid,
    factors: [T; 2],
    stream: Stream<T>,
) -> Coefficients<T> {
    T::outlined(inlined!(move || in_grid(grid, factors, stream)))
}

#[inline(always)]
fn in_grid<T: Numbers>(
    grid: &'static Grid,
    [cd_factor, cl_factor]: [T; 2],
    stream: Stream<T>,
) -> Coefficients<T> {
    let (speed, spin) = (held(&grid.speed, &stream), held(&grid.spin, &stream));
    let c = speed.looked_up(spin, inlined!(|speed, spin| grid.surface.cell(speed, spin)));
    let (u, w) = ((speed - c[0]) * c[1], (spin - c[2]) * c[3]);
    let (mut drag, mut lift) = (T::zero(), T::zero());
    let mut power = 4;
    while power > 0 {
        power -= 1;
        let (d, l) = (4 + 4 * power, 20 + 4 * power);
        let along = w.mul_add(w.mul_add(w.mul_add(c[d + 3], c[d + 2]), c[d + 1]), c[d]);
        drag = drag.mul_add(u, along);
        let along = w.mul_add(w.mul_add(w.mul_add(c[l + 3], c[l + 2]), c[l + 1]), c[l]);
        lift = lift.mul_add(u, along);
    }
    let mut lift = cl_factor * lift;
    if let Some((along, per_least)) = grid.begins {
        let part = value(along, &stream) * per_least;
        let short = T::constant(1.0) - part.blend(T::constant(1.0), part.below(1.0));
        lift = lift * (T::constant(1.0) - short * short * short);
    }
    Coefficients {
        drag: cd_factor * drag,
        lift,
    }
}

/// What a table goes along, in this stream.
#[inline(always)]
fn value<T: Numbers>(along: Along, stream: &Stream<T>) -> T {
    match along {
        Along::SpinRatio => stream.spin_ratio(),
        Along::Spin => stream.spin,
        Along::Reynolds => stream.reynolds(),
        Along::Speed => stream.speed,
    }
}

/// The place along an axis, held beyond its ends.
#[inline(always)]
fn held<T: Numbers>(axis: &Option<Axis>, stream: &Stream<T>) -> T {
    let Some(Axis {
        along,
        ends: [first, last],
        over: [under, over],
    }) = *axis
    else {
        return T::zero();
    };
    held_above(held_below(value(along, stream), first, under), last, over)
}
