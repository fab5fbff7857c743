use super::optimum::OptimumReport;
use super::reply::{Reply, share};
use super::{json, table::table};
use crate::error::{Error, Result};
use crate::parameters::Parameter;
use crate::study::{Changed, Direction, Ellipse, Flatness, Limit, Optima, Optimum, Sensitivity, Vary, Window};
use crate::units::significant;
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

/// What is known of an optimum beside where it is, as JSON; every entry `null` where there is no optimum.
#[derive(Clone, Debug, Default, Serialize)]
pub struct AnalysisReport {
    /// By parameter: `value` is d f*/dp, `optimum` d x*/dp; `null` with a `message` where there is none.
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
    pub fn reply(optima: &Optima, analysis: &Analysis<'_>, warnings: Vec<String>) -> Reply<Self> {
        let all = analysis.sensitivities;
        let found = all.iter().filter(|(_, sensitivity)| sensitivity.is_ok()).count();
        let body =
            Self { optimum: OptimumReport::of_many(analysis.best, optima), analysis: AnalysisReport::new(analysis) };
        let reply = Reply::done("optimum-sensitivity", warnings, body);
        match share(found, all.len()) {
            // a parameter that has none says so itself
            "done" | "partial" => reply.ended(analysis.best.status(), Some(analysis.best.message())),
            none => reply.ended(none, Some("no sensitivity that was asked for exists at this optimum".into())),
        }
    }

    /// The answer where the search found no optimum, or one about which nothing can be told: `why`.
    ///
    /// # Errors
    /// As [`Optima::best`].
    pub fn none(optima: &Optima, why: Option<&Error>, warnings: Vec<String>) -> Result<Reply<Self>> {
        let Reply { status, message, body, warnings, .. } = OptimumReport::reply(optima, warnings)?;
        let reply =
            Reply::done("optimum-sensitivity", warnings, Self { optimum: body, analysis: AnalysisReport::default() });
        Ok(match why {
            Some(why) => reply.ended(why.status(), Some(why.to_string())),
            None => reply.ended(status, message),
        })
    }
}

