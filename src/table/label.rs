//! Label columns of an export: which cells name the shot, or a statistic of other rows.

use super::launch_monitor::words;

/// Kind of the cells of a label column: number of the shot, date, time, player, club. A label that
/// names a statistic, such as `Average`, marks a row that summarizes others. In other columns, such
/// as a rating of the strike, `Average` is a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Label {
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

impl Label {
    /// The kind of label that the words of a column head name; `None` for other heads.
    pub fn of_head(words: &str) -> Option<Self> {
        if words.split(' ').any(|word| NAME_HEADS.contains(&word)) {
            return Some(Self::Name);
        }
        let last = words.rsplit(' ').next().unwrap_or_default();
        NUMBER_HEADS.contains(&last).then_some(Self::Number)
    }

    /// The kind of label in the cells of a column. `None` for a column of values: all its cells are
    /// words, and each name of a statistic among them may also be a rating of the strike. A column
    /// of words without a head has names.
    pub fn of_cells(cells: &[&str], has_no_head: bool) -> Option<Self> {
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
    pub fn is_statistic(self, cell: &str) -> bool {
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
