use super::scale::{Grows, to_scale, with_margin};
use super::style::{clear_names, style};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Vector;
use crate::report::drive::total_uncertainty;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown;
use crate::statistics::extent;
use crate::study::{DriveRole, NamedDrive};
use crate::units::{Digits, Quantity, System, significant};

/// The view of a trajectory. The target is to the right of the picture; seen from above, right of
/// the target line is at the bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "commands", derive(clap::ValueEnum))]
pub enum View {
    /// From the side.
    Side,
    /// From above.
    Top,
}

/// Largest distance from the target line at which a path counts as straight in the view from above,
/// m: a tenth of a yard.
const STRAIGHT: f64 = 0.09144;

/// Minimum distance from the target line to each side of the view from above, m.
const CORRIDOR: f64 = 10.0;

/// Limits of the aspect ratio (height over width) at true scale.
const SHAPE: [f64; 2] = [0.3, 0.9];
/// Aspect ratio (height over width) of the stretched view.
const STRETCHED: f64 = 0.42;

/// Minimum ratio of the stretched height to the height at true scale. Below it there is no
/// stretched view.
const CLEARLY: f64 = 1.6;

/// Paths of drives from the side or from above at true scale. If heights (or lateral distances) are
/// small, a stretched view follows. Marks show apex and carry in the units of `system`.
///
/// # Errors
/// [`Error::Plot`] if no drive flies, and for a view from above if all drives are straight.
pub fn trajectory_figure(flown: &[NamedDrive], view: View, system: System) -> Result<Figure> {
    let path = |one: &NamedDrive| -> Vec<[f64; 2]> {
        let points = one.path.points.iter();
        points.map(|point| view.seen(point.position)).collect()
    };
    let paths: Vec<Vec<[f64; 2]>> = flown.iter().map(path).collect();
    let runs: Vec<Vec<[f64; 2]>> = flown.iter().map(|one| run(one, view)).collect();
    let all = || paths.iter().chain(&runs).flatten();
    let (x, y) = (extent(all().map(|at| at[0])), extent(all().map(|at| at[1])));
    if all().count() < 2 {
        return view.refuse("no drive flies, so there is no path to draw");
    }
    if view == View::Top && y[0].abs().max(y[1].abs()) < STRAIGHT {
        let within = Quantity::LENGTH.text(STRAIGHT, system.unit("yd"), Digits::Difference);
        return view.refuse(&format!(
            "seen from above these drives are straight: they stay within {within} of the target \
             line, so there is nothing to draw"
        ));
    }
    let x = with_margin(extent(x.into_iter().chain([0.0])), 0.0, 0.05);
    let seen_up = match view {
        View::Side => y,
        View::Top => extent(y.into_iter().chain([-CORRIDOR, CORRIDOR])),
    };
    let mut figure = without_layers(view, [x, seen_up], system);
    let lines = lines(flown, &paths, &runs);
    let range = figure.x.range.unwrap_or(x);
    match view {
        View::Side => add_ground(&mut figure, &paths, range),
        View::Top => figure.layers.push(Layer::new(
            "target line",
            Hue::Faint,
            Shape::dashed(range.map(|x| [x, 0.0]).to_vec()),
        )),
    }
    let below = if view == View::Side { 0.0 } else { 0.08 };
    let stretched = stretched(&figure, &lines, with_margin(seen_up, below, 0.08), view);
    figure.layers.extend(lines);
    for one in flown {
        figure.layers.extend(marks(one, view, system));
    }
    figure.note = match view {
        View::Side => "True scale: heights are drawn as large as distances.".into(),
        View::Top => "Seen from above with the target to the right. True scale: distances to the \
                      side are drawn as large as those downrange."
            .into(),
    };
    figure.note += &note_of_totals(flown, &runs, system);
    if let Some(panel) = stretched {
        figure.note += &format!(" Below: {}.", panel.title.to_lowercase());
        figure.panels.push(panel);
    }
    Ok(figure)
}

impl View {
    fn name(self) -> &'static str {
        match self {
            Self::Side => "trajectory-side",
            Self::Top => "trajectory-top",
        }
    }

    /// The coordinates of a position in this view: horizontal, then vertical.
    fn seen(self, at: Vector<f64>) -> [f64; 2] {
        match self {
            Self::Side => [at.z, at.x],
            Self::Top => [at.z, at.y],
        }
    }

    fn refuse(self, reason: &str) -> Result<Figure> {
        Err(Error::Plot {
            name: self.name().into(),
            reason: reason.into(),
        })
    }
}

/// The path of bounces and roll after the landing; empty without a roll-out.
fn run(one: &NamedDrive, view: View) -> Vec<[f64; 2]> {
    let Some(landing) = one.path.points.last() else {
        return vec![];
    };
    if one.path.run.is_empty() {
        return vec![];
    }
    let from = landing.position;
    let run = one.path.run.iter().map(|way| view.seen(from + *way));
    std::iter::once(view.seen(from)).chain(run).collect()
}

/// A figure at true scale without layers: its axes contain these ranges.
fn without_layers(view: View, [x, y]: [[f64; 2]; 2], system: System) -> Figure {
    let length = |label: &str| NamedQuantity::new(label, Quantity::LENGTH, "yd");
    let downrange = Axis::linear(length("downrange"));
    let (title, up) = match view {
        View::Side => ("Trajectory from the side", Axis::linear(length("height"))),
        View::Top => (
            "Trajectory from above",
            // the ball flies to the right, so right of the target line is at the bottom
            Axis {
                is_reversed: true,
                ..Axis::left_right()
            },
        ),
    };
    // margin for the labels at the apex and the landing
    let (y, grows) = match view {
        View::Side => (with_margin(y, 0.0, 0.3), Grows::Up),
        View::Top => (with_margin(y, 0.1, 0.1), Grows::Evenly),
    };
    let figure = Figure::new(system, view.name(), title, downrange, up);
    to_scale(figure, [x, y], SHAPE, [Grows::Up, grows])
}

