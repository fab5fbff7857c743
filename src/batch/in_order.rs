//! Parallel work on chunks with results in the order of the chunks.

use crate::error::{Error, Result};
use rayon::ThreadPoolBuildError;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc;

/// Maximum number of chunks per thread that are begun but not yet passed to `sink`. With this
/// number, threads need not wait for `sink`.
const CHUNKS_PER_THREAD: u64 = 4;

/// Maximum number of threads. To start more threads takes longer than they save.
const MOST_THREADS: usize = 256;

/// WebAssembly has threads only if compiled with atomics.
pub(crate) const HAS_THREADS: bool =
    cfg!(any(not(target_family = "wasm"), target_feature = "atomics"));

/// The number of threads: `wanted`, or one per processor if `wanted` is 0. At most
/// [`MOST_THREADS`], and at most one per chunk.
fn thread_count(wanted: usize, chunks: u64) -> usize {
    let wanted = if wanted == 0 { processors() } else { wanted };
    let chunks = usize::try_from(chunks).unwrap_or(usize::MAX);
    wanted.min(MOST_THREADS).min(chunks).max(1)
}

/// The number of processors. The environment variable `RAYON_NUM_THREADS` overrides it, as in
/// rayon.
pub(crate) fn processors() -> usize {
    std::env::var("RAYON_NUM_THREADS")
        .ok()
        .and_then(|number| number.parse().ok())
        .filter(|number| *number > 0)
        .unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from))
}

/// Calls `work` on each chunk from `next` in parallel, and `sink` on the results in the order of
/// the chunks. The number of chunks that are begun but not yet passed to `sink` is bounded.
/// `chunks` is the number of chunks, or `u64::MAX` if it is unknown. `threads` is the number of
/// threads; 0 means one per processor. There are at most 256 threads, and at most one per chunk.
/// Without threads (WebAssembly) the chunks are processed one by one.
///
/// # Errors
/// Errors of `next` and `sink`. If `next` fails, the earlier results are delivered first.
pub(crate) fn in_order<T: Send, R: Send>(
    threads: usize,
    chunks: u64,
    mut next: impl FnMut() -> Result<Option<T>>,
    work: impl Fn(T) -> R + Sync,
    mut sink: impl FnMut(R) -> Result<()>,
) -> Result<()> {
    if !HAS_THREADS {
        while let Some(chunk) = next()? {
            sink(work(chunk))?;
        }
        return Ok(());
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(thread_count(threads, chunks))
        .build()
        .map_err(not_started)?;
    let most = CHUNKS_PER_THREAD * pool.current_num_threads() as u64;
    pool.in_place_scope(|scope| {
        let (finished, results) = mpsc::channel();
        let mut waiting = BTreeMap::new();
        let (mut begun, mut due) = (0, 0);
        let mut end = None;
        loop {
            while end.is_none() && begun - due < most {
                match next() {
                    Ok(None) => end = Some(Ok(())),
                    Err(error) => end = Some(Err(error)),
                    Ok(Some(chunk)) => {
                        let (finished, work) = (finished.clone(), &work);
                        scope.spawn(move |_| {
                            // `send` fails after an error of `sink`, which drops `results`
                            let _ = finished
                                .send((begun, catch_unwind(AssertUnwindSafe(|| work(chunk)))));
                        });
                        begun += 1;
                    }
                }
            }
            if due == begun {
                return end.unwrap_or(Ok(()));
            }
            let Ok((chunk, result)) = results.recv() else {
                return Ok(());
            };
            waiting.insert(chunk, result.unwrap_or_else(|panic| resume_unwind(panic)));
            while let Some(result) = waiting.remove(&due) {
                sink(result)?;
                due += 1;
            }
        }
    })
}

fn not_started(error: ThreadPoolBuildError) -> Error {
    let reason = format!("the threads cannot be started ({error}); take fewer");
    Error::unreadable("`threads`", reason)
}

#[cfg(test)]
mod tests {
    use super::{MOST_THREADS, not_started, processors, thread_count};

    #[test]
    fn exact_thread_counts_by_processors_chunks_and_the_limit() {
        assert_eq!(thread_count(0, u64::MAX), processors().min(MOST_THREADS));
        assert_eq!(thread_count(0, 2), processors().min(2));
        assert_eq!(thread_count(1000, u64::MAX), MOST_THREADS);
        assert_eq!(thread_count(5, 3), 3);
        assert_eq!([0, 1, 8].map(|wanted| thread_count(wanted, 0)), [1; 3]);
    }

    #[test]
    fn threads_that_cannot_be_started_are_an_error_of_their_number() {
        let error = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .spawn_handler(|_| Err(std::io::Error::other("no memory")))
            .build()
            .map(|_| ())
            .unwrap_err();
        assert_eq!(
            not_started(error).to_string(),
            "`threads`: the threads cannot be started (no memory); take fewer"
        );
    }
}
