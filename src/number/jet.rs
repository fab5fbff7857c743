//! Dual numbers of a fixed number of directions, held in plain arrays.
//!
//! num-dual keeps its vectors of derivatives in an `Option`, which saves work where much is constant but costs
//! a branch and a copy in every operation: through a flight, two to three times these. Its types are the
//! oracle these are tested against.

use super::Number;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with its first derivatives in `N` directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<const N: usize> {
    /// The value.
    pub re: f64,
    /// First derivatives.
    pub gradient: [f64; N],
}

/// A value with its first and second derivatives in `N` directions; `M` must be N (N + 1)/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet2<const N: usize, const M: usize> {
    /// The value.
    pub re: f64,
    /// First derivatives.
    pub gradient: [f64; N],
    /// Lower triangle of the second derivatives, row by row: (0,0), (1,0), (1,1), (2,0) …
    pub hessian: [f64; M],
}

impl<const N: usize> Jet<N> {
    /// The independent variable of a direction.
    pub fn variable(re: f64, direction: usize) -> Self {
        let mut jet = Self::constant(re);
        jet.gradient[direction] = 1.0;
        jet
    }

    /// Chain rule: f(x) from f(x.re) and f′(x.re).
    #[inline(always)]
    fn chain(self, f: f64, slope: f64) -> Self {
        Self { re: f, gradient: self.gradient.map(|d| slope * d) }
    }

    /// Product rule.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        let rule = |a, b| a * other.re + self.re * b;
        Self { re: self.re * other.re, gradient: zip(self.gradient, other.gradient, rule) }
    }

    /// Quotient rule.
    #[inline(always)]
    fn quotient(self, other: Self) -> Self {
        let inverse = other.re.recip();
        let re = self.re * inverse;
        Self { re, gradient: zip(self.gradient, other.gradient, |a, b| (a - re * b) * inverse) }
    }
}

impl<const N: usize, const M: usize> Jet2<N, M> {
    /// The independent variable of a direction.
    pub fn variable(re: f64, direction: usize) -> Self {
        let mut jet = Self::constant(re);
        jet.gradient[direction] = 1.0;
        jet
    }

    /// The second derivative in two directions.
    pub fn second(&self, i: usize, j: usize) -> f64 {
        let (row, column) = (i.max(j), i.min(j));
        self.hessian[row * (row + 1) / 2 + column]
    }

    /// A triangle with these entries.
    #[inline(always)]
    fn triangle(entry: impl Fn(usize, usize, usize) -> f64) -> [f64; M] {
        const { assert!(M == N * (N + 1) / 2) };
        let mut all = [0.0; M];
        let mut k = 0;
        for i in 0..N {
            for j in 0..=i {
                all[k] = entry(k, i, j);
                k += 1;
            }
        }
        all
    }

    /// Chain rule: f(x) from f(x.re), f′(x.re) and f″(x.re).
    #[inline(always)]
    fn chain(self, f: f64, slope: f64, curvature: f64) -> Self {
        let (g, h) = (self.gradient, self.hessian);
        let bent = g.map(|d| curvature * d);
        Self { re: f, gradient: g.map(|d| slope * d), hessian: Self::triangle(|k, i, j| slope * h[k] + bent[i] * g[j]) }
    }

    /// Product rule.
    #[inline(always)]
    fn product(self, other: Self) -> Self {
        let (a, b) = (&self, &other);
        Self {
            re: a.re * b.re,
            gradient: zip(a.gradient, b.gradient, |da, db| da * b.re + a.re * db),
            hessian: Self::triangle(|k, i, j| {
                let own = a.hessian[k] * b.re + a.re * b.hessian[k];
                own + (a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i])
            }),
        }
    }

    /// Quotient rule.
    #[inline(always)]
    fn quotient(self, other: Self) -> Self {
        self.product(other.recip())
    }
}

#[inline(always)]
fn zip<const N: usize>(a: [f64; N], b: [f64; N], f: impl Fn(f64, f64) -> f64) -> [f64; N] {
    std::array::from_fn(|i| f(a[i], b[i]))
}

impl<const N: usize> Add for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, gradient: zip(self.gradient, other.gradient, |a, b| a + b) }
    }
}

