use crate::number::{Factor, Numbers, Vector, inlined};
use std::ops::{Add, Sub};

/// What can be added and multiplied by numbers.
pub(super) trait Linear<T>: Copy + Add<Output = Self> + Sub<Output = Self> {
    /// k `self` + base, with a plain factor.
    fn along(self, k: f64, base: Self) -> Self;
    /// k `self` + base.
    fn times_plus(self, k: T, base: Self) -> Self;
    /// k `self`, with a plain factor.
    fn scaled(self, k: f64) -> Self;
}

impl<T: Numbers> Linear<T> for T {
    #[inline(always)]
    fn along(self, k: f64, base: Self) -> Self {
        self.scale_add(k, base)
    }
    #[inline(always)]
    fn times_plus(self, k: T, base: Self) -> Self {
        self.mul_add(k, base)
    }
    #[inline(always)]
    fn scaled(self, k: f64) -> Self {
        self * k
    }
}

/// Where a flight takes place: the whole of space ([`Vector`]), or, where nothing moves or blows sideways and the spin axis
/// lies across, the vertical plane of the target line ([`Plane`]). The equation of motion is written over either.
pub(super) trait Space<T: Numbers>: Linear<T> {
    /// A spin axis: what a velocity is turned about.
    type Axis: Copy;

    /// The part of a vector that lies in this space.
    fn of(v: Vector<T>) -> Self;
    /// The vector.
    fn in_space(self) -> Vector<T>;
    /// The part of an axis that turns within this space.
    fn axis(v: Vector<T>) -> Self::Axis;
    /// The axis, k times as long.
    fn longer(axis: Self::Axis, k: T) -> Self::Axis;
    /// axis × v + k v.
    fn turned_and_pushed(self, axis: Self::Axis, k: T) -> Self;
    /// The same times |v|, given with its inverse.
    fn turned_and_pushed_by_size(self, axis: Self::Axis, k: T, size: T, inverse: T) -> Self;
    /// As [`Numbers::with_derivatives_of`].
    fn with_derivatives_of(self, other: Self) -> Self;
    /// v·v + more.
    fn square_plus(self, more: f64) -> T;
    /// The vector k higher.
    fn raised(self, k: impl Factor<T>) -> Self;
    /// Its upward component.
    fn up(self) -> T;
    /// `self` where the mask holds, `other` where it does not.
    fn blend(self, other: Self, mask: T::Mask) -> Self;
}

impl<T: Numbers> Linear<T> for Vector<T> {
    #[inline(always)]
    fn along(self, k: f64, base: Self) -> Self {
        Self::new(self.x.scale_add(k, base.x), self.y.scale_add(k, base.y), self.z.scale_add(k, base.z))
    }
    #[inline(always)]
    fn times_plus(self, k: T, base: Self) -> Self {
        Self::new(self.x.mul_add(k, base.x), self.y.mul_add(k, base.y), self.z.mul_add(k, base.z))
    }
    #[inline(always)]
    fn scaled(self, k: f64) -> Self {
        Self::new(self.x * k, self.y * k, self.z * k)
    }
}

impl<T: Numbers> Space<T> for Vector<T> {
    type Axis = Self;

