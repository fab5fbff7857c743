//! Plots and the page of `report`: pictures agree with the computed data, each file is complete
//! without other files, and bad input is refused.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use longdrive::parameters::Preset;
use longdrive::report::figures::{
    Causes, OnMap, View, map_figure, tornado_figure, trajectory_figure, vcurve_figure,
};
use longdrive::report::plot::{
    Axis, Field, Figure, Hue, Layer, Look, NamedQuantity, Shape, figure_csv, figure_svg,
};
use longdrive::study::certificate::certify;
use longdrive::study::{DriveRole, Fineness, NamedDrive, Sigma, Vary, effects, map, with_defaults};
use longdrive::units::{System, TableUnits};
use longdrive::{Drive, Error, Outcome, Setup, derivative, flight, impact};
use std::path::Path;

const XMLNS: &str = "http://www.w3.org/2000/svg";

/// Parses a picture: well-formed, without references to other files, and without NaN.
pub fn whole(svg: &str) -> roxmltree::Document<'_> {
    assert_eq!(svg.matches("http").count(), 1, "the name space alone");
    assert!(
        svg.contains(&format!("xmlns=\"{XMLNS}\"")) && !svg.contains("NaN") && !svg.contains("inf"),
        "{svg}"
    );
    roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{error}: {svg}"))
}

/// The points of each drawn line, pixels from the left and the top.
pub fn polylines(svg: &roxmltree::Document<'_>) -> Vec<Vec<[f64; 2]>> {
    let lines = svg
        .descendants()
        .filter(|node| node.has_tag_name("polyline"));
    let place = |point: &str| {
        let (x, y) = point.split_once(',').unwrap();
        [x, y].map(|at| at.parse().unwrap())
    };
    lines
        .filter_map(|line| {
            Some(
                line.attribute("points")?
                    .split_whitespace()
                    .map(place)
                    .collect(),
            )
        })
        .collect()
}

fn words<'a>(svg: &'a roxmltree::Document<'_>) -> Vec<&'a str> {
    svg.descendants()
        .filter(|node| node.has_tag_name("text"))
        .filter_map(|node| node.text())
        .map(str::trim)
        .collect()
}

/// The numbers in those rows of a data file that begin with `kind`.
fn rows(csv: &str, kind: &str) -> Vec<Vec<f64>> {
    let rows = csv
        .lines()
        .skip(1)
        .filter(|row| row.starts_with(&format!("{kind},")));
    rows.map(|row| {
        row.split(',')
            .skip(2)
            .map(|cell| cell.parse().unwrap_or(f64::NAN))
            .collect()
    })
    .collect()
}

/// The titles of the trajectories have characters that XML escapes.
fn figures(system: System) -> Vec<Figure> {
    let setup = Setup::modern_driver();
    let ranges = ["club.loft=4deg..20deg", "swing.attack_angle=-15deg..5deg"]
        .map(|text| Vary::read(&setup, text).unwrap());
    let fineness = Fineness {
        nodes: 21,
        slopes: 4,
    };
    let landscape = map(&setup, Outcome::Carry, ranges[0], ranges[1], fineness).unwrap();
    let mut crooked = setup;
    crooked.set("swing.path", "3 deg").unwrap();
    let flown = [NamedDrive::new(DriveRole::AsSetUp, &crooked).unwrap()];
    let sigmas = with_defaults(&setup, &[], &[Outcome::Carry]).unwrap();
    let effects = effects(&setup, &[Outcome::Carry], &sigmas, &|_, _| ()).unwrap();
    let loft = setup.variable("club.loft").unwrap();
    let certificate = certify(&setup, &[Outcome::Carry], &[loft], &|_, _| true).unwrap();
    let path = |view| {
        let mut figure = trajectory_figure(&flown, view, system).unwrap();
        figure.title += " <of> & \"up\"";
        figure
    };
    vec![
        path(View::Side),
        path(View::Top),
        map_figure(
            &landscape,
            &OnMap {
                setup: &setup,
                preset: Preset::named("tour-average").unwrap(),
                limits: &[],
                best: None,
                region: None,
            },
            system,
        ),
        tornado_figure(&effects[0], Causes::All, system).unwrap(),
        vcurve_figure(
            &certificate.rows,
            &longdrive::reproduce::while_loop(&setup, &certificate.rows),
            system,
        ),
    ]
}

