use super::limits::{self, Limit, Objective, ended_at};
use super::lines::{item, paragraph};
use super::optimum::{ConstraintReport, Multipliers};
use super::swings::ScenariosReport;
use super::table::table;
use super::{Reply, json, shown};
use crate::error::Result;
use crate::optimize::{Constrained, Status};
use crate::parameters::Preset;
use crate::study::swings::{Model, Robust};
use crate::study::{Optimum, Sense};
use crate::units::{Message, System, counted};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Least multiplier of the loss of a model that decides the design.
const IDLE: f64 = 1e-6;

/// The answer of `robust`; `within` is the allowed loss, SI.
pub fn robust_reply(
    found: &Robust,
    within: Option<f64>,
    warnings: Vec<Message>,
    file: Option<String>,
) -> Reply<Value> {
    let search = &found.search;
    let names = || search.vary.iter().map(|vary| vary.parameter.name);
    let design = |x: &[f64]| json::named(names().zip(x.iter().map(|x| Some(*x))));
    let numbers = |values: &[Option<f64>]| {
        values
            .iter()
            .map(|value| json::number(*value))
            .collect::<Vec<_>>()
    };
    let model = |(k, (model, best)): (usize, &(Model, Optimum))| {
        json!({
            "model": model.name,
            "reason": Some(model.reason).filter(|reason| !reason.is_empty()),
            "value": json::number(best.value()),
            "optimum": design(&best.solution.x),
            "loss": json::number(Some(found.losses[k])),
            "share": json::number(Some(found.shares[k])),
            "losses": numbers(&found.matrix[k]),
            "loss_as_set_up": json::number(found.as_set_up[k]),
            "constraints": constraints(found, k),
        })
    };
    let multipliers = |i: usize| {
        let [lower, upper] = found.bound_prices(i);
        (search.vary[i].parameter.name, Multipliers { lower, upper })
    };
    let swings = found
        .models
        .first()
        .filter(|(_, best)| !best.search.scenarios.is_one_drive());
    let body = json!({
        "objective": search.of.expression,
        "sense": search.sense.name(),
        "optimum": design(&found.design),
        "multipliers": (0..search.vary.len()).map(multipliers).collect::<BTreeMap<_, _>>(),
        "greatest_loss": json::number(Some(found.greatest())),
        "within": json::number(within),
        "holds_for_all": within.map(|within| found.greatest() <= within),
        "models": found.models.iter().enumerate().map(model).collect::<Vec<_>>(),
        "swings": swings.map(|(_, best)| ScenariosReport::new(&best.search.scenarios)),
        "setup": json::setup(&found.setup),
        "file": file,
    });
    Reply::done("robust", warnings, body).ended(
        found.status(),
        Some(verdict(found, within, System::default())),
    )
}

/// The constraints of a model with the robust design; multipliers are of the greatest loss.
fn constraints(found: &Robust, model: usize) -> Vec<ConstraintReport> {
    let of_model = found.limits().filter(|(k, ..)| *k == model);
    let report = |(_, j, at, _): (usize, usize, Constrained, &[f64])| {
        let multiplier = found.limit_price(model, j, &at);
        ConstraintReport {
            multiplier,
            ..ConstraintReport::new(&found.search.subject_to[j], &at)
        }
    };
    of_model.map(report).collect()
}

/// The verdict: one design is within the allowed loss for all models, or none.
fn verdict(found: &Robust, within: Option<f64>, system: System) -> String {
    let goal = &found.search.of;
    let show = |value: f64| shown::goal_difference(goal, value, system);
    let least = format!(
        "the design loses at most {} of {} with any of the models, and none was found that loses \
         less",
        show(found.greatest().max(0.0)),
        goal.expression
    );
    let stopped = found
        .interrupted()
        .map_or(String::new(), |stopped| format!("{stopped}; so far "));
    stopped
        + &match within {
            Some(within) if found.greatest() <= within => {
                format!(
                    "one design is within {} of the best for every model: {least}",
                    show(within)
                )
            }
            Some(within) => format!(
                "no design is within {} of the best for every model: {least}",
                show(within)
            ),
            None => least,
        }
}

/// The robust design as text, with the loss of each model with it and with the best designs of the
/// other models.
pub fn robust_text(found: &Robust, within: Option<f64>, system: System) -> String {
    let search = &found.search;
    let goal = &search.of;
    let show = |value: f64| shown::goal_difference(goal, value, system);
    let solution = &found.solution;
    let ending = paragraph(&format!(
        "{}: {} ({}, {} of {})",
        found.status(),
        verdict(found, within, system),
        counted(solution.iterations, "iteration"),
        counted(solution.evaluations, "evaluation"),
        counted(found.models.len() as u64, "model")
    ));
    let numbers = (1..=found.models.len()).map(|k| format!("best for {k}"));
    let head: Vec<String> = std::iter::once("vary".to_owned())
        .chain(numbers.clone())
        .collect();
    let rows = search.vary.iter().enumerate().map(|(i, vary)| {
        let bests = found
            .models
            .iter()
            .map(|(_, best)| shown::within(vary, best.solution.x[i], system));
        std::iter::once(vary.parameter.name.into())
            .chain(bests)
            .collect()
    });
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let all: Vec<usize> = (1..head.len()).collect();
    let designs = format!("{}\n{}", held_text(found, system), table(&head, &all, rows));

    let head: Vec<String> = ["", "robust", "as set up"]
        .map(str::to_owned)
        .into_iter()
        .chain(numbers)
        .collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let rows = (0..found.models.len()).map(|k| {
        let or_dash =
            |loss: Option<f64>| loss.map_or(shown::NONE.into(), |loss| show(loss.max(0.0)));
        let robust = show(found.losses[k].max(0.0));
        [(k + 1).to_string(), robust, or_dash(found.as_set_up[k])]
            .into_iter()
            .chain(found.matrix[k].iter().copied().map(or_dash))
            .collect()
    });
    let all: Vec<usize> = (1..head.len()).collect();
    let losses = table(&head, &all, rows);

    let models = found.models.iter().enumerate().map(|(k, (model, best))| {
        let value = best
            .value()
            .map_or(shown::NONE.into(), |value| shown::goal(goal, value, system));
        let holds = if found.shares[k] > IDLE {
            "; its loss decides the robust design"
        } else {
            ""
        };
        let reason = if model.reason.is_empty() {
            String::new()
        } else {
            format!(" ({})", model.reason)
        };
        item(&format!(
            "{}: {}{reason}: {} at best {value}{holds}",
            k + 1,
            model.name,
            goal.expression
        ))
    });
    let told = format!(
        "losses of {} beside the best for each model, by design; {} where the design breaks a \
         limit, or a swing does not fly",
        goal.expression,
        shown::NONE
    );
    format!(
        "{ending}\nmodels\n{}\n{designs}\n{}{losses}",
        models.collect::<String>(),
        paragraph(&told)
    )
}

