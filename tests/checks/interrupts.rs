//! Ctrl-C: one rule for every command.

#![cfg(unix)]

use crate::command_line::{Output, WHOLE, interrupt};
use crate::program;
use crate::schema::faults;
use longdrive::command::{Host, MessageKind, run};
use longdrive::optimize::Observers;
use longdrive::parameters::SetupFile;
use longdrive::report::{optima_document, optimum_setup};
use longdrive::study::{Search, optima};
use longdrive::units::System;
use longdrive::{Result, Setup};
use serde_json::Value;
use std::fs::File;
use std::io;
use std::process::Child;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;
use tempfile::TempDir;

/// Processor time before Ctrl-C, in hundredths of a second: long enough that the work has begun.
const STARTED_AFTER: u64 = 20;

/// Limit of the processor time after Ctrl-C, in hundredths of a second. Uninterrupted work takes
/// longer.
const LAST: u64 = 1000;

/// A running program. Its output goes into files, so that it can be read meanwhile.
struct AtWork {
    child: Child,
    folder: TempDir,
}

impl AtWork {
    fn new(args: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let [out, err] = ["out", "err"].map(|name| File::create(folder.path().join(name)).unwrap());
        let mut program = program::command();
        Self {
            child: program.args(args).stdout(out).stderr(err).spawn().unwrap(),
            folder,
        }
    }

    fn read(&self, name: &str) -> String {
        String::from_utf8_lossy(&std::fs::read(self.folder.path().join(name)).unwrap()).into_owned()
    }

