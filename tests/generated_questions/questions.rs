//! Questions of users: a command line with its files.

use crate::chance::Chance;
use crate::files::{binary, change, export, messages, points, setup, shots};
use crate::values::{
    constraint, distribution, list, name_of, near, outcome, preset, range, setting, sigma,
    statistic, variable, with_unit,
};
use longdrive::parameters::{Law, Parameter};
use std::sync::LazyLock;

/// A question: a command line, with its input files and its outputs.
#[derive(Debug, Default)]
pub struct Question {
    /// The arguments.
    pub args: Vec<String>,
    /// Input files.
    pub files: Vec<(String, Vec<u8>)>,
    /// Links to input files: the name of the file, and the name of the link.
    pub links: Vec<(String, String)>,
    /// Files and folders that the command line names as outputs.
    pub outputs: Vec<String>,
}

/// The commands that run without a terminal, each with the frequency of its questions.
static COMMANDS: LazyLock<Vec<(&str, f64)>> = LazyLock::new(|| {
    let commands = longdrive::command::described();
    let names = commands.as_array().unwrap().iter().map(|command| {
        let name = command["name"].as_str().unwrap().to_owned();
        &*name.leak()
    });
    names
        .chain(OF_THE_PROGRAM)
        .map(|name| (name, frequency(name)))
        .collect()
});

/// The frequency of the questions of a command. Slow commands are rare.
fn frequency(command: &str) -> f64 {
    match command {
        "simulate" => 22.0,
        "sweep" => 16.0,
        "gradient" => 14.0,
        "optimize" | "calibrate" => 9.0,
        "fly" => 8.0,
        "plot" => 7.0,
        "compare" => 6.0,
        "delivery" | "sensitivity" | "uncertainty" => 5.0,
        "optimum-sensitivity" | "parameters" | "presets" => 3.0,
        "design" => 2.0,
        "chart" => 1.5,
        "verify" => 0.7,
        "laws" | "man" => 0.5,
        "help" => 0.4,
        "pareto" | "robust" | "completions" => 0.3,
        "report" | "validate" => 0.1,
        "reproduce" => 0.01,
        _ => 1.0,
    }
}

/// Commands without a setup, which answer only in text.
const OF_THE_PROGRAM: [&str; 3] = ["help", "completions", "man"];

impl Question {
    pub fn new(chance: &mut Chance) -> Self {
        let frequencies: Vec<f64> = COMMANDS.iter().map(|(_, frequency)| *frequency).collect();
        let command = COMMANDS[chance.weighted(&frequencies)].0;
        let mut question = Self {
            args: vec![command.into()],
            ..Self::default()
        };
        // a file that the question does not name
        question
            .files
            .push(("mine.txt".into(), b"left alone".to_vec()));
        chance.is_launched = !["calibrate", "design", "fly"].contains(&command)
            && chance.is(if command == "simulate" { 0.15 } else { 0.1 });
        chance.is_of_flight = command == "fly" && chance.is(0.8);
        chance.is_over_swings = command == "design" && chance.is(0.8);
        question.ask(command, chance);
        if chance.is(0.5) && !OF_THE_PROGRAM.contains(&command) {
            question.push("--json");
        }
        // these options may also come before the command
        for (option, probability) in [("--units", 0.15), ("--quiet", 0.1)] {
            if chance.is(probability) {
                let at = if chance.is(0.3) {
                    0
                } else {
                    question.args.len()
                };
                let system = chance.of_or(&["metric", "us"], &["si"]).to_owned();
                question.args.splice(
                    at..at,
                    [option.to_owned(), system]
                        .into_iter()
                        .take(2 - usize::from(option == "--quiet")),
                );
            }
        }
        if chance.makes_mistake() {
            let odd = chance.of(&[
                "--bla",
                "-x",
                "--",
                "extra",
                "--help",
                "",
                "--set",
                "--version",
            ]);
            let at = chance.below(question.args.len() + 1);
            question.args.insert(at, odd.into());
        }
        question
    }

    /// The command of the question.
    pub fn command(&self) -> &str {
        let is_command = |arg: &&String| COMMANDS.iter().any(|(name, _)| arg == name);
        self.args.iter().find(is_command).map_or("", String::as_str)
    }

