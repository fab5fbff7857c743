//! Fronts between two goals of a golfer, and the command `pareto`.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use longdrive::optimize::{Observer, Observers, Options};
use longdrive::parameters::SetupFile;
use longdrive::study::swings::{ParetoSearch, Rule, Scenarios, Swings, pareto};
use longdrive::study::uncertainty::Uncertain;
use longdrive::study::{Constraint, Goal, Optimum, Search, Sense, Vary, optimum};
use longdrive::{Drive, Outcome, Setup};

fn golfer(setup: &Setup<f64>) -> Scenarios {
    let inputs = [
        "swing.path=normal(0 deg, 2 deg)",
        "swing.face_angle=normal(0 deg, 2 deg)",
    ];
    let inputs = inputs
        .iter()
        .map(|text| Uncertain::read(setup, text).unwrap())
        .collect();
    Scenarios::new(
        &Swings::distributed(inputs, &[]).unwrap(),
        Rule::Quadrature(4),
    )
    .unwrap()
}

fn goals() -> [(Goal, Sense); 2] {
    let read = |text: &str| Goal::read(text, None).unwrap();
    [
        (read("mean(carry)"), Sense::Maximize),
        (read("std(lateral)"), Sense::Minimize),
    ]
}

fn vary(setup: &Setup<f64>) -> Vec<Vary> {
    let vary = ["club.loft=11deg..16deg", "club.cg_depth=20mm..45mm"];
    vary.iter()
        .map(|text| Vary::read(setup, text).unwrap())
        .collect()
}

fn alone(setup: &Setup<f64>, k: usize, subject_to: Vec<Constraint>) -> Optimum {
    let (of, sense) = goals()[k].clone();
    let search = Search {
        of,
        sense,
        vary: vary(setup),
        subject_to,
        scenarios: golfer(setup),
        ..Search::largest(Outcome::Carry)
    };
    let best = optimum(setup, search, Observer::default()).unwrap();
    assert_eq!(best.status(), "converged");
    best
}

/// The smallest spin fixes the loft, but not the attack angle. The end of the front has the longest
/// carry of all drives with this spin.
#[test]
fn same_end_of_a_front_and_of_a_search_along_a_free_variable() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let goals = [
        (Outcome::Carry, Sense::Maximize),
        (Outcome::Spin, Sense::Minimize),
    ];
    let goals = goals.map(|(outcome, sense)| (Goal::from(outcome), sense));
    let read = |text: &str| Vary::read(&setup, text).unwrap();
    let vary = vec![
        read("club.loft=4deg..20deg"),
        read("swing.attack_angle=-5deg..5deg"),
    ];
    let search = ParetoSearch {
        goals,
        vary,
        subject_to: vec![],
        scenarios: Scenarios::one_drive(),
        points: 4,
        options: Options::default(),
    };
    let found = pareto(&setup, search, &Observers::default()).unwrap();
    let end = found.points.last().unwrap();
    let mut search = Search::longest_drive(&setup).unwrap();
    search.vary = vec![
        read("club.loft=4deg..4deg"),
        read("swing.attack_angle=-5deg..5deg"),
    ];
    let longest = optimum(&setup, search, Observer::default()).unwrap();
    close(
        end.goals[0],
        longest.value().unwrap(),
        1.0,
        1e-6,
        "carry at the least spin",
    );
    for point in &found.points {
        let as_good = found
            .points
            .iter()
            .filter(|other| (other.goals[1] - point.goals[1]).abs() < 1e-6);
        assert_eq!(as_good.count(), 1, "{:?}", found.points);
    }
}

