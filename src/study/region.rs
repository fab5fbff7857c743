//! The region of a map whose drives meet all constraints and are nearly as good as the optimum.

use super::flatness::check_loss;
use super::optimum::Optimum;
use super::plane::Plane;
use super::{Constraint, Vary};
use crate::derivative::Order;
use crate::error::Result;
use crate::statistics::{extent, largest_magnitude};

/// Region of a map in which drives lose at most a stated amount of an optimum's outcome and meet
/// every bound and constraint. Parameters that are not on the map's axes are fixed at the optimum.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// The allowed loss, SI.
    pub loss: f64,
    /// The horizontal range of the grid.
    pub across: Vary,
    /// The vertical range of the grid.
    pub up: Vary,
    /// Nodes in each direction.
    pub columns: usize,
    /// Excess at each node: the maximum of loss/allowed loss − 1 and the violations of the
    /// constraints. It is at most 0 in the region. Each violation is divided by the range of the
    /// constraint's goal over the map. `None` if the drive does not fly.
    pub excess: Vec<Option<f64>>,
    /// Signed violation of the equality constraint at each node. The region lies on the line on
    /// which the violation is 0. `None` without an equality constraint, or if the constraint holds
    /// on the whole grid.
    pub equation: Option<Vec<Option<f64>>>,
}

/// Nodes in each direction of the grids that locate the region.
const COARSE: usize = 41;
/// Nodes in each direction of the grid that shows the region.
const FINE: usize = 97;

/// Maximum number of grids. Each grid covers the part of the previous grid that contains the
/// region.
const MOST_GRIDS: usize = 8;

/// A region is resolved if it fills more than this fraction of the grid in both directions.
const FILLED: f64 = 0.55;

/// Rounding tolerance of an equality constraint, relative to the largest value of its goal on the
/// grid.
const ROUNDING: f64 = 1e-12;

impl Region {
    /// The region around an optimum over two of the parameters that its search varied.
    ///
    /// `None` if the optimum has no value, if the search does not vary both parameters, if a range
    /// is a single value, if two equality constraints fix both parameters, or if no node of the
    /// finest grid lies in the region.
    ///
    /// # Errors
    /// The errors of [`Batch::new`](crate::batch::Batch::new);
    /// [`Error::Optimizer`](crate::Error::Optimizer) for a loss that is not above 0 and finite;
    /// [`Error::Unreadable`](crate::Error::Unreadable) for a search over swings.
    pub fn around(best: &Optimum, across: Vary, up: Vary, loss: f64) -> Result<Option<Self>> {
        best.search.refuse_swings()?;
        check_loss(best, loss)?;
        let place = |of: &Vary| {
            best.search
                .parameters()
                .position(|varied| varied == of.parameter)
        };
        let (Some(value), Some(i), Some(j)) = (best.value(), place(&across), place(&up)) else {
            return Ok(None);
        };
        let equations = best
            .search
            .subject_to
            .iter()
            .filter(|constraint| constraint.is_equation())
            .count();
        if equations > 1 || across.low == across.high || up.low == up.high {
            return Ok(None);
        }
        let top = [best.solution.x[i], best.solution.x[j]];
        let look = |across: Vary, up: Vary, columns: usize| -> Result<Self> {
            let plane = Plane::fly(
                &best.setup,
                &best.search.outcomes(),
                across,
                up,
                [columns; 2],
                Order::Value,
            )?;
            Ok(Self::from_plane(best, value, loss, &plane))
        };
        let (mut across, mut up) = (across, up);
        for _ in 0..MOST_GRIDS {
            let (x, y) = look(across, up, COARSE)?.extent(top);
            let part = |all: &Vary, part: &Vary| (part.high - part.low) / (all.high - all.low);
            let is_seen = part(&across, &x) > FILLED && part(&up, &y) > FILLED;
            (across, up) = (x, y);
            if is_seen {
                break;
            }
        }
        let region = look(across, up, FINE)?;
        Ok(Some(region)
            .filter(|region| region.excess.iter().flatten().any(|excess| *excess <= 0.0)))
    }

    fn from_plane(best: &Optimum, value: f64, loss: f64, plane: &Plane) -> Self {
        let sign = best.search.sense.sign();
        let mut excess: Vec<Option<f64>> = plane.values[0]
            .iter()
            .map(|found| Some(sign * ((*found)? - value) / loss - 1.0))
            .collect();
        let mut equation = None;
        for (constraint, values) in best.search.subject_to.iter().zip(&plane.values[1..]) {
            let of_constraint = excess_of(constraint, values);
            if constraint.is_equation() {
                // ignore an equality constraint that holds on the whole plane: it excludes no point
                let rounding = ROUNDING * largest_magnitude(values.iter().flatten());
                if values
                    .iter()
                    .flatten()
                    .any(|value| (value - constraint.low).abs() > rounding)
                {
                    equation = Some(of_constraint);
                }
                continue;
            }
            for (most, other) in excess.iter_mut().zip(of_constraint) {
                *most = most.zip(other).map(|(most, other)| most.max(other));
            }
        }
        let Plane {
            across,
            up,
            columns,
            ..
        } = *plane;
        Self {
            loss,
            across,
            up,
            columns,
            excess,
            equation,
        }
    }

    /// Smallest ranges that contain the region, the optimum, and a margin of one node.
    fn extent(&self, top: [f64; 2]) -> (Vary, Vary) {
        let rows = self.excess.len() / self.columns;
        let step = |vary: &Vary, count: usize| (vary.high - vary.low) / (count - 1) as f64;
        let steps = [step(&self.across, self.columns), step(&self.up, rows)];
        let is_within = |excess: &Option<f64>| excess.is_some_and(|excess| excess <= 0.0);
        let nodes = self
            .excess
            .iter()
            .enumerate()
            .filter(|(_, excess)| is_within(excess));
        let places = nodes.map(|(node, _)| {
            let (column, row) = (node % self.columns, node / self.columns);
            [
                self.across.low + column as f64 * steps[0],
                self.up.low + row as f64 * steps[1],
            ]
        });
        let (mut low, mut high) = (top, top);
        for place in places {
            for axis in 0..2 {
                low[axis] = low[axis].min(place[axis]);
                high[axis] = high[axis].max(place[axis]);
            }
        }
        let grown = |vary: &Vary, axis: usize| Vary {
            low: (low[axis] - steps[axis]).max(vary.low),
            high: (high[axis] + steps[axis]).min(vary.high),
            ..*vary
        };
        (grown(&self.across, 0), grown(&self.up, 1))
    }
}

/// Excess of a constraint at each node, divided by the range of the goal's values. It is at most 0
/// if the constraint is met. For an equality constraint, it is the signed violation.
fn excess_of(constraint: &Constraint, values: &[Option<f64>]) -> Vec<Option<f64>> {
    let [low, high] = extent(values.iter().flatten().copied());
    let range = high - low;
    let range = if range > 0.0 && range.is_finite() {
        range
    } else {
        1.0
    };
    let excess = |value: f64| {
        if constraint.is_equation() {
            value - constraint.low
        } else {
            (value - constraint.high).max(constraint.low - value)
        }
    };
    values
        .iter()
        .map(|value| value.map(|value| excess(value) / range))
        .collect()
}
