//! Vector registers as lanes: the only code with processor instructions.
//!
//! Only [`Level`](super::Level) names a register type, and only if the processor has the
//! instructions of the register. The program detects AVX2 and AVX-512 when it runs. NEON is part of
//! the architecture, and a WebAssembly build with vectors requires them. All other code is generic
//! over the lane type of a [`Task`](super::Task). Every `unsafe` in this module relies on these
//! rules.
#![allow(unsafe_code)]
// some intrinsics are unsafe on one architecture and safe on another
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
use std::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(target_arch = "aarch64")]
pub(super) use neon::Pack2;
#[cfg(target_arch = "wasm32")]
pub(super) use wasm::Pack2;
#[cfg(target_arch = "x86_64")]
pub(super) use x86::{Pack4, Pack8};

#[cfg(test)]
mod tests {
    use crate::number::{Lanes, Level, Numbers, Task, inlined};

    /// Largest error in ulp against libm, which is itself within 1 ulp.
    #[inline(always)]
    fn worst<V: Lanes<Lane = f64>>(
        at: impl Fn(f64) -> f64,
        f: impl Fn(V) -> V,
        exact: impl Fn(f64) -> f64,
    ) -> f64 {
        let mut worst = 0.0_f64;
        for i in -40_000..40_000 {
            let x = V::with_values(|lane| at(f64::from(i) + 0.1 * lane as f64));
            let found = f(x);
            for lane in 0..V::WIDTH {
                let exact = exact(x.lane(lane));
                worst = worst.max((found.lane(lane) - exact).abs() / (exact.abs() * f64::EPSILON));
            }
        }
        worst
    }

    /// Largest errors, in ulp, of the functions that registers compute without libm.
    struct RegisterFunctions;

    impl Task for RegisterFunctions {
        type Output = [f64; 7];

        #[inline(always)]
        fn run<V: Lanes<Lane = f64>>(&mut self) -> [f64; 7] {
            assert_eq!(
                (V::zero().exp().lane(0), V::zero().exp_m1().lane(0)),
                (1.0, 0.0)
            );
            let [none, all, undefined] =
                [-1e9, 1e9, f64::NAN].map(|x| V::constant(x).exp().lane(0));
            assert!(none < 1e-300 && all > 1e300 && undefined.is_nan());
            // `powers` are from 1e-12 to 1e12, `wide` from −700 to 700, `narrow` from −4 to 4
            let powers = |i: f64| 10_f64.powf(i * 3e-4);
            let (wide, narrow) = (|i: f64| i * 0.0175 + 1e-7, |i: f64| i * 1e-4 + 3e-9);
            [
                worst::<V>(powers, inlined!(|x: V| x.sqrt_recip().0), f64::sqrt),
                worst::<V>(powers, inlined!(|x: V| x.sqrt_recip().1), |x| {
                    1.0 / x.sqrt()
                }),
                worst::<V>(wide, inlined!(|x: V| x.exp()), f64::exp),
                worst::<V>(narrow, inlined!(|x: V| x.exp_m1()), f64::exp_m1),
                worst::<V>(narrow, inlined!(|x: V| x.sin()), f64::sin),
                worst::<V>(narrow, inlined!(|x: V| x.cos()), f64::cos),
                worst::<V>(narrow, inlined!(|x: V| Numbers::tanh(x)), f64::tanh),
            ]
        }
    }

    #[test]
    fn independent_functions_are_within_two_ulp_of_libm_and_tanh_within_three() {
        for level in Level::ALL {
            let worst = level.run_sweep(RegisterFunctions);
            let ([others @ .., tanh], most) = (worst, if level.width() == 1 { 2.0 } else { 3.0 });
            assert!(
                others.iter().all(|most| *most <= 2.0) && tanh <= most,
                "{level:?}: {worst:?}"
            );
        }
    }
}
