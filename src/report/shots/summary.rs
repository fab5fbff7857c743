//! A summary of flown shots.

use crate::drive::Outcome;
use crate::report::document::{Document, DocumentTable, Line};
use crate::report::reply::{Ending, Report};
use crate::report::shown;
use crate::shots::{ClubShots, Refused, ShotStatistics, Sums, instrument_deviation};
use crate::units::{Message, System, counted, printed, significant};
use serde::Serialize;

/// A summary of flown shots, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ShotsReport {
    /// The status of the command.
    #[serde(skip)]
    pub ending: Ending,
    /// The file of the rows; `null` if the rows are not written to a file.
    pub file: Option<String>,
    /// The maker of the export, if its column heads identify it; for JSON, the name of the format.
    pub source: Option<&'static str>,
    /// Number of rows.
    pub rows: u64,
    /// Number of rows whose ball landed.
    pub flown: u64,
    /// The rows whose ball did not land, by kind of reason.
    pub refused: Vec<Refused>,
    /// Number of rows with assumed values, or with measured values that are not compared with
    /// predictions.
    pub noted: u64,
    /// Number of rows whose export states an estimated or modelled spin.
    pub spin_not_measured: u64,
    /// Number of rows whose export states normalized values.
    pub normalized: u64,
    /// The residuals of each outcome, predicted − measured.
    pub residuals: Vec<OutcomeResiduals>,
    /// The shots of each club; empty unless the table names several clubs.
    pub clubs: Vec<ClubShotsReport>,
    /// Remarks about the columns.
    pub remarks: Vec<Message>,
}

/// The residuals of an outcome, SI.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OutcomeResiduals {
    /// The outcome.
    pub of: Outcome,
    /// The residuals of all rows.
    #[serde(flatten)]
    pub all: SumsReport,
    /// The standard deviation of the difference between two launch monitors for the same drives,
    /// SI; `null` if it is unknown.
    pub instruments: Option<f64>,
    /// The residuals by ball speed.
    pub bands: Vec<BandReport>,
}

/// The shots of a club, SI.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ClubShotsReport {
    /// The name in the table.
    pub club: String,
    /// Number of rows.
    pub rows: u64,
    /// Number of rows whose ball landed.
    pub flown: u64,
    /// The predictions and residuals of each outcome.
    pub outcomes: Vec<ClubOutcome>,
}

/// An outcome of the shots of a club, SI.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ClubOutcome {
    /// The outcome.
    pub of: Outcome,
    /// The mean of the predictions, SI.
    pub predicted: Option<f64>,
    /// The residuals, predicted − measured.
    #[serde(flatten)]
    pub residuals: SumsReport,
}

impl ClubShotsReport {
    fn new(of: &[Outcome], club: &str, shots: &ClubShots) -> Self {
        let outcome = |(at, of): (usize, &Outcome)| ClubOutcome {
            of: *of,
            predicted: shots.predicted[at].moments.mean,
            residuals: SumsReport::new(&shots.residuals[at]),
        };
        Self {
            club: club.into(),
            rows: shots.rows,
            flown: shots.flown,
            outcomes: of.iter().enumerate().map(outcome).collect(),
        }
    }
}

/// Statistics of residuals, predicted − measured.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SumsReport {
    /// Number of rows with a measured value.
    pub rows: u64,
    /// The mean, SI.
    pub bias: Option<f64>,
    /// The mean absolute value, SI.
    pub mean_absolute: Option<f64>,
    /// The standard deviation, SI.
    pub deviation: Option<f64>,
}

/// The rows of a band of ball speeds.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct BandReport {
    /// The lowest ball speed, m/s; `null` in the first band.
    pub from: Option<f64>,
    /// The highest ball speed, m/s; `null` in the last band.
    pub to: Option<f64>,
    /// The residuals.
    #[serde(flatten)]
    pub sums: SumsReport,
}

impl SumsReport {
    fn new(sums: &Sums) -> Self {
        Self {
            rows: sums.moments.count,
            bias: sums.moments.mean,
            mean_absolute: sums.mean_absolute(),
            deviation: sums.moments.deviation(),
        }
    }
}

impl ShotsReport {
    /// The report of these statistics.
    pub fn new(
        statistics: &ShotStatistics,
        source: Option<&'static str>,
        file: Option<String>,
        remarks: &[Message],
    ) -> Self {
        let residual = |(at, of): (usize, &Outcome)| OutcomeResiduals {
            of: *of,
            all: SumsReport::new(&statistics.all[at]),
            instruments: instrument_deviation(*of),
            bands: statistics
                .bands
                .iter()
                .filter(|band| band.sums[at].moments.count > 0)
                .map(|band| BandReport {
                    from: band.from,
                    to: band.to,
                    sums: SumsReport::new(&band.sums[at]),
                })
                .collect(),
        };
        let clubs = statistics.clubs.iter();
        Self {
            ending: Ending::DONE,
            file,
            source,
            rows: statistics.rows,
            flown: statistics.flown,
            refused: statistics.refused.values().cloned().collect(),
            noted: statistics.noted,
            spin_not_measured: statistics.spin_not_measured,
            normalized: statistics.normalized,
            residuals: statistics.of.iter().enumerate().map(residual).collect(),
            clubs: clubs
                .filter(|_| statistics.clubs.len() > 1)
                .map(|(club, shots)| ClubShotsReport::new(&statistics.of, club, shots))
                .collect(),
            remarks: remarks.to_vec(),
        }
    }

