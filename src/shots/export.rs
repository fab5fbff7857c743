//! Reads the rows of an export as shots.

use super::columns::ShotColumns;
use super::shot::{Club, NOT_COMPARED, Origin, REFUSED, Shot, StatedValue, within};
use crate::drive::Outcome;
use crate::table::{
    CONDITIONS, Content, Record, Refusal, StatedConditions, air_of_setup, cells, conditions,
    contradiction, implausible_launch, not_compared,
};
use std::borrow::Cow;

/// Launch conditions of the spin. They share one origin (measured or estimated), which a column
/// such as `Spin Rate Type` states.
pub(super) const OF_SPIN: [Outcome; 4] = [
    Outcome::Spin,
    Outcome::Backspin,
    Outcome::Sidespin,
    Outcome::SpinAxis,
];

impl ShotColumns {
    /// Reads the shot of a record.
    pub(super) fn shot(&self, record: Record) -> Shot {
        let row = cells(&record.text, self.separator);
        if let Some(fault) = self.head.row_fault(&record, &row) {
            let refusal = fault.refusal();
            return Shot::refused(record.line, record.text, refusal);
        }
        let mut shot = self.of_cells(&row);
        if let Some(refusal) = shot
            .refusal()
            .and_then(|now| self.refused_before(&row, now))
        {
            shot.point = Err(refusal);
        }
        shot.has_cells_of_head = row.len() == self.head.heads.len();
        (shot.line, shot.text) = (record.line, record.text);
        shot
    }

    /// The refusal that an earlier run of `fly` wrote into the row, if it says more than `now`, the
    /// refusal of this run: `now` only reports a missing value, or all cells but the first are
    /// empty. Otherwise `None`.
    fn refused_before(&self, row: &[Cow<'_, str>], now: &Refusal) -> Option<Refusal> {
        let [_, flight, reason, _] = row.get(self.head.flown.clone())?.first_chunk()?;
        // `fly` writes a row without valid cells as one text into the first cell
        let own = row[..self.head.flown.start]
            .iter()
            .chain(&row[self.head.flown.end..]);
        let is_lacking = now.kind == Refusal::MISSING || own.skip(1).all(|cell| cell.is_empty());
        (flight == REFUSED && is_lacking).then(|| Refusal::new(Refusal::BEFORE, reason.as_ref()))
    }

    fn of_cells(&self, row: &[Cow<'_, str>]) -> Shot {
        let cell = |at: usize| &*row[at];
        let spin = self.spin_type.and_then(|at| Origin::read(cell(at)));
        let mut shot = Shot::refused(0, String::new(), Refusal::new(Refusal::MISSING, ""));
        let mut wrong = None;
        let carry = || {
            let (at, column) = self.head.column(Content::Outcome(Outcome::CarryDistance))?;
            column.value(cell(at)).ok().flatten()
        };
        for (at, column) in self.head.columns.iter().enumerate() {
            let Content::Outcome(of) = column.content else {
                continue;
            };
            let name = &column.head;
            let is_condition = CONDITIONS.contains(&of);
            match column.value(cell(at)) {
                Ok(None) => {}
                Ok(Some(value)) => {
                    let origin = self.origins[at].or(spin.filter(|_| OF_SPIN.contains(&of)));
                    match not_compared(of, value, carry).filter(|_| !is_condition) {
                        Some(why) => shot.notes.push(format!("{NOT_COMPARED}{name}: {why}")),
                        None => shot.values.push(StatedValue { of, value, origin }),
                    }
                }
                Err(why) if is_condition => {
                    wrong
                        .get_or_insert(Refusal::new(Refusal::UNREADABLE, format!("{name}: {why}")));
                }
                Err(why) => shot.notes.push(format!("{NOT_COMPARED}{name}: {why}")),
            }
        }
        let columns = &self.head.columns;
        let heads = self
            .club
            .map(|club| club.map_or("", |at| &columns[at].head));
        let stated = self.club.map(|club| {
            let Some(at) = club else {
                return Ok(None);
            };
            let column = &columns[at];
            let value = column.value(cell(at));
            value.map_err(|why| format!("{}: {why}", column.head))
        });
        // the columns are in the convention of the parameters
        shot.club = Club::measured(stated, heads, &mut shot.notes).other_convention(self.golfer);
        let text = |at: Option<usize>| {
            at.map(|at| cell(at).to_owned())
                .filter(|text| !text.is_empty())
        };
        shot.club_name = text(self.club_name);
        shot.condition = text(self.condition);
        shot.is_normalized = shot
            .condition
            .as_ref()
            .is_some_and(|text| text.to_ascii_lowercase().contains("normali"));
        let stated = shot.conditions();
        shot.point = wrong.map_or_else(|| self.point(&stated, row), Err);
        add_notes(&mut shot, &stated, |of| self.head.name_of(of));
        if shot.point.is_ok()
            && let Some((at, air)) = self.head.stated_air()
            && let Err(why) = air.stated_air(cell(at))
        {
            shot.notes.push(air_of_setup(&why));
        }
        shot
    }

    /// Input of the flight of a row, SI: the launch parameters, then the other parameters that the
    /// table states.
    fn point(&self, stated: &StatedConditions, row: &[Cow<'_, str>]) -> Result<Vec<f64>, Refusal> {
        let mut point = launch(
            stated,
            |of| self.head.name_of(of),
            |of| self.head.column(Content::Outcome(of)).is_some(),
        )?;
        for &parameter in &self.other_parameters {
            let Some((at, column)) = self.head.column(Content::Input(parameter)) else {
                continue;
            };
            if column.is_stated_air() {
                point.push(column.stated_air(&row[at]).unwrap_or(self.air));
                continue;
            }
            let name = &column.head;
            let value = column.value(&row[at]);
            let value =
                value.map_err(|why| Refusal::new(Refusal::UNREADABLE, format!("{name}: {why}")))?;
            let Some(value) = value else {
                let reason =
                    format!("{name}: the cell is empty; this column needs a value in every row");
                return Err(Refusal::new(Refusal::MISSING, reason));
            };
            point.push(within(parameter, value, name)?);
        }
        Ok(point)
    }
}

/// Computes the [`LAUNCH_PARAMETERS`](crate::table::LAUNCH_PARAMETERS) from the stated launch
/// conditions, SI. `name` returns the column head of a condition for messages; `has` is true for a
/// condition that has a column.
pub(super) fn launch(
    values: &StatedConditions,
    name: impl Fn(Outcome) -> String,
    has: impl Fn(Outcome) -> bool,
) -> Result<Vec<f64>, Refusal> {
    if let Some(reason) = implausible_launch(values, &name) {
        return Err(Refusal::new(Refusal::RANGE, reason));
    }
    match conditions(*values, has) {
        Ok(launch) => Ok(launch.to_vec()),
        Err(fault) => {
            let reason = format!("{}: {}", name(fault.of), fault.why);
            Err(Refusal::new(fault.kind, reason))
        }
    }
}

/// Adds notes to a shot: values assumed to be 0, and contradictory spins.
pub(super) fn add_notes(
    shot: &mut Shot,
    stated: &StatedConditions,
    name: impl Fn(Outcome) -> String,
) {
    let Some(&[_, _, _, back, side]) = shot.launch() else {
        return;
    };
    if shot.is_direction_assumed() {
        shot.notes
            .push("launch direction is missing: 0 deg is assumed".into());
    }
    if shot.is_axis_assumed() {
        shot.notes
            .push("spin axis is missing: 0 deg is assumed".into());
    }
    shot.notes
        .extend(contradiction(*stated, [back, side], name));
}
