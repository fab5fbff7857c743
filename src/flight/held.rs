//! The effect of a law outside the range that it was fitted to: the carry with one variable of the
//! law held at the ends of its range.

use super::inputs::Inputs;
use crate::aerodynamics::{AerodynamicLaw, Stream};
use crate::launch::Launch;
use crate::number::Vector;
use crate::parameters::Setup;

/// Step of the classical Runge–Kutta method, s. The two carries are compared, so that most of the
/// error of a step cancels.
const STEP: f64 = 0.01;

/// The variables of a law, in the order of
/// [`Fitted::ranges`](crate::aerodynamics::Fitted::ranges).
const SPIN_RATIO: usize = 0;
const SPIN: usize = 1;
const REYNOLDS: usize = 2;

/// Position, velocity and spin of a ball, or their rates of change.
#[derive(Clone, Copy)]
struct State {
    position: Vector<f64>,
    velocity: Vector<f64>,
    spin: f64,
}

impl State {
    /// This state after a time at a rate of change.
    fn after(self, time: f64, rate: Self) -> Self {
        Self {
            position: self.position + rate.position * time,
            velocity: self.velocity + rate.velocity * time,
            spin: self.spin + rate.spin * time,
        }
    }
}

/// The change of the downrange carry, m, where a variable of the law is held within a range, in
/// place of its value outside. `None` if a ball does not land.
pub(crate) fn change_by_holding(
    setup: &Setup<f64>,
    launch: &Launch<f64>,
    variable: usize,
    range: [f64; 2],
) -> Option<f64> {
    let inputs = Inputs::new(setup, launch, false);
    let free = carry(&inputs, |stream| stream)?;
    let held = carry(&inputs, |stream| hold(stream, variable, range))?;
    Some(held - free)
}

/// A flow in which a variable is moved to the nearer end of a range, and the others stay.
fn hold(stream: Stream<f64>, variable: usize, [low, high]: [f64; 2]) -> Stream<f64> {
    let mut held = stream;
    match variable {
        SPIN_RATIO => {
            held.spin = stream.spin_ratio().clamp(low, high) * stream.speed / stream.radius
        }
        SPIN => held.spin = stream.spin.clamp(low, high),
        REYNOLDS => held.reynolds_per_speed = stream.reynolds().clamp(low, high) / stream.speed,
        // the airspeed: spin ratio and Reynolds number stay
        _ => {
            let speed = stream.speed.clamp(low, high);
            held = Stream::new(
                stream.spin_ratio() * speed / stream.radius,
                speed,
                stream.radius,
                stream.reynolds() / speed,
            );
        }
    }
    held
}

/// Downrange distance at which the ball falls through the height of the landing area, m.
fn carry(inputs: &Inputs<f64>, flow: impl Fn(Stream<f64>) -> Stream<f64>) -> Option<f64> {
    let rate = |state: State| {
        let v_r = state.velocity - inputs.wind.at(state.position.x);
        let rate = inputs.rate_by(v_r, state.spin, |stream| {
            inputs.law.coefficients(flow(stream))
        });
        let decay = inputs.decay + inputs.damping.unwrap_or_default() * rate.speed;
        State {
            position: state.velocity,
            velocity: rate.acceleration,
            spin: -decay * state.spin,
        }
    };
    let mut state = State {
        position: Vector::zero(),
        velocity: inputs.velocity,
        spin: inputs.spin,
    };
    let steps = (inputs.time_limit / STEP).min(1e5) as usize;
    for _ in 0..steps {
        let first = rate(state);
        let second = rate(state.after(0.5 * STEP, first));
        let third = rate(state.after(0.5 * STEP, second));
        let fourth = rate(state.after(STEP, third));
        let next = state
            .after(STEP / 6.0, first)
            .after(STEP / 3.0, second)
            .after(STEP / 3.0, third)
            .after(STEP / 6.0, fourth);
        if next.position.x < inputs.ground && next.velocity.x < 0.0 {
            let fall = state.position.x - next.position.x;
            let part = (state.position.x - inputs.ground) / fall;
            let way = next.position.z - state.position.z;
            return Some(state.position.z + part * way).filter(|carry| carry.is_finite());
        }
        state = next;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{Inputs, STEP, carry, change_by_holding};
    use crate::Setup;
    use crate::drive::{Drive, Outcome};

    /// The classical method and the flight of the model agree.
    #[test]
    fn same_carry_without_a_variable_held() {
        let mut setup = Setup::preset("tour-average").unwrap();
        setup.set("wind.downrange", "-5 m/s").unwrap();
        let drive = Drive::new(&setup).unwrap();
        let inputs = Inputs::new(&setup, &drive.launch, false);
        let ours = carry(&inputs, |stream| stream).unwrap();
        let exact = Outcome::Carry.value(&drive).unwrap();
        // the place of the landing within the last step is that of a chord
        assert!((ours - exact).abs() < 30.0 * STEP * STEP, "{ours} {exact}");
    }

    /// A variable within the range is not held; a variable far outside makes a shorter carry where
    /// the lift is held.
    #[test]
    fn exact_change_by_holding_is_0_within_the_range() {
        let setup = Setup::preset("tour-average").unwrap();
        let launch = Drive::new(&setup).unwrap().launch;
        for variable in 0..4 {
            let wide = [0.0, 1e9];
            let change = change_by_holding(&setup, &launch, variable, wide).unwrap();
            assert!(change.abs() < 1e-9, "{variable}: {change}");
        }
        let no_spin = change_by_holding(&setup, &launch, 0, [0.0, 1e-6]).unwrap();
        assert!(no_spin < -20.0, "{no_spin}");
    }
}
