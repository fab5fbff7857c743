//! Each optimum is compared with a random sample of the searched ranges.

use crate::command_line::{json, longdrive, number};
use crate::common::{LARGE_STEPS, SET_RIGID};
use crate::random::Random;
use longdrive::batch::Batch;
use longdrive::optimize::{Observer, Observers, Status};
use longdrive::parameters::PRESETS;
use longdrive::study::{Constraint, Search, Sense, Vary, optima, optimum};
use longdrive::{Outcome, Setup};

/// Parameters that are varied, each with its widest range, SI.
const VARIED: [(&str, f64, f64); 10] = [
    ("club.loft", 0.0, 0.45),
    ("swing.attack_angle", -0.2, 0.2),
    ("strike.high", -0.015, 0.015),
    ("strike.toe", -0.02, 0.02),
    ("swing.face_angle", -0.15, 0.15),
    ("swing.path", -0.15, 0.15),
    ("swing.speed", 30.0, 60.0),
    ("swing.shaft_lean", -0.1, 0.1),
    ("wind.right", -15.0, 15.0),
    ("wind.downrange", -15.0, 15.0),
];

const LIMITED: [Outcome; 7] = [
    Outcome::ApexHeight,
    Outcome::DescentAngle,
    Outcome::Lateral,
    Outcome::FlightTime,
    Outcome::Backspin,
    Outcome::LandingSpeed,
    Outcome::LaunchAngle,
];

const LAWS: [&str; 6] = [
    "winfield-tan",
    "nathan",
    "ferguson",
    "robinson",
    "bearman-harvey",
    "launch-monitor",
];

/// A search, and the best objective of random points that meet its constraints. The objective is
/// the outcome, or its negative if the search minimizes.
struct Generated {
    setup: Setup<f64>,
    search: Search,
    best: f64,
}

/// A search over random ranges, with up to two constraints. Each constraint is met by at least one
/// of 760 random points; `None` if no point meets all constraints.
fn generated(random: &mut Random) -> Option<Generated> {
    let mut setup = Setup::preset(PRESETS[random.below(PRESETS.len())].name).unwrap();
    setup
        .set("aero.law", LAWS[random.below(LAWS.len())])
        .unwrap();
    setup.set_all(LARGE_STEPS).unwrap();
    let mut vary: Vec<Vary> = vec![];
    for _ in 0..=random.below(4) {
        let (name, low, high) = VARIED[random.below(VARIED.len())];
        let [a, b] = [(); 2].map(|()| random.between(low, high));
        if vary.iter().all(|vary| vary.parameter.name != name) {
            vary.push(Vary::new(setup.variable(name).unwrap(), a.min(b), a.max(b)).unwrap());
        }
    }
    let of = [Outcome::Carry, Outcome::CarryDistance, Outcome::Total][random.below(3)];
    let first = random.below(LIMITED.len());
    let limited: Vec<_> = (0..random.below(3))
        .map(|j| LIMITED[(first + j) % LIMITED.len()])
        .collect();
    let parameters: Vec<_> = vary.iter().map(|vary| vary.parameter).collect();
    let outcomes: Vec<_> = [of].into_iter().chain(limited.iter().copied()).collect();
    let point = |_| {
        vary.iter()
            .map(|vary| random.between(vary.low, vary.high))
            .collect::<Vec<_>>()
    };
    let points: Vec<f64> = (0..760).flat_map(point).collect();
    let block = Batch::new(&setup, &parameters, &outcomes, &[])
        .unwrap()
        .evaluate(0, points);
    let flown: Vec<Vec<f64>> = (0..block.rows())
        .filter_map(|row| block.outcomes(row).collect())
        .collect();
    let mut subject_to = vec![];
    for (j, outcome) in limited.into_iter().enumerate() {
        let mut values: Vec<f64> = flown.iter().map(|values| values[1 + j]).collect();
        values.sort_by(f64::total_cmp);
        let (least, most) = (*values.first()?, *values.last()?);
        // if no variable changes the outcome, rounding decides whether its constraint is met
        if most - least < 1e-6 * most.abs().max(1.0) {
            return None;
        }
        let place = (random.between(0.0, 0.8).powi(2) * (values.len() - 1) as f64) as usize;
        let (low, high) = match random.below(2) {
            0 => (f64::NEG_INFINITY, values[place]),
            _ => (values[values.len() - 1 - place], f64::INFINITY),
        };
        subject_to.push(Constraint {
            expression: format!("{low} <= {outcome} <= {high}"),
            goal: outcome.into(),
            low,
            high,
        });
    }
    let is_met = |values: &&Vec<f64>| {
        subject_to
            .iter()
            .zip(&values[1..])
            .all(|(limit, value)| (limit.low..=limit.high).contains(value))
    };
    let best = flown
        .iter()
        .filter(is_met)
        .map(|values| -values[0])
        .reduce(f64::min)?;
    let search = Search {
        vary,
        subject_to,
        ..Search::largest(of)
    };
    Some(Generated {
        setup,
        search,
        best,
    })
}

