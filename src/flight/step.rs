//! One step of an explicit Runge–Kutta method (docs/model.md, eq. 16).

use super::inputs::Inputs;
use super::motion::{Rate, StepNode};
use super::tableau::{MOST_STAGES, Tableau};
use crate::aerodynamics::AerodynamicLaw;
use crate::number::{Numbers, Vector, inlined};

/// Computes the steps of one flight. All steps have the length h.
pub(super) struct Stepper<'a, T, L> {
    inputs: &'a Inputs<T, L>,
    pub tableau: &'static Tableau,
    /// Step h, s.
    h: f64,
    /// exp(−δ cᵢ h): factor by which the spin decays from the start of a step to stage i, without
    /// damping.
    decay_factors: [T; MOST_STAGES + 1],
    /// Rates at the stages of a step. Entry 0 is unused, because the first stage is the start node.
    rates: [Rate<T>; MOST_STAGES],
}

/// A step of the integration.
#[derive(Debug)]
pub(crate) struct Step<'n, T> {
    /// Start node. Start and end node are swapped at each step, not copied: copies take 16 to 24 %
    /// of a drive with rk4 (`src/number/mod.rs`, "Pipelines").
    pub from: &'n mut StepNode<T>,
    pub to: &'n mut StepNode<T>,
    /// Position increment x₁ − x₀ − h v₀, computed without the rounding of x₁.
    pub position_increment: Vector<T>,
    /// Velocity increment v₁ − v₀, computed without the rounding of v₁.
    pub velocity_increment: Vector<T>,
}

/// Callback that receives the start time of each step, and the step.
pub(crate) type StepObserver<'o, T> = Option<&'o mut dyn FnMut(f64, &Step<'_, T>)>;

impl<T: Numbers> Step<'_, T> {
    /// Defect of a step of length h, m (docs/model.md, eq. 16a): |Δx − Δx_H| (|Δv|/|v_r|)⁴, where
    /// Δx_H is the change of position Δx by Hermite's quadrature. The defect of a step is O(h⁹), so
    /// the sum over a flight is O(h⁸).
    #[inline(always)]
    pub fn defect(&self, h: f64) -> T {
        let (a0, a1) = (self.from.rate.acceleration, self.to.rate.acceleration);
        let difference = (a0 - a1).scale_add(
            h * h * (-1.0 / 12.0),
            self.velocity_increment
                .scale_add(-0.5 * h, self.position_increment),
        );
        let speed = self.from.rate.speed;
        let change = self.velocity_increment.dot(self.velocity_increment) / (speed * speed);
        difference.norm() * change * change
    }
}

impl<'a, T: Numbers, L: AerodynamicLaw<T>> Stepper<'a, T, L> {
    #[inline(always)]
    pub fn new(inputs: &'a Inputs<T, L>) -> Self {
        let (tableau, h) = (Tableau::of(inputs.method), inputs.step);
        let mut decay_factors = [T::constant(1.0); MOST_STAGES + 1];
        for (factor, time) in decay_factors
            .iter_mut()
            .zip(tableau.times)
            .take(tableau.stages + 1)
            .skip(1)
        {
            *factor = (inputs.decay * (-time * h)).exp();
        }
        Self {
            inputs,
            tableau,
            h,
            decay_factors,
            rates: [Rate::zero(); MOST_STAGES],
        }
    }

    /// Computes the next step in place of `step`.
    #[inline(always)]
    pub fn advance(&mut self, step: &mut Step<'_, T>) {
        std::mem::swap(&mut step.from, &mut step.to);
        let (inputs, tableau, h) = (self.inputs, self.tableau, self.h);
        let StepNode {
            position: x,
            velocity: v,
            spin,
            ..
        } = *step.from;
        let (start, end) = (&step.from.rate, tableau.stages);
        let mut stage_spin = spin;
        // the end of the step is one more stage
        for i in 1..=end {
            // inlined by hand: a separate function costs 3 % of the instructions of a drive without
            // derivatives
            let mut height = v.x.scale_add(h * tableau.times[i], x.x);
            // only a wind profile depends on the height
            if inputs.wind.depends_on_height() {
                for &(stage, weight) in &tableau.position_weights[i][..i - 1] {
                    let acceleration = self.stage_rate(start, stage).acceleration.x;
                    height = acceleration.scale_add(h * h * weight, height);
                }
            }
            let v_r = v - inputs.wind.at(height);
            let v_r = self.add_accelerations(v_r, start, tableau.velocity_weights[i], h);
            stage_spin = self.stage_spin(start, spin, i);
            let rate = if i == end {
                &mut step.to.rate
            } else {
                &mut self.rates[i]
            };
            *rate = inputs.rate(v_r, stage_spin);
        }
        // velocity increment h Σ bᵢ aᵢ and position increment h² Σ bᵢ aᵢⱼ aⱼ, with weights bᵢ and
        // aᵢⱼ, and accelerations aᵢ
        let zero = Vector::zero();
        let (b, ba) = (
            tableau.velocity_weights[end],
            &tableau.position_weights[end][..end - 1],
        );
        step.velocity_increment = self.add_accelerations(zero, start, b, h);
        step.position_increment = self.add_accelerations(zero, start, ba, h * h);
        step.to.position = v.scale_add(h, x + step.position_increment);
        step.to.velocity = v + step.velocity_increment;
        step.to.spin = stage_spin;
    }

    /// Spin at stage i from the spin at the start of the step: ω exp(−δ t − κ ℓ/R), with the time t
    /// and the distance ℓ through the air since the start (docs/model.md, eq. 13).
    #[inline(always)]
    fn stage_spin(&self, start: &Rate<T>, spin: T, i: usize) -> T {
        let decayed = spin * self.decay_factors[i];
        let Some(damping) = self.inputs.damping else {
            return decayed;
        };
        let mut distance = T::zero();
        for &(stage, weight) in self.tableau.velocity_weights[i] {
            let speed = self.stage_rate(start, stage).speed;
            distance = speed.scale_add(self.h * weight, distance);
        }
        T::not_inlined(inlined!(|| decayed * (-(damping * distance)).exp()))
    }

    /// `sum` + k Σ wⱼ aⱼ, with the weights wⱼ and the accelerations aⱼ of the stages.
    #[inline(always)]
    fn add_accelerations(
        &self,
        mut sum: Vector<T>,
        start: &Rate<T>,
        weights: &[(usize, f64)],
        k: f64,
    ) -> Vector<T> {
        for &(stage, weight) in weights {
            let acceleration = self.stage_rate(start, stage).acceleration;
            sum = acceleration.scale_add(k * weight, sum);
        }
        sum
    }

    /// The rate at a stage; the first stage is the start of the step.
    #[inline(always)]
    fn stage_rate<'r>(&'r self, start: &'r Rate<T>, stage: usize) -> &'r Rate<T> {
        if stage == 0 {
            start
        } else {
            &self.rates[stage]
        }
    }
}
