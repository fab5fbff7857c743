//! Sweeps and functions with a tolerance: the lengths of every drive are compared with those of
//! flights in much shorter steps.

use crate::common::{RIGID, random_setups};
use crate::parallel::in_parallel;
use longdrive::batch::{Batch, Block, Points, Sequence, Status};
use longdrive::derivative::{Taylor, hessian};
use longdrive::integration::{StepChoice, accuracy};
use longdrive::parameters::{Law, Method, Parameter, Vary};
use longdrive::units::System;
use longdrive::{Error, Outcome, Setup};
use rayon::prelude::*;

const MICROMETRE: f64 = 1e-6;
const LENGTHS: [Outcome; 5] = [
    Outcome::Carry,
    Outcome::CarryDistance,
    Outcome::Lateral,
    Outcome::ApexHeight,
    Outcome::ApexDownrange,
];

/// Evaluates a batch at `count` points of a quasi-random sequence over ranges.
fn rows(batch: &Batch, ranges: &[Vary], count: u64) -> Block {
    let mut points = vec![];
    Sequence::new(ranges.to_vec(), count, 7)
        .unwrap()
        .read(count as usize, &mut points)
        .unwrap();
    batch.evaluate(0, points)
}

/// The errors of those rows of a sweep that land.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    landed: usize,
    /// Number of rows that the sweep flew again in shorter steps.
    again: usize,
    /// With the step that the sweep chose, before it checked its rows: number of rows with an error
    /// above a micrometre, and largest error, m.
    unchecked: (usize, f64),
    /// In the result of the sweep: number of rows with an error above a micrometre, and largest
    /// error, m.
    checked: (usize, f64),
}

impl Errors {
    fn add(&mut self, other: Self) {
        let both = |a: (usize, f64), b: (usize, f64)| (a.0 + b.0, a.1.max(b.1));
        *self = Self {
            landed: self.landed + other.landed,
            again: self.again + other.again,
            unchecked: both(self.unchecked, other.unchecked),
            checked: both(self.checked, other.checked),
        };
    }
}

/// The errors of a sweep with a tolerance of a micrometre; `None` if no drive lands or no step
/// meets the tolerance.
fn sweep(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], count: u64) -> Option<Errors> {
    let found = match accuracy(setup, ranges, of, MICROMETRE) {
        Ok(found) => found,
        Err(Error::NoFlight { .. } | Error::Tolerance { .. }) => return None,
        Err(error) => panic!("{error}"),
    };
    let parameters: Vec<&'static Parameter> = ranges.iter().map(|range| range.parameter).collect();
    let batch = Batch::new(&found.applied_to(setup), &parameters, of, &[]).unwrap();
    Some(errors(
        setup,
        batch,
        found.largest_defect,
        ranges,
        of,
        count,
    ))
}

fn errors(
    setup: &Setup<f64>,
    batch: Batch,
    defect: f64,
    ranges: &[Vary],
    of: &[Outcome],
    count: u64,
) -> Errors {
    let mut fine = Setup {
        method: Method::DormandPrince8,
        ..*setup
    };
    // the reference needs shorter steps in a wind that increases with height; steps of 5 ms would
    // change every length of the reference by less than 2e-8 m
    let step: f64 = if setup.wind.roughness.is_some() {
        0.02
    } else {
        0.04
    };
    fine.flight.step = step.min(0.25 * batch.setup().flight.step);
    let exact = rows(
        &Batch::new(&fine, batch.parameters(), of, &[]).unwrap(),
        ranges,
        count,
    );
    let unchecked = rows(&batch, ranges, count);
    let checked = rows(&batch.with_largest_defect(defect).unwrap(), ranges, count);
    let mut errors = Errors::default();
    for row in (0..exact.rows()).filter(|&row| exact.status(row) == Status::Landed) {
        let error = |flown: &Block| {
            let off = exact
                .outcomes(row)
                .zip(flown.outcomes(row))
                .map(|(exact, flown)| {
                    flown.map_or(f64::INFINITY, |flown| (flown - exact.unwrap()).abs())
                });
            let worst = off.fold(0.0, f64::max);
            (usize::from(worst > MICROMETRE), worst)
        };
        let again = usize::from(!unchecked.outcomes(row).eq(checked.outcomes(row)));
        errors.add(Errors {
            landed: 1,
            again,
            unchecked: error(&unchecked),
            checked: error(&checked),
        });
    }
    errors
}

