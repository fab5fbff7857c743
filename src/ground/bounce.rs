//! A bounce on the turf (docs/model.md, eqs. 19–22).

use super::turf::Turf;
use crate::number::{Numbers, Vector, inlined, smooth_clamp_above, smooth_step};
use std::f64::consts::{FRAC_PI_2, PI};

/// Velocity and spin of the ball.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion<T> {
    /// Velocity, m/s.
    pub velocity: Vector<T>,
    /// Angular velocity, rad/s.
    pub spin: Vector<T>,
}

impl<T: Numbers> Motion<T> {
    /// Slip, m/s: velocity of the ball's contact point along a surface with the unit `normal`.
    /// `along` is the velocity of the ball's centre along the surface.
    #[inline(always)]
    pub fn slip(&self, along: Vector<T>, normal: Vector<T>, radius: T) -> Vector<T> {
        along - self.spin.cross(normal) * radius
    }
}

/// The compliance θ_g is the tilt of the crater at this impact speed, m/s: Penner (2002), p. 934.
const REFERENCE_SPEED: f64 = 18.6;
/// The compliance θ_g is the tilt of the crater at this angle of incidence, rad.
const REFERENCE_INCIDENCE: f64 = 44.4 / 180.0 * PI;
/// Start and width of the smooth clamp H in eq. 19. The clamped ratio θ_c/φ, the tilt of the crater
/// over the angle of incidence, is at most 1: at 1 the ball meets the crater head-on. In Penner's
/// formula the ratio can exceed 1.
const TILT_CLAMP: [f64; 2] = [0.7, 0.6];
/// Angle of the path to the ground, rad. A ball on a flatter path makes a crater with less tilt
/// than in Penner's formula (factor S in eq. 19). Penner's tilt is largest for a ball that moves
/// along the ground, but such a ball makes no crater. The angle is chosen: the runs of TrackMan's
/// 60 drives are then 9 yd short (docs/sources.md).
const FULL_TILT_ANGLE: f64 = 70.0 / 180.0 * PI;
/// Coefficients, s/m and s²/m², of e/e_g = 1 + e₁ u + e₂ u² (eq. 20): Penner (2002), p. 933.
const RESTITUTION: [f64; 2] = [-0.0375 / 0.51, 0.000903 / 0.51];
/// Start of the smooth clamp of u, m/s. u is the speed of the ball along the normal of its crater.
const CLAMP_SPEED: f64 = 18.0;
/// Width of the smooth clamp of u, m/s. The largest clamped u is 20.8 m/s, where e has its minimum.
const CLAMP_WIDTH: f64 = 2.0 * (-RESTITUTION[0] / (2.0 * RESTITUTION[1]) - CLAMP_SPEED);
/// The transition from sticking to slipping starts at this value of x (eq. 21). x is the friction
/// that sticking needs, divided by the available friction.
const SLIP_START: f64 = 0.8;
/// The transition from sticking to slipping ends at x = [`SLIP_START`] + [`SLIP_WIDTH`].
const SLIP_WIDTH: f64 = 0.4;
/// Tolerance, (m/s)², for squared impulses per mass. With this tolerance, a contact without slip
/// sticks even if there is no friction: the friction of a slipping contact needs a direction.
const NO_SLIP: f64 = 1e-24;
/// Added to the squared speed along the ground, (m/s)², to keep direction and derivatives finite
/// for a ball that falls vertically.
const LEAST_SPEED_SQUARED: f64 = 1e-12;

impl<T: Numbers> Turf<T> {
    /// Motion after an impact (eqs. 19–22). `ground` is the upward unit normal of the ground,
    /// `restitution` is e_g.
    #[inline(always)]
    pub(super) fn bounce(
        &self,
        ball: &Motion<T>,
        ground: Vector<T>,
        radius: T,
        restitution: T,
    ) -> Motion<T> {
        let normal = self.crater_normal(ball.velocity, ground);
        let u = -normal.dot(ball.velocity);
        let along = ball.velocity + normal * u;
        // e, eq. 20
        let h = smooth_clamp_above(u, CLAMP_SPEED, CLAMP_WIDTH);
        let e = restitution * (h * h.scale_add(RESTITUTION[1], T::constant(RESTITUTION[0])) + 1.0);
        // k s q, eq. 21
        let slip = ball.slip(along, normal, radius);
        let grip = self.grip(slip, self.friction * (e + 1.0) * u);
        let lost = slip * (self.sticking_factor() * grip);
        let spin_change = normal.cross(lost) * (self.inertia * radius).recip();
        Motion {
            velocity: along - lost + normal * (e * u),
            spin: ball.spin + spin_change,
        }
    }

