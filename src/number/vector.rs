use super::Number;
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
    /// Right of the target line, towards the toe of the club.
    pub y: T,
    /// Downrange.
    pub z: T,
}

impl<T> Vector<T> {
    /// The vector with these components.
    #[inline]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
}

impl<T: Number> Vector<T> {
    /// The zero vector.
    #[inline]
    pub fn zero() -> Self {
        Self::new(T::zero(), T::zero(), T::zero())
    }

    /// Scalar product.
    #[inline]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Vector product.
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// Euclidean length. Its derivative does not exist at zero length.
    #[inline]
    pub fn norm(self) -> T {
        self.dot(self).sqrt()
    }

    /// The components' values, without derivatives.
    pub fn re(self) -> Vector<f64> {
        Vector::new(self.x.re(), self.y.re(), self.z.re())
    }

    /// The components in order.
    #[inline]
    pub fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// The vector with these components in order.
    #[inline]
    pub fn from_array([x, y, z]: [T; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<T: Number> Add for Vector<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<T: Number> Sub for Vector<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<T: Number> Neg for Vector<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<T: Number> Mul<T> for Vector<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}
