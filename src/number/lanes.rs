use super::{Jet, Number, Numbers};
use std::fmt::Debug;

/// The answers to a comparison of several numbers.
pub trait Mask: Copy + Debug + 'static {
    /// Whether it holds for each.
    fn all(self) -> bool;
    /// Whether it holds for one at least.
    fn any(self) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// The answers to a comparison of `W` numbers, a bit each, the first the lowest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bits<const W: usize>(pub u8);

impl<const W: usize> Bits<W> {
    /// Holds for each.
    pub const ALL: Self = Self(((1_u16 << W) - 1) as u8);
}

impl<const W: usize> Mask for Bits<W> {
    #[inline(always)]
    fn all(self) -> bool {
        self == Self::ALL
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.0 != 0
    }
}

/// Several drives side by side, each a number of its own.
pub(crate) trait Lanes: Numbers {
    /// How many.
    const WIDTH: usize;
    /// The number in one lane.
    type Lane: Number;

    /// The number in a lane.
    fn lane(self, i: usize) -> Self::Lane;
    /// The numbers in lanes 0, 1, 2 …; `f` is asked for each of them.
    fn from_lanes(f: impl FnMut(usize) -> Self::Lane) -> Self;
    /// The mask with these bits, the lowest for lane 0.
    fn mask(bits: u8) -> Self::Mask;
    /// The bits of a mask.
    fn bits(mask: Self::Mask) -> u8;
}

impl<const K: usize, B: Lanes<Lane = f64>> Lanes for Jet<K, B> {
    const WIDTH: usize = B::WIDTH;
    type Lane = Jet<K>;

    #[inline(always)]
    fn lane(self, i: usize) -> Jet<K> {
        Jet { re: self.re.lane(i), gradient: self.gradient.map(|d| d.lane(i)) }
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> Jet<K>) -> Self {
        let mut lanes = [Jet::<K>::zero(); 8];
        for (i, lane) in lanes.iter_mut().enumerate().take(B::WIDTH) {
            *lane = f(i);
        }
        Jet {
            re: B::from_lanes(|i| lanes[i].re),
            gradient: std::array::from_fn(|k| B::from_lanes(|i| lanes[i].gradient[k])),
        }
    }
    #[inline(always)]
    fn mask(bits: u8) -> Self::Mask {
        B::mask(bits)
    }
    #[inline(always)]
    fn bits(mask: Self::Mask) -> u8 {
        B::bits(mask)
    }
}
