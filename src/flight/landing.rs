use super::hermite::Segment;
use super::motion::Motion;
use super::node::{Node, Stepper};
use super::pace::Pace;
use super::rk4::Classical;
use super::shot::Shot;
use super::space::{Plane, Space};
use super::surroundings::{Still, Surroundings, Windy};
use super::tableau::Higher;
use crate::error::{Error, Result};
use crate::launch::Launch;
use crate::number::{Factor, Number, Vector};
use crate::parameters::{Method, Setup};
use crate::units::{Digits, Message, Quantity};
use std::fmt;

/// How a flight ends.
#[derive(Clone, Copy, Debug)]
pub enum Flight<T> {
    /// On the ground.
    Landed(Landed<T>),
    /// It does not begin, or was not followed to its end.
    None(NoFlight),
}

/// A flight that landed.
#[derive(Clone, Copy, Debug)]
pub struct Landed<T> {
    /// Downrange distance at landing, along the target line, m.
    pub carry: T,
    /// Distance to the right of the target line at landing, m.
    pub lateral: T,
    /// Time from launch to landing, s.
    pub flight_time: T,
    /// Velocity at landing, m/s.
    pub velocity: Vector<T>,
    /// The highest point of the flight; `None` where it was not asked for.
    pub apex: Option<Apex<T>>,
    /// Steps of the integration, the last one cut by the landing.
    pub steps: usize,
}

impl<T: Number> Landed<T> {
    /// The highest point of the flight.
    ///
    /// # Errors
    /// [`Error::Undefined`] where the flight was followed for its landing alone.
    pub fn apex(&self) -> Result<&Apex<T>> {
        self.apex.as_ref().ok_or_else(|| Error::Undefined {
            what: "the apex".into(),
            reason: "the flight was followed for its landing alone".into(),
        })
    }
}

impl<T: Copy> Landed<T> {
    /// The same over another number.
    #[inline(always)]
    pub(crate) fn map<U>(&self, mut f: impl FnMut(T) -> U) -> Landed<U> {
        Landed {
            carry: f(self.carry),
            lateral: f(self.lateral),
            flight_time: f(self.flight_time),
            velocity: self.velocity.map(&mut f),
            apex: self.apex.map(|apex| Apex {
                height: f(apex.height),
                time: f(apex.time),
                downrange: f(apex.downrange),
            }),
            steps: self.steps,
        }
    }
}

/// The highest point of a flight; the launch itself where the ball only falls.
#[derive(Clone, Copy, Debug)]
pub struct Apex<T> {
    /// Height above the tee, m.
    pub height: T,
    /// Time from launch, s.
    pub time: T,
    /// Downrange distance, m.
    pub downrange: T,
}

/// Why there is no landing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoFlight {
    /// Launched at or below horizontal, with the ground at or above the ball.
    LaunchedDown {
        /// Angle above horizontal, rad.
        launch_angle: f64,
    },
    /// The apex stays below the ground's height.
    BelowGround {
        /// Apex height, m.
        apex_height: f64,
        /// The ground's height, m.
        ground_height: f64,
    },
    /// Still in the air when `flight.time_limit` ran out.
    Aloft {
        /// When, s.
        time: f64,
        /// How high, m.
        height: f64,
    },
}

impl NoFlight {
    /// The status it has in JSON.
    pub fn status(&self) -> &'static str {
        match self {
            Self::LaunchedDown { .. } | Self::BelowGround { .. } => "no-flight",
            Self::Aloft { .. } => "aloft",
        }
    }
}

impl NoFlight {
    /// The same in a sentence.
    pub fn message(&self) -> Message {
        let height =
            |message: Message, height: f64| message.quantity(Quantity::LENGTH, "m", height, Digits::Significant(5));
        match self {
            Self::LaunchedDown { launch_angle } => {
                let degrees = launch_angle.to_degrees();
                Message::from(format!(
                    "the ball leaves at {degrees:.3}° to the horizontal and the ground is not below it; \
                     more loft or attack angle lets it fly"
                ))
            }
            Self::BelowGround { apex_height, ground_height } => {
                let rises = height("the ball rises to ".into(), *apex_height);
                height(rises.words(" only, below the ground's height of "), *ground_height)
            }
            Self::Aloft { time, height: up } => height("the ball is still ".into(), *up)
                .words(format!(" up after {time} s; raise flight.time_limit to follow it further")),
        }
    }
}

impl fmt::Display for NoFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

/// What is wanted of a flight beyond its landing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// Nothing.
    Landing,
    /// The apex.
    Apex,
}

/// Flies the ball from launch to landing (docs/model.md, eqs. 12–18). No heap memory is used.
///
/// # Errors
/// [`Error::Diverged`] where the numbers overflow.
pub fn fly<T: Number>(setup: &Setup<T>, launch: &Launch<T>) -> Result<Flight<T>> {
    Shot::new(setup, launch).fly::<Vector<T>>(&Pace::of(setup), Wanted::Apex, |_| ())
}

