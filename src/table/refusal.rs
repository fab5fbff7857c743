//! Reasons for rejecting rows.

/// Reason for rejecting a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Category for counting, such as "missing value".
    pub kind: &'static str,
    /// Reason with column and value.
    pub reason: String,
}

impl Refusal {
    pub(crate) const MISSING: &'static str = "missing value";
    pub(crate) const UNREADABLE: &'static str = "not a number";
    pub(crate) const RANGE: &'static str = "out of range";
    pub(crate) const SPIN: &'static str = "contradictory spin";
    pub(crate) const SUMMARY: &'static str = "sums up other rows";
    pub(crate) const TITLE: &'static str = "title";
    pub(crate) const CELLS: &'static str = "number of cells";
    pub(crate) const QUOTE: &'static str = "quote not closed";
    pub(crate) const JSON: &'static str = "not JSON";
    pub(crate) const NO_BALL: &'static str = "no ball data";
    pub(crate) const BEFORE: &'static str = "refused before";

    /// True for messages without a shot, such as heartbeats.
    pub fn is_no_shot(&self) -> bool {
        self.kind == Self::NO_BALL
    }

    /// True if the row cannot be split into cells or parsed.
    pub fn is_unreadable(&self) -> bool {
        [Self::JSON, Self::QUOTE, Self::CELLS, Self::TITLE].contains(&self.kind)
    }

    pub(crate) fn new(kind: &'static str, reason: impl Into<String>) -> Self {
        Self {
            kind,
            reason: reason.into(),
        }
    }
}
