//! Temperatures, altitudes and CSV in the units of the reader.

use crate::command_line::{json, longdrive, number, on_one_line};

/// The head of a CSV text, and the numbers of its first row. A cell with words is NaN.
fn csv(text: &str) -> (Vec<String>, Vec<f64>) {
    let mut lines = text.lines();
    let mut cells = || {
        lines
            .next()
            .unwrap()
            .split(',')
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let head = cells();
    let row = cells();
    let row = row.iter().map(|cell| cell.parse().unwrap_or(f64::NAN));
    (head, row.collect())
}

#[test]
fn temperatures_and_altitudes_are_in_degrees_and_feet() {
    let weather = ["--temperature", "50F", "--altitude", "5000ft"];
    let shown = |words: &[&str]| longdrive(&[words, &weather].concat()).out;
    let us = shown(&["parameters", "air"]);
    assert!(us.contains(" 50 degF ") && us.contains(" 5000 ft "), "{us}");
    let metric = shown(&["parameters", "air", "--units", "metric"]);
    assert!(
        metric.contains(" 10 degC ") && metric.contains(" 1524 m "),
        "{metric}"
    );
    for text in [us, metric] {
        assert!(!text.contains(" K "), "{text}");
    }
    let (_, found) = json(&[&["simulate"], &weather[..]].concat());
    assert!((number(&found["setup"]["air.temperature"]) - 283.15).abs() < 1e-9);
    assert_eq!(number(&found["setup"]["air.altitude"]), 1524.0);
}

/// An uncertainty of 1.5 K is 2.7 °F.
#[test]
fn exact_uncertainties_of_temperatures_are_differences() {
    let output = longdrive(&["sensitivity", "--temperature", "50F"]);
    assert!(
        output.out.contains("2.7") && output.out.contains("°F"),
        "{}",
        output.out
    );
    assert!(!output.out.contains(" K "), "{}", output.out);
}

#[test]
fn an_altitude_without_a_temperature_has_a_note_on_the_standard_temperature() {
    let says = "air.altitude = 5000 ft is given without air.temperature, which is then 77 °F; the \
                standard atmosphere has 41 °F there, so its air is 7 % denser";
    let output = longdrive(&["simulate", "-q", "--altitude", "5000ft"]);
    assert!(on_one_line(&output.err).contains(says), "{}", output.err);
    let (_, found) = json(&["simulate", "--altitude", "5000ft"]);
    assert!(
        found["warnings"]
            .to_string()
            .contains("without air.temperature")
    );
    let whole = ["simulate", "--altitude", "5000ft", "--temperature", "41F"];
    assert!(!on_one_line(&longdrive(&whole).err).contains("without air.temperature"));
}

/// A sweep and a chart have the warnings of the weather at the ends of their ranges.
#[test]
fn ranges_of_the_weather_have_the_warnings_of_their_ends() {
    let sweep = [
        "sweep",
        "--over",
        "air.altitude=0m..2000m:2",
        "--outcomes",
        "carry",
    ];
    let says = "air.altitude = 2000 m is given without air.temperature";
    let output = longdrive(&[&sweep[..], &["--units", "metric"]].concat());
    assert!(on_one_line(&output.err).contains(says), "{}", output.err);
    let sea = [
        "sweep",
        "--over",
        "air.altitude=-200m..0m:2",
        "--outcomes",
        "carry",
    ];
    assert!(!on_one_line(&longdrive(&sea).err).contains("without air.temperature"));
    let (_, chart) = json(&[
        "chart",
        "--along",
        "air.temperature",
        "--at",
        "20degC,50degC",
    ]);
    assert!(
        chart["warnings"]
            .to_string()
            .contains("(CIPM-2007) is extrapolated"),
        "{}",
        chart["warnings"]
    );
}

/// The columns in other units have the converted values of the columns in SI.
#[test]
fn exact_sweeps_in_the_stated_units() {
    let words = [
        "sweep",
        "--over",
        "club.loft=10deg..12deg:2",
        "--over",
        "air.temperature=50F..86F:2",
        "--outcomes",
        "carry,spin",
        "--gradient",
        "-q",
    ];
    let (head, si) = csv(&longdrive(&words).out);
    assert_eq!(head[..2], ["club.loft [rad]", "air.temperature [K]"]);
    let (head, us) = csv(&longdrive(&[&words[..], &["--units", "us"]].concat()).out);
    assert_eq!(
        head,
        [
            "club.loft [deg]",
            "air.temperature [degF]",
            "status",
            "carry [yd]",
            "spin [rpm]",
            "d_carry/d_club.loft [yd/deg]",
            "d_carry/d_air.temperature [yd/degF]",
            "d_spin/d_club.loft [rpm/deg]",
            "d_spin/d_air.temperature [rpm/degF]",
        ]
    );
    let (yd, deg, rpm) = (0.9144, 1.0_f64.to_radians(), std::f64::consts::TAU / 60.0);
    let fahrenheit = 5.0 / 9.0;
    let expected = [
        10.0,
        50.0,
        f64::NAN,
        si[3] / yd,
        si[4] / rpm,
        si[5] / yd * deg,
        si[6] / yd * fahrenheit,
        si[7] / rpm * deg,
        si[8] / rpm * fahrenheit,
    ];
    for (ours, expected) in us.iter().zip(expected) {
        let is_word = ours.is_nan() && expected.is_nan();
        assert!(
            is_word || (ours - expected).abs() <= 1e-12 * expected.abs(),
            "{us:?}"
        );
    }
}

/// A sweep written in other units has the same points when it is read again.
#[test]
fn same_points_from_a_sweep_in_the_stated_units() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("us.csv").display().to_string();
    let over = ["sweep", "--over", "club.loft=10deg..12deg:3"];
    let output = longdrive(&[&over[..], &["--units", "us", "-o", &file]].concat());
    assert_eq!(output.status, 0, "{}", output.err);
    let (_, again) = csv(&longdrive(&["sweep", "--points", &file, "-q"]).out);
    let (_, first) = csv(&longdrive(&[&over[..], &["-q"]].concat()).out);
    assert!((again[2] - first[2]).abs() < 1e-6, "{again:?} {first:?}");
}

