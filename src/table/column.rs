//! Meaning, unit and number format of a column.

use super::decimal_mark::DecimalMark;
use super::heads::{AIR, Meaning, rest_of_head};
use super::label::Label;
use super::launch_monitor;
use super::numbers;
use super::numbers::{CellSide, cell_number, unwrapped};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Golfer, Parameter, Setup};
use crate::units::{Quantity, Unit, UnitError};

/// Content of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Content {
    /// A parameter of the shot.
    Input(&'static Parameter),
    /// An outcome: a measured value, or a launch condition.
    Outcome(Outcome),
    /// The standard uncertainty of a measured outcome.
    Sigma(Outcome),
    /// Names of stationary parameters: the carry of the row is the maximum over these parameters.
    Stationary,
    /// Standard uncertainty of a stationary parameter at the maximum of the carry.
    SigmaStationary,
    /// A remark, ignored.
    Note,
    /// Output of this program (status, derivatives, predictions), ignored.
    Written,
    /// Values of a quantity that an earlier column has, ignored.
    Repeated,
}

/// A column. Its numbers are in `unit`, or in SI if there is no unit.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub content: Content,
    pub head: String,
    unit: Option<String>,
    /// The parsed unit; `None` if there is no unit, or if the unit does not fit the quantity.
    size: Option<Unit>,
    pub format: TableFormat,
    /// True for an air column that the setup overrides.
    pub is_overridden_air: bool,
    /// Handedness of the golfer.
    golfer: Golfer,
    /// True if each cell contains a unit.
    pub has_units_in_cells: bool,
    /// True if the unit is assumed, because the table states none.
    is_unit_assumed: bool,
    /// The side of positive values: stated behind the unit, as in `[deg L-/R+]`, or known of the
    /// maker. `None` for the usual side of the quantity.
    pub positive_side: Option<CellSide>,
    /// True if cells describe the weather by a text; the air density is computed from it.
    pub is_weather: bool,
    /// Kind of the cells, if the column belongs to an export: [`Label::Name`] where `Average` names
    /// a statistic of other rows.
    pub(super) label: Option<Label>,
}

/// Format of a table. The default is the format of a table in SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TableFormat {
    /// True for an export of a launch monitor. Its unknown columns are ignored.
    pub is_export: bool,
    /// The decimal mark; `None` if the first rows do not show it.
    pub decimal_mark: Option<DecimalMark>,
}

impl Default for TableFormat {
    fn default() -> Self {
        Self {
            is_export: false,
            decimal_mark: Some(DecimalMark::Point),
        }
    }
}

impl TableFormat {
    /// True if numbers may have decimal commas.
    pub fn has_decimal_comma(self) -> bool {
        self.decimal_mark != Some(DecimalMark::Point)
    }
}

/// Advice for tables of measured shots.
pub(super) const SHOTS_ADVICE: &str = "give each a name that is known, or take it out: a column is \
                                       a parameter, an outcome, 'sigma OUTCOME', 'stationary', \
                                       'sigma stationary' or 'note'";

/// Column head of stationary parameters.
const STATIONARY: &str = "stationary";
/// Column head of remarks.
const NOTE: &str = "note";
/// Column head of the status in sweeps.
pub(super) const STATUS: &str = "status";
/// Prefix of the names of launch conditions.
pub(super) const LAUNCH: &str = "launch.";

