//! The program for a user: answers, JSON, exit statuses, and messages for bad input.

use crate::common::close;
pub use crate::common::number;
use crate::program;
use crate::schema::faults;
use longdrive::report::TextOptions;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::Duration;

/// Options of a complete text, at the terminal width of the tests.
pub const WHOLE: TextOptions = TextOptions {
    width: 100,
    all: true,
    verbose: true,
};

pub struct Output {
    pub status: i32,
    pub out: String,
    pub err: String,
}

/// Waits until `is_time` returns true, or until the program ends.
pub fn wait_until(child: &mut Child, is_time: impl Fn() -> bool) {
    while !is_time() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Presses Ctrl-C in a program.
#[cfg(unix)]
pub fn interrupt(child: &Child) {
    let mut kill = Command::new("kill");
    let kill = kill.args(["-INT", &child.id().to_string()]);
    assert!(kill.status().unwrap().success());
}

/// Output of a command, and the files that it writes into a new folder.
pub struct Written {
    pub output: Output,
    files: BTreeMap<String, String>,
}

impl Written {
    pub fn file(&self, name: &str) -> &str {
        self.files
            .get(name)
            .unwrap_or_else(|| panic!("no {name} in {:?}: {}", self.files.keys(), self.output.err))
    }
}

/// Runs a command that writes text into a new folder.
pub fn written(args: &[&str]) -> Written {
    let folder = tempfile::tempdir().unwrap();
    let into = folder.path().join("new");
    let printed = longdrive(&[args, &["-o", into.to_str().unwrap()]].concat());
    let entries =
        std::fs::read_dir(&into).unwrap_or_else(|error| panic!("{error}: {}", printed.err));
    let read = |path: PathBuf| {
        (
            path.file_name().unwrap().to_str().unwrap().to_owned(),
            String::from_utf8_lossy(&std::fs::read(&path).unwrap()).into_owned(),
        )
    };
    let files = entries.map(|entry| read(entry.unwrap().path())).collect();
    Written {
        output: printed,
        files,
    }
}

pub fn longdrive(args: &[&str]) -> Output {
    let output = program::command().args(args).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Output {
        status: output.status.code().unwrap(),
        out: text(output.stdout),
        err: text(output.stderr),
    }
}

/// The answer in JSON, checked against its schema in docs/schema.
pub fn json(args: &[&str]) -> (i32, Value) {
    let printed = longdrive(&[args, &["--json"]].concat());
    let answer = serde_json::from_str(&printed.out)
        .unwrap_or_else(|e| panic!("{e}: {} {}", printed.out, printed.err));
    let faults = faults(args[0], &answer);
    assert!(
        faults.is_empty(),
        "{args:?}: {faults:#?} in {answer:#}; if a type of the answer has changed, write docs/schema \
         with LONGDRIVE_WRITE_SCHEMAS=1 cargo test --features full schemas"
    );
    (printed.status, answer)
}

/// The commands that run without a terminal.
pub fn commands() -> BTreeSet<String> {
    let commands = longdrive::command::described();
    let name = |command: &Value| command["name"].as_str().unwrap().to_owned();
    commands.as_array().unwrap().iter().map(name).collect()
}

pub fn on_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The number of characters of the longest line.
pub fn widest(text: &str) -> usize {
    text.lines()
        .map(|line| line.chars().count())
        .max()
        .unwrap_or(0)
}

pub fn file_with(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

#[test]
fn independent_mae494_optimum_as_json() {
    let ranges = [
        "--vary",
        "club.loft=0deg..20deg",
        "--vary",
        "swing.attack_angle=-10deg..10deg",
    ];
    let (status, found) = json(&[&["optimize", "mae494"], ranges.as_slice()].concat());
    assert_eq!(
        (
            status,
            found["status"].as_str().unwrap(),
            found["objective"].as_str().unwrap()
        ),
        (0, "converged", "carry")
    );
    close(
        number(&found["optimum"]["club.loft"]).to_degrees(),
        14.682_923,
        1.0,
        1e-6,
        "loft",
    );
    assert_eq!(
        number(&found["optimum"]["swing.attack_angle"]),
        10.0_f64.to_radians()
    );
    close(number(&found["value"]), 153.333_553, 1.0, 1e-6, "carry");
    close(
        number(&found["multipliers"]["swing.attack_angle"]["upper"]),
        60.2925,
        1.0,
        5e-5,
        "multiplier",
    );
    assert_eq!(number(&found["multipliers"]["club.loft"]["upper"]), 0.0);
    assert!(number(&found["kkt_residual"]) <= 1e-10 && number(&found["iterations"]) <= 15.0);
    assert_eq!(found["constraints"], serde_json::json!([]));
    let keys: Vec<_> = found
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    for key in ["message", "gradient", "evaluations", "warnings"] {
        assert!(keys.contains(&key), "{keys:?}");
    }
}

#[test]
fn published_shot_of_winfield_and_tan_as_json() {
    let set = [
        "--set",
        "swing.speed=103 mph",
        "--set",
        "club.loft=10deg",
        "--set",
        "swing.attack_angle=0deg",
    ];
    let (status, drive) = json(&[&["simulate", "winfield-tan"], set.as_slice()].concat());
    assert_eq!((status, drive["status"].as_str()), (0, Some("landed")));
    let mph = 0.44704;
    close(
        number(&drive["launch"]["velocity"][2]) / mph,
        139.20,
        1.0,
        5e-3,
        "downrange",
    );
    close(
        number(&drive["launch"]["velocity"][0]) / mph,
        19.85,
        1.0,
        5e-3,
        "up",
    );
    close(
        number(&drive["launch"]["spin"]) / std::f64::consts::TAU,
        38.57,
        1.0,
        5e-3,
        "spin",
    );
    close(
        number(&drive["club_after"]["velocity"][2]) / mph,
        71.39,
        1.0,
        5e-3,
        "club",
    );
    assert_eq!(drive["setup"]["aero.law"], "winfield-tan");
    assert_eq!(drive["setup"]["club.bulge_radius"], "inf");
    assert_eq!(drive["setup"]["impact.friction"], Value::Null);
    assert!(number(&drive["flight"]["carry"]) > 150.0);
}

#[test]
fn independent_mae494_derivatives_as_json() {
    let (status, answer) = json(&["gradient", "mae494", "--hessian"]);
    let answer = &answer["outcomes"][0];
    assert_eq!((status, answer["of"].as_str()), (0, Some("carry")));
    close(
        number(&answer["value"]),
        114.312855130798,
        114.0,
        1e-12,
        "value",
    );
    close(
        number(&answer["gradient"]["club.loft"]),
        336.769746388603,
        336.0,
        1e-11,
        "d/d loft",
    );
    close(
        number(&answer["gradient"]["swing.attack_angle"]),
        298.564796806673,
        298.0,
        1e-11,
        "d/d attack",
    );
    assert_eq!(
        answer["hessian"]["names"],
        serde_json::json!(["club.loft", "swing.attack_angle"])
    );
    let expected = [
        [-3068.07279459, -1950.16104589],
        [-1950.16104589, -1588.91207472],
    ];
    for (i, row) in expected.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            close(
                number(&answer["hessian"]["values"][i][j]),
                *entry,
                entry.abs(),
                1e-9,
                "Hessian",
            );
        }
    }
}

