use super::inputs::Inputs;
use crate::error::{Error, Result};
use crate::ground::Rest;
use crate::number::{Mask, Numbers, Vector};
use crate::units::{Digits, Message, Quantity, significant};
use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

/// Result of a flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flight<T> {
    /// The ball landed.
    Landed(Landed<T>),
    /// No landing: the ball does not fly, or is still in the air at the time limit.
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
    /// Highest point of the flight; `None` if not requested.
    pub apex: Option<Apex<T>>,
    /// Position at rest; `None` if not requested.
    pub rest: Option<Rest<T>>,
    /// Defect D of the integration (docs/model.md, eq. 16a), m, without derivatives; `None` if not
    /// requested.
    pub(crate) defect: Option<T>,
    /// Number of steps, including the step of the landing. In a batch, the number of steps of the
    /// longest flight.
    pub steps: usize,
}

impl<T: Copy> Landed<T> {
    /// Converts the number type.
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

/// Highest point of a flight. If the ball only falls, this is the launch point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apex<T> {
    /// Height above the tee, m.
    pub height: T,
    /// Time from launch, s.
    pub time: T,
    /// Downrange distance, m.
    pub downrange: T,
}

/// Reason why there is no landing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoFlight {
    /// Launched at or below horizontal, with the ground at or above the ball.
    LaunchedDown {
        /// Angle above horizontal, rad.
        launch_angle: f64,
    },
    /// The apex is not above the ground's height.
    BelowGround {
        /// Apex height, m.
        apex_height: f64,
        /// Height of the ground, m.
        ground_height: f64,
    },
    /// Still in the air at `flight.time_limit`.
    Aloft {
        /// The time limit, s.
        time: f64,
        /// Height at the time limit, m.
        height: f64,
    },
}

impl NoFlight {
    /// Status in JSON.
    pub fn status(&self) -> &'static str {
        match self {
            Self::LaunchedDown { .. } | Self::BelowGround { .. } => "no-flight",
            Self::Aloft { .. } => "aloft",
        }
    }

    /// The reason as a sentence, with advice.
    pub fn message(&self) -> Message {
        let with_height = |message: Message, height: f64| {
            message.quantity(Quantity::LENGTH, "m", height, Digits::Significant(5))
        };
        match self {
            Self::LaunchedDown { launch_angle } => {
                let angle = Quantity::ANGLE.read_off(*launch_angle, "deg");
                Message::from(format!(
                    "no flight: the ball leaves at {angle}, which is not above the horizontal, and \
                     the ground is not below the ball (a ball that rises by lift alone is not \
                     computed); increase the launch angle (with a club: by more loft or attack \
                     angle), or lower ground.height"
                ))
            }
            Self::BelowGround {
                apex_height,
                ground_height,
            } => {
                let apex = with_height(
                    "no flight: the highest point of the ball is ".into(),
                    *apex_height,
                );
                with_height(
                    apex.words(", which is not above the ground at "),
                    *ground_height,
                )
                .words("; increase the speed or the launch angle, or lower ground.height")
            }
            Self::Aloft { time, height } => {
                let limit = format!(
                    "no landing: the flight was stopped at flight.time_limit = {time} s with the \
                     ball at a height of "
                );
                with_height(limit.into(), *height).words("; increase flight.time_limit")
            }
        }
    }
}

impl From<NoFlight> for Error {
    fn from(why: NoFlight) -> Self {
        Self::NoFlight {
            status: why.status(),
            reason: why.message(),
        }
    }
}

impl fmt::Display for NoFlight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

/// Optional outputs of a flight, and the flag that stops it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RequestedOutputs<'s> {
    /// Highest point.
    pub apex: bool,
    /// Run after the landing.
    pub run: bool,
    /// Defect of the integration.
    pub defect: bool,
    /// Interrupt flag: once true, the flight ends within [`STOP_INTERVAL`] steps.
    pub stop: Option<&'s AtomicBool>,
}

/// Number of steps between two checks of the interrupt flag: about a millisecond.
const STOP_INTERVAL: usize = 4096;

impl<'s> RequestedOutputs<'s> {
    /// All outputs.
    pub fn all(stop: Option<&'s AtomicBool>) -> Self {
        Self {
            apex: true,
            run: true,
            defect: true,
            stop,
        }
    }

    /// All outputs of the flight, without the run.
    pub fn without_run(stop: &'s AtomicBool) -> Self {
        Self {
            run: false,
            ..Self::all(Some(stop))
        }
    }

