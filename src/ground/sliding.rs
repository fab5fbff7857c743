//! Sliding of a body to rest (docs/model.md, eq. 23).

use crate::number::{Numbers, Vector, inlined};

/// η, m/s: √(v·v + η²) − η replaces |v|, which has a corner at rest.
const SMOOTHING_SPEED: f64 = 1e-4;

/// Time T, s, and displacement D, m, until a body of this velocity rests (eq. 23). The body slides
/// under dry friction and a constant force: dv/dt = G − a v/|v|, with the `deceleration` a by
/// friction, m/s², and the acceleration G by the force, `pull`, m/s². NaN if |G| ≥ a, because the
/// body does not stop.
///
/// T follows from d(a|v| + v·G)/dt = −(a² − |G|²). D is the integral of v over this time.
#[inline(always)]
pub(super) fn slide_to_rest<T: Numbers>(
    velocity: Vector<T>,
    deceleration: T,
    pull: Vector<T>,
) -> (T, Vector<T>) {
    T::not_inlined(inlined!(|| {
        let a = deceleration;
        let speed =
            (velocity.dot(velocity) + SMOOTHING_SPEED * SMOOTHING_SPEED).sqrt() - SMOOTHING_SPEED;
        // v·G, |G|² and a²
        let (v_g, g_squared, a_squared) = (velocity.dot(pull), pull.dot(pull), a * a);
        let difference = a_squared - g_squared;
        let difference = difference.select(T::constant(f64::NAN), (-difference).below(0.0));
        // 1/(a² − G²) and 1/(4a² − G²)
        let per_difference = difference.recip();
        let per_quadruple = (a_squared * 4.0 - g_squared).recip();
        let a_speed = a * speed;
        let by_pull = speed * speed + v_g * (a_speed * 6.0 + v_g * 3.0) * per_quadruple;
        let displacement = velocity * ((a_speed * 2.0 + v_g) * per_quadruple)
            + pull * (by_pull * per_difference * 0.25);
        ((a_speed + v_g) * per_difference, displacement)
    }))
}

#[cfg(test)]
mod tests {
    use super::slide_to_rest;
    use crate::number::Vector;

    /// dv/dt = G − a v/|v|, integrated by the midpoint method in small steps.
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
            let (time, way) = slide_to_rest(velocity, 2.0, pull);
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
            let (_, way) = slide_to_rest(Vector::new(0.0, 0.0, 10.0), 2.0, pull);
            assert!((way.z / expected - 1.0).abs() < 1e-3, "{way:?}");
        }
    }

    #[test]
    fn no_rest_where_gravity_along_the_slope_reaches_the_deceleration() {
        let velocity = Vector::new(0.0_f64, 0.0, 5.0);
        for pull in [2.0, 2.5] {
            let (time, way) = slide_to_rest(velocity, 2.0, Vector::new(0.0, pull, 0.0));
            assert!(time.is_nan() && way.z.is_nan());
        }
    }
}
