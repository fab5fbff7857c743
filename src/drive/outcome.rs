use super::Drive;
use crate::error::{Error, Result};
use crate::flight::{Flight, Landed};
use crate::impact::Head;
use crate::launch::Launch;
use crate::number::{Number, Numbers};
use crate::units::Quantity;
use std::fmt;
use std::str::FromStr;

/// Part of a drive that an outcome describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutcomeGroup {
    /// The launch of the ball.
    Launch,
    /// The flight; undefined if the ball does not fly.
    Flight,
    /// The head with its movable weights.
    Head,
}

/// Quantities that outcomes are computed from.
#[derive(Clone, Copy)]
pub(crate) struct OutcomeInputs<'a, T, Read> {
    pub launch: &'a Launch<T>,
    /// Speed of the head before impact, m/s, if there is a club.
    pub club_speed: Option<T>,
    pub landed: Option<&'a Landed<T>>,
    /// The head, if there is a club and if an outcome of the head is requested.
    pub head: Option<&'a Head<T>>,
    /// Converts a number, for example to its value in one lane. It is only called for the numbers
    /// that an outcome depends on.
    pub read: Read,
}

impl<T: Numbers, U, Read: Fn(T) -> U + Copy> OutcomeInputs<'_, T, Read> {
    #[inline(always)]
    fn launch(&self) -> Launch<U> {
        self.launch.map(self.read)
    }

    #[inline(always)]
    fn club_speed(&self) -> Option<U> {
        self.club_speed.map(self.read)
    }

    #[inline(always)]
    fn landed(&self) -> Option<Landed<U>> {
        Some(self.landed?.map(self.read))
    }

    #[inline(always)]
    fn head(&self) -> Option<Head<U>> {
        Some(self.head?.map(self.read))
    }
}

/// Declares each outcome once: group, name, symbol, quantity, display unit, and formula.
macro_rules! outcomes {
    ($( $(#[doc = $doc:literal])+ $Group:ident $Outcome:ident = $name:literal, $symbol:literal, $quantity:ident in $unit:literal, |$drive:ident| $value:expr; )+) => {
        /// An outcome of a drive.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Outcome {
            $( $(#[doc = $doc])+ #[doc = concat!("\n\n`", $name, "`, symbol ", $symbol, ".")] $Outcome, )+
        }

        impl Outcome {
            /// Outcomes of drives, then outcomes of the head.
            const EVERY: &'static [Self] = &[$( Self::$Outcome ),+];

            /// The part of a drive that the outcome describes.
            pub fn group(self) -> OutcomeGroup {
                match self { $( Self::$Outcome => OutcomeGroup::$Group, )+ }
            }

            /// Name in JSON and on the command line: `carry`.
            pub fn name(self) -> &'static str {
                match self { $( Self::$Outcome => $name, )+ }
            }

            /// Symbol in docs/model.md.
            pub fn symbol(self) -> &'static str {
                match self { $( Self::$Outcome => $symbol, )+ }
            }

            /// One line of documentation.
            pub fn doc(self) -> &'static str {
                match self { $( Self::$Outcome => concat!($($doc),+).trim_ascii(), )+ }
            }

            /// Kind of quantity, with its SI unit.
            pub fn quantity(self) -> Quantity {
                match self { $( Self::$Outcome => Quantity::$quantity, )+ }
            }

            /// Display unit.
            pub fn unit(self) -> &'static str {
                match self { $( Self::$Outcome => $unit, )+ }
            }

            /// The outcome of a drive, SI, over the number type of the drive.
            ///
            /// # Errors
            /// [`Error::NoFlight`] for an outcome of the flight if the ball does not land;
            /// [`Error::Undefined`] for an outcome of the club if the setup gives the launch.
            pub fn of<T: Number>(self, drive: &Drive<T>) -> Result<T> {
                let landed = match &drive.flight {
                    Flight::Landed(landed) => Some(landed),
                    Flight::None(_) => None,
                };
                let (launch, club_speed, head) = (&drive.launch, drive.club_speed, drive.head.as_ref());
                let inputs = OutcomeInputs { launch, club_speed, landed, head, read: |number| number };
                self.evaluate(&inputs).ok_or_else(|| match &drive.flight {
                    Flight::None(why) if self.group() == OutcomeGroup::Flight => Error::NoFlight { reason: why.message() },
                    _ => self.unavailable(),
                })
            }

            /// Error for an outcome that does not exist, although the ball lands.
            pub(crate) fn unavailable(self) -> Error {
                let reason = match self.group() {
                    OutcomeGroup::Launch | OutcomeGroup::Head => "no club strikes the ball: the launch is given",
                    OutcomeGroup::Flight => "the apex and the run of this flight were not computed",
                };
                Error::Undefined { what: self.name().into(), reason: reason.into() }
            }

            /// Evaluates the outcome; `None` if a quantity that it depends on is missing.
            pub(crate) fn evaluate<T: Numbers, U: Number>(self, inputs: &OutcomeInputs<'_, T, impl Fn(T) -> U + Copy>) -> Option<U> {
                match self { $( Self::$Outcome => { let $drive = inputs; Some($value) } )+ }
            }
        }
    };
}

