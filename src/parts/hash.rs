use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Read};

/// SHA-256 of a stream of bytes.
#[derive(Clone, Default)]
pub(super) struct Hash(Sha256);

impl Hash {
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// Hexadecimal digits, like the output of `sha256sum`.
    pub fn hex(self) -> String {
        self.0
            .finalize()
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect()
    }

    pub fn of(bytes: &[u8]) -> String {
        let mut hash = Self::default();
        hash.add(bytes);
        hash.hex()
    }

    /// Hashes of the first bytes of a file, and of the whole file.
    pub fn of_file(mut file: File, first: u64) -> io::Result<(String, String)> {
        let mut hash = Self::default();
        let mut of_first = None;
        let (mut piece, mut left) = (vec![0; 1 << 20], first);
        loop {
            let most = if left > 0 {
                left.min(piece.len() as u64) as usize
            } else {
                piece.len()
            };
            let read = file.read(&mut piece[..most])?;
            hash.add(&piece[..read]);
            left = left.saturating_sub(read as u64);
            if left == 0 && of_first.is_none() {
                of_first = Some(hash.clone().hex());
            }
            if read == 0 {
                let all = hash.hex();
                return Ok((of_first.unwrap_or_else(|| all.clone()), all));
            }
        }
    }
}
