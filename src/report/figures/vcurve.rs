use super::At;
use crate::derivative::check::Point;
use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::reproduce::LoopRow;
use crate::study::certificate::Row;
use crate::units::counted;

/// V-curves: the error of plain central differences relative to exact derivatives, over the step.
/// Truncation dominates on the right, rounding on the left. Steps are relative to the parameter's
/// size. Errors are relative to the derivative, or to outcome/size if the derivative is 0. For
/// comparison, the plot has the differences of a while-loop that overshoots the ground.
pub fn vcurve_figure<'a>(
    rows: impl IntoIterator<Item = &'a Row>,
    loops: &[LoopRow],
    at: At,
) -> Figure {
    let x = Axis::log(Measure::plain("step, relative"));
    let y = Axis::log(Measure::plain("error of the difference, relative"));
    let mut figure = Figure::new(
        "vcurve",
        format!("Central differences against exact derivatives, {at}"),
        x,
        y,
    );
    let mut exact = 0;
    let mut looped = vec![];
    for (
        i,
        Row {
            of,
            parameter,
            ladder,
            first,
            ..
        },
    ) in rows.into_iter().enumerate()
    {
        let unit = if first.exact == 0.0 {
            ladder.size / ladder.scale
        } else {
            first.exact.abs()
        };
        let of_curve = |curve: &[Point]| -> Vec<[f64; 2]> {
            curve
                .iter()
                .map(|point| [point.step / ladder.scale, point.error / unit])
                .collect()
        };
        let points = of_curve(&first.curve);
        if let Some(row) = loops
            .iter()
            .find(|row| *of == Outcome::Carry && row.parameter == *parameter)
        {
            looped.push((
                format!("a while-loop, by {}", parameter.name),
                of_curve(&row.check.curve),
            ));
        }
        exact += points.iter().filter(|[_, error]| *error <= 0.0).count();
        let name = format!("d {}/d {}", of.name(), parameter.name);
        figure.layers.push(Layer::Line {
            name,
            hue: Hue::Series(i),
            is_dashed: i % 2 == 1,
            points,
        });
    }
    let first_loop = figure.layers.len();
    for (i, (name, points)) in looped.into_iter().enumerate() {
        figure.layers.push(Layer::Line {
            name,
            hue: Hue::Series(first_loop + i),
            is_dashed: true,
            points,
        });
    }
    let mut note =
        "To the right of its lowest point the error of a difference grows with the square of the \
         step (truncation), to the \
                    left with the inverse of the step (rounding). The exact derivative has neither \
         error."
            .to_owned();
    if figure.layers.len() > first_loop {
        note += " The carry of a while-loop that stops at the first step below the ground is not \
                 smooth, and small steps do not see its slope.";
    }
    if exact > 0 {
        note += &format!(
            " Not drawn, since a logarithmic axis has no 0: {}, equal to the exact derivative to \
             the last bit.",
            counted(exact as u64, "difference")
        );
    }
    figure.noted(note)
}
