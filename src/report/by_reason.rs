//! Groups names by the reason that they share.

/// Each reason once, after the names that it concerns: "gravity, air.density: the reason". The
/// reasons are in the order in which they first occur.
pub fn by_reason<'a>(reasons: impl IntoIterator<Item = (&'a str, String)>) -> Vec<String> {
    let mut all: Vec<(String, String)> = vec![];
    for (name, reason) in reasons {
        match all.iter_mut().find(|(_, other)| *other == reason) {
            Some((names, _)) => *names += &format!(", {name}"),
            None => all.push((name.into(), reason)),
        }
    }
    all.into_iter()
        .map(|(names, reason)| format!("{names}: {reason}"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::by_reason;

    #[test]
    fn a_reason_is_printed_once_with_all_its_names() {
        let reasons = [("a", "no number"), ("b", "no flight"), ("c", "no number")];
        let lines = by_reason(reasons.map(|(name, reason)| (name, reason.to_owned())));
        assert_eq!(lines, ["a, c: no number", "b: no flight"]);
    }
}
