//! Parameters as arguments of library functions: coefficients of another law and duplicates are
//! refused; parameters can be keys.

use longdrive::batch::Batch;
use longdrive::derivative::{Evaluator, Order, gradient, hessian};
use longdrive::integration::StepChoice;
use longdrive::optimize::Observer;
use longdrive::optimize::least_squares::FitObserver;
use longdrive::parameters::{Law, PRESETS, Parameter, SetupFile};
use longdrive::report::{preset_toml, setup_toml};
use longdrive::study::calibrate::{self, ShotTable, calibrate};
use longdrive::study::uncertainty::{self, Distribution, Uncertain, uncertainty};
use longdrive::study::{
    ChartObserver, DriveRole, Fineness, Landing, Search, Sigma, Vary, chart, effects, map, optimum,
    sensitivity,
};
use longdrive::{Drive, Error, Outcome, Result, Setup};
use std::collections::HashSet;

/// A duplicate parameter would have two equal derivatives: every function of derivatives refuses
/// it.
#[test]
fn a_duplicate_parameter_is_refused_by_name_for_all_derivatives() {
    let setup = Setup::modern_driver();
    let [loft, speed] = ["club.loft", "swing.speed"].map(|name| setup.variable(name).unwrap());
    let twice = [loft, speed, loft];
    let mut all = setup.variables();
    all.push(loft);
    let of = [Outcome::Carry];
    let refused: [(&str, Result<()>); 6] = [
        (
            "gradient",
            gradient(&setup, Outcome::Carry, &twice).map(|_| ()),
        ),
        (
            "hessian",
            hessian(&setup, Outcome::Carry, &[loft, loft]).map(|_| ()),
        ),
        (
            "gradient by all",
            gradient(&setup, Outcome::Carry, &all).map(|_| ()),
        ),
        (
            "values",
            Evaluator::new(&setup, &of, &twice, Order::Value).map(|_| ()),
        ),
        (
            "a batch",
            Batch::new(&setup, &[loft], &of, &[loft, loft]).map(|_| ()),
        ),
        (
            "a batch by what is not swept",
            Batch::new(&setup, &[loft], &of, &[speed, speed]).map(|_| ()),
        ),
    ];
    for (what, refused) in refused {
        let error = refused.expect_err(what);
        assert!(matches!(error, Error::Together { .. }), "{what}: {error:?}");
        assert!(
            error.to_string().contains("is given twice"),
            "{what}: {error}"
        );
    }
    assert!(gradient(&setup, Outcome::Carry, &twice[..2]).is_ok());
}