outcomes! {
    /// Distance downrange at landing, along the target line; carry_distance includes the distance
    /// to the side.
    Flight Carry = "carry", "z_L", LENGTH in "yd", |drive| drive.landed()?.carry;
    /// Horizontal distance from the tee to the landing, in any direction: the carry of launch
    /// monitors.
    Flight CarryDistance = "carry_distance", "√(z_L² + y_L²)", LENGTH in "yd", |drive| {
        let landed = drive.landed()?;
        (landed.carry * landed.carry + landed.lateral * landed.lateral).sqrt()
    };
    /// Distance right of the target line at landing.
    Flight Lateral = "lateral", "y_L", LENGTH in "yd", |drive| drive.landed()?.lateral;
    /// Time from launch to landing.
    Flight FlightTime = "flight_time", "t_L", TIME in "s", |drive| drive.landed()?.flight_time;
    /// Greatest height of the flight above the tee.
    Flight ApexHeight = "apex_height", "x_A", LENGTH in "yd", |drive| drive.landed()?.apex?.height;
    /// Time from launch to the apex.
    Flight ApexTime = "apex_time", "t_A", TIME in "s", |drive| drive.landed()?.apex?.time;
    /// Distance downrange of the apex.
    Flight ApexDownrange = "apex_downrange", "z_A", LENGTH in "yd", |drive| drive.landed()?.apex?.downrange;
    /// Angle of the path below horizontal at landing.
    Flight DescentAngle = "descent_angle", "γ_L", ANGLE in "deg", |drive| {
        let v = drive.landed()?.velocity;
        (-v.x).atan2((v.y * v.y + v.z * v.z).sqrt())
    };
    /// Speed at landing.
    Flight LandingSpeed = "landing_speed", "|v_L|", SPEED in "mph", |drive| drive.landed()?.velocity.norm();
    /// Distance downrange where the ball rests, along the target line like carry; uncertain by at
    /// least 10 yd, as the ground is not calibrated.
    Flight Total = "total", "z_R", LENGTH in "yd", |drive| drive.landed()?.rest.as_ref()?.downrange;
    /// Distance from landing to rest (bounces, sliding, rolling), along the target line; uncertain
    /// by at least 10 yd, as the ground is not calibrated.
    Flight Run = "run", "z_R − z_L", LENGTH in "yd", |drive| {
        let landed = drive.landed()?;
        landed.rest.as_ref()?.downrange - landed.carry
    };
    /// Distance right of the target line where the ball rests; the ground is not calibrated.
    Flight LateralTotal = "lateral_total", "y_R", LENGTH in "yd", |drive| drive.landed()?.rest.as_ref()?.right;
    /// Speed of the ball at launch.
    Launch BallSpeed = "ball_speed", "|v_0|", SPEED in "mph", |drive| drive.launch().ball_speed();
    /// Ball speed over club speed.
    Launch SmashFactor = "smash_factor", "|v_0|/V", NUMBER in "", |drive| drive.launch().ball_speed() / drive.club_speed()?;
    /// Angle of the launch above horizontal.
    Launch LaunchAngle = "launch_angle", "γ_0", ANGLE in "deg", |drive| drive.launch().launch_angle();
    /// Horizontal direction of the launch, + right.
    Launch LaunchDirection = "launch_direction", "φ_0", ANGLE in "deg", |drive| drive.launch().launch_direction();
    /// Spin at launch.
    Launch Spin = "spin", "|ω_0|", ANGULAR_VELOCITY in "rpm", |drive| drive.launch().total_spin();
    /// Backspin at launch.
    Launch Backspin = "backspin", "ω_b", ANGULAR_VELOCITY in "rpm", |drive| drive.launch().backspin();
    /// Sidespin at launch, + curves right.
    Launch Sidespin = "sidespin", "ω_s", ANGULAR_VELOCITY in "rpm", |drive| drive.launch().sidespin();
    /// Tilt of the spin axis at launch, + right.
    Launch SpinAxis = "spin_axis", "atan2(ω_s, ω_b)", ANGLE in "deg", |drive| drive.launch().spin_axis();
    /// Mass of the head with its movable weights.
    Head HeadMass = "head_mass", "M", MASS in "g", |drive| drive.head()?.mass;
    /// Moment of inertia of the head with its movable weights about the vertical axis through its
    /// centre of mass, which the Rules of Golf limit.
    Head HeadMoi = "head_moi", "I_xx", INERTIA in "g cm^2", |drive| drive.head()?.inertia[0][0];
    /// First leading minor of the second moments of the head's mass: at least 0 for a rigid body.
    Head HeadMinor1 = "head_minor_1", "S₁", INERTIA in "g cm^2", |drive| drive.head()?.minors()[0];
    /// Second leading minor of the second moments of the head's mass, over their sum: at least 0
    /// for a rigid body.
    Head HeadMinor2 = "head_minor_2", "S₂", INERTIA in "g cm^2", |drive| drive.head()?.minors()[1];
    /// Third leading minor of the second moments of the head's mass, over the square of their sum:
    /// at least 0 for a rigid body.
    Head HeadMinor3 = "head_minor_3", "S₃", INERTIA in "g cm^2", |drive| drive.head()?.minors()[2];
}

