//! The club head with its movable weights.

use crate::number::{Numbers, Vector, inlined};
use crate::parameters::{Club, Weight};

/// A rigid head: mass, centre of mass and inertia tensor, with its movable weights (docs/model.md,
/// eqs. 5a–5c).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head<T> {
    /// Mass M, kg.
    pub mass: T,
    /// Distance d of the centre of mass behind the face, along the normal at the face centre, m.
    pub depth: T,
    /// c₁, c₂: position of the centre of mass above the face centre and towards the toe, m. `None`
    /// if the centre of mass is directly behind the face centre.
    pub cg_offset: Option<[T; 2]>,
    /// Inertia tensor about the centre of mass in the head frame, kg m², row by row.
    pub inertia: [[T; 3]; 3],
}

impl<T: Numbers> Head<T> {
    /// The head of a club.
    #[inline(always)]
    pub fn new(club: &Club<T>) -> Self {
        let cg_offset = match (club.cg_high, club.cg_toe) {
            (None, None) => None,
            (high, toe) => Some([high.unwrap_or_else(T::zero), toe.unwrap_or_else(T::zero)]),
        };
        let body = Self {
            mass: club.mass,
            depth: club.cg_depth,
            cg_offset,
            inertia: club.inertia(),
        };
        let weights = club.weights();
        if weights.iter().all(Option::is_none) {
            return body;
        }
        T::not_inlined(inlined!(|| body.with_weights(weights, club.loft)))
    }

    /// The head with point masses added (eqs. 5b, 5c).
    #[inline(always)]
    fn with_weights(&self, weights: [Option<Weight<T>>; 2], loft: T) -> Self {
        let [high, toe] = self.cg_offset.unwrap_or_else(|| [T::zero(); 2]);
        let body_cg = Vector::new(high, toe, -self.depth);
        // mass m_k of each weight, and its position s_k relative to the centre of mass of `self`
        let point_masses = weights
            .map(|weight| weight.map(|w| (w.mass, Vector::new(w.high, w.toe, -w.depth) - body_cg)));
        // M′ = M + Σ m_k and Σ m_k s_k
        let (mut mass, mut moment) = (self.mass, Vector::zero());
        for (point_mass, position) in point_masses.into_iter().flatten() {
            mass = mass + point_mass;
            moment = moment + position * point_mass;
        }
        // δ, eq. 5b
        let shift = moment * mass.recip();
        // eq. 5c
        let loft = loft.sin_cos();
        let mut inertia = self.inertia;
        add_point_mass(&mut inertia, self.mass, pitched(loft, shift));
        for (point_mass, position) in point_masses.into_iter().flatten() {
            add_point_mass(&mut inertia, point_mass, pitched(loft, position - shift));
        }
        Self {
            mass,
            depth: self.depth - shift.z,
            cg_offset: Some([high + shift.x, toe + shift.y]),
            inertia,
        }
    }

    /// Face centre relative to the centre of mass, m, in the head frame. Without
    /// [`cg_offset`](Self::cg_offset), the face centre is the sweet spot.
    #[inline(always)]
    pub(super) fn face_centre(&self, loft: T) -> Vector<T> {
        let [high, toe] = self.cg_offset.unwrap_or_else(|| [T::zero(); 2]);
        pitched(loft.sin_cos(), Vector::new(-high, -toe, self.depth))
    }

    /// Leading principal minors of S = ½ tr I − I, the matrix of the second moments of mass. The
    /// minor of order k is divided by (tr S)^(k − 1), so that its unit is kg m². The minors are at
    /// least 0 for a rigid body; if all are positive, I is positive definite and satisfies the
    /// triangle inequality.
    pub fn minors(&self) -> [T; 3] {
        let [[a, xy, xz], [_, b, yz], [.., c]] = self.inertia;
        let half = (a + b + c) * 0.5;
        let (xx, yy, zz) = (half - a, half - b, half - c);
        let second = xx * yy - xy * xy;
        // the off-diagonal entries of S equal the off-diagonal entries of −I
        let third = zz * second - xx * (yz * yz) - yy * (xz * xz) - xy * xz * yz * 2.0;
        let over = half.recip();
        [xx, second * over, third * over * over]
    }

    /// Converts the number type.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U + Copy) -> Head<U> {
        Head {
            mass: f(self.mass),
            depth: f(self.depth),
            cg_offset: self.cg_offset.map(|offset| offset.map(f)),
            inertia: self.inertia.map(|row| row.map(f)),
        }
    }
}

/// Adds the inertia tensor m (r·r 1 − r rᵀ) of a point mass m at r.
#[inline(always)]
fn add_point_mass<T: Numbers>(inertia: &mut [[T; 3]; 3], mass: T, r: Vector<T>) {
    let square = r.dot(r);
    let r = r.to_array();
    for (i, row) in inertia.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            let product = r[i] * r[j];
            let moment = if i == j { square - product } else { -product };
            *entry = *entry + moment * mass;
        }
    }
}

/// Transforms a vector from the face frame (i′, j′, k′) to the head frame. The angle between the
/// frames is the loft; the first argument is its sine and cosine.
#[inline(always)]
pub(super) fn pitched<T: Numbers>((sin, cos): (T, T), v: Vector<T>) -> Vector<T> {
    Vector::new(v.x * cos + v.z * sin, v.y, v.z * cos - v.x * sin)
}
