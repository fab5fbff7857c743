//! Presets of averages compared with the published averages. `docs/sources.md` lists the published
//! values to which the presets were fitted.

use longdrive::optimize::Observer;
use longdrive::parameters::Vary;
use longdrive::study::{Search, optimum};
use longdrive::{Drive, Outcome, Setup};

const MPH: f64 = 0.44704;
const YARD: f64 = 0.9144;
const RPM: f64 = std::f64::consts::TAU / 60.0;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// A published average. Delivery: head speed, mph; attack angle, °. Drive: ball speed, mph; launch
/// angle, °; spin, rpm; carry, yd; apex height, yd; descent angle, °.
struct Average {
    preset: &'static str,
    delivery: [f64; 2],
    drive: [f64; 6],
}

const PGA: Average = Average {
    preset: "tour-average",
    delivery: [115.0, -0.9],
    drive: [171.0, 10.4, 2545.0, 282.0, 35.0, 39.0],
};
const LPGA: Average = Average {
    preset: "lpga-average",
    delivery: [96.0, 2.8],
    drive: [143.0, 12.6, 2506.0, 223.0, 26.0, 36.0],
};

impl Average {
    /// Asserts deviations of at most 1 % of ball speed, 0.5° of launch angle, 5 % of spin, 2 % of
    /// carry, 2 yd of apex height, and 2° of descent angle.
    fn compare(&self) {
        let setup = Setup::preset(self.preset).unwrap();
        let [speed, attack] = self.delivery;
        assert!(
            (setup.swing.speed / MPH - speed).abs() < 1e-9
                && (setup.swing.attack_angle / DEGREE - attack).abs() < 1e-9
        );
        let drive = Drive::new(&setup).unwrap();
        let [ball, launch, spin, carry, apex, descent] = self.drive;
        let held = [
            (Outcome::BallSpeed, MPH, ball, 0.01 * ball),
            (Outcome::LaunchAngle, DEGREE, launch, 0.5),
            (Outcome::Spin, RPM, spin, 0.05 * spin),
            (Outcome::CarryDistance, YARD, carry, 0.02 * carry),
            (Outcome::ApexHeight, YARD, apex, 2.0),
            (Outcome::DescentAngle, DEGREE, descent, 2.0),
        ];
        for (outcome, unit, published, bound) in held {
            let ours = outcome.value(&drive).unwrap() / unit;
            let name = outcome.name();
            assert!(
                (ours - published).abs() <= bound,
                "{}: {name} {ours} against {published} ± {bound}",
                self.preset
            );
        }
    }
}

#[test]
fn published_average_of_the_pga_tour_is_met_by_its_preset() {
    PGA.compare();
}

#[test]
fn published_average_of_the_lpga_tour_is_met_by_its_preset() {
    LPGA.compare();
}

/// TrackMan's chart states the loft at impact. With this loft the club of `lpga-average` has the
/// launch and the spin of the chart, and the club of `tour-average` has 13 to 33 % less spin. The
/// presets therefore differ in the impact, not only in the flight.
#[test]
fn published_impacts_of_trackmans_chart_are_those_of_the_club_of_the_lpga_average() {
    let rows = include_str!("../data/trackman_chart_impacts.csv")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1);
    let mut count = 0;
    for row in rows {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [speed, attack, loft, ball, launch, spin] = cells[..] else {
            panic!("{row}")
        };
        let struck = |preset: &str| {
            let mut setup = Setup::preset(preset).unwrap();
            (setup.swing.shaft_bend, setup.swing.shaft_growth) = (None, None);
            (setup.swing.speed, setup.swing.attack_angle) = (speed * MPH, attack * DEGREE);
            // loft at impact = club.loft + attack angle + strike.high / roll radius
            setup.club.loft = (loft - attack) * DEGREE - setup.strike.high / setup.club.roll_radius;
            let drive = Drive::new(&setup).unwrap();
            [
                (Outcome::BallSpeed, MPH),
                (Outcome::LaunchAngle, DEGREE),
                (Outcome::Spin, RPM),
            ]
            .map(|(of, unit)| of.value(&drive).unwrap() / unit)
        };
        let ours = struck("lpga-average");
        assert!(
            (ours[0] / ball - 1.0).abs() < 0.01 && (ours[1] - launch).abs() < 0.5,
            "{row}: {ours:?}"
        );
        assert!((ours[2] / spin - 1.0).abs() < 0.03, "{row}: {ours:?}");
        let less = 1.0 - struck("tour-average")[2] / spin;
        assert!((0.13..0.33).contains(&less), "{row}: {less}");
        count += 1;
    }
    assert_eq!(count, 60);
}

