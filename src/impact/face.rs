use crate::error::{Error, Result};
use crate::number::{Number, Numbers, Vector, inlined};
use crate::parameters::{Club, Strike};

/// Where the ball is struck, in the head frame.
#[derive(Clone, Copy, Debug)]
pub struct FacePoint<T> {
    /// The impact point from the head's centre of mass, m.
    pub position: Vector<T>,
    /// The face's unit normal there.
    pub normal: Vector<T>,
}

impl<T: Numbers> FacePoint<T> {
    /// The struck point of the face's ellipsoid (docs/model.md, eqs. 3–5; Winfield & Tan eqs. 11–12), in the
    /// form that stays exact as a radius grows to infinity.
    ///
    /// # Errors
    /// [`Error::OffFace`] where the ellipsoid has no such point.
    #[inline]
    pub fn new(club: &Club<T>, strike: &Strike<T>) -> Result<Self>
    where
        T: Number,
    {
        let (point, q) = Self::unchecked(club, strike);
        if q.re() >= 1.0 || q.re().is_nan() {
            let (high_mm, toe_mm) = (strike.high.re() * 1e3, strike.toe.re() * 1e3);
            return Err(Error::OffFace { high_mm, toe_mm, q: q.re() });
        }
        Ok(point)
    }

    /// The struck point, which is one where q, given beside it, is below 1.
    #[inline(always)]
    pub(super) fn unchecked(club: &Club<T>, strike: &Strike<T>) -> (Self, T) {
        // 1/R is 0 for a flat direction
        let (roll, bulge) = (club.roll_radius.recip(), club.bulge_radius.recip());
        let third = match club.face_semi_axis {
            Some(semi_axis) => semi_axis.recip(),
            // √(bulge · roll): a flat direction makes it 0, where the root has no derivative
            None => {
                let product = roll * bulge;
                T::choose(
                    product.below(f64::MIN_POSITIVE),
                    T::zero,
                    #[inline(always)]
                    || product.sqrt(),
                )
            }
        };
        let (high, toe) = (strike.high, strike.toe);
        let sag = high * high * roll + toe * toe * bulge;
        let q = sag * third;
        let root = (-q + 1.0).sqrt();
        let point = Vector::new(high, toe, club.cg_depth - sag / (root + 1.0));
        let normal = Vector::new(high * roll, toe * bulge, root);
        let unit = normal * normal.norm().recip();

        // face frame (i', j', k') to head frame: pitched by the loft
        let (sin, cos) = club.loft.sin_cos();
        let pitched = inlined(
            #[inline(always)]
            |v: Vector<T>| Vector::new(v.x * cos + v.z * sin, v.y, v.z * cos - v.x * sin),
        );
        (Self { position: pitched(point), normal: pitched(unit) }, q)
    }
}

#[cfg(test)]
mod tests {
    use super::FacePoint;
    use crate::Setup;

    #[test]
    fn exact_normal_of_a_spherical_face_points_from_its_centre() {
        let mut setup = Setup::default();
        setup.club.loft = 0.3;
        (setup.strike.high, setup.strike.toe) = (0.011, -0.02);
        let face = FacePoint::new(&setup.club, &setup.strike).unwrap();
        // equal radii: a sphere whose centre lies at depth d − R behind the face along k'
        let (sin, cos) = setup.club.loft.sin_cos();
        let centre = setup.club.cg_depth - setup.club.bulge_radius;
        let from_centre = [face.position.x - centre * sin, face.position.y, face.position.z - centre * cos];
        for (component, expected) in from_centre.iter().zip(face.normal.to_array()) {
            assert!((component / setup.club.bulge_radius - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn exact_flat_face_is_the_limit_of_large_radii() {
        let mut setup = Setup::default();
        (setup.strike.high, setup.strike.toe) = (0.01, 0.02);
        let at = |radius, setup: &mut Setup<f64>| {
            (setup.club.bulge_radius, setup.club.roll_radius) = (radius, radius);
            FacePoint::new(&setup.club, &setup.strike).unwrap()
        };
        let (flat, nearly) = (at(f64::INFINITY, &mut setup), at(1e12, &mut setup));
        for (a, b) in flat.position.to_array().iter().zip(nearly.position.to_array()) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}
