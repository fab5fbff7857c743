use super::figures::At;
use super::lines::{by_reason, item};
use super::table::table;
use super::{OptimumReport, Reply, json, shown};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use crate::study::{Bar, Effect, Effects, Optimum, Sensitivity};
use crate::units::{Message, System, significant};
use serde::Serialize;
use serde_json::{Value, json};

/// The sensitivity of an optimum's best value to each parameter, or why there is none.
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
    pub fn reply(
        outcomes: Vec<OutcomeEffects>,
        best: Option<&Optimum>,
        warnings: Vec<Message>,
    ) -> Reply<Self> {
        Reply::done(
            "sensitivity",
            warnings,
            Self {
                outcomes,
                at_optimum: best.map(OptimumReport::new),
            },
        )
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
    /// What the first order neglects; drives flown have it in them.
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
    sensitivity
        .as_ref()
        .ok()
        .map(|sensitivity| sensitivity.value)
}

/// The effects on an outcome of the drive `at` as text: those of uncertainties first, with what
/// they neglect, then the other gradients.
pub fn effects_text(effects: &Effects, totals: Option<&Totals>, at: At, system: System) -> String {
    let of = effects.of;
    let rate = |slope: f64, parameter: &Parameter| {
        shown::slope(of, effects.value, parameter, slope, system, 5)
    };
    let slopes = |effect: &Effect| {
        let parameter = effect.parameter;
        let is_rounding = shown::settled(
            effect.gradient,
            effects.value,
            (of.quantity(), of.unit()),
            &[parameter],
        ) == 0.0;
        let elasticity = effect
            .elasticity
            .map(|elasticity| if is_rounding { 0.0 } else { elasticity });
        let elasticity =
            elasticity.map_or(shown::NONE.into(), |elasticity| significant(elasticity, 4));
        let mut row = vec![
            parameter.name.into(),
            rate(effect.gradient, parameter),
            elasticity,
        ];
        let of_optimum =
            || total(totals, parameter).map_or(shown::NONE.into(), |slope| rate(slope, parameter));
        row.extend(totals.map(|_| of_optimum()));
        row
    };
    let mut text = format!(
        "{} = {}, {at}\n",
        of.name(),
        shown::both(of, effects.value, system)
    );
    let bars: Vec<Bar> = effects
        .effects
        .iter()
        .filter_map(|effect| effect.bar)
        .collect();
    if !bars.is_empty() {
        let head = [
            "uncertainty of",
            "±σ",
            "effect",
            "second order",
            "flown at −σ",
            "flown at +σ",
        ];
        text += &format!(
            "\n{}",
            table(
                &head,
                &[1, 2, 3, 4, 5],
                bars.iter().map(|bar| bar_cells(bar, of, system))
            ),
        );
        let is_flown = bars.iter().all(|bar| bar.flown.iter().all(Option::is_some));
        text += &item(&format!(
            "together ±{} to first order, if independent; second order adds up to {}{}",
            shown::spread(of, effects.standard_uncertainty(), system),
            shown::spread(of, effects.linearity(), system),
            if is_flown {
                ", which the drives flown at −σ and +σ have in them"
            } else {
                ""
            },
        ));
        let without: Vec<&str> = effects
            .effects
            .iter()
            .filter(|effect| is_without(effects, effect))
            .map(|e| e.parameter.name)
            .collect();
        if !without.is_empty() {
            text += &item(&format!(
                "{} does not depend on {} here",
                of.name(),
                without.join(", ")
            ));
        }
        let source = |bar: &Bar| Some((bar.sigma.parameter.name, bar.sigma.source?.to_owned()));
        for line in by_reason(bars.iter().filter_map(source)) {
            text += &item(&format!("default of {line}"));
        }
    }
    let head = ["by", "slope", "elasticity"]
        .into_iter()
        .chain(totals.map(|_| "slope of the optimum"));
    let head: Vec<&str> = head.collect();
    let right: Vec<usize> = (1..head.len()).collect();
    text + &format!(
        "\n{}",
        table(&head, &right, effects.effects.iter().map(slopes))
    )
}

/// Whether an outcome does not depend on a parameter with an uncertainty: neither by its
/// derivatives nor in the drives flown.
fn is_without(effects: &Effects, effect: &Effect) -> bool {
    let Some(Bar {
        sigma,
        second_order: Some(second),
        flown: [Some(below), Some(above)],
        ..
    }) = effect.bar
    else {
        return false;
    };
    let curvature = 2.0 * second / (sigma.value * sigma.value);
    let (of, value) = (effects.of, effects.value);
    let is_moved = [below, above]
        .into_iter()
        .any(|by| !shown::is_rounding(of, value, by));
    !is_moved && !shown::depends(of, value, effect.parameter, effect.gradient, curvature)
}

fn bar_cells(bar: &Bar, of: Outcome, system: System) -> Vec<String> {
    let change = |value: f64| shown::change(of, value, system);
    let or_dash = |value: Option<f64>| value.map_or(shown::NONE.into(), change);
    let [below, above] = bar.flown;
    vec![
        bar.sigma.parameter.name.into(),
        format!(
            "±{}",
            shown::stated(bar.sigma.parameter, bar.sigma.value, system)
        ),
        change(bar.first_order),
        or_dash(bar.second_order),
        or_dash(below),
        or_dash(above),
    ]
}
