//! `validate`: every law compared with published drives. Its numbers are computed here in another
//! way, and the documents have the same numbers.

use crate::command_line::{WHOLE, Written, json, longdrive, written};
use crate::common::{close, number};
use longdrive::report::plot::{Look, figure_svg};
use longdrive::report::{Report, ValidationReport};
use longdrive::study::validation::{Compared, SCATTER, SetScores, validation};
use longdrive::units::{System, TableUnits};
use serde_json::Value;
use std::sync::LazyLock;

static FOUND: LazyLock<Vec<SetScores>> = LazyLock::new(|| validation(None).unwrap());
/// Output and files of `validate` in a folder.
pub static VALIDATED: LazyLock<Written> =
    LazyLock::new(|| written(&["validate", "--units", "metric"]));
pub static ANSWERED: LazyLock<(i32, Value)> = LazyLock::new(|| json(&["validate"]));

fn set(name: &str) -> &'static SetScores {
    FOUND.iter().find(|set| set.set.name == name).unwrap()
}

fn differences(of: &SetScores, law: &str, compared: Compared) -> Vec<f64> {
    let law = of.laws.iter().find(|one| one.law == law).unwrap();
    let score = law
        .scores
        .iter()
        .find(|score| score.of == compared)
        .unwrap();
    score
        .residuals
        .iter()
        .map(|residual| residual.difference)
        .collect()
}

#[test]
fn a_part_of_pictures_alone_is_left_out_of_the_text() {
    let document = ValidationReport { sets: &FOUND }.document(System::Us);
    let (text, markdown) = (document.text(&WHOLE), document.markdown());
    assert!(
        document.figures().next().is_some()
            && markdown.contains("In pictures")
            && !text.contains("In pictures")
    );
    for set in FOUND.iter() {
        assert!(text.contains(set.set.name), "{}", set.set.name);
    }
}

#[test]
fn number_of_published_drives_of_every_set() {
    let counts: Vec<_> = FOUND
        .iter()
        .map(|set| (set.set.name, set.cases.len()))
        .collect();
    let chart = [
        "chart-optima",
        "chart-optima-centred",
        "chart-optima-impact",
    ]
    .map(|name| (name, 30));
    let expected = [
        ("pga-driver", 3),
        ("lpga-driver", 2),
        ("pga-radar", 5),
        ("pga-clubs", 22),
        ("lpga-clubs", 20),
    ];
    let others = [
        ("robots", 5),
        ("altitude", 7),
        ("altitude-alone", 7),
        ("face-to-path", 4),
        ("chart-launches", 60),
    ];
    assert_eq!(
        counts,
        [&expected[..], &others, &chart, &[("simulations", 8)]].concat()
    );
    for set in FOUND.iter() {
        assert!(
            set.cases
                .iter()
                .all(|case| !case.source.is_empty() && !case.name.is_empty()),
            "{}",
            set.set.name
        );
        assert_eq!(set.laws.len(), longdrive::parameters::Law::NAMES.len());
        // every law has a computed value for every published value
        for law in &set.laws {
            for score in &law.scores {
                let published = set
                    .cases
                    .iter()
                    .filter(|case| case.published(score.of).is_some())
                    .count();
                assert_eq!(
                    score.residuals.len(),
                    published,
                    "{} {} {}",
                    set.set.name,
                    law.law,
                    score.of.name()
                );
            }
        }
    }
}

