use super::lines::{by_reason, item};
use super::optimum::OptimumReport;
use super::reply::{Reply, share};
use super::swings::OverSwings;
use super::table::table;
use super::{json, shown};
use crate::error::{Error, Result};
use crate::parameters::Parameter;
use crate::study::{
    Changed, Direction, Ellipse, Flatness, Limit, Optima, Optimum, Sensitivity, Vary, Window,
};
use crate::units::{Message, Quantity, System, printed, significant, with_unit};
use serde::Serialize;
use serde_json::{Value, json};

/// What is known of an optimum beside where it is.
pub struct Analysis<'a> {
    /// The optimum.
    pub best: &'a Optimum,
    /// Its sensitivities, or why there is none.
    pub sensitivities: &'a [(&'static Parameter, Result<Sensitivity>)],
    /// How flat it is.
    pub flatness: &'a Flatness,
    /// What stated changes do to it.
    pub changes: &'a [Changed],
}

/// An optimum with its sensitivities and windows as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct SensitivityReport {
    /// The optimum.
    #[serde(flatten)]
    pub optimum: OptimumReport,
    /// What more is known of it; nothing of that where the search did not converge.
    #[serde(flatten)]
    pub analysis: AnalysisReport,
}

/// What is known of an optimum beside where it is, as JSON; every entry `null` where there is no
/// optimum.
#[derive(Clone, Debug, Default, Serialize)]
pub struct AnalysisReport {
    /// By parameter: `value` is d f*/dp, `optimum` d x*/dp; `null` with a `message` where there is
    /// none.
    pub sensitivity: Value,
    /// By varied parameter: how far it may stray alone for the loss stated.
    pub window: Value,
    /// The loss, SI.
    pub window_loss: Value,
    /// The directions of the free parameters, the flattest first, and how far they reach.
    pub directions: Value,
    /// The ellipses of pairs of free parameters.
    pub ellipses: Value,
    /// What stated changes do, predicted and searched anew.
    pub changes: Value,
}

impl SensitivityReport {
    /// The answer of `optimum-sensitivity`.
    pub fn reply(optima: &Optima, analysis: &Analysis<'_>, warnings: Vec<Message>) -> Reply<Self> {
        let all = analysis.sensitivities;
        let found = all
            .iter()
            .filter(|(_, sensitivity)| sensitivity.is_ok())
            .count();
        let body = Self {
            optimum: OptimumReport::of_many(optima),
            analysis: AnalysisReport::new(analysis),
        };
        let reply = Reply::done("optimum-sensitivity", warnings, body);
        match share(found, all.len()) {
            // a parameter that has none says so itself
            "done" | "partial" => reply.ended(
                analysis.best.status(),
                Some(analysis.best.message().to_string()),
            ),
            none => reply.ended(
                none,
                Some("this optimum has none of the sensitivities that were asked for".into()),
            ),
        }
    }

    /// The answer without an optimum, or without its sensitivity: `why`.
    pub fn none(optima: &Optima, why: Option<&Error>, warnings: Vec<Message>) -> Reply<Self> {
        let Reply {
            status,
            message,
            body,
            warnings,
            ..
        } = OptimumReport::reply(optima, OverSwings::default(), warnings);
        let reply = Reply::done(
            "optimum-sensitivity",
            warnings,
            Self {
                optimum: body,
                analysis: AnalysisReport::default(),
            },
        );
        match why {
            Some(why) => reply.ended(why.status(), Some(why.to_string())),
            None => reply.ended(status, message),
        }
    }
}

