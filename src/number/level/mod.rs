//! Instruction sets of the processor, and code compiled for each.

#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
mod registers;

use super::Lanes;
#[cfg(target_arch = "x86_64")]
use super::inlined;

/// Instruction set for computing drives. Each level has its own copy of the code. Results of
/// different levels agree to rounding. Results of the same level, version of longdrive and
/// operating system are identical to the last bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Baseline instructions of the architecture. A WebAssembly module has this level, or `Simd128`
    /// if it is compiled with SIMD.
    Baseline,
    /// NEON (every aarch64 processor): two numbers in a register.
    Neon,
    /// The 128-bit vectors of WebAssembly (compiled with `-C target-feature=+simd128`): two numbers
    /// in a register.
    Simd128,
    /// AVX2 with FMA (x86-64-v3): four numbers in a register.
    Avx2,
    /// AVX-512 (F, DQ, VL) with FMA: eight numbers in a register.
    Avx512,
}

/// Work that is compiled for each level. `run`, and all functions of numbers that it calls, must be
/// inlined; see [Inlining](crate::number).
pub(crate) trait Task {
    /// Result.
    type Output;
    /// Runs the work with this lane type.
    fn run<V: Lanes<Lane = f64>>(&mut self) -> Self::Output;
}

variant_names! {
    /// Name on the command line: `avx2`.
    Level {
        Baseline = "baseline",
        Neon = "neon",
        Simd128 = "simd128",
        Avx2 = "avx2",
        Avx512 = "avx512",
    }
}

impl Level {
    /// Widest level of this processor, the default.
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

    /// True if this processor has the level.
    pub fn is_here(self) -> bool {
        match (self, Self::here()) {
            (Self::Baseline, here) => here != Self::Simd128,
            (Self::Avx2, Self::Avx512) => true,
            (level, here) => level == here,
        }
    }

    /// Number of lanes.
    pub(crate) fn width(self) -> usize {
        match self {
            Self::Baseline => 1,
            Self::Neon | Self::Simd128 => 2,
            Self::Avx2 => 4,
            Self::Avx512 => 8,
        }
    }

    /// The level for a single drive: at most AVX2. The directions of a single drive seldom fill the
    /// lanes of AVX-512, and the code for AVX-512 would take a fifth of the compile time.
    pub(crate) fn of_one_drive(self) -> Self {
        self.min(Self::Avx2)
    }

    /// Runs a task of one drive at this level. A level above AVX2, or above the widest level of
    /// this processor, is lowered.
    #[inline]
    #[cfg_attr(
        target_arch = "x86_64",
        expect(
            unsafe_code,
            reason = "code for a level runs only on processors with its features"
        )
    )]
    pub(crate) fn run_one_drive<W: Task>(self, mut task: W) -> W::Output {
        match self.of_one_drive().min(Self::here()) {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor has these features
            Self::Avx2 => unsafe {
                inlined::avx2::not_inlined(inlined!(|| task.run::<registers::Pack4>()))
            },
            #[cfg(target_arch = "aarch64")]
            Self::Neon => task.run::<registers::Pack2>(),
            // a WebAssembly module compiled with SIMD runs only on hosts with SIMD, so it needs no
            // other copy
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            _ => task.run::<registers::Pack2>(),
            #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
            _ => task.run::<f64>(),
        }
    }

    /// Runs a task of many drives: like [`run_one_drive`](Self::run_one_drive), but also with
    /// AVX-512.
    #[inline]
    #[cfg_attr(
        target_arch = "x86_64",
        expect(
            unsafe_code,
            reason = "code for a level runs only on processors with its features"
        )
    )]
    pub(crate) fn run_sweep<W: Task>(self, task: W) -> W::Output {
        #[cfg(target_arch = "x86_64")]
        if self.min(Self::here()) == Self::Avx512 {
            let mut task = task;
            // SAFETY: the processor has these features
            return unsafe {
                inlined::avx512::not_inlined(inlined!(|| task.run::<registers::Pack8>()))
            };
        }
        self.run_one_drive(task)
    }
}
