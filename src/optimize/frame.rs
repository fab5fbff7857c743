use super::problem::{Bounds, Evaluation};

/// A point with what is known of the function there.
#[derive(Clone)]
pub(super) struct Point {
    pub x: Vec<f64>,
    pub f: Evaluation,
}

/// What a search measures with: the bounds, what a sensible change of each variable is, and what a sensible size of
/// the function is.
pub(super) struct Frame {
    pub bounds: Bounds,
    pub scale: Vec<f64>,
    /// φ.
    pub phi: f64,
}

impl Frame {
    /// The frame of a search that begins at `first`.
    pub fn new(bounds: Bounds, scale: Vec<f64>, first: &Point) -> Self {
        let slopes = first.f.gradient.iter().zip(&scale).map(|(g, s)| (g * s).abs());
        let phi = slopes.fold(first.f.value.abs(), f64::max).max(f64::MIN_POSITIVE);
        Self { bounds, scale, phi }
    }

    /// The gradient's component where a move inside the bounds can use it, 0 elsewhere.
    pub fn projected_gradient(&self, at: &Point) -> Vec<f64> {
        let Bounds { low, high } = &self.bounds;
        let component = |i: usize| match at.f.gradient[i] {
            _ if low[i] == high[i] => 0.0,
            slope if slope > 0.0 && at.x[i] <= low[i] => 0.0,
            slope if slope < 0.0 && at.x[i] >= high[i] => 0.0,
            slope => slope,
        };
        (0..at.x.len()).map(component).collect()
    }

    /// maxᵢ sᵢ |pᵢ|/φ with p the projected gradient.
    pub fn kkt_residual(&self, at: &Point) -> f64 {
        self.largest(&self.projected_gradient(at)) / self.phi
    }

    /// The largest component of a gradient, in units of the scale.
    pub fn largest(&self, gradient: &[f64]) -> f64 {
        gradient.iter().zip(&self.scale).map(|(p, s)| (p * s).abs()).fold(0.0, f64::max)
    }

    /// The distance of two points, in units of the scale.
    pub fn distance(&self, a: &Point, b: &Point) -> f64 {
        let apart = a.x.iter().zip(&b.x).zip(&self.scale).map(|((a, b), s)| ((a - b) / s).abs());
        apart.fold(0.0, f64::max)
    }

    pub fn is_at_a_bound(&self, at: &Point, i: usize) -> bool {
        at.x[i] <= self.bounds.low[i] || at.x[i] >= self.bounds.high[i]
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
