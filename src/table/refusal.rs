//! Rows that are rejected, and rows that contain no shot.

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

/// A row without a shot, with the word that identifies it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NonShot<'a> {
    /// An average or another statistic of other rows: `Average`.
    Summary(&'a str),
    /// A title with a single filled cell, such as the name of a club above its shots.
    Title(&'a str),
}

impl<'a> NonShot<'a> {
    /// Classifies a row of an export; `None` for a row that may hold a shot.
    pub fn of<S: AsRef<str>>(row: &'a [S]) -> Option<Self> {
        if let Some(word) = summary(row.iter().map(AsRef::as_ref)) {
            return Some(Self::Summary(word));
        }
        let mut filled = row
            .iter()
            .map(AsRef::as_ref)
            .filter(|cell| !cell.is_empty());
        let only = filled.next()?;
        let is_title = filled.next().is_none() && only.parse::<f64>().is_err();
        is_title.then_some(Self::Title(only))
    }

    /// Reason for rejecting the row.
    pub fn refusal(self) -> Refusal {
        match self {
            Self::Summary(word) => Refusal::new(
                Refusal::SUMMARY,
                format!("the row sums up other rows ({word})"),
            ),
            Self::Title(word) => {
                Refusal::new(Refusal::TITLE, format!("the row is a title ({word})"))
            }
        }
    }
}

/// Rows without a shot, by kind.
#[derive(Clone, Debug, Default)]
pub(crate) struct NonShotRows {
    summaries: Vec<String>,
    titles: Vec<String>,
}

impl NonShotRows {
    /// Adds a row by its number.
    pub fn add(&mut self, row: u64, no_shot: NonShot<'_>) {
        let (rows, word) = match no_shot {
            NonShot::Summary(word) => (&mut self.summaries, word),
            NonShot::Title(word) => (&mut self.titles, word),
        };
        rows.push(format!("row {row} ({word})"));
    }

    /// One message per kind of row.
    pub fn messages(&self) -> Vec<String> {
        [
            (&self.summaries, "sum up other rows"),
            (&self.titles, "are titles"),
        ]
        .into_iter()
        .filter(|(rows, _)| !rows.is_empty())
        .map(|(rows, what)| format!("rows left out, since they {what}: {}", rows.join(", ")))
        .collect()
    }
}

/// The word that identifies a statistic of other rows, such as `Average`. Shots contain none of
/// these words.
fn summary<'a>(cells: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    const WORDS: [&str; 17] = [
        "dev",
        "average",
        "averages",
        "avg",
        "mean",
        "median",
        "consistency",
        "std dev",
        "stddev",
        "stdev",
        "standard deviation",
        "deviation",
        "std deviation",
        "durchschnitt",
        "mittelwert",
        "standardabweichung",
        "Ø",
    ];
    let mut cells = cells.map(str::trim);
    // fast path: most cells contain none of the words
    cells.find(|cell| {
        let words = || {
            cell.split(|c: char| c.is_whitespace() || c == '.' || c == ':')
                .filter(|word| !word.is_empty())
        };
        let is = |known: &&str| {
            let mut known = known.split(' ');
            words().all(|word| {
                known
                    .next()
                    .is_some_and(|other| word.eq_ignore_ascii_case(other))
            }) && known.next().is_none()
        };
        let first = cell
            .bytes()
            .find(|byte| !matches!(byte, b'.' | b':' | b' '));
        let begins = |known: &&&str| {
            first.is_some_and(|first| known.as_bytes()[0].eq_ignore_ascii_case(&first))
        };
        WORDS.iter().filter(begins).any(is)
    })
}
