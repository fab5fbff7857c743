//! The chain rule between impact and flight. A flight depends on some twenty quantities, whatever number of parameters
//! made them: derivatives of the flight are taken by the fewer of the two.

use super::Taylor;
use super::asked::{Asked, Directions};
use super::pass::{MOST_PER_LANE, most_in_a_pass, put, read_launches};
use crate::drive::{self, Struck};
use crate::error::Result;
use crate::flight::Inputs;
use crate::number::{Jet, Lanes, Level, Mask, Task};

/// The flight's inputs, and how they change with the parameters.
struct Changes {
    inputs: Inputs<f64>,
    parameters: usize,
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
        let part = Part::Impact { changes: &mut changes, taylors: &mut taylors };
        Level::of(places.len()).run(Pass { asked, places, part })?;
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
    // a flight that no parameter changes is flown too, for its value
    let all = directions.len().div_ceil(most_in_a_pass()).max(1);
    for done in 0..all {
        let places = directions.chunks(most_in_a_pass()).nth(done).unwrap_or_default();
        let moving = by_input.then_some(&moving[..]);
        let part = Part::Flight { changes: &changes, moving, slopes: &mut slopes };
        Level::of(places.len()).run(Pass { asked, places, part })?;
        progress(done + 1, all);
    }
    for (outcome, (taylor, slopes)) in asked.of.iter().zip(taylors.iter_mut().zip(slopes)) {
        if outcome.part() != drive::Part::Flight {
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

/// A pass by the parameters, or the flight's inputs, at some places.
struct Pass<'a> {
    asked: &'a Asked<'a>,
    places: &'a [usize],
    part: Part<'a>,
}

enum Part<'a> {
    /// The impact by the parameters; outcomes of the launch are filled in.
    Impact { changes: &'a mut Option<Changes>, taylors: &'a mut [Taylor] },
    /// The flight by its inputs that move or, where there are none given, through them by the parameters.
    Flight { changes: &'a Changes, moving: Option<&'a [usize]>, slopes: &'a mut [Taylor] },
}

impl Task for Pass<'_> {
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

impl Pass<'_> {
    #[inline(always)]
    fn over<const K: usize, V: Lanes<Lane = f64>>(self) -> Result<()> {
        let Self { asked, places, part } = self;
        let directions = Directions::Each(places);
        let lanes = directions.lanes(K);
        match part {
            Part::Impact { changes, taylors } => {
                let struck = Struck::new(&asked.lifted::<Jet<K, V>>(directions, K));
                if !struck.is_sound.holds(0) {
                    return Err(asked.refusal());
                }
                changes
                    .get_or_insert_with(|| Changes::none(&struck.inputs, asked.wrt.len()))
                    .take(&struck.inputs, places);
                read_launches(asked, &struck, lanes, |lane, outcome, jet| {
                    put(&mut taylors[outcome], directions.in_lane(lane, K), &jet);
                })
            }
            Part::Flight { changes, moving, slopes } => {
                asked.fly(&changes.seeded::<K, V>(moving, places), lanes, |lane, outcome, jet| {
                    put(&mut slopes[outcome], directions.in_lane(lane, K), &jet);
                })
            }
        }
    }
}

impl Changes {
    /// The inputs with room for gradients by so many parameters.
    fn none<const K: usize, V: Lanes<Lane = f64>>(inputs: &Inputs<Jet<K, V>>, parameters: usize) -> Self {
        let mut count = 0;
        let inputs = inputs.map(|jet| {
            count += 1;
            jet.re.lane(0)
        });
        Self { inputs, parameters, gradients: vec![0.0; count * parameters] }
    }

    /// Takes over the derivatives by the parameters at some places.
    fn take<const K: usize, V: Lanes<Lane = f64>>(&mut self, inputs: &Inputs<Jet<K, V>>, places: &[usize]) {
        let mut rows = self.gradients.chunks_mut(self.parameters);
        inputs.map(|jet| {
            if let Some(row) = rows.next() {
                for (k, d) in jet.gradient.iter().enumerate() {
                    for (lane, place) in places.iter().skip(k).step_by(K).enumerate() {
                        row[*place] = d.lane(lane);
                    }
                }
            }
        });
    }

    /// The inputs, each with its change in the directions of a pass.
    #[inline(always)]
    fn seeded<const K: usize, V: Lanes<Lane = f64>>(
        &self,
        moving: Option<&[usize]>,
        places: &[usize],
    ) -> Inputs<Jet<K, V>> {
        let mut input = 0;
        self.inputs.map(|value| {
            let change = |place: usize| match moving {
                Some(moving) => f64::from(u8::from(moving[place] == input)),
                None => self.gradients[input * self.parameters + place],
            };
            let gradient = std::array::from_fn(|k| {
                V::from_lanes(|lane| places.get(lane * K + k).map_or(0.0, |place| change(*place)))
            });
            input += 1;
            Jet { re: V::constant(value), gradient }
        })
    }
}
