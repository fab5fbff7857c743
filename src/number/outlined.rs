//! [`Numbers::outlined`](super::Numbers::outlined), once for each kind of number. A compiler works on modules side by side:
//! with one function for all, a flight over one number would be compiled after that over the other.

macro_rules! rooms {
    ($($room:ident $(: $features:literal)?),+ $(,)?) => {
        $(
            pub(in super::super) mod $room {
                /// Work that is called and not taken in.
                $(
                    #[cfg(target_arch = "x86_64")]
                    #[target_feature(enable = $features)]
                )?
                #[inline(never)]
                pub fn outlined<R>(work: impl FnOnce() -> R) -> R {
                    work()
                }
            }
        )+
    };
}

rooms!(plain);
#[cfg(target_arch = "x86_64")]
rooms! {
    fused: "avx2,fma",
    two: "avx2,fma",
    two_of_32: "avx2,fma,avx512f,avx512dq,avx512vl",
    four: "avx2,fma",
    four_lanes: "avx2,fma",
    four_of_32: "avx2,fma,avx512f,avx512dq,avx512vl",
    eight: "avx2,fma,avx512f,avx512dq,avx512vl",
    eight_lanes: "avx2,fma,avx512f,avx512dq,avx512vl",
}
