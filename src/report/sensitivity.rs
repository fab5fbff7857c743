use super::by_reason::by_reason;
use super::document::{Detail, Document, DocumentBlock, DocumentTable, Line};
use super::json::JsonNumber;
use super::reply::Report;
use super::{OptimumReport, shown};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use crate::study::{Effect, Effects, NamedDrive, Optimum, Sensitivity, SigmaEffect};
use crate::units::{System, significant};
use serde::Serialize;

/// Number of rows of a table in a plain text without the option `all`.
const FIRST_ROWS: usize = 10;

/// The source of an uncertainty that the request states.
pub(super) const STATED: &str = "given";

/// The effects of all parameters on outcomes, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SensitivityReport<'a> {
    #[serde(skip)]
    found: &'a [Effects],
    /// The outcome that the search optimizes; `None` for the drive as set up. The table of this
    /// outcome also has the derivatives of its optimal value.
    #[serde(skip)]
    optimized: Option<Outcome>,
    /// Each outcome, in the order requested.
    pub outcomes: Vec<OutcomeEffects>,
    /// The optimum, if the effects belong to the optimal drive; `null` for the drive as set up.
    pub at_optimum: Option<OptimumReport>,
}

/// The effects of all parameters on an outcome, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OutcomeEffects {
    /// The outcome.
    pub of: Outcome,
    /// The value of the outcome, SI.
    pub value: JsonNumber,
    /// The standard uncertainty of the outcome, SI, to first order for independent parameters.
    pub standard_uncertainty: JsonNumber,
    /// The sum of the second-order terms, SI. `standard_uncertainty` omits these terms; `flown` in
    /// each effect includes the second-order term of the effect.
    pub linearity: JsonNumber,
    /// The effects of the parameters, the largest first.
    pub effects: Vec<EffectReport>,
}

/// The effect of a parameter p on an outcome f. Numbers that need the uncertainty of p are `null`
/// if p has none.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct EffectReport {
    /// The parameter p.
    pub parameter: &'static str,
    /// ∂f/∂p, SI.
    pub derivative: JsonNumber,
    /// (p/f) ∂f/∂p.
    pub elasticity: JsonNumber,
    /// The standard uncertainty σ, SI.
    pub standard_uncertainty: JsonNumber,
    /// The source of σ.
    pub source: Option<&'static str>,
    /// σ ∂f/∂p, SI.
    pub effect: JsonNumber,
    /// ½ σ² ∂²f/∂p², SI.
    pub second_order: JsonNumber,
    /// The change of f in drives computed at p − σ and p + σ, SI.
    pub flown: Option<[JsonNumber; 2]>,
    /// The derivative of the optimal value f* by p, SI; `null` for the drive as set up.
    pub derivative_of_optimum: JsonNumber,
}

