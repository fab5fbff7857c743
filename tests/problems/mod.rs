//! Published test problems of nonlinear programming, generic over the number type.

#[macro_use]
mod case;
mod hock_schittkowski_1;
mod hock_schittkowski_1b;
mod hock_schittkowski_2;
mod hock_schittkowski_3;
mod hock_schittkowski_4;
mod more_garbow_hillstrom;

pub use case::Case;

/// Hock & Schittkowski (1981).
pub fn hock_schittkowski() -> Vec<Case> {
    let parts = [
        hock_schittkowski_1::all(),
        hock_schittkowski_1b::all(),
        hock_schittkowski_2::all(),
        hock_schittkowski_3::all(),
        hock_schittkowski_4::all(),
    ];
    parts.into_iter().flatten().collect()
}

/// Moré, Garbow & Hillstrom (1981).
pub fn more_garbow_hillstrom() -> Vec<Case> {
    more_garbow_hillstrom::all()
}