#[test]
fn jacobian_and_gradient_by_all_parameters() {
    let (_, answer) = json(&["gradient", "--of", "carry,lateral", "--wrt", "all"]);
    let rows = answer["outcomes"].as_array().unwrap();
    assert_eq!((rows.len(), rows[1]["of"].as_str()), (2, Some("lateral")));
    assert!(rows[0]["gradient"].as_object().unwrap().len() > 35);
    let printed = longdrive(&["gradient", "--wrt", "all", "--verbose"]);
    assert!(
        printed.err.contains("left out, because they have no value")
            && printed.err.contains("ball.inertia"),
        "{}",
        printed.err
    );
    assert!(
        printed.out.contains("yd per deg") && printed.out.contains("m per rad"),
        "{}",
        printed.out
    );
}

#[test]
fn the_default_search_converges_and_reads_like_an_answer() {
    let printed = longdrive(&["optimize", "--verbose"]);
    assert_eq!(printed.status, 0);
    for words in [
        "converged: ",
        "KKT residual",
        "club.loft",
        "at its upper bound: +2.13 yd for each degree",
        "carry   300.4 yd (274.7 m)",
        "ball speed 171.1 mph",
        "lateral 0.0 yd",
    ] {
        assert!(
            printed.out.contains(words),
            "no '{words}' in {}",
            printed.out
        );
    }
    assert!(
        printed.err.contains("trust region"),
        "iterations on standard error: {}",
        printed.err
    );
}

