//! The command `explore` if it cannot serve a page, and the address of the explorer.

#[cfg(not(feature = "explore"))]
use crate::command_line::{longdrive, on_one_line};
use longdrive::Setup;
use longdrive::command::{Host, MessageKind, run};
use longdrive::parameters::Preset;
use longdrive::report::explorer_state;
use longdrive::units::System;
use std::io;
use std::sync::{Arc, Mutex};

/// A host without a terminal.
#[derive(Default)]
struct NoTerminal {
    output: Mutex<String>,
}

impl Host for NoTerminal {
    fn print(&self, _: &str) -> io::Result<()> {
        Ok(())
    }

    fn say(&self, _: MessageKind, text: &str) {
        self.output.lock().unwrap().push_str(text);
    }
}

#[test]
fn a_host_without_a_terminal_serves_nothing() {
    let host = Arc::new(NoTerminal::default());
    let words = ["longdrive", "explore", "mae494"];
    assert_eq!(run(words.map(Into::into).to_vec(), host.clone()), 2);
    let output = host.output.lock().unwrap();
    let expected = "explore: it serves a page until Ctrl-C, so it needs a terminal; type there: \
                    longdrive explore";
    assert_eq!(*output, expected);
}

#[cfg(not(feature = "explore"))]
#[test]
fn without_its_feature_the_command_names_the_build_command() {
    let output = longdrive(&["explore"]);
    let err = on_one_line(&output.err);
    assert_eq!(output.status, 2, "{err}");
    let advice = "web/build, then cargo run --release --features explore -- explore";
    assert!(err.ends_with(advice), "{err}");
    // an error of the setup is reported before the missing feature
    let wrong = longdrive(&["explore", "tour"]);
    assert!(
        wrong.err.contains("did you mean 'tour-average'?"),
        "{}",
        wrong.err
    );
}

/// A report of a drive, in a folder.
fn report(folder: &std::path::Path, args: &[&str]) -> String {
    let words = [&["report", "-o", folder.to_str().unwrap()], args].concat();
    let output = crate::command_line::longdrive(&words);
    assert_eq!(output.status, 0, "{}", output.err);
    std::fs::read_to_string(folder.join("index.html")).unwrap()
}

#[test]
fn a_report_leads_to_the_explorer_of_its_drive() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("drive");
    let page = report(&place, &["--speed", "100mph", "--set", "club.loft=10 deg"]);
    let file = place.join("explorer.html");
    if cfg!(feature = "explore") {
        let link = "<a href=\"explorer.html#1&amp;tour-average&amp;swing.speed=100mph&amp;\
                    club.loft=10deg\">the explorer</a>";
        assert!(page.contains(link), "{page}");
        let dist = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/dist/explorer.html");
        assert!(std::fs::read(file).unwrap() == std::fs::read(dist).unwrap());
    } else {
        assert!(!page.contains("This drive with sliders"), "{page}");
        assert!(!file.exists());
    }
}

fn state(preset: &str, changes: &[(&str, &str)], system: System) -> String {
    let mut setup = Setup::preset(preset).unwrap();
    setup.set_all(changes.iter().copied()).unwrap();
    explorer_state(&setup, Preset::named(preset).unwrap(), system).unwrap()
}

#[test]
fn exact_addresses_have_only_what_differs_from_the_preset() {
    let of = |changes: &[_]| state("tour-average", changes, System::Us);
    assert_eq!(of(&[]), "1&tour-average");
    let same = [("golfer", "right"), ("impact.friction", "none")];
    assert_eq!(of(&same), "1&tour-average");
    assert_eq!(
        of(&[("golfer", "left"), ("swing.speed_of", "face-centre")]),
        "1&tour-average&golfer=left&swing.speed_of=face-centre"
    );
    let wind = [("wind.speed", "10 mph"), ("wind.from", "90 deg")];
    assert_eq!(
        state("mae494", &wind, System::Us),
        "1&mae494&wind.speed=10mph&wind.from=90deg"
    );
    assert_eq!(
        state("mae494", &wind, System::Metric),
        "1&mae494&wind.speed=4.4704m/s&wind.from=90deg&units=metric"
    );
}

#[test]
fn exact_address_of_a_launch_has_no_club() {
    let launch = [
        ("golfer", "left"),
        ("club.loft", "12 deg"),
        ("launch.ball_speed", "160 mph"),
        ("launch.launch_angle", "12 deg"),
        ("launch.backspin", "2600 rpm"),
    ];
    assert_eq!(
        state("tour-average", &launch, System::Us),
        "1&tour-average&launch.ball_speed=160mph&launch.launch_angle=12deg&launch.backspin=2600rpm"
    );
}

#[test]
fn exact_escapes_of_units_signs_and_unset_values() {
    let of = |changes: &[_]| state("tour-average", changes, System::Us);
    assert_eq!(
        of(&[("club.inertia.xx", "4500 g cm^2")]),
        "1&tour-average&club.inertia.xx=4500g%20cm%5E2"
    );
    assert_eq!(
        of(&[
            ("swing.attack_angle", "-2 deg"),
            ("wind.speed", "0 mph"),
            ("wind.from", "90 deg")
        ]),
        "1&tour-average&swing.attack_angle=-2deg&wind.speed=0mph&wind.from=90deg"
    );
    assert_eq!(
        of(&[("ground.turf", "wet")]),
        "1&tour-average&ground.restitution=none"
    );
}

#[test]
fn exact_coefficients_of_another_law_are_compared_with_the_published_ones() {
    let of = |changes: &[_]| state("tour-average", changes, System::Us);
    assert_eq!(
        of(&[("aero.law", "linear")]),
        "1&tour-average&aero.law=linear"
    );
    assert_eq!(
        of(&[("aero.law", "linear"), ("aero.cd", "0.3")]),
        "1&tour-average&aero.law=linear&aero.cd=0.3"
    );
}

#[test]
fn a_stated_step_is_in_the_address_also_where_it_is_the_default() {
    let stated = [("flight.method", "rk4"), ("flight.step", "10 ms")];
    assert_eq!(
        state("tour-average", &stated, System::Us),
        "1&tour-average&flight.method=rk4&flight.step=0.01s"
    );
}
