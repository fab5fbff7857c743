//! Vector registers as numbers: lanes of drives side by side, or partial derivatives of one.
//!
//! The one place that names instructions. Only the [`Level`](super::Level) above can name a register type. It does so after it has asked the
//! processor (AVX2, AVX-512), or where every processor of the architecture (NEON) or of the build (WebAssembly) has the instructions. All other
//! code has a register as the type that its [`Task`](super::Task) is run over. That is what each `unsafe` here relies on.
#![allow(unsafe_code)]
// what is unsafe on one architecture is not on another
#![allow(unused_unsafe)]

mod bits;
mod exponential;
#[macro_use]
mod pack;
mod sine;

#[cfg(target_arch = "aarch64")]
mod neon;
#[cfg(target_arch = "wasm32")]
mod wasm;
#[cfg(target_arch = "x86_64")]
mod x86;

use crate::number::tanh::tanh;
use crate::number::{Lanes, Numbers, inlined};
use bits::Bits;
use exponential::Powers;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(target_arch = "aarch64")]
pub(super) use neon::Pack2;
#[cfg(target_arch = "wasm32")]
pub(super) use wasm::Pack2;
#[cfg(target_arch = "x86_64")]
pub(super) use x86::{Pack4, Pack8};

#[cfg(test)]
mod tests {
    use crate::number::{Lanes, Level, Task};

    /// The largest errors of root, inverse root and exponential over many numbers, in units of the last place.
    struct Worst;

    impl Task for Worst {
        type Output = [f64; 3];

        #[inline(always)]
        fn run<P: Lanes<Lane = f64>>(self) -> [f64; 3] {
            let mut worst = [0.0_f64; 3];
            for i in 0..40_000 {
                // 1e-12 to 1e12, each lane another
                let x: P =
                    P::with_values(|lane| 10_f64.powf(-12.0 + 24.0 * f64::from(i) / 4e4) * (1.0 + 0.37 * lane as f64));
                let (root, inverse) = x.sqrt_recip();
                let exponent = (root * 1e-6).exp();
                for lane in 0..P::WIDTH {
                    let (exact, small) = (x.lane(lane).sqrt(), root.lane(lane) * 1e-6);
                    let pairs = [(root, exact), (inverse, 1.0 / exact), (exponent, small.exp())];
                    for (most, (found, exact)) in worst.iter_mut().zip(pairs) {
                        *most = most.max((found.lane(lane) - exact).abs() / (exact.abs() * f64::EPSILON));
                    }
                }
            }
            worst
        }
    }

    #[test]
    fn measured_vector_functions_are_within_two_units_of_the_libm_ones() {
        for worst in Level::ALL.map(|level| level.run(Worst)) {
            assert!(worst.iter().all(|most| *most <= 2.0), "{worst:?}");
        }
    }
}
