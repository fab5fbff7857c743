use crate::report::plot::{Axis, Bar, Figure, Hue, Layer, Measure};
use crate::study::{Effect, Effects, Sigma};
use crate::units::{System, counted, significant};

/// Most bars of a tornado: the largest; the others are counted in the note.
const MOST: usize = 15;

/// Bars below this part of all together have no length to see.
const STILL: f64 = 1e-3;

/// An effect of an uncertainty, to both sides.
struct Ends {
    sigma: Sigma,
    lower: f64,
    higher: f64,
    /// Whether both ends were flown; a straight bar stands for one that could not be.
    is_flown: bool,
}

/// What standard uncertainties of parameters do to an outcome, as bars, the largest on top: flown at p − σ and p + σ, one
/// parameter at a time. The uncertainties, and first in the note, are in the units of `system`.
pub fn tornado_figure(effects: &Effects, system: System) -> Figure {
    let ends = |effect: &Effect| {
        let bar = effect.bar?;
        let [lower, higher] = bar.flown;
        Some(Ends {
            sigma: bar.sigma,
            lower: lower.unwrap_or(-bar.first_order),
            higher: higher.unwrap_or(bar.first_order),
            is_flown: lower.is_some() && higher.is_some(),
        })
    };
    let size = |ends: &Ends| ends.lower.abs().max(ends.higher.abs());
    let (mut ranked, still): (Vec<Ends>, Vec<Ends>) =
        effects.effects.iter().filter_map(ends).partition(|ends| size(ends) > STILL * effects.standard_uncertainty());
    ranked.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let left_out = ranked.len().saturating_sub(MOST);
    ranked.truncate(MOST);
    let still: Vec<String> = still.iter().map(|ends| Measure::parameter(ends.sigma.parameter).label).collect();

    let measure = Measure::outcome(effects.of);
    let names = ranked.iter().map(|ends| {
        let parameter = ends.sigma.parameter;
        let measure = Measure::parameter(parameter);
        let sigma = significant(measure.in_units(ends.sigma.value, system), 3);
        format!("{} ± {sigma} {}", measure.label, system.unit(parameter.unit)).trim_end().to_owned()
    });
    let x = Axis::linear(Measure { label: format!("change of {}", measure.label), ..measure.clone() });
    let bars = |name: &str, hue: usize, to: fn(&Ends) -> f64| {
        let bars = ranked.iter().enumerate().map(|(place, ends)| Bar { place, from: 0.0, to: to(ends) });
        Layer::Bars { name: name.into(), hue: Hue::Series(hue), bars: bars.collect() }
    };
    let title = format!("Effects of uncertainties on {}", measure.label);
    let mut figure = Figure::new(format!("tornado-{}", effects.of.name()), title, x, Axis::names(names))
        .with(bars("parameter lower", 1, |ends| ends.lower))
        .with(bars("parameter higher", 0, |ends| ends.higher));
    // as tall as its bars take
    figure.aspect = 0.16 + 0.11 * ranked.len() as f64;
    figure.noted(note(effects, &ranked, &still, left_out, &measure, system))
}

fn note(
    effects: &Effects,
    ranked: &[Ends],
    still: &[String],
    left_out: usize,
    measure: &Measure,
    system: System,
) -> String {
    let mut note = format!(
        "Change of {} when each parameter is moved by its standard uncertainty, one at a time. All together, if independent: ± {}.",
        measure.label,
        measure.show_both(effects.standard_uncertainty(), system),
    );
    let straight = ranked.iter().filter(|ends| !ends.is_flown).count();
    if straight > 0 {
        let bars = counted(straight as u64, "bar");
        note += &format!(" Drawn from the derivative, since a drive at one end or both does not fly: {bars}.");
    }
    let linearity = effects.linearity();
    if linearity > 0.0 {
        note += &format!(
            " Bars shorter than {} are smaller than what the linear model neglects.",
            measure.show_both(linearity, system)
        );
    }
    if !still.is_empty() {
        note += &format!(" Negligible: {}.", still.join(", "));
    }
    if left_out > 0 {
        note += &format!(" Not shown: {}.", counted(left_out as u64, "smaller effect"));
    }
    note
}
