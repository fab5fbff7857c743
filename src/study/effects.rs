//! What outcomes answer to: gradients, elasticities, and the effect of a standard uncertainty of
//! each parameter.

use super::sigma::Sigma;
use crate::derivative::{Order, evaluate};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};

/// What an outcome answers to.
#[derive(Clone, Debug)]
pub struct Effects {
    /// The outcome, f.
    pub of: Outcome,
    /// Its value, SI.
    pub value: f64,
    /// Each parameter's effect: those with an uncertainty first, by the size of what it does, then
    /// the others by elasticity.
    pub effects: Vec<Effect>,
}

/// What a parameter, p, does to an outcome.
#[derive(Clone, Debug)]
pub struct Effect {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// ∂f/∂p, SI.
    pub gradient: f64,
    /// (p/f) ∂f/∂p: by how many per cent f changes where p changes by one; `None` where p or f is
    /// 0, or f nothing but rounding.
    pub elasticity: Option<f64>,
    /// What its standard uncertainty does; `None` where it has none.
    pub bar: Option<Bar>,
}

/// The effect of a standard uncertainty, σ.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    /// The uncertainty.
    pub sigma: Sigma,
    /// σ ∂f/∂p, SI.
    pub first_order: f64,
    /// ½ σ² ∂²f/∂p²: what the mean of f moves by; `None` where there is no second derivative, or σ
    /// is so large that this is no number.
    pub second_order: Option<f64>,
    /// The change of f in drives flown at p − σ and p + σ; `None` where p cannot be so or nothing
    /// flies.
    pub flown: [Option<f64>; 2],
}

impl Effects {
    /// The standard uncertainty of the outcome, to first order, where the parameters are
    /// independent: √Σ(σ ∂f/∂p)².
    pub fn standard_uncertainty(&self) -> f64 {
        self.bars().map(|bar| bar.first_order).fold(0.0, f64::hypot)
    }

    /// The standard uncertainty of the change from this drive to another one, to first order, where
    /// every parameter is off by the same amount in both: √Σ(σ (∂f₂/∂p − ∂f₁/∂p))².
    pub fn uncertainty_of_change(&self, other: &Self) -> f64 {
        let there = |bar: &Bar| {
            let same = other
                .bars()
                .find(|other| other.sigma.parameter == bar.sigma.parameter);
            same.map_or(0.0, |other| other.first_order)
        };
        self.bars()
            .map(|bar| there(bar) - bar.first_order)
            .fold(0.0, f64::hypot)
    }

    /// What straight bars neglect: Σ ½ σ² |∂²f/∂p²|. Bars that are shorter are not to be trusted.
    pub fn linearity(&self) -> f64 {
        self.bars()
            .filter_map(|bar| bar.second_order)
            .map(f64::abs)
            .sum()
    }

    fn bars(&self) -> impl Iterator<Item = &Bar> {
        self.effects.iter().filter_map(|effect| effect.bar.as_ref())
    }
}

/// Smaller values, in the unit people read, are what rounding leaves of 0.
const LEAST_SIZE: f64 = 1e-9;

/// The effects of all parameters that have a number on some outcomes; `progress` is told how many
/// uncertainties of how many are done.
///
/// # Errors
/// As [`evaluate`]; [`Error::Unreadable`](crate::Error::Unreadable) for an uncertainty that is not
/// above 0 and finite.
pub fn effects(
    setup: &Setup<f64>,
    of: &[Outcome],
    sigmas: &[Sigma],
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Vec<Effects>> {
    sigmas.iter().try_for_each(|sigma| sigma.check(setup))?;
    let mut parameters = setup.variables();
    // what only the run depends on, where none is asked for
    let runs = of.iter().any(|of| of.needs_run());
    parameters.retain(|parameter| runs || !parameter.affects_only_run());
    let taylors = evaluate(setup, of, &parameters, Order::First)?;
    let mut bars: Vec<Vec<Bar>> = vec![vec![]; of.len()];
    for (done, sigma) in sigmas.iter().enumerate() {
        let flown = [-1.0, 1.0].map(|sign| flown_off(setup, of, sigma, sign).ok());
        let curvatures = evaluate(setup, of, &[sigma.parameter], Order::Second).ok();
        let place = parameters
            .iter()
            .position(|parameter| *parameter == sigma.parameter);
        for (i, bars) in bars.iter_mut().enumerate() {
            let slope = place.map_or(0.0, |place| taylors[i].gradient[place]);
            bars.push(Bar {
                sigma: *sigma,
                first_order: slope * sigma.value,
                second_order: curvatures
                    .as_ref()
                    .map(|all| 0.5 * all[i].hessian[0][0] * sigma.value * sigma.value)
                    .filter(|moved| moved.is_finite()),
                flown: flown.each_ref().map(|values| {
                    values
                        .as_ref()
                        .map(|values| change(of[i], taylors[i].value, values[i]))
                }),
            });
        }
        progress(done + 1, sigmas.len());
    }
    let effects = |(i, of): (usize, &Outcome)| {
        let value = taylors[i].value;
        let least = LEAST_SIZE * of.quantity().size_of(of.unit()).unwrap_or(1.0);
        let effect = |(k, parameter): (usize, &&'static Parameter)| {
            let (gradient, p) = (
                taylors[i].gradient[k],
                setup.value(parameter).unwrap_or_default(),
            );
            Effect {
                parameter,
                gradient,
                elasticity: (p != 0.0 && value.abs() > least).then(|| gradient * p / value),
                bar: bars[i]
                    .iter()
                    .find(|bar| bar.sigma.parameter == *parameter)
                    .copied(),
            }
        };
        let mut effects: Vec<_> = parameters.iter().enumerate().map(effect).collect();
        effects.sort_by(|a, b| {
            rank(b)
                .partial_cmp(&rank(a))
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        Effects {
            of: *of,
            value,
            effects,
        }
    };
    Ok(of.iter().enumerate().map(effects).collect())
}

/// From one value of an outcome to another.
fn change(of: Outcome, from: f64, to: f64) -> f64 {
    of.unwrap_angle(to, from) - from
}

/// What effects are ranked by: a bar before none, then the size.
fn rank(effect: &Effect) -> (bool, f64) {
    match &effect.bar {
        Some(bar) => (true, bar.first_order.abs()),
        None => (false, effect.elasticity.unwrap_or_default().abs()),
    }
}

/// The outcomes of the drive with a parameter off by its uncertainty, `sign` −1 for p − σ and 1 for
/// p + σ.
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) for a value that the parameter cannot have; as
/// [`evaluate`].
pub fn flown_off(setup: &Setup<f64>, of: &[Outcome], sigma: &Sigma, sign: f64) -> Result<Vec<f64>> {
    let mut moved = *setup;
    let value = setup
        .value(sigma.parameter)
        .map(|value| value + sign * sigma.value);
    moved.set_value(sigma.parameter, value)?;
    let taylors = evaluate(&moved, of, &[], Order::Value)?;
    Ok(taylors.into_iter().map(|taylor| taylor.value).collect())
}
