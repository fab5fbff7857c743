//! Files of questions: setups, points and shots, good and bad.

use crate::choices::Choices;
use crate::values::{name_of, near, parameter, preset, setting, value, variable, with_unit};
use std::fs;
use std::path::Path;

/// A setup file.
pub fn setup(choices: &mut Choices) -> Vec<u8> {
    let mut text = String::new();
    if choices.is(0.7) {
        let good = preset(choices);
        let name = choices.good_or_bad(&[good], &["nobody"]);
        text += &format!("preset = \"{name}\"\n");
    }
    let mut named = vec![];
    for _ in 0..choices.below(5) {
        let parameter = parameter(choices);
        if named.contains(&parameter.name) && !choices.makes_mistake() {
            continue;
        }
        named.push(parameter.name);
        let name = name_of(parameter, choices);
        let shown = match choices.below(8) {
            // a bare number is SI
            0 => format!("{:?}", near(parameter, 0.1, choices)),
            1 => choices
                .of(&[
                    "true",
                    "[1, 2]",
                    "{ a = 1 }",
                    "1979-05-27",
                    "nan",
                    "inf",
                    "-1",
                    "99999999999999999999",
                ])
                .into(),
            _ => format!(
                "\"{}\"",
                value(parameter, choices).replace(['"', '\\', '\0'], "")
            ),
        };
        text += &format!("{name} = {shown}\n");
    }
    if choices.is_launched {
        text += "[launch]\nball_speed = \"150 mph\"\nlaunch_angle = \"12 deg\"\n";
        text += choices.of(&[
            "backspin = \"2500 rpm\"\n",
            "spin = \"2500 rpm\"\nspin_axis = \"-2 deg\"\n",
        ]);
    }
    if choices.is(0.2) {
        text += "[aero]\nlaw = \"robinson\"\ncd0 = 0.3\n";
    }
    with_damage(text, choices)
}

/// A table of points to sweep.
pub fn points(choices: &mut Choices) -> Vec<u8> {
    let columns: Vec<_> = (0..1 + choices.below(3))
        .map(|_| {
            if choices.is(0.9) {
                variable(choices)
            } else {
                parameter(choices)
            }
        })
        .collect();
    let units: Vec<&str> = columns
        .iter()
        .map(|column| if choices.is(0.95) { column.unit } else { "" })
        .collect();
    let head = |at: usize, choices: &mut Choices| {
        let name = name_of(columns[at], choices);
        if units[at].is_empty() {
            name
        } else {
            format!("{name} [{}]", units[at])
        }
    };
    let separator = if choices.is(0.7) {
        ","
    } else {
        choices.of(&[";", "\t"])
    };
    // columns that a sweep or a launch monitor writes
    let others = [
        ("status", "landed"),
        ("carry [m]", "200.5"),
        ("d_carry/d_club.loft [m/rad]", ""),
        ("note", "x"),
    ];
    let launch = [
        ("Ball Speed [mph]", "150"),
        ("Launch Angle [deg]", "12"),
        ("Spin Rate [rpm]", "2,500"),
    ];
    let more: &[(&str, &str)] = match choices.below(8) {
        0 => &others,
        1 if separator != "," => &launch,
        _ => &[],
    };
    let joined = |cells: Vec<String>, more: Vec<&str>| {
        cells
            .into_iter()
            .chain(more.into_iter().map(str::to_owned))
            .collect::<Vec<_>>()
            .join(separator)
            + "\n"
    };
    let heads = (0..columns.len()).map(|at| head(at, choices)).collect();
    let mut text = joined(heads, more.iter().map(|(head, _)| *head).collect());
    for _ in 0..(1 + choices.below(7)) * usize::from(!choices.makes_mistake()) {
        let cell = |at: usize, choices: &mut Choices| {
            let size = columns[at]
                .quantity
                .size_of(units[at])
                .filter(|_| !units[at].is_empty())
                .unwrap_or(1.0);
            let number = near(
                columns[at],
                if choices.is(0.05) { 30.0 } else { 0.2 },
                choices,
            ) / size;
            if choices.is(0.02) {
                choices.of(&["", "nan", "inf", "x", "1e400", "\"1"]).into()
            } else {
                format!("{number:?}")
            }
        };
        let cells = (0..columns.len()).map(|at| cell(at, choices)).collect();
        text += &joined(cells, more.iter().map(|(_, cell)| *cell).collect());
    }
    with_damage(text, choices)
}

