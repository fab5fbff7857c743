//! [`Numbers::outlined`](super::Numbers::outlined) at each level: a function that is not inlined
//! uses only the instructions that its own `target_feature` names. There is a module for each
//! level, so that they are compiled in parallel.

macro_rules! outlined {
    ($level:ident $(: $features:literal)?) => {
        pub(super) mod $level {
            /// Work that is not inlined.
            $( #[target_feature(enable = $features)] )?
            #[inline(never)]
            pub fn outlined<R>(mut work: impl FnMut() -> R) -> R {
                work()
            }
        }
    };
}

outlined!(plain);
#[cfg(target_arch = "x86_64")]
outlined!(avx2: "avx2,fma");
#[cfg(target_arch = "x86_64")]
outlined!(avx512: "avx2,fma,avx512f,avx512dq,avx512vl");
