use crate::derivative::check::CurvePoint;
use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::reproduce::LoopRow;
use crate::study::certificate::DerivativeRow;
use crate::units::{System, counted};

/// V-curves: the error of plain central differences against the step. The exact derivative is the
/// reference. Truncation dominates on the right, rounding on the left.
///
/// Steps are divided by the size of the parameter. Errors are divided by the exact derivative. If
/// this derivative is 0, errors are divided by the size of the outcome over the size of the
/// parameter. For comparison, `loops` has the curves of a while-loop that stops at the first step
/// below the ground.
pub fn vcurve_figure<'a>(
    rows: impl IntoIterator<Item = &'a DerivativeRow>,
    loops: &[LoopRow],
    system: System,
) -> Figure {
    let x = Axis::log(NamedQuantity::plain("step, relative"));
    let y = Axis::log(NamedQuantity::plain("error of the difference, relative"));
    let mut figure = Figure::new(
        system,
        "vcurve",
        "Central differences against exact derivatives, as set up",
        x,
        y,
    );
    let mut exact = 0;
    let mut looped = vec![];
    for (i, row) in rows.into_iter().enumerate() {
        let points = curve(row, &row.first.curve);
        exact += points.iter().filter(|[_, error]| *error <= 0.0).count();
        figure.layers.push(Layer::new(
            format!("d {}/d {}", row.of.name(), row.parameter.name),
            Hue::Series(i),
            Shape::Line {
                is_dashed: i % 2 == 1,
                points,
            },
        ));
        let same = |other: &&LoopRow| row.of == Outcome::Carry && other.parameter == row.parameter;
        if let Some(other) = loops.iter().find(same) {
            let name = format!("a while-loop, by {}", row.parameter.name);
            looped.push((name, curve(row, &other.check.curve)));
        }
    }
    let first_loop = figure.layers.len();
    for (i, (name, points)) in looped.into_iter().enumerate() {
        figure.layers.push(Layer::new(
            name,
            Hue::Series(first_loop + i),
            Shape::dashed(points),
        ));
    }
    let has_loops = figure.layers.len() > first_loop;
    figure.noted(note(has_loops, exact))
}

/// The relative steps and errors of `points`, with the divisors that [`vcurve_figure`] states.
fn curve(row: &DerivativeRow, points: &[CurvePoint]) -> Vec<[f64; 2]> {
    let unit = if row.first.exact == 0.0 {
        row.ladder.size / row.ladder.scale
    } else {
        row.first.exact.abs()
    };
    points
        .iter()
        .map(|point| [point.step / row.ladder.scale, point.error / unit])
        .collect()
}

/// The text that explains the curves. `exact` is the number of finite differences that equal the
/// exact derivative.
fn note(has_loops: bool, exact: usize) -> String {
    let mut note = "To the right of its lowest point the error of a difference grows with the \
                    square of the step (truncation), to the left with the inverse of the step \
                    (rounding). The exact derivative has neither error."
        .to_owned();
    if has_loops {
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
    note
}
