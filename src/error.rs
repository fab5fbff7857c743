//! Errors: invalid input, and drives without a result.

use crate::external_errors::{read_error_text, write_error_text};
use crate::units::{Digits, Message, Quantity, System, significant};

/// `Result` with longdrive's [`enum@Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// An error. Each message says what is wrong, with the value, the allowed range, and advice.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An unknown name.
    #[error("unknown {what} '{name}'; {}{advice}", suggested(suggestion))]
    Unknown {
        /// Kind of the name: "parameter", "outcome", "preset", "aerodynamic law".
        what: &'static str,
        /// The given name.
        name: String,
        /// The most similar known name.
        suggestion: Option<String>,
        /// How to list the known names.
        advice: String,
    },
    /// A coefficient of an aerodynamic law that the setup does not use.
    #[error(
        "'{name}' is a coefficient of {owners}, but this setup uses the law '{law}'; set aero.law \
         too"
    )]
    OtherLaw {
        /// The parameter.
        name: String,
        /// The setup's law.
        law: &'static str,
        /// The laws with this coefficient.
        owners: String,
    },
    /// A value that cannot be parsed.
    #[error("{name}: {source}")]
    Unreadable {
        /// The parameter.
        name: String,
        /// The reason.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// A value outside the physically possible range.
    #[error("{name} = {value} is outside its range {range}; {advice}")]
    OutOfRange {
        /// The parameter.
        name: String,
        /// The value, SI.
        si: f64,
        /// The value, with its unit.
        value: String,
        /// The range, with its unit.
        range: String,
        /// Advice, or the value that was probably meant.
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
    /// An inertia tensor that is not positive definite.
    #[error(
        "club.inertia is not positive definite: its smallest principal moment is {smallest:e} kg \
         m^2; raise club.inertia.xx, .yy, .zz or reduce the products .xy, .xz, .yz"
    )]
    Inertia {
        /// The smallest eigenvalue, kg m².
        smallest: f64,
    },
    /// Incomplete or conflicting launch conditions.
    #[error(
        "the launch ({given}): {reason}; a launch has ball_speed, launch_angle, perhaps \
         launch_direction, and either backspin (perhaps sidespin) or spin (perhaps spin_axis)"
    )]
    Launch {
        /// The given conditions.
        given: String,
        /// The missing or duplicate condition.
        reason: String,
    },
    /// A value that violates the Rules of Golf.
    #[error(
        "against {rule}: {found}, and the rule is {limit}; {advice}, or leave the Rules of Golf \
         out with `rules none`"
    )]
    Rule {
        /// The rule with its source.
        rule: String,
        /// The quantity and its value.
        found: String,
        /// The limit.
        limit: String,
        /// Advice.
        advice: String,
    },
    /// Conflicting parameters, or a parameter that needs another parameter.
    #[error("{given}: {reason}")]
    Together {
        /// The given or missing parameters.
        given: String,
        /// The reason, and advice.
        reason: String,
    },
    /// A parameter that a search cannot vary, and that has no derivatives.
    #[error("{name} cannot be varied, and has no derivatives: {reason}")]
    NotVariable {
        /// The parameter.
        name: String,
        /// The reason, and advice.
        reason: String,
    },
    /// An invalid range of a search or a sweep.
    #[error("the range {name}: {reason}")]
    SearchRange {
        /// The parameter, with its range as given.
        name: String,
        /// The reason, and advice.
        reason: String,
    },
    /// An operation that needs at least one parameter or outcome, but has none, such as a search
    /// without parameters to vary.
    #[error("nothing to {doing}: name at least one {what}")]
    Nothing {
        /// The operation: "vary", "differentiate by".
        doing: &'static str,
        /// The kind of the missing name: "parameter", "outcome".
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
        /// The reason.
        source: std::io::Error,
        /// Names of the presets.
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
    /// An error at a place of a setup file.
    #[error("{file}:{line}:{column}: {source}")]
    InFile {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The error at this place.
        source: Box<Error>,
    },
    /// A key that a setup file gives twice, in two spellings.
    #[error("'{key}' is given twice, here and at line {line}; keep one")]
    Twice {
        /// The key, dotted.
        key: String,
        /// The line of the first occurrence.
        line: usize,
    },
    /// A key of a setup file with a value of the wrong type.
    #[error("'{key}' is {found}; expected {expected}")]
    WrongType {
        /// The key, dotted.
        key: String,
        /// Type in the file.
        found: &'static str,
        /// Expected type.
        expected: String,
    },
    /// An impact point outside the ellipsoid of the face.
    #[error(
        "the strike is off the face: strike.high = {high_mm} mm and strike.toe = {toe_mm} mm give \
         q = {q} (q = (high²/roll_radius + toe²/bulge_radius)/face_semi_axis), which must be below 1; \
         strike nearer the sweet spot or flatten the face"
    )]
    OffFace {
        /// `strike.high`, mm.
        high_mm: f64,
        /// `strike.toe`, mm.
        toe_mm: f64,
        /// q, as defined in the message. A strike on the face has q < 1.
        q: f64,
    },
    /// A face that does not move towards the ball.
    #[error("{}", no_strike(*approach))]
    NoStrike {
        /// Speed of the face towards the ball along the face normal, m/s: not above 0.
        approach: f64,
    },
    /// An impact without a solution of the rigid-body equations.
    #[error("the impact has no solution: {reason}")]
    Jammed {
        /// The reason, with numbers.
        reason: String,
    },
    /// A flight whose integration diverged.
    #[error(
        "the flight diverged at t = {} s: drag and lift change the velocity too much within one \
         step (flight.step = {} s), or a number overflows; {advice}",
        significant(*time, 5),
        significant(*step, 5)
    )]
    Diverged {
        /// Time of the divergence, s.
        time: f64,
        /// The step, s.
        step: f64,
        /// Unusual conditions, and advice.
        advice: String,
    },
    /// A flight whose defect (docs/model.md, eq. 16a) exceeds its limit even with the shortest
    /// step.
    #[error("{}", large_defect(*defect, *limit, *step))]
    LargeDefect {
        /// The defect, m.
        defect: f64,
        /// Largest accepted defect, m.
        limit: f64,
        /// The step, s.
        step: f64,
    },
    /// A drive that was interrupted: its caller set the interrupt flag.
    #[error("stopped before the ball landed")]
    Stopped,
    /// A drive without a landing (docs/model.md, Landing).
    #[error("{reason}")]
    NoFlight {
        /// `no-flight`, or `aloft` for a ball in the air at the time limit.
        status: &'static str,
        /// The reason, with numbers.
        reason: Message,
    },
    /// An error of one of several drives.
    #[error("{drive}: {source}")]
    OfDrive {
        /// The drive: "drive a".
        drive: &'static str,
        /// The error of this drive.
        source: Box<Error>,
    },
    /// An outcome, or its derivative, that does not exist for this drive.
    #[error("{what} is not defined for this drive: {reason}")]
    Undefined {
        /// The outcome or derivative.
        what: String,
        /// The reason.
        reason: String,
    },
    /// A batch that exceeds the memory or disk space.
    #[error("{rows} drives would take {size}, more than {limit}; {advice}")]
    TooLarge {
        /// Number of drives.
        rows: String,
        /// Required space, and time if it is known.
        size: String,
        /// Available space.
        limit: String,
        /// Advice.
        advice: String,
    },
    /// A table that cannot be read.
    #[error("{file}{place}: {reason}")]
    Table {
        /// The file.
        file: String,
        /// Place in the file: ", row 3, column club.loft"; empty for the whole file.
        place: String,
        /// The reason, and advice.
        reason: String,
    },
    /// A file of results that cannot be created, written or resumed.
    #[error("the file '{file}': {reason}")]
    Results {
        /// The file.
        file: String,
        /// The reason, and advice.
        reason: String,
    },
    /// Output of a command that cannot be written.
    #[error("cannot write the answer: {}", write_error_text(.0))]
    Output(std::io::Error),
    /// A plot that cannot be drawn.
    #[error("the plot '{name}': {reason}")]
    Plot {
        /// The plot, or its file.
        name: String,
        /// The reason, and advice.
        reason: String,
    },
    /// A search that found no optimum.
    #[error("no optimum was found: {status}: {message}")]
    NotConverged {
        /// Status of the search.
        status: &'static str,
        /// The status as a sentence.
        message: Message,
    },
    /// A checkpoint file that cannot be used.
    #[error("the checkpoint '{file}': {reason}")]
    Checkpoint {
        /// The file.
        file: String,
        /// The reason, and advice.
        reason: String,
    },
    /// A constraint that cannot be parsed.
    #[error("`subject_to`: {reason}\n  {expression}\n  {}^", " ".repeat(*.column))]
    Constraint {
        /// The given constraint.
        expression: String,
        /// Position of the error, in characters from 0.
        column: usize,
        /// The reason, and advice.
        reason: String,
    },
    /// A tolerance that no step of the integration meets.
    #[error("the tolerance of {} m: {reason}", significant(*tolerance, 5))]
    Tolerance {
        /// The tolerance, m.
        tolerance: f64,
        /// The reason, and advice.
        reason: String,
    },
    /// An invalid calibration.
    #[error("calibration: {reason}")]
    Calibration {
        /// The reason, and advice.
        reason: String,
    },
    /// A delivery that cannot be determined.
    #[error("delivery: {reason}")]
    Delivery {
        /// The reason, and advice.
        reason: String,
    },
    /// A valid calibration that fails because the drives of some rows have no result: a ball does
    /// not fly, for example.
    #[error("calibration: {reason}")]
    NoFit {
        /// The status of the rows, or `no-answer` if their statuses differ.
        status: &'static str,
        /// The failed rows, the reason for each row, and advice.
        reason: String,
    },
    /// An invalid setting or problem of the optimizer.
    #[error("optimizer: {0}")]
    Optimizer(String),
}

