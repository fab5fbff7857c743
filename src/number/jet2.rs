use super::{Number, Numbers};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with its first and second derivatives in `N` directions; `M` must be N (N + 1)/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet2<const N: usize, const M: usize, B = f64> {
    /// The value.
    pub re: B,
    /// First derivatives.
    pub gradient: [B; N],
    /// Lower triangle of the second derivatives, row by row: (0,0), (1,0), (1,1), (2,0) …
    pub hessian: [B; M],
}

impl<const N: usize, const M: usize, B: Numbers> Jet2<N, M, B> {
    /// The independent variable of a direction.
    pub fn variable(re: B, direction: usize) -> Self {
        let mut jet = Self { re, ..Self::zero() };
        jet.gradient[direction] = B::constant(1.0);
        jet
    }

    /// The second derivative in two directions.
    pub fn second(&self, i: usize, j: usize) -> B {
        let (row, column) = (i.max(j), i.min(j));
        self.hessian[row * (row + 1) / 2 + column]
    }

    /// A triangle with these entries.
    #[inline(always)]
    fn triangle(entry: impl Fn(usize, usize, usize) -> B) -> [B; M] {
        const { assert!(M == N * (N + 1) / 2) };
        let mut all = [B::zero(); M];
        let mut k = 0;
        let mut i = 0;
        while i < N {
            let mut j = 0;
            while j <= i {
                all[k] = entry(k, i, j);
                k += 1;
                j += 1;
            }
            i += 1;
        }
        all
    }

    /// Chain rule: f(x) from f(x.re), f′(x.re) and f″(x.re).
    #[inline(always)]
    fn chain(self, f: B, slope: B, curvature: B) -> Self {
        let (g, h) = (self.gradient, self.hessian);
        let bent = each!(i: N => g[i] * curvature);
        Self {
            re: f,
            gradient: each!(i: N => g[i] * slope),
            hessian: Self::triangle(
                #[inline(always)]
                |k, i, j| h[k].mul_add(slope, bent[i] * g[j]),
            ),
        }
    }

    /// Product rule.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        let (a, b) = (&self, &other);
        Self {
            re: a.re * b.re,
            gradient: each!(i: N => a.gradient[i].mul_add(b.re, a.re * b.gradient[i])),
            hessian: Self::triangle(
                #[inline(always)]
                |k, i, j| {
                    let own = a.hessian[k].mul_add(b.re, a.re * b.hessian[k]);
                    own + a.gradient[i].mul_add(b.gradient[j], a.gradient[j] * b.gradient[i])
                },
            ),
        }
    }

    /// Each entry of two.
    #[inline(always)]
    pub(super) fn entrywise(self, other: Self, f: impl Fn(B, B) -> B) -> Self {
        Self {
            re: f(self.re, other.re),
            gradient: each!(i: N => f(self.gradient[i], other.gradient[i])),
            hessian: each!(i: M => f(self.hessian[i], other.hessian[i])),
        }
    }

    /// Each entry.
    #[inline(always)]
    pub(super) fn each(self, f: impl Fn(B) -> B) -> Self {
        Self {
            re: f(self.re),
            gradient: each!(i: N => f(self.gradient[i])),
            hessian: each!(i: M => f(self.hessian[i])),
        }
    }
}

impl<const N: usize, const M: usize, B: Numbers> Add for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.entrywise(
            other,
            #[inline(always)]
            |a, b| a + b,
        )
    }
}

impl<const N: usize, const M: usize, B: Numbers> Sub for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.entrywise(
            other,
            #[inline(always)]
            |a, b| a - b,
        )
    }
}

impl<const N: usize, const M: usize, B: Numbers> Mul for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.product(other)
    }
}

impl<const N: usize, const M: usize, B: Numbers> Div for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.mul(other.recip())
    }
}

impl<const N: usize, const M: usize, B: Numbers> Neg for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(
            #[inline(always)]
            |entry| -entry,
        )
    }
}

impl<const N: usize, const M: usize, B: Numbers> Add<f64> for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { re: self.re + other, ..self }
    }
}

impl<const N: usize, const M: usize, B: Numbers> Sub<f64> for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        Self { re: self.re - other, ..self }
    }
}

impl<const N: usize, const M: usize, B: Numbers> Mul<f64> for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self.each(
            #[inline(always)]
            |entry| entry * other,
        )
    }
}

impl<const N: usize, const M: usize, B: Numbers> Div<f64> for Jet2<N, M, B> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self.mul(other.recip())
    }
}

impl<const N: usize, const M: usize, B: Numbers> Numbers for Jet2<N, M, B> {
    type Mask = B::Mask;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self { re: B::constant(value), gradient: [B::zero(); N], hessian: [B::zero(); M] }
    }
    second_order_functions!();

    #[inline(always)]
    fn below(self, limit: f64) -> Self::Mask {
        self.re.below(limit)
    }
    #[inline(always)]
    fn blend(self, other: Self, mask: Self::Mask) -> Self {
        self.entrywise(
            other,
            #[inline(always)]
            |a, b| a.blend(b, mask),
        )
    }
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        self.re.is_finite()
    }
    #[inline(always)]
    fn outlined<R>(work: impl FnMut() -> R) -> R {
        B::outlined(work)
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self {
            re: self.re.mul_add(a.re, b.re),
            gradient: each!(i: N => self.gradient[i].mul_add(a.re, self.re.mul_add(a.gradient[i], b.gradient[i]))),
            hessian: Self::triangle(
                #[inline(always)]
                |k, i, j| {
                    let own = self.hessian[k].mul_add(a.re, self.re.mul_add(a.hessian[k], b.hessian[k]));
                    self.gradient[i].mul_add(a.gradient[j], self.gradient[j].mul_add(a.gradient[i], own))
                },
            ),
        }
    }
    #[inline(always)]
    fn scale_add(self, a: f64, b: Self) -> Self {
        self.entrywise(
            b,
            #[inline(always)]
            |x, y| x.scale_add(a, y),
        )
    }
}

impl<const N: usize, const M: usize, B: Number> Number for Jet2<N, M, B> {
    #[inline(always)]
    fn re(self) -> f64 {
        self.re.re()
    }
}
