//! Flights in which one variable of the law is held within its fitted range. The change of the
//! carry shows the effect of the law outside this range.

use super::inputs::Inputs;
use super::motion::StepNode;
use super::result::RequestedOutputs;
use crate::aerodynamics::{AerodynamicLaw, Coefficients, LawProperties, Stream};
use crate::launch::Launch;
use crate::parameters::{Law, Setup};
use std::sync::atomic::AtomicBool;

/// Indices in [`Stream::variables`].
const SPIN_RATIO: usize = 0;
const SPIN: usize = 1;
const REYNOLDS: usize = 2;

/// A law with one of its variables clamped to a range.
struct HeldLaw {
    law: Law<f64>,
    variable: usize,
    range: [f64; 2],
    /// True if the law is stated in the spin, false if it is stated in the spin ratio.
    is_of_spin: bool,
}

impl HeldLaw {
    /// The flow with the variable clamped to the range. Clamping the spin or the spin ratio does
    /// not change airspeed and Reynolds number. Clamping the Reynolds number changes no other
    /// variable. Clamping the airspeed does not change the Reynolds number, and of spin and spin
    /// ratio it does not change the variable of the law.
    fn hold(&self, stream: Stream<f64>) -> Stream<f64> {
        let [low, high] = self.range;
        let mut held = stream;
        match self.variable {
            SPIN_RATIO => {
                held.spin = stream.spin_ratio().clamp(low, high) * stream.speed / stream.radius
            }
            SPIN => held.spin = stream.spin.clamp(low, high),
            REYNOLDS => held.reynolds_per_speed = stream.reynolds().clamp(low, high) / stream.speed,
            // the remaining variable is the airspeed
            _ => {
                let speed = stream.speed.clamp(low, high);
                let spin = if self.is_of_spin {
                    stream.spin
                } else {
                    stream.spin_ratio() * speed / stream.radius
                };
                held = Stream::new(spin, speed, stream.radius, stream.reynolds() / speed);
            }
        }
        held
    }
}

impl AerodynamicLaw<f64> for HeldLaw {
    fn coefficients(&self, stream: Stream<f64>) -> Coefficients<f64> {
        self.law.coefficients(self.hold(stream))
    }

    fn properties(&self) -> LawProperties {
        self.law.properties()
    }
}

/// The carry, m, of a flight in which `variable` of the law is clamped to `range`. `None` if the
/// ball does not land, or once `stop` is true.
pub(crate) fn carry_by_holding(
    setup: &Setup<f64>,
    launch: &Launch<f64>,
    variable: usize,
    range: [f64; 2],
    stop: &AtomicBool,
) -> Option<f64> {
    let inputs = Inputs::new(setup, launch, false);
    let law = HeldLaw {
        law: inputs.law,
        variable,
        range,
        is_of_spin: setup.law.properties().fitted.spin.is_some(),
    };
    let outputs = RequestedOutputs {
        apex: false,
        defect: false,
        stop: Some(stop),
    };
    let result = inputs.with_law(law).integrate(true, outputs, None);
    result.has_landed.then_some(result.landed.carry)
}

/// True if the variables of the law ([`Stream::variables`]) stay within `ranges` during the whole
/// flight. They are checked at the nodes, with a margin for their change between two nodes. False
/// if a variable may leave its range, or if the flight cannot be computed.
pub(crate) fn stays_within(
    setup: &Setup<f64>,
    launch: &Launch<f64>,
    ranges: [Option<[f64; 2]>; 4],
    stop: &AtomicBool,
) -> bool {
    let inputs = Inputs::new(setup, launch, false);
    let h = setup.flight.step;
    let holds = |node: &StepNode<f64>| {
        let speed = node.rate.speed;
        let stream = Stream::new(node.spin, speed, inputs.radius, inputs.reynolds_per_speed);
        // with the acceleration a, the airspeed v has v″ ≤ a²/v: it rises by at most (h a)²/(8 v)
        // within half a step h from a minimum; the margin is twice this rise, relative to v
        let margin = (h * node.rate.acceleration.norm() / speed).powi(2) * 0.25;
        let is_within = |(value, range): (f64, Option<[f64; 2]>)| {
            range.is_none_or(|[low, high]| {
                low <= value * (1.0 - margin) && value * (1.0 + margin) <= high
            })
        };
        stream.variables().into_iter().zip(ranges).all(is_within)
    };
    let mut stays = true;
    let flight = inputs.fly(
        Some(stop),
        Some(&mut |_, step| stays &= holds(step.from) && holds(step.to)),
    );
    stays && flight.is_ok()
}

#[cfg(test)]
mod tests {
    use super::carry_by_holding;
    use crate::Setup;
    use crate::drive::{Drive, Outcome};
    use std::sync::atomic::AtomicBool;

    /// Holding a variable within a range that contains the whole flight does not change the carry.
    /// With the spin ratio held near 0 the law gives no lift, and the carry is shorter.
    #[test]
    fn exact_carry_by_holding_within_the_range_is_that_of_the_drive() {
        let mut setup = Setup::preset("tour-average").unwrap();
        setup.set("wind.downrange", "-5 m/s").unwrap();
        let drive = Drive::new(&setup).unwrap();
        let carry = Outcome::Carry.value(&drive).unwrap();
        let never = AtomicBool::new(false);
        for variable in 0..4 {
            let held =
                carry_by_holding(&setup, &drive.launch, variable, [0.0, 1e9], &never).unwrap();
            assert!((held - carry).abs() < 1e-9, "{variable}: {held} {carry}");
        }
        let no_spin = carry_by_holding(&setup, &drive.launch, 0, [0.0, 1e-6], &never).unwrap();
        assert!(no_spin < carry - 20.0, "{no_spin}");
    }
}
