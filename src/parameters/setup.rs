use super::air::{Conflict, is_reset, replacing};
use super::choices::{GOLFER, Golfer, METHOD, Method, SPEED_OF, SpeedOf};
use super::declare::{Kind, Parameter, Slot, is_unset};
use super::law_table::{LawTable, TABLE, TABLE_LAW};
use super::range::Range;
use super::steps::is_of_step;
use super::table::{LAW, Law, Setup, Table, TableFactors};
use super::turf::{TURF, refuse_idle_turf};
use crate::error::{Error, Result};
use crate::number::{Numbers, inlined};
use crate::units::{Message, Quantity, UnitError, counted};
use std::borrow::Cow;
use std::path::Path;

/// Reason why a parameter of the club has no effect.
pub(crate) const NO_CLUB: &str = "no club strikes the ball, since its launch is given; name \
                                  parameters of the launch, for example launch.launch_angle";

const LISTING: &str = "`parameters()` lists them all";

/// The choices: settings whose values are names of laws, files, methods, turfs and the like, and no
/// numbers. [`Setup::choice`] gives their values.
pub const CHOICES: [&str; 6] = [LAW, TABLE, METHOD, TURF, GOLFER, SPEED_OF];

/// The name of a parameter, or of a choice such as the law, and the text of its value.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingText<'a> {
    /// Dotted name.
    pub name: &'a str,
    /// The value: `10.5 deg`, `none`.
    pub text: Cow<'a, str>,
    /// True if a number without a unit is SI; otherwise a quantity with a dimension needs its unit.
    pub is_bare: bool,
}

/// A setting of a list that cannot be applied.
pub(super) struct SettingFault {
    /// Index of the setting in the list.
    pub index: usize,
    /// True if the message points to the value; otherwise it points to the name.
    pub is_of_value: bool,
    pub error: Error,
}

impl SettingFault {
    fn of_name(index: usize, error: Error) -> Self {
        Self {
            index,
            is_of_value: false,
            error,
        }
    }

    fn of_value(index: usize, error: Error) -> Self {
        Self {
            index,
            is_of_value: true,
            error,
        }
    }
}

impl Parameter {
    /// Parses a value. With `bare`, a number without a unit is SI; otherwise a quantity with a
    /// dimension needs its unit. `none` unsets an optional parameter.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a wrong or missing unit, and for a value with `+` of a parameter
    /// that is never negative; [`Error::OutOfRange`] for a value outside the range.
    pub fn read(&self, text: &str, bare: bool) -> Result<Option<f64>> {
        let text = text.trim();
        if is_unset(text) {
            return if self.kind == Kind::Optional {
                Ok(None)
            } else {
                Err(self.needs_a_value())
            };
        }
        // a sign is usual for a temperature; elsewhere `+5 mm` may be meant as a change
        let is_like_a_change = text.starts_with('+')
            && self.range.low >= 0.0
            && self.quantity != Quantity::TEMPERATURE;
        if is_like_a_change {
            let source =
                format!("\"{text}\" may be meant as a change; give the new value, without +");
            return Err(Error::unreadable(self.name, source));
        }
        let value = if bare {
            self.quantity.read_bare(text)
        } else {
            self.quantity.read(text)
        };
        let value = value.map_err(|error| self.unreadable(error))?;
        self.check(value).map_err(|error| match error {
            Error::OutOfRange {
                name,
                si,
                value: shown,
                range,
                advice,
            } => Error::OutOfRange {
                name,
                si,
                value: self.show_with_text(value, text).unwrap_or(shown),
                range,
                advice: self.unit_suggestion(text).unwrap_or(advice),
            },
            error => error,
        })?;
        Ok(Some(value))
    }

    fn needs_a_value(&self) -> Error {
        let mut reason = "it cannot be unset; give it a value".to_owned();
        if let Some(alternatives) = replacing(self.name) {
            reason += ", or also give the parameters that determine it: ";
            reason += alternatives.rule;
        }
        Error::unreadable(self.name, reason)
    }

