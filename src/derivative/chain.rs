//! The chain rule between impact and flight. A flight depends on some twenty quantities, whatever number of parameters
//! made them: derivatives of the flight are taken by the fewer of the two.

use crate::drive::{Outcome, Part, Shown};
use crate::error::{Error, Result};
#[cfg(target_arch = "x86_64")]
use crate::flight::Over;
use crate::flight::{Flight, Pace, Shot, Wanted};
use crate::impact::{Unchecked, strike};
use crate::launch::Launch;
use crate::number::{Counterpart, Fast, Jet, Jet2, Level, Number, Numbers, Pairs, Seeded, Task, Taylor, Vector};
#[cfg(target_arch = "x86_64")]
use crate::number::{Fused, Pack4, Wide};
use crate::parameters::{Parameter, Setup};
use std::marker::PhantomData;

/// A question, at one place.
pub(super) struct Asked<'a> {
    pub setup: &'a Setup<f64>,
    /// The ball as it leaves, where no club makes it.
    pub launch: Option<&'a Launch<f64>>,
    pub of: &'a [Outcome],
    pub wrt: &'a [&'static Parameter],
    /// The parameters' values.
    pub x: &'a [f64],
    /// Whether an outcome is of the flight, and whether one is of its apex.
    pub flies: bool,
    pub has_apex: bool,
}

/// Parameters differentiated by in one pass of the impact.
const IMPACT_WIDTH: usize = 12;

/// A ball just struck.
struct Struck<T> {
    launch: Launch<T>,
    /// Where there is a club.
    club_speed: Option<T>,
    shot: Shot<T>,
}

impl Asked<'_> {
    /// The impact, where parameter `seeds[k]` is the independent variable of direction k.
    fn strike<J: Seeded + Fast>(&self, seeds: &[usize]) -> Result<Struck<J>> {
        if let Some(struck) = self.strike_quickly(seeds) {
            return Ok(struck);
        }
        let setup = self.lifted(seeds, |plain: J| plain);
        let launch = strike(&setup)?.launch;
        Ok(Struck { launch, club_speed: Some(setup.swing.speed), shot: Shot::new(&setup, &launch) })
    }

    /// The impact over a faster number, where it is one that needs no second look.
    fn strike_quickly<J: Seeded + Fast>(&self, seeds: &[usize]) -> Option<Struck<J>> {
        if self.launch.is_some() || self.setup.launch.is_given() {
            let setup = self.lifted(seeds, |plain: J| plain);
            let lifted = |v: Vector<f64>| v.map(J::constant);
            let launch = self.launch.map(|given| Launch { velocity: lifted(given.velocity), spin: lifted(given.spin) });
            let launch = launch.or_else(|| Launch::given(&setup))?;
            return Some(Struck { launch, club_speed: None, shot: Shot::new(&setup, &launch) });
        }
        if self.setup.impact.friction.is_some() {
            return None;
        }
        Level::run_four(Strike::<J, J::Four> { asked: self, seeds, number: PhantomData })?
    }

    /// The setup, where parameter `seeds[k]` is the independent variable of direction k, over what `made` makes of each number.
    #[inline(always)]
    fn lifted<J: Seeded, F: Numbers>(&self, seeds: &[usize], made: impl Fn(J) -> F) -> Setup<F> {
        self.setup.map(
            #[inline(always)]
            |parameter, value| {
                let Some(place) = self.wrt.iter().position(|row| *row == parameter) else { return F::constant(value) };
                match seeds.iter().position(|seed| *seed == place) {
                    None => F::constant(self.x[place]),
                    Some(direction) => made(J::seeded(self.x[place], direction)),
                }
            },
        )
    }

    /// The flight, where it is asked for; over the number it is asked for in, or a faster one that holds the same.
    fn fly<J: Fast>(&self, shot: &Shot<J>) -> Result<Option<Flight<J>>> {
        if self.flies { shot.fly_fast(&Pace::of(self.setup), self.wanted()).map(Some) } else { Ok(None) }
    }

    fn wanted(&self) -> Wanted {
        if self.has_apex { Wanted::Apex } else { Wanted::Landing }
    }

    /// The outcomes in the number that the drive was computed in.
    fn direct<J: Seeded + Fast>(&self, seeds: &[usize]) -> Result<Vec<J>> {
        let Struck { launch, club_speed, shot } = self.strike::<J>(seeds)?;
        let flight = self.fly(&shot)?;
        self.of.iter().map(|outcome| read(*outcome, &launch, club_speed, flight.as_ref())).collect()
    }

    /// A Taylor polynomial to be filled in for each outcome.
    fn blank(&self, rows: usize) -> Vec<Taylor> {
        let n = self.wrt.len();
        let blank = || Taylor { value: 0.0, gradient: vec![0.0; n], hessian: vec![vec![0.0; n]; rows] };
        std::iter::repeat_with(blank).take(self.of.len()).collect()
    }
}

/// An impact over a number that holds the same as another; nothing where it is not one that needs no second look.
struct Strike<'a, J, F> {
    asked: &'a Asked<'a>,
    seeds: &'a [usize],
    number: PhantomData<(J, F)>,
}

