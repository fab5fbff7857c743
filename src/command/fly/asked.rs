//! What is asked of shots, in a file and of those that are sent alike: the outcomes, the setup, and
//! how they are integrated.

use crate::command::args::{Fly, Question};
use crate::command::names::outcomes;
use crate::drive::Part;
use crate::shots::Flying;
use crate::{Error, Outcome, Result, Setup};

/// The outcomes asked for.
pub fn asked(args: &Fly) -> Result<Vec<Outcome>> {
    let is_all = args.of.iter().any(|name| name.trim() == "all");
    let of = outcomes(&args.of)?;
    Ok(if is_all {
        of.into_iter()
            .filter(|of| of.part() == Part::Flight)
            .collect()
    } else {
        of
    })
}

/// The setup: its ball, air and law are those of the flights, and the rows have the launches.
pub fn setup(question: &Question, rows: &str) -> Result<Setup<f64>> {
    let setup = question.setup_of_points()?;
    if setup.launch.is_given() {
        let source = format!("{rows} give the launch of each ball; leave this out").into();
        return Err(Error::Unreadable {
            name: question.launch_from(),
            source,
        });
    }
    question.refuse_club(&setup, &format!("{rows} are launches"))?;
    Ok(setup)
}

/// Shots as these are flown, integrated as many drives are.
pub fn followed(
    question: &Question,
    setup: &Setup<f64>,
    of: &[Outcome],
    new: impl Fn(&Setup<f64>) -> Result<Flying>,
) -> Result<Flying> {
    // what is wrong with the question is said before anything is flown
    new(setup)?;
    match question.accuracy(setup, &Flying::usual(setup)?, of)? {
        Some(found) => new(&found.applied_to(setup))?.with_largest_defect(found.largest_defect),
        None => new(setup),
    }
}