#[test]
fn plots_charts_and_fronts_have_the_stated_units_in_csv() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let us = ["--units", "us", "-q"];
    let file = at("path.csv");
    let output = longdrive(&[&["plot", "trajectory", "-o", &file][..], &us].concat());
    assert_eq!(output.status, 0, "{}", output.err);
    let (head, _) = csv(&std::fs::read_to_string(&file).unwrap());
    assert!(head.iter().all(|head| !head.contains("[m]")), "{head:?}");
    assert!(head.iter().any(|head| head.contains("[yd]")), "{head:?}");
    let chart = ["chart", "--along", "swing.speed", "--at", "100mph", "--csv"];
    let (head, row) = csv(&longdrive(&[&chart[..], &us].concat()).out);
    assert_eq!(head[..2], ["swing.speed [mph]", "carry [yd]"]);
    assert!((row[0] - 100.0).abs() < 1e-12);
    let (si_head, si) = csv(&longdrive(&[&chart[..], &["-q"]].concat()).out);
    assert_eq!(si_head[1], "carry [m]");
    assert!((row[1] - si[1] / 0.9144).abs() < 1e-9);
    let file = at("front.csv");
    let goals = [
        "--maximize",
        "carry",
        "--minimize",
        "apex_height",
        "--points",
        "2",
    ];
    let words = [&["pareto", "-o", &file], &goals[..], &us].concat();
    assert_eq!(longdrive(&words).status, 0);
    let (head, _) = csv(&std::fs::read_to_string(&file).unwrap());
    assert_eq!(
        head[..3],
        ["carry [yd]", "apex_height [yd]", "club.loft [deg]"]
    );
}

#[test]
fn exact_slope_of_a_front_in_the_stated_units() {
    let folder = tempfile::tempdir().unwrap();
    let slope = |units: &[&str]| {
        let file = folder.path().join("front.csv").display().to_string();
        let goals = [
            "--maximize",
            "carry",
            "--minimize",
            "descent_angle",
            "--points",
            "3",
        ];
        let ask = ["pareto", "-q", "--overwrite", "-o", &file];
        let output = longdrive(&[&ask[..], &goals, units].concat());
        assert_eq!(output.status, 0, "{}", output.err);
        let table = std::fs::read_to_string(&file).unwrap();
        let heads = table.lines().next().unwrap().split(',');
        let (at, head) = heads
            .enumerate()
            .find(|(_, head)| head.starts_with("slope"))
            .unwrap();
        // omits slopes of 0, at the largest carry, and missing slopes, where a bound becomes active
        let slopes = table.lines().skip(1).filter_map(|row| {
            let slope: f64 = row.split(',').nth(at).unwrap().parse().ok()?;
            (slope != 0.0).then_some(slope)
        });
        (head.to_owned(), slopes.last().unwrap())
    };
    let (si_head, si) = slope(&[]);
    let (us_head, us) = slope(&["--units", "us"]);
    assert_eq!(
        [si_head.as_str(), us_head.as_str()],
        ["slope [m/rad]", "slope [yd/deg]"]
    );
    let expected = si / 0.9144 * std::f64::consts::PI / 180.0;
    assert!((us / expected - 1.0).abs() < 1e-12, "{us} {expected}");
}
