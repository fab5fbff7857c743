//! Chain rule between impact and flight. Club and strike affect a flight only through the launch.
//! The launch has six components: three of velocity, three of spin. If there are many parameters of
//! club and strike, the flight is differentiated by these six components instead. The chain rule
//! combines the derivatives of impact and flight.

use super::Taylor;
use super::pass::{COMPONENTS, EvaluationPoint, Stage};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::Result;
use crate::number::{Level, MOST_PER_LANE};
use crate::parameters::{Parameter, ParameterGroup};

/// Parameters that affect the launch, and parameters that affect the flight after a given launch.
/// The parameters of the ball are in both lists.
#[derive(Clone, Debug)]
pub(super) struct ParameterSplit {
    /// Indices of the parameters of the launch: club, strike and ball, or a given launch.
    pub of_launch: Vec<usize>,
    /// Indices of the other inputs of the flight: ball, air, wind, law and ground.
    pub of_flight: Vec<usize>,
}

impl ParameterSplit {
    /// Divides the parameters `wrt`. `runs` is true if an outcome depends on the run; otherwise the
    /// parameters that affect only the run are omitted.
    pub fn of(wrt: &[&'static Parameter], runs: bool) -> Self {
        let indices = |holds: &dyn Fn(&Parameter) -> bool| {
            (0..wrt.len()).filter(|&index| holds(wrt[index])).collect()
        };
        let is_of_launch =
            |parameter: &Parameter| parameter.is_of_strike() || parameter.is_of_launch();
        Self {
            of_launch: indices(&|parameter| {
                is_of_launch(parameter) || parameter.group == ParameterGroup::Ball
            }),
            of_flight: indices(&|parameter| {
                !is_of_launch(parameter) && (runs || !parameter.affects_only_run())
            }),
        }
    }

    /// True if the chain rule is cheaper than direct differentiation. The cost of a Hessian grows
    /// with the number of variables. The cost of a gradient grows with the number of passes and
    /// with the number of directions in a lane.
    pub fn is_cheaper(&self, parameters: usize, to_second: bool, level: Level) -> bool {
        let most_variables = COMPONENTS + self.of_flight.len();
        if to_second {
            return most_variables < parameters;
        }
        let most = MOST_PER_LANE * level.width();
        // cost of a gradient: number of passes times number of directions in a lane
        let size = |count: usize| {
            if count <= level.width() {
                1
            } else {
                MOST_PER_LANE * count.div_ceil(most)
            }
        };
        parameters > most || size(most_variables) < size(parameters)
    }
}

/// Outcomes and derivatives at a point. If `split` is given, they are computed by the chain rule.
/// `progress` receives the number of completed passes (evaluations of a drive in all lanes) and the
/// number of all passes. Passes of the impact alone are not counted.
pub(super) fn derivatives(
    point: &EvaluationPoint<'_>,
    split: Option<&ParameterSplit>,
    progress: &dyn Fn(usize, usize),
) -> Result<Vec<Taylor>> {
    let Some(split) = split else {
        let variables: Vec<_> = (0..point.columns).collect();
        let mut taylors = vec![zero(point, point.columns); point.of.len()];
        point.differentiate(Stage::Whole, &variables, &mut taylors, progress)?;
        return Ok(taylors);
    };
    let mut taylors = vec![zero(point, point.columns); point.of.len() + COMPONENTS];
    point.differentiate(Stage::Impact, &split.of_launch, &mut taylors, &|_, _| ())?;
    let launch = taylors.split_off(point.of.len());
    if !point.flies() {
        progress(1, 1);
        return Ok(taylors);
    }
    let variables = flight_variables(point, split, &launch);
    let columns = |outcome: &Outcome| {
        if is_of_flight(outcome) {
            point.columns + COMPONENTS
        } else {
            0
        }
    };
    let mut by_variables: Vec<Taylor> = point
        .of
        .iter()
        .map(|outcome| zero(point, columns(outcome)))
        .collect();
    point.differentiate(
        Stage::Flight(&launch),
        &variables,
        &mut by_variables,
        progress,
    )?;
    for (outcome, (taylor, by_variables)) in
        point.of.iter().zip(taylors.iter_mut().zip(&by_variables))
    {
        if is_of_flight(outcome) {
            chain(taylor, by_variables, &variables, &launch);
        }
    }
    Ok(taylors)
}

/// Zero value and derivatives by `columns` variables; with a Hessian if `point` requests Hessians.
fn zero(point: &EvaluationPoint<'_>, columns: usize) -> Taylor {
    Taylor::zero(columns, point.entries.map_or(0, |_| columns))
}

fn is_of_flight(outcome: &Outcome) -> bool {
    outcome.group() == OutcomeGroup::Flight
}

/// Indices of the flight's variables: first the components of the launch that depend on a
/// parameter, then the flight's own parameters.
fn flight_variables(
    point: &EvaluationPoint<'_>,
    split: &ParameterSplit,
    launch: &[Taylor],
) -> Vec<usize> {
    let is_nonzero = |component: &Taylor| {
        component
            .gradient
            .iter()
            .chain(component.hessian.iter().flatten())
            .any(|d| *d != 0.0)
    };
    (0..COMPONENTS)
        .filter(|&component| is_nonzero(&launch[component]))
        .map(|component| point.columns + component)
        .chain(split.of_flight.iter().copied())
        .collect()
}

/// Chain rule: adds the derivatives by the parameters to `taylor`. `by_variables` has the
/// derivatives by the variables of the flight. `launch` has the derivatives of the launch by the
/// parameters.
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
    // adds `factor` times the derivative of `variable` by each parameter
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
        // derivative of `slope` by the parameters
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
    // make the Hessian symmetric to the last bit
    for i in 0..taylor.hessian.len() {
        for j in 0..i {
            taylor.hessian[j][i] = taylor.hessian[i][j];
        }
    }
}
