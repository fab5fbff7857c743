use crate::derivative::{self, Order, Taylor};
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::optimize::{Domain, Evaluation, Iteration, Options, Solution, Status, Watch, minimize_watched};
use crate::parameters::{Parameter, Setup};
use crate::units;

/// A parameter to vary, and how far, SI.
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
    /// Reads `NAME=LOW..HIGH`, for example `club.loft=4deg..20deg`. A low end without unit takes that of the
    /// high end; two numbers without units are SI.
    ///
    /// ```
    /// use longdrive::{Setup, study::Vary};
    /// let loft = Vary::read(&Setup::default(), "club.loft=4..20deg").unwrap();
    /// assert_eq!((loft.low, loft.high), (4.0_f64.to_radians(), 20.0_f64.to_radians()));
    /// assert!(Vary::read(&Setup::default(), "club.loft=20deg..4deg").is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::SearchRange`] for a range that is none; as [`Setup::variable`] and [`Parameter::read`].
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let refuse = |reason: String| Error::SearchRange { name: text.trim().into(), reason };
        let (name, range) = text
            .split_once('=')
            .ok_or_else(|| refuse("write NAME=LOW..HIGH, for example club.loft=4deg..20deg".into()))?;
        let parameter = setup.variable(name.trim())?;
        let (low, high) = range
            .split_once("..")
            .ok_or_else(|| refuse(format!("'{range}' is not LOW..HIGH; write for example {name}=4deg..20deg")))?;
        let unreadable = |e| Error::Unreadable { name: name.trim().into(), source: Box::new(e) };
        let (_, low_unit) = parameter.quantity.split(low).map_err(unreadable)?;
        let (_, high_unit) = parameter.quantity.split(high).map_err(unreadable)?;
        let low = if low_unit.is_empty() { format!("{low} {high_unit}") } else { low.into() };
        let end = |text: &str| parameter.read(text, true).map(Option::unwrap_or_default);
        Self::new(parameter, end(&low)?, end(high)?)
    }

    /// A parameter with a range in SI.
    ///
    /// # Errors
    /// [`Error::SearchRange`] where it is reversed or infinite, [`Error::OutOfRange`].
    pub fn new(parameter: &'static Parameter, low: f64, high: f64) -> Result<Self> {
        let name = format!("{}={}..{}", parameter.name, parameter.show(Some(low)), parameter.show(Some(high)));
        parameter.check(low)?;
        parameter.check(high)?;
        if low > high {
            let reason = format!(
                "the range is reversed; did you mean {}..{}?",
                parameter.show(Some(high)),
                parameter.show(Some(low))
            );
            return Err(Error::SearchRange { name, reason });
        }
        if !(low.is_finite() && high.is_finite()) {
            return Err(Error::SearchRange { name, reason: "both ends must be finite".into() });
        }
        Ok(Self { parameter, low, high })
    }
}

/// What to look for.
#[derive(Clone, Debug)]
pub struct Search {
    /// The outcome to make as large as possible.
    pub maximize: Outcome,
    /// The parameters to vary.
    pub vary: Vec<Vary>,
    /// The optimizer's settings.
    pub options: Options,
}

impl Search {
    /// The longest carry over loft 4–20° and attack angle −5…+5°.
    pub fn longest_drive(setup: &Setup<f64>) -> Result<Self> {
        let vary = ["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"];
        let vary = vary.iter().map(|text| Vary::read(setup, text)).collect::<Result<_>>()?;
        Ok(Self { maximize: Outcome::Carry, vary, options: Options::default() })
    }
}

/// The best drive found.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// What was asked.
    pub search: Search,
    /// How the search ended; its objective is the negative of the outcome.
    pub solution: Solution,
    /// The setup at the optimum.
    pub setup: Setup<f64>,
    /// The drive there; `None` where nothing flew.
    pub drive: Option<Drive<f64>>,
}

impl Optimum {
    /// The outcome's value at the optimum, SI.
    pub fn value(&self) -> Option<f64> {
        self.solution.value.map(|value| -value)
    }

    /// The outcome's gradient at the optimum by the parameters varied, SI.
    pub fn gradient(&self) -> Vec<f64> {
        self.solution.gradient.iter().map(|slope| -slope).collect()
    }