    fn ask(&mut self, command: &str, chance: &mut Chance) {
        match command {
            "laws" => return,
            "presets" => {
                if chance.is(0.6) {
                    let name = preset(chance);
                    self.push(chance.of_or(&[name], &["mae49"]));
                }
                return;
            }
            "validate" => {
                if chance.is(0.3) {
                    self.push("--csv");
                }
                if chance.is(0.3) {
                    self.output("-o", &["study"], chance);
                }
                return;
            }
            "reproduce" => {
                self.push(chance.of_or(&["mae494", "winfield-tan"], &["mae495"]));
                if chance.is(0.5) {
                    self.output("-o", &["study"], chance);
                }
                return;
            }
            "help" | "man" => {
                let named: Vec<&str> = COMMANDS.iter().map(|(name, _)| *name).collect();
                match chance.below(4) {
                    0 if command == "man" => {
                        self.output("-o", &["pages"], chance);
                        if chance.makes_mistake() {
                            self.push("simulate");
                        }
                    }
                    1 => {}
                    2 => self.args.extend(["plot", "contour"].map(str::to_owned)),
                    _ => {
                        let name = chance.of_or(&named, &["optimise", "", "plot contours"]);
                        self.push(name);
                    }
                }
                return;
            }
            "completions" => {
                self.push(chance.of_or(
                    &["bash", "zsh", "fish", "powershell", "elvish"],
                    &["nush", ""],
                ));
                return;
            }
            "calibrate" => self.calibrate(chance),
            "delivery" => self.delivery(chance),
            "plot" => self.plot(chance),
            "sweep" => self.sweep(chance),
            "fly" => self.fly(chance),
            "gradient" => self.gradient(chance),
            "compare" => self.compare(chance),
            "optimize" => {
                self.search(true, chance);
                self.work(chance);
            }
            "design" => {
                self.search(true, chance);
                self.option("--scenarios", chance.of_or(&["2", "9", "16"], &["0", "x"]));
                if chance.is(0.5) {
                    self.option("--rules", chance.of_or(&["golf", "none"], &["usga", ""]));
                }
                self.work(chance);
            }
            "optimum-sensitivity" => self.optimum_sensitivity(chance),
            "chart" => {
                self.search(false, chance);
                if chance.is(0.3) {
                    self.at(chance);
                } else {
                    self.along(chance);
                }
                if chance.is(0.2) {
                    self.push("--csv");
                }
            }
            "robust" => {
                self.search(false, chance);
                if chance.is(0.5) {
                    self.option(
                        "--model",
                        chance.of_or(&["aero.law=ferguson", "impact.friction=0.3"], &["x", "a=1"]),
                    );
                }
                if chance.is(0.2) {
                    self.option("--starts", chance.of_or(&["1", "2"], &["0", "x"]));
                }
            }
            "pareto" => {
                for _ in 0..2 {
                    let of = outcome(chance);
                    self.option(
                        if chance.is(0.5) {
                            "--maximize"
                        } else {
                            "--minimize"
                        },
                        of,
                    );
                }
                self.search(false, chance);
                self.option("--points", chance.of_or(&["2", "3", "5"], &["1", "x"]));
                if chance.is(0.2) {
                    self.output("-o", &["front.csv", "best.toml"], chance);
                }
            }
            "report" => {
                self.along(chance);
                if chance.is(0.5) {
                    self.search(false, chance);
                }
                if chance.is(0.5) {
                    let text = sigma(chance);
                    self.option("--sigma", text);
                }
                self.output("-o", &["page"], chance);
            }
            "verify" => {
                self.option("--of", list(2, chance, outcome));
                self.option(
                    "--wrt",
                    list(2, chance, |chance| name_of(variable(chance), chance)),
                );
            }
            "sensitivity" => self.sensitivity(chance),
            "uncertainty" => self.uncertainty(chance),
            _ => {}
        }
        self.setup(command, chance);
        // the second setup comes after the first one
        if command == "compare" && chance.is(0.3) {
            let text = setup(chance);
            self.files.push(("other.toml".into(), text));
            self.push(chance.of(&["other.toml", "mae494", "winfield-tan"]));
        }
    }

    fn push(&mut self, word: impl Into<String>) {
        self.args.push(word.into());
    }

    fn option(&mut self, name: &str, value: impl Into<String>) {
        self.push(name);
        self.push(value);
    }

