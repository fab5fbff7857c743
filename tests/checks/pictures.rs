//! Pictures and printed text: nothing is cut or hidden at any width, and numbers, units and signs
//! have one spelling.

use crate::command_line::{longdrive, on_one_line};
use crate::pages::DEFAULT_REPORT;
use longdrive::Error;
use longdrive::report::plot::{Axis, Figure, Layer, Look, NamedQuantity, figure_svg};
use longdrive::units::System;

const WIDTHS: [u32; 10] = [240, 280, 320, 340, 380, 420, 480, 640, 800, 1200];

/// Command lines of plots: for each kind of plot, the command lines that put the most text into it.
const KINDS: &[&[&str]] = &[
    &["tornado"],
    &["tornado", "--show", "model", "--units", "metric"],
    &["tornado", "--show", "all", "--of", "lateral"],
    &["contour", "--subject-to", "descent_angle >= 38 deg"],
    &["chart", "--along", "swing.speed=90..110 mph"],
    &[
        "chart",
        "--along",
        "swing.speed=90..110 mph",
        "--show",
        "club.loft",
    ],
    &[
        "pareto",
        "--maximize",
        "carry",
        "--minimize",
        "descent_angle",
        "--points",
        "5",
    ],
    &["trajectory"],
    &[
        "trajectory",
        "--view",
        "top",
        "--set",
        "swing.face_angle=3deg",
    ],
    &[
        "compare",
        "--set-b",
        "club.loft=12deg",
        "--set-b",
        "aero.law=linear",
        "--set-b",
        "swing.path=2deg",
    ],
    &[
        "vcurve",
        "--wrt",
        "club.loft,swing.attack_angle,air.density",
        "--of",
        "carry,lateral",
        "--set",
        "flight.method=dp8",
        "--set",
        "flight.step=400ms",
    ],
    &["fairway", "--set", "swing.face_angle=1deg"],
    &["launch"],
    &["face", "--set", "strike.toe=10mm"],
    &["strike", "--set", "strike.toe=-8mm"],
    &["laws"],
    &["laws", "--show", "cl", "--over", "reynolds"],
];

/// Words of a picture and their box, pixels: left, top, right, bottom.
struct Words {
    text: String,
    size: f64,
    place: [f64; 4],
}

/// Approximate width of words in a wide font.
fn width(text: &str, size: f64, is_bold: bool) -> f64 {
    let of = |c: char| match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | '\'' | 'I' | '|' => 0.30,
        ' ' | 'f' | 't' | 'r' | '-' | '(' | ')' | '[' | ']' | '/' => 0.38,
        'm' | 'w' | 'M' | 'W' => 0.94,
        '−' | '±' | '+' | '=' | '≥' | '≤' => 0.84,
        'A'..='Z' => 0.70,
        _ => 0.62,
    };
    text.chars().map(of).sum::<f64>() * size * if is_bold { 1.07 } else { 1.0 }
}

fn words(svg: &str) -> Vec<Words> {
    let picture = roxmltree::Document::parse(svg).unwrap();
    let texts = picture
        .descendants()
        .filter(|node| node.has_tag_name("text"));
    let one = |node: roxmltree::Node<'_, '_>| {
        let of = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
        let text = node.text()?.trim().to_owned();
        let size = of("font-size");
        let wide = width(&text, size, node.attribute("font-weight") == Some("bold"));
        // a view beside or below another one is translated
        let moved = |axis: usize| -> f64 {
            let to = node
                .ancestors()
                .filter_map(|node| node.attribute("transform"));
            let parts = to.map(|to| {
                to.trim_start_matches("translate(")
                    .trim_end_matches(')')
                    .split(' ')
                    .nth(axis)
            });
            parts
                .map(|part| part.unwrap().parse::<f64>().unwrap())
                .sum()
        };
        let (right, down) = (moved(0), moved(1));
        let left = right + of("x")
            - match node.attribute("text-anchor") {
                Some("middle") => 0.5 * wide,
                Some("end") => wide,
                _ => 0.0,
            };
        // letters reach 0.76 of their size above the baseline, and 0.24 below it
        let top = match node.attribute("dy") {
            Some("0.76em") => of("y"),
            Some("0.5ex") => of("y") - 0.5 * size,
            other => panic!("{other:?}"),
        };
        Some(Words {
            place: [left, down + top, left + wide, down + top + size],
            text,
            size,
        })
    };
    texts
        .filter_map(one)
        .filter(|words| !words.text.is_empty())
        .collect()
}

