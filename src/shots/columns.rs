//! Meaning of the columns of an export.

use super::interpretation::interpret;
use super::shot::{Club, Origin, RowParameter};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Golfer, Parameter, Setup};
use crate::table::{
    Column, Content, DecimalMark, ShotLabels, TableFormat, TableHead, TableUse, TextTable,
    air_of_rows, assume_unit, club_column, columns_remark, ignore_stated_air, is_condition_head,
    missing_of_launch, near_known, rest_of_head, split_unit, with_nearest, words,
};
use crate::units::Message;
use std::ops::Range;

/// A column with the values of an outcome.
#[derive(Clone, Debug)]
pub(super) struct MeasuredColumn {
    pub at: usize,
    pub of: Outcome,
    pub column: Column,
    /// Origin of the column's values, if the column head states it.
    pub origin: Option<Origin>,
}

/// The column heads of an export, interpreted.
#[derive(Clone, Debug)]
pub struct ShotColumns {
    /// Cell separator.
    pub separator: u8,
    /// The column heads as written.
    pub heads: Vec<String>,
    /// Units in the line below the column heads; `None` if there is no such line.
    pub units: Option<Vec<String>>,
    pub(super) maker: Option<&'static str>,
    pub(super) read: Vec<MeasuredColumn>,
    /// Columns of the club: speed, attack angle, path, face angle.
    pub(super) club: [Option<(usize, Column)>; 4],
    /// Parameters that are not part of the launch.
    pub(super) other_parameters: Vec<RowParameter>,
    /// Column that states whether the spin is measured or estimated.
    pub(super) spin_type: Option<usize>,
    /// Column that states the conditions for which the values hold, such as normalized weather.
    pub(super) condition: Option<usize>,
    /// Column with the name of the club.
    pub(super) club_name: Option<usize>,
    pub(super) is_export: bool,
    /// The columns that say which shot a row is; `None` for a table that is no export.
    pub(super) labels: Option<ShotLabels>,
    /// The decimal mark of the table; `None` if the first rows do not show it.
    pub(crate) decimal_mark: Option<DecimalMark>,
    /// Indices of the columns that an earlier run of `fly` added; empty without such columns.
    pub(crate) added: Range<usize>,
    /// Handedness of the golfer.
    pub(super) golfer: Golfer,
    /// Air density of the setup, kg/m³, for rows that do not state the air.
    pub(super) air: f64,
    pub(super) remarks: Vec<Message>,
}

impl ShotColumns {
    /// Interprets the column heads of a table of shots. If `is_air_given` is true, columns that
    /// state the air are ignored.
    ///
    /// # Errors
    /// [`Error::Table`] if a launch column is missing, or if a unit has the wrong dimension.
    pub(super) fn read(
        setup: &Setup<f64>,
        mut head: TableHead,
        table: &TextTable,
        is_air_given: bool,
    ) -> Result<Self> {
        add_totals(setup, &mut head)?;
        let mut assumed_units = interpret(setup, &mut head, TableUse::Launches);
        if is_air_given {
            ignore_stated_air(&mut head.columns);
        }
        let repeated = head.ignore_repeated();
        // `add_remarks` lists all unused columns, so drop the head's own remarks on them
        head.remarks.clear();
        let is_text = |at: usize| head.columns[at].content == Content::Note;
        let name = &table.name;
        let mut found = Self {
            separator: table.separator,
            maker: head.maker,
            read: vec![],
            club: Default::default(),
            other_parameters: vec![],
            spin_type: None,
            condition: None,
            club_name: club_column(&head.heads, is_text),
            is_export: head.format.is_export,
            labels: head.labels.clone(),
            decimal_mark: head.format.decimal_mark,
            added: head.flown.clone(),
            golfer: setup.golfer,
            air: setup.air.density,
            remarks: vec![],
            units: head.units.clone(),
            heads: head.heads.clone(),
        };
        for (at, column) in head.columns.iter().enumerate() {
            found
                .add(setup, at, column)
                .map_err(|error| name.refused(format!(", column {}", at + 1), error.to_string()))?;
        }
        for (at, column) in found.club.iter_mut().flatten() {
            assumed_units.extend(assume_unit(*at, column, &head.rows));
        }
        if let Some(reason) = found.why_no_launch(&head.columns) {
            return Err(name.refused(String::new(), reason));
        }
        found.find_descriptions();
        let club = found.club.iter().flatten();
        let club: Vec<Column> = club.map(|(_, column)| column.clone()).collect();
        found.remarks = head.column_remarks(&club, &assumed_units);
        found.add_remarks(&head, repeated);
        Ok(found)
    }