/// The laws `launch-monitor` and `robinson` each have a coefficient `aero.cd0`. A setup with the
/// law `robinson` has no place for the coefficient of `launch-monitor`: its derivative is an error,
/// not 0.
#[test]
fn a_coefficient_of_another_law_is_refused_everywhere() {
    let mut setup = Setup::modern_driver();
    let stale = setup.variable("aero.cd0").unwrap();
    setup.set_law("robinson").unwrap();
    let own = setup.variable("aero.cd0").unwrap();
    assert!(own != stale && setup.value(stale).is_none());
    let loft = Vary::read(&setup, "club.loft=8deg..12deg").unwrap();
    let range = Vary {
        parameter: stale,
        low: 0.1,
        high: 0.4,
    };
    let sigma = Sigma {
        parameter: stale,
        value: 0.01,
        source: None,
    };
    let of = [Outcome::Carry];
    let search = Search {
        vary: vec![loft],
        ..Search::longest_drive(&setup).unwrap()
    };
    let best = optimum(&setup, search.clone(), Observer::default()).unwrap();
    let spread = Uncertain {
        parameter: stale,
        distribution: Distribution::Uniform {
            low: 0.1,
            high: 0.4,
        },
    };
    let fineness = Fineness {
        nodes: 2,
        slopes: 1,
    };
    let plan = uncertainty::SamplePlan {
        samples: 8,
        seed: 1,
    };
    let shots = "ball_speed [m/s],launch_angle [deg],backspin [rpm],carry \
                 [m]\n60,12,2500,180\n70,11,2500,220\n";
    let shots = ShotTable::read(&setup, "shots.csv", shots.as_bytes()).unwrap();
    let fit = calibrate::FitPlan {
        fit: vec![range],
        starts: 1,
        options: Default::default(),
    };
    let followed = &ChartObserver::default();
    let over = Search {
        vary: vec![range],
        ..search.clone()
    };
    let before = setup;
    let results: Vec<(&str, Result<()>)> = vec![
        (
            "gradient",
            gradient(&setup, Outcome::Carry, &[stale]).map(|_| ()),
        ),
        (
            "gradient with others",
            gradient(&setup, Outcome::Carry, &[loft.parameter, stale]).map(|_| ()),
        ),
        (
            "values",
            Evaluator::new(&setup, &of, &[stale], Order::Value).map(|_| ()),
        ),
        ("set_value", setup.set_value(stale, Some(0.5))),
        (
            "a batch over it",
            Batch::new(&setup, &[stale], &of, &[]).map(|_| ()),
        ),
        (
            "a batch by it",
            Batch::new(&setup, &[loft.parameter], &of, &[stale]).map(|_| ()),
        ),
        (
            "a map",
            map(&setup, Outcome::Carry, range, loft, fineness).map(|_| ()),
        ),
        (
            "effects",
            effects(&setup, &of, &[sigma], &|_, _| ()).map(|_| ()),
        ),
        (
            "a landing",
            Landing::of(DriveRole::AsSetUp, &setup, &[sigma]).map(|_| ()),
        ),
        (
            "uncertainty",
            uncertainty(&setup, &of, &[spread], plan, &|_, _| ()).map(|_| ()),
        ),
        (
            "calibrate",
            calibrate(&setup, &shots, &fit, &FitObserver::default()).map(|_| ()),
        ),
        (
            "an optimum",
            optimum(&setup, over, Observer::default()).map(|_| ()),
        ),
        ("a sensitivity", sensitivity(&best, stale).map(|_| ())),
        (
            "a chart",
            chart(&setup, &search, range, &[], followed).map(|_| ()),
        ),
    ];
    for (what, refused) in results {
        let error = refused.expect_err(what);
        let Error::OtherLaw { name, law, owners } = &error else {
            panic!("{what}: {error:?}")
        };
        assert_eq!(
            (name.as_str(), *law, owners.as_str()),
            ("aero.cd0", "robinson", "launch-monitor"),
            "{what}"
        );
    }
    assert_eq!(setup, before);
}

/// The derivative by a coefficient of the chosen law agrees with differences of the carry.
#[test]
fn differences_of_values_agree_with_the_gradient_by_a_coefficient_after_a_change_of_the_law() {
    let mut setup = Setup::modern_driver();
    setup.set_law("robinson").unwrap();
    let own = setup.variable("aero.cd0").unwrap();
    let (value, h) = (setup.value(own).unwrap(), 1e-5);
    let carry = |by: f64| {
        let mut moved = setup;
        moved.set_value(own, Some(value + by)).unwrap();
        Outcome::Carry.of(&Drive::new(&moved).unwrap()).unwrap()
    };
    let slope = gradient(&setup, Outcome::Carry, &[own]).unwrap().gradient[0];
    assert!(
        (slope - (carry(h) - carry(-h)) / (2.0 * h)).abs() < 1e-5 * slope.abs(),
        "{slope}"
    );
}

/// Rows of the table of parameters are equal if name and law are equal. Different rows have
/// different hashes.
#[test]
fn parameters_and_outcomes_are_keys_and_have_names() {
    let rows: Vec<&Parameter> = Setup::modern_driver()
        .parameters()
        .into_iter()
        .chain(Law::all_rows())
        .collect();
    let different: HashSet<&Parameter> = rows.iter().copied().collect();
    let names: HashSet<_> = rows.iter().map(|row| (row.name, row.law)).collect();
    assert_eq!(different.len(), names.len());
    assert!(
        rows.iter()
            .all(|row| row.to_string() == row.name && different.contains(row))
    );
    let outcomes: HashSet<Outcome> = Outcome::OF_DRIVES
        .iter()
        .chain(Outcome::OF_HEAD)
        .copied()
        .collect();
    assert_eq!(
        outcomes.len(),
        Outcome::OF_DRIVES.len() + Outcome::OF_HEAD.len()
    );
    for of in outcomes {
        assert_eq!(
            (of.to_string().as_str(), Outcome::named(of.name()).unwrap()),
            (of.name(), of)
        );
    }
    assert_eq!(format!("{:>8}", Outcome::Carry), "   carry");
    assert!(matches!(
        Outcome::named("cary"),
        Err(Error::Unknown {
            suggestion: Some(_),
            ..
        })
    ));
}

