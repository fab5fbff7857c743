use super::{Derivatives, Jet, Numbers};

/// Numbers in lanes. The lanes are different drives, or one drive with different directions.
pub(crate) trait Lanes: Numbers {
    /// Number of lanes.
    const WIDTH: usize;
    /// Number of directions in each lane.
    const DIRECTIONS: usize;
    /// Number type of one lane.
    type Lane: Derivatives;

    /// Number in lane i.
    fn lane(self, i: usize) -> Self::Lane;
    /// Lanes with the values `f(0)`, `f(1)`, … and zero derivatives.
    fn with_values(f: impl FnMut(usize) -> f64) -> Self;
    /// Sets the derivatives: in direction d, the derivative is 1 in the lanes of `changes_in(d)`
    /// and 0 in the other lanes. The directions of a jet are numbered from `first` on, followed by
    /// the directions of its inner jets.
    fn seeded(self, changes_in: &impl Fn(usize) -> Self::Mask, first: usize) -> Self;
}

/// A single lane.
impl Lanes for f64 {
    const WIDTH: usize = 1;
    const DIRECTIONS: usize = 0;
    type Lane = f64;

    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self
    }
    #[inline(always)]
    fn with_values(mut f: impl FnMut(usize) -> f64) -> f64 {
        f(0)
    }
    #[inline(always)]
    fn seeded(self, _: &impl Fn(usize) -> bool, _: usize) -> f64 {
        self
    }
}

impl<const K: usize, B: Lanes> Lanes for Jet<K, B> {
    const WIDTH: usize = B::WIDTH;
    const DIRECTIONS: usize = K + B::DIRECTIONS;
    type Lane = Jet<K, B::Lane>;

    #[inline(always)]
    fn lane(self, i: usize) -> Self::Lane {
        let mut gradient = [B::Lane::zero(); K];
        let mut k = 0;
        while k < K {
            gradient[k] = self.gradient[k].lane(i);
            k += 1;
        }
        Jet {
            re: self.re.lane(i),
            gradient,
        }
    }
    #[inline(always)]
    fn with_values(f: impl FnMut(usize) -> f64) -> Self {
        Self {
            re: B::with_values(f),
            gradient: [B::zero(); K],
        }
    }
    #[inline(always)]
    fn seeded(self, changes_in: &impl Fn(usize) -> B::Mask, first: usize) -> Self {
        let mut jet = Self {
            re: self.re.seeded(changes_in, first + K),
            gradient: self.gradient,
        };
        for (k, change) in jet.gradient.iter_mut().enumerate() {
            *change = B::constant(1.0).select(B::zero(), changes_in(first + k));
        }
        jet
    }
}