    /// Finds the columns `spin_type` and `condition`.
    fn find_descriptions(&mut self) {
        let plain: Vec<String> = self
            .heads
            .iter()
            .map(|head| words(split_unit(head).0))
            .collect();
        let of_spin = [
            "spin rate type",
            "spin type",
            "spin reading",
            "spin source",
            "drehratentyp",
        ];
        self.spin_type = plain
            .iter()
            .position(|head| of_spin.contains(&head.as_str()));
        self.condition = plain.iter().position(|head| is_condition_head(head));
    }

    /// Sorts the parameters of this section that are not part of the launch: first the parameters
    /// `first` of the table's first section, then the parameters that only this section has.
    ///
    /// # Errors
    /// The name of a parameter in `first` that has no column in this section.
    pub(super) fn order_parameters_like(
        &mut self,
        first: &[&'static Parameter],
    ) -> std::result::Result<(), &'static str> {
        let own = self.other_parameters();
        if let Some(missing) = first.iter().find(|parameter| !own.contains(parameter)) {
            return Err(missing.name);
        }
        let place = |own: &RowParameter| first.iter().position(|of| *of == own.parameter);
        self.other_parameters
            .sort_by_key(|own| place(own).unwrap_or(first.len()));
        Ok(())
    }

    /// Adds a column by its meaning: a measured outcome, a parameter of the flight, or a value of
    /// the club. If several columns have the same value of the club, only the first is added.
    fn add(&mut self, setup: &Setup<f64>, at: usize, column: &Column) -> Result<()> {
        match column.content {
            Content::Outcome(of) => {
                column.check_unit()?;
                self.read.push(MeasuredColumn {
                    at,
                    of,
                    column: column.clone(),
                    origin: origin(&self.heads[at]),
                });
            }
            Content::Input(parameter) if !parameter.is_of_strike() && !parameter.is_of_launch() => {
                column.check_unit()?;
                self.other_parameters.push(RowParameter {
                    at,
                    parameter,
                    column: column.clone(),
                });
            }
            // a flight from a launch does not depend on the club: read a parameter of the club as
            // club data
            Content::Note | Content::Input(_) => {
                let below = read_units(self.units.as_deref(), at);
                let format = TableFormat {
                    is_export: self.is_export,
                    decimal_mark: self.decimal_mark,
                };
                let Ok(again) = Column::read(setup, &self.heads[at], below, format) else {
                    return Ok(());
                };
                if let Content::Input(parameter) = again.content
                    && let Some(club) = Club::index_of(parameter)
                    && self.club[club].is_none()
                    && again.clone().in_unit("mph").check_unit().is_ok()
                {
                    self.club[club] = Some((at, again));
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// The column of an outcome.
    pub(super) fn column_of(&self, of: Outcome) -> Option<&Column> {
        let read = self.read.iter().find(|read| read.of == of)?;
        Some(&read.column)
    }

    /// The column with the index `at` whose numbers are read; `None` for other columns.
    pub(super) fn read_column(&self, at: usize) -> Option<&Column> {
        let measured = self.read.iter().map(|read| (read.at, &read.column));
        let parameters = self.other_parameters.iter();
        let parameters = parameters.map(|row| (row.at, &row.column));
        let club = self.club.iter().flatten();
        let club = club.map(|(at, column)| (*at, column));
        let mut columns = measured.chain(parameters).chain(club);
        let (_, column) = columns.find(|(own, _)| *own == at)?;
        Some(column)
    }

    /// Message about missing columns of the launch; `None` if none is missing.
    fn why_no_launch(&self, columns: &[Column]) -> Option<String> {
        let missing = missing_of_launch(columns);
        if missing.is_empty() {
            return None;
        }
        let near = near_known(columns);
        let heads = self
            .heads
            .iter()
            .filter(|head| !head.is_empty())
            .map(String::as_str)
            .collect::<Vec<_>>()
            .join(", ");
        Some(format!(
            "no column has {}{near}; give each a head that is known, as in 'Ball Speed [mph]', \
             'Launch Angle [deg]', 'Spin Rate [rpm]' \
             (the heads are: {heads})",
            missing.join(" or "),
        ))
    }

    /// Adds remarks on the use of the columns. A column that states the air is used if one of its
    /// cells in the first rows can be read.
    fn add_remarks(&mut self, head: &TableHead, repeated: Option<Message>) {
        let has_air = |air: &&RowParameter| {
            let mut cells = head.rows.iter().map(|row| &row[air.at]);
            cells.any(|cell| air.column.stated_air(cell).is_ok())
        };
        let stated_air = self.stated_air().filter(has_air);
        let is_unread_air = |row: &RowParameter| row.column.is_stated_air() && stated_air.is_none();
        let is_parameter = |row: &RowParameter, at: usize| row.at == at && !is_unread_air(row);
        let is_read = |at: usize| {
            self.read.iter().any(|read| read.at == at)
                || self
                    .other_parameters
                    .iter()
                    .any(|row| is_parameter(row, at))
                || self.club.iter().flatten().any(|(club, _)| *club == at)
                || [self.spin_type, self.club_name].contains(&Some(at))
        };
        let is_reported_elsewhere = |column: &Column| {
            let has_remark = [Content::Written, Content::Repeated].contains(&column.content);
            has_remark || column.is_overridden_air
        };
        let not_read = head.columns.iter().enumerate().filter(|(at, column)| {
            !is_read(*at) && !column.head.is_empty() && !is_reported_elsewhere(column)
        });
        let not_read = not_read.map(|(_, column)| {
            if column.is_unknown() && origin(&column.head).is_none() {
                with_nearest(&column.head)
            } else {
                column.head.clone()
            }
        });
        let not_read: Vec<String> = not_read.collect();
        let stated_air = stated_air.map(|air| air_of_rows(&air.column.head));
        let replaced = (!self.added.is_empty()).then_some(
            "the column Line and all after it, which an earlier 'fly' added, are replaced",
        );
        let remarks = stated_air
            .map(Message::from)
            .into_iter()
            .chain(repeated)
            .chain(replaced.map(Message::from))
            .chain(columns_remark(
                "columns that are copied and not used",
                &not_read,
            ));
        let remarks: Vec<Message> = remarks.collect();
        self.remarks.extend(remarks);
    }

    /// The parameters that each row states in addition to the launch.
    pub(crate) fn other_parameters(&self) -> Vec<&'static Parameter> {
        self.other_parameters
            .iter()
            .map(|row| row.parameter)
            .collect()
    }

    /// Column head of an outcome, for messages; the name of the outcome if it has no column.
    pub(super) fn name_of(&self, of: Outcome) -> String {
        self.column_of(of)
            .map_or(of.name().into(), |column| column.head.clone())
    }

    /// The air column; `None` if the export states no air.
    pub(super) fn stated_air(&self) -> Option<&RowParameter> {
        let mut parameters = self.other_parameters.iter();
        parameters.find(|row| row.column.is_stated_air())
    }
}

/// Interprets the columns of the ball's rest position (total, lateral total). [`TableHead`] does
/// not know their heads, because `calibrate` must ignore these columns: it does not know the ground
/// of the shots.
fn add_totals(setup: &Setup<f64>, head: &mut TableHead) -> Result<()> {
    if !head.format.is_export {
        return Ok(());
    }
    for at in 0..head.columns.len() {
        let name = &head.columns[at].head;
        let rest = rest_of_head(&words(name)).filter(|_| head.columns[at].is_unknown());
        let Some(of) = rest else {
            continue;
        };
        let unit = split_unit(&head.heads[at])
            .1
            .map_or(String::new(), |unit| format!(" [{unit}]"));
        let below = read_units(head.units.as_deref(), at);
        let mut total = Column::read(setup, &format!("{}{unit}", of.name()), below, head.format)?;
        total.head.clone_from(name);
        head.columns[at] = total;
    }
    Ok(())
}

/// Unit of a column, from the line below the column heads, without brackets.
fn read_units(units: Option<&[String]>, at: usize) -> Option<&str> {
    let unit = units?.get(at)?.trim_matches(['[', ']', '(', ')']);
    (!unit.is_empty()).then_some(unit)
}

/// Origin of a column's values, if its column head states it: `Est. Total Flat`, `Carry (Sim)`.
fn origin(head: &str) -> Option<Origin> {
    let words = words(head);
    let has = |word: &str| words.split(' ').any(|other| other == word);
    match () {
        () if has("est") || has("estimated") => Some(Origin::Estimated),
        () if has("sim") || has("modelled") || has("modeled") => Some(Origin::Modelled),
        () if has("measured") => Some(Origin::Measured),
        () => None,
    }
}
