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
                .noted("Heights are drawn larger than distances.")
        }
        View::Top => Figure::new(
            "trajectory-top",
            "Trajectory from above",
            downrange,
            Axis::left_right(length("right of the target line")).reaching(-CORRIDOR, CORRIDOR),
        )
        .noted("Seen from above with the target to the right. Distances to the left and right are drawn larger than those downrange."),
    };
    figure.aspect = if view == View::Side { 0.55 } else { 0.4 };
    for (i, Flown { name, drive, path }) in flown.iter().enumerate() {
        let seen = |up: f64, right: f64, downrange: f64| match view {
            View::Side => [downrange, up],
            View::Top => [downrange, right],
        };
        let points =
            path.points.iter().map(|point| seen(point.position.x, point.position.y, point.position.z)).collect();
        let hue = Hue::Series(i);
        figure.layers.push(Layer::Line { name: name.clone(), hue, is_dashed: i > 0, points });
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
    figure
}
