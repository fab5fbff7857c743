use crate::command::args::{OwnLaw, Question};
use crate::command::output::{system, tell, warn_early};
use crate::command::running::running;
use crate::command::wording::{advice_on, no_setup};
use crate::parameters::{
    GOLFER, Law, METHOD, PRESETS, Parameter, Preset, SPEED_OF, SetupFile, TABLE, Vary,
    follows_from, is_taken_back, is_unset,
};
use crate::report::{parameter_text, setup_toml, with_step_of, without_step};
use crate::study::{Accuracy, accuracy};
use crate::units::{Message, Quantity, counted};
use crate::{Error, Outcome, Result, Setup};
use std::path::{Path, PathBuf};

/// The setup that is read from standard input.
const STANDARD_INPUT: &str = "-";
const STANDARD_INPUT_NAME: &str = "standard input";

/// The tolerance of commands that fly many drives, m.
const MICROMETRE: f64 = 1e-6;

impl Question {
    /// The setup asked about: a preset or a file, with the overrides applied, checked.
    pub fn setup(&self) -> Result<Setup<f64>> {
        let setup = self.setup_of_points()?;
        self.refuse_idle_back(&setup, &[])?;
        setup.validate()?;
        Ok(setup)
    }

    /// The arguments that give this setup to another command, without what is set of these
    /// parameters.
    pub fn as_arguments(&self, without: &[&Parameter]) -> Vec<String> {
        let is_left_out = |text: &str| {
            text.split_once('=').is_some_and(|(name, _)| {
                without
                    .iter()
                    .any(|parameter| parameter.name == name.trim())
            })
        };
        let set = self
            .set
            .iter()
            .filter(|text| !is_left_out(text))
            .flat_map(|text| ["--set".to_owned(), text.clone()]);
        std::iter::once(self.setup.clone()).chain(set).collect()
    }

