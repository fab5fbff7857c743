//! Measures times as the C++ programs do (cpp/harness.hpp): CPU time of the fastest of many
//! batches.

use std::hint::black_box;

/// Duration of a batch, s.
const BATCH: f64 = 2e-3;

#[expect(
    unsafe_code,
    reason = "only the operating system reports CPU time, not the standard library"
)]
fn read(clock: libc::clockid_t) -> f64 {
    let mut time = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: `time` is valid for writing, and both clocks exist on every Linux
    unsafe { libc::clock_gettime(clock, &raw mut time) };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// CPU time of this thread, s.
pub fn thread() -> f64 {
    read(libc::CLOCK_THREAD_CPUTIME_ID)
}

/// CPU time of this process, s.
pub fn process() -> f64 {
    read(libc::CLOCK_PROCESS_CPUTIME_ID)
}

/// Time of one operation, s: the fastest of the batches within `budget` seconds.
pub fn fastest<R>(budget: f64, operation: impl Fn() -> R) -> f64 {
    black_box(operation());
    let start = thread();
    black_box(operation());
    let one = thread() - start;
    let batch = (BATCH / one.max(1e-9)).max(1.0) as u32;
    let end = thread() + budget;
    let mut best = f64::INFINITY;
    loop {
        let start = thread();
        for _ in 0..batch {
            black_box(operation());
        }
        let now = thread();
        best = best.min((now - start) / f64::from(batch));
        if now >= end {
            return best;
        }
    }
}
