//! Settings of the command line: `--set club.loft=11deg`, `--launch ball_speed=70m/s`.

use crate::repeated::first_repeated;
use crate::{Error, Result, Setup};
use std::fmt;

/// A parameter with its value, from an option of the command line.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandSetting {
    /// The argument that states the parameter: `set`, `launch_a`, `ball_speed`, `speed`.
    pub argument: &'static str,
    /// The name as typed: `ball_speed` after `--launch`, or the name of an option such as `speed`.
    name: String,
    /// The name of the parameter: `launch.ball_speed`.
    pub parameter: String,
    pub value: String,
}

impl CommandSetting {
    /// A launch condition with its value, from a separate option (`--ball-speed 167mph`) or from
    /// `--launch`.
    ///
    /// # Errors
    /// [`Error::Unknown`] if `name` is no launch condition.
    pub fn of_launch(argument: &'static str, name: &str, value: &str) -> Result<Self> {
        let setup = Setup::modern_driver();
        let condition = setup.launch_condition(name).ok_or_else(|| {
            let names = setup.launch_conditions();
            let advice = format!("a launch has {}", names.join(", "));
            Error::unknown("launch condition", name, names, advice)
        })?;
        Ok(Self {
            argument,
            name: name.into(),
            parameter: condition.name.into(),
            value: value.trim().into(),
        })
    }

    /// A parameter with its value, from an option of its own (`--speed 95mph`).
    pub fn by_short_name(option: &'static str, parameter: &str, value: &str) -> Self {
        Self {
            argument: option,
            name: option.into(),
            parameter: parameter.into(),
            value: value.trim().into(),
        }
    }

    /// Reads the texts of an option such as `--set`.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if one of `texts` has no `=`.
    pub fn read_all(argument: &'static str, texts: &[String]) -> Result<Vec<Self>> {
        let read = |text: &String| {
            let (name, value) = split(argument, text, "club.loft=10.5deg")?;
            Ok(Self {
                argument,
                name: name.into(),
                parameter: name.into(),
                value: value.into(),
            })
        };
        texts.iter().map(read).collect()
    }

    /// Reads the texts of an option such as `--launch`.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if one of `texts` has no `=`, and the errors of
    /// [`of_launch`](Self::of_launch).
    pub fn read_all_launch(argument: &'static str, texts: &[String]) -> Result<Vec<Self>> {
        let read = |text: &String| {
            let (name, value) = split(argument, text, "ball_speed=167mph")?;
            Self::of_launch(argument, name, value)
        };
        texts.iter().map(read).collect()
    }

    /// Returns true for a launch condition.
    pub fn is_of_launch(&self) -> bool {
        self.parameter.starts_with("launch.")
    }

    /// Returns true for a launch condition from `--launch` or an option such as `--ball-speed`. Its
    /// spin replaces the spin of the setup: total spin unsets backspin and sidespin, backspin
    /// unsets total spin and spin axis. With `--set launch.…`, both forms of the spin together are
    /// an error.
    pub fn replaces_launch(&self) -> bool {
        self.is_of_launch() && self.name != self.parameter
    }

    /// The option and its value that give this setting to another command.
    pub fn as_argument(&self) -> [String; 2] {
        let condition = self.parameter.strip_prefix("launch.");
        match condition.filter(|_| self.replaces_launch()) {
            Some(condition) => ["--launch".into(), format!("{condition}={}", self.value)],
            None => ["--set".into(), format!("{}={}", self.parameter, self.value)],
        }
    }

    /// The argument with the parameter name, for messages: `--set club.loft`.
    pub fn named(&self) -> String {
        if self.has_own_option() {
            format!("`{}`", self.argument)
        } else {
            format!("`{}` {}", self.argument, self.name)
        }
    }

    /// Returns true for an option of one parameter, such as `--ball-speed` or `--speed`.
    fn has_own_option(&self) -> bool {
        self.argument == self.name
    }
}

/// The setting as typed, for messages: `--set club.loft=11deg`.
impl fmt::Display for CommandSetting {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.has_own_option() {
            write!(to, "`{} {}`", self.argument, self.value)
        } else {
            write!(to, "`{} {}={}`", self.argument, self.name, self.value)
        }
    }
}

