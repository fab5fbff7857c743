//! A table without a column of the swing or the launch: all its rows are compared with one drive.

use super::shot_table::ShotTable;
use crate::parameters::{Parameter, Setup, Vary};
use crate::units::{Digits, Message};

/// What is shown of the setup's swing.
const SHOWN: [&str; 3] = ["swing.speed", "swing.attack_angle", "club.loft"];

impl ShotTable {
    /// A note where no row has a launch or an input of swing, club, strike or impact: which swing
    /// of the setup they are all compared with. Of the parameters that are fitted no value is
    /// shown.
    pub fn one_drive(&self, setup: &Setup<f64>, fitted: &[Vary]) -> Option<Message> {
        let has_own = |(parameter, _): &(&Parameter, f64)| parameter.is_of_strike();
        if self.is_launched
            || self
                .shots
                .iter()
                .any(|shot| shot.inputs.iter().any(has_own))
        {
            return None;
        }
        let rows = match self.shots.len() {
            1 => "the row is".to_owned(),
            rows => format!("all {rows} rows are"),
        };
        let shown = SHOWN.iter().filter_map(|name| {
            let parameter = setup.parameter(name).ok()?;
            if fitted.iter().any(|vary| vary.parameter == parameter) {
                return Some(Message::from(format!("{name} as it is fitted")));
            }
            let value = setup.value(parameter)?;
            let named = Message::from(format!("{name} "));
            Some(named.quantity(
                parameter.quantity,
                parameter.unit,
                value,
                Digits::Significant(4),
            ))
        });
        let before = format!(
            "{} has neither a whole launch (ball_speed, launch_angle, and spin or backspin) nor a \
             column of swing, club, strike or impact: {rows} \
             compared with one drive, that of the setup: ",
            self.file
        );
        let after = "; if the rows are of different drives, add the columns that tell them apart";
        Some(
            Message::from(before)
                .message(Message::joined(shown, ", "))
                .words(after),
        )
    }
}
