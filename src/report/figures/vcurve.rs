use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::study::certificate::Row;

/// V-curves of plain central differences of values beside exact derivatives: truncation to the right, rounding to the left.
/// Steps are parts of the parameter's size; errors, of the derivative, or of outcome over size where that is 0.
pub fn vcurve_figure<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Figure {
    let x = Axis::log(Measure::plain("step, relative"));
    let y = Axis::log(Measure::plain("error of the difference, relative"));
    let mut figure = Figure::new("vcurve", "Central differences against exact derivatives", x, y);
    let mut exact = 0;
    for (i, Row { of, parameter, ladder, first, .. }) in rows.into_iter().enumerate() {
        let unit = if first.exact == 0.0 { ladder.size / ladder.scale } else { first.exact.abs() };
        let points = first.curve.iter().map(|point| [point.step / ladder.scale, point.error / unit]);
        let points: Vec<[f64; 2]> = points.collect();
        exact += points.iter().filter(|[_, error]| *error <= 0.0).count();
        let name = format!("d {}/d {}", of.name(), parameter.name);
        figure.layers.push(Layer::Line { name, hue: Hue::Series(i), is_dashed: i % 2 == 1, points });
    }
    let mut note =
        "A difference errs by the square of its step to the right of the lowest point, by rounding over the step to \
                    the left; the exact derivative by neither."
            .to_owned();
    if exact > 0 {
        note +=
            &format!(" Differences that hit it to the last bit: {exact}; they have no place on a logarithmic axis.");
    }
    figure.noted(note)
}
