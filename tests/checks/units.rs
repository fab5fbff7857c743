//! Quantities read from texts: units, and messages about wrong ones.

use longdrive::units::{Quantity, UnitError};

#[test]
fn exact_definitions_of_units() {
    for (quantity, text, si) in [
        (Quantity::SPEED, "1 mph", 0.44704),
        (Quantity::SPEED, "3.6 km/h", 1.0),
        (Quantity::LENGTH, "1 yd", 0.9144),
        (Quantity::LENGTH, "-0.5in", -0.0127),
        (Quantity::MASS, "1 lb", 0.45359237),
        (Quantity::MASS, "1 oz", 0.028349523125),
        (Quantity::INERTIA, "5679 g cm^2", 5.679e-4),
        (Quantity::INERTIA, "5679 g·cm²", 5.679e-4),
        (Quantity::INERTIA, "5679 g-cm2", 5.679e-4),
        (Quantity::INERTIA, "5679 g-cm²", 5.679e-4),
        (Quantity::DENSITY, "1.2 kg/m3", 1.2),
        (Quantity::DENSITY, "1.2 g/L", 1.2),
        (Quantity::VISCOSITY, "0.0181 cP", 1.81e-5),
        (Quantity::VISCOSITY, "1.81e-5 N s/m^2", 1.81e-5),
        (Quantity::ACCELERATION, "9.81 m s^-2", 9.81),
        (Quantity::ANGULAR_VELOCITY, "60 rpm", std::f64::consts::TAU),
        (Quantity::ANGLE, "90°", std::f64::consts::FRAC_PI_2),
        (Quantity::ANGLE, "\u{2212}90°", -std::f64::consts::FRAC_PI_2),
        (Quantity::RATE, "4 %/s", 0.04),
        (Quantity::VISCOSITY, "1.8e-5 Pa.s", 1.8e-5),
        (Quantity::VISCOSITY, "1.8e-5 Pa·s", 1.8e-5),
        (Quantity::VISCOSITY, "1.8e-5 Pa s", 1.8e-5),
        (Quantity::NUMBER, "0.83", 0.83),
        (Quantity::PRESSURE, "1013.25 mbar", 101_325.0),
        (Quantity::PRESSURE, "101.325 kPa", 101_325.0),
        (Quantity::TEMPERATURE, "25 degC", 298.15),
        (Quantity::TEMPERATURE, "-40 °C", 233.15),
        (Quantity::TEMPERATURE, "300 K", 300.0),
    ] {
        let value = quantity.read(text).unwrap();
        assert!(
            (value - si).abs() <= 2e-16 * si.abs(),
            "{text}: {value} != {si}"
        );
    }
    for (quantity, text, si) in [
        (Quantity::INERTIA, "5679 g cm^2", 5.679e-4),
        (Quantity::MASS, "45.93 g", 0.04593),
        (Quantity::LENGTH, "21.335 mm", 0.021335),
        (Quantity::SPEED, "110 mph", 49.1744),
        (Quantity::ANGLE, "10 deg", 0.174_532_925_199_432_95),
    ] {
        assert_eq!(quantity.read(text), Ok(si), "to the last bit");
    }
    assert_eq!(Quantity::LENGTH.read("inf"), Ok(f64::INFINITY));
}