impl AnalysisReport {
    fn new(analysis: &Analysis<'_>) -> Self {
        let Analysis {
            best,
            sensitivities,
            flatness,
            changes,
        } = analysis;
        let names = || best.search.vary.iter().map(|vary| vary.parameter.name);
        let by_name =
            |values: &[f64]| json::named(names().zip(values.iter().map(|value| Some(*value))));
        let sensitivity = sensitivities.iter().map(|(parameter, sensitivity)| {
            let entry = match sensitivity {
                Ok(s) => json!({
                    "value": json::number(Some(s.value)),
                    "optimum": by_name(&s.optimum),
                    "curvature": json::number(Some(s.curvature)),
                    "message": null,
                }),
                Err(error) => {
                    json!({ "value": null, "optimum": null, "curvature": null, "message": error.to_string() })
                }
            };
            (parameter.name.to_owned(), entry)
        });
        let window = names().zip(&flatness.windows).map(|(name, window)| {
            let limits = [window.low_limit, window.high_limit].map(|limit| limit_name(best, limit));
            let entry =
                json!({ "low": window.low, "high": window.high, "low_limit": limits[0], "high_limit": limits[1] });
            (name.to_owned(), entry)
        });
        let directions = flatness.directions.iter().map(|direction| {
            let reach = json::number(Some(direction.reach));
            json!({ "along": by_name(&direction.along), "reach": reach, "losses": direction.losses })
        });
        let ellipses = flatness.ellipses.iter().map(|ellipse| {
            let pair = ellipse.pair.map(|i| best.search.vary[i].parameter.name);
            json!({ "parameters": pair, "half_axes": ellipse.half_axes, "losses": ellipse.losses })
        });
        let changes = changes.iter().map(|changed| {
            json!({
                "parameter": changed.change.parameter.name,
                "change": changed.change.delta,
                "predicted": {
                    "value": changed.second_order,
                    "first_order": changed.first_order,
                    "optimum": by_name(&changed.predicted),
                },
                "resolved": {
                    "status": changed.resolved.status(),
                    "value": json::number(changed.resolved.value()),
                    "optimum": changed.resolved.value().map(|_| by_name(&changed.resolved.solution.x)),
                    "message": changed.resolved.message(),
                },
                "event": changed.event.as_ref().map(|(part, words)| json!({ "after": part, "message": words })),
                "differences": changed.differences,
            })
        });
        Self {
            sensitivity: Value::Object(sensitivity.collect()),
            window: Value::Object(window.collect()),
            window_loss: json::number(Some(flatness.loss)),
            directions: directions.collect(),
            ellipses: ellipses.collect(),
            changes: changes.collect(),
        }
    }
}

fn limit_name(best: &Optimum, limit: Limit) -> String {
    match limit {
        Limit::Loss => "loss".into(),
        Limit::Bound => "bound".into(),
        Limit::Constraint(j) => best.search.subject_to[j].expression.clone(),
        Limit::NoFlight => "no flight".into(),
    }
}

/// Sensitivities, windows and changes as text, below the optimum's own.
pub fn sensitivity_text(analysis: &Analysis<'_>, system: System) -> String {
    let Analysis {
        best,
        sensitivities,
        flatness,
        changes,
    } = analysis;
    let mut text = sensitivities_text(best, sensitivities, system);
    text += &windows_text(best, flatness, system);
    for changed in *changes {
        text += &change_text(best, changed, system);
    }
    text
}

