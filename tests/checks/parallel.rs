//! Checks of many inputs in parallel.

use crate::common::caught;
use rayon::prelude::*;
use std::fmt::Debug;

/// Results of a check of each input, in parallel. If a check panics, the test fails with its
/// message and its input. The panic itself may be printed in another test's output, whose thread
/// started rayon's pool.
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
