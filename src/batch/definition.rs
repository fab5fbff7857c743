use super::points::refuse_repeated;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Level;
use crate::parameters::{Parameter, Setup};

/// Definition of a batch: setup, swept parameters, outcomes, and parameters of differentiation.
#[derive(Clone, Debug)]
pub struct Batch {
    pub(super) setup: Setup<f64>,
    /// Swept parameters. Each point has a value for each swept parameter.
    pub(super) parameters: Vec<&'static Parameter>,
    pub(super) of: Vec<Outcome>,
    /// Parameters of differentiation; empty for values only.
    pub(super) wrt: Vec<&'static Parameter>,
    /// Largest accepted defect of the integration, m (docs/model.md, eq. 16a). Drives with a larger
    /// defect are repeated with shorter steps. Infinity keeps the setup's step.
    pub(crate) largest_defect: f64,
    pub(crate) level: Level,
}

impl Batch {
    /// Creates a batch of the outcomes `of` at points of `parameters`, with derivatives by `wrt`.
    ///
    /// # Errors
    /// The errors of [`Setup::validate`], of [`Setup::column`] for `parameters`, and of
    /// [`Setup::variable`] for `wrt`; [`Error::Nothing`] if `of` or `parameters` is empty;
    /// [`Error::OtherLaw`] for a coefficient of another law, even if the setup's law has a
    /// coefficient of the same name; [`Error::SearchRange`] if `parameters` repeats a parameter,
    /// and [`Error::Together`] if `wrt` repeats a parameter.
    pub fn new(
        setup: &Setup<f64>,
        parameters: &[&'static Parameter],
        of: &[Outcome],
        wrt: &[&'static Parameter],
    ) -> Result<Self> {
        if of.is_empty() {
            return Err(Error::Nothing {
                doing: "evaluate",
                what: "outcome",
            });
        }
        refuse_repeated(parameters)?;
        setup.check_lists(parameters, wrt)?;
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

    /// Adapts the step of each drive: if the defect of the integration (docs/model.md, eq. 16a)
    /// exceeds `defect` (m), the drive is repeated with half the step until the defect is accepted.
    /// If the defect is too large even with the shortest step, the drive has the status `diverged`.
    /// The default, infinity, keeps the setup's step.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if `defect` is NaN or ≤ 0.
    pub fn with_largest_defect(self, defect: f64) -> Result<Self> {
        if defect > 0.0 {
            return Ok(Self {
                largest_defect: defect,
                ..self
            });
        }
        Err(Error::OutOfRange {
            name: "the largest defect of a drive".into(),
            si: defect,
            value: format!("{defect} m"),
            range: "0 m < …".into(),
            advice: "use the defect of integration::accuracy, or infinity for the setup's own step"
                .into(),
        })
    }

    /// The architecture and the instruction level of the processor: `x86_64 avx2`.
    #[cfg(any(feature = "commands", feature = "parquet"))]
    pub(crate) fn instructions(&self) -> String {
        format!("{} {}", std::env::consts::ARCH, self.level)
    }

    /// Copy of the batch with the time step `step`, s.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if `step` is ≤ 0, or if the time limit would need more than 1e8 steps.
    pub(crate) fn with_step(&self, step: f64) -> Result<Self> {
        let mut batch = self.clone();
        batch.setup.flight.step = step;
        batch.setup.flight.check_steps()?;
        Ok(batch)
    }

    /// Copy of the batch with other swept parameters.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub(crate) fn with_parameters(&self, parameters: &[&'static Parameter]) -> Result<Self> {
        Ok(Self {
            largest_defect: self.largest_defect,
            level: self.level,
            ..Self::new(&self.setup, parameters, &self.of, &self.wrt)?
        })
    }

    /// Sets the instruction level. The default is the widest level of this processor.
    ///
    /// # Errors
    /// [`Error::Together`] if the processor does not support `level`.
    pub fn with_level(self, level: Level) -> Result<Self> {
        let most = Level::here();
        if !level.is_here() {
            let reason = format!(
                "this processor does not have them; its widest instruction set is {most}. Give \
                 `instructions` {most} on all machines of the sweep, or use machines with {level}"
            );
            return Err(Error::Together {
                given: format!("the instructions {level}"),
                reason,
            });
        }
        Ok(Self { level, ..self })
    }

    /// Setup whose parameters are swept.
    pub fn setup(&self) -> &Setup<f64> {
        &self.setup
    }

    /// Swept parameters.
    pub fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    /// Outcomes.
    pub fn outcomes(&self) -> &[Outcome] {
        &self.of
    }

    /// Parameters of differentiation.
    pub fn wrt(&self) -> &[&'static Parameter] {
        &self.wrt
    }

    /// Names of the result columns in files: outcomes, then derivatives, as `d_carry/d_club.loft`.
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
