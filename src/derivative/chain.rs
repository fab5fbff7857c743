//! The chain rule between impact and flight. Club and strike change a flight through the launch
//! alone: by more parameters than the six components of its velocity and spin, derivatives of the
//! flight are taken by these, and by what changes it besides.

use super::Taylor;
use super::pass::{COMPONENTS, Leg, Point};
use super::split::Split;
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::Result;

/// The outcomes at a point, by the chain rule where the parameters are split. `progress` is told
/// how many passes of how many are done.
pub(super) fn derivatives(
    point: &Point<'_>,
    split: Option<&Split>,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    let zero = |columns: usize| Taylor::zero(columns, point.first_row.map_or(0, |_| columns));
    let (outcomes, parameters) = (point.of.len(), point.columns);
    let Some(split) = split else {
        let mut taylors = vec![zero(parameters); outcomes];
        point.differentiate(
            Leg::Whole,
            &(0..parameters).collect::<Vec<_>>(),
            &mut taylors,
            progress,
        )?;
        return Ok(taylors);
    };
    let mut taylors = vec![zero(parameters); outcomes + COMPONENTS];
    point.differentiate(Leg::Impact, &split.of_launch, &mut taylors, &mut |_, _| ())?;
    let launch = taylors.split_off(outcomes);
    if !point.flies {
        progress(1, 1);
        return Ok(taylors);
    }
    let moves = |component: &Taylor| {
        component
            .gradient
            .iter()
            .chain(component.hessian.iter().flatten())
            .any(|d| *d != 0.0)
    };
    let components = (0..COMPONENTS).filter(|&component| moves(&launch[component]));
    let variables: Vec<usize> = components
        .map(|component| parameters + component)
        .chain(split.of_flight.iter().copied())
        .collect();
    let is_flown = |outcome: &Outcome| outcome.group() == OutcomeGroup::Flight;
    let columns = |outcome: &Outcome| {
        if is_flown(outcome) {
            parameters + COMPONENTS
        } else {
            0
        }
    };
    let mut slopes: Vec<Taylor> = point
        .of
        .iter()
        .map(|outcome| zero(columns(outcome)))
        .collect();
    point.differentiate(Leg::Flight(&launch), &variables, &mut slopes, progress)?;
    for (i, _) in point
        .of
        .iter()
        .enumerate()
        .filter(|(_, outcome)| is_flown(outcome))
    {
        chain(&mut taylors[i], &slopes[i], &variables, &launch);
    }
    Ok(taylors)
}

/// The chain rule: derivatives by the parameters from those by the variables of a flight.
fn chain(taylor: &mut Taylor, by_variables: &Taylor, variables: &[usize], launch: &[Taylor]) {
    let parameters = taylor.gradient.len();
    let component = |variable: usize| {
        variable
            .checked_sub(parameters)
            .map(|component| &launch[component])
    };
    let add = |sums: &mut [f64], factor: f64, terms: &[f64]| {
        sums.iter_mut()
            .zip(terms)
            .for_each(|(sum, term)| *sum += factor * term);
    };
    // adds how a variable changes with the parameters
    let add_change = |sums: &mut [f64], factor: f64, variable: usize| match component(variable) {
        Some(component) => add(sums, factor, &component.gradient),
        None => sums[variable] += factor,
    };
    taylor.value = by_variables.value;
    for &variable in variables {
        let slope = by_variables.gradient[variable];
        add_change(&mut taylor.gradient, slope, variable);
        if taylor.hessian.is_empty() {
            continue;
        }
        // how the slope by this variable changes with the parameters
        let mut slope_by_parameters = vec![0.0; parameters];
        for &other in variables {
            add_change(
                &mut slope_by_parameters,
                by_variables.hessian[variable][other],
                other,
            );
        }
        let Some(Taylor {
            gradient, hessian, ..
        }) = component(variable)
        else {
            add(&mut taylor.hessian[variable], 1.0, &slope_by_parameters);
            continue;
        };
        for (row, (change, second)) in taylor.hessian.iter_mut().zip(gradient.iter().zip(hessian)) {
            add(row, *change, &slope_by_parameters);
            add(row, slope, second);
        }
    }
    // symmetric to the last bit, as its terms are
    for i in 0..taylor.hessian.len() {
        for j in 0..i {
            taylor.hessian[j][i] = taylor.hessian[i][j];
        }
    }
}