fn drawn(kind: &[&str], file: &str, width: u32) -> String {
    let width = width.to_string();
    let options = ["-o", file, "--overwrite", "--quiet", "--width", &width];
    let output = longdrive(&[&["plot"], kind, options.as_slice()].concat());
    assert_eq!(output.status, 0, "{kind:?} {width}: {}", output.err);
    std::fs::read_to_string(file).unwrap()
}

#[test]
fn no_words_are_cut_or_overlap_in_any_picture_at_any_width() {
    let folder = tempfile::tempdir().unwrap();
    let check = |kind: &[&str], file: &str| {
        for width in WIDTHS {
            let svg = drawn(kind, file, width);
            let found = words(&svg);
            assert!(found.len() > 4, "{kind:?} at {width}: {svg}");
            for (i, one) in found.iter().enumerate() {
                let [left, top, right, bottom] = one.place;
                let what = format!("{kind:?} at {width}: '{}' at {:?}", one.text, one.place);
                assert!(one.size >= 11.999, "{what} is small");
                assert!(
                    left >= -1.0 && top >= -1.0 && right <= f64::from(width) + 1.0,
                    "{what} is cut"
                );
                let height = svg
                    .split_once("height=\"")
                    .unwrap()
                    .1
                    .split_once('"')
                    .unwrap()
                    .0;
                assert!(
                    bottom <= height.parse::<f64>().unwrap() + 1.0,
                    "{what} is cut below"
                );
                for other in &found[..i] {
                    let slack = 1.5;
                    let apart = (0..2).any(|axis| {
                        one.place[axis] + slack >= other.place[axis + 2]
                            || other.place[axis] + slack >= one.place[axis + 2]
                    });
                    assert!(
                        apart,
                        "{what} overlaps '{}' at {:?}",
                        other.text, other.place
                    );
                }
            }
        }
    };
    std::thread::scope(|scope| {
        for (i, kind) in KINDS.iter().enumerate() {
            let file = folder.path().join(format!("{i}.svg")).display().to_string();
            scope.spawn(move || check(kind, &file));
        }
    });
}

/// The fill and the opacity of each polygon.
fn fills(svg: &str) -> Vec<[String; 2]> {
    let picture = roxmltree::Document::parse(svg).unwrap();
    let polygons = picture
        .descendants()
        .filter(|node| node.has_tag_name("polygon"));
    polygons
        .map(|node| ["fill", "opacity"].map(|name| node.attribute(name).unwrap().to_owned()))
        .collect()
}

/// The region of small loss has the same opaque colour in a map, where it covers other colours, and
/// in the legend, where it covers the page.
#[test]
fn the_legend_of_a_map_has_the_colour_of_its_region() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    for more in [&[][..], &["--dark"]] {
        let svg = drawn(&[&["contour"], more].concat(), &file, 480);
        // the symbol is the last polygon before its label
        let (before, _) = svg.split_once("at most 1.00 yd lost</text>").unwrap();
        let [symbol, opacity] = fills(&format!("{before}</text></svg>")).pop().unwrap();
        assert_eq!(opacity, "1");
        let found = fills(&svg);
        let same = found.iter().filter(|[fill, _]| *fill == symbol);
        assert!(same.clone().count() >= 2, "{symbol} {found:?}");
        assert!(same.clone().all(|[_, opacity]| opacity == "1"), "{found:?}");
    }
}

/// Points, in pixels, of those lines in the first view that have at least `least` points.
fn long_lines(svg: &str, least: usize) -> Vec<[f64; 2]> {
    let first = svg
        .split_once("<g transform")
        .map(|(first, _)| format!("{first}</svg>"));
    let first = first.unwrap_or_else(|| svg.into());
    let lines = crate::report::polylines(&crate::report::whole(&first));
    let long = lines.into_iter().filter(|line| line.len() >= least);
    long.flatten().collect()
}

