use super::{Jet, Number, Numbers, inlined};

/// Several numbers side by side: of drives next to each other, or of one drive, each with
/// derivatives in directions of its own.
pub(crate) trait Lanes: Numbers {
    /// How many.
    const WIDTH: usize;
    /// The number in one lane.
    type Lane: Number;

    /// The number in a lane.
    fn lane(self, i: usize) -> Self::Lane;
    /// Numbers with these values in lanes 0, 1, 2 … and without derivatives; `f` is asked for each
    /// of them.
    fn with_values(f: impl FnMut(usize) -> f64) -> Self;
    /// These values as independent variables: the derivative in direction d is 1 in the lanes of
    /// `changes_in(d)`, else 0. The directions of an outer jet are numbered from `first` on, those
    /// of the jets it is made of follow.
    fn seeded(self, changes_in: &impl Fn(usize) -> Self::Mask, first: usize) -> Self;
}

/// Reads the numbers in a lane. Whoever reads a drive's outcomes out of lanes reads them with this,
/// so that they are compiled once.
#[inline(always)]
pub(crate) fn in_lane<J: Lanes>(lane: usize) -> impl Fn(J) -> J::Lane + Copy {
    inlined!(move |number: J| number.lane(lane))
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
            *change = B::constant(1.0).blend(B::zero(), changes_in(first + k));
        }
        jet
    }
}
