use super::lines::item;
use super::reply::{Reply, share};
use super::table::table;
use super::{json, shown};
use crate::drive::OutcomeGroup;
use crate::study::uncertainty::{
    Distribution, Interval, Moments, OutcomeUncertainty, Uncertain, Uncertainty,
};
use crate::units::{Message, Quantity, System, counted, counted_of};
use serde::Serialize;
use serde_json::{Value, json};

/// What is uncertain about a drive as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct UncertaintyReport {
    /// The uncertain parameters and their distributions.
    pub inputs: Vec<Value>,
    /// Each outcome.
    pub outcomes: Vec<Value>,
    /// Ellipses of the landings; empty unless carry and lateral were asked for.
    pub ellipses: Vec<Value>,
    /// Points of the base sample.
    pub samples: usize,
    /// The seed of the sample.
    pub seed: u64,
    /// How many drives were flown.
    pub drives: u64,
    /// How they ended: a number for each status.
    pub statuses: Value,
}

impl UncertaintyReport {
    /// The answer of `uncertainty`.
    pub fn reply(found: &Uncertainty, warnings: Vec<Message>) -> Reply<Self> {
        let sampled = found
            .outcomes
            .iter()
            .filter(|outcome| outcome.sampled.is_some())
            .count();
        let missing = found
            .outcomes
            .iter()
            .filter(|outcome| outcome.sampled.is_none());
        let missing: Vec<_> = missing.map(|outcome| outcome.of.name()).collect();
        let message = (!missing.is_empty())
            .then(|| format!("no drive of the sample has {}", missing.join(", ")));
        Reply::done("uncertainty", warnings, Self::new(found))
            .ended(share(sampled, found.outcomes.len()), message)
    }

    fn new(found: &Uncertainty) -> Self {
        let inputs = found.inputs.iter().map(|input| {
            json!({
                "parameter": input.parameter.name,
                "distribution": name(&input.distribution),
                "values": values(&input.distribution),
                "mean": input.distribution.mean(),
                "standard_uncertainty": input.distribution.deviation(),
            })
        });
        let ellipses = found.ellipses.iter().map(|sampled| {
            json!({
                "share": sampled.ellipse.share,
                "by": if sampled.by_gradient { "gradient" } else { "sample" },
                "centre": { "lateral": sampled.ellipse.centre[0], "carry": sampled.ellipse.centre[1] },
                "half_axes": sampled.ellipse.half_axes,
                "holds": sampled.holds,
            })
        });
        let statuses = found
            .tally
            .counts()
            .map(|(status, count)| (status.name().to_owned(), count.into()));
        Self {
            inputs: inputs.collect(),
            outcomes: found
                .outcomes
                .iter()
                .map(|outcome| outcome_json(outcome, &found.inputs))
                .collect(),
            ellipses: ellipses.collect(),
            samples: found.plan.samples,
            seed: found.plan.seed,
            drives: found.tally.counts().map(|(_, count)| count).sum(),
            statuses: Value::Object(statuses.collect()),
        }
    }
}

fn name(distribution: &Distribution) -> &'static str {
    match distribution {
        Distribution::Normal { .. } => "normal",
        Distribution::Uniform { .. } => "uniform",
        Distribution::Triangular { .. } => "triangular",
        Distribution::Truncated { .. } => "truncated",
    }
}

fn values(distribution: &Distribution) -> Vec<f64> {
    match *distribution {
        Distribution::Normal { mean, deviation } => vec![mean, deviation],
        Distribution::Uniform { low, high } => vec![low, high],
        Distribution::Triangular { low, mode, high } => vec![low, mode, high],
        Distribution::Truncated {
            mean,
            deviation,
            low,
            high,
        } => vec![mean, deviation, low, high],
    }
}

