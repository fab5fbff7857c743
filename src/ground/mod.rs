//! Run of the ball on the ground: bounces, sliding and rolling to rest (docs/model.md, eqs. 19–24),
//! after Penner (2002).
//!
//! Between bounces the ball flies on parabolas, with drag along the ground. The position at rest is
//! C² in all inputs, even where the number of bounces changes.

mod bounce;
mod sliding;
mod turf;

use crate::number::{Mask, Numbers, Vector, inlined, smooth_step};
use bounce::Motion;
use sliding::slide_to_rest;
pub(crate) use turf::Turf;

/// Position of the ball at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<T> {
    /// Downrange distance, along the target line, m. NaN if the ball does not come to rest.
    pub downrange: T,
    /// Distance to the right of the target line, m. NaN if the ball does not come to rest.
    pub right: T,
    /// Number of impacts with the ground. In a batch, this is the largest number of all lanes.
    pub bounces: usize,
}

impl<T: Copy> Rest<T> {
    /// Converts the number type.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U) -> Rest<U> {
        Rest {
            downrange: f(self.downrange),
            right: f(self.right),
            bounces: self.bounces,
        }
    }
}

/// State of the ball at landing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LandingState<T> {
    /// Downrange distance, m.
    pub downrange: T,
    /// Distance to the right of the target line, m.
    pub right: T,
    /// Velocity, m/s.
    pub velocity: Vector<T>,
    /// Angular velocity, rad/s.
    pub spin: Vector<T>,
    /// Radius R of the ball, m.
    pub radius: T,
    /// Acceleration of gravity g, m/s².
    pub gravity: T,
    /// ρ A/(2 m) with the mass m, 1/m. The deceleration by drag is this factor times C_D |v|².
    pub force_per_mass: T,
}

/// A ball that leaves the ground more slowly than this, m/s along the normal, stays on the ground.
/// From this speed to twice this speed, a smooth step reduces the hop (eq. 22). Penner ends the
/// bounces at a height of 5 mm, which a ball reaches with 0.31 m/s.
const LEAST_HOP_SPEED: f64 = 0.2;
/// The square of this speed, m/s, is added to the squared speed along the ground. The root of the
/// sum has finite derivatives at rest.
const LEAST_SPEED: f64 = 1e-6;
/// C_D of a ball with little spin, for the hops.
const HOP_DRAG: f64 = 0.25;
/// Largest number of bounces, more than occur on any ground. Afterwards the ball rolls.
const MOST_BOUNCES: usize = 250;
/// Number of intervals into which the path of a run divides each hop.
const HOP_INTERVALS: u32 = 16;

impl<T: Numbers> Turf<T> {
    /// Position at rest, in `lanes`.
    #[inline(always)]
    pub fn rest(&self, ball: &LandingState<T>, lanes: T::Mask) -> Rest<T> {
        let Some(restitution) = self.restitution else {
            return Rest {
                downrange: ball.downrange,
                right: ball.right,
                bounces: 0,
            };
        };
        T::not_inlined(inlined!(|| self.run(
            ball,
            restitution,
            lanes,
            &mut |_, _| ()
        )))
    }

    /// Computes bounces and roll-out. `observe` receives the position at the start of each hop, m,
    /// relative to the landing, and the hop.
    #[inline(always)]
    fn run(
        &self,
        ball: &LandingState<T>,
        restitution: T,
        lanes: T::Mask,
        observe: &mut impl FnMut(Vector<T>, &Hop<T>),
    ) -> Rest<T> {
        let plane = LandingPlane::new(self.slope, self.side_slope, ball.gravity);
        let mut motion = Motion {
            velocity: ball.velocity,
            spin: ball.spin,
        };
        let mut position = Vector::zero();
        let comes_down = plane.normal.dot(motion.velocity).below(0.0);
        let mut bouncing = lanes & comes_down;
        let mut bounces = 0;
        while bouncing.any() && bounces < MOST_BOUNCES {
            let after = self.bounce(&motion, plane.normal, ball.radius, restitution);
            let hop = plane.hop(after.velocity, ball.force_per_mass * HOP_DRAG);
            observe(position, &hop);
            position = (position + hop.displacement(1.0)).select(position, bouncing);
            motion = Motion {
                velocity: hop.final_velocity().select(motion.velocity, bouncing),
                spin: after.spin.select(motion.spin, bouncing),
            };
            bouncing = bouncing & hop.leaves;
            bounces += 1;
        }
        position = position + self.roll_out(&motion, &plane, ball.radius);
        let or_nan = |start: T, more: T| (start + more).select(T::constant(f64::NAN), comes_down);
        Rest {
            downrange: or_nan(ball.downrange, position.z),
            right: or_nan(ball.right, position.y),
            bounces,
        }
    }

