//! Warnings about a drive.

use super::validity::{
    any_face, flat_landing_angle, is_outside_any_face, with_flat_landing_warning,
};
use super::{Drive, Outcome};
use crate::aerodynamics::{AerodynamicLaw, FittedRange, range_in_words};
use crate::atmosphere::{AirState, WindField};
use crate::flight::{Flight, fly, trajectory};
use crate::parameters::Setup;
use crate::units::{Digits, Message, Quantity};

/// Smallest share of the flight time outside the ranges of the law for which there is a warning.
/// The uncertainty of a law within its ranges has a larger effect than this share.
const LEAST_WARNED_SHARE: f64 = 0.01;

/// Largest shift of the landing by half the step, m, without a warning.
const LARGEST_SHIFT: f64 = 1e-3;

/// Values of a variable along a flight, and the range that the law was fitted to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlownRange {
    /// Least and greatest value in the flight, SI.
    pub flown: [f64; 2],
    /// Share of the flight time with values outside the law's range, 0 to 1.
    pub outside: f64,
}

impl Drive<f64> {
    /// All warnings about a setup and its drive: the warnings about the setup, corners of the model
    /// at this drive, a strike outside any face, a flight outside the ranges of the law, and a step
    /// so long that the landing depends on it. The flight is computed again, so a search requests
    /// the warnings for its result only.
    pub fn warnings(&self, setup: &Setup<f64>) -> Vec<Message> {
        let mut warnings = setup.warnings();
        warnings.extend(self.corners(setup).into_iter().map(Message::from));
        warnings.extend(self.off_face_warning(setup).map(Message::from));
        warnings.extend(self.law_warnings(setup));
        warnings.extend(self.long_step_warning(setup));
        warnings
    }

    /// The [`warnings`](Self::warnings) of a drive for these requested outcomes. If one of the
    /// outcomes depends on the run, there is also a warning about a landing flatter than any
    /// measured bounce.
    pub fn warnings_about(&self, setup: &Setup<f64>, of: &[Outcome]) -> Vec<Message> {
        let mut warnings = self.warnings(setup);
        warnings.extend(
            self.flat_landing_warning(setup)
                .filter(|_| of.iter().any(|of| of.needs_run())),
        );
        warnings
    }

    /// Warning about a landing flatter than any measured bounce.
    fn flat_landing_warning(&self, setup: &Setup<f64>) -> Option<Message> {
        let angle = flat_landing_angle(
            [setup.ground.slope, setup.ground.side_slope],
            self.landed().ok()?,
        )?;
        let message = Message::from("the ball lands at ");
        let message = message.quantity(Quantity::ANGLE, "deg", angle, Digits::Significant(4));
        Some(with_flat_landing_warning(
            message.words(" to the ground, below "),
        ))
    }

    /// Warning about a step so long that half the step shifts the landing.
    fn long_step_warning(&self, setup: &Setup<f64>) -> Option<Message> {
        let landed = self.landed().ok()?;
        let mut finer = *setup;
        finer.flight.step *= 0.5;
        let Ok(Flight::Landed(there)) = fly(&finer, &self.launch) else {
            return None;
        };
        let shift = (there.carry - landed.carry).hypot(there.lateral - landed.lateral);
        let step = Quantity::TIME.show(setup.flight.step, "s");
        let method = setup.method.name();
        let long = format!(
            "flight.step = {step} is long for the method {method}: in steps of half the length the \
             ball lands "
        );
        (shift > LARGEST_SHIFT).then(|| {
            Message::from(long)
                .quantity(Quantity::LENGTH, "mm", shift, Digits::Significant(2))
                .words(" from there; make flight.step shorter")
        })
    }

    /// Warning about a strike outside the face of any conforming head.
    fn off_face_warning(&self, setup: &Setup<f64>) -> Option<String> {
        self.impact.as_ref()?;
        let show = |value: f64| Quantity::LENGTH.show(value, "mm");
        let strike = &setup.strike;
        is_outside_any_face(strike.toe, strike.high).then(|| {
            format!(
                "strike.toe = {} and strike.high = {} lie outside {}: no club strikes the ball \
                 there",
                show(strike.toe),
                show(strike.high),
                any_face()
            )
        })
    }