impl<'a> SensitivityReport<'a> {
    /// The report of the effects `found` on the drive as set up or, if there is an optimum `best`,
    /// on the optimal drive. For each parameter, `totals` has the sensitivity of the optimal value,
    /// or the error if the sensitivity cannot be computed. `totals` is empty without an optimum.
    pub fn new(
        found: &'a [Effects],
        best: Option<&Optimum>,
        totals: &[(&'static Parameter, Result<Sensitivity>)],
    ) -> Self {
        let optimized = best.map(|best| best.search.outcome());
        let outcomes = found.iter().map(|effects| {
            let is_optimized = optimized == Some(effects.of);
            OutcomeEffects::new(effects, if is_optimized { totals } else { &[] })
        });
        Self {
            found,
            optimized,
            outcomes: outcomes.collect(),
            at_optimum: best.map(OptimumReport::new),
        }
    }
}

impl OutcomeEffects {
    /// The effects on an outcome; `totals` are the sensitivities of its optimal value.
    fn new(effects: &Effects, totals: &[(&'static Parameter, Result<Sensitivity>)]) -> Self {
        let total = |parameter: &Parameter| {
            let (_, sensitivity) = totals.iter().find(|(other, _)| *other == parameter)?;
            Some(sensitivity.as_ref().ok()?.value)
        };
        let effect = |effect: &Effect| {
            let sigma_effect = effect.sigma_effect.as_ref();
            EffectReport {
                parameter: effect.parameter.name,
                derivative: effect.gradient.into(),
                elasticity: effect.elasticity.into(),
                standard_uncertainty: sigma_effect.map(|one| one.sigma.value).into(),
                source: sigma_effect.map(|one| one.sigma.source.unwrap_or(STATED)),
                effect: sigma_effect.map(|one| one.first_order).into(),
                second_order: sigma_effect.and_then(|one| one.second_order).into(),
                flown: sigma_effect.map(|one| one.flown.map(JsonNumber::from)),
                derivative_of_optimum: total(effect.parameter).into(),
            }
        };
        Self {
            of: effects.of,
            value: effects.value.into(),
            standard_uncertainty: effects.standard_uncertainty().into(),
            linearity: effects.linearity().into(),
            effects: effects.effects.iter().map(effect).collect(),
        }
    }
}

impl Report for SensitivityReport<'_> {
    const COMMAND: &'static str = "sensitivity";

    /// For each outcome, the effects of uncertainties, then the derivatives.
    fn document(&self, system: System) -> Document {
        let at = if self.at_optimum.is_some() {
            "at the optimum"
        } else {
            NamedDrive::AS_SET_UP
        };
        let mut document = Document::default();
        for (effects, report) in self.found.iter().zip(&self.outcomes) {
            let of = effects.of;
            let value = shown::both(of, effects.value, system);
            document.list([Line::flush(format!("{} = {value}, {at}", of.name()))]);
            let sigma_effects: Vec<SigmaEffect> = effects.sigma_effects().copied().collect();
            if !sigma_effects.is_empty() {
                document.add(uncertainties(effects, &sigma_effects, system));
                let source = |SigmaEffect { sigma, .. }: &SigmaEffect| {
                    Some((sigma.parameter.name, sigma.source?.to_owned()))
                };
                let sources = by_reason(sigma_effects.iter().filter_map(source)).into_iter();
                let lines = sources.map(|line| Line::item(format!("default of {line}")));
                let defaults = DocumentBlock::List(lines.collect());
                document.add_detail(defaults, Detail::WithAll);
            }
            let is_optimized = self.optimized == Some(of);
            let of_optimum = is_optimized.then_some(&report.effects[..]);
            document.add(slopes(effects, of_optimum, system));
        }
        document
    }
}

/// The effects of uncertainties on an outcome, with the size of the second-order terms.
fn uncertainties(
    effects: &Effects,
    sigma_effects: &[SigmaEffect],
    system: System,
) -> DocumentTable {
    let of = effects.of;
    let head = [
        "uncertainty of",
        "±σ",
        "effect",
        "second order",
        "flown at −σ",
        "flown at +σ",
    ];
    let rows = sigma_effects
        .iter()
        .map(|sigma_effect| cells_of_sigma(sigma_effect, of, system));
    let mut table = DocumentTable::new(head, rows).right(1..=5);
    table.first_rows = FIRST_ROWS;
    table.remark(format!(
        "together ±{} to first order, for independent parameters; this leaves out the second-order \
         terms, whose sizes add up to {}",
        shown::difference(of, effects.standard_uncertainty(), system),
        shown::difference(of, effects.linearity(), system),
    ));
    let without: Vec<&str> = effects
        .effects
        .iter()
        .filter(|effect| shown::is_without(effects, effect))
        .map(|effect| effect.parameter.name)
        .collect();
    if !without.is_empty() {
        table.remark(format!(
            "{} does not depend on {} here",
            of.name(),
            without.join(", ")
        ));
    }
    table
}

/// The derivatives of an outcome. `of_optimum` has the derivatives of its optimal value; `None` if
/// the outcome is not optimized.
fn slopes(effects: &Effects, of_optimum: Option<&[EffectReport]>, system: System) -> DocumentTable {
    let of = effects.of;
    let rate = |slope: f64, parameter: &Parameter| {
        shown::slope(of, effects.value, parameter, slope, system, 5)
    };
    let row = |(i, effect): (usize, &Effect)| {
        let parameter = effect.parameter;
        let gradient = shown::zero_if_rounding(effect.gradient, effects.value, of, &[parameter]);
        let elasticity = effect.elasticity.map_or(shown::NONE.into(), |elasticity| {
            significant(if gradient == 0.0 { 0.0 } else { elasticity }, 4)
        });
        let mut row = vec![
            parameter.name.into(),
            rate(effect.gradient, parameter),
            elasticity,
        ];
        row.extend(of_optimum.map(|reports| {
            let slope = reports[i].derivative_of_optimum.0;
            slope.map_or(shown::NONE.into(), |slope| rate(slope, parameter))
        }));
        row
    };
    let mut head = vec!["by", "slope", "elasticity"];
    head.extend(of_optimum.map(|_| "slope of the optimum"));
    let columns = head.len();
    let rows = effects.effects.iter().enumerate().map(row);
    let mut table = DocumentTable::new(head, rows).right(1..columns);
    table.first_rows = FIRST_ROWS;
    table
}

fn cells_of_sigma(sigma_effect: &SigmaEffect, of: Outcome, system: System) -> Vec<String> {
    let change = |value: f64| shown::change(of, value, system);
    let or_dash = |value: Option<f64>| value.map_or(shown::NONE.into(), change);
    let [below, above] = sigma_effect.flown;
    let sigma = sigma_effect.sigma;
    vec![
        sigma.parameter.name.into(),
        format!(
            "±{}",
            shown::stated_difference(sigma.parameter, sigma.value, system)
        ),
        change(sigma_effect.first_order),
        or_dash(sigma_effect.second_order),
        or_dash(below),
        or_dash(above),
    ]
}
