//! The ball on the ground: bounces, sliding and rolling until it rests (docs/model.md, eqs. 19–24),
//! after Penner (2002).
//!
//! Between bounces the ball flies on parabolas, slowed along the ground by the air. Written once,
//! over any numbers, and C² in all that it depends on, also where the number of bounces changes.

mod bounce;
mod rubbing;
mod turf;

use crate::number::{Mask, Numbers, Vector, inlined, smooth_step};
use bounce::Moving;
use rubbing::Rubbing;
pub(crate) use turf::Turf;

/// Where a ball rests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<T> {
    /// Downrange distance, along the target line, m. NaN where the ball does not come to rest.
    pub downrange: T,
    /// Distance to the right of the target line, m. NaN where the ball does not come to rest.
    pub right: T,
    /// Impacts with the ground; of several balls side by side those of the one with most.
    pub bounces: usize,
}

impl<T: Copy> Rest<T> {
    /// The same over another number.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U) -> Rest<U> {
        Rest {
            downrange: f(self.downrange),
            right: f(self.right),
            bounces: self.bounces,
        }
    }
}

/// A ball as it lands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Landing<T> {
    /// Where, m.
    pub downrange: T,
    pub right: T,
    /// m/s.
    pub velocity: Vector<T>,
    /// rad/s.
    pub spin: Vector<T>,
    /// m.
    pub radius: T,
    /// m/s².
    pub gravity: T,
    /// ρ A/(2 m): deceleration by the air per C_D |v|², 1/m.
    pub force_per_mass: T,
}

/// A ball that leaves the ground more slowly, m/s, stays on it; from twice this speed on it hops.
/// Penner ends the bounces at a height of 5 mm, which is between the two (0.31 m/s).
const STAYS: f64 = 0.2;
/// m/s: keeps the speed along the ground, and its derivatives, where there is none.
const LEAST_SPEED: f64 = 1e-6;
/// C_D of a hop: a ball with little spin.
const DRAG: f64 = 0.25;
/// More bounces than any ground leaves a ball; after them it rolls.
const MOST_BOUNCES: usize = 250;
/// Parts of a hop that a path shows.
const HOP_PARTS: u32 = 16;

impl<T: Numbers> Turf<T> {
    /// Where balls rest, in the lanes of a mask. Not inlined: there is one compiled copy for each
    /// number type.
    #[inline(always)]
    pub fn rest(&self, ball: &Landing<T>, lanes: T::Mask) -> Rest<T> {
        let Some(restitution) = self.restitution else {
            return Rest {
                downrange: ball.downrange,
                right: ball.right,
                bounces: 0,
            };
        };
        T::outlined(inlined!(|| self.run(
            ball,
            restitution,
            lanes,
            &mut |_, _| ()
        )))
    }

    /// Shows each hop, with the place that it begins at from the landing, to `seen`.
    #[inline(always)]
    fn run(
        &self,
        ball: &Landing<T>,
        restitution: T,
        lanes: T::Mask,
        seen: &mut impl FnMut(Vector<T>, &Hop<T>),
    ) -> Rest<T> {
        let slope = Slope::new(self.slope, self.side_slope, ball.gravity);
        let mut moving = Moving {
            velocity: ball.velocity,
            spin: ball.spin,
        };
        let mut way = Vector::zero();
        let comes_down = slope.normal.dot(moving.velocity).below(0.0);
        let mut bouncing = lanes & comes_down;
        let mut bounces = 0;
        while bouncing.any() && bounces < MOST_BOUNCES {
            let after = self.bounced(&moving, slope.normal, ball.radius, restitution);
            let hop = slope.hop(after.velocity, ball.force_per_mass * DRAG);
            seen(way, &hop);
            way = (way + hop.way(1.0)).blend(way, bouncing);
            moving = Moving {
                velocity: hop.back().blend(moving.velocity, bouncing),
                spin: after.spin.blend(moving.spin, bouncing),
            };
            bouncing = bouncing & hop.leaves;
            bounces += 1;
        }
        way = way + self.way_to_rest(&moving, &slope, ball.radius);
        let or_nan = |there: T, more: T| (there + more).blend(T::constant(f64::NAN), comes_down);
        Rest {
            downrange: or_nan(ball.downrange, way.z),
            right: or_nan(ball.right, way.y),
            bounces,
        }
    }

    /// The way of a ball that stays on the ground: it slides until it rolls, and rolls until it
    /// rests.
    #[inline(always)]
    fn way_to_rest(&self, ball: &Moving<T>, slope: &Slope<T>, radius: T) -> Vector<T> {
        let (normal, pull, stuck) = (slope.normal, slope.pull, self.stuck());
        let velocity = ball.velocity - normal * normal.dot(ball.velocity);
        let slip = ball.slip(velocity, normal, radius);
        // the slip itself is rubbed away and pulled along the slope like a body of its own, and
        // what it loses the ball loses in part
        let (time, way) = Rubbing {
            deceleration: self.friction * slope.press / stuck,
            pull,
        }
        .stop(slip);
        let pulled = pull * time;
        let half = pull * (time * 0.5);
        let slid = (velocity + half) * time - ((slip + half) * time - way) * stuck;
        let rolling = velocity + pulled - (slip + pulled) * stuck;
        let by_spin = T::constant(1.0) - stuck;
        let (_, rolled) = Rubbing {
            deceleration: self.rolling * slope.press,
            pull: pull * by_spin,
        }
        .stop(rolling);
        slid + rolled
    }
}

