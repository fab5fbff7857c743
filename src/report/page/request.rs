//! The request: the title of the page, and a summary in a few lines.

use super::findings::Findings;
use super::numbers::from_to;
use crate::error::Result;
use crate::parameters::{Parameter, Vary};
use crate::report::conditions;
use crate::report::frame::{both, chosen};
use crate::report::in_both::InBoth;
use crate::report::presets::{ChangedSetting, used_changes};
use crate::report::shown;
use crate::study::Search;
use crate::units::{System, counted};
use maud::{Markup, html};

/// Maximum number of changes that the title names. If there are more, the title names `NAMED − 1`
/// and counts the rest.
const NAMED: usize = 3;

/// The title of the page: the setup or the stated launch, and the first changes of the setup.
pub(super) fn title(findings: &Findings, system: System) -> Result<String> {
    // a setup file has a name of its own, which is the title
    if findings.name != findings.file.preset.name {
        return Ok(findings.name.clone());
    }
    let changed = changed(findings, system)?;
    let named = if changed.len() > NAMED {
        NAMED - 1
    } else {
        changed.len()
    };
    let drive = if findings.stated.launch.is_given() {
        conditions::parameters(&findings.stated, &launch(findings), system)
    } else {
        findings.name.clone()
    };
    let changes = changed[..named]
        .iter()
        .map(|change| format!(", {} {}", change.name, change.to));
    let others = match changed.len() - named {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    Ok(drive + &changes.collect::<String>() + &others)
}

/// The names of the stated launch conditions.
fn launch(findings: &Findings) -> Vec<&'static str> {
    findings
        .stated
        .given_launch_conditions()
        .iter()
        .map(|row| row.name)
        .collect()
}

/// The line below the title. The description of the preset is used only for the drive of the
/// preset.
pub(super) fn subtitle(findings: &Findings) -> Result<String> {
    let preset = findings.file.preset.name;
    let changes = changed(findings, System::default())?.len() as u64;
    Ok(match (findings.stated.launch.is_given(), changes) {
        (true, _) => {
            format!(
                "The ball leaves as its launch says, without a club; its flight is based on the \
                 preset {preset}."
            )
        }
        (false, 0) => findings.file.preset.about.into(),
        (false, changes) => format!("The preset {preset} with {}.", counted(changes, "change")),
    })
}

/// The differences from the preset. Stated launch conditions are omitted, because they have a line
/// of their own. If the launch is stated, golfer, swing, club, strike and impact are omitted too,
/// because they have no effect.
fn changed(findings: &Findings, system: System) -> Result<Vec<ChangedSetting>> {
    let is_of_launch = |name: &str| {
        let parameter = findings.stated.parameter(name);
        parameter.is_ok_and(Parameter::is_of_launch)
    };
    let mut changes = used_changes(&findings.stated, findings.file.preset, system)?;
    changes.retain(|change| !is_of_launch(change.key));
    Ok(changes)
}

/// The summary of the request: golfer, club and strike (or the stated launch), air and wind, the
/// objective with its varied parameters and constraints, and the differences from the preset.
pub(super) fn request(findings: &Findings) -> Result<Markup> {
    const GOLFER: [&str; 4] = [
        "swing.speed",
        "swing.attack_angle",
        "swing.path",
        "swing.face_angle",
    ];
    const CLUB: [&str; 2] = ["club.loft", "club.mass"];
    const STRIKE: [&str; 2] = ["strike.high", "strike.toe"];
    let setup = &findings.stated;
    let values = |names: &[&str]| both(|system| conditions::parameters(setup, names, system));
    let launch = launch(findings);
    let InBoth { metric, us } = InBoth::of(|system| changed(findings, system));
    let (metric, us) = (metric?, us?);
    let text = |changes: &[ChangedSetting]| {
        let one = |change: &ChangedSetting| {
            format!("{} {}", change.name, from_to(&change.from, &change.to))
        };
        changes.iter().map(one).collect::<Vec<_>>().join("; ")
    };
    let of_preset = chosen(&text(&metric), &text(&us));
    let search = findings.found.as_ref().map(|found| &found.search);
    Ok(html! {
        dl.asked {
            @if launch.is_empty() {
                dt { "Golfer" } dd { (values(&GOLFER)) }
                dt { "Club" } dd { (values(&CLUB)) }
                dt { "Strike" } dd { (values(&STRIKE)) }
            } @else {
                dt { "Launch" } dd { (values(&launch)) }
            }
            dt { "Air" } dd { (both(|system| conditions::air(setup, system))) }
            dt { "Wind" } dd { (both(|system| conditions::wind(setup, system).unwrap_or("none".into()))) }
            @if let Some(search) = search { (wanted(search)) }
            @if launch.is_empty() {
                dt { "Preset" } dd {
                    (findings.file.preset.name)
                    @if us.is_empty() { ", as it is" } @else { "; changed: " (of_preset) }
                }
            } @else {
                dt { "Ball, air and ground" } dd {
                    "those of the preset " (findings.file.preset.name)
                    @if !us.is_empty() { "; changed: " (of_preset) }
                }
            }
        }
    })
}

/// The objective with the varied parameters and their ranges, and the constraints.
fn wanted(search: &Search) -> Markup {
    let varied = |system: System| {
        let range = |vary: &Vary| {
            let [low, high] = [vary.low, vary.high]
                .map(|value| shown::with_digits(vary.parameter, value, system, shown::IN_SUMMARY));
            let name = shown::words(vary.parameter.name);
            format!("{name} {}", from_to(&low, &high).replace(" → ", " to "))
        };
        search.vary.iter().map(range).collect::<Vec<_>>().join(", ")
    };
    let limits = |system: System| {
        let limits = search.subject_to.iter();
        let limits = limits.map(|limit| shown::constraint(limit, system));
        limits.collect::<Vec<_>>().join("; ")
    };
    html! {
        dt { "Wanted" } dd {
            "the " (search.sense.adjective()) " " (shown::words(search.outcome().name())) " by "
            (both(varied))
        }
        @if !search.subject_to.is_empty() {
            dt { "Limits" } dd { (both(limits)) }
        }
    }
}
