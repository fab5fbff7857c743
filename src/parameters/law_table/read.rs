//! The nodes of a table, parsed from the text of its file.

use super::super::range::Range;
use super::grid::AxisVariable;
use crate::csv_dialect::detect_separator;
use crate::error::Error;
use crate::external_errors::csv_row_error_text;
use crate::units::{DisplayUnit, Quantity};
use csv::{ReaderBuilder, StringRecord, Trim};

/// A fault of a table.
pub(super) struct LawTableFault {
    /// Place in the file, which follows the name of the file in a message: ", line 3, column cd".
    /// Empty for the whole file.
    pub place: String,
    pub reason: String,
}

impl LawTableFault {
    /// A fault of the whole file.
    pub fn of_file(reason: String) -> Self {
        Self {
            place: String::new(),
            reason,
        }
    }

    /// A fault of a line.
    pub fn at_line(line: u64, reason: String) -> Self {
        Self {
            place: format!(", line {line}"),
            reason,
        }
    }
}

/// Largest number of nodes. The limit bounds the memory of the splines; no measurement has as many
/// nodes.
const MOST_NODES: usize = 200_000;

/// A row of the table.
pub(super) struct GridNode {
    pub line: u64,
    /// Coordinates on the axes of speed and spin, SI; 0 if the table does not have the axis.
    pub speed: f64,
    pub spin: f64,
    pub drag: f64,
    pub lift: f64,
}

