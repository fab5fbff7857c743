use super::constants::subtitle;
use super::style::field;
use crate::parameters::{Preset, Setup};
use crate::report::plot::{Axis, Field, Figure, Hue, Layer, LineNames, NamedQuantity, Shape};
use crate::report::shown::{self, capital};
use crate::study::{Constraint, Map, NamedDrive, Optimum, Region, Slope, Vary};
use crate::units::System;

/// Length of the longest arrow, relative to the map's width.
const LONGEST_ARROW: f64 = 0.1;

/// The setup, constraints, optimum and region to show on a map of an outcome.
#[derive(Clone, Copy, Debug)]
pub struct OnMap<'a> {
    /// The drive as set up.
    pub setup: &'a Setup<f64>,
    /// The preset that the setup starts from. The subtitle names the differences.
    pub preset: &'a Preset,
    /// The constraints, each with the map of its outcome.
    pub limits: &'a [(Constraint, Map)],
    /// The optimum, if one was found.
    pub best: Option<&'a Optimum>,
    /// The region in which drives lose little and satisfy every bound and constraint.
    pub region: Option<&'a Region>,
}

/// A map of an outcome with its gradients, the drive as set up, and the optimum with the region of
/// little loss. Constraints are lines whose forbidden side is hatched. Texts are in the units of
/// `system`.
pub fn map_figure(map: &Map, on: &OnMap<'_>, system: System) -> Figure {
    let (across, up) = (&map.plane.across, &map.plane.up);
    let [x, y] = [across, up].map(|vary| {
        Axis::linear(NamedQuantity::parameter(vary.parameter)).exactly(vary.low, vary.high)
    });
    let title = format!(
        "{} over {} and {}",
        capital(&shown::words(map.of.name())),
        x.quantity.label,
        y.quantity.label
    );
    let name = format!("map-{}", map.of.name());
    let mut figure = Figure::new(system, name, title, x, y)
        .with(Layer::contours(field(&map.plane, 0, map.of)))
        .with(arrows(across, up, &map.slopes));
    figure.aspect = 0.85;
    figure.line_names = LineNames::OnLines;
    let best = on.best.filter(|best| best.value().is_some());
    figure.subtitle = constant_parameters(on, best, [across, up], system);
    for (i, (constraint, map)) in on.limits.iter().enumerate() {
        let limited = field(&map.plane, 0, map.of);
        let forbidden = forbidden(constraint, &limited, 2 + i, system);
        figure.layers.extend(forbidden);
    }
    if let Some(region) = on.region {
        let layers = region_layers(region, &at_most_lost(map, region, system));
        figure.layers.extend(layers);
    }
    figure.layers.extend(marks(map, on.setup, best));
    let note = note(map, on, &figure.layers, system);
    figure.noted(note)
}

/// The name of the region of little loss: "at most 1.00 yd lost".
fn at_most_lost(map: &Map, region: &Region, system: System) -> String {
    format!(
        "at most {} lost",
        shown::difference(map.of, region.loss, system)
    )
}

/// The drive as set up and the optimum, if the map contains them, with an arrow from the drive as
/// set up to the optimum.
fn marks(map: &Map, setup: &Setup<f64>, best: Option<&Optimum>) -> Vec<Layer> {
    let (across, up) = (&map.plane.across, &map.plane.up);
    let at =
        |setup: &Setup<f64>| Some([setup.value(across.parameter)?, setup.value(up.parameter)?]);
    let is_on = |[x, y]: &[f64; 2]| {
        (across.low..=across.high).contains(x) && (up.low..=up.high).contains(y)
    };
    let own = at(setup)
        .filter(is_on)
        .filter(|_| !is_elsewhere(map, setup, best));
    let top = best.and_then(|best| at(&best.setup)).filter(is_on);
    let arrow = own
        .zip(top)
        .map(|(own, top)| Layer::new("", Hue::SET_UP, Shape::Arrows(vec![[own, top]])));
    let mark = |name: &str, hue: Hue, at: Option<[f64; 2]>| {
        at.map(|at| Layer::new(name, hue, Shape::Mark(at)))
    };
    let marks = [
        mark(NamedDrive::AS_SET_UP, Hue::SET_UP, own),
        mark(NamedDrive::OPTIMUM, Hue::OPTIMUM, top),
    ];
    arrow
        .into_iter()
        .chain(marks.into_iter().flatten())
        .collect()
}

