use crate::parameters::Parameter;
use crate::report::plot::{Axis, Figure, HorizontalBar, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown::{self, difference, is_without};
use crate::study::{self, Effects};
use crate::units::{System, counted};

/// Bars shorter than this fraction of the longest bar are combined in one row.
const SMALL: f64 = 0.02;

/// Maximum number of parameters with a row of their own. One more row combines smaller effects.
const MOST: usize = 15;

/// The uncertainties in a tornado plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "commands", derive(clap::ValueEnum))]
pub enum Causes {
    /// Parameters that you control: delivery, strike and club, or a stated launch.
    Control,
    /// Uncertain inputs of the model: coefficients, ball, air, wind and ground.
    Model,
    /// Both kinds in one picture.
    All,
}

impl Causes {
    /// The causes that a report draws. Each has its own plot, because the scales differ.
    pub const APART: [Self; 2] = [Self::Control, Self::Model];

    /// True if the causes contain this parameter.
    pub fn has(self, parameter: &Parameter) -> bool {
        match self {
            Self::Control => parameter.is_controlled(),
            Self::Model => !parameter.is_controlled(),
            Self::All => true,
        }
    }
}

/// The changes of the outcome at p − σ and at p + σ of the parameter p. If one of these drives does
/// not fly, the first-order effect replaces the change.
fn ends(effect: &study::SigmaEffect) -> [f64; 2] {
    let [lower, higher] = effect.flown;
    [
        lower.unwrap_or(-effect.first_order),
        higher.unwrap_or(effect.first_order),
    ]
}

fn size(effect: &study::SigmaEffect) -> f64 {
    let [lower, higher] = ends(effect);
    lower.abs().max(higher.abs())
}

/// The effects of standard uncertainties on an outcome of the drive as set up, as bars, the largest
/// on top. The bar of a parameter p shows drives computed at p − σ and p + σ; the other parameters
/// are unchanged. The uncertainties and the note are in the units of `system`. `None` if none of
/// `causes` has an effect.
pub fn tornado_figure(effects: &Effects, causes: Causes, system: System) -> Option<Figure> {
    let of_causes = effects.of_parameters(|parameter| causes.has(parameter));
    let mut ranked: Vec<study::SigmaEffect> = of_causes
        .effects
        .iter()
        .filter_map(|effect| effect.sigma_effect)
        .collect();
    ranked.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let longest = ranked.first().map(size).filter(|longest| *longest > 0.0)?;
    let quantity = NamedQuantity::outcome(effects.of);
    // bars that are long enough to be visible, at most `MOST`
    let seen = ranked
        .iter()
        .take_while(|effect| size(effect) > SMALL * longest)
        .count()
        .min(MOST);
    let folded = ranked.split_off(seen);
    let names = row_names(effects, &ranked, &folded, system);
    let label = &quantity.label;
    let (suffix, title) = match causes {
        Causes::Control => (
            "-control",
            format!("Effects on {label} of what you control"),
        ),
        Causes::Model => (
            "-model",
            format!("Effects on {label} of what the model does not know"),
        ),
        Causes::All => ("", format!("Effects of uncertainties on {label}")),
    };
    let x = Axis::linear(NamedQuantity {
        label: format!("change of {label}"),
        ..quantity.clone()
    });
    let bars = |name: &str, hue: Hue, end: usize| {
        let bars = ranked
            .iter()
            .enumerate()
            .map(|(row, effect)| HorizontalBar {
                row,
                to: ends(effect)[end],
            });
        Layer::new(name, hue, Shape::Bars(bars.collect()))
    };
    let figure = Figure::new(
        system,
        format!("tornado-{}{suffix}", effects.of.name()),
        format!("{title}, as set up"),
        x,
        Axis::names(names),
    )
    .with(bars("parameter lower", Hue::Series(3), 0))
    .with(bars("parameter higher", Hue::Series(2), 1));
    Some(figure.noted(note(effects, causes, &ranked, &folded, system)))
}

/// The names of the rows: the ranked causes, then one row for all smaller causes together.
fn row_names(
    effects: &Effects,
    ranked: &[study::SigmaEffect],
    folded: &[study::SigmaEffect],
    system: System,
) -> Vec<String> {
    let mut names: Vec<String> = ranked
        .iter()
        .map(|effect| shown::with_sigma(&effect.sigma, system))
        .collect();
    if folded.is_empty() {
        return names;
    }
    let is_folded = |parameter: &Parameter| {
        let mut folded = folded.iter();
        folded.any(|folded| folded.sigma.parameter == parameter)
    };
    let of_row = effects.of_parameters(is_folded);
    let mut effects_of_row = of_row.effects.iter();
    let amount = if effects_of_row.all(|effect| is_without(&of_row, effect)) {
        "no effect".into()
    } else {
        let together = difference(effects.of, of_row.standard_uncertainty(), system);
        format!("together ± {together}")
    };
    names.push(format!("{} more: {amount}", folded.len()));
    names
}

fn note(
    effects: &Effects,
    causes: Causes,
    ranked: &[study::SigmaEffect],
    folded: &[study::SigmaEffect],
    system: System,
) -> String {
    let quantity = NamedQuantity::outcome(effects.of);
    let of_causes = |causes: Causes| effects.of_parameters(|parameter| causes.has(parameter));
    let together = |causes: Causes| {
        let uncertainty = of_causes(causes).standard_uncertainty();
        difference(effects.of, uncertainty, system)
    };
    let mut note = format!(
        "Change of {} when each parameter is moved by its standard uncertainty, one at a time, \
         as set up. All together, if independent: ± {} to first order; the sizes of the \
         second-order terms add up to {}.",
        quantity.label,
        together(causes),
        difference(effects.of, of_causes(causes).linearity(), system),
    );
    match causes {
        Causes::Control => {
            note += &format!(
                " The uncertain inputs of the model cause a separate uncertainty of ± {}.",
                together(Causes::Model)
            )
        }
        Causes::Model => {
            note += &format!(
                " The parameters that you control cause a separate uncertainty of ± {}.",
                together(Causes::Control)
            )
        }
        Causes::All => {}
    }
    let is_straight = |effect: &&study::SigmaEffect| effect.flown.iter().any(Option::is_none);
    let straight = ranked.iter().filter(is_straight).count();
    if straight > 0 {
        let bars = counted(straight as u64, "bar");
        note += &format!(
            " Drawn from the derivative, since a drive at one end or both does not fly: {bars}."
        );
    }
    if !folded.is_empty() {
        let names: Vec<String> = folded
            .iter()
            .map(|effect| shown::words(effect.sigma.parameter.name))
            .collect();
        note += &format!(" In the last row: {}.", names.join(", "));
    }
    note
}