    /// Checks a value, SI, against the range.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value outside the range; [`Error::NotANumber`] for NaN.
    pub fn check(&self, value: f64) -> Result<()> {
        let Range {
            low,
            high,
            low_included,
            high_included,
        } = self.range;
        if self.range.contains(value) {
            return Ok(());
        }
        let range = self.range.show(self.quantity, self.unit);
        if value.is_nan() {
            return Err(Error::NotANumber {
                name: self.name.into(),
                range,
            });
        }
        let (sign, end) = if value <= low {
            (
                if low_included {
                    "at least"
                } else {
                    "more than"
                },
                low,
            )
        } else {
            (
                if high_included {
                    "at most"
                } else {
                    "less than"
                },
                high,
            )
        };
        let advice = if value.is_finite() {
            format!("it must be {sign} {}", self.show(Some(end)))
        } else {
            "give a finite number".into()
        };
        Err(Error::OutOfRange {
            name: self.name.into(),
            si: value,
            value: self.show_with_si(value),
            range,
            advice,
        })
    }

    /// The value in the display unit, in which the range is shown too, and also in SI if the SI
    /// unit is another one. A temperature is shown in the display unit only.
    fn show_with_si(&self, value: f64) -> String {
        let si = self.quantity.show(value, self.quantity.si);
        if !value.is_finite() || self.unit == self.quantity.si {
            return si;
        }
        let shown = self.show(Some(value));
        if self.quantity == Quantity::TEMPERATURE {
            shown
        } else {
            format!("{shown} ({si})")
        }
    }

    /// The value in the display unit, and the user's text if its unit is another one; `None` if the
    /// text has no unit.
    fn show_with_text(&self, value: f64, text: &str) -> Option<String> {
        let (number, unit) = self.quantity.split(text).ok()?;
        if !number.is_finite() || unit.is_empty() {
            return None;
        }
        let shown = self.show(Some(value));
        Some(if unit == self.unit {
            shown
        } else {
            format!("{shown} ({text})")
        })
    }

    /// The error for an unreadable text. If the text is a word, such as a direction of the wind,
    /// the error quotes the documentation of the parameter, which says what its numbers mean.
    fn unreadable(&self, error: UnitError) -> Error {
        let is_word = |text: &str| text.starts_with(char::is_alphabetic);
        match &error {
            UnitError::NoNumber { text, .. } if is_word(text) => {
                let meaning = self.doc.split(';').next().unwrap_or_default();
                let meaning = meaning.trim_end_matches('.');
                Error::unreadable(self.name, format!("{error}. Its meaning: {meaning}"))
            }
            _ => Error::unreadable(self.name, error),
        }
    }

    /// Suggestion for a number without a unit that is out of range, because it is read as SI. A
    /// loft of "10" is 10 rad, and most likely means 10 deg; "50" for a fraction means 50 %, but
    /// "1.2" seldom 1.2 %.
    fn unit_suggestion(&self, text: &str) -> Option<String> {
        let (number, unit) = self.quantity.split(text).ok()?;
        if self.range == Range::from_to(0.0, 1.0)
            && unit.is_empty()
            && number >= 2.0
            && self.range.contains(number / 100.0)
        {
            return Some(format!(
                "a number without a unit is a share of 1; did you mean \"{number} %\"?"
            ));
        }
        let meant = number * self.quantity.size_of(self.unit)?;
        let is_likely =
            unit.is_empty() && self.unit != self.quantity.si && self.range.contains(meant);
        is_likely.then(|| {
            format!(
                "a number without a unit is SI; did you mean \"{number} {}\"?",
                self.unit
            )
        })
    }
}

impl Setup<f64> {
    /// Converts the values to constants of the type `T`, whose derivatives are 0.
    #[inline(always)]
    pub(crate) fn constant<T: Numbers>(&self) -> Setup<T> {
        T::not_inlined(inlined!(|| self.map(|_, value| T::constant(value))))
    }
}

