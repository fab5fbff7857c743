//! Dual numbers with a fixed number of directions, in plain arrays or vector registers.
//!
//! num-dual keeps vectors of derivatives in an `Option`. This saves work if most numbers are
//! constant, but costs a branch and a copy in every operation: a flight takes two to three times as
//! long. The tests compare the types of this file with num-dual's.

use super::{Number, Numbers, inlined};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `each!(self, i: K => expression)`: `expression` for each index `i` of the gradient of `self`.
/// The first three indices are unrolled by hand: loops of one to three rounds took two thirds of
/// the compile time.
macro_rules! each {
    ($self:ident, $i:ident : $K:expr => $value:expr) => {{
        let mut all = $self.gradient;
        if $K > 0 {
            let $i = 0;
            all[$i] = $value;
        }
        if $K > 1 {
            let $i = 1;
            all[$i] = $value;
        }
        if $K > 2 {
            let $i = 2;
            all[$i] = $value;
        }
        if $K > 3 {
            let mut $i = 3;
            while $i < $K {
                all[$i] = $value;
                $i += 1;
            }
        }
        all
    }};
}

/// Array of K equal numbers. For K ≤ 3 there is no loop, which shortens the compile time.
#[inline(always)]
fn filled<B: Copy, const K: usize>(number: B) -> [B; K] {
    [number, number, number]
        .first_chunk()
        .copied()
        .unwrap_or([number; K])
}

/// Dual number: a value of type `B` (by default `f64`) with its first derivatives in `K`
/// directions. If `B` has lanes, the lanes are different drives, or one drive with different
/// directions. A nested jet also has second derivatives: see [`Mixed`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<const K: usize, B = f64> {
    /// Value.
    pub re: B,
    /// First derivatives.
    pub gradient: [B; K],
}

/// Value, derivatives in two directions, and the mixed second derivative.
pub type Mixed<B = f64> = Jet<1, Jet<1, B>>;

impl<const K: usize, B: Numbers> Jet<K, B> {
    /// Independent variable with the value `re`: its derivative is 1 in `direction` (from 0 to K −
    /// 1), and 0 in the other directions.
    ///
    /// # Panics
    /// If there is no such direction.
    pub fn variable(re: B, direction: usize) -> Self {
        let mut jet = Self {
            re,
            gradient: filled(B::zero()),
        };
        jet.gradient[direction] = B::constant(1.0);
        jet
    }

    /// Chain rule: f(x) from f(x.re) and f′(x.re).
    #[inline(always)]
    fn chain(self, f: B, slope: B) -> Self {
        Self {
            re: f,
            gradient: each!(self, i: K => self.gradient[i] * slope),
        }
    }
}

impl<const K: usize, B: Numbers> Add for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            gradient: each!(self, i: K => self.gradient[i] + other.gradient[i]),
        }
    }
}

impl<const K: usize, B: Numbers> Sub for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            re: self.re - other.re,
            gradient: each!(self, i: K => self.gradient[i] - other.gradient[i]),
        }
    }
}

impl<const K: usize, B: Numbers> Mul for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product =
            each!(self, i: K => self.gradient[i].mul_add(other.re, other.gradient[i] * self.re));
        Self {
            re: self.re * other.re,
            gradient: product,
        }
    }
}

impl<const K: usize, B: Numbers> Div for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let inverse = other.re.recip();
        let re = self.re * inverse;
        let change =
            each!(self, i: K => other.gradient[i].mul_add(-re, self.gradient[i]) * inverse);
        Self {
            re,
            gradient: change,
        }
    }
}

impl<const K: usize, B: Numbers> Neg for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            re: -self.re,
            gradient: each!(self, i: K => -self.gradient[i]),
        }
    }
}

impl<const K: usize, B: Numbers> Add<f64> for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self {
            re: self.re + other,
            ..self
        }
    }
}

impl<const K: usize, B: Numbers> Sub<f64> for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        Self {
            re: self.re - other,
            ..self
        }
    }
}

impl<const K: usize, B: Numbers> Mul<f64> for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        Self {
            re: self.re * other,
            gradient: each!(self, i: K => self.gradient[i] * other),
        }
    }
}

