use super::inputs::Inputs;
use super::motion::{Node, Rate};
use super::tableau::{MOST_STAGES, Tableau};
use crate::number::{Numbers, Vector, inlined};

/// A method with a fixed step, for one flight.
pub(super) struct Stepper<'a, T> {
    inputs: &'a Inputs<T>,
    tableau: &'static Tableau,
    /// s.
    h: f64,
    /// exp(−δ cᵢ h): the part of the spin that is left at each stage, apart from damping.
    decay: [T; MOST_STAGES + 1],
    /// The rates at the stages of a step, but the first, which is the rate at its start.
    rates: [Rate<T>; MOST_STAGES],
}

/// A step of the integration.
#[derive(Debug)]
pub(crate) struct Step<'n, T> {
    /// Its two ends. The end of one step is the start of the next: they change places, without a
    /// copy. A copy reads at once what was just written in smaller pieces, and the processor waits
    /// for it: 16 to 24 % of a drive with rk4.
    pub from: &'n mut Node<T>,
    pub to: &'n mut Node<T>,
    /// x₁ − x₀ − h v₀ and v₁ − v₀, as computed, before the sums rounded them.
    pub deflection: Vector<T>,
    pub gained: Vector<T>,
}

/// Who is shown each step, with the time it begins at.
pub(crate) type Observer<'o, T> = Option<&'o mut dyn FnMut(f64, &Step<'_, T>)>;

impl<T: Numbers> Step<'_, T> {
    /// How far a step of length h is from Hermite's quadrature between its ends, times
    /// (|Δv|/|v_r|)⁴, m (docs/model.md, eq. 16a). It grows as h⁹; the sum over a flight as h⁸.
    #[inline(always)]
    pub fn defect(&self, h: f64) -> T {
        let (a0, a1) = (self.from.rate.acceleration, self.to.rate.acceleration);
        let off = (a0 - a1).scale_add(
            h * h * (-1.0 / 12.0),
            self.gained.scale_add(-0.5 * h, self.deflection),
        );
        let speed = self.from.rate.speed;
        let changed = self.gained.dot(self.gained) / (speed * speed);
        off.norm() * changed * changed
    }
}

impl<'a, T: Numbers> Stepper<'a, T> {
    #[inline(always)]
    pub fn new(inputs: &'a Inputs<T>, tableau: &'static Tableau, h: f64) -> Self {
        let mut decay = [T::constant(1.0); MOST_STAGES + 1];
        for (part, time) in decay
            .iter_mut()
            .zip(tableau.time)
            .take(tableau.stages + 1)
            .skip(1)
        {
            *part = (inputs.decay * (-time * h)).exp();
        }
        Self {
            inputs,
            tableau,
            h,
            decay,
            rates: [Rate::none(); MOST_STAGES],
        }
    }

    /// Makes a step the one that follows it.
    #[inline(always)]
    pub fn advance(&mut self, step: &mut Step<'_, T>) {
        std::mem::swap(&mut step.from, &mut step.to);
        let (inputs, tableau, h) = (self.inputs, self.tableau, self.h);
        let Node {
            position: x,
            velocity: v,
            spin,
            ..
        } = *step.from;
        let (start, end) = (&step.from.rate, tableau.stages);
        let mut faded = spin;
        // the end of a step is like one more stage
        for i in 1..=end {
            let mut height = v.x.scale_add(h * tableau.time[i], x.x);
            if inputs.wind.depends_on_height() {
                for &(stage, weight) in &tableau.position[i][..i - 1] {
                    height = self
                        .rate(start, stage)
                        .acceleration
                        .x
                        .scale_add(h * h * weight, height);
                }
            }
            // the wind first, as the sum waits for the stage before
            let air = self.sum(start, tableau.velocity[i], h, v - inputs.wind.at(height));
            faded = self.spin(start, spin, i);
            let rate = if i == end {
                &mut step.to.rate
            } else {
                &mut self.rates[i]
            };
            *rate = inputs.forces(air, faded);
        }
        step.gained = self.sum(start, tableau.velocity[end], h, Vector::zero());
        step.deflection = self.sum(
            start,
            &tableau.position[end][..end - 1],
            h * h,
            Vector::zero(),
        );
        let position = v.scale_add(h, x + step.deflection);
        (step.to.position, step.to.velocity, step.to.spin) = (position, v + step.gained, faded);
    }

    /// The rate at a stage: at the first, that at the start of the step.
    #[inline(always)]
    fn rate<'r>(&'r self, start: &'r Rate<T>, stage: usize) -> &'r Rate<T> {
        if stage == 0 {
            start
        } else {
            &self.rates[stage]
        }
    }

    /// The spin at a stage, of what it was at the start of the step: ω exp(−δ t − κ ℓ/R), ℓ the way
    /// through the air since.
    #[inline(always)]
    fn spin(&self, start: &Rate<T>, spin: T, stage: usize) -> T {
        let faded = spin * self.decay[stage];
        let Some(damping) = self.inputs.damping else {
            return faded;
        };
        let mut way = T::zero();
        for &(of, weight) in self.tableau.velocity[stage] {
            way = self.rate(start, of).speed.scale_add(self.h * weight, way);
        }
        T::outlined(inlined!(|| faded * (-(damping * way)).exp()))
    }

    /// What is there without the stages, and k Σ wⱼ aⱼ.
    #[inline(always)]
    fn sum(
        &self,
        start: &Rate<T>,
        weights: &[(usize, f64)],
        k: f64,
        without: Vector<T>,
    ) -> Vector<T> {
        let mut sum = without;
        for &(stage, weight) in weights {
            sum = self
                .rate(start, stage)
                .acceleration
                .scale_add(k * weight, sum);
        }
        sum
    }
}
