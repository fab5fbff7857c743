//! The page of the explorer, and the error if the page cannot be served.

use crate::Error;

/// The page: one HTML file that contains the core, compiled to WebAssembly.
#[cfg(feature = "explore")]
pub const PAGE: &[u8] = include_bytes!("../../../web/dist/explorer.html"); // if it is missing: run web/build

/// The page, if it is compiled in.
pub fn compiled_in() -> Option<&'static [u8]> {
    #[cfg(feature = "explore")]
    return Some(PAGE);
    #[cfg(not(feature = "explore"))]
    None
}

/// The text in the page that precedes the content security policy.
#[cfg(feature = "explore")]
const POLICY: &[u8] = b"http-equiv=\"Content-Security-Policy\" content=\"";

/// The content security policy that the page states.
#[cfg(feature = "explore")]
pub fn policy(page: &[u8]) -> Option<&str> {
    let at = page.windows(POLICY.len()).position(|text| text == POLICY)?;
    let policy = page[at + POLICY.len()..]
        .split(|byte| *byte == b'"')
        .next()?;
    std::str::from_utf8(policy).ok()
}

/// The error if the explorer cannot be served.
pub fn refused(why: &str) -> Error {
    Error::unreadable("explore", why)
}
