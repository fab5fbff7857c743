//! The request of `fly`: outcomes, setup and integration.

use super::args::Args;
use crate::command::names::outcomes;
use crate::command::request::Request;
use crate::drive::OutcomeGroup;
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

/// The [`Flying`] that `new` makes for the setup with the integration method and step of
/// [`Request::integration`].
pub fn flying_within_tolerance(
    request: &Request,
    setup: &Setup<f64>,
    of: &[Outcome],
    new: impl Fn(&Setup<f64>) -> Result<Flying>,
) -> Result<Flying> {
    // report errors in the request before the first flight
    new(setup)?;
    let found = request.integration(setup, &Flying::usual(setup)?, of)?;
    new(&found.setup)?.with_largest_defect(found.largest_defect)
}
