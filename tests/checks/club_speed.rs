//! The point of the head whose motion speed, attack angle and path describe: the centre of mass of
//! the head, or the centre of its face.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use longdrive::derivative::gradient;
use longdrive::parameters::{SetupFile, SpeedOf};
use longdrive::study::Comparison;
use longdrive::{Drive, Outcome, Setup};

type Vector = [f64; 3];

fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn sum(parts: &[(f64, Vector)]) -> Vector {
    std::array::from_fn(|i| {
        parts
            .iter()
            .map(|(weight, vector)| weight * vector[i])
            .sum()
    })
}

/// A head that rotates about all axes and has a movable weight. The centre of mass is not straight
/// behind the centre of the face.
fn turning() -> Setup<f64> {
    let mut setup = Setup::preset("tour-average").unwrap();
    let given = [
        ("swing.speed", "50 m/s"),
        ("swing.attack_angle", "-2 deg"),
        ("swing.path", "3 deg"),
        ("swing.face_angle", "1.5 deg"),
        ("swing.shaft_lean", "2 deg"),
        ("swing.shaft_bend", "none"),
        ("swing.shaft_droop", "none"),
        ("swing.closure.x", "35 rad/s"),
        ("swing.closure.y", "-20 rad/s"),
        ("swing.closure.z", "12 rad/s"),
        ("club.cg_high", "-9 mm"),
        ("club.cg_toe", "4 mm"),
        ("club.weight_1.mass", "14 g"),
        ("club.weight_1.depth", "90 mm"),
        ("club.weight_1.toe", "25 mm"),
        ("club.weight_1.high", "-12 mm"),
    ];
    setup.set_all(given).unwrap();
    setup
}

/// The same swing, stated by the velocity of the centre of mass: v − ω × r, with the velocity v of
/// the face centre, and the vector r from the centre of mass to the face centre. The axes of the
/// head and r are computed without the library.
fn of_the_centre_of_mass(stated: &Setup<f64>) -> Setup<f64> {
    let (swing, club) = (&stated.swing, &stated.club);
    let (sin, cos) = (swing.attack_angle - swing.shaft_lean).sin_cos();
    let (sin_yaw, cos_yaw) = swing.face_angle.sin_cos();
    let up = [cos, -sin * sin_yaw, -sin * cos_yaw];
    let toe = [0.0, cos_yaw, -sin_yaw];
    let forward = [sin, cos * sin_yaw, cos * cos_yaw];
    let (sin, cos) = club.loft.sin_cos();
    let (up, forward) = (
        sum(&[(cos, up), (-sin, forward)]),
        sum(&[(cos, forward), (sin, up)]),
    );
    // positions relative to the centre of the face: up along the face, towards the toe, behind the
    // face
    let [own, weight] = [
        (
            club.mass,
            [
                club.cg_high.unwrap_or_default(),
                club.cg_toe.unwrap_or_default(),
                club.cg_depth,
            ],
        ),
        (
            club.weight_1_mass.unwrap_or_default(),
            [club.weight_1_high, club.weight_1_toe, club.weight_1_depth]
                .map(Option::unwrap_or_default),
        ),
    ];
    let [high, across, depth]: Vector =
        std::array::from_fn(|i| (own.0 * own.1[i] + weight.0 * weight.1[i]) / (own.0 + weight.0));
    let centre = sum(&[(-high, up), (-across, toe), (depth, forward)]);
    let (sin, cos) = swing.attack_angle.sin_cos();
    let velocity =
        [sin, cos * swing.path.sin(), cos * swing.path.cos()].map(|part| part * swing.speed);
    let turn = cross([swing.closure_x, swing.closure_y, swing.closure_z], centre);
    let [x, y, z] = sum(&[(1.0, velocity), (-1.0, turn)]);
    let mut other = Setup {
        speed_of: SpeedOf::CentreOfMass,
        ..*stated
    };
    other.swing.speed = (x * x + y * y + z * z).sqrt();
    other.swing.attack_angle = (x / other.swing.speed).asin();
    other.swing.path = y.atan2(z);
    // keep the pitch of the head, attack angle − shaft lean
    other.swing.shaft_lean += other.swing.attack_angle - swing.attack_angle;
    other
}

