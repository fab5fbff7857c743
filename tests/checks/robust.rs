//! One design for several models, compared with the best design of each model and with a grid of
//! designs.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{SET_RIGID, close};
use longdrive::optimize::{Iteration, Observers};
use longdrive::parameters::SetupFile;
use longdrive::report::{Report, RobustReport};
use longdrive::study::swings::{Model, Robust, robust};
use longdrive::study::{Goal, Search, Sense, Vary};
use longdrive::{Drive, Error, Outcome, Setup};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

fn search(setup: &Setup<f64>) -> Search {
    let vary = vec![Vary::read(setup, "club.loft=4deg..20deg").unwrap()];
    let (of, sense) = (Goal::from(Outcome::Carry), Sense::Maximize);
    Search {
        of,
        sense,
        vary,
        ..Search::largest(Outcome::Carry)
    }
}

fn found(setup: &Setup<f64>, changes: &[&str]) -> Robust {
    let own = [Model::as_set_up(setup)].into_iter();
    let models = own
        .chain(changes.iter().map(|text| Model::read(setup, text).unwrap()))
        .collect();
    robust(models, search(setup), 1, &Observers::default()).unwrap()
}

/// Two models with different best lofts: at the minimax design both have equal losses, and no loft
/// of a fine grid has a smaller largest loss.
#[test]
fn independent_loft_of_the_smallest_greatest_loss_of_two_models_by_a_grid() {
    let mut setup = Setup::preset("modern-driver").unwrap();
    setup
        .set_all([("flight.method", "dp8"), ("flight.step", "400 ms")])
        .unwrap();
    let change = "swing.attack_angle=-4 deg";
    let best = found(&setup, &[change]);
    assert_eq!(best.status(), "converged");
    close(
        best.models[0].loss,
        best.models[1].loss,
        1.0,
        1e-8,
        "both lose the same",
    );
    close(
        best.models[0].multiplier + best.models[1].multiplier,
        1.0,
        1.0,
        1e-8,
        "shares",
    );
    let mut shares = best.models.iter().map(|of| of.multiplier);
    assert!(shares.all(|share| share > 0.01));
    let models = [setup, Model::read(&setup, change).unwrap().setup];
    let carry = |model: &Setup<f64>, loft: f64| {
        let mut model = *model;
        model.club.loft = loft;
        Outcome::Carry.of(&Drive::new(&model).unwrap()).unwrap()
    };
    let lofts = best
        .models
        .iter()
        .map(|of| of.best.solution.x[0])
        .collect::<Vec<_>>();
    assert!(
        (lofts[0] - lofts[1]).abs() > 1e-3,
        "the best lofts differ: {lofts:?}"
    );
    let own = best
        .models
        .iter()
        .map(|of| of.best.value().unwrap())
        .collect::<Vec<_>>();
    let greatest = |loft: f64| {
        models
            .iter()
            .zip(&own)
            .map(|(model, own)| own - carry(model, loft))
            .fold(0.0, f64::max)
    };
    close(
        best.greatest(),
        greatest(best.design[0]),
        1.0,
        1e-6,
        "greatest loss",
    );
    let grid = (0..400).map(|k| greatest((8.0 + 0.02 * f64::from(k)).to_radians()));
    assert!(grid.fold(f64::INFINITY, f64::min) >= best.greatest() - 1e-7);
    for (k, of) in best.models.iter().enumerate() {
        let row = &of.losses_of_bests;
        close(
            row[k].unwrap(),
            0.0,
            1.0,
            1e-8,
            "nothing is lost at the own best",
        );
        let other = best.models[1 - k].best.solution.x[0];
        close(
            row[1 - k].unwrap(),
            own[k] - carry(&models[k], other),
            1.0,
            1e-6,
            "at the other's best",
        );
    }
}

/// A model limits the design only if its loss is the largest.
#[test]
fn exact_zero_loss_for_a_model_equal_to_the_setup() {
    let setup = Setup::preset("mae494").unwrap();
    let best = found(&setup, &["impact.friction=50"]);
    close(best.greatest(), 0.0, 1.0, 1e-7, "nothing is lost");
}