    /// The setup of a search that varies parameters within ranges, `NAME=LOW..HIGH`: one of them
    /// without a value begins in the middle.
    pub fn setup_varied<'a>(
        &self,
        ranges: impl IntoIterator<Item = &'a String>,
    ) -> Result<Setup<f64>> {
        let setup = self.setup_of_points()?;
        self.refuse_idle_back(&setup, &[])?;
        self.varied(setup, ranges)
    }

    /// This setup, with a value of each parameter of these ranges that has none in it.
    pub fn varied<'a>(
        &self,
        setup: Setup<f64>,
        ranges: impl IntoIterator<Item = &'a String>,
    ) -> Result<Setup<f64>> {
        let mut begins = vec![];
        for text in ranges {
            // what is wrong with it is told where it is read
            let parameter = text
                .split_once('=')
                .and_then(|(name, _)| setup.column(name.trim()).ok());
            if parameter.is_some_and(|parameter| {
                !parameter.is_of_launch() && setup.value(parameter).is_none()
            }) {
                let vary = Vary::read_column(&setup, text)?;
                begins.push((vary.parameter, vary.start(&setup)));
            }
        }
        self.begun(setup, begins, "begins at")
    }

    /// Says of what is set and varied too that the value is where the search begins, and no more.
    pub fn tell_of_the_start(&self, setup: &Setup<f64>, vary: &[Vary]) {
        for text in &self.set {
            let name = text.split_once('=').map_or("", |(name, _)| name.trim());
            if let Some(range) = vary.iter().find(|range| range.parameter.name == name) {
                let (set, [low, high]) = (range.start(setup), [range.low, range.high]);
                let start = parameter_text(range.parameter, set.clamp(low, high), system());
                let moved = if (low..=high).contains(&set) {
                    ""
                } else {
                    ", the end of its range"
                };
                tell(&format!(
                    "note: {name} is varied; the search from the setup begins at {start}{moved}"
                ));
            }
        }
    }

    /// The setup with a value of each of these parameters that has none in it; `how` says what it
    /// is.
    pub fn begun(
        &self,
        mut setup: Setup<f64>,
        values: impl IntoIterator<Item = (&'static Parameter, f64)>,
        how: &str,
    ) -> Result<Setup<f64>> {
        let mut begun = vec![];
        for (parameter, value) in values {
            if setup.value(parameter).is_some() {
                continue;
            }
            // a launch is given as a whole
            if parameter.is_of_launch() {
                setup.variable(parameter.name)?;
            }
            setup.set_value(parameter, Some(value))?;
            begun.push(parameter);
            let shown = parameter_text(parameter, value, system());
            tell(&format!(
                "note: {} has no value in {}; it {how} {shown}",
                parameter.name,
                self.name()
            ));
        }
        self.refuse_replaced(&setup, &begun)?;
        setup.validate()?;
        Ok(setup)
    }

    /// The same where the points may have the rest of a launch.
    pub fn setup_of_points(&self) -> Result<Setup<f64>> {
        let (mut setup, without_unit) = self.base()?;
        let settings = settings(&self.set)?;
        let launch = self.conditions(&setup, &settings)?;
        for (condition, value) in &launch {
            let before = setup.given_launch_conditions();
            setup.replace_spin(condition);
            self.tell_replaced(&setup, &before, &format!("{}={value}", short(condition)));
        }
        let is_replaced = |name: &str| {
            settings.iter().any(|(set, _)| *set == name)
                || launch.iter().any(|(condition, _)| condition.name == name)
        };
        let read: Vec<_> = without_unit
            .into_iter()
            .filter(|parameter| !is_replaced(parameter.name))
            .collect();
        // what columns give may take the place of it
        let (back, settings): (Vec<_>, Vec<_>) = settings
            .into_iter()
            .partition(|(name, text)| is_taken_back(name, text));
        setup.set_all(settings)?;
        for (name, _) in back {
            setup.take_back(setup.parameter(name)?);
        }
        for (condition, value) in launch {
            setup.set(condition.name, value)?;
        }
        self.tell_read_as_si(&setup, &read);
        self.refuse_both(&setup, &[])?;
        setup.validate_but_launch()?;
        if setup.launch.is_given() {
            self.refuse_club(&setup, "the drive is given by its launch")?;
            self.tell_unused()?;
        }
        Ok(setup)
    }

    /// Says what of a setup file stands without a unit, as far as the drive is given by it.
    fn tell_read_as_si(&self, setup: &Setup<f64>, without_unit: &[&'static Parameter]) {
        let read = without_unit.iter().filter_map(|parameter| {
            let value = setup.value(parameter)?;
            Some(format!(
                "{} = {}",
                parameter.name,
                parameter.quantity.show(value, parameter.quantity.si)
            ))
        });
        let read: Vec<_> = read.collect();
        if !read.is_empty() {
            tell(&format!(
                "note: {}: read as SI, without a unit: {}",
                self.setup,
                read.join(", ")
            ));
        }
    }

    /// The conditions of `--launch` with their values, each given once on the command line. They
    /// come in place of those of the setup.
    fn conditions(
        &self,
        setup: &Setup<f64>,
        settings: &[(&str, &str)],
    ) -> Result<Vec<(&'static Parameter, &str)>> {
        let mut all: Vec<(&'static Parameter, &str)> = vec![];
        for text in &self.launch {
            let (name, value) = split("--launch", text)?;
            let condition = setup.launch_condition(name).ok_or_else(|| {
                let names = setup.launch_conditions();
                let advice = format!("a launch has {}", names.join(", "));
                Error::unknown("launch condition", name, names, advice)
            })?;
            let first = settings
                .iter()
                .find(|(set, _)| *set == condition.name)
                .map(|(set, value)| format!("--set {set}={value}"));
            let earlier = all
                .iter()
                .find(|(other, _)| *other == condition)
                .map(|(_, value)| format!("--launch {name}={value}"));
            if let Some(other) = first.or(earlier) {
                return Err(given_twice(
                    &format!("--launch {name}={value}"),
                    &other,
                    &format!("the {name}"),
                ));
            }
            all.push((condition, value));
        }
        Ok(all)
    }

    /// The options and files that give this setup its launch: "--launch", "mine.toml".
    pub fn launch_from(&self) -> String {
        let is_set = self
            .set
            .iter()
            .any(|text| text.trim_start().starts_with("launch."));
        match (self.launch.is_empty(), is_set) {
            (false, _) => "--launch".into(),
            (true, true) => "--set launch.…".into(),
            (true, false) => format!("the launch in {}", self.name()),
        }
    }

    /// Where no club strikes the ball, nothing of a club may be set: it would change nothing.
    pub fn refuse_club(&self, setup: &Setup<f64>, why: &str) -> Result<()> {
        for text in &self.set {
            let (name, _) = split("--set", text)?;
            if [GOLFER, SPEED_OF].contains(&name)
                || setup.parameter(name).is_ok_and(Parameter::is_of_strike)
            {
                let source = format!(
                    "{why}: of the parameters of swing, club, strike and impact none is used; \
                     leave it out, or give the drive by its \
                     club"
                );
                return Err(Error::Unreadable {
                    name: format!("--set {name}"),
                    source: source.into(),
                });
            }
        }
        Ok(())
    }

    /// A parameter whose values come from elsewhere, for the reason `why`, may not be set beside:
    /// that value would not be used.
    pub fn refuse_twice(
        &self,
        setup: &Setup<f64>,
        parameters: &[&'static Parameter],
        why: &str,
    ) -> Result<()> {
        let set = self.set.iter().map(|text| ("--set", text));
        for (option, text) in set.chain(self.launch.iter().map(|text| ("--launch", text))) {
            let (name, _) = split(option, text)?;
            let named = setup
                .launch_condition(name)
                .map_or(name, |condition| condition.name);
            if parameters.iter().any(|parameter| parameter.name == named) {
                let source = format!("{why}, so this one is not used; leave it out");
                return Err(Error::Unreadable {
                    name: format!("{option} {name}"),
                    source: source.into(),
                });
            }
        }
        Ok(())
    }

    /// What the setup file or `--set` gives may not be replaced by other parameters that are given,
    /// here or by `more`.
    pub fn refuse_replaced(&self, setup: &Setup<f64>, more: &[&'static Parameter]) -> Result<()> {
        self.refuse_both(setup, more)?;
        self.refuse_idle_back(setup, more)
    }

    /// What `--set NAME=none` takes back needs what it follows from, in the setup or in `more`.
    fn refuse_idle_back(&self, setup: &Setup<f64>, more: &[&'static Parameter]) -> Result<()> {
        let mut own = *setup;
        let back = settings(&self.set)?
            .into_iter()
            .filter(|(name, text)| is_taken_back(name, text));
        for (name, _) in
            back.filter(|(name, _)| !more.iter().any(|other| follows_from(name, other.name)))
        {
            own.set_value(setup.parameter(name)?, None)?;
        }
        Ok(())
    }

    fn refuse_both(&self, setup: &Setup<f64>, more: &[&'static Parameter]) -> Result<()> {
        let mut given: Vec<&'static Parameter> = vec![];
        for path in self.setup_file() {
            given.extend(SetupFile::open(path)?.given);
        }
        let settings = settings(&self.set)?;
        given.retain(|parameter| {
            !settings
                .iter()
                .any(|(name, text)| *name == parameter.name && is_unset(text))
        });
        let set = settings.iter().filter(|(_, text)| !is_unset(text));
        given.extend(set.filter_map(|(name, _)| setup.parameter(name).ok()));
        given.retain(|parameter| setup.value(parameter).is_some());
        setup.refuse_replaced(
            &given
                .iter()
                .chain(more)
                .map(|parameter| parameter.name)
                .collect::<Vec<_>>(),
        )
    }

    /// Whether the setup file or `--set` says on which ground the ball runs.
    pub fn gives_ground(&self) -> Result<bool> {
        self.gives(|name| name.starts_with("ground.") && name != "ground.height")
    }

    /// Whether the setup file or `--set` says in which air the ball flies.
    pub fn gives_air(&self) -> Result<bool> {
        self.gives(|name| name.starts_with("air."))
    }

    /// Whether the setup file or `--set` gives a parameter of which this is so.
    fn gives(&self, is: impl Fn(&str) -> bool) -> Result<bool> {
        let set = settings(&self.set)?.iter().any(|(name, _)| is(name));
        let files = self
            .setup_file()
            .map(SetupFile::open)
            .collect::<Result<Vec<_>>>()?;
        Ok(set
            || files
                .iter()
                .flat_map(|file| &file.given)
                .any(|parameter| is(parameter.name)))
    }

    /// As [`refuse_twice`](Self::refuse_twice), for parameters that must have a value in the setup
    /// before another option gives their values: where they have none without the setting, and in a
    /// launch, the setting is needed.
    pub fn refuse_unused(
        &self,
        setup: &Setup<f64>,
        parameters: &[&'static Parameter],
        why: &str,
    ) -> Result<()> {
        let (base, _) = self.base()?;
        let has_own = |parameter: &&&Parameter| {
            !parameter.is_of_launch() && base.variable(parameter.name).is_ok()
        };
        self.refuse_twice(
            setup,
            &parameters
                .iter()
                .filter(has_own)
                .copied()
                .collect::<Vec<_>>(),
            why,
        )
    }

    /// Says which conditions of the setup's launch have gone with the form of the spin that another
    /// takes the place of.
    fn tell_replaced(&self, setup: &Setup<f64>, before: &[&'static Parameter], by: &str) {
        let after = setup.given_launch_conditions();
        let gone: Vec<_> = before
            .iter()
            .filter(|old| !after.contains(old))
            .map(|old| short(old))
            .collect();
        if !gone.is_empty() {
            let are = if gone.len() == 1 { "is" } else { "are" };
            tell(&format!(
                "note: {} of {} {are} replaced by --launch {by}",
                gone.join(" and "),
                self.name()
            ));
        }
    }

    /// Says what a setup file gives of a club that does not strike the ball.
    fn tell_unused(&self) -> Result<()> {
        for path in self.setup_file() {
            let of_club = SetupFile::open(path)?
                .given
                .into_iter()
                .filter(|parameter| parameter.is_of_strike());
            let names: Vec<_> = of_club.map(|parameter| parameter.name).collect();
            if !names.is_empty() {
                tell(&format!(
                    "note: {}: not used, since the drive is given by its launch: {}",
                    path.display(),
                    names.join(", ")
                ));
            }
        }
        Ok(())
    }

    /// The setup, integrated within the tolerance asked for.
    pub fn within_tolerance(&self, setup: Setup<f64>) -> Result<Setup<f64>> {
        Ok(self
            .asked_accuracy(&setup, &[], &of_the_flight())?
            .map_or(setup, |found| found.applied_to(&setup)))
    }

    /// The setup, integrated as many drives of it are wherever its parameters lie in these ranges.
    pub fn for_many(&self, setup: Setup<f64>, ranges: &[Vary]) -> Result<Setup<f64>> {
        let begun = Vary::begun(&setup, ranges)?;
        Ok(self
            .accuracy(&begun, ranges, &of_the_flight())?
            .map_or(setup, |found| found.applied_to(&setup)))
    }

    /// How many drives are integrated: within the tolerance asked for or, where none is, a
    /// micrometre; `None` where it is by flight.method and flight.step of the setup.
    pub fn accuracy(
        &self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> Result<Option<Accuracy>> {
        if self.tolerance.is_some() || !self.chooses_step()? {
            return self.asked_accuracy(setup, ranges, of);
        }
        match accuracy(setup, ranges, of, MICROMETRE) {
            Err(Error::Tolerance { reason, .. }) => {
                warn_early(Message::from(format!(
                    "flown with flight.method = {} and flight.step = {} s of the setup, since no \
                     step is within 1 um: {reason}",
                    setup.method.name(),
                    setup.flight.step
                )));
                Ok(None)
            }
            found => landing(found),
        }
    }

    fn asked_accuracy(
        &self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> Result<Option<Accuracy>> {
        let Some(text) = &self.tolerance else {
            return Ok(None);
        };
        let refused = |reason: String| Error::Unreadable {
            name: "--tolerance".into(),
            source: reason.into(),
        };
        let tolerance = Quantity::LENGTH
            .read(text)
            .map_err(|error| refused(error.to_string()))?;
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(refused(format!(
                "\"{text}\" is no tolerance; give a length above 0, for example 1um"
            )));
        }
        if let Some((name, _)) = settings(&self.set)?
            .into_iter()
            .find(|(name, _)| is_of_step(name))
        {
            return Err(refused(format!(
                "it chooses method and step, and --set {name} gives one of them; leave one out"
            )));
        }
        let found = landing(accuracy(setup, ranges, of, tolerance))?;
        if let Some(Accuracy {
            method,
            step,
            error,
            drives,
            ..
        }) = found
        {
            tell(&format!(
                "method {} with a step of {step:.4} s: lengths are within {error:.1e} m of their \
                 exact values in the {} checked",
                method.name(),
                counted(drives as u64, "drive")
            ));
        }
        Ok(found)
    }

    /// Whether method and step are chosen where no tolerance is asked for: not where someone has
    /// said what they are.
    fn chooses_step(&self) -> Result<bool> {
        if self.own_step
            || self
                .set
                .iter()
                .any(|text| split("--set", text).is_ok_and(|(name, _)| is_of_step(name)))
        {
            return Ok(false);
        }
        if self
            .preset()?
            .entries
            .iter()
            .any(|entry| is_of_step(entry.name))
        {
            return Ok(false);
        }
        Ok(Preset::named(&self.setup).is_some() || !self.file()?.gives_step)
    }

    /// A setup file that the command writes: with method and step where someone has said what they
    /// are, and not where they were chosen for this command. Who reads it may choose.
    pub fn as_stated(&self, toml: String) -> Result<String> {
        if self.chooses_step()? {
            return Ok(without_step(&toml));
        }
        // those of a tolerance serve the drives of this command alone
        Ok(match self.tolerance {
            Some(_) => with_step_of(
                &setup_toml(&self.base()?.0, self.preset()?, &[], &[])?,
                &toml,
            ),
            None => toml,
        })
    }

    /// The preset that the setup started from.
    pub fn preset(&self) -> Result<&'static Preset> {
        Preset::named(&self.setup).map_or_else(|| Ok(self.file()?.preset), Ok)
    }

    /// What messages call the setup.
    pub fn name(&self) -> &str {
        if self.setup == STANDARD_INPUT {
            STANDARD_INPUT_NAME
        } else {
            &self.setup
        }
    }

    /// What the setup file says, or what standard input does.
    fn file(&self) -> Result<SetupFile> {
        if self.setup != STANDARD_INPUT {
            let path = Path::new(&self.setup);
            if let Some(message) = no_setup(path) {
                return Err(Error::Toml {
                    file: self.setup.clone(),
                    message,
                });
            }
            return SetupFile::open(path);
        }
        let unread = |source| Error::File {
            file: self.name().into(),
            source,
            presets: Preset::names(),
        };
        let text = running().input().map_err(unread)?;
        if text.trim().is_empty() {
            let source = format!(
                "it is empty; give a setup in TOML, or name a preset ({}) in place of -",
                Preset::names()
            );
            return Err(Error::Unreadable {
                name: self.name().into(),
                source: source.into(),
            });
        }
        SetupFile::read(&text, self.name())
    }

    /// The setup file, if it is one on a disk.
    fn setup_file(&self) -> impl Iterator<Item = &Path> {
        let is_file = Preset::named(&self.setup).is_none() && self.setup != STANDARD_INPUT;
        std::iter::once(Path::new(&self.setup)).filter(move |_| is_file)
    }

    /// The files that it reads: its setup file, and tables of drag and lift that this and --set
    /// name.
    pub fn inputs(&self) -> impl Iterator<Item = PathBuf> {
        let files = self.setup_file().map(Path::to_owned);
        let named = Some(()).filter(|()| Preset::named(&self.setup).is_none());
        let of_setup = named
            .and_then(|()| self.file().ok()?.setup.law.table())
            .into_iter();
        let set = self
            .set
            .iter()
            .filter_map(|text| split("--set", text).ok())
            .filter(|(name, _)| *name == TABLE);
        files
            .chain(of_setup.map(|table| PathBuf::from(table.file())))
            .chain(set.map(|(_, file)| PathBuf::from(file)))
    }

    /// The setup without the overrides, and the parameters that its file gives without a unit.
    fn base(&self) -> Result<(Setup<f64>, Vec<&'static Parameter>)> {
        let path = Path::new(&self.setup);
        let is_named_like_a_file = self.setup.contains(['/', '\\']) || path.extension().is_some();
        let looks_like_a_file = self.setup == STANDARD_INPUT
            || path.exists()
            || is_named_like_a_file && !self.setup.contains('=');
        if Preset::named(&self.setup).is_some() || !looks_like_a_file {
            return Setup::preset(&self.setup)
                .map(|setup| (setup, vec![]))
                .map_err(|_| {
                    let names = PRESETS.iter().map(|preset| preset.name);
                    let usual =
                        || format!("a setup is a preset ({}) or a TOML file", Preset::names());
                    let advice = advice_on(&self.setup).unwrap_or_else(usual);
                    Error::unknown("setup", &self.setup, names, advice)
                });
        }
        let SetupFile {
            setup,
            without_unit,
            ..
        } = self.file()?;
        Ok((setup, without_unit))
    }
}

/// Whether it is a parameter of the integration.
fn is_of_step(name: &str) -> bool {
    matches!(name, METHOD | "flight.step")
}

/// All outcomes but those of the run, which no one knows within a step's error.
fn of_the_flight() -> Vec<Outcome> {
    Outcome::ALL
        .iter()
        .copied()
        .filter(|of| !of.is_of_the_run())
        .collect()
}

/// What was found, or nothing where no drive lands: then there is nothing to be exact about.
fn landing(found: Result<Accuracy>) -> Result<Option<Accuracy>> {
    match found {
        Err(Error::NoFlight { .. }) => Ok(None),
        found => found.map(Some),
    }
}

/// A launch condition as `--launch` names it.
fn short(condition: &Parameter) -> &'static str {
    condition.name.rsplit('.').next().unwrap_or(condition.name)
}

/// Two options that give the same thing, as they were given.
fn given_twice(option: &str, other: &str, what: &str) -> Error {
    let source = format!("{other} gives {what} too; keep one of the two").into();
    Error::Unreadable {
        name: option.into(),
        source,
    }
}

/// The names of `--set` with their values, each given once on the command line.
fn settings(set: &[String]) -> Result<Vec<(&str, &str)>> {
    given_once(&[("--set", set)])
}

/// The names of options with their values, each given once by all of these.
pub fn given_once<'a>(options: &[(&str, &'a [String])]) -> Result<Vec<(&'a str, &'a str)>> {
    let mut all: Vec<(&str, &str, &str)> = vec![];
    for (option, texts) in options {
        for text in *texts {
            let (name, value) = split(option, text)?;
            if let Some((other, _, earlier)) = all.iter().find(|(_, other, _)| *other == name) {
                return Err(given_twice(
                    &format!("{option} {name}={value}"),
                    &format!("{other} {name}={earlier}"),
                    name,
                ));
            }
            all.push((option, name, value));
        }
    }
    Ok(all
        .into_iter()
        .map(|(_, name, value)| (name, value))
        .collect())
}

impl OwnLaw {
    /// The user's own table, where one is given.
    ///
    /// # Errors
    /// As for a setup; and where anything else is set.
    pub fn law(&self) -> Result<Option<Law<f64>>> {
        let settings = settings(&self.set)?;
        if settings.is_empty() {
            return Ok(None);
        }
        let (mut setup, given) = (
            Setup::default(),
            format!("--set {}", self.set.join(" --set ")),
        );
        let advice = "this command takes every law as it is published; --set gives it your own \
                      table beside them, and the table's factors: --set aero.table=mine.csv";
        let refused = || Error::Unreadable {
            name: given,
            source: advice.into(),
        };
        match setup.set_all(settings) {
            Err(Error::OtherLaw { .. }) => return Err(refused()),
            set => set?,
        }
        setup.validate()?;
        let is_alone = setup
            == Setup {
                law: setup.law,
                ..Setup::default()
            };
        let law = setup.law.table().filter(|_| is_alone).map(|_| setup.law);
        law.map(Some).ok_or_else(refused)
    }
}

/// NAME=VALUE.
fn split<'a>(option: &str, text: &'a str) -> Result<(&'a str, &'a str)> {
    text.split_once('=')
        .map(|(name, value)| (name.trim(), value.trim()))
        .ok_or_else(|| {
            let example = if option.starts_with("--set") {
                "club.loft=10.5deg"
            } else {
                "ball_speed=167mph"
            };
            Error::Unreadable {
                name: format!("{option} {text}"),
                source: format!("write NAME=VALUE, for example {example}").into(),
            }
        })
}
