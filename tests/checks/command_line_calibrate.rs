//! `calibrate` as a user meets it: its tolerance, and rows that do not fly.

use crate::command_line::{json, longdrive};

const SHOTS: [&str; 4] = ["calibrate", "examples/shots.csv", "--fit", "aero.cd0"];

#[test]
fn a_tolerance_is_honoured() {
    let with = |more: &[&str]| longdrive(&[&SHOTS[..], more].concat());
    let said = with(&["--tolerance=1m"]);
    assert!(said.status == 0 && said.err.contains("method ") && said.err.contains("carry is within"), "{}", said.err);
    // the step that was chosen is the one that is flown: a metre shows in the carries that are left over
    assert_ne!(said.out, with(&[]).out);
    let (status, fine) = json(&[&SHOTS[..], &["--tolerance=1um"]].concat());
    let setup = &fine["setup"];
    assert!(status == 0 && setup["flight.step"].as_f64().unwrap() > 0.005, "{setup}");
    let said = with(&["--tolerance=0m"]);
    assert!(said.status == 2 && said.err.contains("the tolerance of 0 m"), "{}", said.err);
    // a range that was given to the fit is flown at its ends
    assert_eq!(with(&["--fit", "aero.cl_max=0.2..1", "--tolerance=1mm"]).status, 0);
    let deliveries = "club.loft [deg],swing.speed [mph],carry [yd]\n9,100,240\n11,110,270\n";
    let (_folder, path) = crate::sweep::table("deliveries.csv", deliveries);
    let said = longdrive(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0", "--tolerance"]);
    assert!(said.status == 0 && said.err.contains("carry is within"), "{}", said.err);
}

#[test]
fn rows_that_diverge_alike_are_told_once_with_the_advice_that_fits() {
    let said = longdrive(&[&SHOTS[..], &["--set", "flight.step=2s"]].concat());
    assert_eq!(said.status, 2);
    assert_eq!(said.err.matches("diverge").count(), 1, "{}", said.err);
    assert!(
        said.err.contains("rows 1 to 12: the flight diverges; the step is long; reduce flight.step"),
        "{}",
        said.err
    );
    assert!(!said.err.contains("out"), "no row is to blame: {}", said.err);
    let said = longdrive(&[&SHOTS[..], &["--set", "air.density=900kg/m^3"]].concat());
    assert!(said.err.contains("air.density") && !said.err.contains("flight.step"), "{}", said.err);
}

#[test]
fn a_range_of_one_value_is_refused() {
    let said = longdrive(&["calibrate", "examples/shots.csv", "--fit", "aero.cd0=0.2..0.2"]);
    assert!(said.status == 2 && said.err.contains("aero.cd0 is the single value 0.2"), "{}", said.err);
}
