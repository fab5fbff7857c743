//! Local sensitivity analysis: gradients, elasticities, and the effect of each parameter's standard
//! uncertainty.

use super::sigma::Sigma;
use crate::derivative::{Order, Taylor, all_variables, evaluate};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::units::DisplayUnit;

/// Sensitivities of an outcome.
#[derive(Clone, Debug)]
pub struct Effects {
    /// The outcome, f.
    pub of: Outcome,
    /// Value of the outcome, SI.
    pub value: f64,
    /// Effects of all parameters. Parameters with an uncertainty come first, by magnitude of the
    /// effect; parameters without an uncertainty follow, by elasticity.
    pub effects: Vec<Effect>,
}

/// Effect of a parameter p on an outcome f.
#[derive(Clone, Debug)]
pub struct Effect {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// ∂f/∂p, SI.
    pub gradient: f64,
    /// (p/f) ∂f/∂p: relative change of f per relative change of p; `None` if p is 0, or if f is 0
    /// up to rounding.
    pub elasticity: Option<f64>,
    /// Effect of the parameter's standard uncertainty; `None` if the parameter has no uncertainty.
    pub sigma_effect: Option<SigmaEffect>,
}

/// Effect of a standard uncertainty σ.
#[derive(Clone, Copy, Debug)]
pub struct SigmaEffect {
    /// The uncertainty.
    pub sigma: Sigma,
    /// σ ∂f/∂p, SI.
    pub first_order: f64,
    /// ½ σ² ∂²f/∂p², the shift of the mean of f; `None` without a second derivative, or on
    /// overflow.
    pub second_order: Option<f64>,
    /// Change of f for drives at p − σ and p + σ; `None` if the parameter value is not allowed or
    /// the ball does not fly.
    pub flown: [Option<f64>; 2],
}

impl Effects {
    /// The effects of those parameters for which `has` is true.
    pub fn of_parameters(&self, has: impl Fn(&Parameter) -> bool) -> Self {
        let effects = self.effects.iter();
        let effects = effects.filter(|effect| has(effect.parameter));
        Self {
            of: self.of,
            value: self.value,
            effects: effects.cloned().collect(),
        }
    }

    /// First-order standard uncertainty of the outcome for independent parameters: √Σ(σ ∂f/∂p)².
    pub fn standard_uncertainty(&self) -> f64 {
        self.sigma_effects()
            .map(|sigma_effect| sigma_effect.first_order)
            .fold(0.0, f64::hypot)
    }

    /// First-order standard uncertainty of the difference from another drive, if each parameter has
    /// the same error in both drives: √Σ(σ₂ ∂f₂/∂p − σ₁ ∂f₁/∂p)². If a parameter has no uncertainty
    /// in one of the drives, its σ there counts as 0.
    pub fn uncertainty_of_change(&self, other: &Self) -> f64 {
        let in_other = |parameter| {
            let mut effects = other.sigma_effects();
            effects.find(|effect| effect.sigma.parameter == parameter)
        };
        let is_only_there = |there: &&SigmaEffect| {
            let mut here = self.sigma_effects();
            here.all(|here| here.sigma.parameter != there.sigma.parameter)
        };
        let here = self.sigma_effects().map(|here| {
            let there = in_other(here.sigma.parameter);
            there.map_or(0.0, |there| there.first_order) - here.first_order
        });
        let only_there = other.sigma_effects().filter(is_only_there);
        here.chain(only_there.map(|there| there.first_order))
            .fold(0.0, f64::hypot)
    }

    /// Magnitude of the neglected second-order terms: Σ ½ σ² |∂²f/∂p²|. First-order effects below
    /// this magnitude are unreliable.
    pub fn linearity(&self) -> f64 {
        self.sigma_effects()
            .filter_map(|sigma_effect| sigma_effect.second_order)
            .map(f64::abs)
            .sum()
    }

    /// The effects of the uncertain parameters, the largest first.
    pub(crate) fn sigma_effects(&self) -> impl Iterator<Item = &SigmaEffect> {
        self.effects
            .iter()
            .filter_map(|effect| effect.sigma_effect.as_ref())
    }
}

/// Largest magnitude of an outcome, in its display unit, that counts as 0.
const LEAST_SIZE: f64 = 1e-9;

