//! Parses numbers and units in the spellings of tables, optionally with a side: `4.6° R`,
//! `422 R rpm`, `1.2 D`.

use crate::units::Quantity;

/// A number in a cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CellNumber {
    /// Magnitude if the cell has a side, otherwise the signed value.
    pub number: f64,
    /// Unit after the number.
    pub unit: Option<String>,
    /// Side, in place of a sign.
    pub side: Option<CellSide>,
}

/// A word or letter that replaces the sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CellSide {
    /// Left or right of the target, for right- and left-handed golfers alike.
    OfTarget { is_right: bool },
    /// Up or down.
    UpDown { is_up: bool },
    /// Club path from inside to outside (`I-O`) or the reverse, relative to the golfer.
    InOut { is_in_to_out: bool },
    /// Open or closed face, relative to the golfer.
    OpenClosed { is_open: bool },
}

const IN_TO_OUT: CellSide = CellSide::InOut { is_in_to_out: true };
const OUT_TO_IN: CellSide = CellSide::InOut {
    is_in_to_out: false,
};

/// Spellings of the sides.
const SIDES: [(&str, CellSide); 16] = [
    ("right", CellSide::OfTarget { is_right: true }),
    ("left", CellSide::OfTarget { is_right: false }),
    ("r", CellSide::OfTarget { is_right: true }),
    ("l", CellSide::OfTarget { is_right: false }),
    ("up", CellSide::UpDown { is_up: true }),
    ("down", CellSide::UpDown { is_up: false }),
    ("u", CellSide::UpDown { is_up: true }),
    ("d", CellSide::UpDown { is_up: false }),
    ("i-o", IN_TO_OUT),
    ("o-i", OUT_TO_IN),
    ("in-out", IN_TO_OUT),
    ("out-in", OUT_TO_IN),
    ("open", CellSide::OpenClosed { is_open: true }),
    ("closed", CellSide::OpenClosed { is_open: false }),
    ("o", CellSide::OpenClosed { is_open: true }),
    ("c", CellSide::OpenClosed { is_open: false }),
];

impl CellSide {
    /// Left of the target.
    pub const LEFT: Self = Self::OfTarget { is_right: false };

    fn named(word: &str) -> Option<Self> {
        SIDES
            .iter()
            .find(|(name, _)| word.eq_ignore_ascii_case(name))
            .map(|(_, side)| *side)
    }

    fn opposite(self) -> Self {
        match self {
            Self::OfTarget { is_right } => Self::OfTarget {
                is_right: !is_right,
            },
            Self::UpDown { is_up } => Self::UpDown { is_up: !is_up },
            Self::InOut { is_in_to_out } => Self::InOut {
                is_in_to_out: !is_in_to_out,
            },
            Self::OpenClosed { is_open } => Self::OpenClosed { is_open: !is_open },
        }
    }

    /// The side of positive values in a sign convention such as `L-/R+` or `open+/closed-`. `None`
    /// if the text is not a sign convention of two opposite known sides.
    fn positive_in(signs: &str) -> Option<Self> {
        let (first, second) = signs.split_once('/')?;
        let [first, second] = [first, second].map(str::trim);
        let (negative, positive) = match (first.strip_suffix('-'), second.strip_suffix('-')) {
            (Some(negative), None) => (negative, second.strip_suffix('+')?),
            (None, Some(negative)) => (negative, first.strip_suffix('+')?),
            _ => return None,
        };
        let [negative, positive] = [negative, positive].map(|word| Self::named(word.trim()));
        positive.filter(|side| negative == Some(side.opposite()))
    }

    /// Sign of the value: + right of the target, up, inside to outside, open.
    pub fn sign(self) -> f64 {
        let is_positive = match self {
            Self::OfTarget { is_right: is }
            | Self::UpDown { is_up: is }
            | Self::InOut { is_in_to_out: is }
            | Self::OpenClosed { is_open: is } => is,
        };
        if is_positive { 1.0 } else { -1.0 }
    }
}