#[test]
fn same_points_in_the_data_of_a_trajectory_and_in_its_flight() {
    let setup = Setup::modern_driver();
    let path = flight::trajectory(&setup, &impact::strike(&setup).unwrap().launch).unwrap();
    let figure = trajectory_figure(
        &[NamedDrive::new(DriveRole::Alone, &setup).unwrap()],
        View::Side,
        System::Us,
    )
    .unwrap();
    let csv = figure_csv(&figure, TableUnits::Si).unwrap();
    assert!(
        csv.starts_with("kind,name,downrange [m],height [m]\n"),
        "{csv}"
    );
    let points = rows(&csv, "line,flight");
    assert_eq!(points.len(), path.points.len());
    for (row, point) in points.iter().zip(&path.points) {
        assert_eq!(
            *row,
            [point.position.z, point.position.x],
            "to the last bit"
        );
    }
}

/// In the view from above, the target is at the right end of the picture. A point to the right of
/// the target line is therefore drawn below it.
#[test]
fn a_slice_is_drawn_below_the_target_line_in_the_view_from_above() {
    let ends = |face_angle: &str| {
        let mut setup = Setup::modern_driver();
        setup.set("swing.face_angle", face_angle).unwrap();
        let figure = trajectory_figure(
            &[NamedDrive::new(DriveRole::Alone, &setup).unwrap()],
            View::Top,
            System::Us,
        )
        .unwrap();
        let svg = figure_svg(&figure, &Look::default()).unwrap();
        let picture = whole(&svg);
        let longest = polylines(&picture)
            .into_iter()
            .max_by_key(Vec::len)
            .unwrap();
        let csv = figure_csv(&figure, TableUnits::Si).unwrap();
        let has = |letter: &str| words(&picture).iter().any(|text| text.ends_with(letter));
        assert!(
            has(" L") && has(" R"),
            "ticks say which side they are on: {:?}",
            words(&picture)
        );
        (
            longest[0],
            longest[longest.len() - 1],
            rows(&csv, "line").last().unwrap()[1],
        )
    };
    // pixels count downwards from the top
    let (tee, landing, right) = ends("3 deg");
    assert!(
        right > 5.0 && landing[1] > tee[1] + 2.0 && landing[0] > tee[0] + 10.0,
        "{tee:?} {landing:?} {right}"
    );
    let (tee, landing, right) = ends("-3 deg");
    assert!(
        right < -5.0 && landing[1] < tee[1] - 2.0,
        "{tee:?} {landing:?} {right}"
    );
}

#[test]
fn same_positions_in_the_picture_and_in_the_data() {
    // the limits of both axes are exact: a diagonal line ends in the corners of the frame, in
    // metres and in yards
    let length = || Axis::linear(NamedQuantity::outcome(Outcome::Carry)).exactly(0.0, 91.44);
    let figure = |system| {
        Figure::new(system, "n", "t", length(), length()).with(Layer::line(
            "",
            0,
            vec![[0.0, 0.0], [45.72, 45.72], [91.44, 91.44]],
        ))
    };
    let ends = |system| {
        let svg = figure_svg(&figure(system), &Look::default()).unwrap();
        polylines(&whole(&svg))
            .into_iter()
            // the axes also have three points; the data are drawn after them
            .rfind(|points| points.len() == 3)
            .unwrap()
    };
    for system in System::ALL {
        let [low, middle, high] = ends(system)[..] else {
            panic!("three points")
        };
        assert!(low[0] < high[0] && low[1] > high[1]);
        for axis in 0..2 {
            close(
                middle[axis],
                0.5 * (low[axis] + high[axis]),
                1.0,
                0.1,
                "half-way, to a tenth of a pixel",
            );
        }
    }
    let us = figure_svg(&figure(System::Us), &Look::default()).unwrap();
    let ticks = whole(&us);
    assert!(
        words(&ticks).contains(&"100") && words(&ticks).contains(&"carry [yd]"),
        "100 yd are 91.44 m"
    );
}

