use super::axis::Scale;
use super::figure::{Bar, Field, Figure, Layer};
use crate::error::{Error, Result};
use crate::units::TableUnits;

/// A row: kind, name, x, y, end x, end y, and a value with the head of its column.
type Row<'a> = (
    &'static str,
    String,
    [Option<f64>; 4],
    Option<(&'a Field, f64)>,
);

/// The data of a plot as CSV, in SI and radians: a row for each point, bar, arrow or node, with the
/// kind and the name of its layer. Each quantity shown as contours has its own column. Empty
/// columns are omitted; a missing value is an empty cell. Views with contours have separate rows
/// with the name of the view.
///
/// # Errors
/// [`Error::Output`].
pub fn figure_csv(figure: &Figure) -> Result<String> {
    figure_csv_in(figure, TableUnits::Si)
}

/// The data of a plot as CSV in these units.
///
/// # Errors
/// [`Error::Output`].
pub fn figure_csv_in(figure: &Figure, units: TableUnits) -> Result<String> {
    let has_contours = |view: &&Figure| {
        view.layers
            .iter()
            .any(|layer| matches!(layer, Layer::Contours(_)))
    };
    let views: Vec<&Figure> = std::iter::once(figure)
        .chain(figure.panels.iter().filter(has_contours))
        .collect();
    let of_view = |view: &&Figure| {
        if views.len() > 1 {
            format!(", {}", view.subtitle)
        } else {
            String::new()
        }
    };
    let of_views = views.iter().flat_map(|view| {
        view.layers
            .iter()
            .flat_map(|layer| rows(view, layer, &of_view(view)))
    });
    let rows: Vec<Row<'_>> = of_views.collect();
    let [x, y] = [&figure.x, &figure.y].map(|axis| axis.measure.head(units));
    let [x, y] = [(x, "x"), (y, "y")].map(|(title, letter)| {
        if title.is_empty() {
            letter.into()
        } else {
            title
        }
    });
    let heads = [x.clone(), y.clone(), format!("to {x}"), format!("to {y}")];
    let is_filled = |column: &usize| {
        rows.iter()
            .any(|(_, _, numbers, _)| numbers[*column].is_some())
    };
    let columns: Vec<usize> = (0..heads.len()).filter(is_filled).collect();
    let mut measured: Vec<String> = vec![];
    for (.., value) in &rows {
        let head = value.map(|(field, _)| field.measure.head(units));
        measured.extend(head.filter(|head| !measured.contains(head)));
    }

    let failed = |error: csv::Error| Error::Output(error.into());
    let mut writer = csv::Writer::from_writer(vec![]);
    let head = columns
        .iter()
        .map(|column| heads[*column].as_str())
        .chain(measured.iter().map(String::as_str));
    writer
        .write_record(["kind", "name"].into_iter().chain(head))
        .map_err(failed)?;
    let text = |number: Option<f64>| {
        number
            .filter(|number| number.is_finite())
            .map_or(String::new(), |number| format!("{number:?}"))
    };
    for (kind, name, numbers, value) in &rows {
        let cells = columns.iter().map(|column| {
            let axis = [&figure.x, &figure.y][column % 2];
            text(numbers[*column].map(|value| axis.measure.number(value, units)))
        });
        let is_of = |head: &String| value.filter(|(field, _)| field.measure.head(units) == *head);
        let values = measured
            .iter()
            .map(|head| text(is_of(head).map(|(field, value)| field.measure.number(value, units))));
        writer
            .write_record(
                [(*kind).to_owned(), name.clone()]
                    .into_iter()
                    .chain(cells)
                    .chain(values),
            )
            .map_err(failed)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| Error::Output(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The rows of a layer. With several views, `of_view` is the end of their names.
fn rows<'a>(figure: &'a Figure, layer: &'a Layer, of_view: &str) -> Vec<Row<'a>> {
    let point = |[x, y]: [f64; 2]| [Some(x), Some(y), None, None];
    let between =
        |[x, y]: [f64; 2], [to_x, to_y]: [f64; 2]| [Some(x), Some(y), Some(to_x), Some(to_y)];
    let row = |kind: &'static str, numbers: [Option<f64>; 4]| -> Row<'a> {
        (kind, format!("{}{of_view}", layer.named().0), numbers, None)
    };
    match layer {
        Layer::Line { points, .. } => points.iter().map(|at| row("line", point(*at))).collect(),
        Layer::Dots { points, .. } => points.iter().map(|at| row("dots", point(*at))).collect(),
        Layer::Mark { at, .. } => vec![row("mark", point(*at))],
        Layer::Text { at, .. } => vec![row("text", point(*at))],
        Layer::Band { points, .. } => points
            .iter()
            .map(|[x, low, high]| row("band", [Some(*x), Some(*low), None, Some(*high)]))
            .collect(),
        Layer::Bars { name, bars, .. } => {
            let place = |place: usize| match &figure.y.scale {
                Scale::Names(names) => names.get(place).map_or(name.as_str(), String::as_str),
                _ => name,
            };
            let one = |bar: &Bar| {
                (
                    "bar",
                    place(bar.place).to_owned(),
                    [Some(bar.from), None, Some(bar.to), None],
                    None,
                )
            };
            bars.iter().map(one).collect()
        }
        Layer::Arrows { arrows, .. } => arrows
            .iter()
            .map(|[from, to]| row("arrow", between(*from, *to)))
            .collect(),
        Layer::Region { rings, .. } => {
            // a row without numbers separates two rings
            rings
                .join(&[f64::NAN; 2])
                .iter()
                .map(|at| row("region", point(*at)))
                .collect()
        }
        Layer::Frame { low, high, .. } => vec![row("frame", between(*low, *high))],
        Layer::Contours(field) => {
            let one = |(i, value): (usize, &Option<f64>)| {
                let at = field.place((i % field.columns) as f64, (i / field.columns) as f64);
                let (kind, name, numbers, _) = row("field", point(at));
                (
                    kind,
                    name,
                    numbers,
                    Some((field, value.unwrap_or(f64::NAN))),
                )
            };
            field.values.iter().enumerate().map(one).collect()
        }
    }
}