    /// Normal n′ of the crater that the ball digs, tilted against the ball's velocity (eq. 19).
    #[inline(always)]
    fn crater_normal(&self, velocity: Vector<T>, ground: Vector<T>) -> Vector<T> {
        let down = -ground.dot(velocity);
        let along = velocity + ground * down;
        let (level, per_level) = (along.dot(along) + LEAST_SPEED_SQUARED).sqrt_recip();
        let speed = (level * level + down * down).sqrt();
        // φ = 2 arctan(v_t/(|v| + v_n))
        let incidence = (level / (speed + down)).atan() * 2.0;
        let tilt_ratio = smooth_clamp_above(
            self.compliance * speed * (1.0 / (REFERENCE_SPEED * REFERENCE_INCIDENCE)),
            TILT_CLAMP[0],
            TILT_CLAMP[1],
        );
        let steepness = smooth_step(-incidence + FRAC_PI_2, 0.0, FULL_TILT_ANGLE);
        let (sin, cos) = (incidence * tilt_ratio * steepness).sin_cos();
        ground * cos - along * (per_level * sin)
    }

    /// q (eq. 21): the impulse of friction, as a fraction of the impulse that sticking needs.
    /// `limit` is Coulomb's limit of the impulse per mass, m/s.
    #[inline(always)]
    fn grip(&self, slip: Vector<T>, limit: T) -> T {
        let k = self.sticking_factor();
        let needed_squared = slip.dot(slip) * (k * k);
        let sticks = (needed_squared - limit * limit * (SLIP_START * SLIP_START)).below(NO_SLIP);
        T::select_lazily(
            sticks,
            inlined!(|| T::constant(1.0)),
            inlined!(|| {
                let needed = needed_squared.sqrt();
                T::select_lazily(
                    (limit * (SLIP_START + SLIP_WIDTH) - needed).below(0.0),
                    inlined!(|| limit / needed),
                    inlined!(|| {
                        let x = needed / limit;
                        smooth_clamp_above(x, SLIP_START, SLIP_WIDTH) / x
                    }),
                )
            }),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Motion, REFERENCE_INCIDENCE, REFERENCE_SPEED};
    use crate::Setup;
    use crate::ground::Turf;
    use crate::number::Vector;
    use num_dual::Dual2_64;

    const RADIUS: f64 = 0.021335;
    const UP: Vector<f64> = Vector::new(1.0, 0.0, 0.0);

    /// A landing ball; `incidence` is its angle from the vertical.
    fn ball(speed: f64, incidence: f64, backspin: f64) -> Motion<f64> {
        let velocity = Vector::new(-speed * incidence.cos(), 0.0, speed * incidence.sin());
        Motion {
            velocity,
            spin: Vector::new(0.0, backspin, 0.0),
        }
    }

    fn energy(ball: &Motion<f64>) -> f64 {
        0.5 * ball.velocity.dot(ball.velocity) + 0.2 * RADIUS * RADIUS * ball.spin.dot(ball.spin)
    }

    /// Penner's equations (2002, pp. 933–934) for a ball that rolls at exit, with the factor S of
    /// docs/model.md (19) on his tilt.
    #[test]
    fn independent_bounce_of_penner_with_rolling_at_exit() {
        let turf = Turf::new(&Setup::modern_driver());
        for (speed, spin) in [(REFERENCE_SPEED, 300.0), (25.0, 200.0), (28.0, 0.0)] {
            // S in eq. 19 at 45.6° to the ground
            let u: f64 = 45.6 / 70.0;
            let tilt = (15.4 * speed / REFERENCE_SPEED).to_radians()
                * u.powi(3)
                * (10.0 - 15.0 * u + 6.0 * u * u);
            let (sin, cos) = (REFERENCE_INCIDENCE - tilt).sin_cos();
            let (along, push) = (speed * sin, speed * cos);
            let e = if push < 20.0 {
                0.51 - 0.0375 * push + 0.000903 * push * push
            } else {
                0.12
            };
            let (along, rise) = (5.0 / 7.0 * along - 2.0 / 7.0 * RADIUS * spin, e * push);
            let after = turf.bounce(&ball(speed, REFERENCE_INCIDENCE, spin), UP, RADIUS, 0.51);
            // Penner's restitution has a corner at 20 m/s; the smooth restitution deviates from it
            // by at most 0.0013
            let bar = 0.0013 * push;
            assert!(
                (after.velocity.x - (along * tilt.sin() + rise * tilt.cos())).abs() < bar,
                "{after:?}"
            );
            assert!(
                (after.velocity.z - (along * tilt.cos() - rise * tilt.sin())).abs() < bar,
                "{after:?}"
            );
            assert!((after.spin.y + along / RADIUS).abs() < 1e-9, "{after:?}");
        }
    }

    #[test]
    fn energy_never_grows_in_a_bounce() {
        let mut turf = Turf::new(&Setup::modern_driver());
        for compliance in [0.0, 0.1, 0.27, 1.0] {
            for friction in [0.01, 0.4, 3.0] {
                (turf.compliance, turf.friction) = (compliance, friction);
                for k in 0..4000 {
                    let part = |prime: f64| (f64::from(k) * prime).fract();
                    let mut ball = ball(
                        80.0 * part(0.618),
                        1.57 * part(0.414),
                        2000.0 * part(0.732) - 1000.0,
                    );
                    (ball.spin.x, ball.spin.z) = (500.0 * part(0.236), 500.0 * part(0.449));
                    let after = turf.bounce(&ball, UP, RADIUS, part(0.303));
                    assert!(
                        energy(&after) <= energy(&ball) * (1.0 + 1e-14),
                        "{ball:?} {after:?}"
                    );
                }
            }
        }
    }

    /// The tilt of the crater never exceeds the angle of incidence. Without the clamp, it would
    /// exceed this angle for a ball faster than 54 m/s: the crater would face away from the ball.
    #[test]
    fn no_ball_meets_the_crater_from_behind() {
        let turf = Turf::new(&Setup::modern_driver());
        for speed in 1..200 {
            for degrees in 1..90 {
                let ball = ball(f64::from(speed), f64::from(degrees).to_radians(), 0.0);
                let normal = turf.crater_normal(ball.velocity, UP);
                let along = ball.velocity - normal * normal.dot(ball.velocity);
                let ahead = Vector::new(normal.z.abs(), 0.0, normal.x);
                assert!(
                    normal.dot(ball.velocity) < 0.0 && ahead.dot(along) > -1e-9 * f64::from(speed),
                    "{ball:?}"
                );
            }
        }
    }

    /// A ball that skims the ground does not bounce upwards faster than it came down.
    #[test]
    fn exact_flat_bounces_stay_flat() {
        let turf = Turf::new(&Setup::modern_driver());
        for speed in [5.0, 10.0, 15.0] {
            for degrees in 1..15 {
                let ball = ball(speed, (90.0 - f64::from(degrees)).to_radians(), 0.0);
                let after = turf.bounce(&ball, UP, RADIUS, 0.51);
                assert!(
                    after.velocity.x < -ball.velocity.x,
                    "{speed} m/s at {degrees}°: {after:?}"
                );
            }
        }
    }

    #[test]
    fn exact_friction_is_c2_between_sticking_and_slipping() {
        let setup = Setup::modern_driver();
        let turf = Turf::new(&setup.map(|_, value| Dual2_64::from(value)));
        let given = |needed: f64| {
            let slip = Dual2_64::from(needed * 3.5).derivative();
            let zero = Dual2_64::from(0.0);
            slip * turf.grip(Vector::new(zero, zero, slip), Dual2_64::from(1.0)) * (2.0 / 7.0)
        };
        for needed in [0.8, 1.2] {
            let [a, b] = [needed * (1.0 - 1e-12), needed * (1.0 + 1e-12)].map(given);
            assert!(
                (a.re - b.re).abs() < 1e-11
                    && (a.v1 - b.v1).abs() < 1e-10
                    && (a.v2 - b.v2).abs() < 1e-9
            );
        }
        assert!((given(0.5).re - 0.5).abs() < 1e-15 && (given(7.0).re - 1.0).abs() < 1e-15);
    }
}
