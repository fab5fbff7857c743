use super::inputs::Inputs;
use super::motion::{Node, Rate, State};
use super::tableau::{MOST_STAGES, Tableau};
use crate::number::{Numbers, Vector, inlined};

/// A method with a fixed step, for one flight.
pub(super) struct Stepper<'a, T> {
    inputs: &'a Inputs<T>,
    tableau: &'static Tableau,
    /// s.
    h: f64,
    /// exp(−δ cᵢ h): what is left of a spin at each stage, apart from damping.
    left: [T; MOST_STAGES + 1],
    /// The rates at the stages of a step.
    rates: [Rate<T>; MOST_STAGES],
}

/// A step of the integration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step<T> {
    /// Its two ends, in turns: the end of one step is the start of the next, without a copy. A copy reads at once what was just written in
    /// smaller pieces, and the processor waits for it: 16 to 24 % of a drive with rk4.
    nodes: [Node<T>; 2],
    /// Whether the first of them is the end.
    ends_at_first: bool,
    /// x₁ − x₀ − h v₀ and v₁ − v₀, as computed, before the sums rounded them.
    pub deflection: Vector<T>,
    pub gained: Vector<T>,
}

impl<T: Numbers> Step<T> {
    /// No step yet: at a state.
    #[inline(always)]
    pub fn at(state: State<T>, inputs: &Inputs<T>) -> Self {
        let nodes = [Node { state, rate: Rate::none() }; 2];
        let mut step = Self { nodes, ends_at_first: false, deflection: Vector::zero(), gained: Vector::zero() };
        inputs.find_node(state, step.to_mut());
        step
    }

    /// Its start.
    #[inline(always)]
    pub fn from(&self) -> &Node<T> {
        &self.nodes[usize::from(self.ends_at_first)]
    }

    /// Its end.
    #[inline(always)]
    pub fn to(&self) -> &Node<T> {
        &self.nodes[usize::from(!self.ends_at_first)]
    }

    #[inline(always)]
    fn to_mut(&mut self) -> &mut Node<T> {
        &mut self.nodes[usize::from(!self.ends_at_first)]
    }

    /// How far a step of length h is from Hermite's quadrature between its ends, times (|Δv|/|v_r|)⁴, m (docs/model.md, eq. 16a). It grows as h⁹; the
    /// sum over a flight as h⁸.
    #[inline(always)]
    pub fn defect(&self, h: f64) -> T {
        let (a0, a1) = (self.from().rate.acceleration, self.to().rate.acceleration);
        let off = (a0 - a1).scale_add(h * h * (-1.0 / 12.0), self.gained.scale_add(-0.5 * h, self.deflection));
        let speed = self.from().rate.speed;
        let changed = self.gained.dot(self.gained) / (speed * speed);
        off.norm() * changed * changed
    }
}

impl<'a, T: Numbers> Stepper<'a, T> {
    #[inline(always)]
    pub fn new(inputs: &'a Inputs<T>, tableau: &'static Tableau, h: f64) -> Self {
        let mut left = [T::constant(1.0); MOST_STAGES + 1];
        for (part, time) in left.iter_mut().zip(tableau.time).take(tableau.stages + 1).skip(1) {
            *part = (inputs.decay * (-time * h)).exp();
        }
        Self { inputs, tableau, h, left, rates: [Rate::none(); MOST_STAGES] }
    }

    /// Makes a step the one that follows it.
    #[inline(always)]
    pub fn advance(&mut self, step: &mut Step<T>) {
        step.ends_at_first = !step.ends_at_first;
        let (inputs, tableau, h) = (self.inputs, self.tableau, self.h);
        let State { position: x, velocity: v, spin } = step.from().state;
        self.rates[0] = step.from().rate;
        for i in 1..tableau.stages {
            let mut height = v.x.scale_add(h * tableau.time[i], x.x);
            if inputs.wind.depends_on_height() {
                for &(stage, weight) in &tableau.position[i][..i - 1] {
                    height = self.rates[stage].acceleration.x.scale_add(h * h * weight, height);
                }
            }
            // the wind first, as the sum waits for the stage before
            let air = self.sum(tableau.velocity[i], h, v - inputs.wind.at(height));
            self.rates[i] = inputs.forces(air, self.spin(spin, i));
        }
        let end = tableau.stages;
        let gained = self.sum(tableau.velocity[end], h, Vector::zero());
        let deflection = self.sum(&tableau.position[end][..end - 1], h * h, Vector::zero());
        let state =
            State { position: v.scale_add(h, x + deflection), velocity: v + gained, spin: self.spin(spin, end) };
        (step.deflection, step.gained) = (deflection, gained);
        inputs.find_node(state, step.to_mut());
    }

    /// The spin at a stage, of what it was at the start of the step: ω exp(−δ t − κ ℓ/R), ℓ the way through the air since.
    #[inline(always)]
    fn spin(&self, spin: T, stage: usize) -> T {
        let faded = spin * self.left[stage];
        let Some(damping) = self.inputs.damping else { return faded };
        let mut way = T::zero();
        for (of, weight) in self.tableau.velocity[stage] {
            way = self.rates[*of].speed.scale_add(self.h * weight, way);
        }
        T::outlined(inlined!(|| faded * (-(damping * way)).exp()))
    }

    /// start + k Σ wⱼ aⱼ.
    #[inline(always)]
    fn sum(&self, weights: &[(usize, f64)], k: f64, start: Vector<T>) -> Vector<T> {
        let mut sum = start;
        for &(stage, weight) in weights {
            sum = self.rates[stage].acceleration.scale_add(k * weight, sum);
        }
        sum
    }
}
