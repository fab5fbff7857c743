//! The table of carry and total by loft and attack angle.

use crate::report::drive::total_uncertainty;
use crate::report::frame::{both, scrolled};
use crate::report::shown;
use crate::study::{LOFT_OUTCOMES, Plane};
use crate::units::{System, leading_number};
use maud::{Markup, html};

/// A row for each loft, a column for each attack angle; each cell has the carry, and the total
/// below it.
pub(super) fn lofts(plane: &Plane) -> Markup {
    let rows: Vec<usize> = (0..plane.rows).map(|row| row * plane.columns).collect();
    let unit = |system: System| match system {
        System::Metric => "metres".into(),
        System::Us => "yards".into(),
    };
    let first_row = 0..plane.columns;
    let longest: Vec<Option<usize>> = first_row
        .clone()
        .map(|column| longest(plane, &rows, column))
        .collect();
    html! {
        p.faint {
            "Carry, and below it the total, in " (both(unit)) "; everything else is as set up. Bold: \
             the longest carry of a column, if it is inside the table. A total is known to "
            (both(|system| total_uncertainty().in_units(system))) " at best."
        }
        (scrolled("Carry and total by loft and attack angle", html! { table.lofts {
            thead {
                tr {
                    th scope="col" rowspan="2" { "loft" }
                    th.number scope="colgroup" colspan=(plane.columns) { "attack angle" }
                }
                tr { @for node in first_row { th.number scope="col" { (angle(plane, node, 0)) } } }
            }
            tbody {
                @for row in &rows {
                    tr {
                        td { (angle(plane, *row, 1)) }
                        @for (column, longest) in longest.iter().enumerate() {
                            (cell(plane, row + column, *longest == Some(row + column)))
                        }
                    }
                }
            }
        } }))
    }
}

/// The node of the longest carry in a column. `None` if this node is in the first or last row,
/// because the carry may be longer beyond the table.
fn longest(plane: &Plane, rows: &[usize], column: usize) -> Option<usize> {
    let nodes = rows.iter().map(|row| row + column);
    let known = nodes.filter_map(|node| Some((node, plane.values[0][node]?)));
    known
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(node, _)| node)
        .filter(|node| (1..rows.len() - 1).contains(&(node / plane.columns)))
}

/// The attack angle (axis 0) or loft (axis 1) of a node: a whole number of degrees.
fn angle(plane: &Plane, node: usize, axis: usize) -> Markup {
    let parameter = [plane.across, plane.up][axis].parameter;
    let degrees = plane.node(node)[axis].to_degrees().round();
    both(|system| shown::stated(parameter, degrees.to_radians(), system))
}

fn cell(plane: &Plane, node: usize, is_longest: bool) -> Markup {
    let number = |i: usize| {
        both(|system| {
            let text = shown::outcome_or_dash(LOFT_OUTCOMES[i], plane.values[i][node], system);
            match leading_number(&text) {
                "" => text,
                number => number.into(),
            }
        })
    };
    html! {
        td.number {
            @if is_longest { strong { (number(0)) } } @else { (number(0)) }
            br;
            span.faint { (number(1)) }
        }
    }
}