impl Outcome {
    /// Outcomes of the head, which do not depend on the swing. [`named`](Self::named) also finds
    /// them.
    pub const OF_HEAD: &'static [Self] = &[
        Self::HeadMass,
        Self::HeadMoi,
        Self::HeadMinor1,
        Self::HeadMinor2,
        Self::HeadMinor3,
    ];

    /// All outcomes of drives; the outcomes of the head are [`OF_HEAD`](Self::OF_HEAD).
    pub const ALL: &'static [Self] = Self::EVERY
        .split_at(Self::EVERY.len() - Self::OF_HEAD.len())
        .0;

    /// Outcomes of the launch, of the flight, or of the head.
    pub fn in_group(group: OutcomeGroup) -> impl Iterator<Item = Self> + Clone {
        Self::EVERY
            .iter()
            .copied()
            .filter(move |outcome| outcome.group() == group)
    }

    /// True if the outcome depends on the apex.
    pub(crate) fn needs_apex(self) -> bool {
        matches!(
            self,
            Self::ApexHeight | Self::ApexTime | Self::ApexDownrange
        )
    }

    /// True if the outcome depends on the run of the ball on the ground after the landing.
    pub fn needs_run(self) -> bool {
        matches!(self, Self::Total | Self::Run | Self::LateralTotal)
    }

    /// Reason for a value that is not finite.
    pub(crate) fn why_undefined(self) -> &'static str {
        if self.needs_run() {
            "the ball does not come to rest: the landing area is too steep (ground.slope, \
             ground.side_slope) for ground.rolling and ground.friction, or falls away more steeply \
             than the ball comes down"
        } else {
            "the direction it measures does not exist (vertical, or without spin)"
        }
    }

    /// The outcome of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn named(name: &str) -> Result<Self> {
        Self::EVERY
            .iter()
            .copied()
            .find(|outcome| outcome.name() == name)
            .ok_or_else(|| {
                let names = Self::EVERY.iter().map(|outcome| outcome.name());
                Error::unknown(
                    "outcome",
                    name,
                    names.clone(),
                    format!("the outcomes are {}", names.collect::<Vec<_>>().join(", ")),
                )
            })
    }

    /// The value of this outcome; `None` for an outcome of the flight without a landing, for an
    /// outcome of the club without a club, and for a value that is not finite, such as an angle
    /// whose direction does not exist (a vertical launch, no spin).
    pub fn value(self, drive: &Drive<f64>) -> Option<f64> {
        self.of(drive).ok().filter(|value| value.is_finite())
    }

    /// True if the outcome is an angle between −180° and 180°, which jumps between these ends.
    fn is_direction(self) -> bool {
        matches!(self, Self::LaunchDirection | Self::SpinAxis)
    }

    /// Unwraps a direction: brings it within half a turn of `reference`, so that differences and
    /// means do not cross the jump from 180° to −180°. Other outcomes are unchanged.
    ///
    /// ```
    /// use longdrive::Outcome;
    /// let (value, reference) = (-179_f64.to_radians(), 179_f64.to_radians());
    /// assert!((Outcome::SpinAxis.unwrap_angle(value, reference).to_degrees() - 181.0).abs() < 1e-12);
    /// assert_eq!(Outcome::Carry.unwrap_angle(-3.0, 3.0), -3.0);
    /// ```
    pub fn unwrap_angle(self, value: f64, reference: f64) -> f64 {
        let turns = ((reference - value) / std::f64::consts::TAU).round();
        if self.is_direction() && turns.is_finite() {
            value + turns * std::f64::consts::TAU
        } else {
            value
        }
    }

    /// The value as text, in the display unit.
    pub fn show(self, value: f64) -> String {
        self.quantity().show(value, self.unit())
    }
}

/// The name: `carry`.
impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
impl schemars::JsonSchema for Outcome {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Outcome".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let names: Vec<_> = Self::EVERY.iter().map(|outcome| outcome.name()).collect();
        schemars::json_schema!({
            "description": "The name of an outcome.",
            "type": "string",
            "enum": names
        })
    }
}

/// Parses a name like [`Outcome::named`].
impl FromStr for Outcome {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        Self::named(name)
    }
}
