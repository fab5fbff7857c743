//! Reads the rows of a table of measured shots.

use super::shot_table::{MeasuredShot, Measurement, Stationary};
use super::statistics::SigmaOrigin;
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result as Read};
use crate::parameters::{Parameter, Setup};
use crate::shots::{Club as ClubOfShot, Shot};
use crate::table::{
    CONDITIONS, Column, Content, LAUNCH_PARAMETERS, Refusal, StatedConditions as Launch,
    TableFormat, TableHead, TableUse, TextTable, club_column, columns_remark, conditions,
    contradiction, has_whole_launch, heads_of, ignore_columns, implausible_club,
    implausible_launch, impossible, is_straight_by_assumption, missing_launch_remark, near_known,
    not_compared, outside, redundant_spins_remark, without_redundant_spins,
};
use crate::units::{Digits, Message, Quantity};

/// Largest accepted magnitude of a measured value, in the SI unit of its outcome.
const MOST: f64 = 1e9;

/// The columns of one section of a table, with the setup and the options for reading them.
#[derive(Clone)]
pub(super) struct Reading {
    pub setup: Setup<f64>,
    pub head: TableHead,
    pub is_launched: bool,
    /// Measurements, or deliveries: the launch is then the measurement, and no ball flies.
    pub table_use: TableUse,
    /// Index of the column that names the club of each shot.
    pub club_name: Option<usize>,
}

/// A row that was read successfully.
#[derive(Default)]
pub(super) struct ReadRow {
    pub shot: MeasuredShot,
    /// Column heads of measured values that are not compared because launch direction or spin axis
    /// is assumed.
    pub not_compared: Vec<String>,
    /// Message on contradictory spins.
    pub contradiction: Option<String>,
    /// Messages on implausible measured values.
    pub implausible: Vec<String>,
    /// Reason why the row has no usable air, so that its shot flies in the setup's air.
    pub no_air: Option<String>,
    /// Messages on club columns without a usable value. The prior distribution of the parameter
    /// replaces the missing value.
    pub not_stated: Vec<String>,
}

impl ReadRow {
    /// Returns the row if it has a measurement or a stationary parameter.
    fn checked(self) -> Result<Self, RowError> {
        if !(self.shot.measured.is_empty() && self.shot.stationary.is_empty()) {
            return Ok(self);
        }
        if !self.implausible.is_empty() {
            return Err(RowError::new(None, self.implausible.join("; ")));
        }
        let heads = self.not_compared.join(", ");
        let only = match self.not_compared.len() {
            0 => {
                let why = "the row has no measured value; give an outcome, or remove the row";
                return Err(RowError::incomplete(None, why));
            }
            1 => format!("the only measured value is {heads}, which is"),
            _ => format!("the only measured values are {heads}, which are"),
        };
        let why = format!(
            "{only} compared only if launch direction and spin axis (or sidespin) are given; add \
             them, or remove the row"
        );
        Err(RowError::incomplete(None, why))
    }
}

/// The value of a cell, SI: `None` for an empty cell, or the reason why the cell cannot be read.
type CellValue = Result<Option<f64>, String>;

/// Error in a row.
pub(super) struct RowError {
    /// Column head of the faulty cell; `None` for an error of the whole row.
    pub column: Option<String>,
    pub why: String,
    /// True if a value that every row needs is missing, false if a value is invalid.
    pub is_incomplete: bool,
}

impl RowError {
    fn new(column: Option<String>, why: impl Into<String>) -> Self {
        Self {
            column,
            why: why.into(),
            is_incomplete: false,
        }
    }

    fn incomplete(column: Option<String>, why: impl Into<String>) -> Self {
        Self {
            is_incomplete: true,
            ..Self::new(column, why)
        }
    }
}

