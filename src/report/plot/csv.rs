use super::axis::{Axis, AxisScale};
use super::figure::{Field, Figure, HorizontalBar, Layer, Shape};
use crate::error::Result;
use crate::report::csv_text::csv_text;
use crate::units::TableUnits;

struct CsvRow<'a> {
    kind: &'static str,
    name: String,
    /// For a point: x and y. For a bar or an arrow: x and y of both ends. For a band: x, low y, no
    /// number, high y.
    numbers: [Option<f64>; 4],
    /// The value at a node of a field. The quantity of the field determines the column of the
    /// value.
    value: Option<(&'a Field, f64)>,
}

/// The data of a plot as CSV in these units. Each point, bar, arrow and node has a row with the
/// kind and the name of its layer; a bar has the name of its row before it, "ROW: LAYER". Each
/// quantity shown as contours has its own column. Empty columns are omitted; a missing value is an
/// empty cell. If further views have contours, they have rows too, and the subtitle of the view is
/// added to the names.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output) if a row and the head differ in length, which no figure
/// causes.
pub fn figure_csv(figure: &Figure, units: TableUnits) -> Result<String> {
    let rows = rows(figure);
    let numbers = number_columns(figure, &rows, units);
    let mut values: Vec<String> = vec![];
    for row in &rows {
        let head = row.value.map(|(field, _)| field.quantity.head(units));
        values.extend(head.filter(|head| !values.contains(head)));
    }
    let heads = ["kind", "name"].map(str::to_owned).into_iter();
    let heads = heads
        .chain(numbers.iter().map(|(_, head)| head.clone()))
        .chain(values.iter().cloned());
    let cells = rows.iter().map(|row| {
        let number = |(column, _): &(usize, String)| {
            let axis = [&figure.x, &figure.y][column % 2];
            axis.quantity.cell(row.numbers[*column], units)
        };
        let value = |head: &String| match row.value {
            Some((field, value)) if field.quantity.head(units) == *head => {
                field.quantity.cell(Some(value), units)
            }
            _ => String::new(),
        };
        let mut cells = vec![row.kind.to_owned(), row.name.clone()];
        cells.extend(numbers.iter().map(number));
        cells.extend(values.iter().map(value));
        cells
    });
    csv_text(heads.collect(), cells)
}

/// The columns of [`CsvRow::numbers`] that contain numbers, with their heads.
fn number_columns(figure: &Figure, rows: &[CsvRow<'_>], units: TableUnits) -> Vec<(usize, String)> {
    let head = |axis: &Axis, letter: &str| {
        let head = axis.quantity.head(units);
        if head.is_empty() { letter.into() } else { head }
    };
    let [x, y] = [head(&figure.x, "x"), head(&figure.y, "y")];
    let heads = [x.clone(), y.clone(), format!("to {x}"), format!("to {y}")];
    let is_filled = |column: usize| rows.iter().any(|row| row.numbers[column].is_some());
    (0..).zip(heads).filter(|(i, _)| is_filled(*i)).collect()
}

/// The rows of a figure and of those `panels` that have contours.
fn rows(figure: &Figure) -> Vec<CsvRow<'_>> {
    let is_contours = |layer: &Layer| matches!(layer.shape, Shape::Contours(_));
    let panels = figure.panels.iter();
    let panels = panels.filter(|view| view.layers.iter().any(is_contours));
    let views: Vec<&Figure> = std::iter::once(figure).chain(panels).collect();
    let mut rows = vec![];
    for view in &views {
        let of_view = if views.len() > 1 {
            format!(", {}", view.subtitle)
        } else {
            String::new()
        };
        let layers = view.layers.iter();
        rows.extend(layers.flat_map(|layer| layer_rows(view, layer, &of_view)));
    }
    rows
}

/// The rows of a layer. `of_view` names the view if there are several; it is added to the names.
fn layer_rows<'a>(figure: &'a Figure, layer: &'a Layer, of_view: &str) -> Vec<CsvRow<'a>> {
    let name = layer.full_name();
    let point = |[x, y]: [f64; 2]| [Some(x), Some(y), None, None];
    let row = |kind: &'static str, numbers: [Option<f64>; 4]| -> CsvRow<'a> {
        CsvRow {
            kind,
            name: format!("{name}{of_view}"),
            numbers,
            value: None,
        }
    };
    match &layer.shape {
        Shape::Line { points, .. } => points.iter().map(|at| row("line", point(*at))).collect(),
        Shape::Dots(points) => points.iter().map(|at| row("dots", point(*at))).collect(),
        Shape::Mark(at) => vec![row("mark", point(*at))],
        Shape::Text(at) => vec![row("text", point(*at))],
        Shape::Band(points) => points
            .iter()
            .map(|[x, low, high]| row("band", [Some(*x), Some(*low), None, Some(*high)]))
            .collect(),
        Shape::Bars(bars) => {
            let names = match &figure.y.scale {
                AxisScale::Names(names) => names.as_slice(),
                _ => &[],
            };
            let one = |bar: &HorizontalBar| CsvRow {
                kind: "bar",
                name: match names.get(bar.row) {
                    Some(row) => format!("{row}: {name}"),
                    None => name.clone(),
                },
                numbers: [Some(0.0), None, Some(bar.to), None],
                value: None,
            };
            bars.iter().map(one).collect()
        }
        Shape::Arrows(arrows) => arrows
            .iter()
            .map(|[from, to]| row("arrow", [from[0], from[1], to[0], to[1]].map(Some)))
            .collect(),
        Shape::Region { rings, .. } => {
            // a row without numbers separates two rings
            rings
                .join(&[f64::NAN; 2])
                .iter()
                .map(|at| row("region", point(*at)))
                .collect()
        }
        Shape::Contours(field) => {
            let one = |(i, value): (usize, &Option<f64>)| {
                let at = field.coordinates((i % field.columns) as f64, (i / field.columns) as f64);
                CsvRow {
                    value: Some((field, value.unwrap_or(f64::NAN))),
                    ..row("field", point(at))
                }
            };
            field.values.iter().enumerate().map(one).collect()
        }
    }
}
