//! [`Numbers::outlined`](super::Numbers::outlined) at each level: a function that is called, and not taken in, is compiled for
//! no vector unit but that which it names itself.

macro_rules! outlined {
    ($name:ident $(: $features:literal)?) => {
        /// Work that is called and not taken in.
        $(
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = $features)]
        )?
        #[inline(never)]
        pub(super) fn $name<R>(mut work: impl FnMut() -> R) -> R {
            work()
        }
    };
}

outlined!(plain);
#[cfg(target_arch = "x86_64")]
outlined!(four: "avx2,fma");
#[cfg(target_arch = "x86_64")]
outlined!(eight: "avx2,fma,avx512f,avx512dq,avx512vl");
