use crate::error::Error;

/// Heads of columns that cannot be read: all that have no meaning, or the first with another fault.
#[derive(Debug)]
pub(crate) struct ColumnErrors {
    /// Their numbers, from 0.
    at: Vec<usize>,
    reason: String,
}

/// The columns of a table of measured shots.
pub(super) const OF_SHOTS: &str = "give each a name that is known, or take it out: a column is a \
                                   parameter, an outcome, 'sigma OUTCOME', 'stationary', 'sigma \
                                   stationary' or 'note'";

/// Those of a table of points, or of swings.
pub(super) const OF_POINTS: &str = "give each a name that is known, or take it out: a column is a \
                                    parameter, with its unit as in 'swing.speed [mph]', or one \
                                    that a sweep has written, which is not read";

/// Those of a table of shots that are flown.
pub(super) const OF_LAUNCHES: &str = "give the columns of the launch heads that are known, as in \
                                      'Ball Speed [mph]', 'Launch Angle [deg]', 'Spin Rate [rpm]'; \
                                      the heads \
                           stand in one of the first lines, in English";

impl ColumnErrors {
    /// Collects the errors of columns, numbered from 0; `None` without errors.
    pub(super) fn of(faults: Vec<(usize, Error)>) -> Option<Self> {
        let mut unknown = vec![];
        for (at, error) in &faults {
            if let Error::Unknown {
                name,
                suggestion,
                advice,
                ..
            } = error
            {
                let near = suggestion
                    .as_ref()
                    .map(|near| format!(" (did you mean '{near}'?)"))
                    .unwrap_or_default();
                unknown.push((*at, format!("'{name}'{near}"), advice.clone()));
            }
        }
        if let [_, .., (_, _, advice)] = unknown.as_slice() {
            let named: Vec<&str> = unknown.iter().map(|(_, named, _)| named.as_str()).collect();
            let reason = format!("unknown columns {}; {advice}", named.join(", "));
            return Some(Self {
                at: unknown.into_iter().map(|(at, ..)| at).collect(),
                reason,
            });
        }
        let (at, error) = faults.into_iter().next()?;
        Some(Self {
            at: vec![at],
            reason: error.to_string(),
        })
    }

    /// Replaces the advice by that for another kind of table.
    pub fn advised(self, advice: &str) -> Self {
        Self {
            reason: self.reason.replace(OF_SHOTS, advice),
            ..self
        }
    }

    /// The refusal of the table in this file.
    pub fn in_file(self, file: &str) -> Error {
        let numbers: Vec<String> = self.at.iter().map(|at| (at + 1).to_string()).collect();
        let s = if numbers.len() == 1 { "" } else { "s" };
        Error::Table {
            file: file.into(),
            place: format!(", column{s} {}", numbers.join(", ")),
            reason: self.reason,
        }
    }
}
