//! The layout of a request and of an answer: two lengths, a head in JSON, and a block of bytes.

use crate::refusal::Refusal;
use serde::Serialize;

/// Bytes of a length field.
const LENGTH: usize = 4;

/// A request.
#[derive(Clone, Copy, Debug)]
pub struct Message<'a> {
    /// JSON.
    pub head: &'a [u8],
    /// Numbers, or contents of files.
    pub block: &'a [u8],
}

impl<'a> Message<'a> {
    /// Reads a message.
    ///
    /// # Errors
    /// If the lengths in the message do not add up to its number of bytes.
    pub fn read(bytes: &'a [u8]) -> Result<Self, Refusal> {
        let parts = || {
            let (head, rest) = length(bytes)?;
            let (block, rest) = length(rest)?;
            let is_whole = head.checked_add(block)? == rest.len();
            let (head, block) = rest.split_at_checked(head)?;
            is_whole.then_some(Self { head, block })
        };
        parts().ok_or_else(|| Refusal::of_request("its lengths do not fit its number of bytes"))
    }
}

/// The length at the beginning of `bytes`, and the bytes after it.
fn length(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let (length, rest) = bytes.split_first_chunk::<LENGTH>()?;
    Some((usize::try_from(u32::from_le_bytes(*length)).ok()?, rest))
}

/// The bytes of a message with this head and this block.
pub fn written(head: &impl Serialize, block: &[u8]) -> Vec<u8> {
    // serialization cannot fail: keys are strings
    let head = serde_json::to_vec(head).unwrap_or_default();
    let mut bytes = Vec::with_capacity(2 * LENGTH + head.len() + block.len());
    for part in [&head, block] {
        bytes.extend_from_slice(&u32::try_from(part.len()).unwrap_or(u32::MAX).to_le_bytes());
    }
    bytes.extend_from_slice(&head);
    bytes.extend_from_slice(block);
    bytes
}

/// The bytes of a message with this head, and with these numbers as its block.
pub fn with_numbers(head: &impl Serialize, numbers: &[f64]) -> Vec<u8> {
    let block: Vec<u8> = numbers
        .iter()
        .flat_map(|number| number.to_le_bytes())
        .collect();
    written(head, &block)
}
