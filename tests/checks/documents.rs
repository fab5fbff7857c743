//! Numbers in README and docs, compared with the output of the program.

use crate::command_line::{commands, file_with, json, longdrive, number, on_one_line};
use crate::reproduce::FOUND;
use crate::verification;
use longdrive::Outcome;
use longdrive::parameters::PRESETS;
use longdrive::reproduce::{LandingDefinition, SearchMethod};
use longdrive::units::typeset;
use std::collections::BTreeSet;

fn document(name: &str) -> String {
    std::fs::read_to_string(format!("{}/../{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The rows of the table below a head line, without that line and the rule below it.
fn table(text: &str, head: &str) -> Vec<Vec<String>> {
    let lines = text
        .lines()
        .skip_while(|line| !line.starts_with(head))
        .skip(2);
    let cells = |line: &str| {
        line.trim_matches('|')
            .split('|')
            .map(|cell| cell.trim().to_owned())
            .collect()
    };
    let rows: Vec<Vec<String>> = lines
        .take_while(|line| line.starts_with('|'))
        .map(cells)
        .collect();
    assert!(!rows.is_empty(), "no table under {head}");
    rows
}

/// The first number in a text, with its minus sign (−) if it has one.
fn first_number(text: &str) -> f64 {
    let digits: String = text
        .chars()
        .skip_while(|c| !c.is_ascii_digit() && *c != '−')
        .take_while(|c| c.is_ascii_digit() || ['.', '−'].contains(c))
        .collect();
    digits
        .replace('−', "-")
        .parse()
        .unwrap_or_else(|_| panic!("no number in '{text}'"))
}

#[test]
fn the_answer_in_the_readme_is_the_programs() {
    let readme = document("README.md");
    let output = longdrive(&["optimize"]);
    assert_eq!(output.status, 0);
    assert!(
        readme.contains(&format!("```text\n{}```", output.out)),
        "README.md should have:\n{}",
        output.out
    );
}

#[test]
fn the_best_lofts_of_two_presets_in_the_readme_are_the_programs() {
    let readme = document("README.md");
    let swing = ["--speed", "95mph", "--attack=-2deg"];
    for (preset, says) in [
        ("amateur-average", "its best loft is "),
        ("tour-average", "that of `tour-average` "),
    ] {
        let (_, after) = readme.split_once(says).unwrap();
        let (status, found) = json(&[&["optimize", preset], &swing[..]].concat());
        assert_eq!(status, 0, "{preset}");
        let loft = number(&found["setup"]["club.loft"]).to_degrees();
        let stated = first_number(after);
        assert!((loft - stated).abs() <= 0.05, "{preset}: {loft}, {stated}");
    }
}

/// The lines below a command in docs/tutorial.md are lines of the command's output. Cells of a
/// sweep's table are compared to 12 characters, because their last digits depend on the processor.
#[test]
fn the_outputs_in_the_tutorial_are_the_programs() {
    let text = document("docs/tutorial.md");
    let shown: Vec<&str> = text.split("```text\n").collect();
    for pair in shown.windows(2) {
        let command = pair[0].rsplit("```sh\nlongdrive ").next().unwrap();
        let command = command.lines().next().unwrap();
        let quoted = command.split('"').enumerate();
        let words: Vec<&str> = quoted
            .flat_map(|(i, part)| match i % 2 {
                0 => part.split_whitespace().collect(),
                _ => vec![part],
            })
            .collect();
        let output = longdrive(&words);
        assert_eq!(output.status, 0, "{command}\n{}", output.err);
        let digits = |line: &str| match line.contains(",landed,") {
            true => line
                .split(',')
                .map(|cell| cell.chars().take(12).collect())
                .collect::<Vec<String>>(),
            false => vec![line.to_owned()],
        };
        let printed: Vec<_> = output.out.lines().map(digits).collect();
        for line in pair[1].split("```").next().unwrap().lines() {
            assert!(
                line.is_empty() || printed.contains(&digits(line)),
                "docs/tutorial.md should not have '{line}' below {command}:\n{}",
                output.out
            );
        }
    }
    assert!(shown.len() > 6, "{}", shown.len());
}

#[test]
fn the_searches_in_validation_md_are_those_of_the_program() {
    let rows = table(
        &document("docs/validation.md"),
        "| landing | method | found |",
    );
    assert_eq!(rows.len(), FOUND.noise.searches.len());
    let best = FOUND.optimum.exact().carry;
    let mut landing = LandingDefinition::Overshot;
    for row in &rows {
        landing = match row[0].as_str() {
            "the report's loop" => LandingDefinition::Overshot,
            "the loop, interpolated" => LandingDefinition::Interpolated,
            "smooth" => LandingDefinition::Smooth,
            _ => landing,
        };
        let method = match row[1].as_str() {
            "L-BFGS (argmin), differences" => SearchMethod::LimitedMemory,
            "L-BFGS (argmin), exact gradients" => SearchMethod::LimitedMemoryExact,
            "longdrive without Hessians, differences" => SearchMethod::QuasiNewton,
            "longdrive, exact gradients and Hessians" => SearchMethod::Exact,
            other => panic!("{other}"),
        };
        let searches = FOUND
            .noise
            .searches
            .iter()
            .find(|of| (of.landing, of.method) == (landing, method))
            .unwrap();
        let count = searches.ends.len();
        let missed = searches.losses(best);
        let median = f64::midpoint(missed[(count - 1) / 2], missed[count / 2]);
        let worst = missed[count - 1];
        let found = missed.iter().filter(|loss| **loss <= 0.01).count();
        let found = format!("{found} of {count}");
        let misses = if worst < 0.005 {
            "0".to_owned()
        } else {
            format!("{median:.2} m, {worst:.2} m")
        };
        let flights = format!("{:.0}", searches.flights() as f64 / count as f64);
        assert_eq!(row[2..], [found, misses, flights], "{landing:?} {method:?}");
    }
}

#[test]
fn the_costs_and_slopes_in_validation_md_are_those_of_the_program() {
    let text = document("docs/validation.md");
    for row in table(&text, "| attack angle | loft printed |") {
        let attack = first_number(&row[0]);
        let found = FOUND
            .table1
            .iter()
            .find(|found| (found.exact().attack_angle.to_degrees() - attack).abs() < 1e-6);
        let found = found.unwrap_or_else(|| panic!("{row:?}"));
        let exact = found.exact();
        assert!(
            (first_number(&row[3]) - exact.loft.to_degrees()).abs() <= 5e-5,
            "{row:?}"
        );
        assert!(
            (first_number(&row[4]) - exact.carry).abs() <= 5e-3,
            "{row:?}"
        );
        assert!(
            (first_number(&row[5]) - found.cost()).abs() <= 5.1e-3,
            "{row:?}"
        );
        assert_eq!(
            row[2].contains("does not fly"),
            found.at_printed.is_none(),
            "{row:?}"
        );
    }
    for row in table(&text, "| loft | exact | exact, at fixed time |") {
        let loft = first_number(&row[0]);
        let found = FOUND
            .noise
            .slopes
            .iter()
            .find(|found| (found.loft.to_degrees() - loft).abs() < 1e-6)
            .unwrap();
        let values = [
            found.exact,
            found.at_fixed_time,
            found.overshot,
            found.interpolated,
        ];
        for (cell, value) in row[1..].iter().zip(values) {
            assert!(
                (first_number(cell) - value).abs() <= 0.051,
                "{row:?}: {value}"
            );
        }
    }
}

/// At the beginning of docs/performance.md, the times equal those in the tables, and the ratios
/// follow from these times.
#[test]
fn the_costs_at_the_head_of_performance_md_are_those_of_its_tables() {
    let performance = document("docs/performance.md");
    let head = performance.split("## The default drive").next().unwrap();
    let microseconds = |text: &str| {
        let number: f64 = text.split(' ').next().unwrap().parse().unwrap();
        if text.ends_with("ms") {
            1000.0 * number
        } else {
            number
        }
    };
    let tasks = table(&performance, "| Task | longdrive |");
    let alone = table(&performance, "| longdrive alone |");
    let time = |rows: &[Vec<String>], name: &str, column: usize| {
        let row = rows
            .iter()
            .find(|row| row[0].starts_with(name))
            .unwrap_or_else(|| panic!("no row {name}"));
        microseconds(&row[column])
    };
    let value = time(&tasks, "T1", 1);
    let in_space = time(&alone, "gradient, all 47", 1) / time(&alone, "value, 3-D drive", 1);
    for sentence in [
        format!(
            "a gradient by two parameters {:.1}",
            time(&tasks, "T2", 1) / value
        ),
        format!("by twelve {:.1}", time(&tasks, "T4", 1) / value),
        format!("by all 47 parameters of a drive in space {in_space:.1}"),
        format!("a Hessian by two {:.1}", time(&tasks, "T3", 1) / value),
        format!(
            "the optimum of the `mae494` problem {:.0}",
            time(&tasks, "T5", 1) / value
        ),
        format!(
            "({:.2} ms; {:.2} ms within",
            time(&tasks, "T5", 1) / 1000.0,
            time(&tasks, "T5", 4) / 1000.0
        ),
    ] {
        assert!(
            head.contains(&sentence),
            "docs/performance.md should say: {sentence}"
        );
    }
    let sweeps = table(&performance, "| A drive of a sweep by two parameters |");
    for row in &sweeps {
        assert!(
            head.contains(&format!("{} {}", row[1], row[0])),
            "docs/performance.md should say: {} {}",
            row[1],
            row[0]
        );
    }
}

#[test]
fn questions_md_has_every_command() {
    let text = document("docs/questions.md");
    let of_the_program = ["completions", "explore", "man"].map(str::to_owned);
    for command in commands().into_iter().chain(of_the_program) {
        assert!(
            text.contains(&format!("longdrive {command}")),
            "docs/questions.md should say which question `longdrive {command}` answers"
        );
    }
}

#[test]
fn model_md_has_every_outcome_of_a_drive_with_its_uncertainty() {
    let text = document("docs/model.md");
    let rows = table(&text, "| outcome | definition | σ |");
    let printed: Vec<[&str; 2]> = rows.iter().map(|row| [&*row[0], &*row[2]]).collect();
    let declared: Vec<[String; 2]> = Outcome::OF_DRIVES
        .iter()
        .map(|outcome| {
            let sigma = typeset(outcome.instrument().unwrap().sigma);
            [format!("`{outcome}`"), sigma]
        })
        .collect();
    assert_eq!(
        printed, declared,
        "docs/model.md should have a row for each of them in Outcomes"
    );
}

/// The uncertainty of the carry from drag and lift: README.md, docs/limitations.md and
/// docs/sources.md have the numbers of `sensitivity`.
#[test]
fn one_uncertainty_of_the_carry_in_all_documents() {
    let (status, found) = json(&["sensitivity", "--of", "carry"]);
    assert_eq!(status, 0);
    let effects = found["outcomes"][0]["effects"].as_array().unwrap();
    let effect = |name: &str| {
        let mut effects = effects.iter();
        let effect = effects.find(|effect| effect["parameter"] == name).unwrap();
        number(&effect["effect"]).abs() / 0.9144
    };
    let (drag, lift) = (effect("aero.cd0"), effect("aero.cl_max"));
    let both = drag.hypot(lift);
    for (name, says) in [
        (
            "README.md",
            format!("(`longdrive sensitivity`) | ±{both:.0} yd"),
        ),
        ("docs/limitations.md", format!("by about {both:.0} yd")),
        (
            "docs/sources.md",
            format!("by {drag:.0} and {lift:.0} yd, together {both:.0} yd"),
        ),
    ] {
        let text = on_one_line(&document(name));
        assert!(text.contains(&says), "{name} should say: {says}");
    }
}

/// A file of swings has distributions, a setup has values: no name of a file is used for both.
#[test]
fn a_file_of_swings_has_no_name_of_a_setup_in_the_documents() {
    let folder = format!("{}/../docs", env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(folder).unwrap();
    let files = files.map(|file| file.unwrap().path());
    let texts = files.filter(|file| file.extension().is_some_and(|ending| ending == "md"));
    let texts: String = texts
        .map(|file| std::fs::read_to_string(file).unwrap())
        .collect();
    let (mut swings, mut setups) = (BTreeSet::new(), BTreeSet::new());
    let commands = texts.lines().filter(|line| line.starts_with("longdrive "));
    for command in commands {
        let words: Vec<&str> = command.split_whitespace().collect();
        for pair in words.windows(2).filter(|pair| pair[1].ends_with(".toml")) {
            let names = match pair[0] {
                "--swings" => &mut swings,
                _ => &mut setups,
            };
            names.insert(pair[1]);
        }
    }
    assert!(
        swings.len() > 1 && setups.len() > 3,
        "{swings:?} {setups:?}"
    );
    assert!(swings.is_disjoint(&setups), "{swings:?} {setups:?}");
}

/// The commands of README and docs that read a sample of `examples/`.
#[test]
fn commands_on_the_samples_run_as_they_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let texts = ["README.md", "docs/questions.md", "docs/calibration.md"]
        .map(document)
        .concat();
    let samples = texts
        .lines()
        .filter(|line| line.starts_with("longdrive ") && line.contains("examples/"));
    let mut run = 0;
    for line in samples {
        let command = line.split('#').next().unwrap();
        let words: Vec<String> = command
            .split_whitespace()
            .skip(1)
            .map(|word| match word {
                _ if word.starts_with("examples/") => {
                    format!("{}/../{word}", env!("CARGO_MANIFEST_DIR"))
                }
                _ if word.ends_with(".toml")
                    || word.ends_with(".csv")
                    || word.ends_with(".jsonl")
                    || word == "residuals" =>
                {
                    folder.path().join(word).display().to_string()
                }
                _ => word.to_owned(),
            })
            .collect();
        let output = longdrive(&words.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(output.status, 0, "{line}\n{}", output.err);
        run += 1;
    }
    assert!(run >= 5, "{run}");
}

#[test]
fn same_sample_of_launches_from_the_deliveries() {
    let of = |sample: &str| format!("{}/../examples/{sample}", env!("CARGO_MANIFEST_DIR"));
    let outcomes = "ball_speed,launch_angle,launch_direction,backspin,sidespin";
    let output = longdrive(&[
        "sweep",
        "modern-driver",
        "--points",
        &of("deliveries.csv"),
        "--outcomes",
        outcomes,
    ]);
    let launches = document("examples/launches.csv");
    let (degree, rpm) = (1.0_f64.to_radians(), std::f64::consts::TAU / 60.0);
    let sizes = [0.44704, degree, degree, rpm, rpm];
    let lines: Vec<_> = output
        .out
        .lines()
        .skip(1)
        .zip(launches.lines().skip(1))
        .collect();
    assert_eq!(lines.len(), 6);
    for (computed, written) in lines {
        let computed = computed
            .split(',')
            .skip(8)
            .map(|cell| cell.parse::<f64>().unwrap());
        let written = written.split(',').map(|cell| cell.parse::<f64>().unwrap());
        for (((computed, written), size), digit) in computed
            .zip(written)
            .zip(sizes)
            .zip([0.1, 0.1, 0.1, 1.0, 1.0])
        {
            assert!(
                (computed / size - written).abs() <= 0.501 * digit,
                "{computed} {written}"
            );
        }
    }
}

/// The rules and the numbers in the examples of docs/design.md.
#[test]
fn rules_and_numbers_of_design_md_are_the_programs() {
    let text = document("docs/design.md");
    for rule in &longdrive::study::design::RULES {
        let row = format!(
            "| {} | `{}` | {} |",
            rule.name,
            rule.expression(),
            rule.source
        );
        assert!(text.contains(&row), "docs/design.md should say: {row}");
    }
    let yards = |value: f64| value / 0.9144;
    let near = |cell: &str, value: f64, by: f64| {
        let documented = first_number(cell);
        assert!(
            (documented - value).abs() <= by,
            "docs/design.md says {documented}, the program {value}"
        );
    };
    let design = |more: &[&str]| json(&[&["design", "--set", "club.loft=12deg"], more].concat()).1;
    let goal = "mean(carry) - 0.5*rms(lateral)";
    for row in table(
        &text,
        "| `club.inertia.xx` | best bulge | goal | with 305 mm |",
    ) {
        let inertia = format!("club.inertia.xx={}", row[0]);
        let vary = "club.bulge_radius=150mm..1000mm";
        let found = design(&[
            "--vary",
            vary,
            "--set",
            &inertia,
            "--set",
            "club.inertia.xz=-300 g cm^2",
        ]);
        near(
            &row[1],
            1e3 * number(&found["optimum"]["club.bulge_radius"]),
            0.051,
        );
        near(&row[2], yards(number(&found["value"])), 0.0051);
        near(
            &row[3],
            yards(number(&found["swings"]["as_set_up"][goal])),
            0.0051,
        );
    }
    let command = text
        .lines()
        .find(|line| line.starts_with("longdrive design --set club.loft=12deg --set club.mass"))
        .unwrap();
    let words: Vec<&str> = command.split_whitespace().skip(4).collect();
    for (row, rules) in table(&text, "| | best depth | goal | gained |")
        .iter()
        .zip(["golf", "none"])
    {
        let found = design(&[&words[..], &["--rules", rules]].concat());
        near(
            &row[1],
            1e3 * number(&found["optimum"]["club.weight_1.depth"]),
            0.051,
        );
        near(&row[2], yards(number(&found["value"])), 0.0051);
        near(
            &row[3],
            yards(number(&found["value"]) - number(&found["swings"]["as_set_up"][goal])),
            0.0051,
        );
        let price = found["design"]["held"]
            .as_array()
            .unwrap()
            .iter()
            .find(|held| !held["price"].is_null());
        if let Some(price) = price {
            let documented = text.split("at a price of ").nth(1).unwrap();
            near(documented, yards(number(&price["price"]) * 100e-7), 0.00051);
        }
    }
}

/// For the golfer of docs/swings.md the bulge changes the goal, because the strikes vary.
#[test]
fn the_bulge_changes_the_goal_for_the_golfer_of_swings_md() {
    let text = document("docs/swings.md");
    let (_, file) = text
        .split_once("A file of swings is TOML:\n\n```toml\n")
        .unwrap();
    let (file, _) = file.split_once("```").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let swings = file_with(folder.path(), "golfer.toml", file);
    let command = ["design", "--swings", &swings];
    let question = [
        "--vary=club.bulge_radius=200mm..600mm",
        "--minimize=rms(lateral)",
    ];
    let (status, found) = json(&[&command[..], &question].concat());
    assert_eq!(status, 0, "{}", found["message"]);
    let bulge = number(&found["optimum"]["club.bulge_radius"]);
    assert!(0.35 < bulge && bulge < 0.6, "{bulge}");
}

/// docs/swings.md: the design for several gear effects.
#[test]
fn numbers_of_the_robust_example_of_swings_md_are_the_programs() {
    let text = document("docs/swings.md");
    let command = text
        .lines()
        .find(|line| line.starts_with("longdrive robust modern-driver"))
        .unwrap()
        .replace('"', "");
    let words: Vec<&str> = command.split_whitespace().skip(1).collect();
    let (status, found) = json(&words);
    assert_eq!((status, &found["holds_for_all"]), (0, &false.into()));
    let near = |cell: &str, value: f64, by: f64| {
        let documented = first_number(cell);
        assert!(
            (documented - value).abs() <= by,
            "docs/swings.md says {documented}, the program {value}"
        );
    };
    let head = "| gear effect | best bulge | rms(lateral) there | more with 440.8 mm | more with \
                the best for 0.75 |";
    let (rows, models) = (table(&text, head), found["models"].as_array().unwrap());
    assert_eq!(rows.len(), models.len());
    for (row, model) in rows.iter().zip(models) {
        near(
            &row[1],
            1e3 * number(&model["optimum"]["club.bulge_radius"]),
            0.051,
        );
        near(&row[2], number(&model["value"]) / 0.9144, 0.0051);
        near(&row[3], number(&model["loss"]) / 0.9144, 0.0051);
        near(&row[4], number(&model["losses"][0]) / 0.9144, 0.0051);
    }
    let bulge = 1e3 * number(&found["optimum"]["club.bulge_radius"]);
    near(
        text.split("the one that loses least, ").nth(1).unwrap(),
        bulge,
        0.051,
    );
    let greatest = number(&found["greatest_loss"]) / 0.9144;
    near(
        text.split("440.8 mm, loses ").nth(1).unwrap(),
        greatest,
        0.0051,
    );
    let worst = models
        .iter()
        .map(|model| number(&model["losses"][0]) / 0.9144)
        .fold(0.0, f64::max);
    near(
        text.split("that of\nrigid bodies, ").nth(1).unwrap(),
        worst - greatest,
        0.051,
    );
    assert!(
        models
            .iter()
            .skip(1)
            .all(|model| number(&model["share"]) > 0.4)
            && number(&models[0]["share"]) < 0.01
    );
}

/// docs/verification.md has a row for every preset. Each row counts 0 failed derivatives, and 0
/// planted errors that the check did not notice. A test in `verify.rs` checks every preset with the
/// present code.
#[test]
fn verification_md_lists_every_preset_without_a_failure() {
    verification::write_on_request();
    let written = document("docs/verification.md");
    assert!(written.starts_with(verification::HEAD));
    let rows = table(&written, "| preset | not passed |");
    assert_eq!(rows.len(), PRESETS.len());
    for (row, preset) in rows.iter().zip(PRESETS) {
        let [name, not_passed, _, _, _, landing_not_passed, missed] = &row[..] else {
            panic!("{row:?}");
        };
        assert_eq!(name, &format!("`{}`", preset.name));
        assert_eq!([not_passed, landing_not_passed, missed], ["0", "0", "0"]);
    }
}

/// The estimates of docs/scale.md follow from the measured rate and size of docs/performance.md.
#[test]
fn the_plan_in_scale_md_follows_from_the_rate_in_performance_md() {
    let measured = table(
        &document("docs/performance.md"),
        "| Drives with gradients | File | Wall |",
    );
    let row = measured.iter().find(|row| row[0] == "100 000 000").unwrap();
    let (drives, cores) = (1e8, 2.0);
    let seconds = first_number(&row[2]);
    let bytes = 1e9 * first_number(row[1].trim_start_matches("Parquet, "));
    let scale = document("docs/scale.md");
    assert!(
        scale.contains(&format!(
            "took {seconds} s on two cores, and {} GB",
            bytes / 1e9
        )),
        "{row:?}"
    );

    let rate = drives / seconds / cores;
    let in_units = |text: &str| {
        let size = [
            ("min", 60.0),
            ("days", 86400.0),
            ("h", 3600.0),
            ("s", 1.0),
            ("TB", 1e12),
            ("GB", 1e9),
            ("MB", 1e6),
        ];
        let (_, size) = size
            .into_iter()
            .find(|(unit, _)| text.ends_with(&format!(" {unit}")))
            .unwrap();
        first_number(text) * size
    };
    // the written numbers are rounded
    let is_about = |text: &str, value: f64| {
        let written = in_units(text);
        assert!((written / value - 1.0).abs() < 0.1, "{text} and {value}");
    };
    for row in table(&scale, "| drives with gradients | on 2 cores |") {
        let exponent = row[0].chars().skip(2).fold(0, |exponent, c| {
            10 * exponent + "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c).unwrap() as i32
        });
        let drives = 10_f64.powi(exponent);
        is_about(&row[1], drives / (2.0 * rate));
        is_about(&row[2], drives / (64.0 * rate));
        is_about(&row[3], drives / 1e8 * bytes);
    }
    let plan = table(&scale, "| | |");
    let stated = |what: &str| plan.iter().find(|row| row[0].starts_with(what)).unwrap()[1].clone();
    let of_part: Vec<String> = stated("a part").split(", ").map(str::to_owned).collect();
    is_about(&of_part[0].replace(" on one core", ""), 1e7 / rate);
    is_about(&of_part[1], 1e7 / 1e8 * bytes);
    let core_hours = 1e12 / rate / 3600.0;
    assert!(
        (first_number(&stated("all parts")) / core_hours - 1.0).abs() < 0.001,
        "{core_hours}"
    );
    is_about(&stated("on 1000 cores"), 3600.0 * core_hours / 1000.0);
    assert!((first_number(&stated("at 0.04 $")) / (0.04 * core_hours) - 1.0).abs() < 0.03);
    assert!(
        (first_number(&stated("at 23 $")) / (23.0 * 1e12 / 1e8 * bytes / 1e12) - 1.0).abs() < 0.03
    );
}
