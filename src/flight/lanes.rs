//! Several flights side by side: each step moves them all, and what happens to one alone (apex, landing, trouble) is kept in
//! masks.

use super::hermite::{Quintic, Segment};
use super::landing::{Apex, Landed, Wanted};
use super::motion::Motion;
use super::node::{Node, State, Stepper};
use super::pace::Pace;
use super::rk4::Classical;
use super::shot::Shot;
use super::space::{Plane, Space};
use super::surroundings::{Still, Surroundings, Windy};
use super::tableau::Higher;
use crate::number::{Lanes, Vector, inlined};
use crate::parameters::Method;

/// Flights side by side that have ended.
pub(crate) struct Formation<T> {
    /// The landings, in the lanes that have one.
    pub landed: Landed<T>,
    /// A bit for each lane whose flight landed. The others had something happen to them that is for
    /// [`fly`](super::fly) to look at: no flight, a hop that ends in the step of its apex, numbers that overflow.
    pub sound: u8,
}

/// An event of some of the flights: the state from which the step leads in which it falls. That step is taken once more at the
/// end, for all of them together.
#[derive(Clone, Copy)]
struct Event<T, S> {
    lanes: u8,
    time: T,
    from: State<T, S>,
}

impl<T: Lanes, S: Space<T>> Event<T, S> {
    #[inline(always)]
    fn none<M>(here: &Node<T, S, M>) -> Self {
        Self { lanes: 0, time: T::zero(), from: here.state }
    }

    #[inline(always)]
    fn happens(&mut self, lanes: u8, from: &State<T, S>) {
        let mask = T::mask(lanes);
        self.lanes |= lanes;
        self.time = T::constant(from.time).blend(self.time, mask);
        self.from = from.blend(&self.from, mask);
    }
}

impl<T: Lanes> Shot<T> {
    /// Flies those of the shots that `flying` has a bit for.
    #[inline(always)]
    pub(crate) fn fly_abreast(&self, pace: &Pace, wanted: Wanted, flying: u8) -> Formation<T> {
        if !(self.is_plane() && self.is_in_still_air()) {
            return self.abreast_by::<Vector<T>, _>(Windy::new(self.law, self.force_per_mass), pace, wanted, flying);
        }
        match self.spun::<T::Value>(pace) {
            Some(law) => self.abreast_by::<Plane<T>, _>(law, pace, wanted, flying),
            None => self.abreast_by::<Plane<T>, _>(Still::new(self.law, self.force_per_mass), pace, wanted, flying),
        }
    }

    #[inline(always)]
    fn abreast_by<S: Space<T>, L: Surroundings<T>>(
        &self,
        law: L,
        pace: &Pace,
        wanted: Wanted,
        flying: u8,
    ) -> Formation<T> {
        match pace.method {
            Method::Rk4 => T::outlined(
                #[inline(always)]
                || self.abreast::<S, L, Classical<L::Constant>>(law, pace, wanted, flying),
            ),
            Method::DormandPrince5 | Method::DormandPrince8 => T::outlined(
                #[inline(always)]
                || self.abreast::<S, L, Higher<L::Constant>>(law, pace, wanted, flying),
            ),
        }
    }

