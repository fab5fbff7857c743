//! A user's table of drag and lift (`aero.table`).

use crate::command_line::{json, longdrive, number};
use longdrive::aerodynamics::{AerodynamicLaw, Coefficients, Stream};
use longdrive::number::Number;
use longdrive::parameters::{Law, LawTable, LawVariable, TABLE};
use longdrive::study::certificate::certify;
use longdrive::{Drive, Outcome, Setup};
use num_dual::Dual2_64;
use std::fmt::Write;
use std::path::Path;
use tempfile::TempDir;

const RADIUS: f64 = 0.02134;

/// A folder with a table, and the name of the table.
fn written(text: &str) -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().join("mine.csv").to_str().unwrap().to_owned();
    std::fs::write(&name, text).unwrap();
    (folder, name)
}

fn of_table(text: &str) -> Law<f64> {
    let (_folder, name) = written(text);
    let mut setup = Setup::modern_driver();
    setup.set_table(Path::new(&name)).unwrap();
    setup.law
}

fn at<D: Number>(law: Law<f64>, [s, reynolds, speed]: [D; 3]) -> Coefficients<D> {
    let law = Setup {
        law,
        ..Setup::modern_driver()
    }
    .map(|_, value| D::constant(value))
    .law;
    law.coefficients(Stream::new(
        s * speed / RADIUS,
        speed,
        D::constant(RADIUS),
        reynolds / speed,
    ))
}

/// The coefficients of a law at 50 m/s as a table, with a row for each pair of spin ratio and
/// Reynolds number.
fn table_of(law: &str, spin_ratios: &[f64], reynolds: &[f64]) -> String {
    let law = Law::named(law).unwrap();
    let mut text = "spin_ratio,Re,cd,cl\n".to_owned();
    // the rows of a table may be in any order
    for re in reynolds.iter().rev() {
        for s in spin_ratios {
            let c: Coefficients<f64> = at(law, [*s, *re, 50.0]);
            writeln!(text, "{s},{re},{:?},{:?}", c.drag, c.lift).unwrap();
        }
    }
    text
}

fn evenly(low: f64, high: f64, steps: u32) -> Vec<f64> {
    (0..=steps)
        .map(|k| low + (high - low) * f64::from(k) / f64::from(steps))
        .collect()
}

/// A table with the nodes of Bearman & Harvey has the splines of the law `bearman-harvey`, in any
/// units.
#[test]
fn same_drives_by_a_table_of_bearman_and_harvey_and_by_their_law() {
    let grid = include_str!("../data/bearman_harvey_1976.csv");
    let plain = grid.replacen(
        "speed_m_s,spin_rpm,CD,CL",
        "speed [m/s],spin [rpm],CD,CL",
        1,
    );
    let converted = grid.lines().skip(1).map(|line| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        format!(
            "{:?};{:?};{};{}\n",
            cells[0] * 3.6,
            cells[1] / 60.0 * 360.0,
            cells[2],
            cells[3]
        )
        .replace('.', ",")
    });
    let converted = format!(
        "sep=;\nSpeed (km/h);Spin (deg/s);cd;cl\n{}",
        converted.collect::<String>()
    );
    let published = Law::named("bearman-harvey").unwrap();
    for text in [plain, converted] {
        let own = of_table(&text);
        for (speed, rpm) in [
            (13.7, 2000.0),
            (17.0, 2310.0),
            (50.0, 2950.0),
            (79.9, 5990.0),
            (88.1, 1500.0),
            (88.1, 6090.0),
        ] {
            let spin = rpm * std::f64::consts::PI / 30.0;
            let stream = [spin * RADIUS / speed, 1e5, speed];
            let (a, b): (Coefficients<f64>, Coefficients<f64>) =
                (at(own, stream), at(published, stream));
            assert!(
                (a.drag - b.drag).abs() < 1e-12 && (a.lift - b.lift).abs() < 1e-12,
                "{speed}, {rpm}: {a:?} {b:?}"
            );
        }
    }
}

