//! An outcome over a grid of two parameters.

use super::Vary;
use super::plane::Plane;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::statistics::extent;
use crate::units::{DisplayUnit, Message};
use rayon::prelude::*;

/// An outcome at the nodes of a grid, with its gradient at some points.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The outcome.
    pub of: Outcome,
    /// The outcome and its gradient at the nodes.
    pub plane: Plane,
    /// Reason for the first missing value; `None` if every node has a value.
    pub missing: Option<Message>,
    /// Gradients at the points of a coarser grid.
    pub slopes: Vec<Slope>,
}

impl Map {
    /// Message for an outcome that is constant up to rounding, so that there is nothing to draw;
    /// `None` for any other outcome.
    pub fn flat(&self) -> Option<Message> {
        let [low, high] = extent(self.plane.values[0].iter().flatten().copied());
        let unit = DisplayUnit::from(self.of).size();
        let is_flat = high - low <= ROUNDING * low.abs().max(high.abs()).max(unit);
        is_flat.then(|| {
            Message::from(format!(
                "{} is constant over the map of {} and {}, so there is nothing to draw",
                self.of.name(),
                self.plane.across.parameter.name,
                self.plane.up.parameter.name
            ))
        })
    }
}

/// Values are constant up to rounding if their range is at most this fraction of their largest
/// magnitude, or of one display unit if that is larger.
const ROUNDING: f64 = 1e-9;

/// Gradient at a point of a map, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Point: across, up.
    pub at: [f64; 2],
    /// Derivatives by both parameters.
    pub gradient: [f64; 2],
}

/// Resolution of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fineness {
    /// Nodes per side, at least 2.
    pub nodes: usize,
    /// Gradients per side; 0 for none.
    pub slopes: usize,
}

impl Default for Fineness {
    /// 61 nodes per side, for smooth contour lines, and 7 gradients.
    fn default() -> Self {
        Self {
            nodes: 61,
            slopes: 7,
        }
    }
}

/// An outcome over two parameters of a setup, computed in parallel.
///
/// ```
/// use longdrive::study::{Fineness, Vary, map};
/// use longdrive::{Outcome, Setup};
/// let setup = Setup::modern_driver();
/// let [across, up] = ["club.loft=8deg..12deg", "swing.speed=40..50m/s"]
///     .map(|text| Vary::read(&setup, text).unwrap());
/// let fineness = Fineness { nodes: 3, slopes: 1 };
/// let speeds = map(&setup, Outcome::BallSpeed, across, up, fineness).unwrap();
/// // ball speed is proportional to club speed: the highest row over the lowest
/// let values = &speeds.plane.values[0];
/// assert!((values[6].unwrap() / values[0].unwrap() - 1.25).abs() < 1e-12);
/// ```
///
/// # Errors
/// [`Error::SearchRange`] for equal parameters, a range of a single value, or fewer than 2 nodes
/// per side; the errors of [`Setup::validate`]; [`Error::NoFlight`] if no node has a value.
pub fn map(
    setup: &Setup<f64>,
    of: Outcome,
    across: Vary,
    up: Vary,
    fineness: Fineness,
) -> Result<Map> {
    check(&across, &up, fineness)?;
    let wrt = [across.parameter, up.parameter];
    let values = Evaluator::new(setup, &[of], &wrt, Order::Value)?;
    let gradients = Evaluator::new(setup, &[of], &wrt, Order::First)?;
    let plane = Plane::fly(setup, &[of], across, up, [fineness.nodes; 2], Order::First)?;
    let found = &plane.values[0];
    let first_missing = found.iter().position(Option::is_none);
    let missing = first_missing
        .and_then(|node| values.at(&plane.node(node)).err())
        .map(|error| error.message());
    if found.iter().all(Option::is_none) {
        let reason = missing.unwrap_or_default();
        return Err(Error::NoFlight {
            status: "no-flight",
            reason: Message::from(format!(
                "no flight: {} has no value anywhere on the map; at the lower left corner of the \
                 map: ",
                of.name()
            ))
            .message(reason),
        });
    }
    Ok(Map {
        of,
        plane,
        missing,
        slopes: slopes(&gradients, [across, up], fineness.slopes),
    })
}

/// Gradients at the centres of equal cells. A centre without a gradient is omitted: there the ball
/// does not fly, or the outcome has a kink.
fn slopes(gradients: &Evaluator, ranges: [Vary; 2], cells: usize) -> Vec<Slope> {
    (0..cells * cells)
        .into_par_iter()
        .filter_map(|i| {
            let centre = |vary: Vary, cell: usize| {
                vary.low + (cell as f64 + 0.5) / cells as f64 * (vary.high - vary.low)
            };
            let at = [centre(ranges[0], i % cells), centre(ranges[1], i / cells)];
            let taylors = gradients.at(&at).ok()?;
            Some(Slope {
                at,
                gradient: [taylors[0].gradient[0], taylors[0].gradient[1]],
            })
        })
        .collect()
}

fn check(across: &Vary, up: &Vary, fineness: Fineness) -> Result<()> {
    let refuse = |vary: &Vary, reason: &str| {
        Err(Error::SearchRange {
            name: vary.parameter.name.into(),
            reason: reason.into(),
        })
    };
    if across.parameter == up.parameter {
        return refuse(up, "a map needs two different parameters");
    }
    if fineness.nodes < 2 {
        return refuse(across, "a map needs 2 nodes or more along each side");
    }
    for vary in [across, up] {
        vary.check()?;
        if vary.low == vary.high {
            return refuse(vary, "a map needs a range wider than a single value");
        }
    }
    Ok(())
}
