//! A calibration, as a document, as JSON and as a setup file.

mod plots;
mod text;

use super::document::Document;
use super::json::{ByName, JsonNumber, Matrix, Settings, settings};
use super::presets::file_name;
use super::reply::{Ending, Report};
use super::setup_file::CommentedSetup;
use super::shown::computed;
use crate::optimize::least_squares::RejectedPoints;
use crate::parameters::SetupFile;
use crate::study::calibrate::{
    Calibration, CalibrationStatus, Estimate, FitResidual, HeldOut, ShotTable, Starts,
};
use crate::units::{Message, System, counted, counted_of, typed};
use serde::Serialize;
use text::{by_outcome, rounded_to_error};

/// A calibration, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CalibrationReport<'a> {
    #[serde(skip)]
    table: &'a ShotTable,
    #[serde(skip)]
    found: &'a Calibration,
    #[serde(skip)]
    cross_validations: &'a [(String, HeldOut)],
    /// True if the fit, or a fit of the cross-validation, was interrupted.
    pub interrupted: bool,
    /// The data.
    pub data: DataReport,
    /// The estimate of each fitted parameter.
    pub estimates: ByName<Estimate>,
    /// The covariances of the estimates, each in the product of the SI units of its two parameters.
    pub covariance: Matrix,
    /// The correlations of the estimates, −1 to 1.
    pub correlation: Matrix,
    /// Combinations of parameters that the data do not determine. Each combination consists of
    /// changes of its parameters, SI.
    pub undetermined: Vec<ByName<JsonNumber>>,
    /// χ² of the fit.
    pub chi_square: JsonNumber,
    /// The number of measured values minus the number of parameters that they determine, at least
    /// 0. Parameters at a bound are not counted.
    pub degrees_of_freedom: usize,
    /// The probability of a χ² at least this large, if the model is right; `null` unless the data
    /// state every uncertainty and leave degrees of freedom, and with Huber's loss: its weighted χ²
    /// does not have the χ² distribution.
    pub probability: JsonNumber,
    /// Factor by which the standard uncertainties are multiplied. It is 1 if the data state every
    /// uncertainty. Otherwise it is √(χ²/degrees of freedom), if there are degrees of freedom and
    /// the residuals exceed rounding. If not, it is 1 if the uncertainty of every value is known,
    /// and `null` if one is unknown. With Huber's loss, also for stated uncertainties, it is
    /// √(Σψ²/degrees of freedom)/mean ψ′, where ψ is the derivative of the loss; `null` if every
    /// residual exceeds 1.345 standard uncertainties.
    pub uncertainty_scale: JsonNumber,
    /// Iterations of the fit.
    pub iterations: u64,
    /// Evaluations of the residuals.
    pub evaluations: u64,
    /// The trial points that the fit rejected.
    pub refused: &'a RejectedPoints,
    /// The results of the searches from several starts.
    pub starts: &'a Starts,
    /// The residual of each measured value.
    pub residuals: Vec<FitResidual>,
    /// The prediction errors on held-out data.
    pub held_out: Vec<HeldOutReport>,
    /// Every parameter of the fitted setup by its dotted name.
    pub setup: Settings,
    /// The setup file that was written; `null` if none was written.
    pub file: Option<String>,
    /// The folder of the written page; `null` if none was written.
    pub folder: Option<String>,
}

/// The data of a calibration.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DataReport {
    /// The file.
    pub file: String,
    /// Number of shots.
    pub shots: usize,
    /// Number of measured values.
    pub values: usize,
    /// True if the rows are launch conditions, so that no impact is computed.
    pub launch_conditions: bool,
    /// Remarks about the file.
    pub remarks: Vec<Message>,
}

/// The prediction errors on held-out data.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct HeldOutReport {
    /// The name of the fit: the law and the fitted parameters.
    pub fit: String,
    /// Number of folds of the cross-validation; 0 if nothing was fitted.
    pub folds: usize,
    /// Number of fits of the cross-validation by status. The rows that an interrupted fit held out
    /// do not count in the errors below.
    pub fits: ByName<usize>,
    /// Root mean square of the residuals, each in units of its standard uncertainty.
    pub rms_standardized: JsonNumber,
    /// Root mean square of the residuals of each outcome, not divided by their uncertainties, SI.
    pub rms: ByName<JsonNumber>,
}

impl<'a> CalibrationReport<'a> {
    /// The report of a fit to these shots. `held_out` are the prediction errors on held-out data,
    /// each with the name of its fit.
    pub fn new(
        table: &'a ShotTable,
        found: &'a Calibration,
        held_out: &'a [(String, HeldOut)],
    ) -> Self {
        let statistics = &found.statistics;
        let names: Vec<&'static str> = found
            .estimates
            .iter()
            .map(|estimate| estimate.parameter.name)
            .collect();
        let estimates = found.estimates.iter();
        let estimates = estimates.map(|estimate| (estimate.parameter.name, *estimate));
        let undetermined = statistics.undetermined.iter().map(|direction| {
            let parts = direction.parts.iter();
            parts.map(|(at, part)| (names[*at], *part)).collect()
        });
        Self {
            table,
            found,
            cross_validations: held_out,
            interrupted: found.verdict.status == CalibrationStatus::INTERRUPTED
                || held_out.iter().any(|(_, held)| held.is_interrupted()),
            data: DataReport {
                file: table.file.clone(),
                shots: table.shots.len(),
                values: table.residuals(),
                launch_conditions: table.is_launched,
                remarks: table.remarks.clone(),
            },
            estimates: estimates.collect(),
            covariance: Matrix::new(names.clone(), |a, b| statistics.covariance[a][b]),
            correlation: Matrix::new(names.clone(), |a, b| statistics.correlation(a, b)),
            undetermined: undetermined.collect(),
            chi_square: statistics.chi_square.into(),
            degrees_of_freedom: statistics.degrees_of_freedom,
            probability: statistics.probability.into(),
            uncertainty_scale: statistics.scale.into(),
            iterations: found.fit.iterations,
            evaluations: found.fit.evaluations,
            refused: &found.fit.rejected,
            starts: &found.starts,
            residuals: found.residuals.clone(),
            held_out: held_out
                .iter()
                .map(|(fit, held)| HeldOutReport::new(fit, held))
                .collect(),
            setup: settings(&found.setup),
            file: None,
            folder: None,
        }
    }

