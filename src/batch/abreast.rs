//! Drives side by side: one in each lane of the processor's vector unit.

use super::block::{Block, Status};
use super::kernel::Kernel;
use crate::aerodynamics::AerodynamicLaw;
use crate::drive::{Beyond, Part, Shown, is_beside_any_face};
use crate::flight::{Pace, Shot, Wanted};
use crate::impact::Unchecked;
use crate::launch::Launch;
use crate::number::{Lanes, Number, Seeded, Task};
use crate::parameters::{Parameter, Setup};
use std::marker::PhantomData;

/// The drives of a block, over lanes `V` of values and lanes `J` of values with derivatives by up to two parameters.
pub(super) struct Abreast<'a, V, J> {
    pub kernel: &'a Kernel,
    pub block: &'a mut Block,
    /// The parameters differentiated by, and the place of the first among all.
    pub wrt: &'a [&'static Parameter],
    pub first: usize,
    pub numbers: PhantomData<(V, J)>,
}

impl<V, J> Task for Abreast<'_, V, J>
where
    V: Lanes<Lane = f64>,
    J: Lanes,
    J::Lane: Seeded,
{
    /// The rows that have to be looked at one by one.
    type Output = Vec<usize>;

    #[inline(always)]
    fn run(mut self) -> Vec<usize> {
        let (mut flying, mut alone) = self.line_up();
        // flights of about the same length side by side: a group takes as long as its longest
        flying.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut setup = self.template();
        for group in flying.chunks(J::WIDTH) {
            self.fly(&mut setup, group, &mut alone);
        }
        alone
    }
}

impl<V, J> Abreast<'_, V, J>
where
    V: Lanes<Lane = f64>,
    J: Lanes,
    J::Lane: Seeded,
{
    /// The rows that fly, each with its upward speed at launch, and those that have to be looked at alone. Those whose ball
    /// is launched into the ground are done with.
    #[inline(always)]
    fn line_up(&mut self) -> (Vec<(f64, usize)>, Vec<usize>) {
        let kernel = self.kernel;
        let shows_launch = kernel.of.iter().any(|outcome| outcome.part() == Part::Launch);
        let mut setup = kernel.setup.map(|_, value| V::from_lanes(|_| value));
        let (mut flying, mut alone) = (vec![], vec![]);
        let rows: Vec<usize> =
            (0..self.block.rows()).filter(|&row| kernel.is_in_range(self.block.point(row))).collect();
        for rows in rows.chunks(V::WIDTH) {
            // the last group is filled up with copies of its last row
            let row_of = |lane: usize| rows[lane.min(rows.len() - 1)];
            let block = &*self.block;
            setup.put(&kernel.parameters, |k| V::from_lanes(|lane| block.point(row_of(lane))[k]));
            let struck = Unchecked::new(&setup);
            let sound = struck.checks().map(V::bits).into_iter().fold(u8::MAX, |all, one| all & one);
            for (lane, &row) in rows.iter().enumerate() {
                let (up, ground) = (struck.launch.velocity.x.lane(lane), setup.ground.height.lane(lane));
                if sound >> lane & 1 == 0 {
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

    /// The setup with what is the same in every row: the swept parameters are still to be put in.
    fn template(&self) -> Setup<J> {
        self.kernel.setup.map(|parameter, value| {
            let direction = self.wrt.iter().position(|row| *row == parameter);
            J::from_lanes(|_| seeded(value, direction))
        })
    }

    /// Hits and flies a group, and writes what it finds into the block.
    #[inline(always)]
    fn fly(&mut self, setup: &mut Setup<J>, group: &[(f64, usize)], alone: &mut Vec<usize>) {
        let kernel = self.kernel;
        let row_of = |lane: usize| group[lane.min(group.len() - 1)].1;
        let block = &*self.block;
        setup.put(&kernel.parameters, |k| {
            let direction = self.wrt.iter().position(|row| *row == kernel.parameters[k]);
            J::from_lanes(|lane| seeded(block.point(row_of(lane))[k], direction))
        });
        let launch = Unchecked::new(setup).launch;
        let shot = Shot::new(setup, &launch);
        let wanted =
            if kernel.of.iter().any(|outcome| outcome.is_of_the_apex()) { Wanted::Apex } else { Wanted::Landing };
        let flying = u8::MAX >> (8 - group.len());
        let (stream, strike) = (shot.stream(), [setup.strike.toe, setup.strike.high]);
        let fitted = AerodynamicLaw::<f64>::fitted(&kernel.setup.law);
        let formation = shot.fly_abreast(&Pace::of(&kernel.setup), wanted, flying);
        for (lane, &(_, row)) in group.iter().enumerate() {
            if formation.sound >> lane & 1 == 0 {
                alone.push(row);
                continue;
            }
            let landed = formation.landed.map(
                #[inline(always)]
                |number| number.lane(lane),
            );
            let launch =
                Launch { velocity: launch.velocity.map(|v| v.lane(lane)), spin: launch.spin.map(|w| w.lane(lane)) };
            let shown =
                Shown { launch: &launch, club_speed: Some(setup.swing.speed.lane(lane)), landed: Some(&landed) };
            self.block.status[row] = Status::Landed;
            let [toe, high] = strike.map(|place| place.lane(lane).re());
            self.block.beyond[row] = Beyond {
                law: !fitted.holds(stream.map(|value| value.lane(lane).re())),
                face: is_beside_any_face(toe, high),
            };
            for (i, outcome) in kernel.of.iter().enumerate() {
                self.write(row, i, outcome.shown(&shown));
            }
        }
    }

    /// Writes an outcome with its derivatives.
    fn write(&mut self, row: usize, outcome: usize, found: Option<J::Lane>) {
        let Some(number) = found else { return };
        self.block.outcomes[outcome][row] = number.re();
        for k in 0..self.wrt.len() {
            let column = outcome * self.kernel.wrt.len() + self.first + k;
            self.block.derivatives[column][row] = number.first(k);
        }
    }
}

fn seeded<T: Seeded>(value: f64, direction: Option<usize>) -> T {
    direction.map_or(T::constant(value), |direction| T::seeded(value, direction))
}
