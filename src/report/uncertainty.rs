use super::document::{Detail, Document, DocumentBlock, DocumentTable, Line};
use super::json::ByName;
use super::reply::{Ending, Report, share};
use super::shown;
use crate::drive::OutcomeGroup;
use crate::study::uncertainty::{
    Contribution, DeltaMoments, Distribution, EllipseSource, Interval, OutcomeUncertainty,
    SampledEllipse, Uncertain, Uncertainty,
};
use crate::units::{DisplayUnit, Quantity, System, counted, counted_of, fixed};
use serde::Serialize;

/// The uncertainty of a drive, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct UncertaintyReport<'a> {
    #[serde(skip)]
    found: &'a Uncertainty,
    /// The uncertain parameters and their distributions.
    pub inputs: Vec<InputReport>,
    /// The uncertainty of each outcome.
    pub outcomes: &'a [OutcomeUncertainty],
    /// Ellipses of the landings; empty unless carry and lateral were requested.
    pub ellipses: &'a [SampledEllipse],
    /// Number of points of the base sample.
    pub samples: usize,
    /// The seed of the sample.
    pub seed: u64,
    /// Number of drives flown.
    pub drives: u64,
    /// Number of drives by status.
    #[cfg_attr(
        test,
        schemars(with = "std::collections::BTreeMap<crate::batch::Status, u64>")
    )]
    pub statuses: ByName<u64>,
}

/// An uncertain parameter.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct InputReport {
    /// The parameter.
    pub parameter: &'static str,
    /// The distribution; `truncated` is a normal distribution between two bounds.
    #[cfg_attr(test, schemars(extend("enum" = Distribution::NAMES)))]
    pub distribution: &'static str,
    /// The numbers of the distribution, SI. Normal: mean and standard deviation. Uniform: lower and
    /// upper bound. Triangular: lower bound, mode and upper bound. Truncated normal: mean, standard
    /// deviation, lower and upper bound.
    pub values: Vec<f64>,
    /// The mean of the distribution, SI.
    pub mean: f64,
    /// The standard deviation of the distribution, SI.
    pub standard_uncertainty: f64,
}

impl<'a> UncertaintyReport<'a> {
    /// The report of an uncertainty analysis.
    pub fn new(found: &'a Uncertainty) -> Self {
        let inputs = found.inputs.iter().map(|input| InputReport {
            parameter: input.parameter.name,
            distribution: input.distribution.name(),
            values: input.distribution.numbers(),
            mean: input.distribution.mean(),
            standard_uncertainty: input.distribution.deviation(),
        });
        let statuses = found.status_counts.counts();
        Self {
            found,
            inputs: inputs.collect(),
            outcomes: &found.outcomes,
            ellipses: &found.ellipses,
            samples: found.plan.samples,
            seed: found.plan.seed,
            drives: found.status_counts.total(),
            statuses: statuses
                .map(|(status, count)| (status.name(), count))
                .collect(),
        }
    }
}

impl Report for UncertaintyReport<'_> {
    const COMMAND: &'static str = "uncertainty";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["done", "partial", "no-answer"];

    fn ending(&self) -> Ending {
        let all = &self.found.outcomes;
        let missing: Vec<_> = all
            .iter()
            .filter(|outcome| outcome.monte_carlo.is_none())
            .map(|outcome| outcome.of.name())
            .collect();
        Ending {
            status: share(all.len() - missing.len(), all.len()),
            message: (!missing.is_empty())
                .then(|| format!("no drive of the sample has {}", missing.join(", "))),
        }
    }

    /// The uncertainty of each outcome, the ellipses, and the distributions.
    fn document(&self, system: System) -> Document {
        let found = self.found;
        let inputs = found.inputs.iter().map(|input| {
            vec![
                input.parameter.name.into(),
                distribution_text(input, system),
            ]
        });
        let mut document = Document::default();
        document.paragraph(uncertain(found));
        for outcome in &found.outcomes {
            add_outcome(&mut document, outcome, found, system);
        }
        if !found.ellipses.is_empty() {
            document.add(ellipses(found, system));
        }
        let head = ["uncertain parameter", "distribution"];
        let distributions = DocumentBlock::Table(DocumentTable::new(head, inputs));
        document.add_detail(distributions, Detail::WithAll);
        document.list([Line::flush(format!(
            "{} ({}, seed {}): {}",
            counted(self.drives, "drive"),
            counted(found.plan.samples as u64, "point"),
            found.plan.seed,
            found.status_counts
        ))]);
        document
    }
}

