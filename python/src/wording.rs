//! Arguments and commands in messages, in the syntax of Python.

use longdrive::command::{Mention, with_mentions};
use pyo3::prelude::*;

/// A message whose arguments are in the syntax of Python: `subject_to="apex_height <= 30 m"`.
#[pyfunction]
pub fn in_python(message: &str) -> String {
    with_mentions(message, mention)
}

/// An argument or a command in the syntax of Python.
pub fn mention(mention: Mention<'_>) -> String {
    match mention {
        Mention::Command(name) => {
            format!("longdrive.{}()", name.replace('-', "_").replace(' ', "."))
        }
        Mention::Argument {
            name: "set" | "set_a" | "set_b",
            value,
            ..
        } => replacing(value),
        // only the program has these options
        Mention::Argument {
            name: "json" | "csv" | "listen" | "address",
            ..
        } => mention.in_command_line_syntax(),
        Mention::Argument {
            name,
            takes_value: false,
            ..
        } => format!("{}=True", argument_of(name)),
        Mention::Argument { name, value, .. } => match value {
            None => argument_of(name).into(),
            Some(value) => format!("{}={}", argument_of(name), literal(value)),
        },
    }
}

/// The name of the argument for an option.
pub fn argument_of(option: &str) -> &str {
    match option {
        "outcomes" => "of",
        name => name,
    }
}

/// A call that sets a parameter.
fn replacing(value: Option<&str>) -> String {
    match value.and_then(|value| value.split_once('=')) {
        Some((name, amount)) => {
            let amount = amount.trim_matches('"');
            format!(r#"setup.replace({{"{name}": "{amount}"}})"#)
        }
        None => {
            let name = value.map_or(String::new(), |name| format!(" {name}"));
            format!("setup.replace({{…}}){name}")
        }
    }
}

/// A value in Python's syntax. A text is quoted; numbers and placeholders such as FILE are not.
fn literal(value: &str) -> String {
    let is_placeholder = value.chars().all(|c| c.is_ascii_uppercase() || c == '_');
    if is_placeholder || value.starts_with('"') || value.parse::<f64>().is_ok() {
        value.into()
    } else {
        format!("\"{value}\"")
    }
}
