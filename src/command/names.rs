//! Lists of names on the command line. A repeated name counts once.

use crate::command::output::{note, note_left_out, system};
use crate::derivative::all_variables;
use crate::parameters::Parameter;
use crate::report::total_uncertainty_note;
use crate::study::Sigma;
use crate::{Error, Outcome, Result, Setup};

fn given(names: &[String]) -> impl Iterator<Item = &str> {
    names
        .iter()
        .map(|name| name.trim())
        .filter(|name| !name.is_empty())
}

/// The named outcomes; "all" means every outcome of a drive.
///
/// # Errors
/// For an unknown name, and for a list without names.
pub fn outcomes(names: &[String]) -> Result<Vec<Outcome>> {
    let mut of = Vec::new();
    for name in given(names) {
        let named = if name == "all" {
            Outcome::OF_DRIVES.to_vec()
        } else {
            vec![Outcome::named(name)?]
        };
        of.extend(named);
    }
    if of.is_empty() {
        return Err(Error::Nothing {
            doing: "evaluate",
            what: "outcome",
        });
    }
    let of = once(of);
    note_the_run(&of);
    Ok(of)
}

/// Prints a note on the uncertainty of the roll-out if one of the outcomes depends on the roll-out.
pub fn note_the_run(of: &[Outcome]) {
    if of.iter().any(|of| of.needs_run()) {
        note(&total_uncertainty_note().in_units(system()));
    }
}

/// The parameters to differentiate by, from their names; "all" means every numeric parameter that
/// has a value in this setup.
///
/// If no outcome in `of` depends on the roll-out, "all" excludes the parameters that affect only
/// the roll-out.
pub fn variables(
    setup: &Setup<f64>,
    names: &[String],
    of: &[Outcome],
) -> Result<Vec<&'static Parameter>> {
    let mut rows = Vec::new();
    for name in given(names) {
        if name != "all" {
            rows.push(setup.variable(name)?);
            continue;
        }
        let with_value = setup.variables();
        let left_out = names_besides(&setup.parameters(), &with_value);
        note_left_out(&format!(
            "left out, because they have no value in this setup: {}",
            left_out.join(", ")
        ));
        let all = all_variables(setup, of);
        let idle = names_besides(&with_value, &all);
        if !idle.is_empty() {
            note_left_out(&format!(
                "left out, because they do not affect the requested outcomes: {}",
                idle.join(", ")
            ));
        }
        rows.extend(all);
    }
    Ok(once(rows))
}

/// The names of the parameters in `all` that are not in `chosen`.
fn names_besides(all: &[&'static Parameter], chosen: &[&'static Parameter]) -> Vec<&'static str> {
    let others = all.iter().filter(|parameter| !chosen.contains(parameter));
    others.map(|parameter| parameter.name).collect()
}

/// The stated uncertainties.
pub fn sigmas(setup: &Setup<f64>, stated: &[String]) -> Result<Vec<Sigma>> {
    stated.iter().map(|text| Sigma::read(setup, text)).collect()
}

fn once<T: PartialEq + Copy>(all: Vec<T>) -> Vec<T> {
    let mut seen: Vec<T> = Vec::new();
    for one in all {
        if !seen.contains(&one) {
            seen.push(one);
        }
    }
    seen
}
