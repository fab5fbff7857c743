//! Warnings about a drive.

use super::validity::{
    LEAST_WARNED_CHANGE, LEAST_WARNED_SHARE, any_face, flat_landing_angle, is_outside_any_face,
    with_flat_landing_warning,
};
use super::{Drive, Outcome};
use crate::aerodynamics::{AerodynamicLaw, Continuation, Stream};
use crate::atmosphere::{AirState, WindField};
use crate::flight::{
    Flight, Inputs, RequestedOutputs, TrajectoryPoint, change_by_holding, stays_within,
    trajectory_until,
};
use crate::parameters::{LawVariable, Setup};
use crate::units::{Digits, Message, Quantity};
use serde::Serialize;
use std::sync::atomic::AtomicBool;

/// A variable of a flight outside the range that the law was fitted to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extrapolated {
    variable: LawVariable,
    flown: FlownRange,
    /// Change of the carry, m, if the variable is held within the range. `None` if the change is at
    /// most 0.3 yd, or if the law itself holds the variable. Also `None` if the ball does not land.
    change: Option<f64>,
}

/// Largest shift of the landing, m, when the step is halved. If the shift is larger, a warning says
/// that the step is long.
const LEAST_WARNED_SHIFT: f64 = 1e-3;

/// The fitted range of a quantity of the law, and its range in the flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "LawRange"))]
pub struct FlownRange {
    /// The range of the fit.
    #[serde(serialize_with = "crate::json::range")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonRange"))]
    pub fitted: [f64; 2],
    /// The range in the flight.
    #[serde(serialize_with = "crate::json::range")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonRange"))]
    pub flown: [f64; 2],
    /// The fraction of the flight time outside of the fitted range.
    #[serde(rename = "share_outside", serialize_with = "crate::json::number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub outside: f64,
}

impl Setup<f64> {
    /// The [warnings](Drive::warnings_about) about the setup and its drive, for the requested
    /// outcomes `of`. Without a drive, the warnings are about the setup only.
    pub fn drive_warnings(&self, of: &[Outcome]) -> Vec<Message> {
        Drive::new(self).map_or_else(|_| self.warnings(), |drive| drive.warnings_about(self, of))
    }
}

impl Drive<f64> {
    /// All warnings about a setup and its drive:
    ///
    /// - warnings about the setup, and corners of the model at this drive;
    /// - a strike outside the largest face that the Rules of Golf allow;
    /// - a flight outside the ranges of the law;
    /// - a step so long that the landing depends on it;
    /// - if an outcome in `of` depends on the run, a landing flatter than any measured bounce.
    ///
    /// The warnings need further flights, so a search requests them for its result only.
    pub fn warnings_about(&self, setup: &Setup<f64>, of: &[Outcome]) -> Vec<Message> {
        self.warnings_until(setup, of, false, &AtomicBool::new(false))
    }

    /// Like [`warnings_about`](Self::warnings_about); the flights are interrupted once `stop` is
    /// true. The step is not checked if `is_step_chosen` is true.
    pub(crate) fn warnings_until(
        &self,
        setup: &Setup<f64>,
        of: &[Outcome],
        is_step_chosen: bool,
        stop: &AtomicBool,
    ) -> Vec<Message> {
        let mut warnings = setup.warnings();
        warnings.extend(self.corners(setup).into_iter().map(Message::from));
        warnings.extend(self.off_face_warning(setup).map(Message::from));
        warnings.extend(self.law_warnings(setup, stop));
        if !is_step_chosen {
            warnings.extend(self.long_step_warning(setup, stop));
        }
        warnings.extend(
            self.flat_landing_warning(setup)
                .filter(|_| of.iter().any(|of| of.needs_run())),
        );
        warnings
    }