/// The rows of a table, and the variables of its axes.
pub(super) struct GridNodes {
    pub speed: Option<AxisVariable>,
    pub spin: Option<AxisVariable>,
    pub rows: Vec<GridNode>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum LawColumnContent {
    Axis(AxisVariable),
    Drag,
    Lift,
}

struct LawColumn {
    /// Column head as written in the file.
    head: String,
    content: LawColumnContent,
    /// Factor that converts the column's numbers to SI.
    unit_size: f64,
}

const COLUMNS: &str = "the columns are cd, cl, spin_ratio (or s) or spin [rpm], and reynolds (or \
                       re) or speed [m/s]; one of these two axes may be left out";

/// Parses the text of a table.
pub(super) fn nodes(text: &str) -> Result<GridNodes, LawTableFault> {
    let (separator, rest) = detect_separator(text);
    let skipped = text[..text.len() - rest.len()].matches('\n').count() as u64;
    let mut reader = ReaderBuilder::new()
        .trim(Trim::All)
        .comment(Some(b'#'))
        .delimiter(separator)
        .from_reader(rest.as_bytes());
    let line = |record: Option<&csv::Position>| record.map_or(0, csv::Position::line) + skipped;
    let unreadable = |error: &csv::Error| {
        let reason = csv_row_error_text(error, text.as_bytes());
        LawTableFault::at_line(line(error.position()), reason)
    };
    let heads = reader
        .headers()
        .map_err(|error| unreadable(&error))?
        .clone();
    let columns = columns(&heads)?;
    let axis = |is_of_spin: bool| {
        columns.iter().find_map(|column| match column.content {
            LawColumnContent::Axis(variable) if variable.is_of_spin() == is_of_spin => {
                Some(variable)
            }
            _ => None,
        })
    };
    let (speed, spin, mut rows) = (axis(false), axis(true), vec![]);
    let mut marks = DecimalMarks {
        separator,
        first: None,
    };
    for record in reader.records() {
        let record = record.map_err(|error| unreadable(&error))?;
        // spreadsheets end a table with rows of empty cells
        if record.iter().all(str::is_empty) {
            continue;
        }
        if rows.len() == MOST_NODES {
            return Err(LawTableFault::of_file(format!(
                "it has more than {MOST_NODES} rows; give a coarser grid, since the law is smooth \
                 between its nodes"
            )));
        }
        rows.push(node(
            &record,
            &columns,
            line(record.position()),
            &mut marks,
        )?);
    }
    Ok(GridNodes { speed, spin, rows })
}

fn node(
    record: &StringRecord,
    columns: &[LawColumn],
    line: u64,
    marks: &mut DecimalMarks,
) -> Result<GridNode, LawTableFault> {
    let mut node = GridNode {
        line,
        speed: 0.0,
        spin: 0.0,
        drag: 0.0,
        lift: 0.0,
    };
    for (column, cell) in columns.iter().zip(record.iter()) {
        let value = marks
            .number(cell)
            .and_then(|value| in_range(column, value * column.unit_size))
            .map_err(|reason| LawTableFault {
                place: format!(", line {line}, column {}", column.head),
                reason,
            })?;
        *match column.content {
            LawColumnContent::Axis(variable) if variable.is_of_spin() => &mut node.spin,
            LawColumnContent::Axis(_) => &mut node.speed,
            LawColumnContent::Drag => &mut node.drag,
            LawColumnContent::Lift => &mut node.lift,
        } = value;
    }
    Ok(node)
}

fn columns(heads: &StringRecord) -> Result<Vec<LawColumn>, LawTableFault> {
    let mut columns: Vec<LawColumn> = vec![];
    for (at, head) in heads.iter().enumerate() {
        let wrong = |reason: String| LawTableFault {
            place: format!(", column {}", at + 1),
            reason,
        };
        let column = column(head).map_err(wrong)?;
        let is_same = |other: &&LawColumn| match (other.content, column.content) {
            (LawColumnContent::Axis(a), LawColumnContent::Axis(b)) => {
                a.is_of_spin() == b.is_of_spin()
            }
            (a, b) => a == b,
        };
        if let Some(other) = columns.iter().find(is_same) {
            let reason = format!(
                "'{}' and '{head}' give the same axis or number twice; keep one",
                other.head
            );
            return Err(wrong(reason));
        }
        columns.push(column);
    }
    let has = |content: LawColumnContent| columns.iter().any(|column| column.content == content);
    let missing = match columns
        .iter()
        .any(|column| matches!(column.content, LawColumnContent::Axis(_)))
    {
        _ if !has(LawColumnContent::Drag) => "cd",
        _ if !has(LawColumnContent::Lift) => "cl",
        false => "spin_ratio, spin, reynolds or speed",
        true => return Ok(columns),
    };
    Err(LawTableFault::of_file(format!(
        "it has no column {missing}; {COLUMNS}"
    )))
}

/// Parses a column head, such as `speed [m/s]`.
fn column(head: &str) -> Result<LawColumn, String> {
    let (name, unit) = match head.split_once(['[', '(']) {
        Some((name, unit)) => (
            name.trim(),
            Some(unit.trim().trim_end_matches([']', ')']).trim()),
        ),
        None => (head.trim(), None),
    };
    let small = name.to_lowercase();
    let content = match small.as_str() {
        "cd" => LawColumnContent::Drag,
        "cl" => LawColumnContent::Lift,
        _ => match AxisVariable::ALL
            .into_iter()
            .find(|variable| variable.names().contains(&small.as_str()))
        {
            Some(variable) => LawColumnContent::Axis(variable),
            None => {
                let names = AxisVariable::ALL
                    .into_iter()
                    .flat_map(|variable| variable.names().iter().copied())
                    .chain(["cd", "cl"]);
                return Err(Error::unknown("column", name, names, COLUMNS).to_string());
            }
        },
    };
    let unit_size = match (content, unit) {
        (LawColumnContent::Axis(variable @ (AxisVariable::Spin | AxisVariable::Speed)), unit) => {
            let DisplayUnit {
                quantity,
                unit: usual,
            } = variable.display_unit();
            let Some(unit) = unit else {
                return Err(format!(
                    "'{head}' has no unit; write it into the head, as in '{name} [{usual}]'"
                ));
            };
            let size = quantity.size_of(unit);
            size.ok_or_else(|| {
                format!(
                    "'{unit}' is no unit of {}; take one of {}",
                    quantity.name,
                    quantity.units()
                )
            })?
        }
        (_, Some(unit)) if !unit.is_empty() => {
            return Err(format!(
                "'{head}' has a unit, but {name} is a plain number; take [{unit}] out of the head"
            ));
        }
        _ => 1.0,
    };
    Ok(LawColumn {
        head: head.into(),
        content,
        unit_size,
    })
}

/// Decimal marks of a table: points, or commas if a comma does not separate cells. A table with
/// both marks is refused, because one of them may separate thousands.
struct DecimalMarks {
    /// Cell separator.
    separator: u8,
    /// The first cell with a mark.
    first: Option<String>,
}

impl DecimalMarks {
    /// Parses a number.
    fn number(&mut self, cell: &str) -> Result<f64, String> {
        if cell.is_empty() {
            return Err("the cell is empty; every row needs a value".into());
        }
        let mut plain = cell.replace('\u{2212}', "-");
        if self.separator != b',' {
            self.check(cell)?;
            plain = plain.replacen(',', ".", 1);
        }
        match plain.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) => Err(format!("'{cell}' is not finite; give a number")),
            Err(_) => Err(format!(
                "'{cell}' is not a number; a unit is written in the head, as in 'speed [m/s]'"
            )),
        }
    }

    /// Refuses a cell whose decimal mark differs from the first mark in the table.
    fn check(&mut self, cell: &str) -> Result<(), String> {
        let mark_of = |cell: &str| [',', '.'].into_iter().find(|mark| cell.contains(*mark));
        let Some(mark) = mark_of(cell) else {
            return Ok(());
        };
        let first = self.first.get_or_insert_with(|| cell.into());
        if mark_of(first) == Some(mark) {
            return Ok(());
        }
        let [own, other] = if mark == ',' {
            ["comma", "point"]
        } else {
            ["point", "comma"]
        };
        Err(format!(
            "'{cell}' has a {own}, but '{first}' has a {other}; write all decimals of the table \
             with the same mark, and nothing between thousands"
        ))
    }
}

/// Checks that a value is physically possible.
fn in_range(column: &LawColumn, value: f64) -> Result<f64, String> {
    let range = match column.content {
        LawColumnContent::Axis(AxisVariable::SpinRatio) => Range::from_to(0.0, 1e3),
        LawColumnContent::Axis(AxisVariable::Spin) => Range::from_to(0.0, 1e5),
        LawColumnContent::Axis(AxisVariable::Reynolds) => Range::above_to(0.0, 1e9),
        LawColumnContent::Axis(AxisVariable::Speed) => Range::above_to(0.0, 1e3),
        LawColumnContent::Drag => Range::from_to(0.0, 100.0),
        LawColumnContent::Lift => Range::from_to(-100.0, 100.0),
    };
    if range.contains(value) {
        return Ok(value);
    }
    let quantity = match column.content {
        LawColumnContent::Axis(variable) => variable.display_unit().quantity,
        LawColumnContent::Drag | LawColumnContent::Lift => Quantity::NUMBER,
    };
    let [value, least, most] =
        [value, range.low, range.high].map(|value| quantity.show(value, quantity.si));
    let begins = if range.low_included {
        "at least"
    } else {
        "more than"
    };
    Err(format!(
        "{value} is outside of its range, {begins} {least} and at most {most}; check the number, \
         and the unit in the head"
    ))
}
