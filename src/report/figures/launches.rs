use super::style::field;
use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::report::shown;
use crate::study::Launches;
use crate::units::System;

/// A map of carry over launch angle and backspin at a constant ball speed, as in club fitting, with
/// the launches of the drives and the best launch for each spin.
pub fn launches_figure(map: &Launches, system: System) -> Figure {
    let of = |parameter: &Parameter, label: &str| Measure {
        label: label.into(),
        ..Measure::parameter(parameter)
    };
    let axis = |vary: &crate::study::Vary, label: &str| {
        Axis::linear(of(vary.parameter, label)).exactly(vary.low, vary.high)
    };
    let (x, y) = (
        axis(&map.plane.across, "launch angle"),
        axis(&map.plane.up, "backspin"),
    );
    let mut figure = Figure::new("launches", "Carry over launch angle and backspin", x, y).with(
        Layer::Contours(field(&map.plane, 0, Measure::outcome(Outcome::Carry))),
    );
    figure.aspect = 0.85;
    figure.names_on_lines = true;
    figure.subtitle = format!(
        "at a ball speed of {}",
        shown::outcome(Outcome::BallSpeed, map.ball_speed, system)
    );
    if map.ridge.len() > 1 {
        let name = "best launch".into();
        figure.layers.push(Layer::Line {
            name,
            hue: Hue::Ink,
            is_dashed: true,
            points: map.ridge.clone(),
        });
    }
    let places: Vec<_> = map
        .launched
        .iter()
        .map(|one| [one.launch_angle, one.backspin])
        .collect();
    if let [first, second, ..] = places[..] {
        figure.layers.push(Layer::Arrows {
            name: String::new(),
            hue: Hue::Ink,
            arrows: vec![[first, second]],
        });
    }
    let mut notes = vec!["Dashed: the best launch angle for each backspin.".to_owned()];
    for (i, (one, at)) in map.launched.iter().zip(places).enumerate() {
        let (hue, _) = super::style::style(&one.name, i);
        figure.layers.push(Layer::Mark {
            name: one.name.clone(),
            hue,
            at,
        });
        let told = |of: Outcome, value: f64| shown::outcome(of, value, system);
        let carry = one.carry.map_or("no flight".into(), |carry| {
            format!("carry {}", told(Outcome::Carry, carry))
        });
        let speed = if i == 0 {
            String::new()
        } else {
            format!(
                ", its own ball speed {}",
                told(Outcome::BallSpeed, one.ball_speed)
            )
        };
        notes.push(format!(
            "{}: launch {}, backspin {}, {carry}{speed}.",
            super::capital(if one.name.is_empty() {
                "this drive"
            } else {
                &one.name
            }),
            told(Outcome::LaunchAngle, one.launch_angle),
            told(Outcome::Backspin, one.backspin),
        ));
    }
    notes.push(
        "The map has the ball speed, launch direction and sidespin of the first launch; air and \
         ball are the setup's."
            .into(),
    );
    if map.plane.values[0].iter().any(Option::is_none) {
        notes.push("Without colour: no flight.".into());
    }
    figure.noted(notes.join(" "))
}