/// In the widest common fonts (DejaVu Sans, Verdana) a digit is as wide as 0.636 of the font size.
#[test]
fn a_label_at_the_end_of_an_axis_lies_within_the_picture() {
    for (low, high) in [(4e4, 2.4e5), (0.0, 12.0), (1e6, 3e6), (0.0, 0.0004)] {
        let axis = || Axis::linear(NamedQuantity::plain("n"));
        let figure = Figure::new(System::Us, "n", "t", axis(), axis()).with(Layer::line(
            "",
            0,
            vec![[low, 1.0], [high, 2.0]],
        ));
        for width in [240, 480, 900, 1300] {
            let svg = figure_svg(
                &figure,
                &Look {
                    width,
                    ..Look::default()
                },
            )
            .unwrap();
            let picture = whole(&svg);
            let texts = picture
                .descendants()
                .filter(|node| node.has_tag_name("text"));
            let mut ticks = 0;
            for text in texts.filter(|text| text.attribute("text-anchor") == Some("middle")) {
                let number = |name: &str| text.attribute(name).unwrap().parse::<f64>().unwrap();
                let digits = text.text().unwrap().trim().chars().count() as f64;
                let half = 0.5 * 0.636 * number("font-size") * digits;
                let [from, to] = [number("x") - half, number("x") + half];
                assert!(
                    from >= 0.0 && to <= f64::from(width),
                    "{:?}: {from} to {to} of {width}",
                    text.text()
                );
                ticks += 1;
            }
            assert!(ticks >= 2, "{svg}");
        }
    }
}

#[test]
fn every_series_differs_from_every_other_one() {
    let axis = || Axis::linear(NamedQuantity::plain("n")).exactly(0.0, 1.0);
    let line = |hue: usize, is_dashed: bool| {
        Layer::new(
            "one",
            Hue::Series(hue),
            Shape::Line {
                is_dashed,
                points: vec![[0.0, 0.0], [0.5, 0.8], [1.0, 1.0]],
            },
        )
    };
    let picture = |layer: Layer| {
        let figure = Figure::new(System::Us, "n", "t", axis(), axis()).with(layer);
        figure_svg(&figure, &Look::default()).unwrap()
    };
    let kinds: [&dyn Fn(usize) -> Layer; 3] =
        [&|hue| line(hue, false), &|hue| line(hue, true), &|hue| {
            Layer::dots("one", hue, vec![[0.5, 0.5]])
        }];
    for kind in kinds {
        let pictures: Vec<String> = (0..20).map(|hue| picture(kind(hue))).collect();
        for (i, picture) in pictures.iter().enumerate() {
            whole(picture);
            assert!(
                !pictures[..i].contains(picture),
                "series {i} looks like another one"
            );
        }
    }
    // cross bars distinguish series of one colour; the legend, at the top of the picture, has them
    // too
    let figure = |hue: usize| {
        Figure::new(System::Us, "n", "t", axis(), axis())
            .with(line(hue, false))
            .with(line(0, false))
    };
    let lines = |hue: usize| {
        let svg = figure_svg(&figure(hue), &Look::default()).unwrap();
        polylines(&whole(&svg))
            .iter()
            .filter(|points| points.iter().all(|[_, y]| *y < 45.0))
            .count()
    };
    assert_eq!(lines(6), lines(0) + 1, "one bar");
    assert_eq!(lines(12), lines(0) + 2, "two bars");
}

#[test]
fn pictures_are_whole_in_both_systems_light_and_dark() {
    let [metric, us] = System::ALL.map(figures);
    for figures in metric.iter().zip(&us).map(|(metric, us)| [metric, us]) {
        let mut seen: Vec<String> = vec![];
        for figure in figures {
            for is_dark in [false, true] {
                let look = Look {
                    is_dark,
                    ..Look::default()
                };
                let svg = figure_svg(figure, &look).unwrap();
                let parsed = whole(&svg);
                assert_eq!(
                    parsed.root_element().attribute("aria-label"),
                    Some(figure.title.as_str())
                );
                assert!(
                    !seen.contains(&svg) || figure.name == "vcurve",
                    "{}: two series look alike",
                    figure.name
                );
                let unit = if figure.system == System::Us {
                    "[yd]"
                } else {
                    "[m]"
                };
                let has_lengths = figure.x.quantity.head(TableUnits::Si).contains("[m]");
                assert_eq!(
                    words(&parsed).iter().any(|text| text.contains(unit)),
                    has_lengths,
                    "{}",
                    figure.name
                );
                drop(parsed);
                seen.push(svg);
            }
            let table = figure_csv(figure, TableUnits::Si).unwrap();
            assert!(
                table.lines().count() > 2 && !table.contains("NaN"),
                "{table}"
            );
        }
    }
}

#[test]
fn impossible_plots_are_refused() {
    let empty = Figure::new(
        System::Us,
        "none",
        "t",
        Axis::linear(NamedQuantity::plain("x")),
        Axis::log(NamedQuantity::plain("y")),
    );
    let error = figure_svg(
        &empty.with(Layer::line("", 0, vec![[1.0, 0.0]])),
        &Look::default(),
    )
    .unwrap_err();
    assert!(
        matches!(&error, Error::Plot { name, reason } if name == "none" && reason.contains("vertical")),
        "{error}"
    );
}

