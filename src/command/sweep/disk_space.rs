//! Disk space: estimates the size and time of a sweep before its start.

use super::args::Args;
use super::resumable::part_of;
use super::rows::{FormattedRows, RowFormatter};
use crate::atomic_file::folder_of;
use crate::batch::{Batch, Points, processors};
use crate::units::counted;
use crate::{Error, Result};
use bytesize::ByteSize;
use std::fmt::Display;
use std::path::Path;
use std::time::{Duration, Instant};

/// Number of drives in the trial that measures the size and time of a row.
const TRIED: usize = 64;

/// Refuses a sweep whose file would be larger than `--max-size` or the free disk space. Call this
/// before any other work.
pub fn check(
    args: &Args,
    batch: &Batch,
    points: &mut dyn Points,
    formatter: &RowFormatter,
    file: Option<&Path>,
) -> Result<()> {
    let (most, limit) = match (&args.max_size, file) {
        (Some(text), _) => (read_size(text)?, format!("`max_size {text}`")),
        (None, Some(path)) => match free(path) {
            Some((bytes, folder)) => (
                bytes,
                format!("the {} that are free in {folder}", size(bytes)),
            ),
            None => return Ok(()),
        },
        (None, None) => return Ok(()),
    };
    // try rows in the middle of the sweep
    points.seek(points.rows() / 2)?;
    let mut values = vec![];
    let tried = points.read(TRIED, &mut values)?;
    if tried == 0 {
        return Ok(());
    }
    let begun = Instant::now();
    let content = formatter.rows(batch.evaluate(0, values));
    let seconds_of_row = begun.elapsed().as_secs_f64() / (tried * threads(args)) as f64;
    let bytes_of_row = match content {
        FormattedRows::Text { bytes, .. } => bytes.len() as f64 / tried as f64,
        #[cfg(feature = "parquet")]
        FormattedRows::Block(_) => bytes_in_parquet(args, batch, points),
    };
    let rows = points.rows() as f64;
    let bytes = bytes_of_row * rows;
    if bytes <= most {
        return Ok(());
    }
    let time = duration(seconds_of_row * rows);
    Err(Error::TooLarge {
        rows: points.rows().to_string(),
        size: format!("{} and about {time}", size(bytes)),
        limit,
        advice: "take fewer values or outcomes, `sample` points of the same ranges, or a larger \
                 `max_size`"
            .into(),
    })
}

/// The number of threads that compute rows at the same time.
fn threads(args: &Args) -> usize {
    match args.threads {
        0 => processors(),
        threads => threads.min(processors()),
    }
}

/// The estimated size of a row in Parquet, bytes.
#[cfg(feature = "parquet")]
fn bytes_in_parquet(args: &Args, batch: &Batch, points: &dyn Points) -> f64 {
    // a grid stores each swept value once for many rows: neglect the swept columns
    let is_grid = args.sample.is_none() && args.points.is_none();
    let swept = match is_grid {
        true => 0,
        false => points.parameters().len(),
    };
    let computed = batch.outcomes().len() * (1 + batch.wrt().len());
    // 8.5 bytes for each number, and 1 byte for the status
    8.5 * (swept + computed) as f64 + 1.0
}

/// The number of bytes available for a file, and the folder of the file. The bytes of an unfinished
/// file count as available, because the sweep continues or replaces it. `None` if the free space is
/// unknown.
fn free(path: &Path) -> Option<(f64, String)> {
    let folder = folder_of(path);
    #[cfg(feature = "cli")]
    let available = fs4::available_space(folder).ok();
    // without the feature `cli`, the host limits the size of its files itself
    #[cfg(not(feature = "cli"))]
    let available: Option<u64> = None;
    let there = std::fs::metadata(part_of(path)).map_or(0, |found| found.len());
    Some(((available? + there) as f64, folder.display().to_string()))
}

fn read_size(text: &str) -> Result<f64> {
    let size: ByteSize = text.trim().parse().unwrap_or_default();
    if size.as_u64() == 0 {
        return Err(Error::unreadable(
            format!("`max_size {text}`"),
            "write a size like 500MB, 50GB or 1.5TB",
        ));
    }
    Ok(size.as_u64() as f64)
}

/// A number of bytes with a unit.
fn size(bytes: f64) -> impl Display {
    ByteSize(bytes as u64).display().si()
}

/// Units of durations, s.
const UNITS: [(f64, &str); 6] = [
    (365.0 * 86_400.0, "year"),
    (7.0 * 86_400.0, "week"),
    (86_400.0, "day"),
    (3600.0, "hour"),
    (60.0, "minute"),
    (1.0, "second"),
];

/// A duration in the largest unit that gives a number of at least about 1.5.
fn duration(seconds: f64) -> String {
    let most = Duration::MAX.as_secs_f64();
    let seconds = if (0.0..=most).contains(&seconds) {
        seconds
    } else {
        most
    };
    let is_long = |pair: &[(f64, &str)]| seconds + pair[1].0 / 2.0 >= 1.5 * pair[0].0;
    match UNITS.windows(2).find(|pair| is_long(pair)) {
        Some(pair) => counted((seconds / pair[0].0).round().max(2.0) as u64, pair[0].1),
        None => counted(seconds.round() as u64, "second"),
    }
}

#[cfg(feature = "cli")]
#[cfg(test)]
mod tests {
    use super::duration;
    use indicatif::HumanDuration;
    use std::time::Duration;

    #[test]
    fn independent_durations_are_those_of_progress_bars() {
        for k in 0..4000 {
            let seconds = 0.2 * 1.006_f64.powi(k);
            let of_bars = HumanDuration(Duration::from_secs_f64(seconds)).to_string();
            assert_eq!(duration(seconds), of_bars);
        }
        let longest = HumanDuration(Duration::MAX).to_string();
        assert_eq!(duration(f64::INFINITY), longest);
    }
}