/// Twice as many nodes give a sixteenth of the error, except at the edges: there the natural spline
/// has second order.
#[test]
fn order_of_a_table_of_a_smooth_law_is_four() {
    let law = Law::named("winfield-tan").unwrap();
    let error = |steps: u32| {
        let own = of_table(&table_of(
            "winfield-tan",
            &evenly(0.0, 0.4, steps),
            &[1e5, 2e5],
        ));
        let off = evenly(0.12, 0.28, 53).into_iter().map(|s| {
            let stream = [s, 1.5e5, 50.0];
            let (a, b): (Coefficients<f64>, Coefficients<f64>) = (at(own, stream), at(law, stream));
            (a.drag - b.drag).abs().max((a.lift - b.lift).abs())
        });
        off.fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(20), error(40));
    let order = (coarse / fine).log2();
    assert!(
        (3.5..4.8).contains(&order) && fine < 1e-5,
        "{order}: {coarse:e}, {fine:e}"
    );
}

/// Value, first and second derivative agree on both sides of every grid line, and of the points
/// beyond the grid from which on the coefficients are constant.
#[test]
fn exact_c2_of_a_table_across_every_grid_line_and_beyond() {
    let spin_ratios = [0.05, 0.08, 0.15, 0.2, 0.31];
    let reynolds = [6e4, 1e5, 1.3e5, 2.1e5];
    let law = of_table(&table_of("usga-itr", &spin_ratios, &reynolds));
    // the grid lines, and the points from which on the coefficients are constant: they are beyond
    // the grid by half of its outermost interval
    let lines = spin_ratios
        .into_iter()
        .chain([0.035, 0.365])
        .map(|line| (0, line));
    for (variable, line) in lines.chain(
        reynolds
            .into_iter()
            .chain([4e4, 2.5e5])
            .map(|line| (1, line)),
    ) {
        let sides = [1.0 - 1e-12, 1.0 + 1e-12].map(|part| {
            let mut stream = [0.11, 1.1e5, 40.0].map(Dual2_64::from);
            stream[variable] = Dual2_64::from(line * part).derivative();
            let c = at(law, stream);
            [c.drag, c.lift].map(|c| [c.re, c.v1 * line, c.v2 * line * line])
        });
        for (a, b) in sides[0].iter().flatten().zip(sides[1].iter().flatten()) {
            assert!((a - b).abs() < 1e-8, "{variable} at {line}: {sides:?}");
        }
    }
    // beyond the clamps the coefficients are constant, and without spin there is no lift
    let far = at(
        law,
        [Dual2_64::from(0.5).derivative(), 1e5.into(), 40.0.into()],
    );
    assert_eq!((far.drag.v1, far.drag.v2, far.lift.v1), (0.0, 0.0, 0.0));
    let none = at(
        law,
        [Dual2_64::from(0.0).derivative(), 1e5.into(), 40.0.into()],
    )
    .lift;
    assert!(none.re == 0.0 && none.v1 > 0.0 && none.v2.is_finite());
}

/// Tables over spin ratio, Reynolds number, speed or spin alone. Without spin there is no lift.
#[test]
fn exact_a_table_along_one_axis_and_no_lift_without_spin() {
    for (text, place) in [
        (
            "s,cd,cl\n0,0.2,0\n0.1,0.25,0.15\n0.2,0.3,0.25\n",
            [0.1, 1e5, 50.0],
        ),
        (
            "# of mine\nre;cl;cd\n100000;0,15;0,25\n200000;0,16;0,24\n50000;0,2;0,5\n",
            [0.1, 1e5, 50.0],
        ),
        (
            "speed [mph],cd,cl\n100,0.25,0.15\n150,0.24,0.16\n",
            [0.1, 1e5, 44.704],
        ),
        (
            "spin [rad/s],cd,cl\n200,0.25,0.15\n300,0.24,0.16\n",
            [200.0 * RADIUS / 50.0, 1e5, 50.0],
        ),
    ] {
        let law = of_table(text);
        let c: Coefficients<f64> = at(law, place);
        assert!(
            (c.drag - 0.25).abs() < 1e-14 && (c.lift - 0.15).abs() < 1e-14,
            "{text}: {c:?}"
        );
        let none = at(
            law,
            [
                Dual2_64::from(0.0).derivative(),
                place[1].into(),
                place[2].into(),
            ],
        )
        .lift;
        assert!(
            none.re == 0.0 && none.v1 > 0.0 && none.v2.is_finite(),
            "{text}: {none:?}"
        );
    }
}

