//! Design of head and face: active limits, their multipliers, and refused questions.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{SET_RIGID, close};
use longdrive::Setup;
use longdrive::parameters::SetupFile;
use longdrive::study::Constraint;
use longdrive::study::design::{GolfRule, RULES};

use serde_json::Value;

/// A golfer in whose swings only three parameters vary, so that a search is fast.
const GOLFER: [&str; 5] = [
    "modern-driver",
    "--set=club.loft=12deg",
    "--distribution=swing.face_angle=truncated(0deg,3deg,-6deg,6deg)",
    "--distribution=strike.toe=truncated(0mm,9mm,-18mm,18mm)",
    "--distribution=strike.high=truncated(0mm,6mm,-12mm,12mm)",
];

/// A movable weight whose depth is varied.
const WEIGHT: [&str; 6] = [
    "--set=club.mass=189g",
    "--set=club.weight_1.mass=15g",
    "--set=club.weight_1.high=0mm",
    "--set=club.weight_1.toe=0mm",
    "--vary=club.weight_1.depth=40mm..110mm",
    "--vary=club.bulge_radius=150mm..1000mm",
];

fn designed(more: &[&str]) -> Value {
    let (status, found) = json(&[&["design"], &GOLFER[..], more].concat());
    assert_eq!(
        (status, found["status"].as_str()),
        (0, Some("converged")),
        "{}",
        found["message"]
    );
    found
}

fn held<'a>(found: &'a Value, name: &str) -> &'a Value {
    let all = found["design"]["held"].as_array().unwrap();
    all.iter()
        .find(|held| held["name"] == name)
        .unwrap_or_else(|| panic!("{name}: {found}"))
}

/// The multiplier of the rule on the moment of inertia is the derivative of the best goal by the
/// limit of this rule. The expected value is a difference of two searches, in which a constraint
/// with a changed limit replaces the rule.
#[test]
fn differences_certify_the_price_of_the_limit_on_the_moment_of_inertia() {
    let found = designed(&WEIGHT);
    let rule = held(&found, "moment of inertia");
    close(
        number(&rule["value"]),
        6000e-7,
        6000e-7,
        1e-9,
        "moment of inertia",
    );
    let best = |limit: f64| {
        let limit = format!("--subject-to=head_moi <= {limit} g cm^2");
        number(&designed(&[&WEIGHT[..], &["--rules=none", &limit]].concat())["value"])
    };
    let slope = (best(6010.0) - best(5990.0)) / 20e-7;
    assert!(slope > 0.0);
    close(number(&rule["price"]), slope, slope, 1e-3, "price");
    close(
        number(&found["value"]),
        best(6000.0),
        200.0,
        1e-10,
        "the rule is this limit",
    );
    // without the rule the weight moves further back
    let free = designed(&[&WEIGHT[..], &["--rules=none"]].concat());
    assert!(
        number(&free["optimum"]["club.weight_1.depth"])
            > number(&found["optimum"]["club.weight_1.depth"]) + 1e-3
    );
    assert!(
        free["design"]["rules"] == "none" && free["design"]["held"].as_array().unwrap().is_empty()
    );
}

/// A rule about a parameter acts as a bound, and has the multiplier of this bound. The multiplier
/// is 0 if a tighter bound of the user is active.
#[test]
fn a_rule_about_a_parameter_is_a_bound_of_it() {
    let vary = "--vary=impact.restitution=0.78..0.9";
    let found = designed(&[vary]);
    let rule = held(&found, "spring effect");
    assert_eq!(
        (&rule["by"], number(&rule["value"])),
        (&"bound".into(), 0.83)
    );
    assert_eq!(
        rule["price"],
        found["multipliers"]["impact.restitution"]["upper"]
    );
    let notes = found["design"]["notes"].to_string();
    assert!(
        notes.contains(
            "the range of impact.restitution stops at the limit of the rule on the spring effect: \
             0.83"
        ),
        "{notes}"
    );
    let closer = designed(&["--vary=impact.restitution=0.78..0.82"]);
    let rule = held(&closer, "spring effect");
    assert!(
        rule["price"].is_null() && (number(&rule["margin"]) - 0.01).abs() < 1e-12,
        "{rule}"
    );
}

