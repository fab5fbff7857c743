use crate::number::{Numbers, Vector, inlined};
use crate::parameters::{Ground, Wind};

/// Height ℓ below which the logarithmic profile is smoothed, m. With a step of 0.01 s, carry is
/// then accurate to some micrometres (docs/limitations.md). Without smoothing, carry would be
/// accurate only to some millimetres, because the wind changes within the roughness length at the
/// ground.
const SMOOTHING_HEIGHT: f64 = 0.5;

/// Velocity of the air over the ground, uniform or a function of height (docs/model.md, eq. 15).
#[derive(Clone, Copy, Debug)]
pub struct WindField<T> {
    reference: Vector<T>,
    profile: Option<Profile<T>>,
}

#[derive(Clone, Copy, Debug)]
struct Profile<T> {
    /// Roughness length z₀, m.
    roughness: T,
    /// ln z₀, computed once.
    ln_roughness: T,
    /// Height of the ground, m.
    ground: T,
    /// 1/L(z_ref), with L(z) of `logarithm`. This factor makes the wind at the reference height
    /// z_ref equal to the stated wind.
    scale: T,
}

impl<T: Numbers> WindField<T> {
    /// The wind of the parameters `wind`. A logarithmic profile starts at the height of `ground`.
    #[inline(always)]
    pub fn new(wind: &Wind<T>, ground: &Ground<T>) -> Self {
        let profile = wind.roughness.map(|roughness| {
            let unscaled = Profile {
                roughness,
                ln_roughness: roughness.ln(),
                ground: ground.height,
                scale: T::constant(1.0),
            };
            Profile {
                scale: unscaled.logarithm(wind.reference_height).recip(),
                ..unscaled
            }
        });
        let [right, downrange] = horizontal_components(wind);
        Self {
            reference: Vector::new(wind.up, right, downrange),
            profile,
        }
    }

    /// True if the wind depends on the height; false if it is uniform.
    #[inline(always)]
    pub(crate) fn depends_on_height(&self) -> bool {
        self.profile.is_some()
    }

    /// Velocity of the air, m/s, at a `height` above the tee, m.
    #[inline(always)]
    pub fn at(&self, height: T) -> Vector<T> {
        match &self.profile {
            None => self.reference,
            Some(profile) => {
                self.reference * (profile.logarithm(height - profile.ground) * profile.scale)
            }
        }
    }
}

/// Components of the wind to the right and downrange. If a speed is given, they are computed from
/// the speed and the direction of the wind.
#[inline(always)]
pub(super) fn horizontal_components<T: Numbers>(wind: &Wind<T>) -> [T; 2] {
    let Some(speed) = wind.speed else {
        return [wind.right, wind.downrange];
    };
    let from = match wind.from {
        Some(from) => from,
        None => T::zero(),
    };
    T::not_inlined(inlined!(|| {
        let (sin, cos) = from.sin_cos();
        [-(speed * sin), -(speed * cos)]
    }))
}

impl<T: Numbers> Profile<T> {
    /// L(z) = ln(1 + ζ/z₀) with ζ = (z + √(z² + ℓ²))/2 at the height z above the ground. L is the
    /// logarithmic profile for z ≫ ℓ. It is smooth also below the ground, where the last step of a
    /// flight ends.
    #[inline(always)]
    fn logarithm(&self, height: T) -> T {
        let zeta = (height + (height * height + SMOOTHING_HEIGHT * SMOOTHING_HEIGHT).sqrt()) * 0.5;
        (zeta + self.roughness).ln() - self.ln_roughness
    }
}
