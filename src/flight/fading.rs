use super::inputs::Inputs;
use super::motion::Node;
use crate::number::{Numbers, inlined};

impl<T: Numbers> Inputs<T> {
    /// |ω| between the nodes of a step, at s = (t − t₀)/h: exact where the spin fades in time alone. Where it is damped by the way through the air, the
    /// polynomial of degree 5 with the spin of both ends and two derivatives of it: neighbouring
    /// ones join C².
    #[inline(always)]
    pub(super) fn spin_within(&self, [from, to]: [&Node<T>; 2], s: T) -> T {
        let Some(damping) = self.damping else {
            return T::outlined(inlined!(
                || from.spin * (-(self.decay * s * self.step)).exp()
            ));
        };
        let mut ends = [[s; 3]; 2];
        for (end, node) in ends.iter_mut().zip([from, to]) {
            *end = self.spin_and_derivatives(node, damping);
        }
        let [[p0, m0, c0], [p1, m1, c1]] = ends;
        // what the parabola from the start leaves over at the end
        let x = p1 - p0 - m0 - c0 * 0.5;
        let v = m1 - m0 - c0;
        let a = c1 - c0;
        let third = x.scale_add(10.0, v.scale_add(-4.0, a * 0.5));
        let fourth = x.scale_add(-15.0, v.scale_add(7.0, -a));
        let fifth = x.scale_add(6.0, v.scale_add(-3.0, a * 0.5));
        p0 + (m0 + (c0 * 0.5 + (third + (fourth + fifth * s) * s) * s) * s) * s
    }

    /// The spin at a node with its first and second derivative by s.
    #[inline(always)]
    fn spin_and_derivatives(&self, node: &Node<T>, damping: T) -> [T; 3] {
        let (spin, h) = (node.spin, self.step);
        let rate = damping.mul_add(node.rate.speed, self.decay);
        let damping_change = damping * self.rate_per_time(node).speed;
        [
            spin,
            -(rate * spin) * h,
            spin * (rate * rate - damping_change) * (h * h),
        ]
    }
}
