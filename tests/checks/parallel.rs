//! Checks of many inputs in parallel.

use crate::common::caught;
use rayon::prelude::*;
use std::fmt::Debug;

/// Results of a check of each input, in parallel. A check that panics fails the test with its
/// message and its input: the message itself goes to the output of the test that started rayon's
/// threads.
#[track_caller]
pub fn in_parallel<T: Debug + Sync, R: Send>(
    inputs: &[T],
    check: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let checked = |input: &T| {
        caught(|| check(input)).map_err(|message| format!("{message}\nof the input {input:?}"))
    };
    let results: Result<_, _> = inputs.par_iter().map(checked).collect();
    results.unwrap_or_else(|failure| panic!("{failure}"))
}
