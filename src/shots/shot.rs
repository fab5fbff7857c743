//! A shot of a launch monitor.

use crate::drive::Outcome;
use crate::parameters::{Golfer, Parameter};
use crate::table::{
    CONDITIONS, LAUNCH_PARAMETERS, NOT_MEASURED, Refusal, StatedConditions, implausible_club,
};

/// Flight status of a row that was not flown.
pub(super) const REFUSED: &str = "refused";

/// Beginning of each note on a stated outcome that is not compared with predictions.
pub(super) const NOT_COMPARED: &str = "not compared: ";

/// Origin of a value, as the export states it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Measured by the instrument.
    Measured,
    /// Estimated by the instrument from its measurements.
    Estimated,
    /// Computed by a model.
    Modelled,
}

variant_names! {
    /// Name in files.
    Origin as "Origin" {
        Measured = "measured",
        Estimated = "estimated",
        Modelled = "modelled",
    }
}

impl Origin {
    /// Parses the origin in a cell, such as `Measured` or `Estimate`; `None` for any other text.
    pub(super) fn read(cell: &str) -> Option<Self> {
        match cell.to_lowercase().as_str() {
            "measured" | "actual" => Some(Self::Measured),
            "estimated" | "estimate" | "est" | "est." | "calculated" => Some(Self::Estimated),
            "modelled" | "modeled" | "model" => Some(Self::Modelled),
            _ => None,
        }
    }
}

/// A value that a row states for an outcome.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatedValue {
    /// Outcome.
    pub of: Outcome,
    /// Value, SI.
    pub value: f64,
    /// Origin; `None` if the export does not state it.
    pub origin: Option<Origin>,
}

/// Club data of a row, SI.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Club {
    /// Club speed.
    pub speed: Option<f64>,
    /// Attack angle.
    pub attack_angle: Option<f64>,
    /// Club path, + right.
    pub path: Option<f64>,
    /// Face angle to the target, + right.
    pub face_angle: Option<f64>,
}

impl Club {
    /// Names of the parameters of the club data, in the order of [`values`](Self::values).
    pub const NAMES: [&'static str; 4] = [
        "swing.speed",
        "swing.attack_angle",
        "swing.path",
        "swing.face_angle",
    ];

    /// Club data from stated values, in the order of [`NAMES`](Self::NAMES); `heads` are the column
    /// heads. An unreadable or implausible value counts as not measured, and `notes` receives the
    /// reason. If all stated values are 0, including the club speed, the club was not measured, which
    /// needs no note.
    pub(super) fn measured(
        stated: [Result<Option<f64>, String>; 4],
        heads: [&str; 4],
        notes: &mut Vec<String>,
    ) -> Self {
        let stated = stated.map(|value| {
            value.unwrap_or_else(|why| {
                notes.push(format!("{why}; it {NOT_MEASURED}"));
                None
            })
        });
        if Self::is_unmeasured(stated) {
            return Self::default();
        }
        let mut values = [None; 4];
        for (at, stated) in stated.into_iter().enumerate() {
            let Some(value) = stated else {
                continue;
            };
            match implausible_club(Self::NAMES[at], value, heads[at]) {
                Some(why) => notes.push(why),
                None => values[at] = Some(value),
            }
        }
        Self::of(values)
    }

    /// Club data from values in the order of [`NAMES`](Self::NAMES).
    pub(super) fn of([speed, attack_angle, path, face_angle]: [Option<f64>; 4]) -> Self {
        Self {
            speed,
            attack_angle,
            path,
            face_angle,
        }
    }

    /// True if the stated values include the club speed and are all 0: the club was not measured.
    pub(crate) fn is_unmeasured(values: [Option<f64>; 4]) -> bool {
        values[0].is_some() && values.into_iter().flatten().all(|value| value == 0.0)
    }

    /// Index of a parameter in [`NAMES`](Self::NAMES); `None` for a parameter that is not club
    /// data.
    pub(crate) fn index_of(parameter: &Parameter) -> Option<usize> {
        Self::NAMES.iter().position(|name| *name == parameter.name)
    }

    /// Converts between the convention of this type (+ right) and that of the parameters (+ in to
    /// out, + open). They differ for a left-handed golfer. The conversion is its own inverse.
    pub(crate) fn other_convention(self, golfer: Golfer) -> Self {
        match golfer {
            Golfer::Right => self,
            Golfer::Left => Self {
                // 0 − value avoids −0 for a straight club
                path: self.path.map(|path| 0.0 - path),
                face_angle: self.face_angle.map(|face| 0.0 - face),
                ..self
            },
        }
    }

    /// Values in the order of [`NAMES`](Self::NAMES).
    pub fn values(&self) -> [Option<f64>; 4] {
        [self.speed, self.attack_angle, self.path, self.face_angle]
    }
}

