//! One drive, from the setup to its outcomes: impact, launch, flight, landing.

mod declaration;
mod outcome;
mod outcome_table;
mod validity;
mod warnings;

pub(crate) use declaration::{ComputedFrom, Sign};
pub use declaration::{Instrument, OutcomeGroup};
pub use outcome_table::Outcome;
pub(crate) use outcome_table::OutcomeInputs;
#[cfg(feature = "studies")]
pub(crate) use validity::exceeded_in_flight;
pub use validity::{CheckScope, ExceededCount, ExceededLimits};
pub(crate) use validity::{any_face, flat_landing_angle, is_outside_any_face};
pub use warnings::{FlownRange, carry_with_law_held};

use crate::aerodynamics::AerodynamicLaw;
use crate::atmosphere::AirState;
use crate::error::{Error, Result};
use crate::flight::{Flight, Inputs, Landed, RequestedOutputs};
use crate::impact::{Grip, Impact, strike};
use crate::launch::Launch;
use crate::number::Number;
use crate::parameters::Setup;
use crate::units::significant;
use std::sync::atomic::{AtomicBool, Ordering};

/// A drive: impact, launch and flight of a setup.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive<T> {
    /// Velocity and spin of the ball at launch.
    pub launch: Launch<T>,
    /// The impact; `None` if the setup gives the launch, so that no club strikes the ball.
    pub impact: Option<Impact<T>>,
    /// The flight.
    pub flight: Flight<T>,
}

impl<T: Number> Drive<T> {
    /// Computes the drive of a setup. With `f64` it gives values; with dual numbers it also gives
    /// exact derivatives. Only the step is checked here, because with an invalid step a flight
    /// might never end; [`Setup::validate`] checks all parameters. Method and step of the
    /// integration are those of the setup; [`StepChoice`](crate::integration::StepChoice) chooses
    /// them for an error tolerance.
    ///
    /// ```
    /// use longdrive::{Drive, Outcome, Setup};
    /// // without air: a parabola of range v² sin 2θ/g
    /// let mut setup = Setup::modern_driver();
    /// setup.air.density = 0.0;
    /// let drive = Drive::new(&setup).unwrap();
    /// let outcomes = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Carry];
    /// let [speed, angle, carry] = outcomes.map(|outcome| outcome.of(&drive).unwrap());
    /// assert!((carry - speed * speed * (2.0 * angle).sin() / 9.80665).abs() < 1e-9);
    /// ```
    ///
    /// # Errors
    /// [`Error::OffFace`], [`Error::NoStrike`] and [`Error::Jammed`] as in [`strike`];
    /// [`Error::Diverged`], [`Error::OutOfRange`] and [`Error::NotANumber`] as in
    /// [`fly`](crate::flight::fly). A ball that does not fly is a result, not an error: see
    /// [`Flight`].
    pub fn new(setup: &Setup<T>) -> Result<Self> {
        setup.flight.check_steps()?;
        Self::without_step_check(setup, None)
    }

    /// Like [`new`](Self::new), without the check of the step: the flight may have any number of
    /// steps. It is interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), except the error for the step; [`Error::Stopped`] after an
    /// interrupt.
    pub(crate) fn without_step_check(setup: &Setup<T>, stop: Option<&AtomicBool>) -> Result<Self> {
        let fly =
            |launch: &Launch<T>| Inputs::new(setup, launch).fly(RequestedOutputs::all(stop), None);
        if let Some(launch) = Launch::given(setup) {
            return Ok(Self {
                launch,
                impact: None,
                flight: fly(&launch)?,
            });
        }
        let impact = strike(setup)?;
        Ok(Self {
            launch: impact.launch,
            impact: Some(impact),
            flight: fly(&impact.launch)?,
        })
    }

    /// The landing.
    ///
    /// # Errors
    /// [`Error::NoFlight`] if the ball does not land.
    pub fn landed(&self) -> Result<&Landed<T>> {
        match &self.flight {
            Flight::Landed(landed) => Ok(landed),
            Flight::None(why) => Err((*why).into()),
        }
    }
}

