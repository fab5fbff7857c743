use super::{Numbers, inlined};

/// Beyond what a formula is good for its variable is held: `x` up to `end`, then a way with two
/// continuous derivatives to `end + over/2`, which it reaches at `end + over` and keeps.
#[inline(always)]
pub(crate) fn held_above<T: Numbers>(x: T, end: f64, over: f64) -> T {
    T::choose(
        x.below(end),
        inlined!(|| x),
        inlined!(|| {
            let beyond = (x - end) * (1.0 / over);
            let u = beyond.blend(T::constant(1.0), beyond.below(1.0));
            let square = u * u;
            // its slope is (1 − u)² (1 + 2u): 1 and without bend at u = 0, 0 and without bend at u
            // = 1
            (square * square).scale_add(0.5, u - u * square) * over + end
        }),
    )
}

/// The same below: `x` down to `end`, `end − over/2` from `end − over` on.
#[inline(always)]
pub(crate) fn held_below<T: Numbers>(x: T, end: f64, over: f64) -> T {
    -held_above(-x, -end, over)
}

/// 0 up to `start`, 1 from `start + over` on, and between them a way with two continuous
/// derivatives.
#[inline(always)]
pub(crate) fn smooth_step<T: Numbers>(x: T, start: f64, over: f64) -> T {
    let u = (x - start) * (1.0 / over);
    let u = u.blend(T::zero(), (-u).below(0.0));
    let u = u.blend(T::constant(1.0), u.below(1.0));
    (u * u * u) * (u * u).scale_add(6.0, u.scale_add(-15.0, T::constant(10.0)))
}

#[cfg(test)]
mod tests {
    use super::{held_above, held_below, smooth_step};
    use num_dual::Dual2_64;

    #[test]
    fn exact_c2_at_both_ends_of_the_way_and_constant_beyond() {
        let at = |x: f64| Dual2_64::from(x).derivative();
        let above = |x: f64| held_above(at(x), 0.3, 0.2);
        let below = |x: f64| held_below(at(x), -0.3, 0.2);
        let rise = |x: f64| smooth_step(at(x), 0.2, 0.4);
        let is_smooth = |f: &dyn Fn(f64) -> Dual2_64, end: f64| {
            let [a, b] = [end * (1.0 - 1e-12), end * (1.0 + 1e-12)].map(f);
            (a.re - b.re).abs() < 1e-11 && (a.v1 - b.v1).abs() < 1e-10 && (a.v2 - b.v2).abs() < 1e-9
        };
        assert!(
            is_smooth(&above, 0.3)
                && is_smooth(&above, 0.5)
                && is_smooth(&rise, 0.2)
                && is_smooth(&rise, 0.6)
        );
        let told = |found: Dual2_64| (found.re, found.v1, found.v2);
        assert_eq!(
            (
                told(above(0.25)),
                told(rise(-1.0)),
                rise(0.4).re,
                told(rise(7.0))
            ),
            ((0.25, 1.0, 0.0), (0.0, 0.0, 0.0), 0.5, (1.0, 0.0, 0.0))
        );
        for x in [0.5, 0.7, 1e9] {
            let there = above(x);
            assert!(
                (there.re - 0.4).abs() < 1e-15 && there.v1 == 0.0 && there.v2 == 0.0,
                "{there:?}"
            );
        }
        for x in [0.1, 0.33, 0.42, 0.8] {
            let mirrored = below(-x);
            assert_eq!(
                told(above(x)),
                (-mirrored.re, mirrored.v1, -mirrored.v2),
                "{x}"
            );
        }
    }
}
