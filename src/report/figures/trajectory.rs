use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::flight::{Trajectory, trajectory};
use crate::parameters::Setup;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::units::Quantity;

/// From where a trajectory is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// Downrange and up.
    Side,
    /// Downrange to the right of the picture, as one sees it who looks down with the target to the right: what is right of the target
    /// line is below it.
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

    /// Its colour: that of its meaning, also where it is alone in a picture.
    pub fn hue(&self) -> Hue {
        if self.name == Self::OPTIMUM { Hue::OPTIMUM } else { Hue::SET_UP }
    }

    /// Flies a setup and keeps the path.
    ///
    /// # Errors
    /// As [`Drive::new`].
    pub fn new(name: impl Into<String>, setup: &Setup<f64>) -> Result<Self> {
        let drive = Drive::new(setup)?;
        let path = trajectory(setup, &drive.launch)?;
        Ok(Self { name: name.into(), drive, path })
    }
}

/// The least width of the view from above, m: a straight drive is a line, not an axis full of rounding.
const CORRIDOR: f64 = 10.0;

/// Paths of drives, from the side or from above.
pub fn trajectory_figure(flown: &[Flown], view: View) -> Figure {
    let length = |label: &str| Measure::new(label, Quantity::LENGTH, "yd");
    let downrange = Axis::linear(length("downrange"));
    let mut figure = match view {
        View::Side => {
            Figure::new("trajectory-side", "Trajectory from the side", downrange, Axis::linear(length("height")))
        }
        View::Top => Figure::new(
            "trajectory-top",
            "Trajectory from above",
            downrange,
            Axis::left_right(length("right of the target line")).reaching(-CORRIDOR, CORRIDOR),
        ),
    };
    figure.aspect = if view == View::Side { 0.55 } else { 0.4 };
    for one in flown {
        let Flown { name, drive, path } = one;
        let seen = |up: f64, right: f64, downrange: f64| match view {
            View::Side => [downrange, up],
            View::Top => [downrange, right],
        };
        let points =
            path.points.iter().map(|point| seen(point.position.x, point.position.y, point.position.z)).collect();
        let hue = one.hue();
        figure.layers.push(Layer::Line { name: name.clone(), hue, is_dashed: hue == Hue::OPTIMUM, points });
        let [Some(carry), Some(right)] = [Outcome::Carry, Outcome::Lateral].map(|outcome| outcome.value(drive)) else {
            continue;
        };
        let up = path.points.last().map_or(0.0, |point| point.position.x);
        // the ends of several lie close together, and the legend tells them apart
        let landing = if flown.len() == 1 { "landing" } else { "" };
        figure.layers.push(Layer::Mark { name: landing.into(), hue, at: seen(up, right, carry) });
        let apex = [Outcome::ApexHeight, Outcome::ApexDownrange].map(|outcome| outcome.value(drive));
        if let (View::Side, [Some(height), Some(downrange)]) = (view, apex) {
            figure.layers.push(Layer::Mark { name: "apex".into(), hue, at: [downrange, height] });
        }
    }
    let note = match view {
        View::Side => scales(&figure, "Heights", "distances"),
        View::Top => format!(
            "Seen from above with the target to the right. {}",
            scales(&figure, "Distances to the left and right", "those downrange")
        ),
    };
    figure.noted(note)
}

/// Which of two lengths is drawn larger, for what runs up the picture and what runs across it.
fn scales(figure: &Figure, up: &str, across: &str) -> String {
    /// Axes reach on to the next round number: nearer to 1 than this the ratio is not known here.
    const CLEARLY: f64 = 1.6;
    let lines = figure.layers.iter().filter_map(|layer| match layer {
        Layer::Line { points, .. } => Some(points),
        _ => None,
    });
    let points: Vec<[f64; 2]> = lines.flatten().copied().collect();
    let extent = |axis: usize, reach: Option<[f64; 2]>| {
        let values = points.iter().map(|point| point[axis]).chain(reach.into_iter().flatten());
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        high - low
    };
    let larger = figure.aspect * extent(0, figure.x.reach) / extent(1, figure.y.reach);
    if larger > CLEARLY {
        format!("{up} are drawn larger than {across}.")
    } else if larger < CLEARLY.recip() {
        format!("{up} are drawn smaller than {across}.")
    } else {
        format!("{up} and {across} have scales of their own.")
    }
}
