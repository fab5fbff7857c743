//! Pictures compared with drives: regions, landings, launches, strikes, and true scales.

use crate::command_line::{longdrive, on_one_line};
use crate::common::close;
use crate::pages::DEFAULT_REPORT;
use crate::report::{polylines, whole};
use longdrive::batch::Batch;
use longdrive::optimize::Observer;
use longdrive::parameters::Preset;
use longdrive::report::figures::{
    self, ChartFigures, OnMap, View, face_figure, fairway_figure, launches_figure, map_figure,
    trajectory_figure,
};
use longdrive::report::plot::{Figure, Hue, Layer, Look, Shape, figure_csv, figure_svg};
use longdrive::study::uncertainty::{LandingEllipse, SaltelliDesign, SamplePlan, Uncertain};
use longdrive::study::{
    Chart, ChartObserver, Constraint, DriveRole, Face, Fineness, Landing, Launches, Map,
    NamedDrive, Optimum, Region, Search, Sense, Sigma, Vary, chart, flatness, map, optimum,
    with_defaults,
};
use longdrive::units::{System, TableUnits};
use longdrive::{Drive, Error, Outcome, Setup};

const YARD: f64 = 0.9144;

fn setup() -> Setup<f64> {
    Setup::preset("tour-average").unwrap()
}

/// The setup in large steps, with a tenth of the evaluations. Maps and single drives use the same
/// steps, so their values are comparable.
fn in_large_steps() -> Setup<f64> {
    let mut setup = setup();
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    setup.set_all(crate::common::RIGID).unwrap();
    setup.set("strike.high", "3 mm").unwrap();
    setup
}

/// The plots of a chart for a setup that starts from `tour-average`, and an optimum.
fn chart_figures(
    chart: &Chart,
    setup: &Setup<f64>,
    own: Option<&Optimum>,
    system: System,
) -> ChartFigures {
    let preset = Preset::named("tour-average").unwrap();
    figures::chart_figures(chart, setup, preset, own, system)
}

/// An outcome of the setup with some parameters changed.
pub fn outcome_at(setup: &Setup<f64>, values: &[(&str, f64)], of: Outcome) -> f64 {
    let mut moved = *setup;
    for (name, value) in values {
        moved
            .set_value(moved.column(name).unwrap(), Some(*value))
            .unwrap();
    }
    of.value(&Drive::new(&moved).unwrap()).unwrap()
}

/// An optimum, the region of small loss around it, and the map of carry with both.
fn optimum_with_map(
    setup: &Setup<f64>,
    vary: [&str; 2],
    constraints: &[&str],
) -> (Optimum, Option<Region>, Figure) {
    let vary: Vec<Vary> = vary.map(|text| Vary::read(setup, text).unwrap()).to_vec();
    let subject_to: Vec<Constraint> = constraints
        .iter()
        .map(|text| Constraint::read(text).unwrap())
        .collect();
    let search = Search {
        vary,
        subject_to,
        ..Search::largest(Outcome::Carry)
    };
    let best = optimum(setup, search, Observer::default()).unwrap();
    let [across, up] = [0, 1].map(|i| best.search.vary[i]);
    let over = |of: Outcome| {
        map(
            &best.setup,
            of,
            across,
            up,
            Fineness {
                nodes: 41,
                slopes: 3,
            },
        )
        .unwrap()
    };
    let limits: Vec<(Constraint, Map)> = best
        .search
        .subject_to
        .iter()
        .map(|constraint| (constraint.clone(), over(constraint.goal.outcome().unwrap())))
        .collect();
    let region = Region::around(&best, across, up, YARD).unwrap();
    let on = OnMap {
        setup,
        preset: Preset::named("tour-average").unwrap(),
        limits: &limits,
        best: Some(&best),
        region: region.as_ref(),
    };
    let figure = map_figure(&over(Outcome::Carry), &on, System::Us);
    (best, region, figure)
}

/// The outlines (rings) of the hatched regions of a figure; of the tinted regions if `hatched` is
/// false.
fn rings(figure: &Figure, hatched: bool) -> Vec<Vec<[f64; 2]>> {
    let of = |layer: &Layer| match &layer.shape {
        Shape::Region { is_hatched, rings } if *is_hatched == hatched => rings.clone(),
        _ => vec![],
    };
    figure.layers.iter().flat_map(of).collect()
}