fn sensitivities_text(
    best: &Optimum,
    sensitivities: &[(&'static Parameter, Result<Sensitivity>)],
    system: System,
) -> String {
    let of = best.search.outcome();
    let free: Vec<&Vary> = best
        .search
        .vary
        .iter()
        .filter(|vary| vary.low < vary.high)
        .collect();
    let best_of = format!("best {}", of.name());
    let moved: Vec<String> = free
        .iter()
        .map(|vary| format!("best {}", vary.parameter.name))
        .collect();
    let head: Vec<&str> = ["per unit of", best_of.as_str()]
        .into_iter()
        .chain(moved.iter().map(String::as_str))
        .collect();
    let why = |(parameter, sensitivity): &(&Parameter, Result<Sensitivity>)| {
        Some((parameter.name, sensitivity.as_ref().err()?.in_units(system)))
    };
    let left_out: String = by_reason(sensitivities.iter().filter_map(why))
        .iter()
        .map(|line| item(line))
        .collect();
    let rows: Vec<Vec<String>> = sensitivities
        .iter()
        .filter_map(|(parameter, sensitivity)| Some((parameter, sensitivity.as_ref().ok()?)))
        .map(|(parameter, s)| {
            let by = system.unit(parameter.unit);
            let size = parameter.quantity.size_of(by).unwrap_or(1.0);
            let per_unit = |slope: f64, value: f64, (quantity, unit): (Quantity, &'static str)| {
                let slope = shown::settled(slope, value, (quantity, unit), &[*parameter]);
                let unit = system.unit(unit);
                let number = slope * size / quantity.size_of(unit).unwrap_or(1.0);
                with_unit(&significant(number, 4), unit)
            };
            let moves = best
                .search
                .vary
                .iter()
                .zip(&best.solution.x)
                .zip(&s.optimum);
            let moves = moves.filter(|((vary, _), _)| vary.low < vary.high);
            let moves = moves.map(|((vary, x), slope)| {
                per_unit(*slope, *x, (vary.parameter.quantity, vary.parameter.unit))
            });
            let name = format!(
                "{} [{}]",
                parameter.name,
                if by.is_empty() {
                    "1".into()
                } else {
                    printed(by)
                }
            );
            let value = best.value().unwrap_or_default();
            [name, per_unit(s.value, value, (of.quantity(), of.unit()))]
                .into_iter()
                .chain(moves)
                .collect()
        })
        .collect();
    let right: Vec<usize> = (1..head.len()).collect();
    let shown = if rows.is_empty() {
        String::new()
    } else {
        format!("\n{}", table(&head, &right, rows))
    };
    let left_out = if left_out.is_empty() {
        String::new()
    } else {
        format!("\n{left_out}")
    };
    shown + &left_out
}

fn windows_text(best: &Optimum, flatness: &Flatness, system: System) -> String {
    let loss = shown::spread(best.search.outcome(), flatness.loss, system);
    let rows = best
        .search
        .vary
        .iter()
        .zip(&flatness.windows)
        .map(|(vary, window)| {
            let Window {
                low,
                low_limit,
                high,
                high_limit,
            } = *window;
            let end = |value: f64, limit: Limit| {
                let value = shown::parameter(vary.parameter, value, system);
                match limit {
                    Limit::Loss => value,
                    Limit::Constraint(j) => {
                        format!(
                            "{value} ({})",
                            shown::constraint(&best.search.subject_to[j], system)
                        )
                    }
                    other => format!("{value} ({})", limit_name(best, other)),
                }
            };
            vec![
                vary.parameter.name.into(),
                end(low, low_limit),
                end(high, high_limit),
            ]
        });
    let title = format!("alone, for a loss of {loss}");
    let mut text = format!(
        "\n{}",
        table(&[title.as_str(), "from", "to"], &[1, 2], rows)
    );
    for direction in flatness
        .directions
        .iter()
        .filter(|direction| direction.reach.is_finite())
    {
        text += &direction_text(best, direction, &loss, system);
    }
    for ellipse in &flatness.ellipses {
        text += &ellipse_text(best, ellipse, &loss, system);
    }
    text
}

/// A step of a parameter, with its sign: "+1.20 deg".
fn step(parameter: &Parameter, amount: f64, system: System) -> String {
    let sign = if amount < 0.0 { "-" } else { "+" };
    format!(
        "{sign}{}",
        shown::parameter(parameter, amount.abs(), system)
    )
}

/// "ellipse of club.loft and swing.attack_angle for a loss of 1.00 yd: half-axes (+1.20 deg, -3.40
/// deg) and (…); drives around it lose 0.90 yd to 1.10 yd".
fn ellipse_text(best: &Optimum, ellipse: &Ellipse, loss: &str, system: System) -> String {
    let pair = ellipse.pair.map(|i| best.search.vary[i].parameter);
    let axis = |components: [f64; 2]| {
        let [first, second] = [0, 1].map(|row| step(pair[row], components[row], system));
        format!("({first}, {second})")
    };
    let of = best.search.outcome();
    let flown = ellipse
        .losses
        .map_or("part of it lies out of range".into(), |(least, most)| {
            let [least, most] = [least, most].map(|loss| shown::spread(of, loss, system));
            format!("drives around it lose {least} to {most}")
        });
    let [long, short] = ellipse.half_axes.map(axis);
    let [first, second] = pair.map(|parameter| parameter.name);
    item(&format!(
        "ellipse of {first} and {second} for a loss of {loss}, by the quadratic model, without \
         bounds and constraints: half-axes {long} and {short}; \
         {flown}"
    ))
}

/// "together club.loft +1.20 deg, swing.attack_angle -0.90 deg, or the opposite: …".
fn direction_text(best: &Optimum, direction: &Direction, loss: &str, system: System) -> String {
    let moves = best
        .search
        .vary
        .iter()
        .zip(&direction.along)
        .filter(|(_, along)| **along != 0.0);
    let moves: Vec<_> = moves
        .map(|(vary, along)| {
            format!(
                "{} {}",
                vary.parameter.name,
                step(vary.parameter, along * direction.reach, system)
            )
        })
        .collect();
    let of = best.search.outcome();
    let flown: Vec<_> = direction
        .losses
        .iter()
        .flatten()
        .map(|lost| shown::spread(of, *lost, system))
        .collect();
    let flown = if flown.is_empty() {
        "both ends lie out of range".into()
    } else {
        format!("drives there lose {}", flown.join(" and "))
    };
    item(&format!(
        "together {}, or the opposite: a loss of {loss} by the quadratic model; {flown}",
        moves.join(", ")
    ))
}

fn change_text(best: &Optimum, changed: &Changed, system: System) -> String {
    let (of, parameter) = (best.search.outcome(), changed.change.parameter);
    let row = |words: &str, value: Option<f64>, x: &[f64]| {
        let value = value.map_or(shown::NONE.into(), |value| shown::finely(of, value, system));
        let x = best
            .search
            .vary
            .iter()
            .zip(x)
            .map(|(vary, x)| shown::parameter(vary.parameter, *x, system));
        [words.to_owned(), value]
            .into_iter()
            .chain(x)
            .collect::<Vec<_>>()
    };
    let delta = shown::stated(parameter, changed.change.delta, system);
    // where it goes: an amount without a sign is a change too
    let to = best
        .setup
        .value(parameter)
        .map(|from| shown::stated(parameter, from + changed.change.delta, system));
    let to = to.map_or(String::new(), |to| format!(" to {to}"));
    let title = format!(
        "{} {}{delta}{to}",
        parameter.name,
        if changed.change.delta < 0.0 { "" } else { "+" }
    );
    let names = best.search.vary.iter().map(|vary| vary.parameter.name);
    let head: Vec<&str> = [title.as_str(), of.name()]
        .into_iter()
        .chain(names)
        .collect();
    let rows = [
        row("now", best.value(), &best.solution.x),
        row("predicted", Some(changed.second_order), &changed.predicted),
        match changed.resolved.value() {
            Some(value) => row("searched again", Some(value), &changed.resolved.solution.x),
            None => row("searched again", None, &[]),
        },
    ];
    let right: Vec<usize> = (1..head.len()).collect();
    let mut text = format!("\n{}", table(&head, &right, rows));
    if let Some((part, words)) = &changed.event {
        text += &item(&format!(
            "predicted: {} after {} % of the change",
            words.in_units(system),
            significant(100.0 * part, 3)
        ));
    }
    for difference in &changed.differences {
        text += &item(&format!(
            "after the change: {}",
            difference.in_units(system)
        ));
    }
    text
}
