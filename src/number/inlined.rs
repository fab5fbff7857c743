/// A closure that is always inlined: one that is called twice and not inlined would be compiled for
/// no vector unit at all. An attribute may stand on an argument, not on the right of a `let`.
macro_rules! inlined {
    ($($closure:tt)+) => {
        std::convert::identity(
            #[inline(always)]
            $($closure)+
        )
    };
}
pub(crate) use inlined;
