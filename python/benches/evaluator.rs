//! The fastest time of value and gradient of carry by two parameters with `Evaluator`, in
//! microseconds. `measure.py` compares it with the objective of the Python package.

use longdrive::derivative::{Evaluator, Order};
use longdrive::integration::StepChoice;
use longdrive::{Outcome, Setup};
use std::hint::black_box;
use std::time::Instant;

const NAMES: [&str; 2] = ["club.loft", "swing.attack_angle"];
const CALLS: usize = 500;
/// Number of rounds. They are short, so that other processes disturb only some of them.
const ROUNDS: usize = 200;

fn main() -> longdrive::Result<()> {
    let setup = Setup::preset("tour-average")?;
    let wrt = NAMES
        .iter()
        .map(|name| setup.variable(name))
        .collect::<longdrive::Result<Vec<_>>>()?;
    let of = [Outcome::Carry];
    let integration = StepChoice::default().for_function(&setup, &of, &wrt)?;
    let evaluator = integration.evaluator(&of, &wrt, Order::First)?;
    let start: Vec<f64> = wrt.iter().filter_map(|row| setup.value(row)).collect();
    let mut fastest = f64::INFINITY;
    for _ in 0..ROUNDS {
        fastest = fastest.min(time_of_a_call(&evaluator, &start)?);
    }
    println!("{:.3}", 1e6 * fastest);
    Ok(())
}

/// The mean time of calls at different points, s.
fn time_of_a_call(evaluator: &Evaluator, start: &[f64]) -> longdrive::Result<f64> {
    let began = Instant::now();
    for call in 0..CALLS {
        let point: Vec<f64> = start.iter().map(|x| x + 1e-9 * call as f64).collect();
        black_box(evaluator.at(black_box(&point))?);
    }
    Ok(began.elapsed().as_secs_f64() / CALLS as f64)
}