/// An impossible range of a `Vary` is refused before the search, and the message names the
/// parameter.
#[test]
fn impossible_ranges_are_refused_by_the_name_of_the_parameter() {
    let setup = Setup::modern_driver();
    let loft = setup.variable("club.loft").unwrap();
    let search = |low: f64, high: f64| Search {
        vary: vec![Vary {
            parameter: loft,
            low,
            high,
        }],
        ..Search::longest_drive(&setup).unwrap()
    };
    for (low, high, says) in [
        (f64::NAN, 0.3, "club.loft = NaN is not a number"),
        (0.3, 0.1, "the range is reversed"),
    ] {
        let error = optimum(&setup, search(low, high), Observer::default())
            .unwrap_err()
            .to_string();
        assert!(
            error.contains(says) && error.contains("club.loft"),
            "{error}"
        );
    }
    let mut held = search(0.1, 0.3);
    held.subject_to = vec![longdrive::study::Constraint::read("apex_height <= 30 m").unwrap()];
    held.subject_to[0].low = f64::NAN;
    let error = optimum(&setup, held, Observer::default())
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("apex_height <= 30 m") && error.contains("NaN"),
        "{error}"
    );
}

/// With other weather, density and viscosity are not given; with backspin, no club strikes a ball.
#[test]
fn exact_remark_of_an_unset_value_beside_values_that_replace_it() {
    let remark = |setup: &Setup<f64>, name: &str| {
        let text = setup_toml(setup, &SetupFile::of_preset("mae494").unwrap(), &[], &[]).unwrap();
        let unset = format!("\n{name} = \"none\" # ");
        let (_, after) = text.split_once(&unset).unwrap();
        after.lines().next().unwrap().to_owned()
    };
    let mut warm = Setup::preset("mae494").unwrap();
    warm.set("air.temperature", "30 degC").unwrap();
    for name in ["pressure", "altitude", "humidity"] {
        let given = "density and viscosity are given, or other weather";
        assert!(remark(&warm, name).starts_with(given), "{name}");
    }
    let mut launched = Setup::preset("mae494").unwrap();
    let conditions = [
        ("launch.ball_speed", "160 mph"),
        ("launch.launch_angle", "12 deg"),
        ("launch.backspin", "2500 rpm"),
    ];
    launched.set_all(conditions).unwrap();
    assert_eq!(
        remark(&launched, "spin"),
        "the club strikes the ball, or launch.backspin is given"
    );
}

/// A setup equals the setup that is read from its file. The file has the time step only if the
/// setup states one.
#[test]
fn exact_setups_are_equal_after_a_file_and_their_steps_are_written_only_where_stated() {
    let written = |setup: &Setup<f64>, preset: &str| {
        setup_toml(setup, &SetupFile::of_preset(preset).unwrap(), &[], &[]).unwrap()
    };
    for preset in PRESETS {
        let setup = Setup::preset(preset.name).unwrap();
        let toml = written(&setup, preset.name);
        assert_eq!(SetupFile::read(&toml, "a.toml").unwrap().setup, setup);
        assert_eq!(toml.contains("\nstep = "), setup.states_step, "{toml}");
        for choice in [
            StepChoice::Micrometre,
            StepChoice::Own,
            StepChoice::Within(1e-3),
        ] {
            let flown = choice.for_setup(&setup).unwrap();
            let is_own =
                choice == StepChoice::Own || choice == StepChoice::Micrometre && setup.states_step;
            assert_eq!(
                flown.accuracy.is_none(),
                is_own,
                "{} {choice:?}",
                preset.name
            );
            assert_eq!(choice.is_own(&setup), is_own);
            // a step that the program chose does not count as stated
            assert_eq!(flown.setup.states_step, setup.states_step);
        }
    }
    let usual = Setup::preset("tour-average").unwrap();
    for (name, text) in [("flight.step", "10 ms"), ("flight.method", "rk4")] {
        let mut stated = usual;
        stated.set(name, text).unwrap();
        assert_eq!(
            (stated.method, stated.flight.step),
            (usual.method, usual.flight.step)
        );
        assert!(stated != usual && StepChoice::default().is_own(&stated));
        let toml = written(&stated, "tour-average");
        assert_eq!(SetupFile::read(&toml, "a.toml").unwrap().setup, stated);
    }
}

