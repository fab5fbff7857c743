use super::turf::Turf;
use crate::number::{Numbers, Vector, held_above, inlined, smooth_step};
use std::f64::consts::{FRAC_PI_2, PI};

/// A ball that moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moving<T> {
    /// m/s.
    pub velocity: Vector<T>,
    /// rad/s.
    pub spin: Vector<T>,
}

impl<T: Numbers> Moving<T> {
    /// The velocity of its lowest point along a surface, where its centre has `along`.
    #[inline(always)]
    pub fn slip(&self, along: Vector<T>, normal: Vector<T>, radius: T) -> Vector<T> {
        along - self.spin.cross(normal) * radius
    }
}

/// Penner (2002), p. 934: the impact whose tilt is θ_g, at 18.6 m/s and 44.4° from the vertical.
const SPEED: f64 = 18.6;
const INCIDENCE: f64 = 44.4 / 180.0 * PI;
/// The tilt as a part of the angle of incidence grows with the speed up to here, and is then held
/// over a width: up to the angle of incidence itself, where the ball meets the tilted surface
/// head-on. Beyond, the sine of Penner's (φ − θ_c) would be negative.
const HEAD_ON: [f64; 2] = [0.7, 0.6];
/// A ball that comes in flatter than this, from the ground, digs less, and one along the ground
/// nothing. Penner's angle grows until there; the width is chosen beside TrackMan's chart
/// (docs/sources.md).
const FLAT: f64 = 70.0 / 180.0 * PI;
/// Penner (2002), p. 933, by powers of the normal speed in s/m: e/e₀ = 1 + e₁ v + e₂ v². From 18
/// m/s on the speed is held, so that it ends where e is least, at 20.8 m/s.
const RESTITUTION: [f64; 2] = [-0.0375 / 0.51, 0.000903 / 0.51];
const HELD: f64 = 18.0;
const HELD_OVER: f64 = 2.0 * (-RESTITUTION[0] / (2.0 * RESTITUTION[1]) - HELD);
/// Friction grows with what would make the contact stick up to this part of its limit, and reaches
/// the limit over a width.
const STICKS: f64 = 0.8;
const SLIPS_OVER: f64 = 0.4;
/// (m/s)²: slips as small have no direction.
const NO_SLIP: f64 = 1e-24;
/// (m/s)²: keeps the direction along the ground, and its derivatives, where a ball falls straight
/// down.
const LEAST_SPEED_SQUARED: f64 = 1e-12;

impl<T: Numbers> Turf<T> {
    /// The ball after an impact (docs/model.md, eqs. 19–22).
    #[inline(always)]
    pub(super) fn bounced(
        &self,
        ball: &Moving<T>,
        ground: Vector<T>,
        radius: T,
        restitution: T,
    ) -> Moving<T> {
        let normal = self.tilted(ball.velocity, ground);
        let push = -normal.dot(ball.velocity);
        let along = ball.velocity + normal * push;
        let slow = held_above(push, HELD, HELD_OVER);
        let rebound = restitution
            * (slow * slow.scale_add(RESTITUTION[1], T::constant(RESTITUTION[0])) + 1.0);
        let slip = ball.slip(along, normal, radius);
        let lost = slip * (self.stuck() * self.grip(slip, self.friction * (rebound + 1.0) * push));
        let turned = normal.cross(lost) * (self.inertia * radius).recip();
        Moving {
            velocity: along - lost + normal * (rebound * push),
            spin: ball.spin + turned,
        }
    }

    /// The normal of the crater that a ball digs into the ground, tilted against its way.
    #[inline(always)]
    fn tilted(&self, velocity: Vector<T>, ground: Vector<T>) -> Vector<T> {
        let down = -ground.dot(velocity);
        let along = velocity + ground * down;
        let (level, per_level) = (along.dot(along) + LEAST_SPEED_SQUARED).sqrt_recip();
        let speed = (level * level + down * down).sqrt();
        let incidence = (level / (speed + down)).atan() * 2.0;
        let part = held_above(
            self.compliance * speed * (1.0 / (SPEED * INCIDENCE)),
            HEAD_ON[0],
            HEAD_ON[1],
        );
        let steep = smooth_step(-incidence + FRAC_PI_2, 0.0, FLAT);
        let (sin, cos) = (incidence * part * steep).sin_cos();
        ground * cos - along * (per_level * sin)
    }