    /// The status of the fit; `interrupted` if a fit of the cross-validation was interrupted.
    pub fn status(&self) -> CalibrationStatus {
        if self.interrupted {
            CalibrationStatus::INTERRUPTED
        } else {
            self.found.verdict.status
        }
    }

    /// The status in a sentence.
    pub fn message(&self) -> String {
        let verdict = &self.found.verdict;
        let (stopped, all) =
            self.cross_validations
                .iter()
                .fold((0, 0), |(stopped, all), (_, held)| {
                    (
                        stopped + held.count(CalibrationStatus::INTERRUPTED),
                        all + held.statuses.len(),
                    )
                });
        let of_all = counted_of(stopped as u64, all as u64, ["fit", "fits"]);
        match stopped {
            0 => verdict.message.clone(),
            _ if verdict.status == CalibrationStatus::INTERRUPTED => {
                format!("{}; the held-out error lacks {of_all}", verdict.message)
            }
            _ => format!(
                "the held-out error lacks the interrupted fits ({of_all}); the fit of all data: \
                 {}, {}",
                verdict.status, verdict.message
            ),
        }
    }

    /// The fitted setup for a setup file. Each fitted parameter has a comment with its standard
    /// error. `file` is the setup before the fit, `data` the name of the file with the shots.
    pub fn fitted_setup(&self, file: &SetupFile, data: &str) -> CommentedSetup {
        let found = self.found;
        let about = vec![
            format!("{}, fitted to {data}", file.name),
            format!("{}: {}", found.verdict.status, found.verdict.message),
        ];
        let remarks = found.estimates.iter().map(|estimate| {
            let Estimate {
                parameter,
                value,
                standard_error,
                ..
            } = *estimate;
            let (quantity, unit) = (parameter.quantity, parameter.unit);
            let value = match standard_error {
                Some(error) => {
                    let number =
                        |value: f64| rounded_to_error(quantity, unit, value, standard_error);
                    let show = |value: f64| typed(&number(value), unit);
                    format!("{} ± {}", show(value), show(error))
                }
                None => format!("{} without a standard error", computed(parameter, value)),
            };
            (parameter, format!("fitted to {data}: {value}"))
        });
        CommentedSetup {
            setup: found.setup,
            about,
            remarks: remarks.collect(),
        }
    }
}

impl HeldOutReport {
    fn new(fit: &str, held: &HeldOut) -> Self {
        let mut statuses: Vec<CalibrationStatus> = vec![];
        for status in &held.statuses {
            if !statuses.contains(status) {
                statuses.push(*status);
            }
        }
        let fits = statuses.iter();
        Self {
            fit: fit.to_owned(),
            folds: held.folds,
            fits: fits
                .map(|status| (status.name(), held.count(*status)))
                .collect(),
            rms_standardized: held.mean_square().map(f64::sqrt).into(),
            rms: by_outcome(held)
                .into_iter()
                .map(|one| (one.name, one.rms))
                .collect(),
        }
    }
}

impl Report for CalibrationReport<'_> {
    const COMMAND: &'static str = "calibrate";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &CalibrationStatus::NAMES;

    fn ending(&self) -> Ending {
        Ending {
            status: self.status().name(),
            message: Some(self.message()),
        }
    }

    /// The status of the fit, the estimates with their uncertainties, the residuals, and the
    /// prediction errors on held-out data.
    fn document(&self, system: System) -> Document {
        let Self {
            table,
            found,
            cross_validations,
            ..
        } = *self;
        let mut document = Document::new(&format!("Calibration to {}", file_name(&table.file)));
        document.paragraph(format!(
            "{}: {} ({}, {})",
            self.status(),
            self.message(),
            counted(found.fit.iterations, "iteration"),
            counted(found.fit.evaluations, "evaluation")
        ));
        text::data(&mut document, table, system);
        text::starts(&mut document, found);
        let rejected = &found.fit.rejected;
        if let Some(why) = &rejected.last {
            let points = counted(rejected.count, "trial point");
            document.paragraph(format!(
                "The fit rejected {points}. The reason for the last one: {why}"
            ));
        }
        text::estimates(&mut document, table, found, system);
        text::correlations(&mut document, found);
        document.heading("Residuals");
        for figure in plots::figures(table, found, system) {
            document.figure(figure);
        }
        text::residuals(&mut document, found, system);
        text::held_out(&mut document, cross_validations, system);
        document
    }
}
