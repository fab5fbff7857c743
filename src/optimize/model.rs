use super::convex::convexified;
use super::frame::{Frame, Point, dot};
use super::qp::{End, Piece, QuadraticProgram, Step};
use super::sides::{Sides, scaled_gradient, scaled_hessian};
use nalgebra::DVector;

/// A step that the quadratic model around a point leads to.
pub(super) struct Plan {
    /// Where it ends; a variable that ends at a bound is there exactly.
    pub x: Vec<f64>,
    /// Its largest component, in units of the scale.
    pub length: f64,
    /// What the model says f falls by.
    pub promised: f64,
    /// How many sides of a corner hold it; 1 away from corners.
    pub sides: usize,
}

impl Plan {
    /// Minimises the model within the bounds and a trust region.
    pub fn new(frame: &Frame, sides: &Sides, at: &Point, radius: f64) -> Self {
        let model = model(frame, sides, at, radius);
        let step = model.solve();
        Self {
            x: stepped(frame, at, &step, radius),
            length: step.d.amax(),
            promised: promised(frame, at, &model, &step),
            sides: step.weights.iter().filter(|weight| **weight > 1e-6).count(),
        }
    }
}

/// The quadratic model in scaled variables: the point's own piece, and those of other sides of corners nearby.
fn model(frame: &Frame, sides: &Sides, at: &Point, radius: f64) -> QuadraticProgram {
    let n = at.x.len();
    let projected = frame.projected_gradient(at);
    let held: Vec<bool> = (0..n).map(|i| projected[i] == 0.0 && frame.is_at_a_bound(at, i)).collect();
    let own = Piece { offset: 0.0, gradient: scaled_gradient(frame, at) };
    let limit = |i: usize, bound: f64| ((bound - at.x[i]) / frame.scale[i]).clamp(-radius, radius);
    QuadraticProgram {
        curvature: convexified(&scaled_hessian(frame, at), &held),
        pieces: std::iter::once(own).chain(sides.pieces(frame, at)).collect(),
        low: DVector::from_fn(n, |i, _| limit(i, frame.bounds.low[i])),
        high: DVector::from_fn(n, |i, _| limit(i, frame.bounds.high[i])),
    }
}

fn stepped(frame: &Frame, at: &Point, step: &Step, radius: f64) -> Vec<f64> {
    let coordinate = |i: usize| {
        let (low, high) = (frame.bounds.low[i], frame.bounds.high[i]);
        match step.ends[i] {
            End::Low if step.d[i] > -radius => low,
            End::High if step.d[i] < radius => high,
            _ => (at.x[i] + step.d[i] * frame.scale[i]).clamp(low, high),
        }
    };
    (0..at.x.len()).map(coordinate).collect()
}

/// With the true Hessian where there is one piece: it promises at least as much as the convex stand-in.
fn promised(frame: &Frame, at: &Point, model: &QuadraticProgram, step: &Step) -> f64 {
    if model.pieces.len() > 1 {
        return -model.value(&step.d);
    }
    let d: Vec<f64> = step.d.iter().zip(&frame.scale).map(|(d, s)| d * s).collect();
    let bend: Vec<f64> = at.f.hessian.iter().map(|row| dot(row, &d)).collect();
    -(dot(&at.f.gradient, &d) + 0.5 * dot(&bend, &d))
}