#[test]
fn a_wide_search_whose_optimum_is_at_a_corner_says_so() {
    let ranges = [
        "--vary",
        "club.loft=-5deg..20deg",
        "--vary",
        "swing.attack_angle=0deg..60deg",
    ];
    let (status, found) = json(&[&["optimize", "mae494"], ranges.as_slice()].concat());
    assert_eq!(
        (status, found["status"].as_str().unwrap()),
        (0, "converged")
    );
    assert!(
        found["message"]
            .as_str()
            .unwrap()
            .contains("corner at club.loft"),
        "{found}"
    );
    close(number(&found["value"]), 170.574, 1.0, 1e-3, "carry");
    assert_eq!(found["warnings"].as_array().unwrap().len(), 1);
    // slopes of +83.72 and −29.66 m/rad (docs/model.md)
    let text = on_one_line(&longdrive(&[&["optimize", "mae494"], ranges.as_slice()].concat()).out);
    let state = "at a corner: -1.6 yd for each degree below it, -0.566 yd for each degree above it";
    assert!(text.contains(state), "{text}");
}

#[test]
fn no_flight_is_an_outcome_with_status_one_and_never_a_carry() {
    let set = ["--set", "swing.attack_angle=-20deg"];
    let (status, drive) = json(&[&["simulate"], set.as_slice()].concat());
    assert_eq!(
        (status, drive["status"].as_str(), &drive["flight"]),
        (1, Some("no-flight"), &Value::Null)
    );
    assert!(number(&drive["launch"]["ball_speed"]) > 50.0);
    let printed = longdrive(&["simulate", "--set", "swing.attack_angle=-20deg"]);
    assert!(
        printed.status == 1 && printed.out.contains("no flight: the ball leaves at -"),
        "{}",
        printed.out
    );
    let (status, gradient) = json(&[&["gradient"], set.as_slice()].concat());
    assert_eq!(
        (
            status,
            &gradient["outcomes"][0]["value"],
            &gradient["outcomes"][0]["gradient"]
        ),
        (1, &Value::Null, &Value::Null)
    );
    let (status, found) = json(&["optimize", "--vary", "swing.attack_angle=-40deg..-30deg"]);
    assert_eq!(
        (status, found["status"].as_str(), &found["optimum"]),
        (1, Some("no-flight"), &Value::Null)
    );
}