/// The name and the content of a table of points in another format, or of a damaged table.
pub fn binary(choices: &mut Choices) -> (String, Vec<u8>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/tables");
    let mut names: Vec<_> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    names.retain(|name| {
        Path::new(name)
            .extension()
            .is_some_and(|ending| ending != "py")
    });
    names.sort();
    let name = choices.of(&names).into_string().unwrap();
    let mut bytes = fs::read(folder.join(&name)).unwrap();
    if choices.is(0.3) && !bytes.is_empty() {
        let at = choices.below(bytes.len());
        match choices.below(3) {
            0 => bytes.truncate(at),
            1 => bytes[at] ^= 1 << choices.below(8),
            _ => bytes.insert(at, 0xff),
        }
    }
    (name, bytes)
}

/// An export of a launch monitor: heads, units in the heads or in their own line, letters for the
/// sides, and rows with averages of other rows.
pub fn export(choices: &mut Choices) -> Vec<u8> {
    let all = [
        ("Club Speed", "mph", 105.0, 10.0),
        ("Attack Angle", "deg", 0.0, 3.0),
        ("Ball Speed", "mph", 155.0, 15.0),
        ("Launch Angle", "deg", 12.0, 4.0),
        ("Launch Direction", "deg", 0.0, 3.0),
        ("Spin Rate", "rpm", 2700.0, 600.0),
        ("Spin Axis", "deg", 0.0, 8.0),
        ("Carry", "yds", 240.0, 20.0),
        ("Side", "yds", 0.0, 15.0),
        ("Max Height", "ft", 90.0, 20.0),
        ("Landing Angle", "deg", 38.0, 5.0),
        ("Hang Time", "s", 6.2, 0.4),
    ];
    // the ball speed, which is necessary, is rarely missing
    let columns: Vec<_> = all
        .iter()
        .filter(|(name, ..)| choices.is(if name.contains("ll S") { 0.97 } else { 0.85 }))
        .collect();
    let separator = choices.of(&[",", ";", "\t"]);
    let has_comma = separator != "," && choices.is(0.3);
    let units = choices.below(3);
    let head = |(name, unit, ..): &&(&str, &str, f64, f64)| match units {
        0 => format!("{name} [{unit}]"),
        1 => format!("{name} ({unit})"),
        _ => (*name).to_owned(),
    };
    let mut lines = vec![
        [
            vec!["Player".to_owned()],
            columns.iter().map(head).collect(),
        ]
        .concat(),
    ];
    if units == 2 {
        lines.push(
            [
                vec![String::new()],
                columns
                    .iter()
                    .map(|(_, unit, ..)| format!("[{unit}]"))
                    .collect(),
            ]
            .concat(),
        );
    }
    let rows = 2 + choices.below(7);
    for row in 0..=rows {
        let common = choices.between(-1.0, 1.0);
        let cell = |(name, _, middle, spread): &&(&str, &str, f64, f64), choices: &mut Choices| {
            let value = middle + spread * (0.8 * common + 0.2 * choices.between(-1.0, 1.0));
            let shown = match (
                *middle == 0.0 && !name.starts_with("Attack"),
                choices.below(60),
            ) {
                (_, 0) => String::new(),
                (_, 1) if choices.makes_mistake() => choices
                    .of(&["-", "nan", "x", "1e400", "2,500", "3 L R"])
                    .into(),
                (true, _) => format!("{:.1} {}", value.abs(), if value < 0.0 { "L" } else { "R" }),
                _ => format!("{value:.1}"),
            };
            if has_comma {
                shown.replace('.', ",")
            } else {
                shown
            }
        };
        let first = if row == rows {
            choices.of(&["Average", "Std. Dev.", "A"])
        } else {
            "A"
        };
        lines.push(
            [
                vec![first.to_owned()],
                columns.iter().map(|column| cell(column, choices)).collect(),
            ]
            .concat(),
        );
    }
    with_damage(
        lines
            .iter()
            .map(|cells| cells.join(separator) + "\n")
            .collect(),
        choices,
    )
}

/// Messages of GSPro Open Connect, one a line or in an array.
pub fn messages(choices: &mut Choices) -> Vec<u8> {
    let mut all = vec![];
    for number in 0..1 + choices.below(6) {
        let mut numbers = vec![];
        for (key, middle, spread) in [
            ("Speed", 155.0, 15.0),
            ("VLA", 12.0, 4.0),
            ("HLA", 0.0, 3.0),
            ("TotalSpin", 2700.0, 600.0),
            ("SpinAxis", 0.0, 8.0),
        ] {
            if choices.is(0.97) {
                numbers.push(format!(
                    "\"{key}\": {:.2}",
                    middle + spread * choices.between(-1.0, 1.0)
                ));
            }
        }
        let units = choices.good_or_bad(&["Yards"], &["Furlongs", "Meters"]);
        let is_shot = choices.is(0.9);
        all.push(format!(
            "{{\"Units\": \"{units}\", \"ShotNumber\": {number}, \"BallData\": {{{}}}, \"ShotDataOptions\": {{\"ContainsBallData\": {is_shot}}}}}",
            numbers.join(", ")
        ));
    }
    let text = if choices.is(0.5) {
        all.join("\n")
    } else {
        format!("[{}]", all.join(",\n"))
    };
    with_damage(text, choices)
}

