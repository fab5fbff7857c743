//! Dual numbers of a fixed number of directions, held in plain arrays or in vector registers.
//!
//! num-dual keeps its vectors of derivatives in an `Option`, which saves work where much is constant but costs
//! a branch and a copy in every operation: through a flight, two to three times these. Its types are the
//! oracle these are tested against.

use super::{Number, Numbers, Partial, inlined};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with its first derivatives: `K` partial derivatives of a value over `B`, each a `P`. `Jet<2>` holds plain
/// numbers, two directions; where `P` is a vector register, `K` registers of directions; where `B` is lanes, as many
/// drives side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<const K: usize, B = f64, P = B> {
    /// The value.
    pub re: B,
    /// First derivatives.
    pub gradient: [P; K],
}

impl<const K: usize, B: Numbers> Jet<K, B> {
    /// The independent variable of a direction.
    pub fn variable(re: B, direction: usize) -> Self {
        let mut jet = Self { re, gradient: [B::zero(); K] };
        jet.gradient[direction] = B::constant(1.0);
        jet
    }
}

/// `each!(i: K => expression)`: an array of its values; `std::array::from_fn` is a call that the compiler does not always
/// take apart, and then the registers go through memory.
macro_rules! each {
    ($i:ident : $K:expr => $value:expr) => {{
        let mut all = [P::none(); $K];
        let mut $i = 0;
        while $i < $K {
            all[$i] = $value;
            $i += 1;
        }
        all
    }};
}

impl<const K: usize, B: Numbers, P: Partial<B>> Jet<K, B, P> {
    /// Chain rule: f(x) from f(x.re) and f′(x.re).
    #[inline(always)]
    fn chain(self, f: B, slope: B) -> Self {
        Self { re: f, gradient: each!(i: K => self.gradient[i].times(slope)) }
    }

    /// The product with a number without derivatives.
    #[inline(always)]
    pub(super) fn times_value(self, k: B) -> Self {
        Self { re: k * self.re, gradient: each!(i: K => self.gradient[i].times(k)) }
    }

    /// The same and another number.
    #[inline(always)]
    pub(super) fn times_value_plus(self, k: B, y: Self) -> Self {
        Self { re: k.mul_add(self.re, y.re), gradient: each!(i: K => self.gradient[i].times_plus(k, y.gradient[i])) }
    }
}

/// |z| c z in two ways, of which the first costs more for each direction and the second beforehand.
impl<const K: usize, B: Numbers, P: Partial<B>> Jet<K, B, P> {
    /// By the product rule: c z is |z| times as long and grows by (z·dz)/|z|.
    #[inline(always)]
    fn sized_product_by_direction(c: [Self; 2], z: [Self; 2], size: Self, inverse: Self) -> [Self; 2] {
        let ([a, b], [x, y], size) = ([c[0].re, c[1].re], [z[0].re, z[1].re], size.re);
        let product = B::complex_product([a, b], [x, y]);
        let part = inlined(
            #[inline(always)]
            |n: usize, change: [P; K]| Self {
                re: product[n] * size,
                gradient: each!(i: K => {
                    let grown = z[0].gradient[i].times_plus(x, z[1].gradient[i].times(y)).times(inverse.re);
                    grown.times_plus(product[n], change[i].times(size))
                }),
            },
        );
        let real = each!(i: K => {
            let by_c = c[0].gradient[i].times_plus(x, c[1].gradient[i].times(-y));
            z[0].gradient[i].times_plus(a, z[1].gradient[i].times_plus(-b, by_c))
        });
        let imaginary = each!(i: K => {
            let by_c = c[0].gradient[i].times_plus(y, c[1].gradient[i].times(x));
            z[1].gradient[i].times_plus(a, z[0].gradient[i].times_plus(b, by_c))
        });
        [part(0, real), part(1, imaginary)]
    }

