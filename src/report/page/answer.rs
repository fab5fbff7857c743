//! The summary at the beginning of a page: the drive as set up, the optimal drive, and the changes
//! between them.

use super::findings::Findings;
use super::gain::steps;
use super::numbers::{from_to, outcome};
use crate::report::frame::both;
use crate::report::limits::Objective;
use crate::report::optimum::bound_in_words;
use crate::report::shown::{self, capital};
use crate::study::{Effects, Optimum};
use crate::units::{DisplayUnit, System, significant, with_unit};
use maud::{Markup, html};

/// Maximum number of parameters named as sources of the uncertainty.
const NAMED: usize = 3;

/// If an uncertainty is more than this fraction of a larger one, both may be equal as shown, with
/// two digits.
const ALIKE: f64 = 0.9;

/// The summary at the beginning of the page.
pub(super) fn answer(findings: &Findings) -> Markup {
    let yours = findings
        .flown
        .first()
        .and_then(|flown| findings.of.value(&flown.drive));
    let best = findings.best().and_then(|best| Some((best, best.value()?)));
    html! {
        section.answer {
            h2 { (headline(findings, yours, best.map(|(_, value)| value))) }
            @if let Some(why) = findings.why_not_flown() { p.warning { "As set up: " (both(|system| why.in_units(system))) } }
            @if let Some(why) = &findings.why_none { p.warning { (both(|system| why.in_units(system))) } }
            @if yours.or(best.map(|(_, value)| value)).is_some() { (tiles(findings, yours, best.map(|(_, value)| value))) }
            @if let Some((best, _)) = best {
                (steps(findings, best))
                (limits(best))
            }
            (what_is_known(findings))
            @if !findings.advice.is_empty() { p { (capital(&shown::spoken(&findings.advice))) "." } }
        }
    }
}

/// The result in a line: "Carry 286.8 → 301.2 yd: +14.3 yd".
fn headline(findings: &Findings, yours: Option<f64>, best: Option<f64>) -> Markup {
    let of = findings.of;
    let name = capital(&shown::words(of.name()));
    both(|system| {
        let show = |value: f64| shown::outcome(of, value, system);
        match (yours, best) {
            (Some(yours), Some(best)) => {
                let change = shown::change_as_displayed(of, yours, best, system);
                format!("{name} {}: {change}", from_to(&show(yours), &show(best)))
            }
            (None, Some(best)) => {
                format!(
                    "{name} {} at best; as set up there is no {}",
                    show(best),
                    shown::words(of.name())
                )
            }
            (Some(yours), None) if findings.found.is_some() => {
                format!("{name} {}; no best drive was found", show(yours))
            }
            (Some(yours), None) => format!("{name} {}", show(yours)),
            (None, None) if findings.why_not_flown().is_some() => {
                format!("No {}: the ball does not fly", shown::words(of.name()))
            }
            (None, None) => format!("As set up there is no {}", shown::words(of.name())),
        }
    })
}

fn tiles(findings: &Findings, yours: Option<f64>, best: Option<f64>) -> Markup {
    let of = findings.of;
    let [at_yours, at_best] = [findings.effects_of(of), findings.at_best.as_ref()];
    let two_digits = |size: f64, system: System| {
        let number = size / DisplayUnit::from(of).size_in(system);
        with_unit(&significant(number, 2), system.unit(of.unit()))
    };
    let of_change = at_yours.zip(at_best).and_then(|(yours, best)| {
        let uncertainty = yours.uncertainty_of_change(best);
        let rounding = 1e-9 * yours.standard_uncertainty();
        (uncertainty > rounding).then_some(uncertainty)
    });
    let known = |uncertainty: Option<f64>| {
        let uncertainty = uncertainty.filter(|uncertainty| *uncertainty > 0.0);
        html! { @if let Some(size) = uncertainty { dd.known { "± " (both(|system| two_digits(size, system))) } } }
    };
    html! {
        dl.tiles {
            div { dt { "yours" } dd { (outcome(of, yours)) } (known(at_yours.map(Effects::standard_uncertainty))) }
            @if let Some(best) = best {
                div.best { dt { "best" } dd { (outcome(of, Some(best))) } (known(at_best.map(Effects::standard_uncertainty))) }
                @if let Some(yours) = yours {
                    div {
                        dt { "change" }
                        dd { (both(|system| shown::change_as_displayed(of, yours, best, system))) }
                        (known(of_change))
                    }
                }
            }
        }
    }
}

/// The active bounds and constraints with their multipliers.
fn limits(best: &Optimum) -> Markup {
    let varied = best.search.vary.iter().enumerate();
    let at_bound = varied.filter(|(i, _)| is_at_bound(best, *i));
    let bounds = at_bound.map(|(i, vary)| {
        both(|system| {
            let name = capital(&shown::words(vary.parameter.name));
            let to = shown::parameter(vary.parameter, best.solution.x[i], system);
            format!("{name} {to}, {}", bound_in_words(best, i, system))
        })
    });
    let objective = Objective::at(best);
    let limits = best.constraints();
    let limits = limits.iter().filter_map(|limit| {
        objective.active_limit(limit, System::default())?;
        Some(both(|system| {
            let of = shown::constraint(limit.constraint, system);
            let price = objective.active_limit(limit, system);
            format!("Limited by {of}: {}", price.unwrap_or_default())
        }))
    });
    let lines: Vec<Markup> = bounds.chain(limits).collect();
    html! { @if !lines.is_empty() { ul { @for line in lines { li { (line) } } } } }
}

/// True if varied parameter `i` is fixed, or at a bound or a corner of the converged optimum `best`.
fn is_at_bound(best: &Optimum, i: usize) -> bool {
    let Optimum {
        search, solution, ..
    } = best;
    if search.vary[i].low == search.vary[i].high {
        return true;
    }
    let is_corner = solution.kink.is_some_and(|kink| kink.variable == i);
    is_corner || solution.lower_multipliers[i].max(solution.upper_multipliers[i]) > 0.0
}

/// The sentence about the uncertainty after ±. It names the parameters that cause the uncertainty.
fn what_is_known(findings: &Findings) -> Markup {
    let of = findings
        .effects_of(findings.of)
        .filter(|effects| effects.standard_uncertainty() > 0.0);
    let Some(effects) = of else { return html! {} };
    let moving = effects.sigma_effects();
    let moving: Vec<_> = moving.filter(|effect| effect.first_order != 0.0).collect();
    let names: Vec<String> = moving
        .iter()
        .take(NAMED)
        .map(|effect| shown::words(effect.sigma.parameter.name))
        .collect();
    let others = match moving.len().saturating_sub(NAMED) {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    // an error that moves the drives in opposite directions makes the change less certain
    let is_change_known_better = findings.at_best.as_ref().is_some_and(|best| {
        let of_drives = [effects, best].map(Effects::standard_uncertainty);
        effects.uncertainty_of_change(best) < ALIKE * of_drives[0].min(of_drives[1])
    });
    html! {
        p.faint {
            "± is one standard uncertainty. It comes from " (names.join(", ")) (others) " together."
            @if is_change_known_better {
                " An error that both drives share partly cancels in the change, so the change is \
                 known better."
            }
        }
    }
}
