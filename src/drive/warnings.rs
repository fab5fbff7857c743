//! Warnings about a drive that is computed as it stands.

use super::flat::{assumed, flat_landing_angle};
use super::validity::{any_face, is_outside_any_face};
use super::{Drive, Outcome};
use crate::aerodynamics::{AerodynamicLaw, FittedRange, range_in_words};
use crate::atmosphere::{AirState, WindField};
use crate::flight::{Flight, fly, trajectory};
use crate::parameters::Setup;
use crate::units::{Digits, Message, Quantity};

/// Less than this part of the time of flight outside of what a law was fitted to is not worth a
/// word: the laws are uncertain by more within it.
const WORTH_A_WORD: f64 = 0.01;

/// A landing that moves by more than this where the step is halved is worth a word, m.
const LARGEST_SHIFT: f64 = 1e-3;

/// How far a flight goes along what its law was fitted to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within {
    /// The least and the greatest value in the flight, SI.
    pub flown: [f64; 2],
    /// The share of the time of flight with values outside of the range, 0 to 1.
    pub outside: f64,
}

impl Drive<f64> {
    /// All warnings about a setup and its drive: what the setup warns of, corners of the model that
    /// the drive lies on, a strike beside any face, drag and lift where the law was not fitted, and
    /// a step so long that the landing depends on it. It flies the drive again; a search asks only
    /// about its result.
    pub fn warnings(&self, setup: &Setup<f64>) -> Vec<Message> {
        let mut warnings = setup.warnings();
        warnings.extend(self.corners(setup).into_iter().map(Message::from));
        warnings.extend(self.beside_the_face(setup).map(Message::from));
        warnings.extend(self.law_warnings(setup));
        warnings.extend(self.in_long_steps(setup));
        warnings
    }

    /// The [`warnings`](Self::warnings) of a drive of which these outcomes are asked for or shown:
    /// where one of them is of the run, also that the ball lands flatter than any whose bounce was
    /// measured.
    pub fn warnings_about(&self, setup: &Setup<f64>, of: &[Outcome]) -> Vec<Message> {
        let mut warnings = self.warnings(setup);
        warnings.extend(
            self.lands_flat(setup)
                .filter(|_| of.iter().any(|of| of.needs_run())),
        );
        warnings
    }

    /// A ball that bounces, and landed flatter than any whose bounce was measured.
    fn lands_flat(&self, setup: &Setup<f64>) -> Option<Message> {
        let angle = flat_landing_angle(
            [setup.ground.slope, setup.ground.side_slope],
            self.landed().ok()?,
        )?;
        let message = Message::from("the ball lands at ");
        let message = message.quantity(Quantity::ANGLE, "deg", angle, Digits::Significant(4));
        Some(assumed(message.words(" to the ground, below ")))
    }

    /// Steps so long that the ball lands elsewhere in steps of half their length.
    fn in_long_steps(&self, setup: &Setup<f64>) -> Option<Message> {
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

    /// A strike beside the face of any head that conforms.
    fn beside_the_face(&self, setup: &Setup<f64>) -> Option<String> {
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

    /// What the law of drag and lift was not fitted to, and for how much of the flight.
    pub(super) fn law_warnings(&self, setup: &Setup<f64>) -> Vec<Message> {
        let fitted = setup.law.fitted();
        let told = |(k, ((name, unit, range), within)): (usize, (FittedRange, Option<Within>))| {
            let Within { flown, outside } =
                within.filter(|within| within.outside >= WORTH_A_WORD)?;
            let [low, high] = range?;
            let mut left = [[false; 2]; 4];
            left[k] = [flown[0] < low, flown[1] > high];
            let fitted_to = Message::from(format!(
                "the law {} was fitted to a {name} of ",
                setup.law.name()
            ));
            let before = range_in_words(fitted_to, unit, [low, high])
                .words(format!(" ({}); in this flight it goes from ", fitted.to));
            let how = fitted.beyond(left);
            let after = format!(
                ", {:.0} % of the time outside, where the law is {how}",
                100.0 * outside
            );
            Some(range_in_words(before, unit, flown).words(after))
        };
        fitted
            .ranges()
            .into_iter()
            .zip(self.flown_ranges(setup))
            .enumerate()
            .filter_map(told)
            .collect()
    }

    /// How far the flight goes along each of the ranges that the law was fitted to, in the order of
    /// [`Fitted::ranges`](crate::aerodynamics::Fitted::ranges), and which share of it is outside;
    /// `None` where no range is known, and without air or a flight.
    pub fn flown_ranges(&self, setup: &Setup<f64>) -> [Option<Within>; 4] {
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
            Some(Within { flown, outside })
        })
    }

    /// Spin ratio, spin, Reynolds number and speed through the air along the flight, with their
    /// times.
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
        let (mut way, mut before) = (0.0, None);
        let mut point = |point: &crate::flight::TrajectoryPoint| {
            let speed = (point.velocity - wind.at(point.position.x)).norm();
            if let Some((time, slower)) = before.replace((point.time, speed)) {
                way += 0.5 * (slower + speed) * (point.time - time);
            }
            // docs/model.md, eq. 13
            let faded = setup.aero.spin_decay * point.time
                + setup.aero.spin_damping.unwrap_or_default() * way / radius;
            let spin = self.launch.total_spin() * (-faded).exp();
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

/// The part of the time in which values, with their times, are so; between two of them as at the
/// first.
fn share(values: impl Iterator<Item = (f64, f64)>, is_so: impl Fn(f64) -> bool) -> f64 {
    let (mut all, mut so, mut before) = (0.0, 0.0, None);
    for (time, value) in values {
        if let Some((earlier, was_so)) = before.replace((time, is_so(value))) {
            all += time - earlier;
            so += if was_so { time - earlier } else { 0.0 };
        }
    }
    if all > 0.0 { so / all } else { 0.0 }
}
