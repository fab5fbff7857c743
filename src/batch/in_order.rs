//! Work on chunks by several threads, whose results come in the order of the chunks.

use crate::error::{Error, Result};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc;

/// Chunks under way at a time, for each thread: enough that none waits for the order to be
/// restored.
const UNDER_WAY: u64 = 4;

/// More threads than this take longer to start than they save.
const MOST_THREADS: usize = 256;

/// WebAssembly has none unless it is compiled with atomics.
const HAS_THREADS: bool = cfg!(any(not(target_family = "wasm"), target_feature = "atomics"));

/// Works on each chunk that `next` gives, until there is none, and hands the results to `sink` in
/// the order of the chunks. A bounded number of chunks is under way at a time. Threads: 0 for as
/// many as there are processors, at most 256. Where the system has no threads, one chunk after the
/// other.
///
/// # Errors
/// What `next` and `sink` return; what comes before an error of `next` is handed on first.
pub(crate) fn in_order<T: Send, R: Send>(
    threads: usize,
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
        .num_threads(threads.min(MOST_THREADS))
        .build();
    let pool = pool.map_err(|error| Error::Output(std::io::Error::other(error)))?;
    let most = UNDER_WAY * pool.current_num_threads() as u64;
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
                            // nobody listens once the sink has refused
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