#[test]
fn the_answer_judges_whether_one_design_suits_all_models() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("best.toml").display().to_string();
    let ask = ["robust", "--vary", "club.loft=6deg..16deg"];
    let models = [
        "--model",
        "aero.law=ferguson",
        "--model",
        "impact.gear_scale=0.5,impact.friction=0.3",
    ];
    let (status, answer) = json(&[&ask[..], &models, &["-o", &file]].concat());
    assert_eq!(
        (status, answer["status"].as_str()),
        (0, Some("converged")),
        "{answer:#}"
    );
    let greatest = number(&answer["greatest_loss"]);
    assert_eq!(answer["holds_for_all"], (greatest <= 0.9144), "{answer:#}");
    let written = SetupFile::read(&std::fs::read_to_string(&file).unwrap(), "best.toml")
        .unwrap()
        .setup;
    assert_eq!(written.club.loft, number(&answer["optimum"]["club.loft"]));
    let in_metric = [
        &ask[..],
        &models,
        &["--units", "metric", "--overwrite", "-o", &file],
    ];
    assert_eq!(longdrive(&in_metric.concat()).status, 0);
    let text = std::fs::read_to_string(&file).unwrap();
    let about = text.lines().take_while(|line| line.starts_with('#'));
    let about: String = about.collect();
    assert!(
        about.contains(" m of carry") && !about.contains(" yd"),
        "{about}"
    );
    let text = longdrive(&[&ask[..], &models, &["--within", "0 yd"]].concat()).out;
    for words in [
        "no design was found within",
        "best for 2",
        "aero.law=ferguson",
        "losses of carry",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let swings = [
        "--distribution=swing.face_angle=normal(0deg,2deg)",
        "--distribution=strike.toe=normal(0mm,8mm)",
    ];
    let (_, usual) = json(&[&ask[..], &swings, &["--scenarios", "16"]].concat());
    let names: Vec<_> = usual["models"]
        .as_array()
        .unwrap()
        .iter()
        .map(|model| model["model"].as_str().unwrap())
        .collect();
    assert!(
        names.contains(&"impact.gear_scale=0.5")
            && names.contains(&"impact.gear_scale=1")
            && names[0] == "as set up",
        "{names:?}"
    );
}

/// The best loft of both models is at its lower bound, so relaxing a limit that is not active gains
/// nothing.
#[test]
fn the_gain_of_an_inactive_limit_is_not_printed_if_it_is_zero() {
    let args = ["robust", "--minimize", "descent_angle"];
    let model = ["--model", "aero.law=ferguson"];
    let vary = ["--vary", "club.loft=4deg..20deg"];
    let limit = ["--subject-to", "carry >= 230 yd"];
    let text = longdrive(&[&args[..], &model, &vary, &limit].concat()).out;
    let limits = text.lines().filter(|line| line.contains("not active"));
    let limits: Vec<_> = limits.collect();
    assert_eq!(limits.len(), 2, "{text}");
    for line in limits {
        assert!(line.ends_with("not active"), "{line}");
    }
}

#[test]
fn bad_models_are_refused_with_the_reason() {
    let launch = "ball_speed=167mph,launch_angle=10deg,spin=2500rpm";
    let launched = [
        "--launch",
        launch,
        "--vary",
        "launch.launch_angle=5deg..20deg",
        "--model",
        "impact.gear_scale=0.5",
    ];
    let cases: [(&[&str], &str); 8] = [
        (
            &launched,
            "impact.gear_scale changes nothing: no club strikes the ball",
        ),
        (&["--model", "aero.law"], "write NAME=VALUE"),
        (
            &["--model", "swing.speed=100mph,swing.speed=105mph"],
            "it gives swing.speed twice; keep one value",
        ),
        (&["--model", "aero.law=ferguzon"], "did you mean 'ferguson'"),
        (
            &["--model", "club.loft=12deg"],
            "this value would have no effect",
        ),
        (&["--model", "impact.gear_scale=3"], "impact.gear_scale"),
        (
            &[
                "--model",
                "aero.law=ferguson",
                "--model",
                "aero.law=ferguson",
            ],
            "it is the same as 'aero.law=ferguson'",
        ),
        (&["--within", "-1 yd"], "0 or more"),
    ];
    for (args, output) in cases {
        let failed = longdrive(&[&["robust"], args].concat());
        let sentence = on_one_line(&failed.err);
        assert!(
            failed.status == 2 && sentence.contains(output),
            "{args:?}: {sentence}"
        );
    }
    let mut setup = Setup::modern_driver();
    let names: Vec<String> = Model::defaults(&setup)
        .unwrap()
        .into_iter()
        .map(|model| model.name)
        .collect();
    assert!(names.contains(&"impact.gear_scale=1".into()), "{names:?}");
    setup
        .set_all([
            ("launch.ball_speed", "70 m/s"),
            ("launch.launch_angle", "10 deg"),
            ("launch.spin", "2500 rpm"),
        ])
        .unwrap();
    assert!(
        Model::defaults(&setup)
            .unwrap()
            .iter()
            .all(|model| !model.name.contains("impact."))
    );
    let setup = Setup::modern_driver();
    let alone = robust(
        vec![Model::as_set_up(&setup)],
        search(&setup),
        1,
        &Observers::default(),
    );
    assert!(matches!(alone, Err(Error::Unreadable { .. })));
}

