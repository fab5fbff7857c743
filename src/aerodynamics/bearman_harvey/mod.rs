mod grid;
mod spline;

use super::{AerodynamicLaw, Coefficients, Fitted, Published, Stream};
use crate::number::{Numbers, held_above, held_below};
use crate::parameters::BearmanHarvey;
use grid::{SPEEDS, SPINS};
use spline::cell;

/// rpm to a rad/s.
const RPM: f64 = 30.0 / std::f64::consts::PI;

/// Beyond the edges of the grid speed, m/s, and spin, rpm, are held over these, at once where it is steep: at 13.7 m/s and 2000 rpm the lift
/// halves within 200 rpm, and no one knows how it goes on.
const SPEED_OVER: [f64; 2] = [1.0, 4.0];
const SPIN_OVER: f64 = 100.0;

/// m/s: what was measured. The last column of the grid repeats the drag of the last but one.
const MEASURED: [f64; 2] = [13.7, 80.2];

/// C_D = cd_factor D(v, |ω|), C_L = cl_factor L(v, |ω|): bicubic splines through a grid that was read off the curves of Bearman & Harvey
/// (1976). With less spin than the grid's 2000 rpm the lift is that at its edge times 1 − (1 − |ω|/2000 rpm)³.
impl<T: Numbers> AerodynamicLaw<T> for BearmanHarvey<T> {
    #[inline(always)]
    fn coefficients(&self, stream: &Stream<T>) -> Coefficients<T> {
        T::outlined(
            #[inline(always)]
            || self.in_grid(stream),
        )
    }

    fn has_corner_at_zero_spin(&self) -> bool {
        false
    }

    fn fitted(&self) -> Fitted {
        // of 2000 to 6000 rpm at these speeds
        Fitted {
            spin_ratio: Some([0.05, 0.98]),
            reynolds: None,
            speed: Some(MEASURED),
            to: "a wind tunnel, Bearman & Harvey 1976",
        }
    }

    fn published(&self) -> Published {
        Published {
            authors: "Bearman & Harvey",
            year: Some(1976),
            ball: Some("conventional and hexagonal dimples of the 1970s"),
            source: "wind tunnel; grid of 10 speeds and 21 spins as tkt4140 has it (cdclgolfball.py), docs/sources.md",
        }
    }
}

impl<T: Numbers> BearmanHarvey<T> {
    /// The coefficients at the place in the grid.
    #[inline(always)]
    fn in_grid(&self, stream: &Stream<T>) -> Coefficients<T> {
        let (rpm, [least, most]) = (stream.spin * RPM, SPINS);
        let spin = held_above(held_below(rpm, least, SPIN_OVER), most, SPIN_OVER);
        let (slowest, fastest) = (SPEEDS[0], SPEEDS[SPEEDS.len() - 1]);
        let speed = held_above(held_below(stream.speed, slowest, SPEED_OVER[0]), fastest, SPEED_OVER[1]);
        let c = speed.looked_up(
            spin,
            #[inline(always)]
            |speed, spin| cell(speed, spin),
        );
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
        let part = rpm * (1.0 / least);
        let short = T::constant(1.0) - part.blend(T::constant(1.0), part.below(1.0));
        let begun = T::constant(1.0) - short * short * short;
        Coefficients { drag: self.cd_factor * drag, lift: self.cl_factor * lift * begun }
    }
}