#[test]
fn derivatives_with_a_table_pass_verification() {
    let law = of_table(&table_of(
        "launch-monitor",
        &evenly(0.02, 0.4, 19),
        &evenly(5e4, 2.5e5, 8),
    ));
    let setup = Setup {
        law,
        ..Setup::modern_driver()
    };
    let wrt = [
        "club.loft",
        "swing.speed",
        "air.density",
        "aero.cd_factor",
        "aero.cl_factor",
        "wind.downrange",
    ];
    let wrt = wrt.map(|name| setup.variable(name).unwrap());
    let certificate = certify(
        &setup,
        &[Outcome::Carry, Outcome::Lateral, Outcome::DescentAngle],
        &wrt,
        &|_, _| true,
    )
    .unwrap();
    assert!(certificate.passed(), "{certificate:?}");
    // the carry with the table equals the carry with the law, within 5 cm
    let carry = |setup: &Setup<f64>| Outcome::Carry.of(&Drive::new(setup).unwrap()).unwrap();
    assert!(
        (carry(&setup) - carry(&Setup::modern_driver())).abs() < 0.05,
        "{}",
        carry(&setup)
    );
}

#[test]
fn bad_tables_are_refused_with_file_line_and_advice() {
    for (text, words) in [
        (
            "s,re,cd,cl\n0.1,1e5,0.2,0.1\n0.2,1e5,0.2,0.2\n0.1,2e5,0.2,0.1\n",
            &[
                "1 hole",
                "the first is spin_ratio 0.2, reynolds 200000",
                "every node a row",
            ][..],
        ),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.2,0.2,0.2\n0.1,0.3,0.1\n",
            &[
                ", line 4",
                "spin_ratio 0.1 is given twice, here and at line 2",
                "keep one",
            ],
        ),
        ("s,cd,cl\n0.1,0.2,0.1\n", &["one row only", "two nodes"]),
        ("s,cd,cl\n", &["no row"]),
        ("", &["no column cd"]),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.2,nan,0.2\n",
            &["line 3, column cd", "'nan' is not finite"],
        ),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.2,,0.2\n",
            &["line 3, column cd", "the cell is empty"],
        ),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.2,a lot,0.2\n",
            &["line 3, column cd", "'a lot' is not a number"],
        ),
        (
            "re;cd;cl\n50,000;0.25;0.1\n150,000;0.25;0.1\n",
            &[
                "line 2, column cd",
                "'0.25' has a point, but '50,000' has a comma",
                "nothing between thousands",
            ],
        ),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.2,-0.2,0.2\n",
            &[
                "line 3, column cd",
                "-0.2 is outside of its range, at least 0",
            ],
        ),
        (
            "s,cd,cl\n-0.1,0.2,0.1\n0.2,0.2,0.2\n",
            &["line 2, column s", "at least 0"],
        ),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.2,0.2\n",
            &["line 3", "the row has 2 cells, but the head has 3"],
        ),
        (
            "s,cd,clift\n0.1,0.2,0.1\n",
            &["column 3", "unknown column 'clift'", "did you mean 'cl'?"],
        ),
        (
            "reynold,cd,cl\n0.1,0.2,0.1\n",
            &["did you mean 'reynolds'?"],
        ),
        ("s,re,cl\n0.1,0.2,0.1\n", &["no column cd"]),
        (
            "cd,cl\n0.1,0.2\n",
            &["no column spin_ratio, spin, reynolds or speed"],
        ),
        (
            "speed,cd,cl\n50,0.2,0.1\n",
            &["'speed' has no unit", "'speed [m/s]'"],
        ),
        (
            "speed [rpm],cd,cl\n50,0.2,0.1\n",
            &["'rpm' is no unit of a speed", "mph"],
        ),
        ("s [m],cd,cl\n50,0.2,0.1\n", &["plain number"]),
        (
            "s,spin [rpm],cd,cl\n0.1,2000,0.2,0.1\n",
            &["'s' and 'spin [rpm]' give the same axis or number twice"],
        ),
        ("s,cd,cd,cl\n0.1,0.2,0.2,0.1\n", &["column 3", "twice"]),
        (
            "s,cd,cl\n0,0.2,0.1\n0.2,0.2,0.2\n",
            &["line 2", "without spin"],
        ),
        (
            "s,cd,cl\n0.1,0.2,0.1\n0.10000000001,0.2,0.2\n",
            &["nearly the same"],
        ),
        (
            "s,cd,cl\n0.1,5,0.1\n0.2,0,0.1\n0.21,3,0.1\n0.3,3,0.1\n",
            &["negative drag", "spin_ratio 0.", "more nodes"],
        ),
    ] {
        let (_folder, name) = written(text);
        let output = longdrive(&["simulate", "--set", &format!("{TABLE}={name}")]);
        assert_eq!(
            (output.status, output.out.as_str()),
            (2, ""),
            "{text}: {}",
            output.err
        );
        for word in words.iter().chain(&["mine.csv"]) {
            assert!(output.err.contains(word), "{text}: {word}: {}", output.err);
        }
    }
    for (args, words) in [
        (
            &["--set", "aero.table=none.csv"][..],
            &["none.csv", "there is no such file"][..],
        ),
        (&["--set", "aero.table=."], &["it is a folder"]),
        (
            &["--set", "aero.law=table"],
            &["without aero.table", "--set aero.table=mine.csv"],
        ),
        (
            &["--set", "aero.law=linear", "--set", "aero.table=a.csv"],
            &["aero.table and aero.law = linear are both given"],
        ),
        (&["--set", "aero.law=tabel"], &["did you mean 'table'?"]),
    ] {
        let output = longdrive(&[&["simulate"], args].concat());
        assert_eq!(output.status, 2, "{args:?}: {}", output.err);
        assert!(
            words.iter().all(|word| output.err.contains(word)),
            "{args:?}: {}",
            output.err
        );
    }
    let vary = longdrive(&["gradient", "--wrt", "aero.table"]);
    assert!(
        vary.err.contains("it is a choice, not a number"),
        "{}",
        vary.err
    );
}

