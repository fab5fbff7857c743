use super::{Jet, Number, Numbers};

/// Several numbers side by side: of drives next to each other, or of one drive, each with derivatives in directions of its own.
pub(crate) trait Lanes: Numbers {
    /// How many.
    const WIDTH: usize;
    /// The number in one lane.
    type Lane: Number;

    /// The number in a lane.
    fn lane(self, i: usize) -> Self::Lane;
    /// The numbers in lanes 0, 1, 2 …; `f` is asked for each of them.
    fn from_lanes(f: impl FnMut(usize) -> Self::Lane) -> Self;
    /// The numbers with a value for each lane, which change in those directions of a lane that are so told. Directions are counted
    /// from `first` on, those of a jet before those of the jets it is made of.
    fn seeded(value: &impl Fn(usize) -> f64, changes_in: &impl Fn(usize, usize) -> bool, first: usize) -> Self;
}

/// A number alone.
impl Lanes for f64 {
    const WIDTH: usize = 1;
    type Lane = f64;

    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> f64 {
        f(0)
    }
    #[inline(always)]
    fn seeded(value: &impl Fn(usize) -> f64, _: &impl Fn(usize, usize) -> bool, _: usize) -> f64 {
        value(0)
    }
}

impl<const K: usize, B: Lanes> Lanes for Jet<K, B> {
    const WIDTH: usize = B::WIDTH;
    type Lane = Jet<K, B::Lane>;

    #[inline(always)]
    fn lane(self, i: usize) -> Self::Lane {
        Jet { re: self.re.lane(i), gradient: self.gradient.map(|d| d.lane(i)) }
    }
    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> Self::Lane) -> Self {
        let lanes: [Self::Lane; MOST_LANES] =
            std::array::from_fn(|i| if i < B::WIDTH { f(i) } else { Self::Lane::zero() });
        Jet {
            re: B::from_lanes(|i| lanes[i].re),
            gradient: std::array::from_fn(|k| B::from_lanes(|i| lanes[i].gradient[k])),
        }
    }
    #[inline(always)]
    fn seeded(value: &impl Fn(usize) -> f64, changes_in: &impl Fn(usize, usize) -> bool, first: usize) -> Self {
        let change =
            |k: usize| B::from_lanes(|lane| B::Lane::constant(f64::from(u8::from(changes_in(lane, first + k)))));
        Jet { re: B::seeded(value, changes_in, first + K), gradient: std::array::from_fn(change) }
    }
}

/// Lanes of the widest registers.
pub(crate) const MOST_LANES: usize = 8;
