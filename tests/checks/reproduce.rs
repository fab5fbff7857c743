//! The results of the published studies, recomputed.

use crate::command_line::{Written, json, longdrive, number, written};
use crate::common::close;
use longdrive::reproduce::{
    LandingDefinition, Mae494, RecomputedOptimum, SearchMethod, WinfieldTan, mae494, winfield_tan,
};
use longdrive::{Drive, Outcome, Setup, derivative};
use serde_json::Value;
use std::sync::LazyLock;

pub static FOUND: LazyLock<Mae494> = LazyLock::new(|| mae494(|_| ()).unwrap());
pub static PAPER: LazyLock<WinfieldTan> = LazyLock::new(|| winfield_tan(|_| ()).unwrap());
/// Output and files of the program for the report, which takes seconds.
pub static REPORT: LazyLock<Written> = LazyLock::new(|| written(&["reproduce", "mae494"]));
/// Output and files of the program for the paper.
pub static PAPER_WRITTEN: LazyLock<Written> =
    LazyLock::new(|| written(&["reproduce", "winfield-tan"]));

fn carry(loft: f64, attack: f64) -> f64 {
    let mut setup = Setup::preset("mae494").unwrap();
    (setup.club.loft, setup.swing.attack_angle) = (loft, attack);
    Drive::new(&setup).unwrap().landed().unwrap().carry
}

#[test]
fn published_optimum_is_the_peak_of_the_regression_with_its_slip() {
    let regression = &FOUND.regression;
    // table 1 of the report, at an elevation of 10°, prints the loft to four decimals
    close(
        regression.with_wrong_powers.loft.to_degrees(),
        4.4166,
        1.0,
        5e-5,
        "slipped",
    );
    close(
        regression.as_fitted.loft.to_degrees(),
        17.02,
        1.0,
        5e-3,
        "as fitted",
    );
    // the report's slip, wrong powers in its regression, increases the error of the distance
    assert!(
        regression.with_wrong_powers.distance > 1000.0 && regression.as_fitted.distance < 300.0
    );
}

#[test]
fn independent_optimum_of_the_reports_model_and_the_price_of_its_bound() {
    let exact = FOUND.optimum.exact();
    close(exact.loft.to_degrees(), 14.682_922_531_9, 1.0, 1e-8, "loft");
    assert_eq!(exact.attack_angle, 10.0_f64.to_radians());
    close(exact.carry, 153.333_552_730_536, 1.0, 1e-9, "carry");
    close(
        FOUND.optimum.best.solution.upper_multipliers[1],
        60.292_494_887_4,
        1.0,
        1e-6,
        "price",
    );
}

#[test]
fn independent_bounds_are_active_at_eight_of_thirteen_lofts_and_all_attack_angles() {
    let active = |rows: &[RecomputedOptimum]| {
        let is_at_a_bound = |row: &&RecomputedOptimum| !row.best.active().is_empty();
        rows.iter().filter(is_at_a_bound).count()
    };
    assert_eq!((FOUND.table1.len(), active(&FOUND.table1)), (13, 8));
    assert_eq!((FOUND.table2.len(), active(&FOUND.table2)), (9, 9));
    for row in FOUND.table1.iter().chain(&FOUND.table2) {
        let exact = row.exact();
        close(
            carry(exact.loft, exact.attack_angle),
            exact.carry,
            100.0,
            1e-12,
            "carry flown again",
        );
        // no other loft or attack angle on a grid over the range of the row carries farther
        for part in 0..=40 {
            let along =
                |low: f64, high: f64| (low + f64::from(part) / 40.0 * (high - low)).to_radians();
            let is_loft = row.best.search.vary[0].parameter.name == "club.loft";
            let mut setup = row.best.setup;
            if is_loft {
                setup.club.loft = along(0.0, 20.0)
            } else {
                setup.swing.attack_angle = along(-10.0, 10.0)
            }
            if let Some(other) = Outcome::Carry.value(&Drive::new(&setup).unwrap()) {
                assert!(
                    other <= exact.carry + 1e-9,
                    "{other} beyond {}",
                    exact.carry
                );
            }
        }
        match row.at_printed {
            Some(at) => close(row.cost(), exact.carry - at, 1.0, 1e-12, "cost"),
            None => {
                let mut setup = row.best.setup;
                (setup.club.loft, setup.swing.attack_angle) =
                    (row.printed.loft, row.printed.attack_angle);
                let angle = Outcome::LaunchAngle
                    .of(&Drive::new(&setup).unwrap())
                    .unwrap();
                assert!(angle < 0.0, "only a ball struck down does not fly");
            }
        }
    }
}

