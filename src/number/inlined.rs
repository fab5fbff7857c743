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
