//! What is asked of shots, in a file and of those that are sent alike: the outcomes, the setup, and
//! how they are integrated.

use crate::command::args::Fly;
use crate::command::names::outcomes;
use crate::command::request::Request;
use crate::drive::OutcomeGroup;
use crate::shots::Flying;
use crate::{Error, Outcome, Result, Setup};

/// The outcomes asked for.
pub fn asked(args: &Fly) -> Result<Vec<Outcome>> {
    let is_all = args.of.iter().any(|name| name.trim() == "all");
    let of = outcomes(&args.of)?;
    Ok(if is_all {
        of.into_iter()
            .filter(|of| of.group() == OutcomeGroup::Flight)
            .collect()
    } else {
        of
    })
}

/// The setup: its ball, air and law are those of the flights, and the rows have the launches.
pub fn setup(request: &Request, rows: &str) -> Result<Setup<f64>> {
    let setup = *request.partial_setup();
    if setup.launch.is_given() {
        let source = format!("{rows} give the launch of each ball; leave this out").into();
        return Err(Error::Unreadable {
            name: request.launch_from(),
            source,
        });
    }
    request.refuse_club(&format!("{rows} are launches"))?;
    Ok(setup)
}

/// Shots as these are flown, integrated as many drives are.
pub fn followed(
    request: &Request,
    setup: &Setup<f64>,
    of: &[Outcome],
    new: impl Fn(&Setup<f64>) -> Result<Flying>,
) -> Result<Flying> {
    // what is wrong with the question is said before anything is flown
    new(setup)?;
    match request.accuracy_for_many(setup, &Flying::usual(setup)?, of)? {
        Some(found) => new(&found.applied_to(setup))?.with_largest_defect(found.largest_defect),
        None => new(setup),
    }
}
