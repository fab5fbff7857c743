//! Functions made of functions, with their derivatives.

use crate::number::Taylor;

/// Σ wₖ fₖ, in the order of the scenarios.
pub(super) fn sum<'a>(terms: impl Iterator<Item = (&'a Taylor, f64)>) -> Taylor {
    let mut all: Option<Taylor> = None;
    for (term, weight) in terms {
        let sum = all.get_or_insert_with(|| Taylor {
            value: 0.0,
            gradient: vec![0.0; term.gradient.len()],
            hessian: vec![vec![0.0; term.gradient.len()]; term.hessian.len()],
        });
        sum.value += weight * term.value;
        sum.gradient.iter_mut().zip(&term.gradient).for_each(|(sum, d)| *sum += weight * d);
        for (sum, row) in sum.hessian.iter_mut().zip(&term.hessian) {
            sum.iter_mut().zip(row).for_each(|(sum, d)| *sum += weight * d);
        }
    }
    all.unwrap_or_default()
}

/// g(f) from g, g′ and g″ at f, with f's derivatives.
pub(super) fn chained(f: &Taylor, [value, slope, bend]: [f64; 3]) -> Taylor {
    let row = |(i, row): (usize, &Vec<f64>)| {
        let entry = |(j, second): (usize, &f64)| slope * second + bend * f.gradient[i] * f.gradient[j];
        row.iter().enumerate().map(entry).collect()
    };
    Taylor {
        value,
        gradient: f.gradient.iter().map(|d| slope * d).collect(),
        hessian: f.hessian.iter().enumerate().map(row).collect(),
    }
}