    /// The setup of the question, its changes, and step and method.
    fn setup(&mut self, command: &str, chance: &mut Chance) {
        let place = chance.below(10);
        match place {
            0..5 => self.push(preset(chance)),
            5 | 6 => {
                let text = setup(chance);
                self.files.push(("setup.toml".into(), text));
                self.push("setup.toml");
            }
            8 if chance.makes_mistake() => {
                self.push(chance.of(&["none.toml", "modern", "", ".", "mine.txt", "no/such.toml"]))
            }
            _ => {}
        }
        // if a file states the launch, `--launch` replaces part of it
        let is_of_file = matches!(place, 5 | 6);
        match chance.below(4) {
            _ if !chance.is_launched => {}
            0 if is_of_file => self.option(
                "--launch",
                chance.of(&["ball_speed=70m/s", "backspin=3000rpm", "spin=300rad/s"]),
            ),
            _ if is_of_file => {}
            0 => self.option(
                "--launch",
                "ball_speed=150mph,launch_angle=12deg,spin=2600rpm,spin_axis=-3deg",
            ),
            _ => {
                let launch = [
                    "ball_speed=167mph",
                    "launch_angle=10.9deg",
                    "backspin=2686rpm",
                    "launch_direction=-1deg",
                    "sidespin=-300rpm",
                    "spin_axis=3deg",
                ];
                let part = if chance.makes_mistake() {
                    chance.below(3)..6
                } else {
                    0..3 + chance.below(3)
                };
                self.option("--launch", launch[part].join(","));
            }
        }
        for _ in 0..chance.below(3) {
            let text = setting(chance);
            self.option("--set", text);
        }
        let is_cheap = matches!(command, "simulate" | "gradient" | "parameters" | "delivery");
        match chance.below(20) {
            0 => self.push(chance.of(&[
                "--tolerance",
                "--tolerance=1mm",
                "--tolerance=1cm",
                "--tolerance=0m",
                "--tolerance=x",
            ])),
            1 if is_cheap => {}
            _ => self.option("--set", format!("flight.step={}ms", 10 + chance.below(40))),
        }
    }

    fn delivery(&mut self, chance: &mut Chance) {
        let has_shots = !chance.is_launched && chance.is(0.3);
        if has_shots {
            let text = if chance.is(0.8) {
                export(chance)
            } else {
                shots(chance)
            };
            self.files.push(("shots.csv".into(), text));
            self.option("--shots", "shots.csv");
        }
        if !chance.is_launched && (!has_shots || chance.makes_mistake()) {
            for (option, of, amiss) in [
                ("--ball-speed", "150mph", "150"),
                ("--launch-angle", "12deg", "95deg"),
                ("--spin", "2600rpm", "-1rpm"),
            ] {
                self.option(option, chance.of_or(&[of], &[amiss]));
            }
            if chance.is(0.3) {
                self.option("--spin-axis", "-4deg");
            }
        }
        match chance.below(10) {
            0 => {
                let text = range(variable(chance), chance);
                self.option("--vary", text);
            }
            1 => self.option("--vary", "club.loft=-10deg..60deg"),
            2 => self.option("--sigma", "swing.attack_angle=0.5deg"),
            3 if chance.makes_mistake() => {
                let text = sigma(chance);
                self.option("--sigma", text);
            }
            _ => {}
        }
        if chance.is(0.2) {
            self.output("-o", &["golfer.toml"], chance);
        }
    }

    fn gradient(&mut self, chance: &mut Chance) {
        if chance.is(0.7) {
            self.option("--of", list(3, chance, outcome));
        }
        if chance.is(0.7) {
            let all = chance.is(0.05);
            let named = list(4, chance, |chance| name_of(variable(chance), chance));
            self.option("--wrt", if all { "all".into() } else { named });
        }
        if chance.is(0.3) {
            self.push("--hessian");
        }
    }

    fn compare(&mut self, chance: &mut Chance) {
        if chance.is(0.5) {
            self.option("--of", list(2, chance, outcome));
        }
        for option in ["--set-a", "--set-b", "--set-b"] {
            if chance.is(0.5) {
                let text = setting(chance);
                self.option(option, text);
            }
        }
        if chance.is(0.1) {
            self.option(
                "--launch-b",
                "ball_speed=150mph,launch_angle=12deg,spin=2600rpm,spin_axis=-3deg",
            );
        }
    }