/// The sentences below the map; `layers` are the layers of the map.
fn note(map: &Map, on: &OnMap<'_>, layers: &[Layer], system: System) -> String {
    let has = |name: &str| layers.iter().any(|layer| layer.name == name);
    let mut notes = vec!["The edges of the map are the bounds.".to_owned()];
    let is_hatched = |layer: &Layer| {
        matches!(
            layer.shape,
            Shape::Region {
                is_hatched: true,
                ..
            }
        )
    };
    if layers.iter().any(is_hatched) {
        notes.push("Hatched: forbidden by a constraint.".into());
    }
    if let Some(region) = on.region {
        let name = at_most_lost(map, region, system);
        if region.equation.is_none() {
            let loss = shown::difference(map.of, region.loss, system);
            notes.push(format!(
                "Drives in the tinted region lose at most {loss} and meet every bound and \
                 constraint; each was flown."
            ));
        } else if has(&name) {
            notes.push(format!(
                "Drives on the line “{name}” meet every bound and constraint."
            ));
        }
    }
    notes.push(
        "Arrows: exact gradients, scaled by the ranges; their length grows with the square root of \
         the slope."
            .into(),
    );
    if let Some(why) = &map.missing {
        notes.push(format!(
            "Areas without colour have no value. The reason at the first of them: {}.",
            why.in_units(system)
        ));
    }
    let best = on.best.filter(|best| best.value().is_some());
    let unset: Vec<String> = [map.plane.across, map.plane.up]
        .into_iter()
        .filter(|vary| on.setup.value(vary.parameter).is_none())
        .map(|vary| shown::words(vary.parameter.name))
        .collect();
    if !unset.is_empty() {
        notes.push(format!(
            "The drive as set up is not on the map: it has no value of {}.",
            unset.join(" and ")
        ));
    } else if is_elsewhere(map, on.setup, best) {
        notes.push(
            "The drive as set up is not on the map: it has other values of the parameters that \
             are constant here."
                .into(),
        );
    } else if !has(NamedDrive::AS_SET_UP) {
        notes.push("The drive as set up lies outside of the map.".into());
    }
    notes.join(" ")
}

/// True if the setup and the optimum differ in a varied parameter that is not an axis. Then the
/// drive as set up is not on the map, because the map is drawn at the optimum.
fn is_elsewhere(map: &Map, setup: &Setup<f64>, best: Option<&Optimum>) -> bool {
    let axes = [map.plane.across.parameter, map.plane.up.parameter];
    best.is_some_and(|best| {
        let mut others = best
            .search
            .parameters()
            .filter(|other| !axes.contains(other));
        others.any(|other| best.setup.value(other) != setup.value(other))
    })
}

/// The subtitle of a map: the constant parameters as set up, and the optimal values of the varied
/// parameters that are not axes.
fn constant_parameters(
    on: &OnMap<'_>,
    best: Option<&Optimum>,
    axes: [&Vary; 2],
    system: System,
) -> String {
    let is_axis = |name: &str| axes.iter().any(|vary| vary.parameter.name == name);
    let varied = || {
        best.iter()
            .flat_map(|best| best.search.vary.iter().zip(&best.solution.x))
    };
    let is_varied = |name: &str| varied().any(|(vary, _)| vary.parameter.name == name);
    let varies = |name: &str| is_axis(name) || is_varied(name);
    let at_optimum: Vec<String> = varied()
        .filter(|(vary, _)| !is_axis(vary.parameter.name))
        .map(|(vary, x)| {
            format!(
                "{} {}",
                shown::words(vary.parameter.name),
                shown::parameter(vary.parameter, *x, system)
            )
        })
        .collect();
    let further =
        (!at_optimum.is_empty()).then(|| format!("{} of the optimum", at_optimum.join(", ")));
    subtitle(on.setup, on.preset, varies, further, system)
}

