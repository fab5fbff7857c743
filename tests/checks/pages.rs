//! HTML pages that commands write: the answer precedes the arguments, and all pages have one
//! layout.

use crate::command_line::{Written, json, longdrive, number, written};
use crate::program;
use crate::reproduce::{PAPER_WRITTEN, REPORT};
use crate::validation::VALIDATED;
use std::path::Path;
use std::sync::LazyLock;

/// The exit status and the page of a command that has written a folder.
fn first_page(written: &Written) -> (i32, String) {
    (written.output.status, written.file("index.html").to_owned())
}

/// Exit status of a command that writes a page, and the text of the page.
fn page(folder: &tempfile::TempDir, args: &[&str]) -> (i32, String) {
    let into = folder.path().join("page").display().to_string();
    let option = if args[0] == "calibrate" {
        "--plot"
    } else {
        "-o"
    };
    let printed = longdrive(&[args, &[option, &into, "--overwrite"]].concat());
    let file = Path::new(&into).join("index.html");
    (
        printed.status,
        std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{error}: {}", printed.err)),
    )
}

/// Output and files of the report of the default drive.
pub static DEFAULT_REPORT: LazyLock<Written> = LazyLock::new(|| written(&["report"]));

fn report(args: &[&str]) -> (i32, String) {
    if args.is_empty() {
        return first_page(&DEFAULT_REPORT);
    }
    page(&tempfile::tempdir().unwrap(), &[&["report"], args].concat())
}

/// A part of a page, from one text to another.
fn part<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    let (_, rest) = page
        .split_once(from)
        .unwrap_or_else(|| panic!("no '{from}' in {page}"));
    rest.split_once(to)
        .unwrap_or_else(|| panic!("no '{to}' after '{from}'"))
        .0
}

/// The text between the tags, in one system of units.
fn words(html: &str, system: &str) -> String {
    let other = if system == "us" { "metric" } else { "us" };
    let mut text = String::new();
    for piece in html.split(&format!("<span class=\"{other}\">")).enumerate() {
        let rest = if piece.0 == 0 {
            piece.1
        } else {
            piece.1.split_once("</span>").unwrap().1
        };
        text += rest;
    }
    let mut is_tag = false;
    let kept = text.chars().filter(|c| {
        is_tag = *c == '<' || is_tag && *c != '>';
        !is_tag && *c != '>'
    });
    kept.collect()
}

fn answer(page: &str) -> &str {
    part(page, "<main>", "</section>")
}

#[test]
fn the_answer_is_the_first_thing_on_the_page() {
    let (status, page) = report(&[]);
    assert_eq!(status, 0);
    let (_, yours) = json(&["simulate"]);
    let (_, best) = json(&["optimize"]);
    let yard = 0.9144;
    let [yours, best_carry] =
        [&yours["flight"]["carry"], &best["value"]].map(|value| number(value) / yard);
    // the printed gain is the difference of the printed carries
    let [yours, best_carry] = [yours, best_carry].map(|value| (10.0 * value).round() / 10.0);
    let gain = format!("+{:.1} yd", best_carry - yours);
    let printed = words(answer(&page), "us");
    assert!(
        printed.starts_with(&format!("Carry {yours:.1} → {best_carry:.1} yd: {gain}")),
        "{printed}"
    );
    let text = longdrive(&["optimize"]).out;
    let line = format!("carry {yours:.1} yd → {best_carry:.1} yd: {gain}; total");
    assert!(text.contains(&line), "{text}");
    let gain = number(&best["multipliers"]["swing.attack_angle"]["upper"]).to_radians() / yard;
    assert!(
        printed.contains(&format!(
            "at its upper bound: +{gain:.2} yd for each degree that it is raised"
        )),
        "{printed}"
    );
    assert_eq!(
        answer(&page).matches("±").count(),
        4,
        "yours, best and change, and what it is"
    );
    let metric = words(answer(&page), "metric");
    assert!(
        metric.contains(" m: +") && !metric.contains("yd"),
        "{metric}"
    );
}

#[test]
fn the_page_of_a_lateral_states_what_moves_it() {
    let folder = tempfile::tempdir().unwrap();
    let (_, page) = page(
        &folder,
        &[
            "report",
            "--minimize",
            "lateral",
            "--set",
            "swing.path=2deg",
        ],
    );
    assert_eq!(
        answer(&page).matches("±").count(),
        4,
        "yours, best and change, and what it is"
    );
    for of in ["lateral", "carry"] {
        let plot = format!("page/tornado-{of}-control-us.svg");
        assert!(folder.path().join(&plot).exists(), "{plot}");
    }
}

