//! Setups: settings by name, setup files, turfs, and ranges of values.

use longdrive::parameters::{Law, PRESETS, Range, SetupFile, TURFS};
use longdrive::units::Quantity;
use longdrive::{Error, Setup};

#[test]
fn every_default_and_every_preset_reads_back_within_its_range() {
    for law in Law::NAMES {
        let mut setup = Setup::modern_driver();
        setup.set_law(law).unwrap();
        for row in setup.parameters() {
            assert!(
                row.quantity.size_of(row.unit).is_some() || row.unit.is_empty(),
                "{}",
                row.name
            );
            assert_eq!(
                row.read(row.default, false).unwrap(),
                setup.value(row),
                "{}",
                row.name
            );
        }
    }
    for preset in PRESETS {
        Setup::preset(preset.name).unwrap().validate().unwrap();
    }
}

#[test]
fn names_are_unique_within_a_setup() {
    for law in Law::NAMES {
        let mut setup = Setup::modern_driver();
        setup.set_law(law).unwrap();
        let mut names: Vec<_> = setup.parameters().iter().map(|row| row.name).collect();
        let all = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all);
    }
}

#[test]
fn a_quantity_with_a_dimension_needs_its_unit() {
    let mut setup = Setup::modern_driver();
    let message = setup.set("swing.speed", "100").unwrap_err().to_string();
    assert!(
        message.contains("\"100\" has no unit; a speed takes mph, m/s"),
        "{message}"
    );
    assert_eq!(setup, Setup::modern_driver());
    setup.set("impact.restitution", "0.8").unwrap();
    setup.set("club.loft", "0.2 rad").unwrap();
    assert_eq!((setup.impact.restitution, setup.club.loft), (0.8, 0.2));
}

#[test]
fn the_law_is_chosen_before_its_coefficients_are_set() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([("aero.cd", "0.3"), ("aero.law", "linear")])
        .unwrap();
    assert_eq!(setup.value(setup.parameter("aero.cd").unwrap()), Some(0.3));
    assert!(matches!(
        setup.set("aero.re1", "1"),
        Err(Error::OtherLaw { .. })
    ));
    assert!(matches!(
        setup.set("aero.law", "linaer"),
        Err(Error::Unknown {
            suggestion: Some(_),
            ..
        })
    ));
}

#[test]
fn default_is_refused_as_a_word_and_does_not_unset_a_parameter() {
    let mut setup = Setup::modern_driver();
    for name in ["impact.gear_scale", "air.density"] {
        let message = setup.set(name, "default").unwrap_err().to_string();
        let reason = format!("{name}: \"default\" does not start with a number");
        assert!(message.starts_with(&reason), "{message}");
    }
    assert_eq!(setup, Setup::modern_driver());
}

#[test]
fn infinite_and_unset_values_are_allowed_only_where_they_mean_something() {
    let mut setup = Setup::modern_driver();
    setup.set("club.bulge_radius", "inf").unwrap();
    setup.set("impact.friction", "0.4").unwrap();
    setup.set("impact.friction", "none").unwrap();
    assert_eq!(setup.impact.friction, None);
    assert!(setup.set("swing.speed", "inf").is_err());
    assert!(setup.set("swing.speed", "nan").is_err());
    assert!(setup.set("swing.speed", "none").is_err());
    assert!(matches!(
        setup.variable("club.bulge_radius"),
        Err(Error::NotVariable { .. })
    ));
    assert!(matches!(
        setup.variable("impact.friction"),
        Err(Error::NotVariable { .. })
    ));
    assert!(matches!(
        setup.variable("flight.step"),
        Err(Error::NotVariable { .. })
    ));
}

#[test]
fn ends_count_only_where_included_and_nan_never() {
    let radius = Range::above_to(0.0, f64::INFINITY);
    assert!(radius.contains(f64::INFINITY) && radius.contains(0.3));
    assert!(!radius.contains(0.0) && !radius.contains(f64::NAN));
    assert!(!Range::FINITE.contains(f64::INFINITY) && Range::FINITE.contains(-1e300));
    assert_eq!(radius.show(Quantity::LENGTH, "mm"), "0 mm < … ≤ inf mm");
    assert_eq!(
        Range::from_to(-1.0, 1.0).show(Quantity::INERTIA, "g cm^2"),
        "-1e7 g cm^2 ≤ … ≤ 1e7 g cm^2"
    );
    assert_eq!(
        Range::within_degrees(90.0).show(Quantity::ANGLE, "deg"),
        "-90 deg < … < 90 deg"
    );
}