impl Error {
    /// The error for a value or an argument that cannot be used, with the reason and advice.
    pub fn unreadable(
        name: impl Into<String>,
        source: impl Into<Box<dyn std::error::Error + Send + Sync>>,
    ) -> Self {
        Self::Unreadable {
            name: name.into(),
            source: source.into(),
        }
    }

    /// The error for a table that cannot be read. `place` follows the name of the file in the
    /// message: ", row 3, column club.loft"; it is empty for the whole file.
    pub(crate) fn table(
        file: impl Into<String>,
        place: impl Into<String>,
        reason: impl Into<String>,
    ) -> Self {
        Self::Table {
            file: file.into(),
            place: place.into(),
            reason: reason.into(),
        }
    }

    /// The error for a name that is not among `names`. It suggests the most similar of them, or
    /// lists the names of a group such as `wind`.
    pub fn unknown<'a>(
        what: &'static str,
        name: &str,
        names: impl IntoIterator<Item = &'a str>,
        advice: impl Into<String>,
    ) -> Self {
        let names: Vec<&str> = names.into_iter().collect();
        let is_member = |known: &&str| known.split_once('.').is_some_and(|(of, _)| of == name);
        let members: Vec<&str> = names.iter().copied().filter(is_member).collect();
        let advice = advice.into();
        if !members.is_empty() {
            return Self::Unknown {
                what,
                name: name.into(),
                suggestion: None,
                advice: format!("it is a group: {}; {advice}", members.join(", ")),
            };
        }
        let nearest = nearest(name, names).filter(|(likeness, _)| *likeness > 0.8);
        Self::Unknown {
            what,
            name: name.into(),
            suggestion: nearest.map(|(_, known)| known.to_owned()),
            advice,
        }
    }

    /// Adds the name of the drive, "drive a", to the error.
    #[must_use]
    pub fn of_drive(self, drive: &'static str) -> Self {
        Self::OfDrive {
            drive,
            source: Box::new(self),
        }
    }

    /// The error as text. Computed quantities are in the units of `system`; values that the user
    /// gave are unchanged.
    pub fn in_units(&self, system: System) -> String {
        self.message().in_units(system)
    }

    /// The error as a message, for use in another message.
    pub fn message(&self) -> Message {
        match self {
            Self::NoFlight { reason, .. } => reason.clone(),
            Self::NotConverged { status, message } => {
                Message::from(format!("no optimum was found: {status}: ")).message(message.clone())
            }
            Self::NoStrike { approach } => no_strike(*approach),
            Self::LargeDefect {
                defect,
                limit,
                step,
            } => large_defect(*defect, *limit, *step),
            Self::OfDrive { drive, source } => {
                Message::from(format!("{drive}: ")).message(source.message())
            }
            other => other.to_string().into(),
        }
    }

    /// True if the input is valid but has no result: a ball that does not fly, for example, a
    /// flight that diverges, or an outcome that is not defined for the drive.
    pub fn has_valid_input(&self) -> bool {
        self.status() != "error"
    }

    /// Status in JSON: `no-flight`, `aloft`, `diverged`, `interrupted`, `undefined`, the status of
    /// a search (`infeasible`, …), `no-answer` for rows of a calibration with different statuses,
    /// or `error` for invalid input.
    pub fn status(&self) -> &'static str {
        match self {
            Self::Diverged { .. } | Self::LargeDefect { .. } => "diverged",
            Self::Stopped => "interrupted",
            Self::Undefined { .. } => "undefined",
            Self::OfDrive { source, .. } => source.status(),
            Self::NoFlight { status, .. }
            | Self::NotConverged { status, .. }
            | Self::NoFit { status, .. } => status,
            _ => "error",
        }
    }
}