/// Each end of the front is the optimum of a search for one goal. Each point between them is the
/// optimum of a search with the other goal as a constraint. The slope of the front equals the
/// multiplier of this constraint, and differences of neighbouring optima.
#[test]
fn same_front_of_carry_and_dispersion_by_single_searches() {
    let mut setup = Setup::preset("tour-average").unwrap();
    // the front and the single searches use the same drives, in large steps
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    // with a rigid impact and this strike the front has one branch of designs; otherwise a single
    // search may find another branch
    setup.set_all(crate::common::RIGID).unwrap();
    setup.set("strike.high", "3 mm").unwrap();
    let options = Options::default();
    let search = ParetoSearch {
        goals: goals(),
        vary: vary(&setup),
        subject_to: vec![],
        scenarios: golfer(&setup),
        points: 7,
        options,
    };
    let found = pareto(&setup, search, &Observers::default()).unwrap();
    assert_eq!((found.status(), found.dominated), ("done", 0));
    let (points, last) = (&found.points, found.points.len() - 1);
    for (point, k) in [(&points[0], 0), (&points[last], 1)] {
        let best = alone(&setup, k, vec![]);
        close(
            point.goals[k],
            best.value().unwrap(),
            1.0,
            1e-9,
            "the best of one goal",
        );
        for (x, own) in point.design.iter().zip(&best.solution.x) {
            close(*x, *own, 1.0, 1e-6, "its design");
        }
    }
    let held = |most: f64| {
        let (goal, _) = goals()[1].clone();
        let limit = Constraint {
            expression: "std(lateral)".into(),
            goal,
            low: f64::NEG_INFINITY,
            high: most,
        };
        alone(&setup, 0, vec![limit])
    };
    let mut checked = 0;
    for point in &points[1..last] {
        let [carry, spread] = point.goals;
        let best = held(spread);
        close(best.value().unwrap(), carry, 200.0, 1e-8, "carry");
        let price = best.solution.constraints[0].multiplier;
        // the slope is not unique where one bound becomes active and another one inactive
        let Some(slope) = point.slope else { continue };
        checked += 1;
        close(slope, price, 1.0, 1e-5, "multiplier");
        let h = 1e-3;
        let [more, less] = [spread + h, spread - h].map(|spread| held(spread).value().unwrap());
        close(
            slope,
            (more - less) / (2.0 * h),
            1.0,
            1e-3,
            "difference of optima",
        );
    }
    assert!(checked >= 4, "{checked} slopes");
    for pair in points.windows(2) {
        assert!(
            pair[1].goals[0] < pair[0].goals[0] && pair[1].goals[1] < pair[0].goals[1],
            "{points:#?}"
        );
    }
    assert!(found.as_set_up.is_some());
}

const SWINGS: [&str; 3] = [
    "--distribution=swing.path=normal(0deg,2deg)",
    "--distribution=swing.face_angle=normal(0deg,2deg)",
    "--points=4",
];

/// The front has two separate parts: designs with little dispersion, and designs with a long carry.
/// A trace from each end finds them.
#[test]
fn a_front_of_two_parts_names_points_that_are_dominated() {
    let more = [
        "--distribution=strike.toe=normal(0mm,8mm)",
        "--scenarios",
        "64",
        "--vary",
        "club.loft=7deg..16deg",
    ];
    let goals = [
        "pareto",
        "--maximize",
        "mean(carry)",
        "--minimize",
        "std(lateral)",
        "--vary",
    ];
    let (status, answer) = json(
        &[
            &goals[..],
            &["club.bulge_radius=200mm..600mm"],
            &SWINGS,
            &more,
        ]
        .concat(),
    );
    assert_eq!(
        (status, answer["status"].as_str()),
        (0, Some("done")),
        "{answer:#}"
    );
    let points = answer["points"].as_array().unwrap();
    let output = points
        .iter()
        .filter_map(|point| point["event"].as_str())
        .collect::<Vec<_>>()
        .join("; ");
    assert!(
        output.contains("another branch of designs is better"),
        "{output}"
    );
    for pair in points.windows(2) {
        let is_lower = |k: usize| number(&pair[1]["values"][k]) < number(&pair[0]["values"][k]);
        assert!(is_lower(0) && is_lower(1), "{answer:#}");
    }
}

