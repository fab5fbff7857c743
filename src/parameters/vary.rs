use super::declare::Parameter;
use super::table::Setup;
use crate::error::{Error, Result};

/// A parameter to vary, and its range, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vary {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Least value.
    pub low: f64,
    /// Greatest value.
    pub high: f64,
}

impl Vary {
    /// Parses `NAME=LOW..HIGH`, for example `club.loft=4deg..20deg` or `club.loft=4..20deg`. A low
    /// end without a unit has the unit of the high end. The high end needs a unit if the quantity
    /// has a dimension.
    ///
    /// ```
    /// use longdrive::{Setup, parameters::Vary};
    /// let loft = Vary::read(&Setup::modern_driver(), "club.loft=4..20deg").unwrap();
    /// assert_eq!((loft.low, loft.high), (4.0_f64.to_radians(), 20.0_f64.to_radians()));
    /// assert!(Vary::read(&Setup::modern_driver(), "club.loft=20deg..4deg").is_err());
    /// assert!(Vary::read(&Setup::modern_driver(), "club.loft=4..20").is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::SearchRange`] for a text that is not a range, and for a reversed or infinite range;
    /// the errors of [`Setup::variable`] and [`Parameter::read`].
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        Self::read_of(text, |name| setup.variable(name))
    }

    /// Parses the texts of several ranges.
    ///
    /// ```
    /// use longdrive::{Setup, parameters::Vary};
    /// let texts = ["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"];
    /// let vary = Vary::read_all(&Setup::modern_driver(), texts).unwrap();
    /// assert_eq!(vary[1].parameter.name, "swing.attack_angle");
    /// ```
    ///
    /// # Errors
    /// The errors of [`read`](Self::read).
    pub fn read_all(
        setup: &Setup<f64>,
        texts: impl IntoIterator<Item = impl AsRef<str>>,
    ) -> Result<Vec<Self>> {
        texts
            .into_iter()
            .map(|text| Self::read(setup, text.as_ref()))
            .collect()
    }

    /// Like [`read`](Self::read), for a parameter that need not have a value in the setup, because
    /// each drive of a batch has its own value.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read) and [`Setup::column`].
    pub fn read_column(setup: &Setup<f64>, text: &str) -> Result<Self> {
        Self::read_of(text, |name| setup.column(name))
    }

    /// Start of a search: the value of the setup, or the middle of the range if the setup has no
    /// value.
    pub fn start(&self, setup: &Setup<f64>) -> f64 {
        setup
            .value(self.parameter)
            .unwrap_or(0.5 * (self.low + self.high))
    }

    /// The setup with a start value for each varied parameter that is unset.
    ///
    /// # Errors
    /// The errors of [`Setup::set_value`].
    pub fn initialized(setup: &Setup<f64>, vary: &[Self]) -> Result<Setup<f64>> {
        let mut initialized = *setup;
        for vary in vary
            .iter()
            .filter(|vary| setup.value(vary.parameter).is_none())
        {
            initialized.set_value(vary.parameter, Some(vary.start(setup)))?;
        }
        Ok(initialized)
    }

    fn read_of(text: &str, find: impl Fn(&str) -> Result<&'static Parameter>) -> Result<Self> {
        let refuse = |reason: String| Error::SearchRange {
            name: text.trim().into(),
            reason,
        };
        let (name, range) = text.split_once('=').ok_or_else(|| {
            refuse("write NAME=LOW..HIGH, for example club.loft=4deg..20deg".into())
        })?;
        let parameter = find(name.trim())?;
        let with_unit = |end: &str| format!("{end} {}", parameter.unit).trim_end().to_owned();
        let how = format!("write {name}={}..{}", with_unit("LOW"), with_unit("HIGH"));
        let (low, high) = range
            .split_once("..")
            .ok_or_else(|| refuse(format!("'{range}' is not LOW..HIGH; {how}")))?;
        for (end, which) in [(low, "lower"), (high, "upper")] {
            if end.trim().is_empty() {
                return Err(refuse(format!("its {which} end is missing; {how}")));
            }
        }
        let low = parameter.quantity.with_unit_of(low, high);
        let low =
            low.map_err(|error| Error::unreadable(format!("the range {}", text.trim()), error))?;
        let end = |text: &str| parameter.read(text, false).map(Option::unwrap_or_default);
        // read the high end first: an error about a missing unit then quotes the user's text
        let high = end(high)?;
        Self::new(parameter, end(&low)?, high)
    }

    /// A parameter with a range in SI.
    ///
    /// # Errors
    /// [`Error::SearchRange`] for a reversed or infinite range; [`Error::OutOfRange`] for an end
    /// outside the allowed values; [`Error::NotANumber`] for NaN.
    pub fn new(parameter: &'static Parameter, low: f64, high: f64) -> Result<Self> {
        parameter.check(low)?;
        parameter.check(high)?;
        let vary = Self {
            parameter,
            low,
            high,
        };
        vary.check()?;
        if low.is_finite() && high.is_finite() {
            Ok(vary)
        } else {
            Err(vary.refused("both ends must be finite".into()))
        }
    }

    /// Checks that the ends are numbers and in order. A range that [`new`](Self::new) did not check
    /// may exceed the allowed values of the parameter; no drive is computed at a value that is not
    /// allowed.
    ///
    /// # Errors
    /// [`Error::NotANumber`] if an end is NaN, and [`Error::SearchRange`] if the range is reversed.
    pub(crate) fn check(&self) -> Result<()> {
        let Self {
            parameter,
            low,
            high,
        } = *self;
        for end in [low, high] {
            if end.is_nan() {
                parameter.check(end)?;
            }
        }
        if low <= high {
            return Ok(());
        }
        // without a space between number and unit, the range is a single word of a command line
        let [low, high] = [low, high].map(|end| parameter.show(Some(end)).replacen(' ', "", 1));
        Err(self.refused(format!(
            "the range is reversed; did you mean {high}..{low}?"
        )))
    }

    fn refused(&self, reason: String) -> Error {
        let [low, high] = [self.low, self.high].map(|end| self.parameter.show(Some(end)));
        Error::SearchRange {
            name: format!("{}={low}..{high}", self.parameter),
            reason,
        }
    }
}