    /// True if the flight stops after this number of steps.
    #[inline(always)]
    pub fn stops_at(&self, steps: usize) -> bool {
        steps.is_multiple_of(STOP_INTERVAL)
            && self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

/// Result of one flight, or of a batch of flights with one in each lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlightResult<T: Numbers> {
    /// Landings, in the lanes of `has_landed`.
    pub landed: Landed<T>,
    /// Lanes that landed.
    pub has_landed: T::Mask,
    /// Lanes whose apex is not above the ground.
    pub stays_below: T::Mask,
    /// Lanes whose velocity changes too much within a step, or overflows.
    pub diverges: T::Mask,
    /// Lanes still in the air at the time limit.
    pub is_aloft: T::Mask,
    /// True if the interrupt flag stopped the flights.
    pub is_stopped: bool,
    /// In lanes without a landing: height of an apex that is not above the ground, or of the ball
    /// at the time limit, m.
    pub height: T,
    /// Spin at landing, rad/s; `None` if the run is not requested.
    pub spin: Option<T>,
    /// Sum of the defects of the steps so far, m (docs/model.md, eq. 16a); `None` if the defect is
    /// not requested.
    pub defect_sum: Option<T>,
    /// Contribution D_A of the apex position to the defect, m (eq. 16a), if apex and defect are
    /// requested.
    pub apex_defect: T,
    /// Time at the end of the last step, s. In a batch, this is the time of the longest flight.
    pub time: f64,
}

impl<T: Numbers> FlightResult<T> {
    /// The result before the first step.
    #[inline(always)]
    pub(super) fn initial(outputs: RequestedOutputs<'_>) -> Self {
        let (zero, none) = (T::zero(), T::Mask::none());
        let landed = Landed {
            carry: zero,
            lateral: zero,
            flight_time: zero,
            velocity: Vector::zero(),
            apex: outputs.apex.then_some(Apex {
                height: zero,
                time: zero,
                downrange: zero,
            }),
            rest: None,
            defect: outputs.defect.then_some(zero),
            steps: 0,
        };
        Self {
            landed,
            has_landed: none,
            stays_below: none,
            diverges: none,
            is_aloft: none,
            is_stopped: false,
            height: zero,
            spin: outputs.run.then_some(zero),
            defect_sum: outputs.defect.then_some(zero),
            apex_defect: zero,
            time: 0.0,
        }
    }

    /// Reason why the flight in the first lane has no landing; `None` if it landed. `value`
    /// extracts the value of a number in this lane.
    ///
    /// # Errors
    /// [`Error::Diverged`] if drag and lift change the airspeed too much within a step, or if a
    /// number overflows; [`Error::Stopped`] after an interrupt.
    #[inline(always)]
    pub(crate) fn no_landing_reason(
        &self,
        inputs: &Inputs<T>,
        value: impl Fn(T) -> f64 + Copy,
    ) -> Result<Option<NoFlight>> {
        if self.has_landed.holds(0) {
            return Ok(None);
        }
        if self.is_stopped {
            return Err(Error::Stopped);
        }
        if self.diverges.holds(0) {
            let diverged = DivergedFlight {
                step: inputs.step,
                speed: inputs.velocity.map(value).norm(),
                spin: value(inputs.spin),
                force_per_mass: value(inputs.force_per_mass),
                wind: inputs.wind.at(inputs.ground).map(value).norm(),
            };
            return Err(Error::Diverged {
                time: self.time - inputs.step,
                step: inputs.step,
                advice: diverged.advice(inputs.law.name()),
            });
        }
        let height = value(self.height);
        if self.stays_below.holds(0) {
            return Ok(Some(NoFlight::BelowGround {
                apex_height: height,
                ground_height: value(inputs.ground),
            }));
        }
        if self.is_aloft.holds(0) {
            return Ok(Some(NoFlight::Aloft {
                time: inputs.time_limit,
                height,
            }));
        }
        let velocity = inputs.velocity.map(value);
        Ok(Some(NoFlight::LaunchedDown {
            launch_angle: velocity.x.atan2(velocity.y.hypot(velocity.z)),
        }))
    }
}

/// Conditions of a flight that diverged, SI.
struct DivergedFlight {
    /// Step, s.
    step: f64,
    /// Ball speed at launch, m/s.
    speed: f64,
    /// Spin at launch, rad/s.
    spin: f64,
    /// ρ A/(2 m), 1/m. The deceleration by drag is this factor times C_D |v|².
    force_per_mass: f64,
    /// Wind speed, m/s.
    wind: f64,
}

impl DivergedFlight {
    /// Largest step that resolves the flight of any golf ball, s; the default is 10 ms.
    const LARGEST_SAFE_STEP: f64 = 0.05;

    /// Advice for the likeliest cause: a long step, else unusual conditions, else the law.
    fn advice(&self, law: &str) -> String {
        if self.step > Self::LARGEST_SAFE_STEP {
            return "the step is long; reduce flight.step (the default is 10 ms)".into();
        }
        // largest usual values: the record ball speed is below 110 m/s; 2000 rad/s are 19000 rpm;
        // 100 m/s is faster than a hurricane
        let usual_limits = [
            ("the ball leaves at", self.speed, 150.0, "m/s"),
            ("its spin is", self.spin, 2000.0, "rad/s"),
            (
                "air.density · area/(2 ball.mass) is",
                self.force_per_mass,
                0.1,
                "per m (0.018 for a golf ball in air)",
            ),
            ("the wind is", self.wind, 100.0, "m/s"),
        ];
        let unusual: Vec<_> = usual_limits
            .into_iter()
            // NaN is unusual too
            .filter(|(_, value, limit, _)| !(0.0..=*limit).contains(value))
            .map(|(what, value, _, unit)| format!("{what} {} {unit}", significant(value, 3)))
            .collect();
        if unusual.is_empty() {
            return format!(
                "launch, ball and air are usual, so check the coefficients of the law {law}: they may \
                 give a negative drag, or a force that is far too large"
            );
        }
        format!(
            "{}, which is unusual; check it, or let a tolerance choose the step",
            unusual.join(", and ")
        )
    }
}
