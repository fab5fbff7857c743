use super::{Reply, json, table::table};
use crate::parameters::{Kind, LAW, Law, METHOD, Method, Parameter, Setup};
use serde_json::{Value, json};

/// The rows of a setup, and then those of the laws it does not fly.
fn rows(setup: &Setup<f64>) -> Vec<(&'static Parameter, Option<f64>)> {
    let own = setup.parameters().into_iter().map(|parameter| (parameter, setup.value(parameter)));
    let others = Law::all_rows().filter(|row| row.law != Some(setup.law.name()));
    own.chain(others.map(|parameter| (parameter, parameter.default_value()))).collect()
}

/// The answer of `parameters`: every parameter with its value in a setup.
pub fn parameters_reply(setup: &Setup<f64>, warnings: Vec<String>) -> Reply<Value> {
    let end = |value: f64| json::number(Some(value));
    let row = |(parameter, value): &(&'static Parameter, Option<f64>)| {
        let range = parameter.range;
        json!({
            "parameter": parameter.name,
            "symbol": parameter.symbol,
            "unit": parameter.quantity.si,
            "shown_in": parameter.unit,
            "value": json::number(*value),
            "default": json::number(parameter.default_value()),
            "source": parameter.source,
            "range": {
                "low": end(range.low), "low_included": range.low_included,
                "high": end(range.high), "high_included": range.high_included,
            },
            "kind": match parameter.kind {
                Kind::Required => "required",
                Kind::Optional => "optional",
                Kind::Setting => "setting",
            },
            "law": parameter.law,
            "doc": parameter.doc,
        })
    };
    let parameters: Vec<Value> = rows(setup).iter().map(row).collect();
    let body = json!({ "law": setup.law.name(), "laws": Law::NAMES, "parameters": parameters });
    Reply::done("parameters", warnings, body)
}

/// Every parameter with its value in a setup, as text.
pub fn parameters_text(setup: &Setup<f64>) -> String {
    let line = |(parameter, value): (&'static Parameter, Option<f64>)| {
        let range = parameter.range.show(parameter.quantity, parameter.unit);
        vec![
            parameter.name.into(),
            parameter.symbol.into(),
            parameter.show(value),
            parameter.show(parameter.default_value()),
            range,
            parameter.doc.trim_end_matches('.').into(),
        ]
    };
    let head = ["parameter", "symbol", "value", "default", "range", "meaning"];
    let (mine, others): (Vec<_>, Vec<_>) =
        rows(setup).into_iter().partition(|(row, _)| row.law.is_none_or(|law| law == setup.law.name()));
    let mut text = table(&head, &[2, 3], mine.into_iter().map(line));
    let methods = Method::ALL.iter().map(|method| format!("{} (order {})", method.name(), method.order()));
    text +=
        &format!("\n  {METHOD} = {} here; there are {}\n", setup.method.name(), methods.collect::<Vec<_>>().join(", "));
    text += &format!("\n  {LAW} = {} here; the coefficients of the other laws:\n", setup.law.name());
    for law in Law::NAMES {
        let of_law: Vec<_> = others.iter().copied().filter(|(row, _)| row.law == Some(law)).collect();
        if !of_law.is_empty() {
            text += &format!(
                "\n{}",
                table(&[law, "symbol", "value", "default", "range", "meaning"], &[2, 3], of_law.into_iter().map(line))
            );
        }
    }
    text
}
