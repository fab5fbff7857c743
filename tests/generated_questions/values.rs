//! Names and values for command lines, correct and wrong.

use crate::choices::Choices;
use longdrive::parameters::{Kind, Law, PRESETS, Parameter};
use longdrive::{Outcome, Setup};

/// Texts that are not values, or unusual values.
const ODD: [&str; 25] = [
    "",
    " ",
    "nan",
    "NaN",
    "inf",
    "-inf",
    "1e300",
    "-1e300",
    "1e-300",
    "-0",
    "0",
    "none",
    "abc",
    "10 kg",
    "10deg deg",
    "1e999",
    "0x10",
    "١٠",
    "--",
    "=",
    "10,5 deg",
    "5%",
    "1e5 mph",
    "\u{0}x",
    "🏌",
];

pub fn preset(choices: &mut Choices) -> &'static str {
    PRESETS[choices.below(PRESETS.len())].name
}

/// A parameter of a preset. By mistake, a parameter of any law or of a launch.
pub fn parameter(choices: &mut Choices) -> &'static Parameter {
    if choices.makes_mistake() {
        return choices.of(&Law::all_rows().collect::<Vec<_>>());
    }
    if choices.is_launched {
        let mut all = launched().parameters();
        all.retain(|row| {
            !row.is_of_strike() && row.name != "launch.spin" && row.name != "launch.spin_axis"
        });
        return choices.of(&all);
    }
    let all = Setup::preset(preset(choices)).unwrap().parameters();
    usual_or_mistaken(&all, choices)
}

/// The default setup with a launch in place of the club.
fn launched() -> Setup<f64> {
    let mut setup = Setup::modern_driver();
    let launch = [
        ("ball_speed", "167 mph"),
        ("launch_angle", "10.9 deg"),
        ("backspin", "2686 rpm"),
    ];
    for (name, value) in launch {
        setup.set(&format!("launch.{name}"), value).unwrap();
    }
    setup
}

/// A parameter that a search may vary, and by which a derivative may be taken.
pub fn variable(choices: &mut Choices) -> &'static Parameter {
    if choices.is_launched {
        let mut all = launched().variables();
        if choices.is(0.7) {
            all.retain(|row| row.is_of_launch());
        }
        return choices.of(&all);
    }
    let mut all = Setup::modern_driver().variables();
    if choices.is_over_swings {
        // only parameters of the club, because the swings state the others
        all.retain(|row| row.name.starts_with("club."));
        return usual_or_mistaken(&all, choices);
    }
    if choices.is_of_flight {
        let of_the_club = ["swing.", "club.", "strike.", "impact."];
        all.retain(|row| !of_the_club.iter().any(|group| row.name.starts_with(group)));
        return usual_or_mistaken(&all, choices);
    }
    // the most frequent parameters of users
    let usual = [
        "club.loft",
        "swing.attack_angle",
        "swing.speed",
        "swing.path",
        "swing.face_angle",
        "air.density",
    ];
    if choices.is(0.6) {
        Setup::modern_driver().variable(choices.of(&usual)).unwrap()
    } else {
        usual_or_mistaken(&all, choices)
    }
}

