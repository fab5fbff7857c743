//! Air from the weather, and wind from speed and direction: compared with published densities and
//! pressures, in drives, and with contradictory settings.

use crate::command_line::{json, longdrive, number};
use crate::common::{all_blocks, changed, close};
use longdrive::atmosphere::{AirState, WindField, in_effect};
use longdrive::batch::{Batch, Grid, Points};
use longdrive::derivative::{Order, evaluate};
use longdrive::parameters::{Parameter, SetupFile};
use longdrive::report::setup_toml;
use longdrive::study::Sigma;
use longdrive::study::certificate::certify;
use longdrive::study::uncertainty::{Distribution, Uncertain};
use longdrive::{Drive, Error, Outcome, Setup};
use std::fs;

fn state(settings: &[(&str, &str)]) -> AirState<f64> {
    AirState::of(&changed(&Setup::modern_driver(), settings).air)
}

const DENVER: [(&str, &str); 3] = [
    ("air.temperature", "68 degF"),
    ("air.altitude", "1 mi"),
    ("air.humidity", "40 %"),
];

#[test]
fn published_densities_of_moist_air_within_1e_4() {
    for (temperature, pressure, humidity, published) in [
        // Gupta, Mass Metrology: table of air densities from CIPM's equation
        ("10 degC", "730 mmHg", "40 %", 1.19569),
        ("40 degC", "760 mmHg", "40 %", 1.11497),
        // ASHRAE's real-gas formulation (Hyland & Wexler 1983), dry and moist, with its own
        // equation of state and vapour pressure
        ("20 degC", "1013.25 hPa", "0", 1.204_477_7),
        ("20 degC", "1013.25 hPa", "70 %", 1.197_143_6),
        // dry air at 0 degC: mass of a litre by Regnault, as used since 1908
        ("0 degC", "760 mmHg", "0", 1.2930),
    ] {
        let weather = [
            ("air.temperature", temperature),
            ("air.pressure", pressure),
            ("air.humidity", humidity),
        ];
        close(
            state(&weather).density,
            published,
            published,
            1e-4,
            &format!("{weather:?}"),
        );
    }
}

/// The equation in its molar form, ρ = p M_a/(Z R T) (1 − x (1 − M_v/M_a)), with the molar masses
/// and the gas constant of the paper.
#[test]
fn independent_molar_form_of_cipm_2007_in_all_its_terms() {
    let (dry_air, water, gas) = (28.965_46e-3, 18.015_28e-3, 8.314_472);
    for celsius in [-20.0, 0.0, 15.0, 21.0, 27.0, 40.0_f64] {
        for pressure in [30e3, 60e3, 101_325.0, 110e3_f64] {
            for humidity in [0.0, 0.3, 1.0] {
                let kelvin = 273.15 + celsius;
                let vapour_pressure = 33.937_110_47 - 6343.1645 / kelvin - 0.019_121_316 * kelvin
                    + 0.000_012_378_847 * kelvin.powi(2);
                let x = humidity * vapour_pressure.exp() / pressure
                    * (1.00062 + 3.14e-8 * pressure + 5.6e-7 * celsius.powi(2));
                let a = [1.58123e-6, -2.9331e-8, 1.1043e-10];
                let first = a[0]
                    + a[1] * celsius
                    + a[2] * celsius.powi(2)
                    + (5.707e-6 - 2.051e-8 * celsius) * x
                    + (1.9898e-4 - 2.376e-6 * celsius) * x.powi(2);
                let z = 1.0 - pressure / kelvin * first
                    + (pressure / kelvin).powi(2) * (1.83e-11 - 0.765e-8 * x.powi(2));
                let density =
                    pressure * dry_air / (z * gas * kelvin) * (1.0 - x * (1.0 - water / dry_air));
                let mut setup = Setup::modern_driver();
                (setup.air.temperature, setup.air.pressure) = (Some(kelvin), Some(pressure));
                setup.air.humidity = Some(humidity);
                // the paper rounds M_a/R to 3.483740e-3 and 1 − M_v/M_a to 0.3780
                let rounded = 2e-7 + 5e-5 * x;
                close(
                    AirState::of(&setup.air).density,
                    density,
                    density,
                    rounded,
                    &format!("{celsius} {pressure}"),
                );
            }
        }
    }
}

