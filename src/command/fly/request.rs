//! The request of `fly`: outcomes, setup and integration.

use super::args::Args;
use crate::command::names::outcomes;
use crate::command::request::Request;
use crate::drive::OutcomeGroup;
use crate::parameters::{Parameter, Vary};
use crate::shots::Flying;
use crate::{Outcome, Result, Setup};

/// The outcomes to compute; "all" means all outcomes of the flight.
pub fn requested_outcomes(args: &Args) -> Result<Vec<Outcome>> {
    let is_named = |of: &Outcome| args.of.iter().any(|name| name.trim() == of.name());
    let mut of = outcomes(&args.of)?;
    of.retain(|of| of.group() == OutcomeGroup::Flight || is_named(of));
    Ok(of)
}

/// The setup of ball, air and law. Refuses settings of the launch and of the club, because each
/// shot has a launch of its own. `rows` names the shots in the error.
pub fn setup(request: &Request, rows: &str) -> Result<Setup<f64>> {
    let setup = request.partial_setup;
    request.refuse_launch(
        &setup,
        &format!("{rows} give the launch of each ball; leave this out"),
    )?;
    request.refuse_club(&format!("{rows} are launches"))?;
    Ok(setup)
}

/// The flights of shots, with the integration method and step of [`Request::integration`].
/// `other_parameters` are those of [`Flying::new`].
pub fn flying_within_tolerance(
    request: &Request,
    setup: &Setup<f64>,
    other_parameters: &[&'static Parameter],
    of: &[Outcome],
) -> Result<Flying> {
    // report errors in the request before the first flight
    Flying::new(setup, other_parameters, of)?;
    let ordinary = ordinary_shot(setup, other_parameters)?;
    let ranges = Flying::usual(setup)?;
    request.warn_of_ranges(&ordinary, &ranges);
    request.warn_of_idle_in(&ordinary, &ranges);
    let found = request.integration(&ordinary, &ranges, of)?;
    let setup = found
        .accuracy
        .map_or(*setup, |accuracy| accuracy.applied_to(setup));
    Flying::new(&setup, other_parameters, of)?.with_largest_defect(found.largest_defect)
}

/// The setup with the launch of an ordinary shot. It has the default air if the rows give a part of
/// the air, and no wind if they give a part of the wind: the setup alone may then be incomplete.
fn ordinary_shot(
    setup: &Setup<f64>,
    other_parameters: &[&'static Parameter],
) -> Result<Setup<f64>> {
    let usual = Setup::modern_driver();
    let mut ordinary = Vary::initialized(setup, &Flying::usual(setup)?)?;
    let gives = |group| {
        let mut names = other_parameters.iter().map(|parameter| parameter.name);
        names.any(|name| name.starts_with(group))
    };
    if gives("air.") {
        ordinary.air = usual.air;
    }
    if gives("wind.") {
        ordinary.wind = usual.wind;
    }
    Ok(ordinary)
}
