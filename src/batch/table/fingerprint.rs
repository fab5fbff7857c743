use crate::batch::points::Points;
use crate::error::Result;

/// A fingerprint of bytes that come piece by piece (FNV-1a, 64 bits): tells a table from another, not from a forgery.
#[derive(Debug)]
pub(super) struct Fingerprint(u64);

impl Fingerprint {
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Reads a table from where it stands to its end: how many rows there are, and the fingerprint of their values.
    pub fn of(table: &mut impl Points) -> Result<(u64, Self)> {
        let mut fingerprint = Self::new();
        let (mut rows, mut values) = (0, vec![]);
        loop {
            match table.read(crate::batch::CHUNK, &mut values)? {
                0 => return Ok((rows, fingerprint)),
                more => rows += more as u64,
            }
            for value in values.drain(..) {
                fingerprint.add(&value.to_bits().to_le_bytes());
            }
        }
    }

    /// What tells a table from any other: the same words for the same rows, whatever format they are in.
    pub fn identity(&self, table: &impl Points) -> String {
        let names: Vec<_> = table.parameters().iter().map(|parameter| parameter.name).collect();
        format!("table of {} rows of {}, fingerprint {:016x}", table.rows(), names.join(" "), self.0)
    }

    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}