impl Column {
    /// Interprets the column head `head`: `carry [yd]`, `sigma carry [yd]`, `club.loft [deg]`,
    /// `stationary`, `note`, or a column head of a launch monitor. `below` is the unit in the line
    /// below the column heads.
    ///
    /// A column `carry` is the horizontal distance to the landing point, as launch monitors define
    /// carry, not the distance along the target line.
    pub fn read(
        setup: &Setup<f64>,
        head: &str,
        below: Option<&str>,
        format: TableFormat,
    ) -> Result<Self> {
        let head = head.trim();
        let (name, unit) = launch_monitor::split_unit(head);
        let signed = [unit.as_deref(), below].map(|unit| unit.map(numbers::unit_and_side));
        let sides = signed.clone().map(|stated| stated?.1);
        let [unit, below] = signed.map(|stated| Some(stated?.0));
        if let (Some(unit), Some(below)) = (&unit, &below)
            && !numbers::is_same_unit(unit, below)
        {
            let why = format!(
                "the head says [{unit}], and the line of units [{below}]; correct one of them"
            );
            return Err(Error::Unreadable {
                name: format!("the column '{name}'"),
                source: why.into(),
            });
        }
        let unit = unit.or(below);
        // true if a set parameter replaces this one; for example, the weather replaces the density
        let is_replaced = |name: &str| {
            let parameter = setup.parameter(name);
            parameter.is_ok_and(|parameter| setup.why_replaced(parameter).is_some())
        };
        let meaning = launch_monitor::meaning_with(name, unit.as_deref());
        let is_overridden_air = matches!(meaning, Some(Meaning::Input(AIR)) if is_replaced(AIR));
        let content = match (name.strip_prefix("sigma ").map(str::trim), meaning) {
            (None, Some(Meaning::Outcome(outcome))) => Content::Outcome(outcome),
            (None, Some(Meaning::Input(parameter))) if is_replaced(parameter) => Content::Note,
            (None, Some(Meaning::Input(parameter))) => Content::Input(setup.column(parameter)?),
            (None, None) if is_head_of_launch_monitor(name, format) => {
                let rest = rest_of_head(&launch_monitor::words(name));
                rest.map_or(Content::Note, Content::Outcome)
            }
            _ => named(setup, name)?,
        };
        let mut column = Self {
            unit,
            format,
            is_overridden_air,
            golfer: setup.golfer,
            ..Self::of(content, name)
        };
        column.positive_side = column.stated_side(sides)?;
        let is_of_an_export = format.is_export && launch_monitor::meaning(name).is_some();
        if is_of_an_export && column.unit.is_none() && column.quantity() == Some(Quantity::ANGLE) {
            (column.unit, column.is_unit_assumed) = (Some("deg".into()), true);
        }
        Ok(column.with_parsed_unit())
    }

    /// The side of positive values that the head and the line of units state.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if they contradict each other, or if the quantity has no such sides.
    fn stated_side(&self, [head, below]: [Option<CellSide>; 2]) -> Result<Option<CellSide>> {
        let Some(side) = head.or(below).filter(|_| self.quantity().is_some()) else {
            return Ok(None);
        };
        if below.is_some_and(|below| below != side) {
            let why = "the head and the line of units state opposite signs; correct one of them";
            return Err(self.unreadable(why));
        }
        if !self.accepts_side(side) {
            let why = "its unit states signs that do not fit the column; leave the signs out";
            return Err(self.unreadable(why));
        }
        Ok(Some(side))
    }

    /// Interprets the column name of a table in SI.
    #[cfg(any(feature = "arrow", feature = "parquet"))]
    pub fn in_si(setup: &Setup<f64>, name: &str) -> Result<Self> {
        let name = name.trim();
        named(setup, name)
            .map(|content| Self::of(content, name))
            .map_err(|error| {
                let alone = name.split(['[', '(']).next().unwrap_or_default().trim();
                let Some(Ok(content)) = (alone != name).then(|| named(setup, alone)) else {
                    return error;
                };
                let column = Self::of(content, alone);
                let unit = if column.unit().is_empty() {
                    String::new()
                } else {
                    format!(
                        ", with \
                numbers in {}",
                        column.unit()
                    )
                };
                column.unreadable(format!(
                "'{name}' has a unit in its name, but the columns of Parquet and Arrow tables are \
                 in SI; name it '{alone}'{unit}"
            ))
            })
    }

    /// A column with this content, in SI.
    pub fn of(content: Content, head: &str) -> Self {
        Self {
            content,
            head: head.into(),
            unit: None,
            size: None,
            format: TableFormat::default(),
            is_overridden_air: false,
            golfer: Golfer::Right,
            has_units_in_cells: false,
            is_unit_assumed: false,
            positive_side: None,
            is_weather: false,
            label: None,
        }
    }

    /// True if the column is ignored because its column head is unknown.
    pub fn is_unknown(&self) -> bool {
        self.content == Content::Note && self.head != NOTE && !self.is_overridden_air
    }

    /// True if the column is an angle without a unit, and is read in degrees.
    pub fn is_in_assumed_degrees(&self) -> bool {
        self.is_unit_assumed && !self.has_units_in_cells && self.quantity() == Some(Quantity::ANGLE)
    }

    /// True for a parameter of the groups swing, strike, club and impact.
    pub fn is_of_the_strike(&self) -> bool {
        matches!(self.content, Content::Input(parameter) if parameter.is_of_strike())
    }