fn no_strike(approach: f64) -> Message {
    Message::from(
        "the club does not strike the ball: the contact point approaches the ball along the face \
         normal at ",
    )
    .quantity(Quantity::SPEED, "m/s", approach, Digits::Significant(5))
    .words(
        ", which must be above 0; check swing.speed, club.loft, swing.face_angle, \
         swing.shaft_lean and swing.shaft_bend, which grows with the head speed as \
         swing.shaft_growth says",
    )
}

fn large_defect(defect: f64, limit: f64, step: f64) -> Message {
    let length = |message: Message, value: f64| {
        message.quantity(Quantity::LENGTH, "m", value, Digits::Significant(2))
    };
    let message = Message::from("the integration error of the flight is estimated as ");
    let message = length(message, defect).words(", more than ");
    length(message, limit)
        .words(", also with flight.step = ")
        .quantity(Quantity::TIME, "s", step, Digits::Significant(2))
        .words("; give a larger tolerance, or set flight.method and flight.step")
}

/// The most similar of `names` to a given `name`, with its similarity, 0 to 1.
pub(crate) fn nearest<'a>(
    name: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<(f64, &'a str)> {
    let similarities: Vec<_> = names
        .into_iter()
        .map(|known| (similarity(name, known), known))
        .collect();
    let largest = similarities
        .iter()
        .map(|(similarity, _)| *similarity)
        .max_by(f64::total_cmp)?;
    // of equally similar names, prefer the name that looks most similar: 0 looks like o, 1 like l
    let glyphs = |text: &str| text.replace('0', "o").replace('1', "l");
    let by_glyphs = |known: &str| similarity(&glyphs(name), &glyphs(known));
    // if two names also look equally similar, take the first: swing.speed before wind.speed
    similarities
        .into_iter()
        .rev()
        .filter(|(similarity, _)| *similarity == largest)
        .max_by(|a, b| by_glyphs(a.1).total_cmp(&by_glyphs(b.1)))
}