#[test]
fn exact_zeros_of_temperatures_and_none_of_their_differences() {
    for (text, kelvin) in [
        ("-40 degF", 233.15),
        ("32 °F", 273.15),
        ("212 °F", 373.15),
        ("-459.67 degF", 0.0),
    ] {
        assert!(
            (Quantity::TEMPERATURE.read(text).unwrap() - kelvin).abs() < 1e-12,
            "{text}"
        );
    }
    for (text, kelvin) in [("2 degC", 2.0), ("-9 degF", -5.0), ("3 K", 3.0)] {
        assert!(
            (Quantity::TEMPERATURE.read_difference(text).unwrap() - kelvin).abs() < 1e-15,
            "{text}"
        );
    }
    assert_eq!(
        Quantity::SPEED.read_difference("110 mph"),
        Quantity::SPEED.read("110 mph")
    );
    // degC and degF have their own zero, so they cannot be factors of another unit
    for text in ["2 degC^1 1", "2 1/degC", "2 degF^2", "2 K degC/K"] {
        assert!(
            matches!(
                Quantity::TEMPERATURE.read(text),
                Err(UnitError::UnknownUnit { .. })
            ),
            "{text}"
        );
    }
    let missing = Quantity::TEMPERATURE.read("20").unwrap_err().to_string();
    assert!(
        missing.contains("\"20\" has no unit; a temperature takes degC, degF, K"),
        "{missing}"
    );
}

#[test]
fn messages_list_every_unit_of_a_kind_and_each_is_read() {
    for (quantity, units) in [
        (Quantity::LENGTH, "m, mm, yd, in, um, cm, km, ft, mi"),
        (Quantity::SPEED, "mph, m/s, km/h, ft/s, kph, kn"),
        (Quantity::MASS, "g, kg, oz, mg, lb"),
        (Quantity::VISCOSITY, "Pa s, cP, P"),
        (Quantity::NUMBER, "no unit, or %"),
    ] {
        assert_eq!(quantity.units(), units);
        for unit in units
            .split(", ")
            .filter(|unit| *unit != "no unit")
            .map(|unit| unit.trim_start_matches("or "))
        {
            assert!(quantity.size_of(unit).is_some(), "{unit}");
        }
        let message = quantity.read("1 fox").unwrap_err().to_string();
        assert!(message.ends_with(units), "{message}");
    }
}

#[test]
fn an_unknown_unit_gets_a_suggestion() {
    for (quantity, text, meant) in [
        (Quantity::LENGTH, "3 MM", "'MM' (did you mean 'mm'?)"),
        (
            Quantity::ANGLE,
            "10,5 deg",
            "(leave out commas between thousands, and write a decimal point)",
        ),
        (Quantity::ANGLE, "10 dg", "'dg'; an angle takes"),
    ] {
        let message = quantity.read(text).unwrap_err().to_string();
        assert!(message.contains(meant), "{message}");
    }
}

#[test]
fn wrong_missing_and_unknown_units_have_different_messages() {
    assert!(matches!(
        Quantity::ANGLE.read("10 kg"),
        Err(UnitError::WrongKind { .. })
    ));
    assert!(matches!(
        Quantity::ANGLE.read("10"),
        Err(UnitError::NoUnit { .. })
    ));
    assert!(matches!(
        Quantity::ANGLE.read("10 dg"),
        Err(UnitError::UnknownUnit { .. })
    ));
    assert!(matches!(
        Quantity::ANGLE.read("ten deg"),
        Err(UnitError::NoNumber { .. })
    ));
    for text in ["NaN", "nan deg", "-nandeg"] {
        assert!(
            matches!(
                Quantity::ANGLE.read(text),
                Err(UnitError::NotANumber { .. })
            ),
            "{text}"
        );
    }
    assert!(matches!(
        Quantity::ANGULAR_VELOCITY.read("10 1/s"),
        Err(UnitError::WrongKind { .. })
    ));
    assert!(matches!(
        Quantity::SPEED.read("10 m/"),
        Err(UnitError::UnknownUnit { .. })
    ));
    assert!(matches!(
        Quantity::SPEED.read("10 m//s"),
        Err(UnitError::UnknownUnit { .. })
    ));
    for text in ["10 m^99 s", "10 m^-128 s"] {
        assert!(
            matches!(
                Quantity::SPEED.read(text),
                Err(UnitError::UnknownUnit { .. })
            ),
            "{text}"
        );
    }
    assert_eq!(Quantity::ANGLE.read_bare("0.25"), Ok(0.25));
}
