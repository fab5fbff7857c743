//! The sections of a page with texts and tables.

use super::findings::{EXPLORER_FILE, Findings, SETUP_FILE};
use super::numbers::outcome;
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::Result;
use crate::parameters::{METHOD, is_of_strike};
use crate::report::certificate::add_derivatives;
use crate::report::document::{Document, content};
use crate::report::frame::{both, chosen, scrolled};
use crate::report::in_both::InBoth;
use crate::report::optimum::add_varied_and_constraints;
use crate::report::presets::{SourcedValue, sources};
use crate::report::sensitivity::STATED;
use crate::report::shown::{self, capital};
use crate::study::certificate::DerivativeRow;
use crate::study::{Effects, NamedDrive, Optimum};
use crate::units::{counted, typeset};
use maud::{Markup, html};

/// The numbers of a launch monitor, for the drive as set up.
pub(super) fn panel(findings: &Findings) -> Markup {
    const SHOWN: [Outcome; 10] = [
        Outcome::BallSpeed,
        Outcome::SmashFactor,
        Outcome::LaunchAngle,
        Outcome::Backspin,
        Outcome::SpinAxis,
        // launch monitors call `CarryDistance` carry
        Outcome::CarryDistance,
        Outcome::Lateral,
        Outcome::ApexHeight,
        Outcome::DescentAngle,
        Outcome::FlightTime,
    ];
    let Some(first) = findings.flown.first() else {
        return html! {};
    };
    let inputs = ["swing.speed", "swing.attack_angle"]
        .into_iter()
        .filter_map(|name| findings.setup.variable(name).ok());
    html! {
        dl.panel {
            @for row in inputs {
                @if let Some(value) = findings.setup.value(row) {
                    div { dt { (shown::words(row.name)) } dd { (both(|system| shown::with_digits(row, value, system, shown::IN_SUMMARY))) } }
                }
            }
            @for of in SHOWN {
                div { dt { (shown::words(of.name())) } dd { (outcome(of, of.value(&first.drive))) } }
            }
        }
    }
}

/// Every outcome of each drive.
pub(super) fn outcomes(flown: &[NamedDrive]) -> Markup {
    html! {
        (scrolled("Launch and flight", html! { table {
            thead { tr { th { "outcome" } @for one in flown { th.number { (one.role.name()) } } th.doc { "what \
                it is" } } }
            tbody {
                @for of in Outcome::in_group(OutcomeGroup::Launch).chain(Outcome::in_group(OutcomeGroup::Flight)) {
                    tr {
                        td { (shown::words(of.name())) }
                        @for one in flown { td.number { (outcome(of, of.value(&one.drive))) } }
                        td.faint.doc { (of.doc()) }
                    }
                }
            }
        } }))
    }
}

/// The optimum: its value, the varied parameters with their windows, and the constraints.
///
/// # Errors
/// The errors of [`content`].
pub(super) fn optimum(findings: &Findings, best: &Optimum) -> Result<Markup> {
    let flatness = findings.flatness.as_ref();
    let around = flatness.map(|flatness| flatness.windows_with(findings.club_alone.as_ref()));
    let of = best.search.outcome();
    let tables = InBoth::of(|system| {
        let mut document = Document::new("The optimum");
        add_varied_and_constraints(&mut document, best, around.as_ref(), system);
        document.map_texts(shown::spoken)
    });
    Ok(html! {
        p { (capital(best.search.sense.adjective())) " " (shown::words(of.name())) ": " strong { (outcome(of, best.value())) } "." }
        (content(&tables, true)?)
    })
}

/// A table of the standard uncertainties in the tornado plots, with their sources.
pub(super) fn uncertainties(effects: &[Effects]) -> Markup {
    let Some(first) = effects.first() else {
        return html! {};
    };
    let sigmas = first.sigma_effects().map(|effect| effect.sigma);
    html! {
        (scrolled("Uncertainties", html! { table.told {
            thead { tr { th { "parameter" } th.number { "standard uncertainty" } th { "source" } } }
            tbody {
                @for sigma in sigmas {
                    tr {
                        td { (shown::words(sigma.parameter.name)) }
                        td.number { (both(|system| shown::difference_with_digits(sigma.parameter, sigma.value, system, shown::OF_SIGMA))) }
                        td.words.source { (typeset(sigma.source.unwrap_or(STATED))) }
                    }
                }
            }
        } }))
    }
}

