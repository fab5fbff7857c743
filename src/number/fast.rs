#[cfg(target_arch = "x86_64")]
use super::{Free2, Free4, Pack2, Pack4, Pack8, Pair};
use super::{Fused, Jet, Jet2, Number};

/// A number in plain arrays, and what holds the same in the registers of a vector unit.
pub(crate) trait Fast: Number {
    /// With fused multiply–add, and registers of four.
    type Four: Counterpart<Self>;
    /// The same, among as many registers as a processor with registers of eight has.
    type Eight: Counterpart<Self>;
}

/// A number that holds the same as a plain one.
pub(crate) trait Counterpart<T>: Number {
    /// From the plain one.
    fn made_of(plain: T) -> Self;
    /// The plain one.
    fn plain(self) -> T;
}

impl Fast for f64 {
    type Four = Fused;
    type Eight = Fused;
}

impl Counterpart<f64> for Fused {
    #[inline(always)]
    fn made_of(plain: f64) -> Self {
        Self(plain)
    }
    #[inline(always)]
    fn plain(self) -> f64 {
        self.0
    }
}

impl Fast for Jet2<2, 3> {
    #[cfg(target_arch = "x86_64")]
    type Four = Pair<Pack4>;
    #[cfg(target_arch = "x86_64")]
    type Eight = Pair<Free4>;
    #[cfg(not(target_arch = "x86_64"))]
    type Four = Self;
    #[cfg(not(target_arch = "x86_64"))]
    type Eight = Self;
}

#[cfg(not(target_arch = "x86_64"))]
impl Counterpart<Self> for Jet2<2, 3> {
    fn made_of(plain: Self) -> Self {
        plain
    }
    fn plain(self) -> Self {
        self
    }
}

/// Jets of `$n` directions in `$k` registers of `$width`.
macro_rules! registers {
    ($n:literal = $k:literal x $Pack:ident of $width:literal) => {
        #[cfg(target_arch = "x86_64")]
        impl Counterpart<Jet<$n>> for Jet<$k, Fused, $Pack> {
            #[inline(always)]
            fn made_of(plain: Jet<$n>) -> Self {
                const { assert!($n == $k * $width) };
                let mut gradient = [$Pack::from_array([0.0; $width]); $k];
                for (register, directions) in gradient.iter_mut().zip(plain.gradient.as_chunks().0) {
                    *register = $Pack::from_array(*directions);
                }
                Self { re: Fused(plain.re), gradient }
            }
            #[inline(always)]
            fn plain(self) -> Jet<$n> {
                let mut gradient = [0.0; $n];
                for (register, directions) in self.gradient.iter().zip(gradient.as_chunks_mut().0) {
                    *directions = register.to_array();
                }
                Jet { re: self.re.0, gradient }
            }
        }
    };
}

/// Jets of `$n` directions: what holds them at each level.
macro_rules! fast {
    ($n:literal: $Four:ty, $Eight:ty) => {
        impl Fast for Jet<$n> {
            #[cfg(target_arch = "x86_64")]
            type Four = $Four;
            #[cfg(target_arch = "x86_64")]
            type Eight = $Eight;
            #[cfg(not(target_arch = "x86_64"))]
            type Four = Self;
            #[cfg(not(target_arch = "x86_64"))]
            type Eight = Self;
        }

        #[cfg(not(target_arch = "x86_64"))]
        impl Counterpart<Self> for Jet<$n> {
            fn made_of(plain: Self) -> Self {
                plain
            }
            fn plain(self) -> Self {
                self
            }
        }
    };
}

registers!(2 = 1 x Pack2 of 2);
registers!(2 = 1 x Free2 of 2);
fast!(2: Jet<1, Fused, Pack2>, Jet<1, Fused, Free2>);
registers!(8 = 2 x Pack4 of 4);
registers!(8 = 1 x Pack8 of 8);
registers!(12 = 3 x Pack4 of 4);
fast!(12: Jet<3, Fused, Pack4>, Jet<3, Fused, Pack4>);
registers!(24 = 3 x Pack8 of 8);

/// A jet of 8 K directions in registers of eight, which [`Level::Eight`](super::Level::Eight) has.
#[cfg(target_arch = "x86_64")]
pub(crate) type Wide<const K: usize> = Jet<K, Fused, Pack8>;
