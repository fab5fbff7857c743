//! The gain from the drive as set up to the optimum: first with the best club alone, then with the
//! best swing too.

use super::findings::Findings;
use super::numbers::outcome;
use crate::drive::{Drive, Outcome};
use crate::parameters::{Setup, UNSET};
use crate::report::frame::both;
use crate::report::shown::{self, capital};
use crate::study::Optimum;
use maud::{Markup, html};

/// A column of the table: a drive with its setup.
struct DriveColumn<'a> {
    name: &'static str,
    setup: &'a Setup<f64>,
    drive: Option<&'a Drive<f64>>,
}

/// A table of outcomes and varied parameters. Its columns are the drive as set up, the best club
/// with the same swing (if it is known), and the optimum. The first outcome is that of the report;
/// carry and total are always shown together.
pub(super) fn steps(findings: &Findings, best: &Optimum) -> Markup {
    let columns = columns(findings, best);
    let outcomes = match findings.of {
        Outcome::Carry => vec![Outcome::Carry, Outcome::Total],
        Outcome::Total => vec![Outcome::Total, Outcome::Carry],
        of => vec![of],
    };
    html! {
        table.steps {
            thead { tr { th { "drive" } @for column in &columns { th.number { (column.name) } } } }
            tbody {
                @for of in outcomes {
                    tr {
                        td { (capital(&shown::words(of.name()))) }
                        @for column in &columns {
                            td.number { (outcome(of, column.drive.and_then(|drive| of.value(drive)))) }
                        }
                    }
                }
                @for vary in &best.search.vary {
                    tr {
                        td { (capital(&shown::words(vary.parameter.name))) }
                        @for column in &columns {
                            td.number {
                                (both(|system| column.setup.value(vary.parameter).map_or(UNSET.into(), |value| {
                                    shown::parameter(vary.parameter, value, system)
                                })))
                            }
                        }
                    }
                }
            }
        }
    }
}

fn columns<'a>(findings: &'a Findings, best: &'a Optimum) -> Vec<DriveColumn<'a>> {
    let yours = DriveColumn {
        name: "yours",
        setup: &findings.setup,
        drive: findings.flown.first().map(|flown| &flown.drive),
    };
    let club = findings.club_alone.as_ref().map(|club| DriveColumn {
        name: "best club alone",
        setup: &club.optimum.setup,
        drive: club.optimum.drive.as_ref(),
    });
    let best = DriveColumn {
        name: if club.is_some() {
            "best club and swing"
        } else {
            "best"
        },
        setup: &best.setup,
        drive: best.drive.as_ref(),
    };
    std::iter::once(yours).chain(club).chain([best]).collect()
}