/// Strips spreadsheet wrappers: `="160.0"`, `'-1.5`.
pub(super) fn unwrapped(cell: &str) -> &str {
    let cell = cell.trim();
    let formula = cell.strip_prefix('=').map(|rest| rest.trim_matches('"'));
    let cell = formula.unwrap_or(cell);
    cell.strip_prefix('\'').unwrap_or(cell).trim()
}

/// The number in a cell as text: sign, digits, decimal and thousands marks; empty without digits.
pub(super) fn digits(cell: &str) -> &str {
    let number =
        unwrapped(cell).trim_matches(|c: char| !(c.is_ascii_digit() || "+-.,".contains(c)));
    // a column head such as `Launch Dir.` has a mark without digits
    if number.contains(|c: char| c.is_ascii_digit()) {
        number
    } else {
        ""
    }
}

/// Parses a cell; `None` if it holds no number.
pub(super) fn cell_number(cell: &str, has_decimal_comma: bool) -> Option<CellNumber> {
    let cell = unwrapped(cell);
    if let Some(number) = number(cell, has_decimal_comma) {
        return Some(CellNumber {
            number,
            unit: None,
            side: None,
        });
    }
    let (mut found, mut side) = (None, None);
    let mut rest = cell;
    // the side may come before the number: `R 4.6`, `R4.6 deg`
    let word = cell.split_once(' ');
    let letter = cell.char_indices().nth(1).map(|(at, _)| cell.split_at(at));
    let mut beginnings = [word, letter].into_iter().flatten();
    if let Some((named, after)) =
        beginnings.find_map(|(word, after)| Some((CellSide::named(word)?, after)))
    {
        (side, rest) = (Some(named), after.trim());
    }
    let is_of_number = |c: char| c.is_ascii_digit() || "+-.,\u{2212}".contains(c);
    let begins = rest.find(|c: char| !is_of_number(c)).unwrap_or(rest.len());
    // the thousands separator may be a space
    let ends = rest
        .rfind(|c: char| c.is_ascii_digit())
        .map_or(begins, |last| last + 1)
        .max(begins);
    let (digits, words) = match number(&rest[..ends], has_decimal_comma) {
        Some(_) => rest.split_at(ends),
        None => rest.split_at(begins),
    };
    let value = number(digits, has_decimal_comma)?;
    for word in words.replace('\u{b0}', " deg ").split_whitespace() {
        match (CellSide::named(word), is_unit(word)) {
            (Some(named), _) if side.is_none() => side = Some(named),
            (_, true) if found.is_none() => found = Some(unit(word)),
            _ => return None,
        }
    }
    let is_signed = digits.starts_with(['-', '\u{2212}']);
    (!(is_signed && side.is_some())).then_some(CellNumber {
        number: value,
        unit: found,
        side,
    })
}

