use super::scale::{Grows, extent, to_scale, with_margin};
use super::style::style;
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::flight::{Trajectory, trajectory};
use crate::parameters::Setup;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::report::shown;
use crate::units::{Quantity, System, significant};

/// From where a trajectory is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// Downrange and up.
    Side,
    /// Downrange to the right of the picture, as one sees it who looks down with the target to the
    /// right: what is right of the target line is below it.
    Top,
}

/// A drive with its path and a name.
#[derive(Clone, Debug)]
pub struct Flown {
    /// What it is called: "as set up", "optimum".
    pub name: String,
    /// The drive.
    pub drive: Drive<f64>,
    /// Its path.
    pub path: Trajectory,
}

impl Flown {
    /// What the drive at an optimum is called.
    pub const OPTIMUM: &str = "optimum";

    /// Flies a setup and keeps the path.
    ///
    /// # Errors
    /// As [`Drive::new`].
    pub fn new(name: impl Into<String>, setup: &Setup<f64>) -> Result<Self> {
        let drive = Drive::new(setup)?;
        let path = trajectory(setup, &drive.launch)?;
        Ok(Self {
            name: name.into(),
            drive,
            path,
        })
    }
}

/// A path that stays so near to the target line has nothing to see from above, m: a tenth of a
/// yard.
const STRAIGHT: f64 = 0.09144;

/// How well a total is known at best, m: ten yards.
const TOTAL_WITHIN: f64 = 9.144;

/// What the view from above shows at least to each side, m.
const CORRIDOR: f64 = 10.0;

/// The shape of the view to scale, and of the stretched one, height over width.
const SHAPE: [f64; 2] = [0.3, 0.9];
const STRETCHED: f64 = 0.42;

/// Where the view to scale shows the height at least so much smaller than the stretched one, that
/// one is drawn too.
const CLEARLY: f64 = 1.6;