/// A line for the path of each drive, then a line for the roll-out of each drive that has one.
fn lines(flown: &[NamedDrive], paths: &[Vec<[f64; 2]>], runs: &[Vec<[f64; 2]>]) -> Vec<Layer> {
    let line = |i: usize, points: &Vec<[f64; 2]>, is_run: bool| {
        let role = flown[i].role;
        let (hue, is_dashed) = style(role);
        let points = points.clone();
        // a single drive has no name: its flight and its run are two entries of the legend
        if role == DriveRole::Alone {
            let (name, is_dashed) = match is_run {
                false => ("flight", is_dashed),
                true => ("run", true),
            };
            return Layer::new(name, hue, Shape::Line { is_dashed, points });
        }
        let line = Layer::new(role.name(), hue, Shape::Line { is_dashed, points });
        if is_run { line.remarked("run") } else { line }
    };
    let flights = paths.iter().enumerate();
    let flights = flights.map(|(i, path)| line(i, path, false));
    let runs = runs.iter().enumerate().filter(|(_, run)| !run.is_empty());
    flights
        .chain(runs.map(|(i, run)| line(i, run, true)))
        .collect()
}

/// Adds the ground to a view from the side, at the height of the lowest landing.
fn add_ground(figure: &mut Figure, paths: &[Vec<[f64; 2]>], [left, right]: [f64; 2]) {
    let ground = extent(paths.iter().filter_map(|path| Some(path.last()?[1])))[0];
    let below = ground - 0.03 * (right - left);
    figure.y.range = figure.y.range.map(|[_, high]| [below, high]);
    if let Some([low, high]) = figure.y.range {
        figure.aspect = (high - low) / (right - left);
    }
    figure.layers.push(Layer::new(
        "",
        Hue::Faint,
        Shape::Region {
            is_hatched: true,
            rings: vec![vec![
                [left, below],
                [right, below],
                [right, ground],
                [left, ground],
            ]],
        },
    ));
    figure.layers.push(Layer::new(
        "ground",
        Hue::Faint,
        Shape::line(vec![[left, ground], [right, ground]]),
    ));
}

/// The sentence about the totals; empty without a roll-out. Totals have no marks, because their
/// labels would overlap the labels of the carry.
fn note_of_totals(flown: &[NamedDrive], runs: &[Vec<[f64; 2]>], system: System) -> String {
    let total = |(one, run): (&NamedDrive, &Vec<[f64; 2]>)| {
        if run.is_empty() {
            return None;
        }
        let total = shown::outcome(Outcome::Total, Outcome::Total.value(&one.drive)?, system);
        Some(if one.role == DriveRole::Alone {
            total
        } else {
            format!("{total} ({})", one.role.name())
        })
    };
    let totals: Vec<String> = flown.iter().zip(runs).filter_map(total).collect();
    if totals.is_empty() {
        return String::new();
    }
    format!(
        " After the landing the ball bounces and runs to its total, {}, which is known within {} at \
         best.",
        totals.join(" and "),
        total_uncertainty().in_units(system)
    )
}

/// Marks of the apex and the landing, labelled with their values.
fn marks(flown: &NamedDrive, view: View, system: System) -> Vec<Layer> {
    let (hue, _) = style(flown.role);
    let value = |of: Outcome| of.value(&flown.drive);
    let text = |of: Outcome, word: &str| {
        value(of).map(|found| format!("{word} {}", shown::outcome(of, found, system)))
    };
    let mut marks = vec![];
    let mut mark = |at: Option<[f64; 2]>, name: Option<String>| {
        if let (Some(at), Some(name)) = (at, name) {
            marks.push(Layer::new(name, hue, Shape::Mark(at)));
        }
    };
    let up = flown
        .path
        .points
        .last()
        .map_or(0.0, |point| point.position.x);
    match view {
        View::Side => {
            mark(
                value(Outcome::ApexDownrange)
                    .zip(value(Outcome::ApexHeight))
                    .map(<[f64; 2]>::from),
                text(Outcome::ApexHeight, "apex"),
            );
            mark(
                value(Outcome::Carry).map(|carry| [carry, up]),
                text(Outcome::Carry, "carry"),
            );
        }
        View::Top => {
            let at = value(Outcome::Carry)
                .zip(value(Outcome::Lateral))
                .map(<[f64; 2]>::from);
            let side =
                value(Outcome::Lateral).map(|side| shown::outcome(Outcome::Lateral, side, system));
            mark(
                at,
                text(Outcome::Carry, "carry")
                    .map(|carry| format!("{carry}, {}", side.unwrap_or_default())),
            );
        }
    }
    marks
}

/// A view of the paths with the vertical axis stretched; `None` if the stretch factor is at most
/// [`CLEARLY`].
fn stretched(figure: &Figure, lines: &[Layer], y: [f64; 2], view: View) -> Option<Figure> {
    let [left, right] = figure.x.range?;
    let [low, high] = y;
    let times = STRETCHED * (right - left) / (high - low);
    let what = if view == View::Side {
        "Heights"
    } else {
        "Distances to the side"
    };
    let title = format!(
        "{what} {} times as large as distances downrange",
        significant(times, 2)
    );
    let mut panel = Figure::new(
        figure.system,
        format!("{}-stretched", figure.name),
        title,
        figure.x.clone(),
        figure.y.clone().exactly(low, high),
    );
    panel.aspect = STRETCHED;
    panel.layers = lines.to_vec();
    clear_names(&mut panel.layers);
    (times > CLEARLY).then_some(panel)
}
