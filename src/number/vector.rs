use super::Numbers;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector of three components; in the ground frame x is up, y right and z downrange.
///
/// ```
/// use longdrive::number::Vector;
/// let (up, right) = (Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0));
/// assert_eq!(up.cross(right), Vector::new(0.0, 0.0, 1.0)); // downrange
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<T> {
    /// Up.
    pub x: T,
    /// Right of the target line; in the head frame, towards the toe of the club.
    pub y: T,
    /// Downrange.
    pub z: T,
}

impl<T> Vector<T> {
    /// Vector with these components.
    #[inline(always)]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Converts each component.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U) -> Vector<U>
    where
        T: Copy,
    {
        Vector::new(f(self.x), f(self.y), f(self.z))
    }
}

impl<T: Numbers> Vector<T> {
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(T::zero(), T::zero(), T::zero())
    }

    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        self.x
            .mul_add(other.x, self.y.mul_add(other.y, self.z * other.z))
    }

    /// Vector product.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            (-self.z).mul_add(other.y, self.y * other.z),
            (-self.x).mul_add(other.z, self.z * other.x),
            (-self.y).mul_add(other.x, self.x * other.y),
        )
    }

    /// k v + b, with v = `self` and a factor k that has no derivatives.
    #[inline(always)]
    pub(crate) fn scale_add(self, k: f64, b: Self) -> Self {
        Self::new(
            self.x.scale_add(k, b.x),
            self.y.scale_add(k, b.y),
            self.z.scale_add(k, b.z),
        )
    }

    /// Selects lanes: `self` where the mask is true, `other` elsewhere.
    #[inline(always)]
    pub(crate) fn select(self, other: Self, mask: T::Mask) -> Self {
        Self::new(
            self.x.select(other.x, mask),
            self.y.select(other.y, mask),
            self.z.select(other.z, mask),
        )
    }

    /// Euclidean norm; its derivatives are not finite at 0.
    #[inline(always)]
    pub fn norm(self) -> T {
        self.dot(self).sqrt()
    }

    /// Components in order.
    #[inline(always)]
    pub fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// Vector with these components in order.
    #[inline(always)]
    pub fn from_array([x, y, z]: [T; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<T: Numbers> Add for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<T: Numbers> Sub for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<T: Numbers> Neg for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<T: Numbers> Mul<T> for Vector<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}
