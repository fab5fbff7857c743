//! Shots flown side by side.

use super::flown::Flown;
use super::objects::Piece;
use super::open_connect;
use super::shot::{LAUNCH, Shot};
use super::source::{Chunk, Shots};
use super::tally::Tally;
use crate::batch::{Batch, CHUNK, Run, in_order};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Vary};
use std::sync::atomic::Ordering;

/// Batch and requested outcomes for flying shots.
#[derive(Clone, Debug)]
pub struct Flying {
    batch: Batch,
    /// The ground is that of the shots: measured runs are compared.
    is_on_their_ground: bool,
}

/// The launches that the method and the step of the flights are chosen for, whatever the table has:
/// a drive beyond them that this step does not follow closely enough is flown in shorter ones. So
/// what is predicted of a row does not depend on the other rows.
const USUAL: [(&str, f64, f64, &str); 5] = [
    ("launch.ball_speed", 60.0, 200.0, "mph"),
    ("launch.launch_angle", 2.0, 35.0, "deg"),
    ("launch.launch_direction", -10.0, 10.0, "deg"),
    ("launch.backspin", 1000.0, 7000.0, "rpm"),
    ("launch.sidespin", -1500.0, 1500.0, "rpm"),
];

impl Flying {
    /// The outcomes of these shots with the setup's ball, air and law.
    ///
    /// # Errors
    /// What [`Batch::new`] refuses; [`Error::Nothing`] without an outcome; [`Error::Unreadable`]
    /// for a launch condition, which the rows give.
    pub fn new(setup: &Setup<f64>, shots: &Shots, of: &[Outcome]) -> Result<Self> {
        Self::with(setup, shots.parameters(), of)
    }

    /// For single messages of GSPro Open Connect.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_messages(setup: &Setup<f64>, of: &[Outcome]) -> Result<Self> {
        let parameters = LAUNCH
            .iter()
            .map(|name| setup.parameter(name))
            .collect::<Result<Vec<_>>>()?;
        Self::with(setup, &parameters, of)
    }

    fn with(setup: &Setup<f64>, parameters: &[&'static Parameter], of: &[Outcome]) -> Result<Self> {
        if let Some(of_launch) = of.iter().find(|of| of.group() != OutcomeGroup::Flight) {
            let why = match of_launch.group() {
                OutcomeGroup::Head => "it is of the club, and no club strikes the balls of shots",
                _ => "it is of the launch, which each row gives",
            };
            let source = format!("{why}; name outcomes of the flight").into();
            return Err(Error::Unreadable {
                name: of_launch.name().into(),
                source,
            });
        }
        Ok(Self {
            batch: Batch::new(setup, parameters, of, &[])?,
            is_on_their_ground: false,
        })
    }

    /// The ranges of the launches that a method and a step are to be chosen for.
    ///
    /// # Errors
    /// [`Error::Unknown`] never: the parameters are there.
    pub fn usual(setup: &Setup<f64>) -> Result<Vec<Vary>> {
        let range = |(name, low, high, unit): &(&str, f64, f64, &str)| {
            let parameter = setup.parameter(name)?;
            let size = parameter.quantity.size_of(unit).unwrap_or(1.0);
            Ok(Vary {
                parameter,
                low: low * size,
                high: high * size,
            })
        };
        USUAL.iter().map(range).collect()
    }

    /// As [`Batch::with_largest_defect`].
    ///
    /// # Errors
    /// As there.
    pub fn with_largest_defect(self, defect: f64) -> Result<Self> {
        Ok(Self {
            batch: self.batch.with_largest_defect(defect)?,
            ..self
        })
    }

    /// Declares the ground as that of the shots: total, run and lateral total are compared.
    #[must_use]
    pub fn on_their_ground(self) -> Self {
        Self {
            is_on_their_ground: true,
            ..self
        }
    }

    /// The outcomes.
    pub fn outcomes(&self) -> &[Outcome] {
        self.batch.outcomes()
    }

    /// Flies all shots. Those of a chunk go through `work` on the thread that computed them, and
    /// what that makes of them to `sink`, in the order of the rows.
    ///
    /// # Errors
    /// Errors of the source and of `sink`; rows before an unreadable place are delivered first.
    pub fn fly<R: Send>(
        &self,
        shots: &mut Shots,
        run: &Run<'_>,
        work: impl Fn(Flown) -> R + Sync,
        mut sink: impl FnMut(R) -> Result<()>,
    ) -> Result<Tally> {
        let mut tally = Tally::new(self.outcomes());
        let Shots {
            rows, parameters, ..
        } = shots;
        let is_stopped = || run.stop.is_some_and(|stop| stop.load(Ordering::Relaxed));
        let next = || {
            if is_stopped() {
                Ok(None)
            } else {
                rows.next_rows(CHUNK)
            }
        };
        let further = &parameters[LAUNCH.len()..];
        let work = |chunk: Chunk| {
            let (shots, section) = chunk.shots(further);
            let flown = self.flown(shots).of_section(section);
            let mut tally = Tally::new(self.outcomes());
            tally.add(&flown);
            (tally, work(flown))
        };
        in_order(run.threads, next, work, |(part, result)| {
            tally.merge(part);
            sink(result)
        })?;
        Ok(tally)
    }

    /// Flies the shot of a message of GSPro Open Connect.
    pub fn message(&self, piece: Piece) -> Flown {
        self.flown(vec![open_connect::shot(piece, &[])])
    }

    fn flown(&self, shots: Vec<Shot>) -> Flown {
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
        let block = self.batch.evaluate(0, points);
        Flown::new(
            self.outcomes(),
            shots,
            flights,
            block,
            self.is_on_their_ground,
        )
    }
}