    /// How the search ended, in a sentence, in terms of the drive.
    pub fn message(&self) -> String {
        let of = self.search.maximize.name();
        match (&self.solution.kink, self.solution.status) {
            (Some(kink), _) => {
                let (parameter, outcome) = (self.search.vary[kink.variable].parameter, self.search.maximize);
                let at = parameter.show(Some(self.solution.x[kink.variable]));
                let (by, unit) = (parameter.name, units::per(outcome.quantity().si, parameter.quantity.si));
                let slope = |slope: Option<f64>| {
                    slope.map_or("not looked at (out of range)".into(), |slope| format!("{:+.4} {unit}", -slope))
                };
                format!(
                    "{of} has a corner at {by} = {at}: d {of}/d {by} is {} below it and {} above",
                    slope(kink.slope_below),
                    slope(kink.slope_above),
                )
            }
            (None, Status::Undefined) => {
                let (trials, why) = (self.search.options.start_trials, self.solution.undefined_at_start.as_deref());
                format!(
                    "nothing flew, neither the start nor {trials} other points of the ranges searched; at the start {}",
                    why.unwrap_or_default()
                )
            }
            _ => self.solution.message.clone(),
        }
    }

    /// Where the search began instead, if the start does not fly.
    pub fn moved_start(&self) -> Option<String> {
        let why = self.solution.undefined_at_start.as_ref().filter(|_| !self.solution.begun_at.is_empty())?;
        let begun = self.search.vary.iter().zip(&self.solution.begun_at);
        let begun: Vec<_> =
            begun.map(|(vary, x)| format!("{} {}", vary.parameter.name, vary.parameter.show(Some(*x)))).collect();
        Some(format!("the start does not fly ({why}); begun at {} instead", begun.join(", ")))
    }

    /// The status in a word; where the optimizer says undefined, nothing flew.
    pub fn status(&self) -> &'static str {
        match self.solution.status {
            Status::Undefined => "no-flight",
            status => status.name(),
        }
    }
}

/// Finds the parameters that make an outcome largest, from the setup's own values, moved into the ranges.
///
/// ```
/// use longdrive::{Setup, study::{Search, Vary, optimum}};
/// let setup = Setup::preset("mae494").unwrap();
/// let vary = ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"];
/// let search = Search {
///     vary: vary.map(|text| Vary::read(&setup, text).unwrap()).to_vec(),
///     ..Search::longest_drive(&setup).unwrap()
/// };
/// let best = optimum(&setup, search, |_| ()).unwrap();
/// assert!((best.value().unwrap() - 153.333552731).abs() < 1e-8);
/// assert!((best.solution.upper_multipliers[1] - 60.2924949).abs() < 1e-6); // m per radian of attack angle
/// ```
///
/// # Errors
/// [`Error::Nothing`] without parameters to vary, or where every range is a single value; [`Error::SearchRange`] for one that is varied twice; what
/// [`Setup::validate`] refuses.
pub fn optimum(setup: &Setup<f64>, search: Search, watch: impl FnMut(&Iteration) + 'static) -> Result<Optimum> {
    if search.vary.iter().all(|vary| vary.low == vary.high) {
        return Err(Error::Nothing { doing: "vary", what: "parameter" });
    }
    let parameters: Vec<&'static Parameter> = search.vary.iter().map(|vary| vary.parameter).collect();
    for (i, parameter) in parameters.iter().enumerate() {
        if parameters[..i].contains(parameter) {
            return Err(Error::SearchRange {
                name: parameter.name.into(),
                reason: "it is varied twice; give it one range".into(),
            });
        }
    }
    let domain = Domain::new(
        search.vary.iter().map(|vary| vary.low).collect(),
        search.vary.iter().map(|vary| vary.high).collect(),
    )?;
    let start: Vec<f64> = parameters.iter().filter_map(|parameter| setup.value(parameter)).collect();
    let at = |x: &[f64]| moved(setup, &parameters, x);
    at(&domain.variables.project(&start))?.validate()?;

    let (base, wrt, of) = (*setup, parameters.clone(), search.maximize);
    let negative = move |x: &[f64]| -> std::result::Result<Evaluation, String> {
        let moved = moved(&base, &wrt, x).map_err(|e| e.to_string())?;
        let taylor = derivative::evaluate(&moved, &[of], &wrt, Order::Second).map_err(|e| e.to_string())?;
        let objective = taylor.into_iter().next().map(Taylor::negated).ok_or("no outcome")?;
        Ok(Evaluation { objective, constraints: vec![] })
    };
    let watch = Watch { iteration: Box::new(watch), ..Watch::default() };
    let solution = minimize_watched(negative, &domain, &start, &search.options, watch)?;
    let best = at(&solution.x)?;
    let drive = if solution.status == Status::Undefined { None } else { Some(Drive::new(&best)?) };
    Ok(Optimum { search, solution, setup: best, drive })
}

/// The setup with these parameters at `x`.
fn moved(setup: &Setup<f64>, parameters: &[&'static Parameter], x: &[f64]) -> Result<Setup<f64>> {
    let mut moved = *setup;
    for (parameter, value) in parameters.iter().zip(x) {
        moved.set_value(parameter, Some(*value))?;
    }
    Ok(moved)
}
