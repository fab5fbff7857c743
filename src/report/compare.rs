use super::lines::{item, paragraph};
use super::reply::{Reply, share};
use super::table::table;
use super::{drive, json, shown};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup, UNSET};
use crate::study::{Cause, Comparison, Difference, Share, Shares};
use crate::units::{Message, System};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// Two drives and their differences as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct ComparisonReport {
    /// The first drive: `setup`, `launch` and `flight`.
    pub a: Value,
    /// The second drive.
    pub b: Value,
    /// The outcomes asked for, in their order.
    pub outcomes: Vec<DifferenceReport>,
}

/// The difference of an outcome as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct DifferenceReport {
    /// The outcome.
    pub of: &'static str,
    /// Its value in each drive; `null` where there is no comparison.
    pub values: Option<[Value; 2]>,
    /// What b has more than a.
    pub difference: Value,
    /// The difference by the parameters that differ.
    pub by_parameter: Option<Map<String, Value>>,
    /// The difference by launch conditions and what else the flight depends on; `null` for an
    /// outcome of the launch, and where the launches are given, so that these are the parameters.
    pub by_launch: Option<Map<String, Value>>,
    /// Why there is no comparison; `null` where there is one.
    pub message: Option<String>,
}

impl ComparisonReport {
    /// The answer of `compare`.
    pub fn reply(
        comparison: &Comparison,
        found: &[(Outcome, Result<Difference>)],
        warnings: Vec<Message>,
    ) -> Reply<Self> {
        let mut missing: Vec<_> = found
            .iter()
            .filter_map(|(_, difference)| difference.as_ref().err())
            .collect();
        let status = match (
            share(found.len() - missing.len(), found.len()),
            missing.first(),
        ) {
            // where all of them lack the same, that is the answer
            ("no-answer", Some(first))
                if missing.iter().all(|why| why.status() == first.status()) =>
            {
                first.status()
            }
            (status, _) => status,
        };
        missing.dedup_by_key(|why| why.to_string());
        let mut said: Vec<_> = missing.iter().map(ToString::to_string).collect();
        said.extend((!comparison.differs()).then(|| NOTHING.into()));
        let side = |side: usize| {
            let of = &comparison.drives[side];
            json!({ "setup": json::setup(&comparison.setups[side]), "launch": drive::launch(of), "flight": drive::flight(of) })
        };
        let outcomes = found
            .iter()
            .map(|(of, difference)| DifferenceReport::new(*of, difference))
            .collect();
        let message = (!said.is_empty()).then(|| said.join("; "));
        Reply::done(
            "compare",
            warnings,
            Self {
                a: side(0),
                b: side(1),
                outcomes,
            },
        )
        .ended(status, message)
    }
}

impl DifferenceReport {
    fn new(of: Outcome, difference: &Result<Difference>) -> Self {
        let of = of.name();
        match difference {
            Ok(found) => Self {
                of,
                values: Some(found.values.map(|value| json::number(Some(value)))),
                difference: json::number(Some(found.amount())),
                by_parameter: Some(shares(&found.by_parameter)),
                by_launch: found.by_launch.as_ref().map(shares),
                message: None,
            },
            Err(why) => Self {
                of,
                values: None,
                difference: Value::Null,
                by_parameter: None,
                by_launch: None,
                message: Some(why.to_string()),
            },
        }
    }
}

fn shares(split: &Shares) -> Map<String, Value> {
    let value = |cause: Cause, setup: &Setup<f64>| match cause {
        Cause::Number(parameter) | Cause::AtOnce(parameter) => json::number(setup.value(parameter)),
        Cause::Law | Cause::Golfer | Cause::SpeedOf | Cause::Launch => json!(choice(cause, setup)),
        Cause::Ways(ways) => {
            let given = ways.given_in(setup).into_iter();
            given
                .map(|parameter| (parameter.name, json::number(setup.value(parameter))))
                .collect()
        }
    };
    let each = split.shares.iter().map(|Share { cause, amount }| {
        json!({
            "cause": cause.name(),
            "values": split.setups.each_ref().map(|setup| value(*cause, setup)),
            "share": json::number(Some(*amount)),
            "at_once": cause.is_at_once(),
        })
    });
    let [remainder, error] =
        [split.remainder, split.error].map(|amount| json::number(Some(amount)));
    let entries = [
        ("shares", each.collect()),
        ("remainder", remainder),
        ("integration_error", error),
    ];
    entries
        .into_iter()
        .map(|(name, entry)| (name.to_owned(), entry))
        .collect()
}

/// What a setup has of a choice.
fn choice(cause: Cause, setup: &Setup<f64>) -> &'static str {
    match cause {
        Cause::Golfer => setup.golfer.name(),
        Cause::SpeedOf => setup.speed_of.name(),
        Cause::Law => setup
            .law
            .table()
            .map_or(setup.law.name(), |table| table.file()),
        _ if setup.launch.is_given() => "given",
        _ => "struck by a club",
    }
}

