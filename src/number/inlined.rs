/// A closure as it is. An attribute like `#[inline(always)]` may stand on an argument, not on the right of a `let`; a closure that
/// is called twice and not inlined would be compiled for no vector unit at all.
#[inline(always)]
pub(crate) fn inlined<F>(closure: F) -> F {
    closure
}