#[test]
fn same_rows_of_a_validation_and_drives_of_simulate() {
    let table = ValidationReport { sets: &FOUND }
        .csv(TableUnits::Si)
        .unwrap();
    let rows: Vec<Vec<&str>> = table
        .lines()
        .skip(1)
        .map(|line| line.splitn(9, ',').collect())
        .filter(|row: &Vec<_>| row.len() == 9)
        .collect();
    let of = |case: &str, law: &str, quantity: &str| {
        let row = rows
            .iter()
            .find(|row| row[..4] == ["pga-driver", case, law, quantity])
            .unwrap();
        row[5].parse::<f64>().unwrap()
    };
    for law in ["launch-monitor", "lyu", "bearman-harvey"] {
        let given = [
            "--launch",
            "ball_speed=171mph,launch_angle=10.4deg,spin=2545rpm",
            "--set",
        ];
        let law_is = format!("aero.law={law}");
        let (_, drive) = json(&[&["simulate", "modern-driver"], &given[..], &[&law_is]].concat());
        for (quantity, outcome) in [
            ("carry", "carry_distance"),
            ("apex", "apex_height"),
            ("descent", "descent_angle"),
        ] {
            close(
                of("2023 driver", law, quantity),
                number(&drive["flight"][outcome]),
                1.0,
                1e-5,
                quantity,
            );
        }
    }
    let found = &ANSWERED.1["sets"][0];
    assert_eq!(found["name"], "pga-driver");
    for law in found["laws"].as_array().unwrap() {
        let differences: Vec<f64> = rows
            .iter()
            .filter(|row| row[0] == "pga-driver" && law["law"] == row[2] && row[3] == "carry")
            .map(|row| row[7].parse().unwrap())
            .collect();
        let mean = |of: fn(f64) -> f64| {
            differences.iter().map(|&it| of(it)).sum::<f64>() / differences.len() as f64
        };
        let carry = &law["scores"]["carry"];
        close(number(&carry["bias"]), mean(|it| it), 1.0, 1e-12, "bias");
        close(
            number(&carry["mean_absolute_error"]),
            mean(f64::abs),
            1.0,
            1e-12,
            "MAE",
        );
    }
}

#[test]
fn same_mean_of_scattered_drives_and_of_uncertainty() {
    let launches = [
        (171.0, 10.4, 2545.0),
        (167.0, 10.9, 2686.0),
        (165.0, 11.2, 2685.0),
    ];
    let sigmas: Vec<String> = SCATTER
        .iter()
        .map(|(name, sigma)| {
            let unit = match *name {
                "launch.launch_angle" | "launch.spin_axis" => "rad",
                "launch.spin" => "rad/s",
                _ => "m/s",
            };
            format!("{name}={sigma:?}{unit}")
        })
        .collect();
    let mut less = 0.0;
    for (speed, angle, spin) in launches {
        let launch =
            format!("ball_speed={speed}mph,launch_angle={angle}deg,spin={spin}rpm,spin_axis=0deg");
        let mut requested = vec![
            "uncertainty",
            "modern-driver",
            "--samples",
            "16",
            "--of",
            "carry_distance",
        ];
        requested.extend(["--launch", &launch]);
        requested.extend(sigmas.iter().flat_map(|sigma| ["--sigma", sigma]));
        let (status, found) = json(&requested);
        assert_eq!(status, 0, "{found}");
        let mean = |way: &str| number(&found["outcomes"][0][way]["mean"]);
        less += (mean("second_order") - mean("delta")) / 3.0;
    }
    let law = set("pga-driver")
        .laws
        .iter()
        .find(|law| law.law == "launch-monitor")
        .unwrap();
    close(
        law.averaged.unwrap() - law.scores[0].bias.unwrap(),
        less,
        1.0,
        1e-4,
        "averaging",
    );
}

/// With an impact like the chart's, the law `ferguson` has mean errors of at most 1° of launch
/// angle, 250 rpm and 2 % of carry. `published.rs` has these bounds for `lpga-average`.
#[test]
fn published_optima_of_trackmans_chart_are_met_by_an_impact_like_the_charts() {
    let of = set("chart-optima-impact");
    let carries = of
        .cases
        .iter()
        .map(|case| case.published(Compared::Carry).unwrap())
        .sum::<f64>()
        / 30.0;
    let law = of.laws.iter().find(|law| law.law == "ferguson").unwrap();
    let [carry, launch, spin] = [0, 1, 2].map(|at| law.scores[at].mean_absolute_error.unwrap());
    let (launch, spin) = (launch.to_degrees(), spin * 60.0 / std::f64::consts::TAU);
    assert!(
        carry < 0.02 * carries && launch < 1.0 && spin < 250.0,
        "{carry} m, {launch} deg, {spin} rpm"
    );
    // the impact of the default club gives too little spin: its optimum has the launch angle of the
    // chart, but less spin
    let of = set("chart-optima");
    let of_default = |compared| differences(of, "launch-monitor", compared);
    let mean = |of: Vec<f64>| of.iter().sum::<f64>() / 30.0;
    assert!(mean(of_default(Compared::LaunchAngle)).to_degrees().abs() < 1.0);
    assert!(mean(of_default(Compared::Spin)) * 60.0 / std::f64::consts::TAU < -500.0);
}

