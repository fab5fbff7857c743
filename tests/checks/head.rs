//! The head with its movable weights, and its outcomes.

use crate::command_line::{json, longdrive, number};
use crate::common::{changed, close};
use longdrive::derivative::{gradient, hessian};
use longdrive::impact::Head;
use longdrive::study::certificate::certify;
use longdrive::{Drive, Error, Outcome, Setup};
use nalgebra::Matrix3;

const WEIGHT: [(&str, &str); 4] = [
    ("club.weight_1.mass", "14 g"),
    ("club.weight_1.depth", "95 mm"),
    ("club.weight_1.toe", "-30 mm"),
    ("club.weight_1.high", "-18 mm"),
];

/// Expected: a body and one weight as two masses about their common centre of mass, I + μ (s·s 1 −
/// s sᵀ), with the vector s between them and the reduced mass μ.
#[test]
fn exact_head_with_a_weight_is_that_of_two_masses() {
    let setup = changed(&Setup::modern_driver(), &WEIGHT);
    let head = Head::new(&setup.club);
    let (body, weight) = (0.204, 0.014);
    close(head.mass, body + weight, 0.2, 1e-15, "mass");
    let share = weight / (body + weight);
    close(
        head.depth,
        0.0408 + share * (0.095 - 0.0408),
        0.04,
        1e-15,
        "depth",
    );
    let [high, toe] = head.cg_offset.unwrap();
    close(high, -share * 0.018, 0.01, 1e-15, "high");
    close(toe, -share * 0.030, 0.01, 1e-15, "toe");
    // components in the head frame, which is pitched up by the loft
    let (sin, cos) = setup.club.loft.sin_cos();
    let (x, y, z) = (-0.018, -0.030, -(0.095 - 0.0408));
    let s = nalgebra::Vector3::new(x * cos + z * sin, y, z * cos - x * sin);
    let added =
        (Matrix3::identity() * s.dot(&s) - s * s.transpose()) * (body * weight / (body + weight));
    let expected = Matrix3::from(setup.club.inertia()) + added;
    for (i, row) in head.inertia.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            close(*entry, expected[(i, j)], 5e-4, 1e-14, "inertia");
        }
    }
}

#[test]
fn exact_a_weight_at_the_centre_of_mass_changes_the_mass_alone() {
    let at = [
        ("club.weight_1.mass", "10 g"),
        ("club.weight_1.depth", "40.8 mm"),
    ];
    let (setup, heavier) = (
        changed(&Setup::modern_driver(), &at),
        changed(&Setup::modern_driver(), &[("club.mass", "214 g")]),
    );
    let (head, other) = (Head::new(&setup.club), Head::new(&heavier.club));
    assert_eq!(
        (head.mass, head.depth, head.inertia),
        (other.mass, other.depth, other.inertia)
    );
    let carry = |setup: &Setup<f64>| Outcome::Carry.of(&Drive::new(setup).unwrap()).unwrap();
    assert_eq!(carry(&setup), carry(&heavier));
}

#[test]
fn exact_two_halves_of_a_weight_are_one() {
    let one = changed(&Setup::modern_driver(), &WEIGHT);
    let mut two = one;
    for (name, text) in WEIGHT {
        let text = if name.ends_with("mass") { "7 g" } else { text };
        two.set(name, text).unwrap();
        two.set(&name.replace("weight_1", "weight_2"), text)
            .unwrap();
    }
    for of in [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::HeadMoi,
        Outcome::HeadMass,
        Outcome::HeadMinor3,
    ] {
        let [a, b] = [&one, &two].map(|setup| of.of(&Drive::new(setup).unwrap()).unwrap());
        close(a, b, a.abs(), 1e-12, of.name());
    }
}

/// On a flat face, a higher centre of mass has the effect of a lower strike.
#[test]
fn exact_a_centre_of_mass_beside_the_centre_of_a_flat_face() {
    let flat = [("club.bulge_radius", "inf"), ("club.roll_radius", "inf")];
    let set =
        |settings: &[(&str, &str)]| changed(&Setup::modern_driver(), &[&flat, settings].concat());
    let beside = set(&[
        ("club.cg_high", "-4 mm"),
        ("club.cg_toe", "3 mm"),
        ("strike.high", "1 mm"),
    ]);
    let struck = set(&[("strike.high", "5 mm"), ("strike.toe", "-3 mm")]);
    for of in [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::Backspin,
        Outcome::Sidespin,
    ] {
        let [a, b] = [&beside, &struck].map(|setup| of.of(&Drive::new(setup).unwrap()).unwrap());
        close(a, b, 300.0, 1e-13, of.name());
    }
}

