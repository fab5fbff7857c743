//! A batch in the lanes of the vector unit: one drive per lane.

use super::block::{Block, Status};
use super::definition::Batch;
use crate::aerodynamics::{AerodynamicLaw, Fitted};
use crate::drive::{
    ExceededLimits, Outcome, OutcomeGroup, OutcomeInputs, flat_landing_angle, is_outside_any_face,
};
use crate::flight::{Inputs, Landed};
use crate::impact::{Head, LaunchState};
use crate::number::{Derivatives, Lanes, Mask, Number, OverNumbers, Task, inlined, over_drives};
use crate::parameters::{Parameter, Setup};
use std::sync::atomic::AtomicBool;

/// Computes the drives of the flying rows of a block, with derivatives by a few parameters.
pub(super) struct LaneBatch<'a> {
    pub batch: &'a Batch,
    pub block: &'a mut Block,
    /// Parameters of differentiation in this evaluation.
    pub wrt: &'a [&'static Parameter],
    /// Index of `wrt[0]` among all parameters of differentiation of the batch.
    pub first: usize,
    /// Interrupt flag: once true, flights of thousands of steps end early.
    pub stop: &'a AtomicBool,
    /// Rows whose ball flies.
    pub flying: &'a [FlyingRow],
    /// Receives the rows that need scalar evaluation.
    pub scalar_rows: &'a mut Vec<usize>,
}

impl Task for LaneBatch<'_> {
    type Output = ();

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(&mut self) {
        let parameters = self.wrt.len();
        over_drives::<V, _>(self, parameters);
    }
}

/// A row whose ball flies.
pub(super) struct FlyingRow {
    /// Vertical speed at launch, m/s. Flights with similar vertical speeds have similar lengths.
    upward_speed: f64,
    row: usize,
}

impl OverNumbers for LaneBatch<'_> {
    type Output = ();

    /// Computes impact and flight of the rows whose ball flies, and writes the results to the
    /// block. The rows are computed in groups, with one row per lane.
    #[inline(always)]
    fn over<J: Lanes>(&mut self) {
        let batch = self.batch;
        let outputs = Outcome::requested_outputs(&batch.of, true, Some(self.stop));
        let has_head = batch
            .of
            .iter()
            .any(|outcome| outcome.group() == OutcomeGroup::Head);
        let fitted = batch.setup.law.properties().fitted;
        // set the parameters that are not swept; `put_group` sets the swept parameters
        let mut setup = batch.setup.constant::<J>();
        // each parameter of differentiation has the derivative 1 in its direction
        setup.put(
            self.wrt,
            inlined!(|k| {
                let value = batch.setup.value(self.wrt[k]).unwrap_or(f64::NAN);
                seeded_in(J::constant(value), Some(k))
            }),
        );
        let directions: Vec<Option<usize>> = batch
            .parameters
            .iter()
            .map(|parameter| self.wrt.iter().position(|row| row == parameter))
            .collect();
        for group in self.flying.chunks(J::WIDTH) {
            self.put_group(&mut setup, group, &directions);
            let launched = LaunchState::new(&setup);
            let inputs = Inputs::new(&setup, &launched.launch);
            let stream = inputs.launch_stream().variables();
            let head = (has_head && launched.club_speed.is_some())
                .then(|| J::not_inlined(|| Head::new(&setup.club)));
            let flight_result = inputs.integrate(J::Mask::first(group.len()), outputs, None);
            let flown = FlownLanes {
                setup: &setup,
                launched: &launched,
                stream,
                head,
                landed: &flight_result.landed,
            };
            for (lane, &FlyingRow { row, .. }) in group.iter().enumerate() {
                if flight_result.has_landed.holds(lane) {
                    self.write_row(row, &flown, lane, &fitted);
                } else {
                    self.scalar_rows.push(row);
                }
            }
        }
    }
}

/// Partitions the rows by the launch of the ball, before any flight is computed. Rows with a value
/// out of range are omitted.
pub(super) struct LaunchPartition<'a> {
    pub batch: &'a Batch,
    pub block: &'a mut Block,
    /// Receives the rows whose ball flies, sorted by the vertical speed at launch.
    pub flying: &'a mut Vec<FlyingRow>,
    /// Receives the rows that need scalar evaluation.
    pub scalar_rows: &'a mut Vec<usize>,
}