#[test]
fn published_pressures_of_the_standard_atmosphere_and_viscosities() {
    // the barometric formula p = p₀ exp(−g/R ∫ dh/T), with ∫ dh/T by Simpson's rule
    let simpson = |height: f64| {
        let n = 200;
        let at = |k: i32| 1.0 / (288.15 - 0.0065 * height * f64::from(k) / f64::from(n));
        let weight = |k: i32| {
            if k == 0 || k == n {
                1.0
            } else {
                2.0 + 2.0 * f64::from(k % 2)
            }
        };
        let sum: f64 = (0..=n).map(|k| weight(k) * at(k)).sum();
        101_325.0 * (-9.80665 / 287.05287 * sum * height / (3.0 * f64::from(n))).exp()
    };
    for (altitude, published) in [
        (0.0, 101_325.0),
        (1000.0, 89_874.6),
        (1609.0, simpson(1609.0)),
        (5000.0, 54_019.9),
        (11_000.0, 22_632.0),
    ] {
        close(
            simpson(altitude),
            published,
            published,
            2e-6,
            "the integral",
        );
        let by = |name: &str, value: f64| {
            let mut setup = Setup::modern_driver();
            setup
                .set_value(setup.parameter(name).unwrap(), Some(value))
                .unwrap();
            AirState::of(&setup.air).density
        };
        close(
            by("air.altitude", altitude),
            by("air.pressure", published),
            1.0,
            2e-6,
            &format!("{altitude} m"),
        );
    }
    // U.S. Standard Atmosphere 1976, at sea level and at 11 km
    for (temperature, published) in [("288.15 K", 1.7894e-5), ("216.65 K", 1.4216e-5)] {
        close(
            state(&[("air.temperature", temperature)]).viscosity,
            published,
            published,
            3e-5,
            temperature,
        );
    }
    // dry air with the default weather, 25 degC at sea level, is the air of the default drive
    let usual = state(&[("air.humidity", "0")]);
    close(usual.density, 1.184, 1.184, 3e-4, "density of the default");
    close(
        usual.viscosity,
        1.837e-5,
        1.837e-5,
        2e-4,
        "viscosity of the default",
    );
    assert_eq!(
        state(&[]),
        AirState {
            density: 1.184,
            viscosity: 1.837e-5
        }
    );
}

#[test]
fn same_drive_by_weather_and_by_its_density_and_by_wind_components() {
    let mut setup = changed(&Setup::modern_driver(), &DENVER);
    setup
        .set_all([
            ("wind.speed", "5 m/s"),
            ("wind.from", "60 deg"),
            ("strike.toe", "8 mm"),
        ])
        .unwrap();
    let mut given = Setup::modern_driver();
    given.set("strike.toe", "8 mm").unwrap();
    AirState {
        density: given.air.density,
        viscosity: given.air.viscosity,
    } = AirState::of(&setup.air);
    [given.wind.right, given.wind.downrange] = [
        -5.0 * 60_f64.to_radians().sin(),
        -5.0 * 60_f64.to_radians().cos(),
    ];
    let [ours, theirs] = [setup, given].map(|setup| Drive::new(&setup).unwrap());
    for of in Outcome::OF_DRIVES {
        let [ours, theirs] = [&ours, &theirs].map(|drive| of.value(drive).unwrap());
        close(ours, theirs, theirs.abs().max(1.0), 1e-13, of.name());
    }
    assert_eq!(in_effect(&setup).wind.right, given.wind.right);
    // the ball carries farther in thin air and less far in a head wind; a wind from the right moves
    // it to the left
    let carry = |settings: &[(&str, &str)]| {
        let high = changed(
            &Setup::modern_driver(),
            &[&[("club.loft", "14 deg")], settings].concat(),
        );
        Outcome::Carry.of(&Drive::new(&high).unwrap()).unwrap()
    };
    assert!(carry(&DENVER) > carry(&[]) + 5.0);
    let wind = |from: &'static str| [("wind.speed", "5 m/s"), ("wind.from", from)];
    assert!(carry(&wind("0 deg")) < carry(&[]) - 5.0 && carry(&wind("180 deg")) > carry(&[]) + 5.0);
    let lateral = Outcome::Lateral
        .of(&Drive::new(&changed(&Setup::modern_driver(), &wind("90 deg"))).unwrap())
        .unwrap();
    assert!(lateral < -5.0, "{lateral}");
}