impl<J: Seeded, F: Counterpart<J>> Task for Strike<'_, J, F> {
    type Output = Option<Struck<J>>;

    #[inline(always)]
    fn run(self) -> Self::Output {
        let setup = self.asked.lifted(self.seeds, F::made_of);
        let struck = Unchecked::new(&setup);
        if struck.checks() != [true; 4] {
            return None;
        }
        let (launch, shot) = (struck.launch, Shot::new(&setup, &struck.launch));
        Some(Struck {
            launch: Launch { velocity: launch.velocity.map(F::plain), spin: launch.spin.map(F::plain) },
            club_speed: Some(setup.swing.speed.plain()),
            shot: shot.map(F::plain),
        })
    }
}

/// An outcome of a launch and what followed.
fn read<J: Number>(
    outcome: Outcome,
    launch: &Launch<J>,
    club_speed: Option<J>,
    flight: Option<&Flight<J>>,
) -> Result<J> {
    let landed = match flight {
        Some(Flight::Landed(landed)) => Some(landed),
        Some(Flight::None(why)) if outcome.part() == Part::Flight => {
            return Err(Error::NoFlight { reason: why.message() });
        }
        _ => None,
    };
    outcome.shown(&Shown { launch, club_speed, landed }).ok_or_else(|| Error::Undefined {
        what: outcome.name().into(),
        reason: match outcome.part() {
            Part::Launch => "no club strikes the ball: the launch is given".into(),
            Part::Flight => "the flight was not followed for it".into(),
        },
    })
}

/// Each outcome, alone.
pub(super) fn values(asked: &Asked<'_>) -> Result<Vec<Taylor>> {
    let outcomes = asked.direct::<f64>(&[])?;
    Ok(outcomes.into_iter().map(|value| Taylor { value, ..Taylor::default() }).collect())
}

/// Each outcome with its gradient; `progress` is told how many passes of how many are done.
pub(super) fn first(asked: &Asked<'_>, mut progress: impl FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    if asked.wrt.len() > 2 {
        return chained(asked, progress);
    }
    let seeds: Vec<usize> = (0..asked.wrt.len()).collect();
    let outcomes = asked.direct::<Jet<2>>(&seeds)?;
    progress(1, 1);
    let gradient = |jet: &Jet<2>| seeds.iter().map(|&k| jet.gradient[k]).collect();
    Ok(outcomes.iter().map(|jet| Taylor { value: jet.re, gradient: gradient(jet), hessian: vec![] }).collect())
}

/// Each outcome with its gradient and the wanted part of its Hessian; `progress` as in [`first`].
pub(super) fn second(asked: &Asked<'_>, pairs: Pairs, mut progress: impl FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    let n = asked.wrt.len();
    let is_wanted = |i: &usize| pairs == Pairs::All || i + 1 == n;
    let mut wanted: Vec<Vec<usize>> = (0..n).filter(is_wanted).flat_map(|i| (0..i).map(move |j| vec![j, i])).collect();
    if n == 1 {
        wanted.push(vec![0]);
    }
    let mut taylors = asked.blank(n);
    for (done, pair) in wanted.iter().enumerate() {
        for (jet, taylor) in asked.direct::<Jet2<2, 3>>(pair)?.iter().zip(&mut taylors) {
            taylor.value = jet.re;
            for (i, &row) in pair.iter().enumerate() {
                taylor.gradient[row] = jet.gradient[i];
                for (j, &column) in pair.iter().enumerate() {
                    taylor.hessian[row][column] = jet.second(i, j);
                }
            }
        }
        progress(done + 1, wanted.len());
    }
    Ok(taylors)
}

/// How the quantities that a flight depends on answer to the parameters.
struct Inputs {
    /// The quantities, without derivatives.
    shot: Shot<f64>,
    /// Their gradients, one after the other.
    gradients: Vec<f64>,
}

