//! Design: other swings, unset parameters, limits that no design meets, and wrong questions.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use longdrive::derivative::{Evaluator, Order};
use longdrive::{Outcome, Setup};

/// The default golfer with few swings, so that a search is fast.
const FEW: [&str; 4] = ["design", "modern-driver", "--scenarios", "32"];

/// A golfer whose face angle and strike towards the toe vary, and nothing else.
const TWO: [&str; 4] = [
    "design",
    "modern-driver",
    "--distribution=swing.face_angle=truncated(0deg,3deg,-6deg,6deg)",
    "--distribution=strike.toe=truncated(0mm,9mm,-18mm,18mm)",
];

/// The setup states the wind direction, but not the wind speed, which varies from swing to swing.
#[test]
fn a_design_in_a_wind_whose_speed_varies() {
    let wind = [
        "--set",
        "wind.from=0deg",
        "--distribution",
        "wind.speed=uniform(1mph,5mph)",
    ];
    let (status, found) = json(&[&FEW[..], &wind].concat());
    assert_eq!((status, &found["status"]), (0, &"converged".into()));
    assert_eq!(found["setup"]["wind.from"], 0.0);
}

/// The error estimate of a design uses swings that the design itself does not use. If one of them
/// does not fly, there still is an answer.
#[test]
fn other_swings_without_a_flight_do_not_suppress_a_design() {
    let mut setup = Setup::modern_driver();
    setup.set("club.loft", "8 deg").unwrap();
    let attack = setup.parameter("swing.attack_angle").unwrap();
    let drive = Evaluator::new(&setup, &[Outcome::Carry], &[attack], Order::Value).unwrap();
    let flies = |degrees: f64| drive.at(&[degrees.to_radians()]).is_ok();
    let (mut down, mut up) = (-30.0, 0.0);
    assert!(flies(up) && !flies(down));
    for _ in 0..50 {
        let middle = 0.5 * (down + up);
        *(if flies(middle) { &mut up } else { &mut down }) = middle;
    }
    // the lowest of 32 nodes is above the lowest attack angle with a flight, and the lowest of the
    // 48 nodes of the error estimate is below it
    let low = (up - 0.001 * 5.0) / 0.999;
    let distribution = format!("--distribution=swing.attack_angle=uniform({low}deg, 5deg)");
    for command in ["design", "optimize"] {
        let requested = [
            command,
            "modern-driver",
            &distribution,
            "--vary=club.loft=7deg..8deg",
            "--maximize=mean(carry)",
        ];
        let (status, found) = json(&requested);
        assert_eq!(
            (status, found["status"].as_str()),
            (0, Some("converged")),
            "{}",
            found["message"]
        );
        assert!(
            found["swings"]["quadrature_error"].is_null() && !found["swings"]["nominal"].is_null()
        );
        let unknown = found["swings"]["unknown"][0].as_str().unwrap();
        assert!(
            unknown.contains(
                "the ball does not fly in one of the golfer's other swings (the swing with \
                 swing.attack_angle = "
            ),
            "{unknown}"
        );
        let output = longdrive(&requested);
        assert!(
            output.status == 0
                && on_one_line(&output.out).contains("one of the golfer's other swings"),
            "{}",
            output.out
        );
    }
}

/// The setup has no weight 1, and the mass of weight 1 is varied. The design as set up then has no
/// weight 1, instead of one with the middle mass of the range.
#[test]
fn the_setup_as_set_up_omits_unset_parameters() {
    let base = json(&[&TWO[..], &["--vary=club.loft=10deg..11deg"]].concat()).1;
    let mean = |found: &serde_json::Value| number(&found["design"]["parts"][0]["as_set_up"]);
    for most in ["20g", "40g"] {
        let vary = format!("--vary=club.weight_1.mass=0g..{most}");
        let found = json(&[&TWO[..], &[vary.as_str()]].concat()).1;
        assert_eq!(mean(&found), mean(&base), "{most}");
        assert_eq!(
            number(&found["design"]["as_set_up"]["club.weight_1.mass"]),
            0.0
        );
        let held = found["design"]["held"].as_array().unwrap();
        let budget = held
            .iter()
            .find(|held| held["name"] == "mass budget")
            .unwrap();
        close(number(&budget["high"]), 0.204, 0.2, 1e-12, "budget");
    }
    let optimize = [
        "optimize",
        "modern-driver",
        TWO[2],
        TWO[3],
        "--vary=club.weight_1.mass=0g..20g",
    ];
    let output = json(&optimize).1;
    assert_eq!(
        number(&output["swings"]["as_set_up"]["mean(carry)"]),
        mean(&base)
    );
}

