//! What the processor can do, and work compiled for that.

use super::Lanes;
#[cfg(target_arch = "x86_64")]
use super::{Pack4, Pack8};

/// Vector units worth another copy of the code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    /// What every processor of the architecture can do.
    Baseline,
    /// Fused multiply–add and four numbers in a register (x86-64-v3).
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    Four,
    /// Eight numbers in a register (AVX-512).
    #[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
    Eight,
}

/// Work that is compiled for each level, over the lanes it has. `run` and all that it calls on numbers must be
/// `#[inline(always)]`: only what ends up inside the copy is compiled for its vector unit.
pub(crate) trait Task {
    /// What comes of it.
    type Output;
    /// Does it.
    fn run<V: Lanes<Lane = f64>>(self) -> Self::Output;
}

impl Level {
    /// The best of this machine.
    #[inline]
    pub fn here() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("fma")
            {
                return Self::Eight;
            }
            if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
                return Self::Four;
            }
        }
        Self::Baseline
    }

    /// This level or one below, for so many numbers: what fits into few lanes is quicker in those.
    #[inline]
    pub fn of(self, count: usize) -> Self {
        if count <= 4 { self.min(Self::Four) } else { self }
    }

    /// How many lanes there are.
    pub fn width(self) -> usize {
        match self {
            Self::Baseline => 1,
            Self::Four => 4,
            Self::Eight => 8,
        }
    }

    /// Runs a task at this level, or the best that the machine has below it.
    #[inline]
    #[allow(unsafe_code)]
    pub fn run<W: Task>(self, task: W) -> W::Output {
        match self.min(Self::here()) {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor has been asked
            Self::Eight => unsafe { with_eight(task) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor has been asked
            Self::Four => unsafe { with_four(task) },
            _ => task.run::<f64>(),
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn with_four<W: Task>(task: W) -> W::Output {
    task.run::<Pack4>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,avx512f,avx512dq,avx512vl")]
fn with_eight<W: Task>(task: W) -> W::Output {
    task.run::<Pack8>()
}
