use super::reply::{Reply, share};
use super::{json, shown, table::table};
use crate::derivative::Taylor;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use crate::units::{Message, System, per, significant};
use serde::Serialize;
use serde_json::{Map, Value};

/// Outcomes with their derivatives as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct GradientReport {
    /// Each outcome, in the order asked for.
    pub outcomes: Vec<OutcomeReport>,
}

/// An outcome with its derivatives as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct OutcomeReport {
    /// The outcome.
    pub of: &'static str,
    /// Its value; `null` where the drive has none.
    pub value: Value,
    /// Its derivative by each parameter.
    pub gradient: Option<Map<String, Value>>,
    /// Its second derivatives; `null` where they were not asked for.
    pub hessian: Option<HessianReport>,
    /// Why the drive has no such outcome; `null` where it has.
    pub message: Option<String>,
}

/// A symmetric matrix of second derivatives.
#[derive(Clone, Debug, Serialize)]
pub struct HessianReport {
    /// The parameters of its rows and columns.
    pub names: Vec<&'static str>,
    /// Its rows.
    pub values: Vec<Vec<Value>>,
}

impl HessianReport {
    /// A matrix with the parameters of its rows and columns.
    pub(super) fn new(names: Vec<&'static str>, values: &[Vec<f64>]) -> Self {
        let row = |row: &Vec<f64>| row.iter().map(|entry| json::number(Some(*entry))).collect();
        Self {
            names,
            values: values.iter().map(row).collect(),
        }
    }
}

impl GradientReport {
    /// The answer of `gradient`: each outcome with its derivatives, or why there are none.
    ///
    /// # Panics
    /// Where an outcome has not as many derivatives as there are parameters.
    pub fn reply(
        found: &[(Outcome, Result<Taylor>)],
        wrt: &[&'static Parameter],
        warnings: Vec<Message>,
    ) -> Reply<Self> {
        let mut missing: Vec<_> = found
            .iter()
            .filter_map(|(_, taylor)| taylor.as_ref().err())
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
        let message = missing
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("; ");
        let outcomes = found
            .iter()
            .map(|(of, taylor)| OutcomeReport::new(*of, wrt, taylor))
            .collect();
        let message = (!missing.is_empty()).then_some(message);
        Reply::done("gradient", warnings, Self { outcomes }).ended(status, message)
    }
}

impl OutcomeReport {
    fn new(of: Outcome, wrt: &[&'static Parameter], taylor: &Result<Taylor>) -> Self {
        let names: Vec<&str> = wrt.iter().map(|parameter| parameter.name).collect();
        let taylor = match taylor {
            Ok(taylor) => {
                taylor.expect_derivatives_by(wrt.len(), "parameters");
                taylor
            }
            Err(why) => {
                let message = Some(why.to_string());
                return Self {
                    of: of.name(),
                    value: Value::Null,
                    gradient: None,
                    hessian: None,
                    message,
                };
            }
        };
        let gradient = names
            .iter()
            .copied()
            .zip(taylor.gradient.iter().map(|d| Some(*d)));
        Self {
            of: of.name(),
            value: json::number(Some(taylor.value)),
            gradient: Some(json::named(gradient)),
            hessian: (!taylor.hessian.is_empty())
                .then(|| HessianReport::new(names, &taylor.hessian)),
            message: None,
        }
    }
}

/// An outcome with its gradient, and Hessian if there is one, as text; derivatives also in SI, to
/// twelve digits.
///
/// # Panics
/// Where there are not as many derivatives as parameters.
pub fn gradient_text(
    of: Outcome,
    wrt: &[&'static Parameter],
    taylor: &Taylor,
    system: System,
) -> String {
    taylor.expect_derivatives_by(wrt.len(), "parameters");
    let si = of.quantity().si;
    let settled =
        |d: f64, by: &[&Parameter]| shown::settled(d, taylor.value, (of.quantity(), of.unit()), by);
    let rows = wrt.iter().zip(&taylor.gradient).map(|(parameter, slope)| {
        let in_si = significant(settled(*slope, &[*parameter]), 12);
        vec![
            parameter.name.into(),
            shown::slope(of, taylor.value, parameter, *slope, system, 6),
            format!("{in_si} {}", per(si, parameter.quantity.si))
                .trim_end()
                .to_owned(),
        ]
    });
    let gradient = table(&["by", &format!("d {}", of.name()), "SI"], &[1, 2], rows);
    let exact = format!(
        "{} {si}",
        significant(
            if shown::is_rounding(of, 0.0, taylor.value) {
                0.0
            } else {
                taylor.value
            },
            15
        )
    );
    let value = format!(
        "{} = {}; in SI {}\n\n",
        of.name(),
        shown::both(of, taylor.value, system),
        exact.trim_end()
    );
    if taylor.hessian.is_empty() {
        return value + &gradient;
    }
    let head: Vec<&str> = std::iter::once("Hessian, SI")
        .chain(wrt.iter().map(|parameter| parameter.name))
        .collect();
    let right: Vec<usize> = (1..head.len()).collect();
    let rows = wrt.iter().zip(&taylor.hessian).map(|(parameter, row)| {
        let seconds = row
            .iter()
            .zip(wrt)
            .map(|(d, by)| significant(settled(*d, &[*parameter, *by]), 10));
        std::iter::once(parameter.name.to_owned())
            .chain(seconds)
            .collect()
    });
    format!("{value}{gradient}\n{}", table(&head, &right, rows))
}