impl Reading {
    /// Reads the columns of a section from their column heads.
    ///
    /// # Errors
    /// [`Error::Table`] for a wrong unit, a sigma without its measurement, and an export whose rows
    /// are neither launches nor deliveries.
    pub fn of_head(table: &TextTable, mut head: TableHead) -> Read<Self> {
        let TextTable {
            setup, table_use, ..
        } = *table;
        let refused = |place: String, reason: String| Error::table(&table.name, place, reason);
        let is_export = head.format.is_export;
        let mut remarks = head.column_remarks();
        if !is_export && table_use == TableUse::Deliveries {
            remarks.extend(redundant_spins_remark(&head.columns));
        }
        remarks.extend(head.ignore_repeated());
        check_columns(&head)
            .map_err(|(at, reason)| refused(format!(", column {}", at + 1), reason))?;
        if table_use == TableUse::Deliveries {
            let remark = missing_launch_remark(&head.columns);
            let remark = remark.map_err(|reason| refused(String::new(), reason))?;
            remarks.extend(remark.map(Message::from));
        }
        let written = heads_of(&head.columns, |column| column.content == Content::Written);
        remarks.extend(columns_remark(
            "columns that an earlier 'sweep' or 'fly' wrote are not read",
            &written,
        ));
        // with a column of swing, club, strike or impact, the rows are deliveries: the launch is
        // then a measurement, not the start of the flight
        let is_launched = has_whole_launch(&head.columns)
            && !head.has_strike()
            && table_use == TableUse::Measurements;
        setup
            .refuse_replaced(&inputs(&head.columns))
            .map_err(|error| refused(String::new(), error.to_string()))?;
        let unused = heads_of(
            &head.columns,
            |column| matches!(column.content, Content::Sigma(of) if is_launched && CONDITIONS.contains(&of)),
        );
        remarks.extend(columns_remark(
            "uncertainties of launches are not used, since each ball flies from its measured launch",
            &unused,
        ));
        head.remarks = remarks;
        let is_text = |at: usize| head.columns[at].content == Content::Note;
        let club_name = club_column(&head.heads, is_text);
        let reading = Self {
            setup,
            is_launched,
            table_use,
            club_name,
            head,
        };
        match reading.why_not_flown() {
            Some(reason) => Err(refused(String::new(), reason)),
            None => Ok(reading),
        }
    }

    /// True if the deliveries of the launches are to be estimated.
    pub fn is_delivery(&self) -> bool {
        self.table_use == TableUse::Deliveries
    }

    /// Reason why no row of an export can fly: the export has neither launches nor deliveries.
    /// `None` if rows can fly, if the table needs no flight, or if it is not an export.
    fn why_not_flown(&self) -> Option<String> {
        let is_flown = self.is_launched || self.head.columns.iter().any(Column::is_of_the_strike);
        if !self.head.format.is_export || self.is_delivery() || is_flown {
            return None;
        }
        let near = near_known(&self.head.columns);
        Some(format!(
            "it has neither a whole launch (ball speed, launch angle and spin) nor a column of \
             the club, such as club speed{near}; add \
             the missing columns"
        ))
    }

