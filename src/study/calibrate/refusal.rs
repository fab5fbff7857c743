//! Error for a fit without a starting point: groups rows with the same reason.

use crate::error::Error;

/// Failed rows whose reasons differ only in the numbers within the text.
struct Group {
    rows: Vec<usize>,
    /// The reason of the first row.
    reason: String,
    /// True if all rows have exactly the same reason.
    is_same: bool,
}

/// Error for failed rows, given as pairs of row number and error. The message begins with `what`.
///
/// - [`Error::Calibration`] if a row has invalid input
/// - [`Error::NoFit`] if every row has valid input, but no result; for example, the ball does not
///   fly
pub(super) fn failed_rows_error(what: &str, failed: &[(usize, Error)]) -> Error {
    let reason = format!("{what}: {}", refusal(failed));
    let Some((_, first)) = failed.first() else {
        return Error::Calibration { reason };
    };
    if failed.iter().any(|(_, error)| !error.has_valid_input()) {
        return Error::Calibration { reason };
    }
    let is_same = failed
        .iter()
        .all(|(_, error)| error.status() == first.status());
    Error::NoFit {
        status: if is_same { first.status() } else { "no-answer" },
        reason,
    }
}

/// The reasons of all rows in one sentence, with advice.
fn refusal(failed: &[(usize, Error)]) -> String {
    let mut groups: Vec<Group> = vec![];
    for (row, error) in failed {
        let reason = reason(error);
        match groups
            .iter_mut()
            .find(|group| kind(&group.reason) == kind(&reason))
        {
            Some(group) => {
                group.rows.push(*row);
                group.is_same &= group.reason == reason;
            }
            None => groups.push(Group {
                rows: vec![*row],
                reason,
                is_same: true,
            }),
        }
    }
    let messages: Vec<String> = groups.iter().map(Group::message).collect();
    // the step of the setup diverges, so that the removal of rows does not help
    let mut errors = failed.iter().map(|(_, error)| error);
    let advice = match errors.all(|error| error.status() == "diverged") {
        true => "",
        false => {
            "; correct these rows or take them out, or start the fit elsewhere (`set`, or `fit \
             NAME=LOW..HIGH`)"
        }
    };
    messages.join("; ") + advice
}

impl Group {
    fn message(&self) -> String {
        let Self {
            rows,
            reason,
            is_same,
        } = self;
        let first = rows.first().copied().unwrap_or_default();
        let rows = numbered(rows);
        if *is_same {
            format!("{rows}: {reason}")
        } else {
            format!("{rows}, for example row {first}: {reason}")
        }
    }
}

/// The reason of one row. It omits the prefix of calibration errors, and the time of divergence,
/// which differs from row to row.
fn reason(error: &Error) -> String {
    match error {
        Error::Calibration { reason } => reason.clone(),
        Error::Diverged { advice, .. } => format!("the flight diverges; {advice}"),
        error => error.to_string(),
    }
}

/// The reason without its numbers, for comparison.
fn kind(reason: &str) -> String {
    reason
        .chars()
        .filter(|c| !(c.is_ascii_digit() || ['-', '.', '\u{2212}'].contains(c)))
        .collect()
}

/// Row numbers as text: "row 3", "rows 1 to 4, 7".
fn numbered(rows: &[usize]) -> String {
    let mut runs: Vec<(usize, usize)> = vec![];
    for row in rows {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == *row => *last = *row,
            _ => runs.push((*row, *row)),
        }
    }
    let run = |(first, last): &(usize, usize)| match last - first {
        0 => first.to_string(),
        1 => format!("{first}, {last}"),
        _ => format!("{first} to {last}"),
    };
    let all: Vec<String> = runs.iter().map(run).collect();
    format!(
        "{} {}",
        if rows.len() == 1 { "row" } else { "rows" },
        all.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::{failed_rows_error, numbered, refusal};
    use crate::error::Error;

    #[test]
    fn rows_are_numbered_in_runs() {
        assert_eq!(numbered(&[3]), "row 3");
        assert_eq!(numbered(&[1, 2, 3, 4, 7, 9, 10]), "rows 1 to 4, 7, 9, 10");
    }

    #[test]
    fn rows_with_one_reason_are_listed_once_with_its_advice() {
        let diverged = |time| Error::Diverged {
            time,
            step: 2.0,
            advice: "reduce flight.step".into(),
        };
        let message = refusal(&[(1, diverged(2.0)), (2, diverged(4.0)), (3, diverged(2.0))]);
        assert!(
            message.ends_with("rows 1 to 3: the flight diverges; reduce flight.step"),
            "{message}"
        );
        let no_flight = |angle: &str| Error::NoFlight {
            status: "no-flight",
            reason: format!("no flight: the ball leaves at {angle}")
                .as_str()
                .into(),
        };
        let message = refusal(&[
            (2, no_flight("-3.5 deg")),
            (5, no_flight("-1 deg")),
            (6, diverged(1.0)),
        ]);
        assert!(
            message.contains(
                "rows 2, 5, for example row 2: no flight: the ball leaves at -3.5 deg; \
                           row 6: the flight"
            ),
            "{message}"
        );
        assert!(message.contains("take them out"), "{message}");
    }

    #[test]
    fn rows_that_do_not_fly_are_no_answer_and_bad_input_is_an_error() {
        let diverged = || Error::Diverged {
            time: 1.0,
            step: 2.0,
            advice: "reduce flight.step".into(),
        };
        let no_flight = || Error::NoFlight {
            status: "no-flight",
            reason: "the ball leaves downwards".into(),
        };
        let wrong = || Error::Calibration {
            reason: "row 3 is not a number".into(),
        };
        for (errors, status) in [
            (vec![diverged(), diverged()], "diverged"),
            (vec![no_flight()], "no-flight"),
            (vec![diverged(), no_flight()], "no-answer"),
            (vec![diverged(), wrong()], "error"),
        ] {
            let failed: Vec<_> = errors.into_iter().enumerate().collect();
            assert_eq!(
                failed_rows_error("nothing flies", &failed).status(),
                status,
                "{failed:?}"
            );
        }
    }
}
