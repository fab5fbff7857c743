use super::Taylor;
use super::chain::{self, ParameterSplit};
use super::directions::Entries;
use super::pass::EvaluationPoint;
use crate::drive::{Outcome, with_accepted_step};
use crate::error::{Error, Result};
use crate::number::Level;
use crate::parameters::{Parameter, Setup};
use std::sync::atomic::{AtomicBool, Ordering};

/// Order of differentiation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Values.
    Value,
    /// Values and gradients.
    First,
    /// Values, gradients and Hessians.
    Second,
}

/// Evaluates outcomes of one setup, and their derivatives by some parameters, at any values of
/// these parameters. Setup, outcomes and parameters are checked once, at construction.
///
/// ```
/// use longdrive::derivative::{Evaluator, Order};
/// use longdrive::{Outcome, Setup};
/// let setup = Setup::preset("mae494").unwrap();
/// let loft = setup.variable("club.loft").unwrap();
/// let carry = Evaluator::new(&setup, &[Outcome::Carry], &[loft], Order::First).unwrap();
/// let at_ten_degrees = carry.at(&[10.0_f64.to_radians()]).unwrap();
/// assert!((at_ten_degrees[0].value - 114.312855130798).abs() < 1e-9); // the preset's own loft
/// assert!(carry.at(&[2.0]).is_err()); // 115°
/// ```
#[derive(Clone, Debug)]
pub struct Evaluator {
    setup: Setup<f64>,
    of: Vec<Outcome>,
    wrt: Vec<&'static Parameter>,
    order: Order,
    /// Entries of the Hessians to compute.
    entries: Entries,
    split: ParameterSplit,
    /// Largest accepted defect of the integration, m. If it is infinite, the setup's step is kept.
    largest_defect: f64,
    level: Level,
}

