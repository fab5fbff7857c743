//! Flights in which one variable of the law is held within its fitted range. The change of the
//! carry shows the effect of the law outside this range.

use super::inputs::Inputs;
use super::motion::StepNode;
use super::result::RequestedOutputs;
use crate::aerodynamics::{AerodynamicLaw, Coefficients, Fitted, LawProperties, Stream};
use crate::launch::Launch;
use crate::parameters::{Law, LawVariable, Method, Setup};
use std::sync::atomic::AtomicBool;

/// A law with one of its variables clamped to a range.
struct HeldLaw {
    law: Law<f64>,
    variable: LawVariable,
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
            LawVariable::SpinRatio => {
                held.spin = stream.spin_ratio().clamp(low, high) * stream.speed / stream.radius
            }
            LawVariable::Spin => held.spin = stream.spin.clamp(low, high),
            LawVariable::Reynolds => {
                held.reynolds_per_speed = stream.reynolds().clamp(low, high) / stream.speed;
            }
            LawVariable::Speed => {
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

/// The largest step, s, of flights with a held law. The held law has a corner at the end of the
/// range, which the long steps chosen for the smooth law do not resolve.
const LARGEST_STEP: f64 = 0.01;

/// The change of the carry, m, if `variable` of the law is clamped to `range`. `None` if the ball
/// does not land, or once `stop` is true.
pub(crate) fn change_by_holding(
    setup: &Setup<f64>,
    launch: &Launch<f64>,
    variable: LawVariable,
    range: [f64; 2],
    stop: &AtomicBool,
) -> Option<f64> {
    let mut fine = *setup;
    fine.method = Method::Rk4;
    fine.flight.step = setup.flight.step.min(LARGEST_STEP);
    let inputs = Inputs::new(&fine, launch);
    let held = HeldLaw {
        law: inputs.law,
        variable,
        range,
        is_of_spin: setup.law.properties().fitted.spin.is_some(),
    };
    let outputs = RequestedOutputs {
        apex: false,
        run: false,
        defect: false,
        stop: Some(stop),
    };
    let own = inputs.integrate(true, outputs, None);
    let held = inputs.with_law(held).integrate(true, outputs, None);
    (own.has_landed && held.has_landed).then_some(held.landed.carry - own.landed.carry)
}

/// True if the variables of the law stay within their fitted ranges during the whole flight. They
/// are checked at the nodes, with a margin for their change between two nodes. False if a variable
/// may leave its range, or if the flight cannot be computed.
pub(crate) fn stays_within(
    setup: &Setup<f64>,
    launch: &Launch<f64>,
    fitted: &Fitted,
    stop: &AtomicBool,
) -> bool {
    let inputs = Inputs::new(setup, launch);
    let h = setup.flight.step;
    let holds = |node: &StepNode<f64>| {
        let speed = node.rate.speed;
        let stream = Stream::new(node.spin, speed, inputs.radius, inputs.reynolds_per_speed);
        // with the acceleration a, the airspeed v has v″ ≤ a²/v: it rises by at most (h a)²/(8 v)
        // within half a step h from a minimum; the margin is twice this rise, relative to v
        let margin = (h * node.rate.acceleration.norm() / speed).powi(2) * 0.25;
        LawVariable::ALL.into_iter().all(|variable| {
            let value = stream.value(variable);
            fitted.range(variable).is_none_or(|[low, high]| {
                low <= value * (1.0 - margin) && value * (1.0 + margin) <= high
            })
        })
    };
    let mut stays = true;
    let outputs = RequestedOutputs::without_run(stop);
    let flight = inputs.fly(
        outputs,
        Some(&mut |_, step| stays &= holds(step.from) && holds(step.to)),
    );
    stays && flight.is_ok()
}

#[cfg(test)]
mod tests {
    use super::change_by_holding;
    use crate::Setup;
    use crate::drive::Drive;
    use crate::parameters::{LawVariable, Method};
    use std::sync::atomic::AtomicBool;

    /// Holding a variable within a range that contains the whole flight does not change the carry.
    /// With the spin ratio held near 0 the law gives no lift, and the carry is shorter.
    #[test]
    fn exact_no_change_by_holding_within_the_range() {
        let mut setup = Setup::preset("tour-average").unwrap();
        setup.set("wind.downrange", "-5 m/s").unwrap();
        let drive = Drive::new(&setup).unwrap();
        let never = AtomicBool::new(false);
        for variable in LawVariable::ALL {
            let change =
                change_by_holding(&setup, &drive.launch, variable, [0.0, 1e9], &never).unwrap();
            assert!(change.abs() < 1e-9, "{variable:?}: {change}");
        }
        let variable = LawVariable::SpinRatio;
        let no_spin =
            change_by_holding(&setup, &drive.launch, variable, [0.0, 1e-6], &never).unwrap();
        assert!(no_spin < -20.0, "{no_spin}");
    }

    /// With any method and step of the setup, holding a variable changes the carry by the same
    /// amount as with steps of 1 ms, within 5 %.
    #[test]
    fn the_change_by_holding_hardly_depends_on_the_step_of_the_setup() {
        let mut setup = Setup::preset("modern-driver").unwrap();
        let settings = [
            ("swing.speed", "102.1 mph"),
            ("club.loft", "7.9 deg"),
            ("wind.downrange", "8.6 mph"),
        ];
        setup.set_all(settings).unwrap();
        let change = |method, step| {
            let mut other = setup;
            (other.method, other.flight.step) = (method, step);
            let drive = Drive::new(&other).unwrap();
            drive.extrapolated_carry(&other).unwrap()
        };
        let fine = change(Method::Rk4, 1e-3);
        for (method, step) in [(Method::DormandPrince8, 0.4), (Method::Rk4, 0.01)] {
            let coarse = change(method, step);
            assert!(
                (coarse / fine - 1.0).abs() < 0.05,
                "{coarse} m, not {fine} m"
            );
        }
        assert!((0.3..0.6).contains(&fine.abs()), "{fine} m");
    }
}