/// Jaro–Winkler similarity of two names, 0 to 1; it is 1 for names that differ only in case. The
/// last dot of a name separates its group from its last part: "club.weight_1" and "toe". If both
/// names have the same number of dots, the similarity of the groups is multiplied by the similarity
/// of the last parts, so that a long group does not outweigh the last part. A name without a group
/// ("loft") is also compared with the last part of `known`. Names with different numbers of dots
/// have 0.9 of the similarity of the whole names, because a common group raises it.
fn similarity(given: &str, known: &str) -> f64 {
    if given.eq_ignore_ascii_case(known) {
        return 1.0;
    }
    let has_as_many_parts = given.matches('.').count() == known.matches('.').count();
    match (given.rsplit_once('.'), known.rsplit_once('.')) {
        (Some((group, rest)), Some((of, last))) if has_as_many_parts => {
            strsim::jaro_winkler(group, of) * strsim::jaro_winkler(rest, last)
        }
        (None, Some((_, last))) => {
            strsim::jaro_winkler(given, known).max(0.99 * strsim::jaro_winkler(given, last))
        }
        (None, None) => strsim::jaro_winkler(given, known),
        _ => 0.9 * strsim::jaro_winkler(given, known),
    }
}

fn suggested(suggestion: &Option<String>) -> String {
    suggestion
        .as_ref()
        .map(|name| format!("did you mean '{name}'? "))
        .unwrap_or_default()
}