#[test]
fn varied_inertia_stays_that_of_a_rigid_body() {
    let vary = [
        "--vary=club.inertia.yy=2000 g cm^2..9000 g cm^2",
        "--vary=club.inertia.zz=1000 g cm^2..9000 g cm^2",
    ];
    let found = designed(&[&vary[..], &["--maximize=mean(carry)"], &SET_RIGID].concat());
    let body: Vec<f64> = found["design"]["held"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|held| held["name"] == "a rigid body")
        .map(|held| number(&held["value"]))
        .collect();
    assert!(
        body.len() == 3 && body.iter().all(|minor| *minor > -1e-10),
        "{body:?}"
    );
    // the goal improves as the inertia about the axis to the target becomes less than the inertia
    // about the axis from heel to toe; only the rule `a rigid body` limits this
    assert!(number(&held(&found, "a rigid body")["value"]) > 0.0);
    assert!(
        found["design"]["held"]
            .as_array()
            .unwrap()
            .iter()
            .any(|held| held["name"] == "a rigid body" && !held["price"].is_null())
    );
    // `simulate` has no warning about this inertia tensor
    let setup: Vec<String> = ["club.inertia.xx", "club.inertia.yy", "club.inertia.zz"]
        .iter()
        .map(|name| format!("{name}={} kg m^2", number(&found["setup"][*name])))
        .collect();
    let args: Vec<&str> = setup.iter().flat_map(|set| ["--set", set]).collect();
    let output = longdrive(&[&["simulate", "modern-driver"], &args[..]].concat());
    assert!(
        output.status == 0 && !output.err.contains("no rigid body"),
        "{}",
        output.err
    );
}

/// A varied mass has an upper limit, the budget: the mass of the setup, or a stated limit.
#[test]
fn varied_mass_has_a_budget() {
    let vary = ["--vary=club.mass=180g..230g"];
    let found = designed(&vary);
    close(
        number(&held(&found, "mass budget")["value"]),
        0.204,
        0.2,
        1e-9,
        "mass",
    );
    let stated = designed(&[&vary[..], &["--subject-to=head_mass <= 200 g"]].concat());
    close(
        number(&stated["optimum"]["club.mass"]),
        0.2,
        0.2,
        1e-9,
        "mass",
    );
    assert!(number(&held(&stated, "head_mass")["price"]) > 0.0);
    // two weights that share 20 g
    let two = [
        "--set=club.mass=184g",
        "--set=club.weight_1.depth=100mm",
        "--set=club.weight_2.depth=10mm",
        "--vary=club.weight_1.mass=0g..20g",
        "--vary=club.weight_2.mass=0g..20g",
        "--subject-to=weights: club.weight_1.mass + club.weight_2.mass <= 20 g",
    ];
    let found = designed(&two);
    let [one, other] =
        ["club.weight_1.mass", "club.weight_2.mass"].map(|name| number(&found["optimum"][name]));
    close(one + other, 0.02, 0.02, 1e-9, "both weights");
    close(
        number(&held(&found, "weights")["value"]),
        0.02,
        0.02,
        1e-9,
        "the relation",
    );
}

#[test]
fn exact_limit_of_a_temperature_on_its_scale() {
    let mut setup = Setup::modern_driver();
    setup.set("air.temperature", "25 degC").unwrap();
    let read = |text: &str| Constraint::read_relation(&setup, text);
    for (limit, kelvin) in [
        ("20 degC", 293.15),
        ("68 degF", 293.15),
        ("293.15 K", 293.15),
    ] {
        let found = read(&format!("cool: air.temperature <= {limit}")).unwrap();
        close(found.high, kelvin, 1.0, 1e-9, limit);
    }
    // 20 degC may be a temperature or a difference here
    for sum in [
        "2*air.temperature <= 20 degC",
        "air.temperature - 5 degC <= 20 K",
        "air.temperature - 5 K <= 20 degC",
    ] {
        let error = read(&format!("cool: {sum}")).unwrap_err().to_string();
        assert!(error.contains("differences in K"), "{error}");
    }
}

