use crate::report::plot::{Axis, Figure, Layer, Measure};

/// How differences come near an exact derivative, and leave it again.
#[derive(Clone, Debug, PartialEq)]
pub struct VCurve {
    /// The derivative: "d carry/d club.loft".
    pub name: String,
    /// Each step, relative to the parameter's size, with the error of the central difference, relative to the derivative.
    pub points: Vec<[f64; 2]>,
}

/// V-curves of central differences: truncation to the right, rounding to the left, and the exact derivative below both.
pub fn vcurve_figure(curves: &[VCurve]) -> Figure {
    let x = Axis::log(Measure::plain("step, relative"));
    let y = Axis::log(Measure::plain("error of the difference, relative"));
    let mut figure = Figure::new("vcurve", "Central differences against the exact derivative", x, y);
    for (i, VCurve { name, points }) in curves.iter().enumerate() {
        figure.layers.push(Layer::Line {
            name: name.clone(),
            hue: crate::report::plot::Hue::Series(i),
            is_dashed: i % 2 == 1,
            points: points.clone(),
        });
    }
    let exact = curves.iter().flat_map(|curve| &curve.points).filter(|[_, error]| *error <= 0.0).count();
    let exact = if exact == 0 {
        String::new()
    } else {
        format!(" {exact} differences hit the derivative exactly and have no place on a logarithmic axis.")
    };
    figure.noted(format!(
        "To the right of the lowest point a difference errs by its step squared, to the left by rounding over the step.{exact}"
    ))
}
