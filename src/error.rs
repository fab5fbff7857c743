//! What can be wrong with a question, and what can keep a drive from having an answer.

use crate::external_errors::{read_error_text, write_error_text};
use crate::units::{Digits, Message, Quantity, System, significant};

/// `Result` with longdrive's [`enum@Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why something could not be done. Every message names the thing, the value, what is allowed, and
/// what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A name that nothing bears.
    #[error("unknown {what} '{name}'; {}{advice}", suggested(suggestion))]
    Unknown {
        /// What was named: "parameter", "outcome", "preset", "aerodynamic law".
        what: &'static str,
        /// The name given.
        name: String,
        /// The nearest name there is.
        suggestion: Option<String>,
        /// How to see the names there are.
        advice: String,
    },
    /// A coefficient of another aerodynamic law than the one the setup flies.
    #[error(
        "'{name}' is a coefficient of {owners}, but this setup uses the law '{law}'; set aero.law \
         too"
    )]
    OtherLaw {
        /// The parameter.
        name: String,
        /// The setup's law.
        law: &'static str,
        /// The laws that have such a coefficient.
        owners: String,
    },
    /// A value that cannot be read.
    #[error("{name}: {source}")]
    Unreadable {
        /// The parameter.
        name: String,
        /// Why.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// A value outside the range of what is physically possible.
    #[error("{name} = {value} is outside its range {range}; {advice}")]
    OutOfRange {
        /// The parameter.
        name: String,
        /// The value, with its unit.
        value: String,
        /// The range, with its unit.
        range: String,
        /// What to do, or what may have been meant.
        advice: String,
    },
    /// NaN as the value of a parameter.
    #[error("{name} = NaN is not a number; give it a value in its range {range}")]
    NotANumber {
        /// The parameter.
        name: String,
        /// The range, with its unit.
        range: String,
    },
    /// An inertia tensor no body can have.
    #[error(
        "club.inertia is not positive definite: its smallest principal moment is {smallest:e} kg \
         m^2; \
         raise club.inertia.xx, .yy, .zz or reduce the products .xy, .xz, .yz"
    )]
    Inertia {
        /// The smallest eigenvalue, kg m².
        smallest: f64,
    },
    /// Launch conditions that do not make one launch.
    #[error(
        "the launch ({given}): {reason}; a launch has ball_speed, launch_angle, perhaps \
         launch_direction, and either backspin \
         (perhaps sidespin) or spin (perhaps spin_axis)"
    )]
    Launch {
        /// The conditions that are given.
        given: String,
        /// What is missing or given twice.
        reason: String,
    },
    /// A value that breaks a rule of golf.
    #[error(
        "against {rule}: {found}, and the rule is {limit}; {advice}, or leave the Rules of Golf \
         out with `rules none`"
    )]
    Rule {
        /// The rule with its source.
        rule: String,
        /// Where the value is, and what it is.
        found: String,
        /// The limit.
        limit: String,
        /// What to do.
        advice: String,
    },
    /// Parameters that do not go together, or one that needs another beside it.
    #[error("{given}: {reason}")]
    Together {
        /// What is given, or missing.
        given: String,
        /// Why that is wrong, and what to do.
        reason: String,
    },
    /// A derivative or a search with respect to something that has no number of its own.
    #[error("{name} cannot be varied, and has no derivatives: {reason}")]
    NotVariable {
        /// The parameter.
        name: String,
        /// Why, and what to do.
        reason: String,
    },
    /// A range, to search or to sweep, that cannot be one.
    #[error("the range {name}: {reason}")]
    SearchRange {
        /// The parameter, with its range as given.
        name: String,
        /// Why, and what to do.
        reason: String,
    },
    /// A search without anything to vary, a gradient with respect to nothing.
    #[error("nothing to {doing}: name at least one {what}")]
    Nothing {
        /// What was to be done: "vary", "differentiate by".
        doing: &'static str,
        /// What to name: "parameter", "outcome".
        what: &'static str,
    },
    /// A setup file that cannot be opened or read.
    #[error(
        "the setup file '{file}': {}; a setup is a preset ({presets}) or a TOML file",
        read_error_text(source)
    )]
    File {
        /// The file.
        file: String,
        /// Why.
        source: std::io::Error,
        /// The presets there are.
        presets: String,
    },
    /// A setup file that is not TOML.
    #[error("{file}: {message}")]
    Toml {
        /// The file.
        file: String,
        /// The parser's message, with line, column and the line itself.
        message: String,
    },
    /// Something wrong at a place of a setup file.
    #[error("{file}:{line}:{column}: {source}")]
    InFile {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// What is wrong there.
        source: Box<Error>,
    },
    /// A key that a setup file gives twice, in two spellings.
    #[error("'{key}' is given twice, here and at line {line}; keep one")]
    Twice {
        /// The key, dotted.
        key: String,
        /// The line of the first.
        line: usize,
    },
    /// A key of a setup file with a value of the wrong kind.
    #[error("'{key}' is {found}; expected {expected}")]
    WrongType {
        /// The key, dotted.
        key: String,
        /// What stands there.
        found: &'static str,
        /// What should.
        expected: String,
    },
    /// An impact point beyond the edge of the face's ellipsoid.
    #[error(
        "the strike is off the face: strike.high = {high_mm} mm and strike.toe = {toe_mm} mm give \
         q = {q} \
         (q = (high²/roll_radius + toe²/bulge_radius)/face_semi_axis), which must be below 1; \
         strike nearer the sweet spot or flatten the face"
    )]
    OffFace {
        /// `strike.high`, mm.
        high_mm: f64,
        /// `strike.toe`, mm.
        toe_mm: f64,
        /// The ellipsoid's q.
        q: f64,
    },
    /// A face that does not move towards the ball.
    #[error("{}", no_strike(*approach))]
    NoStrike {
        /// n·u⁻, m/s.
        approach: f64,
    },
    /// An impact that the rigid-body equations do not resolve.
    #[error("the impact has no solution: {reason}")]
    Jammed {
        /// Why, with numbers.
        reason: String,
    },
    /// A flight that cannot be followed.
    #[error(
        "the flight diverged at t = {} s: drag and lift change the velocity too much within a step \
         (flight.step = {} s) to be \
         followed; {advice}", significant(*time, 5), significant(*step, 5)
    )]
    Diverged {
        /// When, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// What is out of the ordinary, and what to do.
        advice: String,
    },
    /// A drive that does not fly; see the model page, landing.
    #[error("{reason}")]
    NoFlight {
        /// That there is no flight or no landing, and why, with numbers.
        reason: Message,
    },
    /// What is wrong with one of several drives.
    #[error("{drive}: {source}")]
    OfDrive {
        /// The drive: "drive a".
        drive: &'static str,
        /// What is wrong with it.
        source: Box<Error>,
    },
    /// An outcome, or its derivative, that does not exist for this drive.
    #[error("{what} is not defined for this drive: {reason}")]
    Undefined {
        /// The outcome or derivative.
        what: String,
        /// Why.
        reason: String,
    },
    /// A batch that no one has room for.
    #[error("{rows} drives would take {size}, more than {limit}; {advice}")]
    TooLarge {
        /// How many drives.
        rows: String,
        /// The space their rows would take, and the time where it is known.
        size: String,
        /// What there is.
        limit: String,
        /// What to do.
        advice: String,
    },
    /// A table of points that cannot be read.
    #[error("{file}{place}: {reason}")]
    Table {
        /// The file.
        file: String,
        /// Where in it: ", row 3, column club.loft"; empty for the file itself.
        place: String,
        /// What is wrong there, and what to do.
        reason: String,
    },
    /// A file of results that cannot be begun, written or gone on with.
    #[error("the file '{file}': {reason}")]
    Results {
        /// The file.
        file: String,
        /// Why, and what to do.
        reason: String,
    },
    /// An answer that could not be written.
    #[error("cannot write the answer: {}", write_error_text(.0))]
    Output(std::io::Error),
    /// A plot that cannot be drawn.
    #[error("the plot '{name}': {reason}")]
    Plot {
        /// The plot, or the file it was to be.
        name: String,
        /// Why, and what to do.
        reason: String,
    },
    /// A question about an optimum where none was found.
    #[error("no optimum was found: {status}: {message}")]
    NotConverged {
        /// How the search ended.
        status: &'static str,
        /// The same in a sentence.
        message: Message,
    },
    /// A checkpoint file that cannot be used.
    #[error("the checkpoint '{file}': {reason}")]
    Checkpoint {
        /// The file.
        file: String,
        /// Why, and what to do.
        reason: String,
    },
    /// A constraint that cannot be read.
    #[error("`subject_to`: {reason}\n  {expression}\n  {}^", " ".repeat(*.column))]
    Constraint {
        /// The constraint as given.
        expression: String,
        /// Where in it, in characters from 0.
        column: usize,
        /// What is wrong there, and what to write.
        reason: String,
    },
    /// A tolerance that no integration meets.
    #[error("the tolerance of {} m: {reason}", significant(*tolerance, 5))]
    Tolerance {
        /// The tolerance, m.
        tolerance: f64,
        /// Why, and what to do.
        reason: String,
    },
    /// A calibration that cannot be made.
    #[error("calibration: {reason}")]
    Calibration {
        /// Why, and what to do.
        reason: String,
    },
    /// A delivery that cannot be looked for.
    #[error("delivery: {reason}")]
    Delivery {
        /// Why, and what to do.
        reason: String,
    },
    /// Rows of a sound calibration that have no answer: they do not fly.
    #[error("calibration: {reason}")]
    NoFit {
        /// What the rows end as: the status that all of them have, or `no-answer`.
        status: &'static str,
        /// The rows, each with its reason, and what to do.
        reason: String,
    },
    /// An optimizer setting or problem that makes no sense.
    #[error("optimizer: {0}")]
    Optimizer(String),
}