    /// Checks that the unit is present and has the right dimension.
    pub fn check_unit(&self) -> Result<()> {
        match (&self.unit, self.quantity()) {
            _ if self.is_unknown()
                || self.is_overridden_air
                || matches!(self.content, Content::Written | Content::Repeated) =>
            {
                Ok(())
            }
            _ if self.has_units_in_cells || self.is_weather => Ok(()),
            (None, Some(quantity)) if !quantity.si.is_empty() => {
                let unit = self.usual_unit();
                Err(self.unreadable(format!(
                    "it has no unit; write it into the head, as in '{} [{unit}]'",
                    self.head
                )))
            }
            (None, _) => Ok(()),
            (Some(unit), Some(_)) if unit.contains("-/") || unit.contains("+/") => Err(self
                .unreadable(format!(
                    "[{unit}] states signs that are not known; write them as in [deg L-/R+], [deg \
                     out-in-/in-out+], [deg closed-/open+] or [deg down-/up+], or leave them out"
                ))),
            (Some(unit), Some(quantity)) => {
                let of_the_head = |e: UnitError| match e {
                    // the text of this error would quote the 1 that is read below, which is not in
                    // the column head
                    UnitError::WrongKind {
                        wanted, examples, ..
                    } => self.unreadable(format!(
                        "[{unit}] is not the unit of {wanted}; {wanted} takes {examples}"
                    )),
                    other => self.unreadable(other),
                };
                quantity
                    .read(&format!("1 {unit}"))
                    .map(drop)
                    .map_err(of_the_head)
            }
            (Some(unit), None) => {
                Err(self.unreadable(format!("it takes no unit; take [{unit}] out of the head")))
            }
        }
    }

    /// True if the quantity has units and the table states none.
    pub fn lacks_unit(&self) -> bool {
        self.unit.is_none()
            && self
                .quantity()
                .is_some_and(|quantity| !quantity.si.is_empty())
    }

    /// Assumes this unit if the column has none.
    #[must_use]
    pub fn in_unit(self, unit: &str) -> Self {
        if self.lacks_unit() {
            Self {
                unit: Some(unit.into()),
                is_unit_assumed: true,
                ..self
            }
            .with_parsed_unit()
        } else {
            self
        }
    }

    fn with_parsed_unit(self) -> Self {
        let size = self
            .unit
            .as_ref()
            .and_then(|unit| self.quantity()?.unit_named(unit));
        Self { size, ..self }
    }

    /// True if a cell states its unit.
    pub fn has_unit_in(&self, cell: &str) -> bool {
        self.format.is_export
            && cell_number(cell, self.format.has_decimal_comma())
                .is_some_and(|cell| cell.unit.is_some())
    }

    fn unreadable(&self, why: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Error {
        Error::Unreadable {
            name: format!("the column '{}'", self.head),
            source: why.into(),
        }
    }

    /// Physical quantity of the numbers.
    pub fn quantity(&self) -> Option<Quantity> {
        match self.content {
            Content::Input(parameter) => Some(parameter.quantity),
            Content::Outcome(outcome) | Content::Sigma(outcome) => Some(outcome.quantity()),
            Content::SigmaStationary => Some(Quantity::ANGLE),
            Content::Stationary | Content::Note | Content::Written | Content::Repeated => None,
        }
    }

    /// Default display unit.
    fn usual_unit(&self) -> &'static str {
        match self.content {
            Content::Input(parameter) => parameter.unit,
            Content::Outcome(outcome) | Content::Sigma(outcome) => outcome.unit(),
            _ => "deg",
        }
    }

    /// True if a cell of this column may state this side, such as `R`, in place of a sign.
    fn accepts_side(&self, side: CellSide) -> bool {
        let of_parameter = |names: &[&str]| match self.content {
            Content::Input(parameter) => names.contains(&parameter.name),
            _ => false,
        };
        let of_outcome = |is: fn(Outcome) -> bool| match self.content {
            Content::Outcome(outcome) => is(outcome),
            _ => false,
        };
        match side {
            CellSide::OfTarget { .. } => {
                of_parameter(&[PATH, FACE]) || of_outcome(Outcome::is_to_the_right)
            }
            CellSide::UpDown { .. } => {
                of_parameter(&["swing.attack_angle"]) || of_outcome(|of| of == Outcome::LaunchAngle)
            }
            CellSide::InOut { .. } => of_parameter(&[PATH]),
            CellSide::OpenClosed { .. } => of_parameter(&[FACE]),
        }
    }