/// Calls `compute`. After [`Error::Diverged`] or [`Error::LargeDefect`], halves the step in `setup`
/// and calls `compute` again, at most [`MAX_HALVINGS`] times. If `largest_defect` is infinite, the
/// step is kept.
///
/// # Errors
/// The errors of `compute`.
pub(crate) fn with_accepted_step<R>(
    setup: &mut Setup<f64>,
    largest_defect: f64,
    mut compute: impl FnMut(&Setup<f64>) -> Result<R>,
) -> Result<R> {
    let mut halvings = if largest_defect.is_finite() {
        MAX_HALVINGS
    } else {
        0
    };
    loop {
        match compute(setup) {
            Err(Error::Diverged { .. } | Error::LargeDefect { .. }) if halvings > 0 => {
                halvings -= 1;
                setup.flight.step *= 0.5;
            }
            found => return found,
        }
    }
}

/// Checks the defect of a flight. `value` returns the value of a number without its derivatives.
/// The message names `step`, s.
///
/// # Errors
/// [`Error::LargeDefect`] for a defect larger than `largest_defect`, m.
#[inline(always)]
pub(crate) fn check_defect<T: Copy>(
    landed: &Landed<T>,
    value: impl Fn(T) -> f64 + Copy,
    largest_defect: f64,
    step: f64,
) -> Result<()> {
    match landed.defect.map(value) {
        Some(defect) if defect > largest_defect => Err(Error::LargeDefect {
            defect,
            limit: largest_defect,
            step,
        }),
        _ => Ok(()),
    }
}

/// A spin at launch below this limit, rad/s, counts as zero spin. At zero spin, |ω| has a corner.
/// The limit is some hundreds of times the rounding error of |ω|.
const ZERO_SPIN_LIMIT: f64 = 1e-3;

/// Maximum number of halvings of the step until the defect of the integration is accepted.
const MAX_HALVINGS: u32 = 12;

impl Drive<f64> {
    /// Like [`new`](Self::new); interrupted if `stop` is true at the start, or becomes true during a
    /// flight of more than 4096 steps.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new); [`Error::Stopped`] after an interrupt.
    pub fn until(setup: &Setup<f64>, stop: &AtomicBool) -> Result<Self> {
        setup.flight.check_steps()?;
        if stop.load(Ordering::Relaxed) {
            return Err(Error::Stopped);
        }
        Self::without_step_check(setup, Some(stop))
    }

    /// Computes the drive, and halves the step in `setup` until the defect of the integration
    /// (docs/model.md, eq. 16a) is at most `largest_defect`, m. If `largest_defect` is infinite,
    /// the step is kept.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new), except the error for the step; [`Error::LargeDefect`]
    /// if the defect is larger even with the shortest step; [`Error::Stopped`] once `stop` is true.
    pub(crate) fn refined(
        setup: &mut Setup<f64>,
        largest_defect: f64,
        stop: Option<&AtomicBool>,
    ) -> Result<Self> {
        with_accepted_step(setup, largest_defect, |setup| {
            let drive = Self::without_step_check(setup, stop)?;
            if let Flight::Landed(landed) = &drive.flight {
                check_defect(landed, |number| number, largest_defect, setup.flight.step)?;
            }
            Ok(drive)
        })
    }

    /// True if the spin at launch is zero. At zero spin, |ω| has a corner.
    pub(crate) fn is_without_spin(&self) -> bool {
        self.launch.total_spin() < ZERO_SPIN_LIMIT
    }

    /// A text for each corner of the model at this drive. At a corner the one-sided derivatives
    /// differ. The corners are zero spin, and the limit between sticking and slipping.
    pub fn corners(&self, setup: &Setup<f64>) -> Vec<String> {
        let mut corners = Vec::new();
        let spin = self.launch.total_spin();
        let has_air = AirState::of(&setup.air).density > 0.0;
        if self.is_without_spin() && setup.law.properties().has_corner_at_zero_spin && has_air {
            corners.push(format!(
                "the spin is {} rad/s: with the law {} outcomes have a corner at zero spin, and \
                 derivatives here lie between the two one-sided derivatives",
                significant(spin, 2),
                setup.law.name()
            ));
        }
        if let Some(Grip::Sticks(used) | Grip::Slips(used)) =
            self.impact.as_ref().map(|impact| impact.grip)
            && (used - 1.0).abs() < 1e-9
        {
            corners.push(
                "the contact is at the limit between sticking and slipping: derivatives are \
                 one-sided"
                    .into(),
            );
        }
        corners
    }
}
