//! Maps of strikes over the face, of one design and of two.

use crate::command_line::{longdrive, on_one_line};
use crate::common::close;
use crate::drawn::outcome_at;
use longdrive::impact::FacePoint;
use longdrive::parameters::Golfer;
use longdrive::report::figures::{face_figure, strikes_figure};
use longdrive::report::plot::{Field, Figure, Shape, figure_csv};
use longdrive::study::Face;
use longdrive::units::{System, TableUnits};
use longdrive::{Outcome, Setup};

/// Each node of a map of strikes is the outcome of a drive. The maps of one outcome for two designs
/// have the same contour levels. The data file names the design of each map.
#[test]
fn same_drives_in_maps_of_strikes_and_alone_for_both_hands() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([("strike.toe", "-6 mm"), ("swing.path", "1 deg")])
        .unwrap();
    let mut flat = Setup {
        golfer: Golfer::Left,
        ..setup
    };
    flat.set("club.bulge_radius", "600 mm").unwrap();
    let faces = [&setup, &flat].map(|setup| Face::of(setup).unwrap());
    let figure =
        strikes_figure(&[("as set up", &faces[0]), ("flat", &faces[1])], System::Us).unwrap();
    let views: Vec<_> = std::iter::once(&figure).chain(&figure.panels).collect();
    assert_eq!((views.len(), figure.columns), (8, 2));
    let field = |view: &Figure| match &view.layers[0].shape {
        Shape::Contours(field) => (**field).clone(),
        other => panic!("{other:?}"),
    };
    for (i, of) in Face::OUTCOMES.into_iter().enumerate() {
        let pair = [field(views[2 * i]), field(views[2 * i + 1])];
        assert_eq!(pair[0].common_values, pair[1].common_values);
        for (field, setup, side) in [(&pair[0], &setup, -1.0), (&pair[1], &flat, 1.0)] {
            for node in (3..field.values.len()).step_by(53) {
                let at =
                    field.coordinates((node % field.columns) as f64, (node / field.columns) as f64);
                let drive = outcome_at(
                    setup,
                    &[("strike.toe", side * at[0]), ("strike.high", at[1])],
                    of,
                );
                close(
                    field.values[node].unwrap(),
                    drive,
                    drive.abs().max(1.0),
                    1e-8,
                    of.name(),
                );
            }
        }
    }
    // gear effect: a strike towards the toe tilts the spin axis to the left for a right-hander, and
    // to the right for a left-hander
    let slopes = faces.each_ref().map(|face| face.by_toe.unwrap()[3]);
    assert!(slopes[0] < 0.0 && slopes[1] > 0.0, "{slopes:?}");
    let by_difference = [1e-4, -1e-4].map(|toe| {
        outcome_at(
            &setup,
            &[("strike.toe", toe), ("strike.high", 0.0)],
            Outcome::Lateral,
        )
    });
    close(
        faces[0].by_toe.unwrap()[1],
        (by_difference[0] - by_difference[1]) / 2e-4,
        100.0,
        1e-4,
        "slope of the landing",
    );
    let data = figure_csv(&figure, TableUnits::Si).unwrap();
    let head = data.lines().next().unwrap();
    assert!(
        head.ends_with(",carry [m],lateral [m],ball speed [m/s],spin axis [rad]"),
        "{head}"
    );
    for row in [
        "field,\"carry, as set up\"",
        "field,\"spin axis, flat\"",
        "mark,\"strike, flat\"",
    ] {
        assert!(data.lines().any(|line| line.starts_with(row)), "{row}");
    }
}

/// A contour is smooth, although the nodes are 5 mm apart. Its direction changes by at most 1 mm/r
/// over 1 mm, where r is its smallest radius of curvature.
#[test]
fn contours_over_the_face_have_no_corners() {
    let setup = Setup::preset("modern-driver").unwrap();
    let face = Face::of(&setup).unwrap();
    let figure = strikes_figure(&[("", &face)], System::Us).unwrap();
    // not the fourth view, the spin axis: its contours cross at a saddle point
    let views = std::iter::once(&figure).chain(&figure.panels).take(3);
    let (mut contours, mut sharpest_on_nodes) = (0, 0.0_f64);
    for view in views {
        let Shape::Contours(field) = &view.layers[0].shape else {
            panic!("{:?}", view.layers[0]);
        };
        let known: Vec<f64> = field.values.iter().flatten().copied().collect();
        let [low, high] =
            [f64::min, f64::max].map(|end| known.iter().copied().reduce(end).unwrap());
        for part in [0.2, 0.35, 0.5, 0.65, 0.8, 0.9] {
            let level = low + part * (high - low);
            let sharpest = sharpest(&field.line_at(level));
            assert!(sharpest < 15.0, "{} {part}: {sharpest}°", view.name);
            contours += 1;
            let on_nodes = Field {
                gradients: vec![],
                ..(**field).clone()
            };
            sharpest_on_nodes = sharpest_on_nodes.max(self::sharpest(&on_nodes.line_at(level)));
        }
    }
    assert_eq!(contours, 18);
    // straight pieces between the nodes would form corners
    assert!(sharpest_on_nodes > 20.0, "{sharpest_on_nodes}");
}

/// The largest change of direction of a contour within 1 mm, degrees.
fn sharpest(line: &[[f64; 2]]) -> f64 {
    let pieces = line.split(|[x, _]| x.is_nan());
    let turns = pieces.flat_map(|piece| turns(&in_steps(piece, 1e-3)));
    turns.fold(0.0, f64::max)
}