/// Parses a number. Decimal commas are allowed only if commas do not separate cells; points may
/// then separate thousands. The caller refuses ambiguous numbers first
/// ([`DecimalMark::ambiguity`](super::decimal_mark::DecimalMark::ambiguity)).
pub(super) fn number(cell: &str, has_decimal_comma: bool) -> Option<f64> {
    let cell = cell.trim();
    let thousands = if has_decimal_comma { '.' } else { ',' };
    let has_thousands = cell.contains(thousands) && has_thousands(cell, thousands);
    // fast path for plain numbers
    if !has_thousands && let Ok(number) = cell.parse::<f64>() {
        return Some(number).filter(|number| number.is_finite());
    }
    let cell = without_thousands(&cell.replace('\u{2212}', "-"));
    let cell = match has_thousands {
        true => cell.replace(thousands, ""),
        false => cell,
    };
    let cell = match has_decimal_comma {
        true if !cell.contains('.') => cell.replacen(',', ".", 1),
        _ => cell,
    };
    cell.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Removes thousands separators that cannot be decimal marks: `2 500`, `2\u{2019}500`.
fn without_thousands(cell: &str) -> String {
    const MARKS: [char; 7] = [' ', '\u{a0}', '\u{2009}', '\u{202f}', '\'', '\u{2019}', '_'];
    let mark = MARKS
        .into_iter()
        .find(|mark| cell.contains(*mark) && has_thousands(&cell.replace(*mark, "_"), '_'));
    mark.map_or_else(|| cell.to_owned(), |mark| cell.replace(mark, ""))
}

/// True if the mark may separate thousands, as the comma in `2,686` or `1,234.5`, but not in `3,2`
/// or `0,250`.
pub(crate) fn has_thousands(cell: &str, mark: char) -> bool {
    let decimals: &[char] = if mark == ',' {
        &['.']
    } else if mark == '.' {
        &[',']
    } else {
        &['.', ',']
    };
    let whole = cell
        .trim_start_matches(['+', '-', '\u{2212}'])
        .split(decimals)
        .next()
        .unwrap_or_default();
    let mut groups = whole.split(mark);
    let is_of = |group: &str, digits: std::ops::RangeInclusive<usize>| {
        digits.contains(&group.len()) && group.bytes().all(|byte| byte.is_ascii_digit())
    };
    let begins = groups
        .next()
        .is_some_and(|first| is_of(first, 1..=3) && !first.starts_with('0'));
    whole.contains(mark) && begins && groups.all(|group| is_of(group, 3..=3))
}

/// Recognizes units of speed, length, angle, spin and time.
pub(super) fn is_unit(word: &str) -> bool {
    let (unit, _) = unit_and_side(word);
    [
        Quantity::SPEED,
        Quantity::LENGTH,
        Quantity::ANGLE,
        Quantity::ANGULAR_VELOCITY,
        Quantity::TIME,
    ]
    .iter()
    .any(|quantity| quantity.size_of(&unit).is_some())
}

/// The unit of a column, and the side of its positive values if the column states it: `deg` and
/// right for `deg L-/R+`. A sign convention that is not known stays a part of the unit.
pub(super) fn unit_and_side(written: &str) -> (String, Option<CellSide>) {
    let stated = written
        .trim()
        .split_once(' ')
        .and_then(|(unit, signs)| Some((unit, CellSide::positive_in(signs)?)));
    match stated {
        Some((of_numbers, positive)) => (unit(of_numbers), Some(positive)),
        None => (unit(written), None),
    }
}

/// A unit in the spelling of this program: mph for `MPH`, yards for `Yards`, yd for `yds`.
pub(super) fn unit(written: &str) -> String {
    let written = written.trim();
    match written.to_lowercase().as_str() {
        "yds" => "yd".into(),
        "mps" => "m/s".into(),
        "degs" => "deg".into(),
        "secs" => "s".into(),
        small @ ("mph" | "km/h" | "kmh" | "kph" | "m/s" | "yd" | "yard" | "yards" | "m"
        | "meter" | "meters" | "metre" | "metres" | "ft" | "feet" | "foot" | "deg"
        | "degree" | "degrees" | "rpm" | "s" | "sec" | "seconds" | "in" | "inch"
        | "inches" | "mm" | "cm") => small.into(),
        _ => written.into(),
    }
}

/// Compares units by size: `km/h` equals `kph`.
pub(super) fn is_same_unit(one: &str, other: &str) -> bool {
    const QUANTITIES: [Quantity; 6] = [
        Quantity::SPEED,
        Quantity::LENGTH,
        Quantity::ANGLE,
        Quantity::ANGULAR_VELOCITY,
        Quantity::TIME,
        Quantity::DENSITY,
    ];
    let is_in = |quantity: &Quantity| {
        quantity.size_of(one).is_some() && quantity.size_of(one) == quantity.size_of(other)
    };
    one == other || QUANTITIES.iter().any(is_in)
}

#[cfg(test)]
mod tests {
    use super::{CellNumber, CellSide, cell_number};
    use super::{number, unit, unit_and_side};

    #[test]
    fn numbers_with_units_and_sides_are_read() {
        let right = Some(CellSide::OfTarget { is_right: true });
        let left = Some(CellSide::OfTarget { is_right: false });
        let down = Some(CellSide::UpDown { is_up: false });
        let [inside, closed] = [
            CellSide::InOut { is_in_to_out: true },
            CellSide::OpenClosed { is_open: false },
        ]
        .map(Some);
        for (cell, comma, number, unit, side) in [
            ("160.0", false, 160.0, None, None),
            ("=\"160.0\"", false, 160.0, None, None),
            ("'-1.5", false, -1.5, None, None),
            ("123 mph", false, 123.0, Some("mph"), None),
            ("4.6\u{b0} R", false, 4.6, Some("deg"), right),
            ("17.1\u{b0}", false, 17.1, Some("deg"), None),
            ("422 R rpm", false, 422.0, Some("rpm"), right),
            ("9.8 L yds", false, 9.8, Some("yd"), left),
            ("2 878 rpm", false, 2878.0, Some("rpm"), None),
            ("3,2R", true, 3.2, None, right),
            ("Left 3", false, 3.0, None, left),
            ("L3", false, 3.0, None, left),
            ("L4.8 deg", false, 4.8, Some("deg"), left),
            ("R 4.8 deg", false, 4.8, Some("deg"), right),
            ("1.2 D", false, 1.2, None, down),
            ("0.8 I-O", false, 0.8, None, inside),
            ("0.1 C", false, 0.1, None, closed),
        ] {
            let expected = CellNumber {
                number,
                unit: unit.map(String::from),
                side,
            };
            assert_eq!(cell_number(cell, comma), Some(expected), "{cell}");
        }
        for cell in [
            "",
            "-",
            "mph",
            "L",
            "-3 L",
            "3 L R",
            "3 mph rpm",
            "3 apples",
            "Driver 3",
            "12:30",
        ] {
            assert_eq!(cell_number(cell, false), None, "{cell}");
        }
    }

    #[test]
    fn numbers_with_decimal_and_thousands_marks_are_read() {
        for (cell, comma, expected) in [
            ("2,686", false, 2686.0),
            ("1,234,567.5", false, 1_234_567.5),
            ("\u{2212}4.5", false, -4.5),
            ("+12,0", true, 12.0),
            ("2 500", false, 2500.0),
            ("2\u{a0}500", true, 2500.0),
            ("2\u{202f}500,5", true, 2500.5),
            ("-2'500", false, -2500.0),
            ("2\u{2019}500.25", false, 2500.25),
        ] {
            assert_eq!(number(cell, comma), Some(expected), "{cell}");
        }
        for (cell, comma) in [
            ("12,34", false),
            ("1234,567", false),
            ("3,2", false),
            ("12 5", false),
            ("1'2", false),
            ("", true),
        ] {
            assert_eq!(number(cell, comma), None, "{cell}");
        }
    }

    #[test]
    fn signs_behind_a_unit_name_the_side_of_positive_values() {
        let side = |is_right| Some(CellSide::OfTarget { is_right });
        let inside = Some(CellSide::InOut { is_in_to_out: true });
        let closed = Some(CellSide::OpenClosed { is_open: false });
        for (written, of_numbers, positive) in [
            ("deg L-/R+", "deg", side(true)),
            ("deg R-/L+", "deg", side(false)),
            ("deg L+/R-", "deg", side(false)),
            ("yds left- / right+", "yd", side(true)),
            ("deg out-in-/in-out+", "deg", inside),
            ("deg open-/closed+", "deg", closed),
            ("deg L-/L+", "deg L-/L+", None),
            ("deg L-/open+", "deg L-/open+", None),
            ("deg toe down-/toe up+", "deg toe down-/toe up+", None),
            ("m/s", "m/s", None),
        ] {
            let expected = (of_numbers.to_owned(), positive);
            assert_eq!(unit_and_side(written), expected, "{written}");
        }
    }

    #[test]
    fn units_in_other_spellings_are_read() {
        assert_eq!(
            ["MPH", "Yards", "yds", "°", "Pa s"].map(unit),
            ["mph", "yards", "yd", "°", "Pa s"]
        );
    }
}