impl<const K: usize, B: Numbers> Div<f64> for Jet<K, B> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self.mul(other.recip())
    }
}

impl<const K: usize, B: Numbers> Numbers for Jet<K, B> {
    type Mask = B::Mask;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self {
            re: B::constant(value),
            gradient: filled(B::zero()),
        }
    }
    #[inline(always)]
    fn recip(self) -> Self {
        let f = self.re.recip();
        self.chain(f, -(f * f))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let (f, inverse) = self.re.sqrt_recip();
        self.chain(f, inverse * 0.5)
    }
    #[inline(always)]
    fn sqrt_recip(self) -> (Self, Self) {
        let (f, inverse) = self.re.sqrt_recip();
        let slope = inverse * 0.5;
        (
            self.chain(f, slope),
            self.chain(inverse, -(slope * inverse * inverse)),
        )
    }
    #[inline(always)]
    fn exp(self) -> Self {
        let f = self.re.exp();
        self.chain(f, f)
    }
    #[inline(always)]
    fn exp_m1(self) -> Self {
        let f = self.re.exp_m1();
        self.chain(f, f + 1.0)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.chain(self.re.ln(), self.re.recip())
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.re.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    #[inline(always)]
    fn atan(self) -> Self {
        self.chain(self.re.atan(), (self.re * self.re + 1.0).recip())
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        let f = self.re.tanh();
        self.chain(f, (-f).mul_add(f, B::constant(1.0)))
    }
    #[inline(always)]
    fn below(self, limit: f64) -> Self::Mask {
        self.re.below(limit)
    }
    #[inline(always)]
    fn select(self, other: Self, mask: Self::Mask) -> Self {
        let gradient = each!(self, i: K => self.gradient[i].select(other.gradient[i], mask));
        Self {
            re: self.re.select(other.re, mask),
            gradient,
        }
    }
    #[inline(always)]
    fn without_derivatives(self) -> Self {
        Self {
            re: self.re.without_derivatives(),
            gradient: filled(B::zero()),
        }
    }
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        self.re.is_finite()
    }
    #[inline(always)]
    fn gather<const N: usize>(
        self,
        other: Self,
        place: impl Fn(f64, f64) -> &'static [f64; N],
    ) -> [Self; N] {
        let found = self.re.gather(other.re, place);
        let mut all = [Self::zero(); N];
        let mut i = 0;
        while i < N {
            all[i].re = found[i];
            i += 1;
        }
        all
    }
    #[inline(always)]
    fn not_inlined<R>(work: impl FnMut() -> R) -> R {
        B::not_inlined(work)
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let other = inlined!(|i: usize| a.gradient[i].mul_add(self.re, b.gradient[i]));
        Self {
            re: self.re.mul_add(a.re, b.re),
            gradient: each!(self, i: K => self.gradient[i].mul_add(a.re, other(i))),
        }
    }
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        Self {
            re: self.re.scale_add(a, b.re),
            gradient: each!(self, i: K => self.gradient[i].scale_add(a, b.gradient[i])),
        }
    }
}

impl<const K: usize, B: Number> Number for Jet<K, B> {
    #[inline(always)]
    fn re(self) -> f64 {
        self.re.re()
    }
}

/// Access to derivatives. In nested jets, the directions of the outer jet are numbered first, then
/// the directions of the inner jet.
pub(crate) trait Derivatives: Number {
    /// First derivative in one direction.
    fn first(&self, direction: usize) -> f64;
    /// Second derivative in directions 0 and 1; 0 if the type has none.
    fn second(&self) -> f64;
}

impl Derivatives for f64 {
    fn first(&self, _: usize) -> f64 {
        0.0
    }

    fn second(&self) -> f64 {
        0.0
    }
}

impl<const K: usize, B: Derivatives> Derivatives for Jet<K, B> {
    fn first(&self, direction: usize) -> f64 {
        if direction < K {
            self.gradient[direction].re()
        } else {
            self.re.first(direction - K)
        }
    }

    fn second(&self) -> f64 {
        self.gradient[0].first(0)
    }
}
