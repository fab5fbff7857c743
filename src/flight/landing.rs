use super::hermite::Segment;
use super::motion::Motion;
use super::rk4::Node;
use crate::error::{Error, Result};
use crate::launch::Launch;
use crate::number::{Number, Vector};
use crate::parameters::Setup;
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
    /// Downrange distance at landing, m.
    pub carry: T,
    /// Distance to the right of the target line at landing, m.
    pub lateral: T,
    /// Time from launch to landing, s.
    pub flight_time: T,
    /// Velocity at landing, m/s.
    pub velocity: Vector<T>,
    /// The highest point of the flight.
    pub apex: Apex<T>,
    /// Steps of the integration, the last one cut by the landing.
    pub steps: usize,
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

impl fmt::Display for NoFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LaunchedDown { launch_angle } => {
                let degrees = launch_angle.to_degrees();
                write!(
                    f,
                    "the ball leaves at {degrees:.3}° to the horizontal and the ground is not below it; \
                     more loft or attack angle lets it fly"
                )
            }
            Self::BelowGround { apex_height, ground_height } => {
                write!(
                    f,
                    "the ball rises to {apex_height:.3} m only, below the ground's height of {ground_height:.3} m"
                )
            }
            Self::Aloft { time, height } => {
                write!(
                    f,
                    "the ball is still {height:.1} m up after {time} s; raise flight.time_limit to follow it further"
                )
            }
        }
    }
}

/// Flies the ball from launch to landing (docs/model.md, eqs. 12–18). No heap memory is used.
///
/// # Errors
/// [`Error::Diverged`] where the numbers overflow.
pub fn fly<T: Number>(setup: &Setup<T>, launch: &Launch<T>) -> Result<Flight<T>> {
    follow(setup, launch, |_| ())
}

/// As [`fly`], showing each node of the integration to `observe`, from the launch on.
pub(super) fn follow<T: Number>(
    setup: &Setup<T>,
    launch: &Launch<T>,
    mut observe: impl FnMut(&Node<T>),
) -> Result<Flight<T>> {
    let ground = setup.ground.height;
    let step = setup.flight.step;
    let mut above = ground.re() < 0.0;
    let rising = launch.velocity.x.re() > 0.0;
    if !above && !rising {
        return Ok(Flight::None(NoFlight::LaunchedDown { launch_angle: launch.launch_angle().re() }));
    }

    let motion = Motion::new(setup, launch);
    let mut here = Node::at_launch(&motion, launch);
    let mut apex = Apex { height: T::zero(), time: T::zero(), downrange: T::zero() };
    for steps in 1.. {
        observe(&here);
        if here.time >= setup.flight.time_limit {
            let (time, height) = (here.time, here.position.x.re());
            return Ok(Flight::None(NoFlight::Aloft { time, height }));
        }
        let next = here.step(&motion, step, steps as f64 * step);
        if !next.is_finite() || here.is_coarse(step, setup.flight.gravity.re()) {
            return Err(Error::Diverged { time: here.time, step });
        }

        let mut falls_from = 0.0;
        if here.velocity.x.re() > 0.0 && next.velocity.x.re() <= 0.0 {
            let segment = Segment::new(&here, &next, step);
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

        if next.position.x.re() > ground.re() {
            above = true;
        } else if above {
            let segment = Segment::new(&here, &next, step);
            let s = segment.height().falls_to(ground, falls_from);
            let landing = segment.position(s);
            return Ok(Flight::Landed(Landed {
                carry: landing.z,
                lateral: landing.y,
                flight_time: segment.time(s),
                velocity: segment.velocity(s),
                apex,
                steps,
            }));
        }
        here = next;
    }
    unreachable!("the loop ends by the time limit")
}