#[test]
fn same_drive_with_an_unset_parameter_and_with_its_documented_value() {
    let with = |settings: &[(&str, &str)]| {
        let mut setup = Setup::modern_driver();
        settings
            .iter()
            .for_each(|(name, text)| setup.set(name, text).unwrap());
        setup
    };
    let weights = [
        ("club.weight_1.mass", "10 g"),
        ("club.weight_1.depth", "60 mm"),
        ("club.weight_2.mass", "5 g"),
    ];
    let club = with(
        &[
            &weights[..],
            &[("swing.shaft_bend", "2 deg"), ("strike.toe", "9 mm")],
        ]
        .concat(),
    );
    let launch = [
        ("launch.ball_speed", "70 m/s"),
        ("launch.launch_angle", "11 deg"),
    ];
    let bases = [
        club,
        with(&[&launch[..], &[("launch.backspin", "2500 rpm")]].concat()),
        with(&[&launch[..], &[("launch.spin", "2500 rpm")]].concat()),
    ];
    let mut counted = 0;
    for parameter in bases[0]
        .parameters()
        .into_iter()
        .filter(|parameter| parameter.default_value().is_none())
    {
        assert_eq!(
            parameter.unset.is_some(),
            parameter.doc.ends_with("unset: 0."),
            "{}",
            parameter.name
        );
        let Some(unset) = parameter.unset else {
            continue;
        };
        let drives = bases.iter().filter_map(|base| {
            let drive = |value: Option<f64>| {
                let mut setup = *base;
                setup
                    .set_value(parameter, value)
                    .ok()
                    .and_then(|()| Drive::new(&setup).ok())
            };
            Some((
                drive(None)?,
                drive(Some(unset))?,
                drive(Some(unset + 0.01))?,
            ))
        });
        let outcomes = |drive: &Drive<f64>| {
            Outcome::OF_DRIVES
                .iter()
                .filter_map(|of| of.value(drive))
                .collect::<Vec<_>>()
        };
        let drives: Vec<_> = drives
            .map(|(a, b, other)| [&a, &b, &other].map(outcomes))
            .collect();
        for [a, b, _] in &drives {
            let far = a
                .iter()
                .zip(b)
                .find(|(a, b)| (*a - *b).abs() > 1e-9 * a.abs().max(1.0));
            assert!(
                a.len() == b.len() && far.is_none(),
                "{}: {far:?}",
                parameter.name
            );
        }
        assert!(
            drives.iter().any(|[a, _, other]| a != other),
            "{}: the drive does not depend on the value",
            parameter.name
        );
        counted += 1;
    }
    assert!(
        counted >= 18,
        "only {counted} parameters count as a value where unset"
    );
}

#[test]
fn values_that_are_not_as_many_as_their_parameters_are_refused() {
    let setup = Setup::modern_driver();
    let parameters = ["club.loft", "swing.speed"].map(|name| setup.parameter(name).unwrap());
    for values in [&[0.2][..], &[0.2, 45.0, 1.0]] {
        let message = setup
            .with_values(&parameters, values)
            .unwrap_err()
            .to_string();
        assert!(
            message.contains("for 2 parameters; give one value for each"),
            "{message}"
        );
    }
    let changed = setup.with_values(&parameters, &[0.2, 45.0]).unwrap();
    assert_eq!((changed.club.loft, changed.swing.speed), (0.2, 45.0));
}

#[test]
fn a_preset_printed_as_a_setup_file_reads_back_as_itself() {
    for preset in PRESETS {
        let text = preset_toml(preset.name).unwrap();
        let read = SetupFile::read(&text.replace("preset =", "# preset ="), preset.name)
            .unwrap()
            .setup;
        assert_eq!(read, Setup::preset(preset.name).unwrap(), "{text}");
    }
}

#[test]
fn same_setup_of_every_law_after_writing_and_reading() {
    for (k, law) in Law::NAMES.iter().enumerate() {
        for preset in PRESETS {
            let mut setup = Setup::preset(preset.name).unwrap();
            setup.set_law(law).unwrap();
            for (i, parameter) in setup.variables().into_iter().enumerate() {
                // change each value a little, to a value with many digits, within its range
                let factor = 1.0 + 1e-3 * ((i + 50 * k) as f64).sin();
                let value = setup.value(parameter).unwrap() * factor;
                setup.set_value(parameter, Some(value)).unwrap();
            }
            let file = SetupFile::of_preset(preset.name).unwrap();
            let text = setup_toml(&setup, &file, &["a file\nwith a break".into()], &[]).unwrap();
            assert_eq!(SetupFile::read(&text, "f").unwrap().setup, setup, "{text}");
            assert!(
                text.starts_with("# a file with a break\npreset = "),
                "{text}"
            );
        }
    }
}
