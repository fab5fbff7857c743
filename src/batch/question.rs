use super::points::refuse_repeated;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Level;
use crate::parameters::{NO_CLUB, Parameter, Setup, refuse_twice};

/// What is asked of every point.
#[derive(Clone, Debug)]
pub struct Batch {
    pub(super) setup: Setup<f64>,
    /// The parameters that have a value in each point.
    pub(super) parameters: Vec<&'static Parameter>,
    pub(super) of: Vec<Outcome>,
    /// What the outcomes are differentiated by; nothing for values alone.
    pub(super) wrt: Vec<&'static Parameter>,
    /// Drives with a larger defect are flown again, in shorter steps; infinite where the setup's
    /// own step is kept.
    pub(super) largest_defect: f64,
    /// The most that is used of what the processor can do.
    pub(super) level: Level,
}

impl Batch {
    /// Outcomes of the setup at the points of some parameters, with their derivatives by `wrt`, if
    /// any.
    ///
    /// # Errors
    /// What [`Setup::validate`] refuses; [`Error::Nothing`] without outcomes or swept parameters;
    /// [`Error::NotVariable`], [`Error::Unknown`] and [`Error::OtherLaw`] as [`Setup::variable`],
    /// also for a coefficient of another law of the same name; [`Error::SearchRange`] and
    /// [`Error::Together`] for a parameter given twice.
    pub fn new(
        setup: &Setup<f64>,
        parameters: &[&'static Parameter],
        of: &[Outcome],
        wrt: &[&'static Parameter],
    ) -> Result<Self> {
        setup.validate_but_launch()?;
        if of.is_empty() {
            return Err(Error::Nothing {
                doing: "evaluate",
                what: "outcome",
            });
        }
        refuse_repeated(parameters)?;
        for parameter in parameters {
            setup.check_column(parameter)?;
        }
        for parameter in wrt
            .iter()
            .filter(|parameter| !parameters.contains(parameter))
        {
            setup.check_variable(parameter)?;
        }
        refuse_twice(wrt)?;
        let names: Vec<_> = parameters.iter().map(|parameter| parameter.name).collect();
        setup.check_launch(&names)?;
        setup.check_air(&names)?;
        let is_launched =
            setup.launch.is_given() || parameters.iter().any(|parameter| parameter.is_of_launch());
        if let Some(of_club) = parameters
            .iter()
            .chain(wrt)
            .find(|parameter| is_launched && parameter.is_of_strike())
        {
            return Err(Error::NotVariable {
                name: of_club.name.into(),
                reason: NO_CLUB.into(),
            });
        }
        let (parameters, of, wrt) = (parameters.to_vec(), of.to_vec(), wrt.to_vec());
        Ok(Self {
            setup: *setup,
            parameters,
            of,
            wrt,
            largest_defect: f64::INFINITY,
            level: Level::here(),
        })
    }

    /// The same with another step for each drive that the setup's own step does not follow closely
    /// enough: one whose steps have a larger defect than this, m (docs/model.md, eq. 16a), is flown
    /// again in steps half as long, and again. One that stays above it in the shortest has the
    /// status `diverged`. Infinity keeps the setup's own step, as does a batch that has not been
    /// given any.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for NaN, 0 and below, which no drive meets.
    pub fn with_largest_defect(self, defect: f64) -> Result<Self> {
        if defect > 0.0 {
            return Ok(Self {
                largest_defect: defect,
                ..self
            });
        }
        Err(Error::OutOfRange {
            name: "the largest defect of a drive".into(),
            value: format!("{defect} m"),
            range: "0 m < …".into(),
            advice: "take that of study::accuracy, or infinity for the setup's own step".into(),
        })
    }

    /// The same with the instructions of this level in place of the most that the processor has.
    ///
    /// # Errors
    /// [`Error::Together`] where the processor does not have them.
    pub fn with_level(self, level: Level) -> Result<Self> {
        let most = Level::here();
        if !level.is_here() {
            let reason = format!(
                "this processor does not have them; the most it has is {most}. Take `instructions` \
                 {most} on every machine, or a machine that has {level}"
            );
            return Err(Error::Together {
                given: format!("the instructions {level}"),
                reason,
            });
        }
        Ok(Self { level, ..self })
    }

    /// The instructions that it is computed with.
    pub fn level(&self) -> Level {
        self.level
    }

    /// The largest defect that a drive may have, m; infinite where the setup's own step is kept.
    pub fn largest_defect(&self) -> f64 {
        self.largest_defect
    }

    /// The setup that the points move.
    pub fn setup(&self) -> &Setup<f64> {
        &self.setup
    }

    /// The swept parameters.
    pub fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    /// The outcomes.
    pub fn outcomes(&self) -> &[Outcome] {
        &self.of
    }

    /// What the outcomes are differentiated by.
    pub fn wrt(&self) -> &[&'static Parameter] {
        &self.wrt
    }

    /// The names of the columns of results, as in files: the outcomes, then their derivatives, as
    /// in `d_carry/d_club.loft`.
    pub fn columns(&self) -> Vec<String> {
        let derivative = |of: &Outcome| {
            self.wrt()
                .iter()
                .map(|by| format!("d_{}/d_{}", of.name(), by.name))
                .collect()
        };
        let derivatives = self.outcomes().iter().flat_map::<Vec<_>, _>(derivative);
        self.outcomes()
            .iter()
            .map(|of| of.name().to_owned())
            .chain(derivatives)
            .collect()
    }
}