    /// The part of what would make the contact stick that friction gives, at most `limit` m/s.
    #[inline(always)]
    fn grip(&self, slip: Vector<T>, limit: T) -> T {
        let stuck = self.stuck();
        let squared = slip.dot(slip) * (stuck * stuck);
        let sticks = (squared - limit * limit * (STICKS * STICKS)).below(NO_SLIP);
        T::choose(
            sticks,
            inlined!(|| T::constant(1.0)),
            inlined!(|| {
                let needed = squared.sqrt();
                T::choose(
                    (limit * (STICKS + SLIPS_OVER) - needed).below(0.0),
                    inlined!(|| limit / needed),
                    inlined!(|| {
                        let asked = needed / limit;
                        held_above(asked, STICKS, SLIPS_OVER) / asked
                    }),
                )
            }),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Turf;
    use super::{INCIDENCE, Moving, SPEED};
    use crate::Setup;
    use crate::number::Vector;
    use num_dual::Dual2_64;

    const RADIUS: f64 = 0.021335;
    const UP: Vector<f64> = Vector::new(1.0, 0.0, 0.0);

    /// A ball that comes in at an angle from the vertical, with backspin.
    fn ball(speed: f64, incidence: f64, backspin: f64) -> Moving<f64> {
        let velocity = Vector::new(-speed * incidence.cos(), 0.0, speed * incidence.sin());
        Moving {
            velocity,
            spin: Vector::new(0.0, backspin, 0.0),
        }
    }

    fn energy(ball: &Moving<f64>) -> f64 {
        0.5 * ball.velocity.dot(ball.velocity) + 0.2 * RADIUS * RADIUS * ball.spin.dot(ball.spin)
    }

    /// Penner's equations by hand (2002, pp. 933–934): rolling at exit.
    #[test]
    fn published_bounce_of_penner_with_rolling_at_exit() {
        let turf = Turf::new(&Setup::default());
        for (speed, spin) in [(SPEED, 300.0), (25.0, 200.0), (28.0, 0.0)] {
            // of his tilt there is left what a ball digs that comes in at 45.6° from the ground
            let u: f64 = 45.6 / 70.0;
            let tilt =
                (15.4 * speed / SPEED).to_radians() * u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u);
            let (sin, cos) = (INCIDENCE - tilt).sin_cos();
            let (along, push) = (speed * sin, speed * cos);
            let e = if push < 20.0 {
                0.51 - 0.0375 * push + 0.000903 * push * push
            } else {
                0.12
            };
            let (along, rise) = (5.0 / 7.0 * along - 2.0 / 7.0 * RADIUS * spin, e * push);
            let after = turf.bounced(&ball(speed, INCIDENCE, spin), UP, RADIUS, 0.51);
            // his restitution is not smooth at 20 m/s, this one within 0.0013 of it
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
        let mut turf = Turf::new(&Setup::default());
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
                    let after = turf.bounced(&ball, UP, RADIUS, part(0.303));
                    assert!(
                        energy(&after) <= energy(&ball) * (1.0 + 1e-14),
                        "{ball:?} {after:?}"
                    );
                }
            }
        }
    }

    /// The crater never faces the ball more than head-on: from 54 m/s on Penner's sine of the angle
    /// between them would be negative, and the ball be thrown back by a surface that it does not
    /// meet.
    #[test]
    fn no_ball_meets_the_crater_from_behind() {
        let turf = Turf::new(&Setup::default());
        for speed in 1..200 {
            for degrees in 1..90 {
                let ball = ball(f64::from(speed), f64::from(degrees).to_radians(), 0.0);
                let normal = turf.tilted(ball.velocity, UP);
                let along = ball.velocity - normal * normal.dot(ball.velocity);
                let ahead = Vector::new(normal.z.abs(), 0.0, normal.x);
                assert!(
                    normal.dot(ball.velocity) < 0.0 && ahead.dot(along) > -1e-9 * f64::from(speed),
                    "{ball:?}"
                );
            }
        }
    }

    /// A ball that skims is not thrown up: it leaves no faster upwards than it came down.
    #[test]
    fn exact_flat_bounces_stay_flat() {
        let turf = Turf::new(&Setup::default());
        for speed in [5.0, 10.0, 15.0] {
            for degrees in 1..15 {
                let ball = ball(speed, (90.0 - f64::from(degrees)).to_radians(), 0.0);
                let after = turf.bounced(&ball, UP, RADIUS, 0.51);
                assert!(
                    after.velocity.x < -ball.velocity.x,
                    "{speed} m/s at {degrees}°: {after:?}"
                );
            }
        }
    }

    /// Where friction begins to slip and where it slips wholly, value, slope and curvature of what
    /// it gives join.
    #[test]
    fn exact_friction_is_c2_between_sticking_and_slipping() {
        let setup = Setup::default();
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