/// A search whose goal has a local optimum at each end of the range. The setup is nearer to the worse
/// one.
const BETTER_AT_AN_END: [&str; 10] = [
    "robust",
    "mae494",
    "--maximize",
    "rms(lateral)",
    "--distribution",
    "swing.speed=normal(100mph,2mph)",
    "--set",
    "swing.face_angle=1deg",
    "--vary",
    "swing.face_angle=-5deg..3deg",
];

/// A search from several starts finds the better end of the range.
#[test]
fn several_starts_find_the_better_end_for_every_model() {
    let args = [&BETTER_AT_AN_END[..], &["--model", "ball.mass=45g"]].concat();
    let face = |more: &[&str]| {
        let (status, found) = json(&[&args[..], more].concat());
        assert_eq!(status, 0, "{found}");
        number(&found["optimum"]["swing.face_angle"]).to_degrees()
    };
    close(face(&[]), 3.0, 1.0, 1e-9, "the nearer end");
    close(face(&["--starts", "8"]), -5.0, 1.0, 1e-9, "the better end");
}

/// Ctrl-C in the search for all models gives the status `interrupted` and the number of finished
/// searches. Ctrl-C in an earlier search, for a single model, is an error with the name of this
/// model.
#[test]
fn a_stopped_search_reports_its_progress() {
    let setup = Setup::preset("mae494").unwrap();
    let stopping_at = |dimension: usize| {
        let interrupt = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&interrupt);
        let look = move |_: usize, iteration: &Iteration| {
            if iteration.x.len() == dimension {
                flag.store(true, Ordering::Relaxed);
            }
        };
        let follow = Observers {
            iteration: Some(Arc::new(look)),
            interrupt,
            ..Observers::default()
        };
        let models = vec![
            Model::as_set_up(&setup),
            Model::read(&setup, "swing.attack_angle=-4 deg").unwrap(),
        ];
        robust(models, search(&setup), 4, &follow)
    };
    // the search for all models has two variables: the loft and the largest loss
    let found = stopping_at(2).unwrap();
    assert!(
        found.stopped > 0 && !found.is_found() && found.status() == "interrupted",
        "{found:?}"
    );
    let (ended, stopped) = (found.searches - found.stopped, found.stopped);
    let says = format!(
        "{ended} of {} searches ended, and {stopped} were stopped before their end",
        found.searches
    );
    assert_eq!(found.interrupted().unwrap(), says);
    let ending = RobustReport::new(&found, Some(0.9144)).ending();
    assert!(
        ending
            .message
            .unwrap()
            .to_string()
            .starts_with(&format!("{says}; so far "))
    );
    let early = stopping_at(1).unwrap_err();
    assert_eq!(early.status(), "interrupted");
    assert!(
        early.to_string().contains("with the model 'as set up': ")
            && early.to_string().contains(" of 4 searches ended"),
        "{early}"
    );
}

