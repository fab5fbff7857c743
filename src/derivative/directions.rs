use crate::error::Result;
use crate::number::{Lanes, Level, Mask, inlined};

/// The most directions in a lane.
pub(super) const MOST_PER_LANE: usize = 3;

/// The variables, by their indices, that derivatives are taken by in all passes together.
pub(super) enum Passes {
    /// By each of some.
    Each(Vec<usize>),
    /// By pairs of them, twice.
    Pairs(Vec<[usize; 2]>),
}

impl Passes {
    /// First derivatives by each of some variables, or second ones by all pairs.
    pub fn by(variables: &[usize], to_second: bool) -> Self {
        match to_second {
            false => Self::Each(variables.to_vec()),
            true => Self::Pairs(
                variables.iter().enumerate().flat_map(|(i, &a)| variables[..=i].iter().map(move |&b| [a, b])).collect(),
            ),
        }
    }

    /// Makes passes of as many directions as fit into one; each is told how many there are. By nothing there is one, for the values.
    pub fn run(&self, level: Level, pass: &mut dyn FnMut(Directions<'_>, usize) -> Result<()>) -> Result<()> {
        match self {
            Self::Each(indices) if !indices.is_empty() => {
                let passes = indices.chunks(MOST_PER_LANE * level.width());
                let all = passes.len();
                passes.map(Directions::Each).try_for_each(|directions| pass(directions, all))
            }
            Self::Pairs(pairs) if !pairs.is_empty() => {
                let passes = pairs.chunks(level.of(pairs.len()).width());
                let all = passes.len();
                passes.map(Directions::Pairs).try_for_each(|directions| pass(directions, all))
            }
            _ => pass(Directions::None, 1),
        }
    }
}

/// The variables, by their indices, that a pass differentiates by: the lanes all hold the same drive, each with directions of its own.
#[derive(Clone, Copy)]
pub(super) enum Directions<'a> {
    /// By none.
    None,
    /// By one after the other, as many in each lane as its number has directions.
    Each(&'a [usize]),
    /// By a pair in each lane, twice.
    Pairs(&'a [[usize; 2]]),
}

impl Directions<'_> {
    /// The indices of the variables in a lane.
    #[inline(always)]
    pub fn in_lane(&self, lane: usize, per_lane: usize) -> &[usize] {
        match self {
            Self::None => &[],
            Self::Each(indices) => indices.chunks(per_lane).nth(lane).unwrap_or_default(),
            Self::Pairs(pairs) => pairs.get(lane).map_or(&[], |pair| pair),
        }
    }

    /// How many lanes have any, and at least one.
    pub fn lanes(&self, per_lane: usize) -> usize {
        match self {
            Self::None => 1,
            Self::Each(indices) => indices.len().div_ceil(per_lane).max(1),
            Self::Pairs(pairs) => pairs.len().max(1),
        }
    }

    /// Shows the index of each variable with its number to `put`: its value, in each lane the independent variable of the direction that it has there.
    #[inline(always)]
    pub fn seeded<J: Lanes>(&self, per_lane: usize, value: impl Fn(usize) -> f64, mut put: impl FnMut(usize, J)) {
        match self {
            Self::None => (),
            Self::Each(indices) => {
                for (at, &index) in indices.iter().enumerate() {
                    let (in_lane, in_direction) = (at / per_lane, at % per_lane);
                    let changes_in = inlined!(|direction: usize| {
                        if direction == in_direction { J::Mask::only(in_lane) } else { J::Mask::none() }
                    });
                    put(index, J::constant(value(index)).seeded(&changes_in, 0));
                }
            }
            // a variable in several pairs is passed once for each
            Self::Pairs(pairs) => {
                for &index in pairs.iter().flatten() {
                    let changes_in = inlined!(|direction: usize| {
                        let mut lanes = J::Mask::none();
                        for (lane, pair) in pairs.iter().enumerate() {
                            if pair[direction] == index {
                                lanes = lanes | J::Mask::only(lane);
                            }
                        }
                        lanes
                    });
                    put(index, J::constant(value(index)).seeded(&changes_in, 0));
                }
            }
        }
    }
}