    /// Displacement of a ball that stays on the ground: it slides until it rolls, and rolls to rest
    /// (eq. 24).
    #[inline(always)]
    fn roll_out(&self, ball: &Motion<T>, plane: &LandingPlane<T>, radius: T) -> Vector<T> {
        let (normal, pull, k) = (
            plane.normal,
            plane.tangential_gravity,
            self.sticking_factor(),
        );
        let velocity = ball.velocity - normal * normal.dot(ball.velocity);
        let slip = ball.slip(velocity, normal, radius);
        // friction decelerates the slip s by μ_g g n_x/k, and gravity accelerates s by G, so s has
        // the equation of motion of a sliding body
        let slip_deceleration = self.friction * plane.normal_gravity / k;
        let (time, slip_distance) = slide_to_rest(slip, slip_deceleration, pull);
        let pulled = pull * time;
        let half = pull * (time * 0.5);
        // displacement v T + G T²/2 − k (s T + G T²/2 − D): the slip s ends at the time T, and D is
        // the integral of s up to T
        let slid = (velocity + half) * time - ((slip + half) * time - slip_distance) * k;
        let rolling_velocity = velocity + pulled - (slip + pulled) * k;
        let (_, rolled) = slide_to_rest(
            rolling_velocity,
            self.rolling * plane.normal_gravity,
            pull * (T::constant(1.0) - k),
        );
        slid + rolled
    }
}

/// Angle between the `velocity` of a landing ball and the ground, rad; negative if the ball moves
/// away from the ground. `slope` and `side_slope` are the slopes of the ground, rad.
pub(crate) fn angle_of_impact([slope, side_slope]: [f64; 2], velocity: Vector<f64>) -> f64 {
    let LandingPlane { normal, .. } = LandingPlane::new(slope, side_slope, 1.0);
    (-normal.dot(velocity) / velocity.norm()).asin()
}

/// Plane of the landing area, with gravity divided into its components.
struct LandingPlane<T> {
    /// Unit normal n, upwards.
    normal: Vector<T>,
    /// Gravity into the plane, g n_x, m/s².
    normal_gravity: T,
    /// Gravity along the plane, G = −g X + g n_x n, m/s².
    tangential_gravity: Vector<T>,
    /// Acceleration of gravity g, m/s².
    gravity: T,
}

impl<T: Numbers> LandingPlane<T> {
    #[inline(always)]
    fn new(slope: T, side_slope: T, gravity: T) -> Self {
        let tangent = |angle: T| {
            let (sin, cos) = angle.sin_cos();
            sin / cos
        };
        let normal = Vector::new(T::constant(1.0), -tangent(side_slope), -tangent(slope));
        let (_, inverse) = normal.dot(normal).sqrt_recip();
        let normal = normal * inverse;
        let normal_gravity = normal.x * gravity;
        let tangential_gravity =
            normal * normal_gravity - Vector::new(gravity, T::zero(), T::zero());
        Self {
            normal,
            normal_gravity,
            tangential_gravity,
            gravity,
        }
    }

    /// Hop after a bounce with the `velocity`, m/s (eq. 22). The speed along the plane falls by
    /// dv/dt = −`drag` v², with `drag` in 1/m: v(t) = v/(1 + `drag` v t).
    #[inline(always)]
    fn hop(&self, velocity: Vector<T>, drag: T) -> Hop<T> {
        let w = self.normal.dot(velocity);
        let rise = w * smooth_step(w, LEAST_HOP_SPEED, LEAST_HOP_SPEED);
        let along = velocity - self.normal * w;
        let time = rise * 2.0 / self.normal_gravity;
        let slowdown = (along.dot(along) + LEAST_SPEED * LEAST_SPEED).sqrt() * drag * time;
        Hop {
            along,
            rising: self.normal * rise,
            time,
            slowdown,
            gravity: self.gravity,
            leaves: (-rise).below(0.0),
        }
    }
}