impl AnalysisReport {
    fn new(analysis: &Analysis<'_>) -> Self {
        let Analysis { best, sensitivities, flatness, changes } = analysis;
        let names = || best.search.vary.iter().map(|vary| vary.parameter.name);
        let by_name = |values: &[f64]| json::named(names().zip(values.iter().map(|value| Some(*value))));
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
pub fn sensitivity_text(analysis: &Analysis<'_>) -> String {
    let Analysis { best, sensitivities, flatness, changes } = analysis;
    let mut text = sensitivities_text(best, sensitivities);
    text += &windows_text(best, flatness);
    for changed in *changes {
        text += &change_text(best, changed);
    }
    text
}

/// A derivative in the units people read, to four digits: per `unit` of the parameter.
fn rate(value: f64, of_size: f64, parameter: &Parameter) -> String {
    let size = parameter.quantity.size_of(parameter.unit).unwrap_or(1.0);
    significant(value * size / of_size, 4)
}

fn sensitivities_text(best: &Optimum, sensitivities: &[(&'static Parameter, Result<Sensitivity>)]) -> String {
    let of = best.search.maximize;
    let of_size = of.quantity().size_of(of.unit()).unwrap_or(1.0);
    let free: Vec<&Vary> = best.search.vary.iter().filter(|vary| vary.low < vary.high).collect();
    let best_of = format!("best {}", of.name());
    let moved: Vec<String> = free.iter().map(|vary| format!("best {}", vary.parameter.name)).collect();
    let head: Vec<&str> =
        ["per unit of", best_of.as_str()].into_iter().chain(moved.iter().map(String::as_str)).collect();
    let mut left_out = vec![];
    let rows: Vec<Vec<String>> = sensitivities
        .iter()
        .filter_map(|(parameter, sensitivity)| match sensitivity {
            Ok(s) => Some((parameter, s)),
            Err(error) => {
                left_out.push(format!("  {}: {error}\n", parameter.name));
                None
            }
        })
        .map(|(parameter, s)| {
            let unit = if parameter.unit.is_empty() { "1" } else { parameter.unit };
            let value = format!("{} {}", rate(s.value, of_size, parameter), of.unit());
            let moves = best.search.vary.iter().zip(&s.optimum).filter(|(vary, _)| vary.low < vary.high);
            let moves = moves.map(|(vary, slope)| {
                let size = vary.parameter.quantity.size_of(vary.parameter.unit).unwrap_or(1.0);
                format!("{} {}", rate(*slope, size, parameter), vary.parameter.unit).trim_end().to_owned()
            });
            [format!("{} [{unit}]", parameter.name), value.trim_end().into()].into_iter().chain(moves).collect()
        })
        .collect();
    let right: Vec<usize> = (1..head.len()).collect();
    let left_out = if left_out.is_empty() { String::new() } else { format!("\n{}", left_out.concat()) };
    format!("\n{}{left_out}", table(&head, &right, rows))
}

fn windows_text(best: &Optimum, flatness: &Flatness) -> String {
    let loss = best.search.maximize.show(flatness.loss);
    let rows = best.search.vary.iter().zip(&flatness.windows).map(|(vary, window)| {
        let Window { low, low_limit, high, high_limit } = *window;
        let end = |value: f64, limit: Limit| match limit {
            Limit::Loss => vary.parameter.show(Some(value)),
            other => format!("{} ({})", vary.parameter.show(Some(value)), limit_name(best, other)),
        };
        vec![vary.parameter.name.into(), end(low, low_limit), end(high, high_limit)]
    });
    let mut text = format!("\n{}", table(&[&format!("alone, for {loss}"), "from", "to"], &[1, 2], rows));
    for direction in flatness.directions.iter().filter(|direction| direction.reach.is_finite()) {
        text += &direction_text(best, direction, &loss);
    }
    for ellipse in &flatness.ellipses {
        text += &ellipse_text(best, ellipse, &loss);
    }
    text
}

/// "ellipse of club.loft and swing.attack_angle: half-axes (+1.2 deg, -3.4 deg) and (…), 0.9 yd to 1.1 yd flown around it".
fn ellipse_text(best: &Optimum, ellipse: &Ellipse, loss: &str) -> String {
    let pair = ellipse.pair.map(|i| best.search.vary[i].parameter);
    let axis = |components: [f64; 2]| {
        let [first, second] = [0, 1].map(|row| {
            let sign = if components[row] < 0.0 { "-" } else { "+" };
            format!("{sign}{}", pair[row].show(Some(components[row].abs())))
        });
        format!("({first}, {second})")
    };
    let of = best.search.maximize;
    let flown = ellipse.losses.map_or("out of range".into(), |(least, most)| {
        format!("{} to {} flown around it", of.show(least), of.show(most))
    });
    let [long, short] = ellipse.half_axes.map(axis);
    let [first, second] = pair.map(|parameter| parameter.name);
    format!("  ellipse of {first} and {second} for {loss}: half-axes {long} and {short}, {flown}\n")
}

/// "together club.loft +1.2 deg, swing.attack_angle -0.9 deg, or both the other way: …".
fn direction_text(best: &Optimum, direction: &Direction, loss: &str) -> String {
    let moves = best.search.vary.iter().zip(&direction.along).filter(|(_, along)| **along != 0.0);
    let moves: Vec<_> = moves
        .map(|(vary, along)| {
            let (sign, amount) = (if *along < 0.0 { "-" } else { "+" }, (along * direction.reach).abs());
            format!("{} {sign}{}", vary.parameter.name, vary.parameter.show(Some(amount)))
        })
        .collect();
    let flown: Vec<_> = direction.losses.iter().flatten().map(|lost| best.search.maximize.show(*lost)).collect();
    let flown = if flown.is_empty() { "out of range".into() } else { format!("{} flown", flown.join(" and ")) };
    format!("  together {}, or the other way: {loss} by the quadratic, {flown}\n", moves.join(", "))
}

fn change_text(best: &Optimum, changed: &Changed) -> String {
    let (of, parameter) = (best.search.maximize, changed.change.parameter);
    let row = |words: &str, value: Option<f64>, x: &[f64]| {
        let value = value.map_or("–".into(), |value| of.show(value));
        let x = best.search.vary.iter().zip(x).map(|(vary, x)| vary.parameter.show(Some(*x)));
        [words.to_owned(), value].into_iter().chain(x).collect::<Vec<_>>()
    };
    let delta = parameter.show(Some(changed.change.delta));
    let title = format!("{} {}{delta}", parameter.name, if changed.change.delta < 0.0 { "" } else { "+" });
    let names = best.search.vary.iter().map(|vary| vary.parameter.name);
    let head: Vec<&str> = [title.as_str(), of.name()].into_iter().chain(names).collect();
    let rows = [
        row("now", best.value(), &best.solution.x),
        row("predicted", Some(changed.second_order), &changed.predicted),
        match changed.resolved.value() {
            Some(value) => row("searched anew", Some(value), &changed.resolved.solution.x),
            None => row("searched anew", None, &[]),
        },
    ];
    let right: Vec<usize> = (1..head.len()).collect();
    let mut text = format!("\n{}", table(&head, &right, rows));
    if let Some((part, words)) = &changed.event {
        text += &format!("  predicted: {words} after {} % of the change\n", significant(100.0 * part, 3));
    }
    for difference in &changed.differences {
        text += &format!("  at the end: {difference}\n");
    }
    text
}
