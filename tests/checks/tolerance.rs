//! The tolerance of many drives: every length of every row, beside flights in much shorter steps.

use crate::common::random_setups;
use longdrive::batch::{Batch, Block, Points, Sequence, Status};
use longdrive::parameters::{Method, Parameter, Vary};
use longdrive::study::accuracy;
use longdrive::{Error, Outcome, Setup};
use rayon::prelude::*;

const MICROMETRE: f64 = 1e-6;
const LENGTHS: [Outcome; 5] =
    [Outcome::Carry, Outcome::CarryDistance, Outcome::Lateral, Outcome::ApexHeight, Outcome::ApexDownrange];

/// The rows of a sweep by so many points of these ranges.
fn rows(batch: &Batch, ranges: &[Vary], count: u64) -> Block {
    let mut points = vec![];
    Sequence::new(ranges.to_vec(), count, 7).unwrap().read(count as usize, &mut points).unwrap();
    batch.evaluate(0, points)
}

/// A sweep within a micrometre: the largest error of a length, m, and how many rows have landed. Nothing where no step is found.
fn sweep(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome], count: u64) -> Option<(f64, usize)> {
    let found = match accuracy(setup, ranges, of, MICROMETRE) {
        Ok(found) => found,
        Err(Error::NoFlight { .. } | Error::Tolerance { .. }) => return None,
        Err(error) => panic!("{error}"),
    };
    let batch = batch(&found.applied_to(setup), ranges, of).with_largest_defect(found.largest_defect);
    Some(error(setup, &batch, ranges, of, count))
}

/// These outcomes of drives that differ in what is varied.
fn batch(setup: &Setup<f64>, ranges: &[Vary], of: &[Outcome]) -> Batch {
    let parameters: Vec<&'static Parameter> = ranges.iter().map(|range| range.parameter).collect();
    Batch::new(setup, &parameters, of, &[]).unwrap()
}

/// The largest difference from flights in much shorter steps, m, and how many of these have landed.
fn error(setup: &Setup<f64>, flown: &Batch, ranges: &[Vary], of: &[Outcome], count: u64) -> (f64, usize) {
    let mut fine = Setup { method: Method::DormandPrince8, ..*setup };
    fine.flight.step = if setup.wind.roughness.is_some() { 0.005 } else { 0.04 };
    let (exact, flown) = (rows(&batch(&fine, ranges, of), ranges, count), rows(flown, ranges, count));
    let landed = || (0..exact.rows()).filter(|&row| exact.status(row) == Status::Landed);
    let errors = landed().flat_map(|row| (0..of.len()).map(move |i| (row, i))).map(|(row, i)| {
        flown.outcome(row, i).map_or(f64::INFINITY, |flown| (flown - exact.outcome(row, i).unwrap()).abs())
    });
    (errors.fold(0.0, f64::max), landed().count())
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
    let setups: Vec<_> = random_setups(sweeps).collect();
    let look = |(n, setup): (usize, &Setup<f64>)| {
        let by = [names[n % names.len()], names[(n + 1 + n / names.len() % (names.len() - 1)) % names.len()]];
        let ranges = by.map(|name| {
            let value = setup.value(setup.variable(name).unwrap()).unwrap();
            let width = if name.ends_with("angle") || name.ends_with("downrange") { 0.1 } else { 0.2 * value };
            range(setup, name, value - width, value + width)
        });
        let (error, rows) = sweep(setup, &ranges, &LENGTHS, 32)?;
        assert!(error <= MICROMETRE, "case {n}, by {by:?}: {error:e} m");
        Some(rows)
    };
    let landed: Vec<usize> = setups.par_iter().enumerate().filter_map(look).collect();
    let (swept, rows) = (landed.len(), landed.iter().sum::<usize>());
    assert!(swept > setups.len() / 10 * 9 && rows > 25 * swept, "{rows} rows of {swept}");
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
        let (error, rows) = sweep(setup, ranges, &[Outcome::Carry, Outcome::Lateral], 1024).unwrap();
        assert!(error <= MICROMETRE && rows > 500, "{error:e} m of {rows} rows");
    }
    // a step for one loft, and rows of all
    let found = accuracy(&low, &[range(&low, "club.loft", 0.17, 0.18)], &LENGTHS, MICROMETRE).unwrap();
    let chosen = || batch(&found.applied_to(&low), &low_ranges, &LENGTHS);
    let of = |batch: Batch| error(&low, &batch, &low_ranges, &LENGTHS, 1024).0;
    let (unchecked, checked) = (of(chosen()), of(chosen().with_largest_defect(found.largest_defect)));
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
