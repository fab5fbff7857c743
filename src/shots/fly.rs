//! Flies shots in batches.

use super::flown::Flown;
use super::open_connect;
use super::shot::Shot;
use super::source::{Chunk, Section, Shots};
use super::statistics::ShotStatistics;
use crate::batch::{Batch, CHUNK, Run, in_order};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Vary};
use crate::table::{LAUNCH_PARAMETERS, Record};
use std::sync::atomic::{AtomicBool, Ordering};

/// Batch and requested outcomes for flying shots.
#[derive(Clone, Debug)]
pub struct Flying {
    batch: Batch,
    /// True if the setup describes the ground of the shots. Total, run and lateral total are then
    /// compared. False by default.
    pub compares_roll_out: bool,
}

/// Usual ranges of [`LAUNCH_PARAMETERS`]. The integration method and step are chosen for these
/// ranges. The ranges do not depend on the table, so that the prediction for a row does not depend
/// on other rows. A drive outside the ranges has a smaller step if necessary.
const USUAL: [&str; 5] = [
    "60mph..200mph",
    "2deg..35deg",
    "-10deg..10deg",
    "1000rpm..7000rpm",
    "-1500rpm..1500rpm",
];

impl Flying {
    /// Prepares to compute the outcomes `of` of shots with the ball, air and law of the setup.
    /// `other_parameters` are [`Shots::other_parameters`]; they are empty for messages of GSPro
    /// Open Connect.
    ///
    /// # Errors
    /// The errors of [`Batch::new`], [`Error::Nothing`] if there is no outcome, and
    /// [`Error::Unreadable`] if a requested outcome does not belong to the flight.
    pub fn new(
        setup: &Setup<f64>,
        other_parameters: &[&'static Parameter],
        of: &[Outcome],
    ) -> Result<Self> {
        if let Some(of_launch) = of.iter().find(|of| of.group() != OutcomeGroup::Flight) {
            let why = match of_launch.group() {
                OutcomeGroup::Head => {
                    "it is a parameter of the club, but shots are flown from \
                                       their launch"
                }
                _ => "it is a launch condition, which each row states already",
            };
            let source = format!("{why}; name outcomes of the flight");
            return Err(Error::unreadable(of_launch.name(), source));
        }
        let launch = LAUNCH_PARAMETERS.iter().map(|name| setup.parameter(name));
        let mut parameters = launch.collect::<Result<Vec<_>>>()?;
        parameters.extend(other_parameters);
        Ok(Self {
            batch: Batch::new(setup, &parameters, of, &[])?,
            compares_roll_out: false,
        })
    }

    /// Ranges of launches for which the integration method and step are chosen.
    ///
    /// # Errors
    /// The errors of [`Vary::read_column`], which do not occur.
    pub fn usual(setup: &Setup<f64>) -> Result<Vec<Vary>> {
        let usual = LAUNCH_PARAMETERS.iter().zip(USUAL);
        usual
            .map(|(name, range)| Vary::read_column(setup, &format!("{name}={range}")))
            .collect()
    }

    /// Limits the integration error: see [`Batch::with_largest_defect`].
    ///
    /// # Errors
    /// The errors of [`Batch::with_largest_defect`].
    pub fn with_largest_defect(self, defect: f64) -> Result<Self> {
        Ok(Self {
            batch: self.batch.with_largest_defect(defect)?,
            ..self
        })
    }

    /// The requested outcomes.
    pub fn outcomes(&self) -> &[Outcome] {
        self.batch.outcomes()
    }

    /// Flies all shots. `work` processes a chunk on the thread that computed the chunk; `sink`
    /// receives the results of `work` in the order of the rows. An interruption leaves out the rows
    /// of a chunk whose flights it cut short, and all later rows; the statistics say whether they
    /// are complete.
    ///
    /// # Errors
    /// Errors of the source and of `sink`. If the source becomes unreadable, `sink` still receives
    /// all rows before that place.
    pub fn fly<R: Send>(
        &self,
        shots: &mut Shots,
        run: &Run<'_>,
        work: impl Fn(Flown) -> R + Sync,
        mut sink: impl FnMut(R) -> Result<()>,
    ) -> Result<ShotStatistics> {
        let mut statistics = ShotStatistics::new(self.outcomes());
        let Shots {
            rows,
            other_parameters,
            ..
        } = shots;
        let never = AtomicBool::new(false);
        let stop = run.stop.unwrap_or(&never);
        let mut has_ended = false;
        let next = || {
            let Some(chunk) = rows.next_rows(CHUNK)? else {
                has_ended = true;
                return Ok(None);
            };
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            let flying = match &chunk.section {
                Some(section) => self.of_rows(&section.columns.other_parameters)?,
                None => self.of_rows(other_parameters)?,
            };
            Ok(Some((flying, chunk)))
        };
        let work = |(flying, chunk): (Self, Chunk)| {
            let (shots, section) = chunk.shots(other_parameters);
            let flown = flying.flown(shots, section, stop)?;
            let mut statistics = ShotStatistics::new(self.outcomes());
            statistics.add(&flown);
            Some((statistics, work(flown)))
        };
        let mut is_cut = false;
        in_order(run.threads, u64::MAX, next, work, |chunk| {
            // rows after an incomplete chunk are not delivered
            is_cut |= chunk.is_none();
            if let Some((part, result)) = chunk.filter(|_| !is_cut) {
                statistics.merge(part);
                sink(result)?;
            }
            Ok(())
        })?;
        statistics.is_complete = has_ended && !is_cut;
        Ok(statistics)
    }

    /// A copy for rows that state `other_parameters` in addition to the launch.
    fn of_rows(&self, other_parameters: &[&'static Parameter]) -> Result<Self> {
        let launch = &self.batch.parameters()[..LAUNCH_PARAMETERS.len()];
        let batch = self
            .batch
            .with_parameters(&[launch, other_parameters].concat())?;
        Ok(Self { batch, ..*self })
    }

    /// Flies the shot of a message of GSPro Open Connect.
    pub fn message(&self, message: Record) -> Flown {
        let shots = vec![open_connect::shot(message, &[])];
        self.flown(shots, None, &AtomicBool::new(false))
            .unwrap_or_else(|| unreachable!("the flag is never set"))
    }

    /// The flights of shots; `None` if `stop` became true and interrupted a flight.
    fn flown(
        &self,
        shots: Vec<Shot>,
        section: Option<Section>,
        stop: &AtomicBool,
    ) -> Option<Flown> {
        let mut points = vec![];
        let mut flights = Vec::with_capacity(shots.len());
        let mut count = 0;
        for shot in &shots {
            let point = shot.point.as_ref().ok();
            flights.push(point.map(|_| count));
            if let Some(point) = point {
                points.extend_from_slice(point);
                count += 1;
            }
        }
        let block = self.batch.evaluate_until(0, points, stop)?;
        Some(Flown {
            of: self.outcomes().to_vec(),
            shots,
            flights,
            block,
            compares_roll_out: self.compares_roll_out,
            section,
        })
    }
}
