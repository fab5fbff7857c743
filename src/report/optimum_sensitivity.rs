use super::by_reason::by_reason;
use super::document::{Detail, Document, DocumentBlock, DocumentTable, Line};
use super::json::{ByName, JsonNumber};
use super::optimum::{
    OptimizeReport, add_convergence, add_varied_and_constraints, drive_lines, gain_lines,
    optima_document, optimum_document,
};
use super::reply::{Ending, Report};
use super::shown;
use crate::error::{Error, Result};
use crate::parameters::Parameter;
use crate::study::{
    Changed, Direction, Ellipse, Flatness, Optimum, OptimumAnalysis, PredictedEvent, Sensitivity,
};
use crate::units::{
    Digits, DisplayUnit, Message, System, is_zero, leading_number, printed, significant, with_unit,
};
use serde::Serialize;

/// An optimum with its sensitivities, directions, ellipses and stated changes, SI and radians.
/// These are `null` if the search did not converge.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OptimumSensitivityReport<'a> {
    #[serde(skip)]
    analysis: Option<&'a OptimumAnalysis>,
    #[serde(skip)]
    why: Option<&'a Error>,
    /// The optimum.
    #[serde(flatten)]
    pub search: OptimizeReport<'a>,
    /// The derivatives of the optimum by each parameter.
    pub sensitivity: Option<ByName<SensitivityOf>>,
    /// Directions in the space of the free parameters, in ascending order of the curvature of the
    /// objective.
    pub directions: Option<Vec<Direction>>,
    /// An ellipse for each pair of free parameters, on which the quadratic model of the objective
    /// has the allowed loss. The model ignores bounds. Empty if a constraint is active.
    pub ellipses: Option<Vec<Ellipse>>,
    /// The optima after stated changes: as the derivatives predict them, and from new searches.
    pub changes: Option<Vec<StatedChangeReport>>,
}

/// The derivatives of an optimum by a parameter p, or `null` with a `message`.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SensitivityOf {
    /// df*/dp, SI.
    pub value: JsonNumber,
    /// dx*/dp of each varied parameter, SI.
    pub optimum: Option<ByName<JsonNumber>>,
    /// d²f*/dp², SI.
    pub curvature: JsonNumber,
    /// The reason why the derivatives do not exist; `null` if they exist.
    pub message: Option<String>,
}

/// The effect of a stated change.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct StatedChangeReport {
    /// The parameter.
    pub parameter: &'static str,
    /// The change of the parameter, SI.
    pub change: f64,
    /// The optimum that the derivatives predict.
    pub predicted: PredictedOptimum,
    /// The result of a new search with the changed parameter.
    pub resolved: ResolvedOptimum,
    /// The first change of the active bounds and constraints that the derivatives predict; `null`
    /// without one.
    pub event: Option<PredictedEvent>,
    /// The actual changes of the active bounds and constraints. If no optimum was found: the
    /// reason.
    pub differences: Vec<Message>,
}

/// An optimum predicted from derivatives.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PredictedOptimum {
    /// The value of the objective to second order, SI.
    pub value: f64,
    /// The value of the objective to first order, SI.
    pub first_order: f64,
    /// The varied parameters at the optimum, SI.
    pub optimum: ByName<JsonNumber>,
}

/// The result of a new search after a change.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ResolvedOptimum {
    /// The status of the search.
    pub status: &'static str,
    /// The value of the objective, SI.
    pub value: JsonNumber,
    /// The varied parameters at the optimum, SI.
    pub optimum: Option<ByName<JsonNumber>>,
    /// The status in a sentence.
    pub message: Message,
}