    #[inline(always)]
    fn abreast<S: Space<T>, L: Surroundings<T>, M: Stepper<T, S, L::Constant>>(
        &self,
        law: L,
        pace: &Pace,
        wanted: Wanted,
        flying: u8,
    ) -> Formation<T> {
        let (ground, step) = (self.ground, pace.step);
        let is_above = inlined(
            #[inline(always)]
            |height: T| T::bits((ground - height).below(0.0)),
        );
        let is_rising = inlined(
            #[inline(always)]
            |velocity: S| T::bits((-velocity.up()).below(0.0)),
        );

        let motion = Motion::<T, S, L>::new(self, law);
        let stepper = M::new(&motion, pace);
        let mut here = Node::at_launch(&motion, self);
        let mut active = flying & (is_rising(here.state.velocity) | is_above(T::zero()));
        let mut above = is_above(T::zero());
        let mut rising = is_rising(here.state.velocity);
        let (mut apex, mut landing) = (Event::none(&here), Event::none(&here));
        let mut steps = 0;
        while active != 0 && here.state.time < pace.time_limit {
            steps += 1;
            let (next, _) = stepper.step(&motion, &here, f64::from(steps) * step);
            // a comparison with NaN does not hold: what is lost is not followed
            let followed = T::bits(here.coarseness(step).below(1.0)) & T::bits(next.state.position.up().is_finite());
            let (now_above, now_rising) = (is_above(next.state.position.up()), is_rising(next.state.velocity));
            let falls = active & rising & !now_rising;
            let lands = active & !now_above & above & followed;
            active &= followed & !(falls & (!above & !now_above | lands));
            if falls & active != 0 && wanted == Wanted::Apex {
                apex.happens(falls & active, &here.state);
            }
            if lands & active != 0 {
                landing.happens(lands & active, &here.state);
                active &= !lands;
            }
            above |= now_above;
            rising = now_rising;
            here = next;
        }
        let (motion, stepper) = (motion, stepper);
        self.landings(&motion, &stepper, pace, [apex, landing], wanted, steps as usize)
    }

    /// Where in their steps the events fall.
    #[inline(always)]
    fn landings<S: Space<T>, L: Surroundings<T>, M: Stepper<T, S, L::Constant>>(
        &self,
        motion: &Motion<T, S, L>,
        stepper: &M,
        pace: &Pace,
        [apex, landing]: [Event<T, S>; 2],
        wanted: Wanted,
        steps: usize,
    ) -> Formation<T> {
        let h = pace.step;
        let segment = |event: &Event<T, S>| {
            T::outlined(
                #[inline(always)]
                || {
                    let from = Node::at(motion, event.from);
                    let (to, added) = stepper.step(motion, &from, 0.0);
                    Segment::new(motion, &from, &to, &added, h)
                },
            )
        };
        let (path, mut sound) = (segment(&landing), landing.lanes);
        let height: Quintic<T> = path.height();
        let (s, found) = falling_root(
            #[inline(always)]
            |s| (height.value(s) - self.ground) / height.slope(s),
        );
        sound &= found;
        let at = path.position(s);
        let time = s * h + landing.time;
        let apex = (wanted == Wanted::Apex).then(|| {
            let path = segment(&apex);
            let height: Quintic<T> = path.height();
            let (s, found) = falling_root(
                #[inline(always)]
                |s| height.slope(s) / height.curvature(s),
            );
            sound &= found | !apex.lanes;
            let top = path.position(s);
            // a ball that only falls has its apex at the launch
            let is_one = T::mask(apex.lanes);
            let one = inlined(
                #[inline(always)]
                |value: T| value.blend(T::zero(), is_one),
            );
            Apex { height: one(top.x), time: one(s * h + apex.time), downrange: one(top.z) }
        });
        let landed = Landed { carry: at.z, lateral: at.y, flight_time: time, velocity: path.velocity(s), apex, steps };
        Formation { landed, sound }
    }
}

/// The roots that Newton's steps lead to from the end of the interval [0, 1], with as many derivatives as the number carries;
/// and which of them are known to lie there.
#[inline(always)]
fn falling_root<T: Lanes>(newton_step: impl Fn(T) -> T) -> (T, u8) {
    const MOST_STEPS: usize = 12;
    let mut s = T::constant(1.0);
    let mut close = 0;
    for _ in 0..MOST_STEPS {
        let change = newton_step(s);
        s = s - change;
        // once the value has settled, a step each makes first and second derivatives exact
        let settled = T::bits((change * change).below(1e-18));
        if close & settled == all::<T>() {
            break;
        }
        close = settled;
    }
    let inside = T::bits((-s).below(0.0)) & T::bits(s.below(1.0 + 1e-9));
    (s, close & inside)
}

/// A bit for each lane.
fn all<T: Lanes>() -> u8 {
    u8::MAX >> (8 - T::WIDTH)
}
