/// Declares a lane type for a register. Its arguments:
///
/// - `not_inlined`: module of `number/inlined.rs` for the instructions of the register; `plain` for
///   baseline instructions
/// - `operators`: sum, difference, product and quotient
/// - `spread`: register with one number in all lanes
/// - `fused`: a b + c, rounded once if a fused operation is as fast
/// - `root`: square root
/// - `least`: minimum and maximum of two numbers; NaN if the second is NaN
/// - `power`: 2ᵏ from k + `ROUNDER`
/// - `below`: comparison x < limit as a bit mask; lane 0 is the lowest bit
/// - `select`: `yes` where the bit of the mask is set, `no` elsewhere
/// - `root and inverse`, optional: √x and 1/√x.
macro_rules! pack {
    (
        $(#[doc = $doc:literal])+
        $Pack:ident($Register:ident) of $width:literal not_inlined $not_inlined:ident,
        {
            operators $add:ident $sub:ident $mul:ident $div:ident,
            spread $set:ident, fused |$a:ident, $b:ident, $c:ident| $mul_add:expr, root $sqrt:ident, least $min:ident $max:ident,
            power |$rounded:ident| $power:expr, below |$x:ident, $limit:ident| $below:expr,
            select |$yes:ident, $no:ident, $mask:ident| $select:expr
            $(, root and inverse |$square:ident| $sqrt_recip:expr)?
        }
    ) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $Pack($Register);

        impl $Pack {
            #[inline(always)]
            pub fn from_array(values: [f64; $width]) -> Self {
                // SAFETY: the register has the layout of the array
                Self(unsafe { std::mem::transmute::<[f64; $width], $Register>(values) })
            }
            #[inline(always)]
            pub fn to_array(self) -> [f64; $width] {
                // SAFETY: as above
                unsafe { std::mem::transmute::<$Register, [f64; $width]>(self.0) }
            }
            #[inline(always)]
            fn each(self, f: impl Fn(f64) -> f64) -> Self {
                let values = self.to_array();
                Self::with_values(inlined!(|lane| f(values[lane])))
            }
        }

        pack!(operator $Pack Add add $add);
        pack!(operator $Pack Sub sub $sub);
        pack!(operator $Pack Mul mul $mul);
        pack!(operator $Pack Div div $div);

        impl Neg for $Pack {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::constant(-0.0) - self
            }
        }

        impl Powers for $Pack {
            #[inline(always)]
            fn two_to(rounded: Self) -> Self {
                let $rounded = rounded.0;
                Self(unsafe { $power })
            }
            #[inline(always)]
            fn clamped(self, low: f64, high: f64) -> Self {
                // NaN stays NaN
                Self(unsafe { $min($set(high), $max($set(low), self.0)) })
            }
        }

        impl Numbers for $Pack {
            type Mask = Bits<$width>;

            #[inline(always)]
            fn constant(value: f64) -> Self {
                Self(unsafe { $set(value) })
            }
            #[inline(always)]
            fn recip(self) -> Self {
                Self::constant(1.0) / self
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }
            $(
                #[inline(always)]
                fn sqrt_recip(self) -> (Self, Self) {
                    let $square = self;
                    $sqrt_recip
                }
            )?
            #[inline(always)]
            fn exp(self) -> Self {
                exponential::exp(self)
            }
            #[inline(always)]
            fn exp_m1(self) -> Self {
                exponential::exp_m1(self)
            }
            #[inline(always)]
            fn ln(self) -> Self {
                Self::not_inlined(inlined!(|| self.each(f64::ln)))
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                // not inlined: an impact calls `sin_cos` six times
                Self::not_inlined(inlined!(|| sine::sin_cos(self, inlined!(|x: Self| (x.each(f64::sin), x.each(f64::cos))))))
            }
            #[inline(always)]
            fn atan(self) -> Self {
                Self::not_inlined(inlined!(|| self.each(f64::atan)))
            }
            #[inline(always)]
            fn tanh(self) -> Self {
                tanh(self)
            }
            #[inline(always)]
            fn below(self, limit: f64) -> Bits<$width> {
                let ($x, $limit) = (self.0, Self::constant(limit).0);
                Bits(unsafe { $below } as u8)
            }
            #[inline(always)]
            fn select(self, other: Self, mask: Bits<$width>) -> Self {
                let ($yes, $no, $mask) = (self.0, other.0, mask.0);
                Self(unsafe { $select })
            }
            #[inline(always)]
            fn without_derivatives(self) -> Self {
                self
            }
            #[inline(always)]
            fn is_finite(self) -> Bits<$width> {
                // x − x is 0 for a finite x and otherwise NaN; comparisons with NaN are false
                (self - self).below(1.0)
            }
            #[inline(always)]
            fn gather<const N: usize>(self, other: Self, place: impl Fn(f64, f64) -> &'static [f64; N]) -> [Self; N] {
                let (x, y) = (self.to_array(), other.to_array());
                let mut lanes = [[0.0; $width]; N];
                let mut lane = 0;
                while lane < $width {
                    let (found, mut i) = (place(x[lane], y[lane]), 0);
                    while i < N {
                        lanes[i][lane] = found[i];
                        i += 1;
                    }
                    lane += 1;
                }
                let (mut all, mut i) = ([Self::constant(0.0); N], 0);
                while i < N {
                    all[i] = Self::from_array(lanes[i]);
                    i += 1;
                }
                all
            }
            #[inline(always)]
            fn not_inlined<R>(work: impl FnMut() -> R) -> R {
                unsafe { crate::number::inlined::$not_inlined::not_inlined(work) }
            }
            #[inline(always)]
            fn mul_add(self, a: Self, b: Self) -> Self {
                let ($a, $b, $c) = (self.0, a.0, b.0);
                Self(unsafe { $mul_add })
            }
            #[inline(always)]
            fn scale_add(self, a: f64, b: Self) -> Self {
                self.mul_add(Self::constant(a), b)
            }
        }

        impl Lanes for $Pack {
            const WIDTH: usize = $width;
            const DIRECTIONS: usize = 0;
            type Lane = f64;

            #[inline(always)]
            fn lane(self, i: usize) -> f64 {
                self.to_array()[i]
            }
            #[inline(always)]
            fn with_values(mut f: impl FnMut(usize) -> f64) -> Self {
                // a loop, because `array::from_fn` may compile to a call per lane
                let (mut values, mut lane) = ([0.0; $width], 0);
                while lane < $width {
                    values[lane] = f(lane);
                    lane += 1;
                }
                Self::from_array(values)
            }
            #[inline(always)]
            fn seeded(self, _: &impl Fn(usize) -> Self::Mask, _: usize) -> Self {
                self
            }
        }

    };

    (operator $Pack:ident $Operator:ident $operation:ident $instruction:ident) => {
        impl $Operator for $Pack {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: Self) -> Self {
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }

        impl $Operator<f64> for $Pack {
            type Output = Self;
            #[inline(always)]
            fn $operation(self, other: f64) -> Self {
                self.$operation(Self::constant(other))
            }
        }
    };
}