#[test]
fn a_relation_is_shown_in_the_unit_of_its_limit() {
    let requested = [
        "--vary=club.cg_depth=21mm..50mm",
        "--subject-to=x: club.cg_depth <= 25 mm",
        "--minimize=mean(carry)",
    ];
    let output = longdrive(&[&TWO[..], &requested].concat());
    let row = output
        .out
        .lines()
        .find(|line| line.starts_with("  x "))
        .unwrap_or_else(|| panic!("{}", output.out));
    assert!(
        row.contains("mm") && !row.contains("yd  ") && !row.contains("1 m "),
        "{row}"
    );
}

/// The message of an infeasible search has the smallest violation that was found, and names limits
/// that no variable changes.
#[test]
fn the_nearest_design_is_no_further_than_the_one_set_up() {
    let weight = [
        "--set=club.mass=189g",
        "--set=club.weight_1.mass=15g",
        "--set=club.weight_1.depth=40.8mm",
        "--set=club.weight_1.high=0mm",
        "--set=club.weight_1.toe=0mm",
        "--vary=club.weight_1.depth=0mm..110mm",
        "--vary=club.weight_1.toe=-50mm..50mm",
        "--subject-to=head_moi <= 5500 g cm^2",
        // large steps and few swings save time; both designs are computed with them
        "--scenarios=64",
        "--set=flight.method=dp8",
        "--set=flight.step=1s",
    ];
    let (status, found) = json(&[&TWO[..], &weight].concat());
    assert_eq!(
        (status, found["status"].as_str()),
        (1, Some("infeasible")),
        "{found}"
    );
    let value = number(&found["constraints"][0]["value"]);
    let own = number(&found["swings"]["as_set_up"]["head_moi"]);
    assert!(value <= own * (1.0 + 1e-9), "{value} {own}");
    let (_, found) = json(&[&TWO[..], &["--subject-to=head_moi <= 3000 g cm^2"]].concat());
    let message = found["message"].as_str().unwrap();
    assert!(
        message.contains("no varied parameter changes it here: its value is 5679.0 g cm^2"),
        "{message}"
    );
}

/// Within its range, the bulge changes the goal by less than 1 mm: the answer says that its effect
/// is negligible.
#[test]
fn a_variable_without_an_effect_is_named() {
    let swings = ["optimize", "modern-driver", TWO[2]];
    let both = [
        "--vary=club.loft=7deg..16deg",
        "--vary=club.bulge_radius=200mm..600mm",
    ];
    let output = longdrive(&[&swings[..], &both].concat());
    assert!(
        output.status == 0 && on_one_line(&output.out).contains("negligible effect"),
        "{} {}",
        output.out,
        output.err
    );
    let text = "club.bulge_radius has a negligible effect: within its range it changes \
                mean(carry) by less than 1 mm";
    assert!(on_one_line(&output.out).contains(text), "{}", output.out);
    assert!(
        !on_one_line(&output.out).contains("club.loft has a negligible effect"),
        "{}",
        output.out
    );
}