const NOTHING: &str = "nothing differs: a and b are the same drive";

/// The outcomes of two drives beside each other as text; `titles` say what the drives are.
pub fn comparison_text(comparison: &Comparison, titles: [String; 2], system: System) -> String {
    let rows = Outcome::ALL.iter().filter_map(|of| {
        let values = comparison.drives.each_ref().map(|drive| of.value(drive));
        let change = match values {
            [None, None] => return None,
            [Some(a), Some(b)] => {
                let change = of.unwrap_angle(b, a) - a;
                shown::change(
                    *of,
                    if shown::is_rounding(*of, a, change) {
                        0.0
                    } else {
                        change
                    },
                    system,
                )
            }
            _ => shown::NONE.into(),
        };
        let [a, b] = values.map(|value| shown::outcome_or_dash(*of, value, system));
        Some(vec![shown::words(of.name()), a, b, change])
    });
    let [a, b] = titles;
    let text = paragraph(&format!("a: {a}")) + &paragraph(&format!("b: {b}"));
    let text = text + "\n" + &table(&["", "a", "b", "difference"], &[1, 2, 3], rows);
    if comparison.differs() {
        text
    } else {
        format!("{text}\n{}", paragraph(NOTHING))
    }
}

/// The difference of an outcome, split into its causes, as text: the largest share first.
pub fn difference_text(difference: &Difference, system: System) -> String {
    let Difference {
        of,
        values,
        by_parameter,
        by_launch,
    } = difference;
    let [a, b] = values.map(|value| shown::outcome(*of, value, system));
    let amount = shown::change(*of, difference.amount(), system);
    let mut text = paragraph(&format!(
        "{}: {amount}, from {a} to {b}",
        shown::words(of.name())
    ));
    text += &shares_text("by parameter", difference, by_parameter, system);
    if let Some(by_launch) = by_launch {
        text += &shares_text("by launch and air", difference, by_launch, system);
    }
    text
}

fn shares_text(title: &str, difference: &Difference, split: &Shares, system: System) -> String {
    let of = difference.of;
    let is_rounding = |amount: f64| shown::is_rounding(of, difference.values[0], amount);
    let (without, mut with): (Vec<&Share>, Vec<&Share>) = split
        .shares
        .iter()
        .partition(|share| is_rounding(share.amount));
    with.sort_by(|a, b| b.amount.abs().total_cmp(&a.amount.abs()));
    let rows = with.iter().map(|share| {
        let [a, b] = split
            .setups
            .each_ref()
            .map(|setup| cell(share.cause, setup, system));
        vec![
            share.cause.name().into(),
            a,
            b,
            shown::change(of, share.amount, system),
        ]
    });
    let mut text = if with.is_empty() {
        format!("\n{}", item(title))
    } else {
        format!("\n{}", table(&[title, "a", "b", "share"], &[1, 2, 3], rows))
    };
    let names = |causes: &mut dyn Iterator<Item = Cause>| {
        causes.map(Cause::name).collect::<Vec<_>>().join(", ")
    };
    if !without.is_empty() {
        text += &item(&format!(
            "without a share: {}",
            names(&mut without.iter().map(|share| share.cause))
        ));
    }
    let mut at_once = with
        .iter()
        .map(|share| share.cause)
        .filter(|cause| cause.is_at_once())
        .peekable();
    if at_once.peek().is_some() {
        text += &item(&format!(
            "changed at once, halfway between a and b, since there are no values between: {}",
            names(&mut at_once)
        ));
    }
    let remainder = shown::change(of, split.remainder, system);
    // without a sign it reads as 0
    if remainder.starts_with(['+', '-']) && !is_rounding(split.remainder) {
        let why = if split.remainder.abs() <= split.error {
            let error = shown::spread(of, split.error, system);
            format!("the shares are integrals between a and b, computed within {error}")
        } else {
            "there is a corner of the model between a and b".into()
        };
        text += &item(&format!("not in these shares: {remainder}; {why}"));
    }
    text
}

/// What a cause is in one of the drives.
fn cell(cause: Cause, setup: &Setup<f64>, system: System) -> String {
    match cause {
        Cause::Number(parameter) | Cause::AtOnce(parameter) => stated(parameter, setup, system),
        Cause::Law | Cause::Golfer | Cause::SpeedOf | Cause::Launch => choice(cause, setup).into(),
        Cause::Ways(ways) => {
            let line = |parameter: &&'static Parameter| {
                let name = parameter.name.rsplit('.').next().unwrap_or(parameter.name);
                format!("{name} {}", stated(parameter, setup, system))
            };
            ways.given_in(setup)
                .iter()
                .map(line)
                .collect::<Vec<_>>()
                .join("\n")
        }
    }
}

fn stated(parameter: &Parameter, setup: &Setup<f64>, system: System) -> String {
    setup.value(parameter).map_or_else(
        || UNSET.into(),
        |value| shown::stated(parameter, value, system),
    )
}
