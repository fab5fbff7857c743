use crate::error::Error;
use crate::units::Message;
use serde::Serialize;

/// An answer as one JSON object: what every command says first, then what it found. docs/json.md
/// describes both.
#[derive(Clone, Debug, Serialize)]
pub struct Reply<T> {
    /// The command that was asked; `null` where none was recognised.
    pub command: Option<&'static str>,
    /// How it ended, in a word: `done` where the command has none of its own.
    pub status: &'static str,
    /// The same in a sentence; `null` where there is nothing to add.
    pub message: Option<String>,
    /// What the reader should know about the question.
    pub warnings: Vec<Message>,
    /// What was found.
    #[serde(flatten)]
    pub body: T,
}

/// The body of a reply that found nothing.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Empty {}

impl<T> Reply<T> {
    /// All that was asked for.
    pub fn done(command: &'static str, warnings: Vec<Message>, body: T) -> Self {
        Self {
            command: Some(command),
            status: "done",
            message: None,
            warnings,
            body,
        }
    }

    /// The same reply with another status, and a sentence that says why.
    #[must_use]
    pub fn ended(self, status: &'static str, message: Option<String>) -> Self {
        Self {
            status,
            message,
            ..self
        }
    }
}

impl Reply<Empty> {
    /// The reply to a question that has no answer, or to bad input.
    pub fn none(command: Option<&'static str>, error: &Error) -> Self {
        Self::refused(command, error.status(), error.to_string())
    }

    /// The reply where there is only a message.
    pub fn refused(command: Option<&'static str>, status: &'static str, message: String) -> Self {
        Self {
            command,
            status,
            message: Some(message),
            warnings: vec![],
            body: Empty {},
        }
    }
}

/// How much was found of what was asked for: `done`, `partial` or `no-answer`.
pub(super) fn share(found: usize, asked: usize) -> &'static str {
    match found {
        _ if found == asked => "done",
        0 => "no-answer",
        _ => "partial",
    }
}
