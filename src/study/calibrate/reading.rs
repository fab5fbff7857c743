//! The rows of a table of measured shots.

use super::instrument::instrument;
use super::shot::{Measurement, Shot, Stationary};
use super::statistics::Uncertainties;
use crate::columns::{
    CONDITIONS, Club, Column, Fault, Holds, Stated, conditions, contradiction, implausible, implausible_launch,
    impossible, is_sideways, is_straight_by_assumption, outside,
};
use crate::drive::{Outcome, Part};
use crate::error::Error;
use crate::parameters::Setup;
use crate::units::{Digits, Message, Quantity};
use csv::StringRecord;

/// No outcome of a drive is larger than this, in whatever SI unit.
const MOST: f64 = 1e9;

/// A table being read.
pub(super) struct Reading<'a> {
    pub setup: &'a Setup<f64>,
    pub columns: Vec<Column>,
    pub is_launched: bool,
    /// Whether it is a launch monitor's export, of which `fly` tells what is no drive.
    pub is_export: bool,
    /// Whether the launches of clubs are looked at, of which the flight is not used.
    pub club: Club,
}

/// A row that is read.
pub(super) struct Row {
    pub shot: Shot,
    /// The column of what is not compared, since the direction or the tilt of the spin is assumed.
    pub not_compared: Option<String>,
    /// What is used of spins that contradict each other.
    pub contradiction: Option<String>,
    /// Why measured values are not compared, which no drive has.
    pub implausible: Vec<String>,
    /// Why the air of the row is the setup's, where the table has a column of it.
    pub no_air: Option<String>,
}

/// What is wrong with a row.
pub(super) struct Wrong {
    /// The column, where it is one.
    pub column: Option<String>,
    pub why: String,
    /// Whether the row lacks what every shot needs, and is sound otherwise.
    pub is_incomplete: bool,
}

impl Wrong {
    fn incomplete(column: Option<String>, why: impl Into<String>) -> Self {
        Self { column, why: why.into(), is_incomplete: true }
    }
}

/// Something wrong in a column.
impl<T: Into<String>> From<(Option<String>, T)> for Wrong {
    fn from((column, why): (Option<String>, T)) -> Self {
        Self { column, why: why.into(), is_incomplete: false }
    }
}

