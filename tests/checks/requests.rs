//! Requests of a program that uses the library, converted to command lines.

use longdrive::command::{ArgumentValue, Call, quantity_of_goal};
use longdrive::units::Quantity;

fn words(command: &str, arguments: Vec<(&str, ArgumentValue)>) -> Vec<String> {
    let arguments = arguments
        .into_iter()
        .map(|(name, value)| (name.into(), value));
    let call = Call {
        command: command.into(),
        arguments: arguments.collect(),
    };
    let words = call.words().unwrap();
    words
        .into_iter()
        .map(|word| word.into_string().unwrap())
        .collect()
}

fn number(number: f64) -> Box<ArgumentValue> {
    Box::new(ArgumentValue::Number(number))
}

#[test]
fn exact_numbers_have_the_si_unit_of_their_argument_parameter_or_goal() {
    let change = ArgumentValue::Named("swing.speed".into(), number(1.5));
    let arguments = vec![
        ("loss", ArgumentValue::Number(1e-7)),
        ("minimize", ArgumentValue::Text("std(launch_angle)".into())),
        ("change", ArgumentValue::Several(vec![change])),
        ("tolerance", ArgumentValue::Number(0.001)),
        ("max_iterations", ArgumentValue::Whole(3)),
        ("overwrite", ArgumentValue::Switch(true)),
        ("json", ArgumentValue::Switch(false)),
        ("setup", ArgumentValue::Text("-".into())),
    ];
    let mut written = words("optimum-sensitivity", arguments);
    written.sort();
    let expected = [
        "-",
        "--change=swing.speed=1.5 m/s",
        "--loss=1e-7 rad",
        "--max-iterations=3",
        "--minimize=std(launch_angle)",
        "--overwrite",
        "--tolerance=0.001 m",
        "longdrive",
        "optimum-sensitivity",
    ];
    assert_eq!(written, expected);
}

#[test]
fn exact_numbers_of_short_options_have_an_si_unit() {
    let numbers = [
        ("speed", 42.5),
        ("attack", 0.05),
        ("loft", 0.25),
        ("temperature", 280.5),
        ("wind", 3.5),
        ("altitude", 100.5),
    ];
    let mut written = words(
        "simulate",
        numbers
            .map(|(name, number)| (name, ArgumentValue::Number(number)))
            .to_vec(),
    );
    written.sort();
    let expected = [
        "--altitude=100.5 m",
        "--attack=0.05 rad",
        "--loft=0.25 rad",
        "--speed=42.5 m/s",
        "--temperature=280.5 K",
        "--wind=3.5 m/s",
        "longdrive",
        "simulate",
    ];
    assert_eq!(written, expected);
}

#[test]
fn exact_distributions_and_several_changes_are_one_word_each() {
    let numbers = vec![
        ArgumentValue::Text("1deg".into()),
        ArgumentValue::Number(0.25),
    ];
    let distribution = ArgumentValue::Distribution("normal".into(), numbers);
    let distribution = ArgumentValue::Named("swing.path".into(), Box::new(distribution));
    let model = ArgumentValue::Joined(vec![
        ArgumentValue::Named("aero.cd0".into(), number(0.2)),
        ArgumentValue::Named("club.loft".into(), number(0.2)),
    ]);
    let arguments = vec![
        ("distribution", distribution),
        ("model", ArgumentValue::Several(vec![model])),
    ];
    let mut written = words("robust", arguments);
    written.sort();
    let expected = [
        "--distribution=swing.path=normal(1deg,0.25 rad)",
        "--model=aero.cd0=0.2,club.loft=0.2 rad",
        "longdrive",
        "robust",
    ];
    assert_eq!(written, expected);
}

#[test]
fn exact_goals_have_the_unit_of_their_first_outcome() {
    assert_eq!(
        quantity_of_goal("2*mean(carry) - std(lateral)"),
        Some(Quantity::LENGTH)
    );
    assert_eq!(quantity_of_goal("within(lateral, 15yd)"), None);
}

#[test]
fn unknown_arguments_are_named() {
    let call = Call {
        command: "plot laws".into(),
        arguments: vec![("sense".into(), ArgumentValue::Switch(true))],
    };
    let message = call.words().unwrap_err().to_string();
    assert_eq!(
        message,
        "sense: `plot laws()` has no such argument; leave it out"
    );
}
