//! The deliveries that explain measured launches, as text, JSON and a setup file.

use super::lines::{item, paragraph};
use super::recovered::population_json;
use super::reply::{Reply, share};
use super::setup_file::setup_toml;
use super::shown;
use super::table::table;
use crate::error::Result;
use crate::optimize::least_squares::Status;
use crate::parameters::{Parameter, Preset, Setup};
use crate::study::delivery::{
    Delivered, Delivery, Known, Population, Recovered, Spread, Unknown, Untold,
};
use crate::units::{Message, System, counted, counted_of, fixed};
use serde_json::{Value, json};

/// The answer of `delivery` as one JSON object, SI and radians: `rows` has one entry for a single
/// shot. With `left_out` rows the work was interrupted before them.
pub fn delivery_reply(
    all: &[Delivery],
    population: Option<&Population>,
    left_out: usize,
    warnings: Vec<Message>,
) -> Reply<Value> {
    let found = all
        .iter()
        .filter(|delivery| delivery.explained().is_some())
        .count();
    let why = all.iter().find_map(|delivery| match &delivery.found {
        Ok(delivered) => verdict(delivered).1,
        Err(error) => Some(error.to_string()),
    });
    let spread = Spread::of(all).into_iter().map(
        |Spread {
             parameter,
             mean,
             deviation,
         }| json!({ "parameter": parameter.name, "mean": mean, "deviation": deviation }),
    );
    let body = json!({
        "rows": all.iter().map(row).collect::<Vec<_>>(),
        "spread": spread.collect::<Vec<_>>(),
        "population": population.map(population_json),
    });
    let reply = Reply::done("delivery", warnings, body);
    if left_out > 0 {
        let rows = counted(left_out as u64, "row");
        return reply.ended(
            "interrupted",
            Some(format!("interrupted before {rows} were looked at")),
        );
    }
    reply.ended(share(found, all.len()), why)
}

fn row(delivery: &Delivery) -> Value {
    let delivered = match &delivery.found {
        Ok(delivered) => delivered,
        Err(error) => {
            let (status, message) = (error.status(), error.to_string());
            return json!({ "row": delivery.row, "status": status, "message": message, "known": [], "explained": [], "untold": [] });
        }
    };
    let (status, message) = verdict(delivered);
    let known = delivered.known.iter().map(|known| {
        json!({
            "parameter": known.unknown.parameter.name,
            "value": known.value,
            "standard_uncertainty": known.sigma,
            "told": known.told,
            "before": known.unknown.before,
            "standard_uncertainty_before": known.unknown.sigma,
            "source": known.unknown.source,
            "range": { "low": known.unknown.low, "high": known.unknown.high },
        })
    });
    let explained = delivered.explained.iter().map(|explained| {
        json!({
            "of": explained.measured.outcome.name(),
            "measured": explained.measured.value,
            "standard_uncertainty": explained.measured.sigma,
            "computed": explained.computed,
            "residual": explained.residual(),
        })
    });
    let untold = delivered.untold.iter().map(|untold| {
        let changes = untold
            .changes
            .iter()
            .map(|(parameter, change)| (parameter.name.to_owned(), json!(change)));
        json!({ "told": untold.told, "changes": Value::Object(changes.collect()) })
    });
    json!({
        "row": delivery.row,
        "status": status,
        "message": message.unwrap_or_else(|| delivered.message.clone()),
        "known": known.collect::<Vec<_>>(),
        "explained": explained.collect::<Vec<_>>(),
        "untold": untold.collect::<Vec<_>>(),
    })
}

/// How the search for a delivery ended in a word, and a sentence where it did not find one.
fn verdict(delivered: &Delivered) -> (&'static str, Option<String>) {
    if delivered.status != Status::Converged {
        return (delivered.status.name(), Some(delivered.message.clone()));
    }
    let Some(worst) = delivered.unexplained() else {
        return (delivered.status.name(), None);
    };
    let of = worst.measured.outcome;
    let message = format!(
        "no delivery within the ranges explains this launch: {} was measured as {} and is {} at \
         the nearest, {} standard uncertainties \
         away; check the value, the club (`set`) and the ranges (`vary`)",
        of.name(),
        of.show(worst.measured.value),
        of.show(worst.computed),
        fixed(worst.residual().abs(), 1)
    );
    ("unexplained", Some(message))
}

