//! The windows of an optimum of a single drive, and the gain of the club alone.

use super::super::limits::change_of;
use super::super::shown;
use crate::study::{ClubAlone, Optimum, OptimumWindows, Vary, Window, WindowLimit};
use crate::units::{System, signed};

/// A line with the windows of all varied parameters, then a line with the gain of the club alone.
pub(super) fn window_lines(
    around: &OptimumWindows<'_>,
    optimum: &Optimum,
    system: System,
) -> Vec<String> {
    let loss = shown::difference(optimum.search.outcome(), around.loss, system);
    let vary = optimum.search.vary.iter().zip(around.windows);
    let windows: Vec<_> = vary
        .filter(|(vary, _)| vary.low < vary.high)
        .map(|(vary, window)| window_text(vary, window, system))
        .collect();
    let windows = format!(
        "within {loss} of the best if one parameter alone changes: {}",
        windows.join(", ")
    );
    let club = around.club_alone;
    let club = club.map(|club| club_text(optimum, club, system));
    [windows].into_iter().chain(club).collect()
}

/// A window in words, such as "club.loft 5.36° to 6.94°". An end that is not due to the loss has
/// its reason: "5.00° (bound)".
fn window_text(vary: &Vary, window: &Window, system: System) -> String {
    let end = |value: f64, limit: &WindowLimit| {
        let value = shown::parameter(vary.parameter, value, system);
        match limit {
            WindowLimit::Loss => value,
            WindowLimit::Constraint(constraint) => {
                format!("{value} ({})", shown::constraint(constraint, system))
            }
            other => format!("{value} ({})", other.name()),
        }
    };
    format!(
        "{} {} to {}",
        vary.parameter.name,
        end(window.low, &window.low_limit),
        end(window.high, &window.high_limit)
    )
}

/// The gain of the club in words, as a signed change of the objective, such as "by the club alone:
/// +2.60 yd (club.loft 10.40°); by varying the swing too: a further +11.90 yd".
fn club_text(optimum: &Optimum, club: &ClubAlone, system: System) -> String {
    let goal = &optimum.search.of;
    let change = |gain: f64| {
        let change = change_of(optimum.search.sense, gain);
        signed(change, shown::goal_difference(goal, change, system))
    };
    let vary = club.optimum.search.vary.iter();
    let values = vary.zip(&club.optimum.solution.x).map(|(vary, x)| {
        let value = shown::within(vary, *x, system);
        format!("{} {value}", vary.parameter.name)
    });
    let values = values.collect::<Vec<_>>().join(", ");
    let from = match optimum.violated_as_set_up().is_empty() {
        true => "",
        false => ", from a drive that violates a limit",
    };
    format!(
        "by the club alone: {} ({values}){from}; by varying the swing too: a further {}",
        change(club.club_gain),
        change(club.swing_gain)
    )
}