/// The line of a constraint, and its hatched forbidden side.
fn forbidden(constraint: &Constraint, field: &Field, hue: usize, system: System) -> Vec<Layer> {
    let words = shown::constraint(constraint, system);
    let mut layers = vec![];
    let hatched = |rings: Vec<Vec<[f64; 2]>>| {
        Layer::new(
            format!("forbidden: {words}"),
            Hue::Series(hue),
            Shape::Region {
                is_hatched: true,
                rings,
            },
        )
    };
    if !constraint.is_equation() {
        if constraint.low.is_finite() {
            layers.push(hatched(field.below(constraint.low)));
        }
        if constraint.high.is_finite() {
            layers.push(hatched(field.above(constraint.high)));
        }
        layers.retain(|layer| !layer.points().is_empty());
        // the legend omits hatched regions, because the name of a constraint is on its line
    }
    let mut ends: Vec<f64> = [constraint.low, constraint.high]
        .into_iter()
        .filter(|end| end.is_finite())
        .collect();
    ends.dedup();
    let lines = ends.into_iter().zip([words.as_str(), ""]);
    let lines = lines.map(|(end, name)| Layer::line(name, hue, field.line_at(end)));
    layers.extend(lines.filter(|line| !line.points().is_empty()));
    layers
}

/// The region of drives that lose little. An equality constraint restricts the region to a part of
/// the line on which the constraint holds.
fn region_layers(region: &Region, name: &str) -> Vec<Layer> {
    let of = |values: Vec<Option<f64>>| Field {
        quantity: NamedQuantity::plain("missed"),
        x: [region.across.low, region.across.high],
        y: [region.up.low, region.up.high],
        columns: region.columns,
        values,
        gradients: vec![],
        common_values: vec![],
    };
    let Some(equation) = &region.equation else {
        // drives that do not fly are outside of the region
        let beyond = region
            .excess
            .iter()
            .map(|excess| Some(excess.unwrap_or(1.0)))
            .collect();
        let rings = of(beyond).below(0.0);
        let region = Layer::new(
            name,
            Hue::OPTIMUM,
            Shape::Region {
                is_hatched: false,
                rings,
            },
        );
        return vec![region];
    };
    let excess = of(region.excess.clone());
    let is_in = |at: &[f64; 2]| excess.at(*at).is_some_and(|excess| excess <= 0.0);
    let line = of(equation.clone()).line_at(0.0).into_iter();
    let points: Vec<_> = line
        .map(|at| if is_in(&at) { at } else { [f64::NAN; 2] })
        .collect();
    if !points.iter().any(|[x, _]| x.is_finite()) {
        return vec![];
    }
    vec![Layer::new(name, Hue::OPTIMUM, Shape::line(points))]
}

/// Gradients as arrows. Each parameter is scaled by its range, so that an arrow has the direction
/// of steepest ascent on the page. The length of an arrow grows with the square root of the slope:
/// near the maximum, a length proportional to the slope would be too short.
fn arrows(across: &Vary, up: &Vary, slopes: &[Slope]) -> Layer {
    let width = [across, up].map(|vary| vary.high - vary.low);
    let scaled = |gradient: [f64; 2]| [gradient[0] * width[0], gradient[1] * width[1]];
    let size = |[x, y]: [f64; 2]| x.hypot(y);
    let longest = slopes
        .iter()
        .map(|slope| size(scaled(slope.gradient)))
        .fold(f64::MIN_POSITIVE, f64::max);
    let arrow = |slope: &Slope| {
        let scaled = scaled(slope.gradient);
        let steepness = size(scaled).max(f64::MIN_POSITIVE);
        let length = LONGEST_ARROW * (steepness / longest).sqrt();
        let [x, y] = scaled.map(|part| part / steepness * length);
        [
            slope.at,
            [slope.at[0] + x * width[0], slope.at[1] + y * width[1]],
        ]
    };
    Layer::new(
        "gradient",
        Hue::Faint,
        Shape::Arrows(slopes.iter().map(arrow).collect()),
    )
}