/// The answer has the value of a relation that the user states. The multiplier of the relation is
/// the derivative of the best goal by the limit of the relation.
#[test]
fn differences_certify_the_price_of_a_relation() {
    let of = |limit: f64| {
        let relation =
            format!("--subject-to=volume: {limit} cm^3 >= 120 cm^3 + 80 cm^2*club.cg_depth");
        designed(&[
            "--rules=none",
            "--vary=club.cg_depth=20mm..60mm",
            "--minimize=rms(lateral)",
            &relation,
        ])
    };
    let found = of(400.0);
    let depth = number(&found["optimum"]["club.cg_depth"]);
    let volume = held(&found, "volume");
    close(
        number(&volume["value"]),
        120e-6 + 80e-4 * depth,
        4e-4,
        1e-12,
        "volume",
    );
    let slope = (number(&of(402.0)["value"]) - number(&of(398.0)["value"])) / 4e-6;
    assert!(slope < 0.0);
    close(
        number(&volume["price"]),
        -slope,
        slope.abs(),
        1e-3,
        "price of the relation",
    );
    let under_rules = designed(&[
        "--vary=club.cg_depth=20mm..40mm",
        "--subject-to=volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3",
    ]);
    let rule = held(&under_rules, "volume");
    assert!(
        rule["by"] == "limit" && rule["source"].as_str().unwrap().contains("part 2"),
        "{rule}"
    );
}

#[test]
fn a_relation_is_read_or_refused_with_its_position() {
    let setup = Setup::modern_driver();
    let read = |text: &str| Constraint::read_relation(&setup, text);
    let limit = read("budget: 2*club.mass - 0.5 g/mm*club.cg_depth + 3 g == 400 g").unwrap();
    assert_eq!(
        (limit.low, limit.high, limit.goal.terms.len()),
        (0.4, 0.4, 3)
    );
    close(limit.goal.terms[1].0, -0.5, 1.0, 1e-15, "coefficient");
    for (text, output, pointed) in [
        (
            "volume: 120 cm^3 + 80 cm*club.cg_depth <= 460 cm^3",
            "an area",
            "80 cm",
        ),
        (
            "volume: 120 cm^3 + 80 cm^2*club.cgdepth <= 460 cm^3",
            "did you mean 'club.cg_depth'",
            "80 cm^2",
        ),
        (
            "volume: 120 cm^3 + 80 qm*club.cg_depth <= 460 cm^3",
            "'qm' is no unit",
            "80 qm",
        ),
        (
            "volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 g",
            "a mass",
            "460 g",
        ),
        ("volume: 120 cm^3 + <= 460 g", "a term is missing", "<="),
        (
            "volume: 120 cm^3 + 80 cm^2*club.cg_depth",
            "no comparison",
            "120",
        ),
        (
            "volume: 120 cm^3 + 20 cm^3 <= 460 cm^3",
            "it contains no parameter",
            "120",
        ),
        ("carry: club.mass <= 210 g", "\"mean(carry) <= …\"", "carry"),
        (
            "head_moi: club.inertia.xx <= 5500 g cm^2",
            "\"head_moi <= …\"",
            "head_moi",
        ),
        (
            ": 120 cm^3 + 80 cm^2*club.cg_depth <= 1 cm^3",
            "has no name",
            ":",
        ),
        (
            "x: 3 s*club.mass <= 4 kg s",
            "give no known quantity",
            "3 s",
        ),
        ("x: 1 g + 2*club.face_semi_axis <= 4 g", "unset", "2*"),
    ] {
        let longdrive::Error::Constraint {
            expression,
            column,
            reason,
        } = read(text).unwrap_err()
        else {
            panic!("{text}")
        };
        assert!(reason.contains(output), "{text}: {reason}");
        let at: String = expression.chars().skip(column).collect();
        assert!(
            at.starts_with(pointed) || pointed == "<=",
            "{text}: points at '{at}'"
        );
    }
}

