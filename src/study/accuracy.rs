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
    /// The largest error found with it, m, of drives with no larger a defect than `largest_defect`.
    pub error: f64,
    /// Drives that were looked at.
    pub drives: usize,
    /// The largest defect of a drive that was looked at and followed closely enough, m: one with a larger defect is beyond that. See
    /// [`Batch::with_largest_defect`].
    pub largest_defect: f64,
}

impl Accuracy {
    /// The setup, integrated like this.
    pub fn applied_to(&self, setup: &Setup<f64>) -> Setup<f64> {
        integrated(setup, self.step)
    }
}

/// The method of the highest order needs the fewest evaluations of the force for every tolerance that is asked for.
const METHOD: Method = Method::DormandPrince8;
/// The rest of the tolerance is kept for drives between those that are looked at.
const SAFETY: f64 = 0.25;
/// Steps tried, s, each 2^(−1/4) of the one before.
const LONGEST_STEP: f64 = 1.6;
const STEPS: i32 = 36;
/// Steps of the reference flights are at most this part of those that are judged, and no shorter than so many seconds.
const REFERENCE: f64 = 1.0 / 4.0;
const SHORTEST_REFERENCE: f64 = 1e-3;
/// Points within the ranges that are looked at.
const INSIDE: u64 = 64;
/// Of all these drives so many are looked at first: a step that is too long for them is too long for all.
const FIRST: usize = 16;
/// Ends of ranges are combined for so many parameters; of further ones the setup's own value is taken.
const MOST_COMBINED: usize = 4;
/// Where in its last step a ball lands makes a difference, so each drive is flown in a few steps a little shorter too.
const PHASES: u32 = 8;
/// What a row costs that is flown again, by itself, in units of one that is flown beside others: 10 to 15.
const AGAIN: f64 = 15.0;
/// If more than this part of the drives looked at is flown again, a shorter step costs less.
const MOST_AGAIN: f64 = 1.0 / 8.0;
/// Drives that are missed have a defect so many times as large as all others, or the step is too long. With 1 rows of laws that
/// are not smooth are off by 3 µm; with 4 two in 400 000 random ones are off by up to 9 µm, of which 25 has none.
const APART: f64 = 25.0;
/// A defect that says nothing, m: next to no air leaves rounding alone.
const ROUNDING: f64 = 1e-12;

/// The longest step with which every length among some outcomes is within `tolerance` (m) of its exact value, for the setup and for
/// drives at the ends of the ranges and within them. It is fixed beforehand and does not depend on the drive, so that outcomes stay as
/// smooth as they are. Without a length among the outcomes, it is that of carry.
///
/// ```
/// use longdrive::{Outcome, Setup, study::accuracy};
/// let setup = Setup::default();
/// let micrometre = accuracy(&setup, &[], &[Outcome::Carry], 1e-6).unwrap();
/// assert!(micrometre.error < 1e-6 && micrometre.step > setup.flight.step);
/// ```
///
/// # Errors
/// [`Error::Tolerance`] for a tolerance that is not above 0, or that none of the steps down to 4 ms reaches, with the drive that is off most;
/// [`Error::NoFlight`] where none of the drives lands; what [`Batch::new`] refuses.
pub fn accuracy(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], tolerance: f64) -> Result<Accuracy> {
    chosen(setup, ranges, of, tolerance, 0.0)
}

/// The step with which the rows of a sweep cost least, if each row with a defect beyond `largest_defect` is flown again in shorter steps
/// ([`Batch::with_largest_defect`]): then every length of every row is within `tolerance` (m), and a few drives that need short steps do not
/// shorten those of all. Else as [`accuracy`].
///
/// ```
/// use longdrive::{Outcome, Setup, study::{Vary, accuracy, accuracy_of_rows}};
/// let setup = Setup::default();
/// let loft = [Vary::read(&setup, "club.loft=6deg..14deg").unwrap()];
/// let [all, rows] = [accuracy, accuracy_of_rows].map(|choose| choose(&setup, &loft, &[Outcome::Carry], 1e-6).unwrap());
/// assert!(rows.step >= all.step);
/// ```
///
/// # Errors
/// As [`accuracy`].
pub fn accuracy_of_rows(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], tolerance: f64) -> Result<Accuracy> {
    chosen(setup, ranges, of, tolerance, MOST_AGAIN)
}