/// The angle between the ground, of these slopes down range and to the side, and the way of a ball
/// that comes down on it, rad; below 0 where it moves away from the ground.
pub(crate) fn angle_of_impact([slope, side_slope]: [f64; 2], velocity: Vector<f64>) -> f64 {
    let Slope { normal, .. } = Slope::new(slope, side_slope, 1.0);
    (-normal.dot(velocity) / velocity.norm()).asin()
}

/// A plane under gravity.
struct Slope<T> {
    /// Unit normal, upwards.
    normal: Vector<T>,
    /// Gravity into the plane, and along it, m/s².
    press: T,
    pull: Vector<T>,
    gravity: T,
}

impl<T: Numbers> Slope<T> {
    #[inline(always)]
    fn new(downrange: T, right: T, gravity: T) -> Self {
        let tangent = |angle: T| {
            let (sin, cos) = angle.sin_cos();
            sin / cos
        };
        let normal = Vector::new(T::constant(1.0), -tangent(right), -tangent(downrange));
        let (_, inverse) = normal.dot(normal).sqrt_recip();
        let normal = normal * inverse;
        let press = normal.x * gravity;
        let pull = normal * press - Vector::new(gravity, T::zero(), T::zero());
        Self {
            normal,
            press,
            pull,
            gravity,
        }
    }

    /// The hop of a ball that leaves the plane. `drag` is what the air takes from its velocity
    /// along the plane, 1/m: dv/dt = −`drag` v², so that v/(1 + `drag` v t) is left.
    #[inline(always)]
    fn hop(&self, velocity: Vector<T>, drag: T) -> Hop<T> {
        let rise = self.normal.dot(velocity);
        let left = rise * smooth_step(rise, STAYS, STAYS);
        let along = velocity - self.normal * rise;
        let time = left * 2.0 / self.press;
        let slowed = (along.dot(along) + LEAST_SPEED * LEAST_SPEED).sqrt() * drag * time;
        Hop {
            along,
            rising: self.normal * left,
            time,
            slowed,
            gravity: self.gravity,
            leaves: (-left).below(0.0),
        }
    }
}

/// A hop from the plane and back.
struct Hop<T: Numbers> {
    /// Velocities along the plane and out of it as the ball leaves, m/s.
    along: Vector<T>,
    rising: Vector<T>,
    /// s.
    time: T,
    /// `drag` v t at its end.
    slowed: T,
    /// m/s².
    gravity: T,
    /// Where the ball leaves the plane at all.
    leaves: T::Mask,
}

impl<T: Numbers> Hop<T> {
    /// The way after a part of its time.
    #[inline(always)]
    fn way(&self, part: f64) -> Vector<T> {
        let time = self.time * part;
        let fall = self.gravity * time;
        // the mean of ln(1 + x)/x, within a hundredth up to x = 0.3
        let way = self.along * (time / (self.slowed * (0.5 * part) + 1.0)) + self.rising * time;
        Vector::new(way.x - fall * time * 0.5, way.y, way.z)
    }

    /// The velocity as it comes back, or along the plane where it does not leave.
    #[inline(always)]
    fn back(&self) -> Vector<T> {
        let back = self.along * (self.slowed + 1.0).recip() + self.rising;
        Vector::new(back.x - self.gravity * self.time, back.y, back.z)
    }
}

impl Turf<f64> {
    /// The way of a ball from its landing to rest: its hops, and from the last of them a straight
    /// line to where it rests; empty for one that embeds, and the hops alone for one that does not
    /// come to rest.
    pub fn path(&self, ball: &Landing<f64>) -> Vec<Vector<f64>> {
        let Some(restitution) = self.restitution else {
            return vec![];
        };
        let mut points = vec![];
        let rest = self.run(ball, restitution, true, &mut |from, hop| {
            if hop.leaves {
                points.extend(
                    (0..=HOP_PARTS).map(|k| from + hop.way(f64::from(k) / f64::from(HOP_PARTS))),
                );
            }
        });
        let [right, downrange] = [rest.right - ball.right, rest.downrange - ball.downrange];
        if right.is_finite() && downrange.is_finite() {
            let Slope { normal, .. } = Slope::new(self.slope, self.side_slope, ball.gravity);
            let up = -(normal.y * right + normal.z * downrange) / normal.x;
            points.push(Vector::new(up, right, downrange));
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::{DRAG, Slope};
    use crate::number::Vector;

    /// A hop beside the same with drag along the ground in small steps, at the density of usual
    /// air.
    #[test]
    fn independent_hop_by_integration_in_small_steps_within_a_hundredth() {
        let (g, drag) = (9.81, 0.0184 * DRAG);
        let slope = Slope::new(0.0, 0.0, g);
        for (rise, along) in [(3.0, 8.0), (6.0, 14.0), (4.0, 28.0)] {
            let hop = slope.hop(Vector::new(rise, 0.0, along), drag);
            let (back, way, hops) = (hop.back(), hop.way(1.0), hop.leaves);
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