/// The cells (`td`) of a table of a page, row by row, in US units.
fn cells(table: &str) -> Vec<Vec<String>> {
    let rows = table.split("<tr>").skip(1);
    let cell = |cell: &str| {
        let (_, text) = cell.split_once('>').unwrap();
        words(text, "us").trim().to_owned()
    };
    rows.map(|row| row.split("<td").skip(1).map(cell).collect())
        .collect()
}

#[test]
fn same_gain_of_the_club_and_of_the_swing_on_the_page_and_in_optimize() {
    let (_, page) = report(&[]);
    let (_, best) = json(&["optimize"]);
    let alone = &best["club_alone"];
    let yard = 0.9144;
    let value = number(&best["value"]);
    let with_swing = value / yard;
    let with_club = (value - number(&alone["swing_gain"])) / yard;
    let yours = with_club - number(&alone["club_gain"]) / yard;
    let table = cells(part(answer(&page), "<table class=\"steps\">", "</table>"));
    assert_eq!(table[1][0], "Carry");
    for (cell, carry) in table[1][1..].iter().zip([yours, with_club, with_swing]) {
        assert_eq!(*cell, format!("{carry:.1} yd"));
    }
    assert_eq!(table[2][0], "Total");
    let loft = table
        .iter()
        .find(|row| row.first().is_some_and(|name| name == "Club loft"));
    let club = number(&alone["optimum"]["club.loft"]).to_degrees();
    assert_eq!(loft.unwrap()[2], format!("{club:.2}°"));
    // columns of the table: the drive as set up, with the best club, and with the best club and
    // swing
    let attack = table
        .iter()
        .find(|row| row.first().is_some_and(|name| name == "Attack angle"));
    assert_eq!(attack.unwrap()[1], attack.unwrap()[2]);
    assert_ne!(attack.unwrap()[2], attack.unwrap()[3]);
    // a search over the club alone has only two columns of drives
    let (_, page) = report(&["--vary", "club.loft=4deg..20deg"]);
    let table = cells(part(answer(&page), "<table class=\"steps\">", "</table>"));
    assert_eq!(table[1].len(), 3);
}

