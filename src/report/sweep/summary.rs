use crate::drive::Outcome;
use crate::parameters::Setup;
use crate::report::document::{Document, DocumentTable, Line};
use crate::report::shown;
use crate::statistics::{Histogram, JsonNumber, Ranking, Summary};
use crate::units::{System, counted, significant};

/// A summary of a sweep's rows: counts by status, moments of each column, histograms and best rows.
/// Outcomes are in the units of a system, derivatives in SI.
pub fn summary_document(summary: &Summary, system: System) -> Document {
    let mut document = Document::default();
    document.list([Line::flush(format!(
        "{}: {}",
        counted(summary.status_counts.total(), "drive"),
        summary.status_counts
    ))]);
    let moments = summary.moments.iter().map(|(column, moments)| {
        let numbers = [
            moments.mean,
            moments.deviation(),
            moments.least,
            moments.greatest,
        ];
        let shown = numbers.map(|number| {
            number.map_or(shown::NONE.into(), |value| quantity(column, value, system))
        });
        [column.clone(), moments.count.to_string()]
            .into_iter()
            .chain(shown)
            .collect()
    });
    let head = [
        "column",
        "rows",
        "mean",
        "standard deviation",
        "least",
        "greatest",
    ];
    document.add(DocumentTable::new(head, moments).right(1..=5));
    for of in &summary.histograms {
        document.add(histogram(of, system));
    }
    for of in &summary.best {
        document.add(ranking(of, system));
    }
    document
}

/// A value of an outcome in the units of `system`, or a derivative in SI.
fn quantity(column: &str, value: f64, system: System) -> String {
    match Outcome::named(column) {
        Ok(of) => shown::outcome(of, value, system),
        Err(_) => significant(value, 6),
    }
}

/// The number of rows in each bin of a histogram.
fn histogram(histogram: &Histogram, system: System) -> DocumentTable {
    let Histogram {
        of,
        below,
        counts,
        above,
        ..
    } = histogram;
    let edge = |i: usize| quantity(of, histogram.edge(i), system);
    let below = (*below > 0).then(|| vec![format!("below {}", edge(0)), below.to_string()]);
    let above =
        (*above > 0).then(|| vec![format!("above {}", edge(counts.len())), above.to_string()]);
    let bins = counts.iter().enumerate().filter(|(_, count)| **count > 0);
    let bins =
        bins.map(|(i, count)| vec![format!("{} to {}", edge(i), edge(i + 1)), count.to_string()]);
    let rows = below.into_iter().chain(bins).chain(above);
    DocumentTable::new([of.as_str(), "rows"], rows).right([1])
}

/// The best rows by a column, with the swept parameters of each row.
fn ranking(ranking: &Ranking, system: System) -> DocumentTable {
    let setup = Setup::default();
    let coordinate = |name: &str, value: JsonNumber| {
        let Some(value) = value.0 else {
            return format!("{name} {}", shown::NONE);
        };
        match setup.parameter(name) {
            Ok(parameter) => format!("{name} {}", shown::stated(parameter, value, system)),
            Err(_) => format!("{name} {}", significant(value, 6)),
        }
    };
    let rows = ranking.rows.iter().map(|row| {
        let point: Vec<_> = row
            .point
            .iter()
            .map(|(name, value)| coordinate(name, *value))
            .collect();
        vec![
            quantity(&ranking.of, row.value, system),
            row.row.to_string(),
            point.join(", "),
        ]
    });
    let which = if ranking.highest { "highest" } else { "lowest" };
    let title = format!("{which} {}", ranking.of);
    DocumentTable::new([title.as_str(), "row", "point"], rows).right([0, 1])
}
