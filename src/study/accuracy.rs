use super::Vary;
use crate::batch::{Batch, Block, Status};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::{Method, Parameter, Setup};
use crate::units::Quantity;

/// How drives are to be integrated so that their lengths are within a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// The method.
    pub method: Method,
    /// Its step, s.
    pub step: f64,
    /// The largest error found with it, m.
    pub error: f64,
    /// Drives that were looked at.
    pub drives: usize,
    /// The largest defect of a drive that was looked at, m: one with a larger defect is beyond what
    /// was looked at. See [`Batch::with_largest_defect`].
    pub largest_defect: f64,
}

impl Accuracy {
    /// The setup, integrated like this.
    pub fn applied_to(&self, setup: &Setup<f64>) -> Setup<f64> {
        integrated(setup, self.step)
    }
}

/// The method of the highest order needs the fewest evaluations of the force for every tolerance
/// that is asked for.
const METHOD: Method = Method::DormandPrince8;
/// The rest of the tolerance is kept for drives between those that are looked at.
const SAFETY: f64 = 0.25;
/// Steps tried, s, each 2^(−1/4) of the one before.
const LONGEST_STEP: f64 = 1.6;
const STEPS: i32 = 36;
/// Steps of the reference flights are at most this part of those that are judged, and no shorter
/// than so many seconds.
const REFERENCE: f64 = 1.0 / 4.0;
const SHORTEST_REFERENCE: f64 = 1e-3;
/// Points within the ranges that are looked at.
const INSIDE: u64 = 64;
/// Of all these drives so many are looked at first: a step that is too long for them is too long
/// for all.
const FIRST: usize = 16;
/// Ends of ranges are combined for so many parameters; of further ones the setup's own value is
/// taken.
const MOST_COMBINED: usize = 4;
/// Where in its last step a ball lands makes a difference, so each drive is flown in a few steps a
/// little shorter too.
const PHASES: u32 = 8;
/// A defect that says nothing, m: next to no air leaves rounding alone.
const ROUNDING: f64 = 1e-12;

/// The longest step with which every length among some outcomes is within `tolerance` (m) of its
/// exact value, for the setup and for drives at the ends of the ranges and within them. It is fixed
/// beforehand and does not depend on the drive, so that outcomes stay as smooth as they are.
/// Without a length among the outcomes, it is that of carry.
///
/// ```
/// use longdrive::{Outcome, Setup, study::accuracy};
/// let setup = Setup::default();
/// let micrometre = accuracy(&setup, &[], &[Outcome::Carry], 1e-6).unwrap();
/// assert!(micrometre.error < 1e-6 && micrometre.step > setup.flight.step);
/// ```
///
/// # Errors
/// [`Error::Tolerance`] for a tolerance that is not above 0, or that none of the steps down to 4 ms
/// reaches, with the drive that is off most; [`Error::NoFlight`] where none of the drives lands;
/// what [`Batch::new`] refuses.
pub fn accuracy(
    setup: &Setup<f64>,
    ranges: &[Vary],
    of: &[Outcome],
    tolerance: f64,
) -> Result<Accuracy> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::Tolerance {
            tolerance,
            reason: "give a length above 0, for example 1 um".into(),
        });
    }
    let mut sample = Sample::new(setup, ranges, of)?;
    let mut step = LONGEST_STEP;
    let mut worst = None;
    for _ in 0..STEPS {
        sample.refine(step)?;
        let mut found = sample.largest_error(step, SAFETY * tolerance)?;
        if found.is_ok() && sample.look_at_all()? {
            found = sample.largest_error(step, SAFETY * tolerance)?;
        }
        match found {
            Ok(Found {
                error,
                largest_defect,
            }) => {
                let drives = sample.exact.defects().count();
                return Ok(Accuracy {
                    method: METHOD,
                    step,
                    error,
                    drives,
                    largest_defect,
                });
            }
            Err(drive) => worst = Some(drive),
        }
        step *= 0.5_f64.powf(0.25);
    }
    let drive = worst.map_or_else(String::new, |missed| sample.told(missed));
    let reason = format!(
        "{drive} with method {} in steps of 4 ms; ask for more than that, or set flight.method and \
         flight.step",
        METHOD.name()
    );
    Err(Error::Tolerance { tolerance, reason })
}

/// What was found of a step.
struct Found {
    error: f64,
    largest_defect: f64,
}

/// A drive that a step does not follow: its row, and the outcome that is off, with its error, m;
/// nothing where it does not land.
type Missed = (usize, Option<(Outcome, f64)>);

/// The drives looked at.
struct Sample {
    setup: Setup<f64>,
    parameters: Vec<&'static Parameter>,
    points: Vec<f64>,
    /// Points that are not looked at yet.
    further: Vec<f64>,
    lengths: Vec<Outcome>,
    /// The step of the reference, s, and the drives as it has them.
    reference: f64,
    exact: Block,
}