/// Which parameters lie at an end of the range that they were sought in: there it is the range that
/// decides, and not the launch.
pub fn bound_warnings(all: &[Delivery], system: System) -> Vec<Message> {
    let found: Vec<_> = all
        .iter()
        .filter_map(|delivery| delivery.found.as_ref().ok())
        .collect();
    let unknowns = found
        .first()
        .map_or(&[][..], |delivered| &delivered.known)
        .iter()
        .map(|known| known.unknown);
    let ends = unknowns.flat_map(|unknown| [(unknown, false), (unknown, true)]);
    ends.filter_map(|(unknown, is_upper)| {
        let parameter = unknown.parameter;
        let known = found.iter().flat_map(|delivered| &delivered.known);
        let at_end = known.filter(|known| {
            let Unknown { low, high, .. } = known.unknown;
            known.unknown.parameter == parameter
                && known.sigma.is_none()
                && (known.value - low > high - known.value) == is_upper
        });
        let mut values: Vec<f64> = at_end.map(|known| known.value).collect();
        values.sort_by(f64::total_cmp);
        let (first, last) = (values.first()?, values.last()?);
        let ends = [*first, *last].map(|end| shown::parameter(parameter, end, system));
        let ends = if ends[0] == ends[1] {
            ends[0].clone()
        } else {
            ends.join(" to ")
        };
        Some(Message::from(format!(
            "{} of {} lies at the {} end of the range that it is sought in, {ends}: the range \
             decides it there, and not the launch; `set` {} to a \
             value nearer to the golfer's, or give it a larger `sigma`",
            parameter.name,
            counted_of(
                values.len() as u64,
                found.len() as u64,
                ["launch", "launches"]
            ),
            if is_upper { "upper" } else { "lower" },
            parameter.name,
        )))
    })
    .collect()
}

/// The delivery of one shot as text.
pub fn delivered_text(delivered: &Delivered, system: System) -> String {
    let known = delivered.known.iter().map(|known| known_row(known, system));
    let mut text = table(
        &[
            "most probable delivery",
            "value",
            "± after the shot",
            "± before",
            "told",
        ],
        &[1, 2, 3, 4],
        known,
    );
    let explained = delivered.explained.iter().map(|explained| {
        let of = explained.measured.outcome;
        vec![
            of.name().into(),
            shown::outcome(of, explained.measured.value, system),
            shown::spread(of, explained.measured.sigma, system),
            shown::outcome(of, explained.computed, system),
            fixed(explained.residual(), 2),
        ]
    });
    text += "\n";
    text += &table(
        &["launch", "measured", "±", "computed", "difference in ±"],
        &[1, 2, 3, 4],
        explained,
    );
    if !delivered.untold.is_empty() {
        text += &format!(
            "\n{}",
            paragraph(
                "The launch does not tell these changes; each leaves it nearly as it is, and what \
                 was known before decides:"
            )
        );
        text += &delivered
            .untold
            .iter()
            .map(|untold| item(&untold_text(untold, system)))
            .collect::<String>();
    }
    if let (status, Some(message)) = verdict(delivered) {
        text += &format!("\n{}", paragraph(&format!("{status}: {message}")));
    }
    text
}

fn known_row(known: &Known, system: System) -> Vec<String> {
    let Known {
        unknown,
        value,
        sigma,
        told,
    } = known;
    let parameter = unknown.parameter;
    vec![
        parameter.name.into(),
        shown::parameter(parameter, *value, system),
        sigma.map_or("at its bound".into(), |sigma| {
            amount(parameter, sigma, system)
        }),
        amount(parameter, unknown.sigma, system),
        told.map_or(shown::NONE.into(), |told| format!("{:.0} %", 100.0 * told)),
    ]
}

/// An uncertainty or a change of a parameter.
fn amount(parameter: &Parameter, value: f64, system: System) -> String {
    parameter
        .quantity
        .read_off_difference(value, system.unit(parameter.unit))
}

fn untold_text(untold: &Untold, system: System) -> String {
    let one = |(parameter, change): &(&'static Parameter, f64)| {
        let sign = if *change < 0.0 { "-" } else { "+" };
        format!(
            "{} {sign}{}",
            parameter.name,
            amount(parameter, change.abs(), system)
        )
    };
    let changes: Vec<_> = untold.changes.iter().map(one).collect();
    format!("{} ({:.0} % told)", changes.join(", "), 100.0 * untold.told)
}