    /// Columns for shots from messages of Open Connect, or from lines that `fly` wrote. Each value
    /// that at least one shot has gets a column.
    pub fn of_shots(
        setup: &Setup<f64>,
        shots: &[Shot],
        other_parameters: &[&'static Parameter],
        table_use: TableUse,
    ) -> Self {
        let is_stated = |of: &&Outcome| {
            shots
                .iter()
                .any(|shot| shot.refusal().is_none() && shot.value(**of).is_some())
        };
        let outcomes = Outcome::OF_DRIVES.iter().filter(is_stated);
        let outcomes = outcomes.map(|of| Column::of(Content::Outcome(*of), of.name()));
        let is_given = |(at, _): &(usize, &str)| {
            let mut clubs = shots.iter().map(|shot| shot.club.values());
            clubs.any(|values| values[*at].is_some())
        };
        let of_club = ClubOfShot::NAMES.into_iter().enumerate().filter(is_given);
        let of_club = of_club.filter_map(|(_, name)| setup.parameter(name).ok());
        let inputs = of_club.chain(other_parameters.iter().copied());
        let inputs = inputs.map(|parameter| Column::of(Content::Input(parameter), parameter.name));
        let mut columns: Vec<Column> = outcomes.chain(inputs).collect();
        let remarks = ignore_columns(&mut columns, table_use);
        Self {
            setup: *setup,
            is_launched: table_use == TableUse::Measurements,
            table_use,
            club_name: None,
            head: TableHead {
                columns,
                remarks,
                format: TableFormat {
                    is_export: true,
                    ..TableFormat::default()
                },
                ..TableHead::default()
            },
        }
    }

    /// Reads the shot of a row of text.
    pub fn shot_of_cells(&self, row: usize, cells: &[&str]) -> Result<ReadRow, RowError> {
        let value = |(column, cell): (&Column, &&str)| match column.quantity() {
            None => Ok(None),
            Some(_) if column.is_stated_air() => column.stated_air(cell).map(Some),
            Some(_) => column.value(cell),
        };
        let values: Vec<CellValue> = self.head.columns.iter().zip(cells).map(value).collect();
        let stationary = self.head.column(Content::Stationary);
        let stationary = stationary.map_or("", |(at, _)| cells[at]);
        self.shot(row, &values, stationary)
    }

    /// Reads the shot of a message, or of a line that `fly` wrote.
    pub fn shot_of_message(
        &self,
        row: usize,
        shot: &Shot,
        other_parameters: &[&'static Parameter],
    ) -> Result<ReadRow, RowError> {
        let of = |column: &Column| match column.content {
            Content::Outcome(outcome) => shot.value(outcome).map(|value| value.value),
            Content::Input(parameter) => {
                let at = || other_parameters.iter().position(|own| *own == parameter);
                ClubOfShot::index_of(parameter).map_or_else(
                    || shot.other_parameters().get(at()?).copied(),
                    |at| shot.club.other_convention(self.setup.golfer).values()[at],
                )
            }
            _ => None,
        };
        let values: Vec<CellValue> = self
            .head
            .columns
            .iter()
            .map(|column| Ok(of(column)))
            .collect();
        self.shot(row, &values, "")
    }

    fn cell(&self, values: &[CellValue], content: Content) -> Result<Option<f64>, RowError> {
        let Some((at, column)) = self.head.column(content) else {
            return Ok(None);
        };
        values[at]
            .clone()
            .map_err(|why| RowError::new(Some(column.head.clone()), why))
    }

    fn sigma(&self, values: &[CellValue], content: Content, one: f64) -> Result<f64, RowError> {
        let Some((_, column)) = self.head.column(content) else {
            return Ok(one);
        };
        let sigma = self.cell(values, content)?;
        sigma.filter(|sigma| *sigma > 0.0).ok_or_else(|| {
            RowError::new(
                Some(column.head.clone()),
                "a standard uncertainty must be a number above 0 wherever there is a measurement",
            )
        })
    }

    /// True for outcomes that count as measured values of some rows:
    ///
    /// - the outcomes of the launch, if the deliveries of the launches are to be estimated. Each
    ///   row then measures only one of two statements of the spin
    /// - otherwise all outcomes, except the launch conditions from which the balls fly
    fn is_measurement(&self, outcome: Outcome) -> bool {
        match self.is_delivery() {
            true => outcome.group() == OutcomeGroup::Launch,
            false => !(self.is_launched && CONDITIONS.contains(&outcome)),
        }
    }

    /// Reads the shot of a row. `values` are in the order of the columns; `stationary` has the names
    /// of stationary parameters.
    fn shot(
        &self,
        row: usize,
        values: &[CellValue],
        stationary: &str,
    ) -> Result<ReadRow, RowError> {
        let stated = self.stated(values)?;
        self.check_launch(&stated)?;
        let redundant = self.redundant_spins(&stated);
        let is_measured = |of| self.is_measurement(of) && !redundant.contains(&of);
        let is_straight = self.is_launched && is_straight_by_assumption(&stated);
        let has_no_club = self.is_delivery() && self.has_no_club(values);
        let mut row = ReadRow {
            shot: MeasuredShot {
                row,
                ..MeasuredShot::default()
            },
            contradiction: self.contradiction(stated),
            ..ReadRow::default()
        };
        let mut at_shot = self.setup;
        let mut missing: Option<RowError> = None;
        for (at, column) in self.head.columns.iter().enumerate() {
            match column.content {
                Content::Input(parameter) if column.is_stated_air() => match &values[at] {
                    Ok(density) => row.shot.inputs.extend(density.map(|air| (parameter, air))),
                    Err(why) => row.no_air = Some(why.clone()),
                },
                // a missing club value is no fault: the prior distribution of the parameter
                // replaces it
                Content::Input(parameter) if self.is_delivery() && column.is_of_the_strike() => {
                    match self.club_value(column, parameter, values, has_no_club) {
                        Ok(value) => row.shot.inputs.push((parameter, value)),
                        Err(why) => row.not_stated.push(why),
                    }
                }
                Content::Input(parameter) => {
                    let here = || Some(column.head.clone());
                    let Some(value) = self.cell(values, column.content)? else {
                        let why = "the cell is empty; every row needs a value in each column that is an input";
                        missing.get_or_insert_with(|| RowError::incomplete(here(), why));
                        continue;
                    };
                    at_shot
                        .set_value(parameter, Some(value))
                        .map_err(|error| RowError::new(here(), error.to_string()))?;
                    row.shot.inputs.push((parameter, value));
                }
                Content::Outcome(outcome) if is_measured(outcome) => {
                    self.add_measurement(&mut row, values, column, outcome, is_straight)?;
                }
                _ => {}
            }
        }
        // a row with an empty cell is only left out; an invalid cell is an error of the table
        if let Some(missing) = missing {
            return Err(missing);
        }
        if self.is_launched {
            self.add_launch(&mut row, &mut at_shot, stated)?;
        }
        at_shot
            .validate()
            .map_err(|error| RowError::new(None, error.to_string()))?;
        row.shot.stationary = self.stationary(values, stationary, &at_shot)?;
        row.checked()
    }

    /// Adds the measurement of a column to a row, if the cell has one. An implausible value of an
    /// export is not compared.
    fn add_measurement(
        &self,
        row: &mut ReadRow,
        values: &[CellValue],
        column: &Column,
        outcome: Outcome,
        is_straight: bool,
    ) -> Result<(), RowError> {
        let here = || Some(column.head.clone());
        let value = match self.cell(values, column.content) {
            // keep a row of an export although a measured value is unusable, as `fly` does
            Err(wrong) if self.head.format.is_export => {
                row.implausible
                    .push(format!("{}: {}", column.head, wrong.why));
                return Ok(());
            }
            value => value?,
        };
        let Some(value) = value else {
            return Ok(());
        };
        if self.is_launched && outcome.group() == OutcomeGroup::Launch {
            return Err(RowError::new(
                here(),
                "the rows state the launch, so that no impact is computed; remove this column",
            ));
        }
        let carry = || {
            let carry = self.cell(values, Content::Outcome(Outcome::CarryDistance));
            carry.ok().flatten()
        };
        if let Some(why) =
            not_compared(outcome, value, carry).filter(|_| self.head.format.is_export)
        {
            row.implausible.push(format!("{}: {why}", column.head));
            return Ok(());
        }
        let outside = || outside(outcome, value).filter(|_| !self.is_measured_zero(outcome, value));
        if let Some(why) = impossible(outcome, value).or_else(outside) {
            return Err(RowError::new(here(), why));
        }
        if value.abs() > MOST {
            let (shown, most) = (outcome.show(value), outcome.show(MOST));
            let why = format!("{shown} is outside its range −{most} .. {most}; correct the cell");
            return Err(RowError::new(here(), why));
        }
        if is_straight && outcome.is_lateral() {
            row.not_compared.push(column.head.clone());
            return Ok(());
        }
        let assumed = outcome
            .measurement_uncertainty()
            .unwrap_or(column.unit_size());
        let sigma = self.sigma(values, Content::Sigma(outcome), assumed)?;
        row.shot.measured.push(Measurement {
            outcome,
            value,
            sigma,
        });
        Ok(())
    }

    /// Adds the launch of a row to its inputs and to `at_shot`.
    fn add_launch(
        &self,
        row: &mut ReadRow,
        at_shot: &mut Setup<f64>,
        stated: Launch,
    ) -> Result<(), RowError> {
        let wrong = |error: Error| RowError::new(None, error.to_string());
        let launch = self.launch(stated)?;
        for (name, value) in LAUNCH_PARAMETERS.into_iter().zip(launch) {
            let parameter = self.setup.parameter(name).map_err(wrong)?;
            at_shot.set_value(parameter, Some(value)).map_err(wrong)?;
            row.shot.inputs.push((parameter, value));
        }
        Ok(())
    }

    /// Message if spins of the row that are not used differ from its launch. `None` if the launch is
    /// neither flown nor the only measurement.
    fn contradiction(&self, stated: Launch) -> Option<String> {
        if !self.is_launched && !self.is_delivery() {
            return None;
        }
        let launch = self.launch(stated).ok()?;
        contradiction(stated, [launch[3], launch[4]], |of| self.head.name_of(of))
    }

    /// The spins of a row that are not measured, since the row states the spin in another way too.
    /// Empty if the deliveries of the launches are not to be estimated.
    fn redundant_spins(&self, stated: &Launch) -> Vec<Outcome> {
        if !self.is_delivery() {
            return vec![];
        }
        let used = without_redundant_spins(*stated);
        let values = CONDITIONS.into_iter().zip(stated.iter().zip(used));
        values
            .filter(|(_, (stated, used))| stated.is_some() && used.is_none())
            .map(|(of, _)| of)
            .collect()
    }

    /// True if the club values of the row are all 0, which means that the club was not measured.
    fn has_no_club(&self, values: &[CellValue]) -> bool {
        let stated = ClubOfShot::NAMES.map(|name| {
            let parameter = self.setup.parameter(name).ok()?;
            self.cell(values, Content::Input(parameter)).ok().flatten()
        });
        ClubOfShot::is_unmeasured(stated)
    }

    /// Value of a club column in a row.
    ///
    /// # Errors
    /// The reason why the row has no usable value.
    fn club_value(
        &self,
        column: &Column,
        parameter: &'static Parameter,
        values: &[CellValue],
        has_no_club: bool,
    ) -> Result<f64, String> {
        let head = &column.head;
        let stated = match has_no_club {
            true => None,
            false => self
                .cell(values, column.content)
                .map_err(|wrong| format!("{head}: {}", wrong.why))?,
        };
        let value = stated.ok_or_else(|| format!("{head}: not stated"))?;
        if let Some(why) = implausible_club(parameter.name, value, head) {
            return Err(why);
        }
        let mut changed = self.setup;
        changed
            .set_value(parameter, Some(value))
            .map_err(|error| format!("{head}: {error}"))?;
        Ok(value)
    }

    /// Column heads of the launch and of the club, if the table has club columns and a complete
    /// launch.
    pub fn launch_beside_club(&self) -> Option<[String; 2]> {
        let heads = |is: &dyn Fn(&Column) -> bool| {
            let heads = self
                .head
                .columns
                .iter()
                .filter(|column| is(column))
                .map(|column| column.head.as_str());
            heads.collect::<Vec<_>>().join(", ")
        };
        let launch = heads(
            &|column| matches!(column.content, Content::Outcome(of) if CONDITIONS.contains(&of)),
        );
        let club = heads(&Column::is_of_the_strike);
        (has_whole_launch(&self.head.columns) && !club.is_empty()).then_some([launch, club])
    }

    /// The launch conditions of a row.
    fn stated(&self, values: &[CellValue]) -> Result<Launch, RowError> {
        let mut stated = [None; CONDITIONS.len()];
        for (value, outcome) in stated.iter_mut().zip(CONDITIONS) {
            *value = self.cell(values, Content::Outcome(outcome))?;
        }
        Ok(stated)
    }

    /// Refuses an implausible launch, by the rules of `fly`.
    fn check_launch(&self, stated: &Launch) -> Result<(), RowError> {
        let mut looked_at = *stated;
        for (value, of) in looked_at.iter_mut().zip(CONDITIONS) {
            *value = value.filter(|value| !self.is_measured_zero(of, *value));
        }
        if let Some(why) = implausible_launch(&looked_at, |of| self.head.name_of(of)) {
            return Err(RowError::new(None, why));
        }
        if !self.head.format.is_export {
            return Ok(());
        }
        // an incomplete launch is a fault only if the delivery of the launch is to be estimated,
        // and if the table has all launch columns
        let is_whole = self.is_delivery() && has_whole_launch(&self.head.columns);
        match self.launch(*stated) {
            Err(wrong) if !wrong.is_incomplete || is_whole => Err(wrong),
            _ => Ok(()),
        }
    }

    /// True for a measured spin of 0. In an export, a spin of 0 means that the spin was not
    /// measured.
    fn is_measured_zero(&self, of: Outcome, value: f64) -> bool {
        of == Outcome::Spin && value == 0.0 && !self.head.format.is_export
    }

    /// Computes the launch parameters (name and SI value) from the launch conditions of a row.
    fn launch(&self, stated: Launch) -> Result<[f64; LAUNCH_PARAMETERS.len()], RowError> {
        let has = |of: Outcome| self.head.column(Content::Outcome(of)).is_some();
        conditions(stated, has).map_err(|fault| RowError {
            column: Some(self.head.name_of(fault.of)),
            why: fault.why.into(),
            is_incomplete: fault.kind == Refusal::MISSING,
        })
    }

    fn stationary(
        &self,
        values: &[CellValue],
        names: &str,
        at_shot: &Setup<f64>,
    ) -> Result<Vec<Stationary>, RowError> {
        let here = || Some("stationary".to_owned());
        let mut all = vec![];
        for name in names.split_whitespace() {
            if self.is_launched {
                return Err(RowError::new(
                    here(),
                    "the rows state the launch; empty this cell, or remove the launch columns",
                ));
            }
            let parameter = at_shot
                .variable(name)
                .map_err(|error| RowError::new(here(), error.to_string()))?;
            let one = Quantity::ANGLE.size_of("deg").unwrap_or(1.0);
            if parameter.quantity != Quantity::ANGLE {
                return Err(RowError::new(
                    here(),
                    format!("{name} is not an angle; carry can only be stationary in angles"),
                ));
            }
            all.push(Stationary {
                parameter,
                sigma: self.sigma(values, Content::SigmaStationary, one)?,
            });
        }
        Ok(all)
    }

    /// Remarks on assumed standard uncertainties, and the origin of the standard uncertainties. If
    /// the columns have several origins, the last of these in [`SigmaOrigin`] counts.
    pub fn assumed_sigmas(&self, shots: &[MeasuredShot]) -> (Vec<Message>, SigmaOrigin) {
        let has = |content: Content| self.head.column(content).is_some();
        let measured = || shots.iter().flat_map(|shot| &shot.measured);
        let is_measured = |outcome| measured().any(|measured| measured.outcome == outcome);
        let mut origin = SigmaOrigin::Stated;
        let mut remarks = vec![];
        for column in &self.head.columns {
            match column.content {
                Content::Outcome(outcome) if !self.is_measurement(outcome) => {}
                // no row has this measurement
                Content::Outcome(outcome) if !is_measured(outcome) => {}
                Content::Outcome(outcome) if !has(Content::Sigma(outcome)) => {
                    remarks.push(assumed_sigma(column, outcome));
                    origin = origin.max(match outcome.measurement_uncertainty() {
                        Some(_) => SigmaOrigin::Instruments,
                        None => SigmaOrigin::Weights,
                    });
                }
                Content::Stationary if !has(Content::SigmaStationary) => {
                    remarks.push(
                        "stationary has no column 'sigma stationary': 1 deg is taken for each \
                         row, as a weight"
                            .into(),
                    );
                    origin = SigmaOrigin::Weights;
                }
                _ => {}
            }
        }
        (remarks, origin)
    }
}

/// Remark on an outcome without a column 'sigma'. The known uncertainty of the instrument is used.
/// If it is unknown, one unit of the column serves as a weight.
fn assumed_sigma(column: &Column, outcome: Outcome) -> Message {
    let (Some(instrument), Some(sigma)) = (outcome.instrument(), outcome.measurement_uncertainty())
    else {
        return format!(
            "{0} has no column 'sigma {0}': each row is weighted as if its standard uncertainty \
             were 1 {1}",
            outcome.name(),
            column.unit()
        )
        .into();
    };
    let digits = Digits::Significant(3);
    Message::from(format!(
        "{} has no column 'sigma {}': ",
        column.head,
        outcome.name()
    ))
    .quantity(outcome.quantity(), outcome.unit(), sigma, digits)
    .words(" is taken for each (")
    .message(instrument.source())
    .words(")")
}

/// Names of the parameters that have a column.
fn inputs(columns: &[Column]) -> Vec<&'static str> {
    columns
        .iter()
        .filter_map(|column| match column.content {
            Content::Input(parameter) => Some(parameter.name),
            _ => None,
        })
        .collect()
}

/// Checks units and columns of uncertainties.
///
/// # Errors
/// Index of the first faulty column, and the reason.
fn check_columns(head: &TableHead) -> Result<(), (usize, String)> {
    for (at, column) in head.columns.iter().enumerate() {
        column
            .check_unit()
            .map_err(|error| (at, error.to_string()))?;
        let of = match column.content {
            Content::Sigma(outcome) => Content::Outcome(outcome),
            Content::SigmaStationary => Content::Stationary,
            _ => continue,
        };
        if head.columns.iter().all(|other| other.content != of) {
            let reason = format!(
                "'{}' is the uncertainty of an outcome without a column; add the column of the \
                 outcome, or leave this out",
                column.head
            );
            return Err((at, reason));
        }
    }
    Ok(())
}
