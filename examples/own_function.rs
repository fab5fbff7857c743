//! The optimizer without golf: a can of one litre with the least sheet metal, its height limited to 10 cm.
//!
//! `cargo run --release --example own_function`

use longdrive::optimize::{Bounds, Evaluation, Options, minimize};
use num_dual::{DualNum, second_derivative};
use std::f64::consts::PI;

/// Area of a closed can of volume 1 dm³, with the radius that its height leaves it; dm.
fn area<D: DualNum<Primitive = f64> + Copy>(height: D) -> D {
    let radius = (height * PI).recip().sqrt();
    radius * radius * (2.0 * PI) + radius * height * (2.0 * PI)
}

fn main() -> longdrive::Result<()> {
    let problem = |x: &[f64]| {
        let (value, slope, curvature) = second_derivative(area, x[0]);
        Ok(Evaluation { value, gradient: vec![slope], hessian: vec![vec![curvature]] })
    };
    for highest in [f64::INFINITY, 1.0] {
        let bounds = Bounds::new(vec![0.1], vec![highest])?;
        let can = minimize(problem, &bounds, &[0.7], &Options::default())?;
        println!("height up to {highest} dm: {} ({})", can.status, can.message);
        let (height, price) = (can.x[0], can.upper_multipliers[0]);
        if let Some(area) = can.value {
            println!("  height {height:.9} dm, area {area:.9} dm², price of the bound {price:.6} dm² per dm");
        }
    }
    // by hand: the free optimum is as high as wide, h = 2 r = ∛(4/π)
    println!("∛(4/π) = {:.9} dm", (4.0 / PI).cbrt());
    Ok(())
}