    #[inline(always)]
    fn of(v: Vector<T>) -> Self {
        v
    }
    #[inline(always)]
    fn in_space(self) -> Vector<T> {
        self
    }
    #[inline(always)]
    fn axis(v: Vector<T>) -> Self {
        v
    }
    #[inline(always)]
    fn longer(axis: Self, k: T) -> Self {
        axis * k
    }
    #[inline(always)]
    fn turned_and_pushed(self, axis: Self, k: T) -> Self {
        let turned = inlined(
            #[inline(always)]
            |a: T, b: T, c: T, d: T, pushed: T| a.mul_add(b, (-c).mul_add(d, pushed * k)),
        );
        Self::new(
            turned(axis.y, self.z, axis.z, self.y, self.x),
            turned(axis.z, self.x, axis.x, self.z, self.y),
            turned(axis.x, self.y, axis.y, self.x, self.z),
        )
    }
    #[inline(always)]
    fn turned_and_pushed_by_size(self, axis: Self, k: T, size: T, _inverse: T) -> Self {
        self.turned_and_pushed(axis, k) * size
    }
    #[inline(always)]
    fn with_derivatives_of(self, _other: Self) -> Self {
        // both ways are the same one
        self
    }
    #[inline(always)]
    fn square_plus(self, more: f64) -> T {
        self.x.mul_add(self.x, self.y.mul_add(self.y, self.z.mul_add(self.z, T::constant(more))))
    }
    #[inline(always)]
    fn raised(self, k: impl Factor<T>) -> Self {
        Self::new(k.plus(self.x), self.y, self.z)
    }
    #[inline(always)]
    fn up(self) -> T {
        self.x
    }
    #[inline(always)]
    fn blend(self, other: Self, mask: T::Mask) -> Self {
        Self::new(self.x.blend(other.x, mask), self.y.blend(other.y, mask), self.z.blend(other.z, mask))
    }
}

/// A vector of the vertical plane through the target line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<T> {
    up: T,
    downrange: T,
}

impl<T: Numbers> Add for Plane<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { up: self.up + other.up, downrange: self.downrange + other.downrange }
    }
}

impl<T: Numbers> Sub for Plane<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { up: self.up - other.up, downrange: self.downrange - other.downrange }
    }
}

impl<T: Numbers> Linear<T> for Plane<T> {
    #[inline(always)]
    fn along(self, k: f64, base: Self) -> Self {
        Self { up: self.up.scale_add(k, base.up), downrange: self.downrange.scale_add(k, base.downrange) }
    }
    #[inline(always)]
    fn times_plus(self, k: T, base: Self) -> Self {
        Self { up: self.up.mul_add(k, base.up), downrange: self.downrange.mul_add(k, base.downrange) }
    }
    #[inline(always)]
    fn scaled(self, k: f64) -> Self {
        Self { up: self.up * k, downrange: self.downrange * k }
    }
}

impl<T: Numbers> Space<T> for Plane<T> {
    /// Along Y: what backspin turns about.
    type Axis = T;

    #[inline(always)]
    fn of(v: Vector<T>) -> Self {
        Self { up: v.x, downrange: v.z }
    }
    #[inline(always)]
    fn in_space(self) -> Vector<T> {
        Vector::new(self.up, T::zero(), self.downrange)
    }
    #[inline(always)]
    fn axis(v: Vector<T>) -> T {
        v.y
    }
    #[inline(always)]
    fn longer(axis: T, k: T) -> T {
        axis * k
    }
    #[inline(always)]
    fn turned_and_pushed(self, axis: T, k: T) -> Self {
        let [downrange, up] = T::complex_product([k, axis], [self.downrange, self.up]);
        Self { up, downrange }
    }
    #[inline(always)]
    fn turned_and_pushed_by_size(self, axis: T, k: T, size: T, inverse: T) -> Self {
        let [downrange, up] = T::sized_product([k, axis], [self.downrange, self.up], size, inverse);
        Self { up, downrange }
    }
    #[inline(always)]
    fn with_derivatives_of(self, other: Self) -> Self {
        Self {
            up: self.up.with_derivatives_of(other.up),
            downrange: self.downrange.with_derivatives_of(other.downrange),
        }
    }
    #[inline(always)]
    fn square_plus(self, more: f64) -> T {
        self.up.mul_add(self.up, self.downrange.mul_add(self.downrange, T::constant(more)))
    }
    #[inline(always)]
    fn raised(self, k: impl Factor<T>) -> Self {
        Self { up: k.plus(self.up), downrange: self.downrange }
    }
    #[inline(always)]
    fn up(self) -> T {
        self.up
    }
    #[inline(always)]
    fn blend(self, other: Self, mask: T::Mask) -> Self {
        Self { up: self.up.blend(other.up, mask), downrange: self.downrange.blend(other.downrange, mask) }
    }
}
