//! Why a row of a table is not used.

/// Why a row is not used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The kind of reason, by which rows are counted: "missing value".
    pub kind: &'static str,
    /// The reason, with the column and the value.
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

    /// Whether the row is a message that is no shot, such as a heartbeat.
    pub fn is_no_shot(&self) -> bool {
        self.kind == Self::NO_BALL
    }

    /// Whether nothing at all can be read from the row.
    pub fn is_unreadable(&self) -> bool {
        [Self::JSON, Self::QUOTE, Self::CELLS, Self::TITLE].contains(&self.kind)
    }

    pub(crate) fn new(kind: &'static str, reason: impl Into<String>) -> Self {
        Self { kind, reason: reason.into() }
    }
}