/// Compares derivatives with differences: outcomes of impact, flight and head, by the positions and
/// masses of the weights, and by the centre of mass.
#[test]
fn differences_certify_derivatives_by_weights_and_centre_of_mass() {
    let other = [
        ("club.weight_2.mass", "6 g"),
        ("club.weight_2.depth", "20 mm"),
        ("club.weight_2.toe", "45 mm"),
        ("club.weight_2.high", "5 mm"),
        ("club.cg_high", "-3 mm"),
        ("club.cg_toe", "2 mm"),
        ("strike.toe", "8 mm"),
        ("strike.high", "-4 mm"),
    ];
    let setup = changed(&Setup::modern_driver(), &[&WEIGHT[..], &other].concat());
    let of = [
        &[Outcome::Carry, Outcome::Lateral, Outcome::Spin],
        Outcome::OF_HEAD,
    ]
    .concat();
    let wrt: Vec<_> = setup
        .variables()
        .into_iter()
        .filter(|row| row.name.starts_with("club."))
        .collect();
    assert!(wrt.len() > 18, "{}", wrt.len());
    let certificate = certify(&setup, &of, &wrt, &|_, _| true).unwrap();
    assert!(certificate.passed(), "{:?}", certificate.failures());
    // derivatives by all parameters and by one at a time take two paths of the chain rule
    let one_by_one = |of: Outcome| {
        wrt.iter()
            .map(|row| gradient(&setup, of, &[row]).unwrap().gradient[0])
            .collect::<Vec<_>>()
    };
    for of in of {
        let whole = hessian(&setup, of, &wrt).unwrap().gradient;
        let size = whole.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
        for (a, b) in whole.iter().zip(one_by_one(of)) {
            close(*a, b, size, 1e-11, of.name());
        }
    }
}

/// The signs of the minors of the second moments follow from the eigenvalues of the second moments.
#[test]
fn exact_minors_of_the_second_moments() {
    for (xz, is_body) in [
        ("-733 g cm^2", true),
        ("-1000 g cm^2", true),
        ("-3300 g cm^2", false),
    ] {
        let setup = changed(
            &Setup::modern_driver(),
            &[
                ("club.inertia.xz", xz),
                ("club.inertia.xy", "300 g cm^2"),
                ("club.inertia.yz", "-200 g cm^2"),
            ],
        );
        let drive = Drive::new(&setup).unwrap();
        let minor = |of: Outcome| of.of(&drive).unwrap();
        let inertia = Matrix3::from(setup.club.inertia());
        let s = Matrix3::identity() * (0.5 * inertia.trace()) - inertia;
        let trace = s.trace();
        close(minor(Outcome::HeadMinor1), s[(0, 0)], trace, 1e-14, "first");
        close(
            minor(Outcome::HeadMinor2),
            s.fixed_view::<2, 2>(0, 0).determinant() / trace,
            trace,
            1e-14,
            "second",
        );
        close(
            minor(Outcome::HeadMinor3),
            s.determinant() / trace.powi(2),
            trace,
            1e-14,
            "third",
        );
        let minors = [
            Outcome::HeadMinor1,
            Outcome::HeadMinor2,
            Outcome::HeadMinor3,
        ]
        .map(minor);
        assert_eq!(
            minors.iter().all(|minor| *minor >= 0.0),
            is_body,
            "{xz}: {minors:?}"
        );
        assert_eq!(s.symmetric_eigenvalues().min() >= 0.0, is_body);
    }
}

#[test]
fn outcomes_of_the_head_are_available_by_name() {
    let found = json(&[
        "gradient",
        "--of",
        "head_moi,carry",
        "--wrt",
        "club.inertia.xx,club.mass",
    ])
    .1;
    let head = &found["outcomes"][0];
    assert!((number(&head["value"]) - 5679e-7).abs() < 1e-18, "{found}");
    assert_eq!(number(&head["gradient"]["club.inertia.xx"]), 1.0);
    let limited = [
        "optimize",
        "--distribution",
        "swing.attack_angle=normal(0 deg, 2 deg)",
        "--vary",
        "club.inertia.xx=4000 g cm^2..5800 g cm^2",
        "--subject-to",
        "head_moi <= 5000 g cm^2",
        "--maximize",
        "mean(carry)",
    ];
    let (status, found) = json(&[&limited[..], &["--set", "strike.toe=10 mm"]].concat());
    assert_eq!(status, 0, "{found}");
    let limit = &found["constraints"][0];
    assert!(
        (number(&limit["value"]) - 5e-4).abs() < 1e-12 && number(&limit["multiplier"]) > 0.0,
        "{found}"
    );
    // without a club there is no head
    let launch = "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm";
    let given = longdrive(&[
        "gradient",
        "--launch",
        launch,
        "--of",
        "head_mass",
        "--wrt",
        "launch.ball_speed",
    ]);
    assert!(
        given.err.contains("no club strikes the ball"),
        "{}",
        given.err
    );
}

#[test]
fn a_weight_without_a_mass_is_reported() {
    let setup = changed(&Setup::modern_driver(), &[("club.weight_2.depth", "20 mm")]);
    let message = setup.warnings()[0].in_units(longdrive::units::System::default());
    assert!(
        message.contains("club.weight_2.depth changes nothing")
            && message.contains("set club.weight_2.mass"),
        "{message}"
    );
    assert!(
        changed(&Setup::modern_driver(), &WEIGHT)
            .warnings()
            .is_empty()
    );
    let mut heavy = Setup::modern_driver();
    assert!(matches!(
        heavy.set("club.weight_1.mass", "600 g"),
        Err(Error::OutOfRange { .. })
    ));
}
