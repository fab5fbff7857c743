use super::map::capital;
use crate::drive::Outcome;
use crate::report::plot::{Axis, Bar, Figure, Hue, Layer, Measure};

/// What a parameter does to an outcome, to both sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// The parameter and how far it goes: "swing.speed ± 1 mph".
    pub name: String,
    /// What the outcome changes by where the parameter is lower, SI.
    pub lower: f64,
    /// And where it is higher.
    pub higher: f64,
}

/// Most bars of a tornado: the largest; the others are counted in the note.
const MOST: usize = 15;

/// Effects of parameters on an outcome as bars, the largest on top.
pub fn tornado_figure(of: Outcome, effects: &[Effect]) -> Figure {
    let size = |effect: &Effect| effect.lower.abs().max(effect.higher.abs());
    let mut ranked: Vec<&Effect> = effects.iter().collect();
    ranked.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let left_out = ranked.len().saturating_sub(MOST);
    ranked.truncate(MOST);

    let measure = Measure::outcome(of);
    let x = Axis::linear(Measure { label: format!("change of {}", measure.label), ..measure.clone() });
    let y = Axis::names(ranked.iter().map(|effect| effect.name.clone()));
    let bars = |name: &str, hue: usize, to: fn(&Effect) -> f64| {
        let bars = ranked.iter().enumerate().map(|(place, effect)| Bar { place, from: 0.0, to: to(effect) });
        Layer::Bars { name: name.into(), hue: Hue::Series(hue), bars: bars.collect() }
    };
    let title = format!("What moves {}", measure.label);
    let mut figure = Figure::new(format!("tornado-{}", of.name()), title, x, y)
        .with(bars("parameter lower", 1, |effect| effect.lower))
        .with(bars("parameter higher", 0, |effect| effect.higher));
    // as tall as its bars take
    figure.aspect = 0.13 + 0.075 * ranked.len() as f64;
    let rest = if left_out == 0 { String::new() } else { format!(" {left_out} smaller ones are not shown.") };
    figure.noted(format!("{} at each parameter's stated uncertainty, one at a time.{rest}", capital(&measure.label)))
}