#[test]
fn a_relation_is_read_with_any_spaces_and_on_either_side_of_its_sign() {
    let setup = Setup::modern_driver();
    let read = |text: &str| {
        let relation = Constraint::read_relation(&setup, text).unwrap();
        (relation.goal.terms, relation.low, relation.high)
    };
    let expected = read("face: 1*swing.attack_angle - 0.5*club.loft <= 10 deg");
    assert_eq!(expected.0[1].0, -0.5);
    for text in [
        "face: 1*swing.attack_angle-0.5*club.loft <= 10 deg",
        "face: swing.attack_angle-0.5*club.loft<=10deg",
        "face: 10 deg >= swing.attack_angle - 0.5*club.loft",
        "face: 10deg>=swing.attack_angle-0.5*club.loft",
        "face: 1e+1 deg >= 1e+0*swing.attack_angle-5.E-1*club.loft",
    ] {
        assert_eq!(read(text), expected, "{text}");
    }
    let expected = read("mass: club.mass+1 g >= 200 g");
    assert_eq!(read("mass: 200 g <= club.mass+1 g"), expected);
}

#[test]
fn designs_outside_the_rules_or_the_face_are_refused_by_name() {
    let cases: [(&[&str], &[&str]); 9] = [
        (
            &["--set=impact.restitution=0.85"],
            &[
                "spring effect",
                "Equipment Rules",
                "0.85",
                "0.822 + 0.008",
                "--rules none",
            ],
        ),
        (
            &["--vary=impact.restitution=0.84..0.9"],
            &[
                "spring effect",
                "the range begins at impact.restitution = 0.84",
            ],
        ),
        (
            &["--set=ball.radius=21mm"],
            &["size of the ball", "21 mm", "21.335 mm"],
        ),
        (
            &["--distribution=ball.mass=uniform(45.5g,46.5g)"],
            &["weight of the ball", "the swings reach ball.mass"],
        ),
        (
            &["--set=club.inertia.xx=6100 g cm^2"],
            &[
                "moment of inertia",
                "6100 g cm^2",
                "5900 g cm^2 + 100 g cm^2",
            ],
        ),
        (
            &[
                "--vary=club.cg_depth=20mm..40mm",
                "--subject-to=volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 500 cm^3",
            ],
            &["the volume", "500 cm^3", "460 cm^3"],
        ),
        (
            &[
                "--set=club.roll_radius=100mm",
                "--set=club.face_semi_axis=1mm",
                "--vary=club.loft=10deg..14deg",
            ],
            &[
                "beyond the edge of a face with a bulge of 305 mm and a roll of 100 mm",
                "strike.high",
            ],
        ),
        (
            &["--set=strike.toe=70mm"],
            &["the swings have values of it"],
        ),
        (
            &["--subject-to=mass: 2*club.mas <= 3 g"],
            &["club.mas", "^"],
        ),
    ];
    for (args, all) in cases {
        let output = longdrive(&[&["design"], &GOLFER[..], args].concat());
        let message = on_one_line(&output.err);
        assert_eq!(output.status, 2, "{args:?}: {message}");
        for part in all {
            assert!(message.contains(part), "{args:?}: {part}: {message}");
        }
    }
    let far = [
        "design",
        "modern-driver",
        "--distribution=strike.toe=uniform(0mm,80mm)",
    ];
    let output = longdrive(&far);
    assert!(
        output.status == 2
            && output
                .err
                .contains("beside the face of any head that conforms"),
        "{}",
        output.err
    );
    // the message names limits that no design can meet
    let (status, found) = json(
        &[
            &["design"],
            &GOLFER[..],
            &["--vary=club.inertia.xx=6100 g cm^2..6500 g cm^2"],
        ]
        .concat(),
    );
    assert_eq!((status, found["status"].as_str()), (1, Some("infeasible")));
    assert!(
        found["message"]
            .as_str()
            .unwrap()
            .contains("head_moi <= 6000 g cm^2"),
        "{found}"
    );
}

