//! The best loft for the swings of a beginner and of a professional, compared with the best loft
//! for their mean swing.
//!
//! `cargo run --release --example best_loft`

use longdrive::optimize::Observer;
use longdrive::study::swings::{Rule, Scenarios, Swings, analyse_over_swings};
use longdrive::study::uncertainty::Uncertain;
use longdrive::study::{Goal, Search, Sense, Vary, optimum};
use longdrive::{Outcome, Result, Setup};
use std::sync::Arc;

fn main() -> Result<()> {
    // assumed spreads; `longdrive delivery --shots` computes yours from launch-monitor data
    let beginner = [
        "swing.speed=truncated(93.4 mph, 6 mph, 81.4 mph, 105.4 mph)",
        "swing.attack_angle=truncated(-1.6 deg, 4 deg, -9.6 deg, 6.4 deg)",
        "strike.high=truncated(-2.6 mm, 8 mm, -18.6 mm, 13.4 mm)",
    ];
    let professional = [
        "swing.speed=normal(115 mph, 1.2 mph)",
        "swing.attack_angle=normal(-0.9 deg, 1 deg)",
        "strike.high=normal(6 mm, 3 mm)",
    ];
    for (golfer, preset, distributions) in [
        ("beginner", "amateur-average", beginner),
        ("professional", "tour-average", professional),
    ] {
        let setup = Setup::preset(preset)?;
        let inputs = distributions
            .iter()
            .map(|text| Uncertain::read(&setup, text))
            .collect::<Result<_>>()?;
        let swings = Swings::distributed(inputs, &[])?;
        let of = Goal::mean(Outcome::Carry);
        let scenarios = Scenarios::new(&swings, Rule::of(&swings, [&of], None, 0)?)?;
        let search = Search {
            of,
            sense: Sense::Maximize,
            vary: vec![Vary::read(&setup, "club.loft=4deg..20deg")?],
            scenarios,
            ..Search::largest(Outcome::Carry)
        };
        let best = optimum(&setup, search, Observer::default())?;
        let analysis = analyse_over_swings(&setup, &swings, &best, &Arc::default())?;
        let nominal = analysis.expect("nothing interrupts it").nominal;
        let show = |x: &[f64]| {
            x.first()
                .map_or("none".into(), |x| format!("{:.2} deg", x.to_degrees()))
        };
        println!(
            "{golfer}: best loft {} over all swings, {} for the mean swing",
            show(&best.solution.x),
            nominal.map_or_else(|why| why, |nominal| show(&nominal.design))
        );
    }
    Ok(())
}
