//! The optimizer without golf: a can of one litre with the smallest surface, first with any height,
//! then with a height of at most 1 dm.
//!
//! `cargo run --release --example own_function`

use longdrive::number::Number;
use longdrive::optimize::{Domain, Evaluation, Exact, Functions, Options, minimize};
use std::f64::consts::PI;

/// Radius and height of a closed can, dm.
struct Can;

impl Functions for Can {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let (radius, height) = (x[0], x[1]);
        let area = radius * (radius + height) * (2.0 * PI);
        let volume = radius * radius * height * PI;
        Ok(Evaluation {
            objective: area,
            constraints: vec![volume],
        })
    }
}

fn main() -> longdrive::Result<()> {
    for highest in [f64::INFINITY, 1.0] {
        let sizes = Domain::new(vec![0.1, 0.1], vec![10.0, highest])?;
        let litre = sizes.with_constraints(vec![1.0], vec![1.0])?;
        let can = minimize(&Exact(Can), &litre, &[1.0, 0.7], &Options::default())?;
        println!(
            "height up to {highest} dm: {} ({}, {} iterations)",
            can.status, can.message, can.iterations
        );
        if let Some(area) = can.value {
            let (radius, height, price) = (can.x[0], can.x[1], can.upper_multipliers[1]);
            println!("  radius {radius:.9} dm, height {height:.9} dm, area {area:.9} dm²");
            println!(
                "  price of the height limit {price:.6} dm² per dm, of the volume {:.6} dm² per dm³",
                -can.constraints[0].multiplier
            );
        }
    }
    // closed form without a limit of the height: the best cylinder has h = 2 r = ∛(4/π)
    println!("∛(4/π) = {:.9} dm", (4.0 / PI).cbrt());
    Ok(())
}
