//! Estimated widths of texts. The reader's font is unknown, so the widths are those of DejaVu Sans,
//! the widest common font; a text in another font is narrower.

/// Size of the text, pixels.
pub(super) const TEXT: f64 = 13.5;
/// Size of the text of numbers, names and labels, pixels.
pub(super) const SMALL_TEXT: f64 = TEXT - 0.5;

/// The widths of the characters from space to tilde, in thousandths of the text size.
#[rustfmt::skip]
const REGULAR: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
];
#[rustfmt::skip]
const BOLD: [u16; 95] = [
    348, 456, 521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415, 380, 365, 696, 696, 696,
    696, 696, 696, 696, 696, 696, 696, 400, 400, 838, 838, 838, 580, 1000, 774, 762, 734, 830, 683,
    683, 821, 837, 372, 372, 775, 637, 995, 837, 850, 733, 850, 770, 720, 682, 812, 774, 1103, 771,
    724, 725, 457, 365, 457, 838, 500, 500, 675, 716, 593, 716, 678, 435, 716, 712, 343, 343, 665,
    343, 1042, 712, 687, 716, 716, 493, 595, 478, 712, 652, 924, 645, 652, 582, 712, 365, 712, 838,
];

/// The widths of all other characters, regular and bold. They are the widths of "−" and "±"; degree
/// signs and exponents are narrower.
const OTHER: [u16; 2] = [838, 870];

/// The width of a text, pixels.
pub(super) fn text_width(text: &str, size: f64, is_bold: bool) -> f64 {
    let (known, other) = if is_bold {
        (&BOLD, OTHER[1])
    } else {
        (&REGULAR, OTHER[0])
    };
    let of = |c: char| {
        (c as usize)
            .checked_sub(32)
            .and_then(|i| known.get(i))
            .copied()
            .unwrap_or(other)
    };
    text.chars().map(|c| f64::from(of(c))).sum::<f64>() * size / 1000.0
}

/// The width of the widest of some texts of the size `SMALL_TEXT`, pixels; 0 without texts.
pub(super) fn widest(texts: impl IntoIterator<Item = impl AsRef<str>>, is_bold: bool) -> f64 {
    let widths = texts
        .into_iter()
        .map(|text| text_width(text.as_ref(), SMALL_TEXT, is_bold));
    widths.fold(0.0, f64::max)
}

/// A text wrapped into lines of at most `room` pixels. A word that is too wide is broken, if
/// possible after a punctuation mark.
pub(super) fn wrapped(text: &str, room: f64, size: f64, is_bold: bool) -> Vec<String> {
    let fits = |text: &str| text_width(text, size, is_bold) <= room;
    let mut lines: Vec<String> = vec![];
    for word in text.split_whitespace() {
        let joined = lines
            .last()
            .map(|line| format!("{line} {word}"))
            .filter(|line| fits(line));
        match (joined, lines.last_mut()) {
            (Some(joined), Some(last)) => *last = joined,
            _ => lines.extend(broken(word, &fits)),
        }
    }
    lines
}

fn broken(word: &str, fits: &dyn Fn(&str) -> bool) -> Vec<String> {
    let mut pieces = vec![];
    let mut rest = word;
    while !fits(rest) {
        let ends = rest.char_indices().map(|(at, c)| at + c.len_utf8());
        // a piece has at least one character, even if this character is too wide
        let longest = ends
            .enumerate()
            .take_while(|(i, end)| *i == 0 || fits(&rest[..*end]))
            .map(|(_, end)| end)
            .last();
        let longest = longest.unwrap_or(rest.len());
        let at = rest[..longest]
            .rfind(['.', '_', '/', '-'])
            .map_or(longest, |at| at + 1);
        if at == rest.len() {
            break;
        }
        pieces.push(rest[..at].to_owned());
        rest = &rest[at..];
    }
    pieces.push(rest.to_owned());
    pieces
}

#[cfg(test)]
mod tests {
    use super::{text_width, wrapped};

    #[test]
    fn no_line_is_wider_than_its_room_and_no_letter_is_lost() {
        let text = "d carry/d swing.attack_angle of macdonald-hanzely over \
                    Llanfairpwllgwyngyllgogerychwyrndrobwll";
        for room in [40.0, 90.0, 150.0, 400.0] {
            let lines = wrapped(text, room, 13.0, false);
            assert!(
                lines
                    .iter()
                    .all(|line| text_width(line, 13.0, false) <= room),
                "{lines:?}"
            );
            assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
        }
        assert_eq!(
            wrapped("swing.attack_angle", 70.0, 13.0, false),
            ["swing.", "attack_", "angle"]
        );
        assert!(wrapped("", 70.0, 13.0, false).is_empty());
    }
}
