//! Bounds and limits in answers: active ones, their multipliers, and designs that violate them.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use serde_json::Value;

/// The words of an answer, with single spaces.
fn text_of(args: &[&str]) -> String {
    let output = longdrive(args);
    assert_eq!(output.status, 0, "{args:?}: {} {}", output.out, output.err);
    on_one_line(&output.out)
}

/// The number between two texts.
fn between(text: &str, before: &str, after: &str) -> f64 {
    let rest = text
        .split(before)
        .nth(1)
        .unwrap_or_else(|| panic!("no '{before}' in {text}"));
    let number = rest.split(after).next().unwrap().trim();
    number
        .parse()
        .unwrap_or_else(|_| panic!("'{number}' in {text}"))
}

const SWINGS: [&str; 4] = [
    "optimize",
    "-q",
    "--distribution",
    "swing.attack_angle=normal(-1deg,2deg)",
];

fn over_swings(limit: &str) -> Vec<&str> {
    [&SWINGS[..], &["--subject-to", limit]].concat()
}

#[test]
fn differences_of_optima_are_the_price_of_a_limit_over_swings() {
    let text = text_of(&over_swings("std(carry) <= 4.5yd"));
    let price = between(
        &text,
        "std(carry) <= 4.5yd active: +",
        " yd for each yard that the limit is relaxed",
    );
    let best = |limit: &str| number(&json(&over_swings(limit)).1["value"]);
    let slope = (best("std(carry) <= 4.52yd") - best("std(carry) <= 4.48yd")) / (0.04 * 0.9144);
    // the text has three digits of the multiplier
    close(
        price,
        slope,
        slope,
        5e-3,
        "yards of carry for a yard of scatter",
    );
    // two designs violate the limit: the optimum for the mean swing, and the design as set up
    assert_eq!(text.matches("(broken)").count(), 2, "{text}");
    assert!(
        text.contains("the design as set up violates a limit"),
        "{text}"
    );
    assert!(
        text.contains("the best design of the mean swing violates a limit"),
        "{text}"
    );
}

#[test]
fn a_design_that_violates_a_relation_is_marked() {
    let text = text_of(&over_swings("loft: club.loft >= 10 deg"));
    assert!(
        text.contains("8.8° (broken)") || text.contains("8.80° (broken)"),
        "{text}"
    );
    assert!(
        text.contains("the design as set up violates a limit"),
        "{text}"
    );
    let kept = text_of(&over_swings("loft: club.loft >= 4.5 deg"));
    assert!(
        !kept.contains("break") && !kept.contains("(broken)") && kept.contains("not active"),
        "{kept}"
    );
}

#[test]
fn differences_of_optima_are_the_price_of_the_active_side() {
    for (limit, words, sides) in [
        (
            "20 yd <= apex_height <= 35 yd",
            [
                "active at its upper limit: +",
                " yd for each yard that it is raised",
            ],
            ["apex_height <= 34.9 yd", "apex_height <= 35.1 yd"],
        ),
        (
            "45 yd <= apex_height <= 50 yd",
            [
                "active at its lower limit: +",
                " yd for each yard that it is lowered",
            ],
            ["apex_height >= 45.1 yd", "apex_height >= 44.9 yd"],
        ),
    ] {
        let price = between(
            &text_of(&["optimize", "-q", "--subject-to", limit]),
            words[0],
            words[1],
        );
        let [tight, loose] =
            sides.map(|limit| number(&json(&["optimize", "--subject-to", limit]).1["value"]));
        let slope = (loose - tight) / (0.2 * 0.9144);
        close(price, slope, slope, 1e-2, limit);
    }
}

