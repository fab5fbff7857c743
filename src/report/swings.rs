use super::limits::{self, Limit, Sought, ended_at};
use super::lines::paragraph;
use super::optimum::{ConstraintReport, LocalReport, Multipliers, ends_text};
use super::table::table;
use super::uncertainty::distribution_text;
use super::{OptimumReport, Reply, json, shown};
use crate::error::Result;
use crate::optimize::{Local, Status};
use crate::parameters::Preset;
use crate::study::swings::{
    Doubt, Goal, Price, Resampled, Rule, Scenarios, Swings, SwingsOptimum, status_of,
};
use crate::study::uncertainty::Interval;
use crate::units::{Message, System, counted, significant};
use serde_json::{Map, Value, json};

/// The answer of `optimize` over many swings: of one drive there is no launch and no flight.
pub fn swings_reply(
    best: &SwingsOptimum,
    price: Option<&Price>,
    resampled: Option<&Resampled>,
    warnings: Vec<Message>,
) -> Reply<OptimumReport> {
    let (search, solution) = (&best.search, &best.solution);
    let found = best.value().is_some();
    let names = || search.vary.iter().map(|vary| vary.parameter.name);
    let by_name =
        |values: &[f64]| json::named(names().zip(values.iter().map(|value| Some(*value))));
    let multipliers = |i: usize| {
        let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
        (search.vary[i].parameter.name, Multipliers { lower, upper })
    };
    let goals = |values: &[f64]| {
        let expressions =
            std::iter::once(&search.of).chain(search.subject_to.iter().map(|limit| &limit.goal));
        json::named(
            expressions
                .map(|goal| goal.expression.as_str())
                .zip(values.iter().map(|value| Some(*value))),
        )
    };
    let interval = |i: &Interval| json!({ "value": json::number(Some(i.value)), "low": json::number(Some(i.low)), "high": json::number(Some(i.high)) });
    let mut swings = scenarios(&best.scenarios);
    swings.extend(named(json!({
        "as_set_up": best.as_set_up.as_deref().map(goals),
        "nominal": price.and_then(|price| price.nominal.as_ref().ok()).map(|nominal| json!({
            "optimum": by_name(&nominal.design),
            "promised": goals(&nominal.promised),
            "kept": nominal.kept.as_deref().map(goals),
        })),
        "unknown": unknown(price),
        "quadrature_error": price.and_then(|price| match price.doubt() { Some(Doubt::Quadrature(error)) => Some(error), _ => None }),
        "sampling": price.and_then(|price| match price.doubt() {
            Some(Doubt::Sampling(found, sequences)) => Some(json!({ "interval": interval(found), "sequences": sequences })),
            _ => None,
        }),
        "beyond_strokes": best.beyond_strokes,
        "resampled": resampled.map(|found| json!({
            "optimum": Value::Object(names().zip(&found.design).map(|(name, design)| (name.to_owned(), interval(design))).collect()),
            "value": interval(&found.goal),
            "rounds": found.rounds,
            "better_than_set_up": found.apart.map(|apart| interval(&apart.better)),
            "swings_to_tell": found.apart.and_then(|apart| apart.swings),
        })),
    })));
    let constraints = best.limits();
    let body = OptimumReport {
        objective: search.of.expression.clone(),
        sense: search.sense.name(),
        value: json::number(best.value()),
        optimum: found.then(|| by_name(&solution.x)),
        start: (!found).then(|| by_name(&solution.x)),
        gradient: found.then(|| by_name(&best.gradient())),
        multipliers: found.then(|| (0..search.vary.len()).map(multipliers).collect()),
        constraints: constraints
            .map(|(limit, at)| ConstraintReport::of_goal(limit, &at))
            .collect(),
        kkt_residual: json::number(found.then_some(solution.kkt_residual)),
        iterations: solution.iterations,
        evaluations: solution.evaluations,
        steps: solution.effort,
        optima: (best.starts() > 1).then(|| locals(best)),
        sample: None,
        setup: found.then(|| json::setup(&best.setup)),
        launch: None,
        flight: None,
        law_range: None,
        file: None,
        swings: Some(Value::Object(swings)),
        design: None,
    };
    let reply = Reply::done("optimize", warnings, body);
    match best.interrupted().filter(|_| best.starts() > 1) {
        None => reply.ended(best.status(), Some(best.message())),
        interrupted => reply.ended("interrupted", interrupted),
    }
}