impl<'a> OptimumSensitivityReport<'a> {
    /// The report of the optimum that `search` found. `analysis` is `None` if the search or the
    /// analysis failed; `why` is the error of a failed analysis.
    pub fn new(
        search: OptimizeReport<'a>,
        analysis: Option<&'a OptimumAnalysis>,
        why: Option<&'a Error>,
    ) -> Self {
        let best = &search.found.best;
        let sensitivity = analysis.map(|analysis| {
            let all = analysis.sensitivities.iter();
            all.map(|(parameter, found)| (parameter.name, SensitivityOf::new(best, found)))
                .collect()
        });
        let changes = analysis.map(|analysis| {
            let all = analysis.changes.iter();
            all.map(|changed| StatedChangeReport::new(best, changed))
                .collect()
        });
        Self {
            analysis,
            why,
            search,
            sensitivity,
            directions: analysis.map(|analysis| analysis.flatness.directions.clone()),
            ellipses: analysis.map(|analysis| analysis.flatness.ellipses.clone()),
            changes,
        }
    }
}

impl Report for OptimumSensitivityReport<'_> {
    const COMMAND: &'static str = "optimum-sensitivity";

    /// The status words of a search, then those of its analysis.
    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &{
        let mut all = [""; Optimum::STATUSES.len() + 2];
        let (search, analysis) = all.split_at_mut(Optimum::STATUSES.len());
        search.copy_from_slice(&Optimum::STATUSES);
        analysis.copy_from_slice(&["no-answer", "undefined"]);
        all
    };

    fn ending(&self) -> Ending {
        match (self.analysis, self.why) {
            // the `message` of each sensitivity has the reason
            (Some(analysis), _) if !analysis.is_answered() => Ending {
                status: "no-answer",
                message: Some("this optimum has none of the requested sensitivities".into()),
            },
            (None, Some(why)) => Ending {
                status: why.status(),
                message: Some(why.to_string()),
            },
            _ => self.search.ending(),
        }
    }

    /// The analysed optimum, or without an analysis the best end of the searches.
    fn document(&self, system: System) -> Document {
        let OptimizeReport {
            found: optima,
            analysis: over_swings,
            ..
        } = self.search;
        let Some(analysis) = self.analysis else {
            return optimum_document(&optima.best, over_swings, None, system);
        };
        let mut document = analysis_document(analysis, &optima.best, system);
        if optima.has_several_starts() {
            document.append(optima_document(optima, system));
        }
        document
    }
}

impl SensitivityOf {
    fn new(best: &Optimum, found: &Result<Sensitivity>) -> Self {
        match found {
            Ok(sensitivity) => Self {
                value: sensitivity.value.into(),
                optimum: Some(ByName::of_varied(&best.search.vary, &sensitivity.optimum)),
                curvature: sensitivity.curvature.into(),
                message: None,
            },
            Err(error) => Self {
                value: JsonNumber(None),
                optimum: None,
                curvature: JsonNumber(None),
                message: Some(error.to_string()),
            },
        }
    }
}

impl StatedChangeReport {
    fn new(best: &Optimum, changed: &Changed) -> Self {
        let (vary, resolved) = (&best.search.vary, &changed.resolved);
        let value = resolved.value();
        Self {
            parameter: changed.change.parameter.name,
            change: changed.change.delta,
            predicted: PredictedOptimum {
                value: changed.second_order,
                first_order: changed.first_order,
                optimum: ByName::of_varied(vary, &changed.predicted),
            },
            resolved: ResolvedOptimum {
                status: resolved.status(),
                value: value.into(),
                optimum: value.map(|_| ByName::of_varied(vary, &resolved.solution.x)),
                message: resolved.message(),
            },
            event: changed.event.clone(),
            differences: changed.differences.clone(),
        }
    }
}

