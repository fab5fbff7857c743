//! Long work on threads of this process, while the thread of Python waits and checks for Ctrl-C.

use crate::boundary::{Answer, unpanicked};
use longdrive::Setup;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, AtomicPtr, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Time between two checks for Ctrl-C.
const CHECK_INTERVAL: Duration = Duration::from_millis(20);

/// The threads of one process. After a fork, the child process has a copy of this struct, but not
/// its threads.
struct Own {
    process: u32,
    pool: ThreadPool,
}

static OWN: AtomicPtr<Own> = AtomicPtr::new(std::ptr::null_mut());

/// The thread pool of this process. It has a thread for each processor that the process may use;
/// `available_parallelism` respects the quota of a container. The function uses no lock: if another
/// thread held a lock during a fork, the child process would wait for it forever.
fn pool() -> std::io::Result<&'static ThreadPool> {
    let process = std::process::id();
    let known = OWN.load(Ordering::Acquire);
    if let Some(own) = shared(known).filter(|own| own.process == process) {
        return Ok(&own.pool);
    }
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let named = |thread| format!("longdrive {thread}");
    let pool = ThreadPoolBuilder::new()
        .num_threads(threads)
        .thread_name(named)
        .build()
        .map_err(std::io::Error::other)?;
    let made = Box::into_raw(Box::new(Own { process, pool }));
    // the pool of a parent process is never freed: its threads do not exist in this process
    let kept = match OWN.compare_exchange(known, made, Ordering::AcqRel, Ordering::Acquire) {
        Ok(_) => made,
        // another thread created a pool first
        Err(first) => first,
    };
    shared(kept)
        .map(|own| &own.pool)
        .ok_or_else(|| std::io::Error::other("no threads"))
}

/// The value at `own`; `None` for a null pointer.
#[expect(
    unsafe_code,
    reason = "the pointer is from Box::into_raw; its target is never freed, and only read"
)]
fn shared(own: *const Own) -> Option<&'static Own> {
    // SAFETY: null, or from Box::into_raw in `pool`, and never freed
    unsafe { own.as_ref() }
}

/// Locks a value, which stays usable after a panic of a thread that had locked it.
pub fn lock<T>(value: &Mutex<T>) -> MutexGuard<'_, T> {
    value.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The result of work that Python may interrupt.
pub enum Ended<R> {
    /// The result of the work, with the exception if Python interrupted the work.
    Done(R, Option<PyErr>),
    /// The work was abandoned because of this exception.
    Abandoned(PyErr),
}

/// Runs work on a thread pool of this process, while other threads of Python run. The parallel
/// parts of the work (rayon) use the same pool: after a fork, rayon's global pool would wait for
/// threads that only the parent process has. Within 20 ms of a Ctrl-C, sets the flag that the work
/// checks, and returns Python's exception. `watch` is called at each check for Ctrl-C.
pub fn run<R: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> R + Send + 'static,
    watch: impl FnMut() -> PyResult<()>,
) -> Answer<R> {
    match run_to_answer(py, work, watch, |_| Duration::ZERO)? {
        Ended::Done(done, _) => Ok(done),
        Ended::Abandoned(raised) => Err(raised.into()),
    }
}

/// Number of time steps that take tenths of a second to compute. A time step of all lanes counts
/// once.
const LONG: f64 = 3e5;

/// True if these drives may take so long that Python has to check for Ctrl-C meanwhile.
pub fn is_long(setup: &Setup<f64>, drives: usize) -> bool {
    const LANES: f64 = 8.0;
    let flight = &setup.flight;
    flight.time_limit / flight.step * (drives as f64 / LANES).max(1.0) > LONG
}

/// Runs the work of one drive: long work on another thread, as [`run`] does, and short work on this
/// thread. The GIL is released, so other threads of Python run meanwhile.
pub fn run_drive<R: Send + 'static>(
    py: Python<'_>,
    is_long: bool,
    work: impl FnOnce(&AtomicBool) -> R + Send + 'static,
) -> Answer<R> {
    if is_long {
        return run(py, work, || Ok(()));
    }
    unpanicked(|| py.detach(|| work(&AtomicBool::new(false))))
}

/// Like `run`, for work that can return its result so far. After an interruption, `patience` stops
/// the work, and returns the time to wait for the result. A second Ctrl-C ends the wait.
pub fn run_to_answer<R: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> R + Send + 'static,
    mut watch: impl FnMut() -> PyResult<()>,
    patience: impl Fn(&PyErr) -> Duration,
) -> Answer<Ended<R>> {
    let pool = pool().map_err(longdrive::Error::Output)?;
    let stop = Arc::new(AtomicBool::new(false));
    let (finished, mut result) = sync_channel(1);
    let stopped = Arc::clone(&stop);
    pool.spawn(move || {
        // sending fails if the caller waits no more
        let _ = finished.send(unpanicked(|| work(&stopped)));
    });
    // the exception of the first interruption, and the end of the wait for the answer
    let mut ending: Option<(PyErr, Instant)> = None;
    loop {
        let heard;
        (heard, result) = py.detach(move || (result.recv_timeout(CHECK_INTERVAL), result));
        match heard {
            Ok(done) => return Ok(Ended::Done(done?, ending.map(|(raised, _)| raised))),
            Err(RecvTimeoutError::Timeout) => {
                let again = check_signals(py).and_then(|()| watch()).err();
                ending = match (ending, again) {
                    (None, None) => None,
                    (None, Some(raised)) => {
                        stop.store(true, Ordering::Relaxed);
                        let until = Instant::now() + patience(&raised);
                        Some((raised, until))
                    }
                    (Some((first, _)), Some(_)) => return Ok(Ended::Abandoned(first)),
                    (ending, None) => ending,
                };
                if let Some((raised, _)) = ending.take_if(|(_, until)| Instant::now() >= *until) {
                    return Ok(Ended::Abandoned(raised));
                }
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(crate::boundary::Failure::Internal(
                    "a thread ended without an answer".into(),
                ));
            }
        }
    }
}

/// Runs pending signal handlers, and raises exceptions that other threads have sent to this thread.
pub fn check_signals(py: Python<'_>) -> PyResult<()> {
    py.check_signals()?;
    py.run(c"pass", None, None)
}
