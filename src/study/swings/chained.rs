//! Chain rule for g(f), with f a function of several variables.

use crate::number::Taylor;

/// g(f) from g, g′ and g″ at f, with f's derivatives.
pub(super) fn chained(f: &Taylor, [value, slope, bend]: [f64; 3]) -> Taylor {
    let row = |(i, row): (usize, &Vec<f64>)| {
        let entry =
            |(j, second): (usize, &f64)| slope * second + bend * f.gradient[i] * f.gradient[j];
        row.iter().enumerate().map(entry).collect()
    };
    Taylor {
        value,
        gradient: f.gradient.iter().map(|d| slope * d).collect(),
        hessian: f.hessian.iter().enumerate().map(row).collect(),
    }
}
