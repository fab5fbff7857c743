//! The nodes of a table as its file has them.

use super::grid::Along;
use crate::csv_dialect::detect_separator;
use crate::error::Error;
use crate::external_errors::csv_row_error_text;
use crate::units::Quantity;
use csv::{ReaderBuilder, StringRecord, Trim};

/// What is wrong, and where: ", line 3, column cd", or nothing for the whole file.
pub(super) type Wrong = (String, String);

/// A table is read as a whole, and its splines are held in memory: no one measures more nodes.
const MOST_NODES: usize = 200_000;

/// A row.
pub(super) struct Node {
    pub line: u64,
    /// Its places on the axes of speed and spin, SI; 0 where there is no such axis.
    pub speed: f64,
    pub spin: f64,
    pub drag: f64,
    pub lift: f64,
}

/// The rows of a table, and what it goes along.
pub(super) struct Nodes {
    pub speed: Option<Along>,
    pub spin: Option<Along>,
    pub rows: Vec<Node>,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Holds {
    Place(Along),
    Drag,
    Lift,
}

/// A column: its head as written, what it holds, and one of its unit, SI.
struct Column {
    head: String,
    holds: Holds,
    one: f64,
}

const COLUMNS: &str = "the columns are cd, cl, spin_ratio (or s) or spin [rpm], and reynolds (or \
                       re) or speed [m/s]; one of these two axes may be left out";

/// Reads the text of a table.
pub(super) fn nodes(text: &str) -> Result<Nodes, Wrong> {
    let (separator, rest) = detect_separator(text);
    let skipped = text[..text.len() - rest.len()].matches('\n').count() as u64;
    let mut reader = ReaderBuilder::new()
        .trim(Trim::All)
        .comment(Some(b'#'))
        .delimiter(separator)
        .from_reader(rest.as_bytes());
    let line = |record: Option<&csv::Position>| record.map_or(0, csv::Position::line) + skipped;
    let unreadable = |error: &csv::Error| {
        (
            format!(", line {}", line(error.position())),
            csv_row_error_text(error, text.as_bytes()),
        )
    };
    let heads = reader
        .headers()
        .map_err(|error| unreadable(&error))?
        .clone();
    let columns = columns(&heads)?;
    let axis = |of_spin: bool| {
        columns.iter().find_map(|column| match column.holds {
            Holds::Place(along) if along.is_of_spin() == of_spin => Some(along),
            _ => None,
        })
    };
    let (speed, spin, mut rows) = (axis(false), axis(true), vec![]);
    for record in reader.records() {
        let record = record.map_err(|error| unreadable(&error))?;
        // a row of empty cells ends what spreadsheets write
        if record.iter().all(str::is_empty) {
            continue;
        }
        let line = line(record.position());
        if rows.len() == MOST_NODES {
            return Err((
                String::new(),
                format!(
                    "it has more than {MOST_NODES} rows; give a coarser grid, since the law is \
                     smooth between its nodes"
                ),
            ));
        }
        let mut node = Node {
            line,
            speed: 0.0,
            spin: 0.0,
            drag: 0.0,
            lift: 0.0,
        };
        for (column, cell) in columns.iter().zip(record.iter()) {
            let wrong = |reason| (format!(", line {line}, column {}", column.head), reason);
            let value = number(cell, separator)
                .and_then(|value| in_range(column, value * column.one))
                .map_err(wrong)?;
            *match column.holds {
                Holds::Place(along) if along.is_of_spin() => &mut node.spin,
                Holds::Place(_) => &mut node.speed,
                Holds::Drag => &mut node.drag,
                Holds::Lift => &mut node.lift,
            } = value;
        }
        rows.push(node);
    }
    Ok(Nodes { speed, spin, rows })
}

/// The columns by their heads.
fn columns(heads: &StringRecord) -> Result<Vec<Column>, Wrong> {
    let mut columns: Vec<Column> = vec![];
    for (at, head) in heads.iter().enumerate() {
        let column = column(head).map_err(|reason| (format!(", column {}", at + 1), reason))?;
        let is_same = |other: &&Column| match (other.holds, column.holds) {
            (Holds::Place(a), Holds::Place(b)) => a.is_of_spin() == b.is_of_spin(),
            (a, b) => a == b,
        };
        if let Some(other) = columns.iter().find(is_same) {
            let reason = format!(
                "'{}' and '{head}' give the same axis or number twice; keep one",
                other.head
            );
            return Err((format!(", column {}", at + 1), reason));
        }
        columns.push(column);
    }
    let has = |holds: Holds| columns.iter().any(|column| column.holds == holds);
    let missing = match columns
        .iter()
        .any(|column| matches!(column.holds, Holds::Place(_)))
    {
        _ if !has(Holds::Drag) => "cd",
        _ if !has(Holds::Lift) => "cl",
        false => "spin_ratio, spin, reynolds or speed",
        true => return Ok(columns),
    };
    Err((
        String::new(),
        format!("it has no column {missing}; {COLUMNS}"),
    ))
}

/// A column by its head, `speed [m/s]`.
fn column(head: &str) -> Result<Column, String> {
    let (name, unit) = match head.split_once(['[', '(']) {
        Some((name, unit)) => (
            name.trim(),
            Some(unit.trim().trim_end_matches([']', ')']).trim()),
        ),
        None => (head.trim(), None),
    };
    let small = name.to_lowercase();
    let holds = match small.as_str() {
        "cd" => Holds::Drag,
        "cl" => Holds::Lift,
        _ => match Along::ALL
            .into_iter()
            .find(|along| along.names().contains(&small.as_str()))
        {
            Some(along) => Holds::Place(along),
            None => {
                let names = Along::ALL
                    .into_iter()
                    .flat_map(|along| along.names().iter().copied())
                    .chain(["cd", "cl"]);
                return Err(Error::unknown("column", name, names, COLUMNS).to_string());
            }
        },
    };
    let one = match (holds, unit) {
        (Holds::Place(along @ (Along::Spin | Along::Speed)), unit) => {
            let (quantity, usual) = along.quantity();
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
    Ok(Column {
        head: head.into(),
        holds,
        one,
    })
}

/// A number, with a decimal comma where that separates no cells.
fn number(cell: &str, separator: u8) -> Result<f64, String> {
    if cell.is_empty() {
        return Err("the cell is empty; every row needs a value".into());
    }
    let mut plain = cell.replace('\u{2212}', "-");
    if separator != b',' && !plain.contains('.') {
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

/// Whether a value is possible.
fn in_range(column: &Column, value: f64) -> Result<f64, String> {
    let (least, most, is_least_in) = match column.holds {
        Holds::Place(Along::SpinRatio) => (0.0, 1e3, true),
        Holds::Place(Along::Spin) => (0.0, 1e5, true),
        Holds::Place(Along::Reynolds) => (0.0, 1e9, false),
        Holds::Place(Along::Speed) => (0.0, 1e3, false),
        Holds::Drag => (0.0, 100.0, true),
        Holds::Lift => (-100.0, 100.0, true),
    };
    if (least..=most).contains(&value) && (is_least_in || value > least) {
        return Ok(value);
    }
    let quantity = match column.holds {
        Holds::Place(along) => along.quantity().0,
        Holds::Drag | Holds::Lift => Quantity::NUMBER,
    };
    let [value, least, most] = [value, least, most].map(|value| quantity.show(value, quantity.si));
    let begins = if is_least_in { "at least" } else { "more than" };
    Err(format!(
        "{value} is outside of its range, {begins} {least} and at most {most}; check the number, \
         and the unit in the head"
    ))
}