/// The derivatives and their verdicts.
///
/// # Errors
/// The errors of [`content`].
pub(super) fn verdicts(rows: &[DerivativeRow]) -> Result<Markup> {
    let mut document = Document::new("Derivatives");
    add_derivatives(&mut document, rows);
    content(&InBoth::of(|_| document.clone()), true)
}

/// Every number of the setup, with its source.
pub(super) fn setup(findings: &Findings) -> Result<Markup> {
    let is_launched = findings.setup.launch.is_given();
    let InBoth { metric, us } =
        InBoth::of(|system| sources(&findings.setup, &findings.file, Some(system)));
    let rows = us?.into_iter().zip(metric?);
    let rows = rows.filter(|(us, _)| !(is_launched && is_of_strike(us.name)));
    Ok(html! {
        p.faint {
            "All numbers of the setup and their sources; it is based on the preset "
            (findings.file.preset.name) "."
            @if is_launched { " Those of swing, club, strike and impact are left out: no club \
                               strikes the ball." }
        }
        (scrolled("The setup", html! { table.told {
            thead { tr { th { "parameter" } th.number { "value" } th { "source" } } }
            tbody {
                @for (us, metric) in rows {
                    tr {
                        td { (us.name) }
                        td.number { (chosen(&metric.value, &us.value)) }
                        td.words.source {
                            (chosen(&source_of(findings, &metric), &source_of(findings, &us)))
                        }
                    }
                }
            }
        } }))
    })
}

/// The source of a value. A remark replaces it if the program chose the value (method or step), or
/// if the launch states its spin by other parameters.
fn source_of(findings: &Findings, row: &SourcedValue) -> String {
    let (flown, stated) = (&findings.setup, &findings.stated);
    let is_chosen = match row.name {
        METHOD => flown.method != stated.method,
        "flight.step" => flown.flight.step != stated.flight.step,
        _ => false,
    };
    if is_chosen {
        return "chosen by the program for the accuracy of the flight".into();
    }
    // a stated launch has its total spin and spin axis, or its backspin and sidespin
    let is_total = |name: &str| ["launch.spin", "launch.spin_axis"].contains(&name);
    let is_in_parts = |name: &str| ["launch.backspin", "launch.sidespin"].contains(&name);
    let given = stated.given_launch_conditions();
    let spin = given
        .iter()
        .find(|given| is_in_parts(given.name) || given.name == "launch.spin");
    let is_of_other_form = |spin: &str| {
        if is_total(spin) {
            is_in_parts(row.name)
        } else {
            is_total(row.name)
        }
    };
    match spin {
        Some(spin) if is_of_other_form(spin.name) => {
            format!("not needed: {} is given", shown::words(spin.name))
        }
        _ => row.source.to_string(),
    }
}

/// The link to the explorer with the state of a drive, which is the text after `#`.
pub(super) fn explorer(state: &str) -> Markup {
    html! {
        p {
            "This drive with sliders: "
            a href=(format!("{EXPLORER_FILE}#{state}")) { "the explorer" } "."
        }
    }
}

/// The footer: status of the search, and the command that made the page.
pub(super) fn footer(findings: &Findings) -> Markup {
    html! {
        @if let Some(found) = &findings.found {
            p {
                "The search: " (found.status()) ": " (both(|system| found.message().in_units(system))) " \
                    ("
                (counted(found.solution.iterations, "iteration")) ", " (counted(found.solution.effort.evaluations, "evaluation")) ")."
            }
        }
        p {
            a href=(SETUP_FILE) { (SETUP_FILE) } " is the " (if findings.best().is_some() { "best \
                drive" } else { "drive \
                as set up" })
            ", for " code { "longdrive simulate " (SETUP_FILE) } ". "
            "Made by longdrive " (env!("CARGO_PKG_VERSION")) " on " (findings.date) " with " code { (findings.command) }
        }
    }
}
