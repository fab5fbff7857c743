//! The physics with another number type: the third derivative of carry by loft with num-dual's
//! `Dual3_64`, and the cubic Taylor polynomial of carry compared with drives.
//!
//! `cargo run --release --example any_number`

use longdrive::number::{Number, Numbers};
use longdrive::{Drive, Outcome, Setup};
use num_dual::Dual3_64;

fn carry<T: Number>(setup: &Setup<T>) -> longdrive::Result<T> {
    Outcome::Carry.of(&Drive::new(setup)?)
}

fn main() -> longdrive::Result<()> {
    let setup = Setup::modern_driver();
    let lifted = setup.map(|parameter, value| {
        if parameter.name == "club.loft" {
            Dual3_64::from(value).derivative()
        } else {
            Dual3_64::constant(value)
        }
    });
    let c = carry(&lifted)?;
    println!(
        "carry {:.6} m, d {:.6}, d² {:.6}, d³ {:.4} (m, rad)",
        c.re, c.v1, c.v2, c.v3
    );

    for degrees in [0.25, 0.5, 1.0_f64] {
        let h = degrees.to_radians();
        let mut moved = setup;
        moved.club.loft += h;
        let flown = carry(&moved)?;
        let quadratic = c.re + h * (c.v1 + 0.5 * h * c.v2);
        let cubic = quadratic + h * h * h * c.v3 / 6.0;
        println!(
            "{degrees:>5}° more: flown {flown:.6} m, quadratic off by {:.1e} m, cubic by {:.1e} m",
            quadratic - flown,
            cubic - flown
        );
    }
    Ok(())
}
