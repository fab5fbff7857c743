use super::axis::Scale;
use super::figure::{Figure, Layer};
use crate::error::{Error, Result};

/// A row: kind, name, and x, y, x to, y to, value.
type Row<'a> = (&'static str, &'a str, [Option<f64>; 5]);

/// The data of a plot as CSV, SI and radians: a row for each point, bar, arrow or node, with what kind of thing it belongs
/// to and its name. Columns that nothing fills are left out; what has no value is an empty cell.
///
/// # Errors
/// [`Error::Output`].
pub fn figure_csv(figure: &Figure) -> Result<String> {
    let rows: Vec<Row<'_>> = figure.layers.iter().flat_map(|layer| rows(figure, layer)).collect();
    let [x, y] = [&figure.x, &figure.y].map(|axis| axis.measure.titled_si());
    let [x, y] = [(x, "x"), (y, "y")].map(|(title, letter)| if title.is_empty() { letter.into() } else { title });
    let value = figure.layers.iter().find_map(|layer| match layer {
        Layer::Contours(field) => Some(field.measure.titled_si()),
        _ => None,
    });
    let heads = [x.clone(), y.clone(), format!("to {x}"), format!("to {y}"), value.unwrap_or_default()];
    let is_filled = |column: &usize| rows.iter().any(|(.., numbers)| numbers[*column].is_some());
    let columns: Vec<usize> = (0..heads.len()).filter(is_filled).collect();

    let failed = |error: csv::Error| Error::Output(error.into());
    let mut writer = csv::Writer::from_writer(vec![]);
    let head = columns.iter().map(|column| heads[*column].as_str());
    writer.write_record(["kind", "name"].into_iter().chain(head)).map_err(failed)?;
    for (kind, name, numbers) in &rows {
        let cell = |column: &usize| {
            numbers[*column].filter(|number| number.is_finite()).map_or(String::new(), |number| format!("{number:?}"))
        };
        let cells = columns.iter().map(cell);
        writer.write_record([(*kind).to_owned(), (*name).to_owned()].into_iter().chain(cells)).map_err(failed)?;
    }
    let bytes = writer.into_inner().map_err(|error| Error::Output(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn rows<'a>(figure: &'a Figure, layer: &'a Layer) -> Vec<Row<'a>> {
    let point = |[x, y]: [f64; 2]| [Some(x), Some(y), None, None, None];
    let between = |[x, y]: [f64; 2], [to_x, to_y]: [f64; 2]| [Some(x), Some(y), Some(to_x), Some(to_y), None];
    match layer {
        Layer::Line { name, points, .. } => points.iter().map(|at| ("line", name.as_str(), point(*at))).collect(),
        Layer::Dots { name, points, .. } => points.iter().map(|at| ("dots", name.as_str(), point(*at))).collect(),
        Layer::Mark { name, at, .. } => vec![("mark", name, point(*at))],
        Layer::Band { name, points, .. } => {
            let row =
                |[x, low, high]: &[f64; 3]| ("band", name.as_str(), [Some(*x), Some(*low), None, Some(*high), None]);
            points.iter().map(row).collect()
        }
        Layer::Bars { name, bars, .. } => {
            let place = |place: usize| match &figure.y.scale {
                Scale::Names(names) => names.get(place).map_or(name.as_str(), String::as_str),
                _ => name,
            };
            bars.iter().map(|bar| ("bar", place(bar.place), [Some(bar.from), None, Some(bar.to), None, None])).collect()
        }
        Layer::Arrows { name, arrows, .. } => {
            arrows.iter().map(|[from, to]| ("arrow", name.as_str(), between(*from, *to))).collect()
        }
        Layer::Region { name, rings, .. } => {
            let row = |at: &[f64; 2]| ("region", name.as_str(), point(*at));
            // rings are parted by rows without numbers
            rings.join(&[f64::NAN; 2]).iter().map(row).collect()
        }
        Layer::Frame { name, low, high, .. } => vec![("frame", name, between(*low, *high))],
        Layer::Contours(field) => field
            .values
            .iter()
            .enumerate()
            .map(|(i, value)| {
                let [x, y] = field.place((i % field.columns) as f64, (i / field.columns) as f64);
                ("field", field.measure.label.as_str(), [Some(x), Some(y), None, None, *value])
            })
            .collect(),
    }
}
