//! Effects of parameters on outcomes: the exact Jacobian of three outcomes by every parameter, and
//! a Hessian.
//!
//! `cargo run --release --example derivatives`

use longdrive::derivative::{Order, evaluate, hessian};
use longdrive::units::per;
use longdrive::{Outcome, Setup};

fn main() -> longdrive::Result<()> {
    let setup = Setup::modern_driver();
    let wrt = setup.variables();
    let outcomes = [Outcome::Carry, Outcome::Lateral, Outcome::Backspin];
    let rows = evaluate(&setup, &outcomes, &wrt, Order::First)?;
    for (outcome, row) in outcomes.iter().zip(&rows) {
        println!("{} = {}", outcome.name(), outcome.show(row.value));
        // the five parameters with the largest effect of a change by 1 %
        let effect = |k: usize| (row.gradient[k] * setup.value(wrt[k]).unwrap_or(0.0)).abs();
        let mut order: Vec<usize> = (0..wrt.len()).collect();
        order.sort_by(|a, b| effect(*b).total_cmp(&effect(*a)));
        for &k in order.iter().take(5).filter(|&&k| effect(k) > 0.0) {
            println!(
                "  {:<28} {:>14.6} {}",
                wrt[k].name,
                row.gradient[k],
                per(outcome.quantity().si, wrt[k].quantity.si)
            );
        }
    }

    let pair = setup.variables_named(["club.loft", "swing.attack_angle"])?;
    let carry = hessian(&setup, Outcome::Carry, &pair)?;
    println!(
        "\nHessian of carry by loft and attack angle, m per rad²: {:?}",
        carry.hessian
    );
    Ok(())
}