/// Paths of drives, from the side or from above: at true scale, and below it stretched where
/// heights (or distances to the side) are small. Apex and carry stand at their points, in the units
/// of `system`.
///
/// # Errors
/// [`Error::Plot`] where nothing flies, and for a view from above of drives that are straight.
pub fn trajectory_figure(flown: &[Flown], view: View, system: System) -> Result<Figure> {
    let name = match view {
        View::Side => "trajectory-side",
        View::Top => "trajectory-top",
    };
    let refuse = |reason: &str| {
        Err(Error::Plot {
            name: name.into(),
            reason: reason.into(),
        })
    };
    let seen = |at: crate::number::Vector<f64>| match view {
        View::Side => [at.z, at.x],
        View::Top => [at.z, at.y],
    };
    let paths: Vec<Vec<[f64; 2]>> = flown
        .iter()
        .map(|one| {
            one.path
                .points
                .iter()
                .map(|point| seen(point.position))
                .collect()
        })
        .collect();
    // bounces and run go on from the landing
    let runs = flown.iter().zip(&paths).map(|(one, path)| {
        let from = one.path.points.last().map(|landing| landing.position);
        let run = one
            .path
            .run
            .iter()
            .filter_map(|way| Some(seen(from? + *way)));
        let landing = path.last().copied().into_iter();
        if one.path.run.is_empty() {
            vec![]
        } else {
            landing.chain(run).collect()
        }
    });
    let runs: Vec<Vec<[f64; 2]>> = runs.collect();
    let all = || paths.iter().chain(&runs).flatten();
    let (x, y) = (extent(all().map(|at| at[0])), extent(all().map(|at| at[1])));
    if all().count() < 2 {
        return refuse("no drive flies, so that there is no path to draw");
    }
    if view == View::Top && y[0].abs().max(y[1].abs()) < STRAIGHT {
        let within = Quantity::LENGTH.read_off_difference(STRAIGHT, system.unit("yd"));
        return refuse(&format!(
            "seen from above these drives are straight: they stay within {within} of the target \
             line, so that there is nothing to draw"
        ));
    }
    let length = |label: &str| Measure::new(label, Quantity::LENGTH, "yd");
    let downrange = Axis::linear(length("downrange"));
    let (title, up) = match view {
        View::Side => ("Trajectory from the side", Axis::linear(length("height"))),
        View::Top => (
            "Trajectory from above",
            Axis::left_right(length("right of the target line")),
        ),
    };
    let grows = if view == View::Side {
        Grows::Up
    } else {
        Grows::Evenly
    };
    let (seen_up, down) = if view == View::Side {
        (y, 0.0)
    } else {
        (extent(y.into_iter().chain([-CORRIDOR, CORRIDOR])), 1.0)
    };
    // room for the words at the apex and the landing
    let y = if view == View::Side {
        with_margin(y, 0.0, 0.3)
    } else {
        with_margin(seen_up, 0.1, 0.1)
    };
    let x = with_margin(extent(x.into_iter().chain([0.0])), 0.0, 0.05);
    let mut figure = to_scale(
        Figure::new(name, title, downrange, up),
        [x, y],
        SHAPE,
        [Grows::Up, grows],
    );
    let mut lines = vec![];
    for (i, (Flown { name, .. }, points)) in flown.iter().zip(&paths).enumerate() {
        let (hue, is_dashed) = style(name, i);
        lines.push(Layer::Line {
            name: name.clone(),
            hue,
            is_dashed,
            points: points.clone(),
        });
    }
    for (i, (Flown { name, .. }, points)) in flown
        .iter()
        .zip(&runs)
        .enumerate()
        .filter(|(_, (_, run))| !run.is_empty())
    {
        let (hue, is_dashed) = style(name, i);
        let name = if name.is_empty() {
            "run".into()
        } else {
            format!("run ({name})")
        };
        lines.push(Layer::Line {
            name,
            hue,
            is_dashed,
            points: points.clone(),
        });
    }
    let [left, right] = figure.x.reach.unwrap_or(x);
    match view {
        View::Side => {
            // the ground is where the paths end
            let ground = extent(paths.iter().filter_map(|path| Some(path.last()?[1])))[0];
            let below = ground - 0.03 * (right - left);
            figure.y.reach = figure.y.reach.map(|[_, high]| [below, high]);
            figure.aspect = figure
                .y
                .reach
                .map_or(figure.aspect, |[low, high]| (high - low) / (right - left));
            let rings = vec![vec![
                [left, below],
                [right, below],
                [right, ground],
                [left, ground],
            ]];
            figure.layers.push(Layer::Region {
                name: String::new(),
                hue: Hue::Faint,
                is_hatched: true,
                rings,
            });
            let points = vec![[left, ground], [right, ground]];
            figure.layers.push(Layer::Line {
                name: "ground".into(),
                hue: Hue::Faint,
                is_dashed: false,
                points,
            });
        }
        View::Top => {
            let points = vec![[left, 0.0], [right, 0.0]];
            let name = "target line".into();
            figure.layers.push(Layer::Line {
                name,
                hue: Hue::Faint,
                is_dashed: true,
                points,
            });
        }
    }
    let stretched = stretched(
        &figure,
        &lines,
        with_margin(seen_up, 0.08 * down, 0.08),
        view,
    );
    figure.layers.extend(lines);
    for (i, one) in flown.iter().enumerate() {
        figure.layers.extend(marks(one, i, view, system));
    }
    let note = match view {
        View::Side => "True scale: heights are drawn as large as distances.",
        View::Top => {
            "Seen from above with the target to the right. True scale: distances to the side are \
             drawn as large as those downrange."
        }
    };
    figure.note = note.into();
    // not at the points: they lie beside those of the carry, whose words would be in the way
    let totals = flown
        .iter()
        .zip(&runs)
        .filter(|(_, run)| !run.is_empty())
        .filter_map(|(one, _)| {
            let total = shown::outcome(Outcome::Total, Outcome::Total.value(&one.drive)?, system);
            Some(if one.name.is_empty() {
                total
            } else {
                format!("{total} ({})", one.name)
            })
        });
    let totals = totals.collect::<Vec<_>>().join(" and ");
    if !totals.is_empty() {
        let within = Quantity::LENGTH.read_off_difference(TOTAL_WITHIN, system.unit("yd"));
        figure.note += &format!(
            " Behind the carry the ball bounces and runs to its total, {totals}, which is known \
             within {within} at best."
        );
    }
    if let Some(panel) = stretched {
        figure.note += &format!(" Below: {}.", panel.title.to_lowercase());
        figure.panels.push(panel);
    }
    Ok(figure)
}

/// The marks of a drive, with their values.
fn marks(flown: &Flown, i: usize, view: View, system: System) -> Vec<Layer> {
    let (hue, _) = style(&flown.name, i);
    let value = |of: Outcome| of.value(&flown.drive);
    let told = |of: Outcome, word: &str| {
        value(of).map(|found| format!("{word} {}", shown::outcome(of, found, system)))
    };
    let mut marks = vec![];
    let mut mark = |at: Option<[f64; 2]>, name: Option<String>| {
        if let (Some(at), Some(name)) = (at, name) {
            marks.push(Layer::Mark { name, hue, at });
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
                told(Outcome::ApexHeight, "apex"),
            );
            mark(
                value(Outcome::Carry).map(|carry| [carry, up]),
                told(Outcome::Carry, "carry"),
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
                told(Outcome::Carry, "carry")
                    .map(|carry| format!("{carry}, {}", side.unwrap_or_default())),
            );
        }
    }
    marks
}

/// The same paths with what is small drawn large; `None` where that would not be clearly larger.
fn stretched(figure: &Figure, lines: &[Layer], y: [f64; 2], view: View) -> Option<Figure> {
    let [left, right] = figure.x.reach?;
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
        format!("{}-stretched", figure.name),
        title,
        figure.x.clone(),
        figure.y.clone().exactly(low, high),
    );
    panel.aspect = STRETCHED;
    // the legend of the view above tells them apart
    let unnamed = |layer: &Layer| match layer.clone() {
        Layer::Line {
            hue,
            is_dashed,
            points,
            ..
        } => Layer::Line {
            name: String::new(),
            hue,
            is_dashed,
            points,
        },
        layer => layer,
    };
    panel.layers = lines.iter().map(unnamed).collect();
    (times > CLEARLY).then_some(panel)
}