/// Points of a line that are at least `step` apart, m.
fn in_steps(line: &[[f64; 2]], step: f64) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = vec![];
    for at in line {
        let is_far = |last: &[f64; 2]| (at[0] - last[0]).hypot(at[1] - last[1]) >= step;
        if points.last().is_none_or(is_far) {
            points.push(*at);
        }
    }
    points
}

/// The changes of direction at the points of a line, degrees.
fn turns(points: &[[f64; 2]]) -> Vec<f64> {
    let directions: Vec<f64> = points
        .windows(2)
        .map(|ends| (ends[1][1] - ends[0][1]).atan2(ends[1][0] - ends[0][0]))
        .collect();
    let turn = |pair: &[f64]| {
        let turn = (pair[1] - pair[0]).to_degrees().abs();
        turn.min(360.0 - turn)
    };
    directions.windows(2).map(turn).collect()
}

/// If the centre of mass is not behind the centre of the face, strikes are measured from the face
/// centre, and the sweet spot is another point.
#[test]
fn exact_sweet_spot_normal_passes_through_the_centre_of_mass() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([
            ("club.cg_toe", "5 mm"),
            ("club.cg_high", "4 mm"),
            ("club.bulge_radius", "200 mm"),
        ])
        .unwrap();
    setup
        .set_all([("strike.toe", "0 mm"), ("strike.high", "0 mm")])
        .unwrap();
    let face = Face::of(&setup).unwrap();
    let [toe, high] = face.sweet_spot.unwrap();
    let mut there = setup;
    (there.strike.toe, there.strike.high) = (toe, high);
    let point = FacePoint::new(&there.club, &there.strike).unwrap();
    assert!(
        point.position.cross(point.normal).norm() < 1e-13,
        "{point:?}"
    );
    // the sweet spot is farther from the face centre than the centre of mass is, because the face
    // is curved
    assert!(
        toe > 5.5e-3 && toe < 8e-3 && high > 4.2e-3 && high < 6e-3,
        "{toe} {high}"
    );
    let slope =
        [1e-4, -1e-4].map(|off| outcome_at(&there, &[("strike.toe", toe + off)], Outcome::Lateral));
    close(
        face.by_toe.unwrap()[1],
        (slope[0] - slope[1]) / 2e-4,
        100.0,
        1e-4,
        "slope of the landing",
    );
    for figure in [
        face_figure(&face, System::Us),
        strikes_figure(&[("", &face)], System::Us).unwrap(),
    ] {
        let data = figure_csv(&figure, TableUnits::Si).unwrap();
        let marks: Vec<&str> = data
            .lines()
            .filter(|line| line.contains("sweet spot"))
            .collect();
        assert!(
            marks
                .iter()
                .any(|line| line.contains(&format!("{:?}", -toe))),
            "{marks:?}"
        );
        let labels = [&figure.x, &figure.y].map(|axis| axis.quantity.label.clone());
        assert!(
            labels
                .iter()
                .all(|label| label.contains("the centre of the face")),
            "{labels:?}"
        );
    }
    assert!(
        face_figure(&face, System::Us)
            .note
            .contains("The strike is at the centre of the face")
    );
    // a movable weight moves the sweet spot; without weights and offsets the sweet spot is the
    // origin of strikes
    let mut weighted = Setup::preset("tour-average").unwrap();
    assert_eq!(Face::of(&weighted).unwrap().sweet_spot, Some([0.0; 2]));
    weighted
        .set_all([
            ("club.weight_1.mass", "10 g"),
            ("club.weight_1.toe", "30 mm"),
        ])
        .unwrap();
    let face = Face::of(&weighted).unwrap();
    assert!(
        face.is_from_centre && face.sweet_spot.unwrap()[0] > 1e-3,
        "{face:?}"
    );
}

#[test]
fn two_designs_are_side_by_side_on_the_face() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let (after, data) = (at("after.toml"), at("a.csv"));
    std::fs::write(
        &after,
        "preset = 'tour-average'\n[club]\nbulge_radius = '400 mm'\n",
    )
    .unwrap();
    let output = longdrive(&[
        "plot",
        "strike",
        "tour-average",
        "--after",
        &after,
        "-o",
        &data,
    ]);
    assert_eq!(output.status, 0, "{}", output.err);
    let text = std::fs::read_to_string(&data).unwrap();
    assert!(
        text.contains("lateral, before")
            && text.contains("lateral, after")
            && output.err.contains("Effect of a strike 1 mm from"),
        "{}",
        output.err
    );
    let more = "differ in more than the club";
    assert!(!on_one_line(&output.err).contains(more), "{}", output.err);
    let faster = [
        "plot",
        "strike",
        "tour-average",
        "--after",
        &after,
        "-o",
        &at("c.csv"),
        "--set",
        "swing.speed=100mph",
    ];
    let output = longdrive(&faster);
    assert!(
        on_one_line(&output.err).contains(&format!("{more}: swing.speed;")),
        "{}",
        output.err
    );
    for (args, why) in [
        (
            vec!["--after", &after, "--set", "golfer=left"],
            "the toe is on opposite sides",
        ),
        (
            vec!["--after", &after, "--vary", "club.loft=8deg..12deg"],
            "no optimum is searched for",
        ),
        (vec!["--after", "no-such.toml"], "no-such.toml"),
    ] {
        let output = longdrive(&[&["plot", "strike", "-o", &at("b.svg")][..], &args].concat());
        assert!(
            output.status == 2 && on_one_line(&output.err).contains(why),
            "{}",
            output.err
        );
    }
    assert_eq!(
        longdrive(&[
            "plot",
            "strike",
            "--after",
            &after,
            "-o",
            &after,
            "--overwrite"
        ])
        .status,
        2
    );
}
