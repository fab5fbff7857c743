//! Repeated items in a list of the user.

/// The places of the first item that an earlier item equals, and of that earlier item, first.
pub(crate) fn first_repeated<T>(all: &[T], is_same: impl Fn(&T, &T) -> bool) -> Option<[usize; 2]> {
    (1..all.len()).find_map(|again| {
        let first = all[..again]
            .iter()
            .position(|earlier| is_same(earlier, &all[again]))?;
        Some([first, again])
    })
}
