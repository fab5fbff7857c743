use super::reply::{Reply, share};
use super::{drive::readable, json, table::table};
use crate::study::uncertainty::{Distribution, Interval, Moments, OutcomeUncertainty, Uncertain, Uncertainty};
use crate::units::significant;
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
    pub fn reply(found: &Uncertainty, warnings: Vec<String>) -> Reply<Self> {
        let sampled = found.outcomes.iter().filter(|outcome| outcome.sampled.is_some()).count();
        let missing = found.outcomes.iter().filter(|outcome| outcome.sampled.is_none());
        let missing: Vec<_> = missing.map(|outcome| outcome.of.name()).collect();
        let message = (!missing.is_empty()).then(|| format!("no drive of the sample has {}", missing.join(", ")));
        Reply::done("uncertainty", warnings, Self::new(found)).ended(share(sampled, found.outcomes.len()), message)
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
        let statuses = found.tally.counts().map(|(status, count)| (status.name().to_owned(), count.into()));
        Self {
            inputs: inputs.collect(),
            outcomes: found.outcomes.iter().map(|outcome| outcome_json(outcome, &found.inputs)).collect(),
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
    }
}

fn values(distribution: &Distribution) -> Vec<f64> {
    match *distribution {
        Distribution::Normal { mean, deviation } => vec![mean, deviation],
        Distribution::Uniform { low, high } => vec![low, high],
        Distribution::Triangular { low, mode, high } => vec![low, mode, high],
    }
}

fn outcome_json(outcome: &OutcomeUncertainty, inputs: &[Uncertain]) -> Value {
    let moments =
        |moments: Option<Moments>| moments.map(|m| json!({ "mean": m.mean, "standard_uncertainty": m.deviation }));
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
            "bound": json::number(slopes.map(|slopes| slopes.bound)),
        })
    });
    let first = outcome.measure_first(inputs);
    json!({
        "of": outcome.of.name(),
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

/// What is uncertain about a drive as text.
pub fn uncertainty_text(found: &Uncertainty) -> String {
    let mut text = table(
        &["uncertain", "distribution"],
        &[],
        found.inputs.iter().map(|input| vec![input.parameter.name.into(), distribution_text(input)]),
    );
    for outcome in &found.outcomes {
        text += &outcome_text(outcome, found);
    }
    if !found.ellipses.is_empty() {
        text += &ellipses_text(found);
    }
    let all: u64 = found.tally.counts().map(|(_, count)| count).sum();
    let counts =
        found.tally.counts().filter(|(_, count)| *count > 0).map(|(status, count)| format!("{count} {status}"));
    let counts: Vec<_> = counts.collect();
    text + &format!("\n{all} drives ({} points, seed {}): {}\n", found.plan.samples, found.plan.seed, counts.join(", "))
}

/// "normal: 110 mph ± 0.5 mph".
fn distribution_text(input: &Uncertain) -> String {
    let (quantity, unit) = (input.parameter.quantity, input.parameter.unit);
    let size = quantity.size_of(unit).unwrap_or(1.0);
    let show = |value: f64| format!("{} {unit}", significant(value / size, 5)).trim_end().to_owned();
    let shown: Vec<_> = values(&input.distribution).into_iter().map(show).collect();
    let between = if matches!(input.distribution, Distribution::Normal { .. }) { " ± " } else { " .. " };
    format!("{}: {}", name(&input.distribution), shown.join(between))
}

fn outcome_text(outcome: &OutcomeUncertainty, found: &Uncertainty) -> String {
    let of = outcome.of;
    let show = |value: f64| readable(of, value);
    let between = |i: Interval| format!("{} ({} to {})", show(i.value), show(i.low), show(i.high));
    let moments = |words: &str, m: Moments| vec![words.into(), show(m.mean), show(m.deviation)];
    let mut rows = vec![];
    if let Some((first, second)) = outcome.delta {
        rows.push(moments("by the gradient", first));
        rows.extend(second.map(|second| moments("by gradient and Hessian", second)));
    }
    let Some(sampled) = &outcome.sampled else {
        let head = [of.name(), "mean", "standard deviation"];
        return format!("\n{}  no drive of the sample has it\n", table(&head, &[1, 2], rows));
    };
    rows.push(vec!["flown (95 % interval)".into(), between(sampled.mean), between(sampled.deviation)]);
    let mut text = format!("\n{}", table(&[of.name(), "mean", "standard deviation"], &[1, 2], rows));
    let [low, middle, high] = sampled.quantiles.map(show);
    text += &format!("  95 % of the drives between {low} and {high}, half above {middle}\n\n");
    let percent = |value: f64| format!("{:.1} %", 100.0 * value + 0.0);
    let share = |i: Interval| format!("{} ({} to {})", percent(i.value), percent(i.low), percent(i.high));
    let rows = found.inputs.iter().enumerate().map(|(k, input)| {
        let indices = sampled.indices[k];
        vec![
            input.parameter.name.into(),
            indices.map_or("–".into(), |indices| share(indices.first)),
            indices.map_or("–".into(), |indices| share(indices.total)),
            outcome.slopes[k].map_or("–".into(), |slopes| format!("<= {}", percent(slopes.bound))),
        ]
    });
    text += &table(
        &["share of the variance of", "alone (Sobol' first)", "with others (total)", "total, by slopes"],
        &[1, 2, 3],
        rows,
    );
    if sampled.left_out > 0 {
        text += &format!(
            "  shares without {} of {} points, where a drive has none\n",
            sampled.left_out, found.plan.samples
        );
    }
    if let Some((parameter, left)) = outcome.measure_first(&found.inputs) {
        text += &format!("  measure first: {}; once it is known, ±{} is left\n", parameter.name, show(left));
    }
    text
}

fn ellipses_text(found: &Uncertainty) -> String {
    use crate::drive::Outcome::Carry;
    let head = ["landings", "half-axes", "longer one turned from downrange to the right by", "flown within"];
    let rows = found.ellipses.iter().map(|sampled| {
        let [long, short] = sampled.ellipse.half_axes;
        let lengths = [long, short].map(|axis| readable(Carry, axis[0].hypot(axis[1])));
        // an axis has no direction of its own: within a quarter turn of downrange
        let turned = (long[0] * long[1].signum()).atan2(long[1].abs()).to_degrees();
        vec![
            format!(
                "{} %, by {}",
                100.0 * sampled.ellipse.share,
                if sampled.by_gradient { "the gradients" } else { "the sample" }
            ),
            lengths.join(" and "),
            format!("{:.1} deg", turned + 0.0),
            format!("{:.1} %", 100.0 * sampled.holds),
        ]
    });
    format!("\n{}", table(&head, &[1, 2, 3], rows))
}