fn range(setup: &Setup<f64>, name: &str, low: f64, high: f64) -> Vary {
    Vary::new(setup.variable(name).unwrap(), low, high).unwrap()
}

/// Sweeps around random setups, some of them in a wind that increases with height, over one to four
/// parameters. `LONGDRIVE_SWEEPS` sets the number of sweeps. docs/model.md (16a) has the printed
/// results.
#[test]
fn same_lengths_of_random_sweeps_in_shorter_steps_within_a_micrometre() {
    within_a_micrometre(&[0.2, 0.5], |setup, ranges| {
        sweep(setup, ranges, &LENGTHS, 100)
    });
}

/// Functions of random parameters, with the step that [`StepChoice`] chooses for the setup.
#[test]
fn same_lengths_of_random_functions_in_shorter_steps_within_a_micrometre() {
    within_a_micrometre(&[0.2, 0.5], |setup, ranges| {
        let parameters: Vec<_> = ranges.iter().map(|range| range.parameter).collect();
        let found = StepChoice::default().for_function(setup, &LENGTHS, &parameters);
        let found = found.unwrap();
        found.accuracy?;
        let batch = Batch::new(&found.setup, &parameters, &LENGTHS, &[]).unwrap();
        let defect = found.largest_defect;
        Some(errors(setup, batch, defect, ranges, &LENGTHS, 100))
    });
}

/// Ranges of one to four parameters around their values in a random setup. `part` is the half-width
/// of a range as a fraction of the value.
fn random_ranges(n: usize, setup: &Setup<f64>, part: f64) -> Vec<Vary> {
    let names = [
        "club.loft",
        "swing.attack_angle",
        "swing.speed",
        "air.density",
        "ball.mass",
        "wind.downrange",
        "gravity",
    ];
    // 28 sweeps begin at each name, with each number of parameters; the stride grows with every 28.
    // Each stride from 1 to 6 visits all seven names, because 7 is prime
    let by = (0..=n % 4).map(|i| names[(n / 4 + i * (1 + n / 28 % 6)) % 7]);
    by.map(|name| {
        let value = setup.value(setup.variable(name).unwrap()).unwrap();
        let width = match name {
            "swing.attack_angle" => 0.5 * part,
            "wind.downrange" => 20.0 * part,
            _ => value * part,
        };
        range(setup, name, value - width, value + width)
    })
    .collect()
}

/// Asserts that the errors of all drives are at most a micrometre. `errors` returns the errors of
/// drives with parameters in ranges around the values of a setup. `parts` are the half-widths of
/// these ranges, as fractions of the values.
fn within_a_micrometre(
    parts: &[f64; 2],
    errors: impl Fn(&Setup<f64>, &[Vary]) -> Option<Errors> + Sync,
) {
    let sweeps = std::env::var("LONGDRIVE_SWEEPS").map_or(28, |text| text.parse().unwrap());
    let setups: Vec<_> = random_setups(sweeps).collect();
    let look = |(n, setup): (usize, &Setup<f64>)| {
        let ranges = random_ranges(n, setup, parts[n / 4 % 2]);
        let found = errors(setup, &ranges)?;
        if found.checked.0 > 0 {
            let by: Vec<_> = ranges.iter().map(|range| range.parameter.name).collect();
            println!("case {n}, by {by:?}: {found:?}");
        }
        Some(found)
    };
    let found: Vec<Errors> = setups.par_iter().enumerate().filter_map(look).collect();
    let swept = found.len();
    let mut all = Errors::default();
    found.into_iter().for_each(|errors| all.add(errors));
    let Errors {
        landed,
        again,
        unchecked,
        checked,
    } = all;
    println!("{landed} drives of {swept} sweeps ({sweeps} asked for): {again} flown again");
    for (what, (off, largest)) in [
        ("by the step alone", unchecked),
        ("as the sweep gives them", checked),
    ] {
        println!(
            "{what}: {off} off by more than 1 um; the largest error is {:.3} um",
            largest / MICROMETRE
        );
    }
    assert!(
        10 * swept > 9 * setups.len() && landed > 80 * swept,
        "{landed} rows of {swept}"
    );
    assert_eq!(checked.0, 0, "{checked:?}");
}

