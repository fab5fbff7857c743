//! What was found of flown shots.

use crate::drive::Outcome;
use crate::report::lines::{item, paragraph};
use crate::report::table::table;
use crate::shots::{Band, FLOOR, Sums, Tally};
use crate::units::{Message, System, counted, fixed, printed, signed};
use serde::Serialize;

/// What was found of flown shots, as JSON.
#[derive(Clone, Debug, Serialize)]
pub struct ShotsReport {
    /// The file that the rows were written to; `None` where they were not.
    pub file: Option<String>,
    /// Whose export the shots are, where its heads tell.
    pub source: Option<&'static str>,
    /// All rows.
    pub rows: u64,
    /// Rows whose ball landed.
    pub flown: u64,
    /// The other rows, by the kind of reason.
    pub refused: Vec<RefusedReport>,
    /// Rows with something assumed or not compared.
    pub noted: u64,
    /// Rows whose spin is estimated or modelled, as the export says.
    pub spin_not_measured: u64,
    /// Rows whose values are normalized, as the export says.
    pub normalized: u64,
    /// Predicted − measured, of each outcome.
    pub residuals: Vec<ResidualReport>,
    /// What the reader should know of the columns.
    pub remarks: Vec<Message>,
}

/// Rows that were refused for one kind of reason.
#[derive(Clone, Debug, Serialize)]
pub struct RefusedReport {
    kind: &'static str,
    rows: u64,
    first_line: u64,
    first_reason: String,
}

/// The residuals of an outcome, SI.
#[derive(Clone, Debug, Serialize)]
pub struct ResidualReport {
    of: &'static str,
    #[serde(flatten)]
    all: SumsReport,
    /// What two instruments differ by on the same drives (standard deviation).
    instruments: Option<f64>,
    bands: Vec<BandReport>,
}

#[derive(Clone, Debug, Serialize)]
struct SumsReport {
    rows: u64,
    bias: Option<f64>,
    mean_absolute: Option<f64>,
    deviation: Option<f64>,
}

#[derive(Clone, Debug, Serialize)]
struct BandReport {
    /// Ball speed, m/s.
    from: Option<f64>,
    to: Option<f64>,
    #[serde(flatten)]
    sums: SumsReport,
}

impl SumsReport {
    fn new(sums: &Sums) -> Self {
        let (bias, mean_absolute, deviation) =
            (sums.bias(), sums.mean_absolute(), sums.deviation());
        Self {
            rows: sums.count,
            bias,
            mean_absolute,
            deviation,
        }
    }
}

/// What two instruments differ by on the same drives, SI.
fn floor(of: Outcome) -> Option<f64> {
    let (_, deviation, unit) = FLOOR.iter().find(|(outcome, ..)| *outcome == of)?;
    Some(deviation * of.quantity().size_of(unit)?)
}

impl ShotsReport {
    /// The report of a tally.
    pub fn new(
        tally: &Tally,
        source: Option<&'static str>,
        file: Option<String>,
        remarks: &[Message],
    ) -> Self {
        let refused = tally.refused.iter().map(|(kind, refused)| RefusedReport {
            kind,
            rows: refused.count,
            first_line: refused.line,
            first_reason: refused.reason.clone(),
        });
        let residual = |(at, of): (usize, &Outcome)| ResidualReport {
            of: of.name(),
            all: SumsReport::new(&tally.all[at]),
            instruments: floor(*of),
            bands: tally
                .bands
                .iter()
                .filter(|band| band.sums[at].count > 0)
                .map(|band| BandReport {
                    from: band.from,
                    to: band.to,
                    sums: SumsReport::new(&band.sums[at]),
                })
                .collect(),
        };
        Self {
            file,
            source,
            rows: tally.rows,
            flown: tally.flown,
            refused: refused.collect(),
            noted: tally.noted,
            spin_not_measured: tally.spin_not_measured,
            normalized: tally.normalized,
            residuals: tally.of.iter().enumerate().map(residual).collect(),
            remarks: remarks.to_vec(),
        }
    }
}

/// The ball speeds of a band.
fn speeds(band: &Band, system: System) -> String {
    let of = Outcome::BallSpeed;
    let unit = system.unit(of.unit());
    let decimals = usize::from(unit != of.unit());
    let shown = |speed: f64| {
        format!(
            "{:.decimals$}",
            speed / of.quantity().size_of(unit).unwrap_or(1.0)
        )
    };
    match (band.from, band.to) {
        (None, Some(to)) => format!("below {} {unit}", shown(to)),
        (Some(from), Some(to)) => format!("{} to {} {unit}", shown(from), shown(to)),
        (Some(from), None) => format!("{} {unit} or more", shown(from)),
        (None, None) => "all".into(),
    }
}

/// What was found, as text.
pub fn shots_text(tally: &Tally, source: Option<&'static str>, system: System) -> String {
    let from = source.map_or(String::new(), |source| format!(" ({source})"));
    let refused: u64 = tally.refused.values().map(|refused| refused.count).sum();
    let mut text = paragraph(&format!(
        "{}{from}: {} flown, {refused} not flown",
        counted(tally.rows, "row"),
        tally.flown
    ));
    for (kind, refused) in &tally.refused {
        text += &item(&format!(
            "{kind}: {}, the first in line {}: {}",
            counted(refused.count, "row"),
            refused.line,
            refused.reason
        ));
    }
    for (count, what) in [
        (
            tally.noted,
            "with values that are assumed or not compared (see their notes)",
        ),
        (
            tally.spin_not_measured,
            "whose spin is estimated or modelled, as the export says",
        ),
        (
            tally.normalized,
            "whose values are normalized to other conditions, as the export says",
        ),
    ] {
        if count > 0 {
            text += &item(&format!("{} {what}", counted(count, "row")));
        }
    }
    let mut rows = vec![];
    for (at, of) in tally.of.iter().enumerate() {
        let unit = system.unit(of.unit());
        let size = of.quantity().size_of(unit).unwrap_or(1.0);
        let decimals = if unit == "s" { 2 } else { 1 };
        let shown = |value: Option<f64>| {
            value.map_or("–".into(), |value| format!("{:.decimals$}", value / size))
        };
        let line = |which: String, sums: &Sums, instruments: Option<f64>| {
            let bias = sums.bias().map_or("–".into(), |bias| {
                signed(bias, fixed(bias / size, decimals))
            });
            let [mean, deviation, instruments] =
                [sums.mean_absolute(), sums.deviation(), instruments].map(shown);
            vec![
                format!("{} [{}]", of.name(), printed(unit)),
                which,
                sums.count.to_string(),
                bias,
                mean,
                deviation,
                instruments,
            ]
        };
        if tally.all[at].count == 0 {
            continue;
        }
        let bands = tally.bands.iter().filter(|band| band.sums[at].count > 0);
        rows.extend(bands.map(|band| line(speeds(band, system), &band.sums[at], None)));
        rows.push(line("all".into(), &tally.all[at], floor(*of)));
    }
    if rows.is_empty() {
        return text + &paragraph("no row has a measured value of these outcomes to compare with");
    }
    text += "\n";
    text += &paragraph("predicted − measured:");
    let head = [
        "outcome",
        "ball speed",
        "rows",
        "bias",
        "MAE",
        "sd",
        "sd of instruments",
    ];
    text += &table(&head, &[2, 3, 4, 5, 6], rows);
    text += &paragraph(
        "sd of instruments: of the differences of two launch monitors on the same 58 drives (Bliss \
         & Langdown 2026); their spins differ \
         by 513 rpm",
    );
    text
}