/// The local optima of a search from several starts.
fn locals(best: &SwingsOptimum) -> Vec<LocalReport> {
    let names = || best.search.vary.iter().map(|vary| vary.parameter.name);
    let local = |(local, value): (&Local, Option<f64>)| LocalReport {
        status: status_of(&local.solution),
        value: json::number(value),
        optimum: json::named(names().zip(local.solution.x.iter().map(|x| Some(*x)))),
        starts: local.starts.len(),
    };
    best.ended().map(local).collect()
}

/// What could not be found beside the best design, in sentences.
fn unknown(price: Option<&Price>) -> Vec<String> {
    let Some(price) = price else { return vec![] };
    let nominal = price.nominal.as_ref().err();
    let nominal = nominal.map(|why| {
        format!("there is no best design for the mean swing alone, which does not fly: {why}")
    });
    let doubt = match price.doubt() {
        Some(Doubt::Unknown(why)) => Some(format!(
            "how far the best value is known is not known: of other swings of the same golfer one \
             does not fly ({why})"
        )),
        _ => None,
    };
    nominal.into_iter().chain(doubt).collect()
}

/// The swings that a goal is about, and how they were taken.
pub(super) fn scenarios(of: &Scenarios) -> Map<String, Value> {
    let (rule, seed) = match of.rule {
        Rule::Quadrature(_) => ("quadrature", None),
        Rule::Sequence { seed, .. } => ("sequence", Some(seed)),
        Rule::Recorded => ("recorded", None),
    };
    named(json!({
        "parameters": of.parameters.iter().map(|parameter| parameter.name).collect::<Vec<_>>(),
        "scenarios": of.points.len(),
        "rule": rule,
        "seed": seed,
    }))
}

fn named(value: Value) -> Map<String, Value> {
    if let Value::Object(named) = value {
        named
    } else {
        Map::new()
    }
}

/// The best design over many swings as text.
pub fn swings_text(
    best: &SwingsOptimum,
    price: Option<&Price>,
    resampled: Option<&Resampled>,
    system: System,
) -> String {
    let (search, solution) = (&best.search, &best.solution);
    let scenarios = best.scenarios.points.len() as u64;
    let ending = paragraph(&format!(
        "{}: {} ({}, {} of {})",
        best.status(),
        best.message(),
        counted(solution.iterations, "iteration"),
        counted(solution.evaluations, "evaluation"),
        counted(scenarios, "swing")
    ));
    let Some(goals) = best.goals() else {
        return ending;
    };
    let own = search.vary.iter().map(|vary| vary.parameter);
    let nominal = price.and_then(|price| price.nominal.as_ref().ok());
    let sought = sought(best);
    let design = own.enumerate().map(|(i, parameter)| {
        let vary = &search.vary[i];
        let nominal = nominal.map_or(shown::NONE.into(), |nominal| {
            shown::within(vary, nominal.design[i], system)
        });
        let multipliers = [solution.lower_multipliers[i], solution.upper_multipliers[i]];
        let bound = match () {
            () if vary.low == vary.high => "fixed".into(),
            () if !sought.is_converged => String::new(),
            () if best.is_idle(i) => "no effect".into(),
            () => limits::bound(multipliers, multipliers, |amount| {
                sought.price(amount, (parameter.quantity, parameter.unit), system)
            }),
        };
        vec![
            parameter.name.into(),
            shown::within(vary, solution.x[i], system),
            nominal,
            shown::range(vary, system),
            bound,
        ]
    });
    let found = ended_at(solution.status, "best");
    let place = table(
        &["vary", found, "for the mean swing", "range", ""],
        &[1, 2],
        design,
    );

    let all = std::iter::once((&search.of, search.of.expression.clone())).chain(
        search
            .subject_to
            .iter()
            .map(|limit| (&limit.goal, limit.expression.clone())),
    );
    let rows = all.enumerate().map(|(k, (goal, expression))| {
        let breaks = |value: f64| k > 0 && !search.subject_to[k - 1].is_met(value);
        let show = |value: f64| {
            let value_shown = value_text(goal, value, system);
            if breaks(value) {
                format!("{value_shown} {BROKEN}")
            } else {
                value_shown
            }
        };
        let of = |values: Option<&Vec<f64>>| {
            let value = values
                .map(|values| values[k])
                .filter(|value| value.is_finite());
            value.map_or(shown::NONE.into(), show)
        };
        let kept = of(nominal.and_then(|nominal| nominal.kept.as_ref()));
        let promised = of(nominal.map(|nominal| &nominal.promised));
        vec![
            expression,
            show(goals[k]),
            kept,
            promised,
            of(best.as_set_up.as_ref()),
        ]
    });
    let head = [
        "over all swings",
        found,
        "best for mean swing",
        "with that swing alone",
        "as set up",
    ];
    let mut text = format!("{ending}\n{place}\n{}", table(&head, &[1, 2, 3, 4], rows));
    text += &limits_text(best, system);
    text += &doubts(best, price, resampled, system);
    if best.starts() > 1 {
        let ends = best.ended().map(|(Local { solution, starts }, value)| {
            let value = value.map(|value| value_text(&search.of, value, system));
            (
                value.unwrap_or(shown::NONE.into()),
                &solution.x[..],
                starts.len(),
                status_of(solution),
            )
        });
        text += &ends_text(
            (&search.of.expression, &search.vary),
            ends,
            (best.starts(), best.stopped()),
            system,
        );
    }
    text
}