    /// Size of the column's unit, SI.
    pub fn unit_size(&self) -> f64 {
        self.size.map_or(1.0, |unit| unit.difference(1.0))
    }

    /// The unit in the column head; the SI unit if the head states no unit.
    pub fn unit(&self) -> &str {
        self.unit
            .as_deref()
            .or_else(|| self.quantity().map(|quantity| quantity.si))
            .unwrap_or_default()
    }

    /// Parses a cell to SI with the golfer's sign convention. `None` for a missing value: an empty
    /// cell, NaN, and in exports also `N/A` and numbers from 1e38 on.
    ///
    /// # Errors
    /// A message, if the cell is not a finite number, or if its mark may separate decimals or
    /// thousands.
    pub fn value(&self, cell: &str) -> std::result::Result<Option<f64>, String> {
        if cell.is_empty() || cell.trim().parse().is_ok_and(f64::is_nan) {
            return Ok(None);
        }
        if let Some(why) = DecimalMark::ambiguity(self.format.decimal_mark, cell) {
            return Err(why);
        }
        let Some(stated) = cell_number(cell, self.format.has_decimal_comma()) else {
            return self.no_number(cell);
        };
        if self.format.is_export && stated.number.abs() >= MISSING {
            return Ok(None);
        }
        if stated.side.is_some_and(|side| !self.accepts_side(side))
            || stated.unit.is_some() && !self.format.is_export
        {
            return Err(self.unreadable_cell(cell, "not a number"));
        }
        let side = stated.side.or(self.positive_side);
        let sign = side.map_or(1.0, CellSide::sign) * self.sign(side);
        let value = self.converted(cell, stated.number, stated.unit.as_deref())?;
        // avoid −0 for straight directions
        Ok(Some(if sign < 0.0 { -value } else { value }))
    }

    /// The factor, 1 or −1, that converts a number to this program's convention. Launch monitors
    /// count path and face angle as positive to the right for every golfer, also in cells with a
    /// side such as `R`. This program counts a path from in to out and an open face as positive.
    /// `side` is that of the cell or of the column's positive values.
    fn sign(&self, side: Option<CellSide>) -> f64 {
        let Content::Input(parameter) = self.content else {
            return 1.0;
        };
        let is_of_the_course = match side {
            Some(CellSide::OfTarget { .. }) => true,
            Some(_) => false,
            None => self.head != parameter.name,
        };
        let is_of_other_hand = self.golfer == Golfer::Left
            && is_of_the_course
            && [PATH, FACE].contains(&parameter.name);
        if is_of_other_hand { -1.0 } else { 1.0 }
    }

    /// Converts a number to SI, from the unit in its cell, otherwise from the unit of the column.
    fn converted(
        &self,
        cell: &str,
        number: f64,
        unit: Option<&str>,
    ) -> std::result::Result<f64, String> {
        let read = |unit: &str, quantity: Quantity| {
            quantity
                .read(&format!("{number} {unit}"))
                .map_err(|error| error.to_string())
        };
        match (unit, &self.size, &self.unit, self.quantity()) {
            (Some(unit), _, of_head, Some(quantity)) => {
                let value = read(unit, quantity)?;
                let is_other = |of_head: &&String| {
                    !self.is_unit_assumed && quantity.size_of(of_head) != quantity.size_of(unit)
                };
                match of_head.as_ref().filter(is_other) {
                    Some(of_head) => Err(format!(
                        "'{cell}' states another unit than its head, [{of_head}]; correct one of \
                         them"
                    )),
                    None => Ok(value),
                }
            }
            (None, ..) if self.has_units_in_cells => Err(format!(
                "'{cell}' has no unit, but other cells of its column have one; write it behind the \
                 number, or into the head"
            )),
            (None, Some(size), ..) => Ok(size.value(number)),
            (None, None, Some(unit), Some(quantity)) => read(unit, quantity),
            _ => Ok(number),
        }
    }

    /// Parses special values: infinity, and words for a missing value.
    fn no_number(&self, cell: &str) -> std::result::Result<Option<f64>, String> {
        let infinite = cell
            .parse()
            .ok()
            .filter(|number: &f64| number.is_infinite());
        match (self.content, infinite) {
            // a flat face has an infinite radius
            (Content::Input(parameter), Some(number)) if parameter.range.contains(number) => {
                Ok(infinite)
            }
            _ if self.format.is_export && is_missing(unwrapped(cell)) => Ok(None),
            (_, Some(_)) => Err(self.unreadable_cell(cell, "not finite")),
            (_, None) => Err(self.unreadable_cell(cell, "not a number")),
        }
    }

