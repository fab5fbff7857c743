//! Whole numbers as values of options, with this program's error messages.

use crate::batch::HAS_THREADS;
use crate::{Error, Result};
use std::ops::RangeInclusive;

/// Parser of a whole number in a range; `example` is a valid use of the option, for the error
/// message.
pub fn whole<T: TryFrom<u64>>(
    range: RangeInclusive<u64>,
    example: &'static str,
) -> impl Fn(&str) -> std::result::Result<T, String> + Clone + Send + Sync {
    move |text| {
        let number = text
            .trim()
            .parse()
            .ok()
            .filter(|number| range.contains(number));
        number
            .and_then(|number| T::try_from(number).ok())
            .ok_or_else(|| {
                let (least, most) = range.clone().into_inner();
                let range = if most < u64::from(u32::MAX) {
                    format!("from {least} to {most}")
                } else {
                    format!("of {least} or more")
                };
                let most = if most == u64::from(u32::MAX) {
                    format!(" (at most {most})")
                } else {
                    String::new()
                };
                format!("it must be a whole number {range}{most}; write for example {example}")
            })
    }
}

/// Largest value of an option that is a `u32`.
pub const U32_MAX: u64 = u32::MAX as u64;

/// Refuses several threads in WebAssembly, where only one thread exists.
///
/// # Errors
/// [`Error::Unreadable`], which names the option.
pub fn refuse_threads(threads: usize) -> Result<()> {
    if HAS_THREADS || threads <= 1 {
        return Ok(());
    }
    Err(Error::unreadable(
        format!("`threads {threads}`"),
        "only one thread is available here; leave the option out",
    ))
}

#[cfg(test)]
mod tests {
    use super::{U32_MAX, whole};

    #[test]
    fn ends_of_the_ranges_are_accepted_and_messages_name_range_and_example() {
        let starts = whole::<u32>(1..=U32_MAX, "`starts 8`");
        assert_eq!((starts("1"), starts("4294967295")), (Ok(1), Ok(u32::MAX)));
        for wrong in [
            "0",
            "-1",
            "1.5",
            "x",
            "",
            "4294967296",
            "99999999999999999999",
        ] {
            let message = starts(wrong).unwrap_err();
            assert_eq!(
                message,
                "it must be a whole number of 1 or more (at most 4294967295); write for example \
                 `starts 8`"
            );
        }
        let message = whole::<u32>(240..=4000, "`width 800`")("100").unwrap_err();
        assert_eq!(
            message,
            "it must be a whole number from 240 to 4000; write for example `width 800`"
        );
        assert_eq!(
            whole::<u64>(0..=u64::MAX, "`seed 7`")("18446744073709551615"),
            Ok(u64::MAX)
        );
    }
}