#[test]
fn exact_face_centre_moves_as_a_point_of_a_rigid_head() {
    let stated = Setup {
        speed_of: SpeedOf::FaceCentre,
        ..turning()
    };
    let other = of_the_centre_of_mass(&stated);
    assert!(
        (other.swing.path - stated.swing.path).abs().to_degrees() > 1.0,
        "the two points have nearly one path: the case tests nothing"
    );
    let [stated_drive, other_drive] = [stated, other].map(|setup| Drive::new(&setup).unwrap());
    for of in Outcome::OF_DRIVES {
        let (Some(found), Some(expected)) = (of.value(&stated_drive), of.value(&other_drive))
        else {
            continue;
        };
        // the smash factor divides by the stated speed
        let expected = if *of == Outcome::SmashFactor {
            expected * other.swing.speed / stated.swing.speed
        } else {
            expected
        };
        close(found, expected, expected.abs().max(1e-3), 1e-11, of.name());
    }
}

/// The head has no loft and closes at the rate ω; its centre of mass is at the distance d behind
/// the face centre. The velocity of the centre of mass has a component ω d from in to out, which
/// the face centre does not have.
#[test]
fn exact_path_of_the_centre_of_mass_of_a_head_that_closes() {
    let mut setup = Setup::preset("modern-driver").unwrap();
    let given = [
        ("swing.attack_angle", "0 deg"),
        ("swing.shaft_lean", "0 deg"),
        ("club.loft", "0 deg"),
        ("swing.closure.x", "40 rad/s"),
    ];
    setup.set_all(given).unwrap();
    let (speed, across) = (setup.swing.speed, 40.0 * setup.club.cg_depth);
    let mut same = setup;
    (same.swing.speed, same.swing.path) = (speed.hypot(across), (across / speed).atan());
    let launches = [
        Setup {
            speed_of: SpeedOf::FaceCentre,
            ..setup
        },
        same,
    ]
    .map(|setup| {
        let launch = longdrive::impact::strike(&setup).unwrap().launch;
        [launch.velocity, launch.spin].map(longdrive::number::Vector::to_array)
    });
    for (found, expected) in launches[0]
        .as_flattened()
        .iter()
        .zip(launches[1].as_flattened())
    {
        close(*found, *expected, 70.0, 1e-13, "launch");
    }
    // TrackMan states that the paths of the two points of a driver differ by about 3°. A closure of
    // 65 rad/s, 50 m/s and a depth of 40 mm give this difference
    assert!((65.0_f64 * 0.040 / 50.0).atan().to_degrees() > 2.9);
}

#[test]
fn exact_both_points_coincide_if_the_head_does_not_turn() {
    let mut setup = turning();
    (
        setup.swing.closure_x,
        setup.swing.closure_y,
        setup.swing.closure_z,
    ) = (0.0, 0.0, 0.0);
    let carries = SpeedOf::ALL.map(|speed_of| {
        Drive::new(&Setup { speed_of, ..setup })
            .unwrap()
            .landed()
            .unwrap()
            .carry
    });
    assert_eq!(carries[0].to_bits(), carries[1].to_bits());
}