/// The multiplier of a bound or limit is the decrease of the largest loss per unit that it is
/// relaxed. Relaxing it changes the best design of each model, too.
#[test]
fn differences_of_the_greatest_loss_are_the_prices_of_its_bounds_and_limits() {
    let search = |attack: f64, limit: &str| {
        let vary = format!("--vary=swing.attack_angle=-5deg..{attack}deg");
        let models = ["--model=ball.mass=44 g", "--model=swing.speed=108 mph"];
        let args = [
            "robust",
            "modern-driver",
            "--vary=club.loft=4deg..20deg",
            &vary,
            "--subject-to",
            limit,
        ];
        let (status, found) = json(&[&args[..], &models, &SET_RIGID].concat());
        assert_eq!(status, 0, "{found}");
        found
    };
    let greatest = |attack: f64, limit: &str| number(&search(attack, limit)["greatest_loss"]);
    let (limit, by) = ("apex_height <= 33 m", 0.02);
    let price = number(&search(3.0, limit)["multipliers"]["swing.attack_angle"]["upper"]);
    let falls = (greatest(3.0 - by, limit) - greatest(3.0 + by, limit)) / (2.0 * by).to_radians();
    close(price, falls, falls.abs(), 1e-5, "bound");
    // a loss is the difference to the best design of a model. These designs gain more from a wider
    // bound than the common design does, so the largest loss increases
    assert!(price < 0.0, "{price}");
    for (limit, unit, relaxed) in [
        ("apex_height <= 33", "m", 1.0),
        ("descent_angle >= 42", "deg", -1.0),
    ] {
        let moved = |by: f64| {
            let (name, at) = limit.rsplit_once(' ').unwrap();
            format!(
                "{name} {} {unit}",
                at.parse::<f64>().unwrap() + relaxed * by
            )
        };
        let found = search(3.0, &moved(0.0));
        let of_models = found["models"].as_array().unwrap().iter();
        let price: f64 = of_models
            .map(|model| number(&model["constraints"][0]["multiplier"]))
            .sum();
        if unit == "deg" {
            // the limit is not active at the common design. It is active at the best designs of
            // single models, which give it a price
            let bests: Vec<_> = found["models"]
                .as_array()
                .unwrap()
                .iter()
                .map(|model| number(&model["constraints"][0]["multiplier"]))
                .collect();
            assert!(bests[1] < -1.0 && bests[2] > 1.0, "{bests:?}");
            let args = [
                "robust",
                "-q",
                "modern-driver",
                "--vary=club.loft=4deg..20deg",
                "--vary=swing.attack_angle=-5deg..3deg",
            ];
            let output = longdrive(
                &[
                    &args[..],
                    &[
                        "--subject-to",
                        "descent_angle >= 42 deg",
                        "--model=ball.mass=44 g",
                        "--model=swing.speed=108 mph",
                    ],
                    &SET_RIGID,
                ]
                .concat(),
            );
            let sentence = on_one_line(&output.out);
            assert!(
                sentence.contains("not active; +0.67 yd for each degree that the limit is relaxed"),
                "{}",
                output.out
            );
        }
        let size = if unit == "deg" { by.to_radians() } else { by };
        let falls = (greatest(3.0, &moved(-by)) - greatest(3.0, &moved(by))) / (2.0 * size);
        close(price, falls, falls.abs(), 1e-4, limit);
        assert!(price.abs() > 1e-3, "{limit}: {price}");
    }
}

#[test]
fn a_search_for_several_models_without_a_start_is_refused() {
    let setup = Setup::modern_driver();
    let other = Model::read(&setup, "swing.attack_angle=-4 deg").unwrap();
    let models = vec![Model::as_set_up(&setup), other];
    let error = robust(models, search(&setup), 0, &Observers::default()).unwrap_err();
    assert!(matches!(error, Error::Nothing { .. }), "{error}");
}

/// The limit on the total is met by low drives and by high drives. A local search from the setup
/// ends at a low drive, which is tens of yards shorter.
#[test]
fn same_best_of_a_model_as_of_its_own_search() {
    let of = ["modern-driver", "--subject-to", "total <= 280yd"];
    let changes = ["aero.law=ferguson", "impact.gear_scale=0.5"];
    let models = changes.map(|change| ["--model", change]);
    let (status, found) = json(&[&["robust"], &of[..], &models.concat()].concat());
    assert_eq!(status, 0, "{found:#}");
    let own = [vec![], vec!["--set", changes[0]], vec!["--set", changes[1]]];
    for (model, own) in found["models"].as_array().unwrap().iter().zip(own) {
        let (_, best) = json(&[&["optimize"], &of[..], &own].concat());
        close(
            number(&model["value"]),
            number(&best["value"]),
            1.0,
            1e-4,
            "best carry of the model",
        );
        assert!(number(&model["loss"]) >= 0.0, "{model:#}");
    }
    assert_eq!(found["holds_for_all"], false, "{found:#}");
}

/// From the setup, the search of the first model goes to one end of the range, and the search of the
/// second model to the other end, which is better for both models.
#[test]
fn a_model_is_searched_again_from_a_better_design_of_another_model() {
    let args = [&BETTER_AT_AN_END[..], &["--model", "swing.path=4deg"]].concat();
    let (status, found) = json(&args);
    assert_eq!(status, 0, "{found:#}");
    for model in found["models"].as_array().unwrap() {
        let face = number(&model["optimum"]["swing.face_angle"]).to_degrees();
        close(face, -5.0, 1.0, 1e-9, "the better end");
        assert_eq!(number(&model["loss"]), 0.0, "{model:#}");
    }
}
