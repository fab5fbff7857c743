//! The head as it strikes: its body with the movable weights on it.

use crate::number::{Numbers, Vector, inlined};
use crate::parameters::{Club, Weight};

/// A rigid head: mass, centre of mass and inertia tensor, with its movable weights (docs/model.md,
/// eqs. 5a–5c).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head<T> {
    /// Its mass M, kg.
    pub mass: T,
    /// The distance d of its centre of mass behind the face, along the normal at the centre of the
    /// face, m.
    pub depth: T,
    /// How far its centre of mass lies above the centre of the face and towards the toe, m; `None`
    /// where it lies behind it.
    pub beside: Option<[T; 2]>,
    /// Its inertia tensor about the centre of mass in the head frame, kg m², row by row.
    pub inertia: [[T; 3]; 3],
}

impl<T: Numbers> Head<T> {
    /// The head of a club.
    #[inline(always)]
    pub fn new(club: &Club<T>) -> Self {
        let beside = match (club.cg_high, club.cg_toe) {
            (None, None) => None,
            (high, toe) => Some([high.unwrap_or_else(T::zero), toe.unwrap_or_else(T::zero)]),
        };
        let body = Self {
            mass: club.mass,
            depth: club.cg_depth,
            beside,
            inertia: club.inertia(),
        };
        let weights = club.weights();
        if weights.iter().all(Option::is_none) {
            return body;
        }
        T::outlined(inlined!(|| body.with(weights, club.loft)))
    }

    /// The same head with point masses on it.
    #[inline(always)]
    fn with(&self, weights: [Option<Weight<T>>; 2], loft: T) -> Self {
        let [high, toe] = self.beside.unwrap_or_else(|| [T::zero(); 2]);
        let own = Vector::new(high, toe, -self.depth);
        // from the centre of mass of the body
        let placed = weights
            .map(|weight| weight.map(|w| (w.mass, Vector::new(w.high, w.toe, -w.depth) - own)));
        let (mut mass, mut moment) = (self.mass, Vector::zero());
        for (weight, place) in placed.into_iter().flatten() {
            mass = mass + weight;
            moment = moment + place * weight;
        }
        let moved = moment * mass.recip();
        let turn = loft.sin_cos();
        let mut inertia = self.inertia;
        add(&mut inertia, self.mass, pitched(turn, moved));
        for (weight, place) in placed.into_iter().flatten() {
            add(&mut inertia, weight, pitched(turn, place - moved));
        }
        Self {
            mass,
            depth: self.depth - moved.z,
            beside: Some([high + moved.x, toe + moved.y]),
            inertia,
        }
    }

    /// The centre of the face from the centre of mass, in the head frame, at this loft; where the
    /// centre of mass is not placed from it, the sweet spot.
    #[inline(always)]
    pub(super) fn face_centre(&self, loft: T) -> Vector<T> {
        let [high, toe] = self.beside.unwrap_or_else(|| [T::zero(); 2]);
        pitched(loft.sin_cos(), Vector::new(-high, -toe, self.depth))
    }

    /// The leading principal minors of the second moments of the mass, S = ½ tr I − I, each over
    /// the power of tr S that makes it a moment: a body has none below 0, and where all are above,
    /// I is positive definite and its principal moments keep the triangle inequality.
    pub fn minors(&self) -> [T; 3] {
        let [[a, xy, xz], [_, b, yz], [.., c]] = self.inertia;
        let half = (a + b + c) * 0.5;
        let (xx, yy, zz) = (half - a, half - b, half - c);
        let second = xx * yy - xy * xy;
        // S has −I off its diagonal
        let third = zz * second - xx * (yz * yz) - yy * (xz * xz) - xy * xz * yz * 2.0;
        let over = half.recip();
        [xx, second * over, third * over * over]
    }

    /// The same over another number.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U + Copy) -> Head<U> {
        Head {
            mass: f(self.mass),
            depth: f(self.depth),
            beside: self.beside.map(|beside| beside.map(f)),
            inertia: self.inertia.map(|row| row.map(f)),
        }
    }
}

/// Adds the moments of inertia of a point mass: m (r·r 1 − r rᵀ).
#[inline(always)]
fn add<T: Numbers>(inertia: &mut [[T; 3]; 3], mass: T, place: Vector<T>) {
    let square = place.dot(place);
    let place = place.to_array();
    for (i, row) in inertia.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            let product = place[i] * place[j];
            let moment = if i == j { square - product } else { -product };
            *entry = *entry + moment * mass;
        }
    }
}

/// A vector of the face frame (i′, j′, k′), in the head frame: pitched by the loft, whose sine and
/// cosine are given.
#[inline(always)]
pub(super) fn pitched<T: Numbers>((sin, cos): (T, T), v: Vector<T>) -> Vector<T> {
    Vector::new(v.x * cos + v.z * sin, v.y, v.z * cos - v.x * sin)
}
