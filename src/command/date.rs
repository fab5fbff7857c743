//! The date of a page.

use crate::{Error, Result};
use std::time::{SystemTime, UNIX_EPOCH};

/// The environment variable for the time of a reproducible build, in seconds since 1970:
/// <https://reproducible-builds.org/specs/source-date-epoch>.
const EPOCH: &str = "SOURCE_DATE_EPOCH";

/// The current date in UTC, such as 2026-11-22. `SOURCE_DATE_EPOCH` overrides it.
///
/// # Errors
/// [`Error::Unreadable`] if `SOURCE_DATE_EPOCH` is not a number of seconds.
pub fn today() -> Result<String> {
    let seconds = match std::env::var(EPOCH) {
        Ok(text) => text.trim().parse().map_err(|_| {
            Error::unreadable(
                EPOCH,
                format!(
                    "'{text}' is no whole number of seconds since 1970; correct it, or unset it"
                ),
            )
        })?,
        Err(_) => SystemTime::now()
            .duration_since(UNIX_EPOCH)
            .map_or(0, |since| since.as_secs()),
    };
    Ok(date(seconds))
}

/// The date of a time in seconds since 1970. The years of the algorithm begin on 1 March, so that a
/// leap day is the last day of a year (Hinnant, "chrono-compatible low-level date algorithms").
fn date(seconds: u64) -> String {
    let days = seconds / 86_400 + 719_468;
    let (era, of_era) = (days / 146_097, days % 146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (month, next) = if month < 10 {
        (month + 3, 0)
    } else {
        (month - 9, 1)
    };
    format!("{:04}-{month:02}-{day:02}", era * 400 + year + next)
}
