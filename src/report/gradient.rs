use super::document::{Document, DocumentTable, Line};
use super::json::{ByName, JsonNumber, Matrix};
use super::reply::{Ending, Report};
use super::shown;
use crate::derivative::Taylor;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use crate::units::{System, per, significant, typed};
use serde::Serialize;

/// Outcomes with their derivatives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct GradientReport<'a> {
    #[serde(skip)]
    found: &'a [(Outcome, Result<Taylor>)],
    #[serde(skip)]
    wrt: &'a [&'static Parameter],
    /// Each outcome, in the order requested.
    pub outcomes: Vec<OutcomeReport>,
}

/// An outcome with its derivatives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OutcomeReport {
    /// The outcome.
    pub of: Outcome,
    /// The value of the outcome, SI; `null` if the drive does not have it.
    pub value: JsonNumber,
    /// The derivative by each parameter, SI; `null` if the drive does not have the outcome.
    pub gradient: Option<ByName<JsonNumber>>,
    /// The second derivatives, SI; `null` if they were not requested, or if the drive does not have
    /// the outcome.
    pub hessian: Option<Matrix>,
    /// The reason why the drive does not have the outcome; `null` if it has the outcome.
    pub message: Option<String>,
}

impl<'a> GradientReport<'a> {
    /// The report of these outcomes: the derivatives of each, or the reason why there are none.
    ///
    /// # Panics
    /// If the number of derivatives differs from the number of parameters.
    pub fn new(found: &'a [(Outcome, Result<Taylor>)], wrt: &'a [&'static Parameter]) -> Self {
        let outcomes = found
            .iter()
            .map(|(of, taylor)| OutcomeReport::new(*of, wrt, taylor))
            .collect();
        Self {
            found,
            wrt,
            outcomes,
        }
    }
}

impl Report for GradientReport<'_> {
    const COMMAND: &'static str = "gradient";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = Ending::STATUSES_OF_EACH;

    fn ending(&self) -> Ending {
        Ending::of_each(self.found.iter().map(|(_, taylor)| taylor.as_ref().err()))
    }

    /// The gradients of the outcomes in the units of `system`, and in SI with 12 digits. Requested
    /// Hessians are in SI with 10 digits.
    fn document(&self, system: System) -> Document {
        let mut document = Document::default();
        for (of, taylor) in self.found {
            if let Ok(taylor) = taylor {
                outcome(&mut document, *of, self.wrt, taylor, system);
            }
        }
        document
    }
}

impl OutcomeReport {
    fn new(of: Outcome, wrt: &[&'static Parameter], taylor: &Result<Taylor>) -> Self {
        let taylor = match taylor {
            Ok(taylor) => taylor,
            Err(why) => {
                return Self {
                    of,
                    value: JsonNumber(None),
                    gradient: None,
                    hessian: None,
                    message: Some(why.to_string()),
                };
            }
        };
        taylor.expect_derivatives_by(wrt.len(), "parameters");
        let names = wrt.iter().map(|parameter| parameter.name);
        let gradient = names.clone().zip(taylor.gradient.iter().copied());
        let hessian = (!taylor.hessian.is_empty())
            .then(|| Matrix::new(names.clone(), |row, column| taylor.hessian[row][column]));
        Self {
            of,
            value: taylor.value.into(),
            gradient: Some(gradient.collect()),
            hessian,
            message: None,
        }
    }
}

fn outcome(
    document: &mut Document,
    of: Outcome,
    wrt: &[&'static Parameter],
    taylor: &Taylor,
    system: System,
) {
    let si = of.quantity().si;
    let value = if shown::is_rounding(of, 0.0, taylor.value) {
        0.0
    } else {
        taylor.value
    };
    let value_in_si = typed(&significant(value, 15), si);
    document.list([Line::flush(format!(
        "{} = {}; in SI {}",
        of.name(),
        shown::both(of, taylor.value, system),
        value_in_si
    ))]);

    let without_rounding =
        |d: f64, by: &[&Parameter]| shown::zero_if_rounding(d, taylor.value, of, by);
    let rows = wrt.iter().zip(&taylor.gradient).map(|(parameter, slope)| {
        let in_si = significant(without_rounding(*slope, &[*parameter]), 12);
        vec![
            parameter.name.into(),
            shown::slope(of, taylor.value, parameter, *slope, system, 6),
            typed(&in_si, &per(si, parameter.quantity.si)),
        ]
    });
    let derivative = format!("d {}", of.name());
    document.add(DocumentTable::new(["by", &derivative, "SI"], rows).right([1, 2]));

    if taylor.hessian.is_empty() {
        return;
    }
    let names = wrt.iter().map(|parameter| parameter.name);
    let rows = wrt.iter().zip(&taylor.hessian).map(|(parameter, row)| {
        let seconds = row
            .iter()
            .zip(wrt)
            .map(|(d, by)| significant(without_rounding(*d, &[*parameter, *by]), 10));
        std::iter::once(parameter.name.to_owned())
            .chain(seconds)
            .collect()
    });
    let head = std::iter::once("Hessian, SI").chain(names);
    document.add(DocumentTable::new(head, rows).right(1..=wrt.len()));
}