impl<T: Copy> Setup<T> {
    /// Sets parameters without checks. `value` returns the number for each index of `parameters`.
    /// Settings of the computation stay unchanged.
    #[inline(always)]
    pub(crate) fn put(
        &mut self,
        parameters: &[&'static Parameter],
        mut value: impl FnMut(usize) -> T,
    ) {
        for (i, parameter) in parameters.iter().enumerate() {
            let value = value(i);
            match self.slot(parameter) {
                Some(Slot::Required(place)) => *place = value,
                Some(Slot::Optional(place)) => *place = Some(value),
                Some(Slot::Setting(_)) | None => {}
            }
        }
    }
}

impl Setup<f64> {
    /// The parameter of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`], with the nearest name, if no parameter has this name, and
    /// [`Error::OtherLaw`] if only coefficients of other laws have it.
    pub fn parameter(&self, name: &str) -> Result<&'static Parameter> {
        if let Some(row) = self.row(name) {
            return Ok(row);
        }
        let rows = self.parameters();
        let owners: Vec<_> = Law::all_rows()
            .filter(|row| row.name == name)
            .filter_map(|row| row.law)
            .collect();
        if !owners.is_empty() {
            return Err(Error::OtherLaw {
                name: name.into(),
                law: self.law.name(),
                owners: owners.join(", "),
            });
        }
        Err(Error::unknown(
            "parameter",
            name,
            rows.iter().map(|row| row.name).chain(CHOICES),
            LISTING,
        ))
    }

