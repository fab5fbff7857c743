use super::document::{Document, DocumentTable, Line};
use super::drive::{LaunchReport, flight, launch};
use super::json::{ByName, JsonNumber, Settings, settings};
use super::reply::{Ending, Report};
use super::shown;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use crate::study::{Cause, CauseValue, Comparison, Difference, Share, Shares};
use crate::units::System;
use serde::Serialize;

const NOTHING: &str = "nothing differs: a and b are the same drive";

/// Two drives and their differences, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ComparisonReport<'a> {
    #[serde(skip)]
    comparison: &'a Comparison,
    #[serde(skip)]
    found: &'a [(Outcome, Result<Difference>)],
    #[serde(skip)]
    titles: [String; 2],
    /// The first drive, as computed.
    pub a: ComparedDrive,
    /// The second drive, as computed.
    pub b: ComparedDrive,
    /// The differences of the requested outcomes, in the order of the request.
    pub outcomes: Vec<DifferenceReport>,
}

/// A drive of a comparison.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ComparedDrive {
    /// Every parameter by its dotted name.
    pub setup: Settings,
    /// The launch.
    pub launch: LaunchReport,
    /// The outcomes of the flight; `null` if the ball does not land.
    #[cfg_attr(test, schemars(schema_with = "super::drive::flight_schema"))]
    pub flight: Option<ByName<JsonNumber>>,
}

/// The difference of an outcome between two drives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DifferenceReport {
    /// The outcome.
    pub of: Outcome,
    /// The value of the outcome in each drive, SI; `null` if the drives cannot be compared.
    pub values: Option<[JsonNumber; 2]>,
    /// The value of b minus the value of a, SI.
    pub difference: JsonNumber,
    /// The shares of the parameters that differ; `null` if the drives cannot be compared.
    pub by_parameter: Option<Shares>,
    /// The shares of the launch conditions and of the other inputs of the flight. `null` if the
    /// drives cannot be compared, or if `of` is an outcome of the launch. Also `null` if the setups
    /// state the launch: then `by_parameter` has these shares.
    pub by_launch: Option<Shares>,
    /// The reason why the drives cannot be compared; `null` if they can.
    pub message: Option<String>,
}

impl<'a> ComparisonReport<'a> {
    /// The report of a comparison; `titles` describe the drives.
    pub fn new(
        comparison: &'a Comparison,
        found: &'a [(Outcome, Result<Difference>)],
        titles: [String; 2],
    ) -> Self {
        let [a, b] = [0, 1].map(|side| {
            let drive = &comparison.drives[side];
            ComparedDrive {
                setup: settings(&comparison.setups[side]),
                launch: launch(drive),
                flight: flight(drive),
            }
        });
        let outcomes = found
            .iter()
            .map(|(of, difference)| DifferenceReport::new(*of, difference))
            .collect();
        Self {
            comparison,
            found,
            titles,
            a,
            b,
            outcomes,
        }
    }
}

impl DifferenceReport {
    fn new(of: Outcome, difference: &Result<Difference>) -> Self {
        match difference {
            Ok(found) => Self {
                of,
                values: Some(found.values.map(JsonNumber::from)),
                difference: found.amount().into(),
                by_parameter: Some(found.by_parameter.clone()),
                by_launch: found.by_launch.clone(),
                message: None,
            },
            Err(why) => Self {
                of,
                values: None,
                difference: JsonNumber(None),
                by_parameter: None,
                by_launch: None,
                message: Some(why.to_string()),
            },
        }
    }
}

impl Report for ComparisonReport<'_> {
    const COMMAND: &'static str = "compare";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = Ending::STATUSES_OF_EACH;

    fn ending(&self) -> Ending {
        let errors = self.found.iter().map(|(_, found)| found.as_ref().err());
        let ending = Ending::of_each(errors);
        if self.comparison.differs() {
            return ending;
        }
        let message = ending.message.into_iter().chain([NOTHING.into()]);
        Ending {
            message: Some(message.collect::<Vec<_>>().join("; ")),
            ..ending
        }
    }

    /// The requested differences, the outcomes of the two drives, then the shares of each
    /// difference.
    fn document(&self, system: System) -> Document {
        let [a, b] = &self.titles;
        let mut document = Document::default();
        document.list([
            Line::flush(format!("a: {a}")),
            Line::flush(format!("b: {b}")),
        ]);
        if !self.comparison.differs() {
            document.paragraph(NOTHING);
            document.add(outcomes(self.comparison, system));
            return document;
        }
        let differences = || {
            self.found
                .iter()
                .filter_map(|(_, found)| found.as_ref().ok())
        };
        document.list(differences().map(|found| difference_line(found, system)));
        document.add(outcomes(self.comparison, system));
        for difference in differences() {
            let of = shown::words(difference.of.name());
            let title = format!("difference of {of} by parameter");
            let by_parameter = &difference.by_parameter;
            add_shares(&mut document, &title, difference, by_parameter, system);
            if let Some(by_launch) = &difference.by_launch {
                let title = format!("difference of {of} by launch and air");
                add_shares(&mut document, &title, difference, by_launch, system);
            }
        }
        let off_centre = self.comparison.setups.iter().find_map(shown::gear_effect);
        document.list(off_centre.map(Line::flush));
        document
    }
}

/// The difference of an outcome: "carry: -18.47 yd, from 286.0 yd to 267.5 yd".
fn difference_line(difference: &Difference, system: System) -> Line {
    let of = difference.of;
    let [a, b] = difference
        .values
        .map(|value| shown::outcome(of, value, system));
    let amount = shown::change(of, difference.amount(), system);
    let name = shown::words(of.name());
    Line::flush(format!("{name}: {amount}, from {a} to {b}"))
}

