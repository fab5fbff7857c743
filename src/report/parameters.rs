use super::lines::{item, note};
use super::{Reply, json};
use crate::atmosphere::in_effect;
use crate::parameters::{
    GOLFER, Kind, LAW, Law, METHOD, Method, Parameter, SPEED_OF, Setup, TABLE, TABLE_LAW, TURF,
    TURFS, UNSET,
};
use crate::units::{Message, System};
use serde_json::{Value, json};

/// The rows of a setup with the values that the drive has, and then those of the laws it does not
/// fly.
fn rows(setup: &Setup<f64>) -> Vec<(&'static Parameter, Option<f64>)> {
    let setup = &in_effect(setup);
    let own = setup
        .parameters()
        .into_iter()
        .map(|parameter| (parameter, setup.value(parameter)));
    let others = Law::all_rows().filter(|row| row.law != Some(setup.law.name()));
    own.chain(others.map(|parameter| (parameter, parameter.default_value())))
        .collect()
}

/// The answer of `parameters`: every parameter with its value in a setup.
pub fn parameters_reply(setup: &Setup<f64>, warnings: Vec<Message>) -> Reply<Value> {
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

/// Every parameter with its value in a setup, as text: a line of numbers each, and below it the
/// symbol and the meaning.
pub fn parameters_text(setup: &Setup<f64>, system: System) -> String {
    let (mine, others): (Vec<_>, Vec<_>) = rows(setup)
        .into_iter()
        .partition(|(row, _)| row.law.is_none_or(|law| law == setup.law.name()));
    let mut text = listing("parameter", &mine, system);
    let methods = Method::ALL
        .iter()
        .map(|method| format!("{} (order {})", method.name(), method.order()));
    text += &format!(
        "\n{}",
        item(&format!(
            "{METHOD} = {} here; the methods are {}",
            setup.method.name(),
            methods.collect::<Vec<_>>().join(", ")
        ))
    );
    let golfer = format!(
        "{GOLFER} = {} here; right or left, by the hand: swing, strike and club of a left-hander \
         are the mirror image of a right-hander's",
        setup.golfer.name()
    );
    text += &format!("\n{}", item(&golfer));
    let speed_of = format!(
        "{SPEED_OF} = {} here; centre-of-mass or face-centre, the point of the head whose speed, \
         attack angle and path the swing states \
         (they differ where swing.closure turns the head)",
        setup.speed_of.name()
    );
    text += &format!("\n{}", item(&speed_of));
    let turfs = TURFS
        .iter()
        .map(|turf| format!("{} ({})", turf.name, turf.about))
        .collect::<Vec<_>>()
        .join("; ");
    let here = setup.turf().map_or("none of them", |turf| turf.name);
    let told = format!(
        "{TURF} sets ground.restitution, ground.friction, ground.compliance and ground.rolling at \
         once ({here} here): {turfs}"
    );
    text += &format!("\n{}", item(&told));
    text += &format!(
        "\n  {LAW} = {} here; the coefficients of the other laws:\n",
        setup.law.name()
    );
    for law in Law::NAMES.iter().copied().chain([TABLE_LAW]) {
        let of_law: Vec<_> = others
            .iter()
            .copied()
            .filter(|(row, _)| row.law == Some(law))
            .collect();
        if !of_law.is_empty() {
            let title = if law == TABLE_LAW {
                format!("{TABLE_LAW}, your own {TABLE}")
            } else {
                law.into()
            };
            text += &format!("\n{}", listing(&title, &of_law, system));
        }
    }
    text
}

fn listing(title: &str, rows: &[(&'static Parameter, Option<f64>)], system: System) -> String {
    let head = [title, "value", "default", "range"].map(str::to_owned);
    let line = |(parameter, value): &(&'static Parameter, Option<f64>)| {
        let unit = system.unit(parameter.unit);
        let show = |value: Option<f64>| {
            value.map_or(UNSET.into(), |value| parameter.quantity.show(value, unit))
        };
        let range = parameter.range.show(parameter.quantity, unit);
        [
            parameter.name.into(),
            show(*value),
            show(parameter.default_value()),
            range,
        ]
    };
    let lines: Vec<[String; 4]> = std::iter::once(head).chain(rows.iter().map(line)).collect();
    let width = |column: usize| {
        lines
            .iter()
            .map(|line| line[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let [names, values, defaults] = [width(0), width(1), width(2)];
    let lines = lines.iter().map(|[name, value, default, range]| {
        format!("  {name:<names$}  {value:>values$}  {default:>defaults$}  {range}\n")
    });
    // below the head nothing, below each line what it means
    let meanings = rows.iter().map(|(parameter, _)| {
        note(&format!(
            "{}: {}",
            parameter.symbol,
            parameter.doc.trim_end_matches('.')
        ))
    });
    lines
        .zip(std::iter::once(String::new()).chain(meanings))
        .map(|(line, meaning)| line + &meaning)
        .collect()
}
