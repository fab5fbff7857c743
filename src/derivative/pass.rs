use super::Taylor;
use super::directions::{Directions, MOST_PER_LANE, Passes};
use super::order::{Order, Pairs};
use super::point::{Point, blank};
use crate::drive::{self, Outcome, Shown, Struck};
use crate::error::Result;
use crate::impact::Head;
use crate::launch::Launch;
use crate::number::{Derivatives, Jet, Lanes, Mask, Mixed, Task, Vector, inlined};
use crate::parameters::Setup;

/// What a flight is differentiated by, where that is not the parameters.
#[derive(Clone, Copy)]
pub(super) enum Variable {
    /// A component of the launch: of its velocity, then of its spin.
    Launch(usize),
    /// The parameter of this index.
    Parameter(usize),
}

/// How much of a drive is computed, and by what it is differentiated.
pub(super) enum Part<'a> {
    /// All of it, by the parameters.
    Drive,
    /// The impact by the parameters, with the components of the launch.
    Impact { launch: &'a mut [Taylor] },
    /// The flight by its variables.
    Flight { launch: &'a [Taylor], variables: &'a [Variable] },
}

/// Derivatives of outcomes in as many directions as there are.
struct Pass<'a> {
    point: &'a Point<'a>,
    directions: Directions<'a>,
    part: Part<'a>,
    taylors: &'a mut [Taylor],
}

impl Point<'_> {
    /// Makes a pass: fills in what comes of these directions.
    pub fn pass(&self, directions: Directions<'_>, part: Part<'_>, taylors: &mut [Taylor]) -> Result<()> {
        self.level.of(directions.lanes(1)).run(Pass { point: self, directions, part, taylors })
    }
}

impl Task for Pass<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(self) -> Result<()> {
        match self.directions {
            Directions::None => self.over::<V>(1),
            Directions::Each(indices) if indices.len() <= V::WIDTH => self.over::<Jet<1, V>>(1),
            Directions::Each(_) => self.over::<Jet<MOST_PER_LANE, V>>(MOST_PER_LANE),
            Directions::Pairs(_) => self.over::<Mixed<V>>(2),
        }
    }
}

impl Pass<'_> {
    #[inline(always)]
    fn over<J: Lanes<Lane: Derivatives>>(self, per_lane: usize) -> Result<()> {
        let Self { point, directions, part, taylors } = self;
        let mut setup = point.setup.constant::<J>();
        let lanes = directions.lanes(per_lane);
        let mut take = |lane: usize, outcome: usize, number: J::Lane| {
            put(&mut taylors[outcome], directions.in_lane(lane, per_lane), &number);
        };
        let launch = if let Part::Flight { launch, variables } = part {
            let mut left: [J; 6] = std::array::from_fn(|component| J::constant(launch[component].value));
            directions.seeded(
                per_lane,
                |variable| match variables[variable] {
                    Variable::Launch(component) => launch[component].value,
                    Variable::Parameter(index) => point.x[index],
                },
                inlined!(|variable, number| match variables[variable] {
                    Variable::Launch(component) => left[component] = number,
                    Variable::Parameter(index) => setup.put(&point.wrt[index..=index], |_| number),
                }),
            );
            let [up, right, downrange, spin @ ..] = left;
            Launch { velocity: Vector::new(up, right, downrange), spin: Vector::from_array(spin) }
        } else {
            directions.seeded(
                per_lane,
                |index| point.x[index],
                inlined!(|index, number| setup.put(&point.wrt[index..=index], |_| number)),
            );
            let struck = Struck::new(&setup);
            if !struck.is_sound.holds(0) {
                return Err(point.refusal());
            }
            read_launches(point, &setup, &struck, lanes, &mut take)?;
            if let Part::Impact { launch } = part {
                let Launch { velocity, spin } = struck.launch;
                for lane in 0..lanes {
                    let components = velocity.to_array().into_iter().chain(spin.to_array());
                    for (component, number) in launch.iter_mut().zip(components) {
                        put(component, directions.in_lane(lane, per_lane), &number.lane(lane));
                    }
                }
                return Ok(());
            }
            struck.launch
        };
        if point.flies { point.fly(&setup, &launch, lanes, take) } else { Ok(()) }
    }
}

/// Shows the outcomes of the launch and of the head in each lane to `take`, with their indices.
#[inline(always)]
fn read_launches<J: Lanes>(
    point: &Point<'_>,
    setup: &Setup<J>,
    struck: &Struck<J>,
    lanes: usize,
    mut take: impl FnMut(usize, usize, J::Lane),
) -> Result<()> {
    let is_before_flight = |outcome: &Outcome| outcome.part() != drive::Part::Flight;
    if !point.of.iter().any(is_before_flight) {
        return Ok(());
    }
    let has_head = struck.club_speed.is_some() && point.of.iter().any(|outcome| outcome.part() == drive::Part::Head);
    let head = has_head.then(|| J::outlined(|| Head::new(&setup.club)));
    for lane in 0..lanes {
        let in_lane = inlined!(|number: J| number.lane(lane));
        let launch = struck.launch.map(in_lane);
        let club_speed = struck.club_speed.map(in_lane);
        let head = head.as_ref().map(|head| head.map(in_lane));
        let shown = Shown { launch: &launch, club_speed, landed: None, head: head.as_ref() };
        for (i, outcome) in point.of.iter().enumerate().filter(|(_, outcome)| is_before_flight(outcome)) {
            take(lane, i, outcome.shown(&shown).ok_or_else(|| outcome.missing())?);
        }
    }
    Ok(())
}

/// Writes what a number tells of its directions to the indices of their variables.
fn put<J: Derivatives>(taylor: &mut Taylor, indices: &[usize], number: &J) {
    taylor.value = number.re();
    for (i, &index) in indices.iter().enumerate() {
        taylor.gradient[index] = number.first(i);
    }
    if let (&[i, j], false) = (indices, taylor.hessian.is_empty()) {
        (taylor.hessian[i][j], taylor.hessian[j][i]) = (number.second(), number.second());
    }
}

/// The outcomes by the parameters themselves; `progress` is told how many passes of how many are done.
pub(super) fn derivatives(
    point: &Point<'_>,
    order: Order,
    pairs: Pairs,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    let n = if order == Order::Value { 0 } else { point.wrt.len() };
    let passes = match (order, pairs) {
        (Order::Second, Pairs::WithLast) => Passes::Pairs((0..n).map(|other| [n - 1, other]).collect()),
        _ => Passes::by(&(0..n).collect::<Vec<_>>(), order == Order::Second),
    };
    let mut taylors = blank(point.of.len(), n, if order == Order::Second { n } else { 0 });
    let mut done = 0;
    passes.run(point.level, &mut |directions, all| {
        point.pass(directions, Part::Drive, &mut taylors)?;
        done += 1;
        progress(done, all);
        Ok(())
    })?;
    Ok(taylors)
}