    /// The value of a choice: a name, or the file of a user's own table. `None` if `name` is not
    /// one of the [`CHOICES`], for [`TABLE`] if the law is no table, and for [`TURF`] if no turf has
    /// the numbers of the ground.
    ///
    /// ```
    /// use longdrive::Setup;
    /// use longdrive::parameters::{METHOD, TABLE};
    /// let setup = Setup::preset("tour-average").unwrap();
    /// assert_eq!(setup.choice(METHOD), Some("rk4"));
    /// assert_eq!(setup.choice(TABLE), None);
    /// ```
    pub fn choice(&self, name: &str) -> Option<&'static str> {
        match name {
            LAW => Some(self.law.name()),
            TABLE => self.law.table().map(|table| table.file.as_str()),
            METHOD => Some(self.method.name()),
            TURF => self.turf().map(|turf| turf.name),
            GOLFER => Some(self.golfer.name()),
            SPEED_OF => Some(self.speed_of.name()),
            _ => None,
        }
    }

    /// Sets a parameter, or a choice such as the law, by name from a text such as `"10.5 deg"`. A
    /// quantity with a dimension needs its unit; [`set_value`](Self::set_value) takes a number in
    /// SI.
    ///
    /// A weather parameter replaces density and viscosity of the air, even if they were set before.
    /// [`set_all`](Self::set_all) refuses both together.
    ///
    /// # Errors
    /// [`Error::Unknown`] for an unknown name; [`Error::OtherLaw`] for a coefficient of another
    /// law; [`Error::Unreadable`] for a text that is not a value; [`Error::OutOfRange`] for a value
    /// outside the range; [`Error::Together`] for a parameter that follows from other parameters
    /// that are set.
    pub fn set(&mut self, name: &str, text: &str) -> Result<()> {
        if !is_reset(name, text) {
            self.refuse_replaced(&[name])?;
        }
        self.apply_setting(&SettingText {
            name,
            text: text.into(),
            is_bare: false,
        })
    }

    pub(super) fn apply_setting(&mut self, setting: &SettingText<'_>) -> Result<()> {
        let SettingText { name, is_bare, .. } = *setting;
        let text = setting.text.as_ref();
        let choice = text.trim();
        match name {
            LAW => return self.set_law(choice),
            TABLE => return self.set_table(Path::new(text)),
            TURF => return self.set_turf(choice),
            METHOD => {
                self.method = Method::from_name(choice).ok_or_else(|| {
                    let advice = format!("the methods are {}", Method::NAMES.join(", "));
                    Error::unknown("method of integration", choice, Method::NAMES, advice)
                })?;
                self.states_step = true;
            }
            GOLFER => {
                self.golfer = Golfer::from_name(choice).ok_or_else(|| {
                    let advice =
                        "write right for a right-handed golfer, left for a left-handed one";
                    Error::unknown(GOLFER, choice, Golfer::NAMES, advice)
                })?;
            }
            SPEED_OF => {
                self.speed_of = SpeedOf::from_name(choice).ok_or_else(|| {
                    let advice =
                        "write centre-of-mass or face-centre, the point whose speed is swing.speed";
                    Error::unknown(SPEED_OF, choice, SpeedOf::NAMES, advice)
                })?;
            }
            _ => {
                let parameter = self.parameter(name)?;
                let value = if is_reset(name, text) {
                    None
                } else {
                    parameter.read(text, is_bare)?
                };
                return self.set_value(parameter, value);
            }
        }
        Ok(())
    }

    /// Applies table, law and turf first, then the numbers in order, and the resets (`none`) last.
    ///
    /// # Errors
    /// The errors of [`set`](Self::set). The setup is then unchanged.
    pub fn set_all<'a>(
        &mut self,
        settings: impl IntoIterator<Item = (&'a str, &'a str)> + Clone,
    ) -> Result<()> {
        let setting = |(name, text): (&'a str, &'a str)| SettingText {
            name,
            text: text.into(),
            is_bare: false,
        };
        let settings: Vec<_> = settings.into_iter().map(setting).collect();
        self.set_each(&settings)
    }

    /// Like [`set_all`](Self::set_all), for settings that may be numbers in SI.
    ///
    /// ```
    /// use longdrive::Setup;
    /// use longdrive::parameters::SettingText;
    /// let mut setup = Setup::modern_driver();
    /// let loft = SettingText { name: "club.loft", text: "0.2".into(), is_bare: true };
    /// let speed = SettingText { name: "swing.speed", text: "50 m/s".into(), is_bare: false };
    /// setup.set_each(&[loft, speed]).unwrap();
    /// assert_eq!((setup.club.loft, setup.swing.speed), (0.2, 50.0));
    /// ```
    ///
    /// # Errors
    /// The errors of [`set`](Self::set). The setup is then unchanged.
    pub fn set_each(&mut self, settings: &[SettingText<'_>]) -> Result<()> {
        let mut changed = *self;
        changed.apply_each(settings).map_err(|fault| fault.error)?;
        *self = changed;
        Ok(())
    }

    /// Applies settings that are given at once, as [`set_all`](Self::set_all) says. After a fault,
    /// some of them are applied.
    pub(super) fn apply_each(&mut self, settings: &[SettingText<'_>]) -> Result<(), SettingFault> {
        refuse_idle_law_and_turf(settings)?;
        let mut order: Vec<usize> = (0..settings.len()).collect();
        order.sort_by_key(|&index| rank(settings[index].name, &settings[index].text));
        for &index in &order {
            let setting = &settings[index];
            if !CHOICES.contains(&setting.name) {
                self.parameter(setting.name)
                    .map_err(|error| SettingFault::of_name(index, error))?;
            }
            self.apply_setting(setting)
                .map_err(|error| SettingFault::of_value(index, error))?;
        }
        let given: Vec<&str> = order
            .iter()
            .map(|&index| &settings[index])
            .filter(|setting| !is_reset(setting.name, &setting.text))
            .map(|setting| setting.name)
            .filter(|name| self.is_set(name))
            .collect();
        let is_set = |name: &str| self.is_set(name);
        let Some(conflict) = Conflict::find(&given, is_set) else {
            return Ok(());
        };
        // to unset one helps only if the setup had it before: settings given together exclude each
        // other
        let advice = if given.contains(&conflict.by) {
            String::new()
        } else {
            conflict.unset_advice(&given, is_set)
        };
        let is_replaced = |setting: &SettingText<'_>| setting.name == conflict.given;
        let index = settings.iter().position(is_replaced).unwrap_or_default();
        Err(SettingFault::of_name(index, conflict.error(&advice)))
    }

    /// Changes the aerodynamic law to the law `name` with its published coefficients. If `name` is
    /// already the law of this setup, its coefficients are kept.
    ///
    /// # Errors
    /// [`Error::Unknown`], with the nearest name, if no law has this name, and [`Error::Together`]
    /// for the law `table` if no table is set.
    pub fn set_law(&mut self, name: &str) -> Result<()> {
        let name = name.trim();
        if name == TABLE_LAW {
            if matches!(self.law, Law::Table(_)) {
                return Ok(());
            }
            let reason = format!(
                "name the file of your table, {TABLE} = \"mine.csv\" in a setup file or `set \
                 {TABLE}=mine.csv`"
            );
            return Err(Error::Together {
                given: format!("{LAW} = {TABLE_LAW} is given without {TABLE}"),
                reason,
            });
        }
        let law = Law::named(name).ok_or_else(|| {
            let names = Law::NAMES.iter().copied().chain([TABLE_LAW]);
            let advice = format!(
                "the laws are {}, and {TABLE_LAW} with your own {TABLE}",
                Law::NAMES.join(", ")
            );
            Error::unknown("aerodynamic law", name, names, advice)
        })?;
        if law.name() != self.law.name() {
            self.law = law;
        }
        Ok(())
    }

    /// Changes the law to a user's own table in a CSV file. If the law is a table already, its
    /// factors (`aero.cd_factor`, `aero.cl_factor`) are kept.
    ///
    /// # Errors
    /// The errors of [`LawTable::open`].
    pub fn set_table(&mut self, path: &Path) -> Result<()> {
        let table = LawTable::open(path)?;
        match &mut self.law {
            Law::Table(law) => law.table = table,
            law => {
                let factors = TableFactors::defaults();
                *law = Law::Table(Table { factors, table });
            }
        }
        Ok(())
    }

    /// Sets a parameter to an SI value. `None` unsets an optional parameter. If other parameters
    /// replace this parameter, `None` resets it to its default.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the value is outside the range, [`Error::NotANumber`] if it is NaN,
    /// [`Error::OtherLaw`] if the parameter is a coefficient of another law, and
    /// [`Error::Unreadable`] if `value` is `None` and the parameter needs a value.
    pub fn set_value(&mut self, parameter: &Parameter, value: Option<f64>) -> Result<()> {
        if let Some(value) = value {
            parameter.check(value)?;
        } else if parameter.kind != Kind::Optional && self.why_replaced(parameter).is_none() {
            return Err(parameter.needs_a_value());
        }
        self.states_step |= is_of_step(parameter.name);
        match (self.slot(parameter), value) {
            (Some(Slot::Required(place) | Slot::Setting(place)), Some(value)) => *place = value,
            (Some(Slot::Optional(place)), value) => *place = value,
            (Some(Slot::Required(_)), None) => self.reset(parameter),
            (Some(Slot::Setting(_)), None) => {}
            (None, _) => return Err(self.of_other_law(parameter)),
        }
        Ok(())
    }

    /// The setup with other values of some parameters, SI.
    ///
    /// # Errors
    /// [`Error::Unreadable`] unless each parameter has one value; the errors of
    /// [`set_value`](Self::set_value).
    pub fn with_values(&self, parameters: &[&'static Parameter], values: &[f64]) -> Result<Self> {
        if parameters.len() != values.len() {
            let (values, parameters) = (values.len() as u64, parameters.len() as u64);
            let source = format!(
                "{} for {}; give one value for each",
                counted(values, "value"),
                counted(parameters, "parameter")
            );
            return Err(Error::unreadable("the values", source));
        }
        let mut changed = *self;
        for (parameter, value) in parameters.iter().zip(values) {
            changed.set_value(parameter, Some(*value))?;
        }
        Ok(changed)
    }

    /// The error for a coefficient of another law, which may share its name with a coefficient of
    /// this law.
    fn of_other_law(&self, parameter: &Parameter) -> Error {
        let owners = parameter.law.unwrap_or_default().into();
        Error::OtherLaw {
            name: parameter.name.into(),
            law: self.law.name(),
            owners,
        }
    }

    /// Resets a parameter to its default. The drive does not use the default, because other
    /// parameters replace this parameter.
    pub(crate) fn reset(&mut self, parameter: &Parameter) {
        if let (Some(Slot::Required(place)), Some(default)) =
            (self.slot(parameter), parameter.default_value())
        {
            *place = default;
        }
    }

    /// Checks every value against its range, the inertia tensor, and parameters that must be given
    /// together.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if a value is outside its range, or if the time limit contains more
    /// than 1e8 steps; [`Error::NotANumber`] if a value is NaN; [`Error::Inertia`] if the inertia
    /// tensor is not positive definite; [`Error::Launch`] if the launch conditions are incomplete
    /// or conflict; [`Error::Together`] if weather or wind is given twice or incompletely.
    pub fn validate(&self) -> Result<()> {
        self.validate_values()?;
        self.check_launch(&[])?;
        self.check_air(&[])
    }

    /// Like [`validate`](Self::validate), without the checks of launch, weather and wind: the
    /// columns of a table may complete these three.
    ///
    /// # Errors
    /// The errors of [`validate`](Self::validate).
    pub fn validate_values(&self) -> Result<()> {
        for parameter in self.parameters() {
            if let Some(value) = self.value(parameter) {
                parameter.check(value)?;
            }
        }
        self.flight.check_steps()?;
        self.club.check_inertia()
    }

    /// Warnings about values that are accepted but questionable.
    pub fn warnings(&self) -> Vec<Message> {
        self.club_warnings()
            .chain(self.weather_warnings())
            .chain(self.reference_height_warning())
            .collect()
    }

    /// The [warnings](Self::warnings) that are about the club.
    pub(crate) fn club_warnings(&self) -> impl Iterator<Item = Message> {
        self.club
            .triangle_warning()
            .into_iter()
            .chain(self.massless_weight_warnings())
            .map(Message::from)
    }

    /// The parameter of this name, if it can be varied and outcomes can be differentiated by it.
    ///
    /// # Errors
    /// The errors of [`parameter`](Self::parameter); [`Error::NotVariable`] for a setting, the law,
    /// an unset parameter, an infinite radius, a parameter that others replace, and a parameter of
    /// the club if the launch is given.
    pub fn variable(&self, name: &str) -> Result<&'static Parameter> {
        let refuse = |reason: String| {
            Err(Error::NotVariable {
                name: name.into(),
                reason,
            })
        };
        if name == TURF {
            return refuse(
                "it is a choice, not a number; vary ground.compliance, ground.rolling and the like"
                    .into(),
            );
        }
        if name == METHOD {
            return refuse("it is a setting of the computation, not of the drive".into());
        }
        if CHOICES.contains(&name) {
            return refuse(format!(
                "it is a choice, not a number; compare two runs with `set {name}=…`"
            ));
        }
        let parameter = self.parameter(name)?;
        if parameter.kind == Kind::Setting {
            return refuse("it is a setting of the computation, not of the drive".into());
        }
        if self.launch.is_given() && parameter.is_of_strike() {
            return refuse(NO_CLUB.into());
        }
        if let Some(why) = self.why_replaced(parameter) {
            return refuse(why);
        }
        match self.value(parameter) {
            Some(value) if value.is_finite() => Ok(parameter),
            Some(_) => refuse(
                "it is infinite (a flat face) here; give it a finite value with `set`".into(),
            ),
            None => {
                let meaning = parameter.doc.trim_end_matches('.').split_once("unset: ");
                let meaning = meaning.map_or(String::new(), |(_, meaning)| {
                    format!(", which means: {meaning}")
                });
                refuse(format!(
                    "it is unset here{meaning}; give it a value with `set`"
                ))
            }
        }
    }

    /// The parameters of these names, each as [`variable`](Self::variable).
    ///
    /// # Errors
    /// The errors of [`variable`](Self::variable).
    pub fn variables_named(
        &self,
        names: impl IntoIterator<Item = impl AsRef<str>>,
    ) -> Result<Vec<&'static Parameter>> {
        names
            .into_iter()
            .map(|name| self.variable(name.as_ref()))
            .collect()
    }

    /// The parameter of this name, if the drives of a batch may differ in it. It may be unset or
    /// infinite in this setup.
    ///
    /// # Errors
    /// The errors of [`parameter`](Self::parameter); [`Error::NotVariable`] for a setting, the law,
    /// and a parameter that others replace.
    pub fn column(&self, name: &str) -> Result<&'static Parameter> {
        match self.parameter(name) {
            Ok(parameter)
                if parameter.kind != Kind::Setting && self.why_replaced(parameter).is_none() =>
            {
                Ok(parameter)
            }
            _ => self.variable(name),
        }
    }

    /// The value of a parameter. An unset parameter has the value [`Parameter::unset`], which may
    /// be `None`.
    pub(crate) fn value_or_unset(&self, parameter: &Parameter) -> Option<f64> {
        self.value(parameter).or(parameter.unset)
    }

    /// Checks that a parameter is a [`variable`](Self::variable) of this setup.
    ///
    /// # Errors
    /// The errors of [`variable`](Self::variable); [`Error::OtherLaw`] for a coefficient of another
    /// law.
    pub(crate) fn check_variable(&self, parameter: &Parameter) -> Result<()> {
        self.check_found(parameter, self.variable(parameter.name)?)
    }

    /// Checks that a parameter may be a [`column`](Self::column) of this setup.
    ///
    /// # Errors
    /// The errors of [`column`](Self::column); [`Error::OtherLaw`] for a coefficient of another
    /// law.
    pub(crate) fn check_column(&self, parameter: &Parameter) -> Result<()> {
        self.check_found(parameter, self.column(parameter.name)?)
    }

    fn check_found(&self, parameter: &Parameter, found: &Parameter) -> Result<()> {
        if parameter == found {
            Ok(())
        } else {
            Err(self.of_other_law(parameter))
        }
    }

    /// The parameters that [`variable`](Self::variable) accepts.
    pub fn variables(&self) -> Vec<&'static Parameter> {
        let mut rows = self.parameters();
        rows.retain(|row| self.variable(row.name).is_ok());
        rows
    }
}

