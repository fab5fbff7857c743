use std::fmt::Debug;
use std::ops::{BitAnd, BitOr, Not};

/// The answers to a comparison of several numbers.
pub trait Mask:
    Copy + Debug + 'static + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// Whether it holds for each.
    fn all(self) -> bool;
    /// Whether it holds for one at least.
    #[inline(always)]
    fn any(self) -> bool {
        !(!self).all()
    }
    /// Whether it holds for this one, counted from 0.
    fn holds(self, lane: usize) -> bool;
    /// The mask that holds for the first of several.
    fn first(count: usize) -> Self;
    /// The mask that holds for none.
    #[inline(always)]
    fn none() -> Self {
        Self::first(0)
    }
    /// The mask that holds for one, counted from 0.
    #[inline(always)]
    fn only(lane: usize) -> Self {
        Self::first(lane + 1) & !Self::first(lane)
    }
}

impl Mask for bool {
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn holds(self, _lane: usize) -> bool {
        self
    }
    #[inline(always)]
    fn first(count: usize) -> Self {
        count > 0
    }
}