    /// True if the program has ended, and its processor time in hundredths of a second; `None`
    /// without /proc. A test must call this before it waits for the program, because the system
    /// forgets the time then.
    fn used(&self) -> Option<(bool, u64)> {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.child.id())).ok()?;
        // after the name, /proc/PID/stat has the state, ten numbers, and the times in user mode and
        // in the kernel
        let fields: Vec<&str> = stat.rsplit(')').next()?.split_whitespace().collect();
        let used = fields[11..13]
            .iter()
            .map(|ticks| ticks.parse::<u64>().unwrap())
            .sum();
        Some((fields[0] == "Z", used))
    }

    /// Waits for a condition, or for the end of the program.
    fn wait_until(&mut self, is_time: impl Fn(&Self) -> bool) {
        let has_ended = |program: &mut Self| match program.used() {
            Some((has_ended, _)) => has_ended,
            None => program.child.try_wait().unwrap().is_some(),
        };
        while !has_ended(self) && !is_time(self) {
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    fn has_printed(&self, text: &str) -> bool {
        self.read("err").contains(text)
    }

    fn has_used_time(&self) -> bool {
        self.has_used(STARTED_AFTER)
    }

    fn has_used(&self, hundredths: u64) -> bool {
        match self.used() {
            Some((_, used)) => used >= hundredths,
            None => {
                std::thread::sleep(Duration::from_millis(10 * hundredths));
                true
            }
        }
    }

    /// Presses Ctrl-C and returns the output. The program must end within [`LAST`] of processor
    /// time.
    fn interrupted(mut self) -> Output {
        let before = self.used();
        interrupt(&self.child);
        self.wait_until(|_| false);
        let after = self.used();
        let status = self.child.wait().unwrap();
        let [out, err] = ["out", "err"].map(|name| self.read(name));
        if let (Some((_, before)), Some((_, after))) = (before, after) {
            assert!(
                after - before < LAST,
                "{:.2} s of computing after Ctrl-C: {err}",
                (after - before) as f64 / 100.0
            );
        }
        Output {
            status: status.code().unwrap_or_else(|| panic!("it died: {err}")),
            out,
            err,
        }
    }
}

/// A host that knows whether the work of its command can be interrupted.
#[derive(Default)]
struct Watching {
    is_interruptible: AtomicBool,
    /// True once work was announced.
    was_interruptible: AtomicBool,
    /// True if the answer came while work was still announced.
    is_printed_meanwhile: AtomicBool,
}

impl Host for Watching {
    fn print(&self, _: &str) -> io::Result<()> {
        let meanwhile = self.is_interruptible.load(Ordering::Relaxed);
        self.is_printed_meanwhile
            .store(meanwhile, Ordering::Relaxed);
        Ok(())
    }

    fn say(&self, _: MessageKind, _: &str) {}

    fn can_stop(&self, _: &'static str, _: &Arc<AtomicBool>) {
        self.is_interruptible.store(true, Ordering::Relaxed);
        self.was_interruptible.store(true, Ordering::Relaxed);
    }

    fn cannot_stop(&self) {
        self.is_interruptible.store(false, Ordering::Relaxed);
    }
}

/// After the rows of `delivery`, its population is computed, which cannot be interrupted: Ctrl-C
/// then ends the program. An error ends the work, too.
#[test]
fn no_answer_and_no_error_while_work_is_announced() {
    let folder = tempfile::tempdir().unwrap();
    let shots = folder.path().join("shots.csv");
    let rows = "ball_speed [mph],launch_angle [deg],spin [rpm]\n165,11.2,2500\n168.1,10.4,2380\n";
    std::fs::write(&shots, rows).unwrap();
    let shots = shots.to_str().unwrap();
    for (words, status) in [
        (vec!["delivery", "--shots", shots], 0),
        (vec!["optimize"], 0),
        (vec!["sweep", "no-such-setup"], 2),
    ] {
        let host = Arc::new(Watching::default());
        let line = [&["longdrive"], &words[..]].concat();
        let line = line.into_iter().map(Into::into).collect();
        assert_eq!(run(line, host.clone()), status, "{words:?}");
        let [was, is, printed] = [
            &host.was_interruptible,
            &host.is_interruptible,
            &host.is_printed_meanwhile,
        ]
        .map(|flag| flag.load(Ordering::Relaxed));
        assert_eq!((was, is, printed), (true, false, false), "{words:?}");
    }
}

/// Output of a command that is interrupted as soon as it computes.
pub fn interrupted(args: &[&str]) -> Output {
    let mut program = AtWork::new(args);
    program.wait_until(AtWork::has_used_time);
    program.interrupted()
}

/// The JSON output, checked against its schema in docs/schema.
fn interrupted_json(args: &[&str]) -> Value {
    interrupted_json_once(args, AtWork::has_used_time)
}

/// The JSON output of a command that is interrupted once `is_time` returns true.
fn interrupted_json_once(args: &[&str], is_time: impl Fn(&AtWork) -> bool) -> Value {
    let mut program = AtWork::new(&[args, &["--json"]].concat());
    program.wait_until(is_time);
    let output = program.interrupted();
    let answer: Value = serde_json::from_str(&output.out)
        .unwrap_or_else(|e| panic!("{e}: {} {}", output.out, output.err));
    let faults = faults(args[0], &answer);
    assert!(faults.is_empty(), "{args:?}: {faults:#?} in {answer:#}");
    assert_eq!(
        (output.status, answer["status"].as_str()),
        (1, Some("interrupted")),
        "{args:?}: {answer:#} {}",
        output.err
    );
    answer
}

#[test]
fn work_without_a_part_of_an_answer_ends_with_nothing_printed_or_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (page, plot, study) = (path("page"), path("map.svg"), path("study"));
    let slow = ["--set", "flight.step=0.02ms"];
    for args in [
        vec!["uncertainty", "--samples", "1000000"],
        vec!["sensitivity", "--at-optimum", slow[0], slow[1]],
        vec!["plot", "contour", "-o", &plot, slow[0], slow[1]],
        vec!["report", "-o", &page, slow[0], slow[1]],
        vec!["reproduce", "mae494", "-o", &study],
    ] {
        // `reproduce` takes only a second or two: its printed progress shows that it has begun
        let has_progress = args[0] == "reproduce";
        let is_time = |program: &AtWork| {
            if has_progress {
                program.has_printed("computing")
            } else {
                program.has_used_time()
            }
        };
        let message = interrupted_json_once(&args, is_time)["message"]
            .as_str()
            .unwrap()
            .to_owned();
        assert_eq!(
            message, "interrupted before there was an answer; nothing was printed or written",
            "{args:?}"
        );
        let left = std::fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(left, 0, "{args:?} left something behind");
    }
    let output = interrupted(&["uncertainty", "-q", "--samples", "1000000"]);
    assert!(
        output.status == 1 && output.out.is_empty(),
        "{}",
        output.out
    );
    assert!(
        output
            .err
            .contains("error: interrupted before there was an answer"),
        "{}",
        output.err
    );
}

