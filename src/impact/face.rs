use super::head::{Head, pitched};
use crate::error::{Error, Result};
use crate::number::{Number, Numbers, Vector, inlined};
use crate::parameters::{Club, Strike};

/// Impact point on the face, in the head frame.
#[derive(Clone, Copy, Debug)]
pub struct FacePoint<T> {
    /// Impact point from the head's centre of mass, m.
    pub position: Vector<T>,
    /// Unit normal of the face at this point.
    pub normal: Vector<T>,
}

impl<T: Numbers> FacePoint<T> {
    /// Impact point on the ellipsoid of the face (docs/model.md, eqs. 3–5; Winfield & Tan eqs.
    /// 11–12). The formulas are exact also for infinite radii.
    ///
    /// # Errors
    /// [`Error::OffFace`] if the strike is beyond the ellipsoid.
    #[inline]
    pub fn new(club: &Club<T>, strike: &Strike<T>) -> Result<Self>
    where
        T: Number,
    {
        let (point, q) = Self::unchecked(&Head::new(club), club, strike);
        if q.re() >= 1.0 || q.re().is_nan() {
            let (high_mm, toe_mm) = (strike.high.re() * 1e3, strike.toe.re() * 1e3);
            return Err(Error::OffFace {
                high_mm,
                toe_mm,
                q: q.re(),
            });
        }
        Ok(point)
    }

    /// Impact point, and q (eq. 3): the strike is on the face if q < 1.
    #[inline(always)]
    pub(super) fn unchecked(head: &Head<T>, club: &Club<T>, strike: &Strike<T>) -> (Self, T) {
        // 1/R is 0 for a flat direction
        let (roll, bulge) = (club.roll_radius.recip(), club.bulge_radius.recip());
        let third = match club.face_semi_axis {
            Some(semi_axis) => semi_axis.recip(),
            // 1/P_k = √(1/(R_b R_r)). If a direction is flat, this is the constant 0, because the
            // root has no derivative at 0.
            None => {
                let product = roll * bulge;
                T::select_lazily(
                    product.below(f64::MIN_POSITIVE),
                    T::zero,
                    inlined!(|| product.sqrt()),
                )
            }
        };
        // `sag` is q′ of eq. 3
        let (high, toe) = (strike.high, strike.toe);
        let sag = high * high * roll + toe * toe * bulge;
        let q = sag * third;
        let root = (-q + 1.0).sqrt();
        // eqs. 4 and 5a
        let [up, across] = match head.cg_offset {
            None => [high, toe],
            Some([cg_high, cg_toe]) => [high - cg_high, toe - cg_toe],
        };
        let point = Vector::new(up, across, head.depth - sag / (root + 1.0));
        // eq. 5
        let normal = Vector::new(high * roll, toe * bulge, root);
        let unit = normal * normal.norm().recip();

        let loft = club.loft.sin_cos();
        (
            Self {
                position: pitched(loft, point),
                normal: pitched(loft, unit),
            },
            q,
        )
    }
}

/// Tolerance of the fixed-point iteration for the sweet spot, m.
const TOLERANCE: f64 = 1e-13;
/// Largest number of steps of the fixed-point iteration.
const MOST_STEPS: usize = 200;

impl Strike<f64> {
    /// Strike on the sweet spot, where the face normal passes through the centre of mass. Each step
    /// of a fixed-point iteration starts at the centre of mass and follows the normal of the
    /// previous point, until it is as far forward as this point. `None` if the iteration leaves the
    /// face or does not converge, because the face is too curved.
    pub fn on_sweet_spot(club: &Club<f64>) -> Option<Self> {
        let head = Head::new(club);
        let Some([cg_high, cg_toe]) = head.cg_offset else {
            return Some(Self {
                high: 0.0,
                toe: 0.0,
            });
        };
        let loft = club.loft.sin_cos();
        let [up, forward] = [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 0.0, 1.0)]
            .map(|axis| pitched(loft, axis));
        let mut strike = Self {
            high: cg_high,
            toe: cg_toe,
        };
        for _ in 0..MOST_STEPS {
            let (FacePoint { position, normal }, q) = FacePoint::unchecked(&head, club, &strike);
            if q >= 1.0 || q.is_nan() {
                return None;
            }
            let length = position.dot(forward) / normal.dot(forward);
            let next = Self {
                high: cg_high + length * normal.dot(up),
                toe: cg_toe + length * normal.y,
            };
            let change = (next.high - strike.high)
                .abs()
                .max((next.toe - strike.toe).abs());
            strike = next;
            if change < TOLERANCE {
                return Some(strike);
            }
        }
        None
    }
}