#[test]
fn comments_after_values_are_remarks() {
    let text = "preset = 'mae494'\r\n# of the club\r\nclub.mass = '0.2 kg'   #  weighed # twice \r\n\
                club.loft = '9 deg'\n# none\nswing = { speed = '50 m/s', path = '0 deg' } # of both\n\
                golfer = \"left\" # '#'\nball.mass = '45 g' #\nball.radius = '0.0214 m'# close";
    let file = SetupFile::read(text, "a.toml").unwrap();
    let remarks: Vec<_> = file
        .remarks
        .iter()
        .map(|(of, text)| format!("{of}: {text}"))
        .collect();
    assert_eq!(
        remarks,
        [
            "ball.radius: close",
            "club.mass: weighed # twice",
            "golfer: '#'"
        ]
    );
}

#[test]
fn nested_keys_and_units() {
    let text = "aero.law = 'linear'\n[swing]\nspeed = '50 m/s'\n[club]\ninertia = \
                { xx = '5679 g cm^2', yz = '1e-6 kg m^2' }\n\
                bulge_radius = inf\n[impact]\nfriction = 0.4\n[aero]\ncd = 0.27";
    let error = SetupFile::read(text, "a.toml").unwrap_err().to_string();
    assert!(
        error.starts_with("a.toml: "),
        "a table defined twice is a TOML error: {error}"
    );
    let setup = SetupFile::read(
        &text
            .replace("\n[aero]\ncd", "\n[a]\n")
            .replace("[a]\n = 0.27", ""),
        "a.toml",
    )
    .unwrap()
    .setup;
    assert_eq!((setup.swing.speed, setup.club.inertia_xx), (50.0, 5.679e-4));
    assert_eq!(
        (setup.club.bulge_radius, setup.impact.friction),
        (f64::INFINITY, Some(0.4))
    );
    assert_eq!(setup.law.name(), "linear");
}

fn assert_refused(texts: &[(&str, &str, &str)]) {
    for (text, start, says) in texts {
        let message = SetupFile::read(text, "f").unwrap_err().to_string();
        assert!(
            message.starts_with(start) && message.contains(says),
            "{text:?}: {message}"
        );
    }
}

#[test]
fn every_wrong_value_has_its_line_and_column() {
    assert_refused(&[
        (
            "[club]\nloft = '10 kg'",
            "f:2:8: club.loft: \"10 kg\" is not an angle",
            "deg",
        ),
        (
            "[club]\nloft = '10'",
            "f:2:8: club.loft: \"10\" has no unit",
            "deg",
        ),
        (
            "[club]\nloft = 10",
            "f:2:8: club.loft: \"10\" has no unit",
            "deg",
        ),
        (
            "[club]\nloft = nan",
            "f:2:8: club.loft: \"nan\" is not a number",
            "10.5 deg",
        ),
        (
            "[club]\nloft = true",
            "f:2:8: 'club.loft' is a boolean",
            "9.8 deg",
        ),
        (
            "preset = 'mae'",
            "f:1:10: unknown preset 'mae'; did you mean 'mae494'?",
            "winfield-tan",
        ),
        (
            "club = 3",
            "f:1:8: 'club' is a number; expected a table",
            "[club]",
        ),
        (
            "[[swing]]\nspeed = 50",
            "f:1:1: 'swing' is an array; expected a table",
            "[swing]",
        ),
    ]);
}

#[test]
fn a_value_of_a_wrong_type_gets_an_example_of_its_quantity() {
    for parameter in Setup::modern_driver().parameters() {
        let read = |value: &str| SetupFile::read(&format!("{parameter} = {value}"), "f");
        let message = read("true").unwrap_err().to_string();
        let (expected, example) = message.split_once(" like ").unwrap();
        let takes_bare_numbers = read("0.5").is_ok() || read("4").is_ok();
        assert_eq!(
            expected.contains("a number"),
            takes_bare_numbers,
            "{message}"
        );
        let example = example.trim_matches('"');
        assert!(parameter.quantity.read(example).is_ok(), "{message}");
    }
}

#[test]
fn every_wrong_name_has_its_line_and_column() {
    assert_refused(&[
        (
            "[club]\nloft = { x = 1 }",
            "f:2:10: unknown parameter 'club.loft.x'",
            "did you mean 'club.loft'",
        ),
        (
            "\n\nprset = 'mae494'",
            "f:3:1: unknown parameter 'prset'",
            "`parameters()` lists them all",
        ),
        (
            "[aero]\nlaw = 'linear'\ncd0 = 0.3",
            "f:3:1: 'aero.cd0' is a coefficient of robinson, ",
            "robinson",
        ),
        (
            "\"swing.speed\" = 50\n[swing]\nspeed = 40",
            "f:3:1: 'swing.speed' is given twice, here and at line 1",
            "keep one",
        ),
    ]);
}

#[test]
fn a_mistake_of_the_syntax_has_its_line_and_column() {
    let message = SetupFile::read("[club\nloft = 1", "f")
        .unwrap_err()
        .to_string();
    assert!(message.contains("line 1, column"), "{message}");
}