/// Gradients by many parameters: those of the impact, then those of the flight by its inputs or, where these are more, by the
/// parameters.
fn chained(asked: &Asked<'_>, mut progress: impl FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    let mut taylors = asked.blank(0);
    let inputs = impact(asked, &mut taylors)?;
    if !asked.flies {
        progress(1, 1);
        return Ok(taylors);
    }
    let gradients = inputs.gradients.chunks_exact(asked.wrt.len());
    let moves = |(input, gradient): (usize, &[f64])| gradient.iter().any(|d| *d != 0.0).then_some(input);
    let moving: Vec<usize> = gradients.enumerate().filter_map(moves).collect();
    let gradient = |input: usize| &inputs.gradients[input * asked.wrt.len()..][..asked.wrt.len()];
    let by_input = moving.len() < asked.wrt.len();
    let directions = if by_input { moving.len() } else { asked.wrt.len() };
    // how far a direction moves an input, and what the derivative in that direction adds to a gradient
    let seed = |input: usize, direction: usize| match by_input {
        true => f64::from(u8::from(moving[direction] == input)),
        false => gradient(input)[direction],
    };
    let add = |sums: &mut [f64], direction: usize, derivative: f64| match by_input {
        true => {
            for (sum, d) in sums.iter_mut().zip(gradient(moving[direction])) {
                *sum += derivative * d;
            }
        }
        false => sums[direction] = derivative,
    };
    let wide = match Level::here() {
        Level::Eight => 24,
        Level::Four => 8,
        Level::Baseline => 2,
    };
    let mut from = 0;
    while from < directions.max(1) {
        let here = (directions - from).min(wide);
        let pass = FlightPass { asked, shot: &inputs.shot, from, here, seed: &seed, add: &add };
        match here {
            ..=2 => pass.run::<2>(&mut taylors, |shot, pace, wanted| Some(shot.fly_fast(pace, wanted)))?,
            #[cfg(target_arch = "x86_64")]
            ..=8 => pass.run::<8>(&mut taylors, |shot, pace, wanted| match Level::here() {
                Level::Eight => Level::run_eight(Over::<_, Wide<1>>::new(shot, pace, wanted)),
                _ => Level::run_four(Over::<_, Jet<2, Fused, Pack4>>::new(shot, pace, wanted)),
            })?,
            #[cfg(target_arch = "x86_64")]
            _ => pass.run::<24>(&mut taylors, |shot, pace, wanted| {
                Level::run_eight(Over::<_, Wide<3>>::new(shot, pace, wanted))
            })?,
            #[cfg(not(target_arch = "x86_64"))]
            _ => {}
        }
        from += here.max(1);
        progress(from.min(directions), directions);
    }
    Ok(taylors)
}

/// The impact with its gradients, a chunk of the parameters at a time; outcomes of the launch are filled in.
fn impact(asked: &Asked<'_>, taylors: &mut [Taylor]) -> Result<Inputs> {
    let places: Vec<usize> = (0..asked.wrt.len()).collect();
    let mut inputs = None;
    for chunk in places.chunks(IMPACT_WIDTH) {
        if let Some(struck) = asked.strike_quickly::<Jet<IMPACT_WIDTH>>(chunk) {
            take(asked, chunk, &struck, &mut inputs, taylors)?;
            continue;
        }
        for pair in chunk.chunks(2) {
            take(asked, pair, &asked.strike::<Jet<2>>(pair)?, &mut inputs, taylors)?;
        }
    }
    inputs.ok_or(Error::Nothing { doing: "differentiate by", what: "parameter" })
}

/// Takes over what an impact says of the parameters at some places.
fn take<const N: usize>(
    asked: &Asked<'_>,
    places: &[usize],
    struck: &Struck<Jet<N>>,
    inputs: &mut Option<Inputs>,
    taylors: &mut [Taylor],
) -> Result<()> {
    let n = asked.wrt.len();
    let inputs = inputs.get_or_insert_with(|| {
        let mut count = 0;
        let shot = struck.shot.map(|jet| {
            count += 1;
            jet.re
        });
        Inputs { shot, gradients: vec![0.0; count * n] }
    });
    let mut rows = inputs.gradients.chunks_mut(n);
    struck.shot.map(|jet| {
        if let Some(row) = rows.next() {
            for (&place, d) in places.iter().zip(jet.gradient) {
                row[place] = d;
            }
        }
    });
    for (outcome, taylor) in asked.of.iter().zip(taylors) {
        if outcome.part() == Part::Launch {
            let jet = read(*outcome, &struck.launch, struck.club_speed, None)?;
            taylor.value = jet.re;
            for (&place, d) in places.iter().zip(jet.gradient) {
                taylor.gradient[place] = d;
            }
        }
    }
    Ok(())
}

/// A flight with derivatives in some of the directions.
struct FlightPass<'a, S, A> {
    asked: &'a Asked<'a>,
    shot: &'a Shot<f64>,
    from: usize,
    here: usize,
    seed: &'a S,
    add: &'a A,
}

impl<S: Fn(usize, usize) -> f64, A: Fn(&mut [f64], usize, f64)> FlightPass<'_, S, A> {
    fn run<const N: usize>(
        &self,
        taylors: &mut [Taylor],
        fly: impl FnOnce(&Shot<Jet<N>>, &Pace, Wanted) -> Option<Result<Flight<Jet<N>>>>,
    ) -> Result<()> {
        let mut input = 0;
        let shot = self.shot.map(|value| {
            let mut jet = Jet::<N>::constant(value);
            for (k, d) in jet.gradient.iter_mut().enumerate().take(self.here) {
                *d = (self.seed)(input, self.from + k);
            }
            input += 1;
            jet
        });
        // as many directions at once as the machine's registers hold: it has them
        let Some(flight) = fly(&shot, &Pace::of(self.asked.setup), self.asked.wanted()) else { return Ok(()) };
        let flight = flight?;
        let launch = Launch { velocity: shot.velocity, spin: shot.axis };
        for (outcome, taylor) in self.asked.of.iter().zip(taylors) {
            if outcome.part() == Part::Flight {
                let jet = read(*outcome, &launch, None, Some(&flight))?;
                taylor.value = jet.re;
                for (k, d) in jet.gradient.iter().enumerate().take(self.here) {
                    (self.add)(&mut taylor.gradient, self.from + k, *d);
                }
            }
        }
        Ok(())
    }
}