/// Derivatives by loft, depth, closure and weight, which determine the vector between the two
/// points.
#[test]
fn differences_confirm_derivatives_by_the_position_of_the_face_centre() {
    let setup = Setup {
        speed_of: SpeedOf::FaceCentre,
        ..turning()
    };
    for (name, h) in [
        ("club.loft", 1e-4),
        ("club.cg_depth", 1e-5),
        ("club.cg_toe", 1e-5),
        ("club.cg_high", 1e-5),
        ("club.weight_1.mass", 1e-5),
        ("club.weight_1.depth", 1e-5),
        ("swing.closure.x", 1e-2),
        ("swing.closure.y", 1e-2),
        ("swing.closure.z", 1e-2),
        ("swing.path", 1e-4),
        ("swing.speed", 1e-3),
    ] {
        let parameter = setup.variable(name).unwrap();
        for of in [Outcome::Carry, Outcome::Lateral, Outcome::SpinAxis] {
            let exact = gradient(&setup, of, &[parameter]).unwrap().gradient[0];
            let at = |by: f64| {
                let mut moved = setup;
                moved
                    .set_value(parameter, Some(setup.value(parameter).unwrap() + by))
                    .unwrap();
                of.of(&Drive::new(&moved).unwrap()).unwrap()
            };
            // a central difference of fourth order
            let slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
            close(
                exact,
                slope,
                slope.abs().max(1e-3),
                2e-6,
                &format!("{} by {name}", of.name()),
            );
        }
    }
}

#[test]
fn the_point_is_read_written_and_compared() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("camera.toml").display().to_string();
    let text = "preset = 'tour-average'\n[swing]\nspeed_of = 'face-centre'\nclosure = \
                { x = '40 rad/s' }\n";
    std::fs::write(&file, text).unwrap();
    let (_, own) = json(&["simulate", &file]);
    let set = [
        "--set",
        "swing.closure.x=40rad/s",
        "--set",
        "swing.speed_of=face-centre",
    ];
    let (_, same) = json(&[&["simulate", "tour-average"][..], &set].concat());
    let (_, other) = json(&[&["simulate", "tour-average"][..], &set[..2]].concat());
    assert_eq!(
        (&own["flight"], &own["setup"]["swing.speed_of"]),
        (&same["flight"], &"face-centre".into())
    );
    assert_eq!(other["setup"]["swing.speed_of"], "centre-of-mass");
    let lateral = [&own, &other].map(|answer| number(&answer["flight"]["lateral"]));
    assert!((lateral[0] - lateral[1]).abs() > 0.1, "{lateral:?}");
    let best = folder.path().join("best.toml").display().to_string();
    assert_eq!(longdrive(&["optimize", &file, "-o", &best]).status, 0);
    assert_eq!(
        SetupFile::open(best.as_ref()).unwrap().setup.speed_of,
        SpeedOf::FaceCentre
    );

    for (args, output) in [
        (
            &["simulate", "--set", "swing.speed_of=face-center"][..],
            "did you mean 'face-centre'",
        ),
        (
            &["optimize", "--vary", "swing.speed_of=0..1"],
            "it is a choice",
        ),
        (
            &[
                "simulate",
                "tour-average",
                "--set",
                "swing.sped_of=face-centre",
            ],
            "did you mean 'swing.speed_of'",
        ),
        (
            &[
                "simulate",
                "--launch",
                "ball_speed=150mph,launch_angle=12deg,backspin=2500rpm",
                "--set",
                "swing.speed_of=face-centre",
            ],
            "strike and impact are not used",
        ),
    ] {
        let message = longdrive(args);
        let words = on_one_line(&message.err);
        assert!(
            message.status == 2 && words.contains(output),
            "{args:?}: {words}"
        );
    }
    let setup = SetupFile::open(file.as_ref()).unwrap().setup;
    let there = Comparison::new(
        &setup,
        &Setup {
            speed_of: SpeedOf::CentreOfMass,
            ..setup
        },
    )
    .unwrap();
    let shares = there.of(Outcome::Lateral).unwrap().by_parameter.shares;
    assert!(
        shares.len() == 1 && shares[0].cause.name() == "swing.speed_of",
        "{shares:?}"
    );
    close(
        shares[0].amount,
        lateral[1] - lateral[0],
        1.0,
        1e-5,
        "share",
    );
}