#[test]
fn bad_input_gets_status_two_and_a_message_that_helps() {
    for (args, says) in [
        (
            vec!["simulate", "--set", "club.lofft=10deg"],
            vec!["'club.lofft'", "did you mean 'club.loft'?"],
        ),
        (
            vec!["simulate", "--set", "loft=10deg"],
            vec!["'loft'", "did you mean 'club.loft'?"],
        ),
        (
            vec!["simulate", "--set", "club.loft=10 kg"],
            vec!["club.loft", "\"10 kg\" is not an angle", "deg"],
        ),
        (
            vec!["simulate", "--set", "club.loft=10 dg"],
            vec!["unknown unit 'dg'", "deg"],
        ),
        (
            vec!["simulate", "--set", "club.loft=10"],
            vec!["\"10\" has no unit; an angle takes deg, rad"],
        ),
        (
            vec!["simulate", "--set", "ground.height=100MM"],
            vec!["unknown unit 'MM' (did you mean 'mm'?)"],
        ),
        (
            vec!["simulate", "--tolerance", "1mm"],
            vec!["joined to its option by '='", "--tolerance=1mm"],
        ),
        (
            vec!["simulate", "--tolerance", "1 mm"],
            vec!["as in --tolerance=1mm"],
        ),
        (
            vec!["simulate", "--tolerance=1e-30m"],
            vec!["give a larger tolerance"],
        ),
        (
            vec!["simulate", "-"],
            vec!["standard input: it is empty", "name a preset"],
        ),
        (
            vec!["fly", "tour-average", "shots.csv"],
            vec!["the shots come first, as in longdrive fly shots.csv"],
        ),
        (
            vec!["simulate", "--set", "swing.speed=100"],
            vec!["\"100\" has no unit; a speed takes mph"],
        ),
        (
            vec!["simulate", "--set", "club.loft"],
            vec!["--set club.loft", "NAME=VALUE"],
        ),
        (
            vec!["simulate", "--set", "swing.speed=nan"],
            vec!["nan", "is not a number"],
        ),
        (
            vec!["simulate", "--set", "swing.speed=inf"],
            vec!["inf", "finite"],
        ),
        (
            vec!["simulate", "--set", "club.mass=10 kg"],
            vec!["10 kg", "50 g ≤ … ≤ 2000 g", "at most 2000 g"],
        ),
        (
            vec!["simulate", "--set", "swing.speed=none"],
            vec!["swing.speed", "it cannot be unset; give it a value"],
        ),
        (
            vec!["simulate", "--set", "aero.law=robinsn"],
            vec!["did you mean 'robinson'?", "launch-monitor"],
        ),
        (
            vec!["simulate", "--set", "aero.cd=0.3"],
            vec!["'aero.cd'", "linear", "aero.law"],
        ),
        (
            vec!["simulate", "--set", "club.inertia.xy=9000 g cm^2"],
            vec!["not positive definite", "-4.1"],
        ),
        (
            vec![
                "simulate",
                "--set",
                "strike.toe=190 mm",
                "--set",
                "club.face_semi_axis=40 mm",
            ],
            vec!["off the face", "190 mm"],
        ),
        (
            vec![
                "simulate",
                "--set",
                "swing.face_angle=80deg",
                "--set",
                "swing.path=-80deg",
            ],
            vec!["does not strike the ball", "mph"],
        ),
        (
            vec!["simulate", "winfeld-tan"],
            vec!["did you mean 'winfield-tan'?"],
        ),
        (
            vec![
                "simulate",
                "--set",
                "swing.path=1deg",
                "--set",
                "ground.height=-20",
                "m",
            ],
            vec![
                "unknown setup 'm'",
                "with a space in quotes, as in --set \"ground.height=-20 m\"",
            ],
        ),
        (
            vec!["optimize", "--set=swing.speed=100", "mph", "modern-driver"],
            vec![
                "unexpected argument",
                "with a space in quotes, as in --set \"swing.speed=100 mph\"",
            ],
        ),
        (
            vec!["sweep", "--over", "swing.speed=90", "mph..100", "mph:3"],
            vec!["with a space in quotes, as in --over \"swing.speed=90 mph..100 mph:3\""],
        ),
        (
            vec![
                "simulate",
                "--launch",
                "ball_speed=160",
                "mph,launch_angle=11deg,backspin=2600rpm",
            ],
            vec![
                "unknown setup",
                "with a space in quotes, as in --launch \"ball_speed=160 \
                 mph,launch_angle=11deg,backspin=2600rpm\"",
            ],
        ),
        (
            vec!["simulate", "mae494", "--tolerance", "1mm"],
            vec!["joined to its option by '=', as in --tolerance=1mm\n"],
        ),
        (
            vec!["simulate", "--set", "swing.speed=103mph", "club.loft=10deg"],
            vec!["each value needs its own option: write --set NAME=VALUE"],
        ),
        (
            vec![
                "optimize",
                "mae494",
                "--vary",
                "club.loft=4deg..20deg",
                "swing.attack_angle=-5deg..5deg",
            ],
            vec![
                "each range needs its own option: write --vary NAME=LOW..HIGH or --over NAME=LOW..HIGH",
            ],
        ),
        (
            vec!["delivery", "examples/shots.csv"],
            vec!["examples/shots.csv: a table is no setup", "--shots"],
        ),
        (
            vec!["optimize", "examples/deliveries.csv"],
            vec!["a table is no setup", "--swings"],
        ),
        (
            vec!["--quiet", "optimize", "examples/deliveries.csv"],
            vec!["a table is no setup; give a table of swings with --swings FILE"],
        ),
        (
            vec!["--units", "metric", "delivery", "examples/shots.csv"],
            vec!["a table is no setup; give a table of shots with --shots FILE"],
        ),
        (
            vec!["simulate", "drives.parquet"],
            vec!["drives.parquet: a table is no setup\n"],
        ),
        (
            vec![
                "optimize",
                "--vary",
                "club.loft=-4",
                "deg..20",
                "deg",
                "-o",
                "best.toml",
            ],
            vec!["with a space in quotes, as in --vary \"club.loft=-4 deg..20 deg\"\n"],
        ),
        (
            vec!["simulate", "no/such/file.toml"],
            vec!["no/such/file.toml", "modern-driver"],
        ),
        (
            vec!["gradient", "--wrt", "club.lof"],
            vec!["did you mean 'club.loft'?"],
        ),
        (
            vec!["gradient", "--of", "cary"],
            vec!["unknown outcome 'cary'", "did you mean 'carry'?"],
        ),
        (
            vec!["gradient", "--wrt", "flight.step"],
            vec!["flight.step", "setting"],
        ),
        (
            vec!["gradient", "--wrt", "ball.inertia"],
            vec!["ball.inertia", "unset", "--set"],
        ),
        (
            vec!["gradient", "mae494", "--wrt", "club.bulge_radius"],
            vec!["infinite", "--set"],
        ),
        (
            vec!["gradient", "--wrt", ""],
            vec!["nothing to differentiate by"],
        ),
        (
            vec!["compare", "--set-b", "club.loft=9deg", "--of", ""],
            vec!["nothing to evaluate"],
        ),
        (
            vec!["optimize", "--vary", "club.loft=20deg..4deg"],
            vec!["reversed", "4deg..20deg"],
        ),
        (
            vec!["optimize", "--vary", "club.loft=4deg..4deg"],
            vec!["nothing to vary"],
        ),
        (
            vec!["optimize", "--vary", "club.loft=4deg"],
            vec!["LOW..HIGH"],
        ),
        (
            vec!["optimize", "--vary", "club.loft"],
            vec!["NAME=LOW..HIGH"],
        ),
        (
            vec!["optimize", "--vary", "club.loft=4..20"],
            vec!["\"20\" has no unit; an angle takes deg, rad"],
        ),
        (
            vec!["optimize", "--vary", "club.loft=4deg..200deg"],
            vec!["200 deg", "less than 90 deg"],
        ),
        (
            vec!["optimize", "--vary", "club.bulge_radius=0.1m..inf"],
            vec!["finite"],
        ),
        (
            vec![
                "optimize",
                "--vary",
                "club.loft=4deg..9deg",
                "--vary",
                "club.loft=4deg..9deg",
            ],
            vec!["varied twice"],
        ),
        (
            vec!["optimize", "--maximize", "distance"],
            vec!["unknown outcome 'distance'"],
        ),
        (vec!["presets", "mae44"], vec!["did you mean 'mae494'?"]),
        (vec!["soar"], vec!["unrecognized subcommand"]),
    ] {
        let printed = longdrive(&args);
        assert_eq!(printed.status, 2, "{args:?}: {}", printed.err);
        assert_eq!(printed.out, "", "{args:?}");
        for words in says {
            assert!(
                printed.err.contains(words),
                "{args:?}: no '{words}' in {}",
                printed.err
            );
        }
    }
}

