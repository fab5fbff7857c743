use crate::aerodynamics::{AerodynamicLaw, Coefficients, Fitted, Stream};
use crate::atmosphere::AirState;
use crate::parameters::{Along, Law, Setup};
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::units::significant;
use std::f64::consts::PI;

/// What laws of drag and lift are drawn over; the other is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Over {
    /// Over the spin ratio, at this Reynolds number.
    SpinRatio(f64),
    /// Over the Reynolds number, at this spin ratio.
    Reynolds(f64),
}

/// The coefficient that is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coefficient {
    /// C_D.
    Drag,
    /// C_L.
    Lift,
}

/// Spin ratios and Reynolds numbers from a driver's launch to its landing, and about as much beside
/// them.
const SPIN_RATIOS: [f64; 2] = [0.0, 0.4];
const REYNOLDS: [f64; 2] = [4e4, 2.4e5];

/// Steps of a curve.
const STEPS: usize = 240;

/// Measured points are drawn whose Reynolds number or spin ratio is that of the picture within this
/// part of it.
const NEAR: f64 = 0.1;

/// A measured point; what a source does not tell apart is missing.
struct Measured {
    spin_ratio: Option<f64>,
    reynolds: Option<f64>,
    /// C_D and C_L.
    values: [Option<f64>; 2],
}

/// Laws of drag and lift as curves: solid within what each was fitted to, dashed beyond and where
/// that is not known, with measured points. Speeds and spins are those of the ball and the air of a
/// setup.
pub fn laws_figure(laws: &[Law<f64>], setup: &Setup<f64>, over: Over, of: Coefficient) -> Figure {
    let air = AirState::of(&setup.air);
    let radius = setup.ball.radius;
    let per_speed = air.density * 2.0 * radius / air.viscosity;
    let stream = |at: f64| {
        let (spin_ratio, reynolds) = match over {
            Over::SpinRatio(reynolds) => (at, reynolds),
            Over::Reynolds(spin_ratio) => (spin_ratio, at),
        };
        let speed = reynolds / per_speed;
        Stream::new(spin_ratio * speed / radius, speed, radius, per_speed)
    };
    let ([low, high], label, at) = match over {
        Over::SpinRatio(reynolds) => (
            SPIN_RATIOS,
            "spin ratio",
            format!("a Reynolds number of {}", significant(reynolds, 4)),
        ),
        Over::Reynolds(spin_ratio) => (
            REYNOLDS,
            "Reynolds number",
            format!("a spin ratio of {}", significant(spin_ratio, 4)),
        ),
    };
    let (symbol, words, which) = match of {
        Coefficient::Drag => ("C_D", "Drag", 0),
        Coefficient::Lift => ("C_L", "Lift", 1),
    };
    let name = format!(
        "laws-{}-{}",
        words.to_lowercase(),
        label.replace(' ', "-").to_lowercase()
    );
    let title = format!("{words} coefficient over the {label}, at {at}");
    let mut figure = Figure::new(
        name,
        title,
        Axis::linear(Measure::plain(label)),
        Axis::linear(Measure::plain(symbol)),
    );
    let (mut marks, mut has_points) = (vec![], false);
    for (i, law) in laws.iter().enumerate() {
        let fitted = law.fitted();
        let is_known = fitted.ranges().iter().any(|(.., range)| range.is_some());
        let curve = (0..=STEPS).map(|k| {
            let at = low + (high - low) * k as f64 / STEPS as f64;
            let stream = stream(at);
            let Coefficients { drag, lift } = law.coefficients(stream);
            let is_in = is_known
                && fitted.holds([
                    stream.spin_ratio(),
                    stream.spin,
                    stream.reynolds(),
                    stream.speed,
                ]);
            ([at, [drag, lift][which]], is_in)
        });
        let curve: Vec<([f64; 2], bool)> = curve.collect();
        let (first, last) = (stream(low), stream(high));
        let reached = [
            [first.spin_ratio(), last.spin_ratio()],
            [first.spin, last.spin],
            [first.reynolds(), last.reynolds()],
            [first.speed, last.speed],
        ];
        let (within, beyond) = (pieces(&curve, true), pieces(&curve, false));
        let curve = if within.is_empty() { &beyond } else { &within };
        // at another place of each curve, so that the words do not stand in each other's way
        let drawn: Vec<_> = curve.iter().filter(|at| at[1].is_finite()).collect();
        let at = drawn.get(drawn.len() * (2 * i + 1) / (2 * laws.len()));
        marks.extend(at.map(|at| Layer::Mark {
            name: law.name().into(),
            hue: Hue::Series(i),
            at: **at,
        }));
        // a law that is dashed alone has its own name
        let suffix = if within.is_empty() {
            String::new()
        } else {
            format!(" ({})", fitted.beyond(fitted.left(reached)))
        };
        let layers = [
            Layer::line(law.name(), i, within),
            Layer::dashed(format!("{}{suffix}", law.name()), i, beyond),
        ];
        figure.layers.extend(
            layers
                .into_iter()
                .filter(|layer| !matches!(layer, Layer::Line { points, .. } if points.is_empty())),
        );
        let points: Vec<[f64; 2]> = measured(law, &fitted, per_speed, radius)
            .into_iter()
            .filter_map(|point| {
                let (x, other, held) = match over {
                    Over::SpinRatio(held) => (point.spin_ratio?, point.reynolds, held),
                    Over::Reynolds(held) => (point.reynolds?, point.spin_ratio, held),
                };
                let is_near = other.is_none_or(|other| (other - held).abs() <= NEAR * held);
                let value = point.values[which]?;
                (is_near && (low..=high).contains(&x)).then_some([x, value])
            })
            .collect();
        if !points.is_empty() {
            has_points = true;
            figure
                .layers
                .push(Layer::dots(format!("{} (measured)", law.name()), i, points));
        }
    }
    // where colours begin again, names stand beside the curves too
    if laws.len() > Hue::SERIES {
        figure.layers.extend(marks);
    }
    let mut note =
        "Solid within what a law was fitted to, dashed beyond it and where that is not known."
            .to_owned();
    if has_points {
        note += &format!(
            " Points are measured values, within {:.0} % of {at}.",
            100.0 * NEAR
        );
    }
    note += " Speeds and spins, for laws that depend on them, are those of the setup's ball in its \
             air.";
    figure.noted(note)
}