    /// Warnings about variables outside the ranges that the law was fitted to.
    pub(super) fn law_warnings(&self, setup: &Setup<f64>) -> Vec<Message> {
        let fitted = setup.law.fitted();
        let name = setup.law.name();
        let warning = |k: usize, (variable, unit, range): FittedRange, flown: FlownRange| {
            let [low, high] = range?;
            if flown.outside < LEAST_WARNED_SHARE {
                return None;
            }
            let [least, greatest] = flown.flown;
            let mut exceeded_ends = [[false; 2]; 4];
            exceeded_ends[k] = [least < low, greatest > high];
            let how = fitted.continuation(exceeded_ends);
            let percent = 100.0 * flown.outside;
            let message = format!("the law {name} was fitted to a {variable} of ").into();
            let message = range_in_words(message, unit, [low, high])
                .words(format!(" ({}); in this flight it goes from ", fitted.to));
            Some(range_in_words(message, unit, flown.flown).words(format!(
                ", {percent:.0} % of the time outside, where the law is {how}"
            )))
        };
        fitted
            .ranges()
            .into_iter()
            .zip(self.flown_ranges(setup))
            .enumerate()
            .filter_map(|(k, (range, flown))| warning(k, range, flown?))
            .collect()
    }

    /// Values along the flight of each variable with a known range of the law, in the order of
    /// [`Fitted::ranges`](crate::aerodynamics::Fitted::ranges); `None` for a variable without a
    /// known range, and without air or a flight.
    pub fn flown_ranges(&self, setup: &Setup<f64>) -> [Option<FlownRange>; 4] {
        let ranges = setup.law.fitted().ranges().map(|(.., range)| range);
        if AirState::of(&setup.air).density == 0.0 || ranges == [None; 4] {
            return [None; 4];
        }
        let path = self.stream(setup);
        std::array::from_fn(|k| {
            let [low, high] = ranges[k].filter(|_| !path.is_empty())?;
            let values = path.iter().map(|(time, values)| (*time, values[k]));
            let outside = share(values.clone(), |value| !(low..=high).contains(&value));
            let flown = values.fold(
                [f64::INFINITY, f64::NEG_INFINITY],
                |[least, most], (_, value)| [least.min(value), most.max(value)],
            );
            Some(FlownRange { flown, outside })
        })
    }

    /// Time, and spin ratio, spin, Reynolds number and airspeed at the points of the trajectory.
    fn stream(&self, setup: &Setup<f64>) -> Vec<(f64, [f64; 4])> {
        let Ok(path) = trajectory(setup, &self.launch) else {
            return vec![];
        };
        let (wind, radius) = (
            WindField::new(&setup.wind, &setup.ground),
            setup.ball.radius,
        );
        let air = AirState::of(&setup.air);
        let per_speed = air.density * 2.0 * radius / air.viscosity;
        let (mut distance, mut before) = (0.0, None);
        let mut point = |point: &crate::flight::TrajectoryPoint| {
            let speed = (point.velocity - wind.at(point.position.x)).norm();
            if let Some((time, slower)) = before.replace((point.time, speed)) {
                distance += 0.5 * (slower + speed) * (point.time - time);
            }
            // δ t + κ ℓ/R, docs/model.md, eq. 13
            let decay = setup.aero.spin_decay * point.time
                + setup.aero.spin_damping.unwrap_or_default() * distance / radius;
            let spin = self.launch.total_spin() * (-decay).exp();
            (speed > 0.0).then(|| {
                (
                    point.time,
                    [spin * radius / speed, spin, per_speed * speed, speed],
                )
            })
        };
        path.points.iter().filter_map(&mut point).collect()
    }
}

/// Share of the time in which a condition holds, from values with their times. The value at the
/// start of each interval represents the interval.
fn share(values: impl Iterator<Item = (f64, f64)>, condition: impl Fn(f64) -> bool) -> f64 {
    let (mut total, mut held, mut before) = (0.0, 0.0, None);
    for (time, value) in values {
        if let Some((earlier, did_hold)) = before.replace((time, condition(value))) {
            total += time - earlier;
            held += if did_hold { time - earlier } else { 0.0 };
        }
    }
    if total > 0.0 { held / total } else { 0.0 }
}