fn outcome_json(outcome: &OutcomeUncertainty, inputs: &[Uncertain]) -> Value {
    let moments = |moments: Option<Moments>| {
        moments.map(|m| json!({ "mean": m.mean, "standard_uncertainty": m.deviation }))
    };
    let interval = |i: Interval| json!({ "value": i.value, "low": i.low, "high": i.high });
    let sampled = outcome.sampled.as_ref();
    let shares = inputs.iter().enumerate().map(|(k, input)| {
        let indices = sampled.and_then(|sampled| sampled.indices[k]);
        let slopes = outcome.slopes[k];
        json!({
            "parameter": input.parameter.name,
            "first": indices.map(|indices| interval(indices.first)),
            "total": indices.map(|indices| interval(indices.total)),
            "mean_square_slope": json::number(slopes.map(|slopes| slopes.mean_square)),
            "bound": slopes.map(|slopes| interval(slopes.bound)),
        })
    });
    let first = outcome.measure_first(inputs);
    json!({
        "of": outcome.of.name(),
        "varies": outcome.varies(),
        "delta": moments(outcome.delta.map(|(first, _)| first)),
        "second_order": moments(outcome.delta.and_then(|(_, second)| second)),
        "monte_carlo": sampled.map(|sampled| json!({
            "mean": interval(sampled.mean),
            "standard_uncertainty": interval(sampled.deviation),
            "quantiles": { "2.5 %": sampled.quantiles[0], "50 %": sampled.quantiles[1], "97.5 %": sampled.quantiles[2] },
            "rows_left_out": sampled.left_out,
        })),
        "indices": shares.collect::<Vec<_>>(),
        "measure_first": first.map(|(parameter, left)| json!({ "parameter": parameter.name, "standard_uncertainty": left })),
    })
}

/// The uncertainty of outcomes as text.
pub fn uncertainty_text(found: &Uncertainty, system: System) -> String {
    let inputs = found.inputs.iter().map(|input| {
        vec![
            input.parameter.name.into(),
            distribution_text(input, system),
        ]
    });
    let mut text = table(&["uncertain parameter", "distribution"], &[], inputs);
    for outcome in &found.outcomes {
        text += &outcome_text(outcome, found, system);
    }
    if !found.ellipses.is_empty() {
        text += &ellipses_text(found, system);
    }
    let all: u64 = found.tally.counts().map(|(_, count)| count).sum();
    let counts = found
        .tally
        .counts()
        .filter(|(_, count)| *count > 0)
        .map(|(status, count)| format!("{count} {status}"));
    let counts: Vec<_> = counts.collect();
    text + &format!(
        "\n{} ({}, seed {}): {}\n",
        counted(all, "drive"),
        counted(found.plan.samples as u64, "point"),
        found.plan.seed,
        counts.join(", ")
    )
}

/// "normal: 110 mph ± 0.5 mph"; "truncated normal: 110 mph ± 4 mph, cut at 105 mph and 115 mph".
pub(super) fn distribution_text(input: &Uncertain, system: System) -> String {
    let show = |value: f64| shown::stated(input.parameter, value, system);
    let normal =
        |mean: f64, deviation: f64| format!("normal: {} ± {}", show(mean), show(deviation));
    match input.distribution {
        Distribution::Normal { mean, deviation } => normal(mean, deviation),
        Distribution::Truncated {
            mean,
            deviation,
            low,
            high,
        } => {
            format!(
                "truncated {}, cut at {} and {}",
                normal(mean, deviation),
                show(low),
                show(high)
            )
        }
        other => format!(
            "{}: {}",
            name(&other),
            values(&other)
                .into_iter()
                .map(show)
                .collect::<Vec<_>>()
                .join(" .. ")
        ),
    }
}

/// Points of a sample below which estimates of shares are noise.
const ENOUGH: usize = 100;

