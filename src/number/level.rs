//! What the processor can do, and work compiled for that.

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

/// Work that is compiled for a level. `run` and all that it calls on the numbers of that level must be
/// `#[inline(always)]`: only what ends up inside the copy is compiled for its vector unit.
pub(crate) trait Task {
    /// What comes of it.
    type Output;
    /// Does it.
    fn run(self) -> Self::Output;
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

    /// Runs a task that is compiled for [`Level::Four`]; `None` where the machine is below it.
    #[inline]
    #[allow(unsafe_code)]
    pub fn run_four<W: Task>(task: W) -> Option<W::Output> {
        #[cfg(target_arch = "x86_64")]
        if Self::here() >= Self::Four {
            // SAFETY: the processor has been asked
            return Some(unsafe { with_four(task) });
        }
        let _ = task;
        None
    }

    /// Runs a task that is compiled for [`Level::Eight`]; `None` where the machine is below it.
    #[inline]
    #[allow(unsafe_code)]
    pub fn run_eight<W: Task>(task: W) -> Option<W::Output> {
        #[cfg(target_arch = "x86_64")]
        if Self::here() >= Self::Eight {
            // SAFETY: the processor has been asked
            return Some(unsafe { with_eight(task) });
        }
        let _ = task;
        None
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn with_four<W: Task>(task: W) -> W::Output {
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,avx512f,avx512dq,avx512vl")]
fn with_eight<W: Task>(task: W) -> W::Output {
    task.run()
}

/// A closure as it is. An attribute like `#[inline(always)]` may stand on an argument, not on the right of a `let`; a closure that
/// is called twice and not taken in would be compiled for no vector unit at all.
#[inline(always)]
pub(crate) fn inlined<F>(closure: F) -> F {
    closure
}