/// Few searches end more than half a metre below the best of 760 random points of their ranges. No
/// search reports that the constraints cannot be met.
#[test]
fn sampled_points_are_rarely_better_than_optima() {
    let mut random = Random::seeded(51);
    let (mut below, mut improved) = (vec![], 0);
    for number in 0..400 {
        let Some(Generated {
            setup,
            search,
            best,
        }) = generated(&mut random)
        else {
            continue;
        };
        let found = optimum(&setup, search, Observer::default()).unwrap();
        let sample = found.sample.unwrap();
        assert!(
            sample.feasible <= sample.points && sample.better <= sample.feasible,
            "{number}: {sample:?}"
        );
        assert_ne!(
            found.solution.status,
            Status::Infeasible,
            "{number}: {}",
            found.message()
        );
        improved += usize::from(sample.improved);
        let value = found.solution.value.unwrap();
        if value > best + 0.5 {
            below.push((number, value, best));
        }
    }
    assert!(below.len() <= 1, "{below:?}");
    assert!(
        improved >= 1,
        "{improved} searches were improved by their samples"
    );
}

/// Only 47 of 2,000 random points meet these constraints. The search from the preset's values ends
/// where they are not met.
#[test]
fn a_small_feasible_region_is_found() {
    let requested = [
        "optimize",
        "modern-driver",
        "--set",
        "aero.law=winfield-tan",
        "--maximize",
        "carry_distance",
        "--vary",
        "club.loft=0.03267802173667786rad..0.2726708361540153rad",
        "--vary",
        "strike.high=-0.010458154429292002m..0.008183702957722104m",
        "--vary",
        "swing.face_angle=-0.15rad..0.15rad",
        "--subject-to",
        "total <= 203.62809437379258 m",
        "--subject-to",
        "apex_height <= 14.362690438633521 m",
    ];
    let requested = [&requested[..], &SET_RIGID].concat();
    let (status, found) = json(&requested);
    assert_eq!(
        (status, found["status"].as_str()),
        (0, Some("converged")),
        "{}",
        found["message"]
    );
    // expected: the best value of eight searches from different starts
    assert!(number(&found["value"]) > 181.36, "{}", found["value"]);
    assert_eq!(found["sample"]["improved"], true);
    assert!(found["optima"].is_null(), "one start was requested");
    let output = longdrive(&requested);
    assert!(
        output
            .out
            .contains("found by a search from another point of the ranges"),
        "{}",
        output.out
    );
}

/// The search from the setup ends at a local optimum, and a search from the best club alone finds a
/// better one. This start was not requested. Its index follows that of the one requested start.
#[test]
fn a_search_from_the_club_alone_is_a_further_start() {
    let mut setup = Setup::preset("amateur-average").unwrap();
    setup.set("aero.law", "lyu").unwrap();
    let vary = [
        "club.loft=0deg..30deg",
        "club.cg_depth=20mm..50mm",
        "swing.attack_angle=-10deg..10deg",
        "swing.face_angle=-2deg..1deg",
    ];
    let search = Search {
        of: Outcome::Spin.into(),
        sense: Sense::Minimize,
        vary: vary.map(|text| Vary::read(&setup, text).unwrap()).to_vec(),
        ..Search::longest_drive(&setup).unwrap()
    };
    let mut found = optima(&setup, &search, 1, &Observers::default()).unwrap();
    assert_eq!((found.starts(), found.has_extra_start), (1, false));
    found.improve_from_club_alone().unwrap();
    assert!(found.has_extra_start);
    let starts: Vec<_> = found.locals.iter().map(|local| &local.starts[..]).collect();
    assert_eq!(starts, [[1], [0]]);
    assert_eq!((found.starts(), found.stopped()), (2, 0));
    assert!(!found.has_several_starts());
}

/// An infeasible search states the number of tried points, and does not claim that no point meets
/// the limits.
#[test]
fn infeasible_reports_the_number_of_points() {
    let requested = [
        "optimize",
        "--subject-to",
        "apex_height <= 30 m",
        "--subject-to",
        "apex_height >= 31 m",
    ];
    let (status, found) = json(&requested);
    assert_eq!((status, found["status"].as_str()), (1, Some("infeasible")));
    let message = found["message"].as_str().unwrap();
    let points = &found["sample"]["points"];
    let text = format!(
        "no point was found that meets the constraints (the search and {points} other points"
    );
    assert!(message.starts_with(&text), "{message}");
    assert_eq!(found["sample"]["feasible"], 0);
}

/// The shortest carry is at a corner of the ranges. A search from the setup ends at another corner,
/// and no point of a Sobol' sequence is near enough to the first.
#[test]
fn the_corners_of_the_ranges_are_in_the_sample() {
    let (_, found) = json(&["optimize", "--minimize", "carry"]);
    let corner = [
        "simulate",
        "--set",
        "club.loft=4deg",
        "--set",
        "swing.attack_angle=-5deg",
    ];
    let (_, drive) = json(&corner);
    let shortest = number(&drive["flight"]["carry"]);
    assert!(number(&found["value"]) <= shortest + 1e-3, "{shortest}");
    assert_eq!(found["sample"]["points"], 128);
}