    /// Lines with the numbers of flown rows, of refused rows by kind of reason, and of rows with
    /// remarks.
    fn counts(&self) -> Vec<Line> {
        let from = self
            .source
            .map_or(String::new(), |source| format!(" ({source})"));
        let refused: u64 = self.refused.iter().map(|refused| refused.count).sum();
        let mut lines = vec![Line::flush(format!(
            "{}{from}: {} flown, {refused} not flown",
            counted(self.rows, "row"),
            self.flown
        ))];
        for refused in &self.refused {
            lines.push(Line::item(format!(
                "{}: {}, the first in line {}: {}",
                refused.kind,
                counted(refused.count, "row"),
                refused.line,
                refused.reason
            )));
        }
        let remarks = [
            (
                self.noted,
                "with values that are assumed or not compared (see the notes of these rows)",
            ),
            (
                self.spin_not_measured,
                "whose spin is estimated or modelled, as the export says",
            ),
            (
                self.normalized,
                "whose values are normalized to other conditions, as the export says",
            ),
        ];
        for (count, remark) in remarks {
            if count > 0 {
                lines.push(Line::item(format!("{} {remark}", counted(count, "row"))));
            }
        }
        lines
    }
}

impl Report for ShotsReport {
    const COMMAND: &'static str = "fly";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["done", "no-answer", "interrupted"];

    fn ending(&self) -> Ending {
        self.ending.clone()
    }

    /// The counts of rows, and the residuals of each outcome by ball speed.
    fn document(&self, system: System) -> Document {
        let mut lines = self.counts();
        let compared = self.residuals.iter().filter(|of| of.all.rows > 0);
        let rows: Vec<_> = compared.flat_map(|of| residual_rows(of, system)).collect();
        let mut document = Document::default();
        if rows.is_empty() {
            if self.rows > 0 {
                lines.push(Line::flush(
                    "no row has a measured value of these outcomes to compare with",
                ));
            }
            document.list(lines);
            add_clubs(&mut document, &self.clubs, system);
            return document;
        }
        document.list(lines);
        let head = [
            "outcome",
            "ball speed",
            "rows",
            "bias",
            "MAE",
            "sd",
            "sd of instruments",
        ];
        let mut table = DocumentTable::new(head, rows).right(2..=6);
        table.caption = "predicted − measured:".into();
        table.remarks.push(Line::flush(
            "sd of instruments: the standard deviation of the difference between two launch \
             monitors on the same 58 drives (Bliss & Langdown 2026); 513 rpm for the spin",
        ));
        if self.residuals.iter().any(|one| one.of.is_lateral()) {
            let side = Line::flush("lateral: + is right of the target line");
            table.remarks.push(side);
        }
        document.add(table);
        add_clubs(&mut document, &self.clubs, system);
        document
    }
}

fn speeds(band: &BandReport, system: System) -> String {
    let of = Outcome::BallSpeed;
    let unit = system.unit(of.unit());
    let shown = |speed: f64| significant(of.quantity().number_in(speed, unit), 3);
    match (band.from, band.to) {
        (None, Some(to)) => format!("below {} {unit}", shown(to)),
        (Some(from), Some(to)) => format!("{} to {} {unit}", shown(from), shown(to)),
        (Some(from), None) => format!("{} {unit} or more", shown(from)),
        (None, None) => "all".into(),
    }
}

/// An outcome with the unit of its residuals: "carry [yd]".
fn title(of: Outcome, system: System) -> String {
    format!("{} [{}]", of.name(), printed(system.unit(of.unit())))
}

/// Adds a table of the first outcome by club, if there are several clubs.
fn add_clubs(document: &mut Document, clubs: &[ClubShotsReport], system: System) {
    let Some(first) = clubs.first().and_then(|club| club.outcomes.first()) else {
        return;
    };
    let of = first.of;
    let row = |club: &ClubShotsReport| {
        let ClubOutcome {
            predicted,
            residuals,
            ..
        } = &club.outcomes[0];
        vec![
            club.club.clone(),
            club.rows.to_string(),
            shown::number_or_dash(of, *predicted, system),
            shown::signed_or_dash(of, residuals.bias, system),
            shown::number_or_dash(of, residuals.mean_absolute, system),
        ]
    };
    let head = ["club", "rows", "predicted", "bias", "MAE"];
    let mut table = DocumentTable::new(head, clubs.iter().map(row)).right(1..=4);
    table.caption = format!("{} by club:", title(of, system));
    document.add(table);
}

/// The residuals of an outcome: a row for each band of ball speed, and one for all rows.
fn residual_rows(residuals: &OutcomeResiduals, system: System) -> Vec<Vec<String>> {
    let of = residuals.of;
    let number = |value: Option<f64>| shown::number_or_dash(of, value, system);
    let row = |which: String, sums: &SumsReport, instruments: Option<f64>| {
        vec![
            title(of, system),
            which,
            sums.rows.to_string(),
            shown::signed_or_dash(of, sums.bias, system),
            number(sums.mean_absolute),
            number(sums.deviation),
            number(instruments),
        ]
    };
    let bands = residuals.bands.iter();
    let bands = bands.map(|band| row(speeds(band, system), &band.sums, None));
    let all = row("all".into(), &residuals.all, residuals.instruments);
    bands.chain([all]).collect()
}