impl Evaluator {
    /// Evaluator of the outcomes `of`, with derivatives by `wrt` up to `order`. For order `Value`,
    /// the parameters may be unset, and may complete a launch, the weather or the wind.
    ///
    /// # Errors
    /// Errors of [`Setup::validate`] and [`Setup::variable`] (of [`Setup::column`] for order
    /// `Value`); [`Error::OtherLaw`] for a coefficient of another law; [`Error::Together`] for a
    /// repeated parameter; [`Error::Nothing`] without outcomes. A higher order than `Value` needs
    /// parameters: otherwise [`Error::Nothing`].
    pub fn new(
        setup: &Setup<f64>,
        of: &[Outcome],
        wrt: &[&'static Parameter],
        order: Order,
    ) -> Result<Self> {
        if of.is_empty() {
            return Err(Error::Nothing {
                doing: "evaluate",
                what: "outcome",
            });
        }
        if order > Order::Value && wrt.is_empty() {
            return Err(Error::Nothing {
                doing: "differentiate by",
                what: "parameter",
            });
        }
        if order > Order::Value {
            setup.check_lists(&[], wrt)?;
        } else {
            setup.check_lists(wrt, &[])?;
        }
        let split = ParameterSplit::of(wrt, of.iter().any(|outcome| outcome.needs_run()));
        let (of, wrt) = (of.to_vec(), wrt.to_vec());
        Ok(Self {
            setup: *setup,
            of,
            wrt,
            order,
            split,
            entries: Entries::All,
            largest_defect: f64::INFINITY,
            level: Level::here().of_one_drive(),
        })
    }

    /// Adapts the step at each point. If the defect of the integration (docs/model.md, eq. 16a)
    /// exceeds `largest_defect`, m, the drive is repeated with half the step until the defect is
    /// accepted.
    pub(crate) fn with_largest_defect(self, largest_defect: f64) -> Self {
        Self {
            largest_defect,
            ..self
        }
    }

    /// Computes only these entries of the Hessians; the others are 0.
    pub(super) fn with_entries(self, entries: Entries) -> Self {
        Self { entries, ..self }
    }

    /// Sets the instruction level; a level above AVX2 becomes AVX2.
    pub(crate) fn at_level(self, level: Level) -> Self {
        Self {
            level: level.of_one_drive(),
            ..self
        }
    }

    /// Parameters, in the order of values and derivatives.
    pub fn parameters(&self) -> &[&'static Parameter] {
        &self.wrt
    }

    /// Outcomes at the `values` of the parameters, SI.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] and [`Error::Inertia`] for impossible values; errors of
    /// [`Drive::new`](crate::Drive::new); [`Error::NoFlight`] for an outcome of a ball that does
    /// not fly; [`Error::Undefined`] if a value or derivative does not exist.
    ///
    /// # Panics
    /// If the numbers of values and parameters differ.
    pub fn at(&self, values: &[f64]) -> Result<Vec<Taylor>> {
        self.at_order(values, self.order, None)
    }

    /// Like [`at`](Self::at); interrupted if `stop` is true at the start, or becomes true during a
    /// flight of more than 4096 steps.
    ///
    /// # Errors
    /// The errors of [`at`](Self::at); [`Error::Stopped`] after an interrupt.
    ///
    /// # Panics
    /// If the numbers of values and parameters differ.
    pub fn at_until(&self, values: &[f64], stop: &AtomicBool) -> Result<Vec<Taylor>> {
        if stop.load(Ordering::Relaxed) {
            return Err(Error::Stopped);
        }
        self.at_order(values, self.order, Some(stop))
    }

    /// Outcomes with derivatives up to `order`, or up to the evaluator's own order if this is
    /// lower.
    pub(crate) fn at_order(
        &self,
        values: &[f64],
        order: Order,
        stop: Option<&AtomicBool>,
    ) -> Result<Vec<Taylor>> {
        assert_eq!(values.len(), self.wrt.len(), "a value for each parameter");
        for (parameter, value) in self.wrt.iter().zip(values) {
            parameter.check(*value)?;
        }
        let mut setup = self.setup;
        setup.put(&self.wrt, |i| values[i]);
        if setup.club.inertia() != self.setup.club.inertia() {
            setup.club.check_inertia()?;
        }
        self.with_accepted_step(setup, values, order.min(self.order), stop, &|_, _| ())
    }

    /// Outcomes at the setup's own values of the parameters. `progress` receives the number of
    /// completed evaluations of the drive and the number of all evaluations. Interrupted once
    /// `stop` is true.
    ///
    /// # Errors
    /// The errors of [`at_until`](Self::at_until).
    pub fn at_setup(
        &self,
        stop: Option<&AtomicBool>,
        progress: &dyn Fn(usize, usize),
    ) -> Result<Vec<Taylor>> {
        let values: Vec<f64> = self
            .wrt
            .iter()
            .map(|row| self.setup.value(row).unwrap_or(f64::NAN))
            .collect();
        self.with_accepted_step(self.setup, &values, self.order, stop, progress)
    }

    /// Evaluates without checking the values of the parameters. The step is halved until the defect
    /// of the integration is accepted.
    fn with_accepted_step(
        &self,
        mut setup: Setup<f64>,
        x: &[f64],
        order: Order,
        stop: Option<&AtomicBool>,
        progress: &dyn Fn(usize, usize),
    ) -> Result<Vec<Taylor>> {
        let is_second = order == Order::Second;
        let is_chained = order > Order::Value
            && self.entries == Entries::All
            && self.split.is_cheaper(x.len(), is_second, self.level);
        let taylors = with_accepted_step(&mut setup, self.largest_defect, |setup| {
            let point = EvaluationPoint {
                setup,
                of: &self.of,
                wrt: &self.wrt,
                x,
                columns: if order == Order::Value { 0 } else { x.len() },
                entries: is_second.then_some(self.entries),
                largest_defect: self.largest_defect,
                stop,
                level: self.level,
            };
            chain::derivatives(&point, is_chained.then_some(&self.split), progress)
        })?;
        for (outcome, taylor) in self.of.iter().zip(&taylors) {
            check(taylor, *outcome, &self.wrt)?;
        }
        Ok(taylors)
    }
}

/// Returns an error for a value or derivative that is not finite.
fn check(taylor: &Taylor, outcome: Outcome, wrt: &[&'static Parameter]) -> Result<()> {
    let undefined = |what: String, reason: &str| {
        Err(Error::Undefined {
            what,
            reason: reason.into(),
        })
    };
    if !taylor.value.is_finite() {
        return undefined(outcome.name().into(), outcome.why_undefined());
    }
    let edge = "this outcome is not smooth at this drive; examples are a vertical launch, a launch \
                without spin, and a landing at the apex";
    for (i, parameter) in wrt.iter().enumerate() {
        if taylor.gradient.get(i).is_some_and(|d| !d.is_finite()) {
            return undefined(format!("d {}/d {}", outcome.name(), parameter.name), edge);
        }
        let row = taylor.hessian.get(i);
        if let Some(k) = row.and_then(|row| row.iter().position(|d| !d.is_finite())) {
            let what = format!(
                "the second derivative of {} by {} and {}",
                outcome.name(),
                parameter.name,
                wrt[k].name
            );
            return undefined(what, edge);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Taylor, check};
    use crate::drive::Outcome;
    use crate::parameters::Setup;

    #[test]
    fn an_undefined_second_derivative_names_both_parameters() {
        let setup = Setup::modern_driver();
        let wrt = ["swing.speed", "club.loft"].map(|name| setup.variable(name).unwrap());
        let taylor = Taylor {
            value: 200.0,
            gradient: vec![1.0; 2],
            hessian: vec![vec![1.0, f64::NAN], vec![f64::NAN, 1.0]],
        };
        let error = check(&taylor, Outcome::Carry, &wrt)
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with("the second derivative of carry by swing.speed and club.loft is not"),
            "{error}"
        );
    }
}
