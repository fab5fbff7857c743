//! Files of questions: setups, points and shots, good and bad.

use crate::chance::Chance;
use crate::values::{name_of, near, parameter, preset, setting, value, variable, with_unit};
use std::fs;
use std::path::Path;

/// A setup file.
pub fn setup(chance: &mut Chance) -> Vec<u8> {
    let mut text = String::new();
    if chance.is(0.7) {
        let good = preset(chance);
        let name = chance.of_or(&[good], &["nobody"]);
        text += &format!("preset = \"{name}\"\n");
    }
    let mut named = vec![];
    for _ in 0..chance.below(5) {
        let parameter = parameter(chance);
        if named.contains(&parameter.name) && !chance.makes_mistake() {
            continue;
        }
        named.push(parameter.name);
        let name = name_of(parameter, chance);
        let shown = match chance.below(8) {
            // a bare number is SI
            0 => format!("{:?}", near(parameter, 0.1, chance)),
            1 => chance
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
                value(parameter, chance).replace(['"', '\\', '\0'], "")
            ),
        };
        text += &format!("{name} = {shown}\n");
    }
    if chance.is_launched {
        text += "[launch]\nball_speed = \"150 mph\"\nlaunch_angle = \"12 deg\"\n";
        text += chance.of(&[
            "backspin = \"2500 rpm\"\n",
            "spin = \"2500 rpm\"\nspin_axis = \"-2 deg\"\n",
        ]);
    }
    if chance.is(0.2) {
        text += "[aero]\nlaw = \"robinson\"\ncd0 = 0.3\n";
    }
    with_damage(text, chance)
}

