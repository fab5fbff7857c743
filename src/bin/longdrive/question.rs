use crate::args::Question;
use crate::output::tell;
use longdrive::parameters::{PRESETS, Parameter, Preset, SetupFile, Vary};
use longdrive::study::{Accuracy, accuracy};
use longdrive::units::{Quantity, counted};
use longdrive::{Error, Result, Setup};
use std::path::Path;

impl Question {
    /// The setup asked about: a preset or a file, with the overrides applied, checked.
    pub fn setup(&self) -> Result<Setup<f64>> {
        let mut setup = self.base()?;
        let settings = self.set.iter().map(|text| split("--set", text)).collect::<Result<Vec<_>>>()?;
        let launch = self.conditions(&setup, &settings)?;
        for (condition, _) in &launch {
            setup.replace_spin(condition);
        }
        setup.set_all(settings)?;
        for (condition, value) in launch {
            setup.set(condition.name, value)?;
        }
        setup.validate()?;
        if setup.launch.is_given() {
            self.refuse_club(&setup, "the drive is given by its launch")?;
            self.tell_unused()?;
        }
        Ok(setup)
    }

    /// The conditions of `--launch` with their values, each given once on the command line. They come in place of those of the setup.
    fn conditions(&self, setup: &Setup<f64>, settings: &[(&str, &str)]) -> Result<Vec<(&'static Parameter, &str)>> {
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
            let earlier =
                all.iter().find(|(other, _)| *other == condition).map(|(_, value)| format!("--launch {name}={value}"));
            if let Some(other) = first.or(earlier) {
                let source = format!("{other} gives the {name} too; keep one of the two").into();
                return Err(Error::Unreadable { name: format!("--launch {name}={value}"), source });
            }
            all.push((condition, value));
        }
        Ok(all)
    }

    /// The options and files that give this setup its launch: "--launch", "mine.toml".
    pub fn launch_from(&self) -> String {
        let is_set = self.set.iter().any(|text| text.trim_start().starts_with("launch."));
        match (self.launch.is_empty(), is_set) {
            (false, _) => "--launch".into(),
            (true, true) => "--set launch.…".into(),
            (true, false) => format!("the launch in {}", self.setup),
        }
    }

    /// Where no club strikes the ball, nothing of a club may be set: it would change nothing.
    pub fn refuse_club(&self, setup: &Setup<f64>, why: &str) -> Result<()> {
        for text in &self.set {
            let (name, _) = split("--set", text)?;
            if setup.parameter(name).is_ok_and(Parameter::is_of_strike) {
                let source = format!(
                    "{why}: of the parameters of swing, club, strike and impact none is used; leave it out, or give the drive by its \
                     club"
                );
                return Err(Error::Unreadable { name: format!("--set {name}"), source: source.into() });
            }
        }
        Ok(())
    }

    /// A parameter that has a value in each drive may not be set beside: that value would not be used.
    pub fn refuse_twice(&self, setup: &Setup<f64>, parameters: &[&'static Parameter]) -> Result<()> {
        let set = self.set.iter().map(|text| ("--set", text));
        for (option, text) in set.chain(self.launch.iter().map(|text| ("--launch", text))) {
            let (name, _) = split(option, text)?;
            let named = setup.launch_condition(name).map_or(name, |condition| condition.name);
            if parameters.iter().any(|parameter| parameter.name == named) {
                let source =
                    format!("every drive of the sweep has a {name} of its own, so this one is not used; leave it out");
                return Err(Error::Unreadable { name: format!("{option} {name}"), source: source.into() });
            }
        }
        Ok(())
    }

    /// Says what a setup file gives of a club that does not strike the ball.
    fn tell_unused(&self) -> Result<()> {
        for path in self.inputs() {
            let of_club = SetupFile::open(path)?.given.into_iter().filter(|parameter| parameter.is_of_strike());
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

    /// The setup, flown within the tolerance asked for wherever its parameters lie in these ranges.
    pub fn within_tolerance(&self, setup: Setup<f64>, ranges: &[Vary]) -> Result<Setup<f64>> {
        let Some(text) = &self.tolerance else { return Ok(setup) };
        let unreadable = |e| Error::Unreadable { name: "--tolerance".into(), source: Box::new(e) };
        let tolerance = Quantity::LENGTH.read(text).map_err(unreadable)?;
        let Accuracy { method, step, error, drives } = accuracy(&setup, ranges, tolerance)?;
        tell(&format!(
            "method {} with a step of {step:.4} s: carry is within {error:.1e} m of its exact value in the {} checked",
            method.name(),
            counted(drives as u64, "drive")
        ));
        let mut setup = Setup { method, ..setup };
        setup.flight.step = step;
        Ok(setup)
    }

    /// The preset that the setup started from.
    pub fn preset(&self) -> Result<&'static Preset> {
        Preset::named(&self.setup).map_or_else(|| Ok(SetupFile::open(Path::new(&self.setup))?.preset), Ok)
    }

    /// The files that it reads.
    pub fn inputs(&self) -> impl Iterator<Item = &Path> {
        std::iter::once(Path::new(&self.setup)).filter(|_| Preset::named(&self.setup).is_none())
    }

    fn base(&self) -> Result<Setup<f64>> {
        let path = Path::new(&self.setup);
        let looks_like_a_file = path.exists() || self.setup.contains(['/', '\\']) || path.extension().is_some();
        if Preset::named(&self.setup).is_some() || !looks_like_a_file {
            return Setup::preset(&self.setup).map_err(|_| {
                let names = PRESETS.iter().map(|preset| preset.name);
                let advice = format!("a setup is a preset ({}) or a TOML file", Preset::names());
                Error::unknown("setup", &self.setup, names, advice)
            });
        }
        let SetupFile { setup, without_unit, .. } = SetupFile::open(path)?;
        if !without_unit.is_empty() {
            let read = without_unit.iter().map(|parameter| {
                let value = setup.value(parameter).unwrap_or_default();
                format!("{} = {}", parameter.name, parameter.quantity.show(value, parameter.quantity.si))
            });
            tell(&format!("note: {}: read as SI, without a unit: {}", self.setup, read.collect::<Vec<_>>().join(", ")));
        }
        Ok(setup)
    }
}

/// NAME=VALUE.
fn split<'a>(option: &str, text: &'a str) -> Result<(&'a str, &'a str)> {
    text.split_once('=').map(|(name, value)| (name.trim(), value.trim())).ok_or_else(|| {
        let example = if option == "--set" { "club.loft=10.5deg" } else { "ball_speed=167mph" };
        Error::Unreadable {
            name: format!("{option} {text}"),
            source: format!("write NAME=VALUE, for example {example}").into(),
        }
    })
}