#[test]
fn a_map_without_columns_is_an_empty_picture() {
    let axis = || Axis::linear(NamedQuantity::plain("x"));
    let field = Field {
        quantity: NamedQuantity::plain("z"),
        x: [0.0, 1.0],
        y: [0.0, 1.0],
        columns: 0,
        values: vec![],
        gradients: vec![],
        common_values: vec![],
    };
    let map = Figure::new(System::Us, "empty", "t", axis(), axis()).with(Layer::contours(field));
    whole(&figure_svg(&map, &Look::default()).unwrap());
}

#[test]
fn limits_on_a_map_are_where_the_outcome_reaches_them() {
    let folder = tempfile::tempdir().unwrap();
    let file = path(&folder, "x.csv");
    let output = longdrive(&[
        "plot",
        "contour",
        "-o",
        &file,
        "--subject-to",
        "descent_angle >= 38 deg",
    ]);
    assert_eq!(output.status, 0, "{}", output.err);
    let csv = std::fs::read_to_string(&file).unwrap();
    let line: Vec<&str> = csv
        .lines()
        .filter(|row| row.starts_with("line,descent angle ≥ 38°,"))
        .collect();
    assert!(line.len() > 20, "{csv}");
    // rows without numbers separate the pieces of a line
    for row in line.iter().filter(|row| !row.contains("°,,")).step_by(7) {
        let at: Vec<&str> = row.split(',').skip(2).take(2).collect();
        let set = [
            format!("club.loft={}rad", at[0]),
            format!("swing.attack_angle={}rad", at[1]),
        ];
        let (_, drive) = json(&["simulate", "--set", &set[0], "--set", &set[1]]);
        // a map is linear between its nodes
        close(
            number(&drive["flight"]["descent_angle"]).to_degrees(),
            38.0,
            1.0,
            0.01,
            row,
        );
    }
}

#[test]
fn same_tornado_bars_and_drives() {
    let all = figures(System::Us);
    let csv = figure_csv(&all[3], TableUnits::Si).unwrap();
    let bar = csv
        .lines()
        .find(|line| line.starts_with("bar,club speed ± 0.5 mph: parameter lower,0.0,-"))
        .unwrap();
    let lower: f64 = bar.rsplit(',').next().unwrap().parse().unwrap();
    let carry = |speed: &str| {
        number(
            &json(&[
                "simulate",
                "modern-driver",
                "--set",
                &format!("swing.speed={speed}"),
            ])
            .1["flight"]["carry"],
        )
    };
    close(
        lower,
        carry("109.5 mph") - carry("110 mph"),
        1.0,
        1e-9,
        "the bar of a slower swing",
    );

    // of the finite differences: the truncation error is proportional to the square of the step,
    // the rounding error to its inverse
    let curve = rows(&figure_csv(&all[4], TableUnits::Si).unwrap(), "line");
    let error = |step: f64| {
        curve
            .iter()
            .find(|row| (row[0] / step - 1.0).abs() < 1e-3)
            .unwrap()[1]
    };
    assert!(
        (error(1e-2) / error(1e-3) - 100.0).abs() < 20.0,
        "{} over {}",
        error(1e-2),
        error(1e-3)
    );
    let lowest = curve.iter().map(|row| row[1]).fold(f64::INFINITY, f64::min);
    assert!(lowest < 1e-8 && error(1e-12) > 100.0 * lowest, "{curve:?}");
}

#[test]
fn differences_standard_uncertainty_of_a_tornado_plot() {
    let setup = Setup::preset("modern-driver").unwrap();
    let sigmas = with_defaults(&setup, &[], &[Outcome::Carry]).unwrap();
    let effects = effects(&setup, &[Outcome::Carry], &sigmas, &|_, _| ()).unwrap();
    let carry = |sigma: &Sigma, steps: f64| {
        let mut moved = setup;
        let value = setup.value(sigma.parameter).unwrap() + steps * sigma.value;
        moved.set_value(sigma.parameter, Some(value)).unwrap();
        Outcome::Carry.value(&Drive::new(&moved).unwrap()).unwrap()
    };
    const STEP: f64 = 1e-3;
    let first_order = |sigma: &Sigma| (carry(sigma, STEP) - carry(sigma, -STEP)) / (2.0 * STEP);
    for causes in [Causes::Control, Causes::Model, Causes::All] {
        let of_causes = sigmas.iter().filter(|sigma| causes.has(sigma.parameter));
        let together = of_causes.map(first_order).fold(0.0, f64::hypot) / 0.9144;
        let figure = tornado_figure(&effects[0], causes, System::Us).unwrap();
        let (_, after) = figure.note.split_once("if independent: ± ").unwrap();
        let stated: f64 = after.split_once(" yd").unwrap().0.parse().unwrap();
        close(stated, together, together, 5e-3, "all together");
    }
}