/// The deliveries of the shots of a table as text: each, their mean and spread, and the swings
/// behind them.
pub fn deliveries_text(
    all: &[Delivery],
    population: Option<&Population>,
    system: System,
) -> String {
    let spread = Spread::of(all);
    let names = spread.iter().map(|spread| spread.parameter.name);
    let head: Vec<&str> = std::iter::once("row")
        .chain(names)
        .chain(["worst difference in ±"])
        .collect();
    let right: Vec<usize> = (1..head.len()).collect();
    let rows = all.iter().filter_map(|delivery| {
        let delivered = delivery.found.as_ref().ok()?;
        let values = delivered
            .known
            .iter()
            .map(|known| shown::parameter(known.unknown.parameter, known.value, system));
        let worst = delivered
            .explained
            .iter()
            .map(|explained| explained.residual().abs())
            .fold(0.0, f64::max);
        Some(
            std::iter::once(delivery.row.to_string())
                .chain(values)
                .chain([fixed(worst, 2)])
                .collect(),
        )
    });
    let mut text = if spread.is_empty() {
        String::new()
    } else {
        table(&head, &right, rows)
    };
    let why = |delivery: &Delivery| match &delivery.found {
        Ok(delivered) => verdict(delivered).1,
        Err(error) => Some(error.in_units(system)),
    };
    let wrong = all
        .iter()
        .filter_map(|delivery| Some(item(&format!("row {}: {}", delivery.row, why(delivery)?))));
    let wrong: Vec<_> = wrong.collect();
    if !wrong.is_empty() {
        text += &format!(
            "\nno delivery was found for {}, left out of the means below:\n{}",
            counted(wrong.len() as u64, "row"),
            wrong.concat()
        );
    }
    if spread.is_empty() {
        return text;
    }
    let rows = spread.iter().map(
        |Spread {
             parameter,
             mean,
             deviation,
         }| {
            vec![
                parameter.name.into(),
                shown::parameter(parameter, *mean, system),
                deviation.map_or(shown::NONE.into(), |deviation| {
                    amount(parameter, deviation, system)
                }),
                told_of(all, parameter),
            ]
        },
    );
    text += "\n";
    text += &table(
        &["over all shots", "mean", "standard deviation", "told"],
        &[1, 2, 3],
        rows,
    );
    text + &population.map_or(String::new(), |population| {
        population_text(population, system)
    })
}

/// The swings behind the shots, without what the errors of the launch monitor add.
fn population_text(population: &Population, system: System) -> String {
    let rows = population.spreads.iter().map(|spread| {
        let Recovered {
            parameter,
            mean,
            deviation,
            told,
            mean_error,
            deviation_error,
        } = *spread;
        let error = |error: f64| format!("± {}", amount(parameter, error, system));
        vec![
            parameter.name.into(),
            shown::parameter(parameter, mean, system),
            error(mean_error),
            amount(parameter, deviation, system),
            error(deviation_error),
            format!("{:.0} %", 100.0 * told),
        ]
    });
    let head = [
        "the swings behind them",
        "mean",
        "",
        "standard deviation",
        "",
        "told",
    ];
    format!("\n{}", table(&head, &[1, 2, 3, 4, 5], rows))
}

/// What part of the variance before the shots tell of a parameter, in the middle of all.
fn told_of(all: &[Delivery], parameter: &Parameter) -> String {
    let known = all
        .iter()
        .filter_map(Delivery::explained)
        .flat_map(|delivered| &delivered.known);
    let mut told: Vec<f64> = known
        .filter(|known| known.unknown.parameter == parameter)
        .filter_map(|known| known.told)
        .collect();
    told.sort_by(f64::total_cmp);
    told.get(told.len() / 2)
        .map_or(shown::NONE.into(), |told| format!("{:.0} %", 100.0 * told))
}

/// The setup of a golfer as a setup file: the most probable delivery of a shot, or the mean of
/// several.
///
/// # Errors
/// As [`setup_toml`].
pub fn delivery_toml(
    setup: &Setup<f64>,
    all: &[Delivery],
    preset: &Preset,
    from: &str,
) -> Result<String> {
    let spread = Spread::of(all);
    let mut golfer = *setup;
    let mut remarks = vec![];
    let shots = counted(
        all.iter().filter_map(Delivery::explained).count() as u64,
        "shot",
    );
    for Spread {
        parameter,
        mean,
        deviation,
    } in spread
    {
        golfer.set_value(parameter, Some(mean))?;
        let scatter = deviation.map_or(String::new(), |deviation| {
            format!(
                ", with a standard deviation of {}",
                amount(parameter, deviation, System::Us)
            )
        });
        remarks.push((
            parameter,
            format!("recovered from {shots} of {from}{scatter}"),
        ));
    }
    setup_toml(
        &golfer,
        preset,
        &[format!("{}, with the delivery of {from}", preset.name)],
        &remarks,
    )
}
