//! The request of a command: its setup with the settings of the command line, read once.
//!
//! [`SetupArgs`] are the arguments on the command line. They are read into a [`Request`], which all
//! commands use. The library receives a setup; only this module and the commands know options.

mod setting;
mod source;
mod step;

pub use setting::{CommandSetting, refuse_duplicates};
pub use source::Source;
pub use step::warn_of_idle;

use crate::command::args::{DriveArgs, OwnLaw, SetupArgs};
use crate::command::output::{note, system, warn_early};
use crate::integration::StepChoice;
use crate::parameters::{
    LAW, Law, Parameter, SetupFile, TABLE, TURF, Vary, follows_from, is_of_strike, is_reset,
    is_unset,
};
use crate::report::{SetupOrigin, parameter_text};
use crate::units::Message;
use crate::{Error, Result, Setup};
use std::path::PathBuf;

/// Name of the parameter for the loft of the club.
pub const LOFT: &str = "club.loft";

/// The setup of a command, with the settings of its command line.
#[derive(Clone)]
pub struct Request {
    pub source: Source,
    /// The settings of the command line, in the order of the options. A parameter occurs only once.
    pub settings: Vec<CommandSetting>,
    /// The setup of the source, with the settings applied. It may lack launch conditions, and
    /// parameters without a default. The columns of a table or the points of a sweep then supply
    /// them.
    pub partial_setup: Setup<f64>,
    /// The choice of method and step.
    step: StepChoice,
}