#[test]
fn same_drive_in_other_weather_from_a_written_setup_and_from_its_preset() {
    let base = SetupFile::of_preset("tour-average").unwrap();
    let setup = base.setup;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("me.toml").display().to_string();
    fs::write(&file, setup_toml(&setup, &base, &[], &[]).unwrap()).unwrap();
    let carry = |from: &str| {
        let weather = ["--temperature", "40degF", "--wind", "10mph"];
        let words = [&["simulate", from, "--set", "wind.from=0deg"], &weather[..]].concat();
        let (status, found) = json(&words);
        assert_eq!(status, 0, "{found}");
        number(&found["flight"]["carry"])
    };
    assert_eq!(carry(&file), carry("tour-average"));
}

#[test]
fn differences_certify_every_derivative_by_weather_and_wind() {
    let stations = [
        ("air.temperature", "8 degC"),
        ("air.pressure", "24.9 inHg"),
        ("air.humidity", "80 %"),
    ];
    let winds = [("wind.speed", "6 m/s"), ("wind.from", "-35 deg")];
    for weather in [DENVER, stations] {
        let setup = changed(&Setup::modern_driver(), &[&weather[..], &winds].concat());
        let names = weather.iter().chain(&winds).map(|(name, _)| *name);
        let wrt: Vec<&'static Parameter> =
            names.map(|name| setup.variable(name).unwrap()).collect();
        let of = [
            Outcome::Carry,
            Outcome::Lateral,
            Outcome::FlightTime,
            Outcome::DescentAngle,
        ];
        let certificate = certify(&setup, &of, &wrt, &|_, _| true).unwrap();
        assert!(
            certificate.passed() && certificate.rows.len() == 4 * wrt.len(),
            "{weather:?}"
        );
        // derivatives by all parameters are computed through the inputs of the flight (chain rule);
        // derivatives by these few parameters are computed directly
        let (all, found) = (
            setup.variables(),
            evaluate(&setup, &of, &wrt, Order::Second).unwrap(),
        );
        let chained = evaluate(&setup, &of, &all, Order::Second).unwrap();
        let place =
            |parameter: &Parameter| all.iter().position(|other| *other == parameter).unwrap();
        for (few, many) in found.iter().zip(&chained) {
            for (i, a) in wrt.iter().enumerate() {
                let slope = few.gradient[i];
                close(
                    many.gradient[place(a)],
                    slope,
                    slope.abs().max(1e-6),
                    1e-9,
                    a.name,
                );
                for (j, b) in wrt.iter().enumerate() {
                    let bend = few.hessian[i][j];
                    let size = (few.hessian[i][i] * few.hessian[j][j])
                        .abs()
                        .sqrt()
                        .max(bend.abs())
                        .max(1e-9);
                    close(many.hessian[place(a)][place(b)], bend, size, 1e-7, b.name);
                }
            }
        }
    }
}

#[test]
fn same_drives_in_a_sweep_over_the_weather_and_alone() {
    let setup = changed(
        &Setup::modern_driver(),
        &[
            ("air.humidity", "50 %"),
            ("wind.speed", "4 m/s"),
            ("wind.from", "30 deg"),
        ],
    );
    // the setup has no temperature and no altitude: only the points state them
    let over = [
        "air.temperature=0..35degC:4",
        "air.altitude=0..2000m:3",
        "wind.from=-90deg..90deg:5",
    ];
    let axes = over.map(|text| longdrive::batch::GridAxis::read(&setup, text).unwrap());
    let mut grid = Grid::new(axes.to_vec()).unwrap();
    let names = ["air.temperature", "air.altitude", "wind.from"];
    let wrt = names.map(|name| setup.parameter(name).unwrap());
    let mut rows = 0;
    let batch = Batch::new(&setup, grid.parameters(), &[Outcome::Carry], &wrt).unwrap();
    for block in all_blocks(&batch, &mut grid) {
        for row in 0..block.rows() {
            let mut alone = setup;
            for (parameter, value) in wrt.iter().zip(block.point(row)) {
                alone.set_value(parameter, Some(*value)).unwrap();
            }
            let exact = evaluate(&alone, &[Outcome::Carry], &wrt, Order::First)
                .unwrap()
                .remove(0);
            close(
                block.outcome(row, 0).unwrap(),
                exact.value,
                exact.value,
                1e-12,
                "carry",
            );
            for (ours, theirs) in block.derivatives(row).zip(&exact.gradient) {
                close(
                    ours.unwrap(),
                    *theirs,
                    theirs.abs().max(1.0),
                    1e-11,
                    "derivative",
                );
            }
            rows += 1;
        }
    }
    assert_eq!(rows, 60);
}

