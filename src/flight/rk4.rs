use super::motion::{Motion, Rate, SpinNow};
use super::node::{Added, Node, State, Stepper};
use super::pace::Pace;
use super::space::Space;
use super::surroundings::Surroundings;
use crate::number::{Factor, Numbers, inlined};

/// The classical fourth-order Runge–Kutta method (Kutta 1901) with a fixed step.
///
/// For x″ = a(t, x, x′) its position update Σ bᵢ vᵢ is h v + h²/6 (a₁ + a₂ + a₃), and the stages' positions
/// are wanted only where the wind depends on height.
#[derive(Clone, Copy)]
pub(super) struct Classical<C> {
    step: f64,
    /// exp(−δ h/2).
    fading: C,
}

/// What moves the ball at the second, third and fourth stage, and the spin at the end.
struct Stages<T: Numbers, S: Space<T>, M> {
    second: Rate<T, S>,
    third: Rate<T, S>,
    fourth: Rate<T, S>,
    faded: T,
    last_spin: SpinNow<T, S, M>,
}

impl<C> Classical<C> {
    #[inline(always)]
    fn stages<T: Numbers, S: Space<T>, L: Surroundings<T>>(
        &self,
        motion: &Motion<T, S, L>,
        from: &Node<T, S, L::Memory>,
    ) -> Stages<T, S, L::Memory>
    where
        C: Factor<T>,
    {
        let (h, half) = (self.step, 0.5 * self.step);
        let State { position: x, velocity: v, faded, air_path, .. } = from.state;
        let first = from.rate;
        let path_after = inlined(
            #[inline(always)]
            |time: f64, rate: &Rate<T, S>| rate.airspeed.scale_add(time, air_path),
        );
        let halfway = self.fading.times(faded);
        let at_end = self.fading.times(halfway);

        let spin = motion.later_spin(
            halfway,
            (faded, from.memory),
            #[inline(always)]
            || path_after(half, &first),
        );
        let second = motion.rate(
            &spin,
            motion.after(&first, half, v),
            #[inline(always)]
            || v.along(half, x).up(),
        );

        let spin = if motion.is_damped() {
            motion.spin(
                halfway,
                #[inline(always)]
                || path_after(half, &second),
            )
        } else {
            spin
        };
        let third = motion.rate(
            &spin,
            motion.after(&second, half, v),
            #[inline(always)]
            || motion.acceleration(&first).along(half * half, v.along(half, x)).up(),
        );

        let last_spin = motion.later_spin(
            at_end,
            (halfway, spin.memory),
            #[inline(always)]
            || path_after(h, &third),
        );
        let fourth = motion.rate(
            &last_spin,
            motion.after(&third, h, v),
            #[inline(always)]
            || motion.acceleration(&second).along(half * h, v.along(h, x)).up(),
        );
        Stages { second, third, fourth, faded: at_end, last_spin }
    }
}

impl<T: Numbers, S: Space<T>, C: Factor<T>> Stepper<T, S, C> for Classical<C> {
    #[inline(always)]
    fn new<L: Surroundings<T, Constant = C>>(motion: &Motion<T, S, L>, pace: &Pace) -> Self {
        let step = pace.step;
        Self { step, fading: motion.fading(0.5 * step) }
    }

    #[inline(always)]
    fn step<L: Surroundings<T, Constant = C>>(
        &self,
        motion: &Motion<T, S, L>,
        from: &Node<T, S, L::Memory>,
        time: f64,
    ) -> (Node<T, S, L::Memory>, Added<T, S>) {
        let h = self.step;
        let stages = self.stages(motion, from);
        let State { position: x, velocity: v, mut air_path, .. } = from.state;
        // a₁ + a₂ + a₃ and a₁ + 2 a₂ + 2 a₃
        let inner = motion.acceleration(&stages.second) + motion.acceleration(&stages.third);
        let sum = motion.acceleration(&from.rate) + inner;
        let weighted = sum + inner;
        let position = sum.along(h * h / 6.0, v.along(h, x));
        let velocity = motion.after(&stages.fourth, h / 6.0, weighted.along(h / 6.0, v));
        let mut spin = stages.last_spin;
        if motion.is_damped() {
            let inner = stages.second.airspeed + stages.third.airspeed;
            air_path = (from.rate.airspeed + inner + inner + stages.fourth.airspeed).scale_add(h / 6.0, air_path);
            spin = motion.spin(
                stages.faded,
                #[inline(always)]
                || air_path,
            );
        }
        let memory = spin.memory;
        let rate = motion.rate(
            &spin,
            velocity,
            #[inline(always)]
            || position.up(),
        );
        let added = Added { bent: sum, gained: weighted, last: stages.fourth, weight: h / 6.0 };
        let state = State { time, position, velocity, faded: stages.faded, air_path };
        (Node { state, rate, memory }, added)
    }
}