/// Refuses parameters that a host states in the setup `content` without effect, as the commands do:
/// parameters of the club if the launch is given, and parameters whose values `columns` give or
/// replace. `columns` have a value of their own in each drive; `why` is the reason why a stated
/// value of a column is not used.
///
/// # Errors
/// [`Error::Unreadable`], which names the parameter, and [`Error::Together`].
pub fn refuse_idle(
    content: SetupFile,
    stated: &[String],
    columns: &[&'static Parameter],
    why: &str,
) -> Result<()> {
    let source = Source::of_host(content, stated.to_vec());
    Request::of_drive(source, vec![])?.refuse_columns(columns, why)
}

impl SetupArgs {
    /// Reads the setup and the settings.
    ///
    /// # Errors
    /// If the setup cannot be read, or if a setting does not apply to the setup.
    pub fn request(&self) -> Result<Request> {
        let source = Source::read(&self.drive.setup)?;
        Request::new(source, self.drive.settings()?, self)
    }
}

impl DriveArgs {
    /// Reads the setup and the settings, for a command without options of the integration.
    ///
    /// # Errors
    /// The errors of [`SetupArgs::request`].
    pub fn request(&self) -> Result<Request> {
        Request::of_drive(Source::read(&self.setup)?, self.settings()?)
    }

    /// The settings of `--set`, of options such as `--speed`, and of `--launch`.
    ///
    /// # Errors
    /// If a setting cannot be read.
    pub fn settings(&self) -> Result<Vec<CommandSetting>> {
        let mut settings = CommandSetting::read_all("set", &self.set)?;
        let short_names = self.short_names();
        settings.extend(short_names.map(|(option, parameter, value)| {
            CommandSetting::by_short_name(option, parameter, value)
        }));
        settings.extend(CommandSetting::read_all_launch("launch", &self.launch)?);
        Ok(settings)
    }
}

impl Request {
    /// Applies these settings to the source, and prints notes on values that are replaced or not
    /// used. `args` has the options other than settings.
    ///
    /// # Errors
    /// If two settings state one parameter, or if a setting does not apply to the source.
    pub fn new(source: Source, settings: Vec<CommandSetting>, args: &SetupArgs) -> Result<Self> {
        let step = args.step()?;
        Ok(Self {
            step,
            ..Self::of_drive(source, settings)?
        })
    }

    /// Applies these settings to the source, for a command that flies no drive or keeps the
    /// integration of the setup.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn of_drive(source: Source, settings: Vec<CommandSetting>) -> Result<Self> {
        refuse_duplicates(&settings)?;
        let mut request = Self {
            partial_setup: source.content.setup,
            source,
            settings,
            step: StepChoice::default(),
        };
        request.apply_settings()?;
        request.warn_of_replaced();
        request.refuse_given_twice(&request.partial_setup, &[])?;
        request.partial_setup.validate_values()?;
        if request.partial_setup.launch.is_given() {
            request.refuse_club("the drive is given by its launch")?;
            request.note_unused_club();
        }
        Ok(request)
    }

    fn apply_settings(&mut self) -> Result<()> {
        let (launch, settings): (Vec<_>, Vec<_>) = self
            .settings
            .iter()
            .partition(|setting| setting.replaces_launch());
        let mut setup = self.partial_setup;
        for setting in &launch {
            let before = setup.given_launch_conditions();
            setup.replace_spin(setup.parameter(&setting.parameter)?);
            self.note_replaced(&setup, &before, setting);
        }
        // The value `none` resets a parameter that other parameters determine. `set` would refuse
        // `none` if these have no values, but their values may come from columns of a table.
        let (resets, settings): (Vec<_>, Vec<_>) = settings
            .into_iter()
            .partition(|setting| is_reset(&setting.parameter, &setting.value));
        setup.set_all(
            settings
                .iter()
                .map(|setting| (setting.parameter.as_str(), setting.value.as_str())),
        )?;
        for setting in resets {
            setup.reset(setup.parameter(&setting.parameter)?);
        }
        for setting in launch {
            setup.set(&setting.parameter, &setting.value)?;
        }
        self.partial_setup = setup;
        Ok(())
    }

    /// The checked setup.
    ///
    /// # Errors
    /// If a parameter is missing, or if parameters contradict each other.
    pub fn setup(&self) -> Result<Setup<f64>> {
        self.refuse_idle_unset(&self.partial_setup, &[])?;
        self.partial_setup.validate()?;
        Ok(self.partial_setup)
    }

    /// The setup at the start of a search over `ranges`, texts `NAME=LOW..HIGH`: a varied parameter
    /// without a value gets the middle of its range. The parameter `along` which a chart runs gets
    /// the lowest value of its range if it has no value.
    ///
    /// # Errors
    /// The errors of [`setup`](Self::setup) and of [`Vary::read_column`].
    pub fn with_starts(
        &self,
        setup: Setup<f64>,
        ranges: &[String],
        along: Option<Vary>,
    ) -> Result<Setup<f64>> {
        let mut starts = vec![];
        for text in ranges {
            // ignore errors in the text here: the code that reads the search reports them
            let parameter = text
                .split_once('=')
                .and_then(|(name, _)| setup.column(name.trim()).ok());
            if parameter.is_some_and(|parameter| {
                !parameter.is_of_launch() && setup.value(parameter).is_none()
            }) {
                let vary = Vary::read_column(&setup, text)?;
                starts.push((vary.parameter, vary.start(&setup)));
            }
        }
        starts.extend(along.map(|along| (along.parameter, along.low)));
        self.fill_missing(setup, starts, "begins at")
    }

    /// Adds these values to a setup. A parameter that already has a value keeps it. A note reports
    /// each added value; `how` is the verb of the note, such as "begins at".
    ///
    /// # Errors
    /// The errors of [`setup`](Self::setup).
    pub fn fill_missing(
        &self,
        mut setup: Setup<f64>,
        values: impl IntoIterator<Item = (&'static Parameter, f64)>,
        how: &str,
    ) -> Result<Setup<f64>> {
        let mut added = vec![];
        for (parameter, value) in values {
            if setup.value(parameter).is_some() {
                continue;
            }
            // refuse a launch condition: the conditions of a launch must be given together
            if parameter.is_of_launch() {
                setup.variable(parameter.name)?;
            }
            setup.set_value(parameter, Some(value))?;
            added.push(parameter);
            let shown = parameter_text(parameter, value, system());
            note(&format!(
                "note: {} has no value in {}; it {how} {shown}",
                parameter.name,
                self.source.name()
            ));
        }
        self.refuse_replaced(&setup, &added)?;
        setup.validate()?;
        Ok(setup)
    }

    /// The setup with the value 0 for each missing condition of a given launch whose default is 0
    /// ([`Setup::with_assumed_launch`]). With a value, such a condition can have an uncertainty,
    /// like a measured one. A note reports each added value.
    ///
    /// # Errors
    /// The errors of [`Setup::set_value`].
    pub fn with_assumed_launch(&self, setup: Setup<f64>) -> Result<Setup<f64>> {
        for condition in setup.conditions_assumed_zero() {
            note(&format!(
                "note: {} is missing: {} is assumed",
                condition.name,
                parameter_text(condition, 0.0, system())
            ));
        }
        setup.with_assumed_launch()
    }

    /// The names of the parameters that the host states, then of those that the command line
    /// states.
    pub fn stated(&self) -> impl Iterator<Item = &str> {
        let by_host = &self.source.stated;
        let by_setting = self.settings.iter().map(|setting| &setting.parameter);
        let only_by_setting = by_setting.filter(|name| !by_host.contains(name));
        by_host.iter().chain(only_by_setting).map(String::as_str)
    }

    /// True if the command line or the host states the parameter. A search over the default ranges
    /// does not vary stated parameters.
    pub fn states(&self, name: &str) -> bool {
        self.stated().any(|stated| stated == name)
    }

    /// The setup as a title: "tour-average, swing.speed=95mph".
    pub fn title(&self) -> String {
        let settings = self.settings.iter();
        let settings = settings.map(|setting| format!(", {}={}", setting.parameter, setting.value));
        self.source.title() + &settings.collect::<String>()
    }

    /// The description of the setup for the first lines of an answer, with the advice of
    /// [`Self::loft_advice`].
    pub fn origin(&self) -> SetupOrigin {
        SetupOrigin {
            advice: self.loft_advice().unwrap_or_default(),
            ..self.origin_of_shots()
        }
    }

    /// The description of the setup for the first lines of an answer on measured shots. It has no
    /// advice on the loft of the setup: the shots have their own launch or club.
    pub fn origin_of_shots(&self) -> SetupOrigin {
        SetupOrigin {
            title: self.title(),
            has_name: self.source.has_name(),
            ..SetupOrigin::default()
        }
    }

    /// True if the setup starts from the preset of an average of many golfers, and neither the
    /// setup file nor a setting gives a launch or one of the parameters for which `is` is true.
    pub fn has_average(&self, is: impl Fn(&str) -> bool) -> bool {
        let preset = self.source.content.preset.name;
        preset.ends_with("-average") && !self.partial_setup.launch.is_given() && !self.gives(is)
    }

    /// Advice if the loft is that of an average golfer, but the speed is not: at another speed,
    /// another loft carries farther.
    pub fn loft_advice(&self) -> Option<String> {
        if !self.has_average(|name| name == LOFT) {
            return None;
        }
        let preset = self.source.content.preset.name;
        let own = Setup::preset(preset).ok()?;
        if self.partial_setup.swing.speed == own.swing.speed {
            return None;
        }
        let show = |name| {
            let parameter = own.variable(name).ok()?;
            Some(parameter_text(parameter, own.value(parameter)?, system()))
        };
        Some(format!(
            "{LOFT} {} is the loft of {preset} at {}: at another speed another loft carries farther; \
             state your loft, for example `set {LOFT}=10.5deg`",
            show(LOFT)?,
            show("swing.speed")?
        ))
    }

    /// The description of the setup for the first lines of a search's answer, with the advice of
    /// [`Self::best_loft_advice`] if the search varies the loft.
    pub fn origin_of_search(&self, vary: &[Vary]) -> SetupOrigin {
        let varies_loft = vary.iter().any(|vary| vary.parameter.name == LOFT);
        if !varies_loft {
            return self.origin();
        }
        SetupOrigin {
            advice: self.best_loft_advice().unwrap_or_default(),
            ..self.origin()
        }
    }

    /// Advice if a best loft is for shaft and strike of an average golfer, or for a rigid shaft: the
    /// best loft of a single golfer differs by some degrees. `None` if a parameter of shaft or strike
    /// is given.
    fn best_loft_advice(&self) -> Option<String> {
        let is_of_shaft_or_strike =
            |name: &str| name.starts_with("swing.shaft") || name.starts_with("strike.");
        if self.has_average(is_of_shaft_or_strike) {
            return Some(format!(
                "the loft is for the shaft and strike of {}, and yours may differ by some degrees: \
                 `delivery()` starts from your own launch, `presets()` lists other golfers",
                self.source.content.preset.name
            ));
        }
        let setup = &self.partial_setup;
        let has_rigid_shaft = setup.swing.shaft_bend.is_none() && !setup.launch.is_given();
        if !has_rigid_shaft || self.gives(is_of_shaft_or_strike) {
            return None;
        }
        Some(
            "the loft is for a rigid shaft; a shaft that bends by 2 to 5 deg needs about as much less \
             loft: `set swing.shaft_bend=2.5deg`"
                .into(),
        )
    }

    /// The arguments that give this setup to another command: the source and its settings, except
    /// the settings of the parameters `without`.
    pub fn as_arguments(&self, without: &[&Parameter]) -> Vec<String> {
        let is_kept = |setting: &&CommandSetting| {
            let mut without = without.iter();
            without.all(|parameter| parameter.name != setting.parameter)
        };
        let settings = self.settings.iter().filter(is_kept);
        std::iter::once(self.source.argument.clone())
            .chain(settings.flat_map(CommandSetting::as_argument))
            .collect()
    }

    /// Refuses a setup that gives a launch condition; `why` is the reason, with advice.
    pub fn refuse_launch(&self, setup: &Setup<f64>, why: &str) -> Result<()> {
        if setup.given_launch_conditions().is_empty() {
            return Ok(());
        }
        let of_launch = || {
            let settings = self.settings.iter();
            settings.filter(|setting| setting.is_of_launch())
        };
        let stated = of_launch()
            .find(|setting| setting.replaces_launch())
            .or(of_launch().next());
        let name = match stated {
            Some(setting) if setting.replaces_launch() => format!("`{}`", setting.argument),
            Some(setting) => format!("`{} launch.…`", setting.argument),
            None => format!("the launch in {}", self.source.name()),
        };
        Err(Error::unreadable(name, why))
    }

    /// Returns true if a setup file or a setting gives the ground of the roll-out.
    pub fn gives_ground(&self) -> bool {
        self.gives(|name| name.starts_with("ground.") && name != "ground.height")
    }

    /// Returns true if a setup file or a setting gives the air.
    pub fn gives_air(&self) -> bool {
        self.gives(|name| name.starts_with("air."))
    }

    fn gives(&self, is: impl Fn(&str) -> bool) -> bool {
        self.given().any(is)
    }

    /// The names of the parameters that the command line, the host or a setup file gives, each
    /// once.
    pub fn given(&self) -> impl Iterator<Item = &str> {
        let in_file = self.source.content.given.iter();
        let only_in_file = in_file.filter(|parameter| !self.states(parameter.name));
        self.stated()
            .chain(only_in_file.map(|parameter| parameter.name))
    }

    /// The input files of the setup: the setup file, and tables of drag and lift.
    pub fn inputs(&self) -> impl Iterator<Item = PathBuf> {
        let of_source = self.source.content.setup.law.table();
        let of_setting = self
            .settings
            .iter()
            .filter(|setting| setting.parameter == TABLE);
        let file = self.source.file().map(PathBuf::from);
        file.into_iter()
            .chain(of_source.map(|table| PathBuf::from(&table.file)))
            .chain(of_setting.map(|setting| PathBuf::from(&setting.value)))
    }
}

/// Refusal of settings and files that contradict the command.
impl Request {
    /// Refuses settings of club parameters, because the command uses no club.
    /// A value that the host states counts as a setting.
    ///
    /// # Errors
    /// [`Error::Unreadable`], which names the setting and gives the reason `why`.
    pub fn refuse_club(&self, why: &str) -> Result<()> {
        match self.first_stated(is_of_strike) {
            Some(name) => {
                let source = format!(
                    "{why}: the parameters of swing, club, strike and impact are not used; leave \
                     it out, or give the drive by its club"
                );
                Err(Error::unreadable(name, source))
            }
            None => Ok(()),
        }
    }

    /// Refuses settings of these parameters: their values come from another source, so a setting
    /// would have no effect. A value that the host states counts as a setting.
    ///
    /// # Errors
    /// [`Error::Unreadable`], which names the setting and gives the reason `why`.
    pub fn refuse_stated(&self, parameters: &[&'static Parameter], why: &str) -> Result<()> {
        let is_unused = |name: &str| parameters.iter().any(|parameter| parameter.name == name);
        match self.first_stated(is_unused) {
            Some(name) => Err(Error::unreadable(
                name,
                format!("{why}, so this one is not used; leave it out"),
            )),
            None => Ok(()),
        }
    }

    /// The name, for messages, of the first stated parameter for which `is` is true. The settings
    /// of the command line come first, then the values that the host states.
    fn first_stated(&self, is: impl Fn(&str) -> bool) -> Option<String> {
        let setting = self.settings.iter().find(|setting| is(&setting.parameter));
        if let Some(setting) = setting {
            return Some(setting.named());
        }
        let name = self.source.stated.iter().find(|name| is(name))?;
        Some(format!("{name} of the setup"))
    }

    /// Like [`refuse_stated`](Self::refuse_stated), but allows settings of launch conditions: a
    /// launch needs a value of each of its conditions.
    ///
    /// # Errors
    /// The errors of [`refuse_stated`](Self::refuse_stated).
    pub fn refuse_stated_besides_launch(
        &self,
        parameters: &[&'static Parameter],
        why: &str,
    ) -> Result<()> {
        let mut parameters = parameters.to_vec();
        parameters.retain(|parameter| !parameter.is_of_launch());
        self.refuse_stated(&parameters, why)
    }

    /// Refuses settings without effect beside `columns`, which have a value of their own in each
    /// drive. These are settings of the columns themselves, of parameters that the columns replace,
    /// and of the club if the columns are a launch. `why` is the reason why a setting of a column
    /// is not used.
    ///
    /// # Errors
    /// [`Error::Unreadable`], which names the setting, and [`Error::Together`].
    pub fn refuse_columns(&self, columns: &[&'static Parameter], why: &str) -> Result<()> {
        self.refuse_stated(columns, why)?;
        self.refuse_replaced(&self.partial_setup, columns)?;
        let is_launch = columns.iter().any(|parameter| parameter.is_of_launch());
        if is_launch && !self.partial_setup.launch.is_given() {
            self.refuse_club("the points are launches")?;
        }
        Ok(())
    }

    /// Refuses parameters that the setup file or a setting states, if other stated parameters, or
    /// the columns `more`, replace their values.
    ///
    /// # Errors
    /// [`Error::Together`].
    pub fn refuse_replaced(&self, setup: &Setup<f64>, more: &[&'static Parameter]) -> Result<()> {
        self.refuse_given_twice(setup, more)?;
        self.refuse_idle_unset(setup, more)
    }

    fn refuse_given_twice(&self, setup: &Setup<f64>, more: &[&'static Parameter]) -> Result<()> {
        let is_unset_by_setting = |parameter: &Parameter| {
            self.settings
                .iter()
                .any(|setting| setting.parameter == parameter.name && is_unset(&setting.value))
        };
        let in_file = self.source.content.given.iter().copied();
        let by_settings = self
            .settings
            .iter()
            .filter(|setting| !is_unset(&setting.value))
            .filter_map(|setting| setup.parameter(&setting.parameter).ok());
        let names: Vec<_> = in_file
            .filter(|parameter| !is_unset_by_setting(parameter))
            .chain(by_settings)
            .filter(|parameter| setup.value(parameter).is_some())
            .chain(more.iter().copied())
            .map(|parameter| parameter.name)
            .collect();
        setup.refuse_replaced(&names)
    }

    /// Refuses `--set NAME=none` if nothing else determines NAME: neither other parameters of the
    /// setup, nor the columns `more`.
    fn refuse_idle_unset(&self, setup: &Setup<f64>, more: &[&'static Parameter]) -> Result<()> {
        let mut setup = *setup;
        let resets = |setting: &&CommandSetting| is_reset(&setting.parameter, &setting.value);
        for setting in self.settings.iter().filter(resets) {
            let follows = more
                .iter()
                .any(|other| follows_from(&setting.parameter, other.name));
            if !follows {
                setup.set_value(setup.parameter(&setting.parameter)?, None)?;
            }
        }
        Ok(())
    }
}

/// Notes for the user about the setup.
impl Request {
    /// Prints a note on the start value of each parameter that is both stated and varied.
    pub fn note_starts(&self, setup: &Setup<f64>, vary: &[Vary]) {
        for name in self.stated() {
            let Some(range) = vary.iter().find(|range| range.parameter.name == name) else {
                continue;
            };
            let stated = range.start(setup);
            let start = stated.clamp(range.low, range.high);
            let start_text = parameter_text(range.parameter, start, system());
            let moved = if start == stated {
                ""
            } else {
                ", the end of its range"
            };
            note(&format!(
                "note: {name} is varied; the search from the setup begins at {start_text}{moved}"
            ));
        }
    }

    /// Prints a note if a setting (`by`) has unset earlier launch conditions (`before`): total spin
    /// replaces backspin and sidespin, and backspin replaces total spin and spin axis.
    fn note_replaced(
        &self,
        setup: &Setup<f64>,
        before: &[&'static Parameter],
        by: &CommandSetting,
    ) {
        let after = setup.given_launch_conditions();
        let gone: Vec<_> = before
            .iter()
            .filter(|old| !after.contains(old))
            .map(|old| old.name.rsplit('.').next().unwrap_or(old.name))
            .collect();
        if gone.is_empty() {
            return;
        }
        let are = if gone.len() == 1 { "is" } else { "are" };
        note(&format!(
            "note: {} of {} {are} replaced by {by}",
            gone.join(" and "),
            self.source.name()
        ));
    }

    /// Warning about stated parameters for which `is_used` is false: they have no effect on the
    /// answer. `answer` is the end of the message: the name of the answer, then advice.
    pub fn unused_warning(&self, is_used: impl Fn(&str) -> bool, answer: &str) -> Option<Message> {
        let unused: Vec<_> = self.stated().filter(|name| !is_used(name)).collect();
        let unused = unused.join(", ");
        (!unused.is_empty()).then(|| format!("{unused}: no effect on {answer}").into())
    }

    /// Warns of values of the setup file that a law, a table or a turf of the command line
    /// replaces. A turf in place of another turf has no warning.
    fn warn_of_replaced(&self) {
        let has_turf = self.source.content.setup.turf().is_some();
        let settings = self.settings.iter();
        let choices = settings.filter(|setting| match &*setting.parameter {
            LAW | TABLE => true,
            TURF => !has_turf,
            _ => false,
        });
        let in_file: Vec<_> = self.source.content.given.iter().collect();
        for choice in choices {
            let group = choice.parameter.split('.').next().unwrap_or_default();
            let of_group = in_file
                .iter()
                .map(|parameter| parameter.name)
                .filter(|name| name.split('.').next() == Some(group) && !self.states(name));
            let gone = replaced(of_group, &self.source.content.setup, &self.partial_setup);
            if !gone.is_empty() {
                let are = if gone.len() == 1 { "is" } else { "are" };
                warn_early(Message::from(format!(
                    "{} of {} {are} replaced by {choice}",
                    gone.join(", "),
                    self.source.name()
                )));
            }
        }
    }

    /// Prints a note on the club parameters in a setup file, which have no effect because the drive
    /// is given by its launch.
    fn note_unused_club(&self) {
        let names: Vec<_> = self
            .source
            .content
            .given
            .iter()
            .filter(|parameter| parameter.is_of_strike())
            .map(|parameter| parameter.name)
            .collect();
        if !names.is_empty() {
            note(&format!(
                "note: {}: not used, since the drive is given by its launch: {}",
                self.source.name(),
                names.join(", ")
            ));
        }
    }
}

/// Selects the parameters among `names` whose values differ between the setups `own` and `changed`.
pub fn replaced<'a>(
    names: impl Iterator<Item = &'a str>,
    own: &Setup<f64>,
    changed: &Setup<f64>,
) -> Vec<&'a str> {
    let value = |setup: &Setup<f64>, name: &str| {
        let parameter = setup.parameter(name).ok();
        let parameter = parameter.filter(|parameter| setup.why_replaced(parameter).is_none());
        parameter.and_then(|parameter| setup.value(parameter))
    };
    names
        .filter(|name| value(own, name) != value(changed, name))
        .collect()
}

impl OwnLaw {
    /// The user's table of drag and lift, if one is given.
    ///
    /// # Errors
    /// The errors of [`Setup::set_all`] and [`Setup::validate`], and [`Error::Unreadable`] if a
    /// setting has a parameter that does not belong to the table.
    pub fn law(&self) -> Result<Option<Law<f64>>> {
        let settings = CommandSetting::read_all("set", &self.set)?;
        refuse_duplicates(&settings)?;
        if settings.is_empty() {
            return Ok(None);
        }
        let refused = || {
            Error::unreadable(
                settings
                    .iter()
                    .map(CommandSetting::to_string)
                    .collect::<Vec<_>>()
                    .join(" "),
                "this command uses every law as published; `set` only adds your own table and \
                 its factors: `set aero.table=mine.csv`",
            )
        };
        let mut setup = Setup::modern_driver();
        let pairs = settings
            .iter()
            .map(|setting| (setting.parameter.as_str(), setting.value.as_str()));
        match setup.set_all(pairs) {
            Err(Error::OtherLaw { .. }) => return Err(refused()),
            set => set?,
        }
        setup.validate()?;
        let is_alone = setup
            == Setup {
                law: setup.law,
                ..Setup::modern_driver()
            };
        let law = setup.law.table().filter(|_| is_alone).map(|_| setup.law);
        law.map(Some).ok_or_else(refused)
    }
}
