//! The chain rule between impact and flight. A flight depends on some twenty quantities, and on six where the club alone changes, whatever
//! number of parameters made them: by more parameters, derivatives of the flight are taken by these.

use super::Taylor;
use super::asked::{Asked, Directions};
use super::pass::{MOST_PER_LANE, most_in_a_pass, put, read_launches};
use crate::drive::{self, Struck};
use crate::error::Result;
use crate::flight::Inputs;
use crate::launch::Launch;
use crate::number::{Derivatives, Jet, Lanes, MOST_LANES, Mask, Mixed, Number, Task, inlined};
use crate::parameters::Parameter;

/// By fewer parameters a flight may have more pairs of inputs than there are of these.
const MOST_INPUTS: usize = 24;
/// Velocity and spin of the ball: all that the club and its strike change of a flight.
const OF_A_LAUNCH: usize = 6;

/// Whether Hessians by these parameters take fewer flights by what stands between impact and flight.
pub(super) fn pays(wrt: &[&'static Parameter]) -> bool {
    wrt.len() > if by_the_launch(wrt) { OF_A_LAUNCH } else { MOST_INPUTS }
}

/// Whether these parameters change a flight through its launch alone.
fn by_the_launch(wrt: &[&'static Parameter]) -> bool {
    wrt.iter().all(|parameter| parameter.is_of_strike())
}

/// What the flight depends on, and how it changes with the parameters.
struct Changes {
    inputs: Inputs<f64>,
    /// The ball as it leaves, where nothing else of the flight changes: then its velocity and spin are what is differentiated by, else the
    /// inputs.
    launch: Option<Launch<f64>>,
    parameters: usize,
    /// The gradients of these quantities, one after the other.
    gradients: Vec<f64>,
    /// Their Hessians likewise, row by row, where these are asked for.
    hessians: Vec<f64>,
}

/// Values and gradients by many parameters. `progress` is told how many passes of how many are done.
pub(super) fn gradients(asked: &Asked<'_>, progress: &mut dyn FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    let each = |count: usize| (0..count).collect::<Vec<_>>();
    derivatives(
        asked,
        false,
        &|n, pass| each(n).chunks(most_in_a_pass(asked.level)).try_for_each(|d| pass(Directions::Each(d))),
        progress,
    )
}

/// The same with Hessians.
pub(super) fn hessians(asked: &Asked<'_>, progress: &mut dyn FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    let pairs = |count: usize| (0..count).flat_map(|i| (0..=i).map(move |j| [i, j])).collect::<Vec<_>>();
    derivatives(
        asked,
        true,
        &|n, pass| pairs(n).chunks(asked.level.width()).try_for_each(|d| pass(Directions::Pairs(d))),
        progress,
    )
}

/// Makes a pass for each part of the directions in so many variables.
type Passes<'a> = &'a dyn Fn(usize, &mut dyn FnMut(Directions<'_>) -> Result<()>) -> Result<()>;

fn derivatives(
    asked: &Asked<'_>,
    to_second: bool,
    passes: Passes<'_>,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    let n = asked.wrt.len();
    let rows = |n: usize| if to_second { n } else { 0 };
    let mut taylors = asked.blank(n, rows(n));
    let mut changes = None;
    passes(n, &mut |directions| {
        let part = Part::Impact { changes: &mut changes, taylors: &mut taylors };
        asked.level_of(directions).run(Pass { asked, directions, part })
    })?;
    let Some(changes) = changes.filter(|_| asked.flies) else {
        progress(1, 1);
        return Ok(taylors);
    };
    let moves = |(input, gradient): (usize, &[f64])| gradient.iter().any(|d| *d != 0.0).then_some(input);
    let moving: Vec<usize> = changes.gradients.chunks_exact(n).enumerate().filter_map(moves).collect();
    let mut slopes = asked.blank(moving.len(), rows(moving.len()));
    let (mut done, mut all) = (0, 0);
    passes(moving.len(), &mut |_| {
        all += 1;
        Ok(())
    })?;
    let mut fly = |directions: Directions<'_>| {
        let part = Part::Flight { changes: &changes, moving: &moving, slopes: &mut slopes };
        asked.level_of(directions).run(Pass { asked, directions, part })?;
        done += 1;
        progress(done, all.max(1));
        Ok(())
    };
    match all {
        // a flight that no parameter changes is flown too, for its value
        0 => fly(Directions::None)?,
        _ => passes(moving.len(), &mut fly)?,
    }
    for (outcome, (taylor, slopes)) in asked.of.iter().zip(taylors.iter_mut().zip(slopes)) {
        if outcome.part() == drive::Part::Flight {
            changes.chain(taylor, &slopes, &moving);
        }
    }
    Ok(taylors)
}

/// A pass in some directions.
struct Pass<'a> {
    asked: &'a Asked<'a>,
    directions: Directions<'a>,
    part: Part<'a>,
}

enum Part<'a> {
    /// The impact by the parameters; outcomes of the launch are filled in.
    Impact { changes: &'a mut Option<Changes>, taylors: &'a mut [Taylor] },
    /// The flight by its inputs that move.
    Flight { changes: &'a Changes, moving: &'a [usize], slopes: &'a mut [Taylor] },
}

impl Task for Pass<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(self) -> Result<()> {
        match self.directions {
            Directions::Pairs(_) => self.over::<Mixed<V>>(2),
            _ => self.over::<Jet<MOST_PER_LANE, V>>(MOST_PER_LANE),
        }
    }
}

impl Pass<'_> {
    #[inline(always)]
    fn over<J: Lanes<Lane: Derivatives>>(self, per_lane: usize) -> Result<()> {
        let Self { asked, directions, part } = self;
        let lanes = directions.lanes(per_lane);
        match part {
            Part::Impact { changes, taylors } => {
                let setup = asked.lifted::<J>(directions, per_lane);
                let struck = Struck::new(&setup, asked.runs);
                if !struck.is_sound.holds(0) {
                    return Err(asked.refusal());
                }
                let to_second = !taylors[0].hessian.is_empty();
                changes
                    .get_or_insert_with(|| Changes::blank(&struck, asked.wrt, to_second))
                    .take(&struck, directions, per_lane);
                read_launches(asked, &setup, &struck, lanes, |lane, outcome, number| {
                    put(&mut taylors[outcome], directions.in_lane(lane, per_lane), &number);
                })
            }
            Part::Flight { changes, moving, slopes } => {
                let mut input = 0;
                let seeded = inlined(
                    #[inline(always)]
                    |value: f64| {
                        // called for each of them, and not taken in
                        let number = J::outlined(
                            #[inline(always)]
                            || match moving.iter().position(|moves| *moves == input) {
                                Some(place) => directions.seeded(place, J::constant(value), per_lane),
                                None => J::constant(value),
                            },
                        );
                        input += 1;
                        number
                    },
                );
                let inputs = match &changes.launch {
                    Some(launch) => changes.inputs.map(J::constant).leaving(&launch.map(seeded)),
                    None => changes.inputs.map(seeded),
                };
                asked.fly(&inputs, lanes, |lane, outcome, number| {
                    put(&mut slopes[outcome], directions.in_lane(lane, per_lane), &number);
                })
            }
        }
    }
}