/// The setup file of a point gives the outcomes that the JSON answer has for this point.
#[test]
fn same_front_in_text_json_csv_and_setups() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let ask = [
        "pareto",
        "--maximize",
        "carry",
        "--minimize",
        "apex_height",
        "--points",
        "6",
    ];
    let (_, answer) = json(&ask);
    let points = answer["points"].as_array().unwrap();
    let knee = answer["knee"].as_u64().unwrap() as usize;
    for (name, more, place) in [
        ("knee.toml", &[][..], knee),
        ("second.toml", &["--at", "2"][..], 1),
    ] {
        let output = longdrive(&[&ask[..], &["-o", &file(name)], more].concat());
        assert_eq!(output.status, 0, "{}", output.err);
        let drive = Drive::new(
            &SetupFile::read(&std::fs::read_to_string(file(name)).unwrap(), name)
                .unwrap()
                .setup,
        )
        .unwrap();
        for (k, of) in [Outcome::Carry, Outcome::ApexHeight]
            .into_iter()
            .enumerate()
        {
            close(
                of.of(&drive).unwrap(),
                number(&points[place]["values"][k]),
                100.0,
                1e-6,
                "outcome",
            );
        }
    }
    let output = longdrive(&[&ask[..], &["-o", &file("none.toml"), "--at", "99"]].concat());
    let words = format!(
        "there is no point 99; choose one with --at, from 1 to {}",
        points.len()
    );
    let message = on_one_line(&output.err);
    assert!(output.status == 1 && message.contains(&words), "{message}");
    let (status, answer) = json(&[&ask[..], &["-o", &file("none.toml"), "--at", "99"]].concat());
    assert_eq!((status, &answer["status"]), (1, &"partial".into()));
    let output = longdrive(&[&ask[..], &["-o", &file("front.csv")]].concat());
    assert_eq!(output.status, 0, "{}", output.err);
    let table = std::fs::read_to_string(file("front.csv")).unwrap();
    let head = "carry [m],apex_height [m],club.loft [rad],swing.attack_angle \
                [rad],slope [m/m],role,active,event\n";
    assert!(
        table.starts_with(head) && table.lines().count() == points.len() + 1,
        "{table}"
    );
    let first: Vec<f64> = table
        .lines()
        .nth(1)
        .unwrap()
        .split(',')
        .take(5)
        .map(|cell| cell.parse().unwrap())
        .collect();
    assert_eq!(first[0], number(&points[0]["values"][0]));
    assert_eq!(first[4], number(&points[0]["slope"]));
    for name in [
        "knee",
        "largest carry",
        "smallest apex_height",
        "as set up: carry",
        "[yd per yd]",
    ] {
        let text = longdrive(&ask).out;
        assert!(text.contains(name), "{name}: {text}");
    }
    let picture = file("front.svg");
    assert_eq!(
        longdrive(&[&["plot"], &ask[..], &["-o", &picture]].concat()).status,
        0
    );
    let svg = std::fs::read_to_string(&picture).unwrap();
    for name in ["knee", "as set up", "largest carry", "slope at the knee"] {
        assert!(svg.contains(name), "{name}");
    }
}

#[test]
fn a_design_that_is_best_for_both_goals_is_written_without_a_choice() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("best.toml").display().to_string();
    let output = longdrive(&[
        "pareto",
        "mae494",
        "--maximize=ball_speed",
        "--maximize=smash_factor",
        "--vary=swing.path=0deg..1deg",
        "-o",
        &file,
    ]);
    assert_eq!(output.status, 0, "{}", output.err);
    assert!(
        output.out.contains("one design is best for both"),
        "{}",
        output.out
    );
    let best = SetupFile::read(&std::fs::read_to_string(&file).unwrap(), &file)
        .unwrap()
        .setup;
    assert_eq!(best.swing.path, 0.0);
}

#[test]
fn the_front_in_pareto_md_is_the_programs() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/pareto.md")).unwrap();
    let requested = text
        .split("```sh\nlongdrive ")
        .nth(2)
        .unwrap()
        .lines()
        .next()
        .unwrap();
    let output = longdrive(&requested.split(' ').collect::<Vec<_>>());
    assert_eq!(output.status, 0, "{}", output.err);
    assert!(
        text.contains(&format!("```text\n{}```", output.out)),
        "docs/pareto.md should have:\n{}",
        output.out
    );
}

