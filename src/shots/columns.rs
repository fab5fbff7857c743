//! Meaning of the columns of an export.

use super::shot::{Club, Origin};
use crate::error::{Error, Result};
use crate::parameters::{Golfer, Parameter};
use crate::table::{
    Column, Content, TableHead, TextTable, air_of_rows, assume_unit, club_column, columns_remark,
    is_condition_head, missing_of_launch, near_known, split_unit, with_nearest, words,
};
use crate::units::Message;

/// The column heads of an export, interpreted.
#[derive(Clone, Debug)]
pub struct ShotColumns {
    /// Cell separator.
    pub separator: u8,
    pub(crate) head: TableHead,
    /// Origin of each column's values, if its head states it.
    pub(super) origins: Vec<Option<Origin>>,
    /// Indices of the columns of the club: speed, attack angle, path, face angle.
    pub(super) club: [Option<usize>; 4],
    /// Parameters that are not part of the launch.
    pub(crate) other_parameters: Vec<&'static Parameter>,
    /// Column that states whether the spin is measured or estimated.
    pub(super) spin_type: Option<usize>,
    /// Column that states the conditions for which the values hold, such as normalized weather.
    pub(super) condition: Option<usize>,
    /// Column with the name of the club.
    pub(super) club_name: Option<usize>,
    /// Handedness of the golfer.
    pub(super) golfer: Golfer,
    /// Air density of the setup, kg/m³, for rows that do not state the air.
    pub(super) air: f64,
    pub(super) remarks: Vec<Message>,
}

impl ShotColumns {
    /// Interprets the column heads of a table of shots.
    ///
    /// # Errors
    /// [`Error::Table`] if a launch column is missing, or if a unit has the wrong dimension.
    pub(super) fn read(mut head: TableHead, table: &TextTable) -> Result<Self> {
        let repeated = head.ignore_repeated();
        // `add_remarks` lists all unused columns, so drop the head's own remarks on them
        head.remarks.clear();
        let is_text = |at: usize| head.columns[at].content == Content::Note;
        let mut found = Self {
            separator: table.separator,
            origins: head.heads.iter().map(|head| origin(head)).collect(),
            club: Default::default(),
            other_parameters: vec![],
            spin_type: None,
            condition: None,
            club_name: club_column(&head.heads, is_text),
            golfer: table.setup.golfer,
            air: table.setup.air.density,
            remarks: vec![],
            head,
        };
        let name = &table.name;
        for at in 0..found.head.columns.len() {
            found.add(at).map_err(|error| {
                let place = format!(", column {}", at + 1);
                Error::table(name, place, error.to_string())
            })?;
        }
        if let Some(reason) = found.why_no_launch() {
            return Err(Error::table(name, "", reason));
        }
        found.find_descriptions();
        found.remarks = found.head.column_remarks();
        found.add_remarks(repeated);
        found.head.rows.clear();
        Ok(found)
    }

    /// Finds the columns `spin_type` and `condition`.
    fn find_descriptions(&mut self) {
        let heads = self.head.heads.iter();
        let plain: Vec<String> = heads.map(|head| words(split_unit(head).0)).collect();
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
        let own = &self.other_parameters;
        if let Some(missing) = first.iter().find(|parameter| !own.contains(parameter)) {
            return Err(missing.name);
        }
        let place = |own: &&Parameter| first.iter().position(|of| of == own);
        self.other_parameters
            .sort_by_key(|own| place(own).unwrap_or(first.len()));
        Ok(())
    }

    /// Adds a column by its meaning: a measured outcome, a parameter of the flight, or a value of
    /// the club. If several columns have the same value of the club, only the first is added.
    fn add(&mut self, at: usize) -> Result<()> {
        let column = &mut self.head.columns[at];
        match column.content {
            Content::Outcome(_) => column.check_unit()?,
            Content::Input(parameter) if !parameter.is_of_strike() && !parameter.is_of_launch() => {
                column.check_unit()?;
                self.other_parameters.push(parameter);
            }
            // a flight from a launch does not depend on the club: read a parameter of the club as
            // club data
            Content::Input(parameter) => {
                if let Some(club) = Club::index_of(parameter)
                    && self.club[club].is_none()
                    && column.clone().in_unit("mph").check_unit().is_ok()
                {
                    self.club[club] = Some(at);
                    let assumed = assume_unit(at, column, &self.head.rows);
                    self.head.assumed_units.extend(assumed);
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Message about missing columns of the launch; `None` if none is missing.
    fn why_no_launch(&self) -> Option<String> {
        let columns = &self.head.columns;
        let missing = missing_of_launch(columns);
        if missing.is_empty() {
            return None;
        }
        let near = near_known(columns);
        let heads = self.head.heads.iter();
        let heads = heads
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
    fn add_remarks(&mut self, repeated: Option<Message>) {
        let head = &self.head;
        let has_air = |(at, air): &(usize, &Column)| {
            let mut cells = head.rows.iter().map(|row| &row[*at]);
            cells.any(|cell| air.stated_air(cell).is_ok())
        };
        let stated_air = head.stated_air().filter(has_air);
        let is_read = |at: usize| match head.columns[at].content {
            Content::Outcome(_) => true,
            Content::Input(_) if head.columns[at].is_stated_air() => stated_air.is_some(),
            Content::Input(parameter) => {
                self.other_parameters.contains(&parameter) || self.club.contains(&Some(at))
            }
            _ => [self.spin_type, self.club_name].contains(&Some(at)),
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
        let stated_air = stated_air.map(|(_, air)| air_of_rows(&air.head));
        let replaced = (!head.flown.is_empty()).then_some(
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