#[test]
fn finished_parts_of_a_certificate_and_of_a_chart_are_printed_as_interrupted() {
    let found = interrupted_json(&["verify", "--set", "flight.step=0.05ms"]);
    let rows = found["rows"].as_array().unwrap().len();
    let message = found["message"].as_str().unwrap();
    assert!(
        message.starts_with(&format!("the rows are complete for {} of ", rows / 2)),
        "{message}, {rows} rows"
    );
    assert_eq!(found["passed"], false);
    let chart = interrupted_json(&[
        "chart",
        "--along",
        "swing.speed=60mph..140mph",
        "--set",
        "flight.step=0.1ms",
    ]);
    assert!(chart["ended"].as_str().is_some(), "{chart:#}");
    let goals = [
        "pareto",
        "--maximize",
        "carry",
        "--minimize",
        "apex_height",
        "--points",
        "1000",
        "--verbose",
    ];
    // the two ends of the front take four searches; the program prints the number of finished
    // searches every second
    let searches = |text: &str| {
        text.rsplit("following the front: ")
            .next()?
            .split(' ')
            .next()?
            .parse()
            .ok()
    };
    let has_begun =
        |program: &AtWork| searches(&program.read("err")).is_some_and(|searches: u32| searches > 5);
    let front = interrupted_json_once(
        &[&goals[..], &["--set", "flight.step=0.5ms"]].concat(),
        has_begun,
    );
    assert!(
        front["points"]
            .as_array()
            .is_some_and(|points| points.len() > 1),
        "{front:#}"
    );
}

#[test]
fn stopped_work_writes_no_fit_lists_no_optimum_and_names_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (fitted, rows) = (path("fitted.toml"), path("rows.csv"));
    let shots = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let slow = ["--set", "flight.step=0.02ms"];
    let step = "flight.step=0.1ms";
    let fit = [
        "calibrate",
        shots,
        "--fit",
        "aero.cd0",
        "-o",
        &fitted,
        "--set",
        step,
    ];
    let found = interrupted_json_once(&fit, |program| program.has_printed("iteration"));
    assert!(
        found["file"].is_null() && found["warnings"].to_string().contains("is not written"),
        "{found:#}"
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    let so_far = std::path::PathBuf::from(format!("{rows}.part"));
    let sweep = [
        "sweep",
        "--over",
        "club.loft=5deg..15deg:3000000",
        "-o",
        &rows,
    ];
    let found = interrupted_json_once(&sweep, |_| so_far.exists());
    assert_eq!(found["file"].as_str(), so_far.to_str());
    assert!(so_far.exists());
    let output = interrupted(&["optimize", "--starts", "5000", slow[0], slow[1]]);
    assert!(
        output
            .out
            .contains("\nnot listed: 5000 of 5000 searches stopped before the end\n"),
        "{}",
        output.out
    );
    assert!(
        !output.out.contains(" of 5000  interrupted"),
        "{}",
        output.out
    );
}

/// The best of the searches that ended may have converged. The setup file still says that other
/// searches were stopped.
#[test]
fn a_setup_file_of_the_best_so_far_says_that_searches_were_stopped() -> Result<()> {
    let setup = Setup::modern_driver();
    let search = Search::longest_drive(&setup)?;
    let (stop, ended) = (Arc::new(AtomicBool::new(false)), AtomicUsize::new(0));
    let flag = stop.clone();
    let end = move |_: usize, _: &_| {
        flag.store(
            ended.fetch_add(1, Ordering::Relaxed) >= 3,
            Ordering::Relaxed,
        )
    };
    let follow = Observers {
        interrupt: stop,
        end: Some(Arc::new(end)),
        ..Observers::default()
    };
    let found = optima(&setup, &search, 400, &follow)?;
    let stopped = found.stopped();
    let file = SetupFile::of_preset("modern-driver")?;
    assert!(
        stopped > 0 && found.best.status() == "converged",
        "{stopped}"
    );
    let listed = optima_document(&found, System::Metric).text(&WHOLE);
    assert!(
        listed.contains(&format!(
            "\nnot listed: {stopped} of 400 searches stopped before the end\n"
        )),
        "{listed}"
    );
    assert!(
        !listed.contains("interrupted") && listed.contains("converged"),
        "{listed}"
    );
    let text =
        optimum_setup(&found.best, None, found.interrupted(), &file, System::Us).toml(&file)?;
    let ended = 400 - stopped;
    let line = format!(
        "\n# interrupted: {ended} of 400 searches ended, and {stopped} were stopped before their \
         end; the best so far:\n# converged: "
    );
    assert!(text.contains(&line), "{text}");
    let found = optima(&setup, &search, 4, &Observers::default())?;
    let whole =
        optimum_setup(&found.best, None, found.interrupted(), &file, System::Us).toml(&file)?;
    assert!(
        !whole.contains("interrupted") && whole.contains("\n# converged: "),
        "{whole}"
    );
    Ok(())
}

