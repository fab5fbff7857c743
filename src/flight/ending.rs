use crate::ground::Rest;
use crate::number::Vector;
use crate::units::{Digits, Message, Quantity};
use std::fmt;

/// How a flight ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flight<T> {
    /// On the ground.
    Landed(Landed<T>),
    /// It does not begin, or was not followed to its end.
    None(NoFlight),
}

/// A flight that landed.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// Where the ball rests; `None` where it was not asked for.
    pub rest: Option<Rest<T>>,
    /// What tells of the error of the integration, without derivatives: the defects of the steps,
    /// over the sine of the descent angle, m; `None` where it was not asked for.
    pub(crate) defect: Option<T>,
    /// Steps of the integration, the last one cut by the landing. Of drives side by side, those of
    /// the longest flight.
    pub steps: usize,
}

impl<T: Copy> Landed<T> {
    /// The same over another number.
    #[inline(always)]
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U + Copy) -> Landed<U> {
        Landed {
            carry: f(self.carry),
            lateral: f(self.lateral),
            flight_time: f(self.flight_time),
            velocity: self.velocity.map(f),
            apex: self.apex.as_ref().map(|apex| Apex {
                height: f(apex.height),
                time: f(apex.time),
                downrange: f(apex.downrange),
            }),
            rest: self.rest.as_ref().map(|rest| rest.map(f)),
            defect: self.defect.map(f),
            steps: self.steps,
        }
    }
}

/// The highest point of a flight; the launch itself where the ball only falls.
#[derive(Clone, Copy, Debug, PartialEq)]
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

    /// The same in a sentence.
    pub fn message(&self) -> Message {
        let height = |message: Message, height: f64| {
            message.quantity(Quantity::LENGTH, "m", height, Digits::Significant(5))
        };
        match self {
            Self::LaunchedDown { launch_angle } => {
                let angle = Quantity::ANGLE.read_off(*launch_angle, "deg");
                Message::from(format!(
                    "no flight: the ball leaves at {angle}, which is not above the horizontal, and \
                     the ground is not below the ball \
                     (a ball that only lift would raise is not followed); increase the launch \
                     angle (with a club: by more loft or attack angle), or lower ground.height"
                ))
            }
            Self::BelowGround {
                apex_height,
                ground_height,
            } => {
                let highest = height(
                    "no flight: the highest point of the ball is ".into(),
                    *apex_height,
                );
                height(
                    highest.words(", which is not above the ground at "),
                    *ground_height,
                )
                .words("; increase the speed or the launch angle, or lower ground.height")
            }
            Self::Aloft { time, height: up } => {
                let limit = format!(
                    "no landing: the flight was stopped at flight.time_limit = {time} s with the \
                     ball at a height of "
                );
                height(limit.into(), *up).words("; increase flight.time_limit")
            }
        }
    }
}

impl fmt::Display for NoFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}