#[test]
fn bad_goals_of_a_front_have_a_message() {
    let folder = tempfile::tempdir().unwrap();
    let text = folder.path().join("front.txt").display().to_string();
    let csv = folder.path().join("front.csv").display().to_string();
    let both = ["--maximize", "carry", "--minimize", "apex_height"];
    let toml = folder.path().join("best.toml").display().to_string();
    let cases: [(Vec<&str>, &str); 10] = [
        (
            vec!["--maximize", "carry"],
            "one is given, but a front needs two",
        ),
        (vec![], "none is given"),
        (
            vec!["--maximize", "carry", "--minimize", "carry"],
            "both are the same",
        ),
        (
            vec!["--maximize", "mean(carry)", "--minimize", "std(lateral)"],
            "give the swings too, with --swings FILE",
        ),
        (
            vec!["--maximize", "cary", "--minimize", "lateral"],
            "did you mean 'carry'",
        ),
        (
            [
                &["--maximize", "carry", "--minimize", "std(lateral)"][..],
                &SWINGS,
            ]
            .concat(),
            "mean(carry)",
        ),
        (
            [&both[..], &["-o", &text]].concat(),
            "use .csv for all points or .toml",
        ),
        (
            [&both[..], &["-o", &csv, "--at", "2"]].concat(),
            "it chooses the point whose setup is written",
        ),
        (
            [&both[..], &["--scenarios", "9"]].concat(),
            "give the swings too",
        ),
        (
            [&both[..], &["-o", &toml, "--at", "-1"]].concat(),
            "the number of a point in the table, from 1",
        ),
    ];
    for (args, output) in cases {
        let failed = longdrive(&[&["pareto"], &args[..]].concat());
        let message = on_one_line(&failed.err);
        assert!(
            failed.status == 2 && message.contains(output),
            "{args:?}: {message}"
        );
    }
    // `optimize` names the limits that cannot be met, and their violations
    let limits = [
        "--subject-to",
        "descent_angle >= 80 deg",
        "--subject-to",
        "carry >= 400 yd",
    ];
    let failed = longdrive(&[&["pareto"][..], &both, &limits].concat());
    let message = on_one_line(&failed.err);
    assert_eq!(failed.status, 1, "{message}");
    for (expression, limit) in [("descent_angle >= 80°", 80.0), ("carry >= 400 yd", 400.0)] {
        // the message has the value of the outcome, and its distance from the allowed range
        let output = message
            .split(&format!("{expression} (its value is "))
            .nth(1)
            .unwrap_or_else(|| panic!("{message}"));
        let [found, outside] = ["", "outside by "].map(|before| {
            let at = output.find(before).unwrap_or_else(|| panic!("{output}")) + before.len();
            output[at..]
                .split([' ', '°'])
                .next()
                .unwrap()
                .parse::<f64>()
                .unwrap()
        });
        assert!(found < limit, "{expression}: {found}");
        close(outside, limit - found, limit, 1e-3, expression);
    }
    let straight = longdrive(&[
        "pareto",
        "--maximize",
        "carry",
        "--minimize",
        "flight_time",
        "--vary",
        "club.loft=8deg..9deg",
    ]);
    assert!(straight.status < 2, "{}", straight.err);
}

/// A local search from the setup ends at another optimum for at least one goal of each front.
#[test]
fn same_ends_of_a_front_as_of_searches_with_a_sample() {
    let fronts: [(&str, [&str; 4], &str); 3] = [
        (
            "modern-driver",
            ["--maximize", "carry", "--maximize", "spin"],
            "total <= 280yd",
        ),
        (
            "tour-average",
            ["--maximize", "apex_height", "--minimize", "spin"],
            "230yd <= carry <= 250yd",
        ),
        (
            "tour-average",
            ["--maximize", "total", "--minimize", "carry"],
            "carry >= 0yd",
        ),
    ];
    for (preset, goals, limit) in fronts {
        let limit = ["--subject-to", limit, "--points", "3"];
        let (_, front) = json(&[&["pareto", preset], &goals[..], &limit].concat());
        let points = front["points"].as_array().unwrap();
        let ends = [points.first(), points.last()].map(|end| end.unwrap());
        for ((end, goal), place) in ends.into_iter().zip(goals.chunks(2)).zip(0..) {
            let (_, best) = json(&[&["optimize", preset], goal, &limit[..2]].concat());
            let best = number(&best["value"]);
            let own = number(&end["values"][place]);
            close(own, best, best.abs(), 1e-6, &format!("{preset}: {goal:?}"));
        }
    }
}
