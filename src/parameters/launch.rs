//! Which launch conditions go together.

use super::table::{LaunchConditions, Setup};
use crate::error::{Error, Result};

/// The group of the launch conditions, in front of their names.
const GROUP: &str = "launch.";

impl super::Parameter {
    /// Whether it is of the club and its strike, of which nothing depends where the launch is
    /// given.
    pub fn is_of_strike(&self) -> bool {
        ["swing.", "strike.", "club.", "impact."]
            .iter()
            .any(|group| self.name.starts_with(group))
    }

    /// Whether it is of the ball, on which impact and flight depend.
    pub(crate) fn is_of_ball(&self) -> bool {
        self.name.starts_with("ball.")
    }

    /// Whether it is a launch condition.
    pub fn is_of_launch(&self) -> bool {
        self.name.starts_with(GROUP)
    }
}

impl<T: Copy> LaunchConditions<T> {
    /// Whether a launch is given, so that no club strikes the ball.
    pub fn is_given(&self) -> bool {
        self.ball_speed.is_some()
    }
}

impl Setup<f64> {
    /// Whether the launch conditions that are set, and those of these names, make one launch: none
    /// at all, or ball speed, launch angle, and the spin once.
    ///
    /// # Errors
    /// [`Error::Launch`] with what is missing or given twice.
    pub(crate) fn check_launch(&self, names: &[&str]) -> Result<()> {
        let mut given = vec![];
        for parameter in self.parameters() {
            if let Some(name) = parameter.name.strip_prefix(GROUP)
                && (names.contains(&parameter.name) || self.value(parameter).is_some())
            {
                given.push(name);
            }
        }
        let has = |name: &str| given.contains(&name);
        let refuse = |reason: &str| {
            Err(Error::Launch {
                given: given.join(", "),
                reason: reason.into(),
            })
        };
        if given.is_empty() {
            return Ok(());
        }
        match (has("backspin"), has("spin")) {
            _ if !has("ball_speed") => refuse("ball_speed is missing"),
            _ if !has("launch_angle") => refuse("launch_angle is missing"),
            (false, false) => refuse("the spin is missing: give backspin, or spin"),
            (true, true) => refuse(
                "the spin is given twice: keep backspin, or spin, and unset the other (`set \
                 launch.spin=none`)",
            ),
            (true, false) if has("spin_axis") => {
                refuse("spin_axis needs spin; with backspin, give sidespin")
            }
            (false, true) if has("sidespin") => {
                refuse("sidespin needs backspin; with spin, give spin_axis")
            }
            _ => Ok(()),
        }
    }

    /// Where the spin is to be given in one form (backspin and sidespin, or spin and its axis),
    /// unsets the other form.
    pub fn replace_spin(&mut self, given: &super::Parameter) {
        match given.name {
            "launch.backspin" => (self.launch.spin, self.launch.spin_axis) = (None, None),
            "launch.spin" => (self.launch.backspin, self.launch.sidespin) = (None, None),
            _ => {}
        }
    }

    /// The launch conditions that have a value.
    pub fn given_launch_conditions(&self) -> Vec<&'static super::Parameter> {
        let mut given = self.parameters();
        given.retain(|parameter| parameter.is_of_launch() && self.value(parameter).is_some());
        given
    }

    /// The names of the launch conditions, without their group.
    pub fn launch_conditions(&self) -> Vec<&'static str> {
        self.parameters()
            .iter()
            .filter_map(|parameter| parameter.name.strip_prefix(GROUP))
            .collect()
    }

    /// The launch condition of this name, without its group: `ball_speed` for `launch.ball_speed`.
    pub fn launch_condition(&self, name: &str) -> Option<&'static super::Parameter> {
        self.parameter(&format!("{GROUP}{name}")).ok()
    }
}