#[test]
fn same_bits_of_a_resumed_design() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let args = [&["design"], &GOLFER[..], &WEIGHT[..]].concat();
    let whole = json(&args);
    let (kept, best) = (file("kept"), file("best.toml"));
    let kept = ["--checkpoint", &kept];
    assert_eq!(
        longdrive(&[&args[..], &kept, &["--max-iterations", "2"]].concat()).status,
        1
    );
    assert_eq!(whole, json(&[&args[..], &kept].concat()));
    assert_eq!(json(&[&args[..], &["-o", &best]].concat()).1["file"], best);
    let written = SetupFile::open(std::path::Path::new(&best)).unwrap().setup;
    assert_eq!(
        written.club.weight_1_depth,
        Some(number(&whole.1["optimum"]["club.weight_1.depth"]))
    );
}

/// The answer names assumed defaults and the known error of rigid bodies.
#[test]
fn assumptions_of_a_design_are_printed() {
    let output = longdrive(&["design", "--scenarios", "64"]);
    let text = on_one_line(&output.out);
    assert_eq!(output.status, 0, "{}", output.err);
    for part in [
        "Bliss & Langdown 2026",
        "default goal: the largest mean(carry) - 0.5*rms(lateral)",
        "varied by default: club.bulge_radius, club.roll_radius, club.loft",
        "the gear effect, and the scatter from it, is known to about 30 %",
        "moment of inertia",
        "not checked: no parameter gives it",
        "the rules above are the Rules of Golf",
        "std(carry)",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let free = longdrive(&["design", "--scenarios", "64", "--rules", "none"]);
    assert!(
        free.out.contains("without the Rules of Golf"),
        "{}",
        free.out
    );
}

/// Other commands start from their default preset and say so. A design refuses a file without a
/// preset, because the default preset violates a rule.
#[test]
fn a_file_that_names_no_preset_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, "[swing]\nspeed = \"95 mph\"\n").unwrap();
    let file = path.display().to_string();
    let output = longdrive(&["design", &file]);
    assert_eq!(output.status, 2, "{}", output.out);
    assert!(output.err.contains("it names no preset"), "{}", output.err);
    let output = longdrive(&["simulate", &file]);
    let title = on_one_line(&output.out);
    assert!(title.contains("mine.toml (tour-average)"), "{title}");
}

/// The tolerance is relative: a volume 0.2 % above its limit exceeds it. An absolute tolerance of
/// 1e-6 m³ would be a whole cm³.
#[test]
fn a_limit_of_a_small_quantity_is_met_within_a_millionth_of_its_value() {
    let setup = Setup::modern_driver();
    let volume = Constraint::read_relation(&setup, "volume: 80 cm^2*club.cg_depth <= 460 cm^3");
    let volume = volume.unwrap();
    assert!(volume.is_met(460e-6) && volume.is_met(460e-6 * (1.0 + 1e-7)));
    assert!(!volume.is_met(461e-6));
}

#[test]
fn exact_limits_with_their_tolerances() {
    let bounds = RULES.iter().map(GolfRule::bound).collect::<Vec<_>>();
    for (bound, expected) in bounds
        .iter()
        .zip([6000e-7, 470e-6, 0.83, 0.04593, 0.04267 / 2.0])
    {
        assert!((bound - expected).abs() < 1e-12 * expected, "{bound}");
    }
    assert!(
        RULES[2].allows(0.83)
            && !RULES[2].allows(0.8301)
            && RULES[4].allows(0.022)
            && !RULES[4].allows(0.021)
    );
    assert_eq!(
        RULES[0].expression(),
        "head_moi <= 5900 g cm^2 + 100 g cm^2"
    );
    let least = GolfRule {
        tolerance: Some("0.335 mm"),
        ..RULES[4]
    };
    assert!((least.bound() - 0.021).abs() < 1e-15, "{}", least.bound());
    assert_eq!(least.expression(), "ball.radius >= 21.335 mm - 0.335 mm");
}