/// The outcomes of two drives, and their differences.
fn outcomes(comparison: &Comparison, system: System) -> DocumentTable {
    let rows = Outcome::OF_DRIVES.iter().filter_map(|of| {
        let values = comparison.drives.each_ref().map(|drive| of.value(drive));
        let change = match values {
            [None, None] => return None,
            [Some(a), Some(b)] => {
                let change = of.change(a, b);
                let is_rounding = shown::is_rounding(*of, a, change);
                shown::change(*of, if is_rounding { 0.0 } else { change }, system)
            }
            _ => shown::NONE.into(),
        };
        let [a, b] = values.map(|value| shown::outcome_or_dash(*of, value, system));
        Some(vec![shown::words(of.name()), a, b, change])
    });
    DocumentTable::new(["", "a", "b", "difference"], rows).right([1, 2, 3])
}

/// Adds the shares of a difference to a document, the largest first. A difference with a single
/// cause becomes a line of text.
fn add_shares(
    document: &mut Document,
    title: &str,
    difference: &Difference,
    split: &Shares,
    system: System,
) {
    let of = difference.of;
    let (with, without) = by_size(difference, split);
    if let ([only], []) = (&with[..], &without[..]) {
        let values = only.values.each_ref();
        let [a, b] = values.map(|value| cell(only.cause, value, system).replace('\n', ", "));
        let cause = only.cause.name();
        document.list([Line::flush(format!(
            "{title}: all of it from {cause}, {a} → {b}"
        ))]);
        return;
    }

    let mut remarks = share_remarks(&without, &with);
    remarks.extend(remainder_text(difference, split, system));
    if with.is_empty() {
        let remarks = remarks.into_iter().map(Line::item);
        document.list([Line::item(title)].into_iter().chain(remarks));
        return;
    }
    let rows = with.iter().map(|share| {
        let values = share.values.each_ref();
        let [a, b] = values.map(|value| cell(share.cause, value, system));
        vec![
            share.cause.name().into(),
            a,
            b,
            shown::change(of, share.amount, system),
        ]
    });
    let mut table = DocumentTable::new([title, "a", "b", "share"], rows).right([1, 2, 3]);
    for remark in remarks {
        table.remark(remark);
    }
    document.add(table);
}

/// The shares of a split, the largest first, and those that are only rounding errors.
pub(super) fn by_size<'a>(
    difference: &Difference,
    split: &'a Shares,
) -> (Vec<&'a Share>, Vec<&'a Share>) {
    let [value, _] = difference.values;
    let is_share = |share: &&Share| !shown::is_rounding(difference.of, value, share.amount);
    let (mut with, without): (Vec<&Share>, Vec<&Share>) = split.shares.iter().partition(is_share);
    with.sort_by(|a, b| b.amount.abs().total_cmp(&a.amount.abs()));
    (with, without)
}

/// Remarks on the causes `without` a share of a difference, and on the discrete causes among
/// `with`, which change in one step.
fn share_remarks(without: &[&Share], with: &[&Share]) -> Vec<String> {
    let mut remarks = vec![];
    if !without.is_empty() {
        let causes = names(without.iter().map(|share| share.cause));
        remarks.push(format!("without a share: {causes}"));
    }
    let at_once = with.iter().filter(|share| share.at_once);
    let at_once = names(at_once.map(|share| share.cause));
    if !at_once.is_empty() {
        remarks.push(format!(
            "changed in one step, halfway between a and b, since there are no values between: \
             {at_once}"
        ));
    }
    remarks
}

/// The text about the remainder: the part of a difference that belongs to no share. `None` if the
/// remainder is displayed as 0 or is a rounding error.
fn remainder_text(difference: &Difference, split: &Shares, system: System) -> Option<String> {
    let of = difference.of;
    let remainder = shown::change(of, split.remainder, system);
    // `shown::change` writes no sign if it displays 0
    let is_shown = remainder.starts_with(['+', '-']);
    if !is_shown || shown::is_rounding(of, difference.values[0], split.remainder) {
        return None;
    }
    let why = if split.is_within_error() {
        let error = shown::difference(of, split.error, system);
        format!("the shares are integrals between a and b, each computed within {error}")
    } else {
        "there is a corner of the model between a and b".into()
    };
    Some(format!("not in these shares: {remainder}; {why}"))
}

fn names(causes: impl Iterator<Item = Cause>) -> String {
    causes.map(Cause::name).collect::<Vec<_>>().join(", ")
}

/// The value of a cause in one of the two drives. A quantity that may be stated in several ways has
/// a line for each parameter that states it.
fn cell(cause: Cause, value: &CauseValue, system: System) -> String {
    let stated = |parameter: &Parameter, number: &JsonNumber| {
        shown::setup_value(parameter, number.0, system, shown::STATED)
    };
    match (cause, value) {
        (Cause::Continuous(parameter) | Cause::Discrete(parameter), CauseValue::Number(number)) => {
            stated(parameter, number)
        }
        (_, CauseValue::Choice(name)) => (*name).into(),
        (_, CauseValue::Numbers(numbers)) => {
            let lines = numbers.iter().map(|(parameter, number)| {
                let name = parameter.name.rsplit('.').next().unwrap_or(parameter.name);
                format!("{name} {}", stated(parameter, number))
            });
            lines.collect::<Vec<_>>().join("\n")
        }
        // only a parameter has a single number
        (_, CauseValue::Number(_)) => String::new(),
    }
}