#[test]
fn a_trajectory_names_its_flight_and_no_label_covers_the_landing() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    for width in [340, 390, 480, 640, 800] {
        for preset in [
            "tour-average",
            "amateur-average",
            "modern-driver",
            "winfield-tan",
        ] {
            let svg = drawn(&["trajectory", preset], &file, width);
            let found = words(&svg);
            // the ball of this preset embeds, so it has no run
            let has_run = preset != "winfield-tan";
            for (name, is_named) in [("flight", true), ("run", has_run), ("ground", true)] {
                let is_found = found.iter().any(|words| words.text == name);
                assert_eq!(is_found, is_named, "{preset}: {name}");
            }
            let label = found.iter().find(|words| words.text.starts_with("carry"));
            let [left, top, right, bottom] = label.unwrap().place;
            // apex and landing have a mark; the landing is farther downrange
            let landing = marks(&svg).into_iter().map(|(at, _)| at);
            let landing = landing.max_by(|a, b| a[0].total_cmp(&b[0])).unwrap();
            let near = |[x, y]: &[f64; 2]| (x - landing[0]).hypot(y - landing[1]) < 40.0;
            let lines = long_lines(&svg, 20);
            let places: Vec<_> = lines.into_iter().filter(near).collect();
            assert!(places.len() > 10);
            for [x, y] in places {
                let is_covered = (left..right).contains(&x) && (top..bottom).contains(&y);
                assert!(!is_covered, "{preset} at {width}: {x} {y}");
            }
        }
    }
}

/// Each circle of a mark: its centre and colour.
fn marks(svg: &str) -> Vec<([f64; 2], String)> {
    let picture = roxmltree::Document::parse(svg).unwrap();
    let circles = picture
        .descendants()
        .filter(|node| node.has_tag_name("circle") && node.attribute("r") == Some("5"));
    circles
        .map(|node| {
            let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
            let fill = node.attribute("fill").unwrap().to_owned();
            ([number("cx"), number("cy")], fill)
        })
        .collect()
}

