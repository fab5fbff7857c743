use super::golfer::{Correlation, Swings};
use crate::batch::Points;
use crate::error::{Error, Result};
use crate::external_errors::{read_error_text, toml_error_text};
use crate::input_file::InputFile;
use crate::parameters::{Setup, in_file, place_in};
use crate::study::uncertainty::Uncertain;
use crate::table::open_table;
use std::path::Path;
use toml::de::{DeTable, DeValue};

/// Maximum number of recorded swings: a search over more swings would take too long.
const MOST_ROWS: u64 = 100_000;

impl Swings {
    /// Swings from a file. A `.toml` file has distributions and correlations. Any other file is a
    /// table of recorded swings, which [`open_table`] reads: a row for each swing, and names of
    /// parameters as column heads.
    ///
    /// ```toml
    /// [distributions]
    /// swing.speed = "normal(110 mph, 3 mph)"
    /// swing.path = "normal(0 deg, 2 deg)"
    /// swing.face_angle = "normal(0 deg, 2 deg)"
    ///
    /// [[correlations]]
    /// between = ["swing.path", "swing.face_angle"]
    /// coefficient = 0.6
    /// ```
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a file that cannot be opened; [`Error::Toml`] and
    /// [`Error::InFile`], which name the line; the errors of [`open_table`],
    /// [`Swings::distributed`] and [`Swings::recorded`].
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        if path
            .extension()
            .is_none_or(|ending| !ending.eq_ignore_ascii_case("toml"))
        {
            return recorded(setup, open_table(setup, path)?.as_mut(), path);
        }
        let file = path.display().to_string();
        let text = InputFile::read_to_string(path).map_err(|error| {
            Error::unreadable(format!("the swings in {file}"), read_error_text(&error))
        })?;
        read(setup, &text, &file)
    }
}

fn recorded(setup: &Setup<f64>, table: &mut dyn Points, path: &Path) -> Result<Swings> {
    let parameters = table.parameters().to_vec();
    let refuse = |reason: String| Error::table(path.display().to_string(), "", reason);
    if table.rows() > MOST_ROWS {
        let rows = table.rows();
        let reason = format!(
            "it has {rows} rows, and at most {MOST_ROWS} recorded swings are allowed; take a part \
             of them"
        );
        return Err(refuse(reason));
    }
    for parameter in &parameters {
        if parameter.is_of_launch() && !setup.launch.is_given() {
            let reason = format!(
                "it has {}, a quantity of the ball, but a table of swings has parameters of swing \
                 and strike; `delivery()` with `shots` finds the swings behind launches",
                parameter.name
            );
            return Err(refuse(reason));
        }
        setup.column(parameter.name)?;
    }
    if table.rows() == 0 {
        return Err(refuse("it has no rows; give one row for each swing".into()));
    }
    let mut values = vec![];
    while table.read(4096, &mut values)? > 0 {}
    let rows = values
        .chunks(parameters.len())
        .map(<[f64]>::to_vec)
        .collect();
    let mut swings =
        Swings::recorded(parameters, rows).map_err(|error| refuse(error.to_string()))?;
    if let Swings::Recorded { remarks, .. } = &mut swings {
        *remarks = table.notes();
    }
    Ok(swings)
}

fn read(setup: &Setup<f64>, text: &str, file: &str) -> Result<Swings> {
    let table = DeTable::parse(text).map_err(|error| Error::Toml {
        file: file.into(),
        message: toml_error_text(&error, text, |at| place_in(text, at)),
    })?;
    let wrong = |at: usize, source: Error| in_file(text, file, at, source);
    let (mut inputs, mut correlations) = (vec![], vec![]);
    for (key, value) in table.get_ref() {
        let at = key.span().start;
        match (key.get_ref().as_ref(), value.get_ref()) {
            ("distributions", DeValue::Table(inner)) => {
                distributions(setup, inner, "", &wrong, &mut inputs)?
            }
            ("correlations", DeValue::Array(all)) => {
                for one in all {
                    let read = correlation(setup, one.get_ref());
                    correlations.push(read.map_err(|source| wrong(one.span().start, source))?);
                }
            }
            ("distributions", other) => {
                return Err(wrong(at, of_type("distributions", other, "a table")));
            }
            ("correlations", other) => {
                return Err(wrong(
                    at,
                    of_type("correlations", other, "a list of tables, [[correlations]]"),
                ));
            }
            (name, _) => {
                let names = ["distributions", "correlations"];
                let advice = "a file of swings has [distributions] and [[correlations]]".to_owned();
                return Err(wrong(at, Error::unknown("key", name, names, advice)));
            }
        }
    }
    if inputs.is_empty() {
        let source = "it has no distribution; write [distributions] and below it, for example, \
                      swing.speed = \"normal(110 mph, 3 mph)\"";
        return Err(Error::unreadable(format!("the swings in {file}"), source));
    }
    Swings::distributed(inputs, &correlations)
}

