use super::motion::{Motion, Rate};
use super::node::{Added, Node, State, Stepper};
use super::pace::Pace;
use super::space::Space;
use super::surroundings::Surroundings;
use crate::number::{Factor, Numbers, inlined};
use crate::parameters::Method;
use std::sync::LazyLock;

/// What is summed with which weight.
type Weights = &'static [(usize, f64)];

/// Dormand & Prince (1980), J. Comp. Appl. Math. 6(1), table 2: the 6 stages of the fifth-order formula.
const DP5_A: &[Weights] = &[
    &[],
    &[(0, 1.0 / 5.0)],
    &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)],
    &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)],
    &[(0, 19372.0 / 6561.0), (1, -25360.0 / 2187.0), (2, 64448.0 / 6561.0), (3, -212.0 / 729.0)],
    &[(0, 9017.0 / 3168.0), (1, -355.0 / 33.0), (2, 46732.0 / 5247.0), (3, 49.0 / 176.0), (4, -5103.0 / 18656.0)],
];
const DP5_B: Weights =
    &[(0, 35.0 / 384.0), (2, 500.0 / 1113.0), (3, 125.0 / 192.0), (4, -2187.0 / 6784.0), (5, 11.0 / 84.0)];

/// Hairer, Nørsett & Wanner (1993), Solving Ordinary Differential Equations I, DOP853: the 12 stages of the eighth-order
/// formula.
#[rustfmt::skip]
const DP8_A: &[Weights] = & [
    &[],
    &[(0, 0.05260015195876773)],
    &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
    &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
    &[(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)],
    &[(0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242)],
    &[(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)],
    &[(0, 0.03709200011850479), (3, 0.17038392571223998), (4, 0.10726203044637328), (5, -0.015319437748624402), (6, 0.008273789163814023)],
    &[(0, 0.6241109587160757), (3, -3.3608926294469414), (4, -0.868219346841726), (5, 27.59209969944671), (6, 20.154067550477894), (7, -43.48988418106996)],
    &[(0, 0.47766253643826434), (3, -2.4881146199716677), (4, -0.590290826836843), (5, 21.230051448181193), (6, 15.279233632882423), (7, -33.28821096898486), (8, -0.020331201708508627)],
    &[(0, -0.9371424300859873), (3, 5.186372428844064), (4, 1.0914373489967295), (5, -8.149787010746927), (6, -18.52006565999696), (7, 22.739487099350505), (8, 2.4936055526796523), (9, -3.0467644718982196)],
    &[(0, 2.273310147516538), (3, -10.53449546673725), (4, -2.0008720582248625), (5, -17.9589318631188), (6, 27.94888452941996), (7, -2.8589982771350235), (8, -8.87285693353063), (9, 12.360567175794303), (10, 0.6433927460157636)],
];
#[rustfmt::skip]
const DP8_B: Weights = & [(0, 0.054293734116568765), (5, 4.450312892752409), (6, 1.8915178993145003), (7, -5.801203960010585), (8, 0.3111643669578199), (9, -0.1521609496625161), (10, 0.20136540080403034), (11, 0.04471061572777259)];

const MOST_STAGES: usize = 12;

/// An explicit Runge–Kutta method for x″ = a(t, x, x′), with the weights of its positions worked out: they are sums of
/// accelerations too.
struct Tableau {
    /// aᵢⱼ: how much of stage j's acceleration goes into stage i's velocity.
    a: &'static [Weights],
    /// bⱼ: how much goes into the velocity at the end.
    b: [f64; MOST_STAGES],
    /// cᵢ = Σ aᵢⱼ: when stage i is.
    c: [f64; MOST_STAGES],
    /// Σₖ aᵢₖ aₖⱼ: how much goes into stage i's position.
    position: [[f64; MOST_STAGES]; MOST_STAGES],
    /// Σᵢ bᵢ aᵢⱼ: how much goes into the position at the end.
    end: [f64; MOST_STAGES],
}

impl Tableau {
    fn new(a: &'static [Weights], b: Weights) -> Self {
        let combined = |outer: Weights| {
            let mut all = [0.0; MOST_STAGES];
            for &(k, outer_weight) in outer {
                for &(j, weight) in a[k] {
                    all[j] += outer_weight * weight;
                }
            }
            all
        };
        let (mut c, mut position) = ([0.0; MOST_STAGES], [[0.0; MOST_STAGES]; MOST_STAGES]);
        for (i, weights) in a.iter().enumerate() {
            c[i] = weights.iter().map(|(_, weight)| weight).sum();
            position[i] = combined(weights);
        }
        let mut last = [0.0; MOST_STAGES];
        for &(j, weight) in b {
            last[j] = weight;
        }
        Self { a, b: last, c, position, end: combined(b) }
    }

    fn of(method: Method) -> &'static Self {
        static DP5: LazyLock<Tableau> = LazyLock::new(|| Tableau::new(DP5_A, DP5_B));
        static DP8: LazyLock<Tableau> = LazyLock::new(|| Tableau::new(DP8_A, DP8_B));
        match method {
            Method::DormandPrince8 => &DP8,
            // rk4 has its own stepper, and is never asked for here
            Method::Rk4 | Method::DormandPrince5 => &DP5,
        }
    }
}

/// A method of higher order than [`Classical`](super::rk4::Classical), from its tableau.
#[derive(Clone, Copy)]
pub(super) struct Higher<C> {
    tableau: &'static Tableau,
    step: f64,
    /// exp(−δ cᵢ h), and exp(−δ h).
    fading: [C; MOST_STAGES],
    fading_at_end: C,
}