/// Refuses several settings of one parameter.
///
/// # Errors
/// [`Error::Unreadable`], which names two of the settings.
pub fn refuse_duplicates(settings: &[CommandSetting]) -> Result<()> {
    let Some([first, again]) = first_repeated(settings, |a, b| a.parameter == b.parameter) else {
        return Ok(());
    };
    let (earlier, setting) = (&settings[first], &settings[again]);
    let what = if setting.replaces_launch() {
        format!("the {}", setting.name)
    } else {
        setting.parameter.clone()
    };
    Err(Error::unreadable(
        setting.to_string(),
        format!("{earlier} gives {what} too; keep one of the two"),
    ))
}

/// Splits `NAME=VALUE`.
fn split<'a>(argument: &str, text: &'a str, example: &str) -> Result<(&'a str, &'a str)> {
    text.split_once('=')
        .map(|(name, value)| (name.trim(), value.trim()))
        .ok_or_else(|| {
            Error::unreadable(
                format!("`{argument} {text}`"),
                format!("write NAME=VALUE, for example {example}"),
            )
        })
}

#[cfg(test)]
mod tests {
    use super::{CommandSetting, refuse_duplicates};

    #[test]
    fn exact_settings_know_their_parameter_and_how_they_were_typed() {
        let set = CommandSetting::read_all("set_a", &["club.loft = 11deg".into()]).unwrap();
        let launch = CommandSetting::read_all_launch("launch", &["spin=2700rpm".into()]).unwrap();
        let own = CommandSetting::of_launch("ball_speed", "ball_speed", "70m/s").unwrap();
        let all = [&set[0], &launch[0], &own];
        assert_eq!(
            all.map(|setting| setting.parameter.as_str()),
            ["club.loft", "launch.spin", "launch.ball_speed"]
        );
        assert_eq!(
            all.map(CommandSetting::to_string),
            [
                "`set_a club.loft=11deg`",
                "`launch spin=2700rpm`",
                "`ball_speed 70m/s`"
            ]
        );
        assert_eq!(
            all.map(CommandSetting::replaces_launch),
            [false, true, true],
            "--set changes one condition of the setup's launch"
        );
    }

    #[test]
    fn exact_options_for_another_command() {
        let set = CommandSetting::read_all("set_b", &["launch.spin=2700rpm".into()]).unwrap();
        let launch = CommandSetting::read_all_launch("launch_a", &["spin=2700rpm".into()]).unwrap();
        let own = CommandSetting::of_launch("ball_speed", "ball_speed", "70m/s").unwrap();
        let short = CommandSetting::by_short_name("speed", "swing.speed", "95mph");
        assert_eq!(
            [&set[0], &launch[0], &own, &short].map(CommandSetting::as_argument),
            [
                ["--set", "launch.spin=2700rpm"],
                ["--launch", "spin=2700rpm"],
                ["--launch", "ball_speed=70m/s"],
                ["--set", "swing.speed=95mph"],
            ]
            .map(|words| words.map(String::from))
        );
    }

    #[test]
    fn one_parameter_by_two_options_is_refused() {
        let mut all = CommandSetting::read_all("set", &["launch.spin=1rpm".into()]).unwrap();
        all.extend(CommandSetting::read_all_launch("launch", &["spin=2rpm".into()]).unwrap());
        let error = refuse_duplicates(&all).unwrap_err().to_string();
        assert_eq!(
            error,
            "`launch spin=2rpm`: `set launch.spin=1rpm` gives the spin too; keep one of the two"
        );
        let short = CommandSetting::by_short_name("speed", "swing.speed", "95mph");
        let mut all = CommandSetting::read_all("set", &["swing.speed=90mph".into()]).unwrap();
        all.push(short);
        let error = refuse_duplicates(&all).unwrap_err().to_string();
        assert_eq!(
            error,
            "`speed 95mph`: `set swing.speed=90mph` gives swing.speed too; keep one of the two"
        );
    }
}
