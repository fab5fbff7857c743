//! Requests of programs that embed the library. A request is a command with named arguments, whose
//! values are typed. This module writes a request as the words of a command line, which clap reads.

use super::program;
use crate::parameters::{Law, Parameter};
use crate::units::Quantity;
use crate::{Error, Outcome, Result, Setup};
use clap::{Arg, ArgAction};
use std::ffi::OsString;

/// A request: a command with arguments.
///
/// ```
/// use longdrive::command::{Call, ArgumentValue};
/// let range = ArgumentValue::Range {
///     low: Box::new(ArgumentValue::Number(0.1)),
///     high: Box::new(ArgumentValue::Text("20 deg".into())),
///     count: None,
/// };
/// let call = Call {
///     command: "optimize".into(),
///     arguments: vec![("vary".into(), ArgumentValue::Named("club.loft".into(), Box::new(range)))],
/// };
/// let words = call.words().unwrap();
/// assert_eq!(words, ["longdrive", "optimize", "--vary=club.loft=0.1 rad..20 deg"]);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Call {
    /// The command, as on the command line: `optimize`, `plot contour`.
    pub command: String,
    /// Arguments: the name of the option with underscores, such as `subject_to`, and the value.
    pub arguments: Vec<(String, ArgumentValue)>,
}

/// The value of an argument.
#[derive(Clone, Debug)]
pub enum ArgumentValue {
    /// On or off, for an option such as `overwrite`.
    Switch(bool),
    /// A text, as on the command line.
    Text(OsString),
    /// A whole number without a unit.
    Whole(i64),
    /// A number in the SI unit of its argument, parameter or outcome.
    Number(f64),
    /// A range; for a grid, also the number of values.
    Range {
        /// The lower end: a number or a text.
        low: Box<ArgumentValue>,
        /// The upper end.
        high: Box<ArgumentValue>,
        /// The number of values, the ends included.
        count: Option<u64>,
    },
    /// A distribution: its kind, and its numbers.
    Distribution(String, Vec<ArgumentValue>),
    /// A value with the name of its parameter or outcome. The name may be a list with commas, as
    /// for a correlation; the value then has no unit.
    Named(String, Box<ArgumentValue>),
    /// Several values of one argument.
    Several(Vec<ArgumentValue>),
    /// Values that commas join into one value, such as the changes that define a model.
    Joined(Vec<ArgumentValue>),
}

impl ArgumentValue {
    /// The text of a value on the command line, such as `club.loft=0.1 rad..20 deg`.
    pub fn text(&self) -> OsString {
        self.text_in(None, &mut vec![])
    }

    /// The text of a value whose numbers have the quantity `quantity`. Adds angles that are numbers
    /// without a unit, rad, to `bare_angles`.
    fn text_in(&self, quantity: Option<Quantity>, bare_angles: &mut Vec<f64>) -> OsString {
        match self {
            Self::Switch(is_on) => is_on.to_string().into(),
            Self::Text(text) => text.clone(),
            Self::Whole(number) => number.to_string().into(),
            Self::Number(number) => {
                if quantity == Some(Quantity::ANGLE) {
                    bare_angles.push(*number);
                }
                let unit = quantity.map_or("", |quantity| quantity.si);
                format!("{number:?} {unit}").trim_end().into()
            }
            Self::Range { low, high, count } => {
                let mut text = low.text_in(quantity, bare_angles);
                text.push("..");
                text.push(high.text_in(quantity, bare_angles));
                if let Some(count) = count {
                    text.push(format!(":{count}"));
                }
                text
            }
            Self::Distribution(kind, numbers) => {
                let mut text = OsString::from(format!("{kind}("));
                for (at, number) in numbers.iter().enumerate() {
                    text.push(if at == 0 { "" } else { "," });
                    text.push(number.text_in(quantity, bare_angles));
                }
                text.push(")");
                text
            }
            Self::Named(name, value) => {
                let mut text = OsString::from(format!("{name}="));
                text.push(value.text_in(quantity_of(name), bare_angles));
                text
            }
            Self::Several(values) | Self::Joined(values) => {
                let texts: Vec<_> = values
                    .iter()
                    .map(|value| value.text_in(quantity, bare_angles))
                    .collect();
                texts.join(",".as_ref())
            }
        }
    }
}

impl Call {
    /// The words of the command line, the name of the program first.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if the command is unknown, or does not have one of the arguments.
    pub fn words(&self) -> Result<Vec<OsString>> {
        Ok(self.command_line()?.words)
    }

    pub(super) fn command_line(&self) -> Result<CommandLine> {
        let mut command = program();
        for name in self.command.split(' ') {
            command = command
                .find_subcommand(name)
                .ok_or_else(|| Error::unreadable(&self.command, "no command has this name"))?;
        }
        for (name, _) in &self.arguments {
            if !command.get_arguments().any(|arg| name_of(arg) == *name) {
                let reason = format!("`{}()` has no such argument; leave it out", self.command);
                return Err(Error::unreadable(name, reason));
            }
        }
        let mut line = CommandLine {
            words: vec!["longdrive".into()],
            bare_angles: vec![],
        };
        line.words
            .extend(self.command.split(' ').map(OsString::from));
        for arg in command.get_arguments() {
            let own = self
                .arguments
                .iter()
                .filter(|(name, _)| name_of(arg) == *name);
            for (_, value) in own {
                line.argument(arg, value, self.quantity(arg));
            }
        }
        Ok(line)
    }

