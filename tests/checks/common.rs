//! Independently computed drives, random drives, and comparison of numbers.

use longdrive::batch::{Batch, Block, Points, Run};
use longdrive::derivative::Taylor;
use longdrive::number::{Jet, Mixed};
use longdrive::parameters::Law;
use longdrive::{Drive, Outcome, Setup};
use num_dual::{Dual64, DualNum};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::Path;

/// A file of `tests/data`.
pub fn data(name: &str) -> Value {
    // `tests/elsewhere` reads the same files
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let path = folders
        .map(|folder| folder.join("tests/data").join(name))
        .find(|path| path.exists())
        .unwrap();
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Reads a setup from JSON: parameters by dotted name, `null` for an unset parameter, `"inf"` for a
/// flat face. Missing parameters have the values of `winfield-tan`.
pub fn setup(json: &Map<String, Value>) -> Setup<f64> {
    let mut setup = Setup::preset("winfield-tan").unwrap();
    setup.set_law(json["aero.law"].as_str().unwrap()).unwrap();
    for (name, value) in json.iter().filter(|(name, _)| *name != "aero.law") {
        let parameter = setup.parameter(name).unwrap();
        let value = match value {
            Value::Null => None,
            Value::String(text) => Some(text.parse().unwrap()),
            number => number.as_f64(),
        };
        setup.set_value(parameter, value).unwrap();
    }
    setup.validate().unwrap();
    setup
}

/// The setup with these settings.
pub fn changed(from: &Setup<f64>, settings: &[(&str, &str)]) -> Setup<f64> {
    let mut setup = *from;
    setup.set_all(settings.iter().copied()).unwrap();
    setup.validate().unwrap();
    setup
}

/// All blocks of a batch at these points.
pub fn all_blocks(batch: &Batch, points: &mut dyn Points) -> Vec<Block> {
    let mut blocks = vec![];
    let keep = |block: Block| {
        blocks.push(block);
        Ok(())
    };
    let rows = batch.run(points, &Run::default(), |block| block, keep);
    let kept: u64 = blocks.iter().map(|block| block.rows() as u64).sum();
    assert_eq!(rows.unwrap(), kept);
    blocks
}

/// A number with seeds for two derivatives: its derivative by the first variable is 1 if `first` is
/// true, and by the second variable if `second` is true.
pub fn mixed(value: f64, first: bool, second: bool) -> Mixed {
    let change = |is: bool| f64::from(u8::from(is));
    let inner = Jet {
        re: value,
        gradient: [change(first)],
    };
    Jet {
        re: inner,
        gradient: [Jet {
            re: change(second),
            gradient: [0.0],
        }],
    }
}

pub fn setup_of(drive: &Value) -> Setup<f64> {
    setup(drive["setup"].as_object().unwrap())
}

pub fn drives(file: &str) -> Vec<Value> {
    data(file)["drives"].as_array().unwrap().clone()
}

/// A number of a JSON file or answer.
pub fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

/// An outcome of an independently computed drive, over any number type. `printed` returns an
/// outcome or a parameter of the file by its name; other outcomes follow from these. In the files
/// the ball embeds where it lands, so total equals carry.
fn outcome_from<T: DualNum<Primitive = f64> + Copy>(of: Outcome, printed: impl Fn(&str) -> T) -> T {
    match of {
        Outcome::CarryDistance => {
            let [z, y] = ["carry", "lateral"].map(printed);
            (z * z + y * y).sqrt()
        }
        Outcome::Total => printed("carry"),
        Outcome::Run => T::zero(),
        Outcome::LateralTotal => printed("lateral"),
        of => printed(of.name()),
    }
}

fn printed(drive: &Value, name: &str) -> f64 {
    let outcome = drive["outcomes"].get(name);
    number(outcome.unwrap_or(&drive["setup"][name]))
}

pub fn outcome_of(drive: &Value, of: Outcome) -> f64 {
    outcome_from(of, |name| printed(drive, name))
}

/// The gradient of an outcome of a JSON drive: derivatives by the names of the parameters.
pub fn gradient_of(drive: &Value, of: Outcome) -> BTreeMap<String, f64> {
    let slope = |name: &str, by: &str| match drive["gradient"].get(name) {
        Some(gradient) => number(&gradient[by]),
        None => f64::from(u8::from(name == by)),
    };
    let by = drive["gradient"]["carry"].as_object().unwrap().keys();
    by.map(|by| {
        let dual = |name: &str| Dual64::new(printed(drive, name), slope(name, by));
        (by.clone(), outcome_from(of, dual).eps)
    })
    .collect()
}

/// Asserts |ours − theirs| ≤ tolerance · scale.
#[track_caller]
pub fn close(ours: f64, theirs: f64, scale: f64, tolerance: f64, what: &str) {
    let error = (ours - theirs).abs();
    assert!(
        error <= tolerance * scale,
        "{what}: {ours:e} against {theirs:e}, off by {:e} of {scale:e}",
        error / scale
    );
}

/// Settings of a rigid collision, for tests whose expected numbers were computed with one.
pub const RIGID: [(&str, &str); 2] = [
    ("impact.gear_scale", "none"),
    ("impact.tangential_restitution", "-0.15"),
];

/// [`RIGID`] as settings of a command.
pub const SET_RIGID: [&str; 2] = [
    "--set=impact.gear_scale=none",
    "--set=impact.tangential_restitution=-0.15",
];

/// A drive of the PGA TOUR with a rigid impact, as settings of a command.
pub const SET_RIGID_TOUR: [&str; 4] = [
    SET_RIGID[0],
    SET_RIGID[1],
    "--set=club.loft=9.5deg",
    "--set=strike.high=3mm",
];

/// Large steps: the error of carry is about 1e-8 m, and a drive takes a tenth of the time.
pub const LARGE_STEPS: [(&str, &str); 2] = [("flight.method", "dp8"), ("flight.step", "400 ms")];

/// The setup with large steps, for tests of properties that hold with any step. The method
/// alternates between `rk4` and `dp8` with `place`, the place of the setup in a list.
pub fn in_large_steps((place, mut setup): (usize, Setup<f64>)) -> Setup<f64> {
    let (method, step) = if place % 2 == 1 {
        ("dp8", "400 ms")
    } else {
        ("rk4", "100 ms")
    };
    setup
        .set_all([("flight.method", method), ("flight.step", step)])
        .unwrap();
    setup
}

/// Random drives that land, in large steps. Panics if many do not land, because a check would then
/// cover little.
#[track_caller]
pub fn landing(cases: u32) -> Vec<Setup<f64>> {
    let lands = |setup: &Setup<f64>| Drive::new(setup).is_ok_and(|drive| drive.landed().is_ok());
    let landing: Vec<_> = random_setups(cases)
        .enumerate()
        .map(in_large_steps)
        .filter(lands)
        .collect();
    assert!(
        landing.len() >= cases as usize * 9 / 10,
        "{} of {cases} land; all of the first 60 did",
        landing.len()
    );
    landing
}

/// Random setups, `cases` of them, equal in every run.
pub fn random_setups(cases: u32) -> impl Iterator<Item = Setup<f64>> {
    let mut runner = TestRunner::deterministic();
    (0..cases).map(move |_| any_setup().new_tree(&mut runner).unwrap().current())
}

/// Three-dimensional drives from easy to hard: light and heavy heads, every law, off-centre strikes
/// on curved faces, products of inertia, closure, wind, with and without the optional parameters.
fn any_setup() -> impl Strategy<Value = Setup<f64>> {
    let swing = (
        20.0..70.0,
        -0.05..0.25,
        -0.1..0.1,
        -0.1..0.1,
        -0.1..0.1,
        prop::array::uniform3(-50.0..50.0),
    );
    let club = (
        0.05..2.0,
        0.02..0.6,
        prop::array::uniform3(1e-4..8e-4),
        prop::array::uniform3(-0.4..0.4),
        0.0..0.05,
    );
    let face = (
        -0.015..0.015,
        -0.03..0.03,
        0.2..0.5,
        0.2..0.5,
        prop::option::of(0.2..0.5),
    );
    let ball = (
        0.03..0.06,
        0.018..0.025,
        prop::option::of(0.3..0.5),
        0.3..1.0,
        -0.3..0.3,
    );
    let air = (
        0.2..1.5,
        0.0..0.8,
        prop::option::of(0.0..5e-5),
        prop::array::uniform3(-8.0..8.0),
        prop::option::of(0.003..0.03),
    );
    let law = 0..Law::NAMES.len();
    (swing, club, face, ball, air, law).prop_map(|(swing, club, face, ball, air, law)| {
        let mut s = Setup::modern_driver();
        s.set_law(Law::NAMES[law]).unwrap();
        (
            s.swing.speed,
            s.swing.attack_angle,
            s.swing.path,
            s.swing.face_angle,
            s.swing.shaft_lean,
            _,
        ) = swing;
        [s.swing.closure_x, s.swing.closure_y, s.swing.closure_z] = swing.5;
        (s.club.mass, s.club.loft, _, _, s.club.cg_depth) = club;
        [s.club.inertia_xx, s.club.inertia_yy, s.club.inertia_zz] = club.2;
        // |I_ij| < ½ √(I_ii I_jj), so that the tensor is positive definite
        let product = |part: f64, a: f64, b: f64| part * (a * b).sqrt();
        s.club.inertia_xy = product(club.3[0], s.club.inertia_xx, s.club.inertia_yy);
        s.club.inertia_xz = product(club.3[1], s.club.inertia_xx, s.club.inertia_zz);
        s.club.inertia_yz = product(club.3[2], s.club.inertia_yy, s.club.inertia_zz);
        (
            s.strike.high,
            s.strike.toe,
            s.club.bulge_radius,
            s.club.roll_radius,
            s.club.face_semi_axis,
        ) = face;
        (
            s.ball.mass,
            s.ball.radius,
            _,
            s.impact.restitution,
            s.impact.tangential_restitution,
        ) = ball;
        // in half of the drives the collision is rigid
        s.impact.gear_scale = s.club.face_semi_axis.map(|_| 0.75);
        s.ball.inertia = ball
            .2
            .map(|part: f64| part * s.ball.mass * s.ball.radius * s.ball.radius);
        (
            s.air.density,
            s.aero.spin_decay,
            s.aero.spin_damping,
            _,
            s.wind.roughness,
        ) = air;
        [s.wind.up, s.wind.right, s.wind.downrange] = air.3;
        s.wind.up *= 0.1;
        // in half of the drives the shaft bends and droops, and the restitution decreases with the
        // speed
        if s.club.face_semi_axis.is_some() {
            (s.swing.shaft_bend, s.swing.shaft_droop) =
                (Some(0.5 * s.swing.shaft_lean), Some(s.swing.path));
            s.swing.shaft_growth = s.ball.inertia.map(|_| 1.5);
            s.impact.restitution_slope = Some(-5e-4 * (1.0 - s.impact.restitution));
        }
        s.validate().unwrap();
        s
    })
}

pub fn panic_of<T>(work: impl FnOnce() -> T) -> String {
    caught(work).err().expect("it panics")
}

/// The result of `work`, or the message with which it panics.
pub fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).map_err(|panic| {
        let word = panic.downcast_ref::<&str>().map(ToString::to_string);
        word.or_else(|| panic.downcast_ref::<String>().cloned())
            .unwrap_or_default()
    })
}

/// Largest differences of value, gradient and Hessian between two neighbouring drives, relative to
/// the largest component of `a`.
pub fn jump(a: &Taylor, b: &Taylor) -> [f64; 3] {
    let jump = |a: &[f64], b: &[f64]| {
        let most = a
            .iter()
            .zip(b)
            .fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        most / a.iter().fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    [
        jump(&[a.value], &[b.value]),
        jump(&a.gradient, &b.gradient),
        jump(&a.hessian.concat(), &b.hessian.concat()),
    ]
}