/// A shot: a row of an export, or a message.
#[derive(Clone, Debug)]
pub struct Shot {
    /// Number of the first line of the row in the file, from 1.
    pub line: u64,
    /// Text of the row.
    pub text: String,
    /// Stated values of the ball: launch conditions and outcomes of the flight.
    pub values: Vec<StatedValue>,
    /// Club data.
    pub club: Club,
    /// Name of the club, if a column or a JSON line of `fly` has it.
    pub club_name: Option<String>,
    /// Conditions that the row states for its values, such as normalized weather; `None` if the row
    /// states none.
    pub condition: Option<String>,
    /// True if the row states that its values are normalized.
    pub is_normalized: bool,
    /// Notes on assumed or unused values.
    pub notes: Vec<String>,
    /// Input of the flight, SI: the launch (ball speed, launch angle, launch direction, backspin,
    /// sidespin), then the other parameters of the table. An error if the row cannot be flown.
    pub(super) point: Result<Vec<f64>, Refusal>,
    /// True if the row has exactly one cell for each column head.
    pub(crate) has_cells_of_head: bool,
}

impl Shot {
    /// A row that cannot be flown.
    pub(super) fn refused(line: u64, text: String, refusal: Refusal) -> Self {
        Self {
            line,
            text,
            values: vec![],
            club: Club::default(),
            club_name: None,
            condition: None,
            is_normalized: false,
            notes: vec![],
            point: Err(refusal),
            has_cells_of_head: false,
        }
    }

    /// The launch: ball speed, launch angle, launch direction, backspin and sidespin, SI. `None` if
    /// the shot cannot be flown.
    pub fn launch(&self) -> Option<&[f64]> {
        self.point
            .as_ref()
            .ok()
            .map(|point| &point[..LAUNCH_PARAMETERS.len()])
    }

    /// Values of the parameters that are not part of the launch, SI, in the order of
    /// [`Shots::other_parameters`](crate::shots::Shots::other_parameters). Empty if the shot cannot
    /// be flown.
    pub fn other_parameters(&self) -> &[f64] {
        self.point
            .as_ref()
            .map_or(&[], |point| &point[LAUNCH_PARAMETERS.len()..])
    }

    /// The reason why the shot cannot be flown; `None` if it can.
    pub fn refusal(&self) -> Option<&Refusal> {
        self.point.as_ref().err()
    }

    /// Stated value of an outcome; `None` if the row does not state it.
    pub fn value(&self, of: Outcome) -> Option<StatedValue> {
        self.values.iter().find(|value| value.of == of).copied()
    }

    /// The origin of the total spin, or of the backspin without a total spin: measured, estimated
    /// or modelled. `None` if the export does not state it.
    pub fn spin_origin(&self) -> Option<Origin> {
        let spin = self.value(Outcome::Spin);
        spin.or_else(|| self.value(Outcome::Backspin))?.origin
    }

    /// The notes on values of the club that are not used.
    pub(crate) fn club_notes(&self) -> impl Iterator<Item = &String> {
        self.notes
            .iter()
            .filter(|note| note.ends_with(NOT_MEASURED))
    }

    /// The reasons why stated outcomes are not compared with predictions.
    pub(crate) fn not_compared(&self) -> impl Iterator<Item = String> {
        self.notes
            .iter()
            .filter_map(|note| note.strip_prefix(NOT_COMPARED).map(str::to_owned))
    }

    /// Stated launch conditions in the order of [`CONDITIONS`].
    pub(super) fn conditions(&self) -> StatedConditions {
        CONDITIONS.map(|of| self.value(of).map(|value| value.value))
    }

    /// True if the row states no launch direction. The flight then starts with the direction 0.
    pub fn is_direction_assumed(&self) -> bool {
        self.value(Outcome::LaunchDirection).is_none()
    }

    /// True if the row states neither spin axis nor sidespin. The flight then starts with the spin
    /// axis 0.
    pub fn is_axis_assumed(&self) -> bool {
        self.value(Outcome::SpinAxis).is_none() && self.value(Outcome::Sidespin).is_none()
    }
}

/// Returns the value if it is in the range of the parameter. `name` is the column head for the
/// message.
///
/// # Errors
/// The refusal, if the value is outside the range.
pub(super) fn within(parameter: &Parameter, value: f64, name: &str) -> Result<f64, Refusal> {
    if parameter.range.contains(value) {
        return Ok(value);
    }
    let shown = parameter.show(Some(value));
    let range = parameter.range.show(parameter.quantity, parameter.unit);
    Err(Refusal::new(
        Refusal::RANGE,
        format!("{name}: {shown} is outside of its range {range}"),
    ))
}