    /// The physical quantity of an argument's value, from the placeholder in the help, such as
    /// LENGTH.
    fn quantity(&self, arg: &Arg) -> Option<Quantity> {
        match arg.get_value_names()?.first()?.as_str() {
            "AMOUNT" => self.goal(),
            "VALUE,…" => self.along(),
            "LENGTH" => Some(Quantity::LENGTH),
            "SPEED" => Some(Quantity::SPEED),
            "ANGLE" => Some(Quantity::ANGLE),
            "TEMPERATURE" => Some(Quantity::TEMPERATURE),
            "SPIN" => Some(Quantity::ANGULAR_VELOCITY),
            _ => None,
        }
    }

    /// The quantity of the goal of a search; the default goal is the carry. `None` if the goal has
    /// no unit.
    fn goal(&self) -> Option<Quantity> {
        let text = self.arguments.iter().find_map(|(name, value)| match value {
            ArgumentValue::Text(text) if name == "maximize" || name == "minimize" => text.to_str(),
            _ => None,
        });
        quantity_of_goal(text.unwrap_or("carry"))
    }

    /// The quantity of the parameter that `along` names. The values of the option `at` have this
    /// quantity.
    fn along(&self) -> Option<Quantity> {
        let (_, value) = self.arguments.iter().find(|(name, _)| name == "along")?;
        let first = match value {
            ArgumentValue::Several(values) => values.first()?,
            value => value,
        };
        match first {
            ArgumentValue::Named(name, _) => quantity_of(name),
            ArgumentValue::Text(text) => quantity_of(text.to_str()?.split('=').next()?.trim()),
            _ => None,
        }
    }
}

/// The name of an argument: the name of its option, with underscores.
fn name_of(arg: &Arg) -> String {
    arg.get_long()
        .unwrap_or(arg.get_id().as_str())
        .replace('-', "_")
}

/// The quantity of a goal such as `mean(carry) - 0.5*std(lateral)`: the quantity of its first
/// outcome. `None` if the goal has only fractions of drives (`within`) or strokes, which have no
/// unit.
pub fn quantity_of_goal(goal: &str) -> Option<Quantity> {
    let mut rest = goal;
    while let Some(start) = rest.find(|c: char| c.is_ascii_lowercase()) {
        rest = &rest[start..];
        let end = rest
            .find(|c: char| !c.is_ascii_lowercase() && c != '_')
            .unwrap_or(rest.len());
        let (word, behind) = rest.split_at(end);
        rest = match word {
            "within" | "strokes" => behind.split_once(')')?.1,
            _ => behind,
        };
        if let Ok(outcome) = Outcome::named(word) {
            return Some(outcome.quantity());
        }
    }
    None
}

/// The parameter with this name. Includes the coefficients of every law.
fn parameter(name: &str) -> Option<&'static Parameter> {
    let of_any_law = || Law::all_rows().find(|row| row.name == name);
    Setup::modern_driver()
        .parameter(name)
        .ok()
        .or_else(of_any_law)
}

/// The quantity of a parameter or an outcome; `None` for an unknown name. A number without a unit
/// is in the SI unit of this quantity.
pub fn quantity_of(name: &str) -> Option<Quantity> {
    let of_outcome = || Outcome::named(name).ok().map(|outcome| outcome.quantity());
    parameter(name)
        .map(|parameter| parameter.quantity)
        .or_else(of_outcome)
}

/// The command line of a call.
pub(super) struct CommandLine {
    /// The words, the name of the program first.
    pub words: Vec<OsString>,
    /// Angles that the call gives as numbers without a unit, rad.
    pub bare_angles: Vec<f64>,
}

impl CommandLine {
    /// Adds an argument whose numbers have the quantity `quantity`.
    fn argument(&mut self, arg: &Arg, value: &ArgumentValue, quantity: Option<Quantity>) {
        if let ArgumentValue::Several(values) = value {
            for value in values {
                self.argument(arg, value, quantity);
            }
            return;
        }
        if let ArgumentValue::Switch(false) = value {
            return;
        }
        let mut word = match arg.is_positional() {
            true => OsString::new(),
            false => OsString::from(format!("--{}", arg.get_long().unwrap_or_default())),
        };
        let takes_value = !matches!(arg.get_action(), ArgAction::SetTrue | ArgAction::Count);
        if takes_value && !matches!(value, ArgumentValue::Switch(true)) {
            if !arg.is_positional() {
                word.push("=");
            }
            word.push(value.text_in(quantity, &mut self.bare_angles));
        }
        self.words.push(word);
    }
}

/// If an angle is out of range and the request states it without a unit, advises to write the
/// number in degrees. `bare_angles` are the angles without a unit in the request, rad.
pub fn with_degrees(error: Error, bare_angles: &[f64]) -> Error {
    match error {
        Error::OutOfRange {
            name,
            si,
            value,
            range,
            ..
        } if quantity_of(&name) == Some(Quantity::ANGLE) && bare_angles.contains(&si) => {
            Error::OutOfRange {
                name,
                si,
                value,
                range,
                advice: format!("a number without a unit is SI; did you mean \"{si} deg\"?"),
            }
        }
        error => error,
    }
}
