use super::Taylor;
use super::asked::{Asked, Directions, blank, read};
use super::order::Pairs;
use crate::drive::{Outcome, Part, Struck};
use crate::error::Result;
use crate::impact::Head;
use crate::number::{Derivatives, Jet, Lanes, Mask, Mixed, Task, inlined};
use crate::parameters::Setup;

/// The most directions in a lane.
pub(super) const MOST_PER_LANE: usize = 3;

/// A drive with its derivatives in as many directions as there are, from the club to the landing.
struct Pass<'a> {
    asked: &'a Asked<'a>,
    directions: Directions<'a>,
    taylors: &'a mut [Taylor],
}

impl Task for Pass<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(self) -> Result<()> {
        match self.directions {
            Directions::None => self.over::<V>(1),
            Directions::Each(places) if places.len() <= V::WIDTH => self.over::<Jet<1, V>>(1),
            Directions::Each(_) => self.over::<Jet<MOST_PER_LANE, V>>(MOST_PER_LANE),
            Directions::Pairs(_) => self.over::<Mixed<V>>(2),
        }
    }
}

impl Pass<'_> {
    #[inline(always)]
    fn over<J: Lanes<Lane: Derivatives>>(self, per_lane: usize) -> Result<()> {
        let Self { asked, directions, taylors } = self;
        let mut setup = asked.setup.constant::<J>();
        asked.seed(&mut setup, directions, per_lane);
        let struck = Struck::new(&setup);
        if !struck.is_sound.holds(0) {
            return Err(asked.refusal());
        }
        let lanes = directions.lanes(per_lane);
        let mut take = |lane: usize, outcome: usize, number: J::Lane| {
            put(&mut taylors[outcome], directions.in_lane(lane, per_lane), &number);
        };
        read_launches(asked, &setup, &struck, lanes, &mut take)?;
        if asked.flies { asked.fly(&setup, &struck.launch, lanes, take) } else { Ok(()) }
    }
}

/// Shows the outcomes of the launch and of the head in each lane to `take`, with their places.
#[inline(always)]
pub(super) fn read_launches<J: Lanes>(
    asked: &Asked<'_>,
    setup: &Setup<J>,
    struck: &Struck<J>,
    lanes: usize,
    mut take: impl FnMut(usize, usize, J::Lane),
) -> Result<()> {
    let is_before_flight = |outcome: &Outcome| outcome.part() != Part::Flight;
    if !asked.of.iter().any(is_before_flight) {
        return Ok(());
    }
    let has_head = struck.club_speed.is_some() && asked.of.iter().any(|outcome| outcome.part() == Part::Head);
    let head = has_head.then(|| J::outlined(|| Head::new(&setup.club)));
    for lane in 0..lanes {
        let in_lane = inlined(
            #[inline(always)]
            |number: J| number.lane(lane),
        );
        let launch = struck.launch.map(in_lane);
        let club_speed = struck.club_speed.map(in_lane);
        let head = head.as_ref().map(|head| head.map(in_lane));
        for (i, outcome) in asked.of.iter().enumerate().filter(|(_, outcome)| is_before_flight(outcome)) {
            take(lane, i, read(*outcome, &launch, (club_speed, head.as_ref()), None)?);
        }
    }
    Ok(())
}

/// Writes what a number tells of its directions to their places.
pub(super) fn put<J: Derivatives>(taylor: &mut Taylor, places: &[usize], number: &J) {
    taylor.value = number.re();
    for (i, &place) in places.iter().enumerate() {
        taylor.gradient[place] = number.first(i);
    }
    if let (&[i, j], Some(second)) = (places, number.second()) {
        (taylor.hessian[i][j], taylor.hessian[j][i]) = (second, second);
    }
}

/// Each outcome, alone.
pub(super) fn values(asked: &Asked<'_>) -> Result<Vec<Taylor>> {
    let mut taylors = blank(asked.of.len(), 0, 0);
    let directions = Directions::None;
    asked.level_of(directions).run(Pass { asked, directions, taylors: &mut taylors })?;
    Ok(taylors)
}

/// Each outcome with its gradient by few enough parameters for one pass.
pub(super) fn gradients(asked: &Asked<'_>) -> Result<Vec<Taylor>> {
    let n = asked.wrt.len();
    let mut taylors = blank(asked.of.len(), n, 0);
    let places: Vec<usize> = (0..n).collect();
    let directions = Directions::Each(&places);
    asked.level_of(directions).run(Pass { asked, directions, taylors: &mut taylors })?;
    Ok(taylors)
}

/// Each outcome with its gradient and the wanted part of its Hessian; `progress` is told how many passes of how many are done.
pub(super) fn hessians(asked: &Asked<'_>, pairs: Pairs, progress: &mut dyn FnMut(usize, usize)) -> Result<Vec<Taylor>> {
    let n = asked.wrt.len();
    let rows = if pairs == Pairs::WithLast { n - 1..n } else { 0..n };
    let wanted: Vec<[usize; 2]> = rows.flat_map(|i| (0..=i).map(move |j| [i, j])).collect();
    let mut taylors = blank(asked.of.len(), n, n);
    let level = asked.level.of(wanted.len());
    let passes = wanted.chunks(level.width());
    let all = passes.len();
    for (done, pairs) in passes.enumerate() {
        level.run(Pass { asked, directions: Directions::Pairs(pairs), taylors: &mut taylors })?;
        progress(done + 1, all);
    }
    Ok(taylors)
}