/// The parts of a curve that lie within the law's range or beyond it, with a break between two of
/// them. Where the range ends they meet.
fn pieces(curve: &[([f64; 2], bool)], within: bool) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = vec![];
    for (k, (at, is_in)) in curve.iter().enumerate() {
        // a part beyond goes on to the first point within
        let is_next_to = |k: Option<usize>| {
            k.and_then(|k| curve.get(k))
                .is_some_and(|(_, is_in)| !is_in)
        };
        if *is_in == within
            || (!within && (is_next_to(k.checked_sub(1)) || is_next_to(Some(k + 1))))
        {
            points.push(*at);
        } else if points.last().is_some_and(|last| last[1].is_finite()) {
            points.push([at[0], f64::NAN]);
        }
    }
    while points.last().is_some_and(|last| !last[1].is_finite()) {
        points.pop();
    }
    points
}

/// The points that a law was made from, where they are known.
fn measured(law: &Law<f64>, fitted: &Fitted, per_speed: f64, radius: f64) -> Vec<Measured> {
    let of_speed = |speed: f64, spin: f64, values: [f64; 2]| Measured {
        spin_ratio: Some(spin * radius / speed),
        reynolds: Some(per_speed * speed),
        values: values.map(Some),
    };
    match law {
        Law::BearmanHarvey(_) => rows(include_str!("../../../tests/data/bearman_harvey_1976.csv"))
            .filter(|[speed, ..]| fitted.speed.is_none_or(|[_, most]| *speed <= most))
            .map(|[speed, rpm, drag, lift]| of_speed(speed, rpm * PI / 30.0, [drag, lift]))
            .collect(),
        Law::NaruoMizota(_) => rows(include_str!("../../../tests/data/naruo_2004.csv"))
            .map(|[s, drag, lift, _]| Measured {
                spin_ratio: Some(s),
                reynolds: None,
                values: [Some(drag), Some(lift)],
            })
            .collect(),
        // lift over the spin ratio, as a mean of balls, and drag over the Reynolds number, of one
        // of them, whatever the other
        Law::Lyu(_) => cells(include_str!("../../../tests/data/lyu_2018.csv"))
            .map(|[reynolds, spin_ratio, drag, lift]| Measured {
                spin_ratio,
                reynolds,
                values: [drag, lift],
            })
            .collect(),
        Law::UsgaItr(_) => rows(include_str!("../../../tests/data/usga_itr_test_ball.csv"))
            .map(|[re, s, drag, lift]| Measured {
                spin_ratio: Some(s),
                reynolds: Some(re),
                values: [Some(drag), Some(lift)],
            })
            .collect(),
        Law::Table(law) => {
            let has = |along: Along| law.table.axes().any(|axis| axis.along == along);
            let node = |[speed, spin, drag, lift]: &[f64; 4]| {
                let reynolds = if has(Along::Reynolds) {
                    Some(*speed)
                } else {
                    has(Along::Speed).then_some(per_speed * speed)
                };
                // a spin alone is a spin ratio at a known speed only
                let at_speed = reynolds.map(|reynolds| reynolds / per_speed);
                let by_spin = at_speed
                    .filter(|_| has(Along::Spin))
                    .map(|speed| spin * radius / speed);
                let spin_ratio = if has(Along::SpinRatio) {
                    Some(*spin)
                } else {
                    by_spin
                };
                Measured {
                    spin_ratio,
                    reynolds,
                    values: [Some(*drag), Some(*lift)],
                }
            };
            law.table.nodes().iter().map(node).collect()
        }
        Law::Robinson(_)
        | Law::Linear(_)
        | Law::SmitsSmith(_)
        | Law::Ferguson(_)
        | Law::LaunchMonitor(_)
        | Law::WinfieldTan(_)
        | Law::MacdonaldHanzely(_)
        | Law::Nathan(_) => vec![],
    }
}

/// The rows of a table of numbers below its head, cells beyond the fourth left out.
fn rows(table: &str) -> impl Iterator<Item = [f64; 4]> + '_ {
    cells(table).filter_map(|[a, b, c, d]| Some([a?, b?, c?, d?]))
}

/// The same with empty cells.
fn cells(table: &str) -> impl Iterator<Item = [Option<f64>; 4]> + '_ {
    table.lines().skip(1).map(|line| {
        let mut cells = line.split(',').map(|cell| cell.trim().parse::<f64>().ok());
        std::array::from_fn(|_| cells.next().flatten())
    })
}
