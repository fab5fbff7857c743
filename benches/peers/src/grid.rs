//! Task T6: carry and its gradient at each point of a grid of 1000 lofts (0 to 25°) by 1000 attack
//! angles (−10 to 10°), on one thread.

use crate::clock;
use crate::tasks::{Discretization, mae494, two};
use longdrive::batch::{Batch, Block, Grid, GridAxis, Points, Run};
use longdrive::{Outcome, Result};
use std::hint::black_box;

const AXES: [&str; 2] = [
    "club.loft=0deg..25deg:1000",
    "swing.attack_angle=-10deg..10deg:1000",
];
const SIDE: u64 = 1000;
/// Every 25th row of the grid is timed. The check sum has every 25th column of these rows.
const STRIDE: u64 = 25;
/// The rows of the grid for which valgrind counts instructions.
const COUNTED: [u64; 2] = [250, 750];
/// Number of repetitions of a row; the fastest counts.
const REPEATS: usize = 5;
/// Largest duration of the repetitions of a row, s.
const PATIENCE: f64 = 0.1;

fn axes(by: &Discretization) -> Result<Vec<GridAxis>> {
    let setup = mae494(by)?;
    AXES.iter()
        .map(|text| GridAxis::read(&setup, text))
        .collect()
}

/// Carry and its two derivatives in a row of a block; zeros if the ball does not fly.
fn at(block: &Block, row: usize) -> [f64; 3] {
    let mut derivatives = block.derivatives(row).map(Option::unwrap_or_default);
    let carry = block.outcome(row, 0).unwrap_or_default();
    [
        carry,
        derivatives.next().unwrap_or_default(),
        derivatives.next().unwrap_or_default(),
    ]
}

/// Sums of carry + (d carry/d loft + d carry/d attack)/1000 over every 25th row and column.
#[derive(Clone, Copy, Default)]
pub struct Sums {
    pub all: f64,
    /// Sums without the row of loft 0. There the ball does not spin, and the drag has a kink. Carry
    /// then has two one-sided slopes by loft: the peers compute the slope from above, longdrive a
    /// value between both.
    pub spinning: f64,
}

impl Sums {
    fn add(&mut self, block: &Block) {
        for row in 0..block.rows() {
            let number = block.first_row() + row as u64;
            let (i, j) = (number / SIDE, number % SIDE);
            if i.is_multiple_of(STRIDE) && j.is_multiple_of(STRIDE) {
                let [carry, by_loft, by_attack] = at(block, row);
                let term = carry + 1e-3 * (by_loft + by_attack);
                self.all += term;
                self.spinning += if i > 0 { term } else { 0.0 };
            }
        }
    }
}

/// Evaluates rows of the grid: a row is one loft with all attack angles.
pub struct Rows {
    batch: Batch,
    axes: Vec<GridAxis>,
}

impl Rows {
    pub fn new(by: &Discretization) -> Result<Self> {
        let (setup, axes) = (mae494(by)?, axes(by)?);
        let wrt = two(&setup)?;
        Ok(Self {
            batch: Batch::new(&setup, &wrt, &[Outcome::Carry], &wrt)?,
            axes,
        })
    }

    fn evaluate(&self, row: u64) -> Block {
        let loft = self.axes[0].value(row);
        let points = (0..SIDE)
            .flat_map(|column| [loft, self.axes[1].value(column)])
            .collect();
        self.batch.evaluate(row * SIDE, black_box(points))
    }

    /// Computes the rows of `COUNTED` `count` times.
    pub fn repeat(&self, count: u64) {
        for _ in 0..count {
            for row in COUNTED {
                black_box(self.evaluate(row));
            }
        }
    }

    /// Computation time per point of the middle row, s.
    pub fn time_middle(&self) -> f64 {
        clock::fastest(PATIENCE, || self.evaluate(SIDE / 2)) / SIDE as f64
    }

    /// Computation time per point, s, and the check sums, over every 25th row. The fastest of
    /// several repetitions of each row counts.
    pub fn time(&self) -> (f64, Sums) {
        let (mut seconds, mut sums, mut rows) = (0.0, Sums::default(), 0.0);
        for row in (0..SIDE).step_by(STRIDE as usize) {
            let mut best = f64::INFINITY;
            let begun = clock::thread();
            for repeat in 0..REPEATS {
                let start = clock::thread();
                let block = self.evaluate(row);
                best = best.min(clock::thread() - start);
                if repeat == 0 {
                    sums.add(&block);
                } else if clock::thread() - begun > PATIENCE {
                    break;
                }
            }
            seconds += best;
            rows += 1.0;
        }
        (seconds / (rows * SIDE as f64), sums)
    }
}

/// Computation time per point, s, and the check sums, if one call computes the whole grid on one
/// thread.
pub fn whole(by: &Discretization) -> Result<(f64, Sums)> {
    let setup = mae494(by)?;
    let mut grid = Grid::new(axes(by)?)?;
    let run = Run {
        threads: 1,
        ..Run::default()
    };
    let start = clock::process();
    let mut sums = Sums::default();
    let batch = Batch::new(&setup, grid.parameters(), &[Outcome::Carry], &two(&setup)?)?;
    batch.run(
        &mut grid,
        &run,
        |block| block,
        |block| {
            sums.add(&block);
            Ok(())
        },
    )?;
    Ok(((clock::process() - start) / (SIDE * SIDE) as f64, sums))
}

/// The carries at every 25th row and column.
pub fn carries(by: &Discretization) -> Result<Vec<f64>> {
    let (setup, axes) = (mae494(by)?, axes(by)?);
    let batch = Batch::new(&setup, &two(&setup)?, &[Outcome::Carry], &[])?;
    let every = || (0..SIDE).step_by(STRIDE as usize);
    let points = every().flat_map(|i| every().flat_map(move |j| [(i, 0), (j, 1)]));
    let points = points
        .map(|(number, axis)| axes[axis].value(number))
        .collect();
    let block = batch.evaluate(0, points);
    Ok((0..block.rows())
        .map(|row| block.outcome(row, 0).unwrap_or_default())
        .collect())
}