impl Error {
    /// The error for a name that is not among `names`, with the nearest of them.
    pub fn unknown<'a>(
        what: &'static str,
        name: &str,
        names: impl IntoIterator<Item = &'a str>,
        advice: impl Into<String>,
    ) -> Self {
        let nearest = nearest(name, names).filter(|(likeness, _)| *likeness > 0.8);
        let suggestion = nearest.map(|(_, known)| known.to_owned());
        Self::Unknown {
            what,
            name: name.into(),
            suggestion,
            advice: advice.into(),
        }
    }

    /// The error as that of one of several drives: "drive a".
    #[must_use]
    pub fn of_drive(self, drive: &'static str) -> Self {
        Self::OfDrive {
            drive,
            source: Box::new(self),
        }
    }

    /// Why a file cannot be written, in words: "the disk is full".
    pub fn why_unwritten(error: &std::io::Error) -> String {
        write_error_text(error)
    }

    /// The error with computed quantities in the units of a system; what was given is named as it
    /// was given.
    pub fn in_units(&self, system: System) -> String {
        self.message().in_units(system)
    }

    /// The error as a message, to be shown as part of another.
    pub fn message(&self) -> Message {
        match self {
            Self::NoFlight { reason } => reason.clone(),
            Self::NotConverged { status, message } => {
                Message::from(format!("no optimum was found: {status}: ")).message(message.clone())
            }
            Self::NoStrike { approach } => no_strike(*approach),
            Self::OfDrive { drive, source } => {
                Message::from(format!("{drive}: ")).message(source.message())
            }
            other => other.to_string().into(),
        }
    }

    /// Whether the question was sound but has no answer (a drive that does not fly, a flight that
    /// diverges, an angle without direction), as against bad input.
    pub fn is_an_outcome(&self) -> bool {
        self.status() != "error"
    }

    /// The error in a word, as JSON answers give it: `no-flight`, `diverged`, `undefined`, how a
    /// search ended (`infeasible`, …), `no-answer` where the rows of a calibration end differently,
    /// or `error` for bad input.
    pub fn status(&self) -> &'static str {
        match self {
            Self::NoFlight { .. } => "no-flight",
            Self::Diverged { .. } => "diverged",
            Self::Undefined { .. } => "undefined",
            Self::OfDrive { source, .. } => source.status(),
            Self::NotConverged { status, .. } | Self::NoFit { status, .. } => status,
            _ => "error",
        }
    }
}

