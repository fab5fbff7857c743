//! Checks that the nodes form a full grid, and that the splines through them are finite and have no
//! negative drag.

use super::super::number_table::TableFault;
use super::grid::{CoefficientGrid, LawTableAxis, LawVariable};
use super::read::{GridNode, GridNodes};
use super::surface::{Cell, DRAG_START, LIFT_START, Surface, bicubic, cells, intervals};

/// Spin ratio below which the lift falls smoothly to 0, if the table has no axis of spin or spin
/// ratio. Usual drives have larger spin ratios: 0.08 at 72 m/s and 2500 rpm.
const FULL_LIFT: f64 = 0.02;

/// Smallest allowed distance between two lines of the grid, relative to the largest value. Closer
/// lines are refused: they are different roundings of one line.
const LEAST_DISTANCE: f64 = 1e-9;

/// Width of the smooth clamp beyond the ends of an axis, as a fraction of the outermost interval.
/// The splines are evaluated up to half this width beyond the last node.
const CLAMP_WIDTH: f64 = 0.5;

/// Upper bound of |u|ᵃ |w|ᵇ for exponents a, b ≤ 3 and the coordinates u, w of a cell or of the
/// clamps beside it. |u| and |w| are at most 1 + [`CLAMP_WIDTH`]/2 = 1.25, and 1.25⁶ = 3.8.
const LARGEST_POWER: f64 = 4.0;

/// Checks the nodes, and makes the grid with its splines.
pub(super) fn grid(nodes: &GridNodes) -> Result<CoefficientGrid, TableFault> {
    let rows = &nodes.rows;
    if rows.len() < 2 {
        let found = if rows.is_empty() {
            "no row"
        } else {
            "one row only"
        };
        return Err(TableFault::of_file(format!(
            "it has {found}; a law needs at least two nodes along an axis"
        )));
    }
    let speeds = grid_lines(rows.iter().map(|node| node.speed), nodes.speed)?;
    let spins = grid_lines(rows.iter().map(|node| node.spin), nodes.spin)?;
    let sorted = full_grid(nodes, &speeds, &spins)?;
    let drag: Vec<f64> = sorted.iter().map(|node| node.drag).collect();
    let lift: Vec<f64> = sorted.iter().map(|node| node.lift).collect();
    if let Some(node) = rows
        .iter()
        .find(|node| nodes.spin.is_some() && node.spin == 0.0 && node.lift != 0.0)
    {
        let reason = format!(
            "cl is {} without spin, but then there is no lift; give 0, or leave out the rows \
             without spin",
            node.lift
        );
        return Err(TableFault::at_line(node.line, reason));
    }
    let speed = nodes.speed.map(|variable| axis(variable, &speeds));
    let spin = nodes.spin.map(|variable| axis(variable, &spins));
    let lift_onset = match spin {
        Some(LawTableAxis { ends: [0.0, _], .. }) => None,
        Some(LawTableAxis {
            variable,
            ends: [least, _],
            ..
        }) => Some((variable, 1.0 / least)),
        None => Some((LawVariable::SpinRatio, 1.0 / FULL_LIFT)),
    };
    let counts = [speeds.len(), spins.len()];
    let cells = cells(&speeds, &spins, [&drag, &lift]);
    check_between_nodes(&cells, counts, nodes)?;
    // leaked only after all checks, so that a refused table leaks no memory
    let surface = Surface::new(speeds.leak(), spins.leak(), cells.leak());
    Ok(CoefficientGrid {
        speed,
        spin,
        lift_onset,
        surface,
    })
}

/// The lines of the grid along an axis, in ascending order.
fn grid_lines(
    values: impl Iterator<Item = f64>,
    variable: Option<LawVariable>,
) -> Result<Vec<f64>, TableFault> {
    let mut lines: Vec<f64> = values.collect();
    lines.sort_by(f64::total_cmp);
    lines.dedup();
    let most = lines.last().copied().unwrap_or_default();
    let close = lines
        .windows(2)
        .find(|pair| pair[1] - pair[0] <= LEAST_DISTANCE * most);
    if let (Some(pair), Some(variable)) = (close, variable) {
        let (name, si) = (
            variable.column_names()[0],
            variable.display_unit().quantity.si,
        );
        let both = format!("{name} {:?} and {:?} {si}", pair[0], pair[1]);
        let reason = format!(
            "{} are nearly the same; write one number for both",
            both.trim_end()
        );
        return Err(TableFault::of_file(reason));
    }
    Ok(lines)
}

