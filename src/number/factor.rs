use super::{Jet, Jet2, Numbers, Partial};

/// What a number is multiplied by: another of its kind, or its [`Value`](Numbers::Value) type, a number without derivatives,
/// which costs less.
pub trait Factor<T>: Numbers {
    /// Whether it carries what derivatives a number has.
    const HAS_DERIVATIVES: bool = false;

    /// The factor with a number's value, and its derivatives where it carries them.
    fn of(x: T) -> Self;
    /// k x.
    fn times(self, x: T) -> T;
    /// k x + y.
    fn times_plus(self, x: T, y: T) -> T;
    /// k + x.
    fn plus(self, x: T) -> T;
}

impl<T: Numbers> Factor<T> for T {
    const HAS_DERIVATIVES: bool = true;

    #[inline(always)]
    fn of(x: T) -> Self {
        x
    }
    #[inline(always)]
    fn times(self, x: T) -> T {
        self * x
    }
    #[inline(always)]
    fn times_plus(self, x: T, y: T) -> T {
        self.mul_add(x, y)
    }
    #[inline(always)]
    fn plus(self, x: T) -> T {
        self + x
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Factor<Jet<K, B, P>> for B {
    #[inline(always)]
    fn of(x: Jet<K, B, P>) -> Self {
        x.re
    }
    #[inline(always)]
    fn times(self, x: Jet<K, B, P>) -> Jet<K, B, P> {
        x.times_value(self)
    }
    #[inline(always)]
    fn times_plus(self, x: Jet<K, B, P>, y: Jet<K, B, P>) -> Jet<K, B, P> {
        x.times_value_plus(self, y)
    }
    #[inline(always)]
    fn plus(self, x: Jet<K, B, P>) -> Jet<K, B, P> {
        Jet { re: self + x.re, ..x }
    }
}

impl<const N: usize, const M: usize, B: Numbers> Factor<Jet2<N, M, B>> for B {
    #[inline(always)]
    fn of(x: Jet2<N, M, B>) -> Self {
        x.re
    }
    #[inline(always)]
    fn times(self, x: Jet2<N, M, B>) -> Jet2<N, M, B> {
        x.each(
            #[inline(always)]
            |entry| self * entry,
        )
    }
    #[inline(always)]
    fn times_plus(self, x: Jet2<N, M, B>, y: Jet2<N, M, B>) -> Jet2<N, M, B> {
        x.entrywise(
            y,
            #[inline(always)]
            |a, b| self.mul_add(a, b),
        )
    }
    #[inline(always)]
    fn plus(self, x: Jet2<N, M, B>) -> Jet2<N, M, B> {
        Jet2 { re: self + x.re, ..x }
    }
}

#[cfg(target_arch = "x86_64")]
impl<P: super::pair::Register> Factor<super::Pair<P>> for super::Fused {
    #[inline(always)]
    fn of(x: super::Pair<P>) -> Self {
        x.re
    }
    #[inline(always)]
    fn times(self, x: super::Pair<P>) -> super::Pair<P> {
        x * self.0
    }
    #[inline(always)]
    fn times_plus(self, x: super::Pair<P>, y: super::Pair<P>) -> super::Pair<P> {
        x.scale_add(self.0, y)
    }
    #[inline(always)]
    fn plus(self, x: super::Pair<P>) -> super::Pair<P> {
        x + self.0
    }
}