/// A sweep chooses its step from a few drives, so that other rows may have larger errors: here up
/// to 266 times the tolerance, at the ends of the ranges and near drives without a flight. The
/// sweep flies these rows again.
#[test]
fn same_rows_in_shorter_steps_after_a_retry() {
    let mut low = Setup::modern_driver();
    low.set_all(RIGID).unwrap();
    let mut far = low;
    far.set_all([
        ("aero.law", "smits-smith"),
        ("ball.mass", "54.8 g"),
        ("club.cg_depth", "36.6 mm"),
    ])
    .unwrap();
    let far_ranges = [
        range(&far, "impact.restitution", 0.7, 0.93),
        range(&far, "swing.attack_angle", -0.1, 0.4),
        range(&far, "club.loft", 0.1, 0.5),
        range(&far, "gravity", 4.0, 10.0),
    ];
    let low_ranges = [
        range(&low, "club.loft", 0.02, 0.3),
        range(&low, "swing.attack_angle", -0.15, 0.1),
    ];
    for (setup, ranges) in [(&far, &far_ranges[..]), (&low, &low_ranges)] {
        let found = sweep(setup, ranges, &[Outcome::Carry, Outcome::Lateral], 1024).unwrap();
        assert!(found.checked.0 == 0 && found.landed > 500, "{found:?}");
    }
    // the step is chosen for a narrow range of lofts, but the rows have all lofts
    let found = accuracy(
        &low,
        &[range(&low, "club.loft", 0.17, 0.18)],
        &LENGTHS,
        MICROMETRE,
    )
    .unwrap();
    let parameters: Vec<&'static Parameter> =
        low_ranges.iter().map(|range| range.parameter).collect();
    let batch = Batch::new(&found.applied_to(&low), &parameters, &LENGTHS, &[]).unwrap();
    let found = errors(
        &low,
        batch,
        found.largest_defect,
        &low_ranges,
        &LENGTHS,
        1024,
    );
    assert!(
        found.checked.0 == 0 && found.again > 0 && found.unchecked.1 > 2.0 * MICROMETRE,
        "{found:?}"
    );
}

/// Some of these flights last half a second, take one step and descend at half a degree. The
/// interpolation within this last step has a larger error than the step. The error check of a row
/// therefore gives the defect of the last step a larger weight; without this weight, some of the
/// 4096 rows had an error of 5 µm.
#[test]
fn same_short_and_flat_flights_in_shorter_steps_after_a_retry() {
    let setup = Setup::modern_driver();
    let ranges = [
        range(&setup, "club.loft", 0.07, 0.35),
        range(&setup, "swing.attack_angle", -0.087, 0.087),
        range(&setup, "swing.speed", 30.0, 60.0),
    ];
    let found = sweep(&setup, &ranges, &[Outcome::Carry], 4096).unwrap();
    assert!(
        found.checked.0 == 0 && found.again > 0 && found.unchecked.1 > 2.0 * MICROMETRE,
        "{found:?}"
    );
}