#[test]
fn a_setup_file_is_read_and_its_mistakes_are_placed() {
    let file = |text: &str| {
        let mut file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
        file.write_all(text.as_bytes()).unwrap();
        file
    };
    let good = file(
        "preset = \"modern-driver\"\n[swing]\nspeed = \"110 mph\"\nattack_angle = \"3 \
         deg\"\n[club]\nloft = \"10.5 deg\"\n\
         inertia = \
         { xx = \"5679 g cm^2\", yy = \"4085 g cm^2\", zz = \"2843 g cm^2\" }\n[aero]\nlaw = \
         \"robinson\"\ncd0 = 0.3\n",
    );
    let path = good.path().to_str().unwrap();
    let (status, drive) = json(&["simulate", path]);
    assert_eq!(
        (status, drive["setup"]["aero.law"].as_str()),
        (0, Some("robinson"))
    );
    close(
        number(&drive["setup"]["club.loft"]),
        10.5_f64.to_radians(),
        1.0,
        1e-15,
        "loft",
    );
    close(
        number(&drive["setup"]["club.inertia.xx"]),
        5.679e-4,
        1e-3,
        1e-15,
        "inertia",
    );
    let (_, moved) = json(&["simulate", path, "--set", "aero.cd0=0.2"]);
    assert!(number(&moved["flight"]["carry"]) > number(&drive["flight"]["carry"]));

    for (text, says) in [
        (
            "[club]\nlofft = \"10 deg\"\n",
            vec![":2:1:", "did you mean 'club.loft'?"],
        ),
        ("[club]\nloft = \"10 kg\"\n", vec![":2:8:", "not an angle"]),
        ("[club]\nloft = \"10\"\n", vec![":2:8:", "no unit"]),
        ("[club\nloft = 1\n", vec!["line 1"]),
        ("preset = \"nobody\"\n", vec![":1:10:", "unknown preset"]),
    ] {
        let bad = file(text);
        let printed = longdrive(&["simulate", bad.path().to_str().unwrap()]);
        assert_eq!(printed.status, 2, "{text}");
        for words in says {
            assert!(
                printed.err.contains(words),
                "{text}: no '{words}' in {}",
                printed.err
            );
        }
    }
    let directory = tempfile::tempdir().unwrap();
    assert_eq!(
        longdrive(&["simulate", directory.path().to_str().unwrap()]).status,
        2
    );
}

