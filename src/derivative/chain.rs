//! The chain rule between impact and flight. A flight depends on some twenty quantities, whatever number of parameters
//! made them: derivatives of the flight are taken by the fewer of the two.

use super::Taylor;
use super::asked::{Asked, Directions};
use super::pass::{MOST_PER_LANE, most_in_a_pass, read_launches};
use crate::drive::Struck;
use crate::error::Result;
use crate::flight::Inputs;
use crate::number::{Jet, Lanes, Level, Mask, Task};

/// The flight's inputs, and how they change with the parameters.
struct Changes {
    inputs: Inputs<f64>,
    /// The gradients of the inputs, one after the other.
    gradients: Vec<f64>,
}

/// Gradients by many parameters: those of the impact, then those of the flight by its inputs or, where these are more, by the
/// parameters. `progress` is told how many passes of how many are done.
pub(super) fn gradients(asked: &Asked<'_>, mut progress: impl FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    let n = asked.wrt.len();
    let mut taylors = asked.blank(n, 0);
    let places: Vec<usize> = (0..n).collect();
    let mut changes = None;
    for places in places.chunks(most_in_a_pass()) {
        Level::of(places.len()).run(Impact { asked, places, changes: &mut changes, taylors: &mut taylors })?;
    }
    let Some(changes) = changes.filter(|_| asked.flies) else {
        progress(1, 1);
        return Ok(taylors);
    };
    let moves = |(input, gradient): (usize, &[f64])| gradient.iter().any(|d| *d != 0.0).then_some(input);
    let moving: Vec<usize> = changes.gradients.chunks_exact(n).enumerate().filter_map(moves).collect();
    let by_input = moving.len() < n;
    let directions: Vec<usize> = (0..if by_input { moving.len() } else { n }).collect();
    let mut slopes = asked.blank(directions.len(), 0);
    let passes = directions.chunks(most_in_a_pass());
    let all = passes.len();
    for (done, places) in passes.enumerate() {
        let moving = by_input.then_some(&moving[..]);
        let flight = Flight { asked, changes: &changes, moving, places, slopes: &mut slopes };
        Level::of(places.len()).run(flight)?;
        progress(done + 1, all);
    }
    for (outcome, (taylor, slopes)) in asked.of.iter().zip(taylors.iter_mut().zip(slopes)) {
        if outcome.part() != crate::drive::Part::Flight {
            continue;
        }
        taylor.value = slopes.value;
        if !by_input {
            taylor.gradient = slopes.gradient;
            continue;
        }
        for (input, slope) in moving.iter().zip(slopes.gradient) {
            for (sum, d) in taylor.gradient.iter_mut().zip(&changes.gradients[input * n..]) {
                *sum += slope * d;
            }
        }
    }
    Ok(taylors)
}

/// The impact, with derivatives by the parameters at some places; outcomes of the launch are filled in.
struct Impact<'a> {
    asked: &'a Asked<'a>,
    places: &'a [usize],
    changes: &'a mut Option<Changes>,
    taylors: &'a mut [Taylor],
}

impl Task for Impact<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(self) -> Result<()> {
        match self.places.len().div_ceil(V::WIDTH) {
            0 | 1 => self.over::<1, V>(),
            2 => self.over::<2, V>(),
            _ => self.over::<MOST_PER_LANE, V>(),
        }
    }
}

impl Impact<'_> {
    #[inline(always)]
    fn over<const K: usize, V: Lanes<Lane = f64>>(self) -> Result<()> {
        let Self { asked, places, changes, taylors } = self;
        let n = asked.wrt.len();
        let directions = Directions::Each(places);
        let struck = Struck::new(&asked.lifted::<Jet<K, V>>(directions, K), asked.launch);
        if !struck.is_sound.holds(0) {
            return Err(asked.refusal());
        }
        let changes = changes.get_or_insert_with(|| {
            let mut count = 0;
            let inputs = struck.inputs.map(|jet| {
                count += 1;
                jet.re.lane(0)
            });
            Changes { inputs, gradients: vec![0.0; count * n] }
        });
        let mut rows = changes.gradients.chunks_mut(n);
        struck.inputs.map(|jet| {
            if let Some(row) = rows.next() {
                for (direction, place) in places.iter().enumerate() {
                    row[*place] = jet.gradient[direction % K].lane(direction / K);
                }
            }
        });
        read_launches(asked, &struck, directions.lanes(K), |lane, outcome, jet| {
            taylors[outcome].value = jet.re;
            for (place, d) in directions.in_lane(lane, K).iter().zip(jet.gradient) {
                taylors[outcome].gradient[*place] = d;
            }
        })
    }
}

/// The flight, with derivatives in some directions: by its inputs or, through them, by the parameters.
struct Flight<'a> {
    asked: &'a Asked<'a>,
    changes: &'a Changes,
    /// The inputs differentiated by.
    moving: Option<&'a [usize]>,
    places: &'a [usize],
    slopes: &'a mut [Taylor],
}

impl Task for Flight<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(self) -> Result<()> {
        match self.places.len().div_ceil(V::WIDTH) {
            0 | 1 => self.over::<1, V>(),
            2 => self.over::<2, V>(),
            _ => self.over::<MOST_PER_LANE, V>(),
        }
    }
}

impl Flight<'_> {
    #[inline(always)]
    fn over<const K: usize, V: Lanes<Lane = f64>>(self) -> Result<()> {
        let Self { asked, changes, moving, places, slopes } = self;
        let n = asked.wrt.len();
        let mut input = 0;
        let inputs = changes.inputs.map(|value| {
            let change = |place: usize| match moving {
                Some(moving) => f64::from(u8::from(moving[place] == input)),
                None => changes.gradients[input * n + place],
            };
            let gradient = std::array::from_fn(|k| {
                V::from_lanes(|lane| places.get(lane * K + k).map_or(0.0, |place| change(*place)))
            });
            input += 1;
            Jet::<K, V> { re: V::constant(value), gradient }
        });
        let directions = Directions::Each(places);
        asked.fly(&inputs, directions.lanes(K), |lane, outcome, jet| {
            slopes[outcome].value = jet.re;
            for (place, d) in directions.in_lane(lane, K).iter().zip(jet.gradient) {
                slopes[outcome].gradient[*place] = d;
            }
        })
    }
}