/// In what a face misses the ball.
fn no_strike(approach: f64) -> Message {
    Message::from(
        "the club does not strike the ball: the contact point approaches along the face \
                   normal at ",
    )
    .quantity(Quantity::SPEED, "m/s", approach, Digits::Significant(5))
    .words(
        ", which must be above 0; check swing.speed, club.loft, swing.face_angle, \
                swing.shaft_lean and swing.shaft_bend, which grows with the square of the speed",
    )
}

/// The name that is most like a given one, and how alike they are, 0 to 1.
pub(crate) fn nearest<'a>(
    name: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<(f64, &'a str)> {
    let alike: Vec<_> = names
        .into_iter()
        .map(|known| (similarity(name, known), known))
        .collect();
    let most = alike
        .iter()
        .map(|(likeness, _)| *likeness)
        .max_by(f64::total_cmp)?;
    // of names that are equally alike the one that looks like it: o is not 0, but looks so
    let looks = |text: &str| text.replace('0', "o").replace('1', "l");
    let as_it_looks = |known: &str| similarity(&looks(name), &looks(known));
    let equally = alike.into_iter().filter(|(likeness, _)| *likeness == most);
    equally.max_by(|a, b| as_it_looks(a.1).total_cmp(&as_it_looks(b.1)))
}

