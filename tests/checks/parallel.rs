//! Checks of many inputs in parallel.

use crate::common::caught;
use rayon::prelude::*;
use std::fmt::Debug;

/// Runs a check of each input in parallel, and returns the results. If a check panics, the test
/// fails with the message and the input. The output of another test may also show the panic.
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