#[test]
fn impossible_designs_are_refused_in_plain_words() {
    let cases: [(&[&str], &str); 10] = [
        (
            &["--distribution=club.inertia.xx=uniform(5000 g cm^2,6001 g cm^2)"],
            "the swings reach head_moi = 6001 g cm^2",
        ),
        (
            &["--distribution=ball.mass=uniform(45 g,45.931 g)"],
            "the swings reach ball.mass = 45.931 g",
        ),
        (
            &["--subject-to=volume: 2*club.mass <= 600 g"],
            "which limits a volume, but this is a mass",
        ),
        (
            &["--subject-to=volume: 120 cm^3 + 80 cm^2*club.cg_depth >= 400 cm^3"],
            "its upper limit is missing",
        ),
        (
            &["--maximize=2*mean(carry) - std(carry)/2"],
            "there is no division; a weight comes before the measure, for example 0.5*std(carry)",
        ),
        (
            &["--maximize=mean(carry) mean(total)"],
            "a + or - is missing before 'mean(total)'",
        ),
        (&["--maximize=mean(carry)*2"], "'*2'"),
        (
            &["--launch=ball_speed=150mph,launch_angle=12deg,backspin=2500rpm"],
            "there is nothing to design",
        ),
        (
            &["--distribution=club.inertia.xx=uniform(5700 g cm^2,6200 g cm^2)"],
            "the swings reach head_moi = ",
        ),
        (
            &["--set=impact.restitution=0.859"],
            "chosen so that the ball speed agrees",
        ),
    ];
    for (args, part) in cases {
        let output = longdrive(&[&FEW[..2], args].concat());
        assert_eq!(output.status, 2, "{args:?}: {} {}", output.err, output.out);
        assert!(
            on_one_line(&output.err).contains(part),
            "{args:?}: {part}: {}",
            output.err
        );
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("nothing.toml").display().to_string();
    std::fs::write(&file, "").unwrap();
    let output = longdrive(&["design", "--swings", &file]);
    assert!(
        output.status == 2
            && on_one_line(&output.err).contains("nothing.toml: it has no distribution"),
        "{}",
        output.err
    );
    let free = longdrive(&[&TWO[..], &["--rules=none", "--vary=club.loft=10deg..11deg"]].concat());
    assert!(
        free.status == 0 && !free.out.contains("rule or limit"),
        "{}",
        free.out
    );
}

#[test]
fn unchecked_rules_and_missing_effects_are_reported() {
    let swings = "--distribution=club.inertia.xx=normal(5700 g cm^2,10 g cm^2)";
    let output = longdrive(&[
        "design",
        "modern-driver",
        swings,
        "--vary=club.loft=10deg..12deg",
    ]);
    let text = "the rule on the moment of inertia is checked at 32 swings only, since the \
                distribution of club.inertia.xx is unbounded";
    assert!(output.status == 0 && on_one_line(&(output.out + &output.err)).contains(text));
    let bounded = swings.replace(
        "normal(5700 g cm^2,10 g cm^2)",
        "uniform(5600 g cm^2,5999 g cm^2)",
    );
    let output = longdrive(&[
        "design",
        "modern-driver",
        &bounded,
        "--vary=club.loft=10deg..12deg",
    ]);
    assert!(
        output.status == 0 && !on_one_line(&(output.out + &output.err)).contains("is checked at")
    );

    let placed = [
        "--set=club.weight_1.depth=40mm",
        "--set=club.weight_1.toe=10mm",
    ];
    for (mass, why) in [
        ("none", "the weight has no mass; set"),
        ("0g", "the mass of the weight is 0 g; raise"),
    ] {
        let mass = format!("--set=club.weight_1.mass={mass}");
        let output = longdrive(&[&["simulate", "modern-driver", &mass][..], &placed].concat());
        let text = format!(
            "club.weight_1.depth, club.weight_1.toe change nothing: {why} club.weight_1.mass"
        );
        assert!(on_one_line(&output.err).contains(&text), "{}", output.err);
    }
    let output = longdrive(
        &[
            &["simulate", "modern-driver", "--set=club.weight_1.mass=5g"][..],
            &placed,
        ]
        .concat(),
    );
    assert!(!output.err.contains("nothing"), "{}", output.err);
}

#[test]
fn the_error_of_side_spin_is_printed_once() {
    assert_eq!(
        longdrive(&["design"])
            .out
            .replace('\n', " ")
            .matches("the gear effect, and the scatter from it, is known")
            .count(),
        1
    );
}
