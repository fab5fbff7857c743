//! Published test problems of nonlinear programming, each written once over the number.

#[macro_use]
mod case;
mod hock_schittkowski_2;
mod hock_schittkowski_3;
mod hock_schittkowski_4;

pub use case::Case;

/// Hock & Schittkowski (1981).
pub fn hock_schittkowski() -> Vec<Case> {
    [hock_schittkowski_2::all(), hock_schittkowski_3::all(), hock_schittkowski_4::all()]
        .into_iter()
        .flatten()
        .collect()
}