fn outcome_text(outcome: &OutcomeUncertainty, found: &Uncertainty, system: System) -> String {
    let of = outcome.of;
    let value = |value: f64| shown::outcome(of, value, system);
    let spread = |value: f64| shown::spread(of, value, system);
    let between = |i: Interval, show: &dyn Fn(f64) -> String| {
        format!("{} ({} to {})", show(i.value), show(i.low), show(i.high))
    };
    let moments = |words: &str, m: Moments| vec![words.into(), value(m.mean), spread(m.deviation)];
    let mut rows = vec![];
    if let Some((first, second)) = outcome.delta {
        rows.push(moments("by the gradient", first));
        rows.extend(second.map(|second| moments("by gradient and Hessian", second)));
    }
    let Some(sampled) = &outcome.sampled else {
        let head = [of.name(), "mean", "standard deviation"];
        return format!(
            "\n{}  no drive of the sample has this outcome\n",
            table(&head, &[1, 2], rows)
        );
    };
    if !outcome.varies() {
        let given = if found.inputs.len() == 1 {
            "the uncertain parameter"
        } else {
            "any of the uncertain parameters"
        };
        let mean = value(sampled.mean.value);
        let why = if depends(outcome, found) {
            "it varies by less than rounding, since the uncertainty is so small".to_owned()
        } else {
            format!("it does not depend on {given}")
        };
        return format!("\n{} is {mean} in every drive: {why}\n", of.name());
    }
    rows.push(vec![
        "by the sample (95 % interval)".into(),
        between(sampled.mean, &value),
        between(sampled.deviation, &spread),
    ]);
    let mut text = format!(
        "\n{}",
        table(&[of.name(), "mean", "standard deviation"], &[1, 2], rows)
    );
    let [low, middle, high] = sampled.quantiles.map(value);
    let drives = match of.group() {
        OutcomeGroup::Flight if found.part_without_landing() > 0.0 => "drives that land",
        _ => "drives",
    };
    text +=
        &format!("  95 % of the {drives} lie between {low} and {high}; the median is {middle}\n\n");
    if found.plan.samples < ENOUGH {
        return text
            + &format!(
                "  shares of the variance are shown from {ENOUGH} points on; `samples` gives their \
                 number\n"
            );
    }
    // rounding has no sign
    let tenths = |value: f64| format!("{:.1}", (1000.0 * value).round() / 10.0 + 0.0);
    let percent = |value: f64| format!("{} %", tenths(value));
    let share = |i: Interval| {
        format!(
            "{} ({} to {})",
            percent(i.value),
            tenths(i.low),
            tenths(i.high)
        )
    };
    let rows = found.inputs.iter().enumerate().map(|(k, input)| {
        let indices = sampled.indices[k];
        vec![
            input.parameter.name.into(),
            indices.map_or(shown::NONE.into(), |indices| share(indices.first)),
            indices.map_or(shown::NONE.into(), |indices| share(indices.total)),
            outcome.slopes[k].map_or(shown::NONE.into(), |slopes| share(slopes.bound)),
        ]
    });
    let head = [
        "Sobol' share of the variance",
        "first-order index",
        "total index",
        "upper bound of total",
    ];
    text += &table(&head, &[1, 2, 3], rows);
    if found.inputs.len() > 1 {
        text += &item(
            "estimates from the sample with 95 % intervals; the upper bound is estimated from the \
             slopes",
        );
    } else {
        text += &item(
            "of a single uncertain parameter the share is 100 %; the upper bound is estimated from \
             the slopes, with a 95 % interval",
        );
    }
    if sampled.left_out > 0 {
        text += &format!(
            "  these shares leave out {} at which a drive does not have this outcome\n",
            counted_of(
                sampled.left_out as u64,
                found.plan.samples as u64,
                ["point", "points"]
            )
        );
    }
    if let Some((parameter, left)) = outcome.measure_first(&found.inputs) {
        text += &item(&format!(
            "measure {} first: once it is known exactly, the standard deviation falls to {}",
            parameter.name,
            spread(left)
        ));
    }
    text
}

/// Whether the outcome depends on any of the uncertain parameters at their means; also where it is
/// not known not to.
fn depends(outcome: &OutcomeUncertainty, found: &Uncertainty) -> bool {
    let Some(at) = &outcome.at_means else {
        return true;
    };
    let curvature = |k: usize| at.hessian.get(k).map_or(0.0, |row| row[k]);
    let mut inputs = found.inputs.iter().enumerate();
    inputs.any(|(k, input)| {
        shown::depends(
            outcome.of,
            at.value,
            input.parameter,
            at.gradient[k],
            curvature(k),
        )
    })
}

fn ellipses_text(found: &Uncertainty, system: System) -> String {
    use crate::drive::Outcome::Carry;
    let head = [
        "landing ellipse",
        "half-axes",
        "long axis from downrange",
        "drives inside",
    ];
    let rows = found.ellipses.iter().map(|sampled| {
        let [long, short] = sampled.ellipse.half_axes;
        let lengths =
            [long, short].map(|axis| shown::spread(Carry, axis[0].hypot(axis[1]), system));
        // an axis has no direction of its own: within a quarter turn of downrange
        let turned = (long[0] * long[1].signum()).atan2(long[1].abs());
        vec![
            format!(
                "{} %, from the {}",
                100.0 * sampled.ellipse.share,
                if sampled.by_gradient {
                    "gradients"
                } else {
                    "sample"
                }
            ),
            lengths.join(" and "),
            shown::side(Quantity::ANGLE, "deg", turned),
            format!("{:.1} %", 100.0 * sampled.holds),
        ]
    });
    format!("\n{}", table(&head, &[1, 2, 3], rows))
}
