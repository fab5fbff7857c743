//! Reports on a search over swings: the goals with the best design and with other designs, and the
//! uncertainty of the optimum.

use super::document::{DocumentTable, Line};
use super::json::{ByName, JsonNumber};
use super::limits::{ended_at, limited_value};
use super::shown;
use crate::drive::Outcome;
use crate::study::Optimum;
use crate::study::swings::{
    BootstrapOptimum, GoalError, Measure, Nominal, Rule, SamplingError, Scenarios, SwingsAnalysis,
};
use crate::units::{System, counted, significant};
use serde::Serialize;

/// The swings of a search as JSON.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ScenariosReport {
    /// The parameters that vary from swing to swing.
    pub parameters: Vec<&'static str>,
    /// The number of swings.
    pub scenarios: usize,
    /// The rule that generates the swings: `quadrature` (Gauss's rule), `sequence` (a scrambled
    /// Sobol' sequence) or `recorded`.
    #[cfg_attr(test, schemars(extend("enum" = ["quadrature", "sequence", "recorded"])))]
    pub rule: &'static str,
    /// The seed of the sequence; `null` for other rules.
    pub seed: Option<u32>,
}

impl ScenariosReport {
    pub(super) fn new(of: &Scenarios) -> Self {
        let seed = match of.rule {
            Rule::Sequence { seed, .. } => Some(seed),
            Rule::Quadrature(_) | Rule::Recorded => None,
        };
        let parameters = of.parameters.iter().map(|parameter| parameter.name);
        Self {
            parameters: parameters.collect(),
            scenarios: of.points.len(),
            rule: of.rule.name(),
            seed,
        }
    }
}

/// Additional results over swings, as JSON.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct StudiesReport {
    /// The swings.
    #[serde(flatten)]
    pub scenarios: ScenariosReport,
    /// The values of the goals at the design before the search, SI; `null` if the ball does not fly
    /// in one of the swings.
    pub as_set_up: Option<ByName<JsonNumber>>,
    /// The best design for the mean swing; `null` without an optimum, or if the ball of the mean
    /// swing does not fly.
    pub nominal: Option<NominalReport>,
    /// Sentences about results that could not be computed.
    pub unknown: Vec<String>,
    /// The estimated error of the objective, SI: twice the change of the objective if Gauss's rules
    /// have 1.5 times as many nodes; `null` for other rules.
    pub quadrature_error: Option<f64>,
    /// The 99 % interval of the objective over all swings, from independent sequences of swings;
    /// `null` without these sequences.
    pub sampling: Option<SamplingError>,
    /// The fraction of the swings whose ball ends where the table of expected strokes is
    /// extrapolated, 0 to 1; `null` without such a table.
    pub beyond_strokes: Option<f64>,
    /// The optima of resamples of recorded swings, and the number of swings needed to distinguish
    /// the best design from the design before the search; `null` without resamples.
    pub resampled: Option<BootstrapOptimum>,
}

/// The best design for the mean swing.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct NominalReport {
    /// The varied parameters, SI.
    pub optimum: ByName<JsonNumber>,
    /// The values of the goals that the mean swing alone predicts, SI.
    pub promised: ByName<JsonNumber>,
    /// The values of the goals over all swings, SI; `null` if the ball does not fly in one of the
    /// swings.
    pub kept: Option<ByName<JsonNumber>>,
}

impl StudiesReport {
    /// The additional results of an optimum over swings.
    pub(super) fn new(best: &Optimum, analysis: Option<&SwingsAnalysis>) -> Self {
        let search = &best.search;
        let goals = |values: &[f64]| -> ByName<JsonNumber> {
            let names = search.goals().map(|goal| goal.expression.clone());
            names.zip(values.iter().copied()).collect()
        };
        let error = analysis.and_then(SwingsAnalysis::error);
        Self {
            scenarios: ScenariosReport::new(&search.scenarios),
            as_set_up: best.as_set_up.as_deref().map(goals),
            nominal: nominal(analysis).map(|nominal| NominalReport {
                optimum: ByName::of_varied(&search.vary, &nominal.design),
                promised: goals(&nominal.for_mean_swing),
                kept: nominal.over_swings.as_deref().map(goals),
            }),
            unknown: unknown(analysis),
            quadrature_error: match error {
                Some(GoalError::Quadrature(size)) => Some(*size),
                _ => None,
            },
            sampling: match error {
                Some(GoalError::Sampling(found)) => Some(*found),
                _ => None,
            },
            beyond_strokes: best.beyond_strokes,
            resampled: analysis.and_then(|analysis| analysis.resampled.clone()),
        }
    }
}

/// The best design for the mean swing.
pub(super) fn nominal(analysis: Option<&SwingsAnalysis>) -> Option<&Nominal> {
    analysis?.nominal.as_ref().ok()
}

