use super::style::{field, style};
use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Hue, Layer, LineNames, NamedQuantity, Shape};
use crate::report::shown::{self, capital};
use crate::study::{DriveRole, Launches, NamedLaunch, Vary};
use crate::units::System;

/// A map of the carry as a function of launch angle and backspin at a constant ball speed, as in
/// club fitting. It shows the launches of the drives, and the best launch angle for each backspin.
pub fn launches_figure(map: &Launches, system: System) -> Figure {
    let axis = |vary: &Vary, label: &str| {
        let quantity = NamedQuantity {
            label: label.into(),
            ..NamedQuantity::parameter(vary.parameter)
        };
        Axis::linear(quantity).exactly(vary.low, vary.high)
    };
    let (x, y) = (
        axis(&map.plane.across, "launch angle"),
        axis(&map.plane.up, "backspin"),
    );
    let mut figure = Figure::new(
        system,
        "launches",
        "Carry over launch angle and backspin",
        x,
        y,
    )
    .with(Layer::contours(field(&map.plane, 0, Outcome::Carry)));
    figure.aspect = 0.85;
    figure.line_names = LineNames::OnLines;
    figure.subtitle = format!(
        "at a ball speed of {}",
        shown::outcome(Outcome::BallSpeed, map.ball_speed, system)
    );
    figure.layers.extend(layers(map));
    figure.noted(note(map, system))
}

/// The best launch for each spin, and the launches of the drives.
fn layers(map: &Launches) -> Vec<Layer> {
    let ridge = (map.ridge.len() > 1)
        .then(|| Layer::new("best launch", Hue::Ink, Shape::dashed(map.ridge.clone())));
    let place = |one: &NamedLaunch| [one.launch_angle, one.backspin];
    let arrow = match &map.launched[..] {
        [first, second, ..] => Some(Layer::new(
            "",
            Hue::Ink,
            Shape::Arrows(vec![[place(first), place(second)]]),
        )),
        _ => None,
    };
    let marks = map.launched.iter().map(|one| {
        let (hue, _) = style(one.role);
        Layer::new(one.role.name(), hue, Shape::Mark(place(one)))
    });
    ridge.into_iter().chain(arrow).chain(marks).collect()
}

fn note(map: &Launches, system: System) -> String {
    let mut notes = vec![];
    if map.ridge.len() > 1 {
        notes.push(
            "Dashed: the best launch angle for each backspin, where it is on the map.".to_owned(),
        );
    }
    notes.extend(map.launched.iter().map(|one| note_of(one, map, system)));
    let first = match map.launched.first() {
        Some(one) if one.role == DriveRole::Optimum => "optimum",
        _ => "drive as set up",
    };
    notes.push(format!(
        "The map has the ball speed, launch direction and sidespin of the {first}; air and ball \
         are the setup's."
    ));
    if map.plane.values[0].iter().any(Option::is_none) {
        notes.push("Without colour: no flight.".into());
    }
    notes.join(" ")
}

/// The launch and the carry of a drive. The ball speed is added if it differs from the ball speed
/// of the map.
fn note_of(one: &NamedLaunch, map: &Launches, system: System) -> String {
    let text = |of: Outcome, value: f64| shown::outcome(of, value, system);
    let carry = one.carry.map_or("no flight".into(), |carry| {
        format!("carry {}", text(Outcome::Carry, carry))
    });
    let [speed, of_map] =
        [one.ball_speed, map.ball_speed].map(|speed| text(Outcome::BallSpeed, speed));
    let speed = if speed == of_map {
        String::new()
    } else {
        format!(", its own ball speed {speed}")
    };
    let name = match one.role {
        DriveRole::Alone => "this drive",
        role => role.name(),
    };
    format!(
        "{}: launch {}, backspin {}, {carry}{speed}.",
        capital(name),
        text(Outcome::LaunchAngle, one.launch_angle),
        text(Outcome::Backspin, one.backspin),
    )
}