/// Refuses a law beside a table, and a turf beside all of its numbers: one of the two would have no
/// effect.
fn refuse_idle_law_and_turf(settings: &[SettingText<'_>]) -> Result<(), SettingFault> {
    let place = |name: &str| settings.iter().position(|setting| setting.name == name);
    let is_given = |name: &str| place(name).is_some();
    let is_another_law =
        |setting: &SettingText<'_>| setting.name == LAW && setting.text.trim() != TABLE_LAW;
    if let Some(index) = settings.iter().position(is_another_law)
        && is_given(TABLE)
    {
        let law = settings[index].text.trim();
        let error = Error::Together {
            given: format!("{TABLE} and {LAW} = {law} are both given"),
            reason: format!(
                "a table is a law of its own, {LAW} = {TABLE_LAW}; keep one of the two"
            ),
        };
        return Err(SettingFault::of_value(index, error));
    }
    let index = place(TURF).unwrap_or_default();
    refuse_idle_turf(is_given).map_err(|error| SettingFault::of_name(index, error))
}

/// Place of a setting in the order in which several settings are applied: table, law, turf, values,
/// resets (`none`). Table and law determine which coefficients exist, and values override those of
/// the turf. A parameter can be reset only after the parameter that replaces it is set.
fn rank(name: &str, text: &str) -> u8 {
    match name {
        TABLE => 0,
        LAW => 1,
        TURF => 2,
        _ if is_reset(name, text) => 4,
        _ => 3,
    }
}