impl Reading<'_> {
    fn cell(&self, record: &StringRecord, holds: Holds) -> Result<Option<f64>, Wrong> {
        let Some(at) = self.columns.iter().position(|column| column.holds == holds) else { return Ok(None) };
        let column = &self.columns[at];
        column.value(record.get(at).unwrap_or_default()).map_err(|why| (Some(column.head.clone()), why).into())
    }

    fn sigma(&self, record: &StringRecord, holds: Holds, one: f64) -> Result<f64, Wrong> {
        let sigma = self.cell(record, holds)?;
        let has_column = self.columns.iter().any(|column| column.holds == holds);
        match sigma {
            Some(sigma) if sigma > 0.0 => Ok(sigma),
            None if !has_column => Ok(one),
            _ => {
                let head = self.columns.iter().find(|column| column.holds == holds).map(|column| column.head.clone());
                Err((head, "a standard uncertainty must be a number above 0 wherever there is a measurement").into())
            }
        }
    }

    /// Whether an outcome is used as measured: not what gives the launch, and of the launch of a club nothing else.
    fn is_used(&self, outcome: Outcome) -> bool {
        match self.club {
            Club::LeftOut => !(self.is_launched && CONDITIONS.contains(&outcome)),
            Club::Kept => outcome.part() == Part::Launch,
        }
    }

    /// The shot of a row.
    pub fn shot(&self, row: usize, record: &StringRecord) -> Result<Row, Wrong> {
        let (mut inputs, mut measured, mut not_compared, mut contradicts) = (vec![], vec![], None, None);
        let (mut beyond, mut no_air) = (vec![], None);
        let stated = self.stated(record)?;
        if let Some(wrong) = self.refused(&stated) {
            return Err(wrong);
        }
        let stated = self.is_launched.then_some(stated);
        let is_straight = stated.as_ref().is_some_and(is_straight_by_assumption);
        let mut at_shot = *self.setup;
        for (at, column) in self.columns.iter().enumerate() {
            let here = || Some(column.head.clone());
            match column.holds {
                Holds::Input(parameter) if column.is_stated_air() => {
                    match column.stated_air(record.get(at).unwrap_or_default()) {
                        Ok(density) => inputs.push((parameter, density)),
                        Err(why) => no_air = Some(why),
                    }
                }
                Holds::Input(parameter) => {
                    let Some(value) = self.cell(record, column.holds)? else {
                        let why = "the cell is empty; every row needs the shot's own inputs";
                        return Err(Wrong::incomplete(here(), why));
                    };
                    at_shot
                        .set_value(parameter, Some(value))
                        .map_err(|error| Wrong::from((here(), error.to_string())))?;
                    inputs.push((parameter, value));
                }
                Holds::Outcome(outcome) if self.is_used(outcome) => {
                    let value = match self.cell(record, column.holds) {
                        // as `fly` does: the rest of the row is a drive all the same
                        Err(wrong) if self.is_export => {
                            beyond.push(format!("{}: {}", column.head, wrong.why));
                            continue;
                        }
                        value => value?,
                    };
                    if let Some(value) = value {
                        if self.is_launched && outcome.part() == Part::Launch {
                            return Err((here(), "rows of launch conditions have no club").into());
                        }
                        let name = || column.head.clone();
                        if let Some(why) = implausible(outcome, value, name).filter(|_| self.is_export) {
                            beyond.push(why);
                            continue;
                        }
                        if let Some(why) = impossible(outcome, value).or_else(|| self.outside(outcome, value)) {
                            return Err((here(), why).into());
                        }
                        if value.abs() > MOST {
                            let (shown, most) = (outcome.show(value), outcome.show(MOST));
                            let why = format!("{shown} is outside its range −{most} .. {most}; correct the cell");
                            return Err((here(), why).into());
                        }
                        if is_straight && is_sideways(outcome) {
                            not_compared = here();
                            continue;
                        }
                        let assumed = instrument(outcome).map_or(column.one(), |(_, sigma)| sigma);
                        let sigma = self.sigma(record, Holds::Sigma(outcome), assumed)?;
                        measured.push(Measurement { outcome, value, sigma });
                    }
                }
                _ => {}
            }
        }
        let wrong = |error: Error| Wrong::from((None, error.to_string()));
        if let Some(stated) = stated {
            let launch = self.launch(stated)?;
            contradicts = contradiction(stated, [launch[3].1, launch[4].1], |of| self.head(of));
            for (name, value) in launch {
                let parameter = self.setup.parameter(name).map_err(wrong)?;
                at_shot.set_value(parameter, Some(value)).map_err(wrong)?;
                inputs.push((parameter, value));
            }
        }
        at_shot.validate().map_err(wrong)?;
        let stationary = self.stationary(record, &at_shot)?;
        if measured.is_empty() && stationary.is_empty() {
            if !beyond.is_empty() {
                return Err((None, beyond.join("; ")).into());
            }
            let why = match &not_compared {
                None => "nothing is measured in it; give an outcome, or take the row out".into(),
                Some(head) => format!(
                    "nothing but {head} is measured in it, which is not compared without launch direction and spin axis (or sidespin); \
                     give them, or take the row out"
                ),
            };
            return Err(Wrong::incomplete(None, why));
        }
        let shot = Shot { row, inputs, measured, stationary };
        Ok(Row { shot, not_compared, contradiction: contradicts, implausible: beyond, no_air })
    }

    fn has(&self, outcome: Outcome) -> bool {
        self.columns.iter().any(|column| column.holds == Holds::Outcome(outcome))
    }

    /// Whether it has the columns of a whole launch.
    fn has_whole_launch(&self) -> bool {
        let has_spin = self.has(Outcome::Spin) || self.has(Outcome::Backspin);
        self.has(Outcome::BallSpeed) && self.has(Outcome::LaunchAngle) && has_spin
    }

    /// The heads of a whole launch and of the columns of the club beside it, where both are there.
    pub fn launch_beside_club(&self) -> Option<[String; 2]> {
        let heads = |is: &dyn Fn(&Column) -> bool| {
            let heads = self.columns.iter().filter(|column| is(column)).map(|column| column.head.as_str());
            heads.collect::<Vec<_>>().join(", ")
        };
        let launch = heads(&|column| matches!(column.holds, Holds::Outcome(of) if CONDITIONS.contains(&of)));
        let club = heads(&Column::is_of_the_strike);
        (self.has_whole_launch() && !club.is_empty()).then_some([launch, club])
    }

    /// The head of an outcome's column, for messages.
    fn head(&self, of: Outcome) -> String {
        let column = self.columns.iter().find(|column| column.holds == Holds::Outcome(of));
        column.map_or(of.name(), |column| column.head.as_str()).to_owned()
    }

    /// The launch conditions that a row states.
    fn stated(&self, record: &StringRecord) -> Result<Stated, Wrong> {
        let mut values = [None; CONDITIONS.len()];
        for (value, outcome) in values.iter_mut().zip(CONDITIONS) {
            *value = self.cell(record, Holds::Outcome(outcome))?;
        }
        Ok(values)
    }

    /// Why the launch that a row states is none of a drive, as `fly` refuses it.
    fn refused(&self, stated: &Stated) -> Option<Wrong> {
        let mut looked_at = *stated;
        for (value, of) in looked_at.iter_mut().zip(CONDITIONS) {
            *value = value.filter(|value| !self.may_be_none(of, *value));
        }
        if let Some(why) = implausible_launch(&looked_at, |of| self.head(of)) {
            return Some((None, why).into());
        }
        if !self.is_export {
            return None;
        }
        // a delivery is looked for behind a whole launch, where the table has one
        let is_whole = self.club == Club::Kept && self.has_whole_launch();
        self.launch(*stated).err().filter(|wrong| !wrong.is_incomplete || is_whole)
    }

    /// Why a measured value is none of a drive, in words.
    fn outside(&self, of: Outcome, value: f64) -> Option<String> {
        if self.may_be_none(of, value) { None } else { outside(of, value) }
    }

    /// Whether a value says that a ball does not spin: a launch monitor's 0 says that no spin was measured.
    fn may_be_none(&self, of: Outcome, value: f64) -> bool {
        of == Outcome::Spin && value == 0.0 && !self.is_export
    }

    /// The launch that they make, by the parameters that it is.
    fn launch(&self, stated: Stated) -> Result<[(&'static str, f64); 5], Wrong> {
        conditions(stated, |of| self.has(of)).map_err(|Fault { of, why, is_missing }| Wrong {
            column: Some(self.head(of)),
            why: why.into(),
            is_incomplete: is_missing,
        })
    }

    fn stationary(&self, record: &StringRecord, at_shot: &Setup<f64>) -> Result<Vec<Stationary>, Wrong> {
        let Some(at) = self.columns.iter().position(|column| column.holds == Holds::Stationary) else {
            return Ok(vec![]);
        };
        let here = || Some("stationary".to_owned());
        let mut all = vec![];
        for name in record.get(at).unwrap_or_default().split_whitespace() {
            if self.is_launched {
                return Err((here(), "rows of launch conditions have no parameter to be best in").into());
            }
            let parameter = at_shot.variable(name).map_err(|error| Wrong::from((here(), error.to_string())))?;
            let one = Quantity::ANGLE.size_of("deg").unwrap_or(1.0);
            if parameter.quantity != Quantity::ANGLE {
                return Err((here(), format!("{name} is no angle; optima are read in angles")).into());
            }
            all.push(Stationary { parameter, sigma: self.sigma(record, Holds::SigmaStationary, one)? });
        }
        Ok(all)
    }

    /// What is taken where no standard uncertainty stands beside a measured column, and what they are worth in all.
    pub fn assumed(&self, shots: &[Shot]) -> (Vec<Message>, Uncertainties) {
        let has = |holds: Holds| self.columns.iter().any(|column| column.holds == holds);
        let measured = || shots.iter().flat_map(|shot| &shot.measured);
        let is_measured = |outcome| measured().any(|measured| measured.outcome == outcome);
        let mut worth = Uncertainties::Stated;
        let mut remarks = vec![];
        for column in &self.columns {
            match column.holds {
                Holds::Outcome(outcome) if !self.is_used(outcome) => {}
                // in no row compared
                Holds::Outcome(outcome) if !is_measured(outcome) => {}
                Holds::Outcome(outcome) if !has(Holds::Sigma(outcome)) => match instrument(outcome) {
                    Some((instrument, sigma)) => {
                        let without = format!("{} has no column 'sigma {}': ", column.head, outcome.name());
                        let remark = Message::from(without)
                            .quantity(outcome.quantity(), outcome.unit(), sigma, Digits::Significant(3))
                            .words(" is taken for each (")
                            .message(instrument.source())
                            .words(")");
                        remarks.push(remark);
                        if worth == Uncertainties::Stated {
                            worth = Uncertainties::Instruments;
                        }
                    }
                    None => {
                        remarks.push(
                            format!(
                                "{0} has no column 'sigma {0}': 1 {1} is taken for each, as a weight",
                                outcome.name(),
                                column.unit()
                            )
                            .into(),
                        );
                        worth = Uncertainties::Weights;
                    }
                },
                Holds::Stationary if !has(Holds::SigmaStationary) => {
                    remarks.push(
                        "stationary has no column 'sigma stationary': 1 deg is taken for each, as a weight".into(),
                    );
                    worth = Uncertainties::Weights;
                }
                _ => {}
            }
        }
        (remarks, worth)
    }
}