/// Effects of all numeric parameters on the outcomes (`longdrive sensitivity`). `progress` receives
/// two numbers: how many of `sigmas` are finished, and how many there are.
///
/// # Errors
/// The errors of [`evaluate`]; [`Error::Unreadable`](crate::Error::Unreadable) for an uncertainty
/// that is not positive and finite.
pub fn effects(
    setup: &Setup<f64>,
    of: &[Outcome],
    sigmas: &[Sigma],
    progress: &dyn Fn(usize, usize),
) -> Result<Vec<Effects>> {
    sigmas.iter().try_for_each(|sigma| sigma.check(setup))?;
    let mut parameters = setup.variables();
    // keep a parameter with a stated uncertainty: its effect is 0 if no outcome depends on the run
    let of_outcomes = all_variables(setup, of);
    let has_sigma = |parameter| sigmas.iter().any(|sigma| sigma.parameter == parameter);
    parameters.retain(|parameter| of_outcomes.contains(parameter) || has_sigma(*parameter));
    let taylors = evaluate(setup, of, &parameters, Order::First)?;
    let mut sigma_effects: Vec<Vec<SigmaEffect>> = vec![vec![]; of.len()];
    for (done, sigma) in sigmas.iter().enumerate() {
        let flown = [-1.0, 1.0].map(|sign| flown_off(setup, of, sigma, sign).ok());
        let curvatures = evaluate(setup, of, &[sigma.parameter], Order::Second).ok();
        let place = parameters
            .iter()
            .position(|parameter| *parameter == sigma.parameter);
        for (i, sigma_effects) in sigma_effects.iter_mut().enumerate() {
            let slope = place.map_or(0.0, |place| taylors[i].gradient[place]);
            sigma_effects.push(SigmaEffect {
                sigma: *sigma,
                first_order: slope * sigma.value,
                second_order: curvatures
                    .as_ref()
                    .map(|all| 0.5 * all[i].hessian[0][0] * sigma.value * sigma.value)
                    .filter(|moved| moved.is_finite()),
                flown: flown.each_ref().map(|values| {
                    values
                        .as_ref()
                        .map(|values| of[i].change(taylors[i].value, values[i]))
                }),
            });
        }
        progress(done + 1, sigmas.len());
    }
    let taylors = taylors.iter().zip(sigma_effects);
    let effects = of.iter().zip(taylors).map(|(of, (taylor, sigma_effects))| {
        ranked(setup, *of, &parameters, taylor, &sigma_effects)
    });
    Ok(effects.collect())
}

/// Effects of all parameters on an outcome, in descending order of [`rank`].
fn ranked(
    setup: &Setup<f64>,
    of: Outcome,
    parameters: &[&'static Parameter],
    taylor: &Taylor,
    sigma_effects: &[SigmaEffect],
) -> Effects {
    let value = taylor.value;
    let least = LEAST_SIZE * DisplayUnit::from(of).size();
    let effect = |(parameter, gradient): (&&'static Parameter, &f64)| {
        let p = setup.value(parameter).unwrap_or_default();
        Effect {
            parameter,
            gradient: *gradient,
            elasticity: (p != 0.0 && value.abs() > least).then(|| gradient * p / value),
            sigma_effect: sigma_effects
                .iter()
                .find(|sigma_effect| sigma_effect.sigma.parameter == *parameter)
                .copied(),
        }
    };
    let mut effects: Vec<_> = parameters
        .iter()
        .zip(&taylor.gradient)
        .map(effect)
        .collect();
    effects.sort_by(|a, b| {
        rank(b)
            .partial_cmp(&rank(a))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    Effects { of, value, effects }
}

/// Sort key of an effect: effects with an uncertainty first, then by magnitude.
fn rank(effect: &Effect) -> (bool, f64) {
    match &effect.sigma_effect {
        Some(sigma_effect) => (true, sigma_effect.first_order.abs()),
        None => (false, effect.elasticity.unwrap_or_default().abs()),
    }
}

/// Outcomes of the drive at p − σ (`sign` −1) or p + σ (`sign` 1).
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) for a value that the parameter cannot have; the
/// errors of [`evaluate`].
pub fn flown_off(setup: &Setup<f64>, of: &[Outcome], sigma: &Sigma, sign: f64) -> Result<Vec<f64>> {
    let mut moved = *setup;
    let value = setup
        .value(sigma.parameter)
        .map(|value| value + sign * sigma.value);
    moved.set_value(sigma.parameter, value)?;
    let taylors = evaluate(&moved, of, &[], Order::Value)?;
    Ok(taylors.into_iter().map(|taylor| taylor.value).collect())
}
