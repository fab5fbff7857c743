//! The best loft for the swings of a beginner and of a professional, compared with that of their
//! mean swing.
//!
//! `cargo run --release --example best_loft`

use longdrive::optimize::{Follow, Options};
use longdrive::study::swings::{
    Goal, Rule, Scenarios, Swings, SwingsSearch, price, swings_optimum,
};
use longdrive::study::uncertainty::Uncertain;
use longdrive::study::{Sense, Vary};
use longdrive::{Outcome, Result, Setup};

fn main() -> Result<()> {
    // assumed spreads; a launch monitor gives yours: longdrive delivery --shots
    let beginner = [
        "swing.speed=truncated(93.4 mph, 6 mph, 81.4 mph, 105.4 mph)",
        "swing.attack_angle=truncated(-1.6 deg, 4 deg, -9.6 deg, 6.4 deg)",
        "strike.high=truncated(-4.5 mm, 8 mm, -20.5 mm, 11.5 mm)",
    ];
    let professional = [
        "swing.speed=normal(115 mph, 1.2 mph)",
        "swing.attack_angle=normal(-0.9 deg, 1 deg)",
        "strike.high=normal(3 mm, 3 mm)",
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
        let scenarios = Scenarios::new(&swings, Rule::of(&swings, None, 0)?)?;
        let search = SwingsSearch {
            of: Goal::mean(Outcome::Carry),
            sense: Sense::Maximize,
            vary: vec![Vary::read(&setup, "club.loft=4deg..20deg")?],
            subject_to: vec![],
            options: Options::default(),
        };
        let best = swings_optimum(&setup, search, scenarios, &Follow::default())?;
        let alone = price(&setup, &swings, &best)?.nominal;
        let show = |x: &[f64]| {
            x.first()
                .map_or("none".into(), |x| format!("{:.2} deg", x.to_degrees()))
        };
        println!(
            "{golfer}: best loft {} over all swings, {} for the mean swing",
            show(&best.solution.x),
            alone.map_or_else(|why| why, |nominal| show(&nominal.design))
        );
    }
    Ok(())
}
