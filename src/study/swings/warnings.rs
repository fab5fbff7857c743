//! Warnings about the drives of a design: outside the ranges that the law was fitted to, strikes
//! outside the face, flat landings.

use super::pareto::Pareto;
use super::robust::{ModelResult, Robust};
use super::scenarios::Scenarios;
use crate::drive::{CheckScope, ExceededCount, ExceededLimits, Outcome, exceeded_in_flight};
use crate::parameters::Setup;
use crate::study::cancellable::{LIMITS_NOT_CHECKED, each_until};
use crate::study::{Goal, Optimum};
use crate::units::Message;
use std::sync::atomic::AtomicBool;

/// For each validity limit of the model: the share of the swings that exceed it, with the design of
/// `setup`. Only swings that land count. `None` once `stop` is true.
fn exceeded_shares(
    setup: &Setup<f64>,
    scenarios: &Scenarios,
    of: &[Outcome],
    stop: &AtomicBool,
) -> Option<ExceededLimits<f64>> {
    let looked_at = |point: &Vec<f64>| {
        let setup = setup.with_values(&scenarios.parameters, point).ok()?;
        exceeded_in_flight(&setup, of, stop)
    };
    let drives: Vec<Option<ExceededLimits>> = each_until(&scenarios.points, stop, looked_at)?;
    let landed: Vec<(ExceededLimits, f64)> = drives
        .into_iter()
        .zip(&scenarios.weights)
        .filter_map(|(drive, weight)| Some((drive?, *weight)))
        .collect();
    let all: f64 = landed.iter().map(|(_, weight)| weight).sum();
    let mut share = ExceededLimits::<f64>::default();
    for (drive, weight) in landed {
        share.add(drive, weight / all);
    }
    Some(share)
}

/// Warnings about a setup and its drives. One drive has the warnings of [`Setup::drive_warnings`].
/// Over swings, each warning about drives names the share of the swings that it concerns.
fn warnings(
    setup: &Setup<f64>,
    scenarios: &Scenarios,
    of: &[Outcome],
    stop: &AtomicBool,
) -> Vec<Message> {
    if scenarios.is_one_drive() {
        return setup.drive_warnings(of);
    }
    let mut warnings = setup.warnings();
    match exceeded_shares(setup, scenarios, of, stop) {
        Some(share) => warnings.extend(share.warnings(&setup.law, "the swings")),
        None => warnings.push(LIMITS_NOT_CHECKED.into()),
    }
    warnings
}

impl Optimum {
    /// Warnings about the setup at the optimum and about its drives:
    ///
    /// - one drive: about the drive at the optimum, and about a flat landing of the drive as set up
    ///   if the report shows both totals
    /// - swings: each warning with the share of the swings; once `stop` is true, a warning that the
    ///   swings were not checked
    /// - no drive flies: about the setup only
    pub fn warnings(&self, stop: &AtomicBool) -> Vec<Message> {
        let mut of = self.search.outcomes();
        if self.compares_totals() {
            of.push(Outcome::Total);
        }
        let of_drives = match (&self.drive, self.solution.value) {
            (Some(drive), _) => {
                let mut warnings = drive.warnings_about(&self.setup, &of);
                let start = self
                    .drive_as_set_up
                    .as_ref()
                    .filter(|_| self.compares_totals());
                let flat = start.and_then(|start| start.flat_landing_warning(&self.start));
                let as_set_up = Message::from("the drive as set up: ");
                warnings.extend(flat.map(|flat| as_set_up.message(flat)));
                warnings
            }
            (None, Some(_)) => warnings(&self.setup, &self.search.scenarios, &of, stop),
            (None, None) => self.setup.warnings(),
        };
        let of_side = self.search.sense.side_warning(&self.search.of);
        of_side.into_iter().chain(of_drives).collect()
    }
}

impl Robust {
    /// Warnings about the setup with the design, and about its drives with each model. Once `stop`
    /// is true, a warning says that swings were not checked.
    pub fn warnings(&self, stop: &AtomicBool) -> Vec<Message> {
        let of = self.search.outcomes();
        let design: Vec<_> = self.search.parameters().collect();
        let of_side = self.search.sense.side_warning(&self.search.of);
        let mut all: Vec<Message> = of_side.into_iter().collect();
        for ModelResult { model, .. } in &self.models {
            let Ok(setup) = model.setup.with_values(&design, &self.design) else {
                continue;
            };
            let of_drives = warnings(&setup, &self.search.scenarios, &of, stop);
            let of_setup = setup.warnings();
            for message in of_drives {
                // a warning that does not come from the drives concerns all models: do not name a
                // model
                let message =
                    match of_setup.contains(&message) || message == LIMITS_NOT_CHECKED.into() {
                        true => message,
                        false => Message::from(format!("with the model '{}': ", model.name))
                            .message(message),
                    };
                if !all.contains(&message) {
                    all.push(message);
                }
            }
        }
        all
    }
}

impl Pareto {
    /// Warnings about the drives at the points of the front. Each names the number of points that
    /// it concerns. Once `stop` is true, a warning says that the drives were not checked.
    pub fn warnings(&self, stop: &AtomicBool) -> Vec<Message> {
        let Some(first) = self.points.first() else {
            return vec![];
        };
        let of: Vec<_> = self.search.all_goals().flat_map(Goal::outcomes).collect();
        let mut count = ExceededCount::default();
        for point in &self.points {
            let Some(share) = exceeded_shares(&point.setup, &self.search.scenarios, &of, stop)
            else {
                return vec![LIMITS_NOT_CHECKED.into()];
            };
            count.add(share.exceeded_limits());
        }
        let what = match self.search.scenarios.is_one_drive() {
            true => ["point of the front", "points of the front"],
            false => [
                "point of the front, for at least 1 % of its swings",
                "points of the front, for at least 1 % of their swings",
            ],
        };
        let of_drives = count.warnings(&first.setup.law, what, CheckScope::Flight);
        let goals = self.search.goals.iter();
        goals
            .filter_map(|(goal, sense)| sense.side_warning(goal))
            .chain(of_drives)
            .collect()
    }
}