/// A setup file names its table relative to its own folder. A setup that is written into another
/// folder still finds it.
#[test]
fn a_setup_with_a_table_is_written_and_read_again() {
    let (folder, name) = written(&table_of("ferguson", &evenly(0.02, 0.4, 10), &[5e4, 2.5e5]));
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    std::fs::create_dir(file("else")).unwrap();
    let (mine, best) = (file("mine.toml"), file("else/best.toml"));
    std::fs::write(
        &mine,
        "[aero]\nlaw = 'table'\ntable = 'mine.csv' # of the tunnel\ncd_factor = 0.9 # worn\n",
    )
    .unwrap();
    let (status, found) = json(&["optimize", &mine, "-o", &best, "--own-step"]);
    assert_eq!(
        (status, found["setup"]["aero.law"].as_str()),
        (0, Some("table"))
    );
    assert_eq!(found["setup"]["aero.table"].as_str(), Some(&*name));
    let text = std::fs::read_to_string(&best).unwrap();
    for comment in [
        "mine.csv\" # of the tunnel\n",
        "cd_factor = \"0.9\" # worn\n",
    ] {
        assert!(text.contains(comment), "{comment}: {text}");
    }
    let (_, again) = json(&["simulate", &best]);
    assert_eq!(
        number(&again["flight"]["carry"]),
        number(&found["flight"]["carry"])
    );
    assert_eq!(number(&again["setup"]["aero.cd_factor"]), 0.9);
    // no command overwrites the table
    let over = longdrive(&["optimize", &mine, "-o", &name, "--overwrite"]);
    assert!(
        over.status == 2 && over.err.contains("also an input"),
        "{}",
        over.err
    );
    let both = file("both.toml");
    std::fs::write(&both, "[aero]\ntable = 'mine.csv'\nlaw = 'ferguson'\n").unwrap();
    let output = longdrive(&["simulate", &both]);
    assert!(
        output.status == 2
            && output.err.contains("both.toml:3:7")
            && output.err.contains("keep one"),
        "{}",
        output.err
    );
    std::fs::write(&both, "[aero]\ntable = 'no.csv'\n").unwrap();
    let output = longdrive(&["simulate", &both]);
    assert!(
        output.status == 2 && output.err.contains("both.toml:2:9") && output.err.contains("no.csv"),
        "{}",
        output.err
    );
}

