use crate::number::Mask;
use std::ops::{BitAnd, BitOr, Not};

/// Mask of `W` lanes, with one bit for each lane; lane 0 is the lowest bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits<const W: usize>(pub u8);

impl<const W: usize> Bits<W> {
    /// True in all lanes.
    pub const ALL: Self = Self(u8::MAX >> (8 - W));
}

impl<const W: usize> BitAnd for Bits<W> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<const W: usize> BitOr for Bits<W> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl<const W: usize> Not for Bits<W> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0 & Self::ALL.0)
    }
}

impl<const W: usize> Mask for Bits<W> {
    #[inline(always)]
    fn all(self) -> bool {
        self == Self::ALL
    }
    #[inline(always)]
    fn holds(self, lane: usize) -> bool {
        self.0 >> lane & 1 == 1
    }
    #[inline(always)]
    fn first(count: usize) -> Self {
        Self(((1_u16 << count.min(W)) - 1) as u8)
    }
}