/// What stands behind the value of a limit that a design breaks.
const BROKEN: &str = "(broken)";

/// What is sought over the swings.
fn sought(best: &SwingsOptimum) -> Sought {
    let goal = &best.search.of;
    let is_converged = best.solution.status == Status::Converged;
    Sought {
        of: (goal.quantity, goal.unit),
        value: best.value().unwrap_or_default(),
        sense: best.search.sense,
        is_converged,
    }
}

/// The limits with their prices, as a table; empty without any.
fn limits_text(best: &SwingsOptimum, system: System) -> String {
    let solution = &best.solution;
    let rows = best.limits().enumerate().map(|(j, (limit, at))| {
        let slopes = solution.jacobian.get(j).map_or(&[][..], Vec::as_slice);
        let of = Limit::new(
            (limit.goal.quantity, limit.goal.unit),
            [limit.low, limit.high],
            &at,
            slopes,
        );
        vec![limit.expression.clone(), sought(best).limit(of, system)]
    });
    let rows: Vec<_> = rows.filter(|row| !row[1].is_empty()).collect();
    if rows.is_empty() {
        String::new()
    } else {
        format!("\n{}", table(&["subject to", ""], &[], rows))
    }
}

/// How far the answer is known.
fn doubts(
    best: &SwingsOptimum,
    price: Option<&Price>,
    resampled: Option<&Resampled>,
    system: System,
) -> String {
    let goal = &best.search.of;
    let show = |value: f64| value_text(goal, value, system);
    let between = |i: &Interval| format!("{} to {}", show(i.low), show(i.high));
    let scenarios = counted(best.scenarios.points.len() as u64, "swing");
    let nominal = price.and_then(|price| price.nominal.as_ref().ok());
    let mut lines = unknown(price);
    let vary = best
        .scenarios
        .parameters
        .iter()
        .any(|parameter| parameter.name.starts_with("strike."));
    if vary || best.setup.strike.toe != 0.0 {
        lines.push(format!(
            "{}; the scatter to the sides has this doubt",
            shown::RIGID
        ));
    }
    let missed = [
        (
            nominal.is_some_and(|nominal| nominal.kept.is_none()),
            "with the best design of the mean swing",
        ),
        (best.as_set_up.is_none(), "with the design as set up"),
    ];
    lines.extend(
        missed
            .iter()
            .filter(|(is_missed, _)| *is_missed)
            .map(|(_, with)| format!("{with} some of the swings do not fly")),
    );
    let breaks = |goals: Option<&Vec<f64>>| {
        let limits = best.search.subject_to.iter();
        goals.is_some_and(|goals| {
            limits
                .zip(&goals[1..])
                .any(|(limit, value)| value.is_finite() && !limit.is_met(*value))
        })
    };
    let broken = [
        (
            breaks(nominal.and_then(|nominal| nominal.kept.as_ref())),
            "the best design of the mean swing",
        ),
        (breaks(best.as_set_up.as_ref()), "the design as set up"),
    ];
    lines.extend(
        broken
            .iter()
            .filter(|(is_broken, _)| *is_broken)
            .map(|(_, design)| {
                format!("{design} breaks a limit, so that it is no alternative to the best one")
            }),
    );
    lines.extend(best.limits().zip(&best.solution.constraints).filter_map(
        |((limit, told), seen)| {
            let is_broken = limit.is_met(seen.value) && !limit.is_met(told.value);
            is_broken.then(|| {
            format!(
                "the search keeps to {} with smoothed edges; over all swings it is outside by {}: \
                 give a limit that is stricter by as much",
                limit.expression,
                difference_text(&limit.goal, told.violation.abs(), system)
            )
        })
        },
    ));
    match price.and_then(Price::doubt) {
        Some(Doubt::Quadrature(error)) => lines.push(format!(
            "{scenarios} by Gauss's rules; {} is known to {}",
            goal.expression,
            difference_text(goal, *error, system)
        )),
        Some(Doubt::Sampling(found, sequences)) => lines.push(format!(
            "{scenarios} {}; over all swings {} is {} (99 %, by {sequences} other quasi-random \
             sequences){}",
            taken(best.scenarios.rule),
            goal.expression,
            between(found),
            if matches!(best.scenarios.rule, Rule::Sequence { .. }) {
                "; it is known better with more `scenarios`"
            } else {
                ""
            }
        )),
        Some(Doubt::Unknown(_)) | None => {
            lines.push(format!("{scenarios} {}", taken(best.scenarios.rule)))
        }
    }
    if best.scenarios.rule == Rule::Recorded
        && resampled.is_none()
        && best.solution.status == Status::Converged
    {
        lines.push(
            "how well these swings tell the best design is not known: they are alike, or \
                    their resamples came to no optimum"
                .into(),
        );
    }
    if let Some(found) = resampled {
        for (vary, design) in best.search.vary.iter().zip(&found.design) {
            let show = |value: f64| shown::parameter(vary.parameter, value, system);
            lines.push(format!(
                "from these swings the best {} lies between {} and {} (95 %, {} resamples)",
                vary.parameter.name,
                show(design.low),
                show(design.high),
                found.rounds
            ));
        }
        if let Some(apart) = &found.apart {
            let better = format!(
                "the best design is better than the one set up by {} (95 %: {} to {})",
                difference_text(goal, apart.better.value, system),
                difference_text(goal, apart.better.low, system),
                difference_text(goal, apart.better.high, system)
            );
            let recorded = best.scenarios.points.len() as u64;
            lines.push(match apart.swings {
                Some(needed) if needed <= recorded => {
                    format!("{better}: these swings tell the two apart")
                }
                Some(needed) => {
                    format!(
                        "{better}: to tell the two apart takes about {needed} swings, {} more",
                        needed - recorded
                    )
                }
                None => better,
            });
        }
    }
    format!(
        "\n{}",
        lines.iter().map(|line| paragraph(line)).collect::<String>()
    )
}

