use super::constraint::Constraint;
use super::search::{Search, Sense};
use crate::batch::Batch;
use crate::derivative::{self, Evaluator, Order, Taylor};
use crate::drive::Outcome;
use crate::error::Result;
use crate::optimize::{Domain, Evaluation, Problem};
use crate::parameters::{Parameter, Setup, Vary};

/// A search for the best drive as the optimizer sees it: the outcome, with the sign with which it
/// is minimised, and the outcomes that are held between limits.
pub(super) struct DriveProblem {
    setup: Setup<f64>,
    vary: Vec<&'static Parameter>,
    /// The outcome that is looked for, then those of the constraints.
    of: Vec<Outcome>,
    pub sense: Sense,
    derivatives: Evaluator,
    pub domain: Domain,
}

impl DriveProblem {
    pub fn new(setup: &Setup<f64>, search: &Search) -> Result<Self> {
        search.vary.iter().try_for_each(Vary::check)?;
        search.subject_to.iter().try_for_each(Constraint::check)?;
        let ends = |end: fn(&Vary) -> f64| search.vary.iter().map(end).collect::<Vec<_>>();
        let domain = Domain::new(ends(|vary| vary.low), ends(|vary| vary.high))?.subject_to(
            search
                .subject_to
                .iter()
                .map(|constraint| constraint.low)
                .collect(),
            search
                .subject_to
                .iter()
                .map(|constraint| constraint.high)
                .collect(),
        )?;
        let vary: Vec<_> = search.vary.iter().map(|vary| vary.parameter).collect();
        let of = search.outcomes();
        let derivatives = Evaluator::new(setup, &of, &vary, Order::Second)?;
        Ok(Self {
            setup: *setup,
            vary,
            of,
            sense: search.sense,
            derivatives,
            domain,
        })
    }

    /// The setup's own values of what is varied.
    pub fn start(&self) -> Vec<f64> {
        values(&self.setup, &self.vary)
    }

    /// The setup with the varied parameters at `x`.
    pub fn moved(&self, x: &[f64]) -> Result<Setup<f64>> {
        moved(&self.setup, &self.vary, x)
    }

    /// The outcome looked for, then those of the constraints, without derivatives.
    pub fn values(&self) -> Result<Evaluator> {
        Evaluator::new(&self.setup, &self.of, &self.vary, Order::Value)
    }

    /// The same outcomes at very many points.
    pub fn batch(&self) -> Result<Batch> {
        Batch::new(&self.setup, &self.vary, &self.of, &[])
    }

    /// The functions at `x` with derivatives by the varied parameters, and by one more.
    pub fn evaluate_with(&self, x: &[f64], parameter: &'static Parameter) -> Result<Evaluation> {
        let wrt: Vec<_> = self.vary.iter().copied().chain([parameter]).collect();
        Ok(self.as_functions(derivative::towards_last(&self.moved(x)?, &self.of, &wrt)?))
    }

    fn as_functions(&self, mut taylors: Vec<Taylor>) -> Evaluation {
        let constraints = taylors.split_off(1);
        let of = taylors.pop();
        let objective = match self.sense {
            Sense::Maximize => of.map(Taylor::negated),
            Sense::Minimize => of,
        };
        Evaluation {
            objective: objective.unwrap_or_default(),
            constraints,
        }
    }
}

/// A setup's own values of some parameters.
pub(super) fn values(setup: &Setup<f64>, parameters: &[&'static Parameter]) -> Vec<f64> {
    parameters
        .iter()
        .filter_map(|parameter| setup.value(parameter))
        .collect()
}

/// A setup with other values of some parameters.
pub(super) fn moved(
    setup: &Setup<f64>,
    parameters: &[&'static Parameter],
    values: &[f64],
) -> Result<Setup<f64>> {
    let mut moved = *setup;
    for (parameter, value) in parameters.iter().zip(values) {
        moved.set_value(parameter, Some(*value))?;
    }
    Ok(moved)
}

impl Problem for DriveProblem {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        let taylors = self.derivatives.at(x);
        taylors
            .map(|taylors| self.as_functions(taylors))
            .map_err(|e| e.to_string())
    }
}
