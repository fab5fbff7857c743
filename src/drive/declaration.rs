//! The declaration of an outcome, without its formula.

use crate::parameters::Range;
use crate::units::{Digits, Message, Quantity};

/// Facts about an outcome, apart from its formula.
pub(super) struct Declaration {
    /// Name in JSON and on the command line: `carry`.
    pub name: &'static str,
    /// Symbol in docs/model.md.
    pub symbol: &'static str,
    /// One line of documentation.
    pub doc: &'static str,
    /// Kind of quantity, with its SI unit.
    pub quantity: Quantity,
    /// Display unit.
    pub unit: &'static str,
    /// Part of the drive that the formula reads.
    pub computed_from: ComputedFrom,
    /// Sign of the values of the outcome.
    pub sign: Sign,
    /// How launch monitors measure the outcome; `None` for an outcome that describes the design of
    /// the club head, not the shot.
    pub instrument: Option<Instrument>,
}

/// Part of a drive that the formula of an outcome reads. If the formula reads several parts, this
/// is the part that is computed last. It determines the order of convergence of the outcome.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ComputedFrom {
    /// The launch.
    Launch,
    /// Position and time of the landing.
    Landing,
    /// Velocity at landing.
    LandingVelocity,
    /// Height of the apex. An error of the apex time does not change the height to first order,
    /// because the height is a maximum.
    ApexHeight,
    /// Time or horizontal position of the apex.
    ApexTime,
    /// Position at rest.
    Rest,
    /// The head with its movable weights.
    Head,
}

/// Part of a drive that an outcome describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutcomeGroup {
    /// The launch of the ball.
    Launch,
    /// The flight; undefined if the ball does not fly.
    Flight,
    /// The head with its movable weights.
    Head,
}

/// Sign of the values of an outcome.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    /// Above 0 in every drive that lands.
    Positive,
    /// 0 or more.
    NotNegative,
    /// Positive to the right of the target line.
    Right,
    /// Positive or negative.
    Either,
}

/// An outcome as launch monitors measure and export it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instrument {
    /// Standard uncertainty of the outcome, with unit: `0.3 deg`.
    pub sigma: &'static str,
    /// Source, or "assumed: …" with the reasoning if no source was found. Lengths and speeds in
    /// braces are printed in the user's units.
    pub(super) source: &'static str,
    /// Plausible values of a drive, in the display unit of the outcome; `None` if any value is
    /// accepted. A measured value outside this range counts as an error in the table, such as a
    /// wrong unit. The lower end is excluded where launch monitors export 0 for a value that they
    /// did not measure.
    pub(crate) plausible: Option<Range>,
    /// Column heads of exports, in lower case, without punctuation.
    pub(crate) column_heads: &'static [&'static str],
}

impl Instrument {
    /// The source of the uncertainty, or the reasoning behind an assumption.
    pub fn source(&self) -> Message {
        let parts = self.source.split(['{', '}']).enumerate();
        parts.fold(Message::default(), |message, (i, part)| {
            match quantity(part) {
                Some((quantity, unit, value)) if i % 2 == 1 => {
                    message.quantity(quantity, unit, value, Digits::Significant(2))
                }
                _ => message.words(part),
            }
        })
    }
}

/// Quantity, unit and SI value of a length or a speed as text; `None` for other texts.
fn quantity(text: &str) -> Option<(Quantity, &'static str, f64)> {
    let kinds = [(Quantity::LENGTH, "yd"), (Quantity::SPEED, "mph")];
    kinds
        .into_iter()
        .find_map(|(quantity, unit)| Some((quantity, unit, quantity.read(text).ok()?)))
}