    fn search(&mut self, is_wide: bool, chance: &mut Chance) {
        if chance.is(0.2) {
            let of = statistic(&outcome(chance), chance);
            self.option(
                if chance.is(0.7) {
                    "--maximize"
                } else {
                    "--minimize"
                },
                of,
            );
        }
        if chance.is_launched || chance.is(0.6) {
            for _ in 0..1 + chance.below(if is_wide { 3 } else { 2 }) {
                let text = range(variable(chance), chance);
                self.option("--vary", text);
            }
        }
        for _ in 0..chance.weighted(&[5.0, 3.0, 1.0]) {
            let text = constraint(chance);
            self.option("--subject-to", text);
        }
        let most = if chance.is(0.9) {
            5 + chance.below(25)
        } else {
            chance.below(2)
        };
        self.option("--max-iterations", most.to_string());
    }

    fn work(&mut self, chance: &mut Chance) {
        if chance.is(0.2) {
            self.option(
                "--starts",
                chance.of_or(&["1", "2", "4"], &["0", "-1", "70000", "x"]),
            );
        }
        if chance.is(0.1) {
            self.output("-o", &["best.toml"], chance);
        }
        if chance.is(0.1) {
            if chance.makes_mistake() {
                self.files
                    .push(("kept.json".into(), b"{\"no\": \"checkpoint\"}".to_vec()));
            }
            self.option("--checkpoint", "kept.json");
            self.outputs.push("kept.json".into());
        }
    }

    fn optimum_sensitivity(&mut self, chance: &mut Chance) {
        self.search(false, chance);
        self.work(chance);
        self.option(
            "--wrt",
            list(2, chance, |chance| name_of(variable(chance), chance)),
        );
        if chance.is(0.3) {
            let text = change(chance);
            self.option("--change", text);
        }
        if chance.is(0.2) {
            self.option(
                "--loss",
                chance.of_or(
                    &["1yd", "0.5 m", "1e-9 m", "1e300 m"],
                    &["0 yd", "1 kg", "nan m", "inf yd"],
                ),
            );
        }
    }

    fn along(&mut self, chance: &mut Chance) {
        let parameter: &Parameter = variable(chance);
        let text = if chance.is(0.7) {
            let low = near(parameter, 0.05, chance);
            let high = low + 0.01 * low.abs().max(0.1);
            format!(
                "{}={}..{}",
                parameter.name,
                with_unit(low, parameter, chance),
                with_unit(high, parameter, chance)
            )
        } else {
            range(parameter, chance)
        };
        self.option("--along", text);
    }

    fn at(&mut self, chance: &mut Chance) {
        let parameter = variable(chance);
        let values = list(3, chance, |chance| {
            let value = near(parameter, 0.05, chance);
            with_unit(value, parameter, chance)
        });
        self.option("--along", parameter.name);
        self.option("--at", values);
    }

    fn sensitivity(&mut self, chance: &mut Chance) {
        if chance.is(0.5) {
            self.option("--of", list(2, chance, outcome));
        }
        for _ in 0..chance.below(3) {
            let text = sigma(chance);
            self.option("--sigma", text);
        }
        if chance.is(0.6) {
            self.push("--no-defaults");
        }
        if chance.is(0.15) {
            self.push("--at-optimum");
            self.search(false, chance);
        }
    }

    fn uncertainty(&mut self, chance: &mut Chance) {
        if chance.is(0.5) {
            self.option("--of", list(2, chance, outcome));
        }
        for _ in 0..chance.below(3) {
            let text = sigma(chance);
            self.option("--sigma", text);
        }
        for _ in 0..chance.below(2) {
            let text = distribution(chance);
            self.option("--distribution", text);
        }
        self.option(
            "--samples",
            (if chance.makes_mistake() {
                chance.below(2)
            } else {
                2 + chance.below(20)
            })
            .to_string(),
        );
        if chance.is(0.2) {
            self.option("--seed", chance.below(9).to_string());
        }
    }