#[test]
fn a_tensor_that_breaks_the_triangle_is_flown_with_a_warning() {
    let set = [
        "simulate",
        "modern-driver",
        "--set",
        "club.inertia.yy=20000 g cm^2",
    ];
    let printed = longdrive(&set);
    assert!(
        printed.status == 0 && printed.err.contains("warning: club.inertia"),
        "{}",
        printed.err
    );
    assert_eq!(json(&set).1["warnings"].as_array().unwrap().len(), 1);
}

#[test]
fn parameters_lists_every_row_with_unit_range_default_and_meaning() {
    let (_, listing) = json(&["parameters"]);
    let rows = listing["parameters"].as_array().unwrap();
    assert!(rows.len() > 55);
    let loft = rows
        .iter()
        .find(|row| row["parameter"] == "club.loft")
        .unwrap();
    assert_eq!(
        (loft["unit"].as_str(), loft["shown_in"].as_str()),
        (Some("rad"), Some("deg"))
    );
    close(
        number(&loft["range"]["high"]),
        std::f64::consts::FRAC_PI_2,
        1.0,
        1e-15,
        "range",
    );
    assert!(
        rows.iter()
            .all(|row| !row["doc"].as_str().unwrap().is_empty()
                && !row["source"].as_str().unwrap().is_empty())
    );
    let text = longdrive(&["parameters", "mae494", "--all"]).out;
    for words in [
        "club.loft",
        "9.8 deg",
        "10 deg",
        "aero.law = robinson here",
        "aero.cl_exp",
        "flight.step",
    ] {
        assert!(text.contains(words), "{words}");
    }
}

#[test]
fn presets_print_as_setup_files_with_sources() {
    assert!(longdrive(&["presets"]).out.contains("winfield-tan"));
    let text = longdrive(&["presets", "winfield-tan"]).out;
    assert!(
        text.contains("mass = \"203 g\" # Winfield & Tan (1994)"),
        "{text}"
    );
    let mut file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    file.write_all(text.as_bytes()).unwrap();
    let setup = |name: &str| json(&["simulate", name]).1["setup"].clone();
    assert_eq!(setup(file.path().to_str().unwrap()), setup("winfield-tan"));
    let (_, all) = json(&["presets"]);
    assert_eq!(all["presets"].as_array().unwrap().len(), 6);
}