#[test]
fn shots_flown_before_the_interruption_are_counted_and_no_file_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let row = |at: usize| format!("{},12,{}\n", 140 + at % 40, 2000 + at % 1000);
    let rows: String = (0..200_000).map(row).collect();
    std::fs::write(
        path("shots.csv"),
        format!("ball_speed [mph],launch_angle [deg],backspin [rpm]\n{rows}"),
    )
    .unwrap();
    // until all rows are flown, they are in a file of another name
    let names = || -> Vec<_> {
        std::fs::read_dir(folder.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect()
    };
    let has_rows = |_: &AtWork| {
        let others = names().into_iter().filter(|name| name != "shots.csv");
        others
            .map(|name| folder.path().join(name))
            .any(|file| std::fs::metadata(file).is_ok_and(|file| file.len() > 1000))
    };
    let fly = [
        "fly",
        &path("shots.csv"),
        "-o",
        &path("flown.csv"),
        "--set",
        "flight.step=2ms",
    ];
    let found = interrupted_json_once(&fly, has_rows);
    let flown = found["rows"].as_u64().unwrap();
    assert!((1..200_000).contains(&flown), "{flown}");
    assert_eq!(
        found["message"],
        format!(
            "stopped after {flown} rows; {} is not written",
            path("flown.csv")
        )
    );
    assert_eq!(names(), ["shots.csv"]);
}

/// An evaluation over 50,000 swings takes seconds. Ctrl-C stops it between two swings.
#[test]
fn searches_over_very_many_swings_are_interrupted_within_an_evaluation() {
    let swings = [
        "--scenarios",
        "50000",
        "--distribution",
        "swing.speed=normal(110mph,3mph)",
    ];
    let swings = [
        &swings[..],
        &["--distribution", "swing.path=normal(0deg,2deg)"],
    ]
    .concat();
    let goals = ["--maximize", "mean(carry)", "--minimize", "std(lateral)"];
    for args in [
        vec!["optimize"],
        vec!["design"],
        vec!["robust"],
        [&["pareto"], &goals[..]].concat(),
    ] {
        let after = |hundredths| {
            let found = interrupted_json_once(&[&args[..], &swings].concat(), |program| {
                program.has_used(hundredths)
            });
            (found["message"].as_str().unwrap().to_owned(), found)
        };
        // if Ctrl-C came before the search began, repeat with a later Ctrl-C
        let mut within = [1, 2, 4, 8, 16, 32]
            .map(|times| times * STARTED_AFTER)
            .into_iter()
            .map(after);
        let (message, found) = within
            .find(|(message, _)| !message.contains("before there was an answer"))
            .unwrap();
        assert!(message.contains("stopped"), "{found:#}");
        // a point without a value is not the optimum
        assert_eq!(
            found["optimum"].is_object(),
            found["value"].is_number(),
            "{found:#}"
        );
    }
}

#[test]
fn same_answer_over_swings_after_repeated_ctrl_c() {
    let folder = tempfile::tempdir().unwrap();
    let swings = [
        "--distribution",
        "swing.path=normal(0deg,2deg)",
        "--distribution",
        "swing.speed=normal(110mph,3mph)",
    ];
    let vary = [
        "--vary",
        "club.loft=4deg..20deg",
        "--vary",
        "club.bulge_radius=200mm..600mm",
    ];
    let goal = [
        "--scenarios",
        "4000",
        "--maximize",
        "mean(carry) - 0.5*std(lateral)",
    ];
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (alone, stopped) = (path("alone.json"), path("stopped.json"));
    let requested = |checkpoint| {
        [
            &["optimize", "--json"],
            &swings[..],
            &vary,
            &goal,
            &["--checkpoint", checkpoint],
        ]
        .concat()
    };
    let alone = crate::command_line::longdrive(&requested(&alone));
    assert_eq!(alone.status, 0, "{}", alone.err);
    // the first round interrupts as soon as the checkpoint file exists; each later round waits for
    // one more saved iteration, and interrupts the iteration after it
    for round in 0..4 {
        let kept = || std::fs::read(&stopped).ok();
        let before = kept();
        let mut program = AtWork::new(&requested(&stopped));
        program.wait_until(|_| {
            if round == 0 {
                kept().is_some()
            } else {
                kept() != before
            }
        });
        let output = program.interrupted();
        assert!(
            output.status == 0 || output.status == 1,
            "round {round}: {}",
            output.err
        );
    }
    assert_eq!(
        crate::command_line::longdrive(&requested(&stopped)).out,
        alone.out
    );
}
