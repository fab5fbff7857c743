use crate::optimize::least_squares::FitStatus;
use crate::parameters::Parameter;
use crate::report::document::{Document, DocumentTable, Line};
use crate::report::shown;
use crate::statistics::median;
use crate::study::delivery::{
    Delivered, Population, Posterior, Recovered, ShotDelivery, Spread, Unidentified, Unknown,
};
use crate::units::{Message, System, counted, fixed};

/// The delivery of one shot.
pub(super) fn of_one(delivered: &Delivered, system: System) -> Document {
    let mut document = Document::default();
    let known = delivered
        .posteriors
        .iter()
        .map(|known| known_row(known, system));
    let head = [
        "most probable delivery",
        "value",
        "± after the shot",
        "± before",
        "determined",
    ];
    document.add(DocumentTable::new(head, known).right([1, 2, 3, 4]));
    document.list(measured_club([delivered], system));
    document.add(differences(delivered, system));
    if !delivered.unidentified.is_empty() {
        let title = Line::flush(
            "Each of these changes, of one parameter or of several together, hardly changes the \
             launch. The launch does not determine their sizes; the column \"± before\" does:",
        );
        let changes = delivered
            .unidentified
            .iter()
            .map(|change| Line::item(unidentified(change, system)));
        document.list([title].into_iter().chain(changes));
    }
    if let (status, Some(message)) = verdict(delivered) {
        document.paragraph(format!("{status}: {}", message.in_units(system)));
    }
    document
}

/// A table of the given values of launch and club. A column has the values of the delivery.
fn differences(delivered: &Delivered, system: System) -> DocumentTable {
    let of_launch = delivered.explained.iter().map(|explained| {
        let of = explained.measured.outcome;
        vec![
            of.name().into(),
            shown::outcome(of, explained.measured.value, system),
            shown::difference(of, explained.measured.sigma, system),
            shown::outcome(of, explained.computed, system),
            fixed(explained.residual, 2),
        ]
    });
    let of_club = delivered.stated().map(|posterior| {
        let of = posterior.unknown.parameter;
        vec![
            of.name.into(),
            shown::parameter(of, posterior.unknown.prior, system),
            shown::difference(of, posterior.unknown.sigma, system),
            shown::parameter(of, posterior.value, system),
            fixed(posterior.residual(), 2),
        ]
    });
    let head = ["given", "value", "±", "computed", "difference / ±"];
    DocumentTable::new(head, of_launch.chain(of_club)).right([1, 2, 3, 4])
}

/// The assumed errors of the given club values, of each parameter once; `None` if no error is
/// assumed.
fn measured_club<'a>(all: impl IntoIterator<Item = &'a Delivered>, system: System) -> Option<Line> {
    let mut measured: Vec<&Unknown> = vec![];
    for Posterior { unknown, .. } in all.into_iter().flat_map(|one| &one.posteriors) {
        let is_new = || {
            let mut others = measured.iter();
            others.all(|other| other.parameter != unknown.parameter)
        };
        if unknown.has_assumed_error() && is_new() {
            measured.push(unknown);
        }
    }
    let one = |unknown: &&Unknown| {
        let sigma = shown::difference(unknown.parameter, unknown.sigma, system);
        format!("{} ± {sigma}", unknown.parameter.name)
    };
    let all = measured.iter().map(one).collect::<Vec<_>>().join(", ");
    (!measured.is_empty()).then(|| {
        Line::flush(format!(
            "assumed errors of the given club values: {all}; use `sigma` to state other errors"
        ))
    })
}

fn known_row(known: &Posterior, system: System) -> Vec<String> {
    let Posterior {
        unknown,
        value,
        sigma,
        variance_removed,
    } = known;
    let parameter = unknown.parameter;
    vec![
        parameter.name.into(),
        shown::parameter(parameter, *value, system),
        sigma.map_or("at its bound".into(), |sigma| {
            shown::difference(parameter, sigma, system)
        }),
        shown::difference(parameter, unknown.sigma, system),
        percent(*variance_removed),
    ]
}

/// The text about a change of the delivery that the launch does not determine. It includes the
/// fraction of the prior variance that the launch removes.
fn unidentified(unidentified: &Unidentified, system: System) -> String {
    let one = |(parameter, change): &(&'static Parameter, f64)| {
        let change = shown::component(parameter, *change, system);
        format!("{} {change}", parameter.name)
    };
    let changes: Vec<_> = unidentified.changes.iter().map(one).collect();
    format!(
        "{} ({:.0} % determined)",
        changes.join(", "),
        100.0 * unidentified.variance_removed
    )
}

