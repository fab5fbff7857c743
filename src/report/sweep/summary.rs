use crate::drive::Outcome;
use crate::parameters::Setup;
use crate::report::shown;
use crate::report::table::table;
use crate::statistics::{Coordinate, Histogram, Infinite, Ranking, Summary};
use crate::units::{System, counted, significant};

/// What the rows of a sweep are like in all, as tables: how they ended, the moments of each column,
/// histograms and best rows. Outcomes are in the units of a system, derivatives in SI.
pub fn summary_text(summary: &Summary, system: System) -> String {
    let counts = summary.statuses.iter().filter(|(_, count)| **count > 0);
    let counts: Vec<_> = counts
        .map(|(status, count)| format!("{count} {status}"))
        .collect();
    let mut parts = vec![format!(
        "{}: {}\n",
        counted(summary.rows(), "drive"),
        counts.join(", ")
    )];
    let moments = summary.moments.iter().map(|(column, moments)| {
        let numbers = [
            moments.mean(),
            moments.deviation(),
            moments.least(),
            moments.greatest(),
        ];
        let shown = numbers.map(|number| {
            number.map_or(shown::NONE.into(), |value| quantity(column, value, system))
        });
        [column.clone(), moments.count.to_string()]
            .into_iter()
            .chain(shown)
            .collect()
    });
    parts.push(table(
        &[
            "column",
            "rows",
            "mean",
            "standard deviation",
            "least",
            "greatest",
        ],
        &[1, 2, 3, 4, 5],
        moments,
    ));
    parts.extend(
        summary
            .histograms
            .iter()
            .map(|histogram| histogram_text(histogram, system)),
    );
    parts.extend(
        summary
            .best
            .iter()
            .map(|ranking| ranking_text(ranking, system)),
    );
    parts.join("\n")
}

/// A value of a column: derivatives are in SI.
fn quantity(column: &str, value: f64, system: System) -> String {
    match Outcome::named(column) {
        Ok(of) => shown::outcome(of, value, system),
        Err(_) => significant(value, 6),
    }
}

fn histogram_text(histogram: &Histogram, system: System) -> String {
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
    table(
        &[of, "rows"],
        &[1],
        below.into_iter().chain(bins).chain(above),
    )
}

fn ranking_text(ranking: &Ranking, system: System) -> String {
    let setup = Setup::default();
    let coordinate = |name: &str, value: &Option<Coordinate>| {
        let value = match value {
            Some(Coordinate::Finite(value)) => *value,
            Some(Coordinate::Infinite(Infinite::Above)) => f64::INFINITY,
            Some(Coordinate::Infinite(Infinite::Below)) => f64::NEG_INFINITY,
            None => return format!("{name} {}", shown::NONE),
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
            .map(|(name, value)| coordinate(name, value))
            .collect();
        vec![
            quantity(&ranking.of, row.value, system),
            row.row.to_string(),
            point.join(", "),
        ]
    });
    let which = if ranking.highest { "highest" } else { "lowest" };
    table(
        &[&format!("{which} {}", ranking.of), "row", "point"],
        &[0, 1],
        rows,
    )
}
