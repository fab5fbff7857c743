use super::{Numbers, inlined};

/// Smooth (C²) upper clamp: the value is x up to `end`, the constant `end + over/2` from
/// `end + over` on, and a polynomial of degree 4 in between. It keeps the variable of a formula
/// within the range in which the formula is valid.
#[inline(always)]
pub(crate) fn smooth_clamp_above<T: Numbers>(x: T, end: f64, over: f64) -> T {
    T::select_lazily(
        x.below(end),
        inlined!(|| x),
        inlined!(|| {
            let beyond = (x - end) * (1.0 / over);
            let u = beyond.select(T::constant(1.0), beyond.below(1.0));
            let square = u * u;
            // the derivative is (1 − u)² (1 + 2u): 1 at u = 0 and 0 at u = 1; the second derivative
            // is 0 at both ends
            (square * square).scale_add(0.5, u - u * square) * over + end
        }),
    )
}

/// Smooth (C²) lower clamp: the value is x from `end` on, the constant `end − over/2` up to
/// `end − over`, and a polynomial of degree 4 in between.
#[inline(always)]
pub(crate) fn smooth_clamp_below<T: Numbers>(x: T, end: f64, over: f64) -> T {
    -smooth_clamp_above(-x, -end, over)
}

/// Smooth (C²) step: the value is 0 up to `start`, 1 from `start + over` on, and a polynomial of
/// degree 5 in between.
#[inline(always)]
pub(crate) fn smooth_step<T: Numbers>(x: T, start: f64, over: f64) -> T {
    let u = (x - start) * (1.0 / over);
    let u = u.select(T::zero(), (-u).below(0.0));
    let u = u.select(T::constant(1.0), u.below(1.0));
    (u * u * u) * (u * u).scale_add(6.0, u.scale_add(-15.0, T::constant(10.0)))
}

#[cfg(test)]
mod tests {
    use super::{smooth_clamp_above, smooth_clamp_below, smooth_step};
    use num_dual::Dual2_64;

    #[test]
    fn exact_c2_at_both_ends_of_the_way_and_constant_beyond() {
        let at = |x: f64| Dual2_64::from(x).derivative();
        let above = |x: f64| smooth_clamp_above(at(x), 0.3, 0.2);
        let below = |x: f64| smooth_clamp_below(at(x), -0.3, 0.2);
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
        let parts = |found: Dual2_64| (found.re, found.v1, found.v2);
        assert_eq!(
            (
                parts(above(0.25)),
                parts(rise(-1.0)),
                rise(0.4).re,
                parts(rise(7.0))
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
                parts(above(x)),
                (-mirrored.re, mirrored.v1, -mirrored.v2),
                "{x}"
            );
        }
    }
}