/// The sentences of `validate` about the sets of other clubs agree with its numbers.
#[test]
fn misses_of_the_other_clubs_in_the_text_are_those_of_the_table() {
    for name in ["pga-clubs", "lpga-clubs"] {
        let set = set(name);
        assert!(
            set.set
                .misses
                .starts_with("No law meets carry and descent together."),
            "{}",
            set.set.misses
        );
        for law in &set.laws {
            let bias = |of: Compared| {
                law.scores
                    .iter()
                    .find(|score| score.of == of)
                    .unwrap()
                    .bias
                    .unwrap()
            };
            let (carry, descent) = (
                bias(Compared::Carry) / 0.9144,
                bias(Compared::Descent).to_degrees(),
            );
            let is_as_told = match law.law {
                "usga-itr" => (-13.0..-8.0).contains(&carry) && descent.abs() < 1.0,
                "lyu" => (38.0..53.0).contains(&carry) && (-2.5..-0.5).contains(&descent),
                "winfield-tan" => (-49.0..-32.0).contains(&carry) && (9.5..10.5).contains(&descent),
                _ => carry.abs() > 5.0 || (-6.5..-1.5).contains(&descent),
            };
            assert!(is_as_told, "{name} {}: {carry} yd, {descent}°", law.law);
        }
    }
}

/// Compares a file with the output of the program, after writing it if
/// `LONGDRIVE_WRITE_VALIDATION` is set.
fn is_output(file: &str, output: &str) {
    if std::env::var_os("LONGDRIVE_WRITE_VALIDATION").is_some() {
        std::fs::write(file, output).unwrap();
    }
    assert!(
        std::fs::read_to_string(file).unwrap_or_default() == output,
        "{file} differs from the output of validate; \
         LONGDRIVE_WRITE_VALIDATION=1 cargo test same_numbers_in_validation_md writes it"
    );
}

/// The worst club is off by more than the mean, so the text states the mean of each set.
#[test]
fn mean_error_of_the_descent_in_the_text_is_that_of_the_drives() {
    let document = ValidationReport { sets: &FOUND }.document(System::Us);
    let text = document.markdown();
    let mut stated = vec![];
    for name in ["pga-clubs", "lpga-clubs"] {
        let errors = differences(set(name), "launch-monitor", Compared::Descent);
        let mean = errors.iter().map(|error| error.abs()).sum::<f64>() / errors.len() as f64;
        let worst = errors.iter().map(|error| error.abs()).fold(0.0, f64::max);
        assert!(worst > 1.5 * mean, "{worst} {mean}");
        stated.push(format!("{:.1}° ({name})", mean.to_degrees()));
    }
    let sentence = "the mean absolute error of its descent angle over the other clubs is ";
    let sentence = format!("{sentence}{},", stated.join(" and "));
    assert!(text.contains(&sentence), "{sentence}");
}