    fn fly(&mut self, chance: &mut Chance) {
        match chance.below(3) {
            0 => self.files.push(("shots.json".into(), messages(chance))),
            1 => self.files.push(("shots.csv".into(), shots(chance))),
            _ => self.files.push(("shots.csv".into(), export(chance))),
        }
        let name = self
            .files
            .last()
            .map_or_else(String::new, |(name, _)| name.clone());
        self.push(chance.of_or(&[name.as_str()], &["none.csv", "mine.txt", ".", "-"]));
        if chance.is(0.4) {
            self.option("--of", list(3, chance, outcome));
        }
        if chance.is(0.4) {
            self.option(
                "--format",
                chance.of_or(
                    &["csv", "launch-monitor", "jsonl", "open-connect"],
                    &["xml"],
                ),
            );
        }
        if chance.is(0.5) {
            self.output("-o", &["flown.csv", "flown.jsonl", "flown.json"], chance);
        }
        if chance.is(0.2) {
            self.option("--threads", chance.of_or(&["1", "2"], &["-1", "x"]));
        }
    }

    fn calibrate(&mut self, chance: &mut Chance) {
        let text = if chance.is(0.3) {
            export(chance)
        } else {
            shots(chance)
        };
        self.files.push(("shots.csv".into(), text));
        self.push(chance.of_or(&["shots.csv"], &["none.csv", "mine.txt", "."]));
        for _ in 0..1 + chance.below(2) {
            // mostly parameters of the flight: a row that is a launch does not use parameters of
            // the club
            let rows = [
                "air.density",
                "aero.spin_decay",
                "gravity",
                "ball.mass",
                "swing.shaft_lean",
            ];
            let of_law: Vec<_> = Law::all_rows().map(|row| row.name).collect();
            let name = match chance.below(3) {
                0 | 1 => chance.of(&rows).to_owned(),
                _ if chance.makes_mistake() => chance.of(&of_law).to_owned(),
                _ => variable(chance).name.to_owned(),
            };
            let text = if chance.is(0.2) {
                range(variable(chance), chance)
            } else {
                name
            };
            self.option("--fit", text);
        }
        self.option("--max-iterations", (1 + chance.below(20)).to_string());
        for (option, most) in [("--starts", 3), ("--folds", 5)] {
            if chance.is(0.1) {
                let count = if chance.makes_mistake() {
                    chance.below(most)
                } else {
                    2 + chance.below(most - 1)
                };
                self.option(option, count.to_string());
            }
        }
        if chance.is(0.1) {
            self.push("--huber");
        }
        if chance.is(0.05) {
            self.option(
                "--compare",
                chance.of_or(&["robinson", "ferguson", "linear"], &["nothing"]),
            );
        }
        if chance.is(0.3) {
            self.output("-o", &["fitted.toml"], chance);
        }
        if chance.is(0.05) {
            self.option("--plot", "plots");
            self.outputs.push("plots".into());
        }
    }

    fn plot(&mut self, chance: &mut Chance) {
        let kind = if chance.makes_mistake() {
            11
        } else {
            chance.weighted(&[10.0, 0.3, 0.5, 4.0, 1.0, 2.0, 2.0, 0.5, 0.5, 0.5, 0.3])
        };
        let kinds = [
            "trajectory",
            "contour",
            "chart",
            "tornado",
            "vcurve",
            "compare",
            "laws",
            "fairway",
            "launch",
            "face",
            "strike",
            "pie",
        ];
        self.push(kinds[kind]);
        match kind {
            0 if chance.is(0.5) => self.option("--view", chance.of_or(&["side", "top"], &["back"])),
            1 | 7 | 8 | 10 => self.search(false, chance),
            2 => {
                self.search(false, chance);
                self.along(chance);
                if chance.is(0.3) {
                    let shown = chance.of(&[
                        "carry",
                        "club.loft",
                        "swing.attack_angle",
                        "launch.launch_angle",
                    ]);
                    self.option("--show", shown);
                }
            }
            3 => {
                let of = outcome(chance);
                self.option("--of", of);
                let text = sigma(chance);
                self.option("--sigma", text);
            }
            5 => {
                let (of, text) = (outcome(chance), setting(chance));
                self.option("--of", of);
                self.option("--set-b", text);
            }
            6 => {
                self.option("--show", chance.of_or(&["cd", "cl"], &["drag"]));
                match chance.below(3) {
                    0 => self.option(
                        "--laws",
                        chance.of_or(&["lyu,ferguson", "linear"], &["lyu,lyu", "table"]),
                    ),
                    1 => self.option(
                        "--over",
                        chance.of_or(&["reynolds", "spin-ratio"], &["speed"]),
                    ),
                    _ => self.option(
                        "--reynolds",
                        chance.of_or(&["1e5", "200000"], &["0", "1e5 m", "nan"]),
                    ),
                }
            }
            4 => {
                self.option("--of", list(2, chance, outcome));
                self.option(
                    "--wrt",
                    list(2, chance, |chance| name_of(variable(chance), chance)),
                );
            }
            _ => {}
        }
        let names = if chance.makes_mistake() {
            ["a.jpg", "a", ".svg"]
        } else {
            ["a.svg", "a.csv", "a.png"]
        };
        self.output("-o", &names, chance);
        if chance.is(0.2) {
            self.push("--dark");
        }
        if chance.is(0.2) {
            self.option("--width", chance.of_or(&["240", "600"], &["10", "x"]));
        }
    }

