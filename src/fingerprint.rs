/// Hash of a sequence of numbers: FNV-1a, 64 bits, of their little-endian bytes. Not cryptographic.
/// The hash does not depend on machine and compiler, because the journal of a sweep stores it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fingerprint(pub u64);

impl Fingerprint {
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub fn add(&mut self, value: f64) {
        for byte in value.to_bits().to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// Hash, in hexadecimal, of values of the C library's elementary functions that drives use. Their
/// rounding depends on the library, its version and its variant for the processor. Equal hashes
/// mean equal values at some thousand arguments of each function.
#[cfg(any(feature = "commands", feature = "parquet"))]
pub(crate) fn elementary_functions() -> String {
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
        // x up to 12.7 covers two full turns, and common arguments of logarithms and exponentials
        let x = f64::from(i) * 3.1e-3;
        functions
            .iter()
            .for_each(|function| fingerprint.add(function(x)));
        fingerprint.add(x.atan2(12.7 - x));
    }
    format!("{:016x}", fingerprint.0)
}
