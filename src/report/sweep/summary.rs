use crate::drive::Outcome;
use crate::parameters::{Law, Setup};
use crate::report::document::{Document, DocumentTable, Line};
use crate::report::shown;
use crate::statistics::{Histogram, JsonNumber, Ranking, Summary};
use crate::units::{DerivativeUnit, System, TableUnits, counted, significant};

/// A summary of a sweep's rows: counts by status, moments of each column, histograms and best rows,
/// in the units of a system.
pub fn summary_document(summary: &Summary, system: System) -> Document {
    let mut document = Document::default();
    document.list([Line::flush(format!(
        "{}: {}",
        counted(summary.status_counts.total(), "drive"),
        summary.status_counts
    ))]);
    let moments = summary.moments.iter().map(|(column, moments)| {
        let place = |value| quantity(column, value, system);
        let spread = |value| difference(column, value, system);
        let cells = [
            moments.mean.map(place),
            moments.deviation().map(spread),
            moments.least.map(place),
            moments.greatest.map(place),
        ];
        let shown = cells.map(|cell| cell.unwrap_or(shown::NONE.into()));
        [column_head(column, system), moments.count.to_string()]
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

/// A value of an outcome with its unit, or a number in the unit that [`column_head`] names.
fn quantity(column: &str, value: f64, system: System) -> String {
    match Outcome::named(column) {
        Ok(of) => shown::outcome(of, value, system),
        Err(_) => in_unit_of_head(column, value, system),
    }
}

/// A standard deviation, like [`quantity`]. It has no side, such as "left".
fn difference(column: &str, value: f64, system: System) -> String {
    match Outcome::named(column) {
        Ok(of) => shown::difference(of, value, system),
        Err(_) => in_unit_of_head(column, value, system),
    }
}

fn in_unit_of_head(column: &str, value: f64, system: System) -> String {
    let size = derivative_unit(column, system).map_or(1.0, |unit| unit.size);
    significant(value / size, 6)
}

/// The name of a column; for a derivative with its unit.
fn column_head(column: &str, system: System) -> String {
    match derivative_unit(column, system) {
        Some(unit) => unit.head(column),
        None => column.into(),
    }
}

/// The unit of a derivative, such as `d_carry/d_club.loft`; `None` for another column.
fn derivative_unit(column: &str, system: System) -> Option<DerivativeUnit> {
    let (of, by) = column.strip_prefix("d_")?.split_once("/d_")?;
    let of = Outcome::named(of).ok()?;
    let own = Setup::modern_driver().parameters();
    let mut all = own.into_iter().chain(Law::all_rows());
    let by = all.find(|row| row.name == by)?;
    Some(DerivativeUnit::new(
        of.into(),
        by.into(),
        TableUnits::Of(system),
    ))
}

/// The number of rows in each non-empty bin of a histogram, and below and above the bins.
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
    DocumentTable::new([column_head(of, system).as_str(), "rows"], rows).right([1])
}

/// The best rows by a column, with the swept parameters of each row.
fn ranking(ranking: &Ranking, system: System) -> DocumentTable {
    let setup = Setup::modern_driver();
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
    let title = format!("{which} {}", column_head(&ranking.of, system));
    DocumentTable::new([title.as_str(), "row", "point"], rows).right([0, 1])
}