/// At any width a label on the face is nearer to its own mark than to another one, or has a line to
/// it.
#[test]
fn labels_of_the_face_belong_to_their_marks() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let labels = ["sweet spot", "strike", "longest carry"];
    for strike in ["strike.toe=0mm", "strike.toe=10mm", "strike.high=-3mm"] {
        for width in [340, 390, 480, 640, 800] {
            let svg = drawn(&["face", "--set", strike], &file, width);
            let marks = marks(&svg);
            let picture = roxmltree::Document::parse(&svg).unwrap();
            let fill = |text: &str| {
                let mut texts = picture
                    .descendants()
                    .filter(|node| node.has_tag_name("text"));
                let node = texts.find(|node| node.text().is_some_and(|own| own.trim() == text));
                node.unwrap().attribute("fill").unwrap().to_owned()
            };
            let named = |text: &str| labels.iter().any(|label| text.starts_with(label));
            let found: Vec<Words> = words(&svg)
                .into_iter()
                .filter(|words| named(&words.text))
                .collect();
            assert_eq!(found.len(), marks.len(), "{strike} at {width}");
            for Words { text, place, .. } in found {
                let [left, top, right, bottom] = place;
                let distance = |[x, y]: [f64; 2]| {
                    let dx = (left - x).max(x - right).max(0.0);
                    dx.hypot((top - y).max(y - bottom).max(0.0))
                };
                let color = fill(&text);
                let own = marks.iter().find(|(_, fill)| *fill == color).unwrap();
                // a label farther away has a line to its mark
                let is_joined = long_lines(&svg, 2)
                    .iter()
                    .any(|[x, y]| ((x - own.0[0]).hypot(y - own.0[1]) - 6.5).abs() < 0.2);
                if distance(own.0) > 28.0 && is_joined {
                    continue;
                }
                for (other, _) in marks.iter().filter(|(at, _)| *at != own.0) {
                    assert!(
                        distance(own.0) < distance(*other),
                        "{strike} at {width}: {text} {place:?} {marks:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_width_too_narrow_for_a_picture_is_refused_with_the_least_width() {
    let axis = |label: &str| Axis::linear(NamedQuantity::plain(label));
    let figure = Figure::new(System::Us, "n", "t", axis("x"), axis("y")).with(Layer::line(
        "",
        0,
        vec![[0.0, 0.0], [1.0, 1e9]],
    ));
    let at = |width: u32| {
        figure_svg(
            &figure,
            &Look {
                width,
                ..Look::default()
            },
        )
    };
    let Err(Error::Plot { reason, .. }) = at(130) else {
        panic!("it is too narrow")
    };
    let least = reason
        .split_once("take ")
        .unwrap()
        .1
        .split(' ')
        .next()
        .unwrap()
        .parse::<u32>()
        .unwrap();
    assert!(
        least > 130 && at(least).is_ok() && at(least - 1).is_err(),
        "{reason}"
    );
}

/// The bars in a table of data: the name and the end of each bar; bars begin at 0.
fn bars(csv: &str) -> Vec<(String, f64)> {
    let rows = csv.lines().filter(|row| row.starts_with("bar,"));
    rows.map(|row| {
        let cells: Vec<&str> = row.split(',').collect();
        (cells[1].to_owned(), cells[3].parse().unwrap())
    })
    .collect()
}

/// The line at the centre of the face is at 0, which is computed as -0.
#[test]
fn exact_zero_has_no_sign_in_the_table_of_a_plot() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("face.csv").display().to_string();
    let output = longdrive(&["plot", "face", "-o", &path]);
    assert_eq!(output.status, 0, "{}", output.err);
    let csv = std::fs::read_to_string(&path).unwrap();
    let mut cells = csv.split([',', '\n']);
    assert!(cells.clone().any(|cell| cell == "0.0"), "{csv}");
    assert!(cells.all(|cell| cell != "-0.0"), "{csv}");
}

#[test]
fn controlled_and_model_parameters_have_separate_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let (svg, csv) = (file("x.svg"), file("x.csv"));
    for (show, has, has_not) in [
        (
            "control",
            ["club speed ± 0.5 mph", "attack angle ± 0.3°"],
            "cd0",
        ),
        (
            "model",
            ["cd0 ± 0.015", "wind downrange ± 2.24 mph"],
            "club speed",
        ),
    ] {
        let output = longdrive(&["plot", "tornado", "-o", &csv, "--overwrite", "--show", show]);
        assert!(
            output.status == 0
                && output.err.contains("as set up")
                && !output.err.contains("linear"),
            "{}",
            output.err
        );
        let found = bars(&std::fs::read_to_string(&csv).unwrap());
        assert!(
            has.iter()
                .all(|name| found.iter().any(|(bar, _)| bar.starts_with(name))),
            "{found:?}"
        );
        let mut names: Vec<&String> = found.iter().map(|(bar, _)| bar).collect();
        names.sort();
        names.dedup();
        assert_eq!(
            names.len(),
            found.len(),
            "bars with the same name: {found:?}"
        );
        assert!(
            found.iter().all(|(bar, _)| !bar.contains(has_not)),
            "{found:?}"
        );
        // the value of each bar is written at its end, in yards, with a true minus sign
        let picture = drawn(&["tornado", "--show", show], &svg, 480);
        let texts: Vec<String> = words(&picture)
            .into_iter()
            .map(|words| words.text)
            .collect();
        for (bar, metres) in &found {
            let yards = metres / 0.9144;
            let sign = if yards < 0.0 { "−" } else { "+" };
            let value = format!("{sign}{:.1}", yards.abs());
            assert!(
                yards.abs() < 0.05 || texts.contains(&value),
                "{bar}: {value} is not in {texts:?}"
            );
        }
        assert!(
            texts.iter().any(|text| text.contains(" more: ")),
            "small bars are in one row: {texts:?}"
        );
    }
}

/// A square face and a straight path are the longest drive: both bars point to the left, and
/// neither hides the other.
#[test]
fn two_bars_on_one_side_are_both_seen() {
    let folder = tempfile::tempdir().unwrap();
    let svg = drawn(
        &["tornado"],
        &folder.path().join("x.svg").display().to_string(),
        480,
    );
    let picture = roxmltree::Document::parse(&svg).unwrap();
    let of = |node: &roxmltree::Node<'_, '_>, name: &str| {
        node.attribute(name).unwrap().parse::<f64>().unwrap()
    };
    let bars: Vec<[f64; 4]> = picture
        .descendants()
        .filter(|node| node.has_tag_name("rect") && node.attribute("opacity") == Some("0.85"))
        .map(|node| {
            let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| of(&node, name));
            [x, y, x + width, y + height]
        })
        .collect();
    assert!(bars.len() > 8, "{svg}");
    let mut one_sided = 0;
    for (i, one) in bars.iter().enumerate() {
        for other in &bars[..i] {
            let covered =
                |axis: usize| one[axis + 2].min(other[axis + 2]) - one[axis].max(other[axis]);
            assert!(
                covered(0) <= 0.2 || covered(1) <= 0.2,
                "{one:?} hides {other:?}"
            );
            one_sided += usize::from(covered(0) > 1.0 && (one[1] - other[1]).abs() < 20.0);
        }
    }
    assert!(
        one_sided >= 2,
        "face angle and path have both bars on one side: {bars:?}"
    );
}

#[test]
fn a_price_has_its_direction_and_a_constraint_the_chosen_units() {
    // joins the lines, because the program breaks long ones
    let text = |args: &[&str]| on_one_line(&longdrive(&[&["optimize"], args].concat()).out);
    let bound = text(&[]);
    assert!(
        bound.contains("at its upper bound: +")
            && bound.contains(" yd for each degree that it is raised"),
        "{bound}"
    );
    let least = text(&[
        "--minimize",
        "descent_angle",
        "--vary",
        "swing.speed=100mph..120mph",
    ]);
    assert!(
        least.contains("at its lower bound: -")
            && least.contains("° for each mph that it is lowered"),
        "{least}"
    );
    let limits = [
        "--subject-to",
        "descent_angle >= 42 deg",
        "--subject-to",
        "lateral == 0 m",
        "--set",
        "swing.path=2deg",
    ];
    let both = [
        limits.as_slice(),
        &[
            "--vary",
            "club.loft=4deg..20deg",
            "--vary",
            "swing.face_angle=-5deg..5deg",
        ],
    ]
    .concat();
    let limited = text(&both);
    for words in [
        "descent angle ≥ 42°",
        "yd for each degree that the limit is relaxed",
        "lateral = 0 yd",
        "that the value is raised",
    ] {
        assert!(limited.contains(words), "no '{words}': {limited}");
    }
    let metric = text(&[both.as_slice(), &["--units", "metric"]].concat());
    assert!(
        metric.contains("m for each degree that the limit is relaxed")
            && metric.contains("lateral = 0 m"),
        "{metric}"
    );
}

/// The text of a page without its tags, and without code and preformatted text.
fn visible(page: &str) -> String {
    let body = page.split_once("<body").unwrap().1;
    let mut text = String::new();
    for part in body.split('<') {
        let (tag, words) = part.split_once('>').unwrap_or(("", part));
        if !tag.starts_with("code") && !tag.starts_with("pre") {
            text += words;
        }
        text.push('\n');
    }
    text.replace("&gt;", ">")
        .replace("&lt;", "<")
        .replace("&amp;", "&")
}

#[test]
fn degrees_signs_and_units_have_one_spelling_wherever_people_read() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("r").display().to_string();
    let speed = ["--set", "swing.speed=110mph"];
    let args = [
        "report",
        "-o",
        &directory,
        "--set",
        "swing.path=-2deg",
        "--subject-to",
        "descent_angle >= 38 deg",
    ];
    let vary = [
        "--vary",
        "club.loft=4deg..20deg",
        "--vary",
        "swing.attack_angle=-10deg..5deg",
        "--subject-to",
        "lateral <= 40 yd",
    ];
    let output = longdrive(&[args.as_slice(), &vary, &speed].concat());
    assert_eq!(output.status, 0, "{}", output.err);
    let mut read = vec![];
    for entry in std::fs::read_dir(&directory).unwrap() {
        let file = entry.unwrap().path();
        // with the feature `explore` the folder has the explorer too, which is compressed
        if file.ends_with("explorer.html") {
            continue;
        }
        let text = std::fs::read_to_string(&file).unwrap();
        match file.extension().and_then(|ending| ending.to_str()) {
            Some("svg") => read.push((
                file,
                words(&text)
                    .into_iter()
                    .map(|words| words.text)
                    .collect::<Vec<_>>()
                    .join("\n"),
            )),
            Some("html") => read.push((file, visible(&text))),
            _ => {}
        }
    }
    assert!(read.len() > 6, "{read:?}");
    for (file, text) in &read {
        let letters: Vec<char> = text.chars().collect();
        for (i, part) in letters.windows(3).enumerate() {
            let around = || {
                letters[i.saturating_sub(30)..(i + 30).min(letters.len())]
                    .iter()
                    .collect::<String>()
            };
            let [a, b, c] = [part[0], part[1], part[2]];
            let is_hyphen = (a.is_whitespace() || a == '(') && b == '-' && c.is_ascii_digit();
            let is_power = b == '^' || (matches!(a, '>' | '<') && b == '=');
            assert!(!is_hyphen && !is_power, "{}: {}", file.display(), around());
            let is_degree =
                a.is_ascii_digit() && b == ' ' && letters[i + 2..].starts_with(&['d', 'e', 'g']);
            assert!(
                !is_degree || letters.get(i + 5).is_some_and(|c| c.is_alphabetic()),
                "{}: {}",
                file.display(),
                around()
            );
        }
        assert!(
            !text.contains("swing speed") && !text.contains("swing attack angle"),
            "{}",
            file.display()
        );
    }
    let page = &read
        .iter()
        .find(|(file, _)| file.ends_with("index.html"))
        .unwrap()
        .1;
    // the values that the switch of units changes, in both systems of units
    for words in [
        "110 mph",
        "49.1744 m/s",
        "descent angle ≥ 38°",
        "lateral ≤ 40 yd",
        "lateral ≤ 36.576 m",
        "attack angle",
        "kg/m³",
    ] {
        assert!(page.contains(words), "no '{words}'");
    }
    // a terminal prints degree signs, and hyphens as minus signs, because hyphens can be copied.
    // JSON repeats a limit as it was typed
    let output = longdrive(&["simulate", "--set", "swing.path=-2deg"]);
    assert!(
        output.out.contains('°') && !output.out.contains(" deg") && !output.out.contains('−'),
        "{}",
        output.out
    );
    let json = longdrive(&[
        "optimize",
        "--json",
        "--subject-to",
        "descent_angle >= 80 deg",
    ]);
    assert!(
        json.out.contains("descent_angle >= 80 deg") && !json.out.contains('°'),
        "{}",
        json.out
    );
}