/// The laws with the smallest mean error on each set of averaged drives, and the bias of the default
/// over these sets.
#[test]
fn exact_reasons_for_the_default_law_from_the_drives() {
    let document = ValidationReport { sets: &FOUND }.document(System::Us);
    let text = document.markdown();
    let sets = ["pga-driver", "lpga-driver", "pga-radar"].map(set);
    let mean = |of: &SetScores, law: &str, size: fn(f64) -> f64| {
        let errors = differences(of, law, Compared::Carry);
        errors.iter().map(|error| size(*error)).sum::<f64>() / errors.len() as f64 / 0.9144
    };
    let best = sets.map(|of| {
        let laws = of.laws.iter().map(|law| law.law);
        let best = laws.min_by(|a, b| mean(of, a, f64::abs).total_cmp(&mean(of, b, f64::abs)));
        format!("{} on {}", best.unwrap(), of.set.name)
    });
    let says = format!(
        "other laws have the smallest error of carry: {}.",
        best.join(", ")
    );
    assert!(text.contains(&says), "{says}");
    let bias = sets.map(|of| mean(of, "launch-monitor", |error| error));
    let [least, most] = [
        bias.into_iter().fold(f64::INFINITY, f64::min),
        bias.into_iter().fold(f64::NEG_INFINITY, f64::max),
    ];
    let says = format!("launch-monitor predicts {least:.1} to {most:.1} yd more, ferguson");
    assert!(text.contains(&says), "{says}");
}

