//! What deserves a word about a drive: a law beyond what it was fitted to, a strike beside the face; and nothing about usual drives.

use crate::command_line::{json, longdrive};
use longdrive::optimize::Watch;
use longdrive::parameters::PRESETS;
use longdrive::study::{Search, optimum};
use longdrive::{Drive, Setup};

fn warnings(preset: &str, settings: &[(&str, &str)]) -> Vec<String> {
    let mut setup = Setup::preset(preset).unwrap();
    setup.set_all(settings.iter().copied()).unwrap();
    Drive::new(&setup).unwrap().warnings(&setup).iter().map(ToString::to_string).collect()
}

#[test]
fn nothing_is_said_about_the_presets_and_their_longest_drives() {
    for preset in PRESETS {
        let setup = Setup::preset(preset.name).unwrap();
        assert_eq!(warnings(preset.name, &[]), Vec::<String>::new(), "{}", preset.name);
        let best = optimum(&setup, Search::longest_drive(&setup).unwrap(), Watch::default()).unwrap();
        let warnings = best.drive.unwrap().warnings(&best.setup);
        assert_eq!(warnings, [], "{}", preset.name);
    }
}

/// Next to no air, no decay: s = Rω/v(t) of a parabola is below 0.02 where v > v* = Rω/0.02, for 1 − √(v*² − v_h²)/v_v of the time.
#[test]
fn exact_share_of_the_flight_outside_of_what_the_law_was_fitted_to() {
    let (ahead, up, at_edge) = (50.0_f64, 30.0_f64, 53.0_f64);
    let mut setup = Setup::default();
    setup.set_all([("aero.law", "ferguson"), ("air.density", "1e-9 kg/m^3"), ("aero.spin_decay", "0 1/s")]).unwrap();
    setup.launch.ball_speed = Some(ahead.hypot(up));
    setup.launch.launch_angle = Some(up.atan2(ahead));
    setup.launch.backspin = Some(0.02 * at_edge / setup.ball.radius);
    let warnings = Drive::new(&setup).unwrap().warnings(&setup);
    let share = 100.0 * (1.0 - (at_edge * at_edge - ahead * ahead).sqrt() / up);
    let [low, high] = [ahead.hypot(up), ahead].map(|speed| 0.02 * at_edge / speed);
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    let words = [
        "the law ferguson".into(),
        "spin ratio of 0.02 to 0.75".into(),
        format!("from {low:.4} to {high:.4}"),
        format!("{share:.0} % of the time outside"),
    ];
    for word in words {
        assert!(warnings[0].to_string().contains(&word), "{word}: {}", warnings[0]);
    }
}

#[test]
fn each_law_names_what_it_was_fitted_to() {
    let slow = [("aero.law", "winfield-tan"), ("swing.speed", "30 mph"), ("club.loft", "14 deg")];
    let found = warnings("modern-driver", &slow);
    assert!(found.iter().any(|it| it.contains("speed through the air of 25 m/s to 68 m/s")), "{found:?}");
    let found = warnings("modern-driver", &[("swing.speed", "30 mph"), ("club.loft", "14 deg")]);
    assert!(found.iter().any(|it| it.contains("Reynolds number of 70000 to 230000")), "{found:?}");
    let found = warnings("modern-driver", &[("aero.law", "smits-smith"), ("swing.speed", "140 mph")]);
    assert!(found.iter().any(|it| it.contains("the law smits-smith")), "{found:?}");
    // no air, no law; and what is fitted to nothing that is known says nothing
    assert!(
        warnings("modern-driver", &[("swing.speed", "30 mph"), ("club.loft", "14 deg"), ("air.density", "0 kg/m^3")])
            .is_empty()
    );
    assert!(
        warnings("modern-driver", &[("swing.speed", "30 mph"), ("club.loft", "14 deg"), ("aero.law", "linear")])
            .is_empty()
    );
}

#[test]
fn a_strike_beside_the_face_is_told_on_standard_error_and_in_json() {
    let on_the_face = [("strike.toe", "30 mm"), ("strike.high", "-20 mm")];
    assert!(warnings("modern-driver", &on_the_face).iter().all(|it| !it.contains("strike.toe")));
    let command = ["simulate", "--set", "strike.toe=70mm"];
    let text = longdrive(&command);
    let told = "strike.toe = 70 mm and strike.high = 0 mm lie outside the face";
    assert!(text.status == 0 && text.err.contains(told), "{}", text.err);
    for command in
        [command.to_vec(), vec!["gradient", "--set", "strike.toe=70mm", "--of", "carry", "--wrt", "club.loft"]]
    {
        let (_, answer) = json(&command);
        let warnings = answer["warnings"].as_array().unwrap();
        assert!(warnings.iter().any(|it| it.as_str().unwrap().contains(told)), "{answer}");
    }
}
