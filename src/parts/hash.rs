use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Read};

/// Hexadecimal digits of a finished hash, like the output of `sha256sum`.
pub(super) fn hex(hash: Sha256) -> String {
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// SHA-256 of the first bytes of a file, and of the whole file, in hexadecimal.
pub(super) fn of_file(mut file: File, first: u64) -> io::Result<(String, String)> {
    let mut hash = Sha256::default();
    let mut of_first = None;
    let (mut piece, mut left) = (vec![0; 1 << 20], first);
    loop {
        let most = if left > 0 {
            left.min(piece.len() as u64) as usize
        } else {
            piece.len()
        };
        let read = file.read(&mut piece[..most])?;
        hash.update(&piece[..read]);
        left = left.saturating_sub(read as u64);
        if left == 0 && of_first.is_none() {
            of_first = Some(hex(hash.clone()));
        }
        if read == 0 {
            let all = hex(hash);
            return Ok((of_first.unwrap_or_else(|| all.clone()), all));
        }
    }
}
