//! Rows that are not read: rows without a shot, and rows that cannot be split into cells.

use super::column::Column;
use super::launch_monitor::words;
use super::numbers::cell_number;
use super::records::only_cell;
use super::refusal::Refusal;
use crate::units::counted;

/// Reason why a row of a table is not read.
pub(crate) enum RowFault<'a> {
    /// A row of an export that summarizes other rows, with the cell that says so, such as
    /// `Average`.
    Summary(&'a str),
    /// A row of an export with a single filled cell, which is a title, such as the name of a club.
    Title(&'a str),
    /// An unclosed quote, fewer cells than column heads, or a filled cell beyond them.
    Unreadable(Refusal),
}

impl<'a> RowFault<'a> {
    /// Classifies a row of an export; `None` for a row that may hold a shot.
    pub fn of_export<S: AsRef<str>>(
        row: &'a [S],
        columns: &[Column],
        labels: &ShotLabels,
    ) -> Option<Self> {
        // `60°` is a value in a column of angles, but the title of a wedge elsewhere
        let is_value = |column: &Column, cell: &str| {
            column.quantity().is_some()
                && cell_number(cell, column.format.has_decimal_comma()).is_some()
        };
        let is_number = |(at, cell): &(usize, &str)| {
            let column = columns.get(*at);
            cell.parse::<f64>().is_ok() || column.is_some_and(|column| is_value(column, cell))
        };
        match only_cell(row).filter(|only| !is_number(only)) {
            Some((_, title)) => Some(Self::Title(title)),
            None => labels.summary(row).map(Self::Summary),
        }
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
            Self::Unreadable(refusal) => refusal,
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
    /// Adds a row without a shot; `row` is its number.
    ///
    /// # Errors
    /// The refusal of an unreadable row, which may hold a shot.
    pub fn add(&mut self, row: u64, fault: RowFault<'_>) -> Result<(), Refusal> {
        let (rows, word) = match fault {
            RowFault::Summary(word) => (&mut self.summaries, word),
            RowFault::Title(word) => (&mut self.titles, word),
            RowFault::Unreadable(refusal) => return Err(refusal),
        };
        rows.push(format!("row {row} ({word})"));
        Ok(())
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

/// Label columns: number of the shot, date, time, player, club. A label that names a statistic,
/// such as `Average`, marks a row that summarizes others. In other columns, such as a rating of the
/// strike, `Average` is a value.
#[derive(Clone, Debug)]
pub(crate) struct ShotLabels(Vec<Option<Label>>);

/// Kind of the cells of a label column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Label {
    /// Numbers, dates or times, or empty cells.
    Number,
    /// Names of players or clubs, or other words.
    Name,
}

/// Words in the heads of columns with names of players and clubs.
const NAME_HEADS: [&str; 20] = [
    "player",
    "players",
    "golfer",
    "golfers",
    "name",
    "club",
    "clubs",
    "spieler",
    "spielername",
    "schläger",
    "schlägername",
    "schlägerart",
    "joueur",
    "nom",
    "jugador",
    "nombre",
    "palo",
    "プレーヤー",
    "プレイヤー",
    "クラブ",
];

/// Last words in the heads of columns with numbers, dates and times of shots.
const NUMBER_HEADS: [&str; 10] = [
    "shot", "no", "nr", "number", "index", "id", "date", "time", "datum", "fecha",
];

/// Names of statistics in English, German, French, Spanish and Japanese.
const STATISTICS: [&str; 33] = [
    "average",
    "averages",
    "avg",
    "mean",
    "median",
    "consistency",
    "deviation",
    "stddev",
    "stdev",
    "ø",
    "σ",
    "durchschnitt",
    "gesamtdurchschnitt",
    "mittelwert",
    "abweichung",
    "standardabweichung",
    "standardabw",
    "moyenne",
    "médiane",
    "écart",
    "promedio",
    "mediana",
    "desviación",
    "平均",
    "平均値",
    "中央値",
    "標準偏差",
    "最大",
    "最大値",
    "最小",
    "最小値",
    "最高",
    "合計",
];

/// Names of statistics that may also be names of players and clubs, such as `Max`. Such a word
/// counts only if all words of the cell are in this list.
const SHORT_STATISTICS: [&str; 23] = [
    "dev",
    "std",
    "standard",
    "sd",
    "max",
    "maximum",
    "min",
    "minimum",
    "best",
    "range",
    "total",
    "sum",
    "mittel",
    "abw",
    "gesamt",
    "summe",
    "beste",
    "media",
    "máximo",
    "mínimo",
    "mejor",
    "meilleur",
    "meilleure",
];

/// Statistics that may also be ratings in a column of words, such as the quality of the strike.
const RATINGS: [&str; 8] = [
    "average",
    "avg",
    "mean",
    "median",
    "durchschnitt",
    "moyenne",
    "promedio",
    "平均",
];

impl ShotLabels {
    /// Finds the label columns by their heads. Left of the measured values, the cells of the first
    /// `rows` may show a label too ([`Label::of_cells`]).
    pub fn find(columns: &[Column], rows: &[Vec<String>]) -> Self {
        let is_measured = |column: &Column| column.quantity().is_some();
        let first = columns.iter().position(is_measured).unwrap_or_default();
        let label = |(at, column): (usize, &Column)| {
            let head = words(&column.head);
            let is_name = || head.split(' ').any(|word| NAME_HEADS.contains(&word));
            let last = head.rsplit(' ').next().unwrap_or_default();
            if is_measured(column) {
                return Some(Label::Number);
            }
            if is_name() {
                return Some(Label::Name);
            }
            if NUMBER_HEADS.contains(&last) {
                return Some(Label::Number);
            }
            if at >= first {
                return None;
            }
            // a row with a single filled cell is a title
            let rows = rows.iter().filter(|row| only_cell(row).is_none());
            let cells: Vec<&str> = rows.map(|row| row[at].as_str()).collect();
            Label::of_cells(&cells, head.is_empty())
        };
        Self(columns.iter().enumerate().map(label).collect())
    }

    /// The cell that names a statistic of other rows; `None` for a row that may hold a shot.
    fn summary<'a, S: AsRef<str>>(&self, row: &'a [S]) -> Option<&'a str> {
        let cells = row.iter().map(AsRef::as_ref).zip(&self.0);
        cells
            .filter_map(|(cell, label)| Some((cell, (*label)?)))
            .find(|(cell, label)| label.is_statistic(cell))
            .map(|(cell, _)| cell)
    }
}

impl Label {
    /// The kind of label in the cells of a column. `None` for a column of values: all its cells are
    /// words, and each name of a statistic among them may also be a rating of the strike. A column
    /// of words without a head has names.
    fn of_cells(cells: &[&str], has_no_head: bool) -> Option<Self> {
        if cells.iter().any(|cell| is_number_or_date(cell)) {
            return Some(Self::Number);
        }
        let is_statistic = |cell: &&&str| Self::Number.is_statistic(cell);
        let (statistics, others): (Vec<&str>, Vec<&str>) = cells.iter().partition(is_statistic);
        let is_number = |cell: &&str| {
            let has_digit = cell.contains(|c: char| c.is_ascii_digit());
            cell.is_empty() || has_digit || NUMBER_HEADS.contains(&words(cell).as_str())
        };
        if !others.is_empty() && others.iter().all(is_number) {
            return Some(Self::Number);
        }
        let is_rating = |cell: &str| {
            let words = words(cell);
            words.split(' ').any(|word| RATINGS.contains(&word))
        };
        let mut statistics = statistics.iter();
        let is_label =
            has_no_head || statistics.any(|cell| Self::Name.is_statistic(cell) && !is_rating(cell));
        is_label.then_some(Self::Name)
    }

    /// True if a cell is the name of a statistic: `Average (12)`, `Driver Average`, `Std. Dev.`,
    /// `Max`. In a column of names, `Max` alone is not: it may be a player.
    fn is_statistic(self, cell: &str) -> bool {
        // fast path for numbers
        if !cell.contains(char::is_alphabetic) {
            return false;
        }
        let words = || {
            cell.split(|c: char| !c.is_alphanumeric())
                .filter(|word| word.contains(char::is_alphabetic))
        };
        let is_in = |known: &[&str], word: &str| {
            let lower = || word.chars().flat_map(char::to_lowercase);
            known.iter().any(|known| lower().eq(known.chars()))
        };
        if words().any(|word| is_in(&STATISTICS, word)) {
            return true;
        }
        let least = match self {
            Self::Number => 1,
            Self::Name => 2,
        };
        words().all(|word| is_in(&SHORT_STATISTICS, word)) && words().count() >= least
    }
}

/// True for a cell with more digits than letters: `12`, `#12`, `Nov 26, 2025`, `10:30 AM`.
fn is_number_or_date(cell: &str) -> bool {
    let digits = cell.chars().filter(char::is_ascii_digit).count();
    digits > cell.chars().filter(|c| c.is_alphabetic()).count()
}

/// Refusal of a row that has fewer cells than `heads`, the number of column heads, or a filled cell
/// beyond them.
pub(super) fn miscounted<S: AsRef<str>>(row: &[S], heads: usize) -> Option<Refusal> {
    let filled = row
        .iter()
        .rposition(|cell| !cell.as_ref().is_empty())
        .map_or(0, |at| at + 1);
    if row.len() >= heads && filled <= heads {
        return None;
    }
    let [row, head] = [row.len(), heads].map(|count| counted(count as u64, "cell"));
    let reason = format!(
        "the row has {row}, but the head has {head}; give every row a cell for each column"
    );
    Some(Refusal::new(Refusal::CELLS, reason))
}