/// A hop from the plane and back.
struct Hop<T: Numbers> {
    /// Initial velocity along the plane, m/s.
    along: Vector<T>,
    /// Initial velocity out of the plane, m/s.
    rising: Vector<T>,
    /// Duration T, s.
    time: T,
    /// x in eq. 22 of docs/model.md. During the hop, drag divides the speed along the plane by
    /// 1 + x.
    slowdown: T,
    /// Acceleration of gravity g, m/s².
    gravity: T,
    /// Lanes in which the ball leaves the plane.
    leaves: T::Mask,
}

impl<T: Numbers> Hop<T> {
    /// Displacement after the fraction `part` of the duration, from 0 to 1.
    #[inline(always)]
    fn displacement(&self, part: f64) -> Vector<T> {
        let time = self.time * part;
        let fall = self.gravity * time;
        // 1/(1 + x/2) approximates ln(1 + x)/x, within 1 % up to x = 0.3
        let displacement =
            self.along * (time / (self.slowdown * (0.5 * part) + 1.0)) + self.rising * time;
        Vector::new(
            displacement.x - fall * time * 0.5,
            displacement.y,
            displacement.z,
        )
    }

    /// Velocity at the end of the hop. It is along the plane if the ball does not leave the plane.
    #[inline(always)]
    fn final_velocity(&self) -> Vector<T> {
        let v = self.along * (self.slowdown + 1.0).recip() + self.rising;
        Vector::new(v.x - self.gravity * self.time, v.y, v.z)
    }
}

impl Turf<f64> {
    /// Path from the landing to rest, m, relative to the landing: the hops, then a straight line.
    /// The line is missing if the ball does not come to rest. The path is empty if the ball embeds.
    pub fn path(&self, ball: &LandingState<f64>) -> Vec<Vector<f64>> {
        let Some(restitution) = self.restitution else {
            return vec![];
        };
        let mut points = vec![];
        let rest = self.run(ball, restitution, true, &mut |from, hop| {
            if hop.leaves {
                points.extend(
                    (0..=HOP_INTERVALS)
                        .map(|k| from + hop.displacement(f64::from(k) / f64::from(HOP_INTERVALS))),
                );
            }
        });
        let [right, downrange] = [rest.right - ball.right, rest.downrange - ball.downrange];
        if right.is_finite() && downrange.is_finite() {
            let LandingPlane { normal, .. } =
                LandingPlane::new(self.slope, self.side_slope, ball.gravity);
            let up = -(normal.y * right + normal.z * downrange) / normal.x;
            points.push(Vector::new(up, right, downrange));
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::{HOP_DRAG, LandingPlane};
    use crate::number::Vector;

    /// The drag along the ground is integrated in small steps, at usual air density.
    #[test]
    fn independent_hop_by_integration_in_small_steps_within_a_hundredth() {
        let (g, drag) = (9.81, 0.0184 * HOP_DRAG);
        let plane = LandingPlane::new(0.0, 0.0, g);
        for (rise, along) in [(3.0, 8.0), (6.0, 14.0), (4.0, 28.0)] {
            let hop = plane.hop(Vector::new(rise, 0.0, along), drag);
            let (back, way, hops) = (hop.final_velocity(), hop.displacement(1.0), hop.leaves);
            let (mut v, mut far, h) = (along, 0.0, 1e-4);
            for _ in 0..(2.0 * rise / g / h) as usize {
                far += v * h;
                v -= drag * v * v * h;
            }
            assert!(
                hops && (way.z / far - 1.0_f64).abs() < 0.01
                    && (back.z / v - 1.0_f64).abs() < 0.001,
                "{way:?} {far}"
            );
            assert!((back.x + rise).abs() < 1e-12 && way.x.abs() < 1e-12);
        }
    }
}
