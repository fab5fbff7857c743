use crate::batch::{Batch, Block, Status};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::{Method, Setup, Vary};
use crate::units::{Quantity, significant};
use std::sync::atomic::{AtomicBool, Ordering};

/// Integration method and step that meet a tolerance on lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// The method.
    pub method: Method,
    /// Step, s.
    pub step: f64,
    /// Largest error of a length in the compared drives, m.
    pub error: f64,
    /// Number of drives compared.
    pub drives: usize,
    /// Largest defect of the integration (docs/model.md, eq. 16a) of the compared drives, m. A
    /// drive with a larger defect may exceed the tolerance. [`Batch::with_largest_defect`] refines
    /// such drives.
    pub largest_defect: f64,
}

impl Accuracy {
    /// The setup with this method and step.
    pub fn applied_to(&self, setup: &Setup<f64>) -> Setup<f64> {
        let method = self.method;
        let mut setup = Setup { method, ..*setup };
        setup.flight.step = self.step;
        setup
    }
}

/// Method for every tolerance: the method of highest order needs the fewest force evaluations.
const METHOD: Method = Method::DormandPrince8;
/// Largest error allowed for the compared drives, as a fraction of the tolerance. Other drives in
/// the ranges, which are not compared, may have larger errors.
pub(super) const SAFETY: f64 = 0.25;
/// Longest trial step, s. Each further trial step is shorter by the factor 2^(−1/4).
const LONGEST_STEP: f64 = 1.6;
/// Number of trial steps.
const STEPS: i32 = 36;
/// Step of the reference flights, relative to the tested step.
const REFERENCE: f64 = 1.0 / 4.0;
/// Shortest step of the reference flights, s.
const SHORTEST_REFERENCE: f64 = 1e-3;
/// Number of sampled points inside the ranges.
const INTERIOR_POINTS: u64 = 64;
/// Number of drives that are tested first. The other drives are tested only with a step that is
/// accurate for the first drives.
const TESTED_FIRST: usize = 16;
/// Drives at the corners of the ranges are tested for this number of parameters: at most 2⁴ drives.
/// In these drives, the other parameters have the values of the setup.
const CORNER_PARAMETERS: usize = 4;
/// Number of steps tested per drive: the step itself and slightly shorter steps, because the error
/// depends on the position of the landing within the last step.
const STEPS_PER_TRIAL: u32 = 8;
/// Difference between a step and the next shorter one of these steps, as a fraction of the longest
/// step. The shortest step is a quarter shorter than the longest step.
const STEP_DIFFERENCE: f64 = 0.035;
/// Smallest value of [`Accuracy::largest_defect`], m. Smaller defects are rounding (for example in
/// a flight almost without air).
const ROUNDING: f64 = 1e-12;

/// The longest trial step for which the error of each tested length is at most a quarter of
/// `tolerance`, m. The tested lengths are those among the outcomes, or carry if there are none. The
/// tested drives are the setup's own, the corners of the first four ranges, and 64 drives inside
/// the ranges. Other drives in the ranges may have larger errors. All drives have this one step, so
/// outcomes stay smooth.
///
/// ```
/// use longdrive::{Outcome, Setup, integration::accuracy};
/// let setup = Setup::modern_driver();
/// let micrometre = accuracy(&setup, &[], &[Outcome::Carry], 1e-6).unwrap();
/// assert!(micrometre.error < 1e-6 && micrometre.step > setup.flight.step);
/// ```
///
/// # Errors
/// [`Error::Tolerance`] if `tolerance` is not positive and finite, or if no step down to 4 ms
/// reaches it (the message names a failing drive); [`Error::NoFlight`] if no drive lands; the
/// errors of [`Batch::new`].
pub fn accuracy(
    setup: &Setup<f64>,
    ranges: &[Vary],
    of: &[Outcome],
    tolerance: f64,
) -> Result<Accuracy> {
    accuracy_until(setup, ranges, of, tolerance, &AtomicBool::new(false))
}

/// Like [`accuracy`]; interrupted once `stop` is true.
///
/// # Errors
/// The errors of [`accuracy`]; [`Error::Stopped`] after an interrupt.
pub(super) fn accuracy_until(
    setup: &Setup<f64>,
    ranges: &[Vary],
    of: &[Outcome],
    tolerance: f64,
    stop: &AtomicBool,
) -> Result<Accuracy> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::Tolerance {
            tolerance,
            reason: "give a length above 0, for example 1 um".into(),
        });
    }
    let mut sample = TestedDrives::new(setup, ranges, of, stop)?;
    let mut step = LONGEST_STEP;
    let mut last_failing = String::new();
    for _ in 0..STEPS {
        sample.refine(step)?;
        let mut found = sample.accuracy(step, SAFETY * tolerance)?;
        if found.is_ok() && sample.test_all()? {
            found = sample.accuracy(step, SAFETY * tolerance)?;
        }
        match found {
            Ok(accuracy) => return Ok(accuracy),
            Err(failing) => last_failing = failing,
        }
        step *= 0.5_f64.powf(0.25);
    }
    let reason =
        format!("{last_failing}; give a larger tolerance, or set flight.method and flight.step");
    Err(Error::Tolerance { tolerance, reason })
}

