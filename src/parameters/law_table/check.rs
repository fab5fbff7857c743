//! Whether nodes make a full grid, and the splines through it are a law.

use super::grid::{Along, Axis, Grid};
use super::read::{Node, Nodes, Wrong};
use super::surface::{Cell, Surface};

/// Below this spin ratio, slower spin than any drive has, a table that says nothing of the spin has
/// less lift, and none without spin.
const LIFT_BEGINS: f64 = 0.02;

/// Lines of a grid closer together than this, relative to the largest, are one line written in two
/// ways.
const SAME: f64 = 1e-9;

/// Beyond its ends an axis is held over this part of its outer step: half as far, the splines are
/// read off beyond their last node.
const OVER: f64 = 0.5;

/// The grid of some nodes.
pub(super) fn grid(nodes: &Nodes) -> Result<Grid, Wrong> {
    let rows = &nodes.rows;
    if rows.len() < 2 {
        let found = if rows.is_empty() {
            "no row"
        } else {
            "one row only"
        };
        return Err((
            String::new(),
            format!("it has {found}; a law needs at least two nodes along an axis"),
        ));
    }
    let across = lines(rows.iter().map(|node| node.speed), nodes.speed)?;
    let up = lines(rows.iter().map(|node| node.spin), nodes.spin)?;
    let places = places(nodes, &across, &up)?;
    let [drag, lift] = [|node: &Node| node.drag, |node: &Node| node.lift]
        .map(|number| places.iter().map(|node| number(node)).collect::<Vec<f64>>());
    if let Some(node) = rows
        .iter()
        .find(|node| nodes.spin.is_some() && node.spin == 0.0 && node.lift != 0.0)
    {
        let reason = format!(
            "cl is {} without spin, but then there is no lift; give 0, or leave out the rows \
             without spin",
            node.lift
        );
        return Err((format!(", line {}", node.line), reason));
    }
    let speed = nodes.speed.map(|along| axis(along, &across));
    let spin = nodes.spin.map(|along| axis(along, &up));
    let begins = match spin {
        Some(Axis { ends: [0.0, _], .. }) => None,
        Some(Axis {
            along,
            ends: [least, _],
            ..
        }) => Some((along, 1.0 / least)),
        None => Some((Along::SpinRatio, 1.0 / LIFT_BEGINS)),
    };
    let counts = [across.len(), up.len()];
    let surface = Surface::new(across, up, [&drag, &lift]);
    check_between(&surface, counts, nodes)?;
    Ok(Grid {
        speed,
        spin,
        begins,
        surface,
    })
}

/// The lines of a grid along an axis, rising.
fn lines(values: impl Iterator<Item = f64>, along: Option<Along>) -> Result<Vec<f64>, Wrong> {
    let mut lines: Vec<f64> = values.collect();
    lines.sort_by(f64::total_cmp);
    lines.dedup();
    let most = lines.last().copied().unwrap_or_default();
    let close = lines
        .windows(2)
        .find(|pair| pair[1] - pair[0] <= SAME * most);
    if let (Some(pair), Some(along)) = (close, along) {
        let (name, si) = (along.names()[0], along.quantity().0.si);
        let both = format!("{name} {:?} and {:?} {si}", pair[0], pair[1]);
        let reason = format!(
            "{} are nearly the same; write one number for both",
            both.trim_end()
        );
        return Err((String::new(), reason));
    }
    Ok(lines)
}

/// The nodes row by row: one at each crossing of the lines.
fn places<'a>(nodes: &'a Nodes, across: &[f64], up: &[f64]) -> Result<Vec<&'a Node>, Wrong> {
    // each axis has at most as many lines as there are rows; but not both
    let size = across.len().saturating_mul(up.len());
    let mut sorted: Vec<&Node> = nodes.rows.iter().collect();
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
        return Err((format!(", line {}", twice[1].line), reason));
    }
    if sorted.len() < size {
        let nodes_at = (0..size).map(|i| (up[i / across.len()], across[i % across.len()]));
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
            across.len(),
            up.len(),
            crate::units::counted((size - sorted.len()) as u64, "hole"),
            place(nodes, speed, spin)
        );
        return Err((String::new(), reason));
    }
    Ok(sorted)
}

/// An axis with its ends, and how far it is held beyond them.
fn axis(along: Along, lines: &[f64]) -> Axis {
    let last = lines.len() - 1;
    // where nothing changes along it, it does not matter
    let over = if last == 0 {
        [1.0; 2]
    } else {
        [lines[1] - lines[0], lines[last] - lines[last - 1]].map(|step| OVER * step)
    };
    Axis {
        along,
        ends: [lines[0], lines[last]],
        over,
    }
}

/// The splines are finite, and drag is nowhere below 0 between the nodes, nor beyond them as far as
/// they are read off.
fn check_between(
    surface: &Surface,
    [columns, rows]: [usize; 2],
    nodes: &Nodes,
) -> Result<(), Wrong> {
    const FINE: usize = 8;
    let [wide, high] = [columns, rows].map(|count| count.saturating_sub(1).max(1));
    for (i, cell) in surface.cells().iter().enumerate() {
        if !cell.iter().all(|number| number.is_finite()) {
            return Err((
                String::new(),
                "its numbers differ too much for a smooth curve through them; check the columns"
                    .into(),
            ));
        }
        // the coefficients bound what is between: most cells need no closer look
        let swing: f64 = cell[5..20].iter().map(|number| number.abs()).sum();
        if cell[4] > 4.0 * swing {
            continue;
        }
        // no spin and no speed is below 0, which is at `none`
        let places = |at: usize, count: usize, none: f64| {
            let under = if at == 0 && count > 1 {
                Some((-0.5 * OVER).max(none))
            } else {
                None
            };
            let above = if at + 2 >= count && count > 1 {
                Some(1.0 + 0.5 * OVER)
            } else {
                None
            };
            under
                .into_iter()
                .chain((0..=FINE).map(|k| k as f64 / FINE as f64))
                .chain(above)
        };
        for u in places(i % wide, columns, -cell[0] * cell[1]) {
            for w in places(i / wide % high, rows, -cell[2] * cell[3]) {
                let found = drag(cell, u, w);
                if found < -1e-12 {
                    let end = |corner: f64, per: f64, part: f64| {
                        if per > 0.0 {
                            corner + part / per
                        } else {
                            corner
                        }
                    };
                    let at = place(nodes, end(cell[0], cell[1], u), end(cell[2], cell[3], w));
                    let reason = format!(
                        "the smooth curve through its nodes has a negative drag, cd = {found:.3}, \
                         at {at}; give more nodes there"
                    );
                    return Err((String::new(), reason));
                }
            }
        }
    }
    Ok(())
}

/// C_D at a place in a cell.
fn drag(cell: &Cell, u: f64, w: f64) -> f64 {
    let along = |power: usize| {
        (0..4)
            .rev()
            .fold(0.0, |sum, k| sum * w + cell[4 + 4 * power + k])
    };
    (0..4).rev().fold(0.0, |sum, power| sum * u + along(power))
}

/// A place in the words of the table: "spin_ratio 0.1, reynolds 150000".
fn place(nodes: &Nodes, speed: f64, spin: f64) -> String {
    let axes = [(nodes.spin, spin), (nodes.speed, speed)];
    let told: Vec<String> = axes
        .iter()
        .filter_map(|(along, value)| Some(told((*along)?, *value)))
        .collect();
    told.join(", ")
}

fn told(along: Along, value: f64) -> String {
    let (quantity, unit) = along.quantity();
    format!("{} {}", along.names()[0], quantity.show(value, unit))
}