    /// By the partial derivatives in the four parts of z and c, which are the same for every direction.
    #[inline(always)]
    fn sized_product_by_part(c: [Self; 2], z: [Self; 2], size: Self, inverse: Self) -> [Self; 2] {
        let ([a, b], [x, y], size) = ([c[0].re, c[1].re], [z[0].re, z[1].re], size.re);
        let product = B::complex_product([a, b], [x, y]);
        let (along, held, turned) = ([x * inverse.re, y * inverse.re], a * size, b * size);
        let (by_a, by_b) = ([x * size, y * size], [-(y * size), x * size]);
        let part = inlined(
            #[inline(always)]
            |n: usize, by_x: B, by_y: B| Self {
                re: product[n] * size,
                gradient: each!(i: K => {
                    let by_c = c[1].gradient[i].times_plus(by_b[n], c[0].gradient[i].times(by_a[n]));
                    z[0].gradient[i].times_plus(by_x, z[1].gradient[i].times_plus(by_y, by_c))
                }),
            },
        );
        [
            part(0, along[0].mul_add(product[0], held), along[1].mul_add(product[0], -turned)),
            part(1, along[0].mul_add(product[1], turned), along[1].mul_add(product[1], held)),
        ]
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Add for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, gradient: each!(i: K => self.gradient[i] + other.gradient[i]) }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Sub for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, gradient: each!(i: K => self.gradient[i] - other.gradient[i]) }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Mul for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let product = each!(i: K => self.gradient[i].times_plus(other.re, other.gradient[i].times(self.re)));
        Self { re: self.re * other.re, gradient: product }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Div for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let inverse = other.re.recip();
        let re = self.re * inverse;
        let change = each!(i: K => other.gradient[i].times_plus(-re, self.gradient[i]).times(inverse));
        Self { re, gradient: change }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Neg for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { re: -self.re, gradient: each!(i: K => -self.gradient[i]) }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Add<f64> for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { re: self.re + other, ..self }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Sub<f64> for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        Self { re: self.re - other, ..self }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Mul<f64> for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        Self { re: self.re * other, gradient: each!(i: K => self.gradient[i].scaled(other)) }
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Div<f64> for Jet<K, B, P> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self.mul(other.recip())
    }
}

impl<const K: usize, B: Numbers, P: Partial<B>> Numbers for Jet<K, B, P> {
    type Mask = B::Mask;
    type Value = B;
    // the values wait for each other as they do alone; the derivatives fill the time
    const IS_LONE: bool = B::IS_LONE;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self { re: B::constant(value), gradient: [P::none(); K] }
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
        (self.chain(f, slope), self.chain(inverse, -(slope * inverse * inverse)))
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
    fn known_exp_m1(self, value: B) -> Self {
        self.chain(value, value + 1.0)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.chain(self.re.ln(), self.re.recip())
    }
    #[inline(always)]
    fn ln_1p(self) -> Self {
        self.chain(self.re.ln_1p(), (self.re + 1.0).recip())
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
    fn below(self, limit: f64) -> Self::Mask {
        self.re.below(limit)
    }
    #[inline(always)]
    fn blend(self, other: Self, mask: Self::Mask) -> Self {
        let gradient = each!(i: K => self.gradient[i].either(other.gradient[i], mask));
        Self { re: self.re.blend(other.re, mask), gradient }
    }
    #[inline(always)]
    fn sized_product(c: [Self; 2], z: [Self; 2], size: Self, inverse: Self) -> [Self; 2] {
        if K == 1 {
            Self::sized_product_by_direction(c, z, size, inverse)
        } else {
            Self::sized_product_by_part(c, z, size, inverse)
        }
    }
    #[inline(always)]
    fn with_derivatives_of(self, other: Self) -> Self {
        Self { gradient: other.gradient, ..self }
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.re.is_zero() && self.gradient.iter().all(|d| d.vanishes())
    }
    #[inline(always)]
    fn is_constant(self) -> bool {
        self.gradient.iter().all(|d| d.vanishes())
    }
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        self.re.is_finite()
    }
    #[inline(always)]
    fn outlined<R>(work: impl FnOnce() -> R) -> R {
        P::outlined(work)
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        let other = inlined(
            #[inline(always)]
            |i: usize| a.gradient[i].times_plus(self.re, b.gradient[i]),
        );
        Self { re: self.re.mul_add(a.re, b.re), gradient: each!(i: K => self.gradient[i].times_plus(a.re, other(i))) }
    }
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        Self { re: self.re.scale_add(a, b.re), gradient: each!(i: K => self.gradient[i].scaled_plus(a, b.gradient[i])) }
    }
}

impl<const K: usize, B: Number, P: Partial<B>> Number for Jet<K, B, P> {
    #[inline(always)]
    fn re(self) -> f64 {
        self.re.re()
    }
}