/// A table of points to sweep.
pub fn points(chance: &mut Chance) -> Vec<u8> {
    let columns: Vec<_> = (0..1 + chance.below(3))
        .map(|_| {
            if chance.is(0.9) {
                variable(chance)
            } else {
                parameter(chance)
            }
        })
        .collect();
    let units: Vec<&str> = columns
        .iter()
        .map(|column| if chance.is(0.95) { column.unit } else { "" })
        .collect();
    let head = |at: usize, chance: &mut Chance| {
        let name = name_of(columns[at], chance);
        if units[at].is_empty() {
            name
        } else {
            format!("{name} [{}]", units[at])
        }
    };
    let separator = if chance.is(0.7) {
        ","
    } else {
        chance.of(&[";", "\t"])
    };
    // columns written by a sweep, and by launch monitors
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
    let more: &[(&str, &str)] = match chance.below(8) {
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
    let heads = (0..columns.len()).map(|at| head(at, chance)).collect();
    let mut text = joined(heads, more.iter().map(|(head, _)| *head).collect());
    for _ in 0..(1 + chance.below(7)) * usize::from(!chance.makes_mistake()) {
        let cell = |at: usize, chance: &mut Chance| {
            let size = columns[at]
                .quantity
                .size_of(units[at])
                .filter(|_| !units[at].is_empty())
                .unwrap_or(1.0);
            let number = near(
                columns[at],
                if chance.is(0.05) { 30.0 } else { 0.2 },
                chance,
            ) / size;
            if chance.is(0.02) {
                chance.of(&["", "nan", "inf", "x", "1e400", "\"1"]).into()
            } else {
                format!("{number:?}")
            }
        };
        let cells = (0..columns.len()).map(|at| cell(at, chance)).collect();
        text += &joined(cells, more.iter().map(|(_, cell)| *cell).collect());
    }
    with_damage(text, chance)
}

/// The name and the content of a table of points in another format, or of a damaged table.
pub fn binary(chance: &mut Chance) -> (String, Vec<u8>) {
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
    let name = chance.of(&names).into_string().unwrap();
    let mut bytes = fs::read(folder.join(&name)).unwrap();
    if chance.is(0.3) && !bytes.is_empty() {
        let at = chance.below(bytes.len());
        match chance.below(3) {
            0 => bytes.truncate(at),
            1 => bytes[at] ^= 1 << chance.below(8),
            _ => bytes.insert(at, 0xff),
        }
    }
    (name, bytes)
}

/// An export of a launch monitor. It has heads, units in the heads or in a line of their own,
/// letters for the sides, and rows that sum up others.
pub fn export(chance: &mut Chance) -> Vec<u8> {
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
    // rarely, a necessary column is missing
    let columns: Vec<_> = all
        .iter()
        .filter(|(name, ..)| chance.is(if name.contains("ll S") { 0.97 } else { 0.85 }))
        .collect();
    let separator = chance.of(&[",", ";", "\t"]);
    let has_comma = separator != "," && chance.is(0.3);
    let units = chance.below(3);
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
    let rows = 2 + chance.below(7);
    for row in 0..=rows {
        let common = chance.between(-1.0, 1.0);
        let cell = |(name, _, middle, spread): &&(&str, &str, f64, f64), chance: &mut Chance| {
            let value = middle + spread * (0.8 * common + 0.2 * chance.between(-1.0, 1.0));
            let shown = match (
                *middle == 0.0 && !name.starts_with("Attack"),
                chance.below(60),
            ) {
                (_, 0) => String::new(),
                (_, 1) if chance.makes_mistake() => chance
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
            chance.of(&["Average", "Std. Dev.", "A"])
        } else {
            "A"
        };
        lines.push(
            [
                vec![first.to_owned()],
                columns.iter().map(|column| cell(column, chance)).collect(),
            ]
            .concat(),
        );
    }
    with_damage(
        lines
            .iter()
            .map(|cells| cells.join(separator) + "\n")
            .collect(),
        chance,
    )
}

/// Messages of GSPro Open Connect, one a line or in an array.
pub fn messages(chance: &mut Chance) -> Vec<u8> {
    let mut all = vec![];
    for number in 0..1 + chance.below(6) {
        let mut numbers = vec![];
        for (key, middle, spread) in [
            ("Speed", 155.0, 15.0),
            ("VLA", 12.0, 4.0),
            ("HLA", 0.0, 3.0),
            ("TotalSpin", 2700.0, 600.0),
            ("SpinAxis", 0.0, 8.0),
        ] {
            if chance.is(0.97) {
                numbers.push(format!(
                    "\"{key}\": {:.2}",
                    middle + spread * chance.between(-1.0, 1.0)
                ));
            }
        }
        let units = chance.of_or(&["Yards"], &["Furlongs", "Meters"]);
        let is_shot = chance.is(0.9);
        all.push(format!(
            "{{\"Units\": \"{units}\", \"ShotNumber\": {number}, \"BallData\": {{{}}}, \"ShotDataOptions\": {{\"ContainsBallData\": {is_shot}}}}}",
            numbers.join(", ")
        ));
    }
    let text = if chance.is(0.5) {
        all.join("\n")
    } else {
        format!("[{}]", all.join(",\n"))
    };
    with_damage(text, chance)
}

/// A table of measured shots: deliveries or launch conditions, with measured values.
pub fn shots(chance: &mut Chance) -> Vec<u8> {
    let given: &[(&str, f64, f64)] = if chance.is(0.5) {
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
    let mut columns = given[..1 + chance.below(4)].to_vec();
    let first = columns.len();
    columns.extend(&measured[..1 + chance.below(5)]);
    if chance.makes_mistake() {
        let twice = chance.of(&columns);
        columns.push(twice);
    }
    let mut heads: Vec<String> = columns
        .iter()
        .map(|(head, ..)| (*head).to_owned())
        .collect();
    if chance.makes_mistake() {
        let at = chance.below(heads.len());
        heads[at] = chance
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
    for _ in 0..(2 + chance.below(8)) * usize::from(!chance.makes_mistake()) {
        let common = chance.between(-1.0, 1.0);
        let cell = |at: usize, chance: &mut Chance| {
            let (_, middle, spread) = columns[at];
            let part = if at >= first {
                0.8 * common + 0.1 * chance.between(-1.0, 1.0)
            } else {
                common * chance.between(0.2, 1.0)
            };
            match chance.below(60) {
                // missing values
                0 if at >= first => String::new(),
                _ if chance.makes_mistake() => chance
                    .of(&["nan", "-5", "x", "1e300", "inf", "0", ""])
                    .into(),
                _ => format!("{:.3}", middle + spread * part),
            }
        };
        text += &((0..columns.len())
            .map(|at| cell(at, chance))
            .collect::<Vec<_>>()
            .join(",")
            + "\n");
    }
    with_damage(text, chance)
}

/// The bytes of a text. By mistake, a random place of it is damaged.
fn with_damage(text: String, chance: &mut Chance) -> Vec<u8> {
    let mut bytes = text.into_bytes();
    if !(chance.makes_mistake() || chance.makes_mistake()) {
        return bytes;
    }
    let at = chance.below(bytes.len() + 1);
    match chance.below(8) {
        0 => bytes.truncate(at),
        1 => bytes.clear(),
        2 => bytes.insert(at, 0xff),
        3 => bytes.insert(at, 0),
        4 => {
            let _ = bytes.splice(at..at, "\u{feff}é\r\n".bytes());
        }
        5 => bytes.extend(bytes.clone()),
        6 => {
            let odd = chance.of(b"\"',;[]{}=#\n\t.-");
            bytes.insert(at, odd);
        }
        _ => {
            let line = setting(chance).into_bytes();
            bytes.extend(line);
        }
    }
    bytes
}

/// A change of a parameter for `--change`: NAME=NUMBER UNIT.
pub fn change(chance: &mut Chance) -> String {
    let parameter = variable(chance);
    let sign = chance.of(&["+", "-", ""]);
    let name = name_of(parameter, chance);
    let size = 0.02 * near(parameter, 0.1, chance).abs().max(1e-3);
    format!("{name}={sign}{}", with_unit(size, parameter, chance))
}