/// The step that costs least of those that miss no more than a part of the drives looked at.
fn chosen(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], tolerance: f64, most_again: f64) -> Result<Accuracy> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::Tolerance { tolerance, reason: "give a length above 0, for example 1 um".into() });
    }
    let mut sample = Sample::new(setup, ranges, of, most_again)?;
    let mut step = LONGEST_STEP;
    let (mut worst, mut best) = (None, None::<(f64, Accuracy)>);
    for _ in 0..STEPS {
        if best.is_some_and(|(cost, _)| cost * step <= 1.0) {
            break;
        }
        sample.refine(step)?;
        let mut found = sample.look(step, SAFETY * tolerance)?;
        if found.is_ok() && sample.look_at_all()? {
            found = sample.look(step, SAFETY * tolerance)?;
        }
        match found {
            Ok(Found { error, largest_defect, again }) => {
                let cost = (1.0 + AGAIN * again) / step;
                if best.is_none_or(|(least, _)| cost < least) {
                    let drives = sample.landed().count();
                    best = Some((cost, Accuracy { method: METHOD, step, error, drives, largest_defect }));
                }
            }
            Err(drive) => worst = Some(drive),
        }
        step *= 0.5_f64.powf(0.25);
    }
    if let Some((_, found)) = best {
        return Ok(found);
    }
    let drive = worst.map_or_else(String::new, |missed| sample.told(missed));
    let reason = format!(
        "{drive} with method {} in steps of 4 ms; ask for more than that, or set flight.method and flight.step",
        METHOD.name()
    );
    Err(Error::Tolerance { tolerance, reason })
}

/// What was found of a step.
struct Found {
    error: f64,
    largest_defect: f64,
    /// Which part of the drives within the ranges is flown again.
    again: f64,
}

/// A drive that a step does not follow: its row, and the outcome that is off, with its error, m; nothing where it does not land.
type Missed = (usize, Option<(Outcome, f64)>);

/// The drives looked at.
struct Sample {
    setup: Setup<f64>,
    parameters: Vec<&'static Parameter>,
    points: Vec<f64>,
    /// Points that are not looked at yet.
    further: Vec<f64>,
    lengths: Vec<Outcome>,
    /// Which part of them may be missed.
    most_again: f64,
    /// The step of the reference, s, and the drives as it has them.
    reference: f64,
    exact: Block,
}

