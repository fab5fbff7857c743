//! Arguments and commands in messages, in the words of the page.

use longdrive::command::{Mention, with_mentions};

/// A message whose arguments are named like the fields of the page, without hyphens.
pub fn in_page_words(message: &str) -> String {
    with_mentions(message, page_words)
}

/// An argument or a command in the words of the page.
pub fn page_words(mention: Mention<'_>) -> String {
    match mention {
        Mention::Command(name) => format!("\"{name}\""),
        Mention::Argument {
            name: "set",
            value: Some(setting),
            ..
        } => setting.replacen('=', " = ", 1),
        Mention::Argument { name, value, .. } => {
            let name = name.replace('_', " ");
            value.map_or(name.clone(), |value| format!("{name} {value}"))
        }
    }
}