/// The compared drives with their reference flights.
struct TestedDrives<'s> {
    /// Batch whose outcomes are the tested lengths. Its integration method is [`METHOD`].
    batch: Batch,
    points: Vec<f64>,
    /// Points of the drives that are tested later.
    untested_points: Vec<f64>,
    /// Step of the reference flights, s.
    reference_step: f64,
    /// Results of the reference flights.
    reference: Block,
    /// Interrupt flag.
    stop: &'s AtomicBool,
}

impl<'s> TestedDrives<'s> {
    fn new(
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
        stop: &'s AtomicBool,
    ) -> Result<Self> {
        let lengths = of
            .iter()
            .copied()
            .filter(|of| of.quantity() == Quantity::LENGTH);
        let mut lengths: Vec<_> = lengths.collect();
        if lengths.is_empty() {
            lengths.push(Outcome::Carry);
        }
        // a batch needs at least one parameter: use a parameter that every setup has
        let own = |parameter| {
            let value = setup.value(parameter).unwrap_or_default();
            Vary {
                parameter,
                low: value,
                high: value,
            }
        };
        let still = [own(setup.variable("gravity")?)];
        // ignore duplicate ranges here: the caller reports them
        let ranges = ranges
            .iter()
            .enumerate()
            .filter(|(i, range)| ranges[..*i].iter().all(|r| r.parameter != range.parameter));
        let ranges: Vec<Vary> = ranges.map(|(_, range)| *range).collect();
        let ranges = if ranges.is_empty() {
            &still[..]
        } else {
            &ranges
        };
        let parameters: Vec<_> = ranges.iter().map(|range| range.parameter).collect();
        let mut points = points(setup, ranges);
        let untested_points = points.split_off(points.len().min(TESTED_FIRST * parameters.len()));
        let reference_step = REFERENCE * LONGEST_STEP;
        let mut setup = Setup {
            method: METHOD,
            ..*setup
        };
        setup.flight.step = reference_step;
        let batch = Batch::new(&setup, &parameters, &lengths, &[])?;
        let reference = flown(&batch, points.clone(), stop)?;
        Ok(Self {
            batch,
            points,
            untested_points,
            reference_step,
            reference,
            stop,
        })
    }

    fn flown(&self, step: f64) -> Result<Block> {
        flown(&self.batch.with_step(step)?, self.points.clone(), self.stop)
    }

    /// Repeats the reference flights with a shorter step, if the reference step is too long for a
    /// test of `step`.
    fn refine(&mut self, step: f64) -> Result<()> {
        if self.reference_step > (REFERENCE * step).max(SHORTEST_REFERENCE) {
            // half the longest allowed reference step: the next, shorter trial steps can use the
            // same reference flights
            self.reference_step = (0.5 * REFERENCE * step).max(SHORTEST_REFERENCE);
            self.reference = self.flown(self.reference_step)?;
        }
        Ok(())
    }

    /// Adds the drives that were not tested yet to the sample. Returns false if there are none.
    fn test_all(&mut self) -> Result<bool> {
        if self.untested_points.is_empty() {
            return Ok(false);
        }
        self.points.append(&mut self.untested_points);
        self.reference = self.flown(self.reference_step)?;
        Ok(true)
    }

    /// The accuracy with `step`. If a drive does not land or its error exceeds `limit`, a text
    /// about the first such drive.
    ///
    /// # Errors
    /// [`Error::NoFlight`] if no drive lands.
    fn accuracy(&self, step: f64, limit: f64) -> Result<std::result::Result<Accuracy, String>> {
        let mut found = Accuracy {
            method: METHOD,
            step,
            error: 0.0,
            drives: self.reference.defects().count(),
            largest_defect: ROUNDING,
        };
        let failing = |what: String| {
            let step = significant(1e3 * step, 1);
            Ok(Err(format!(
                "{what} with method {} in steps of {step} ms",
                METHOD.name()
            )))
        };
        let with =
            |status| (0..self.reference.rows()).find(|&row| self.reference.status(row) == status);
        match (with(Status::Landed), with(Status::Diverged)) {
            // no drive lands, but one of the drives that are not tested yet may land
            (None, _) if !self.untested_points.is_empty() => return Ok(Ok(found)),
            (None, None) => {
                return Err(Error::NoFlight {
                    status: "no-flight",
                    reason: "none of the drives lands, so no step can be chosen for them".into(),
                });
            }
            // a shorter step may succeed
            (None, Some(row)) => return failing(format!("{} diverges", self.drive(row))),
            _ => {}
        }
        for shortening in 0..STEPS_PER_TRIAL {
            let flown = self.flown(step * (1.0 - STEP_DIFFERENCE * f64::from(shortening)))?;
            for row in (0..flown.rows()).filter(|&row| self.reference.status(row) == Status::Landed)
            {
                match self.largest_error(&flown, row, limit) {
                    Ok(error) => found.error = found.error.max(error),
                    Err(what) => return failing(what),
                }
            }
            if shortening == 0 {
                found.largest_defect = flown.defects().fold(ROUNDING, f64::max);
            }
        }
        Ok(Ok(found))
    }

