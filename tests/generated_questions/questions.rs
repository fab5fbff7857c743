//! Questions of users: a command line with its files.

use crate::choices::Choices;
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
    pub fn new(choices: &mut Choices) -> Self {
        let frequencies: Vec<f64> = COMMANDS.iter().map(|(_, frequency)| *frequency).collect();
        let command = COMMANDS[choices.weighted(&frequencies)].0;
        let mut question = Self {
            args: vec![command.into()],
            ..Self::default()
        };
        // a file that the question does not name
        question
            .files
            .push(("mine.txt".into(), b"left alone".to_vec()));
        choices.is_launched = !["calibrate", "design", "fly"].contains(&command)
            && choices.is(if command == "simulate" { 0.15 } else { 0.1 });
        choices.is_of_flight = command == "fly" && choices.is(0.8);
        choices.is_over_swings = command == "design" && choices.is(0.8);
        question.ask(command, choices);
        if choices.is(0.5) && !OF_THE_PROGRAM.contains(&command) {
            question.push("--json");
        }
        // these options may come before or after the command
        for (option, probability) in [("--units", 0.15), ("--quiet", 0.1)] {
            if choices.is(probability) {
                let at = if choices.is(0.3) {
                    0
                } else {
                    question.args.len()
                };
                let system = choices.good_or_bad(&["metric", "us"], &["si"]).to_owned();
                question.args.splice(
                    at..at,
                    [option.to_owned(), system]
                        .into_iter()
                        .take(2 - usize::from(option == "--quiet")),
                );
            }
        }
        if choices.makes_mistake() {
            let odd = choices.of(&[
                "--bla",
                "-x",
                "--",
                "extra",
                "--help",
                "",
                "--set",
                "--version",
            ]);
            let at = choices.below(question.args.len() + 1);
            question.args.insert(at, odd.into());
        }
        question
    }

    /// The command of the question.
    pub fn command(&self) -> &str {
        let is_command = |arg: &&String| COMMANDS.iter().any(|(name, _)| arg == name);
        self.args.iter().find(is_command).map_or("", String::as_str)
    }

    fn ask(&mut self, command: &str, choices: &mut Choices) {
        match command {
            "laws" => return,
            "presets" => {
                if choices.is(0.6) {
                    let name = preset(choices);
                    self.push(choices.good_or_bad(&[name], &["mae49"]));
                }
                return;
            }
            "validate" => {
                if choices.is(0.3) {
                    self.push("--csv");
                }
                if choices.is(0.3) {
                    self.output("-o", &["study"], choices);
                }
                return;
            }
            "reproduce" => {
                self.push(choices.good_or_bad(&["mae494", "winfield-tan"], &["mae495"]));
                if choices.is(0.5) {
                    self.output("-o", &["study"], choices);
                }
                return;
            }
            "help" | "man" => {
                let named: Vec<&str> = COMMANDS.iter().map(|(name, _)| *name).collect();
                match choices.below(4) {
                    0 if command == "man" => {
                        self.output("-o", &["pages"], choices);
                        if choices.makes_mistake() {
                            self.push("simulate");
                        }
                    }
                    1 => {}
                    2 => self.args.extend(["plot", "contour"].map(str::to_owned)),
                    _ => {
                        let name = choices.good_or_bad(&named, &["optimise", "", "plot contours"]);
                        self.push(name);
                    }
                }
                return;
            }
            "completions" => {
                self.push(choices.good_or_bad(
                    &["bash", "zsh", "fish", "powershell", "elvish"],
                    &["nush", ""],
                ));
                return;
            }
            "calibrate" => self.calibrate(choices),
            "delivery" => self.delivery(choices),
            "plot" => self.plot(choices),
            "sweep" => self.sweep(choices),
            "fly" => self.fly(choices),
            "gradient" => self.gradient(choices),
            "compare" => self.compare(choices),
            "optimize" => {
                self.search(true, choices);
                self.work(choices);
            }
            "design" => {
                self.search(true, choices);
                self.option(
                    "--scenarios",
                    choices.good_or_bad(&["2", "9", "16"], &["0", "x"]),
                );
                if choices.is(0.5) {
                    self.option(
                        "--rules",
                        choices.good_or_bad(&["golf", "none"], &["usga", ""]),
                    );
                }
                self.work(choices);
            }
            "optimum-sensitivity" => self.optimum_sensitivity(choices),
            "chart" => {
                self.search(false, choices);
                if choices.is(0.3) {
                    self.at(choices);
                } else {
                    self.along(choices);
                }
                if choices.is(0.2) {
                    self.push("--csv");
                }
            }
            "robust" => {
                self.search(false, choices);
                if choices.is(0.5) {
                    self.option(
                        "--model",
                        choices.good_or_bad(
                            &["aero.law=ferguson", "impact.friction=0.3"],
                            &["x", "a=1"],
                        ),
                    );
                }
                if choices.is(0.2) {
                    self.option("--starts", choices.good_or_bad(&["1", "2"], &["0", "x"]));
                }
            }
            "pareto" => {
                for _ in 0..2 {
                    let of = outcome(choices);
                    self.option(
                        if choices.is(0.5) {
                            "--maximize"
                        } else {
                            "--minimize"
                        },
                        of,
                    );
                }
                self.search(false, choices);
                self.option(
                    "--points",
                    choices.good_or_bad(&["2", "3", "5"], &["1", "x"]),
                );
                if choices.is(0.2) {
                    self.output("-o", &["front.csv", "best.toml"], choices);
                }
            }
            "report" => {
                self.along(choices);
                if choices.is(0.5) {
                    self.search(false, choices);
                }
                if choices.is(0.5) {
                    let text = sigma(choices);
                    self.option("--sigma", text);
                }
                self.output("-o", &["page"], choices);
            }
            "verify" => {
                self.option("--of", list(2, choices, outcome));
                self.option(
                    "--wrt",
                    list(2, choices, |choices| name_of(variable(choices), choices)),
                );
            }
            "sensitivity" => self.sensitivity(choices),
            "uncertainty" => self.uncertainty(choices),
            _ => {}
        }
        self.setup(command, choices);
        // the second setup comes after the first one
        if command == "compare" && choices.is(0.3) {
            let text = setup(choices);
            self.files.push(("other.toml".into(), text));
            self.push(choices.of(&["other.toml", "mae494", "winfield-tan"]));
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
    fn setup(&mut self, command: &str, choices: &mut Choices) {
        let place = choices.below(10);
        match place {
            0..5 => self.push(preset(choices)),
            5 | 6 => {
                let text = setup(choices);
                self.files.push(("setup.toml".into(), text));
                self.push("setup.toml");
            }
            8 if choices.makes_mistake() => {
                self.push(choices.of(&["none.toml", "modern", "", ".", "mine.txt", "no/such.toml"]))
            }
            _ => {}
        }
        // if a file states the launch, `--launch` replaces part of it
        let is_of_file = matches!(place, 5 | 6);
        match choices.below(4) {
            _ if !choices.is_launched => {}
            0 if is_of_file => self.option(
                "--launch",
                choices.of(&["ball_speed=70m/s", "backspin=3000rpm", "spin=300rad/s"]),
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
                let part = if choices.makes_mistake() {
                    choices.below(3)..6
                } else {
                    0..3 + choices.below(3)
                };
                self.option("--launch", launch[part].join(","));
            }
        }
        for _ in 0..choices.below(3) {
            let text = setting(choices);
            self.option("--set", text);
        }
        let is_cheap = matches!(command, "simulate" | "gradient" | "parameters" | "delivery");
        match choices.below(20) {
            0 => self.push(choices.of(&[
                "--tolerance",
                "--tolerance=1mm",
                "--tolerance=1cm",
                "--tolerance=0m",
                "--tolerance=x",
            ])),
            1 if is_cheap => {}
            _ => self.option("--set", format!("flight.step={}ms", 10 + choices.below(40))),
        }
    }

    fn delivery(&mut self, choices: &mut Choices) {
        let has_shots = !choices.is_launched && choices.is(0.3);
        if has_shots {
            let text = if choices.is(0.8) {
                export(choices)
            } else {
                shots(choices)
            };
            self.files.push(("shots.csv".into(), text));
            self.option("--shots", "shots.csv");
        }
        if !choices.is_launched && (!has_shots || choices.makes_mistake()) {
            for (option, of, amiss) in [
                ("--ball-speed", "150mph", "150"),
                ("--launch-angle", "12deg", "95deg"),
                ("--spin", "2600rpm", "-1rpm"),
            ] {
                self.option(option, choices.good_or_bad(&[of], &[amiss]));
            }
            if choices.is(0.3) {
                self.option("--spin-axis", "-4deg");
            }
        }
        match choices.below(10) {
            0 => {
                let text = range(variable(choices), choices);
                self.option("--vary", text);
            }
            1 => self.option("--vary", "club.loft=-10deg..60deg"),
            2 => self.option("--sigma", "swing.attack_angle=0.5deg"),
            3 if choices.makes_mistake() => {
                let text = sigma(choices);
                self.option("--sigma", text);
            }
            _ => {}
        }
        if choices.is(0.2) {
            self.output("-o", &["golfer.toml"], choices);
        }
    }

    fn gradient(&mut self, choices: &mut Choices) {
        if choices.is(0.7) {
            self.option("--of", list(3, choices, outcome));
        }
        if choices.is(0.7) {
            let all = choices.is(0.05);
            let named = list(4, choices, |choices| name_of(variable(choices), choices));
            self.option("--wrt", if all { "all".into() } else { named });
        }
        if choices.is(0.3) {
            self.push("--hessian");
        }
    }

    fn compare(&mut self, choices: &mut Choices) {
        if choices.is(0.5) {
            self.option("--of", list(2, choices, outcome));
        }
        for option in ["--set-a", "--set-b", "--set-b"] {
            if choices.is(0.5) {
                let text = setting(choices);
                self.option(option, text);
            }
        }
        if choices.is(0.1) {
            self.option(
                "--launch-b",
                "ball_speed=150mph,launch_angle=12deg,spin=2600rpm,spin_axis=-3deg",
            );
        }
    }

    fn search(&mut self, is_wide: bool, choices: &mut Choices) {
        if choices.is(0.2) {
            let of = statistic(&outcome(choices), choices);
            self.option(
                if choices.is(0.7) {
                    "--maximize"
                } else {
                    "--minimize"
                },
                of,
            );
        }
        if choices.is_launched || choices.is(0.6) {
            for _ in 0..1 + choices.below(if is_wide { 3 } else { 2 }) {
                let text = range(variable(choices), choices);
                self.option("--vary", text);
            }
        }
        for _ in 0..choices.weighted(&[5.0, 3.0, 1.0]) {
            let text = constraint(choices);
            self.option("--subject-to", text);
        }
        let most = if choices.is(0.9) {
            5 + choices.below(25)
        } else {
            choices.below(2)
        };
        self.option("--max-iterations", most.to_string());
    }

    fn work(&mut self, choices: &mut Choices) {
        if choices.is(0.2) {
            self.option(
                "--starts",
                choices.good_or_bad(&["1", "2", "4"], &["0", "-1", "70000", "x"]),
            );
        }
        if choices.is(0.1) {
            self.output("-o", &["best.toml"], choices);
        }
        if choices.is(0.1) {
            if choices.makes_mistake() {
                self.files
                    .push(("kept.json".into(), b"{\"no\": \"checkpoint\"}".to_vec()));
            }
            self.option("--checkpoint", "kept.json");
            self.outputs.push("kept.json".into());
        }
    }

    fn optimum_sensitivity(&mut self, choices: &mut Choices) {
        self.search(false, choices);
        self.work(choices);
        self.option(
            "--wrt",
            list(2, choices, |choices| name_of(variable(choices), choices)),
        );
        if choices.is(0.3) {
            let text = change(choices);
            self.option("--change", text);
        }
        if choices.is(0.2) {
            self.option(
                "--loss",
                choices.good_or_bad(
                    &["1yd", "0.5 m", "1e-9 m", "1e300 m"],
                    &["0 yd", "1 kg", "nan m", "inf yd"],
                ),
            );
        }
    }

    fn along(&mut self, choices: &mut Choices) {
        let parameter: &Parameter = variable(choices);
        let text = if choices.is(0.7) {
            let low = near(parameter, 0.05, choices);
            let high = low + 0.01 * low.abs().max(0.1);
            format!(
                "{}={}..{}",
                parameter.name,
                with_unit(low, parameter, choices),
                with_unit(high, parameter, choices)
            )
        } else {
            range(parameter, choices)
        };
        self.option("--along", text);
    }

    fn at(&mut self, choices: &mut Choices) {
        let parameter = variable(choices);
        let values = list(3, choices, |choices| {
            let value = near(parameter, 0.05, choices);
            with_unit(value, parameter, choices)
        });
        self.option("--along", parameter.name);
        self.option("--at", values);
    }

    fn sensitivity(&mut self, choices: &mut Choices) {
        if choices.is(0.5) {
            self.option("--of", list(2, choices, outcome));
        }
        for _ in 0..choices.below(3) {
            let text = sigma(choices);
            self.option("--sigma", text);
        }
        if choices.is(0.6) {
            self.push("--no-defaults");
        }
        if choices.is(0.15) {
            self.push("--at-optimum");
            self.search(false, choices);
        }
    }

    fn uncertainty(&mut self, choices: &mut Choices) {
        if choices.is(0.5) {
            self.option("--of", list(2, choices, outcome));
        }
        for _ in 0..choices.below(3) {
            let text = sigma(choices);
            self.option("--sigma", text);
        }
        for _ in 0..choices.below(2) {
            let text = distribution(choices);
            self.option("--distribution", text);
        }
        self.option(
            "--samples",
            (if choices.makes_mistake() {
                choices.below(2)
            } else {
                2 + choices.below(20)
            })
            .to_string(),
        );
        if choices.is(0.2) {
            self.option("--seed", choices.below(9).to_string());
        }
    }

    fn fly(&mut self, choices: &mut Choices) {
        match choices.below(3) {
            0 => self.files.push(("shots.json".into(), messages(choices))),
            1 => self.files.push(("shots.csv".into(), shots(choices))),
            _ => self.files.push(("shots.csv".into(), export(choices))),
        }
        let name = self
            .files
            .last()
            .map_or_else(String::new, |(name, _)| name.clone());
        self.push(choices.good_or_bad(&[name.as_str()], &["none.csv", "mine.txt", ".", "-"]));
        if choices.is(0.4) {
            self.option("--of", list(3, choices, outcome));
        }
        if choices.is(0.4) {
            self.option(
                "--format",
                choices.good_or_bad(
                    &["csv", "launch-monitor", "jsonl", "open-connect"],
                    &["xml"],
                ),
            );
        }
        if choices.is(0.5) {
            self.output("-o", &["flown.csv", "flown.jsonl", "flown.json"], choices);
        }
        if choices.is(0.2) {
            self.option("--threads", choices.good_or_bad(&["1", "2"], &["-1", "x"]));
        }
    }

    fn calibrate(&mut self, choices: &mut Choices) {
        let text = if choices.is(0.3) {
            export(choices)
        } else {
            shots(choices)
        };
        self.files.push(("shots.csv".into(), text));
        self.push(choices.good_or_bad(&["shots.csv"], &["none.csv", "mine.txt", "."]));
        for _ in 0..1 + choices.below(2) {
            // mostly parameters of the flight: rows that state a launch do not use parameters of
            // the club
            let rows = [
                "air.density",
                "aero.spin_decay",
                "gravity",
                "ball.mass",
                "swing.shaft_lean",
            ];
            let of_law: Vec<_> = Law::all_rows().map(|row| row.name).collect();
            let name = match choices.below(3) {
                0 | 1 => choices.of(&rows).to_owned(),
                _ if choices.makes_mistake() => choices.of(&of_law).to_owned(),
                _ => variable(choices).name.to_owned(),
            };
            let text = if choices.is(0.2) {
                range(variable(choices), choices)
            } else {
                name
            };
            self.option("--fit", text);
        }
        self.option("--max-iterations", (1 + choices.below(20)).to_string());
        for (option, most) in [("--starts", 3), ("--folds", 5)] {
            if choices.is(0.1) {
                let count = if choices.makes_mistake() {
                    choices.below(most)
                } else {
                    2 + choices.below(most - 1)
                };
                self.option(option, count.to_string());
            }
        }
        if choices.is(0.1) {
            self.push("--huber");
        }
        if choices.is(0.05) {
            self.option(
                "--compare",
                choices.good_or_bad(&["robinson", "ferguson", "linear"], &["nothing"]),
            );
        }
        if choices.is(0.3) {
            self.output("-o", &["fitted.toml"], choices);
        }
        if choices.is(0.05) {
            self.option("--plot", "plots");
            self.outputs.push("plots".into());
        }
    }

    fn plot(&mut self, choices: &mut Choices) {
        let kind = if choices.makes_mistake() {
            11
        } else {
            choices.weighted(&[10.0, 0.3, 0.5, 4.0, 1.0, 2.0, 2.0, 0.5, 0.5, 0.5, 0.3])
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
            0 if choices.is(0.5) => {
                self.option("--view", choices.good_or_bad(&["side", "top"], &["back"]))
            }
            1 | 7 | 8 | 10 => self.search(false, choices),
            2 => {
                self.search(false, choices);
                self.along(choices);
                if choices.is(0.3) {
                    let shown = choices.of(&[
                        "carry",
                        "club.loft",
                        "swing.attack_angle",
                        "launch.launch_angle",
                    ]);
                    self.option("--show", shown);
                }
            }
            3 => {
                let of = outcome(choices);
                self.option("--of", of);
                let text = sigma(choices);
                self.option("--sigma", text);
            }
            5 => {
                let (of, text) = (outcome(choices), setting(choices));
                self.option("--of", of);
                self.option("--set-b", text);
            }
            6 => {
                self.option("--show", choices.good_or_bad(&["cd", "cl"], &["drag"]));
                match choices.below(3) {
                    0 => self.option(
                        "--laws",
                        choices.good_or_bad(&["lyu,ferguson", "linear"], &["lyu,lyu", "table"]),
                    ),
                    1 => self.option(
                        "--over",
                        choices.good_or_bad(&["reynolds", "spin-ratio"], &["speed"]),
                    ),
                    _ => self.option(
                        "--reynolds",
                        choices.good_or_bad(&["1e5", "200000"], &["0", "1e5 m", "nan"]),
                    ),
                }
            }
            4 => {
                self.option("--of", list(2, choices, outcome));
                self.option(
                    "--wrt",
                    list(2, choices, |choices| name_of(variable(choices), choices)),
                );
            }
            _ => {}
        }
        let names = if choices.makes_mistake() {
            ["a.jpg", "a", ".svg"]
        } else {
            ["a.svg", "a.csv", "a.png"]
        };
        self.output("-o", &names, choices);
        if choices.is(0.2) {
            self.push("--dark");
        }
        if choices.is(0.2) {
            self.option(
                "--width",
                choices.good_or_bad(&["240", "600"], &["10", "x"]),
            );
        }
    }

    fn sweep(&mut self, choices: &mut Choices) {
        match choices.below(3) {
            0 => {
                let (name, text) = match choices.below(12) {
                    0 => binary(choices),
                    1 => ("export.csv".into(), export(choices)),
                    _ => ("points.csv".into(), points(choices)),
                };
                self.files.push((name.clone(), text));
                self.option("--points", name);
            }
            1 => {
                let text = range(variable(choices), choices);
                self.option("--over", text);
                self.option(
                    "--sample",
                    (if choices.makes_mistake() {
                        0
                    } else {
                        1 + choices.below(12)
                    })
                    .to_string(),
                );
                if choices.is(0.2) {
                    self.option(
                        "--seed",
                        choices.good_or_bad(&["0", "7", "4294967295"], &["-1", "4294967296"]),
                    );
                }
            }
            _ => {
                for _ in 0..1 + choices.below(2) {
                    let text = range(variable(choices), choices);
                    let count = choices.good_or_bad(
                        &["1", "2", "3", "7"],
                        &["0", "x", "-1", "99999999999999999999"],
                    );
                    if choices.is(0.02) {
                        self.option("--over", format!("{text}:99999999999"));
                        self.option("--max-size", "1GB");
                        continue;
                    }
                    self.option(
                        "--over",
                        if choices.makes_mistake() {
                            text
                        } else {
                            format!("{text}:{count}")
                        },
                    );
                }
            }
        }
        if choices.is(0.6) {
            self.option("--outcomes", list(3, choices, outcome));
        }
        if choices.is(0.2) {
            self.push("--gradient");
        }
        if choices.is(0.1) {
            self.option(
                "--instructions",
                choices.good_or_bad(&["baseline"], &["sse2", "avx1024"]),
            );
        }
        if choices.is(0.1) {
            self.option(
                "--wrt",
                list(2, choices, |choices| name_of(variable(choices), choices)),
            );
        }
        if choices.is(0.85) {
            let names = if choices.makes_mistake() {
                ["rows.xlsx", "rows", "rows."]
            } else {
                ["rows.csv", "rows.jsonl", "rows.parquet"]
            };
            self.output("-o", &names, choices);
        }
        if choices.is(0.2) {
            self.option(
                "--format",
                choices.good_or_bad(&["csv", "jsonl", "parquet"], &["xlsx"]),
            );
        }
        if choices.is(0.03) {
            self.push("--resume");
        }
        if choices.is(0.1) {
            self.option(
                "--threads",
                choices.good_or_bad(&["0", "1", "2", "5000"], &["-1", "x"]),
            );
        }
        if choices.is(0.1) {
            self.option(
                "--max-size",
                choices.good_or_bad(&["1GB", "10B"], &["much", "0B"]),
            );
        }
    }

    /// An option for an output: a new file, an existing file, a file in a missing folder, or an
    /// input file.
    fn output(&mut self, option: &str, names: &[&str], choices: &mut Choices) {
        let name = choices.of(names).to_owned();
        let name = match choices.below(40) {
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
            5 => choices.of(&["", ".", "-", "folder"]).to_owned(),
            _ => name,
        };
        self.option(option, name.clone());
        self.outputs.push(name);
        if choices.is(0.15) {
            self.push("--overwrite");
        }
    }
}