/// Text, tables and pictures of docs/validation.md are the output of the program.
#[test]
fn same_numbers_in_validation_md_and_the_program() {
    let place = |name: &str| format!("{}/../docs/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(place("validation.md")).unwrap();
    let document = ValidationReport { sets: &FOUND }.document(System::Us);
    let markdown = document
        .markdown()
        .replace("\n## ", "\n### ")
        .replace("](validation-", "](pictures/validation-");
    let (_, body) = markdown.split_once("\n\n").unwrap();
    let (laws, sets) = body.split_at(body.find("### PGA TOUR averages, driver").unwrap());
    let results = place("../src/study/validation/results.md");
    let page = std::fs::read_to_string(&results).unwrap();
    let (head, _) = page.split_once("### ").unwrap();
    is_output(&results, &format!("{head}{}\n", sets.trim()));
    let mut figures = vec![];
    for figure in document.figures() {
        let svg = figure_svg(figure, &Look::default()).unwrap();
        let file = place(&format!("pictures/{}-us.svg", figure.name));
        is_output(&file, &svg);
        figures.push(figure.name.as_str());
    }
    let residuals = [
        "validation-carry-residuals",
        "validation-apex",
        "validation-descent",
        "validation-spin",
    ];
    assert_eq!(figures, [&["validation-carry"], &residuals[..]].concat());
    assert!(
        text.contains(laws.trim()),
        "docs/validation.md should have:\n{laws}"
    );
}

#[test]
fn a_folder_gets_a_page_and_markdown_and_two_formats_are_refused() {
    let output = &VALIDATED.output;
    assert!(
        output.status == 0 && output.out.contains("error of carry [m]"),
        "{}",
        output.err
    );
    // 30 optima of each law
    let data = VALIDATED.file("validation-spin.csv");
    assert_eq!(
        data.lines()
            .filter(|line| line.contains("ferguson"))
            .count(),
        30
    );
    assert!(!VALIDATED.file("validation-carry-us.svg").is_empty());
    for file in ["index.html", "report.md"] {
        let text = VALIDATED.file(file);
        assert!(
            text.contains("launch-monitor") && !text.contains("NaN"),
            "{file}"
        );
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("index.html"), "not ours").unwrap();
    assert_eq!(
        longdrive(&["validate", "-o", folder.path().to_str().unwrap()]).status,
        2
    );
    let output = longdrive(&["validate", "--csv", "--json"]);
    assert_eq!(output.status, 2, "{}", output.out);
    let answer: Value = serde_json::from_str(&output.out).unwrap();
    assert_eq!(answer["command"], "validate");
}

#[test]
fn a_name_that_ends_in_csv_gets_the_rows_and_other_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let output = longdrive(&["validate", "--units", "us", "-o", &place("v.csv")]);
    assert_eq!(output.status, 0, "{}", output.err);
    let rows = std::fs::read_to_string(place("v.csv")).unwrap();
    let us = TableUnits::Of(System::Us);
    assert_eq!(rows, ValidationReport { sets: &FOUND }.csv(us).unwrap());
    let printed = longdrive(&["validate", "--csv"]);
    let si = ValidationReport { sets: &FOUND }.csv(TableUnits::Si);
    assert_eq!(printed.out, si.unwrap());
    assert_eq!(longdrive(&["validate", "-o", &place("v.csv")]).status, 2);
    for command in [&["validate"][..], &["reproduce", "winfield-tan"]] {
        let output = longdrive(&[command, &["-o", &place("page.html")]].concat());
        assert!(
            output.status == 2 && output.err.contains(".html is the extension of a file"),
            "{}",
            output.err
        );
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

/// A user's table of drag and lift is compared like the laws.
#[test]
fn a_users_table_is_compared_and_listed_with_the_laws() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("mine.csv");
    let rows: String = (0..5)
        .map(|i| format!("{},{},{}\n", 0.1 * f64::from(i), 0.2, 0.05 * f64::from(i)))
        .collect();
    std::fs::write(&table, format!("spin_ratio,cd,cl\n{rows}")).unwrap();
    let set = format!("aero.table={}", table.display());
    let (status, found) = json(&["validate", "--set", &set]);
    assert_eq!(status, 0, "{found}");
    let laws = found["sets"][0]["laws"].as_array().unwrap();
    assert_eq!(laws.len(), longdrive::parameters::Law::NAMES.len() + 1);
    let mine = laws.last().unwrap();
    assert_eq!(mine["law"], "table");
    let launch = "ball_speed=171mph,launch_angle=10.4deg,spin=2545rpm";
    let (_, drive) = json(&[
        "simulate",
        "modern-driver",
        "--launch",
        launch,
        "--set",
        &set,
    ]);
    let predicted = number(&mine["scores"]["carry"]["residuals"][0]["predicted"]);
    close(
        predicted,
        number(&drive["flight"]["carry_distance"]),
        1.0,
        1e-5,
        "carry",
    );
    // the summary in the terminal has a column for the table
    let own = longdrive(&["validate", "--set", &set]);
    assert_eq!(own.status, 0, "{}", own.err);
    assert!(own.out.contains("your table"), "{}", own.out);
    assert!(!VALIDATED.output.out.contains("your table"));
    let (_, listed) = json(&["laws", "--set", &set]);
    assert_eq!(
        listed["laws"].as_array().unwrap().last().unwrap()["name"],
        "table"
    );
    for command in ["laws", "validate"] {
        for refused in ["aero.law=lyu", "club.loft=9deg", "aero.spin_decay=0.1/s"] {
            let output = longdrive(&[command, "--set", refused]);
            assert!(
                output.status == 2 && output.err.contains("aero.table=mine.csv"),
                "{refused}: {}",
                output.err
            );
        }
    }
}

#[test]
fn same_rows_of_a_validation_in_each_system() {
    let rows = |units: TableUnits| -> Vec<Vec<String>> {
        let text = ValidationReport { sets: &FOUND }.csv(units).unwrap();
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let records = reader.records().map(|record| record.unwrap());
        records
            .map(|record| record.iter().map(str::to_owned).collect())
            .collect()
    };
    let sizes = [("m", "yd", 0.9144), ("rad", "deg", 1.0_f64.to_radians())];
    let rpm = ("rad/s", "rpm", std::f64::consts::PI / 30.0);
    for (si, us) in rows(TableUnits::Si)
        .iter()
        .zip(rows(TableUnits::Of(System::Us)))
    {
        let size = sizes.into_iter().chain([rpm]).find(|size| size.0 == si[4]);
        let (_, unit, size) = size.unwrap();
        assert_eq!(us[4], unit);
        for column in 5..8 {
            let [si, us]: [f64; 2] = [&si[column], &us[column]].map(|cell| cell.parse().unwrap());
            assert!(
                (us * size - si).abs() <= 1e-12 * si.abs(),
                "{si} {us} {unit}"
            );
        }
    }
}
