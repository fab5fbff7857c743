use super::program::{End, QuadraticProgram};

/// Which ends, rows and pieces hold a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ActiveSet {
    pub ends: Vec<End>,
    pub rows: Vec<End>,
    pub pieces: Vec<bool>,
}

/// A constraint that can be active at a step.
#[derive(Clone, Copy)]
pub(super) enum ActiveConstraint {
    Variable(usize, End),
    Row(usize, End),
    Piece(usize),
}

impl QuadraticProgram {
    /// The active set of these holders, and of what holds any step: fixed variables, equations, and at least one piece.
    pub(super) fn held_by(&self, holders: impl IntoIterator<Item = ActiveConstraint>) -> ActiveSet {
        let fixed = |is_fixed: bool| if is_fixed { End::Low } else { End::Free };
        let mut active = ActiveSet {
            ends: (0..self.dimension()).map(|i| fixed(self.low[i] == self.high[i])).collect(),
            rows: self.rows.iter().map(|row| fixed(row.low == row.high)).collect(),
            pieces: vec![self.pieces.len() == 1; self.pieces.len()],
        };
        for holder in holders {
            match holder {
                ActiveConstraint::Variable(i, end) if self.low[i] < self.high[i] => active.ends[i] = end,
                ActiveConstraint::Row(j, end) if self.rows[j].low < self.rows[j].high => active.rows[j] = end,
                ActiveConstraint::Piece(k) => active.pieces[k] = true,
                // fixed already
                ActiveConstraint::Variable(..) | ActiveConstraint::Row(..) => {}
            }
        }
        if !active.pieces.contains(&true) {
            active.pieces[0] = true;
        }
        active
    }
}
