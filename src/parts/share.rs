use crate::batch::CHUNK;
use crate::error::{Error, Result};
use crate::units::counted;
use std::ops::Range;

/// Least number of digits of a part's number in its file name.
const DIGITS: usize = 5;

/// The rows of part K of M, where K is counted from 1 and rows from 0. A part consists of whole
/// blocks of [`CHUNK`] rows; only the last block of the sweep may be shorter. The parts are as
/// equal as possible: of B blocks, counted from 0, part K has the blocks ⌊(K − 1)B/M⌋ to
/// ⌊K B/M⌋ − 1.
///
/// ```
/// use longdrive::parts::rows_of;
/// // ten blocks, the last with 784 rows, in three parts
/// let rows: Vec<_> = (1..=3).map(|part| rows_of(part, 3, 10_000).unwrap()).collect();
/// assert_eq!(rows, [0..3072, 3072..6144, 6144..10_000]);
/// ```
///
/// # Errors
/// [`Error::Together`] if `part` is not from 1 to M, or if there are more parts than blocks.
pub fn rows_of(part: u64, parts: u64, rows: u64) -> Result<Range<u64>> {
    let refuse = |given: String, reason: String| Err(Error::Together { given, reason });
    if part == 0 || part > parts {
        return refuse(
            format!("part {part} of {parts}"),
            format!(
                "parts are counted from 1; give one from 1 to {parts}, as a job array from 1 to \
                 {parts} does"
            ),
        );
    }
    // at most one part per block, so that each part has a block
    let blocks = rows.div_ceil(CHUNK as u64);
    if parts > blocks {
        return refuse(
            format!("{parts} parts"),
            format!(
                "the sweep has {}, in blocks of {CHUNK}; divide it into at most {}",
                counted(rows, "row"),
                counted(blocks, "part")
            ),
        );
    }
    // the product of two 64-bit numbers needs 128 bits
    let begin = |part: u64| {
        (u128::from(part) * u128::from(blocks) / u128::from(parts)) as u64 * CHUNK as u64
    };
    Ok(begin(part - 1)..begin(part).min(rows))
}

/// File name of a part: its number has as many digits as the number of parts, and at least five.
///
/// ```
/// assert_eq!(longdrive::parts::file_name(17, 1000), "part-00017.parquet");
/// assert_eq!(longdrive::parts::file_name(17, 1_000_000), "part-0000017.parquet");
/// ```
pub fn file_name(part: u64, parts: u64) -> String {
    let digits = parts.to_string().len().max(DIGITS);
    format!("part-{part:0digits$}.parquet")
}
