//! The exported functions. Requests and answers lie in the memory of this module.

#![allow(
    unsafe_code,
    reason = "exported names, and the functions of the linker and of the page"
)]

use crate::answered;
use std::cell::RefCell;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
}

// SAFETY: the linker makes `__wasm_call_ctors`, and the page gives `progress`. During a call,
// neither of them touches memory of this module that Rust uses
unsafe extern "C" {
    safe fn __wasm_call_ctors();
}

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    safe fn progress(done: f64, of: f64);
}

/// The page must call this function once, before any other function. Without this function, each
/// call of an exported function would run the constructors of the C library.
#[unsafe(no_mangle)]
extern "C" fn _initialize() {
    __wasm_call_ctors();
}

/// Makes space for a request of this many bytes, and returns the address of the space.
#[unsafe(no_mangle)]
extern "C" fn input(bytes: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        request.resize(bytes, 0);
        request.as_mut_ptr()
    })
}

/// The address of the last answer.
#[unsafe(no_mangle)]
extern "C" fn output() -> *const u8 {
    ANSWER.with_borrow(Vec::as_ptr)
}

/// Answers the request, and returns the size of the answer, bytes.
#[unsafe(no_mangle)]
extern "C" fn answer() -> usize {
    let request = REQUEST.take();
    let answer = answered(&request, |done, of| progress(done, of));
    let bytes = answer.len();
    ANSWER.set(answer);
    bytes
}
