//! The tolerance of many drives: every length of every row, beside flights in much shorter steps.

use crate::common::for_random_setups;
use longdrive::batch::{Batch, Block, Points, Sequence, Status};
use longdrive::parameters::{Method, Parameter, Vary};
use longdrive::study::accuracy;
use longdrive::{Error, Outcome, Setup};
use std::cell::Cell;

const MICROMETRE: f64 = 1e-6;
const LENGTHS: [Outcome; 5] =
    [Outcome::Carry, Outcome::CarryDistance, Outcome::Lateral, Outcome::ApexHeight, Outcome::ApexDownrange];

/// The rows of a sweep by so many points of these ranges.
fn rows(batch: &Batch, ranges: &[Vary], count: u64) -> Block {
    let mut points = vec![];
    Sequence::new(ranges.to_vec(), count, 7).unwrap().read(count as usize, &mut points).unwrap();
    batch.evaluate(0, points)
}

/// The largest error of a length of a sweep within a micrometre, m, and how many rows have landed; beside it, what it is without
/// looking at each row. Nothing where no step is found.
fn sweep(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], count: u64) -> Option<(f64, f64, usize)> {
    let found = match accuracy(setup, ranges, of, MICROMETRE) {
        Ok(found) => found,
        Err(Error::NoFlight { .. } | Error::Tolerance { .. }) => return None,
        Err(error) => panic!("{error}"),
    };
    let parameters: Vec<&'static Parameter> = ranges.iter().map(|range| range.parameter).collect();
    let batch = Batch::new(&found.applied_to(setup), &parameters, of, &[]).unwrap();
    Some(errors(setup, batch, found.largest_defect, ranges, of, count))
}

fn errors(
    setup: &Setup<f64>,
    batch: Batch,
    defect: f64,
    ranges: &[Vary],
    of: &[Outcome],
    count: u64,
) -> (f64, f64, usize) {
    let mut fine = Setup { method: Method::DormandPrince8, ..*setup };
    fine.flight.step = if setup.wind.roughness.is_some() { 0.005 } else { 0.04 };
    let exact = rows(&Batch::new(&fine, batch.parameters(), of, &[]).unwrap(), ranges, count);
    let error = |flown: &Block| {
        let landed = (0..exact.rows()).filter(|&row| exact.status(row) == Status::Landed);
        let errors = landed.flat_map(|row| (0..of.len()).map(move |i| (row, i)));
        errors.fold(0.0_f64, |worst, (row, i)| {
            let error =
                flown.outcome(row, i).map_or(f64::INFINITY, |flown| (flown - exact.outcome(row, i).unwrap()).abs());
            worst.max(error)
        })
    };
    let unchecked = error(&rows(&batch, ranges, count));
    let checked = error(&rows(&batch.with_largest_defect(defect), ranges, count));
    (checked, unchecked, (0..exact.rows()).filter(|&row| exact.status(row) == Status::Landed).count())
}

fn range(setup: &Setup<f64>, name: &str, low: f64, high: f64) -> Vary {
    Vary::new(setup.variable(name).unwrap(), low, high).unwrap()
}

/// Random setups in space, of all laws, some in a wind that grows with height; each swept over two parameters. `LONGDRIVE_SWEEPS` is how
/// many (1000 take a minute and a half).
#[test]
fn independent_lengths_of_random_sweeps_are_within_a_micrometre() {
    let names =
        ["club.loft", "swing.attack_angle", "swing.speed", "air.density", "ball.mass", "wind.downrange", "gravity"];
    let sweeps = std::env::var("LONGDRIVE_SWEEPS").map_or(150, |text| text.parse().unwrap());
    let (case, swept, landed) = (Cell::new(0_usize), Cell::new(0_u32), Cell::new(0));
    for_random_setups(sweeps, |setup| {
        let n = case.replace(case.get() + 1);
        let by = [names[n % names.len()], names[(n + 1 + n / names.len() % (names.len() - 1)) % names.len()]];
        let ranges = by.map(|name| {
            let value = setup.value(setup.variable(name).unwrap()).unwrap();
            let width = if name.ends_with("angle") || name.ends_with("downrange") { 0.1 } else { 0.2 * value };
            range(&setup, name, value - width, value + width)
        });
        if let Some((checked, _, rows)) = sweep(&setup, &ranges, &LENGTHS, 32) {
            swept.set(swept.get() + 1);
            landed.set(landed.get() + rows);
            assert!(checked <= MICROMETRE, "case {n}, by {by:?}: {checked:e} m");
        }
    });
    assert!(swept.get() > sweeps / 10 * 9 && landed.get() > 25 * swept.get() as usize, "{landed:?} rows of {swept:?}");
}

/// Two of the drives of which the step alone, chosen by others, was off by up to 266 times the tolerance: far out, and next to no flight.
#[test]
fn independent_rows_that_a_step_chosen_by_others_misses_are_flown_again() {
    let mut far = Setup::default();
    far.set_all([("aero.law", "smits-smith"), ("ball.mass", "54.8 g"), ("club.cg_depth", "36.6 mm")]).unwrap();
    let far_ranges = [
        range(&far, "impact.restitution", 0.7, 0.93),
        range(&far, "swing.attack_angle", -0.1, 0.4),
        range(&far, "club.loft", 0.1, 0.5),
        range(&far, "gravity", 4.0, 10.0),
    ];
    let low = Setup::default();
    let low_ranges = [range(&low, "club.loft", 0.02, 0.3), range(&low, "swing.attack_angle", -0.15, 0.1)];
    for (setup, ranges) in [(&far, &far_ranges[..]), (&low, &low_ranges)] {
        let (checked, _, rows) = sweep(setup, ranges, &[Outcome::Carry, Outcome::Lateral], 1024).unwrap();
        assert!(checked <= MICROMETRE && rows > 500, "{checked:e} m of {rows} rows");
    }
    // a step for one loft, and rows of all
    let found = accuracy(&low, &[range(&low, "club.loft", 0.17, 0.18)], &LENGTHS, MICROMETRE).unwrap();
    let parameters: Vec<&'static Parameter> = low_ranges.iter().map(|range| range.parameter).collect();
    let batch = Batch::new(&found.applied_to(&low), &parameters, &LENGTHS, &[]).unwrap();
    let (checked, unchecked, _) = errors(&low, batch, found.largest_defect, &low_ranges, &LENGTHS, 1024);
    assert!(checked <= MICROMETRE && unchecked > 2.0 * MICROMETRE, "{checked:e} m, {unchecked:e} m");
}

/// A row that no step follows as closely as is asked has no outcomes.
#[test]
fn exact_a_row_that_no_step_follows_closely_enough_diverges() {
    let setup = Setup::default();
    let loft = setup.variable("club.loft").unwrap();
    for (defect, status) in [(0.0, Status::Diverged), (f64::INFINITY, Status::Landed)] {
        let batch = Batch::new(&setup, &[loft], &[Outcome::Carry], &[]).unwrap().with_largest_defect(defect);
        let block = batch.evaluate(0, vec![0.18]);
        assert_eq!((block.status(0), block.outcome(0, 0).is_some()), (status, status == Status::Landed));
    }
}

/// What cannot be reached says which drive is off, and by how much.
#[test]
fn exact_a_tolerance_out_of_reach_names_the_drive() {
    let setup = Setup::default();
    let error = accuracy(&setup, &[range(&setup, "club.loft", 0.1, 0.2)], &[Outcome::Carry], 1e-16).unwrap_err();
    let words = error.to_string();
    assert!(words.contains("carry of the drive with club.loft = ") && words.contains(" is off by "), "{words}");
}