/// Low shots with nearly straight paths at the apex, where lift carries most of the weight. There
/// an error of the velocity moves the apex up to a hundred times as far as usual.
#[test]
fn same_positions_of_flat_apexes_in_shorter_steps_within_a_micrometre() {
    let setup = Setup::modern_driver();
    let ranges = [
        range(&setup, "club.loft", 0.05, 0.35),
        range(&setup, "swing.attack_angle", -0.087, 0.087),
        range(&setup, "swing.speed", 27.0, 58.0),
    ];
    let found = sweep(
        &setup,
        &ranges,
        &[Outcome::Carry, Outcome::ApexDownrange],
        60_000,
    )
    .unwrap();
    assert!(
        found.landed > 58_000 && found.unchecked.0 > 0 && found.checked.0 == 0,
        "{found:?}"
    );
}

/// A light ball whose airspeed falls to 0.5 m/s at the apex, where the drag, proportional to |v| v,
/// is not smooth. Its row has an error of 8.6 µm in the step of the sweep. The error estimate of a
/// row (docs/model.md, eq. 16a) is too small there.
#[test]
fn same_row_that_nearly_stops_at_its_apex_in_shorter_steps_after_a_retry() {
    let setup = random_setups(158).last().unwrap();
    let around = |name: &str| {
        let value = setup.value(setup.variable(name).unwrap()).unwrap();
        range(&setup, name, 0.5 * value, 1.5 * value)
    };
    let found = sweep(
        &setup,
        &[around("ball.mass"), around("air.density")],
        &LENGTHS,
        100,
    )
    .unwrap();
    assert!(
        found.checked.0 == 0 && found.again > 0 && found.unchecked.1 > 8.0 * MICROMETRE,
        "{found:?}"
    );
}

/// A row whose error exceeds the tolerance in every step has no outcomes.
#[test]
fn a_row_beyond_the_tolerance_in_every_step_diverges() {
    let setup = Setup::modern_driver();
    let loft = setup.variable("club.loft").unwrap();
    let batch = Batch::new(&setup, &[loft], &[Outcome::Carry], &[]).unwrap();
    for (defect, status) in [
        (f64::MIN_POSITIVE, Status::Diverged),
        (f64::INFINITY, Status::Landed),
    ] {
        let block = batch
            .clone()
            .with_largest_defect(defect)
            .unwrap()
            .evaluate(0, vec![0.18]);
        assert_eq!(
            (block.status(0), block.outcome(0, 0).is_some()),
            (status, status == Status::Landed)
        );
    }
}

#[test]
fn a_drive_beyond_the_tolerance_in_every_step_is_an_error_of_its_integration() {
    let mut found = StepChoice::default()
        .for_setup(&Setup::modern_driver())
        .unwrap();
    found.largest_defect = f64::MIN_POSITIVE;
    let error = found.drive().unwrap_err();
    let message = error.to_string();
    assert_eq!(error.status(), "diverged");
    assert!(
        message.starts_with("the integration error of the flight is estimated as ")
            && message.contains("give a larger tolerance"),
        "{message}"
    );
    let in_yards = error.in_units(System::Us);
    assert!(
        in_yards.contains(" yd, more than ") && message.contains(" m, more than "),
        "{in_yards}"
    );
}

/// A largest defect of NaN would disable the check of the rows. Defects are above 0, so a largest
/// defect of 0 or less would refuse every row.
#[test]
fn an_impossible_largest_defect_is_refused() {
    let setup = Setup::modern_driver();
    let batch = Batch::new(
        &setup,
        &[setup.variable("club.loft").unwrap()],
        &[Outcome::Carry],
        &[],
    )
    .unwrap();
    for (defect, shown) in [(f64::NAN, "NaN m"), (0.0, "0 m"), (-1.0, "-1 m")] {
        let error = batch
            .clone()
            .with_largest_defect(defect)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains(shown) && error.contains("0 m < …"),
            "{error}"
        );
    }
}