#[test]
fn uncertainties_of_a_temperature_are_differences() {
    let setup = changed(&Setup::modern_driver(), &[("air.temperature", "77 degF")]);
    assert!((setup.air.temperature.unwrap() - 298.15).abs() < 1e-12);
    for (text, kelvin) in [("2degC", 2.0), ("3.6 degF", 2.0), ("2 K", 2.0)] {
        let sigma = Sigma::read(&setup, &format!("air.temperature={text}")).unwrap();
        assert!(
            (sigma.value - kelvin).abs() < 1e-12,
            "{text}: {}",
            sigma.value
        );
    }
    let read = |text: &str| {
        Uncertain::read(&setup, &format!("air.temperature={text}"))
            .unwrap()
            .distribution
    };
    assert_eq!(
        read("normal(20 degC, 2 degC)"),
        Distribution::Normal {
            mean: 293.15,
            deviation: 2.0
        }
    );
    assert_eq!(
        read("uniform(10 degC, 20 degC)"),
        Distribution::Uniform {
            low: 283.15,
            high: 293.15
        }
    );
    let (status, found) = json(&["sensitivity", "--set", "air.temperature=77degF"]);
    assert_eq!(status, 0);
    let text = found.to_string();
    assert!(
        text.contains("air.temperature") && !text.contains("\"parameter\":\"air.density\""),
        "{text}"
    );
}

#[test]
fn the_effective_density_is_shown_and_setups_read_back() {
    let set: Vec<String> = DENVER
        .iter()
        .map(|(name, text)| format!("{name}={text}"))
        .collect();
    let set: Vec<&str> = set.iter().flat_map(|text| ["--set", text]).collect();
    let density = state(&DENVER).density;
    let (_, found) = json(&[&["simulate"], &set[..]].concat());
    assert_eq!(number(&found["setup"]["air.density"]), density);
    let (_, found) = json(&[&["parameters"], &set[..]].concat());
    let rows = found["parameters"].as_array().unwrap();
    let row = rows
        .iter()
        .find(|row| row["parameter"] == "air.density")
        .unwrap();
    assert_eq!(number(&row["value"]), density);
    let setup = changed(&Setup::modern_driver(), &DENVER);
    let base = SetupFile::of_preset("modern-driver").unwrap();
    let text = setup_toml(&setup, &base, &[], &[]).unwrap();
    assert!(
        !text.contains("\ndensity") && text.contains("\nhumidity = \"0.4\""),
        "{text}"
    );
    assert_eq!(SetupFile::read(&text, "f").unwrap().setup, setup, "{text}");
}