/// What the answer assumes of shaft and strike stands on the page as in the text of `optimize`.
#[test]
fn the_page_has_the_advice_of_the_answer() {
    let arguments = [
        "--speed",
        "92mph",
        "--loft",
        "10.5deg",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    let (_, page) = report(&arguments);
    let (_, found) = json(&[&["optimize"][..], &arguments].concat());
    let advice = found["advice"].as_str().unwrap();
    assert!(advice.starts_with("the loft is for the shaft and strike of tour-average"));
    let printed = words(answer(&page), "us");
    assert!(printed.contains(&advice[1..]), "{printed}");
}

#[test]
fn same_carry_and_total_by_loft_and_attack_angle_and_alone() {
    let (_, page) = report(&["--set", "swing.speed=95mph"]);
    let table = cells(part(&page, "<table class=\"lofts\">", "</table>"));
    let head = part(&page, "<table class=\"lofts\">", "</thead>");
    let attacks: Vec<String> = head
        .split("<th class=\"number\" scope=\"col\">")
        .skip(1)
        .map(|cell| cell.split_once('<').unwrap().0.replace('−', "-"))
        .collect();
    let rows: Vec<_> = table.iter().filter(|row| !row.is_empty()).collect();
    assert_eq!((attacks.len(), rows.len()), (5, 7));
    for (row, column) in [(0, 0), (3, 2), (6, 4)] {
        let loft = format!("club.loft={}", rows[row][0].replace('°', "deg"));
        let attack = format!("swing.attack_angle={}", attacks[column].replace('°', "deg"));
        let set = [
            "--set",
            "swing.speed=95mph",
            "--set",
            &loft,
            "--set",
            &attack,
        ];
        let (_, drive) = json(&[&["simulate"][..], &set].concat());
        let [carry, total] = ["carry", "total"].map(|of| number(&drive["flight"][of]) / 0.9144);
        assert_eq!(
            rows[row][1 + column],
            format!("{carry:.1}{total:.1}"),
            "{set:?}"
        );
    }
    // the longest carry of a column is bold if it is longer than the column's first and last carry
    let carry_of = |cell: &str| -> f64 {
        let (whole, rest) = cell.split_once('.').unwrap();
        format!("{whole}.{}", &rest[..1]).parse().unwrap()
    };
    let inside = (1..=attacks.len())
        .filter(|&column| {
            let carries: Vec<f64> = rows.iter().map(|row| carry_of(&row[column])).collect();
            let longest = carries.iter().copied().fold(0.0, f64::max);
            carries[0] < longest && carries[rows.len() - 1] < longest
        })
        .count();
    assert!((1..attacks.len()).contains(&inside), "{rows:?}");
    assert_eq!(
        part(&page, "<table class=\"lofts\">", "</table>")
            .matches("<strong>")
            .count(),
        inside
    );
    let (_, page) = report(&[
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm",
    ]);
    assert!(!page.contains("<table class=\"lofts\">"), "no club");
}

/// A common error changes both drives: between two equal drives the change has no uncertainty.
#[test]
fn exact_zero_uncertainty_of_the_change_to_an_equal_drive() {
    use longdrive::study::{effects, with_defaults};
    use longdrive::{Outcome, Setup};
    let setup = Setup::modern_driver();
    let sigmas = with_defaults(&setup, &[], &[Outcome::Carry]).unwrap();
    let of = |setup: &Setup<f64>| {
        effects(setup, &[Outcome::Carry], &sigmas, &|_, _| ())
            .unwrap()
            .pop()
            .unwrap()
    };
    let here = of(&setup);
    assert_eq!(here.uncertainty_of_change(&here), 0.0);
    let mut other = setup;
    other.set("club.loft", "14 deg").unwrap();
    let there = of(&other);
    // expected: √Σ(σ Δ)² over the parameters, with the difference Δ of the two derivatives
    let slope = |of: &longdrive::study::Effects, name: &str| {
        of.effects
            .iter()
            .find(|effect| effect.parameter.name == name)
            .unwrap()
            .gradient
    };
    let square = |sigma: &longdrive::study::Sigma| {
        let name = sigma.parameter.name;
        (sigma.value * (slope(&there, name) - slope(&here, name))).powi(2)
    };
    let expected: f64 = sigmas.iter().map(square).sum::<f64>().sqrt();
    crate::common::close(
        here.uncertainty_of_change(&there),
        expected,
        expected,
        1e-12,
        "the change",
    );
    // the second drive has the uncertainties of only three parameters
    let few = effects(&other, &[Outcome::Carry], &sigmas[..3], &|_, _| ()).unwrap();
    let ways = [
        here.uncertainty_of_change(&few[0]),
        few[0].uncertainty_of_change(&here),
    ];
    crate::common::close(ways[0], ways[1], expected, 1e-12, "both ways");
}

/// An error of 2° of loft moves this drive and its optimum in opposite directions: the change has a
/// larger uncertainty than both.
#[test]
fn a_change_is_known_better_only_if_its_uncertainty_is_smaller_than_both() {
    let steep = ["--loft", "13deg", "--vary", "club.loft=4deg..20deg"];
    let opposite = ["--subject-to", "apex_height <= 25 yd", "--sigma"];
    let opposite = [&steep[..], &opposite, &["club.loft=2deg"]].concat();
    for (args, is_better) in [(&opposite[..], false), (&[], true)] {
        let (status, page) = report(args);
        assert_eq!(status, 0, "{args:?}");
        let text = words(answer(&page), "us");
        let known: Vec<f64> = text
            .split("± ")
            .skip(1)
            .filter_map(|rest| rest.split(' ').next()?.parse().ok())
            .collect();
        let [yours, best, change] = known[..3] else {
            panic!("{text}");
        };
        assert_eq!(change < yours.min(best), is_better, "{text}");
        assert_eq!(text.contains("known better"), is_better, "{text}");
    }
}

#[test]
fn the_uncertainty_of_a_total_and_the_names_in_data_files_have_the_chosen_units() {
    let folder = tempfile::tempdir().unwrap();
    for (units, within, apex) in [("us", "10 yd", " yd"), ("metric", "9.1 m", " m")] {
        let (_, page) = page(&folder, &["report", "--units", units]);
        let text = words(&page, units);
        for sentence in [
            format!("A total is known to {within} at best."),
            format!("which is known within {within} at best."),
        ] {
            assert!(text.contains(&sentence), "{units}: {sentence}");
        }
        let data = folder.path().join("page").join("trajectory-side.csv");
        let data = std::fs::read_to_string(data).unwrap();
        let mark = data.lines().find(|line| line.starts_with("mark,apex"));
        let name = mark.unwrap().split(',').nth(1).unwrap();
        assert!(name.ends_with(apex), "{units}: {name}");
        let text = longdrive(&["optimize", "--units", units]).out;
        let totals = format!("(totals ± {within} at best)");
        assert!(text.contains(&totals), "{text}");
    }
}

#[test]
fn the_title_states_the_arguments() {
    let (_, page) = report(&[
        "modern-driver",
        "--set",
        "swing.speed=60mph",
        "--set",
        "wind.speed=5mph",
        "--set",
        "wind.from=0deg",
    ]);
    assert!(
        !page.contains("at 110 mph"),
        "the description of the preset is for another drive"
    );
    let head = words(part(&page, "<header>", "</header>"), "us");
    assert!(
        head.contains("modern-driver") && head.contains("3 changes"),
        "{head}"
    );
    let requested = words(part(&page, "What was asked", "</section>"), "us");
    for printed in [
        "club speed 60 mph",
        "club speed 110 → 60 mph",
        "wind speed 5 mph, wind from 0",
        "4 to 20",
        "modern-driver",
    ] {
        assert!(requested.contains(printed), "no '{printed}' in {requested}");
    }
    let (_, page) = report(&["modern-driver", "--set", "swing.speed=60mph"]);
    assert!(
        words(part(&page, "<h1>", "</h1>"), "us").ends_with("modern-driver, club speed 60 mph")
    );
    assert!(
        words(part(&page, "<h1>", "</h1>"), "metric").contains("26.8"),
        "and in the other units"
    );
    let (_, page) = report(&["modern-driver"]);
    assert!(
        page.contains("A 460 cc driver of the 2020s at 110 mph")
            && page.contains("modern-driver, as it is")
    );
}

#[test]
fn the_title_names_the_first_changes_and_counts_the_others() {
    let set = [
        "swing.speed=105mph",
        "strike.toe=15mm",
        "wind.speed=15mph",
        "wind.from=60deg",
    ];
    let args: Vec<&str> = set.into_iter().flat_map(|text| ["--set", text]).collect();
    let title = |args: &[&str]| words(part(&report(args).1, "<h1>", "</h1>"), "us");
    assert_eq!(
        title(&args),
        "Drive: tour-average, club speed 105 mph, strike toe 15 mm and 2 more"
    );
    let three = [&args[..4], &["--set", "strike.high=0mm"]].concat();
    assert_eq!(
        title(&three),
        "Drive: tour-average, club speed 105 mph, strike high 0 mm, strike toe 15 mm"
    );
}

#[test]
fn the_page_of_a_launch_is_about_its_launch_and_no_club() {
    let launch = "ball_speed=150mph,launch_angle=11deg,backspin=2900rpm";
    let (_, page) = report(&["--launch", launch]);
    let title = words(part(&page, "<h1>", "</h1>"), "us");
    assert_eq!(
        title,
        "Drive: ball speed 150 mph, launch angle 11°, backspin 2900 rpm"
    );
    let requested = words(part(&page, "What was asked", "</section>"), "us");
    assert!(
        requested.contains("those of the preset tour-average") && !requested.contains("as it is"),
        "{requested}"
    );
    let setup = words(part(&page, "All numbers of the setup", "</table>"), "us");
    assert!(
        setup.contains("launch.spinnonenot needed: backspin is given"),
        "{setup}"
    );
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    let text = "golfer = 'left'\nswing.speed_of = 'face-centre'\ngravity = '9.8 m/s^2'\n";
    std::fs::write(&file, text).unwrap();
    let (_, page) = report(&[file.to_str().unwrap(), "--launch", launch]);
    let requested = words(part(&page, "What was asked", "</section>"), "us");
    assert!(
        requested.contains("changed: gravity")
            && !requested.contains("golfer")
            && !requested.contains("club"),
        "{requested}"
    );
    let printed = longdrive(&["plot", "face", "--launch", launch, "-o", "face.svg"]);
    assert!(
        printed.status != 0 && printed.err.contains("no face to draw"),
        "{}",
        printed.err
    );
}

#[test]
fn the_reason_of_no_flight_is_printed_once_and_first() {
    let (_, page) = report(&[
        "--set",
        "swing.attack_angle=-20deg",
        "--set",
        "club.loft=2deg",
    ]);
    assert_eq!(page.matches("which is not above the horizontal").count(), 1);
    let printed = words(answer(&page), "us");
    assert!(
        printed.contains("As set up: no flight: the ball leaves at −14.3°"),
        "{printed}"
    );
}

#[test]
fn a_ball_that_flies_and_does_not_come_to_rest_is_not_said_to_stay_on_the_ground() {
    let (_, page) = report(&["--maximize", "total", "--set", "ground.slope=-40deg"]);
    let printed = words(answer(&page), "us");
    assert!(
        printed.starts_with("As set up there is no total") && !printed.contains("does not fly"),
        "{printed}"
    );
    assert!(page.contains("the ball does not come to rest"));
}

#[test]
fn the_usual_chart_holds_the_speed_as_set_up() {
    for (speed, holds) in [
        ("115mph", ["80", "130"]),
        ("20mph", ["10", "45"]),
        ("160mph", ["135", "185"]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        page(
            &folder,
            &["report", "--set", &format!("swing.speed={speed}")],
        );
        let csv =
            std::fs::read_to_string(folder.path().join("page/chart-carry-by-swing-speed.csv"))
                .unwrap();
        let along: Vec<f64> = csv
            .lines()
            .filter(|line| line.starts_with("line,optimum"))
            .filter_map(|line| line.split(',').nth(2)?.parse().ok())
            .collect();
        let ends = [
            along.iter().copied().fold(f64::MAX, f64::min),
            along.iter().copied().fold(0.0, f64::max),
        ];
        for (end, mph) in ends.into_iter().zip(holds) {
            crate::common::close(
                end,
                mph.parse::<f64>().unwrap() * 0.44704,
                50.0,
                1e-6,
                speed,
            );
        }
    }
}

#[test]
fn a_drive_of_a_yard_allows_a_loss_of_one_percent_and_has_no_ellipses() {
    let (_, page) = report(&["--set", "swing.speed=3mph"]);
    let page = words(&page, "us");
    assert!(
        !page.contains("for a loss of 1.00 yd")
            && page.contains("the loss that is allowed is 1 % of this carry")
    );
    // no ellipses at 1 mph: the assumed uncertainty of the club speed, 0.5 mph, is too large there
    assert!(page.contains("The ellipses contain the landing"));
    assert!(page.contains("at the edge of the searched face"));
    let (_, page) = report(&["--set", "swing.speed=1mph"]);
    assert!(
        page.contains("As set up: no ellipses are drawn")
            && !page.contains("The ellipses contain the landing")
    );
}

#[test]
fn the_setup_file_of_a_report_flies_its_best_drive() {
    let folder = tempfile::tempdir().unwrap();
    // the table of drag and lift is in a folder of its own
    let table = folder.path().join("mine.csv");
    std::fs::write(
        &table,
        "spin_ratio,cd,cl\n0,0.22,0\n0.1,0.24,0.15\n0.3,0.28,0.25\n",
    )
    .unwrap();
    let set = format!("aero.table={}", table.display());
    let launched = [
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm",
    ];
    for requested in [
        vec!["mae494"],
        vec![
            "--set",
            "swing.speed=60mph",
            "--subject-to",
            "descent_angle >= 30 deg",
        ],
        vec!["--set", &set],
        [
            &launched[..],
            &["--vary", "launch.launch_angle=5deg..20deg"],
        ]
        .concat(),
    ] {
        let (status, page) = page(&folder, &[&["report"], &requested[..]].concat());
        assert!(
            status == 0 && page.contains("href=\"setup.toml\""),
            "{requested:?}"
        );
        let (_, best) = json(&[&["optimize"], &requested[..]].concat());
        let file = folder.path().join("page/setup.toml").display().to_string();
        let (_, drive) = json(&["simulate", &file]);
        // the report, `optimize` and `simulate` choose different steps, so the carries differ by up
        // to a micrometre
        crate::common::close(
            number(&drive["flight"]["carry"]),
            number(&best["value"]),
            1.0,
            1e-6,
            "the best carry",
        );
    }
    // without a best drive the page shows the drive of the setup
    let (status, page) = page(
        &folder,
        &[
            "report",
            "--set",
            "swing.speed=70mph",
            "--subject-to",
            "descent_angle >= 80 deg",
        ],
    );
    assert!(status == 1 && page.contains("the drive as set up"));
    let file = folder.path().join("page/setup.toml").display().to_string();
    let [(_, drive), (_, requested)] = [
        json(&["simulate", &file]),
        json(&["simulate", "--set", "swing.speed=70mph"]),
    ];
    crate::common::close(
        number(&drive["flight"]["carry"]),
        number(&requested["flight"]["carry"]),
        100.0,
        1e-7,
        "carry",
    );
}

#[test]
fn the_footer_has_the_command_of_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let made = |date: &str| {
        let mut command = program::command();
        let requested = [
            "report",
            "--set",
            "club.loft=10.5 deg",
            "-o",
            "page",
            "--overwrite",
        ];
        let output = command
            .current_dir(folder.path())
            .env("SOURCE_DATE_EPOCH", date)
            .args(requested)
            .output()
            .unwrap();
        (
            output.status.code(),
            std::fs::read_to_string(folder.path().join("page/index.html")).unwrap_or_default(),
        )
    };
    let (_, first) = made("951782400");
    let footer = words(part(&first, "<footer>", "</footer>"), "us");
    for printed in [
        "The search: converged",
        "2000-02-29",
        env!("CARGO_PKG_VERSION"),
        "longdrive report --set 'club.loft=10.5 deg' -o page --overwrite",
    ] {
        assert!(footer.contains(printed), "no '{printed}' in {footer}");
    }
    assert_eq!(made("951782400").1, first, "to the last letter");
    assert!(
        made("951868800").1.contains("2000-03-01") && made("4107542400").1.contains("2100-03-01")
    );
    assert_eq!(made("yesterday").0, Some(2));
}

#[test]
fn a_missing_answer_is_reported_first() {
    let (status, page) = report(&["--subject-to", "descent_angle >= 80 deg"]);
    let printed = words(answer(&page), "us");
    assert!(
        status == 1
            && printed.contains("no best drive was found")
            && printed.contains("no optimum: infeasible"),
        "{printed}"
    );
    assert!(
        printed.contains("286.0 yd"),
        "the drive of the setup: {printed}"
    );
    let (status, page) = report(&["--set", "swing.attack_angle=-15deg"]);
    let printed = words(answer(&page), "us");
    assert!(
        status == 1
            && printed.contains("at best; as set up there is no carry")
            && printed.contains("As set up: "),
        "{printed}"
    );
    let (status, page) = report(&[
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm",
    ]);
    let printed = words(answer(&page), "us");
    assert!(
        status == 0
            && printed.starts_with("Carry 2")
            && printed.contains("for example --vary launch.launch_angle"),
        "{printed}"
    );
    let down = [
        "--set",
        "swing.attack_angle=-20deg",
        "--vary",
        "swing.attack_angle=-40deg..-30deg",
    ];
    let (status, page) = report(&down);
    let printed = words(answer(&page), "us");
    assert!(
        status == 1
            && printed.contains("the ball does not fly")
            && printed.contains("no optimum: no-flight"),
        "{printed}"
    );
}

#[test]
fn all_pages_have_one_frame() {
    let folder = tempfile::tempdir().unwrap();
    let shots = format!("{}/../examples/shots.csv", env!("CARGO_MANIFEST_DIR"));
    let fit = ["--fit", "aero.cd0", "--fit", "aero.cl_max=0.2..1"];
    for requested in [
        vec!["report"],
        vec!["reproduce", "mae494"],
        vec!["reproduce", "winfield-tan"],
        vec!["validate", "--units", "metric"],
        [&["calibrate", &shots, "modern-driver"], &fit[..]].concat(),
    ] {
        let (status, page) = match requested[..] {
            ["report"] => first_page(&DEFAULT_REPORT),
            ["reproduce", "mae494"] => first_page(&REPORT),
            ["reproduce", "winfield-tan"] => first_page(&PAPER_WRITTEN),
            ["validate", "--units", "metric"] => first_page(&VALIDATED),
            _ => page(&folder, &requested),
        };
        assert_eq!(status, 0, "{requested:?}");
        for once in [
            "<main>",
            "<h1>",
            "<header>",
            "id=\"units-us\" type=\"radio\"",
            "name=\"viewport\"",
        ] {
            assert_eq!(page.matches(once).count(), 1, "{requested:?}: {once}");
        }
        // a table that is wider than a phone scrolls by keys, and has a name for screen readers
        let tables = page.matches("<table").count();
        let labels: Vec<&str> = page
            .split("<section class=\"wide\" tabindex=\"0\" aria-label=\"")
            .skip(1)
            .collect();
        let mut names: Vec<&str> = labels
            .iter()
            .map(|rest| rest.split_once('"').unwrap().0)
            .collect();
        names.sort_unstable();
        names.dedup();
        // the table of steps in the answer fits every screen
        let tables = tables - page.matches("<table class=\"steps\"").count();
        assert!(
            tables > 0 && names.len() == tables && !names.contains(&""),
            "{requested:?}: {names:?}"
        );
        // every figure has a picture and a data file
        for end in ["-us.svg\"", ".csv\""] {
            assert_eq!(
                page.matches(end).count(),
                page.matches("<figure").count(),
                "{requested:?}: {end}"
            );
        }
        assert!(
            !page.contains("<th></th>") && !page.contains("NaN"),
            "{requested:?}"
        );
    }
}

#[test]
fn published_peak_of_the_average_of_winfield_and_tan_is_drawn() {
    let csv = PAPER_WRITTEN.file("average.csv");
    let rows = |name: &str| -> Vec<[f64; 2]> {
        let rows = csv
            .lines()
            .map(|line| line.split(',').collect::<Vec<_>>())
            .filter(|cells| cells[1] == name);
        rows.map(|cells| [2, 3].map(|at| cells[at].parse().unwrap()))
            .collect()
    };
    let curve = rows("polynomial of fifth order");
    let top = curve.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
    assert!(
        curve.len() > 50 && (top[0].to_degrees() - 10.35).abs() < 0.05,
        "{top:?}"
    );
    let computed = rows("computed");
    assert_eq!(computed.len(), 6);
    for [loft, carry] in computed {
        let near = curve
            .iter()
            .min_by(|a, b| (a[0] - loft).abs().total_cmp(&(b[0] - loft).abs()))
            .unwrap();
        assert!(
            (near[1] - carry).abs() < 1e-9,
            "the curve misses a computed point: {near:?} {carry}"
        );
    }
    let [mark] = rows("10.35°")[..] else {
        panic!("{csv}")
    };
    assert!((mark[1] - top[1]).abs() < 0.01, "{mark:?} {top:?}");
}

#[test]
fn a_page_of_a_calibration_plots_measured_over_computed_values() {
    let folder = tempfile::tempdir().unwrap();
    let shots = folder.path().join("shots.csv");
    std::fs::copy(
        format!("{}/../examples/shots.csv", env!("CARGO_MANIFEST_DIR")),
        &shots,
    )
    .unwrap();
    let shots = shots.display().to_string();
    let requested = ["calibrate", &shots, "modern-driver", "--fit", "aero.cd0"];
    let (_, page) = page(&folder, &requested);
    assert!(
        part(&page, "<h1>", "</h1>") == "Calibration to shots.csv",
        "the file name without its folder"
    );
    let (_, found) = json(&requested);
    let csv =
        std::fs::read_to_string(folder.path().join("page/measured-carry-distance.csv")).unwrap();
    let rows = |name: &str| -> Vec<Vec<f64>> {
        let rows = csv
            .lines()
            .map(|line| line.split(',').collect::<Vec<_>>())
            .filter(|cells| cells[1] == name);
        rows.map(|cells| {
            cells[2..]
                .iter()
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect()
    };
    let carries = found["residuals"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|row| row["of"] == "carry_distance");
    let (drawn, bars) = (rows("shots"), rows("± one standard uncertainty"));
    assert_eq!(drawn.len(), 12);
    for (i, row) in carries.enumerate() {
        let (measured, difference) = (number(&row["measured"]), number(&row["difference"]));
        crate::common::close(drawn[i][0], measured + difference, 200.0, 1e-12, "computed");
        crate::common::close(drawn[i][1], measured, 200.0, 1e-12, "measured");
        // three rows draw an error bar: its two ends, and NaN after them
        let half = 0.5 * (bars[3 * i + 1][1] - bars[3 * i][1]);
        crate::common::close(
            half,
            (difference / number(&row["residual"])).abs(),
            1.0,
            1e-9,
            "the instrument",
        );
    }
    assert!(
        rows("equal").iter().all(|end| end[0] == end[1]),
        "the line of equality"
    );
}
