//! A stack for each thread, with one value for each nested call.

use std::cell::RefCell;
use std::thread::LocalKey;

/// Removes the innermost value of a stack, also after a panic.
struct PopOnDrop<T: 'static>(&'static LocalKey<RefCell<Vec<T>>>);

impl<T: 'static> Drop for PopOnDrop<T> {
    fn drop(&mut self) {
        self.0.with_borrow_mut(Vec::pop);
    }
}

/// Runs `work` with `value` on top of the stack of this thread.
pub(crate) fn with_innermost<T: 'static, R>(
    stack: &'static LocalKey<RefCell<Vec<T>>>,
    value: T,
    work: impl FnOnce() -> R,
) -> R {
    stack.with_borrow_mut(|all| all.push(value));
    let _popped = PopOnDrop(stack);
    work()
}
