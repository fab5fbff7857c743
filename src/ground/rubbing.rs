use crate::number::{Numbers, Vector, inlined};

/// A body that a force of constant size slows, and another pulls along.
pub(super) struct Rubbing<T> {
    /// a, m/s², against the velocity.
    pub deceleration: T,
    /// G, m/s².
    pub pull: Vector<T>,
}

/// m/s: |v| is √(v·v + η²) − η, smooth where the body rests.
const LEAST_SPEED: f64 = 1e-4;

impl<T: Numbers> Rubbing<T> {
    /// The time until it rests, and its way until then (docs/model.md, eq. 23). NaN where it does
    /// not come to rest: |G| ≥ a.
    ///
    /// From dv/dt = G − a v/|v| follows d(a|v| + v·G)/dt = −(a² − |G|²), and likewise the way by
    /// quadratic functions of |v| and v·G.
    #[inline(always)]
    pub fn stop(&self, velocity: Vector<T>) -> (T, Vector<T>) {
        T::outlined(inlined!(|| self.stopped(velocity)))
    }

    #[inline(always)]
    fn stopped(&self, velocity: Vector<T>) -> (T, Vector<T>) {
        let (a, pull) = (self.deceleration, self.pull);
        let speed = (velocity.dot(velocity) + LEAST_SPEED * LEAST_SPEED).sqrt() - LEAST_SPEED;
        let (along, steep, rubbed) = (velocity.dot(pull), pull.dot(pull), a * a);
        let left = rubbed - steep;
        let left = left.blend(T::constant(f64::NAN), (-left).below(0.0));
        let ahead = left.recip();
        let beside = (rubbed * 4.0 - steep).recip();
        let pushed = a * speed;
        let by_pull = speed * speed + along * (pushed * 6.0 + along * 3.0) * beside;
        let way = velocity * ((pushed * 2.0 + along) * beside) + pull * (by_pull * ahead * 0.25);
        ((pushed + along) * ahead, way)
    }
}

#[cfg(test)]
mod tests {
    use super::Rubbing;
    use crate::number::Vector;

    /// dv/dt = G − a v/|v| by many small steps of the second order.
    fn stepped(deceleration: f64, pull: Vector<f64>, mut v: Vector<f64>) -> (f64, Vector<f64>) {
        const H: f64 = 1e-5;
        let rate = |v: Vector<f64>| pull - v * (deceleration / v.norm());
        let (mut time, mut way) = (0.0, Vector::new(0.0, 0.0, 0.0));
        while v.norm() > 1e-4 {
            let middle = v + rate(v) * (0.5 * H);
            (v, way, time) = (v + rate(middle) * H, way + middle * H, time + H);
        }
        (time, way)
    }

    #[test]
    fn independent_roll_out_by_integration_in_small_steps() {
        let velocity = Vector::new(0.0, 3.0, 8.0);
        for pull in [
            [0.0, 0.0, 0.0],
            [0.0, 0.0, -1.5],
            [0.0, 1.2, 0.8],
            [0.3, -0.9, 1.1],
        ] {
            let pull = Vector::from_array(pull);
            let (time, way) = Rubbing {
                deceleration: 2.0,
                pull,
            }
            .stop(velocity);
            let (expected, there) = stepped(2.0, pull, velocity);
            assert!(
                (time - expected).abs() < 1e-3 * expected,
                "{time} against {expected}"
            );
            assert!(
                (way - there).norm() < 1e-3 * there.norm(),
                "{way:?} against {there:?}"
            );
        }
        // straight up and down the slope: v²/(2 (a ± G))
        for (pull, expected) in [(-1.0_f64, 100.0 / 6.0), (1.0, 100.0 / 2.0)] {
            let pull = Vector::new(0.0, 0.0, pull);
            let (_, way) = Rubbing {
                deceleration: 2.0,
                pull,
            }
            .stop(Vector::new(0.0, 0.0, 10.0));
            assert!((way.z / expected - 1.0).abs() < 1e-3, "{way:?}");
        }
    }

    #[test]
    fn no_rest_where_gravity_along_the_slope_reaches_the_deceleration() {
        let velocity = Vector::new(0.0_f64, 0.0, 5.0);
        for pull in [2.0, 2.5] {
            let (time, way) = Rubbing {
                deceleration: 2.0,
                pull: Vector::new(0.0, pull, 0.0),
            }
            .stop(velocity);
            assert!(time.is_nan() && way.z.is_nan());
        }
    }
}
