use crate::fingerprint::Fingerprint;

/// A fingerprint of the elementary functions that drives use of the C library: they are rounded
/// otherwise by another library, another version, or another processor, for which the library has
/// variants. The same fingerprint stands for the same values at some thousand arguments of each.
pub(super) fn elementary_functions() -> u64 {
    let functions: [fn(f64) -> f64; 6] = [
        f64::sin,
        f64::cos,
        f64::atan,
        f64::exp,
        f64::exp_m1,
        f64::ln,
    ];
    let mut fingerprint = Fingerprint::new();
    for i in 1..=4096 {
        // two turns of a circle, and what logarithms and exponentials are taken of
        let x = f64::from(i) * 3.1e-3;
        functions
            .iter()
            .for_each(|function| fingerprint.add(function(x)));
        fingerprint.add(x.atan2(12.7 - x));
    }
    fingerprint.0
}