impl Changes {
    /// The ball as it leaves, with room for gradients by these parameters, and for Hessians.
    fn blank<J: Lanes>(struck: &Struck<J>, wrt: &[&'static Parameter], to_second: bool) -> Self {
        let mut inputs = 0;
        let values = struck.inputs.map(|number| {
            inputs += 1;
            number.lane(0).re()
        });
        let launch = by_the_launch(wrt).then(|| struck.launch.map(|number| number.lane(0).re()));
        let (count, n) = (if launch.is_some() { OF_A_LAUNCH } else { inputs }, wrt.len());
        let hessians = if to_second { count * n * n } else { 0 };
        Self { inputs: values, launch, parameters: n, gradients: vec![0.0; count * n], hessians: vec![0.0; hessians] }
    }

    /// Takes over the derivatives by the parameters in some directions.
    #[inline(always)]
    fn take<J: Lanes<Lane: Derivatives>>(&mut self, struck: &Struck<J>, directions: Directions<'_>, per_lane: usize) {
        let (n, lanes) = (self.parameters, directions.lanes(per_lane));
        let places: [&[usize]; MOST_LANES] = std::array::from_fn(|lane| directions.in_lane(lane, per_lane));
        let mut gradients = self.gradients.chunks_exact_mut(n);
        let mut hessians = self.hessians.chunks_exact_mut(n * n);
        let take = inlined(
            #[inline(always)]
            |number: J| {
                // called for each of them, and not taken in
                J::outlined(
                    #[inline(always)]
                    || {
                        let (Some(gradient), mut hessian) = (gradients.next(), hessians.next()) else { return };
                        for (lane, places) in places.iter().take(lanes).enumerate() {
                            let number = number.lane(lane);
                            for (i, &place) in places.iter().enumerate() {
                                gradient[place] = number.first(i);
                            }
                            if let (&&[i, j], Some(second), Some(hessian)) = (places, number.second(), hessian.as_mut())
                            {
                                (hessian[i * n + j], hessian[j * n + i]) = (second, second);
                            }
                        }
                    },
                );
            },
        );
        match self.launch {
            Some(_) => _ = struck.launch.map(take),
            None => _ = struck.inputs.map(take),
        }
    }

    /// The derivatives by parameters of what has these by the inputs that move.
    fn chain(&self, taylor: &mut Taylor, by_inputs: &Taylor, moving: &[usize]) {
        let n = self.parameters;
        let gradient = |input: usize| &self.gradients[input * n..][..n];
        let add = |sums: &mut [f64], factor: f64, terms: &[f64]| {
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += factor * term);
        };
        taylor.value = by_inputs.value;
        for (a, &input) in moving.iter().enumerate() {
            add(&mut taylor.gradient, by_inputs.gradient[a], gradient(input));
            if taylor.hessian.is_empty() {
                continue;
            }
            // how the slope by this input changes with the parameters
            let mut bent = vec![0.0; n];
            for (b, &other) in moving.iter().enumerate() {
                add(&mut bent, by_inputs.hessian[a][b], gradient(other));
            }
            for (i, row) in taylor.hessian.iter_mut().enumerate() {
                add(row, by_inputs.gradient[a], &self.hessians[(input * n + i) * n..][..n]);
                add(row, gradient(input)[i], &bent);
            }
        }
        // symmetric to the last bit, as its terms are
        for i in 0..taylor.hessian.len() {
            for j in 0..i {
                taylor.hessian[j][i] = taylor.hessian[i][j];
            }
        }
    }
}