#[test]
fn the_last_row_of_a_tornado_plot_has_no_effect_only_if_no_parameter_has_one() {
    let setup = Setup::preset("modern-driver").unwrap();
    for (of, given, has_none) in [
        (Outcome::Carry, "strike.toe=3mm", false),
        (Outcome::Lateral, "strike.toe=3mm", true),
    ] {
        let given = [Sigma::read(&setup, given).unwrap()];
        let sigmas = with_defaults(&setup, &given, &[of]).unwrap();
        let effects = effects(&setup, &[of], &sigmas, &|_, _| ()).unwrap();
        let figure = tornado_figure(&effects[0], Causes::All, System::Us).unwrap();
        let rows = format!("{:?}", figure.y);
        assert_eq!(rows.contains(" more: no effect"), has_none, "{rows}");
        assert!(rows.contains(" more: "), "{rows}");
    }
}

#[test]
fn same_drives_and_gradients_in_maps_and_other_commands() {
    let setup = Setup::modern_driver();
    let [across, up] = ["club.loft=4deg..20deg", "swing.attack_angle=-15deg..5deg"]
        .map(|text| Vary::read(&setup, text).unwrap());
    let found = map(
        &setup,
        Outcome::Carry,
        across,
        up,
        Fineness {
            nodes: 5,
            slopes: 3,
        },
    )
    .unwrap();
    assert!(
        found.plane.values[0][0].is_none()
            && found
                .missing
                .as_ref()
                .unwrap()
                .to_string()
                .contains("no flight"),
        "{found:?}"
    );
    // the node in the third column of the top row: loft 12°, attack 5°
    let set = [
        "--set",
        "club.loft=12deg",
        "--set",
        "swing.attack_angle=5deg",
    ];
    let (_, drive) = json(&[&["simulate", "modern-driver"], set.as_slice()].concat());
    close(
        found.plane.values[0][22].unwrap(),
        number(&drive["flight"]["carry"]),
        250.0,
        1e-13,
        "carry",
    );
    let slope = found.slopes.last().unwrap();
    let mut there = setup;
    for (parameter, value) in [across.parameter, up.parameter].into_iter().zip(slope.at) {
        there.set_value(parameter, Some(value)).unwrap();
    }
    let taylor =
        derivative::gradient(&there, Outcome::Carry, &[across.parameter, up.parameter]).unwrap();
    for axis in 0..2 {
        close(
            slope.gradient[axis],
            taylor.gradient[axis],
            100.0,
            1e-12,
            "gradient",
        );
    }
    assert!(matches!(
        map(&setup, Outcome::Carry, across, across, Fineness::default()),
        Err(Error::SearchRange { .. })
    ));
    let down = Vary::read(&setup, "swing.attack_angle=-40deg..-30deg").unwrap();
    assert!(matches!(
        map(&setup, Outcome::Carry, across, down, Fineness::default()),
        Err(Error::NoFlight { .. })
    ));
}

fn path(folder: &tempfile::TempDir, name: &str) -> String {
    folder.path().join(name).display().to_string()
}

