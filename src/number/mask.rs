use std::fmt::Debug;
use std::ops::{BitAnd, BitOr, Not};

/// Result of a comparison: one bit per lane.
pub trait Mask:
    Copy + Debug + 'static + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// True if all lanes are true.
    fn all(self) -> bool;
    /// True if at least one lane is true.
    #[inline(always)]
    fn any(self) -> bool {
        !(!self).all()
    }
    /// Value in a lane, counted from 0.
    fn holds(self, lane: usize) -> bool;
    /// Mask that is true in the first `count` lanes.
    fn first(count: usize) -> Self;
    /// Mask that is false in all lanes.
    #[inline(always)]
    fn none() -> Self {
        Self::first(0)
    }
    /// Mask that is true in one lane, counted from 0.
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
