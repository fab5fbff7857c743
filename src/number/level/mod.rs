//! What the processor can do, and work compiled for that.

#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
mod registers;

use super::Lanes;
#[cfg(target_arch = "x86_64")]
use super::{inlined, outlined};
use std::fmt;

/// The instructions of the processor that drives are computed with: each level is another copy of
/// the code. Drives computed with another agree to rounding only; with the same, by the same
/// version of longdrive on the same operating system, to the last bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Those that every processor of the architecture has.
    Baseline,
    /// NEON, which every processor of the architecture aarch64 has: two numbers in a register.
    Neon,
    /// The 128-bit vectors of WebAssembly, for which a program is compiled with
    /// `-C target-feature=+simd128`: two numbers in a register.
    Simd128,
    /// AVX2 with FMA (x86-64-v3): four numbers in a register.
    Avx2,
    /// AVX-512 (F, DQ, VL) with FMA: eight numbers in a register.
    Avx512,
}

/// Work that is compiled for each level, over the lanes it has. `run` and all that it calls on
/// numbers must be `#[inline(always)]`: only what ends up inside the copy is compiled for its
/// vector unit.
pub(crate) trait Task {
    /// What comes of it.
    type Output;
    /// Does it.
    fn run<V: Lanes<Lane = f64>>(&mut self) -> Self::Output;
}

impl Level {
    /// All, the narrowest registers first. A machine has those of its own architecture only.
    pub const ALL: [Self; 5] = [
        Self::Baseline,
        Self::Neon,
        Self::Simd128,
        Self::Avx2,
        Self::Avx512,
    ];

    /// The name on the command line: `avx2`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Neon => "neon",
            Self::Simd128 => "simd128",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }

    /// The most that this processor has: what is used where nothing else is asked for.
    #[inline]
    pub fn here() -> Self {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            let has_avx512 = is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl");
            return if has_avx512 { Self::Avx512 } else { Self::Avx2 };
        }
        if cfg!(target_arch = "aarch64") {
            Self::Neon
        } else if cfg!(all(target_arch = "wasm32", target_feature = "simd128")) {
            Self::Simd128
        } else {
            Self::Baseline
        }
    }

    /// Whether this processor has it: never one of another architecture.
    pub fn is_here(self) -> bool {
        let here = Self::here();
        self == Self::Baseline || self == here || (self, here) == (Self::Avx2, Self::Avx512)
    }

    /// How many lanes there are.
    pub(crate) fn width(self) -> usize {
        match self {
            Self::Baseline => 1,
            Self::Neon | Self::Simd128 => 2,
            Self::Avx2 => 4,
            Self::Avx512 => 8,
        }
    }

    /// Runs a task at this level, or the best that the machine has below it; over plain numbers
    /// where the level is of another architecture.
    #[inline]
    #[allow(
        unsafe_code,
        reason = "code for a level runs where the processor has been asked whether it has it"
    )]
    pub(crate) fn run<W: Task>(self, mut task: W) -> W::Output {
        match self.min(Self::here()) {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor has been asked
            Self::Avx512 => unsafe {
                outlined::avx512::outlined(inlined!(|| task.run::<registers::Pack8>()))
            },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor has been asked
            Self::Avx2 => unsafe {
                outlined::avx2::outlined(inlined!(|| task.run::<registers::Pack4>()))
            },
            #[cfg(target_arch = "aarch64")]
            Self::Neon => task.run::<registers::Pack2>(),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Self::Simd128 => task.run::<registers::Pack2>(),
            _ => task.run::<f64>(),
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
