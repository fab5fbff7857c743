//! Requests without an answer: the status and the message of the program.

use crate::words::in_page_words;
use longdrive::units::System;
use longdrive::{Error, Setup};
use serde::Serialize;

/// The reason why a request has no answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Refusal {
    /// `error` for bad input, else the status of the drive: `no-flight`.
    pub status: &'static str,
    /// The message of the program.
    pub message: String,
    /// The parameters that the message names, the cause first.
    pub parameters: Vec<String>,
    /// The parameters to which the request gives a text that can be read.
    pub stated: Vec<String>,
    /// The values of `stated`, SI. They are the block of the answer.
    #[serde(skip)]
    pub values: Vec<f64>,
}

impl Refusal {
    /// The refusal of a malformed request, which is an error of the page.
    pub fn of_request(why: &str) -> Self {
        Self {
            status: "error",
            message: format!("the request: {why}"),
            parameters: vec![],
            stated: vec![],
            values: vec![],
        }
    }

    /// The refusal with the message of an error, and with the parameters that the message mentions.
    /// It searches the message for the parameters of the setup, and for the `names` in the request.
    pub fn of<'a>(
        error: &Error,
        system: System,
        setup: &Setup<f64>,
        names: impl Iterator<Item = &'a str>,
    ) -> Self {
        let message = in_page_words(&error.in_units(system));
        let known = setup.parameters().into_iter().map(|row| row.name);
        let mut named: Vec<(usize, &str)> = names
            .chain(known)
            .filter_map(|name| Some((place(&message, name)?, name)))
            .collect();
        named.sort_unstable();
        named.dedup();
        Self {
            status: error.status(),
            parameters: named.into_iter().map(|(_, name)| name.to_owned()).collect(),
            message,
            stated: vec![],
            values: vec![],
        }
    }
}

/// Index of the byte at which a message mentions a parameter; `None` without a mention. A message
/// may omit the group `launch` of a launch condition.
fn place(message: &str, name: &str) -> Option<usize> {
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    let whole = |name: &str| {
        message.match_indices(name).find_map(|(at, _)| {
            let after = message[at + name.len()..].trim_start_matches('.');
            let is_whole = !message[..at].ends_with(is_of_name) && !after.starts_with(is_of_name);
            is_whole.then_some(at)
        })
    };
    whole(name).or_else(|| whole(name.strip_prefix("launch.")?))
}
