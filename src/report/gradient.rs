use super::{json, shown, table::table};
use crate::derivative::Taylor;
use crate::drive::Outcome;
use crate::error::Error;
use crate::parameters::Parameter;
use crate::units::{System, per, significant};
use serde::Serialize;
use serde_json::{Map, Value};

/// An outcome with its derivatives as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct GradientReport {
    /// The outcome.
    pub of: &'static str,
    /// Its value; `null` where the drive has none.
    pub value: Value,
    /// Its derivative by each parameter.
    pub gradient: Option<Map<String, Value>>,
    /// Its second derivatives, if asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hessian: Option<HessianReport>,
    /// Why the drive has no such outcome.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// What deserves a word.
    pub warnings: Vec<String>,
}

/// A symmetric matrix of second derivatives.
#[derive(Clone, Debug, Serialize)]
pub struct HessianReport {
    /// The parameters of its rows and columns.
    pub names: Vec<&'static str>,
    /// Its rows.
    pub values: Vec<Vec<f64>>,
}

impl GradientReport {
    /// The report of an outcome's derivatives.
    pub fn new(of: Outcome, wrt: &[&'static Parameter], taylor: &Taylor, warnings: Vec<String>) -> Self {
        let names: Vec<&str> = wrt.iter().map(|parameter| parameter.name).collect();
        let gradient = names.iter().copied().zip(taylor.gradient.iter().map(|d| Some(*d)));
        Self {
            of: of.name(),
            value: json::number(Some(taylor.value)),
            gradient: Some(json::named(gradient)),
            hessian: (!taylor.hessian.is_empty()).then(|| HessianReport { names, values: taylor.hessian.clone() }),
            message: None,
            warnings,
        }
    }

    /// The report of an outcome that this drive does not have.
    pub fn none(of: Outcome, why: &Error, warnings: Vec<String>) -> Self {
        let message = Some(why.to_string());
        Self { of: of.name(), value: Value::Null, gradient: None, hessian: None, message, warnings }
    }
}

/// An outcome with its gradient, and Hessian if there is one, as text; derivatives also in SI, to twelve digits.
pub fn gradient_text(of: Outcome, wrt: &[&'static Parameter], taylor: &Taylor, system: System) -> String {
    let si = of.quantity().si;
    let rows = wrt.iter().zip(&taylor.gradient).map(|(parameter, slope)| {
        vec![
            parameter.name.into(),
            shown::slope(of, parameter, *slope, system, 6),
            format!("{} {}", significant(*slope, 12), per(si, parameter.quantity.si)).trim_end().to_owned(),
        ]
    });
    let gradient = table(&["by", &format!("d {}", of.name()), "SI"], &[1, 2], rows);
    let exact = format!("{} {si}", significant(taylor.value, 15));
    let value = format!("{} = {}; in SI {}\n\n", of.name(), shown::both(of, taylor.value, system), exact.trim_end());
    if taylor.hessian.is_empty() {
        return value + &gradient;
    }
    let head: Vec<&str> = std::iter::once("Hessian, SI").chain(wrt.iter().map(|parameter| parameter.name)).collect();
    let right: Vec<usize> = (1..head.len()).collect();
    let rows = wrt.iter().zip(&taylor.hessian).map(|(parameter, row)| {
        std::iter::once(parameter.name.to_owned()).chain(row.iter().map(|d| significant(*d, 10))).collect()
    });
    format!("{value}{gradient}\n{}", table(&head, &right, rows))
}