/// Differences between a club's optima and the rows of longest carry of TrackMan's chart: launch
/// angle, deg; spin, rpm; carry, relative.
fn misses_of_optima(club: &Setup<f64>) -> Vec<[f64; 3]> {
    let rows = include_str!("../data/trackman_optimal_driver.csv")
        .lines()
        .filter(|line| line.starts_with("best carry"));
    let miss = |row: &str| {
        let cells: Vec<&str> = row.split(',').collect();
        let words: Vec<&str> = cells[0].split(' ').collect();
        let [speed, attack] = [words[3], words[6]].map(|word| word.parse::<f64>().unwrap());
        let mut setup = *club;
        (setup.swing.speed, setup.swing.attack_angle) = (speed * MPH, attack * DEGREE);
        let vary = vec![Vary::read(&setup, "club.loft=0deg..40deg").unwrap()];
        let search = Search {
            vary,
            ..Search::largest(Outcome::CarryDistance)
        };
        let drive = optimum(&setup, search, Observer::default())
            .unwrap()
            .drive
            .unwrap();
        let of = |of: Outcome, unit: f64| of.value(&drive).unwrap() / unit;
        let published: Vec<f64> = cells[2..]
            .iter()
            .map(|cell| cell.parse().unwrap())
            .collect();
        [
            (of(Outcome::LaunchAngle, DEGREE) - published[0]).abs(),
            (of(Outcome::Spin, RPM) - published[1]).abs(),
            (of(Outcome::CarryDistance, YARD) / published[2] - 1.0).abs(),
        ]
    };
    let misses: Vec<_> = rows.map(miss).collect();
    assert_eq!(misses.len(), 30);
    misses
}

/// The best club loft for carry gives a launch angle within 1°, a spin within 250 rpm and a carry
/// within 2 % of the chart, on average over its 30 rows.
#[test]
fn published_optima_of_trackmans_chart_are_met_by_the_lpga_average() {
    let misses = misses_of_optima(&Setup::preset("lpga-average").unwrap());
    let [launch, spin, carry] =
        [0, 1, 2].map(|at| misses.iter().map(|miss| miss[at]).sum::<f64>() / 30.0);
    assert!(
        launch < 1.0 && spin < 250.0 && carry < 0.02,
        "{launch} deg, {spin} rpm, {carry}"
    );
}

/// With the tangential restitution of the chart and the law `ferguson`, `modern-driver` is within
/// 1°, 250 rpm and 2 % of the chart in each of its 30 rows.
#[test]
fn published_optima_of_trackmans_chart_are_met_row_by_row_with_its_impact_and_fergusons_law() {
    let mut club = Setup::preset("modern-driver").unwrap();
    club.set("impact.tangential_restitution", "-0.03").unwrap();
    club.set("aero.law", "ferguson").unwrap();
    let misses = misses_of_optima(&club);
    let [launch, spin, carry] =
        [0, 1, 2].map(|at| misses.iter().map(|miss| miss[at]).fold(0.0, f64::max));
    assert!(
        launch < 1.0 && spin < 250.0 && carry < 0.02,
        "at most {launch} deg, {spin} rpm, {carry}"
    );
}

#[test]
fn published_launch_and_carry_of_the_average_amateur_are_met_by_its_preset() {
    let drive = Drive::new(&Setup::preset("amateur-average").unwrap()).unwrap();
    for (outcome, unit, expected, bound) in [
        (Outcome::BallSpeed, MPH, 132.6, 0.1),
        (Outcome::LaunchAngle, DEGREE, 12.6, 0.1),
        (Outcome::Spin, RPM, 3275.0, 10.0),
        // the bound is 2 % of the published carry, to which the preset was not fitted
        (Outcome::CarryDistance, YARD, 204.0, 4.08),
        // the computed angle; the published angle is 34.8° (docs/sources.md)
        (Outcome::DescentAngle, DEGREE, 37.5, 0.05),
    ] {
        let ours = outcome.value(&drive).unwrap() / unit;
        assert!(
            (ours - expected).abs() <= bound,
            "{}: {ours} against {expected}",
            outcome.name()
        );
    }
}

#[test]
fn published_edition_of_2019_is_met_but_for_the_launch_angle() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([
            ("swing.speed", "113 mph"),
            ("swing.attack_angle", "-1.3 deg"),
        ])
        .unwrap();
    let drive = Drive::new(&setup).unwrap();
    let of = |outcome: Outcome, unit: f64| outcome.value(&drive).unwrap() / unit;
    assert!((of(Outcome::BallSpeed, MPH) - 167.0).abs() <= 1.67);
    assert!((of(Outcome::CarryDistance, YARD) - 275.0).abs() <= 5.5);
    assert!((of(Outcome::ApexHeight, YARD) - 32.0).abs() <= 2.0);
    assert!((of(Outcome::DescentAngle, DEGREE) - 38.0).abs() <= 2.0);
    assert!((of(Outcome::Spin, RPM) - 2686.0).abs() <= 0.05 * 2686.0);
    // the computed angle; the published angle is 10.9° (docs/sources.md)
    assert_eq!(format!("{:.1}", of(Outcome::LaunchAngle, DEGREE)), "10.1");
}