fn robust(more: &[&str]) -> Vec<String> {
    let fixed = [
        "robust",
        "--model",
        "aero.law=ferguson",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    fixed
        .iter()
        .chain(more)
        .map(|text| (*text).to_owned())
        .collect()
}

fn as_text(args: &[String]) -> Vec<&str> {
    args.iter().map(String::as_str).collect()
}

#[test]
fn differences_of_the_greatest_loss_are_the_prices_of_the_active_limits_of_a_robust_design() {
    // only one of the two models has an active limit of the apex height
    let limited = |limit: &str| robust(&["--subject-to", limit]);
    let (args, tight, loose) = (
        limited("apex_height <= 30 yd"),
        limited("apex_height <= 29.9 yd"),
        limited("apex_height <= 30.1 yd"),
    );
    let found = json(&as_text(&args)).1;
    let least = |model: &Value| number(&model["constraints"][0]["multiplier"]);
    let models = found["models"].as_array().unwrap();
    let prices: Vec<f64> = models.iter().map(least).collect();
    assert!(prices.iter().any(|price| *price > 1e-3), "{found:#}");
    let [tight, loose] =
        [tight, loose].map(|args| number(&json(&as_text(&args)).1["greatest_loss"]));
    close(
        prices.iter().sum(),
        (tight - loose) / (0.2 * 0.9144),
        1.0,
        2e-2,
        "fall of the greatest loss for a metre of apex",
    );
    let text = text_of(&as_text(&[args, vec!["-q".into()]].concat()));
    assert!(
        text.contains("apex_height <= 30 yd 1 ") && text.contains("that the limit is relaxed"),
        "{text}"
    );
    assert!(
        text.contains("its loss decides the robust design"),
        "{text}"
    );

    // the best attack angle is at the upper end of the default range
    let of_attack = |high: &str| {
        let attack = format!("swing.attack_angle=-5deg..{high}");
        let args = [
            "robust",
            "--model",
            "aero.law=ferguson",
            "--vary",
            "club.loft=4deg..20deg",
            "--vary",
            &attack,
        ];
        (json(&args).1, longdrive(&[&args[..], &["-q"]].concat()).out)
    };
    let (found, text) = of_attack("5deg");
    assert!(text.contains("at its upper bound: "), "{text}");
    assert_eq!(found["models"][0]["constraints"], Value::Array(vec![]));
}

#[test]
fn a_search_without_an_optimum_does_not_call_its_end_one() {
    for (more, status, head) in [
        (
            &["--subject-to", "apex_height >= 300 yd"][..],
            "infeasible",
            "nearest point",
        ),
        (
            &["--max-iterations", "1"][..],
            "iteration-limit",
            "last point",
        ),
    ] {
        for requested in [&["optimize", "-q"][..], &SWINGS[..]] {
            let more: Vec<&str> = match requested.len() {
                4 if more[0] == "--subject-to" => {
                    vec!["--subject-to", "mean(apex_height) >= 300 yd"]
                }
                _ => more.to_vec(),
            };
            let output = longdrive(&[requested, &more[..]].concat());
            assert_eq!(output.status, 1, "{}", output.out);
            // the text begins with the setup
            let blocks = output.out.split("\n\n").next().unwrap();
            assert!(blocks.contains(&format!("\n{status}: ")), "{}", output.out);
            assert!(
                output.out.starts_with("from tour-average"),
                "{}",
                output.out
            );
            let line = output
                .out
                .lines()
                .find(|line| line.trim_start().starts_with("vary "))
                .unwrap();
            assert!(
                line.contains(head) && !line.contains("optimum") && !line.contains("best"),
                "{line}"
            );
        }
    }
    let best = longdrive(&["optimize", "-q"]).out;
    assert!(
        best.contains("optimum") && !best.contains("last point"),
        "{best}"
    );
}

#[test]
fn the_nearest_point_names_a_bound_that_it_has_reached() {
    let vary = |range: &str| format!("club.loft={range}");
    let row = |range: &str| {
        let limit = ["--subject-to", "spin <= 1000rpm", "--vary", &vary(range)];
        let output = longdrive(&[&["optimize", "-q", "--attack=-2deg"], &limit[..]].concat());
        assert!(output.out.contains("\ninfeasible: "), "{}", output.out);
        let row = output
            .out
            .lines()
            .find(|line| line.starts_with("  club.loft "));
        row.unwrap().to_owned()
    };
    // less loft gives less spin
    assert!(row("4deg..20deg").ends_with("4.00°  4° .. 20°  at its lower bound"));
    assert!(row("8deg..20deg").ends_with("8.00°  8° .. 20°  at its lower bound"));
}

#[test]
fn a_range_of_several_values_does_not_print_as_one() {
    let narrow = [
        "optimize",
        "-q",
        "--vary",
        "club.loft=10deg..10.0000001deg",
        "--vary",
        "swing.attack_angle=-5deg..5deg",
    ];
    let text = text_of(&narrow);
    assert!(text.contains("10° .. 10.0000001°"), "{text}");
}

/// The least spin has one loft and many attack angles. The search ends at the limit on the carry,
/// which does not decide the spin: its multiplier is rounding.
#[test]
fn a_limit_whose_multiplier_is_rounding_is_not_active() {
    for limit in ["carry >= 280yd", "carry >= 285yd"] {
        let search = ["--minimize", "spin", "--subject-to", limit];
        let (_, found) = json(&[&["optimize"], &search[..]].concat());
        let constraint = &found["constraints"][0];
        assert_eq!(number(&constraint["multiplier"]), 0.0, "{constraint:#}");
        let text = text_of(&[&["optimize"], &search[..]].concat());
        assert!(text.contains("yd not active"), "{text}");
        let change = ["--wrt", "swing.speed", "--loss", "50rpm"];
        let text = longdrive(&[&["optimum-sensitivity"], &search[..], &change].concat()).out;
        assert!(!text.contains("together"), "{text}");
    }
}