/// How alike two names are, 0 to 1. Of names of one group the rest is compared; a name without its
/// group ("loft") is compared with the last part too; names that differ in their case alone are the
/// same.
fn similarity(given: &str, known: &str) -> f64 {
    if given.eq_ignore_ascii_case(known) {
        return 1.0;
    }
    match (given.rsplit_once('.'), known.rsplit_once('.')) {
        (Some((group, rest)), Some((of, known))) if group == of => {
            strsim::jaro_winkler(rest, known)
        }
        (None, Some((_, last))) => {
            strsim::jaro_winkler(given, known).max(0.99 * strsim::jaro_winkler(given, last))
        }
        _ => strsim::jaro_winkler(given, known),
    }
}

fn suggested(suggestion: &Option<String>) -> String {
    suggestion
        .as_ref()
        .map(|name| format!("did you mean '{name}'? "))
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::Error;

    #[test]
    fn nearest_name_is_suggested() {
        let names = ["club.loft", "club.mass", "swing.attack_angle"];
        for (given, meant) in [
            ("club.lofft", "club.loft"),
            ("loft", "club.loft"),
            ("atack_angle", "swing.attack_angle"),
        ] {
            let message = Error::unknown("parameter", given, names, "list").to_string();
            assert!(
                message.contains(&format!("did you mean '{meant}'?")),
                "{message}"
            );
        }
        let coefficients = ["aero.cd0", "aero.cd1", "aero.cd2"];
        let message = Error::unknown("parameter", "aero.cdo", coefficients, "list").to_string();
        assert!(message.contains("did you mean 'aero.cd0'?"), "{message}");
        for strange in ["xyzzy", "sw"] {
            let message = Error::unknown("parameter", strange, names, "list").to_string();
            assert!(!message.contains("did you mean"), "{message}");
        }
    }
}
