//! Method and step of flights: chosen for a tolerance, or stated by the setup.

use super::accuracy::{Accuracy, SAFETY, accuracy_until};
use crate::batch::Batch;
use crate::derivative::{Evaluator, Order, Taylor};
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Vary};
use crate::units::{Message, Quantity};
use std::sync::atomic::AtomicBool;

/// Default tolerance, m.
const MICROMETRE: f64 = 1e-6;

/// Choice of the method and the step of flights.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum StepChoice {
    /// Lengths have errors of at most 1 µm. The method and the step of the setup are kept if the
    /// setup states them ([`Setup::states_step`]), or if no step reaches 1 µm.
    #[default]
    Micrometre,
    /// Lengths have errors of at most this tolerance, m, even if the setup states its method or
    /// step.
    Within(f64),
    /// Method and step of the setup.
    Own,
}

/// A setup with the chosen method and step.
#[derive(Clone, Debug, PartialEq)]
pub struct Integration {
    /// The setup with the chosen method and step.
    pub setup: Setup<f64>,
    /// The chosen method and step with their error; `None` if the setup keeps its own method and
    /// step.
    pub accuracy: Option<Accuracy>,
    /// Largest accepted defect of a drive (docs/model.md, eq. 16a), m. A drive with a larger defect
    /// is repeated with shorter steps. Infinite if the setup's own step is kept.
    pub largest_defect: f64,
    /// A warning if no step meets the default tolerance; otherwise `None`.
    pub warning: Option<Message>,
}

impl StepChoice {
    /// Method and step for the drive of this setup, and its derivatives.
    ///
    /// ```
    /// use longdrive::integration::StepChoice;
    /// use longdrive::{Drive, Setup};
    /// let setup = Setup::preset("tour-average").unwrap();
    /// let carry = |drive: Drive<f64>| drive.landed().unwrap().carry;
    /// let within = StepChoice::default().for_setup(&setup).unwrap();
    /// let error = carry(within.drive().unwrap()) - carry(Drive::new(&setup).unwrap());
    /// assert!(error.abs() < 1e-6);
    /// ```
    ///
    /// # Errors
    /// [`Error::Tolerance`] for a tolerance ≤ 0, or a stated tolerance that no step reaches; the
    /// errors of [`Setup::validate`].
    pub fn for_setup(self, setup: &Setup<f64>) -> Result<Integration> {
        self.for_setup_until(setup, &AtomicBool::new(false))
    }

    /// Like [`for_setup`](Self::for_setup); interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`for_setup`](Self::for_setup); [`Error::Stopped`] after an interrupt.
    pub fn for_setup_until(self, setup: &Setup<f64>, stop: &AtomicBool) -> Result<Integration> {
        setup.validate()?;
        let mut found = self.for_ranges(setup, &[], &of_the_flight(), stop)?;
        // with the limit of `for_ranges`, errors are at most `SAFETY` times the tolerance; the
        // error of a single drive may be as large as the tolerance
        found.largest_defect /= SAFETY;
        Ok(found)
    }

