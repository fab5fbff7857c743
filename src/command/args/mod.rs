//! Arguments that several commands have.

// these doc comments are help texts, in which "carry [yd]" is a column head, not a link
#![allow(rustdoc::broken_intra_doc_links)]

mod number;
mod output;
mod search;
mod setup;

pub use number::{U32_MAX, refuse_threads, whole};
pub use output::OutputOptions;
pub use search::{OptimizeArgs, OptimumArgs, SearchArgs, SwingsArgs};
pub use setup::{DriveArgs, OwnLaw, SetupArgs};

/// The names of the stated options, in the order of `options`. The `bool` is true for a stated
/// option.
pub fn stated<const N: usize>(
    options: [(&'static str, bool); N],
) -> impl Iterator<Item = &'static str> {
    options
        .into_iter()
        .filter(|(_, is_stated)| *is_stated)
        .map(|(option, _)| option)
}
