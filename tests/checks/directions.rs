//! Outcomes that are directions. 180° equals −180°: differences and means of directions do not
//! cross this jump.

use crate::command_line::{json, number};

/// A strike with backspin below 0, so that the spin axis is near 180°.
const TOPPED: [&str; 4] = [
    "--set",
    "club.loft=-2deg",
    "--set",
    "swing.attack_angle=12deg",
];
const LAUNCH: [&str; 2] = [
    "--launch",
    "ball_speed=160mph,launch_angle=10deg,backspin=-500rpm,sidespin=0rpm",
];

#[test]
fn derivatives_of_a_direction_are_verified_across_the_half_turn() {
    for requested in [
        [
            &["verify"],
            &TOPPED[..],
            &["--of", "spin_axis", "--wrt", "swing.path"],
        ]
        .concat(),
        [
            &["verify"],
            &LAUNCH[..],
            &["--of", "spin_axis", "--wrt", "launch.sidespin"],
        ]
        .concat(),
    ] {
        let (status, found) = json(&requested);
        assert_eq!(
            (status, found["passed"].as_bool()),
            (0, Some(true)),
            "{requested:?}: {found}"
        );
        assert!(number(&found["rows"][0]["exact"]).abs() > 1e-3, "{found}");
    }
}

#[test]
fn changes_of_a_direction_are_the_smaller_angle() {
    let requested = [
        "--of",
        "spin_axis",
        "--sigma",
        "launch.sidespin=100rpm",
        "--no-defaults",
    ];
    let (status, found) = json(&[&["sensitivity"], &LAUNCH[..], &requested].concat());
    let effect = &found["outcomes"][0]["effects"][0];
    let [below, above] = [0, 1].map(|side| number(&effect["flown"][side]).to_degrees());
    assert_eq!(status, 0);
    // sidespin of ±100 rpm at a backspin of −500 rpm turns the spin axis by atan(100/500)
    let turned = 0.2_f64.atan().to_degrees();
    assert!(
        (below - turned).abs() < 1e-9 && (above + turned).abs() < 1e-9,
        "{below} {above}"
    );
}

#[test]
fn a_mean_of_a_direction_is_about_its_value_at_the_means() {
    let requested = [
        "--of",
        "spin_axis",
        "--sigma",
        "swing.path=0.5deg",
        "--samples",
        "400",
    ];
    let (status, found) =
        json(&[&["uncertainty", "modern-driver"], &TOPPED[..], &requested].concat());
    let outcome = &found["outcomes"][0];
    let sampled = |what: &str| number(&outcome["monte_carlo"][what]["value"]).to_degrees();
    let by_gradient = number(&outcome["delta"]["standard_uncertainty"]).to_degrees();
    assert_eq!(status, 0);
    let (mean, deviation) = (sampled("mean"), sampled("standard_uncertainty"));
    assert!((mean.abs() - 180.0).abs() < by_gradient, "{mean}");
    assert!(
        (0.7..1.4).contains(&(deviation / by_gradient)),
        "{deviation} {by_gradient}"
    );
}

#[test]
fn a_measured_direction_is_compared_by_the_smaller_angle() {
    let head = "club.loft [deg],swing.attack_angle [deg],swing.path [deg],spin_axis [deg],sigma \
                spin_axis [deg],\
                ball_speed [mph],sigma ball_speed [mph]";
    // the computed spin axis is −177.2°: 3.8° from 179°
    let (_folder, path) =
        crate::sweep::table("directions.csv", format!("{head}\n-2,12,0.1,179,1,160,1\n"));
    let (status, found) = json(&[
        "calibrate",
        path.to_str().unwrap(),
        "modern-driver",
        "--fit",
        "impact.restitution",
    ]);
    let off = number(&found["residuals"][0]["residual"]);
    assert!(status == 0 && (off - 3.84).abs() < 0.01, "{status} {found}");
}