    /// Method and step for outcomes as functions of the parameters `wrt` near the setup's own
    /// values. Each parameter may change by half its value, or by 10°, 5 m/s or 1 cm if this is
    /// more. With more than four parameters, each of them may change less. Farther from the setup,
    /// a drive is repeated with half the step if its defect exceeds the
    /// [limit](Integration::largest_defect).
    ///
    /// ```
    /// use longdrive::derivative::Order;
    /// use longdrive::integration::StepChoice;
    /// use longdrive::{Outcome, Setup};
    /// let setup = Setup::preset("tour-average").unwrap();
    /// let (of, wrt) = ([Outcome::Carry], [setup.variable("club.loft").unwrap()]);
    /// let within = StepChoice::default().for_function(&setup, &of, &wrt).unwrap();
    /// let carry = within.evaluator(&of, &wrt, Order::First).unwrap();
    /// assert!(carry.at(&[0.2]).unwrap()[0].gradient[0] < 0.0);
    /// ```
    ///
    /// # Errors
    /// The errors of [`for_setup`](Self::for_setup) and [`Batch::new`].
    pub fn for_function(
        self,
        setup: &Setup<f64>,
        of: &[Outcome],
        wrt: &[&'static Parameter],
    ) -> Result<Integration> {
        self.for_function_until(setup, of, wrt, &AtomicBool::new(false))
    }

    /// Like [`for_function`](Self::for_function); interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`for_function`](Self::for_function); [`Error::Stopped`] after an interrupt.
    pub fn for_function_until(
        self,
        setup: &Setup<f64>,
        of: &[Outcome],
        wrt: &[&'static Parameter],
        stop: &AtomicBool,
    ) -> Result<Integration> {
        setup.validate()?;
        self.for_ranges(setup, &neighbourhood(setup, wrt), of, stop)
    }

    /// Method and step for many drives with parameters in these ranges. The tolerance applies to
    /// the lengths among the outcomes. Interrupted once `stop` is true.
    ///
    /// # Errors
    /// [`Error::Tolerance`] for a tolerance ≤ 0, or a stated tolerance that no step reaches;
    /// [`Error::Stopped`] after an interrupt; the errors of [`Batch::new`].
    pub fn for_ranges(
        self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
        stop: &AtomicBool,
    ) -> Result<Integration> {
        let Some(tolerance) = self.tolerance(setup) else {
            return Ok(Integration::own(setup, None));
        };
        match accuracy_until(setup, ranges, of, tolerance, stop) {
            Ok(found) => Ok(Integration {
                setup: found.applied_to(setup),
                accuracy: Some(found),
                largest_defect: found.largest_defect,
                warning: None,
            }),
            // no drive lands, so no length exists whose error limits the step
            Err(Error::NoFlight { .. }) => Ok(Integration::own(setup, None)),
            Err(Error::Tolerance { reason, .. }) if self == Self::Micrometre => {
                let warning = format!(
                    "flown with flight.method = {} and flight.step = {} s of the setup, since no \
                     step has errors of at most 1 um: {reason}",
                    setup.method.name(),
                    setup.flight.step
                );
                Ok(Integration::own(setup, Some(warning.into())))
            }
            Err(error) => Err(error),
        }
    }

    /// True if the setup keeps its own method and step. No drives are then computed for a choice.
    pub fn is_own(self, setup: &Setup<f64>) -> bool {
        self.tolerance(setup).is_none()
    }

    /// The tolerance, m, for which method and step are chosen; `None` if the setup keeps its own
    /// method and step.
    fn tolerance(self, setup: &Setup<f64>) -> Option<f64> {
        match self {
            Self::Within(tolerance) => Some(tolerance),
            Self::Micrometre => Some(MICROMETRE).filter(|_| !setup.states_step),
            Self::Own => None,
        }
    }
}

impl Integration {
    fn own(setup: &Setup<f64>, warning: Option<Message>) -> Self {
        Self {
            setup: *setup,
            accuracy: None,
            largest_defect: f64::INFINITY,
            warning,
        }
    }

    /// The drive of the setup.
    ///
    /// # Errors
    /// The errors of [`Drive::new`].
    pub fn drive(&self) -> Result<Drive<f64>> {
        self.drive_until(&AtomicBool::new(false))
    }

    /// Like [`drive`](Self::drive); interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`Drive::until`].
    pub fn drive_until(&self, stop: &AtomicBool) -> Result<Drive<f64>> {
        self.setup.flight.check_steps()?;
        Drive::refined(&mut self.setup.clone(), self.largest_defect, Some(stop))
    }

    /// The warnings of a drive about these outcomes ([`Drive::warnings_about`]); the flights are
    /// interrupted once `stop` is true.
    pub fn warnings_until(
        &self,
        drive: &Drive<f64>,
        of: &[Outcome],
        stop: &AtomicBool,
    ) -> Vec<Message> {
        drive.warnings_until(&self.setup, of, self.accuracy.is_some(), stop)
    }

    /// Outcomes of the setup with their derivatives; interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`evaluate`](crate::derivative::evaluate); [`Error::Stopped`] after an
    /// interrupt.
    pub fn evaluate_until(
        &self,
        of: &[Outcome],
        wrt: &[&'static Parameter],
        order: Order,
        stop: &AtomicBool,
    ) -> Result<Vec<Taylor>> {
        self.evaluator(of, wrt, order)?
            .at_setup(Some(stop), &|_, _| ())
    }

    /// An evaluator of outcomes with derivatives.
    ///
    /// # Errors
    /// The errors of [`Evaluator::new`].
    pub fn evaluator(
        &self,
        of: &[Outcome],
        wrt: &[&'static Parameter],
        order: Order,
    ) -> Result<Evaluator> {
        let evaluator = Evaluator::new(&self.setup, of, wrt, order)?;
        Ok(evaluator.with_largest_defect(self.largest_defect))
    }

    /// A batch of outcomes with derivatives, at points of `parameters`.
    ///
    /// # Errors
    /// The errors of [`Batch::new`].
    pub fn batch(
        &self,
        parameters: &[&'static Parameter],
        of: &[Outcome],
        wrt: &[&'static Parameter],
    ) -> Result<Batch> {
        Batch::new(&self.setup, parameters, of, wrt)?.with_largest_defect(self.largest_defect)
    }
}

/// Ranges around the setup's own values, within the ranges of the parameters. With more than four
/// parameters the ranges are narrower, because most random points would otherwise be far from the
/// setup in several parameters.
pub(crate) fn neighbourhood(setup: &Setup<f64>, wrt: &[&'static Parameter]) -> Vec<Vary> {
    let part = (2.0 / (wrt.len() as f64).sqrt()).min(1.0);
    let around = |parameter: &&'static Parameter| {
        let value = setup.value(parameter)?;
        let least = match parameter.quantity {
            Quantity::ANGLE => 10.0_f64.to_radians(),
            Quantity::SPEED => 5.0,
            Quantity::LENGTH => 0.01,
            _ => 0.0,
        };
        let width = part * (0.5 * value.abs()).max(least);
        let [least, most] = parameter.range.ends();
        let [low, high] = [value - width, value + width].map(|end| end.clamp(least, most));
        Some(Vary {
            parameter,
            low,
            high,
        })
    };
    wrt.iter().filter_map(around).collect()
}

/// All outcomes that do not depend on the run. The error of the run caused by the step is unknown.
pub(crate) fn of_the_flight() -> Vec<Outcome> {
    let all = Outcome::OF_DRIVES.iter().copied();
    all.filter(|outcome| !outcome.needs_run()).collect()
}