#[test]
fn independent_bound_by_energy_and_grid_of_launches() {
    let energy = &FOUND.energy;
    close(
        energy.fastest,
        1.7 / (1.0 + 0.049 / 0.230) * 44.7,
        1.0,
        1e-12,
        "speed",
    );
    close(
        energy.farthest.carry,
        170.574_315_6,
        1.0,
        1e-6,
        "the model page's global maximum",
    );
    assert_eq!(energy.farthest.speed, energy.fastest);
    // no launch carries farther, on a grid of angles, spins and ball speeds up to `energy.fastest`
    let setup = Setup::preset("mae494").unwrap();
    for (speed, angle, spin) in (1..=4).flat_map(|v| {
        (1..18).flat_map(move |a| (0..8).map(move |s| (v, f64::from(5 * a), f64::from(100 * s))))
    }) {
        let speed = energy.fastest * f64::from(speed) / 4.0;
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let launch = longdrive::launch::Launch {
            velocity: longdrive::number::Vector::new(speed * sin, 0.0, speed * cos),
            spin: longdrive::number::Vector::new(0.0, spin, 0.0),
        };
        if let longdrive::flight::Flight::Landed(landed) =
            longdrive::flight::fly(&setup, &launch).unwrap()
        {
            assert!(
                landed.carry < energy.farthest.carry,
                "{speed} m/s, {angle}°, {spin} rad/s"
            );
        }
    }
    assert!(energy.needed.speed > 1.5 * energy.fastest && energy.ball_needed > 2.0 * energy.ball);
    close(
        energy.needed.carry,
        248.48,
        1.0,
        1e-6,
        "the report's longest distance",
    );
}

#[test]
fn exact_parts_of_the_launch_add_up_to_the_gradient() {
    let parts = &FOUND.subsystems;
    let setup = &FOUND.optimum.best.setup;
    let wrt = ["club.loft", "swing.attack_angle"].map(|name| setup.variable(name).unwrap());
    let whole = derivative::gradient(setup, Outcome::Carry, &wrt).unwrap();
    close(
        parts.by_loft.to_array().iter().sum(),
        whole.gradient[0],
        60.0,
        1e-10,
        "loft",
    );
    close(
        parts.by_attack_angle.to_array().iter().sum(),
        whole.gradient[1],
        60.0,
        1e-10,
        "attack angle",
    );
    assert!(
        parts.by_loft.to_array().iter().all(|part| part.abs() > 1.0),
        "each part has an effect"
    );
    assert!(
        parts.flight.carry > parts.whole.carry + 10.0 && parts.flight.speed == parts.whole.speed
    );
}

#[test]
fn independent_derivatives_of_the_loop_have_the_wrong_sign_at_every_loft() {
    let noise = &FOUND.noise;
    assert_eq!((noise.slopes.len(), noise.wrong_signs), (15, 15));
    let ten = noise
        .slopes
        .iter()
        .find(|at| (at.loft.to_degrees() - 10.0).abs() < 1e-9)
        .unwrap();
    close(ten.exact, 336.769_746_388_603, 1.0, 1e-8, "exact");
    close(ten.overshot, -65.0, 1.0, 1.0, "the loop's");
    for at in &noise.slopes {
        // the loop stops at the end of a step, so its derivative is the derivative at a fixed time.
        // With an interpolation to the landing it is the derivative at the landing
        close(
            at.overshot,
            at.at_fixed_time,
            at.at_fixed_time.abs(),
            0.01,
            "at fixed time",
        );
        close(
            at.interpolated,
            at.exact,
            at.exact.abs().max(100.0),
            0.02,
            "interpolated",
        );
    }
    for shorter in &noise.shorter_steps {
        close(
            shorter.overshot,
            ten.at_fixed_time,
            65.0,
            0.01,
            "a shorter step does not help",
        );
    }
    // carry over loft is a sawtooth: a tooth is at most as high as the distance that the ball flies
    // downrange in a step
    assert!(noise.teeth.count > 10 && (0.1..0.6).contains(&noise.teeth.height));
}

#[test]
fn finite_differences_on_the_loop_miss_the_optimum_and_exact_derivatives_find_it() {
    let best = FOUND.optimum.exact().carry;
    for searches in &FOUND.noise.searches {
        assert_eq!(searches.ends.len(), 20);
        let losses = searches.losses(best);
        let found = losses.iter().filter(|loss| **loss <= 0.01).count();
        match (searches.landing, searches.method) {
            (LandingDefinition::Overshot, _) => {
                assert!(found <= 1, "{found} by {:?}", searches.method)
            }
            (LandingDefinition::Interpolated, _) | (_, SearchMethod::QuasiNewton) => {
                assert_eq!(found, 20, "{:?}", searches.method)
            }
            (LandingDefinition::Smooth, SearchMethod::Exact) => {
                assert_eq!(found, 20);
                assert!(
                    searches.flights() < 200
                        && searches
                            .ends
                            .iter()
                            .all(|end| end.message.contains("converged"))
                );
            }
            (LandingDefinition::Smooth, _) => {
                assert!(found >= 15, "{found} by {:?}", searches.method)
            }
        }
        let same = |end: usize| searches.ends[end].start == FOUND.noise.searches[0].ends[end].start;
        assert!((0..20).all(same), "the same starts for all");
    }
}

