use super::{Counterpart, Fused, Jet2, Lanes, Number, Numbers, Partial};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A register of four.
pub(crate) trait Register: Partial<Fused> + Lanes<Lane = f64> {}

impl<P: Partial<Fused> + Lanes<Lane = f64>> Register for P {}

/// A value with its first and second derivatives in two directions, a and b, in registers of four.
///
/// The gradient is held twice, each time as wide as the second derivatives (aa, ab, bb) and in the order in which one factor
/// of a product meets the other: the product rule is then multiplications of whole registers, without a shuffle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair<P> {
    pub(super) re: Fused,
    /// ∂a, ∂a, ∂b.
    first: P,
    /// ∂a, ∂b, ∂b.
    second: P,
    /// ∂²aa, ∂²ab, ∂²bb.
    hessian: P,
}

impl<P: Register> Counterpart<Jet2<2, 3>> for Pair<P> {
    #[inline(always)]
    fn made_of(plain: Jet2<2, 3>) -> Self {
        let ([a, b], [aa, ab, bb]) = (plain.gradient, plain.hessian);
        let row = |entries: [f64; 3]| P::from_lanes(|i| entries.get(i).copied().unwrap_or(0.0));
        Self { re: Fused(plain.re), first: row([a, a, b]), second: row([a, b, b]), hessian: row([aa, ab, bb]) }
    }
    #[inline(always)]
    fn plain(self) -> Jet2<2, 3> {
        let gradient = [0, 1].map(|i| self.second.lane(i));
        Jet2 { re: self.re.0, gradient, hessian: [0, 1, 2].map(|i| self.hessian.lane(i)) }
    }
}

impl<P: Register> Pair<P> {
    /// Chain rule: f(x) from f(x.re), f′(x.re) and f″(x.re).
    #[inline(always)]
    fn chain(self, f: Fused, slope: Fused, curvature: Fused) -> Self {
        let bent = self.first.times(curvature);
        Self {
            re: f,
            first: self.first.times(slope),
            second: self.second.times(slope),
            hessian: self.hessian.times_plus(slope, bent * self.second),
        }
    }

    /// Each register of two.
    #[inline(always)]
    fn with(self, other: Self, re: Fused, f: impl Fn(P, P) -> P) -> Self {
        Self {
            re,
            first: f(self.first, other.first),
            second: f(self.second, other.second),
            hessian: f(self.hessian, other.hessian),
        }
    }
}

impl<P: Register> Add for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(
            other,
            self.re + other.re,
            #[inline(always)]
            |a, b| a + b,
        )
    }
}

impl<P: Register> Sub for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(
            other,
            self.re - other.re,
            #[inline(always)]
            |a, b| a - b,
        )
    }
}

impl<P: Register> Mul for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let own = a.hessian.times_plus(b.re, b.hessian.times(a.re));
        Self {
            re: a.re * b.re,
            first: a.first.times_plus(b.re, b.first.times(a.re)),
            second: a.second.times_plus(b.re, b.second.times(a.re)),
            hessian: a.first.mul_add(b.second, a.second.mul_add(b.first, own)),
        }
    }
}

impl<P: Register> Div for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.mul(other.recip())
    }
}

impl<P: Register> Neg for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { re: -self.re, first: -self.first, second: -self.second, hessian: -self.hessian }
    }
}

impl<P: Register> Add<f64> for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { re: self.re + other, ..self }
    }
}

impl<P: Register> Sub<f64> for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        Self { re: self.re - other, ..self }
    }
}

impl<P: Register> Mul<f64> for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        Self {
            re: self.re * other,
            first: self.first * other,
            second: self.second * other,
            hessian: self.hessian * other,
        }
    }
}

impl<P: Register> Div<f64> for Pair<P> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self.mul(other.recip())
    }
}

impl<P: Register> Numbers for Pair<P> {
    type Mask = bool;
    type Value = Fused;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        let none = P::zero();
        Self { re: Fused(value), first: none, second: none, hessian: none }
    }
    second_order_functions!();

    #[inline(always)]
    fn below(self, limit: f64) -> bool {
        self.re.below(limit)
    }
    #[inline(always)]
    fn blend(self, other: Self, mask: bool) -> Self {
        if mask { self } else { other }
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.re.is_zero() && self.is_constant()
    }
    #[inline(always)]
    fn is_constant(self) -> bool {
        self.second.is_zero() && self.hessian.is_zero()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.re.is_finite()
    }
    #[inline(always)]
    fn outlined<R>(work: impl FnOnce() -> R) -> R {
        <P as Partial<Fused>>::outlined(work)
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let own = self.hessian.times_plus(a.re, a.hessian.times_plus(self.re, b.hessian));
        Self {
            re: self.re.mul_add(a.re, b.re),
            first: self.first.times_plus(a.re, a.first.times_plus(self.re, b.first)),
            second: self.second.times_plus(a.re, a.second.times_plus(self.re, b.second)),
            hessian: self.first.mul_add(a.second, self.second.mul_add(a.first, own)),
        }
    }
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        self.with(
            b,
            self.re.scale_add(a, b.re),
            #[inline(always)]
            |x, y| x.scale_add(a, y),
        )
    }
}

impl<P: Register> Number for Pair<P> {
    #[inline(always)]
    fn re(self) -> f64 {
        self.re.0
    }
}
