//! The best position of a movable weight of 15 g for a golfer whose swings vary, if the Rules of
//! Golf limit the moment of inertia; and the price of this limit.
//!
//! `cargo run --release --example design`

use longdrive::optimize::Observer;
use longdrive::study::design::{Design, golfer};
use longdrive::study::swings::{Rule, Scenarios};
use longdrive::study::{Goal, Search, Sense, Vary, optimum};
use longdrive::{Outcome, Result, Setup};

fn main() -> Result<()> {
    let mut setup = Setup::preset("modern-driver")?;
    // the head of 204 g includes the weight, which starts at the centre of mass of the other 189 g
    setup.set_all([
        ("club.loft", "12 deg"),
        ("club.mass", "189 g"),
        ("club.weight_1.mass", "15 g"),
        ("club.weight_1.depth", "40.8 mm"),
        ("club.weight_1.toe", "0 mm"),
    ])?;
    let vary = [
        "club.weight_1.depth=0mm..110mm",
        "club.weight_1.toe=-50mm..50mm",
    ];
    let swings = golfer(&setup)?;
    let of = Goal::read("mean(carry) - 0.5*rms(lateral)", None)?;
    let rule = Rule::of(&swings, [&of], None, 0)?;
    let search = Search {
        of,
        sense: Sense::Maximize,
        vary: Vary::read_all(&setup, vary)?,
        scenarios: Scenarios::new(&swings, rule)?,
        ..Search::largest(Outcome::Carry)
    };
    let design = Design::new(&setup, search, true)?;
    let best = optimum(&setup, design.search.clone(), Observer::default())?;
    println!("{}: {}", best.status(), best.message());
    for (vary, x) in best.search.vary.iter().zip(&best.solution.x) {
        println!(
            "{} = {}",
            vary.parameter.name,
            vary.parameter.show(Some(*x))
        );
    }
    for state in design.constraint_states(&best) {
        let constraint = &state.constraint;
        let value = state
            .value
            .map_or("unknown".into(), |value| constraint.unit.show(value));
        // a yard is 0.9144 m
        let price = state.price.map(|price| {
            format!(
                ", {:+.3} yd for each 100 g cm^2 of the limit",
                price * constraint.reported_change / 0.9144
            )
        });
        println!(
            "{}: {value} ({}){}",
            constraint.name,
            constraint.expression,
            price.unwrap_or_default()
        );
    }
    Ok(())
}
