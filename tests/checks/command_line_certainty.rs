//! `verify`, `sensitivity` and `uncertainty` on the command line.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{SET_RIGID, close};
use crate::program;

#[test]
fn certified_derivatives_as_json() {
    let (status, found) = json(&[
        "verify",
        "mae494",
        "--of",
        "carry",
        "--wrt",
        "club.loft,swing.speed",
    ]);
    assert_eq!(
        (
            status,
            found["passed"].as_bool(),
            found["negative_control"]["caught"].as_bool()
        ),
        (0, Some(true), Some(true))
    );
    let rows = found["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 2);
    let loft = rows
        .iter()
        .find(|row| row["of"] == "carry" && row["parameter"] == "club.loft")
        .unwrap();
    assert_eq!(loft["verdict"], "pass");
    close(number(&loft["exact"]), 336.769746388603, 1.0, 1e-8, "exact");
    close(
        number(&loft["best_difference"]),
        336.769746388603,
        1.0,
        1e-6,
        "difference",
    );
    assert!(number(&loft["error"]) <= number(&loft["tolerance"]));
    assert_eq!(loft["curve"]["steps"].as_array().unwrap().len(), 25);
    assert!(
        found["landing"].as_array().unwrap().len() == 6
            && !found["continuity"].as_array().unwrap().is_empty()
    );
    let printed = longdrive(&["verify", "mae494", "--wrt", "club.loft"]);
    assert!(
        printed.status == 0 && printed.out.contains("passed: 0 fail, 0 corner, 2 pass"),
        "{}",
        printed.out
    );
}

#[test]
fn corners_neither_pass_nor_fail_and_no_flight_does_not_pass() {
    let corner = [
        "verify",
        "mae494",
        "--set",
        "club.loft=0deg",
        "--set",
        "swing.attack_angle=20deg",
    ];
    let (status, found) =
        json(&[corner.as_slice(), &["--of", "carry", "--wrt", "club.loft"]].concat());
    let carry = found["rows"]
        .as_array()
        .unwrap()
        .iter()
        .find(|row| row["of"] == "carry")
        .unwrap();
    assert_eq!((status, carry["verdict"].as_str()), (0, Some("corner")));
    let [below, above] = [0, 1].map(|side| number(&carry["sides"][side]));
    assert!(below > above + 10.0, "{below} {above}");
    let (status, found) = json(&[
        "verify",
        "mae494",
        "--set",
        "swing.attack_angle=-20deg",
        "--wrt",
        "club.loft",
    ]);
    assert_eq!((status, found["status"].as_str()), (1, Some("no-flight")));
    assert!(
        found["message"]
            .as_str()
            .unwrap()
            .starts_with("no flight: "),
        "{found}"
    );
}

#[test]
fn exact_no_deviation_once_the_only_uncertain_parameter_is_known() {
    let args = [
        "uncertainty",
        "--sigma",
        "swing.speed=1mph",
        "--of",
        "carry",
        "--seed",
        "1",
        "--samples",
        "256",
    ];
    let text = longdrive(&[&args[..], &["--all"]].concat()).out;
    let message = on_one_line(&text);
    assert!(
        message.contains("uncertain: swing.speed; all other values count as known"),
        "{text}"
    );
    assert!(
        message.contains("once it is known exactly, the standard deviation falls to 0.00 yd"),
        "{text}"
    );
    assert!(
        message.contains("100.0 % (100.0 to 100.0)") && !message.contains("<="),
        "{text}"
    );
    let (_, found) = json(&args);
    let outcome = &found["outcomes"][0];
    assert_eq!(
        number(&outcome["measure_first"]["standard_uncertainty"]),
        0.0
    );
    // if the carry is nearly linear in a normally distributed parameter, the upper bound is nearly
    // 1
    let bound = &outcome["indices"][0]["bound"];
    assert!(
        number(&bound["low"]) < 1.0 && 1.0 < number(&bound["high"]),
        "{bound}"
    );
}

#[test]
fn the_answer_gives_the_reason_for_omitted_drives() {
    let args = [
        "sensitivity",
        "--sigma",
        "swing.speed=500 mph",
        "--no-defaults",
    ];
    let (status, found) = json(&args);
    assert_eq!(
        (status, &found["outcomes"][0]["effects"][0]["flown"]),
        (0, &serde_json::json!([null, null]))
    );
    let message = found["warnings"].to_string();
    assert!(
        message.contains("no drive at −σ of swing.speed: swing.speed = ")
            && message.contains("outside its range"),
        "{message}"
    );
    assert!(
        message.contains("no drive at +σ of swing.speed: the club does not strike the ball"),
        "{message}"
    );
    for (units, unit) in [("us", "mph"), ("metric", "m/s")] {
        let printed = longdrive(&[&args[..], &["--units", units]].concat());
        let (_, approach) = printed.err.split_once("along the face normal at").unwrap();
        let words: Vec<_> = approach.split_whitespace().take(2).collect();
        assert_eq!(words[1].trim_end_matches(','), unit, "{}", printed.err);
    }
    assert_eq!(longdrive(&args).status, 0);
}

#[test]
fn effects_and_the_sensitivity_of_an_optimum_as_json() {
    let (status, found) = json(&[
        "sensitivity",
        "--sigma",
        "swing.speed=1 mph",
        "--no-defaults",
    ]);
    let carry = &found["outcomes"][0];
    let first = &carry["effects"][0];
    assert_eq!(
        (status, first["parameter"].as_str()),
        (0, Some("swing.speed"))
    );
    close(
        number(&first["effect"]),
        number(&first["derivative"]) * 0.44704,
        1.0,
        1e-12,
        "effect",
    );
    close(
        number(&carry["standard_uncertainty"]),
        number(&first["effect"]),
        1.0,
        1e-12,
        "together",
    );
    assert!(carry["effects"][1]["standard_uncertainty"].is_null());

    let (status, found) = json(&[
        "sensitivity",
        "mae494",
        "--at-optimum",
        "--vary",
        "club.loft=0deg..40deg",
    ]);
    assert_eq!(status, 0);
    let effects = found["outcomes"][0]["effects"].as_array().unwrap();
    let of = |name: &str| {
        effects
            .iter()
            .find(|effect| effect["parameter"] == name)
            .unwrap()
    };
    // at an unconstrained optimum the derivatives by varied parameters are 0. By the envelope
    // theorem the derivative of the optimum then equals the derivative of the drive
    close(
        number(&of("swing.speed")["derivative_of_optimum"]),
        number(&of("swing.speed")["derivative"]),
        1.0,
        1e-7,
        "envelope",
    );
    assert!(
        of("club.loft")["derivative_of_optimum"].is_null()
            && number(&of("club.loft")["derivative"]).abs() < 1e-6
    );
}

/// A search without iterations finds no optimum, so the name is refused before the search.
#[test]
fn a_wrong_name_of_an_uncertainty_is_refused_before_the_search() {
    let search = ["sensitivity", "--at-optimum", "--max-iterations", "0"];
    for (sigma, reason) in [
        ("swing.sped=1mph", "swing.sped"),
        ("swing.speed", "write NAME=AMOUNT"),
    ] {
        let printed = longdrive(&[&search[..], &["--sigma", sigma]].concat());
        assert_eq!(printed.status, 2, "{}", printed.err);
        assert!(printed.err.contains(reason), "{}", printed.err);
    }
}

/// A percentage is of the value that the parameter has in the analysed drive: the optimum.
#[test]
fn a_percentage_at_the_optimum_is_of_the_value_there() {
    let sigma = ["--no-defaults", "--sigma", "club.loft=10%"];
    let (status, found) = json(&[&["sensitivity", "--at-optimum"], &sigma[..]].concat());
    assert_eq!(status, 0);
    let effects = found["outcomes"][0]["effects"].as_array().unwrap();
    let loft = effects
        .iter()
        .find(|effect| effect["parameter"] == "club.loft")
        .unwrap();
    let at_optimum = number(&found["at_optimum"]["optimum"]["club.loft"]);
    let sigma = number(&loft["standard_uncertainty"]);
    close(sigma, 0.1 * at_optimum, at_optimum, 1e-12, "a tenth");
}

#[test]
fn same_uncertainty_as_json_for_one_seed() {
    let requested = [
        "uncertainty",
        "--sigma",
        "swing.speed=1mph",
        "--distribution",
        "club.loft=triangular(9.5deg,9.8deg,10.1deg)",
        "--samples",
        "200",
    ];
    let (status, found) = json(&requested);
    assert_eq!(
        (
            status,
            number(&found["drives"]),
            number(&found["statuses"]["landed"])
        ),
        (0, 800.0, 800.0)
    );
    let carry = &found["outcomes"][0];
    let deviation = &carry["monte_carlo"]["standard_uncertainty"];
    assert!(
        number(&deviation["low"]) <= number(&deviation["value"])
            && number(&deviation["value"]) <= number(&deviation["high"])
    );
    close(
        number(&deviation["value"]),
        number(&carry["delta"]["standard_uncertainty"]),
        number(&deviation["value"]),
        0.2,
        "deviation",
    );
    assert_eq!(carry["measure_first"]["parameter"], "swing.speed");
    assert_eq!(found["ellipses"].as_array().unwrap().len(), 4);
    let one_thread = program::command()
        .args(requested)
        .arg("--json")
        .env("RAYON_NUM_THREADS", "1")
        .output();
    assert_eq!(
        serde_json::from_slice::<serde_json::Value>(&one_thread.unwrap().stdout).unwrap(),
        found
    );
    assert_ne!(
        json(&[requested.as_slice(), &["--seed", "1"]].concat()).1["outcomes"],
        found["outcomes"]
    );
}

#[test]
fn drives_that_do_not_fly_are_reported_and_none_at_all_is_no_answer() {
    let partly = [
        "uncertainty",
        "modern-driver",
        "--set",
        "swing.attack_angle=0deg",
        "--distribution",
        "club.loft=uniform(-2deg,4deg)",
        "--samples",
        "200",
    ];
    let printed = longdrive(&[&partly[..], &["--all"]].concat());
    assert!(
        printed.status == 0
            && printed.out.contains("no-flight")
            && printed.out.contains("these shares leave out"),
        "{}",
        printed.out
    );
    let never = [
        "uncertainty",
        "modern-driver",
        "--set",
        "swing.attack_angle=-30deg",
        "--sigma",
        "club.loft=0.1deg",
        "--samples",
        "50",
        "--of",
        "carry",
    ];
    let (status, found) = json(&never);
    assert_eq!(
        (status, number(&found["statuses"]["no-flight"])),
        (1, 150.0)
    );
    assert!(found["outcomes"][0]["monte_carlo"].is_null());
}

#[test]
fn mistakes_are_bad_input_with_advice() {
    for (args, says) in [
        (vec!["verify", "--of", "cary"], "did you mean 'carry'?"),
        (
            vec!["verify", "--wrt", "flight.step"],
            "setting of the computation",
        ),
        (
            vec!["sensitivity", "--sigma", "swing.speed"],
            "write NAME=AMOUNT",
        ),
        (
            vec!["sensitivity", "--sigma", "swing.speed=-1mph"],
            "above 0",
        ),
        (
            vec![
                "sensitivity",
                "--sigma",
                "swing.speed=1mph",
                "--sigma",
                "swing.speed=2mph",
            ],
            "given twice",
        ),
        (
            vec![
                "uncertainty",
                "--distribution",
                "club.loft=gauss(1deg,2deg)",
            ],
            "write NAME=normal(MEAN,DEVIATION)",
        ),
        (
            vec!["uncertainty", "--distribution", "club.loft=beta(1,2)"],
            "there is no distribution \"beta\"; write",
        ),
        (
            vec!["gradient", "--wrt", "launch.launch_angle"],
            "it is unset here; give it a value with --set",
        ),
        (
            vec!["chart", "--along", "swing.speed"],
            "write NAME=LOW..HIGH, for example swing.speed=80mph..130mph, or give",
        ),
        (
            vec!["optimize", "--vary", "aero.cd0=0.1"],
            "'0.1' is not LOW..HIGH; write aero.cd0=LOW..HIGH",
        ),
        (
            vec!["optimize", "--vary", "club.loft=4deg.."],
            "upper end is missing; write club.loft=LOW deg..HIGH deg",
        ),
        (
            vec!["simulate", "--tolerance=0mm"],
            "--tolerance: \"0mm\" is no tolerance; give a length above 0",
        ),
        (
            vec!["optimize", "--tolerance=1um", "--set", "flight.method=dp8"],
            "--tolerance: it chooses method and step, and --set flight.method states one of them",
        ),
        (
            vec![
                "uncertainty",
                "--distribution",
                "club.loft=uniform(12deg,9deg)",
            ],
            "must rise",
        ),
        (
            vec!["uncertainty", "--sigma", "club.lofft=1deg"],
            "did you mean 'club.loft'?",
        ),
        (
            vec!["uncertainty", "--samples", "1"],
            "a whole number from 2 to 1000000",
        ),
    ] {
        let printed = longdrive(&args);
        assert!(
            printed.status == 2 && printed.err.contains(says),
            "{args:?}: {} {}",
            printed.status,
            printed.err
        );
        assert!(printed.out.is_empty(), "{}", printed.out);
    }
}

/// Of a normal distribution with mean 115 mph and deviation 200 mph, 28 % are below 0. Of the
/// sample with seed 0, 29 % are below 0.
#[test]
fn a_distribution_far_beyond_the_range_of_its_parameter_has_a_warning() {
    let error = |text| {
        longdrive(&["uncertainty", "--distribution", text])
            .err
            .replace("\n  ", " ")
    };
    let (wide, cut) = (
        error("swing.speed=normal(115mph,200mph)"),
        error("swing.speed=truncated(115mph,200mph,60mph,130mph)"),
    );
    assert!(
        wide.contains("warning: 29 % of the drives have a value outside of its allowed range"),
        "{wide}"
    );
    assert!(
        wide.contains("with truncated(MEAN,DEVIATION,LOW,HIGH)") && !cut.contains("left out"),
        "{wide} {cut}"
    );
}

/// If a derivative is 0 except for rounding, the text shows 0 without a sign. JSON keeps the
/// digits.
#[test]
fn rounding_is_shown_as_0_in_texts_and_kept_in_json() {
    let of_zero = |word: &str| {
        let digits = word.trim_start_matches(['+', '-']);
        let is_zero = digits.contains('0') && digits.bytes().all(|byte| b"0.".contains(&byte));
        is_zero && digits.len() < word.len()
    };
    let is_rounding = |word: &str| {
        let power = word
            .rsplit_once("e-")
            .filter(|_| word.starts_with(|c: char| c.is_ascii_digit() || c == '-'));
        power.is_some_and(|(_, power)| power.parse().is_ok_and(|power: u32| power >= 13))
    };
    for args in [
        vec!["sensitivity", "--of", "all"],
        vec!["sensitivity", "--at-optimum"],
        vec!["gradient", "--of", "all", "--wrt", "all"],
        vec!["optimum-sensitivity", "--all"],
    ] {
        let printed = longdrive(&args);
        assert_eq!(printed.status, 0, "{args:?} {}", printed.err);
        // skip the KKT residual: it may be as small as rounding, but it is not a derivative
        let lines = printed
            .out
            .lines()
            .filter(|line| !line.contains("KKT residual"));
        let words = lines.flat_map(str::split_whitespace);
        let wrong: Vec<_> = words
            .filter(|word| of_zero(word) || is_rounding(word))
            .collect();
        assert!(wrong.is_empty(), "{args:?}: {wrong:?}");
    }
    let text = longdrive(&[
        "gradient",
        "--of",
        "backspin",
        "--wrt",
        "swing.attack_angle,club.loft",
    ])
    .out;
    assert!(
        text.contains("0 rpm per deg") && !text.contains("e-"),
        "{text}"
    );
    let (_, answer) = json(&[
        "gradient",
        "--of",
        "backspin",
        "--wrt",
        "swing.attack_angle",
    ]);
    let kept = answer["outcomes"][0]["gradient"]["swing.attack_angle"]
        .as_f64()
        .unwrap();
    assert!(kept != 0.0 && kept.abs() < 1e-9, "{kept}");
}

#[test]
fn a_certificate_that_fails_names_what_failed() {
    let ground = [
        "--set",
        "ground.height=-10000m",
        "--wrt",
        "ground.height",
        "--of",
        "landing_speed",
    ];
    let wind = [
        "verify",
        "modern-driver",
        "--set",
        "aero.law=ferguson",
        "--set",
        "wind.roughness=10000mm",
    ];
    let printed = longdrive(&[&wind[..], &SET_RIGID, &ground].concat());
    let words = on_one_line(&printed.out);
    assert_eq!(printed.status, 1);
    assert!(words.contains("fail (second)"), "{words}");
    assert!(
        words.contains("fail: the second derivative of landing_speed by ground.height is "),
        "{words}"
    );
    let ending = "FAILED: second derivatives (landing_speed by ground.height); derivatives: 1 \
                  fail, 0 corner, 0 pass";
    assert!(words.ends_with(ending), "{words}");
    assert!(
        words.contains(
            "not checked: the planted error \"sign\" changes none of the derivatives that passed"
        ),
        "{words}"
    );
}

#[test]
fn the_order_of_convergence_does_not_depend_on_the_step_of_the_setup() {
    let requested = [
        "verify",
        "--set",
        "aero.law=linear",
        "--of",
        "landing_speed",
        "--wrt",
        "club.loft,swing.speed",
    ];
    for step in ["flight.step=0.5s", "flight.step=10ms"] {
        let (status, found) = json(&[&requested[..], &["--set", step]].concat());
        let [value, gradient] =
            [0, 1].map(|which| number(&found["convergence"][0]["orders"][which]));
        assert!(
            status == 0 && value > 3.25 && gradient > 3.25,
            "{step}: {value} {gradient}"
        );
    }
}

#[test]
fn no_effect_and_a_too_small_uncertainty_have_different_messages() {
    let without = [
        "sensitivity",
        "--of",
        "ball_speed",
        "--sigma",
        "air.density=1%",
        "--no-defaults",
    ];
    let printed = longdrive(&without);
    assert!(
        printed.status == 0
            && printed
                .out
                .contains("ball_speed does not depend on air.density here"),
        "{}",
        printed.out
    );
    let small = ["--of", "carry", "--sigma", "swing.speed=1e-13mph"];
    let printed = longdrive(&[&["sensitivity", "--no-defaults"], &small[..]].concat());
    assert!(
        printed.status == 0 && !printed.out.contains("does not depend"),
        "{}",
        printed.out
    );
    let printed = longdrive(&[&["uncertainty", "--samples", "50"], &small[..]].concat());
    assert!(
        printed.status == 0 && printed.out.contains("it varies by less than rounding"),
        "{}",
        printed.out
    );
    assert!(!printed.out.contains("does not depend"), "{}", printed.out);
}

#[test]
fn an_unset_parameter_is_named_with_its_meaning() {
    let launch = [
        "--launch",
        "ball_speed=160mph,launch_angle=10deg,backspin=2500rpm",
    ];
    let printed = longdrive(&[&["verify", "--wrt", "launch.sidespin"], &launch[..]].concat());
    assert!(
        printed.status == 2
            && printed
                .err
                .contains("unset here, which means: 0; give it a value"),
        "{}",
        printed.err
    );
}

#[test]
fn the_while_loop_is_compared_only_where_it_has_a_difference() {
    // two parameters have no comparison: at the end of its range the spin decay has no central
    // difference, and the carry of mae494 does not depend on the viscosity
    for wrt in [
        "aero.spin_decay",
        "aero.spin_decay,air.viscosity,swing.speed",
    ] {
        let set = "aero.spin_decay=0/s";
        let printed = longdrive(&["verify", "mae494", "--set", set, "--wrt", wrt]);
        let words = on_one_line(&printed.out);
        assert!(
            !words.contains("scale is –") && !words.contains("is that of d carry/d air.viscosity"),
            "{words}"
        );
        assert_eq!(
            words.contains("The largest error is that of d carry/d swing.speed"),
            wrt.contains("swing.speed"),
            "{words}"
        );
    }
}
