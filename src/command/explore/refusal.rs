use crate::Error;

/// The error of a command that cannot serve the explorer.
pub fn refused(why: impl Into<String>) -> Error {
    Error::Unreadable {
        name: "explore".into(),
        source: why.into().into(),
    }
}