/// True if a point is inside rings, by the even-odd rule.
fn lies_in(rings: &[Vec<[f64; 2]>], [x, y]: [f64; 2]) -> bool {
    let edges = rings
        .iter()
        .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let crossed = edges.filter(|(a, b)| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

const LOFT: &str = "club.loft=4deg..20deg";
const ATTACK: &str = "swing.attack_angle=-5deg..5deg";

#[test]
fn drives_on_the_edge_of_the_region_of_small_loss_have_that_loss_and_meet_every_limit() {
    let setup = in_large_steps();
    for constraints in [
        &[][..],
        &["descent_angle >= 38 deg"],
        &["apex_height <= 30 yd"],
        &["apex_height <= 33 yd", "descent_angle >= 38 deg"],
        &["1900 rpm <= backspin <= 2100 rpm"],
    ] {
        let (best, region, figure) = optimum_with_map(&setup, [LOFT, ATTACK], constraints);
        assert!(region.is_some(), "{constraints:?}");
        let edge: Vec<[f64; 2]> = rings(&figure, false).concat();
        assert!(edge.len() > 40, "{constraints:?}: {} points", edge.len());
        for [loft, attack] in edge.into_iter().step_by(3) {
            let at = [("club.loft", loft), ("swing.attack_angle", attack)];
            let value = |of: Outcome| outcome_at(&best.setup, &at, of);
            let lost = (best.value().unwrap() - value(Outcome::Carry)) / YARD;
            assert!(lost <= 1.002, "{constraints:?} at {at:?}: {lost} yd lost");
            let mut is_edge = lost > 0.94;
            for (vary, (_, x)) in best.search.vary.iter().zip(at) {
                assert!(
                    (vary.low..=vary.high).contains(&x),
                    "{at:?} lies within the bounds"
                );
                is_edge |= (x - vary.low).min(vary.high - x) < 1e-12;
            }
            for constraint in &best.search.subject_to {
                let unit = constraint
                    .goal
                    .quantity
                    .size_of(constraint.goal.unit)
                    .unwrap();
                let short = (constraint.low - value(constraint.goal.outcome().unwrap()))
                    .max(value(constraint.goal.outcome().unwrap()) - constraint.high);
                // a point may miss a limit by 0.01 deg, 0.01 yd or 1 rpm, because the map is linear
                // between its nodes
                let fine = if constraint.goal.outcome() == Some(Outcome::Backspin) {
                    unit
                } else {
                    0.01 * unit
                };
                assert!(
                    short < fine,
                    "{constraints:?} at {at:?}: {} missed by {}",
                    constraint.expression,
                    short / unit
                );
                is_edge |= short > -20.0 * fine;
            }
            assert!(
                is_edge,
                "{constraints:?} at {at:?}: no limit ends the region there, {lost} yd lost"
            );
        }
    }
}

/// At an active constraint the gradient of the outcome is not 0, so an ellipse of the quadratic
/// model would be wrong.
#[test]
fn no_ellipse_is_printed_with_an_active_constraint() {
    let (best, ..) = optimum_with_map(
        &in_large_steps(),
        [LOFT, ATTACK],
        &["apex_height <= 33 yd", "descent_angle >= 38 deg"],
    );
    assert!(best.active().iter().all(|active| active.end.is_none()) && !best.active().is_empty());
    assert!(flatness(&best, YARD).unwrap().ellipses.is_empty());
}

#[test]
fn only_the_infeasible_region_is_hatched() {
    let (best, _, figure) = optimum_with_map(
        &in_large_steps(),
        [LOFT, ATTACK],
        &["33 deg <= descent_angle <= 38 deg"],
    );
    let hatched = rings(&figure, true);
    let [across, up] = [0, 1].map(|i| best.search.vary[i]);
    let mut seen = [0, 0];
    for i in 0..12 {
        for j in 0..12 {
            let part =
                |vary: &Vary, k: usize| vary.low + (k as f64 + 0.5) / 12.0 * (vary.high - vary.low);
            let at = [part(&across, i), part(&up, j)];
            let descent = outcome_at(
                &best.setup,
                &[("club.loft", at[0]), ("swing.attack_angle", at[1])],
                Outcome::DescentAngle,
            )
            .to_degrees();
            // skip points near a limit, because the map is linear between its nodes
            if (descent - 33.0).abs() > 0.05 && (descent - 38.0).abs() > 0.05 {
                let is_forbidden = !(33.0..=38.0).contains(&descent);
                assert_eq!(lies_in(&hatched, at), is_forbidden, "{at:?}: {descent}");
                seen[usize::from(is_forbidden)] += 1;
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 5), "{seen:?}");
    assert!(figure.note.contains("Hatched: "), "{}", figure.note);
    let (_, _, figure) = optimum_with_map(
        &in_large_steps(),
        [LOFT, ATTACK],
        &["descent_angle >= 1 deg"],
    );
    assert!(rings(&figure, true).is_empty() && !figure.note.contains("Hatched: "));
}

#[test]
fn an_equation_keeps_the_part_of_its_line_with_small_loss() {
    let mut setup = in_large_steps();
    setup.set("swing.path", "3 deg").unwrap();
    let face = "swing.face_angle=-3deg..6deg";
    let (best, region, figure) = optimum_with_map(&setup, [LOFT, face], &["lateral == 0 m"]);
    assert!(region.unwrap().equation.is_some());
    assert!(
        figure
            .note
            .contains("Drives on the line “at most 1.00 yd lost” meet every bound and constraint")
            && !figure.note.contains("region"),
        "{}",
        figure.note
    );
    assert!(
        rings(&figure, false).is_empty() && rings(&figure, true).is_empty(),
        "a line has no area"
    );
    let line = figure.layers.iter().find_map(|layer| match &layer.shape {
        Shape::Line { points, .. } if layer.name.contains("lost") => Some(points.clone()),
        _ => None,
    });
    let line: Vec<[f64; 2]> = line
        .unwrap()
        .into_iter()
        .filter(|[x, _]| x.is_finite())
        .collect();
    assert!(line.len() > 20);
    for [loft, face] in line {
        let value = |of: Outcome| {
            outcome_at(
                &best.setup,
                &[("club.loft", loft), ("swing.face_angle", face)],
                of,
            ) / YARD
        };
        assert!(
            value(Outcome::Lateral).abs() < 0.02,
            "{}",
            value(Outcome::Lateral)
        );
        assert!(best.value().unwrap() / YARD - value(Outcome::Carry) < 1.03);
    }
}

/// A straight drive stays straight for every loft: the equation forbids nothing.
#[test]
fn an_equation_that_holds_everywhere_does_not_change_the_region() {
    let [with, without] = [&["lateral == 0 m"][..], &[]]
        .map(|limits| optimum_with_map(&in_large_steps(), [LOFT, ATTACK], limits));
    let region = with.1.expect("the region");
    assert_eq!(
        (region.equation, rings(&with.2, false).len()),
        (None, rings(&without.2, false).len())
    );
    let output = on_one_line(&longdrive(&["optimize", "--subject-to", "lateral == 0 m"]).out);
    assert!(
        output.contains("no varied parameter changes it")
            && !output.contains("that the value is raised"),
        "{output}"
    );
}

#[test]
fn a_map_states_its_point_and_has_names() {
    let mut setup = setup();
    setup.set("swing.speed", "97 mph").unwrap();
    let (_, _, figure) = optimum_with_map(&setup, [LOFT, ATTACK], &["descent_angle >= 38 deg"]);
    assert!(figure.subtitle.contains("97 mph"), "{}", figure.subtitle);
    for width in [240, 480, 1200] {
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
        let texts: Vec<(String, f64)> = texts
            .map(|text| {
                (
                    text.text().unwrap().trim().to_owned(),
                    text.attribute("y").unwrap().parse::<f64>().unwrap(),
                )
            })
            .collect();
        let place = |has: &str| {
            texts
                .iter()
                .find(|(text, _)| text.contains(has))
                .map(|(_, y)| *y)
        };
        let first_tick = place("swing attack angle")
            .or(place("attack angle"))
            .unwrap();
        for name in ["38", "as set up", "optimum", " yd"] {
            assert!(
                texts
                    .iter()
                    .any(|(text, y)| text.contains(name) && *y > first_tick),
                "{width}: '{name}' in {texts:?}"
            );
        }
        let titles = picture
            .descendants()
            .filter(|node| node.has_tag_name("title"));
        let titles: Vec<_> = titles.filter_map(|title| title.text()).collect();
        assert!(
            titles
                .iter()
                .any(|title| title.starts_with("carry 2") && title.ends_with(" yd")),
            "{titles:?}"
        );
        assert!(
            titles.iter().any(|title| title.starts_with("optimum, ")),
            "{titles:?}"
        );
    }
}

#[test]
fn a_chart_marks_the_drive_and_names_active_bounds() {
    let setup = setup();
    let search = Search::longest_drive(&setup).unwrap();
    let along = Vary::read(&setup, "swing.speed=90mph..125mph").unwrap();
    let found = chart(&setup, &search, along, &[], &ChartObserver::default()).unwrap();
    let best = optimum(&setup, search, Observer::default()).unwrap();
    let figures = chart_figures(&found, &setup, Some(&best), System::Us);
    assert_eq!(figures.drawn.len(), 2, "the attack angle has no figure");
    assert!(
        figures.at_bound[0].1.contains("upper bound"),
        "{}",
        figures.at_bound[0].1
    );
    assert!(figures.drawn[0].note.contains(&figures.at_bound[0].1));
    for (figure, value) in figures
        .drawn
        .iter()
        .zip([best.value().unwrap(), best.solution.x[0]])
    {
        let mark = figure.layers.iter().find_map(|layer| match layer.shape {
            Shape::Mark(at) if layer.name.contains("mph: ") => Some((at, layer.hue)),
            _ => None,
        });
        // the mark is on the line of optima, and has its colour
        let marked = ([setup.swing.speed, value], Hue::OPTIMUM);
        assert_eq!(mark, Some(marked));
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let output = longdrive(&[
        "plot",
        "chart",
        "-o",
        &file,
        "--along",
        "swing.speed=90mph..125mph",
        "--show",
        "swing.attack_angle",
    ]);
    assert!(
        output.status == 2 && output.err.contains("upper bound, in every optimum"),
        "{}",
        output.err
    );
}

/// The chart follows the optimum at the largest loft; at the speed as set up a search finds a
/// slower landing at a smaller loft.
#[test]
fn a_chart_that_misses_the_optimum_of_the_setup_has_a_sentence_about_it() {
    let setup = setup();
    let search = Search {
        sense: Sense::Minimize,
        of: Outcome::LandingSpeed.into(),
        ..Search::longest_drive(&setup).unwrap()
    };
    let along = Vary::read(&setup, "swing.speed=80mph..130mph").unwrap();
    let follow = |at: &[f64]| chart(&setup, &search, along, at, &ChartObserver::default());
    let found = follow(&[]).unwrap();
    let own = optimum(&setup, search.clone(), Observer::default()).unwrap();
    let followed = follow(&[setup.swing.speed]).unwrap();
    let lost = followed.points[0].best.value().unwrap() - own.value().unwrap();
    assert!(lost > 0.005, "{lost} m/s");
    close(found.loss_at(&own).unwrap(), lost, lost, 1e-6, "the loss");
    let figures = chart_figures(&found, &setup, Some(&own), System::Us);
    assert!(
        !figures
            .at_bound
            .iter()
            .any(|(vary, _)| vary.parameter.name == "club.loft"),
        "{:?}",
        figures.at_bound
    );
    let says = "At 115 mph the line follows another optimum than the mark, which is better by 0.0";
    assert!(figures.drawn.len() >= 2, "{}", figures.drawn.len());
    for figure in &figures.drawn {
        assert!(figure.note.contains(says), "{}", figure.note);
    }
}

#[test]
fn events_of_a_chart_are_in_words_with_the_chosen_units() {
    let setup = Setup::modern_driver();
    let limit = Constraint::read("apex_height <= 35 yd").unwrap();
    let search = Search {
        subject_to: vec![limit],
        ..Search::longest_drive(&setup).unwrap()
    };
    let along = Vary::read(&setup, "swing.speed=80mph..130mph").unwrap();
    let found = chart(&setup, &search, along, &[], &ChartObserver::default()).unwrap();
    for (system, limit) in [
        (System::Us, "apex height ≤ 35 yd from here on"),
        (System::Metric, "apex height ≤ 32.004 m from here on"),
    ] {
        let note = &chart_figures(&found, &setup, None, system).drawn[0].note;
        assert!(
            note.contains(limit) && !note.contains("<=") && !note.contains("apex_height"),
            "{note}"
        );
    }
}

/// Pixels per metre along both axes of a figure, from a drawn line and its data.
fn scales(figure: &Figure, line: &[[f64; 2]]) -> [f64; 2] {
    let svg = figure_svg(
        figure,
        &Look {
            width: 800,
            ..Look::default()
        },
    )
    .unwrap();
    let drawn = polylines(&whole(&svg))
        .into_iter()
        .find(|points| points.len() == line.len())
        .unwrap();
    let extent = |points: &[[f64; 2]], axis: usize| {
        let values = || points.iter().map(|point| point[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    [0, 1].map(|axis| extent(&drawn, axis) / extent(line, axis))
}

fn line_of(figure: &Figure, name: &str) -> Vec<[f64; 2]> {
    let line = figure.layers.iter().find_map(|layer| match &layer.shape {
        Shape::Line { points, .. } if layer.name == name => Some(points.clone()),
        _ => None,
    });
    line.unwrap_or_else(|| panic!("no line {name}"))
}

/// The name of the largest landing ellipse of the drive as set up.
fn largest_ellipse_name(figure: &Figure) -> String {
    let names = figure.layers.iter().map(|layer| layer.name.as_str());
    names
        .into_iter()
        .find(|name| name.starts_with("as set up: carry"))
        .unwrap()
        .to_owned()
}

#[test]
fn trajectories_and_landings_are_drawn_at_true_scale() {
    let mut setup = setup();
    for (face, loft) in [
        ("3 deg", "10 deg"),
        ("25 deg", "60 deg"),
        ("-0.2 deg", "4 deg"),
    ] {
        setup.set("swing.face_angle", face).unwrap();
        setup.set("club.loft", loft).unwrap();
        let flown = [NamedDrive::new(DriveRole::AsSetUp, &setup).unwrap()];
        for view in [View::Side, View::Top] {
            let figure = trajectory_figure(&flown, view, System::Us).unwrap();
            let [across, up] = scales(&figure, &line_of(&figure, "as set up"));
            close(
                up,
                across,
                across,
                0.02,
                "as many pixels for a yard upwards as across",
            );
        }
        let sigmas = with_defaults(&setup, &[], &[Outcome::Carry]).unwrap();
        let figure = fairway_figure(
            &[Landing::of(DriveRole::AsSetUp, &setup, &sigmas).unwrap()],
            System::Us,
        );
        let [across, up] = scales(&figure, &line_of(&figure, &largest_ellipse_name(&figure)));
        close(up, across, across, 0.02, "landings");
    }
}

#[test]
fn a_side_view_has_its_numbers_at_the_points_and_a_stretched_view_below() {
    let setup = setup();
    let figure = trajectory_figure(
        &[NamedDrive::new(DriveRole::AsSetUp, &setup).unwrap()],
        View::Side,
        System::Us,
    )
    .unwrap();
    let drive = Drive::new(&setup).unwrap();
    for (word, of, x, y) in [
        (
            "apex",
            Outcome::ApexHeight,
            Outcome::ApexDownrange,
            Some(Outcome::ApexHeight),
        ),
        ("carry", Outcome::Carry, Outcome::Carry, None),
    ] {
        let value = |of: Outcome| of.value(&drive).unwrap();
        let mark = figure.layers.iter().find_map(|layer| match layer.shape {
            Shape::Mark(at) if layer.name.starts_with(word) => Some((layer.name.clone(), at)),
            _ => None,
        });
        let (name, at) = mark.unwrap();
        assert!(
            name.contains(&format!("{:.1} yd", value(of) / YARD)),
            "{name}"
        );
        assert_eq!(at[0], value(x));
        close(at[1], y.map_or(0.0, value), 1.0, 1e-9, word);
    }
    let times: f64 = figure.panels[0]
        .title
        .split_whitespace()
        .find_map(|word| word.parse().ok())
        .unwrap();
    let [across, up] = scales(&figure.panels[0], &line_of(&figure, "as set up"));
    close(
        up / across,
        times,
        times,
        0.06,
        "heights are as many times as large as it says",
    );
}

#[test]
fn a_constant_map_is_not_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let (file, page) = (
        folder.path().join("a.svg").display().to_string(),
        folder.path().join("page"),
    );
    let straight = folder.path().join("straight");
    // a straight drive lands on the target line for every loft, to rounding
    let output = longdrive(&["plot", "contour", "-o", &file, "--minimize", "lateral"]);
    assert!(
        output.status == 2 && output.err.contains("lateral is constant over the map"),
        "{}",
        output.err
    );
    assert!(!std::path::Path::new(&file).exists());
    // air and wind do not change the ball speed
    let air = [
        "--vary",
        "air.density=1..1.3 kg/m^3",
        "--vary",
        "wind.downrange=-5..5 m/s",
    ];
    let output = longdrive(
        &[
            &[
                "report",
                "-o",
                &page.display().to_string(),
                "--maximize",
                "ball_speed",
            ],
            &air[..],
        ]
        .concat(),
    );
    let page = std::fs::read_to_string(page.join("index.html")).unwrap();
    assert!(
        page.contains("ball_speed is constant over the map") && !page.contains("map-ball"),
        "{}",
        output.err
    );
    // a derivative that is 0 in every drive has no curve, but the page is complete
    let output = longdrive(&[
        "report",
        "-o",
        &straight.display().to_string(),
        "--minimize",
        "lateral",
    ]);
    assert!(
        output.status == 0 && straight.join("index.html").exists(),
        "{}",
        output.err
    );
}

#[test]
fn a_straight_drive_has_no_view_from_above() {
    let flown = [NamedDrive::new(DriveRole::AsSetUp, &setup()).unwrap()];
    let error = trajectory_figure(&flown, View::Top, System::Us).unwrap_err();
    assert!(
        matches!(&error, Error::Plot { reason, .. } if reason.contains("straight")),
        "{error}"
    );
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let output = longdrive(&["plot", "trajectory", "-o", &file, "--view", "top"]);
    assert!(
        output.status == 2 && output.err.contains("--view side"),
        "{}",
        output.err
    );
    assert!(!std::path::Path::new(&file).exists());
    let page = DEFAULT_REPORT.file("index.html");
    assert!(
        page.contains("from above these drives are straight") && !page.contains("trajectory-top")
    );
}

/// Fractions of 4000 drives whose landing is in each ellipse. The drives are another sample than
/// that of the ellipses.
fn shares_in_ellipses(setup: &Setup<f64>, landing: &Landing) -> Vec<f64> {
    let inputs = landing.sigmas.iter();
    let distributions: Vec<_> = inputs
        .map(|sigma| Uncertain::normal(setup, sigma).distribution)
        .collect();
    let parameters: Vec<_> = landing.sigmas.iter().map(|one| one.parameter).collect();
    let plan = SamplePlan {
        samples: 4000,
        seed: 9,
    };
    let points = &SaltelliDesign::new(&distributions, plan).unwrap().points[0];
    let of = [Outcome::Lateral, Outcome::Carry];
    let batch = Batch::new(setup, &parameters, &of, &[]).unwrap();
    let block = batch.evaluate(0, points.concat());
    let landings: Vec<[f64; 2]> = block
        .result(0)
        .zip(block.result(1))
        .map(|(lateral, carry)| [lateral.unwrap(), carry.unwrap()])
        .collect();
    let share = |ellipse: &LandingEllipse| {
        let within = landings.iter().filter(|at| ellipse.contains(**at)).count();
        within as f64 / landings.len() as f64
    };
    landing.ellipses.iter().map(share).collect()
}

/// The carry of a straight drive has no first derivative by the face angle, so the ellipse of the
/// gradients at 2° holds 32 % and 56 % of the landings instead of 50 % and 95 %.
#[test]
fn sampled_ellipses_on_the_fairway_hold_the_shares_of_the_caption() {
    let of = [Outcome::Carry, Outcome::Lateral];
    for (face, sigma) in [
        ("0 deg", "swing.face_angle=0.1deg"),
        ("0 deg", "swing.face_angle=1deg"),
        ("0 deg", "swing.face_angle=2deg"),
        ("1 deg", "swing.face_angle=2deg"),
        ("0 deg", "swing.speed=20mph"),
    ] {
        let mut setup = setup();
        setup.set("swing.face_angle", face).unwrap();
        let given = [Sigma::read(&setup, sigma).unwrap()];
        let defaults = with_defaults(&setup, &given, &of).unwrap();
        for sigmas in [&given[..], &defaults] {
            let landing = Landing::of(DriveRole::AsSetUp, &setup, sigmas).unwrap();
            let shares = shares_in_ellipses(&setup, &landing);
            assert_eq!(shares.len(), 2, "{sigma}");
            // four standard errors of the two samples
            close(shares[0], 0.5, 1.0, 0.045, sigma);
            close(shares[1], 0.95, 1.0, 0.02, sigma);
        }
    }
}

/// The fairway is 30 yd wide, so its edges are 15 yd left and right of the target line.
#[test]
fn exact_sides_of_the_fairway_in_titles_of_points() {
    let landing = Landing::of(DriveRole::AsSetUp, &setup(), &[]).unwrap();
    let figure = fairway_figure(&[landing], System::Us);
    let picture = figure_svg(&figure, &Look::default()).unwrap();
    assert!(
        picture.contains("fairway, 15.0 yd L, downrange "),
        "{picture}"
    );
    assert!(picture.contains(">15.0 yd R, downrange "), "{picture}");
    let axis = "L, R: left and right of the target line [yd]";
    assert!(picture.contains(axis), "{picture}");
    assert!(!picture.contains("(left: −)"), "{picture}");
}

#[test]
fn the_landing_and_the_ellipses_of_the_fairway_are_those_of_the_drive() {
    let mut setup = setup();
    setup.set("swing.face_angle", "1 deg").unwrap();
    let of = [Outcome::Carry, Outcome::Lateral];
    let sigmas = with_defaults(
        &setup,
        &[Sigma::read(&setup, "swing.face_angle=2deg").unwrap()],
        &of,
    )
    .unwrap();
    let landing = Landing::of(DriveRole::AsSetUp, &setup, &sigmas).unwrap();
    assert!(
        landing
            .sigmas
            .iter()
            .all(|sigma| !sigma.parameter.name.starts_with("aero."))
    );
    for (lateral, words) in [
        (0.0, "on the target line"),
        (3.2, "3.5 yd right of the target line"),
        (-3.2, "3.5 yd left of"),
    ] {
        let beside = Landing {
            at: [lateral, 250.0],
            ..landing.clone()
        };
        let note = fairway_figure(&[beside], System::Us).note;
        assert!(
            note.starts_with(&format!("As set up: carry 273.4 yd, {words}")),
            "{note}"
        );
    }
    // the points of the drawn ellipse are on the computed ellipse, and the drawn landing is the
    // landing of the drive
    let figure = fairway_figure(std::slice::from_ref(&landing), System::Us);
    // the run is a solid line in the colour of its drive, and the legend names it
    let run = figure
        .layers
        .iter()
        .find(|layer| layer.name == "run")
        .unwrap();
    let own = figure
        .layers
        .iter()
        .find(|layer| layer.name.starts_with("as set up: carry"))
        .unwrap();
    assert!(
        matches!(
            run.shape,
            Shape::Line {
                is_dashed: false,
                ..
            }
        ) && run.hue == own.hue
    );
    let wide = landing.ellipses[1];
    for point in line_of(&figure, &largest_ellipse_name(&figure)) {
        let out = |part: f64| {
            let centre = [wide.centre.lateral, wide.centre.carry];
            [0, 1].map(|axis| centre[axis] + part * (point[axis] - centre[axis]))
        };
        assert!(
            wide.contains(out(0.999)) && !wide.contains(out(1.001)),
            "{point:?}"
        );
    }
    let drive = Drive::new(&setup).unwrap();
    for (at, of) in landing
        .at
        .into_iter()
        .zip([Outcome::Lateral, Outcome::Carry])
    {
        close(at, of.value(&drive).unwrap(), 250.0, 1e-12, "the landing");
    }
}

/// The landings of the drive as set up and of its optimum.
fn two_landings() -> [Landing; 2] {
    let setup = setup();
    let search = Search::longest_drive(&setup).unwrap();
    let best = optimum(&setup, search, Observer::default()).unwrap();
    [
        (DriveRole::AsSetUp, &setup),
        (DriveRole::Optimum, &best.setup),
    ]
    .map(|(role, setup)| {
        let sigmas = with_defaults(setup, &[], &[Outcome::Carry]).unwrap();
        Landing::of(role, setup, &sigmas).unwrap()
    })
}

fn arcs(view: &Figure) -> Vec<Vec<[f64; 2]>> {
    let arc = |layer: &Layer| match &layer.shape {
        Shape::Line {
            is_dashed: false,
            points,
        } if layer.name.is_empty() && layer.hue == Hue::Faint => Some(points.clone()),
        _ => None,
    };
    view.layers.iter().filter_map(arc).collect()
}

/// The arcs of the fairway are at the distances that their labels state; the second view begins at
/// the tee.
#[test]
fn exact_distances_of_the_arcs_and_the_edges_of_a_fairway() {
    let landings = two_landings();
    for (system, unit, size) in [(System::Us, "yd", YARD), (System::Metric, "m", 1.0)] {
        let figure = fairway_figure(&landings, system);
        let tee = &figure.panels[0];
        let radius = |[x, y]: [f64; 2]| x.hypot(y) / size;
        for view in [&figure, tee] {
            let arcs = arcs(view);
            assert!(arcs.len() > 2, "{}", view.name);
            for arc in &arcs {
                let first = radius(arc[0]).round();
                assert!(first % 5.0 == 0.0 && arc.len() > 50);
                for at in arc {
                    close(radius(*at), first, first, 1e-12, "a point of an arc");
                }
            }
            let mut labels = 0;
            for layer in &view.layers {
                if let Shape::Text(at) = layer.shape {
                    let name = &layer.name;
                    let stated: f64 = name.strip_suffix(unit).unwrap().trim().parse().unwrap();
                    close(radius(at), stated, stated, 1e-12, name);
                    labels += 1;
                }
            }
            assert!(labels > 1, "{labels}");
        }
        for [x, _] in line_of(&figure, "fairway") {
            close(x, -15.0 * YARD, 1.0, 1e-12, "the left edge");
        }
        let at_tee = tee
            .layers
            .iter()
            .any(|layer| matches!(layer.shape, Shape::Mark([0.0, 0.0])) && layer.name == "tee");
        assert!(at_tee);
    }
}

/// Both runs are on the target line. One run is dashed, so that both are seen, and a mark at the
/// end of each run has its total.
#[test]
fn two_runs_on_one_line_are_both_seen() {
    let landings = two_landings();
    let figure = fairway_figure(&landings, System::Us);
    let runs = figure.layers.iter().filter_map(|layer| match layer.shape {
        Shape::Line { is_dashed, .. } if layer.name == "run" => Some(is_dashed),
        _ => None,
    });
    assert_eq!(runs.collect::<Vec<_>>(), [false, true]);
    for rest in landings.iter().map(|landing| landing.rest.unwrap()) {
        let total = format!("total {:.1} yd", rest[1] / YARD);
        let marks = figure.layers.iter();
        let mut marks = marks.filter(|layer| matches!(layer.shape, Shape::Mark(_)));
        assert!(marks.any(|layer| layer.name == total), "{total}");
    }
}

#[test]
fn same_flights_in_a_launch_map_and_alone() {
    let mut setup = setup();
    setup.set("swing.face_angle", "1 deg").unwrap();
    let best = optimum(
        &setup,
        Search::longest_drive(&setup).unwrap(),
        Observer::default(),
    )
    .unwrap();
    let map = Launches::around(&[
        (DriveRole::AsSetUp, &setup),
        (DriveRole::Optimum, &best.setup),
    ])
    .unwrap();
    let own = Drive::new(&setup).unwrap();
    let carry = |angle: f64, backspin: f64| {
        outcome_at(
            &map.setup,
            &[
                ("launch.launch_angle", angle),
                ("launch.backspin", backspin),
            ],
            Outcome::Carry,
        )
    };
    // the launch marked as the golfer's own has the carry of the strike
    let [yours, others] = [0, 1].map(|i| &map.launched[i]);
    close(
        carry(yours.launch_angle, yours.backspin),
        Outcome::Carry.value(&own).unwrap(),
        250.0,
        1e-12,
        "own launch",
    );
    close(
        others.carry.unwrap(),
        best.value().unwrap(),
        250.0,
        1e-12,
        "the optimum's carry",
    );
    for node in (0..map.plane.values[0].len()).step_by(397) {
        let [angle, backspin] = map.plane.node(node);
        close(
            map.plane.values[0][node].unwrap(),
            carry(angle, backspin),
            250.0,
            1e-12,
            "a node",
        );
    }
    assert!(map.ridge.len() > 10);
    for [angle, backspin] in map.ridge.iter().step_by(7) {
        for off in [-0.3_f64, 0.3] {
            assert!(
                carry(*angle, *backspin) > carry(angle + off.to_radians(), *backspin),
                "{angle} {backspin}"
            );
        }
    }
    let figure = launches_figure(&map, System::Us);
    assert!(
        figure.subtitle.contains(" mph") && figure.note.contains("ball speed"),
        "{}",
        figure.note
    );
    assert!(figure_csv(&figure, TableUnits::Si).unwrap().lines().count() > 3700);
    // the note states the ball speed of a drive only if it differs from the map's
    let mut lofted = setup;
    lofted.launch.ball_speed = Some(70.0);
    lofted.launch.launch_angle = Some(0.2);
    lofted.launch.spin = Some(300.0);
    let mut faster = lofted;
    faster.launch.ball_speed = Some(75.0);
    let drives = [
        (DriveRole::AsSetUp, &lofted),
        (DriveRole::Optimum, &lofted),
        (DriveRole::Optimum, &faster),
    ];
    let map = Launches::around(&drives).unwrap();
    let note = launches_figure(&map, System::Us).note;
    assert_eq!(note.matches(", its own ball speed").count(), 1, "{note}");
    assert!(note.contains("its own ball speed 167.8 mph"), "{note}");
}

#[test]
fn rings_on_the_face_have_their_loss_and_arrows_tilt_with_the_spin_axis() {
    let mut setup = setup();
    setup.set("strike.toe", "8 mm").unwrap();
    let face = Face::of(&setup).unwrap();
    let figure = face_figure(&face, System::Us);
    let strike = |toe: f64, high: f64, of: Outcome| {
        outcome_at(&setup, &[("strike.toe", toe), ("strike.high", high)], of)
    };
    for (name, lost) in [("−1 yd", 1.0), ("−5 yd", 5.0), ("−10 yd", 10.0)] {
        let ring: Vec<_> = line_of(&figure, name)
            .into_iter()
            .filter(|[x, _]| x.is_finite())
            .collect();
        assert!(ring.len() > 20, "{name}");
        for [x, high] in ring.into_iter().step_by(5) {
            close(
                face.longest.1 - strike(-x, high, Outcome::Carry),
                lost * YARD,
                YARD,
                0.03,
                name,
            );
        }
    }
    let arrows = figure.layers.iter().find_map(|layer| match &layer.shape {
        Shape::Arrows(arrows) => Some(arrows.clone()),
        _ => None,
    });
    let straight = strike(0.0, 0.0, Outcome::SpinAxis);
    let mut seen = [false; 2];
    for [from, to] in arrows.unwrap() {
        let tilt = strike(-from[0], from[1], Outcome::SpinAxis) - straight;
        // the face is seen from the front, so a tilt of the spin axis to the right points to the
        // left
        assert!((to[0] - from[0]) * tilt <= 1e-12, "{from:?}");
        seen[usize::from(tilt > 0.0)] = true;
    }
    assert_eq!(seen, [true, true]);
    // a launch has no face
    let mut launched = setup;
    for (name, value) in [
        ("launch.ball_speed", "70 m/s"),
        ("launch.launch_angle", "12 deg"),
        ("launch.backspin", "2500 rpm"),
    ] {
        launched.set(name, value).unwrap();
    }
    assert!(matches!(
        Face::of(&launched),
        Err(Error::NotVariable { .. })
    ));
}

#[test]
fn pictures_are_drawn_at_every_width_and_name_omitted_parts() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let launch = [
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm",
    ];
    for kind in ["fairway", "launch", "face", "strike"] {
        for width in ["240", "340", "480", "1200"] {
            let output = longdrive(&["plot", kind, "-o", &file, "--overwrite", "--width", width]);
            assert_eq!(output.status, 0, "{kind} {width}: {}", output.err);
            whole(&std::fs::read_to_string(&file).unwrap());
        }
        let output =
            longdrive(&[&["plot", kind, "-o", &file, "--overwrite"], &launch[..]].concat());
        if ["face", "strike"].contains(&kind) {
            assert!(
                output.status == 2 && output.err.contains("no club"),
                "{}",
                output.err
            );
        } else {
            assert!(
                output.status == 0 && output.err.contains("no optimum is drawn"),
                "{kind}: {}",
                output.err
            );
        }
        let down = longdrive(&[
            "plot",
            kind,
            "-o",
            &file,
            "--overwrite",
            "--set",
            "swing.attack_angle=-40deg",
        ]);
        assert!(
            down.status == 1 && down.err.contains("no flight"),
            "{kind}: {} {}",
            down.status,
            down.err
        );
    }
    let output = longdrive(&[
        "plot",
        "fairway",
        "-o",
        &file,
        "--overwrite",
        "--subject-to",
        "descent_angle >= 80 deg",
    ]);
    assert!(
        output.status == 1 && output.err.contains("no optimum is drawn: infeasible"),
        "{}",
        output.err
    );
}

/// A carry of 400 yd is out of reach. The picture shows the drive as set up.
#[test]
fn a_stated_search_without_an_optimum_ends_infeasible_in_every_picture() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    for kind in ["fairway", "contour", "strike", "launch"] {
        let limit = ["--subject-to", "carry>=400yd", "-q", "--json"];
        let plot = ["plot", kind, "-o", &file, "--overwrite"];
        let output = longdrive(&[&plot[..], &limit].concat());
        let answer: serde_json::Value = serde_json::from_str(&output.out).unwrap();
        let warnings = answer["warnings"].to_string();
        assert!(
            output.status == 1
                && answer["status"] == "infeasible"
                && answer["message"].is_string()
                && warnings.contains("no optimum is drawn: infeasible: ")
                && output.err.contains("no optimum is drawn: infeasible: "),
            "{kind}: {} {answer} {}",
            output.status,
            output.err
        );
        whole(&std::fs::read_to_string(&file).unwrap());
    }
}

/// The sources of naruo-mizota and lyu state no Reynolds number of a measured point.
#[test]
fn the_caption_of_laws_names_the_measured_points_at_any_reynolds_number() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let caption = |laws: &str, reynolds: &str| {
        let plot = ["plot", "laws", "--show", "cl", "-o", &file, "--overwrite"];
        let chosen = ["--laws", laws, "--reynolds", reynolds];
        let output = longdrive(&[&plot[..], &chosen].concat());
        assert_eq!(output.status, 0, "{}", output.err);
        on_one_line(&output.err)
    };
    let at_any = "those of naruo-mizota, lyu are drawn at any Reynolds number, because their \
                  sources state no single one.";
    let none = caption("naruo-mizota,lyu", "6e4");
    assert!(
        none.contains(&format!("Points are measured values; {at_any}")),
        "{none}"
    );
    let near = "Points are measured values, within 10 % of a Reynolds number of 150000";
    let both = caption("naruo-mizota,lyu,bearman-harvey", "1.5e5");
    assert!(both.contains(&format!("{near}; {at_any}")), "{both}");
    let stated = caption("bearman-harvey", "1.5e5");
    assert!(stated.contains(&format!("{near}. ")), "{stated}");
    let nothing = caption("ferguson", "1.5e5");
    assert!(!nothing.contains("Points are"), "{nothing}");
}

/// What a golfer states of the club and its path.
const STATED: [&str; 4] = ["--attack", "-3deg", "--loft", "10.5deg"];

/// Draws a plot of the stated drive, and returns the picture and the messages, each on one line.
fn stated_plot(kind: &str, more: &[&str]) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let output = longdrive(&[&["plot", kind, "-o", &file], &STATED[..], more].concat());
    assert_eq!(output.status, 0, "{kind} {more:?}: {}", output.err);
    let picture = std::fs::read_to_string(&file).unwrap();
    (picture, on_one_line(&output.err))
}

/// The texts of a picture, joined by spaces: words of a wrapped line stay in order.
fn texts(svg: &str) -> String {
    let picture = whole(svg);
    let texts = picture
        .descendants()
        .filter(|node| node.has_tag_name("text"));
    let texts: Vec<_> = texts.filter_map(|text| text.text()).collect();
    on_one_line(&texts.join(" "))
}

const SPEED: [&str; 2] = ["--speed", "92mph"];
const LOFT_ALONE: [&str; 2] = ["--vary", "club.loft=4deg..20deg"];

#[test]
fn a_caption_names_the_constraints_of_its_optimum() {
    let free = [&SPEED[..], &LOFT_ALONE].concat();
    let limits = [
        "--subject-to=descent_angle >= 38 deg",
        "--subject-to=apex_height <= 60 yd",
    ];
    let limited = [&free[..], &limits].concat();
    for kind in ["launch", "fairway", "strike"] {
        let (_, messages) = stated_plot(kind, &limited);
        let says = "The optimum has club.loft 15.94°, with descent angle ≥ 38° and apex height ≤ 60 \
                    yd.";
        assert!(messages.contains(says), "{kind}: {messages}");
        let (_, messages) = stated_plot(kind, &free);
        let says = "The optimum has club.loft 14.25°.";
        assert!(messages.contains(says), "{kind}: {messages}");
    }
}

/// Pictures are shown to others: no folder of a disk stands in them.
#[test]
fn a_picture_names_a_table_of_ones_own_without_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("mine.csv").display().to_string();
    let nodes = "spin_ratio,cd,cl\n0.05,0.22,0.08\n0.1,0.24,0.13\n0.2,0.27,0.2\n0.3,0.3,0.25\n";
    std::fs::write(&table, nodes).unwrap();
    let law = format!("aero.table={table}");
    let vary = ["--vary", "swing.speed=80mph..100mph"];
    let (picture, _) = stated_plot(
        "contour",
        &[&LOFT_ALONE[..], &vary, &["--set", &law]].concat(),
    );
    let words = texts(&picture);
    assert!(words.contains("law of drag and lift mine.csv"), "{words}");
    assert!(!picture.contains(&*folder.path().to_string_lossy()));
}

#[test]
fn a_subtitle_names_stated_values_that_are_not_on_an_axis() {
    let speed = ["--vary", "swing.speed=80mph..100mph"];
    let attack = ["--vary", "swing.attack_angle=-5deg..5deg"];
    let along = ["--along", "swing.speed=85mph..100mph"];
    let limit = ["--subject-to", "descent_angle >= 38 deg"];
    let goals = ["--maximize", "carry", "--minimize", "spin"];
    for (kind, more, subtitle) in [
        (
            "contour",
            [&SPEED[..], &LOFT_ALONE, &speed].concat(),
            " at attack angle −3°, all else as set up ",
        ),
        (
            "contour",
            [&SPEED[..], &LOFT_ALONE, &attack].concat(),
            " at club speed 92 mph, all else as set up ",
        ),
        (
            "contour",
            [&speed[..], &attack].concat(),
            " at club loft 10.5°, all else as set up ",
        ),
        (
            "contour",
            [&speed[..], &["--vary", "club.mass=180g..220g"]].concat(),
            " at attack angle −3°, club loft 10.5°, all else as set up ",
        ),
        (
            "chart",
            [&LOFT_ALONE[..], &along].concat(),
            " at attack angle −3°, all else as set up ",
        ),
        (
            "chart",
            [&LOFT_ALONE[..], &along, &["--set=aero.law=smits-smith"]].concat(),
            " at attack angle −3°, law of drag and lift smits-smith, all else as set up ",
        ),
        (
            "chart",
            [&LOFT_ALONE[..], &along, &limit].concat(),
            " at attack angle −3°, all else as set up, with descent angle ≥ 38° ",
        ),
        (
            "pareto",
            [&SPEED[..], &LOFT_ALONE, &goals, &limit].concat(),
            " at club speed 92 mph, attack angle −3°, all else as set up, with descent angle ≥ 38° ",
        ),
    ] {
        let (picture, _) = stated_plot(kind, &more);
        let texts = texts(&picture);
        assert!(texts.contains(subtitle), "{kind} {more:?}: {texts}");
    }
    // as set up in the preset, with a speed and a loft on the axes
    let setup = setup();
    let (_, _, figure) = optimum_with_map(&setup, [LOFT, "swing.speed=80mph..100mph"], &[]);
    assert_eq!(figure.subtitle, "all else as set up");
}

/// The best launch angles of the slow drive are above the map.
#[test]
fn a_caption_names_a_dashed_line_only_if_it_is_drawn() {
    let (picture, messages) = stated_plot("launch", &SPEED);
    assert!(!picture.contains("dasharray"), "{picture}");
    assert!(!messages.contains("Dashed"), "{messages}");
    let says = "sidespin of the drive as set up;";
    assert!(messages.contains(says), "{messages}");
    let map = Launches::around(&[(DriveRole::AsSetUp, &setup())]).unwrap();
    let note = launches_figure(&map, System::Us).note;
    assert!(note.starts_with("Dashed: the best launch angle"), "{note}");
}