/// Sentences about results that could not be computed.
fn unknown(analysis: Option<&SwingsAnalysis>) -> Vec<String> {
    let Some(analysis) = analysis else {
        return vec![];
    };
    let nominal = analysis.nominal.as_ref().err();
    let nominal =
        nominal.map(|why| format!("no comparison with the best design for the mean swing: {why}"));
    let error = match analysis.error() {
        Some(GoalError::Unknown(why)) => Some(format!(
            "the uncertainty of the best value is not known: the ball does not fly in one of the \
             golfer's other swings ({why})"
        )),
        _ => None,
    };
    nominal.into_iter().chain(error).collect()
}

/// Table of the goals over the swings, with a column for each design.
pub(super) fn goals(
    best: &Optimum,
    analysis: Option<&SwingsAnalysis>,
    system: System,
) -> DocumentTable {
    let search = &best.search;
    let nominal = nominal(analysis);
    let limits = search.subject_to.iter();
    let limits = limits.map(|limit| limit.message().in_units(system));
    let expressions = std::iter::once(search.of.expression.clone()).chain(limits);
    let rows = search.goals().zip(expressions).enumerate();
    let rows = rows.map(|(k, (goal, expression))| {
        let limit = k.checked_sub(1).map(|j| &search.subject_to[j]);
        let show = |value: f64| match limit {
            Some(limit) => limited_value(limit, value, system),
            None => shown::goal(goal, value, system),
        };
        let of = |values: Option<&Vec<f64>>| {
            values
                .map(|values| values[k])
                .filter(|value| value.is_finite())
                .map_or(shown::NONE.into(), show)
        };
        vec![
            expression,
            best.goals
                .as_ref()
                .map_or(shown::NONE.into(), |goals| show(goals[k])),
            of(nominal.and_then(|nominal| nominal.over_swings.as_ref())),
            of(nominal.map(|nominal| &nominal.for_mean_swing)),
            of(best.as_set_up.as_ref()),
        ]
    });
    let head = [
        "over all swings",
        ended_at(best.solution.status, "best"),
        "best for mean swing",
        "mean swing alone",
        "as set up",
    ];
    DocumentTable::new(head, rows).right(1..5)
}

/// Notes on the designs and on the uncertainty of the answer.
pub(super) fn notes(
    best: &Optimum,
    analysis: Option<&SwingsAnalysis>,
    system: System,
) -> Vec<Line> {
    let resamples = analysis.and_then(|analysis| analysis.resampled.as_ref());
    let mut notes = vec![];
    let strikes = best.search.scenarios.parameters.iter();
    let mut strikes = strikes.filter(|parameter| parameter.name.starts_with("strike."));
    if strikes.next().is_some() || best.setup.strike.toe != 0.0 {
        notes.push("the gear effect, and the scatter from it, is known to about 30 %".into());
    }
    notes.extend(designs(best, nominal(analysis)));
    notes.extend(smoothed_limits(best, system));
    notes.extend(measures_in_words(best));
    notes.push(sampling(best, analysis, system));
    if best.search.scenarios.rule == Rule::Recorded && resamples.is_none() && best.is_converged() {
        notes.push(
            "it is not known how well these swings determine the best design: the swings are \
             equal, or the searches of their resamples found no optimum"
                .into(),
        );
    }
    if let Some(found) = resamples {
        notes.extend(resampled(best, found, system));
    }
    notes.extend(unknown(analysis));
    notes.into_iter().map(Line::flush).collect()
}

/// Notes on designs that violate a limit, and on designs for which the ball does not fly in one of
/// the swings.
fn designs(best: &Optimum, nominal: Option<&Nominal>) -> Vec<String> {
    let kept = nominal.map(|nominal| nominal.over_swings.as_ref());
    let as_set_up = best.as_set_up.as_ref();
    let mut notes = vec![];
    let missed = |with: &str| format!("with {with} the ball does not fly in some of the swings");
    if kept.is_some_and(|kept| kept.is_none()) {
        notes.push(missed("the best design of the mean swing"));
    }
    if as_set_up.is_none() {
        notes.push(missed("the design as set up"));
    }
    let breaks = |goals: Option<&Vec<f64>>| {
        let limits = best.search.subject_to.iter();
        goals.is_some_and(|goals| {
            limits
                .zip(&goals[1..])
                .any(|(limit, value)| value.is_finite() && !limit.is_met(*value))
        })
    };
    let broken = |design: &str| {
        format!("{design} violates a limit, so it is no alternative to the best design")
    };
    if breaks(kept.flatten()) {
        notes.push(broken("the best design of the mean swing"));
    }
    if breaks(as_set_up) {
        notes.push(broken("the design as set up"));
    }
    notes
}

