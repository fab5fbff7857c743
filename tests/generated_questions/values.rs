//! Names and values, correct and wrong.

use crate::chance::Chance;
use longdrive::parameters::{Kind, Law, PRESETS, Parameter};
use longdrive::{Outcome, Setup};

/// Texts that are no value, or an unusual one.
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

pub fn preset(chance: &mut Chance) -> &'static str {
    PRESETS[chance.below(PRESETS.len())].name
}

/// A parameter of a preset. By mistake, a parameter of any law or of a launch.
pub fn parameter(chance: &mut Chance) -> &'static Parameter {
    if chance.makes_mistake() {
        return chance.of(&Law::all_rows().collect::<Vec<_>>());
    }
    if chance.is_launched {
        let mut all = launched().parameters();
        all.retain(|row| {
            !row.is_of_strike() && row.name != "launch.spin" && row.name != "launch.spin_axis"
        });
        return chance.of(&all);
    }
    let all = Setup::preset(preset(chance)).unwrap().parameters();
    of_the_drive(&all, chance)
}

/// The default setup with a launch in place of the club.
fn launched() -> Setup<f64> {
    let mut setup = Setup::default();
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

/// A parameter that searches and derivatives accept.
pub fn variable(chance: &mut Chance) -> &'static Parameter {
    if chance.is_launched {
        let mut all = launched().variables();
        if chance.is(0.7) {
            all.retain(|row| row.is_of_launch());
        }
        return chance.of(&all);
    }
    let mut all = Setup::default().variables();
    if chance.is_over_swings {
        // only parameters of the club, because the swings state the others
        all.retain(|row| row.name.starts_with("club."));
        return of_the_drive(&all, chance);
    }
    if chance.is_of_flight {
        let of_the_club = ["swing.", "club.", "strike.", "impact."];
        all.retain(|row| !of_the_club.iter().any(|group| row.name.starts_with(group)));
        return of_the_drive(&all, chance);
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
    if chance.is(0.6) {
        Setup::default().variable(chance.of(&usual)).unwrap()
    } else {
        of_the_drive(&all, chance)
    }
}

/// One of `all`. Only by mistake a launch parameter, or the wind's speed or direction, which must
/// be given together.
fn of_the_drive(all: &[&'static Parameter], chance: &mut Chance) -> &'static Parameter {
    let struck: Vec<_> = all
        .iter()
        .copied()
        .filter(|row| {
            !row.name.starts_with("launch.") && !["wind.speed", "wind.from"].contains(&row.name)
        })
        .collect();
    if chance.makes_mistake() {
        chance.of(all)
    } else {
        chance.of(&struck)
    }
}

/// Name of a parameter; sometimes one that does not exist.
pub fn name_of(parameter: &Parameter, chance: &mut Chance) -> String {
    let name = parameter.name;
    if !chance.makes_mistake() {
        return name.into();
    }
    chance.of(&[
        name.replace('.', ""),
        format!("{name}x"),
        name.to_uppercase(),
        String::new(),
    ])
}

/// A value near the parameter's default, SI, at a relative distance of at most `spread`.
pub fn near(parameter: &Parameter, spread: f64, chance: &mut Chance) -> f64 {
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
    let value = default + size * spread * chance.between(-1.0, 1.0);
    let value = value.max(parameter.range.low).min(parameter.range.high);
    if parameter.name == "flight.step" {
        chance.between(0.01, 0.05)
    } else {
        value
    }
}

/// A value in SI as text, in the parameter's unit or in the SI unit.
pub fn with_unit(value: f64, parameter: &Parameter, chance: &mut Chance) -> String {
    let unit = if chance.is(0.7) {
        parameter.unit
    } else {
        parameter.quantity.si
    };
    let Some(size) = parameter.quantity.size_of(unit) else {
        return format!("{value:?}");
    };
    let space = if chance.is(0.3) { " " } else { "" };
    let text = format!("{:?}{space}{unit}", value / size)
        .trim_end()
        .to_owned();
    // if the parameter does not accept this text: a number in SI without a unit
    if parameter.quantity.read(&text).is_ok() {
        text
    } else {
        format!("{value:?}")
    }
}

/// A value of a parameter: mostly within its range.
pub fn value(parameter: &Parameter, chance: &mut Chance) -> String {
    let range = parameter.range;
    if chance.makes_mistake() {
        let bare = format!("{:?}", near(parameter, 0.2, chance));
        let beyond = if range.high.is_finite() {
            1.01 * range.high
        } else {
            -1e6
        };
        let beyond = with_unit(beyond, parameter, chance);
        let odd = chance.of(&ODD).to_owned();
        return chance.of(&[bare, beyond, odd.clone(), odd]);
    }
    match chance.below(40) {
        0 => with_unit(
            if range.high.is_finite() {
                range.high
            } else {
                1e6
            },
            parameter,
            chance,
        ),
        1 => with_unit(
            if range.low.is_finite() {
                range.low
            } else {
                -1e6
            },
            parameter,
            chance,
        ),
        2 | 3 => with_unit(near(parameter, 20.0, chance), parameter, chance),
        4 if parameter.kind == Kind::Optional => "none".into(),
        5 if parameter.name.contains("radius") => "inf".into(),
        _ => with_unit(near(parameter, 0.2, chance), parameter, chance),
    }
}

/// NAME=VALUE.
pub fn setting(chance: &mut Chance) -> String {
    if chance.makes_mistake() {
        return chance
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
    match chance.below(30) {
        0 => format!("aero.law={}", chance.of(Law::NAMES)),
        1 => format!("flight.method={}", chance.of(&["rk4", "dp8"])),
        _ => {
            let parameter = parameter(chance);
            format!(
                "{}={}",
                name_of(parameter, chance),
                value(parameter, chance)
            )
        }
    }
}

/// NAME=LOW..HIGH about a parameter's default.
pub fn range(parameter: &Parameter, chance: &mut Chance) -> String {
    let middle = near(parameter, 0.05, chance);
    let reach = if middle == 0.0 {
        0.05
    } else {
        0.2 * middle.abs()
    };
    let low = with_unit((middle - reach).max(parameter.range.low), parameter, chance);
    let high = with_unit(
        (middle + reach).min(parameter.range.high),
        parameter,
        chance,
    );
    let name = name_of(parameter, chance);
    if chance.makes_mistake() {
        let odd = chance.of(&ODD);
        let reversed = format!("{name}={high}..{low}");
        let without = [
            format!("{name}={low}"),
            format!("{name}={low}.."),
            format!("{name}={odd}..{high}"),
            name,
        ];
        return if chance.is(0.3) {
            reversed
        } else {
            chance.of(&without)
        };
    }
    match chance.below(40) {
        0 => format!("{name}={low}..{low}"),
        _ => format!("{name}={low}..{high}"),
    }
}

/// Name of an outcome; sometimes another text.
pub fn outcome(chance: &mut Chance) -> String {
    if chance.makes_mistake() {
        return chance.of(&["cary", "", "Carry", "club.loft"]).into();
    }
    match chance.below(40) {
        0 => "all".into(),
        _ if chance.is(0.4) => chance.of(&["carry", "lateral"]).into(),
        _ => chance.of(Outcome::ALL).name().into(),
    }
}

/// The goal of an outcome: its mean in a question over many swings.
pub fn statistic(outcome: &str, chance: &Chance) -> String {
    if chance.is_over_swings {
        format!("mean({outcome})")
    } else {
        outcome.into()
    }
}

/// Up to `count` names with commas between them.
pub fn list(count: usize, chance: &mut Chance, one: impl Fn(&mut Chance) -> String) -> String {
    (0..1 + chance.below(count))
        .map(|_| one(chance))
        .collect::<Vec<_>>()
        .join(",")
}

/// A constraint for `--subject-to`.
pub fn constraint(chance: &mut Chance) -> String {
    let outcome = chance.of(Outcome::ALL);
    let usual = match outcome.unit() {
        "yd" => 200.0,
        "mph" => 150.0,
        "deg" => 15.0,
        "rpm" => 3000.0,
        "s" => 6.0,
        _ => 1.4,
    };
    let limit = |chance: &mut Chance| {
        let value = usual * chance.between(0.0, 1.5);
        let unit = chance.of_or(&[outcome.unit()], &["kg", "", "yards"]);
        format!("{value:.2} {unit}").trim_end().to_owned()
    };
    let (name, first) = (statistic(outcome.name(), chance), limit(chance));
    match chance.below(12) {
        0 => format!("{name} == {first}"),
        1 => format!("{first} <= {name} <= {}", limit(chance)),
        2 => format!("{name} {first}"),
        3 => format!("{name} >= {}", chance.of(&ODD)),
        4 => chance
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
pub fn sigma(chance: &mut Chance) -> String {
    let parameter = variable(chance);
    let name = name_of(parameter, chance);
    if chance.makes_mistake() {
        return format!("{name}={}", chance.of(&ODD));
    }
    match chance.below(4) {
        0 => format!("{name}={:.3}%", chance.between(0.0, 3.0)),
        _ => {
            let size = near(parameter, 0.1, chance).abs().max(1e-6);
            format!("{name}={}", with_unit(0.01 * size, parameter, chance))
        }
    }
}

/// A distribution for `--distribution`.
pub fn distribution(chance: &mut Chance) -> String {
    let parameter = variable(chance);
    let name = name_of(parameter, chance);
    let mut values: Vec<f64> = (0..3).map(|_| near(parameter, 0.05, chance)).collect();
    values.sort_by(f64::total_cmp);
    let [low, middle, high] = [0, 1, 2].map(|at| with_unit(values[at], parameter, chance));
    if chance.makes_mistake() {
        let odd = chance.of(&ODD);
        let bad = [
            format!("{name}={odd}"),
            format!("{name}=gauss({low},{high})"),
            format!("{name}=normal({low})"),
        ];
        return chance.of(&bad);
    }
    match chance.below(12) {
        0..3 => format!(
            "{name}=normal({middle},{})",
            with_unit(1e-3 + 0.01 * values[1].abs(), parameter, chance)
        ),
        3..8 => format!("{name}=uniform({low},{high})"),
        _ => format!("{name}=triangular({low},{middle},{high})"),
    }
}