impl<const N: usize> Sub for Jet<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, gradient: zip(self.gradient, other.gradient, |a, b| a - b) }
    }
}

impl<const N: usize, const M: usize> Add for Jet2<N, M> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            gradient: zip(self.gradient, other.gradient, |a, b| a + b),
            hessian: zip(self.hessian, other.hessian, |a, b| a + b),
        }
    }
}

impl<const N: usize, const M: usize> Sub for Jet2<N, M> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            re: self.re - other.re,
            gradient: zip(self.gradient, other.gradient, |a, b| a - b),
            hessian: zip(self.hessian, other.hessian, |a, b| a - b),
        }
    }
}

/// What both jets do alike: the elementary functions, with `f`, `f′` and, for the second, `f″` at the value, and
/// the operators on plain numbers.
macro_rules! jet_functions {
    ($Jet:ident<$($n:ident),+>, |$x:ident, $f:ident, $d:ident, $d2:ident| $chain:expr, zero: { $($zero:ident),+ }) => {
        impl<$(const $n: usize),+> Number for $Jet<$($n),+> {
            #[inline(always)]
            fn constant(re: f64) -> Self {
                Self { re, $($zero: [0.0; _]),+ }
            }
            #[inline(always)]
            fn re(self) -> f64 {
                self.re
            }
            #[inline(always)]
            fn recip(self) -> Self {
                let ($x, $f) = (self, self.re.recip());
                let $d = -$f * $f;
                let $d2 = -2.0 * $d * $f;
                $chain
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                let ($x, $f) = (self, self.re.sqrt());
                let $d = 0.5 / $f;
                let $d2 = -0.5 * $d / self.re;
                $chain
            }
            #[inline(always)]
            fn exp(self) -> Self {
                let ($x, $f) = (self, self.re.exp());
                let ($d, $d2) = ($f, $f);
                $chain
            }
            #[inline(always)]
            fn exp_m1(self) -> Self {
                let ($x, $f) = (self, self.re.exp_m1());
                let $d = self.re.exp();
                let $d2 = $d;
                $chain
            }
            #[inline(always)]
            fn ln(self) -> Self {
                let ($x, $f, $d) = (self, self.re.ln(), self.re.recip());
                let $d2 = -$d * $d;
                $chain
            }
            #[inline(always)]
            fn ln_1p(self) -> Self {
                let ($x, $f, $d) = (self, self.re.ln_1p(), (1.0 + self.re).recip());
                let $d2 = -$d * $d;
                $chain
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let (sin, cos) = self.re.sin_cos();
                let $x = self;
                let sine = { let ($f, $d, $d2) = (sin, cos, -sin); $chain };
                let cosine = { let ($f, $d, $d2) = (cos, -sin, -cos); $chain };
                (sine, cosine)
            }
            #[inline(always)]
            fn atan(self) -> Self {
                let ($x, $f, $d) = (self, self.re.atan(), (1.0 + self.re * self.re).recip());
                let $d2 = -2.0 * self.re * $d * $d;
                $chain
            }
        }

        impl<$(const $n: usize),+> Mul for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                self.product(other)
            }
        }

        impl<$(const $n: usize),+> Div for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                self.quotient(other)
            }
        }

        impl<$(const $n: usize),+> Neg for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self * -1.0
            }
        }

        impl<$(const $n: usize),+> Add<f64> for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn add(mut self, other: f64) -> Self {
                self.re += other;
                self
            }
        }

        impl<$(const $n: usize),+> Sub<f64> for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn sub(mut self, other: f64) -> Self {
                self.re -= other;
                self
            }
        }

        impl<$(const $n: usize),+> Mul<f64> for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: f64) -> Self {
                Self { re: self.re * other, $($zero: self.$zero.map(|d| d * other)),+ }
            }
        }

        impl<$(const $n: usize),+> Div<f64> for $Jet<$($n),+> {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: f64) -> Self {
                let inverse = other.recip();
                self.mul(inverse)
            }
        }
    };
}

jet_functions! { Jet<N>, |x, f, d, _d2| x.chain(f, d), zero: { gradient } }
jet_functions! { Jet2<N, M>, |x, f, d, d2| x.chain(f, d, d2), zero: { gradient, hessian } }