/// Sorts the nodes row by row, and checks that each crossing of the lines has exactly one node.
fn full_grid<'a>(
    nodes: &'a GridNodes,
    speeds: &[f64],
    spins: &[f64],
) -> Result<Vec<&'a GridNode>, TableFault> {
    // each axis can have as many lines as there are rows, so that the product can overflow 32 bits
    let size = speeds.len().saturating_mul(spins.len());
    let mut sorted: Vec<&GridNode> = nodes.rows.iter().collect();
    sorted.sort_by(|a, b| {
        a.spin
            .total_cmp(&b.spin)
            .then(a.speed.total_cmp(&b.speed))
            .then(a.line.cmp(&b.line))
    });
    if let Some(twice) = sorted
        .windows(2)
        .find(|pair| (pair[0].spin, pair[0].speed) == (pair[1].spin, pair[1].speed))
    {
        let reason = format!(
            "the node {} is given twice, here and at line {}; keep one",
            place(nodes, twice[1].speed, twice[1].spin),
            twice[0].line
        );
        return Err(TableFault::at_line(twice[1].line, reason));
    }
    if sorted.len() < size {
        let nodes_at = (0..size).map(|i| (spins[i / speeds.len()], speeds[i % speeds.len()]));
        let missing = nodes_at.zip(
            sorted
                .iter()
                .map(|node| Some((node.spin, node.speed)))
                .chain(std::iter::repeat(None)),
        );
        let first = missing
            .into_iter()
            .find(|(wanted, found)| Some(*wanted) != *found)
            .map(|(wanted, _)| wanted);
        let (spin, speed) = first.unwrap_or_default();
        let reason = format!(
            "the grid of {} by {} nodes has {}: the first is {}; give every node a row, or leave \
             out the lines of the grid that are not full",
            speeds.len(),
            spins.len(),
            crate::units::counted((size - sorted.len()) as u64, "hole"),
            place(nodes, speed, spin)
        );
        return Err(TableFault::of_file(reason));
    }
    Ok(sorted)
}

fn axis(variable: LawVariable, lines: &[f64]) -> LawTableAxis {
    let last = lines.len() - 1;
    // with a single line the surface is constant, and the width has no effect
    let over = if last == 0 {
        [1.0; 2]
    } else {
        [lines[1] - lines[0], lines[last] - lines[last - 1]].map(|step| CLAMP_WIDTH * step)
    };
    LawTableAxis {
        variable,
        ends: [lines[0], lines[last]],
        over,
    }
}

/// Checks that the splines are finite, and that the drag is not negative between the nodes and in
/// the clamps beyond the outermost nodes.
fn check_between_nodes(
    cells: &[Cell],
    [columns, rows]: [usize; 2],
    nodes: &GridNodes,
) -> Result<(), TableFault> {
    let wide = intervals(columns);
    for (i, cell) in cells.iter().enumerate() {
        if !cell.iter().all(|number| number.is_finite()) {
            return Err(TableFault::of_file(
                "its numbers differ too much for a smooth curve through them; check the columns"
                    .into(),
            ));
        }
        // most cells need no samples: the constant term is larger than all other terms together
        let variation: f64 = cell[DRAG_START + 1..LIFT_START]
            .iter()
            .map(|number| number.abs())
            .sum();
        if cell[DRAG_START] > LARGEST_POWER * variation {
            continue;
        }
        for u in samples(i % wide, columns, -cell[0] * cell[1]) {
            for w in samples(i / wide, rows, -cell[2] * cell[3]) {
                let found = bicubic(cell, DRAG_START, u, w);
                if found < -1e-12 {
                    return Err(negative_drag(cell, [u, w], found, nodes));
                }
            }
        }
    }
    Ok(())
}

/// Coordinates along one direction of a cell at which the drag is sampled: from 0 to 1, and one
/// coordinate in the clamp beside the cell if it is the first or the last cell of the grid. `at` is
/// the index of the cell's first line among `count` lines. `zero` is the coordinate of zero speed
/// or spin; no sample is below `zero`.
fn samples(at: usize, count: usize, zero: f64) -> impl Iterator<Item = f64> {
    const INTERVALS: usize = 8;
    let below = if at == 0 && count > 1 {
        Some((-0.5 * CLAMP_WIDTH).max(zero))
    } else {
        None
    };
    let above = if at + 2 >= count && count > 1 {
        Some(1.0 + 0.5 * CLAMP_WIDTH)
    } else {
        None
    };
    below
        .into_iter()
        .chain((0..=INTERVALS).map(|k| k as f64 / INTERVALS as f64))
        .chain(above)
}

fn negative_drag(cell: &Cell, [u, w]: [f64; 2], drag: f64, nodes: &GridNodes) -> TableFault {
    let coordinate = |corner: f64, per: f64, part: f64| {
        if per > 0.0 {
            corner + part / per
        } else {
            corner
        }
    };
    let speed = coordinate(cell[0], cell[1], u);
    let spin = coordinate(cell[2], cell[3], w);
    TableFault::of_file(format!(
        "the smooth curve through its nodes has a negative drag, cd = {drag:.3}, at {}; give more \
         nodes there",
        place(nodes, speed, spin)
    ))
}

/// A node as text: "spin_ratio 0.1, reynolds 150000".
fn place(nodes: &GridNodes, speed: f64, spin: f64) -> String {
    [(nodes.spin, spin), (nodes.speed, speed)]
        .into_iter()
        .filter_map(|(variable, value)| {
            let variable = variable?;
            let shown = variable.display_unit().show(value);
            Some(format!("{} {shown}", variable.column_names()[0]))
        })
        .collect::<Vec<_>>()
        .join(", ")
}
