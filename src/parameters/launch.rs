//! Launch conditions that must be given together.

use super::choices::GOLFER;
use super::declare::ParameterGroup;
use super::table::{LaunchConditions, Setup};
use crate::error::{Error, Result};

/// Prefix of the names of launch conditions.
const GROUP: &str = "launch.";

/// True for a name of the groups swing, strike, club and impact, and for `golfer`. These settings
/// have no effect if the launch is given.
pub fn is_of_strike(name: &str) -> bool {
    let groups = ["swing.", "strike.", "club.", "impact."];
    name == GOLFER || groups.iter().any(|group| name.starts_with(group))
}

impl super::Parameter {
    /// True for a parameter of swing, strike, club or impact. It has no effect if the launch is
    /// given.
    pub fn is_of_strike(&self) -> bool {
        match self.group {
            ParameterGroup::Swing
            | ParameterGroup::Strike
            | ParameterGroup::Club
            | ParameterGroup::Contact => true,
            ParameterGroup::Ball
            | ParameterGroup::LaunchConditions
            | ParameterGroup::Air
            | ParameterGroup::Aero
            | ParameterGroup::Wind
            | ParameterGroup::Ground
            | ParameterGroup::FlightConditions
            | ParameterGroup::Law => false,
        }
    }

    /// True for a parameter of swing, strike or club, and for a launch condition: the golfer
    /// controls these.
    pub(crate) fn is_controlled(&self) -> bool {
        let is_of_impact = self.group == ParameterGroup::Contact;
        self.is_of_launch() || self.is_of_strike() && !is_of_impact
    }

    /// True for a launch condition.
    pub fn is_of_launch(&self) -> bool {
        self.group == ParameterGroup::LaunchConditions
    }
}

impl<T: Copy> LaunchConditions<T> {
    /// True if the launch is given and no club strikes the ball.
    pub fn is_given(&self) -> bool {
        self.ball_speed.is_some()
    }
}

impl Setup<f64> {
    /// Checks that the launch conditions (set, or among `names`) are complete: either none is
    /// given, or ball speed, launch angle and one form of the spin are given.
    ///
    /// # Errors
    /// [`Error::Launch`] with the missing or duplicate condition.
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
            (false, false) => refuse("the spin is missing: give backspin, or spin (total spin)"),
            (true, true) => refuse(
                "the spin is given twice: leave backspin or spin out, or unset the one of a setup \
                 file (`set launch.backspin=none` or `set launch.spin=none`)",
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

    /// Unsets the form of the spin that conflicts with `given`. Backspin unsets total spin and
    /// axis. Total spin unsets backspin and sidespin.
    pub fn replace_spin(&mut self, given: &super::Parameter) {
        match given.name {
            "launch.backspin" => (self.launch.spin, self.launch.spin_axis) = (None, None),
            "launch.spin" => (self.launch.backspin, self.launch.sidespin) = (None, None),
            _ => {}
        }
    }

    /// The conditions of a given launch that count as 0 because they are unset: the launch
    /// direction, and the spin axis or the sidespin. Empty if no launch is given.
    pub fn conditions_assumed_zero(&self) -> Vec<&'static super::Parameter> {
        let launch = &self.launch;
        let axis = match (launch.spin, launch.backspin) {
            (Some(_), _) => Some("spin_axis"),
            (None, Some(_)) => Some("sidespin"),
            (None, None) => None,
        };
        let names = std::iter::once("launch_direction").chain(axis);
        let mut assumed: Vec<_> = names
            .filter_map(|name| self.launch_condition(name))
            .collect();
        assumed.retain(|condition| launch.is_given() && self.value(condition).is_none());
        assumed
    }

    /// The setup with the value 0 for each condition of a given launch that counts as 0. Default
    /// uncertainties then apply to these conditions.
    ///
    /// # Errors
    /// The errors of [`Setup::set_value`].
    pub fn with_assumed_launch(mut self) -> Result<Self> {
        for condition in self.conditions_assumed_zero() {
            self.set_value(condition, Some(0.0))?;
        }
        Ok(self)
    }

    /// Launch conditions with a value.
    pub fn given_launch_conditions(&self) -> Vec<&'static super::Parameter> {
        let mut given = self.parameters();
        given.retain(|parameter| parameter.is_of_launch() && self.value(parameter).is_some());
        given
    }

    /// Names of the launch conditions without their prefix, such as `ball_speed`.
    pub fn launch_conditions(&self) -> Vec<&'static str> {
        self.parameters()
            .iter()
            .filter_map(|parameter| parameter.name.strip_prefix(GROUP))
            .collect()
    }

    /// The launch condition with this short name, such as `ball_speed` for `launch.ball_speed`;
    /// `None` if there is no such condition.
    pub fn launch_condition(&self, name: &str) -> Option<&'static super::Parameter> {
        self.parameter(&format!("{GROUP}{name}")).ok()
    }
}
