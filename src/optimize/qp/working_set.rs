use super::program::{Activity, QuadraticProgram};
use serde::{Deserialize, Serialize};

/// Working set: the bounds, rows and terms of the maximum that are treated as active (Nocedal &
/// Wright 2006, §16.5). At a solution it is the active set.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(in crate::optimize) struct WorkingSet {
    pub bounds: Vec<Activity>,
    pub rows: Vec<Activity>,
    pub max_terms: Vec<bool>,
}

/// A bound, row or term of the maximum.
#[derive(Clone, Copy)]
pub(super) enum ActiveConstraint {
    Bound(usize, Activity),
    Row(usize, Activity),
    MaxTerm(usize),
}

impl WorkingSet {
    /// True if the dimensions fit a program of `n` variables and `m` rows.
    pub fn has_dimensions(&self, n: usize, m: usize) -> bool {
        self.bounds.len() == n && self.rows.len() == m && !self.max_terms.is_empty()
    }

    /// True if the dimensions fit this program.
    pub fn fits(&self, program: &QuadraticProgram) -> bool {
        self.bounds.len() == program.dimension()
            && self.rows.len() == program.rows.len()
            && self.max_terms.len() == program.max_terms.len()
    }

    /// Working set of the constraints `active`, the fixed variables and the equalities. If the
    /// objective is a maximum of terms, at least one term is in the set.
    pub(super) fn new(
        program: &QuadraticProgram,
        active: impl IntoIterator<Item = ActiveConstraint>,
    ) -> Self {
        let fixed = |is_fixed: bool| {
            if is_fixed {
                Activity::Lower
            } else {
                Activity::Inactive
            }
        };
        let terms = program.max_terms.len();
        let mut set = Self {
            bounds: (0..program.dimension())
                .map(|i| fixed(program.low[i] == program.high[i]))
                .collect(),
            rows: program
                .rows
                .iter()
                .map(|row| fixed(row.is_equation()))
                .collect(),
            max_terms: vec![terms == 1; terms],
        };
        for constraint in active {
            match constraint {
                ActiveConstraint::Bound(i, side) => set.bounds[i] = side,
                ActiveConstraint::Row(j, side) => set.rows[j] = side,
                ActiveConstraint::MaxTerm(k) => set.max_terms[k] = true,
            }
        }
        if !set.max_terms.contains(&true) {
            set.max_terms[0] = true;
        }
        set
    }
}