/// Notes on constraints that are met by the smoothed goal but violated by the exact goal.
fn smoothed_limits(best: &Optimum, system: System) -> Vec<String> {
    let all = best.constraints();
    let pairs = all.iter().zip(&best.solution.constraints);
    pairs
        .filter(|(limit, smoothed)| {
            let constraint = limit.constraint;
            constraint.is_met(smoothed.value) && !constraint.is_met(limit.at.value)
        })
        .map(|(limit, _)| {
            format!(
                "the search meets {} with smoothed kinks and jumps; the exact value over all \
                 swings violates it by {}: give a limit that is stricter by as much",
                limit.constraint.message().in_units(system),
                shown::goal_difference(&limit.constraint.goal, limit.at.violation.abs(), system)
            )
        })
        .collect()
}

/// Explains the measures that are means over a share of the swings, and the expected strokes.
fn measures_in_words(best: &Optimum) -> Vec<String> {
    let terms = best.search.goals().flat_map(|goal| &goal.terms);
    let mut notes: Vec<String> = vec![];
    for (_, measure) in terms {
        let of_share = |name: &str, of: &Outcome, share: &f64| {
            let percent = significant(100.0 * share, 4);
            let of = of.name();
            format!("{name}({of}, {percent}%): mean {of} of the {name} {percent} % of the swings")
        };
        let note = match measure {
            Measure::Lowest(of, share) => of_share("lowest", of, share),
            Measure::Highest(of, share) => of_share("highest", of, share),
            Measure::Strokes(strokes, _) => format!(
                "strokes: expected strokes to hole out after this drive, from where it {}",
                if strokes.runs() {
                    "comes to rest"
                } else {
                    "lands (no run)"
                }
            ),
            _ => continue,
        };
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    notes
}

/// The number of swings, the rule that chose them, and the uncertainty of the objective.
fn sampling(best: &Optimum, analysis: Option<&SwingsAnalysis>, system: System) -> String {
    let goal = &best.search.of;
    let all = &best.search.scenarios;
    let swings = counted(all.points.len() as u64, "swing");
    let taken = match all.rule {
        Rule::Recorded => "as recorded, with equal probability",
        Rule::Quadrature(_) => "by Gauss's rules",
        Rule::Sequence { .. } => "of a quasi-random sequence",
    };
    match analysis.and_then(SwingsAnalysis::error) {
        Some(GoalError::Quadrature(error)) => format!(
            "{swings} by Gauss's rules; the error of {} is about {}",
            goal.expression,
            shown::goal_difference(goal, *error, system)
        ),
        Some(GoalError::Sampling(SamplingError {
            interval,
            sequences,
        })) => format!(
            "{swings} {taken}; over infinitely many swings {} is {} to {} (99 % interval, from \
             {sequences} other quasi-random sequences){}",
            goal.expression,
            shown::goal(goal, interval.low, system),
            shown::goal(goal, interval.high, system),
            if matches!(all.rule, Rule::Sequence { .. }) {
                "; more `scenarios` make this interval narrower"
            } else {
                ""
            }
        ),
        Some(GoalError::Unknown(_)) | None => format!("{swings} {taken}"),
    }
}

/// Notes on the designs and gains that resamples of the recorded swings give, with intervals of
/// about 95 %.
fn resampled(best: &Optimum, found: &BootstrapOptimum, system: System) -> Vec<String> {
    let goal = &best.search.of;
    let design = best.search.vary.iter().zip(&found.design);
    let mut notes: Vec<String> = design
        .map(|(vary, (parameter, design))| {
            let show = |value: f64| shown::parameter(parameter, value, system);
            let clipped = match [design.low <= vary.low, design.high >= vary.high] {
                [false, false] => "",
                [true, true] => "; these swings do not determine it",
                _ => "; the interval is cut at an end of the range",
            };
            format!(
                "from these swings the best {} lies between {} and {} (about 95 %, {} \
                 resamples){clipped}",
                parameter.name,
                show(design.low),
                show(design.high),
                found.rounds
            )
        })
        .collect();
    let Some(gain) = &found.gain else {
        return notes;
    };
    let show = |value: f64| shown::goal_difference(goal, value, system);
    let better = format!(
        "the best design is better by {} (about 95 %: {} to {}) than the design as set up",
        show(gain.value),
        show(gain.low),
        show(gain.high)
    );
    let recorded = best.search.scenarios.points.len() as u64;
    notes.push(match found.swings_needed {
        Some(needed) if needed > recorded => format!(
            "{better}: about {needed} swings are needed to show the difference, {} more than \
             recorded",
            needed - recorded
        ),
        Some(_) if gain.low > 0.0 => {
            format!("{better}: these swings suffice to show the difference")
        }
        _ => better,
    });
    notes
}
