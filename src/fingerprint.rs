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