/// Adds the distributions of a TOML table to `inputs`. A dotted key such as `swing.speed` is a
/// nested table, and `before` is then the first part of the key: `swing.`.
fn distributions(
    setup: &Setup<f64>,
    table: &DeTable<'_>,
    before: &str,
    wrong: &dyn Fn(usize, Error) -> Error,
    inputs: &mut Vec<Uncertain>,
) -> Result<()> {
    for (key, value) in table {
        let name = format!("{before}{}", key.get_ref());
        match value.get_ref() {
            DeValue::Table(inner) => {
                distributions(setup, inner, &format!("{name}."), wrong, inputs)?
            }
            DeValue::String(text) => {
                let read = Uncertain::read(setup, &format!("{name}={text}"));
                inputs.push(read.map_err(|source| wrong(key.span().start, source))?);
            }
            other => {
                let example = "a distribution in quotes, for example \"normal(110 mph, 3 mph)\"";
                return Err(wrong(value.span().start, of_type(&name, other, example)));
            }
        }
    }
    Ok(())
}

fn correlation(setup: &Setup<f64>, value: &DeValue<'_>) -> Result<Correlation> {
    let how = "a correlation has between = [\"NAME\", \"NAME\"] and coefficient = NUMBER";
    let refuse = |source: String| Error::unreadable("a correlation", source);
    let DeValue::Table(table) = value else {
        return Err(of_type("correlations", value, "a table"));
    };
    for key in table.keys() {
        if !["between", "coefficient"].contains(&key.get_ref().as_ref()) {
            return Err(refuse(format!(
                "'{}' does not belong here; {how}",
                key.get_ref()
            )));
        }
    }
    let get = |name: &str| {
        table
            .get(name)
            .map(|value| value.get_ref())
            .ok_or_else(|| refuse(format!("{name} is missing; {how}")))
    };
    let names = match get("between")? {
        DeValue::Array(names) => {
            let names = names.iter().map(|name| name.get_ref().as_str());
            names.collect::<Option<Vec<_>>>()
        }
        _ => None,
    };
    let Some([one, other]) = names.as_deref() else {
        return Err(refuse(format!("between must be two names; {how}")));
    };
    let coefficient = match get("coefficient")? {
        DeValue::Float(number) => number.as_str().parse().ok(),
        DeValue::Integer(number) => number.as_str().parse().ok(),
        _ => None,
    };
    let coefficient =
        coefficient.ok_or_else(|| refuse(format!("coefficient must be a number; {how}")))?;
    Correlation::new([setup.column(one)?, setup.column(other)?], coefficient)
}

fn of_type(key: &str, found: &DeValue<'_>, expected: &str) -> Error {
    Error::WrongType {
        key: key.into(),
        found: found.type_str(),
        expected: expected.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::read;
    use crate::Setup;

    #[test]
    fn files_of_swings_are_read_and_wrong_ones_refused() {
        let setup = Setup::modern_driver();
        let good = "[distributions]\nswing.speed = 'normal(110 mph, 3 mph)'\n'swing.path' = \
                    'uniform(-2 deg, 2 deg)'\n\
                    [[correlations]]\nbetween = ['swing.speed', 'swing.path']\ncoefficient = \
                    -0.25\n";
        let swings = read(&setup, good, "s.toml").unwrap();
        assert_eq!(
            swings
                .parameters()
                .iter()
                .map(|p| p.name)
                .collect::<Vec<_>>(),
            ["swing.speed", "swing.path"]
        );
        assert!((swings.means()[0] - 49.1744).abs() < 1e-12 && swings.means()[1] == 0.0);
        for (bad, message) in [
            (
                "[distributions]\nswing.sped = 'normal(1 mph, 3 mph)'\n",
                "did you mean 'swing.speed'",
            ),
            ("[distributions]\nswing.speed = 110\n", "in quotes"),
            ("[distributon]\n", "did you mean 'distributions'"),
            (
                "[distributions]\nswing.path = 'normal(0 deg, -1 deg)'\n",
                "above 0",
            ),
            (
                "[distributions]\nswing.path = 'normal(0 deg, 1 deg)'\n[[correlations]]\nbetween = \
                 ['swing.path', 'swing.speed']\ncoefficient = 0.5\n",
                "has no distribution",
            ),
            (
                "[distributions]\nswing.path = 'normal(0 deg, 1 deg)'\n[[correlations]]\nbetween = \
                 ['swing.path']\ncoefficient = 0.5\n",
                "two names",
            ),
            (
                "[distributions]\nswing.path = 'normal(0 deg, 1 deg)'\n'swing.speed' = \
                 'normal(110 mph, 3 mph)'\n[[correlations]]\nbetween = ['swing.path', 3, \
                 'swing.speed']\ncoefficient = 0.5\n",
                "two names",
            ),
            (
                "[distributions]\nswing.path = 'normal(0 deg, 1 deg)'\n[[correlations]]\nbetween = \
                 ['swing.path', 'swing.path']\ncoefficient = 0.5\n",
                "with itself",
            ),
            ("", "no distribution"),
        ] {
            let error = read(&setup, bad, "s.toml").unwrap_err().to_string();
            assert!(error.contains(message), "{bad}: {error}");
        }
    }
}
