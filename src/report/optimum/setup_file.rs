//! The setup at an optimum as a setup file.

use super::super::setup_file::{CommentedSetup, about_constraint, remarks_on_varied};
use super::super::shown;
use super::super::uncertainty::distribution_text;
use crate::parameters::SetupFile;
use crate::study::Optimum;
use crate::study::swings::Swings;
use crate::units::{System, counted};

/// The setup at an optimum for a setup file. `interrupted` is the message about interrupted
/// searches, if there are any. `file` is the setup file or preset that the request names. Comments
/// are in the units of `system`.
pub fn optimum_setup(
    optimum: &Optimum,
    swings: Option<&Swings>,
    interrupted: Option<String>,
    file: &SetupFile,
    system: System,
) -> CommentedSetup {
    let search = &optimum.search;
    let value = optimum
        .value()
        .map_or(shown::NONE.into(), |value| match search.of.outcome() {
            Some(of) => shown::both(of, value, system),
            None => shown::goal(&search.of, value, system),
        });
    let over = match search.scenarios.is_one_drive() {
        true => String::new(),
        false => {
            let count = search.scenarios.points.len() as u64;
            format!(" over {}", counted(count, "swing"))
        }
    };
    let mut about = vec![format!(
        "{}, {}{over}: {value}",
        file.name,
        search.sense.best_of(&search.of)
    )];
    match swings {
        None => {}
        Some(Swings::Recorded { .. }) => about.push("over recorded swings".into()),
        Some(Swings::Distributed { inputs, .. }) => about.extend(inputs.iter().map(|input| {
            let distribution = distribution_text(input, system);
            format!("over swings: {} {distribution}", input.parameter.name)
        })),
    }
    about.extend(search.subject_to.iter().map(about_constraint));
    about.extend(
        interrupted.map(|interrupted| format!("interrupted: {interrupted}; the best so far:")),
    );
    let message = optimum.message().in_units(system);
    about.push(format!("{}: {message}", optimum.status()));
    CommentedSetup {
        setup: optimum.setup,
        about,
        remarks: remarks_on_varied("optimum", &search.vary, &optimum.solution.x),
    }
}
