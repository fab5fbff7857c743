//! Spelling of numbers and units in output: `10.5°`, `kg/m³`. The spelling of input is `10.5 deg`,
//! `kg/m^3`.

/// A unit in the spelling of output: `°`, `kg/m³`.
///
/// ```
/// use longdrive::units::printed;
/// let units = ["deg", "degC", "kg/m^3", "g cm^2", "mph"];
/// assert_eq!(units.map(printed), ["°", "°C", "kg/m³", "g cm²", "mph"]);
/// ```
pub fn printed(unit: &str) -> String {
    unit.replace("deg", "°")
        .replace("^2", "²")
        .replace("^3", "³")
}

/// A number with its unit in the spelling of output: "162.0 mph", "7.5°", "1.47".
pub(crate) fn with_unit(number: &str, unit: &str) -> String {
    match printed(unit).as_str() {
        "°" => format!("{number}°"),
        unit => format!("{number} {unit}").trim_end().to_owned(),
    }
}

/// A number with its unit in the spelling of input: "7.5 deg".
pub(crate) fn typed(number: &str, unit: &str) -> String {
    format!("{number} {unit}").trim_end().to_owned()
}

/// A unit as a noun, for the phrase "for each …".
///
/// ```
/// use longdrive::units::one;
/// let names = ["deg", "yd", "m", "mph", "g cm^2", ""].map(one);
/// assert_eq!(names, ["degree", "yard", "metre", "mph", "g cm²", "unit"]);
/// ```
pub fn one(unit: &str) -> String {
    match unit {
        "deg" => "degree".into(),
        "yd" => "yard".into(),
        "m" => "metre".into(),
        "in" => "inch".into(),
        "s" => "second".into(),
        "" => "unit".into(),
        other => printed(other),
    }
}

/// SI unit of a derivative for column heads, from the SI units of the outcome and the parameter;
/// empty for a plain number.
///
/// ```
/// use longdrive::units::ratio;
/// let pairs = [("m", "rad"), ("m", "m/s"), ("", "s"), ("m", ""), ("", "")];
/// let ratios = pairs.map(|(of, by)| ratio(of, by));
/// assert_eq!(ratios, ["m/rad", "m/(m/s)", "1/s", "m", ""]);
/// ```
pub fn ratio(of: &str, by: &str) -> String {
    let unit = if of.is_empty() { "1" } else { of };
    match by {
        "" => of.into(),
        by if by.contains([' ', '/']) => format!("{unit}/({by})"),
        by => format!("{unit}/{by}"),
    }
}

/// Unit of a derivative in words, from the units of the outcome and the parameter.
///
/// ```
/// use longdrive::units::per;
/// assert_eq!([per("m", "rad"), per("m", ""), per("yd", "deg")], ["m per rad", "m", "yd per degree"]);
/// ```
pub fn per(of: &str, by: &str) -> String {
    let by = if by == "deg" { one(by) } else { printed(by) };
    match (printed(of), by) {
        (of, by) if by.is_empty() => of,
        (of, by) if of.is_empty() => format!("per {by}"),
        (of, by) => format!("{of} per {by}"),
    }
}

/// The number at the start of a text, also of a typeset text: "162.0" of "162.0 mph", "-7.5" of
/// "-7.5°", "−7.5" of "−7.5°", "1e-9" of "1e-9 m".
pub(crate) fn leading_number(text: &str) -> &str {
    let end = text
        .find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '−' | '+' | 'e')))
        .unwrap_or(text.len());
    &text[..end]
}

/// Text for pages and pictures: minus signs, `38 deg` as `38°`, `>=` as `≥`, `m^2` as `m²`. On a
/// terminal the hyphen stays, so that a number can be copied into a command.
///
/// ```
/// use longdrive::units::typeset;
/// assert_eq!(
///     typeset("at -0.9 deg (-3e-5 m^2), descent_angle >= 38 deg"),
///     "at −0.9° (−3e−5 m²), descent_angle ≥ 38°"
/// );
/// let unchanged = "the modern-driver, 2-3 mph, --set x=-1deg, 5 degrees";
/// assert_eq!(typeset(unchanged), unchanged);
/// ```
pub fn typeset(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let at = |i: Option<usize>| i.and_then(|i| letters.get(i)).copied();
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let mut printed = String::with_capacity(text.len());
    let mut i = 0;
    while let Some(c) = at(Some(i)) {
        let (before, after) = (at(i.checked_sub(1)), at(Some(i + 1)));
        let begins_a_number = is_digit(after) || (after == Some('.') && is_digit(at(Some(i + 2))));
        let is_sign = before
            .is_none_or(|c| c.is_whitespace() || matches!(c, '(' | '[' | '±' | '…'))
            || (before == Some('e') && is_digit(at(i.checked_sub(2))));
        let is_degree = || letters[i..].starts_with(&[' ', 'd', 'e', 'g']) && is_digit(before);
        let (put, length) = match (c, after) {
            ('-', _) if begins_a_number && is_sign => ('−', 1),
            ('>', Some('=')) => ('≥', 2),
            ('<', Some('=')) => ('≤', 2),
            ('^', Some('2')) if before.is_some_and(char::is_alphabetic) => ('²', 2),
            ('^', Some('3')) if before.is_some_and(char::is_alphabetic) => ('³', 2),
            (' ', Some('d'))
                if is_degree() && !at(Some(i + 4)).is_some_and(char::is_alphanumeric) =>
            {
                ('°', 4)
            }
            _ => (c, 1),
        };
        printed.push(put);
        i += length;
    }
    printed
}
