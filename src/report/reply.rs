use super::Document;
use super::origin::SetupOrigin;
use crate::error::Error;
use crate::units::{Message, System};
use serde::Serialize;

/// An answer as one JSON object: first the members that every answer has, then the result of the
/// command. docs/json.md describes both.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Reply<T> {
    /// The command; `null` if none was recognized.
    pub command: Option<&'static str>,
    /// The status, in a word and in a sentence.
    #[serde(flatten)]
    pub ending: Ending,
    /// Warnings about the request.
    pub warnings: Vec<Message>,
    /// The setup of the answer: the preset or file, and the settings of the request. Omitted if the
    /// request does not name a setup, for example for a setup from standard input.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// Parameters that the search does not vary, because the request states them; omitted if there
    /// are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub held: Vec<&'static str>,
    /// Advice on the setup; omitted if there is none.
    #[serde(skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, schemars(default))]
    pub advice: String,
    /// The result.
    #[serde(flatten)]
    pub body: T,
}

/// The result of a command. The serialized result is the body of the JSON, in SI and radians. The
/// document of the result is the answer for people.
pub trait Report: Serialize {
    /// The name of the command.
    const COMMAND: &'static str;

    /// The status of the command; the default is `done`.
    fn ending(&self) -> Ending {
        Ending::DONE
    }

    /// The words that [`ending`](Self::ending) may give as the status.
    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["done"];

    /// The result in words, tables and figures, in the units of a system.
    fn document(&self, system: System) -> Document;
}

/// The status of a command: `done`, `partial`, `no-answer`, or a word of this command.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Ending {
    /// The status in a word.
    pub status: &'static str,
    /// The status in a sentence; `null` if there is nothing to add.
    pub message: Option<String>,
}

impl Ending {
    /// The status `done`, without a message.
    pub const DONE: Self = Self {
        status: "done",
        message: None,
    };

    /// The status words of [`of_each`](Self::of_each).
    #[cfg(test)]
    pub(super) const STATUSES_OF_EACH: &'static [&'static str] = &[
        "done",
        "partial",
        "no-answer",
        "no-flight",
        "aloft",
        "diverged",
        "undefined",
    ];

    /// The status of several outcomes. `errors` has an item for each outcome: its error, or `None`
    /// if the outcome has a result.
    pub(super) fn of_each<'a>(errors: impl Iterator<Item = Option<&'a Error>>) -> Self {
        let errors: Vec<Option<&Error>> = errors.collect();
        let all = errors.len();
        let errors: Vec<&Error> = errors.into_iter().flatten().collect();
        let status = match (share(all - errors.len(), all), errors.first()) {
            // the status of the errors, if all errors have the same status
            ("no-answer", Some(first))
                if errors.iter().all(|error| error.status() == first.status()) =>
            {
                first.status()
            }
            (status, _) => status,
        };
        let mut messages: Vec<String> = vec![];
        for error in errors {
            let message = error.to_string();
            if !messages.contains(&message) {
                messages.push(message);
            }
        }
        Self {
            status,
            message: (!messages.is_empty()).then(|| messages.join("; ")),
        }
    }
}

/// The empty body of a reply without a result.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Empty {}

impl<'a, T: Report> Reply<&'a T> {
    /// The reply with this report.
    pub fn of(report: &'a T, warnings: Vec<Message>) -> Self {
        Self::done(T::COMMAND, warnings, report).ended(report.ending())
    }
}

impl<T> Reply<T> {
    /// The reply with a complete result.
    pub fn done(command: &'static str, warnings: Vec<Message>, body: T) -> Self {
        Self {
            command: Some(command),
            ending: Ending::DONE,
            warnings,
            from: None,
            held: vec![],
            advice: String::new(),
            body,
        }
    }

    /// Sets `from` to the name of the setup, `held` to the names of the held parameters, and
    /// `advice` to the advice on the setup.
    #[must_use]
    pub fn about(self, origin: &SetupOrigin) -> Self {
        let held = origin.held.iter();
        Self {
            from: origin.has_name.then(|| origin.title.clone()),
            held: held.map(|(parameter, _)| parameter.name).collect(),
            advice: origin.advice.clone(),
            ..self
        }
    }

    /// Sets the status.
    #[must_use]
    pub fn ended(self, ending: Ending) -> Self {
        Self { ending, ..self }
    }
}

impl Reply<Empty> {
    /// The status words of a reply without a result: errors, and searches that end without a
    /// result.
    #[cfg(test)]
    pub(crate) fn statuses() -> Vec<&'static str> {
        let errors = ["error", "no-flight", "aloft", "diverged", "no-answer"];
        let searches = crate::optimize::Status::NAMES;
        errors.into_iter().chain(searches).collect()
    }

    /// The reply that has only a message.
    pub fn refused(command: Option<&'static str>, status: &'static str, message: String) -> Self {
        let ending = Ending {
            status,
            message: Some(message),
        };
        Self {
            command,
            ending,
            ..Self::done("", vec![], Empty {})
        }
    }
}

/// `done` if all requests have an answer, `no-answer` if none has one, otherwise `partial`.
pub(super) fn share(found: usize, requested: usize) -> &'static str {
    match found {
        _ if found == requested => "done",
        0 => "no-answer",
        _ => "partial",
    }
}

#[cfg(test)]
mod tests {
    use super::Ending;
    use crate::error::Error;

    #[test]
    fn each_reason_is_told_once() {
        let errors = ["a", "b", "a"].map(|name| Error::unreadable(name, "wrong"));
        let ending = Ending::of_each(errors.iter().map(Some));
        assert_eq!(ending.message.as_deref(), Some("a: wrong; b: wrong"));
    }
}