    /// The largest error of the lengths of the drive in a row, m.
    ///
    /// # Errors
    /// A text about the drive, if an error exceeds `limit`, or if a length does not exist in the
    /// reference or in `flown`.
    fn largest_error(
        &self,
        flown: &Block,
        row: usize,
        limit: f64,
    ) -> std::result::Result<f64, String> {
        let mut largest = 0.0_f64;
        for (i, of) in self.batch.outcomes().iter().enumerate() {
            let name = of.name();
            let error = match (self.reference.outcome(row, i), flown.outcome(row, i)) {
                (Some(exact), Some(flown)) => (flown - exact).abs(),
                // the ball lands but does not come to rest, so this outcome does not exist
                (None, None) if of.needs_run() => continue,
                _ => {
                    let (drive, status) = (self.drive(row), flown.status(row));
                    return Err(format!("{name} of {drive} is not comparable ({status})"));
                }
            };
            if error > limit {
                let drive = self.drive(row);
                return Err(format!("{name} of {drive} is off by {error:.1e} m"));
            }
            largest = largest.max(error);
        }
        Ok(largest)
    }

    /// The drive of a row, for a message.
    fn drive(&self, row: usize) -> String {
        let values = self
            .batch
            .parameters()
            .iter()
            .zip(self.reference.point(row));
        let values = values.map(|(parameter, value)| {
            format!("{} = {}", parameter.name, parameter.show(Some(*value)))
        });
        match self.reference.rows() {
            1 => "the drive".into(),
            _ => format!("the drive with {}", values.collect::<Vec<_>>().join(", ")),
        }
    }
}

/// Computes the drives of `points`.
///
/// # Errors
/// [`Error::Stopped`] once `stop` is true.
fn flown(batch: &Batch, points: Vec<f64>, stop: &AtomicBool) -> Result<Block> {
    let block = batch.evaluate_until(0, points, stop);
    block
        .filter(|_| !stop.load(Ordering::Relaxed))
        .ok_or(Error::Stopped)
}

/// The points of the drives to compare, one after the other. A point has a value for each range.
fn points(setup: &Setup<f64>, ranges: &[Vary]) -> Vec<f64> {
    // one drive if nothing varies
    if ranges.iter().all(|range| range.low == range.high) {
        return ranges.iter().map(|range| range.low).collect();
    }
    // a parameter without a value in the setup gets the middle of its range
    let middle = |range: &Vary| 0.5 * (range.low + range.high);
    let own: Vec<f64> = ranges
        .iter()
        .map(|range| {
            setup
                .value(range.parameter)
                .unwrap_or_else(|| middle(range))
        })
        .collect();
    let mut points = own.clone();
    for corner in 0..1_usize << ranges.len().min(CORNER_PARAMETERS) {
        points.extend(
            ranges
                .iter()
                .enumerate()
                .map(|(i, range)| match corner >> i & 1 {
                    _ if i >= CORNER_PARAMETERS => own[i],
                    0 => range.low,
                    _ => range.high,
                }),
        );
    }
    // points inside the ranges, because the shortest flights, which have the fewest steps, are
    // rarely at a corner of the ranges
    for k in 0..INTERIOR_POINTS {
        let at = |(i, range): (usize, &Vary)| {
            range.low + (range.high - range.low) * sobol::coordinate(k, i, 0)
        };
        points.extend(ranges.iter().enumerate().map(at));
    }
    points
}

#[cfg(test)]
mod tests {
    use super::Accuracy;
    use crate::parameters::{Method, Setup};

    #[test]
    fn an_accuracy_is_applied_with_its_own_method_and_step() {
        let accuracy = Accuracy {
            method: Method::Rk4,
            step: 0.02,
            error: 0.0,
            drives: 1,
            largest_defect: 1.0,
        };
        let setup = accuracy.applied_to(&Setup::modern_driver());
        assert_eq!((setup.method, setup.flight.step), (Method::Rk4, 0.02));
    }
}