/// A saved search is not resumed after a change of the table of drag and lift.
#[test]
fn a_changed_table_is_another_sweep() {
    let table = |drag: f64| format!("s,cd,cl\n0,0.2,0\n0.1,{drag},0.15\n0.5,0.3,0.3\n");
    let (folder, name) = written(&table(0.25));
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (set, kept) = (format!("{TABLE}={name}"), file("kept.json"));
    let search = || longdrive(&["optimize", "--set", &set, "--checkpoint", &kept]);
    // sweeps and checkpoints are resumed only if the debug text of the setup is the same
    let identity = || {
        let mut setup = Setup::modern_driver();
        setup.set(TABLE, &name).unwrap();
        format!("{setup:?}")
    };
    assert_eq!((search().status, search().status), (0, 0));
    let before = [identity(), identity()];
    std::fs::write(&name, table(0.26)).unwrap();
    assert!(
        before[0] == before[1] && identity() != before[0],
        "{before:?}"
    );
    let output = search();
    assert!(
        output.status == 2 && output.err.contains("its setup, search or options differ"),
        "{}",
        output.err
    );
    // two tables are two different laws, although both laws are named `table`
    std::fs::write(file("other.csv"), table(0.25)).unwrap();
    for (setup, table) in [("a.toml", "mine.csv"), ("b.toml", "other.csv")] {
        std::fs::write(file(setup), format!("[aero]\ntable = '{table}'\n")).unwrap();
    }
    let (_, found) = json(&["compare", &file("a.toml"), &file("b.toml"), "--of", "carry"]);
    let share = &found["outcomes"][0]["by_parameter"]["shares"][0];
    assert_eq!(
        (&share["cause"], &share["values"][1]),
        (&"aero.law".into(), &file("other.csv").into()),
        "{found}"
    );
}

/// The splines through the nodes have a negative drag below the first node. Spin ratios below 0 do
/// not exist, so this is an error only if the first node is above 0.
#[test]
fn drag_of_a_table_is_not_checked_below_zero_spin() {
    let law = of_table("s,cd,cl\n0,0.02,0\n0.05,0.3,0.1\n0.1,0.32,0.2\n0.2,0.33,0.3\n");
    for (s, drag) in [(0.0, 0.02), (0.05, 0.3), (0.1, 0.32), (0.2, 0.33)] {
        let found: Coefficients<f64> = at(law, [s, 1e5, 50.0]);
        assert!((found.drag - drag).abs() < 1e-12, "{s}: {}", found.drag);
    }
    for s in evenly(0.0, 0.4, 4000) {
        let found: Coefficients<f64> = at(law, [s, 1e5, 50.0]);
        assert!(found.drag > 0.0, "{s}: {}", found.drag);
    }
    let (_folder, name) =
        written("s,cd,cl\n0.1,0.02,0.1\n0.15,0.3,0.1\n0.2,0.32,0.2\n0.3,0.33,0.3\n");
    let message = LawTable::open(Path::new(&name)).unwrap_err().to_string();
    assert!(
        message.contains("negative drag") && message.contains("at spin_ratio 0.0875"),
        "{message}"
    );
}

