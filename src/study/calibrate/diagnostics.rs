//! Warnings and notes about a table of shots and the fit to it.

use super::calibration::{Calibration, CalibrationStatus, Estimate};
use super::residuals::at_shot;
use super::shot_table::{MeasuredShot, ShotTable};
use super::statistics::SigmaOrigin;
use super::verdict::{WARNED_MISFIT, misfit_text};
use crate::drive::{CheckScope, ExceededCount, exceeded_in_flight};
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::cancellable::{LIMITS_NOT_CHECKED, each_until};
use crate::units::{Digits, Message};
use std::sync::atomic::AtomicBool;

impl Calibration {
    /// Warnings about the fit: rows that are read as deliveries although they have launches,
    /// residuals too large for noise, values on a bound, and confidence intervals that reach beyond
    /// the allowed range.
    pub fn warnings(&self, table: &ShotTable) -> Vec<Message> {
        let of_values = self.estimates.iter().filter_map(value_warning);
        self.club_warning(table)
            .into_iter()
            .chain(self.misfit_warning(table))
            .chain(of_values)
            .collect()
    }

    /// Warning that the balls do not fly from the measured launches: rows with launch and club
    /// columns are deliveries, and the impact computes their launch. `None` if a parameter of
    /// swing, club, strike or impact is fitted, because this fit needs the impact.
    fn club_warning(&self, table: &ShotTable) -> Option<Message> {
        let [launch, club] = table.launch_beside_club.as_ref()?;
        let is_of_flight = self
            .estimates
            .iter()
            .all(|estimate| !estimate.parameter.is_of_strike());
        is_of_flight.then(|| {
            format!(
                "the rows are read as deliveries of a club, since the table has {club}: each \
                 launch is computed by the impact, and {launch} are \
                 measured values that it is compared with; to fly the measured launches, leave \
                 {club} out"
            )
            .into()
        })
    }

    /// Warning for residuals far larger than their uncertainties. `None` if the status of the fit
    /// already reports them, or if an uncertainty is unknown.
    fn misfit_warning(&self, table: &ShotTable) -> Option<Message> {
        let is_unreported = !matches!(
            self.verdict.status,
            CalibrationStatus::DominatedByOneResidual | CalibrationStatus::Misfit
        );
        let is_judged = table.sigma_origin != SigmaOrigin::Weights;
        misfit_text(&self.statistics, WARNED_MISFIT)
            .filter(|_| is_unreported && is_judged)
            .map(Message::from)
    }
}

/// Warning for a value on a bound, or a confidence interval that reaches beyond the allowed range.
fn value_warning(estimate: &Estimate) -> Option<Message> {
    let (parameter, name) = (estimate.parameter, estimate.parameter.name);
    let show = |value: f64| parameter.show(Some(value));
    if estimate.is_at_bound && estimate.is_determined {
        let bounds = [parameter.range.low, parameter.range.high];
        let advice = match bounds.contains(&estimate.value) {
            true => "the end of its allowed values: the fitted model does not describe the data",
            false => {
                "the end of its range: beyond it the sum of squares would decrease further; give \
                 a wider range, or check the data"
            }
        };
        return Some(format!("{name} ended at {}, {advice}", show(estimate.value)).into());
    }
    let interval = estimate.interval_95?;
    let is_beyond = interval
        .iter()
        .any(|end| *end < parameter.range.low || *end > parameter.range.high);
    is_beyond.then(|| {
        let [low, high] = interval.map(show);
        let allowed = parameter.range.show(parameter.quantity, parameter.unit);
        format!(
            "the 95 % interval of {name}, {low} to {high}, reaches beyond its allowed range \
             ({allowed}): the data hardly determine it; measure more, or fit fewer parameters"
        )
        .into()
    })
}

/// Parameters of the setup that the note of [`ShotTable::one_drive`] shows.
const SHOWN: [&str; 3] = ["swing.speed", "swing.attack_angle", "club.loft"];

impl ShotTable {
    /// Note that all rows are compared with one drive, the drive of the setup. `None` if a row
    /// states its own drive by a launch, or by an input of swing, club, strike or impact. The note
    /// shows the setup's swing and loft, but no value of a fitted parameter.
    pub fn one_drive(&self, setup: &Setup<f64>, fitted: &[Vary]) -> Option<Message> {
        let has_own = |(parameter, _): &(&Parameter, f64)| parameter.is_of_strike();
        if self.is_launched
            || self
                .shots
                .iter()
                .any(|shot| shot.inputs.iter().any(has_own))
        {
            return None;
        }
        let rows = match self.shots.len() {
            1 => "the row is".to_owned(),
            rows => format!("all {rows} rows are"),
        };
        let shown = SHOWN.iter().filter_map(|name| {
            let parameter = setup.parameter(name).ok()?;
            if fitted.iter().any(|vary| vary.parameter == parameter) {
                return Some(Message::from(format!("{name} as it is fitted")));
            }
            let value = setup.value(parameter)?;
            let named = Message::from(format!("{name} "));
            Some(named.quantity(
                parameter.quantity,
                parameter.unit,
                value,
                Digits::Significant(4),
            ))
        });
        let before = format!(
            "{} has neither a whole launch (ball_speed, launch_angle, and spin or backspin) nor a \
             column of swing, club, strike or impact: {rows} \
             compared with one drive, that of the setup: ",
            self.file
        );
        let after = "; if the rows are different drives, add the columns in which they differ";
        Some(
            Message::from(before)
                .message(Message::joined(shown, ", "))
                .words(after),
        )
    }
}

/// Warnings about shots outside the model's validity limits. Shots that do not land are not
/// counted. Once `stop` is true, the warning says that the shots were not checked.
pub fn validity_warnings(
    setup: &Setup<f64>,
    shots: &[MeasuredShot],
    stop: &AtomicBool,
) -> Vec<Message> {
    let looked_at = |shot: &MeasuredShot| {
        let setup = at_shot(setup, shot).ok()?;
        let of: Vec<_> = shot
            .measured
            .iter()
            .map(|measurement| measurement.outcome)
            .collect();
        exceeded_in_flight(&setup, &of, stop)
    };
    let mut count = ExceededCount::default();
    let Some(drives) = each_until(shots, stop, looked_at) else {
        return vec![LIMITS_NOT_CHECKED.into()];
    };
    drives
        .into_iter()
        .flatten()
        .for_each(|drive| count.add(drive));
    count.warnings(&setup.law, ["shot", "shots"], CheckScope::Flight)
}