#[test]
fn contradictory_weather_settings_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let dense = file("dense.toml", "[air]\ndensity = '1.1 kg/m^3'\n");
    let warm = file("warm.toml", "[air]\ntemperature = '30 degC'\n");
    let both = file(
        "both.toml",
        "[air]\ntemperature = '30 degC'\ndensity = '1.1 kg/m^3'\n",
    );
    let rows = file(
        "rows.csv",
        "air.density [kg/m^3],air.temperature [degC]\n1.1,20\n",
    );
    let shots = file(
        "shots.csv",
        "club.loft [deg],air.temperature [degC],carry [yd]\n10,20,250\n11,25,255\n12,10,260\n",
    );
    let weather = "air.density and air.temperature are both given: density and viscosity follow \
                   from the weather";
    for (args, says) in [
        (
            &[
                "simulate",
                "--set",
                "air.density=1.1kg/m^3",
                "--set",
                "air.temperature=20degC",
            ][..],
            weather,
        ),
        (
            &[
                "simulate",
                "--set",
                "air.temperature=20degC",
                "--set",
                "air.density=1.1kg/m^3",
            ],
            weather,
        ),
        (
            &["simulate", &dense, "--set", "air.temperature=20degC"],
            weather,
        ),
        (
            &["simulate", &warm, "--set", "air.density=1.1kg/m^3"],
            weather,
        ),
        (&["simulate", &both], weather),
        (&["simulate", &both], "both.toml:3:1: air.density"),
        (&["sweep", "--points", &rows], weather),
        (
            &["sweep", &dense, "--over", "air.temperature=0..30degC:3"],
            weather,
        ),
        (
            &[
                "calibrate",
                &shots,
                "--set",
                "air.density=1.1kg/m^3",
                "--fit",
                "aero.cd0",
            ],
            weather,
        ),
        (&["calibrate", &shots, "--fit", "air.density"], weather),
        (
            &[
                "simulate",
                "--set",
                "air.viscosity=2e-5Pa.s",
                "--set",
                "air.humidity=0.5",
            ],
            "air.viscosity and air.humidity are both given",
        ),
        (
            &[
                "simulate",
                "--set",
                "air.pressure=900hPa",
                "--set",
                "air.altitude=1000m",
            ],
            "air.pressure and air.altitude are both given: the altitude gives a pressure too",
        ),
        (
            &[
                "sweep",
                "--set",
                "air.pressure=900hPa",
                "--over",
                "air.altitude=0..1000m:2",
            ],
            "air.pressure and air.altitude are both given",
        ),
        (
            &["simulate", "--set", "wind.speed=5m/s"],
            "wind.speed is given without wind.from: say where",
        ),
        (
            &["simulate", "--set", "wind.from=5deg"],
            "wind.from is given without wind.speed: give the speed",
        ),
        (
            &[
                "simulate",
                "--set",
                "wind.from=5deg",
                "--set",
                "wind.speed=5m/s",
                "--set",
                "wind.right=0m/s",
            ],
            "wind.right and wind.speed are both given",
        ),
        (
            &["gradient", &warm, "--of", "carry", "--wrt", "air.density"],
            "air.density cannot be varied, and has no derivatives: air.temperature is given, and \
             density and viscosity follow",
        ),
        (
            &["gradient", &warm, "--of", "carry", "--wrt", "air.humidity"],
            "it is unset here, which means: dry air if other weather is set; give it a value",
        ),
        (
            &["simulate", "--set", "air.humidity=50"],
            "air.humidity = 50 is outside its range 0 ≤ … ≤ 1; a number without a unit is a share \
             of 1; did you mean \"50 %\"?",
        ),
        (
            &["simulate", "--set", "impact.restitution=1.2"],
            "impact.restitution = 1.2 is outside its range 0 ≤ … ≤ 1; it must be at most 1",
        ),
        (
            &["simulate", "--set", "air.humidity=150"],
            "is outside its range 0 ≤ … ≤ 1; it must be at most 1",
        ),
        (
            &["simulate", "--set", "air.temperature=500degF"],
            "air.temperature = 260 degC (500degF) is outside its range",
        ),
        (
            &["simulate", "--set", "air.humidity=-1%"],
            "air.humidity = -0.01 (-1%) is outside its range",
        ),
        (
            &["simulate", "--set", "air.temperature=20K"],
            "air.temperature = -253.15 degC (20K) is outside its range -90 degC ≤ … ≤ 60 degC",
        ),
        (
            &["simulate", "--set", "air.temperature=20"],
            "\"20\" has no unit; a temperature takes degC, degF, K",
        ),
        (
            &["simulate", "--set", "air.temperature=20 deg"],
            "\"20 deg\" is not a temperature",
        ),
        (
            &["simulate", "--set", "air.altitude=20km"],
            "air.altitude = 65616.8 ft (20km) is outside its range",
        ),
        (
            &["simulate", "--set", "air.pressure=29.9hPa"],
            "air.pressure = 29.9 hPa is outside its range 220 hPa",
        ),
    ] {
        let output = longdrive(args);
        let text = format!("{}{}", output.out, output.err);
        assert!(
            output.status == 2 && text.contains(says),
            "{args:?}: {}: no '{says}': {text}",
            output.status
        );
    }
    // each error advises to unset the setting that contradicts the options, and the advice works
    let presets = longdrive(&["presets", "tour-average"]).out;
    let printed = file("printed.toml", &presets);
    let (air, wind) = (
        ["air.temperature=50degF", "air.humidity=40%"],
        ["wind.speed=10mph", "wind.from=0deg"],
    );
    let weather = file(
        "weather.toml",
        "[air]\ntemperature = '50 degF'\nhumidity = '40 %'\n",
    );
    let blown = file("blown.toml", "[wind]\nspeed = '10 mph'\nfrom = '0 deg'\n");
    let pressed = file("pressed.toml", "[air]\npressure = '900 hPa'\n");
    for (setup, set, remedy) in [
        (
            &printed,
            &air[..],
            "--set air.density=none --set air.viscosity=none",
        ),
        (
            &printed,
            &wind,
            "--set wind.right=none --set wind.downrange=none",
        ),
        (
            &weather,
            &["air.density=1.1kg/m^3"],
            "--set air.temperature=none --set air.humidity=none",
        ),
        (
            &blown,
            &["wind.right=2m/s"],
            "--set wind.speed=none --set wind.from=none",
        ),
        (
            &pressed,
            &["air.altitude=1000m"],
            "--set air.altitude=none or --set air.pressure=none",
        ),
    ] {
        let set = set.iter().flat_map(|text| ["--set", text]);
        let args: Vec<&str> = ["simulate", setup].into_iter().chain(set).collect();
        let output = longdrive(&args);
        assert!(
            output.status == 2
                && output
                    .err
                    .trim_end()
                    .ends_with(&format!("value of the setup with {remedy}")),
            "{}",
            output.err
        );
        let back = remedy.split(" or ").last().unwrap().split(' ');
        let followed = longdrive(&args.iter().copied().chain(back).collect::<Vec<_>>());
        assert_eq!(followed.status, 0, "{args:?}: {}", followed.err);
        // with the advised options, the drive has only the air and wind of the options
        if *setup == printed {
            let requested: Vec<&str> = ["simulate"]
                .into_iter()
                .chain(args[2..].iter().copied())
                .collect();
            // skips the first lines, which name the setup
            let drive = |out: &str| out.split_once("\n\n").unwrap().1.to_owned();
            assert_eq!(drive(&followed.out), drive(&longdrive(&requested).out));
        }
    }
    let none = presets
        .lines()
        .map(|line| match line.split(" = ").next().unwrap() {
            name @ ("density" | "viscosity" | "right" | "downrange") => {
                format!("{name} = \"none\"\n")
            }
            "temperature" => "temperature = \"50 degF\"\n".into(),
            "speed" if line.contains("none") => "speed = \"10 mph\"\n".into(),
            "from" => "from = \"0 deg\"\n".into(),
            _ => format!("{line}\n"),
        });
    let none = file("none.toml", &none.collect::<String>());
    let set = [
        "--set",
        "air.temperature=50degF",
        "--set",
        "wind.speed=10mph",
        "--set",
        "wind.from=0deg",
    ];
    let drive = |out: String| out.split_once("\n\n").unwrap().1.to_owned();
    assert_eq!(
        drive(longdrive(&["simulate", &none]).out),
        drive(longdrive(&[&["simulate"][..], &set].concat()).out)
    );
    let output = longdrive(&["simulate", &printed, "--set", "air.density=none"]);
    let says = "air.density: it cannot be unset; give it a value, or also give the parameters that determine it: density and viscosity follow from";
    assert!(
        output.status == 2 && output.err.contains(says),
        "{}",
        output.err
    );
    // each drive of a sweep has the weather
    let over = [
        "sweep",
        &dense,
        "--over",
        "air.temperature=0degC..30degC:3",
        "--outcomes",
        "carry",
    ];
    let swept = longdrive(&[&over[..], &["--set", "air.density=none"]].concat());
    let alike = longdrive(&[&["sweep"][..], &over[2..]].concat());
    assert_eq!((swept.status, &swept.out), (0, &alike.out), "{}", swept.err);
    let idle = longdrive(&[
        "sweep",
        &dense,
        "--over",
        "club.loft=9deg..11deg:3",
        "--set",
        "air.density=none",
    ]);
    assert!(
        idle.status == 2 && idle.err.contains("air.density: it cannot be unset"),
        "{}",
        idle.err
    );
    // the temperature is set and differentiated by; the weather then replaces the density
    let vary = [
        "gradient",
        &dense,
        "--of",
        "carry",
        "--wrt",
        "air.temperature",
        "--set",
        "air.temperature=20degC",
    ];
    assert_eq!(
        longdrive(&[&vary[..], &["--set", "air.density=none"]].concat()).status,
        0
    );
    // accepted: one of the two forms of the air or the wind is unset, in the setup or by the
    // command
    for args in [
        &[
            "simulate",
            &warm,
            "--set",
            "air.temperature=none",
            "--set",
            "air.density=1.1kg/m^3",
        ][..],
        &[
            "simulate",
            "winfield-tan",
            "--set",
            "air.temperature=20degC",
        ],
        &[
            "simulate",
            "--set",
            "wind.speed=5mph",
            "--set",
            "wind.from=-360deg",
            "--set",
            "wind.up=1mph",
        ],
    ] {
        let output = longdrive(args);
        assert_eq!(output.status, 0, "{args:?}: {}", output.err);
    }
    let mut setup = Setup::modern_driver();
    setup.set("air.temperature", "20 degC").unwrap();
    assert!(matches!(
        setup.set("air.density", "1.1 kg/m^3"),
        Err(Error::Together { .. })
    ));
}