    fn unreadable_cell(&self, cell: &str, what: &str) -> String {
        if let Some((whole, decimals)) = cell
            .split_once(',')
            .filter(|_| !self.format.has_decimal_comma())
            && format!("{whole}.{decimals}").parse::<f64>().is_ok()
        {
            return format!(
                "'{cell}' is {what}: a comma marks decimals only in tables whose cells are \
                 separated by semicolons or tabs; write {whole}.{decimals}, or separate the cells \
                 by one of these"
            );
        }
        format!(
            "'{}' is {what}; a unit is written in the head, as in '{} [{}]', and a missing value \
             is an empty cell",
            visible(cell),
            self.head,
            self.unit()
        )
    }
}

/// Club path. Its sign depends on the golfer's handedness.
const PATH: &str = "swing.path";
/// Face angle. Its sign depends on the golfer's handedness.
const FACE: &str = "swing.face_angle";

/// Smallest number that stands for a missing value. Launch monitors write, for example, the largest
/// 32-bit float, 3.4e38.
const MISSING: f64 = 1e38;

/// A cell with escaped control characters, for terminals.
fn visible(cell: &str) -> String {
    let shown = |c: char| {
        if c.is_control() {
            c.escape_default().to_string()
        } else {
            c.to_string()
        }
    };
    cell.chars().map(shown).collect()
}

/// Recognizes missing values of exports: dashes, `N/A`.
fn is_missing(cell: &str) -> bool {
    ["", "-", "--", "–", "—", "n/a", "na", "null"]
        .iter()
        .any(|word| cell.eq_ignore_ascii_case(word))
}

/// The outcome that a launch monitor measures under this name: `carry` is the distance to the
/// landing point.
fn measured(outcome: Outcome) -> Outcome {
    if outcome == Outcome::Carry {
        Outcome::CarryDistance
    } else {
        outcome
    }
}

/// True if an unknown name is a column head of a launch monitor; false if it is a misspelt name of
/// this program.
fn is_head_of_launch_monitor(name: &str, format: TableFormat) -> bool {
    let is_written_otherwise = name.is_empty() || name.contains(". ");
    let has_own_marks = name.contains(['_', '.']) && !name.ends_with('.');
    // `cary` is a misspelt name of this program; `club` and `date` belong to launch monitors
    let is_a_slip = || {
        Outcome::OF_DRIVES
            .iter()
            .any(|of| strsim::levenshtein(name, of.name()) <= 2)
    };
    let is_its_own = !has_own_marks && (name.chars().any(char::is_uppercase) || !is_a_slip());
    format.is_export && (is_written_otherwise || is_its_own)
}

/// Content of a column that has a name of this program, not the head of a launch monitor.
fn named(setup: &Setup<f64>, name: &str) -> Result<Content> {
    let condition = |name: &str| {
        setup
            .launch_condition(name)
            .and_then(|_| Outcome::named(name).ok())
    };
    match name.strip_prefix("sigma ").map(str::trim) {
        Some(STATIONARY) => return Ok(Content::SigmaStationary),
        Some(outcome) => return Ok(Content::Sigma(measured(Outcome::named(outcome)?))),
        None => {}
    }
    let is_derivative = || {
        name.strip_prefix("d_")
            .is_some_and(|rest| rest.contains("/d_"))
    };
    Ok(match name {
        STATIONARY => Content::Stationary,
        NOTE => Content::Note,
        STATUS => Content::Written,
        _ if is_derivative() => Content::Written,
        _ => match name.strip_prefix(LAUNCH).and_then(condition) {
            Some(outcome) => Content::Outcome(outcome),
            None => Outcome::named(name)
                .map(|outcome| Content::Outcome(measured(outcome)))
                .or_else(|_| known(setup, name).map(Content::Input))?,
        },
    })
}

/// The parameter with the column name `name`, or an error whose suggestions include outcomes.
fn known(setup: &Setup<f64>, name: &str) -> Result<&'static Parameter> {
    setup.column(name).map_err(|error| match error {
        Error::Unknown { .. } => {
            let names: Vec<_> = setup.parameters().iter().map(|row| row.name).collect();
            let outcomes = Outcome::OF_DRIVES.iter().map(|outcome| outcome.name());
            Error::unknown(
                "column",
                name,
                names.into_iter().chain(outcomes),
                SHOTS_ADVICE,
            )
        }
        error => error,
    })
}