/// A table of measured shots: deliveries or launch conditions, with measured values.
pub fn shots(choices: &mut Choices) -> Vec<u8> {
    let given: &[(&str, f64, f64)] = if choices.is(0.5) {
        &[
            ("club.loft [deg]", 11.0, 3.0),
            ("swing.speed [mph]", 105.0, 10.0),
            ("swing.attack_angle [deg]", 1.0, 3.0),
            ("swing.face_angle [deg]", 0.0, 2.0),
        ]
    } else {
        &[
            ("ball_speed [mph]", 155.0, 15.0),
            ("launch_angle [deg]", 12.0, 4.0),
            ("backspin [rpm]", 2700.0, 600.0),
            ("sidespin [rpm]", 0.0, 300.0),
        ]
    };
    let measured = [
        ("carry [yd]", 240.0, 25.0),
        ("lateral [yd]", 0.0, 8.0),
        ("apex_height [yd]", 30.0, 8.0),
        ("sigma carry [yd]", 2.0, 0.5),
        ("flight_time [s]", 6.2, 0.5),
    ];
    let mut columns = given[..1 + choices.below(4)].to_vec();
    let first = columns.len();
    columns.extend(&measured[..1 + choices.below(5)]);
    if choices.makes_mistake() {
        let twice = choices.of(&columns);
        columns.push(twice);
    }
    let mut heads: Vec<String> = columns
        .iter()
        .map(|(head, ..)| (*head).to_owned())
        .collect();
    if choices.makes_mistake() {
        let at = choices.below(heads.len());
        heads[at] = choices
            .of(&[
                "",
                "carry",
                "cary [yd]",
                "carry [kg]",
                "Club Speed [mph]",
                "optimum club.loft",
            ])
            .into();
    }
    let mut text = heads.join(",") + "\n";
    // faster or higher shots fly farther
    for _ in 0..(2 + choices.below(8)) * usize::from(!choices.makes_mistake()) {
        let common = choices.between(-1.0, 1.0);
        let cell = |at: usize, choices: &mut Choices| {
            let (_, middle, spread) = columns[at];
            let part = if at >= first {
                0.8 * common + 0.1 * choices.between(-1.0, 1.0)
            } else {
                common * choices.between(0.2, 1.0)
            };
            match choices.below(60) {
                // missing values
                0 if at >= first => String::new(),
                _ if choices.makes_mistake() => choices
                    .of(&["nan", "-5", "x", "1e300", "inf", "0", ""])
                    .into(),
                _ => format!("{:.3}", middle + spread * part),
            }
        };
        text += &((0..columns.len())
            .map(|at| cell(at, choices))
            .collect::<Vec<_>>()
            .join(",")
            + "\n");
    }
    with_damage(text, choices)
}

/// The bytes of a text. A mistake damages them at a random place.
fn with_damage(text: String, choices: &mut Choices) -> Vec<u8> {
    let mut bytes = text.into_bytes();
    if !(choices.makes_mistake() || choices.makes_mistake()) {
        return bytes;
    }
    let at = choices.below(bytes.len() + 1);
    match choices.below(8) {
        0 => bytes.truncate(at),
        1 => bytes.clear(),
        2 => bytes.insert(at, 0xff),
        3 => bytes.insert(at, 0),
        4 => {
            let _ = bytes.splice(at..at, "\u{feff}é\r\n".bytes());
        }
        5 => bytes.extend(bytes.clone()),
        6 => {
            let odd = choices.of(b"\"',;[]{}=#\n\t.-");
            bytes.insert(at, odd);
        }
        _ => {
            let line = setting(choices).into_bytes();
            bytes.extend(line);
        }
    }
    bytes
}

/// A change of a parameter for `--change`: NAME=NUMBER UNIT.
pub fn change(choices: &mut Choices) -> String {
    let parameter = variable(choices);
    let sign = choices.of(&["+", "-", ""]);
    let name = name_of(parameter, choices);
    let size = 0.02 * near(parameter, 0.1, choices).abs().max(1e-3);
    format!("{name}={sign}{}", with_unit(size, parameter, choices))
}
