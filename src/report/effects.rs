use super::{OptimumReport, Reply, drive::readable, json, table::table};
use crate::error::Result;
use crate::parameters::Parameter;
use crate::study::{Bar, Effect, Effects, Optimum, Sensitivity};
use crate::units::{per, significant};
use serde::Serialize;
use serde_json::{Value, json};

/// What an optimum's best value answers to: a parameter each, as far as it has one.
pub type Totals = [(&'static Parameter, Result<Sensitivity>)];

/// The effects of all parameters on outcomes as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct EffectsReport {
    /// Each outcome, in the order asked for.
    pub outcomes: Vec<OutcomeEffects>,
    /// The optimum that was asked at; `null` where it was the setup itself.
    pub at_optimum: Option<OptimumReport>,
}

impl EffectsReport {
    /// The answer of `sensitivity`.
    pub fn reply(outcomes: Vec<OutcomeEffects>, best: Option<&Optimum>, warnings: Vec<String>) -> Reply<Self> {
        Reply::done("sensitivity", warnings, Self { outcomes, at_optimum: best.map(OptimumReport::new) })
    }
}

/// The effects of all parameters on an outcome as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct OutcomeEffects {
    /// The outcome.
    pub of: &'static str,
    /// Its value.
    pub value: Value,
    /// Its standard uncertainty to first order.
    pub standard_uncertainty: Value,
    /// What straight bars neglect; shorter ones are not to be trusted.
    pub linearity: Value,
    /// The parameters, by the size of what their uncertainty does.
    pub effects: Vec<Value>,
}

impl OutcomeEffects {
    /// The report of an outcome's effects; `totals` where the drive is an optimum of it.
    pub fn new(effects: &Effects, totals: Option<&Totals>) -> Self {
        let effect = |effect: &Effect| {
            let bar = effect.bar.as_ref();
            json!({
                "parameter": effect.parameter.name,
                "derivative": json::number(Some(effect.gradient)),
                "elasticity": json::number(effect.elasticity),
                "standard_uncertainty": json::number(bar.map(|bar| bar.sigma.value)),
                "source": bar.map(|bar| bar.sigma.source.unwrap_or("given")),
                "effect": json::number(bar.map(|bar| bar.first_order)),
                "second_order": json::number(bar.and_then(|bar| bar.second_order)),
                "flown": bar.map(|bar| bar.flown.map(json::number)),
                "derivative_of_optimum": json::number(total(totals, effect.parameter)),
            })
        };
        Self {
            of: effects.of.name(),
            value: json::number(Some(effects.value)),
            standard_uncertainty: json::number(Some(effects.standard_uncertainty())),
            linearity: json::number(Some(effects.linearity())),
            effects: effects.effects.iter().map(effect).collect(),
        }
    }
}

/// d f*/dp of a parameter at the optimum.
fn total(totals: Option<&Totals>, parameter: &Parameter) -> Option<f64> {
    let (_, sensitivity) = totals?.iter().find(|(other, _)| *other == parameter)?;
    sensitivity.as_ref().ok().map(|sensitivity| sensitivity.value)
}

/// The effects on an outcome as text: those of uncertainties first, with what they neglect, then the other gradients.
pub fn effects_text(effects: &Effects, totals: Option<&Totals>) -> String {
    let of = effects.of;
    let signed = |value: f64| if value > 0.0 { format!("+{}", readable(of, value)) } else { readable(of, value) };
    let size = of.quantity().size_of(of.unit()).unwrap_or(1.0);
    let rate = |slope: f64, parameter: &Parameter| {
        let by = parameter.quantity.size_of(parameter.unit).unwrap_or(1.0);
        format!("{} {}", significant(slope * by / size, 5), per(of.unit(), parameter.unit)).trim_end().to_owned()
    };
    let row = |effect: &Effect| {
        let parameter = effect.parameter;
        let elasticity = effect.elasticity.map_or("–".into(), |elasticity| significant(elasticity, 4));
        let mut row = vec![parameter.name.into(), rate(effect.gradient, parameter), elasticity];
        row.extend(totals.map(|_| total(totals, parameter).map_or("–".into(), |slope| rate(slope, parameter))));
        row.extend(effect.bar.as_ref().map(|bar| bar_cells(bar, signed)).into_iter().flatten());
        row
    };
    let gradient = ["by", "slope", "elasticity"].into_iter().chain(totals.map(|_| "slope of the optimum"));
    let with_bars: Vec<&str> =
        gradient.clone().chain(["uncertainty", "effect", "second order", "flown −σ", "flown +σ"]).collect();
    let gradient: Vec<&str> = gradient.collect();
    let (bars, others): (Vec<_>, Vec<_>) = effects.effects.iter().partition(|effect| effect.bar.is_some());
    let right = |head: &[&str]| (2..head.len()).collect::<Vec<_>>();
    let mut text = format!("{} = {}\n", of.name(), of.show(effects.value));
    if !bars.is_empty() {
        text += &format!(
            "\n{}  together ±{} to first order, if independent; trust only bars above {}\n",
            table(&with_bars, &right(&with_bars), bars.iter().map(|effect| row(effect))),
            readable(of, effects.standard_uncertainty()),
            readable(of, effects.linearity()),
        );
        for bar in bars.iter().filter_map(|effect| effect.bar) {
            if let Some(source) = bar.sigma.source {
                text += &format!("  default of {}: {source}\n", bar.sigma.parameter.name);
            }
        }
    }
    text + &format!("\n{}", table(&gradient, &right(&gradient), others.iter().map(|effect| row(effect))))
}

fn bar_cells(bar: &Bar, signed: impl Fn(f64) -> String) -> Vec<String> {
    let or_dash = |value: Option<f64>| value.map_or("–".into(), &signed);
    let [below, above] = bar.flown;
    vec![
        format!("±{}", bar.sigma.parameter.quantity.show(round(bar.sigma.value, bar), bar.sigma.parameter.unit)),
        signed(bar.first_order),
        or_dash(bar.second_order),
        or_dash(below),
        or_dash(above),
    ]
}

/// An uncertainty to four digits of the unit it is shown in.
fn round(value: f64, bar: &Bar) -> f64 {
    let size = bar.sigma.parameter.quantity.size_of(bar.sigma.parameter.unit).unwrap_or(1.0);
    significant(value / size, 4).parse::<f64>().map_or(value, |rounded| rounded * size)
}