    /// Warning about a landing flatter than any measured bounce.
    pub(crate) fn flat_landing_warning(&self, setup: &Setup<f64>) -> Option<Message> {
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

    fn long_step_warning(&self, setup: &Setup<f64>, stop: &AtomicBool) -> Option<Message> {
        let landed = self.landed().ok()?;
        let mut finer = *setup;
        finer.flight.step *= 0.5;
        finer.flight.check_steps().ok()?;
        let outputs = RequestedOutputs::without_run(stop);
        let again = Inputs::new(&finer, &self.launch).fly(outputs, None);
        let Ok(Flight::Landed(there)) = again else {
            return None;
        };
        let shift = (there.carry - landed.carry).hypot(there.lateral - landed.lateral);
        let step = Quantity::TIME.show(setup.flight.step, "s");
        let method = setup.method.name();
        let long = format!(
            "flight.step = {step} is long for the method {method}: with steps of half this length \
             the landing shifts by "
        );
        (shift > LEAST_WARNED_SHIFT).then(|| {
            Message::from(long)
                .quantity(Quantity::LENGTH, "mm", shift, Digits::Significant(2))
                .words("; make flight.step shorter")
        })
    }

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

    /// The largest change of the carry, m, if a variable of the law that leaves its fitted range is
    /// held within this range; `None` if no variable changes the carry by more than 0.3 yd.
    pub fn extrapolated_carry(&self, setup: &Setup<f64>) -> Option<f64> {
        let changes = self
            .extrapolated(setup, &AtomicBool::new(false))
            .into_iter();
        changes
            .filter_map(|extrapolated| extrapolated.change)
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// The variables of the law that leave their fitted range and cause a warning. A variable
    /// causes a warning if holding it within the range changes the carry by more than 0.3 yd. If
    /// the law itself holds the variable, or if the change is unknown, the variable also causes a
    /// warning if its share of the flight time outside the range is at least
    /// [`LEAST_WARNED_SHARE`].
    pub(super) fn extrapolated(&self, setup: &Setup<f64>, stop: &AtomicBool) -> Vec<Extrapolated> {
        let fitted = setup.law.properties().fitted;
        if stays_within(setup, &self.launch, &fitted, stop) {
            return vec![];
        }
        let one = |(variable, flown): (LawVariable, Option<FlownRange>)| {
            let flown = flown?;
            if flown.outside == 0.0 {
                return None;
            }
            let Continuation {
                is_extrapolated,
                is_held,
            } = fitted.continuation(variable, flown.flown);
            let change = is_extrapolated
                .then(|| change_by_holding(setup, &self.launch, variable, flown.fitted, stop))
                .flatten();
            let has_share = (is_held || change.is_none()) && flown.outside >= LEAST_WARNED_SHARE;
            let change = change.filter(|change| change.abs() > LEAST_WARNED_CHANGE);
            (has_share || change.is_some()).then_some(Extrapolated {
                variable,
                flown,
                change,
            })
        };
        let flown = LawVariable::ALL
            .into_iter()
            .zip(self.flown_ranges(setup, stop));
        flown.filter_map(one).collect()
    }

    /// Warnings about the variables that [`extrapolated`](Self::extrapolated) returns.
    pub(super) fn law_warnings(&self, setup: &Setup<f64>, stop: &AtomicBool) -> Vec<Message> {
        let fitted = setup.law.properties().fitted;
        let name = setup.law.name();
        let warning = |extrapolated: Extrapolated| {
            let Extrapolated {
                variable,
                flown,
                change,
            } = extrapolated;
            let how = fitted.continuation(variable, flown.flown);
            let percent = 100.0 * flown.outside;
            let beginning = format!("the law {name} was fitted to a {} of ", variable.name());
            let message = variable
                .append_range(beginning.into(), flown.fitted)
                .words(format!(" ({}); in this flight it is ", fitted.to));
            let message = variable.append_range(message, flown.flown).words(format!(
                ", and outside of that range for {percent:.0} % of the time, where the law is {how}"
            ));
            match change {
                None => message,
                Some(change) => message.words("; ").message(carry_with_law_held(change)),
            }
        };
        let extrapolated = self.extrapolated(setup, stop).into_iter();
        extrapolated.map(warning).collect()
    }

    /// The fitted range of each variable of the law, and its range in the flight, in the order of
    /// [`LawVariable::ALL`]. `None` for a variable without a known fitted range, and for all
    /// variables if there is no air or no flight, or once `stop` is true.
    pub fn flown_ranges(&self, setup: &Setup<f64>, stop: &AtomicBool) -> [Option<FlownRange>; 4] {
        let fitted = setup.law.properties().fitted;
        if AirState::of(&setup.air).density == 0.0 || fitted.is_unknown() {
            return [None; 4];
        }
        let path = self.stream(setup, stop);
        std::array::from_fn(|k| {
            let fitted @ [low, high] = fitted
                .range(LawVariable::ALL[k])
                .filter(|_| !path.is_empty())?;
            let values = path.iter().map(|(time, values)| (*time, values[k]));
            let outside = share(values.clone(), |value| !(low..=high).contains(&value));
            let flown = values.fold(
                [f64::INFINITY, f64::NEG_INFINITY],
                |[least, most], (_, value)| [least.min(value), most.max(value)],
            );
            Some(FlownRange {
                fitted,
                flown,
                outside,
            })
        })
    }

    /// For each point of the trajectory, the time, s, and [`Stream::variables`]. Empty if the
    /// flight cannot be computed.
    fn stream(&self, setup: &Setup<f64>, stop: &AtomicBool) -> Vec<(f64, [f64; 4])> {
        let Ok(path) = trajectory_until(setup, &self.launch, stop) else {
            return vec![];
        };
        let wind = WindField::new(&setup.wind, &setup.ground);
        let radius = setup.ball.radius;
        let reynolds_per_speed = AirState::of(&setup.air).reynolds_per_speed(radius);
        let stream = |point: &TrajectoryPoint| {
            let speed = (point.velocity - wind.at(point.position.x)).norm();
            let stream = Stream::new(point.spin.norm(), speed, radius, reynolds_per_speed);
            (speed > 0.0).then(|| (point.time, stream.variables()))
        };
        path.points.iter().filter_map(stream).collect()
    }
}

/// A change of the carry by [`Drive::extrapolated_carry`] in words: "with the law held at the end of
/// its range the carry would be 1.3 yd longer".
pub fn carry_with_law_held(change: f64) -> Message {
    Message::from("with the law held at the end of its range the carry would be ")
        .quantity(Quantity::LENGTH, "yd", change.abs(), Digits::Significant(2))
        .words(if change < 0.0 { " shorter" } else { " longer" })
}

/// Share of the time for which `condition` is true. `values` are pairs of time and value. Each
/// value applies until the next time.
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