    fn sweep(&mut self, chance: &mut Chance) {
        match chance.below(3) {
            0 => {
                let (name, text) = match chance.below(12) {
                    0 => binary(chance),
                    1 => ("export.csv".into(), export(chance)),
                    _ => ("points.csv".into(), points(chance)),
                };
                self.files.push((name.clone(), text));
                self.option("--points", name);
            }
            1 => {
                let text = range(variable(chance), chance);
                self.option("--over", text);
                self.option(
                    "--sample",
                    (if chance.makes_mistake() {
                        0
                    } else {
                        1 + chance.below(12)
                    })
                    .to_string(),
                );
                if chance.is(0.2) {
                    self.option(
                        "--seed",
                        chance.of_or(&["0", "7", "4294967295"], &["-1", "4294967296"]),
                    );
                }
            }
            _ => {
                for _ in 0..1 + chance.below(2) {
                    let text = range(variable(chance), chance);
                    let count = chance.of_or(
                        &["1", "2", "3", "7"],
                        &["0", "x", "-1", "99999999999999999999"],
                    );
                    if chance.is(0.02) {
                        self.option("--over", format!("{text}:99999999999"));
                        self.option("--max-size", "1GB");
                        continue;
                    }
                    self.option(
                        "--over",
                        if chance.makes_mistake() {
                            text
                        } else {
                            format!("{text}:{count}")
                        },
                    );
                }
            }
        }
        if chance.is(0.6) {
            self.option("--outcomes", list(3, chance, outcome));
        }
        if chance.is(0.2) {
            self.push("--gradient");
        }
        if chance.is(0.1) {
            self.option(
                "--instructions",
                chance.of_or(&["baseline"], &["sse2", "avx1024"]),
            );
        }
        if chance.is(0.1) {
            self.option(
                "--wrt",
                list(2, chance, |chance| name_of(variable(chance), chance)),
            );
        }
        if chance.is(0.85) {
            let names = if chance.makes_mistake() {
                ["rows.xlsx", "rows", "rows."]
            } else {
                ["rows.csv", "rows.jsonl", "rows.parquet"]
            };
            self.output("-o", &names, chance);
        }
        if chance.is(0.2) {
            self.option(
                "--format",
                chance.of_or(&["csv", "jsonl", "parquet"], &["xlsx"]),
            );
        }
        if chance.is(0.03) {
            self.push("--resume");
        }
        if chance.is(0.1) {
            self.option(
                "--threads",
                chance.of_or(&["0", "1", "2", "5000"], &["-1", "x"]),
            );
        }
        if chance.is(0.1) {
            self.option("--max-size", chance.of_or(&["1GB", "10B"], &["much", "0B"]));
        }
    }

    /// An output: a new file, an existing one, one in a missing folder, or an input.
    fn output(&mut self, option: &str, names: &[&str], chance: &mut Chance) {
        let name = chance.of(names).to_owned();
        let name = match chance.below(40) {
            0 => format!("no/such/{name}"),
            1 | 6 | 7 => format!("folder/{name}"),
            2 => {
                self.files.push((name.clone(), b"there before".to_vec()));
                name
            }
            3 => self.files[self.files.len() - 1].0.clone(),
            4 => {
                self.links
                    .push((self.files[self.files.len() - 1].0.clone(), name.clone()));
                name
            }
            5 => chance.of(&["", ".", "-", "folder"]).to_owned(),
            _ => name,
        };
        self.option(option, name.clone());
        self.outputs.push(name);
        if chance.is(0.15) {
            self.push("--overwrite");
        }
    }
}
