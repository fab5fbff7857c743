//! Cancellable parallel work on many drives.

use crate::error::Error;
use crate::optimize::Status;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// Warning for an interrupted check of the validity limits.
pub(super) const LIMITS_NOT_CHECKED: &str = "the validity limits of the drives were not checked: the \
                                        work was stopped before this check";

/// Applies `work` to the items in parallel, and returns the results in the order of the items.
/// `None` if `stop` became true before all items were started.
pub(super) fn each_until<T: Sync, R: Send>(
    items: &[T],
    stop: &AtomicBool,
    work: impl Fn(&T) -> R + Sync,
) -> Option<Vec<R>> {
    // a single item needs no threads
    if let [only] = items {
        return (!stop.load(Ordering::Relaxed)).then(|| vec![work(only)]);
    }
    items
        .par_iter()
        .map(|item| (!stop.load(Ordering::Relaxed)).then(|| work(item)))
        .collect()
}

/// The error for interrupted work; `before` completes "stopped before …".
pub(super) fn stopped_before(before: &str) -> Error {
    Error::NotConverged {
        status: Status::Interrupted.name(),
        message: format!("stopped before {before}").into(),
    }
}

#[cfg(test)]
mod tests {
    use super::each_until;
    use rayon::ThreadPoolBuilder;
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

    #[test]
    fn no_item_starts_after_cancellation_and_running_items_end() {
        let items: Vec<usize> = (0..100_000).collect();
        for threads in [1, 2, 4] {
            let pool = ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            for most in [1, 10, 1000] {
                let (stop, begun) = (AtomicBool::new(false), AtomicUsize::new(0));
                let work = |item: &usize| {
                    if begun.fetch_add(1, Ordering::SeqCst) + 1 >= most {
                        stop.store(true, Ordering::SeqCst);
                    }
                    *item
                };
                assert_eq!(pool.install(|| each_until(&items, &stop, work)), None);
                let begun = begun.into_inner();
                assert!(
                    (most..most + threads).contains(&begun),
                    "{begun} of {most} with {threads} threads"
                );
            }
            let never = AtomicBool::new(false);
            let squares = pool
                .install(|| each_until(&items, &never, |item| item * item))
                .unwrap();
            assert!(
                squares
                    .iter()
                    .enumerate()
                    .all(|(at, square)| *square == at * at)
            );
        }
    }
}
