use super::{json, table::table};
use crate::derivative::Taylor;
use crate::drive::Outcome;
use crate::error::Error;
use crate::parameters::Parameter;
use crate::units::{per, significant};
use serde_json::{Value, json};

/// An outcome with its gradient, and Hessian if there is one, as JSON.
pub fn gradient_json(of: Outcome, wrt: &[&'static Parameter], taylor: &Taylor, warnings: &[String]) -> Value {
    let names: Vec<&str> = wrt.iter().map(|parameter| parameter.name).collect();
    let gradient = names.iter().copied().zip(taylor.gradient.iter().map(|d| Some(*d)));
    let mut result = json!({
        "of": of.name(),
        "value": json::number(Some(taylor.value)),
        "gradient": json::named(gradient),
    });
    if !taylor.hessian.is_empty() {
        result["hessian"] = json!({ "names": names, "values": taylor.hessian });
    }
    result["warnings"] = json!(warnings);
    result
}

/// An outcome that this drive does not have, as JSON.
pub fn no_gradient_json(of: Outcome, why: &Error, warnings: &[String]) -> Value {
    json!({ "of": of.name(), "value": null, "gradient": null, "message": why.to_string(), "warnings": warnings })
}

/// An outcome with its gradient, and Hessian if there is one, as text.
pub fn gradient_text(of: Outcome, wrt: &[&'static Parameter], taylor: &Taylor) -> String {
    let unit_size = of.quantity().size_of(of.unit()).unwrap_or(1.0);
    let rows = wrt.iter().zip(&taylor.gradient).map(|(parameter, slope)| {
        let size = parameter.quantity.size_of(parameter.unit).unwrap_or(1.0);
        vec![
            parameter.name.into(),
            format!("{} {}", significant(slope * size / unit_size, 6), per(of.unit(), parameter.unit)),
            format!("{} {}", significant(*slope, 12), per(of.quantity().si, parameter.quantity.si)),
        ]
    });
    let gradient = table(&["by", &format!("d {}", of.name()), "SI"], &[], rows);
    let value = format!(
        "{} = {} = {} {}\n\n",
        of.name(),
        of.show(taylor.value),
        significant(taylor.value, 15),
        of.quantity().si
    );
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