/// The robust design with the prices of its bounds and constraints, of the greatest loss.
fn held_text(found: &Robust, system: System) -> String {
    let (search, solution) = (&found.search, &found.solution);
    let goal = &search.of;
    let is_converged = solution.status == Status::Converged;
    let objective = Objective {
        of: (goal.quantity, goal.unit),
        value: solution.value.unwrap_or_default(),
        sense: Sense::Minimize,
        is_converged,
    };
    let rows = search.vary.iter().enumerate().map(|(i, vary)| {
        let by = (vary.parameter.quantity, vary.parameter.unit);
        let multipliers = [solution.lower_multipliers[i], solution.upper_multipliers[i]];
        let held = match () {
            () if vary.low == vary.high => "fixed".into(),
            () if !is_converged => String::new(),
            () => {
                let prices = found.bound_prices(i);
                let [lower, upper] = prices
                    .map(|price| of_the_bests(multipliers, objective.price(price, by, system)));
                limits::bound(multipliers, prices, |amount| {
                    objective.price(amount, by, system)
                }) + &lower.map_or(String::new(), |price| {
                    format!("; {price} that its lower bound is lowered")
                }) + &upper.map_or(String::new(), |price| {
                    format!("; {price} that its upper bound is raised")
                })
            }
        };
        let value = shown::within(vary, found.design[i], system);
        vec![
            vary.parameter.name.into(),
            value,
            shown::range(vary, system),
            held,
        ]
    });
    let mut text = table(
        &[
            "vary",
            ended_at(solution.status, "robust"),
            "range",
            "change of the greatest loss",
        ],
        &[1],
        rows,
    );
    let rows = found.limits().map(|(k, j, at, slopes)| {
        let limit = &search.subject_to[j];
        let by = (limit.goal.quantity, limit.goal.unit);
        let gain = found.limit_price(k, j, &at);
        let of = Limit {
            gain,
            ..Limit::new(limit, &at, slopes)
        };
        let value = shown::goal(&limit.goal, at.value, system);
        let bests = of_the_bests([at.multiplier; 2], objective.price(gain, by, system))
            .filter(|_| is_converged);
        let bests = bests.map_or(String::new(), |price| {
            format!("; {price} that the limit is relaxed")
        });
        vec![
            limit.expression.clone(),
            (k + 1).to_string(),
            value,
            objective.limit(of, system) + &bests,
        ]
    });
    let rows: Vec<_> = rows.collect();
    if !rows.is_empty() {
        text += &format!(
            "\n{}",
            table(
                &[
                    "subject to",
                    "model",
                    "value",
                    "change of the greatest loss"
                ],
                &[1, 2],
                rows
            )
        );
    }
    text
}

/// The price of an inactive bound or constraint that is active at a single model's optimum.
fn of_the_bests(multipliers: [f64; 2], price: String) -> Option<String> {
    Some(price).filter(|price| multipliers == [0.0; 2] && !price.starts_with("0 "))
}

/// The setup with the robust design as a setup file in TOML, to the last digit.
///
/// # Errors
/// As [`setup_toml`](super::setup_toml).
pub fn robust_toml(found: &Robust, within: Option<f64>, preset: &Preset) -> Result<String> {
    let search = &found.search;
    let mut about = vec![format!(
        "{}, {} {}",
        preset.name,
        search.sense.adjective(),
        search.of.expression
    )];
    about.push(verdict(found, within, System::default()));
    about.extend(
        found
            .models
            .iter()
            .map(|(model, _)| format!("model: {}", model.name)),
    );
    about.extend(
        search
            .subject_to
            .iter()
            .map(|limit| format!("subject to {}", limit.expression)),
    );
    let remarks = search.vary.iter().zip(&found.design).map(|(vary, x)| {
        let show = |value: f64| vary.parameter.show(Some(value));
        let chosen = shown::as_declared(vary.parameter, *x);
        (
            vary.parameter,
            format!(
                "robust: {chosen} in {} .. {}",
                show(vary.low),
                show(vary.high)
            ),
        )
    });
    super::setup_toml(&found.setup, preset, &about, &remarks.collect::<Vec<_>>())
}
