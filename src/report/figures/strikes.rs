use super::face::{axes, marks, outline, reference, seen, tilt_arrows};
use super::style::field;
use crate::drive::Outcome;
use crate::report::plot::{Field, Figure, Hue, Layer};
use crate::report::shown::{self, capital};
use crate::statistics::largest_magnitude;
use crate::study::Face;
use crate::units::{Quantity, System};

/// Only every fifth node of the computed grid is drawn. Few nodes suffice, because the
/// interpolation of the contours uses the gradients.
const THINNED: usize = 5;

/// Carry, lateral, ball speed and spin axis as functions of the impact point on the face, seen from
/// the front at true scale. Each design has its own views, with common levels and colours. `None`
/// if `designs` is empty.
pub fn strikes_figure(designs: &[(&str, &Face)], system: System) -> Option<Figure> {
    let tilts = designs.iter().flat_map(|(_, face)| &face.tilts);
    let largest = largest_magnitude(tilts.map(|(_, tilt)| tilt));
    let mut views = vec![];
    for (i, of) in Face::OUTCOMES.into_iter().enumerate() {
        let fields: Vec<Field> = designs
            .iter()
            .map(|(_, face)| over_face(face, i, of))
            .collect();
        let all: Vec<f64> = fields
            .iter()
            .flat_map(|field| field.values.iter().flatten().copied())
            .collect();
        for ((name, face), field) in designs.iter().zip(fields) {
            let mut view = view(
                face,
                of,
                Field {
                    common_values: all.clone(),
                    ..field
                },
                system,
            );
            view.subtitle = (*name).into();
            if of == Outcome::SpinAxis && largest > 0.0 {
                let name = format!(
                    "added tilt, longest {}",
                    Quantity::ANGLE.read_off(largest, "deg")
                );
                view.layers.push(tilt_arrows(face, name, largest));
            }
            views.push(view);
        }
    }
    let mut views = views.into_iter();
    let mut figure = views.next()?;
    (figure.name, figure.columns, figure.panels) = ("strikes".into(), 2, views.collect());
    Some(figure.noted(note(designs, system)))
}

fn view(face: &Face, of: Outcome, field: Field, system: System) -> Figure {
    let [wide, tall] = face.half;
    let [x, y] = axes(face);
    let (x, y) = (x.exactly(-wide, wide), y.exactly(-tall, tall));
    let title = format!("{} over the face", capital(&field.quantity.label));
    let mut figure = Figure::new(system, format!("strikes-{}", of.name()), title, x, y)
        .with(Layer::contours(field));
    figure.aspect = tall / wide;
    figure.layers.push(outline(face));
    figure.layers.extend(marks(face, Hue::Ink));
    figure
}

/// The values of an outcome at every `THINNED`th node of the face. The columns run from left to
/// right in the view from the front.
fn over_face(face: &Face, of: usize, outcome: Outcome) -> Field {
    let whole = field(&face.plane, of, outcome);
    let is_turned = seen(face, [1.0, 0.0])[0] < 0.0;
    let columns: Vec<usize> = (0..whole.columns).step_by(THINNED).collect();
    let column = |i: usize| columns[if is_turned { columns.len() - 1 - i } else { i }];
    let rows = (0..whole.rows()).step_by(THINNED);
    let places = rows.flat_map(|row| (0..columns.len()).map(move |i| (row, i)));
    let nodes: Vec<usize> = places
        .map(|(row, i)| row * whole.columns + column(i))
        .collect();
    let side = if is_turned { -1.0 } else { 1.0 };
    let gradient = |node: &usize| {
        let [across, up] = whole.gradients.get(*node).copied().flatten()?;
        Some([side * across, up])
    };
    Field {
        values: nodes.iter().map(|node| whole.values[*node]).collect(),
        gradients: nodes.iter().map(gradient).collect(),
        columns: columns.len(),
        ..whole
    }
}

fn note(designs: &[(&str, &Face)], system: System) -> String {
    /// Distance of a strike from the reference point, m. The note states the effect of such a
    /// strike.
    const STEP: f64 = 1e-3;
    let text = |(name, face): &(&str, &Face)| {
        let slopes = Face::OUTCOMES.into_iter().zip(face.by_toe?);
        let change = |of: Outcome| {
            let (_, slope) = slopes.clone().find(|(other, _)| *other == of)?;
            Some(shown::change(of, STEP * slope, system))
        };
        Some(format!(
            "{name}: spin axis {}, lateral {}, carry {}",
            change(Outcome::SpinAxis)?,
            change(Outcome::Lateral)?,
            change(Outcome::Carry)?
        ))
    };
    let text: Vec<String> = designs.iter().filter_map(text).collect();
    let mut references: Vec<_> = designs.iter().map(|(_, face)| reference(face)).collect();
    references.dedup();
    let from = references.join(" or ");
    let slopes = match text.is_empty() {
        true => String::new(),
        false => format!(
            "Effect of a strike 1 mm from {from} towards the toe: {}. ",
            text.join("; ")
        ),
    };
    format!(
        "{slopes}Arrows: the tilt of the spin axis minus its tilt for a strike at {from}; bulge, \
         roll and gear effect together. {}. Seen from the front, so that right of the target line \
         is on the left. The outline is that of a usual driver, for scale only.",
        capital(shown::GEAR_EFFECT)
    )
}