#[test]
fn the_ending_of_the_file_chooses_the_format_of_a_plot() {
    let folder = tempfile::tempdir().unwrap();
    let (svg, csv) = (path(&folder, "x.svg"), path(&folder, "x.csv"));
    for (kind, extra) in [
        (
            "trajectory",
            vec!["--view", "top", "--set", "swing.path=3deg"],
        ),
        ("contour", vec![]),
        ("chart", vec!["--along", "swing.speed=90..110 mph"]),
        (
            "tornado",
            vec!["--of", "lateral", "--sigma", "swing.path=1deg"],
        ),
        (
            "compare",
            vec![
                "mae494",
                "--set-b",
                "club.loft=12deg",
                "--set-b",
                "aero.law=linear",
            ],
        ),
        ("vcurve", vec!["--wrt", "swing.speed"]),
    ] {
        for file in [&svg, &csv] {
            let output = longdrive(
                &[
                    &["plot", kind, "-o", file, "--overwrite", "--units", "metric"],
                    extra.as_slice(),
                ]
                .concat(),
            );
            assert!(
                output.status == 0 && output.out.is_empty() && output.err.contains(file.as_str()),
                "{kind}: {}",
                output.err
            );
        }
        let text = std::fs::read_to_string(&svg).unwrap();
        assert!(words(&whole(&text)).iter().any(|text| {
            ["[m]", "[°]", "relative"]
                .iter()
                .any(|end| text.ends_with(end))
        }));
        assert!(
            std::fs::read_to_string(&csv)
                .unwrap()
                .starts_with("kind,name,")
        );
    }
    let (status, answer) = json(&["plot", "trajectory", "-o", &svg, "--overwrite"]);
    assert_eq!((status, answer["file"].as_str()), (0, Some(svg.as_str())));
}

