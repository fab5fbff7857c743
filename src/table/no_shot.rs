//! Rows of an export that are no shots: sums of others, and titles.

use super::launch_monitor::summary;
use super::refusal::Refusal;
use crate::units::Message;

/// A row that is no shot, with the word that says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoShot<'a> {
    /// It sums up others: `Average`.
    Summary(&'a str),
    /// It has one word alone, such as the name of a club above its shots.
    Title(&'a str),
}

impl<'a> NoShot<'a> {
    /// What a row of an export is that is no shot; `None` for one that may be a shot.
    pub fn of<S: AsRef<str>>(row: &'a [S]) -> Option<Self> {
        if let Some(word) = summary(row.iter().map(AsRef::as_ref)) {
            return Some(Self::Summary(word));
        }
        let mut filled = row.iter().map(AsRef::as_ref).filter(|cell| !cell.is_empty());
        let only = filled.next()?;
        let is_title = filled.next().is_none() && only.parse::<f64>().is_err();
        is_title.then_some(Self::Title(only))
    }

    /// Why it is not used.
    pub fn refusal(self) -> Refusal {
        match self {
            Self::Summary(word) => Refusal::new(Refusal::SUMMARY, format!("the row sums up other rows ({word})")),
            Self::Title(word) => Refusal::new(Refusal::TITLE, format!("the row is a title ({word})")),
        }
    }
}

/// The rows of a table that are no shots.
#[derive(Clone, Debug, Default)]
pub(crate) struct NoShots {
    summaries: Vec<String>,
    titles: Vec<String>,
}

impl NoShots {
    /// Adds a row with its number.
    pub fn add(&mut self, row: u64, no_shot: NoShot<'_>) {
        let (rows, word) = match no_shot {
            NoShot::Summary(word) => (&mut self.summaries, word),
            NoShot::Title(word) => (&mut self.titles, word),
        };
        rows.push(format!("row {row} ({word})"));
    }

    /// What deserves a word about them.
    pub fn told(&self) -> Vec<String> {
        [(&self.summaries, "sum up other rows"), (&self.titles, "are titles")]
            .into_iter()
            .filter(|(rows, _)| !rows.is_empty())
            .map(|(rows, what)| format!("rows left out, since they {what}: {}", rows.join(", ")))
            .collect()
    }

    /// The same as messages.
    pub fn remarks(&self) -> impl Iterator<Item = Message> {
        self.told().into_iter().map(Message::from)
    }
}
