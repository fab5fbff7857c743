use crate::number::{Lanes, Level, MOST_PER_LANE, Mask, inlined};

/// The variables of a differentiation, divided among the lanes. Every lane computes the same drive,
/// with derivatives by other variables.
#[derive(Clone, Copy)]
pub(super) struct Directions<'a> {
    /// Indices of the variables: first those of lane 0, then those of lane 1, and so on.
    pub variables: &'a [usize],
    /// True if each lane has a pair of variables, for their mixed second derivative.
    pub are_pairs: bool,
}

/// Entries of a Hessian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Entries {
    All,
    /// Second derivatives ∂²/∂x² by each variable x.
    Diagonal,
    /// Last row: second derivatives ∂²/∂x∂y by each variable x and the last variable y.
    LastRow,
}

/// List of the two variables of each requested entry of a Hessian, one pair after the other. Only
/// entries of the lower triangle are listed.
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
        Entries::LastRow => rows.last().into_iter().flat_map(row).collect(),
    }
}

impl Directions<'_> {
    /// Splits the variables into passes: evaluations of the drive in all lanes. Without variables
    /// there is one pass, which computes the values.
    pub fn passes(self, level: Level) -> impl ExactSizeIterator<Item = Self> {
        let per_lane = if self.are_pairs { 2 } else { MOST_PER_LANE };
        let most = per_lane * level.width();
        let end = self.variables.len();
        (0..end.div_ceil(most).max(1)).map(move |k| Self {
            variables: &self.variables[k * most..end.min((k + 1) * most)],
            ..self
        })
    }

    /// Variables of one lane of `J`.
    #[inline(always)]
    pub fn in_lane<J: Lanes>(&self, lane: usize) -> &[usize] {
        self.variables
            .chunks(variables_per_lane::<J>())
            .nth(lane)
            .unwrap_or_default()
    }

    /// Number of lanes of `J` with variables, at least one.
    pub fn lanes<J: Lanes>(&self) -> usize {
        let per_lane = variables_per_lane::<J>();
        self.variables.len().div_ceil(per_lane).max(1)
    }

    /// Calls `put` with each variable and a number. The number has the value of the variable, and
    /// the derivative 1 in each lane and direction of this variable. If several pairs contain a
    /// variable, `put` is called several times with this variable.
    #[inline(always)]
    pub fn seeded<J: Lanes>(&self, value: impl Fn(usize) -> f64, mut put: impl FnMut(usize, J)) {
        let per_lane = variables_per_lane::<J>();
        for (at, &variable) in self.variables.iter().enumerate() {
            let own = at / per_lane;
            let changes_in = inlined!(|direction: usize| {
                let mut lanes = J::Mask::none();
                for lane in if self.are_pairs {
                    0..self.lanes::<J>()
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

/// Variables of a lane: a lane without derivatives counts as one with a single variable.
#[inline(always)]
fn variables_per_lane<J: Lanes>() -> usize {
    J::DIRECTIONS.max(1)
}