/// The document for a table of shots. It has the deliveries with their means and standard
/// deviations, and the distribution `population` of the swings.
pub(super) fn of_table(
    all: &[ShotDelivery],
    population: Option<&Population>,
    system: System,
) -> Document {
    let spread = Spread::of(all);
    let mut document = Document::default();
    if !spread.is_empty() {
        document.add(shots(all, &spread, system));
    }
    let failures = failures(all, system);
    if !failures.is_empty() {
        let title = Line::flush(format!(
            "no delivery was found for {}; the means below leave out these rows:",
            counted(failures.len() as u64, "row")
        ));
        document.list([title].into_iter().chain(failures));
    }
    if spread.is_empty() {
        return document;
    }
    let rows = spread.iter().map(|spread| {
        let deviation = spread.deviation;
        vec![
            spread.parameter.name.into(),
            shown::parameter(spread.parameter, spread.mean, system),
            deviation.map_or(shown::NONE.into(), |deviation| {
                shown::difference(spread.parameter, deviation, system)
            }),
            percent(median_identified(all, spread.parameter)),
        ]
    });
    let head = ["over all shots", "mean", "standard deviation", "determined"];
    document.add(DocumentTable::new(head, rows).right([1, 2, 3]));
    document.list(measured_club(
        all.iter().filter_map(ShotDelivery::explained),
        system,
    ));
    if let Some(population) = population {
        document.add(swings(population, system));
        document.list([Line::flush(
            "over all shots: the deliveries above, which `output` writes; the swings behind them: \
             without the errors of the launch monitor, which `swings` writes",
        )]);
    }
    document
}

/// A row for each fitted shot: the delivery and the largest residual.
fn shots(all: &[ShotDelivery], spread: &[Spread], system: System) -> DocumentTable {
    let names = spread.iter().map(|spread| spread.parameter.name);
    let head: Vec<&str> = std::iter::once("row")
        .chain(names)
        .chain(["worst difference in ±"])
        .collect();
    let columns = head.len();
    let rows = all.iter().filter_map(|delivery| {
        let delivered = delivery.found.as_ref().ok()?;
        let values = delivered
            .posteriors
            .iter()
            .map(|known| shown::parameter(known.unknown.parameter, known.value, system));
        Some(
            std::iter::once(delivery.row.to_string())
                .chain(values)
                .chain([fixed(delivered.largest_residual(), 2)])
                .collect(),
        )
    });
    DocumentTable::new(head, rows).right(1..columns)
}

/// Lines with the rows that have no delivery, and the reasons.
fn failures(all: &[ShotDelivery], system: System) -> Vec<Line> {
    let why = |delivery: &ShotDelivery| match &delivery.found {
        Ok(delivered) => verdict(delivered).1.map(|message| message.in_units(system)),
        Err(error) => Some(error.in_units(system)),
    };
    let line = |delivery: &ShotDelivery| {
        let why = why(delivery)?;
        Some(Line::item(format!("row {}: {why}", delivery.row)))
    };
    all.iter().filter_map(line).collect()
}

/// The population of swings behind the shots, without the measurement errors of the launch monitor.
fn swings(population: &Population, system: System) -> DocumentTable {
    let rows = population.spreads.iter().map(|spread| {
        let Recovered {
            parameter,
            mean,
            deviation,
            variance_removed,
            mean_error,
            deviation_error,
        } = *spread;
        let error = |error: f64| format!("± {}", shown::difference(parameter, error, system));
        vec![
            parameter.name.into(),
            shown::parameter(parameter, mean, system),
            error(mean_error),
            shown::difference(parameter, deviation, system),
            error(deviation_error),
            format!("{:.0} %", 100.0 * variance_removed),
        ]
    });
    let head = [
        "the swings behind them",
        "mean",
        "",
        "standard deviation",
        "",
        "determined",
    ];
    DocumentTable::new(head, rows).right(1..=5)
}

/// The fraction of a parameter's prior variance that a shot removes, as the median over the shots.
/// `None` if the fraction is unknown for every shot.
pub(super) fn median_identified(all: &[ShotDelivery], parameter: &Parameter) -> Option<f64> {
    let known = all
        .iter()
        .filter_map(ShotDelivery::explained)
        .flat_map(|delivered| &delivered.posteriors);
    let fractions: Vec<f64> = known
        .filter(|known| known.unknown.parameter == parameter)
        .filter_map(|known| known.variance_removed)
        .collect();
    median(&fractions)
}

fn percent(fraction: Option<f64>) -> String {
    fraction.map_or(shown::NONE.into(), |fraction| {
        format!("{:.0} %", 100.0 * fraction)
    })
}

/// The status of the search for a delivery, with a sentence if it failed.
pub(super) fn verdict(delivered: &Delivered) -> (&'static str, Option<Message>) {
    if delivered.status != FitStatus::Converged {
        return (
            delivered.status.name(),
            Some(delivered.message.clone().into()),
        );
    }
    match delivered.unexplained() {
        Some(message) => ("unexplained", Some(message)),
        None => (delivered.status.name(), None),
    }
}