#[test]
fn drives_at_the_limits_of_the_ranges_fly() {
    for set in [
        ["--set", "air.density=0kg/m^3"],
        ["--set", "club.bulge_radius=inf"],
        ["--set", "club.loft=-3deg"],
        ["--set", "impact.restitution=1"],
        ["--set", "club.mass=50 g"],
        ["--set", "club.mass=2 kg"],
        ["--set", "gravity=1.62m/s^2"],
        ["--set", "aero.spin_damping=2e-5"],
        ["--set", "wind.roughness=10 mm"],
        ["--set", "impact.friction=0"],
    ] {
        let args = [
            &["simulate", "--set", "swing.attack_angle=12deg"],
            set.as_slice(),
        ]
        .concat();
        let (status, drive) = json(&args);
        assert_eq!(
            (status, drive["status"].as_str()),
            (0, Some("landed")),
            "{set:?}"
        );
        let text = drive.to_string();
        assert!(!text.contains("NaN") && !text.contains("nan"), "{text}");
    }
}

#[test]
fn whole_numbers_of_options_are_refused_with_option_value_range_and_example() {
    for (command, option, value, says) in [
        (
            &["sweep", "--over", "club.loft=5deg..15deg:3"][..],
            "--threads",
            "x",
            "a whole number of 0 or more; write for example --threads 4",
        ),
        (
            &["sweep", "--over", "club.loft=5deg..15deg"],
            "--sample",
            "0",
            "a whole number of 1 or more; write for example --sample 1000",
        ),
        (
            &["uncertainty"],
            "--seed",
            "-1",
            "a whole number of 0 or more; write for example --seed 7",
        ),
        (
            &["uncertainty"],
            "--samples",
            "1",
            "a whole number from 2 to 1000000; write for example --samples 4096",
        ),
        (
            &["optimize"],
            "--starts",
            "1.5",
            "a whole number of 1 or more (at most 4294967295); write for example --starts 8",
        ),
        (
            &["optimize"],
            "--max-iterations",
            "many",
            "a whole number of 0 or more; write for example --max-iterations 200",
        ),
        (
            &["plot", "contour", "-o", "a.svg"],
            "--width",
            "10",
            "a whole number from 240 to 4000; write for example --width 800",
        ),
        (
            &["calibrate", "a.csv", "--fit", "aero.cd0"],
            "--folds",
            "-2",
            "a whole number of 0 or more (at most 4294967295)",
        ),
    ] {
        let printed = longdrive(&[command, &[option, value]].concat());
        assert_eq!(printed.status, 2, "{option} {value}: {}", printed.err);
        for word in [option, value, says] {
            assert!(
                printed.err.contains(word),
                "{option} {value}: '{word}' is not in {}",
                printed.err
            );
        }
        assert!(!printed.err.contains("invalid digit"), "{}", printed.err);
    }
}

/// A flight that diverges ends with an error, in a single drive and in a sweep. The message advises
/// a shorter step only if the step is long.
#[test]
fn a_flight_that_diverges_ends_with_status_one_everywhere() {
    for (set, says, says_not) in [
        ("flight.step=2s", "reduce flight.step", "ordinary"),
        ("air.density=900kg/m^3", "air.density", "reduce flight.step"),
        ("ball.mass=0.1g", "ball.mass", "reduce flight.step"),
    ] {
        let set = ["--set", set];
        let printed = longdrive(&[&["simulate"], &set[..]].concat());
        assert!(
            printed.status == 1 && printed.err.contains("the flight diverged at t = "),
            "{set:?}: {}",
            printed.err
        );
        assert!(
            printed.err.contains(says) && !printed.err.contains(says_not),
            "{set:?}: {}",
            printed.err
        );
        let (status, answer) = json(&[&["simulate"], &set[..]].concat());
        assert_eq!((status, answer["status"].as_str()), (1, Some("diverged")));
        let sweep = longdrive(
            &[
                &["sweep", "--own-step", "--over", "gravity=9m/s^2..10m/s^2:2"],
                &set[..],
            ]
            .concat(),
        );
        assert!(
            sweep.status == 1 && sweep.err.contains("2 diverged"),
            "{set:?}: {}",
            sweep.err
        );
        let (status, answer) = json(&[&["gradient"], &set[..]].concat());
        assert_eq!((status, answer["status"].as_str()), (1, Some("diverged")));
    }
}
