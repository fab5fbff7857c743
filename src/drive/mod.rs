//! One drive, from the setup to its outcomes: impact, launch, flight, landing.

mod flat;
mod launch_state;
mod outcome;

mod validity;
mod warnings;

pub(crate) use flat::flat_landing_angle;
pub use validity::{CheckScope, ExceededCount, ExceededLimits, ExceededShare};
pub(crate) use validity::{any_face, is_outside_any_face};
pub use warnings::Within;

pub(crate) use launch_state::LaunchState;
pub(crate) use outcome::OutcomeInputs;
pub use outcome::{Outcome, OutcomeGroup};

use crate::aerodynamics::AerodynamicLaw;
use crate::atmosphere::AirState;
use crate::error::{Error, Result};
use crate::flight::{Flight, Inputs, Landed};
use crate::impact::{Grip, Head, Impact, strike};
use crate::launch::Launch;
use crate::number::Number;
use crate::parameters::Setup;
use crate::units::significant;

/// A drive: what the impact makes of a setup, and how the ball flies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive<T> {
    /// The ball as it leaves.
    pub launch: Launch<T>,
    /// The impact, with the club after it; `None` where the setup gives the launch and no club
    /// strikes the ball.
    pub impact: Option<Impact<T>>,
    /// The flight.
    pub flight: Flight<T>,
    /// Speed of the head before impact, m/s, where there is a club.
    pub club_speed: Option<T>,
    /// The head with its movable weights, where there is a club.
    pub head: Option<Head<T>>,
}

impl<T: Number> Drive<T> {
    /// Hits and flies. The same code gives values over `f64` and exact derivatives over dual
    /// numbers; the values are not checked against their ranges here ([`Setup::validate`] does),
    /// but for the step, with which a flight might never end. Method and step of the integration
    /// are those of the setup: [`accuracy`](crate::study::accuracy()) finds others for a stated
    /// error.
    ///
    /// ```
    /// use longdrive::{Drive, Outcome, Setup};
    /// // no air, no gravity worth speaking of along the way: a parabola v² sin 2θ/g, by hand
    /// let mut setup = Setup::default();
    /// setup.air.density = 0.0;
    /// let drive = Drive::new(&setup).unwrap();
    /// let [speed, angle, carry] = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Carry].map(|o| o.of(&drive).unwrap());
    /// assert!((carry - speed * speed * (2.0 * angle).sin() / 9.80665).abs() < 1e-9);
    /// ```
    ///
    /// # Errors
    /// [`Error::OffFace`], [`Error::NoStrike`], [`Error::Jammed`], [`Error::Diverged`];
    /// [`Error::OutOfRange`] and [`Error::NotANumber`] as [`fly`](crate::flight::fly). A drive that
    /// does not fly is no error here: see [`Flight`].
    pub fn new(setup: &Setup<T>) -> Result<Self> {
        setup.flight.check_steps()?;
        Self::without_step_check(setup)
    }

    /// The same, however many steps the flight takes.
    ///
    /// # Errors
    /// As [`new`](Self::new), but for the step.
    pub(crate) fn without_step_check(setup: &Setup<T>) -> Result<Self> {
        let fly = |launch: &Launch<T>| Inputs::new(setup, launch, true).fly(None);
        if let Some(launch) = Launch::given(setup) {
            let flight = fly(&launch)?;
            return Ok(Self {
                launch,
                impact: None,
                flight,
                club_speed: None,
                head: None,
            });
        }
        let impact = strike(setup)?;
        let (launch, flight) = (impact.launch, fly(&impact.launch)?);
        let (club_speed, head) = (Some(setup.swing.speed), Some(Head::new(&setup.club)));
        Ok(Self {
            launch,
            impact: Some(impact),
            flight,
            club_speed,
            head,
        })
    }

    /// The landed flight.
    ///
    /// # Errors
    /// [`Error::NoFlight`].
    pub fn landed(&self) -> Result<&Landed<T>> {
        match &self.flight {
            Flight::Landed(landed) => Ok(landed),
            Flight::None(why) => Err(Error::NoFlight {
                reason: why.message(),
            }),
        }
    }
}

/// Spins below this, rad/s, are taken to lie on the corner at zero spin: some hundreds of times the
/// rounding of |ω| there.
const ON_THE_SPIN_CORNER: f64 = 1e-3;

impl Drive<f64> {
    /// Whether the ball leaves without spin: |ω| itself has a corner there, whatever the law makes
    /// of it.
    pub(crate) fn is_without_spin(&self) -> bool {
        self.launch.total_spin() < ON_THE_SPIN_CORNER
    }

    /// Corners of the model that this drive lies on, where derivatives to the two sides differ:
    /// zero spin, and the limit between sticking and slipping.
    pub fn corners(&self, setup: &Setup<f64>) -> Vec<String> {
        let mut corners = Vec::new();
        let spin = self.launch.total_spin();
        let has_air = AirState::of(&setup.air).density > 0.0;
        if self.is_without_spin() && setup.law.has_corner_at_zero_spin() && has_air {
            corners.push(format!(
                "the spin is {} rad/s: with the law {} outcomes have a corner at zero spin, and \
                 derivatives \
                 here lie between those of its two sides",
                significant(spin, 2),
                setup.law.name()
            ));
        }
        if let Some(Grip::Sticks(used) | Grip::Slips(used)) =
            self.impact.as_ref().map(|impact| impact.grip)
            && (used - 1.0).abs() < 1e-9
        {
            corners.push(
                "the contact is at the limit between sticking and slipping: derivatives are those \
                 of one side"
                    .into(),
            );
        }
        corners
    }
}