impl Task for LaunchPartition<'_> {
    type Output = ();

    /// Rows whose ball flies go to `flying`. Rows without a valid impact go to `scalar_rows`. A row
    /// whose ball is launched into the ground gets its status here, or goes to `scalar_rows` if an
    /// outcome of the launch is requested.
    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(&mut self) {
        let batch = self.batch;
        let shows_launch = batch
            .of
            .iter()
            .any(|outcome| outcome.group() != OutcomeGroup::Flight);
        let mut setup = batch.setup.constant::<V>();
        let is_in_range = |&row: &usize| {
            batch
                .parameters
                .iter()
                .zip(self.block.point(row))
                .all(|(parameter, value)| parameter.range.contains(*value))
        };
        let rows: Vec<usize> = (0..self.block.rows()).filter(is_in_range).collect();
        for rows in rows.chunks(V::WIDTH) {
            // copies of the last row fill the remaining lanes of the last group
            let row_of = |lane: usize| rows[lane.min(rows.len() - 1)];
            let block = &*self.block;
            setup.put(&batch.parameters, |k| {
                V::with_values(|lane| block.point(row_of(lane))[k])
            });
            let launched = LaunchState::new(&setup);
            for (lane, &row) in rows.iter().enumerate() {
                let (up, ground) = (
                    launched.launch.velocity.x.lane(lane),
                    setup.ground.height.lane(lane),
                );
                if !launched.is_valid.holds(lane) {
                    self.scalar_rows.push(row);
                } else if up > 0.0 || ground < 0.0 {
                    self.flying.push(FlyingRow {
                        upward_speed: up,
                        row,
                    });
                } else if shows_launch {
                    self.scalar_rows.push(row);
                } else {
                    self.block.status[row] = Status::NoFlight;
                }
            }
        }
        // a group takes as long as its longest flight, so it should have flights of similar lengths
        self.flying.sort_unstable_by(|a, b| {
            a.upward_speed
                .total_cmp(&b.upward_speed)
                .then(a.row.cmp(&b.row))
        });
    }
}

impl LaneBatch<'_> {
    /// Sets the swept parameters to the values of a group of rows. `directions` has an entry for
    /// each swept parameter: the direction of its derivative, or `None` if the parameter is not in
    /// `wrt`.
    #[inline(always)]
    fn put_group<J: Lanes>(
        &self,
        setup: &mut Setup<J>,
        group: &[FlyingRow],
        directions: &[Option<usize>],
    ) {
        // copies of the last row fill the remaining lanes of the last group
        let row_of = |lane: usize| group[lane.min(group.len() - 1)].row;
        let block = &*self.block;
        setup.put(
            &self.batch.parameters,
            inlined!(|k| seeded_in(
                J::with_values(|lane| block.point(row_of(lane))[k]),
                directions[k]
            )),
        );
    }

    /// Writes the results of the drive in a lane of `flown`, which has landed. An outcome without a
    /// value stays missing. `fitted` has the ranges of the law.
    #[inline(always)]
    fn write_row<J: Lanes>(
        &mut self,
        row: usize,
        flown: &FlownLanes<'_, J>,
        lane: usize,
        fitted: &Fitted,
    ) {
        let in_lane = inlined!(|number: J| number.lane(lane));
        let launch = flown.launched.launch.map(in_lane);
        let landed = flown.landed.map(in_lane);
        let head = flown
            .head
            .as_ref()
            .map(inlined!(|head: &Head<J>| head.map(in_lane)));
        let drive = OutcomeInputs {
            launch: &launch,
            club_speed: flown.launched.club_speed.map(in_lane),
            landed: Some(&landed),
            head: head.as_ref(),
        };
        self.block.status[row] = Status::Landed;
        self.block.defect[row] = landed.defect.map_or(0.0, Number::re);
        self.block.exceeded[row] = flown.exceeded_limits(lane, &landed, fitted);
        for (i, outcome) in self.batch.of.iter().enumerate() {
            self.write(row, i, outcome.evaluate(&drive));
        }
    }

    /// Writes an outcome and its derivatives; `None` leaves both missing.
    fn write<L: Derivatives>(&mut self, row: usize, outcome: usize, found: Option<L>) {
        let Some(number) = found else { return };
        self.block.outcomes[outcome][row] = number.re();
        for k in 0..self.wrt.len() {
            let column = outcome * self.batch.wrt.len() + self.first + k;
            self.block.derivatives[column][row] = number.first(k);
        }
    }
}

/// Impact and flight of a group of rows, one row per lane.
struct FlownLanes<'a, J: Lanes> {
    setup: &'a Setup<J>,
    launched: &'a LaunchState<J>,
    /// Spin ratio, spin, Reynolds number and airspeed at launch.
    stream: [J; 4],
    /// The head, if there is a club and if an outcome of the head is requested.
    head: Option<Head<J>>,
    landed: &'a Landed<J>,
}

impl<J: Lanes> FlownLanes<'_, J> {
    /// Validity limits that the drive in a lane exceeds. `landed` is its landing.
    #[inline(always)]
    fn exceeded_limits(
        &self,
        lane: usize,
        landed: &Landed<J::Lane>,
        fitted: &Fitted,
    ) -> ExceededLimits {
        let value = inlined!(|number: J| number.lane(lane).re());
        let (strike, ground) = (&self.setup.strike, &self.setup.ground);
        let [spin_ratio, spin, reynolds, air_speed] = self.stream;
        let slopes = [value(ground.slope), value(ground.side_slope)];
        ExceededLimits {
            law: !fitted.contains([
                value(spin_ratio),
                value(spin),
                value(reynolds),
                value(air_speed),
            ]),
            face: self.launched.club_speed.is_some()
                && is_outside_any_face(value(strike.toe), value(strike.high)),
            // without a run there is no flat landing
            flat: flat_landing_angle(slopes, landed).is_some(),
        }
    }
}

/// Seeds `values`: the derivative in `direction` is 1 in all lanes. With `None`, all derivatives
/// are 0.
#[inline(always)]
fn seeded_in<J: Lanes>(values: J, direction: Option<usize>) -> J {
    let changes_in = inlined!(|k: usize| if direction == Some(k) {
        J::Mask::first(J::WIDTH)
    } else {
        J::Mask::none()
    });
    values.seeded(&changes_in, 0)
}
