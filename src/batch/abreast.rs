//! Drives side by side: one in each lane of the processor's vector unit.

use super::block::{Block, Status};
use super::question::Batch;
use crate::aerodynamics::AerodynamicLaw;
use crate::drive::{
    ExceededLimits, LaunchState, Outcome, OutcomeGroup, OutcomeInputs, flat_landing_angle,
    is_outside_any_face,
};
use crate::flight::{Inputs, RequestedOutputs};
use crate::impact::Head;
use crate::number::{
    Derivatives, Lanes, Mask, Number, OverNumbers, Task, in_lane, inlined, over_drives,
};
use crate::parameters::Parameter;

/// The drives of a block, with derivatives by a few parameters.
pub(super) struct Abreast<'a> {
    pub batch: &'a Batch,
    pub block: &'a mut Block,
    /// The parameters differentiated by, and the place of the first among all.
    pub wrt: &'a [&'static Parameter],
    pub first: usize,
}

impl Task for Abreast<'_> {
    /// The rows that have to be looked at one by one.
    type Output = Vec<usize>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(&mut self) -> Vec<usize> {
        let (mut flying, mut alone) = self.line_up::<V>();
        // flights of about the same length side by side: a group takes as long as its longest
        flying.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let parameters = self.wrt.len();
        let mut flight = Flying {
            drives: self,
            rows: &flying,
            alone: &mut alone,
        };
        over_drives::<V, _>(&mut flight, parameters);
        alone
    }
}

/// Rows that fly, each with its upward speed at launch, and those left to be computed alone.
struct Flying<'a, 'b> {
    drives: &'a mut Abreast<'b>,
    rows: &'a [(f64, usize)],
    alone: &'a mut Vec<usize>,
}

impl OverNumbers for Flying<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn over<J: Lanes<Lane: Derivatives>>(&mut self, _per_lane: usize) {
        self.drives.fly::<J>(self.rows, self.alone);
    }
}

impl Abreast<'_> {
    /// The rows that fly, each with its upward speed at launch, and those that have to be looked at
    /// alone. Those whose ball is launched into the ground get their status here.
    #[inline(always)]
    fn line_up<V: Lanes<Lane = f64>>(&mut self) -> (Vec<(f64, usize)>, Vec<usize>) {
        let batch = self.batch;
        let shows_launch = batch
            .of
            .iter()
            .any(|outcome| outcome.group() != OutcomeGroup::Flight);
        let mut setup = batch.setup.constant::<V>();
        let (mut flying, mut alone) = (vec![], vec![]);
        let is_in_range = |&row: &usize| {
            batch
                .parameters
                .iter()
                .zip(self.block.point(row))
                .all(|(parameter, value)| parameter.range.contains(*value))
        };
        let rows: Vec<usize> = (0..self.block.rows()).filter(is_in_range).collect();
        for rows in rows.chunks(V::WIDTH) {
            // the last group is filled up with copies of its last row
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
                    alone.push(row);
                } else if up > 0.0 || ground < 0.0 {
                    flying.push((up, row));
                } else if shows_launch {
                    alone.push(row);
                } else {
                    self.block.status[row] = Status::NoFlight;
                }
            }
        }
        (flying, alone)
    }

    /// Hits and flies the rows, a group at a time, and writes what it finds into the block.
    #[inline(always)]
    fn fly<J: Lanes<Lane: Derivatives>>(&mut self, rows: &[(f64, usize)], alone: &mut Vec<usize>) {
        let batch = self.batch;
        let any = |is: fn(&Outcome) -> bool| batch.of.iter().any(is);
        let apex = any(|outcome| outcome.needs_apex());
        let has_run = any(|outcome| outcome.needs_run());
        let has_head = any(|outcome| outcome.group() == OutcomeGroup::Head);
        let fitted = batch.setup.law.fitted();
        // the setup with what is the same in every row: the swept parameters are put in for each
        // group
        let mut setup = batch.setup.constant::<J>();
        setup.put(
            self.wrt,
            inlined!(|k| {
                let value = batch.setup.value(self.wrt[k]).unwrap_or(f64::NAN);
                changing(J::constant(value), Some(k))
            }),
        );
        let directions: Vec<Option<usize>> = batch
            .parameters
            .iter()
            .map(|parameter| self.wrt.iter().position(|row| row == parameter))
            .collect();
        for group in rows.chunks(J::WIDTH) {
            // the last group is filled up with copies of its last row
            let row_of = |lane: usize| group[lane.min(group.len() - 1)].1;
            let block = &*self.block;
            setup.put(
                &batch.parameters,
                inlined!(|k| changing(
                    J::with_values(|lane| block.point(row_of(lane))[k]),
                    directions[k]
                )),
            );
            let launched = LaunchState::new(&setup);
            let inputs = Inputs::new(&setup, &launched.launch, has_run);
            let [spin_ratio, spin, reynolds, air_speed] = inputs.stream();
            let (toe, high) = (setup.strike.toe, setup.strike.high);
            let (slope, side_slope) = (setup.ground.slope, setup.ground.side_slope);
            let head = (has_head && launched.club_speed.is_some())
                .then(|| J::outlined(|| Head::new(&setup.club)));
            let ended = inputs.integrate(
                J::Mask::first(group.len()),
                RequestedOutputs { apex, defect: true },
                None,
            );
            for (lane, &(_, row)) in group.iter().enumerate() {
                if !ended.has_landed.holds(lane) {
                    alone.push(row);
                    continue;
                }
                let read = in_lane(lane);
                let (landed, launch, club_speed) =
                    (&ended.landed, &launched.launch, launched.club_speed);
                let drive = OutcomeInputs {
                    launch,
                    club_speed,
                    landed: Some(landed),
                    head: head.as_ref(),
                    read,
                };
                let value = inlined!(|number: J| number.lane(lane).re());
                self.block.status[row] = Status::Landed;
                self.block.defect[row] = landed.defect.map_or(0.0, value);
                self.block.beyond[row] = ExceededLimits {
                    law: !fitted.holds([
                        value(spin_ratio),
                        value(spin),
                        value(reynolds),
                        value(air_speed),
                    ]),
                    face: club_speed.is_some() && is_outside_any_face(value(toe), value(high)),
                    flat: has_run
                        && flat_landing_angle(
                            [value(slope), value(side_slope)],
                            &landed.map(value),
                        )
                        .is_some(),
                };
                for (i, outcome) in batch.of.iter().enumerate() {
                    self.write(row, i, outcome.evaluate(&drive));
                }
            }
        }
    }

    /// Writes an outcome with its derivatives.
    fn write<L: Derivatives>(&mut self, row: usize, outcome: usize, found: Option<L>) {
        let Some(number) = found else { return };
        self.block.outcomes[outcome][row] = number.re();
        for k in 0..self.wrt.len() {
            let column = outcome * self.batch.wrt.len() + self.first + k;
            self.block.derivatives[column][row] = number.first(k);
        }
    }
}

/// Numbers that change in a direction, in each lane.
#[inline(always)]
fn changing<J: Lanes>(values: J, direction: Option<usize>) -> J {
    let changes_in = inlined!(|k: usize| if direction == Some(k) {
        J::Mask::first(J::WIDTH)
    } else {
        J::Mask::none()
    });
    values.seeded(&changes_in, 0)
}
