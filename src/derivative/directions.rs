use crate::number::{Lanes, Level, MOST_PER_LANE, Mask, inlined};

/// Variables of differentiation, by index. All lanes compute the same drive, each with its own
/// directions.
#[derive(Clone, Copy)]
pub(super) struct Directions<'a> {
    /// Indices of the variables. Each lane takes the next of them, as many as its number type has
    /// directions.
    pub variables: &'a [usize],
    /// True if the directions are pairs, one pair per lane, for a mixed second derivative.
    pub are_pairs: bool,
}

/// Entries of a Hessian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Entries {
    All,
    /// Second derivatives ∂²/∂x² by each variable x.
    Diagonal,
    /// Second derivatives that involve the last variable.
    Last,
}

/// Pairs of variables of the requested entries in the lower triangle of a Hessian: two elements of
/// the result for each entry.
pub(super) fn pairs(variables: &[usize], entries: Entries) -> Vec<usize> {
    let row = |i: usize| {
        variables[..=i]
            .iter()
            .flat_map(move |&other| [variables[i], other])
    };
    let rows = 0..variables.len();
    match entries {
        Entries::All => rows.flat_map(row).collect(),
        Entries::Diagonal => variables.iter().flat_map(|&alone| [alone; 2]).collect(),
        Entries::Last => rows.last().into_iter().flat_map(row).collect(),
    }
}

impl Directions<'_> {
    /// Splits the directions into passes: evaluations with one set of directions per lane. Without
    /// variables there is one pass, which computes the values.
    pub fn passes(self, level: Level) -> impl ExactSizeIterator<Item = Self> {
        let per_lane = if self.are_pairs { 2 } else { MOST_PER_LANE };
        let most = per_lane * level.width();
        let end = self.variables.len();
        (0..end.div_ceil(most).max(1)).map(move |k| Self {
            variables: &self.variables[k * most..end.min((k + 1) * most)],
            ..self
        })
    }

    /// Variables of one lane.
    #[inline(always)]
    pub fn in_lane(&self, lane: usize, per_lane: usize) -> &[usize] {
        self.variables
            .chunks(per_lane)
            .nth(lane)
            .unwrap_or_default()
    }

    /// Number of lanes with variables, at least one.
    pub fn lanes(&self, per_lane: usize) -> usize {
        self.variables.len().div_ceil(per_lane).max(1)
    }

    /// Calls `put` with each variable and its seeded number: the variable's value, with the
    /// derivative 1 in the variable's lanes and directions. A variable of several pairs is passed
    /// several times.
    #[inline(always)]
    pub fn seeded<J: Lanes>(
        &self,
        per_lane: usize,
        value: impl Fn(usize) -> f64,
        mut put: impl FnMut(usize, J),
    ) {
        for (at, &variable) in self.variables.iter().enumerate() {
            let own = at / per_lane;
            let changes_in = inlined!(|direction: usize| {
                let mut lanes = J::Mask::none();
                for lane in if self.are_pairs {
                    0..self.lanes(per_lane)
                } else {
                    own..own + 1
                } {
                    if self.variables.get(lane * per_lane + direction) == Some(&variable) {
                        lanes = lanes | J::Mask::only(lane);
                    }
                }
                lanes
            });
            put(
                variable,
                J::constant(value(variable)).seeded(&changes_in, 0),
            );
        }
    }
}