#[test]
fn every_turf_is_recognised_by_its_numbers() {
    assert_eq!(
        Setup::modern_driver().turf().map(|turf| turf.name),
        Some("average")
    );
    for turf in TURFS {
        let mut setup = Setup::modern_driver();
        setup.set("ground.turf", turf.name).unwrap();
        setup.validate().unwrap();
        assert_eq!(setup.turf().map(|found| found.name), Some(turf.name));
        setup.ground.restitution = Some(0.3);
        assert!(setup.turf().is_none());
    }
    let message = Setup::modern_driver()
        .set("ground.turf", "frim")
        .unwrap_err()
        .to_string();
    assert!(
        message.starts_with("unknown turf 'frim'; did you mean 'firm'?")
            && message.contains("the turfs are firm, average, soft, wet"),
        "{message}"
    );
}

#[test]
fn the_turf_is_set_before_its_numbers() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([("ground.rolling", "0.4"), ("ground.turf", "firm")])
        .unwrap();
    assert_eq!(
        (setup.ground.rolling, setup.ground.compliance),
        (0.4, 15.4_f64.to_radians())
    );
    let text = "preset = 'modern-driver'\n[ground]\nrolling = 0.4\nturf = 'firm'";
    assert_eq!(SetupFile::read(text, "a.toml").unwrap().setup, setup);
    assert!(setup.variable("ground.turf").is_err());
}

/// A file cannot state a value and unset it, so the only remedy is to delete a line.
#[test]
fn advice_for_a_conflict_within_a_file_is_to_leave_out_one_of_the_two() {
    let weather = "density and viscosity follow from the weather (air.temperature, air.pressure, \
                   air.altitude, air.humidity)";
    let wind = "wind.right and wind.downrange follow from wind.speed and wind.from";
    for (lines, start, rule) in [
        (
            ["air.density = '1.1 kg/m^3'", "air.temperature = '20 degC'"],
            "a.toml:1:5: air.density and air.temperature are both given",
            weather,
        ),
        (
            ["air.temperature = '20 degC'", "air.viscosity = '2e-5 Pa s'"],
            "a.toml:2:5: air.viscosity and air.temperature are both given",
            weather,
        ),
        (
            ["wind.right = '3 m/s'", "wind.speed = '3 m/s'"],
            "a.toml:1:6: wind.right and wind.speed are both given",
            wind,
        ),
    ] {
        let message = SetupFile::read(&lines.join("\n"), "a.toml")
            .unwrap_err()
            .to_string();
        assert_eq!(
            message,
            format!("{start}: {rule}; leave out one of the two")
        );
        for line in lines {
            assert!(SetupFile::read(line, "a.toml").is_ok(), "{line}");
        }
    }
}

#[test]
fn a_turf_beside_all_of_its_numbers_is_refused() {
    let numbers = "friction = '0.4'\ncompliance = '15.4 deg'\nrolling = '1'\nslope = '0 deg'\n";
    let text = |restitution: &str| {
        format!("[ground]\nrestitution = '{restitution}'\nturf = 'firm'\n{numbers}")
    };
    for restitution in ["0.51", "none"] {
        let message = SetupFile::read(&text(restitution), "a.toml")
            .unwrap_err()
            .to_string();
        let says = "ground.turf is given together with all of its numbers \
                    (ground.restitution, ground.friction, ground.compliance, \
                    ground.rolling): stated numbers override the turf's, so the turf has no \
                    effect; delete ground.turf, or delete the numbers that it should give";
        assert_eq!(message, format!("a.toml:3:1: {says}"));
        let remedied = text(restitution).replace("turf = 'firm'\n", "");
        assert!(SetupFile::read(&remedied, "a.toml").is_ok());
    }
    let firm = SetupFile::read("[ground]\nturf = 'firm'\nslope = '0 deg'", "a.toml")
        .unwrap()
        .setup;
    assert_eq!(firm.turf().unwrap().name, "firm");
    let all =
        ["restitution", "friction", "compliance", "rolling"].map(|name| format!("ground.{name}"));
    let all = all
        .iter()
        .map(|name| (&**name, if name.ends_with("e") { "15 deg" } else { "0.5" }));
    let mut settings: Vec<(&str, &str)> = all.chain([("ground.turf", "firm")]).collect();
    assert!(
        Setup::modern_driver()
            .set_all(settings.clone())
            .unwrap_err()
            .to_string()
            .contains("the turf has no effect")
    );
    settings.remove(0);
    assert!(Setup::modern_driver().set_all(settings).is_ok());
}

#[test]
fn an_indefinite_tensor_is_refused_and_a_broken_triangle_warned_of() {
    let mut setup = Setup::preset("mae494").unwrap();
    assert!(setup.warnings().is_empty());
    setup.club.inertia_xy = 1e-3;
    assert!(matches!(setup.validate(), Err(Error::Inertia { .. })));
    setup.club.inertia_xy = 0.0;
    setup.club.inertia_yy = 1e-2;
    setup.validate().unwrap();
    assert_eq!(setup.warnings().len(), 1);
}