/// How the swings of a search were taken.
fn taken(rule: Rule) -> &'static str {
    match rule {
        Rule::Recorded => "as recorded, each as likely as any other",
        Rule::Quadrature(_) => "by Gauss's rules",
        Rule::Sequence { .. } => "of a quasi-random sequence",
    }
}

/// A goal as people read it.
pub fn value_text(goal: &Goal, value: f64, system: System) -> String {
    match goal.unit {
        "" => significant(value, 4),
        unit => goal.quantity.read_off(value, system.unit(unit)),
    }
}

/// A difference of a goal as people read it.
pub(super) fn difference_text(goal: &Goal, value: f64, system: System) -> String {
    match goal.unit {
        "" => significant(value, 2),
        unit => goal.quantity.read_off_difference(value, system.unit(unit)),
    }
}

/// The setup with the best design as a setup file in TOML, to the last digit.
///
/// # Errors
/// As [`setup_toml`](super::setup_toml).
pub fn swings_toml(best: &SwingsOptimum, swings: &Swings, preset: &Preset) -> Result<String> {
    let search = &best.search;
    let value = best.value().map_or(shown::NONE.into(), |value| {
        value_text(&search.of, value, System::default())
    });
    let all = counted(best.scenarios.points.len() as u64, "swing");
    let mut about = vec![format!(
        "{}, {} {} over {all}: {value}",
        preset.name,
        search.sense.adjective(),
        search.of.expression
    )];
    about.extend(match swings {
        Swings::Distributed { inputs, .. } => inputs
            .iter()
            .map(|input| {
                format!(
                    "over swings: {} {}",
                    input.parameter.name,
                    distribution_text(input, System::default())
                )
            })
            .collect(),
        Swings::Recorded { .. } => vec!["over recorded swings".into()],
    });
    about.extend(
        search
            .subject_to
            .iter()
            .map(|limit| format!("subject to {}", limit.expression)),
    );
    let interrupted = best.interrupted().filter(|_| best.starts() > 1);
    about.extend(
        interrupted.map(|interrupted| format!("interrupted: {interrupted}; the best so far:")),
    );
    about.push(format!("{}: {}", best.status(), best.message()));
    let remarks = search.vary.iter().zip(&best.solution.x).map(|(vary, x)| {
        let show = |value: f64| vary.parameter.show(Some(value));
        let found = shown::as_declared(vary.parameter, *x);
        (
            vary.parameter,
            format!(
                "optimum: {found} in {} .. {}",
                show(vary.low),
                show(vary.high)
            ),
        )
    });
    super::setup_toml(&best.setup, preset, &about, &remarks.collect::<Vec<_>>())
}
