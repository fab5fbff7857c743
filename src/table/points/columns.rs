//! Columns of a table of points, independent of its format.

use crate::batch::refuse_repeated;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::table::{CONDITIONS, Column, Content, TableHead, columns_remark, heads_of, near_known};
use crate::units::Message;

/// Columns that are parameters of the drives.
#[derive(Debug)]
pub(super) struct PointColumns {
    /// Positions in the table, from 0.
    pub at: Vec<usize>,
    pub parameters: Vec<&'static Parameter>,
    /// Remarks on the columns of the table.
    pub notes: Vec<Message>,
}

impl PointColumns {
    /// Selects the columns of parameters. If no column is a parameter of swing, strike, club or
    /// impact, the columns of launch conditions are selected too.
    pub fn new(setup: &Setup<f64>, file: &str, head: &mut TableHead) -> Result<Self> {
        let is_struck = head.has_strike();
        let parameter = |column: &Column| match column.content {
            Content::Input(parameter) => Some(parameter),
            Content::Outcome(outcome) if !is_struck && CONDITIONS.contains(&outcome) => {
                setup.launch_condition(outcome.name())
            }
            _ => None,
        };
        let read = head
            .columns
            .iter()
            .enumerate()
            .filter_map(|(at, column)| Some((at, parameter(column)?)));
        let (at, parameters): (Vec<_>, Vec<_>) = read.unzip();
        refuse_repeated(&parameters).map_err(|error| {
            let reason = match error {
                Error::SearchRange { name, .. } => format!(
                    "the parameter {name} has two columns; \
                                                            keep one"
                ),
                _ if head.columns.is_empty() => "it has no columns".into(),
                _ => format!(
                    "none of its columns is a parameter or a launch condition ({}); add one, such \
                     as 'club.loft [deg]'",
                    heads_of(&head.columns, |_| true).join(", ")
                ),
            };
            Error::table(file, "", reason)
        })?;
        let near = near_known(&head.columns);
        if !near.is_empty() {
            let names: Vec<&str> = parameters.iter().map(|parameter| parameter.name).collect();
            setup
                .check_launch(&names)
                .map_err(|error| Error::table(file, "", format!("{error}{near}")))?;
        }
        if is_struck {
            // the spins are not read
            head.turned = None;
        }
        let mut notes = head.column_remarks();
        notes.extend(not_read(head, &at));
        Ok(Self {
            at,
            parameters,
            notes,
        })
    }

    /// Positions of the columns of these parameters.
    ///
    /// # Errors
    /// The name of a parameter that has no column.
    pub fn places_of(
        &self,
        parameters: &[&'static Parameter],
    ) -> std::result::Result<Vec<usize>, &'static str> {
        let place = |wanted: &&'static Parameter| {
            let found = self
                .parameters
                .iter()
                .position(|parameter| parameter == wanted);
            found.map(|found| self.at[found]).ok_or(wanted.name)
        };
        parameters.iter().map(place).collect()
    }
}

/// Remark on ignored columns. It omits columns that another remark names.
fn not_read(head: &TableHead, read: &[usize]) -> Option<Message> {
    let is_read = |column: &Column| {
        read.iter()
            .any(|at| std::ptr::eq(&head.columns[*at], column))
    };
    let not_read = heads_of(&head.columns, |column| {
        !is_read(column)
            && !column.is_overridden_air
            && (column.content != Content::Note || !head.format.is_export)
    });
    let of = if head.has_strike() && !head.format.is_export {
        "parameters of the club"
    } else {
        "parameters"
    };
    let what = format!("columns not read, since they are results or remarks and not {of}");
    columns_remark(&what, &not_read)
}