/// One of `all`. A launch parameter is a mistake, and so is the speed or the direction of the wind,
/// which must be given together.
fn usual_or_mistaken(all: &[&'static Parameter], choices: &mut Choices) -> &'static Parameter {
    let struck: Vec<_> = all
        .iter()
        .copied()
        .filter(|row| {
            !row.name.starts_with("launch.") && !["wind.speed", "wind.from"].contains(&row.name)
        })
        .collect();
    if choices.makes_mistake() {
        choices.of(all)
    } else {
        choices.of(&struck)
    }
}

/// Name of a parameter; sometimes one that does not exist.
pub fn name_of(parameter: &Parameter, choices: &mut Choices) -> String {
    let name = parameter.name;
    if !choices.makes_mistake() {
        return name.into();
    }
    choices.of(&[
        name.replace('.', ""),
        format!("{name}x"),
        name.to_uppercase(),
        String::new(),
    ])
}

/// A value near the parameter's default, SI, at a relative distance of at most `spread`.
pub fn near(parameter: &Parameter, spread: f64, choices: &mut Choices) -> f64 {
    let default = parameter
        .default_value()
        .filter(|value| value.is_finite())
        .unwrap_or(match parameter.quantity.si {
            "m/s" => 70.0,
            "rad/s" => 280.0,
            "rad" if parameter.name == "launch.launch_angle" => 0.2,
            "m" => 0.3,
            "rad" => 0.05,
            "K" => 293.15,
            "Pa" => 1e5,
            _ => 0.1,
        });
    let size = match (default, parameter.quantity.si) {
        (0.0, "m") => 0.01,
        (0.0, "kg m^2") => 1e-5,
        (0.0, _) => 0.05,
        _ => default.abs(),
    };
    let value = default + size * spread * choices.between(-1.0, 1.0);
    let value = value.max(parameter.range.low).min(parameter.range.high);
    if parameter.name == "flight.step" {
        choices.between(0.01, 0.05)
    } else {
        value
    }
}

/// A value in SI as text, in the parameter's unit or in the SI unit.
pub fn with_unit(value: f64, parameter: &Parameter, choices: &mut Choices) -> String {
    let unit = if choices.is(0.7) {
        parameter.unit
    } else {
        parameter.quantity.si
    };
    let Some(size) = parameter.quantity.size_of(unit) else {
        return format!("{value:?}");
    };
    let space = if choices.is(0.3) { " " } else { "" };
    let text = format!("{:?}{space}{unit}", value / size)
        .trim_end()
        .to_owned();
    // a number in SI without a unit, if the parameter does not accept the text
    if parameter.quantity.read(&text).is_ok() {
        text
    } else {
        format!("{value:?}")
    }
}

/// A value of a parameter: mostly within its range.
pub fn value(parameter: &Parameter, choices: &mut Choices) -> String {
    let range = parameter.range;
    if choices.makes_mistake() {
        let bare = format!("{:?}", near(parameter, 0.2, choices));
        let beyond = if range.high.is_finite() {
            1.01 * range.high
        } else {
            -1e6
        };
        let beyond = with_unit(beyond, parameter, choices);
        let odd = choices.of(&ODD).to_owned();
        return choices.of(&[bare, beyond, odd.clone(), odd]);
    }
    match choices.below(40) {
        0 => with_unit(
            if range.high.is_finite() {
                range.high
            } else {
                1e6
            },
            parameter,
            choices,
        ),
        1 => with_unit(
            if range.low.is_finite() {
                range.low
            } else {
                -1e6
            },
            parameter,
            choices,
        ),
        2 | 3 => with_unit(near(parameter, 20.0, choices), parameter, choices),
        4 if parameter.kind == Kind::Optional => "none".into(),
        5 if parameter.name.contains("radius") => "inf".into(),
        _ => with_unit(near(parameter, 0.2, choices), parameter, choices),
    }
}

/// A setting for `--set`: NAME=VALUE.
pub fn setting(choices: &mut Choices) -> String {
    if choices.makes_mistake() {
        return choices
            .of(&[
                "club.loft",
                "=",
                "=1",
                "a=b=c",
                "aero.law=",
                "club.loft==1deg",
                "flight.method=euler",
                "aero.table=",
                "aero.table=none.csv",
                "aero.law=table",
            ])
            .into();
    }
    match choices.below(30) {
        0 => format!("aero.law={}", choices.of(Law::NAMES)),
        1 => format!("flight.method={}", choices.of(&["rk4", "dp8"])),
        _ => {
            let parameter = parameter(choices);
            format!(
                "{}={}",
                name_of(parameter, choices),
                value(parameter, choices)
            )
        }
    }
}

/// A range for `--vary`: NAME=LOW..HIGH around the parameter's default.
pub fn range(parameter: &Parameter, choices: &mut Choices) -> String {
    let middle = near(parameter, 0.05, choices);
    let reach = if middle == 0.0 {
        0.05
    } else {
        0.2 * middle.abs()
    };
    let low = with_unit(
        (middle - reach).max(parameter.range.low),
        parameter,
        choices,
    );
    let high = with_unit(
        (middle + reach).min(parameter.range.high),
        parameter,
        choices,
    );
    let name = name_of(parameter, choices);
    if choices.makes_mistake() {
        let odd = choices.of(&ODD);
        let reversed = format!("{name}={high}..{low}");
        let without = [
            format!("{name}={low}"),
            format!("{name}={low}.."),
            format!("{name}={odd}..{high}"),
            name,
        ];
        return if choices.is(0.3) {
            reversed
        } else {
            choices.of(&without)
        };
    }
    match choices.below(40) {
        0 => format!("{name}={low}..{low}"),
        _ => format!("{name}={low}..{high}"),
    }
}

/// Name of an outcome, or by mistake another text.
pub fn outcome(choices: &mut Choices) -> String {
    if choices.makes_mistake() {
        return choices.of(&["cary", "", "Carry", "club.loft"]).into();
    }
    match choices.below(40) {
        0 => "all".into(),
        _ if choices.is(0.4) => choices.of(&["carry", "lateral"]).into(),
        _ => choices.of(Outcome::OF_DRIVES).name().into(),
    }
}

/// The goal of an outcome: in a question over many swings, its mean.
pub fn statistic(outcome: &str, choices: &Choices) -> String {
    if choices.is_over_swings {
        format!("mean({outcome})")
    } else {
        outcome.into()
    }
}

/// Up to `count` names with commas between them.
pub fn list(count: usize, choices: &mut Choices, one: impl Fn(&mut Choices) -> String) -> String {
    (0..1 + choices.below(count))
        .map(|_| one(choices))
        .collect::<Vec<_>>()
        .join(",")
}

/// A constraint for `--subject-to`.
pub fn constraint(choices: &mut Choices) -> String {
    let outcome = choices.of(Outcome::OF_DRIVES);
    let usual = match outcome.unit() {
        "yd" => 200.0,
        "mph" => 150.0,
        "deg" => 15.0,
        "rpm" => 3000.0,
        "s" => 6.0,
        _ => 1.4,
    };
    let limit = |choices: &mut Choices| {
        let value = usual * choices.between(0.0, 1.5);
        let unit = choices.good_or_bad(&[outcome.unit()], &["kg", "", "yards"]);
        format!("{value:.2} {unit}").trim_end().to_owned()
    };
    let (name, first) = (statistic(outcome.name(), choices), limit(choices));
    match choices.below(12) {
        0 => format!("{name} == {first}"),
        1 => format!("{first} <= {name} <= {}", limit(choices)),
        2 => format!("{name} {first}"),
        3 => format!("{name} >= {}", choices.of(&ODD)),
        4 => choices
            .of(&[
                "",
                "<=",
                "carry",
                "carry <=",
                "carry <= lateral",
                "1 yd <= 2 yd",
                "carry < 1 yd < 2 yd",
            ])
            .into(),
        5..8 => format!("{name} <= {first}"),
        _ => format!("{name} >= {first}"),
    }
}

/// A standard uncertainty for `--sigma`.
pub fn sigma(choices: &mut Choices) -> String {
    let parameter = variable(choices);
    let name = name_of(parameter, choices);
    if choices.makes_mistake() {
        return format!("{name}={}", choices.of(&ODD));
    }
    match choices.below(4) {
        0 => format!("{name}={:.3}%", choices.between(0.0, 3.0)),
        _ => {
            let size = near(parameter, 0.1, choices).abs().max(1e-6);
            format!("{name}={}", with_unit(0.01 * size, parameter, choices))
        }
    }
}

/// A distribution for `--distribution`.
pub fn distribution(choices: &mut Choices) -> String {
    let parameter = variable(choices);
    let name = name_of(parameter, choices);
    let mut values: Vec<f64> = (0..3).map(|_| near(parameter, 0.05, choices)).collect();
    values.sort_by(f64::total_cmp);
    let [low, middle, high] = [0, 1, 2].map(|at| with_unit(values[at], parameter, choices));
    if choices.makes_mistake() {
        let odd = choices.of(&ODD);
        let bad = [
            format!("{name}={odd}"),
            format!("{name}=gauss({low},{high})"),
            format!("{name}=normal({low})"),
        ];
        return choices.of(&bad);
    }
    match choices.below(12) {
        0..3 => format!(
            "{name}=normal({middle},{})",
            with_unit(1e-3 + 0.01 * values[1].abs(), parameter, choices)
        ),
        3..8 => format!("{name}=uniform({low},{high})"),
        _ => format!("{name}=triangular({low},{middle},{high})"),
    }
}
