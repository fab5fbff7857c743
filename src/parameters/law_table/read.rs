//! The nodes of a table, parsed from the text of its file.

use super::super::number_table::{NumberRow, NumberTable, TableFault};
use super::super::range::Range;
use super::grid::LawVariable;
use crate::error::Error;
use crate::units::{DisplayUnit, Quantity};
use csv::StringRecord;

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
    pub speed: Option<LawVariable>,
    pub spin: Option<LawVariable>,
    pub rows: Vec<GridNode>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum LawColumnContent {
    Axis(LawVariable),
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
pub(super) fn nodes(text: &str) -> Result<GridNodes, TableFault> {
    let mut table = NumberTable::new(text, "speed [m/s]")?;
    let columns = columns(&table.heads)?;
    let axis = |is_of_spin: bool| {
        columns.iter().find_map(|column| match column.content {
            LawColumnContent::Axis(variable) if variable.is_of_spin() == is_of_spin => {
                Some(variable)
            }
            _ => None,
        })
    };
    let (speed, spin, mut rows) = (axis(false), axis(true), vec![]);
    while let Some(row) = table.next_row()? {
        if rows.len() == MOST_NODES {
            return Err(TableFault::of_file(format!(
                "it has more than {MOST_NODES} rows; give a coarser grid, since the law is smooth \
                 between its nodes"
            )));
        }
        rows.push(node(&mut table, &row, &columns)?);
    }
    Ok(GridNodes { speed, spin, rows })
}

fn node(
    table: &mut NumberTable<'_>,
    row: &NumberRow,
    columns: &[LawColumn],
) -> Result<GridNode, TableFault> {
    let mut node = GridNode {
        line: row.line,
        speed: 0.0,
        spin: 0.0,
        drag: 0.0,
        lift: 0.0,
    };
    for (at, column) in columns.iter().enumerate() {
        let number = table.number(row, at)?;
        let value = in_range(column, number * column.unit_size)
            .map_err(|reason| TableFault::in_cell(row.line, &column.head, reason))?;
        *match column.content {
            LawColumnContent::Axis(variable) if variable.is_of_spin() => &mut node.spin,
            LawColumnContent::Axis(_) => &mut node.speed,
            LawColumnContent::Drag => &mut node.drag,
            LawColumnContent::Lift => &mut node.lift,
        } = value;
    }
    Ok(node)
}

fn columns(heads: &StringRecord) -> Result<Vec<LawColumn>, TableFault> {
    let mut columns: Vec<LawColumn> = vec![];
    for (at, head) in heads.iter().enumerate() {
        let wrong = |reason: String| TableFault {
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
    Err(TableFault::of_file(format!(
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
        _ => match LawVariable::ALL
            .into_iter()
            .find(|variable| variable.column_names().contains(&small.as_str()))
        {
            Some(variable) => LawColumnContent::Axis(variable),
            None => {
                let names = LawVariable::ALL
                    .into_iter()
                    .flat_map(|variable| variable.column_names().iter().copied())
                    .chain(["cd", "cl"]);
                return Err(Error::unknown("column", name, names, COLUMNS).to_string());
            }
        },
    };
    let unit_size = match (content, unit) {
        (LawColumnContent::Axis(variable @ (LawVariable::Spin | LawVariable::Speed)), unit) => {
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

/// Checks that a value is physically possible.
fn in_range(column: &LawColumn, value: f64) -> Result<f64, String> {
    let range = match column.content {
        LawColumnContent::Axis(LawVariable::SpinRatio) => Range::from_to(0.0, 1e3),
        LawColumnContent::Axis(LawVariable::Spin) => Range::from_to(0.0, 1e5),
        LawColumnContent::Axis(LawVariable::Reynolds) => Range::above_to(0.0, 1e9),
        LawColumnContent::Axis(LawVariable::Speed) => Range::above_to(0.0, 1e3),
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