impl Sample {
    fn new(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], most_again: f64) -> Result<Self> {
        let lengths = of.iter().copied().filter(|of| of.quantity() == Quantity::LENGTH);
        let mut lengths: Vec<_> = lengths.collect();
        if lengths.is_empty() {
            lengths.push(Outcome::Carry);
        }
        // a batch has a parameter at least: one that every setup has
        let own = |parameter: &'static Parameter| {
            let value = setup.value(parameter).unwrap_or_default();
            Vary { parameter, low: value, high: value }
        };
        let still = [own(setup.variable("gravity")?)];
        // of two ranges of one parameter the command itself complains
        let ranges =
            ranges.iter().enumerate().filter(|(i, range)| ranges[..*i].iter().all(|r| r.parameter != range.parameter));
        let ranges: Vec<Vary> = ranges.map(|(_, range)| *range).collect();
        let ranges = if ranges.is_empty() { &still[..] } else { &ranges };
        let parameters: Vec<_> = ranges.iter().map(|range| range.parameter).collect();
        let mut points = points(setup, ranges);
        let further = points.split_off(FIRST * parameters.len());
        let reference = REFERENCE * LONGEST_STEP;
        let exact = flown(setup, reference, &parameters, &lengths, points.clone())?;
        Ok(Self { setup: *setup, parameters, points, further, lengths, most_again, reference, exact })
    }

    fn flown(&self, step: f64) -> Result<Block> {
        flown(&self.setup, step, &self.parameters, &self.lengths, self.points.clone())
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

    /// The drives that land.
    fn landed(&self) -> impl Iterator<Item = usize> {
        (0..self.exact.rows()).filter(|&row| self.exact.status(row) == Status::Landed)
    }

    /// What a step costs, or the drive by which it misses the limit where it misses too many.
    ///
    /// # Errors
    /// [`Error::NoFlight`] where none of the drives lands.
    fn look(&self, step: f64, limit: f64) -> Result<std::result::Result<Found, Missed>> {
        let diverged = (0..self.exact.rows()).find(|&row| self.exact.status(row) == Status::Diverged);
        match (self.landed().next(), diverged) {
            // perhaps a further one lands
            (None, _) if !self.further.is_empty() => {
                return Ok(Ok(Found { error: 0.0, largest_defect: ROUNDING, again: 0.0 }));
            }
            (None, None) => {
                return Err(Error::NoFlight { reason: "no drive that the step would be chosen for lands".into() });
            }
            // perhaps in shorter steps
            (None, Some(row)) => return Ok(Err((row, None))),
            _ => {}
        }
        // the error and the defect of each drive, largest of all phases and of the first; no number where it is missed
        let (mut errors, mut defects) = (vec![0.0_f64; self.exact.rows()], vec![]);
        let (mut missed, most) = (0, (self.most_again * self.landed().count() as f64) as usize);
        for phase in 0..PHASES {
            let flown = self.flown(step * (1.0 - 0.035 * f64::from(phase)))?;
            for row in self.landed().filter(|&row| errors[row].is_finite()).collect::<Vec<_>>() {
                let worst = self.worst(row, &flown);
                errors[row] = errors[row].max(worst.map_or(f64::INFINITY, |(_, error)| error));
                if errors[row] > limit {
                    errors[row] = f64::INFINITY;
                    missed += 1;
                    if missed > most {
                        return Ok(Err((row, worst)));
                    }
                }
            }
            if phase == 0 {
                defects = (0..flown.rows()).map(|row| flown.defect(row)).collect();
            }
        }
        let is_missed = |row: &usize| errors[*row].is_infinite();
        let of = |row: usize| defects[row].unwrap_or(f64::INFINITY);
        let least_missed = self.landed().filter(is_missed).map(of).fold(f64::INFINITY, f64::min);
        let largest = self.landed().filter(|row| !is_missed(row)).map(of).fold(ROUNDING, f64::max);
        if missed > 0 && largest * APART > least_missed {
            // their defects do not tell them from others
            let row = self.landed().find(is_missed).unwrap_or_default();
            return Ok(Err((row, None)));
        }
        let error = self.landed().filter(|row| !is_missed(row)).map(|row| errors[row]).fold(0.0, f64::max);
        // of the drives within the ranges: few are at their ends. One that is not met among so many may be met yet
        let inside = || self.landed().filter(|row| row + INSIDE as usize >= self.exact.rows());
        let unseen = if missed > 0 { 0.5 } else { 0.0 };
        let again = (inside().filter(is_missed).count() as f64 + unseen) / inside().count().max(1) as f64;
        Ok(Ok(Found { error, largest_defect: largest, again }))
    }

    /// The length of a row that is off most, with its error; `None` where one is missing.
    fn worst(&self, row: usize, flown: &Block) -> Option<(Outcome, f64)> {
        let mut worst = (self.lengths[0], 0.0);
        for (i, of) in self.lengths.iter().enumerate() {
            let (exact, flown) = match (self.exact.outcome(row, i), flown.outcome(row, i)) {
                (Some(exact), Some(flown)) => (exact, flown),
                // a ball that lands and does not come to rest
                (None, None) if of.is_of_the_run() => continue,
                _ => return None,
            };
            let error = (flown - exact).abs();
            if error > worst.1 {
                worst = (*of, error);
            }
        }
        Some(worst)
    }

    /// A drive that is missed, in words.
    fn told(&self, (row, off): Missed) -> String {
        let values = self.parameters.iter().zip(self.exact.point(row));
        let values = values.map(|(parameter, value)| format!("{} = {}", parameter.name, parameter.show(Some(*value))));
        let drive = format!("the drive with {}", values.collect::<Vec<_>>().join(", "));
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
    let mut setup = Setup { method: METHOD, ..*setup };
    setup.flight.step = step;
    setup
}

/// The drives looked at, as values of the ranges' parameters, one after the other.
fn points(setup: &Setup<f64>, ranges: &[Vary]) -> Vec<f64> {
    // a launch that only the points have is taken in its middle
    let middle = |range: &Vary| 0.5 * (range.low + range.high);
    let own: Vec<f64> =
        ranges.iter().map(|range| setup.value(range.parameter).unwrap_or_else(|| middle(range))).collect();
    let mut points = own.clone();
    for corner in 0..1_usize << ranges.len().min(MOST_COMBINED) {
        points.extend(ranges.iter().enumerate().map(|(i, range)| match corner >> i & 1 {
            _ if i >= MOST_COMBINED => own[i],
            0 => range.low,
            _ => range.high,
        }));
    }
    // and within: the shortest flights, in few steps, are seldom at a corner
    for k in 0..INSIDE {
        let at = |(i, range): (usize, &Vary)| range.low + (range.high - range.low) * sobol::coordinate(k, i, 0);
        points.extend(ranges.iter().enumerate().map(at));
    }
    points
}