/// The optimum with its flatness, the stated changes, and the sensitivities.
fn analysis_document(analysis: &OptimumAnalysis, best: &Optimum, system: System) -> Document {
    let mut document = Document::default();
    if let Some(drive) = &best.drive {
        document.list(gain_lines(best, drive, system));
    }
    add_varied_and_constraints(
        &mut document,
        best,
        Some(&analysis.flatness.windows_with(None)),
        system,
    );
    document.list(flatness_lines(best, &analysis.flatness, system));
    for changed in &analysis.changes {
        document.add(change(best, changed, system));
    }
    add_sensitivities(&mut document, best, &analysis.sensitivities, system);
    if let (Some(drive), Some(value)) = (&best.drive, best.value()) {
        let lines = drive_lines(best, value, drive, system);
        let flown = DocumentBlock::List(lines.into_iter().collect());
        document.add_detail(flown, Detail::WithAll);
    }
    add_convergence(&mut document, best, system);
    document
}

/// Number of sensitivities in a plain text without the option `all`.
const FIRST_SENSITIVITIES: usize = 12;

/// Adds the derivatives of the optimum by each parameter to a document. The rows are sorted by
/// |df*/dp| times the typical size of the parameter p, the largest first; f* is the optimal value.
fn add_sensitivities(
    document: &mut Document,
    best: &Optimum,
    sensitivities: &[(&'static Parameter, Result<Sensitivity>)],
    system: System,
) {
    let mut found: Vec<_> = sensitivities
        .iter()
        .filter_map(|(parameter, found)| Some((parameter, found.as_ref().ok()?)))
        .collect();
    let weight = |(parameter, found): &(&&Parameter, &Sensitivity)| {
        found.value.abs() * shown::typical_size(parameter)
    };
    found.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    let rows: Vec<Vec<String>> = found
        .into_iter()
        .map(|(parameter, found)| sensitivity_row(best, parameter, found, system))
        .collect();
    if !rows.is_empty() {
        let value = format!("best {}", best.search.outcome().name());
        let vary = best.search.vary.iter();
        let free = vary.filter(|vary| vary.low < vary.high);
        let optimum = free.map(|vary| format!("best {}", vary.parameter.name));
        let head: Vec<String> = ["per unit of".into(), value]
            .into_iter()
            .chain(optimum)
            .collect();
        let columns = head.len();
        let mut table = DocumentTable::new(head, rows).right(1..columns);
        table.caption = "change of the optimum for each unit of a parameter".into();
        table.first_rows = FIRST_SENSITIVITIES;
        document.add(table);
    }
    let why = |(parameter, found): &(&Parameter, Result<Sensitivity>)| {
        Some((parameter.name, found.as_ref().err()?.in_units(system)))
    };
    let left_out = by_reason(sensitivities.iter().filter_map(why));
    document.list(left_out.into_iter().map(Line::item));
}

fn sensitivity_row(
    best: &Optimum,
    parameter: &Parameter,
    sensitivity: &Sensitivity,
    system: System,
) -> Vec<String> {
    let of = best.search.outcome();
    let per_unit = |of: DisplayUnit, value: f64, slope: f64| {
        let slope = shown::zero_if_rounding(slope, value, of, &[parameter]);
        let number = shown::quotient(of, parameter, slope, system, 4);
        with_unit(&number, system.unit(of.unit))
    };
    let unit = match system.unit(parameter.unit) {
        "" => "1".into(),
        unit => printed(unit),
    };
    let value = best.value().unwrap_or_default();
    let mut cells = vec![
        format!("{} [{unit}]", parameter.name),
        per_unit(of.into(), value, sensitivity.value),
    ];
    let vary = best.search.vary.iter();
    let moves = vary.zip(&best.solution.x).zip(&sensitivity.optimum);
    let moves = moves.filter(|((vary, _), _)| vary.low < vary.high);
    cells.extend(moves.map(|((vary, x), slope)| per_unit(vary.parameter.into(), *x, *slope)));
    cells
}

/// Lines for the directions and for the ellipses. A direction of infinite reach is omitted, because
/// the quadratic model never has the stated loss along this direction.
fn flatness_lines(best: &Optimum, flatness: &Flatness, system: System) -> Vec<Line> {
    let loss = shown::difference(best.search.outcome(), flatness.loss, system);
    let directions = flatness
        .directions
        .iter()
        .filter(|direction| direction.reach.is_finite())
        .map(|direction| direction_line(best, direction, &loss, system));
    let ellipses = flatness
        .ellipses
        .iter()
        .map(|ellipse| ellipse_line(best, ellipse, &loss, system));
    directions.chain(ellipses).map(Line::item).collect()
}

/// An ellipse in words, such as "ellipse of club.loft and swing.attack_angle for a loss of 1.00 yd:
/// half-axes (+1.20 deg, -3.40 deg) and (…); drives around it lose 0.90 yd to 1.10 yd".
fn ellipse_line(best: &Optimum, ellipse: &Ellipse, loss: &str, system: System) -> String {
    let parameters = ellipse.parameters;
    let axis = |components: [f64; 2]| {
        let [first, second] =
            [0, 1].map(|row| shown::component(parameters[row], components[row], system));
        format!("({first}, {second})")
    };
    let of = best.search.outcome();
    let flown = ellipse
        .losses
        .map_or("part of it lies out of range".into(), |(least, most)| {
            let [least, most] = [least, most].map(|loss| shown::difference(of, loss, system));
            format!("drives around it lose {least} to {most}")
        });
    let [long, short] = ellipse.half_axes.map(axis);
    let [first, second] = parameters.map(|parameter| parameter.name);
    format!(
        "ellipse of {first} and {second} for a loss of {loss}, by the quadratic model, without \
         bounds and constraints: half-axes {long} and {short}; \
         {flown}"
    )
}

/// A direction in words, such as "changing club.loft by +1.20° and swing.attack_angle by -0.90° (or
/// the opposite way) loses 1.00 yd by the quadratic model, 0.98 yd and 1.03 yd when flown".
fn direction_line(best: &Optimum, direction: &Direction, loss: &str, system: System) -> String {
    let moves = direction.along.iter().filter(|(_, along)| *along != 0.0);
    let moves: Vec<_> = moves
        .map(|(parameter, along)| {
            let step = shown::component(parameter, along * direction.reach, system);
            (parameter, step)
        })
        .filter(|(_, step)| !is_zero(leading_number(step).trim_start_matches('+')))
        .map(|(parameter, step)| format!("{} by {step}", parameter.name))
        .collect();
    let of = best.search.outcome();
    let flown: Vec<_> = direction
        .losses
        .iter()
        .flatten()
        .map(|lost| shown::difference(of, *lost, system))
        .collect();
    let flown = if flown.is_empty() {
        "; both ends lie out of range".into()
    } else {
        format!(", {} when flown", flown.join(" and "))
    };
    format!(
        "changing {} (or the opposite way) loses {loss} by the quadratic model{flown}",
        moves.join(" and ")
    )
}

/// The optimum before and after a stated change.
fn change(best: &Optimum, changed: &Changed, system: System) -> DocumentTable {
    let (of, parameter) = (best.search.outcome(), changed.change.parameter);
    let row = |words: &str, value: Option<f64>, x: &[f64]| {
        // show one decimal more than usual, so that two close values can be compared
        let unit = system.unit(of.unit());
        let value = value.map_or(shown::NONE.into(), |value| {
            of.quantity().text(value, unit, Digits::Fine)
        });
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
    let delta = shown::stated_difference(parameter, changed.change.delta, system);
    // show the new value too: a change without a sign looks like a value
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
    let names = best.search.parameters().map(|parameter| parameter.name);
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
    let columns = head.len();
    let mut table = DocumentTable::new(head, rows).right(1..columns);
    if let Some(PredictedEvent { after, message }) = &changed.event {
        table.remark(format!(
            "predicted: {} after {} % of the change",
            message.in_units(system),
            significant(100.0 * after, 3)
        ));
    }
    for difference in &changed.differences {
        table.remark(format!("after the change: {}", difference.in_units(system)));
    }
    table
}
