//! Inlining: the macro `inlined!`, and [`Numbers::not_inlined`](super::Numbers::not_inlined) for
//! each level. A function that is not inlined uses only the instructions of its own
//! `target_feature`. Each level has a module of its own, so that the levels are compiled in
//! parallel.

/// A closure with `#[inline(always)]`; see [Inlining](crate::number).
macro_rules! inlined {
    ($($closure:tt)+) => {
        std::convert::identity(
            #[inline(always)]
            $($closure)+
        )
    };
}
pub(crate) use inlined;

macro_rules! not_inlined {
    ($level:ident $(: $features:literal)?) => {
        pub(super) mod $level {
            /// Calls `work` without inlining.
            $( #[target_feature(enable = $features)] )?
            #[inline(never)]
            pub fn not_inlined<R>(mut work: impl FnMut() -> R) -> R {
                work()
            }
        }
    };
}

not_inlined!(plain);
#[cfg(target_arch = "x86_64")]
not_inlined!(avx2: "avx2,fma");
#[cfg(target_arch = "x86_64")]
not_inlined!(avx512: "avx2,fma,avx512f,avx512dq,avx512vl");