/// The uncertain parameters, by name if they are few.
fn uncertain(found: &Uncertainty) -> String {
    /// The largest number of parameters that are named.
    const NAMED: usize = 4;
    let names: Vec<_> = found
        .inputs
        .iter()
        .map(|input| input.parameter.name)
        .collect();
    if names.len() > NAMED {
        return format!("{} parameters are uncertain", names.len());
    }
    format!(
        "uncertain: {}; all other values count as known",
        names.join(", ")
    )
}

/// A distribution in words, such as "normal: 110 mph ± 0.5 mph" or "truncated normal: 110 mph ± 4
/// mph, cut at 105 mph and 115 mph".
pub(super) fn distribution_text(input: &Uncertain, system: System) -> String {
    let show = |value: f64| shown::stated(input.parameter, value, system);
    let spread = |value: f64| shown::stated_difference(input.parameter, value, system);
    let normal =
        |mean: f64, deviation: f64| format!("normal: {} ± {}", show(mean), spread(deviation));
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
            other.name(),
            other
                .numbers()
                .into_iter()
                .map(show)
                .collect::<Vec<_>>()
                .join(" .. ")
        ),
    }
}

fn add_outcome(
    document: &mut Document,
    outcome: &OutcomeUncertainty,
    found: &Uncertainty,
    system: System,
) {
    let of = outcome.of;
    if let Some(sampled) = outcome.monte_carlo.as_ref().filter(|_| !outcome.varies) {
        let mean = shown::outcome(of, sampled.mean.value, system);
        let why = match (depends(outcome, found), found.inputs.len()) {
            (true, _) => "it varies by less than rounding, since the uncertainty is so small",
            (false, 1) => "it does not depend on the uncertain parameter",
            (false, _) => "it does not depend on any of the uncertain parameters",
        };
        document.list([Line::flush(format!(
            "{} is {mean} in every drive: {why}",
            of.name()
        ))]);
        return;
    }
    document.add(moments(outcome, found, system));
    // a small sample has no shares
    let Some(sampled) = (outcome.monte_carlo.as_ref()).filter(|found| found.quantiles.is_some())
    else {
        return;
    };
    document.list(shares_lines(outcome, system));
    let table = shares(outcome, sampled.rows_left_out, found);
    document.add_detail(DocumentBlock::Table(table), Detail::WithAll);
}

/// Mean and standard deviation of an outcome, by each method.
fn moments(outcome: &OutcomeUncertainty, found: &Uncertainty, system: System) -> DocumentTable {
    let of = outcome.of;
    let value = |value: f64| shown::outcome(of, value, system);
    let spread = |value: f64| shown::difference(of, value, system);
    let row = |words: &str, m: DeltaMoments| {
        vec![words.into(), value(m.mean), spread(m.standard_uncertainty)]
    };
    let mut rows = vec![];
    rows.extend(outcome.delta.map(|first| row("by the gradient", first)));
    let second = outcome.second_order;
    rows.extend(second.map(|second| row("by gradient and Hessian", second)));
    let mut remarks = vec![];
    if let Some(sampled) = &outcome.monte_carlo {
        let (mean, deviation) = (sampled.mean, sampled.standard_uncertainty);
        rows.push(vec![
            "by the sample".into(),
            value(mean.value),
            spread(deviation.value),
        ]);
        let condition = match of.group() {
            OutcomeGroup::Flight if found.part_without_landing() > 0.0 => ", if the ball lands",
            _ => "",
        };
        remarks.extend(sampled.quantiles.map(|quantiles| {
            let [low, middle, high] = quantiles.map(value);
            format!("95 % probability: {low} to {high}{condition}; median {middle}")
        }));
        let intervals = mean.interval().zip(deviation.interval());
        remarks.extend(intervals.map(|(mean, deviation)| {
            format!(
                "95 % intervals of the sample: mean {} to {}, standard deviation {} to {}",
                value(mean.low),
                value(mean.high),
                spread(deviation.low),
                spread(deviation.high)
            )
        }));
    } else {
        remarks.push("no drive of the sample has this outcome".into());
    }
    let mut table =
        DocumentTable::new([of.name(), "mean", "standard deviation"], rows).right([1, 2]);
    for remark in remarks {
        table.remark(remark);
    }
    table
}

/// Number of shares of the variance that a line lists.
const FIRST_SHARES: usize = 4;

/// Number of ellipses in a plain text without the option `all`. The first two are from the sample.
const FIRST_ELLIPSES: usize = 2;