impl Sample {
    fn new(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome]) -> Result<Self> {
        let lengths = of
            .iter()
            .copied()
            .filter(|of| of.quantity() == Quantity::LENGTH);
        let mut lengths: Vec<_> = lengths.collect();
        if lengths.is_empty() {
            lengths.push(Outcome::Carry);
        }
        // a batch has a parameter at least: one that every setup has
        let own = |parameter: &'static Parameter| {
            let value = setup.value(parameter).unwrap_or_default();
            Vary {
                parameter,
                low: value,
                high: value,
            }
        };
        let still = [own(setup.variable("gravity")?)];
        // of two ranges of one parameter the command itself complains
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
        let further = points.split_off(points.len().min(FIRST * parameters.len()));
        let reference = REFERENCE * LONGEST_STEP;
        let exact = flown(setup, reference, &parameters, &lengths, points.clone())?;
        Ok(Self {
            setup: *setup,
            parameters,
            points,
            further,
            lengths,
            reference,
            exact,
        })
    }

    fn flown(&self, step: f64) -> Result<Block> {
        flown(
            &self.setup,
            step,
            &self.parameters,
            &self.lengths,
            self.points.clone(),
        )
    }

    /// Makes the reference fine enough to judge a step by.
    fn refine(&mut self, step: f64) -> Result<()> {
        if self.reference > (REFERENCE * step).max(SHORTEST_REFERENCE) {
            // for the next steps too
            self.reference = (0.5 * REFERENCE * step).max(SHORTEST_REFERENCE);
            self.exact = self.flown(self.reference)?;
        }
        Ok(())
    }

    /// Looks at the further drives too, from now on. False where there are none.
    fn look_at_all(&mut self) -> Result<bool> {
        if self.further.is_empty() {
            return Ok(false);
        }
        self.points.append(&mut self.further);
        self.exact = self.flown(self.reference)?;
        Ok(true)
    }

    /// The largest error of a step, or the drive by which it misses the limit.
    ///
    /// # Errors
    /// [`Error::NoFlight`] where none of the drives lands.
    fn largest_error(&self, step: f64, limit: f64) -> Result<std::result::Result<Found, Missed>> {
        let with = |status| (0..self.exact.rows()).find(|&row| self.exact.status(row) == status);
        match (with(Status::Landed), with(Status::Diverged)) {
            // perhaps a further one lands
            (None, _) if !self.further.is_empty() => {
                return Ok(Ok(Found {
                    error: 0.0,
                    largest_defect: ROUNDING,
                }));
            }
            (None, None) => {
                return Err(Error::NoFlight {
                    reason: "no drive that the step would be chosen for lands".into(),
                });
            }
            // perhaps in shorter steps
            (None, Some(row)) => return Ok(Err((row, None))),
            _ => {}
        }
        let mut found = Found {
            error: 0.0,
            largest_defect: ROUNDING,
        };
        for phase in 0..PHASES {
            let flown = self.flown(step * (1.0 - 0.035 * f64::from(phase)))?;
            for row in (0..flown.rows()).filter(|&row| self.exact.status(row) == Status::Landed) {
                for (i, of) in self.lengths.iter().enumerate() {
                    let (exact, flown) = match (self.exact.outcome(row, i), flown.outcome(row, i)) {
                        (Some(exact), Some(flown)) => (exact, flown),
                        // a ball that lands and does not come to rest
                        (None, None) if of.needs_run() => continue,
                        _ => return Ok(Err((row, None))),
                    };
                    let error = (flown - exact).abs();
                    if error > limit {
                        return Ok(Err((row, Some((*of, error)))));
                    }
                    found.error = found.error.max(error);
                }
            }
            if phase == 0 {
                found.largest_defect = flown.defects().fold(ROUNDING, f64::max);
            }
        }
        Ok(Ok(found))
    }

    /// A drive that is missed, in words.
    fn told(&self, (row, off): Missed) -> String {
        let values = self.parameters.iter().zip(self.exact.point(row));
        let values = values.map(|(parameter, value)| {
            format!("{} = {}", parameter.name, parameter.show(Some(*value)))
        });
        let drive = match self.exact.rows() {
            1 => "the drive".into(),
            _ => format!("the drive with {}", values.collect::<Vec<_>>().join(", ")),
        };
        match off {
            Some((of, error)) => format!("{} of {drive} is off by {error:.1e} m", of.name()),
            None => format!("{drive} diverges"),
        }
    }
}

fn flown(
    setup: &Setup<f64>,
    step: f64,
    parameters: &[&'static Parameter],
    of: &[Outcome],
    points: Vec<f64>,
) -> Result<Block> {
    Ok(Batch::new(&integrated(setup, step), parameters, of, &[])?.evaluate(0, points))
}

fn integrated(setup: &Setup<f64>, step: f64) -> Setup<f64> {
    let mut setup = Setup {
        method: METHOD,
        ..*setup
    };
    setup.flight.step = step;
    setup
}

/// The drives looked at, as values of the ranges' parameters, one after the other.
fn points(setup: &Setup<f64>, ranges: &[Vary]) -> Vec<f64> {
    // where nothing varies there is one drive
    if ranges.iter().all(|range| range.low == range.high) {
        return ranges.iter().map(|range| range.low).collect();
    }
    // a launch that only the points have is taken in its middle
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
    for corner in 0..1_usize << ranges.len().min(MOST_COMBINED) {
        points.extend(
            ranges
                .iter()
                .enumerate()
                .map(|(i, range)| match corner >> i & 1 {
                    _ if i >= MOST_COMBINED => own[i],
                    0 => range.low,
                    _ => range.high,
                }),
        );
    }
    // and within: the shortest flights, in few steps, are seldom at a corner
    for k in 0..INSIDE {
        let at = |(i, range): (usize, &Vary)| {
            range.low + (range.high - range.low) * sobol::coordinate(k, i, 0)
        };
        points.extend(ranges.iter().enumerate().map(at));
    }
    points
}