/// Rounding leaves the lateral distance of a straight drive near 1e-15 m; it is printed as zero.
#[test]
fn rounding_is_shown_as_no_value() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.svg").display().to_string();
    let slower = ["--set-b", "swing.speed=100mph", "--of", "lateral"];
    for args in [
        vec![
            "gradient",
            "--of",
            "lateral",
            "--wrt",
            "swing.speed,swing.path",
        ],
        vec!["sensitivity", "--of", "lateral"],
        [vec!["compare"], slower.to_vec()].concat(),
        [
            vec!["plot", "compare", "-o", &file, "--set-b", "swing.path=1deg"],
            slower[..2].to_vec(),
            slower[2..].to_vec(),
        ]
        .concat(),
        vec![
            "plot",
            "tornado",
            "-o",
            &file,
            "--overwrite",
            "--of",
            "lateral",
            "--show",
            "all",
        ],
    ] {
        let output = longdrive(&args);
        assert_eq!(output.status, 0, "{args:?}: {}", output.err);
        let all = output.out + &output.err;
        for power in 12..20 {
            assert!(!all.contains(&format!("e-{power}")), "{args:?}: {all}");
        }
        if let Ok(svg) = std::fs::read_to_string(&file) {
            let shown = words(&svg);
            assert!(
                shown.iter().all(|words| !words.text.contains("e−1")),
                "{args:?}"
            );
        }
    }
}

#[test]
fn the_optimum_has_its_own_style_also_if_the_setup_does_not_fly() {
    let lines = |svg: &str| {
        let picture = roxmltree::Document::parse(svg).unwrap();
        [("#0065A6", false), ("#C04C00", true)].map(|(color, is_dashed)| {
            let lines = picture
                .descendants()
                .filter(|node| node.attribute("stroke") == Some(color));
            lines
                .filter(|node| node.has_attribute("stroke-dasharray") == is_dashed)
                .count()
        })
    };
    let [set_up, optimum] = lines(DEFAULT_REPORT.file("trajectory-side-us.svg"));
    assert!(
        set_up > 0 && optimum > 0,
        "solid lines of the drive as set up, dashed ones of the optimum: {set_up} {optimum}"
    );
    let vary = [
        "--vary",
        "swing.attack_angle=-25deg..5deg",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page").display().to_string();
    let setup = ["--set", "swing.attack_angle=-20deg"];
    longdrive(&[&["report", "-o", &page], &setup[..], &vary].concat());
    let svg = std::fs::read_to_string(format!("{page}/trajectory-side-us.svg")).unwrap();
    let [set_up, optimum] = lines(&svg);
    assert!(set_up == 0 && optimum > 0, "{set_up} {optimum}");
}
