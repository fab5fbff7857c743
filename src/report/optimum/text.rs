//! An optimum, or the optima of several starts, for readers.

use super::super::document::{Detail, Document, DocumentBlock, DocumentTable, Line};
use super::super::limits::{Objective, ended_at, limited_value};
use super::super::shown;
use super::super::swings::{goals, nominal, notes};
use super::best_drive::{drive_lines, gain_lines};
use super::bounds::bound_in_words;
use super::windows::window_lines;
use crate::optimize::{Iteration, Status};
use crate::study::swings::{Nominal, SwingsAnalysis};
use crate::study::{Optima, Optimum, OptimumWindows, Sample, Search};
use crate::units::{DisplayUnit, System, counted, counted_of, fixed, with_unit};

/// One optimum for readers: the result first, the convergence last. If the search did not converge,
/// its status is first. If the objective has no value, the document has only the status.
pub(in crate::report) fn optimum_document(
    optimum: &Optimum,
    analysis: Option<&SwingsAnalysis>,
    around: Option<&OptimumWindows<'_>>,
    system: System,
) -> Document {
    let mut document = Document::default();
    let is_converged = optimum.is_converged();
    if !is_converged {
        let ended = ended_line(optimum, system);
        let sample = optimum.value().and_then(|_| sample_line(optimum));
        document.list([ended].into_iter().chain(sample));
    }
    let Some(value) = optimum.value() else {
        return document;
    };
    if let Some(drive) = &optimum.drive {
        if is_converged {
            document.list(gain_lines(optimum, drive, system));
        }
        add_varied_and_constraints(&mut document, optimum, around, system);
        document.list(drive_lines(optimum, value, drive, system));
    } else {
        document.add(goals(optimum, analysis, system));
        document.add(varied_table(optimum, nominal(analysis), system));
        add_constraints(&mut document, optimum, system);
        document.list(notes(optimum, analysis, system));
    }
    if is_converged {
        add_convergence(&mut document, optimum, system);
    }
    document
}

/// For the optimum of a single drive: adds the varied parameters with remarks on the windows,
/// and the constraints.
pub(in crate::report) fn add_varied_and_constraints(
    document: &mut Document,
    optimum: &Optimum,
    around: Option<&OptimumWindows<'_>>,
    system: System,
) {
    let mut table = varied_table(optimum, None, system);
    for text in around
        .iter()
        .flat_map(|around| window_lines(around, optimum, system))
    {
        table.remark(text);
    }
    document.add(table);
    add_constraints(document, optimum, system);
}

/// The varied parameters as a table. For swings, a column has the design that is best for the mean
/// swing.
pub(in crate::report) fn varied_table(
    optimum: &Optimum,
    nominal: Option<&Nominal>,
    system: System,
) -> DocumentTable {
    let (search, solution) = (&optimum.search, &optimum.solution);
    let is_one_drive = search.scenarios.is_one_drive();
    let rows = search.vary.iter().enumerate().map(|(i, vary)| {
        let mean_swing = nominal.map_or(shown::NONE.into(), |nominal| {
            shown::within(vary, nominal.design[i], system)
        });
        let mean_swing = (!is_one_drive).then_some(mean_swing);
        let start = is_one_drive.then(|| {
            let value = optimum.start.value(vary.parameter);
            value.map_or(shown::NONE.into(), |value| {
                shown::within(vary, value, system)
            })
        });
        let name: String = vary.parameter.name.into();
        let found = shown::within(vary, solution.x[i], system);
        std::iter::once(name)
            .chain(start)
            .chain([found])
            .chain(mean_swing)
            .chain([
                shown::range(vary, system),
                bound_in_words(optimum, i, system),
            ])
            .collect::<Vec<String>>()
    });
    if is_one_drive {
        let found = ended_at(solution.status, "optimum");
        DocumentTable::new(["vary", "as set up", found, "range", ""], rows).right([1, 2])
    } else {
        let found = ended_at(solution.status, "best");
        let head = ["vary", found, "for the mean swing", "range", ""];
        DocumentTable::new(head, rows).right([1, 2])
    }
}

/// Adds a table of the constraints with their values and prices, if there are constraints. If the
/// drive as set up violates a constraint, a further column has the values of that drive. For
/// swings, the values are in the table of the goals instead.
fn add_constraints(document: &mut Document, optimum: &Optimum, system: System) {
    let is_one_drive = optimum.search.scenarios.is_one_drive();
    let is_violated_as_set_up = !optimum.violated_as_set_up().is_empty();
    let objective = Objective::at(optimum);
    let all = optimum.constraints();
    let rows = all.iter().map(|limit| {
        let constraint = limit.constraint;
        let price = objective.limit(limit, system);
        if !is_one_drive {
            return vec![constraint.expression.clone(), price];
        }
        let as_set_up = is_violated_as_set_up.then(|| {
            let value = optimum.as_set_up_by_drive(constraint);
            value.map_or(shown::NONE.into(), |value| {
                limited_value(constraint, value, system)
            })
        });
        let name = shown::constraint(constraint, system);
        let value = shown::goal(&constraint.goal, limit.at.value, system);
        let cells = [name].into_iter().chain(as_set_up);
        cells.chain([value, price]).collect()
    });
    // for swings, omit constraints without a price
    let rows: Vec<_> = rows
        .filter(|row| is_one_drive || !row[1].is_empty())
        .collect();
    if rows.is_empty() {
        return;
    }
    document.add(match (is_one_drive, is_violated_as_set_up) {
        (true, true) => {
            let head = ["subject to", "as set up", "value", ""];
            DocumentTable::new(head, rows).right([1, 2])
        }
        (true, false) => DocumentTable::new(["subject to", "value", ""], rows).right([1]),
        (false, _) => DocumentTable::new(["subject to", ""], rows),
    });
}