/// Without ranges, `accuracy` checks one drive, and finds the step that it finds for a very narrow
/// range.
#[test]
fn one_drive_alone_is_checked_once() {
    let setup = Setup::preset("modern-driver").unwrap();
    let (parameter, low) = (setup.variable("club.loft").unwrap(), setup.club.loft);
    let looked_at = |ranges: &[Vary]| accuracy(&setup, ranges, &[Outcome::Carry], 1e-6).unwrap();
    let (alone, still) = (
        looked_at(&[]),
        looked_at(&[Vary {
            parameter,
            low,
            high: low,
        }]),
    );
    let narrow = looked_at(&[Vary {
        parameter,
        low,
        high: low * (1.0 + 1e-12),
    }]);
    assert_eq!((alone.drives, still.drives), (1, 1));
    assert!(
        narrow.drives > 60 && alone.step == narrow.step && still.step == narrow.step,
        "{alone:?}, {narrow:?}"
    );
}

/// If no step meets a tolerance, the message names a drive that misses it, and the error of this
/// drive.
#[test]
fn a_tolerance_out_of_reach_names_the_drive() {
    let setup = Setup::modern_driver();
    let error = accuracy(
        &setup,
        &[range(&setup, "club.loft", 0.1, 0.2)],
        &[Outcome::Carry],
        1e-16,
    )
    .unwrap_err();
    let words = error.to_string();
    assert!(
        words.contains("carry of the drive with club.loft = ") && words.contains(" is off by "),
        "{words}"
    );
}

/// A tolerance limits errors of lengths, not of derivatives. docs/limitations.md states the errors
/// of derivatives by loft, attack angle, speed and density, relative to the largest derivative. The
/// reference has much shorter steps.
#[test]
fn same_derivatives_in_shorter_steps_within_the_documented_error() {
    let sizes = [
        ("club.loft", 0.1),
        ("swing.attack_angle", 0.1),
        ("swing.speed", 10.0),
        ("air.density", 0.3),
    ];
    let drives = [[0.18, 0.0, 50.0], [0.14, 0.07, 55.0], [0.23, -0.05, 38.0]];
    let requested = Law::NAMES
        .iter()
        .flat_map(|law| drives.map(|drive| (*law, drive)))
        .collect::<Vec<_>>();
    in_parallel(&requested, |&(law, [loft, attack_angle, speed])| {
        let mut setup = Setup::modern_driver();
        setup.set_law(law).unwrap();
        (setup.club.loft, setup.swing.attack_angle, setup.swing.speed) =
            (loft, attack_angle, speed);
        let by = sizes.map(|(name, _)| setup.variable(name).unwrap());
        let within = accuracy(&setup, &[], &[Outcome::Carry], MICROMETRE)
            .unwrap()
            .applied_to(&setup);
        // the reference: its derivatives differ from those in steps of 1 ms by at most a thousandth
        // of the tolerance of this test
        let mut fine = setup;
        (fine.method, fine.flight.step) = (Method::Rk4, 4e-3);
        // each derivative is multiplied by the size of its parameter
        let sized = |Taylor {
                         gradient, hessian, ..
                     }: Taylor| {
            let row = |row: &[f64]| {
                row.iter()
                    .zip(sizes)
                    .map(|(d, (_, size))| d * size)
                    .collect::<Vec<_>>()
            };
            let second = hessian
                .iter()
                .zip(sizes)
                .flat_map(|(second, (_, size))| row(second).into_iter().map(move |d| d * size));
            [row(&gradient), second.collect()]
        };
        let [found, exact] =
            [within, fine].map(|setup| sized(hessian(&setup, Outcome::Carry, &by).unwrap()));
        let bars = if ["nathan", "bearman-harvey"].contains(&law) {
            [2e-6, 1e-3]
        } else {
            [1e-7, 3e-6]
        };
        for ((found, exact), bar) in found.iter().zip(&exact).zip(bars) {
            let largest = exact.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
            let off = found
                .iter()
                .zip(exact)
                .fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(
                off < bar * largest,
                "{law} {loft} {attack_angle} {speed}: {:.1e}",
                off / largest
            );
        }
    });
}