#[test]
fn weather_beyond_the_equation_of_the_density_has_a_warning() {
    let message = |settings: &[(&str, &str)]| {
        changed(&Setup::modern_driver(), settings)
            .warnings()
            .iter()
            .map(ToString::to_string)
            .filter(|warning| !warning.contains("changes the air alone"))
            .collect::<Vec<_>>()
    };
    for usual in [
        &DENVER[..],
        &[("air.temperature", "-5 degC"), ("air.humidity", "90 %")],
        &[("air.pressure", "600 hPa")],
    ] {
        assert_eq!(message(usual), [""; 0], "{usual:?}");
    }
    let steam = message(&[
        ("air.temperature", "60 degC"),
        ("air.humidity", "1"),
        ("air.pressure", "220 hPa"),
    ]);
    assert!(steam.len() == 2, "{steam:?}");
    assert!(
        steam[0].starts_with("air.pressure = 220 hPa is below 600 hPa: "),
        "{steam:?}"
    );
    assert!(
        steam[1].starts_with("air.temperature = 60 degC is above 40 degC: "),
        "{steam:?}"
    );
    assert!(
        message(&[("air.altitude", "5 km")])[0]
            .contains("air.altitude = 16404 ft is above 13780 ft")
    );
}

/// `--set air.density=none` is accepted if the command itself varies the temperature.
#[test]
fn a_varied_temperature_replaces_the_density_of_the_setup() {
    let range = "air.temperature=0degC..30degC";
    let normal = "air.temperature=normal(20degC,5degC)";
    let swings = [
        "optimize",
        "--vary",
        "club.loft=8deg..14deg",
        "--distribution",
        normal,
    ];
    for args in [
        &["optimize", "--vary", range][..],
        &["uncertainty", "--samples", "8", "--distribution", normal],
        &["chart", "--along", "air.temperature", "--at", "10degC"],
        &swings,
    ] {
        let args = [args, &["--set", "air.density=none"]].concat();
        let output = crate::command_line::longdrive(&args);
        assert_eq!(output.status, 0, "{args:?}: {}", output.err);
    }
    let idle = ["optimize", "--set", "air.density=none"];
    let output = crate::command_line::longdrive(&idle);
    assert!(
        output.status == 2 && output.err.contains("it cannot be unset"),
        "{}",
        output.err
    );
}

#[test]
fn exact_wind_at_the_reference_height_and_logarithmic_profile_far_above() {
    let mut setup = Setup::modern_driver();
    (setup.wind.downrange, setup.wind.roughness) = (5.0, Some(0.03));
    let field = WindField::new(&setup.wind, &setup.ground);
    assert!((field.at(10.0).z - 5.0).abs() < 1e-14);
    let ratio = field.at(1000.0).z / field.at(100.0).z;
    assert!((ratio - (1000.0 / 0.03_f64).ln_1p() / (100.0 / 0.03_f64).ln_1p()).abs() < 1e-6);
    let below = field.at(-3.0).z;
    assert!(below > 0.0 && below < field.at(0.0).z);
}