/// A parameter without a value in the setup has no place on a map or a chart. The drive as set up
/// of a front has no value of it either.
#[test]
fn the_start_of_a_search_is_no_value_of_the_drive_as_set_up() {
    let folder = tempfile::tempdir().unwrap();
    let csv = path(&folder, "x.csv");
    let drawn = |args: &[&str]| {
        let output = longdrive(&[&["plot"], args, &["-o", &csv, "--overwrite"]].concat());
        assert_eq!(output.status, 0, "{args:?}: {}", output.err);
        let marks = std::fs::read_to_string(&csv).unwrap();
        let marks = marks.lines().filter(|line| line.starts_with("mark,"));
        let marks: Vec<String> = marks.map(str::to_owned).collect();
        (marks, on_one_line(&output.err))
    };
    let vary = [
        "--vary",
        "air.temperature=0C..35C",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    let (marks, note) = drawn(&[&["contour"], &vary[..]].concat());
    assert!(
        marks.len() == 1 && marks[0].starts_with("mark,optimum,"),
        "{marks:?}"
    );
    let says = "The drive as set up is not on the map: it has no value of air temperature.";
    assert!(note.contains(says), "{note}");
    let (marks, _) = drawn(&["chart", "--along", "air.temperature=0C..35C"]);
    assert!(!marks.iter().any(|mark| mark.contains("17.5")), "{marks:?}");
    let goals = ["--maximize", "carry", "--minimize", "apex_height"];
    let front = [&["pareto", "--points", "2"], &goals[..], &vary].concat();
    let (status, front) = json(&front);
    let (_, own) = json(&["simulate"]);
    assert_eq!(status, 0);
    for (k, of) in ["carry", "apex_height"].into_iter().enumerate() {
        let own = number(&own["flight"][of]);
        close(number(&front["as_set_up"][k]), own, own, 1e-7, of);
    }
}

/// Every command about the optimum of one drive finds a start for a varied parameter that has no
/// value in the setup. Expected: the longest drive has a rigid shaft, as a droop only adds loft, so
/// that its carry is that of a search over the loft alone.
#[test]
fn a_parameter_without_a_value_is_varied_by_every_command_about_an_optimum() {
    let folder = tempfile::tempdir().unwrap();
    let loft = ["--vary", "club.loft=4deg..20deg"];
    let droop = ["--vary", "swing.shaft_droop=0deg..5deg"];
    let (_, best) = json(&[&["optimize"], &loft[..]].concat());
    let (status, found) = json(&[&["sensitivity", "--at-optimum"], &loft[..], &droop].concat());
    assert_eq!(status, 0, "{found}");
    let carry = number(&found["at_optimum"]["value"]);
    close(carry, number(&best["value"]), carry, 1e-6, "carry");
    let (picture, page) = (path(&folder, "x.csv"), path(&folder, "page"));
    for words in [
        vec!["plot", "fairway", "-o", &picture],
        vec!["report", "-o", &page],
    ] {
        let output = longdrive(&[&words[..], &loft, &droop].concat());
        assert_eq!(output.status, 0, "{words:?}: {}", output.err);
        assert!(!output.err.contains("no optimum"), "{}", output.err);
    }
}

#[cfg(feature = "full")]
#[test]
fn a_png_has_its_size_and_its_words() {
    let folder = tempfile::tempdir().unwrap();
    let file = path(&folder, "x.PNG");
    assert_eq!(
        longdrive(&[
            "plot",
            "trajectory",
            "-o",
            &file,
            "--overwrite",
            "--width",
            "300"
        ])
        .status,
        0
    );
    let bytes = std::fs::read(&file).unwrap();
    assert_eq!(
        (&bytes[..8], &bytes[16..20]),
        (
            b"\x89PNG\r\n\x1a\n".as_slice(),
            600_u32.to_be_bytes().as_slice()
        )
    );
    // a file with a title is larger; without a font the letters would be missing
    let setup = Setup::modern_driver();
    let figure = trajectory_figure(
        &[NamedDrive::new(DriveRole::Alone, &setup).unwrap()],
        View::Side,
        System::Us,
    )
    .unwrap();
    let silent = Figure {
        title: String::new(),
        ..figure.clone()
    };
    let size = |figure| {
        longdrive::report::plot::figure_png(figure, &Look::default(), 1.0)
            .unwrap()
            .len()
    };
    assert!(size(&figure) > size(&silent) + 500);
}

#[test]
fn the_page_is_self_contained_and_describes_its_content() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mine.txt"), "left alone").unwrap();
    std::fs::write(folder.path().join("index.html"), "replaced").unwrap();
    let setup = folder.path().join("a<b>&c.toml");
    std::fs::write(&setup, "preset = 'mae494'\n[swing]\nspeed = '100 mph'\n").unwrap();
    let directory = folder.path().display().to_string();
    let ranges = [
        "--vary",
        "club.loft=0deg..20deg",
        "--vary",
        "swing.attack_angle=-10deg..10deg",
    ];
    let options = ["-o", &directory, "--overwrite", "--units", "metric"];
    let (status, answer) = json(
        &[
            &["report", &setup.display().to_string()],
            options.as_slice(),
            ranges.as_slice(),
        ]
        .concat(),
    );
    assert_eq!(status, 0, "{answer}");
    assert_eq!(
        std::fs::read_to_string(folder.path().join("mine.txt")).unwrap(),
        "left alone"
    );

    let page = std::fs::read_to_string(folder.path().join("index.html")).unwrap();
    assert!(
        page.contains("a&lt;b&gt;&amp;c.toml") && !page.contains("a<b>"),
        "escaped"
    );
    assert_eq!(
        page.matches("http").count(),
        page.matches(XMLNS).count(),
        "nothing from elsewhere"
    );
    for word in ["<script", "src=", "@import", "url(", "NaN", "replaced"] {
        assert!(!page.contains(word), "{word}");
    }
    let opens_in = |units: &str| {
        page.contains(&format!(
            "id=\"units-{units}\" type=\"radio\" name=\"units\" checked"
        ))
    };
    assert!(
        opens_in("metric") && !opens_in("us"),
        "the chosen units are shown first"
    );
    for words in [
        "as given, instead of 44.7 m/s",
        "MAE 494 report, listing",
        "at its upper bound: +",
        "yd for each degree that it is raised",
        "m for each degree that it is raised",
        "robinson",
    ] {
        assert!(page.contains(words), "no '{words}'");
    }
    for parameter in Setup::preset("mae494").unwrap().parameters() {
        assert!(page.contains(parameter.name), "{}", parameter.name);
    }
    let pictures: Vec<&str> = page
        .split("<svg")
        .skip(1)
        .map(|rest| rest.split_once("</svg>").unwrap().0)
        .collect();
    for picture in &pictures {
        whole(&format!("<svg{picture}</svg>"));
    }
    let files: Vec<&str> = answer["files"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|name| name.as_str())
        .collect();
    let count = |end: &str| files.iter().filter(|name| name.ends_with(end)).count();
    let figures = page.matches("<figure").count();
    assert_eq!(
        [count("-us.svg"), count("-metric.svg"), count(".csv")],
        [figures; 3]
    );
    // each figure is drawn in two widths, and, unless it has no units, in two systems of units
    let drawn = |class: &str| page.matches(&format!("<div class=\"{class}")).count();
    assert!(
        pictures.len() == drawn("broad") + drawn("narrow") && drawn("broad us") + 1 == figures,
        "{figures}"
    );
    for name in files {
        if name == "explorer.html" {
            continue;
        }
        let text = std::fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(!text.is_empty());
        if name.ends_with(".svg") {
            whole(&text);
        }
        assert!(
            name == "index.html" || page.contains(&format!("href=\"{name}\"")),
            "{name} is linked"
        );
    }
}

