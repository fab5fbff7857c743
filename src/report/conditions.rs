//! The conditions of a drive as text: its air and its wind.

use super::shown;
use crate::atmosphere::AirState;
use crate::parameters::Setup;
use crate::units::{Digits, Message, Quantity, System, is_zero, leading_number};

/// Parameters with their values: "swing speed 115 mph, swing path 0 deg".
pub(super) fn parameters(setup: &Setup<f64>, names: &[&str], system: System) -> String {
    let one = |name: &&str| {
        let row = setup.variable(name).ok()?;
        Some(format!(
            "{} {}",
            shown::words(row.name),
            shown::with_digits(row, setup.value(row)?, system, shown::IN_SUMMARY)
        ))
    };
    names.iter().filter_map(one).collect::<Vec<_>>().join(", ")
}

/// The density of the air. The text says if the density is computed from the weather.
pub(super) fn air(setup: &Setup<f64>, system: System) -> String {
    let density = AirState::of(&setup.air).density;
    if density == 0.0 {
        return "none".into();
    }
    let source = if setup.air.has_weather() {
        ", from the weather"
    } else {
        ""
    };
    Message::from("density ")
        .quantity(Quantity::DENSITY, "kg/m^3", density, Digits::Significant(5))
        .words(source)
        .in_units(system)
}

/// The wind as text; `None` without wind. Omits a component that is 0, and a component that another
/// parameter replaces.
pub(super) fn wind(setup: &Setup<f64>, system: System) -> Option<String> {
    const WIND: [&str; 5] = [
        "wind.downrange",
        "wind.right",
        "wind.up",
        "wind.speed",
        "wind.from",
    ];
    let blows = |name: &str| {
        let value = |row| setup.value(row).is_some_and(|value| value != 0.0);
        let row = setup.parameter(name);
        row.is_ok_and(|row| setup.why_replaced(row).is_none() && value(row))
    };
    // name the direction if the speed is not 0: a direction of 0° is valid
    let is_given = |name: &&str| {
        blows(if *name == "wind.from" {
            "wind.speed"
        } else {
            name
        })
    };
    let names: Vec<&str> = WIND.into_iter().filter(is_given).collect();
    if names.is_empty() {
        return None;
    }
    let stated = parameters(setup, &names, system);
    let direction = setup.wind.speed.zip(setup.wind.from);
    let sides = direction.filter(|_| names.contains(&"wind.speed"));
    let sides = sides.map(|(speed, from)| {
        sides_of_wind(setup, [speed * from.cos(), speed * from.sin()], system)
    });
    match sides {
        Some(sides) if !sides.is_empty() => Some(format!("{stated}: {sides}")),
        _ => Some(stated),
    }
}

/// The wind as head or tail wind and side wind: "7.1 mph head wind, 7.1 mph from the left".
/// `components` are the speeds against the ball and from the right, m/s. A component that is
/// displayed as 0 is omitted.
fn sides_of_wind(setup: &Setup<f64>, components: [f64; 2], system: System) -> String {
    let names = [
        ["head wind", "tail wind"],
        ["from the right", "from the left"],
    ];
    let one = |(component, [positive, negative]): (f64, [&str; 2])| {
        let row = setup.parameter("wind.downrange").ok()?;
        let speed = shown::parameter(row, component.abs(), system);
        let name = if component > 0.0 { positive } else { negative };
        (!is_zero(leading_number(&speed))).then(|| format!("{speed} {name}"))
    };
    let sides: Vec<_> = components.into_iter().zip(names).filter_map(one).collect();
    sides.join(", ")
}
