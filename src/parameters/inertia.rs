//! Inertia tensor of the head, and the conditions for it.

use super::declare::Parameter;
use super::table::Club;
use crate::error::{Error, Result};
use crate::units::Quantity;
use nalgebra::Matrix3;

impl Parameter {
    /// True for an entry of the inertia tensor. A check of its range is not enough: the tensor must
    /// be positive definite.
    pub(crate) fn is_of_inertia(&self) -> bool {
        self.name.starts_with("club.inertia")
    }
}

impl<T: Copy> Club<T> {
    /// The inertia tensor about the centre of mass in the head frame, kg m², row by row.
    #[inline(always)]
    pub fn inertia(&self) -> [[T; 3]; 3] {
        let (xy, xz, yz) = (self.inertia_xy, self.inertia_xz, self.inertia_yz);
        [
            [self.inertia_xx, xy, xz],
            [xy, self.inertia_yy, yz],
            [xz, yz, self.inertia_zz],
        ]
    }
}

impl Club<f64> {
    /// The principal moments of inertia, kg m², smallest first.
    fn principal_moments(&self) -> [f64; 3] {
        let mut moments: [f64; 3] = Matrix3::from(self.inertia()).symmetric_eigenvalues().into();
        moments.sort_by(f64::total_cmp);
        moments
    }

    /// Checks that the tensor is positive definite.
    ///
    /// # Errors
    /// [`Error::Inertia`] if the tensor is not positive definite.
    pub(crate) fn check_inertia(&self) -> Result<()> {
        let [smallest, _, largest] = self.principal_moments();
        // the rounding error of every eigenvalue is proportional to the largest eigenvalue
        if smallest > 1e-14 * largest {
            Ok(())
        } else {
            Err(Error::Inertia { smallest })
        }
    }

    /// Warning about a violated triangle inequality: for a rigid body, the sum of two principal
    /// moments is at least the third.
    pub(super) fn triangle_warning(&self) -> Option<String> {
        let moments = self.principal_moments();
        let [a, b, c] = moments;
        (a + b < c * (1.0 - 1e-12)).then(|| {
            let [a, b, c] = moments.map(|moment| Quantity::INERTIA.number_in(moment, "g cm^2"));
            format!(
                "club.inertia: no rigid body has the principal moments {a:.1}, {b:.1} and {c:.1} \
                 g cm^2 (the sum of the two smaller must be at least the largest); the drive is \
                 computed with them anyway"
            )
        })
    }
}
