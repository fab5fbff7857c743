//! The longest drive for a golfer with a slower swing and an attack angle of at most 3°, and the
//! price of each bound.
//!
//! `cargo run --release --example longest_drive`

use longdrive::optimize::Observer;
use longdrive::study::{Search, Vary, optimum};
use longdrive::{Outcome, Setup};

fn main() -> longdrive::Result<()> {
    let mut setup = Setup::preset("modern-driver")?;
    setup.set("swing.speed", "85 mph")?;
    let vary = ["club.loft=6deg..18deg", "swing.attack_angle=-5deg..3deg"];
    let search = Search {
        vary: Vary::read_all(&setup, vary)?,
        ..Search::largest(Outcome::Carry)
    };

    let observer = Observer::showing(|iteration| {
        println!("iteration {}: {:.4} m", iteration.number, -iteration.value)
    });
    let best = optimum(&setup, search, observer)?;
    println!("{}: {}", best.status(), best.message());
    for (i, vary) in best.search.vary.iter().enumerate() {
        let price = best.solution.upper_multipliers[i] - best.solution.lower_multipliers[i];
        println!(
            "{} = {}, price of its bound {price:.3} m per rad",
            vary.parameter.name,
            vary.parameter.show(Some(best.solution.x[i]))
        );
    }
    if let Some(carry) = best.value() {
        println!("carry {}", Outcome::Carry.show(carry));
    }
    Ok(())
}
