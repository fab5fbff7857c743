use super::axis::{Axis, Scale};
use super::figure::{Bar, Field, Figure, Layer};
use crate::error::Result;
use crate::report::csv_text::csv_text;
use crate::units::TableUnits;

/// A row of the data.
struct Row<'a> {
    kind: &'static str,
    name: String,
    /// x and y, then x and y of the other end of a bar, an arrow or the width of a band.
    numbers: [Option<f64>; 4],
    /// The value at a node of a field. The field determines the column.
    value: Option<(&'a Field, f64)>,
}

/// The data of a plot as CSV, in SI and radians: a row for each point, bar, arrow or node, with the
/// kind and the name of its layer. Each quantity shown as contours has its own column. Empty
/// columns are omitted; a missing value is an empty cell. Views with contours have separate rows
/// with the name of the view.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output).
pub fn figure_csv(figure: &Figure) -> Result<String> {
    figure_csv_in(figure, TableUnits::Si)
}

/// The data of a plot as CSV in these units.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output).
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
    let columns = Columns::of(figure, &rows, units);
    let cells = rows.iter().map(|row| columns.cells(figure, row));
    csv_text(columns.heads().map(str::to_owned).collect(), cells)
}

/// The columns after kind and name.
struct Columns {
    units: TableUnits,
    /// The filled columns of [`Row::numbers`], with their heads.
    numbers: Vec<(usize, String)>,
    /// The column heads of the values of fields.
    values: Vec<String>,
}

impl Columns {
    fn of(figure: &Figure, rows: &[Row<'_>], units: TableUnits) -> Self {
        let head = |axis: &Axis, letter: &str| {
            let head = axis.measure.head(units);
            if head.is_empty() { letter.into() } else { head }
        };
        let [x, y] = [head(&figure.x, "x"), head(&figure.y, "y")];
        let heads = [x.clone(), y.clone(), format!("to {x}"), format!("to {y}")];
        let is_filled = |column: usize| rows.iter().any(|row| row.numbers[column].is_some());
        let mut values: Vec<String> = vec![];
        for row in rows {
            let head = row.value.map(|(field, _)| field.measure.head(units));
            values.extend(head.filter(|head| !values.contains(head)));
        }
        Self {
            units,
            numbers: (0..).zip(heads).filter(|(i, _)| is_filled(*i)).collect(),
            values,
        }
    }

    fn heads(&self) -> impl Iterator<Item = &str> {
        let numbers = self.numbers.iter().map(|(_, head)| head.as_str());
        let values = self.values.iter().map(String::as_str);
        ["kind", "name"].into_iter().chain(numbers).chain(values)
    }

    fn cells(&self, figure: &Figure, row: &Row<'_>) -> Vec<String> {
        let number = |(column, _): &(usize, String)| {
            let axis = [&figure.x, &figure.y][column % 2];
            axis.measure.cell(row.numbers[*column], self.units)
        };
        let value = |head: &String| match row.value {
            Some((field, value)) if field.measure.head(self.units) == *head => {
                field.measure.cell(Some(value), self.units)
            }
            _ => String::new(),
        };
        let mut cells = vec![row.kind.to_owned(), row.name.clone()];
        cells.extend(self.numbers.iter().map(number));
        cells.extend(self.values.iter().map(value));
        cells
    }
}

/// The rows of a layer. If the figure has several views, `of_view` is appended to the names.
fn rows<'a>(figure: &'a Figure, layer: &'a Layer, of_view: &str) -> Vec<Row<'a>> {
    let point = |[x, y]: [f64; 2]| [Some(x), Some(y), None, None];
    let row = |kind: &'static str, numbers: [Option<f64>; 4]| -> Row<'a> {
        Row {
            kind,
            name: format!("{}{of_view}", layer.named().0),
            numbers,
            value: None,
        }
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
            let one = |bar: &Bar| Row {
                kind: "bar",
                name: place(bar.place).to_owned(),
                numbers: [Some(0.0), None, Some(bar.to), None],
                value: None,
            };
            bars.iter().map(one).collect()
        }
        Layer::Arrows { arrows, .. } => arrows
            .iter()
            .map(|[from, to]| row("arrow", [from[0], from[1], to[0], to[1]].map(Some)))
            .collect(),
        Layer::Region { rings, .. } => {
            // a row without numbers separates two rings
            rings
                .join(&[f64::NAN; 2])
                .iter()
                .map(|at| row("region", point(*at)))
                .collect()
        }
        Layer::Contours(field) => {
            let one = |(i, value): (usize, &Option<f64>)| {
                let at = field.place((i % field.columns) as f64, (i / field.columns) as f64);
                Row {
                    value: Some((field, value.unwrap_or(f64::NAN))),
                    ..row("field", point(at))
                }
            };
            field.values.iter().enumerate().map(one).collect()
        }
    }
}