#[test]
fn a_report_without_an_optimum_gives_the_reason_and_status_one() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("new").display().to_string();
    let limits = ["--subject-to", "descent_angle >= 80 deg"];
    let output = longdrive(&[&["report", "-o", &directory], limits.as_slice()].concat());
    assert_eq!(output.status, 1, "{}", output.err);
    let page = std::fs::read_to_string(Path::new(&directory).join("index.html")).unwrap();
    assert!(
        page.contains("no optimum: infeasible") && page.contains("The map"),
        "{}",
        output.err
    );
    let output = longdrive(&[
        "report",
        "-o",
        &directory,
        "--overwrite",
        "--set",
        "swing.attack_angle=-20deg",
        "--vary",
        "swing.attack_angle=-40deg..-30deg",
    ]);
    assert!(
        output.status == 1 && output.err.contains("no flight"),
        "{}",
        output.err
    );
}

#[test]
fn bad_plots_and_folders_get_messages_that_help() {
    let folder = tempfile::tempdir().unwrap();
    let (svg, csv, file) = (
        path(&folder, "x.svg"),
        path(&folder, "x.csv"),
        path(&folder, "file"),
    );
    std::fs::write(&file, "").unwrap();
    let missing = path(&folder, "no/such/x.svg");
    let beneath = format!("{file}/report");
    let page = path(&folder, "page");
    for (args, status, says) in [
        (
            vec!["plot", "trajectory", "-o", "x.jpg"],
            2,
            vec!["'x.jpg'", ".svg", ".csv"],
        ),
        (
            vec!["plot", "trajectory", "-o", "x"],
            2,
            vec!["'x'", "extension"],
        ),
        (
            vec!["plot", "trajectory", "-o", &missing],
            2,
            vec![&missing, "there is no folder"],
        ),
        (
            vec!["plot", "trajectory", "-o", &svg, "--width", "10"],
            2,
            vec!["240"],
        ),
        (
            vec!["plot", "trajectory", "-o", &csv, "--dark"],
            2,
            vec!["--dark", "it applies to pictures"],
        ),
        (
            vec!["plot", "tornado", "-o", &csv, "--width", "300"],
            2,
            vec!["--width", "it applies to pictures"],
        ),
        (
            vec![
                "plot",
                "trajectory",
                "-o",
                &svg,
                "--set",
                "swing.attack_angle=-20deg",
            ],
            1,
            vec!["no flight"],
        ),
        (
            vec![
                "plot",
                "contour",
                "-o",
                &svg,
                "--vary",
                "club.loft=4deg..20deg",
            ],
            2,
            vec!["two parameters", "--vary"],
        ),
        (
            vec![
                "plot",
                "chart",
                "-o",
                &svg,
                "--along",
                "swing.speed=40..50m/s",
                "--show",
                "club.lof",
            ],
            2,
            vec!["did you mean 'club.loft'?"],
        ),
        (
            vec!["plot", "pie", "-o", &svg],
            2,
            vec!["unrecognized subcommand"],
        ),
        (
            vec!["report", "-o", &beneath],
            2,
            vec!["cannot be written", &beneath],
        ),
        (vec!["report"], 2, vec!["--output"]),
        (
            vec![
                "report",
                "-o",
                &page,
                "--vary",
                "swing.speed=45..50m/s",
                "--along",
                "swing.speed=40..50m/s",
            ],
            2,
            vec!["swing.speed is a varied parameter"],
        ),
        (
            vec!["plot", "laws", "-o", &svg, "--tolerance"],
            2,
            vec!["this command has no option '--tolerance'"],
        ),
    ] {
        let output = longdrive(&args);
        assert_eq!(output.status, status, "{args:?}: {}", output.err);
        for words in says {
            assert!(
                output.err.contains(words),
                "{args:?}: no '{words}' in {}",
                output.err
            );
        }
        assert!(
            !Path::new(&svg).exists() && !Path::new(&csv).exists(),
            "{args:?}: nothing is written"
        );
    }
}

/// The wind from an angle replaces `wind.right`, which has a usual uncertainty in the drive as set
/// up, but none at the optimum.
#[test]
fn a_report_of_a_varied_wind_from_an_angle_has_a_page() {
    let folder = tempfile::tempdir().unwrap();
    let directory = folder.path().join("new").display().to_string();
    let vary = [
        "--vary",
        "wind.speed=0m/s..5m/s",
        "--vary",
        "wind.from=90deg..270deg",
    ];
    let output = longdrive(&[&["report", "-o", &directory], &vary[..]].concat());
    assert_eq!(output.status, 0, "{}", output.err);
    assert!(!output.err.contains("wind.right"), "{}", output.err);
}
