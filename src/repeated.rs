//! Repeated items in a list.

/// Finds the first item that equals an earlier item. Returns the indices of the earlier item and of
/// the found item; `None` if no item is repeated.
pub(crate) fn first_repeated<T>(all: &[T], is_same: impl Fn(&T, &T) -> bool) -> Option<[usize; 2]> {
    (1..all.len()).find_map(|again| {
        let first = all[..again]
            .iter()
            .position(|earlier| is_same(earlier, &all[again]))?;
        Some([first, again])
    })
}