#[test]
fn sensitivities_of_the_parametric_study_predict_the_new_optimum() {
    let study = &FOUND.parametric;
    for changed in &study.changes {
        let moved = changed.resolved.value.unwrap();
        let size = (moved - FOUND.optimum.exact().carry).abs();
        close(
            changed.predicted.value.unwrap(),
            moved,
            size,
            0.02,
            changed.parameter.name,
        );
    }
    let idle = ["club.inertia.xx", "club.inertia.zz"];
    for constant in &study.sensitivities {
        let takes_part = !idle.contains(&constant.parameter.name);
        assert_eq!(
            constant.carry_per_cent() != 0.0,
            takes_part,
            "{}",
            constant.parameter.name
        );
    }
}

#[test]
fn published_third_study_ends_before_its_optimum() {
    let average = &FOUND.average;
    assert_eq!(average.printed.to_degrees().round(), 16.0);
    // carry increases up to 18°, the largest loft of the MAE 494 report
    assert!(
        average
            .rows
            .windows(2)
            .all(|pair| pair[0].carry < pair[1].carry)
    );
    assert!(average.best.loft.to_degrees() > 18.0);
    assert!(
        average
            .rows
            .iter()
            .all(|row| row.carry <= average.best.carry)
    );
    let mean = (0..=10)
        .map(|attack| carry(average.best.loft, f64::from(attack).to_radians()))
        .sum::<f64>()
        / 11.0;
    close(average.best.carry, mean, 100.0, 1e-12, "mean");
}

#[test]
fn published_and_computed_numbers_in_json_and_text() {
    let (status, found) = json(&["reproduce", "mae494"]);
    assert_eq!(status, 0);
    close(
        number(&found["slipped_optimum"]["club.loft"]).to_degrees(),
        4.4166,
        1.0,
        5e-5,
        "slipped",
    );
    close(
        number(&found["optimum"]["carry"]),
        153.333_553,
        1.0,
        1e-6,
        "optimum",
    );
    close(
        number(&found["optimum"]["multipliers"]["swing.attack_angle"]["upper"]),
        60.2925,
        1.0,
        5e-5,
        "price",
    );
    let rows = |table: &Value| table.as_array().unwrap().len();
    for at in [&found, &found["printed"]] {
        assert_eq!((rows(&at["table1"]), rows(&at["table2"])), (13, 9));
        for key in ["club.loft", "swing.attack_angle", "carry"] {
            assert!(at["table1"][12][key].is_number() && at["table2"][0][key].is_number());
        }
    }
    assert_eq!(number(&found["printed"]["table1"][10]["carry"]), 248.48);
    assert_eq!(
        found["table1"][0]["carry_at_printed"],
        Value::Null,
        "a missing flight is not a carry of zero"
    );
    assert_eq!(rows(&found["noise"]["slopes"]), 15);

    let output = &REPORT.output;
    assert_eq!(output.status, 0);
    for words in [
        "14.6829°",
        "4.4166°",
        "17.0206°",
        "170.57 m",
        "8 of 13",
        "9 of 9",
        "-65.4 m/rad",
        "+336.8 m/rad",
    ] {
        assert!(output.out.contains(words), "{words}: {}", output.out);
    }
}

#[test]
fn a_folder_gets_the_report_with_its_figures_and_their_data() {
    assert_eq!(REPORT.output.status, 0, "{}", REPORT.output.err);
    let read = |name: &str| REPORT.file(name);
    let (markdown, page) = (read("report.md"), read("index.html"));
    for name in ["table-1", "teeth", "slopes", "ends"] {
        assert!(
            markdown.contains(&format!("({name}-metric.svg)")),
            "in the units of the report"
        );
        for system in ["us", "metric"] {
            roxmltree::Document::parse(read(&format!("{name}-{system}.svg"))).unwrap();
        }
        assert!(read(&format!("{name}.csv")).lines().count() > 5);
    }
    assert_eq!(page.matches("<figure>").count(), 4);
    assert_eq!(
        page.matches("http").count(),
        page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count(),
        "no link"
    );

    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("file"), "").unwrap();
    let refused = longdrive(&[
        "reproduce",
        "mae494",
        "-o",
        folder.path().join("file").to_str().unwrap(),
    ]);
    assert_eq!(refused.status, 2);
    assert!(
        refused.err.contains("it is a file; name a folder"),
        "{}",
        refused.err
    );
}

#[test]
fn an_unknown_study_is_refused_with_a_list() {
    let refused = longdrive(&["reproduce", "mae495"]);
    assert_eq!(refused.status, 2);
    assert!(refused.err.contains("mae494"), "{}", refused.err);
}