/// Adds the comparison of an optimum with the sample, and the convergence of the search.
pub(in crate::report) fn add_convergence(
    document: &mut Document,
    optimum: &Optimum,
    system: System,
) {
    let message = optimum.message();
    let is_of_solver = message.to_string() == optimum.solution.message;
    let ended = match is_of_solver {
        true => Line::flush(format!("{}: {}", optimum.status(), effort(optimum))),
        false => ended_line(optimum, system),
    };
    document.list(sample_line(optimum).into_iter().chain([ended]));
    if is_of_solver {
        let residual = DocumentBlock::Paragraph(message.in_units(system));
        document.add_detail(residual, Detail::WithVerbose);
    }
}

/// The status, the message and the effort of a search.
pub(in crate::report) fn ended_line(optimum: &Optimum, system: System) -> Line {
    Line::flush(format!(
        "{}: {} ({})",
        optimum.status(),
        optimum.message().in_units(system),
        effort(optimum)
    ))
}

/// The effort of a search, such as "4 iterations, 5 evaluations of 64 swings".
fn effort(optimum: &Optimum) -> String {
    let scenarios = &optimum.search.scenarios;
    let swings = match scenarios.is_one_drive() {
        true => String::new(),
        false => format!(" of {}", counted(scenarios.points.len() as u64, "swing")),
    };
    format!(
        "{}, {}{swings}",
        counted(optimum.solution.iterations, "iteration"),
        counted(optimum.solution.effort.evaluations, "evaluation")
    )
}

/// The comparison of the optimum with the sample of the ranges. `None` without a sample, or if the
/// message of the search already has this comparison.
fn sample_line(optimum: &Optimum) -> Option<Line> {
    let is_told = optimum.solution.status == Status::Infeasible;
    let Sample {
        points,
        feasible,
        better,
        improved,
    } = optimum.sample.filter(|_| !is_told)?;
    let found = if improved {
        "found by a search from another point of the ranges; "
    } else {
        ""
    };
    let is_better = match better {
        0 => format!("none of {points} other points in the ranges is better"),
        _ => format!(
            "{better} of {points} other points in the ranges are better; search from more starts, \
             for example `starts 32`"
        ),
    };
    let met = match (optimum.search.subject_to.is_empty(), feasible) {
        (true, _) => String::new(),
        (false, 0) => " (none meets the constraints)".into(),
        (false, 1) => " (1 meets the constraints)".into(),
        (false, _) => format!(" ({feasible} meet the constraints)"),
    };
    Some(Line::flush(format!("{found}{is_better}{met}")))
}

/// The results of the searches as a table, best first, and the number of interrupted searches.
pub fn optima_document(optima: &Optima, system: System) -> Document {
    let search = &optima.best.search;
    let all = optima.starts();
    let names = search.parameters().map(|parameter| parameter.name);
    let head: Vec<&str> = [search.of.expression.as_str()]
        .into_iter()
        .chain(names)
        .chain(["starts", ""])
        .collect();
    let rows: Vec<Vec<String>> = optima
        .ended()
        .map(|local| {
            let value = shown::goal_or_dash(&search.of, local.value, system);
            let x = search.vary.iter().zip(&local.solution.x);
            let x = x.map(|(vary, x)| shown::parameter(vary.parameter, *x, system));
            let starts = format!("{} of {all}", local.starts.len());
            std::iter::once(value)
                .chain(x)
                .chain([starts, local.status().into()])
                .collect()
        })
        .collect();
    let right: Vec<usize> = (0..head.len() - 1).collect();
    let mut document = Document::default();
    if !rows.is_empty() {
        document.add(DocumentTable::new(head, rows).right(right));
    }
    if optima.stopped() > 0 {
        let stopped = counted_of(optima.stopped() as u64, all as u64, ["search", "searches"]);
        document.paragraph(format!("not listed: {stopped} stopped before the end"));
    }
    document
}

/// The progress line of an iteration.
pub fn iteration_line(search: &Search, iteration: &Iteration, system: System) -> String {
    let number = |of: DisplayUnit, value: f64| {
        let number = fixed(value / of.size_in(system), 6);
        with_unit(&number, system.unit(of.unit))
    };
    let x = search.vary.iter().zip(&iteration.x).map(|(vary, x)| {
        let value = number(vary.parameter.into(), *x);
        format!("{} {value}", vary.parameter.name)
    });
    let of = &search.of;
    let violation = if search.subject_to.is_empty() {
        String::new()
    } else {
        format!("  violation {:.1e}", iteration.violation)
    };
    format!(
        "{:>3}  {} {}  KKT {:.1e}{violation}  trust region {:.1e}{}  {}",
        iteration.number,
        of.expression,
        number(of.into(), search.sense.sign() * iteration.value),
        iteration.kkt_residual,
        iteration.radius,
        if iteration.accepted {
            ""
        } else {
            "  step refused"
        },
        x.collect::<Vec<_>>().join(", ")
    )
}