/// Lines on an outcome: the largest shares of its variance, by uncertain parameter, and the
/// parameter to measure first.
fn shares_lines(outcome: &OutcomeUncertainty, system: System) -> Vec<Line> {
    let largest = by_share(outcome).into_iter().take(FIRST_SHARES);
    let shares: Vec<_> = largest
        .filter_map(|one| {
            let share = percent(one.total?.value);
            Some(format!("{} {share} %", one.parameter.name))
        })
        .collect();
    let shares = (!shares.is_empty()).then(|| {
        let of = outcome.of.name();
        format!(
            "shares of the variance of {of}, interactions included: {}",
            shares.join(", ")
        )
    });
    let first = outcome.measure_first.map(|first| {
        format!(
            "measure {} first: once it is known exactly, the standard deviation falls to {}",
            first.parameter.name,
            shown::difference(outcome.of, first.standard_uncertainty, system)
        )
    });
    shares.into_iter().chain(first).map(Line::item).collect()
}

/// The contributions of the uncertain parameters, the largest share of the variance first.
fn by_share(outcome: &OutcomeUncertainty) -> Vec<Contribution> {
    let total = |one: &Contribution| one.total.map_or(0.0, |total| total.value);
    let mut sorted = outcome.indices.clone();
    sorted.sort_by(|a, b| total(b).total_cmp(&total(a)));
    sorted
}

fn percent(share: f64) -> String {
    fixed(100.0 * share, 1)
}

/// The contributions of the uncertain parameters to the variance of an outcome, the largest first.
/// The shares ignore `left_out` sample points, because their drives do not have this outcome.
fn shares(outcome: &OutcomeUncertainty, left_out: usize, found: &Uncertainty) -> DocumentTable {
    let share = |share: Option<Interval>| {
        share.map_or(shown::NONE.into(), |i| {
            format!(
                "{} % ({} to {})",
                percent(i.value),
                percent(i.low),
                percent(i.high)
            )
        })
    };
    let rows = by_share(outcome).into_iter().map(|one| {
        vec![
            one.parameter.name.into(),
            share(one.first),
            share(one.total),
            share(one.bound),
        ]
    });
    let head = [
        "Sobol' share of the variance",
        "first-order index",
        "total index",
        "upper bound of total",
    ];
    let mut table = DocumentTable::new(head, rows).right([1, 2, 3]);
    table.remark(if found.inputs.len() > 1 {
        "estimates from the sample with 95 % intervals; the upper bound is estimated from the \
         slopes"
    } else {
        "of a single uncertain parameter the share is 100 %; the upper bound is estimated from \
         the slopes, with a 95 % interval"
    });
    let exceeds_bound = |one: &Contribution| one.bound.is_none() && one.mean_square_slope.is_some();
    if outcome.indices.iter().any(exceeds_bound) {
        table.remark(
            "no upper bound where it would lie below an index: the outcome jumps, or the sample is \
             too small",
        );
    }
    if left_out > 0 {
        let points = counted_of(
            left_out as u64,
            found.plan.samples as u64,
            ["point", "points"],
        );
        table.remark(format!(
            "these shares leave out {points} at which a drive does not have this outcome"
        ));
    }
    table
}

/// True if the outcome depends on an uncertain parameter at the means, or if the derivatives at the
/// means are unknown.
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

fn ellipses(found: &Uncertainty, system: System) -> DocumentTable {
    use crate::drive::Outcome::Carry;
    let angle = DisplayUnit {
        quantity: Quantity::ANGLE,
        unit: "deg",
    };
    let head = ["landing ellipse", "half-axes", "long axis points", "inside"];
    let rows = found.ellipses.iter().map(|sampled| {
        let [long, short] = sampled.ellipse.half_axes;
        let lengths =
            [long, short].map(|axis| shown::difference(Carry, axis[0].hypot(axis[1]), system));
        // an axis has two directions: choose the direction within 90° of downrange
        let turned = (long[0] * long[1].signum()).atan2(long[1].abs());
        vec![
            format!(
                "{} %, from the {}",
                100.0 * sampled.ellipse.share,
                match sampled.by {
                    EllipseSource::Gradient => "gradients",
                    EllipseSource::Sample => "sample",
                }
            ),
            lengths.join(" and "),
            shown::side(angle, turned, system),
            format!("{:.1} %", 100.0 * sampled.holds),
        ]
    });
    let mut table = DocumentTable::new(head, rows).right([1, 2, 3]);
    table.first_rows = FIRST_ELLIPSES;
    table
}