impl<T: Number> Shot<T> {
    /// The flight in a space, showing each node of the integration to `observe`, from the launch on.
    #[inline(always)]
    pub(super) fn fly<S: Space<T>>(
        &self,
        pace: &Pace,
        wanted: Wanted,
        observe: impl FnMut(&Node<T, S>),
    ) -> Result<Flight<T>> {
        self.fly_by::<S, _>(Windy::new(self.law, self.force_per_mass), pace, wanted, observe)
    }

    /// The flight by the shortest way there is: in the plane where it stays there, and with the one law whose
    /// coefficients change with the time alone taken in rather than called, if its constants can be of type `C`.
    #[inline(always)]
    pub(super) fn fly_shortest<C: Factor<T>>(&self, pace: &Pace, wanted: Wanted) -> Result<Flight<T>> {
        if !(self.is_plane() && self.is_in_still_air()) {
            return self.fly::<Vector<T>>(pace, wanted, |_| ());
        }
        match self.spun::<C>(pace) {
            Some(law) => self.fly_by::<Plane<T>, _>(law, pace, wanted, |_| ()),
            None => self.fly_by::<Plane<T>, _>(Still::new(self.law, self.force_per_mass), pace, wanted, |_| ()),
        }
    }

    #[inline(always)]
    fn fly_by<S: Space<T>, L: Surroundings<T>>(
        &self,
        law: L,
        pace: &Pace,
        wanted: Wanted,
        observe: impl FnMut(&Node<T, S, L::Memory>),
    ) -> Result<Flight<T>> {
        match pace.method {
            Method::Rk4 => T::outlined(
                #[inline(always)]
                || self.follow::<S, L, Classical<L::Constant>>(law, pace, wanted, observe),
            ),
            Method::DormandPrince5 | Method::DormandPrince8 => T::outlined(
                #[inline(always)]
                || self.follow::<S, L, Higher<L::Constant>>(law, pace, wanted, observe),
            ),
        }
    }

    #[inline(always)]
    fn follow<S: Space<T>, L: Surroundings<T>, M: Stepper<T, S, L::Constant>>(
        &self,
        law: L,
        pace: &Pace,
        wanted: Wanted,
        mut observe: impl FnMut(&Node<T, S, L::Memory>),
    ) -> Result<Flight<T>> {
        let ground = self.ground;
        let step = pace.step;
        let mut above = ground.re() < 0.0;
        let rising = self.velocity.x.re() > 0.0;
        if !above && !rising {
            let launch = Launch { velocity: self.velocity, spin: self.axis };
            return Ok(Flight::None(NoFlight::LaunchedDown { launch_angle: launch.launch_angle().re() }));
        }

        let motion = Motion::<T, S, L>::new(self, law);
        let stepper = M::new(&motion, pace);
        let mut here = Node::at_launch(&motion, self);
        let mut apex = Apex { height: T::zero(), time: T::zero(), downrange: T::zero() };
        for steps in 1.. {
            observe(&here);
            if here.state.time >= pace.time_limit {
                let (time, height) = (here.state.time, here.state.position.up().re());
                return Ok(Flight::None(NoFlight::Aloft { time, height }));
            }
            let time = steps as f64 * step;
            let (next, _) = stepper.step(&motion, &here, time);
            // NaN is no less than 1, and infinite numbers pull as much
            let is_followed = here.coarseness(step).re() <= 1.0;

            let falls = here.state.velocity.up().re() > 0.0 && next.state.velocity.up().re() <= 0.0;
            let is_low = next.state.position.up().re() <= ground.re();
            // a step without an event
            if is_followed && !is_low && !(falls && (wanted == Wanted::Apex || !above)) {
                above = true;
                here = next;
                continue;
            }

            if !is_followed || next.is_lost() {
                return Err(Error::Diverged { time: here.state.time, step });
            }

            // the step once more, with what it added: kept at every step, that would fill the registers for nothing
            // (copies, so that what every step uses is not kept in memory for the sake of the call)
            let (motion, stepper, start) = (motion, stepper, here.state);
            let (from, to, added) = T::outlined(
                #[inline(always)]
                || {
                    let from = Node::at(&motion, start);
                    let (to, added) = stepper.step(&motion, &from, time);
                    (from, to, added)
                },
            );
            let segment = Segment::new(&motion, &from, &to, &added, step);
            let mut falls_from = 0.0;
            if falls {
                let s = segment.height().top();
                let top = segment.position(s);
                if top.x.re() > apex.height.re() {
                    apex = Apex { height: top.x, time: segment.time(s), downrange: top.z };
                }
                if !above && top.x.re() <= ground.re() {
                    let (apex_height, ground_height) = (top.x.re(), ground.re());
                    return Ok(Flight::None(NoFlight::BelowGround { apex_height, ground_height }));
                }
                above = true;
                falls_from = s.re();
            }

            if !is_low {
                above = true;
            } else if above {
                let s = segment.height().falls_to(ground, falls_from);
                let landing = segment.position(s);
                return Ok(Flight::Landed(Landed {
                    carry: landing.z,
                    lateral: landing.y,
                    flight_time: segment.time(s),
                    velocity: segment.velocity(s),
                    apex: (wanted == Wanted::Apex).then_some(apex),
                    steps,
                }));
            }
            here = to;
        }
        unreachable!("the loop ends by the time limit")
    }
}
