//! The chain rule between impact and flight. Club and strike change a flight through the launch alone: by more parameters than the
//! six components of its velocity and spin, derivatives of the flight are taken by these, and by what changes it besides.

use super::Taylor;
use super::directions::Passes;
use super::pass::{Part, Variable};
use super::point::{Point, blank};
use super::split::Split;
use crate::drive;
use crate::error::Result;

/// Values and gradients by many parameters, or Hessians too. `progress` is told how many passes of how many are done.
pub(super) fn derivatives(
    point: &Point<'_>,
    split: &Split,
    to_second: bool,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    let n = point.wrt.len();
    let rows = |n: usize| if to_second { n } else { 0 };
    let mut taylors = blank(point.of.len(), n, rows(n));
    let mut launch = blank(6, n, rows(n));
    Passes::by(&split.of_launch, to_second).run(point.level, &mut |directions, _| {
        point.pass(directions, Part::Impact { launch: &mut launch }, &mut taylors)
    })?;
    if !point.flies {
        progress(1, 1);
        return Ok(taylors);
    }
    let moves = |component: &usize| {
        launch[*component].gradient.iter().chain(launch[*component].hessian.iter().flatten()).any(|d| *d != 0.0)
    };
    let components = (0..launch.len()).filter(moves).map(Variable::Launch);
    let variables: Vec<_> = components.chain(split.of_flight.iter().copied().map(Variable::Parameter)).collect();
    let each: Vec<usize> = (0..variables.len()).collect();
    let mut slopes = blank(point.of.len(), each.len(), rows(each.len()));
    let mut done = 0;
    Passes::by(&each, to_second).run(point.level, &mut |directions, all| {
        point.pass(directions, Part::Flight { launch: &launch, variables: &variables }, &mut slopes)?;
        done += 1;
        progress(done, all);
        Ok(())
    })?;
    for (outcome, (taylor, slopes)) in point.of.iter().zip(taylors.iter_mut().zip(slopes)) {
        if outcome.part() == drive::Part::Flight {
            chain(taylor, &slopes, &variables, &launch);
        }
    }
    Ok(taylors)
}

/// The derivatives by parameters of what has these by the variables of a flight.
fn chain(taylor: &mut Taylor, by_variables: &Taylor, variables: &[Variable], launch: &[Taylor]) {
    let add = |sums: &mut [f64], factor: f64, terms: &[f64]| {
        sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += factor * term);
    };
    // adds how a variable changes with the parameters
    let add_change = |sums: &mut [f64], factor: f64, variable: Variable| match variable {
        Variable::Launch(component) => add(sums, factor, &launch[component].gradient),
        Variable::Parameter(index) => sums[index] += factor,
    };
    taylor.value = by_variables.value;
    for (a, &variable) in variables.iter().enumerate() {
        let slope = by_variables.gradient[a];
        add_change(&mut taylor.gradient, slope, variable);
        if taylor.hessian.is_empty() {
            continue;
        }
        // how the slope by this variable changes with the parameters
        let mut slope_by_parameters = vec![0.0; taylor.gradient.len()];
        for (b, &other) in variables.iter().enumerate() {
            add_change(&mut slope_by_parameters, by_variables.hessian[a][b], other);
        }
        match variable {
            Variable::Launch(component) => {
                let Taylor { gradient, hessian, .. } = &launch[component];
                for (row, (change, second)) in taylor.hessian.iter_mut().zip(gradient.iter().zip(hessian)) {
                    add(row, *change, &slope_by_parameters);
                    add(row, slope, second);
                }
            }
            Variable::Parameter(index) => add(&mut taylor.hessian[index], 1.0, &slope_by_parameters),
        }
    }
    // symmetric to the last bit, as its terms are
    for i in 0..taylor.hessian.len() {
        for j in 0..i {
            taylor.hessian[j][i] = taylor.hessian[i][j];
        }
    }
}
