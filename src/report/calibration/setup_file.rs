use crate::parameters::{Kind, LAW, METHOD, Parameter, UNSET};
use crate::study::calibrate::Calibration;

/// The fitted setup as a setup file in TOML: every parameter, to the last digit, the fitted ones with their standard errors.
pub fn calibration_toml(found: &Calibration, data: &str) -> String {
    let setup = &found.setup;
    let mut lines: Vec<(String, String)> = vec![
        (LAW.into(), format!("\"{}\"", setup.law.name())),
        (METHOD.into(), format!("\"{}\"", setup.method.name())),
    ];
    for parameter in setup.parameters() {
        let value = match setup.value(parameter) {
            None => format!("\"{UNSET}\""),
            Some(value) if value == f64::INFINITY => "\"inf\"".into(),
            Some(value) => format!("\"{value:?} {}\"", parameter.quantity.si).replace(" \"", "\""),
        };
        if !(parameter.kind == Kind::Optional && value.contains(UNSET)) {
            lines.push((parameter.name.into(), value + &remark(found, parameter)));
        }
    }
    let table_of = |name: &str| name.split_once('.').map_or(String::new(), |(table, _)| table.to_owned());
    let mut tables = vec![String::new()];
    for (name, _) in &lines {
        if !tables.contains(&table_of(name)) {
            tables.push(table_of(name));
        }
    }
    let mut text = format!("# fitted to {data}: {}\n", found.fit.message);
    for table in tables {
        if !table.is_empty() {
            text += &format!("\n[{table}]\n");
        }
        for (name, value) in lines.iter().filter(|(name, _)| table_of(name) == table) {
            let key = name.split_once('.').map_or(name.as_str(), |(_, key)| key);
            text += &format!("{key} = {value}\n");
        }
    }
    text
}

fn remark(found: &Calibration, parameter: &'static Parameter) -> String {
    let estimate = found.estimates.iter().find(|estimate| estimate.parameter == parameter);
    match estimate.map(|estimate| estimate.standard_error) {
        None => String::new(),
        Some(Some(error)) => format!(" # fitted, ± {}", parameter.show(Some(error))),
        Some(None) => " # fitted, without a standard error".into(),
    }
}