/// The accelerations of a step's stages, and the airspeeds.
struct Stages<T, S> {
    accelerations: [S; MOST_STAGES],
    airspeeds: [T; MOST_STAGES],
}

impl<C> Higher<C> {
    /// Computes the stages after the first.
    #[inline(always)]
    fn complete<T: Numbers, S: Space<T>, L: Surroundings<T>>(
        &self,
        motion: &Motion<T, S, L>,
        start: &State<T, S>,
        Stages { accelerations, airspeeds }: &mut Stages<T, S>,
    ) where
        C: Factor<T>,
    {
        let (h, tableau) = (self.step, self.tableau);
        for i in 1..tableau.a.len() {
            let mut velocity = start.velocity;
            for &(j, weight) in tableau.a[i] {
                velocity = accelerations[j].along(h * weight, velocity);
            }
            let air_path = inlined(
                #[inline(always)]
                || {
                    let mut path = start.air_path;
                    for &(j, weight) in tableau.a[i] {
                        path = airspeeds[j].scale_add(h * weight, path);
                    }
                    path
                },
            );
            let height = inlined(
                #[inline(always)]
                || {
                    let mut position = start.velocity.along(tableau.c[i] * h, start.position);
                    for (acceleration, weight) in accelerations.iter().zip(&tableau.position[i]).take(i) {
                        position = acceleration.along(h * h * weight, position);
                    }
                    position.up()
                },
            );
            let spin = motion.spin(self.fading[i].times(start.faded), air_path);
            let rate: Rate<T, S> = motion.rate(&spin, velocity, height);
            accelerations[i] = motion.acceleration(&rate);
            airspeeds[i] = rate.airspeed;
        }
    }

    /// Σ wⱼ aⱼ.
    #[inline(always)]
    fn sum<T: Numbers, S: Space<T>>(&self, stages: &Stages<T, S>, weights: &[f64; MOST_STAGES]) -> S {
        let mut sum = stages.accelerations[0].scaled(weights[0]);
        for (acceleration, weight) in stages.accelerations.iter().zip(weights).take(self.tableau.a.len()).skip(1) {
            sum = acceleration.along(*weight, sum);
        }
        sum
    }
}

impl<T: Numbers, S: Space<T>, C: Factor<T>> Stepper<T, S, C> for Higher<C> {
    #[inline(always)]
    fn new<L: Surroundings<T, Constant = C>>(motion: &Motion<T, S, L>, pace: &Pace) -> Self {
        let (tableau, step) = (Tableau::of(pace.method), pace.step);
        let mut fading = [C::constant(1.0); MOST_STAGES];
        for (fading, c) in fading.iter_mut().zip(tableau.c).take(tableau.a.len()) {
            *fading = motion.fading(c * step);
        }
        Self { tableau, step, fading, fading_at_end: motion.fading(step) }
    }

    #[inline(always)]
    fn step<L: Surroundings<T, Constant = C>>(
        &self,
        motion: &Motion<T, S, L>,
        from: &Node<T, S, L::Memory>,
        time: f64,
    ) -> (Node<T, S, L::Memory>, Added<T, S>) {
        let (h, start) = (self.step, from.state);
        // filled in where it stands: it is too large to be handed on
        let mut stages = Stages {
            accelerations: [motion.acceleration(&from.rate); MOST_STAGES],
            airspeeds: [from.rate.airspeed; MOST_STAGES],
        };
        self.complete(motion, &start, &mut stages);
        let (bent, gained) = (self.sum(&stages, &self.tableau.end), self.sum(&stages, &self.tableau.b));
        let position = bent.along(h * h, start.velocity.along(h, start.position));
        let velocity = gained.along(h, start.velocity);
        let (faded, mut air_path) = (self.fading_at_end.times(start.faded), start.air_path);
        if motion.is_damped() {
            for (airspeed, weight) in stages.airspeeds.iter().zip(&self.tableau.b).take(self.tableau.a.len()) {
                air_path = airspeed.scale_add(h * weight, air_path);
            }
        }
        let state = State { time, position, velocity, faded, air_path };
        // all stages are in the sums: the last adds nothing to them
        let still = velocity.scaled(0.0);
        let none = Rate { airspeed: T::zero(), pull: still, push: still };
        let gained = gained.raised(motion.gravity);
        let added = Added { bent, gained, last: none, weight: h };
        (Node::at(motion, state), added)
    }
}

#[cfg(test)]
mod tests {
    use super::{DP5_A, DP5_B, DP8_A, DP8_B, Tableau};

    /// The conditions Σ bᵢ cᵢᵏ⁻¹ = 1/k and Σ bᵢ aᵢⱼ cⱼᵏ⁻² = 1/(k (k − 1)) of order p, for k up to p (Hairer, Nørsett & Wanner 1993).
    #[test]
    fn exact_quadrature_conditions_of_each_order() {
        for (order, tableau) in [(5, Tableau::new(DP5_A, DP5_B)), (8, Tableau::new(DP8_A, DP8_B))] {
            for k in 1..=order {
                let power = |i: usize, n: i32| if n == 0 { 1.0 } else { tableau.c[i].powi(n) };
                let velocity: f64 = tableau.b.iter().enumerate().map(|(i, b)| b * power(i, k - 1)).sum();
                assert!((velocity - 1.0 / f64::from(k)).abs() < 1e-14, "order {k}: {velocity}");
                if k >= 2 {
                    let position: f64 = (0..tableau.a.len()).map(|j| tableau.end[j] * power(j, k - 2)).sum();
                    assert!((position - 1.0 / f64::from(k * (k - 1))).abs() < 1e-14, "order {k}: {position}");
                }
            }
        }
    }
}