/// Zero spin is a corner if the drag has a slope there. The clamp below the least spin is half of
/// the first interval wide. If it ends above zero spin, the drag at zero spin is constant. The
/// slopes are difference quotients.
#[test]
fn zero_spin_is_a_corner_if_the_drag_of_the_table_has_a_slope_there() {
    let table = |spins: [f64; 3]| {
        let mut text = "spin [rad/s],cd,cl\n".to_owned();
        for (spin, drag) in spins.into_iter().zip([0.2, 0.25, 0.32]) {
            let lift = if spin == 0.0 { 0.0 } else { 0.1 };
            writeln!(text, "{spin},{drag},{lift}").unwrap();
        }
        text
    };
    let launch = [
        ("launch.ball_speed", "67 m/s"),
        ("launch.launch_angle", "12 deg"),
        ("launch.spin", "0 rpm"),
    ];
    for (text, is_corner) in [
        (table([0.0, 150.0, 400.0]), true),
        (table([20.0, 150.0, 400.0]), true),
        (table([150.0, 300.0, 400.0]), false),
        (
            "speed [mph],cd,cl\n100,0.25,0.15\n150,0.24,0.16\n".into(),
            false,
        ),
    ] {
        let law = of_table(&text);
        let drag = |s: f64| at(law, [s, 1e5, 50.0]).drag;
        let slope = (drag(1e-6) - drag(0.0)) / 1e-6;
        assert_eq!(slope.abs() > 1e-3, is_corner, "{text}: {slope}");
        let mut setup = Setup::modern_driver();
        setup.set_all(launch).unwrap();
        setup.law = law;
        let corners = Drive::new(&setup).unwrap().corners(&setup);
        assert_eq!(corners.len(), usize::from(is_corner), "{text}: {corners:?}");
    }
}

/// The fitted range of a table is the range of its nodes.
#[test]
fn a_drive_beyond_its_table_has_a_warning() {
    let (_folder, name) = written(
        "speed [m/s],spin \
         [rpm],cd,cl\n50,2000,0.25,0.15\n80,2000,0.25,0.15\n50,3000,0.25,0.2\n80,3000,0.25,0.2\n",
    );
    let (_, answer) = json(&["simulate", "--set", &format!("{TABLE}={name}")]);
    let message = answer["warnings"].to_string();
    assert!(
        message.contains("speed through the air of 50 m/s to 80 m/s (the table mine.csv)"),
        "{message}"
    );
    assert!(
        message.contains("where the law is held\"") && !message.contains("extrapolated"),
        "{message}"
    );
    let range = &answer["law_range"];
    assert!(
        range["spin_ratio"].is_null() && range["reynolds"].is_null(),
        "{range}"
    );
    assert!(number(&range["speed"]["share_outside"]) > 0.3, "{range}");
    assert_eq!(
        number(&range["spin"]["fitted"]["high"]),
        100.0 * std::f64::consts::PI
    );
    let table = LawTable::open(Path::new(&name)).unwrap();
    assert_eq!(
        table.axes().map(|axis| axis.variable).collect::<Vec<_>>(),
        [LawVariable::Speed, LawVariable::Spin]
    );
}

#[test]
fn a_factor_of_your_own_table_asks_for_the_table() {
    let output = longdrive(&["laws", "--set", "aero.cd_factor=1.05"]);
    assert_eq!((output.status, output.out.as_str()), (2, ""));
    assert!(
        output.err.contains("--set aero.table=mine.csv") && !output.err.contains("aero.law"),
        "{}",
        output.err
    );
}

#[test]
fn same_table_with_its_rows_in_another_order() {
    let rows = [
        "50,2000,0.25,0.15",
        "80,2000,0.26,0.16",
        "50,3000,0.27,0.2",
        "80,3000,0.28,0.21",
    ];
    let table = |rows: &[&str]| {
        let (_folder, name) = written(&format!(
            "speed [m/s],spin [rpm],cd,cl\n{}\n",
            rows.join("\n")
        ));
        LawTable::open(Path::new(&name)).unwrap()
    };
    let ordered = table(&rows);
    let reversed = table(&rows.map(|row| row).into_iter().rev().collect::<Vec<_>>());
    assert!(ordered == reversed);
    assert_eq!(format!("{ordered:?}"), format!("{reversed:?}"));
    let other = table(&[rows[0], rows[1], rows[2], "80,3000,0.28,0.22"]);
    assert!(ordered != other);
}
