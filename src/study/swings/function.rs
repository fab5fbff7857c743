use super::scenarios::Scenarios;
use crate::derivative::{Order, Taylor};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::integration::{Integration, StepChoice, neighbourhood, of_the_flight};
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::problem::SearchProblem;
use crate::study::{Goal, Search, Sense};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A goal over swings as a function of some design parameters, with derivatives up to second order.
/// It can be the objective of any optimizer. Measures with a kink or jump (`lowest`, `highest`,
/// `within`) are smoothed. The drives use the setup's integration method and time step; to choose
/// them for a tolerance, see [`StepChoice::for_swings`].
///
/// ```
/// use longdrive::Setup;
/// use longdrive::derivative::Order;
/// use longdrive::study::Goal;
/// use longdrive::study::swings::{GoalFunction, Rule, Scenarios, Swings};
/// use longdrive::study::uncertainty::Uncertain;
///
/// let setup = Setup::preset("mae494").unwrap();
/// let attack = Uncertain::read(&setup, "swing.attack_angle=uniform(0deg, 10deg)").unwrap();
/// let swings = Swings::distributed(vec![attack], &[]).unwrap();
/// let goal = Goal::read("mean(carry)", None).unwrap();
/// let rule = Rule::of(&swings, [&goal], None, 0).unwrap();
/// let scenarios = Scenarios::new(&swings, rule).unwrap();
/// let loft = setup.variable("club.loft").unwrap();
/// let mean = GoalFunction::new(&setup, &goal, &[loft], scenarios).unwrap();
/// let at_ten_degrees = mean.at(&[10.0_f64.to_radians()], Order::First).unwrap();
/// assert!(at_ten_degrees.gradient[0] > 0.0); // a higher loft is better for these swings
/// ```
pub struct GoalFunction {
    problem: SearchProblem,
}

impl StepChoice {
    /// Selects integration method and time step for a goal over swings as a function of the
    /// parameters `wrt`. Unlike in [`for_function`](Self::for_function), the trial drives also
    /// cover the ranges of the swings. Interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`for_function`](Self::for_function); [`Error::Stopped`] after an interrupt.
    pub fn for_swings(
        self,
        setup: &Setup<f64>,
        wrt: &[&'static Parameter],
        scenarios: &Scenarios,
        stop: &AtomicBool,
    ) -> Result<Integration> {
        let mut ranges = scenarios.ranges();
        ranges.extend(neighbourhood(setup, wrt));
        self.for_ranges(setup, &ranges, &of_the_flight(), stop)
    }
}

impl Integration {
    /// A goal over swings as a function of the parameters `wrt`, with this method and time step. A
    /// drive whose defect exceeds [`largest_defect`](Self::largest_defect) is repeated with shorter
    /// steps.
    ///
    /// # Errors
    /// The errors of [`GoalFunction::new`].
    pub fn goal_function(
        &self,
        goal: &Goal,
        wrt: &[&'static Parameter],
        scenarios: Scenarios,
    ) -> Result<GoalFunction> {
        let GoalFunction { problem } = GoalFunction::new(&self.setup, goal, wrt, scenarios)?;
        let problem = problem.with_largest_defect(self.largest_defect);
        Ok(GoalFunction { problem })
    }
}

impl GoalFunction {
    /// The goal as a function of the parameters `wrt`.
    ///
    /// # Errors
    /// [`Error::Nothing`] without a parameter; [`Error::Unreadable`] for a parameter that is in
    /// both `wrt` and the swings; the errors of [`Setup::validate`].
    pub fn new(
        setup: &Setup<f64>,
        goal: &Goal,
        wrt: &[&'static Parameter],
        scenarios: Scenarios,
    ) -> Result<Self> {
        if wrt.is_empty() {
            return Err(Error::Nothing {
                doing: "differentiate by",
                what: "parameter",
            });
        }
        let whole = |parameter: &&'static Parameter| Vary {
            parameter,
            low: parameter.range.low,
            high: parameter.range.high,
        };
        let search = Search {
            of: goal.clone(),
            sense: Sense::Minimize,
            vary: wrt.iter().map(whole).collect(),
            scenarios,
            ..Search::largest(Outcome::Carry)
        };
        let problem = SearchProblem::of_goals(setup, search, &Arc::default())?;
        Ok(Self { problem })
    }

    /// The parameters of the function, in the order of its arguments and derivatives.
    pub fn parameters(&self) -> &[&'static Parameter] {
        &self.problem.parameters
    }

    /// The goal at these values of the parameters, SI, with derivatives up to `order`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a value outside the allowed range; [`Error::NoFlight`], which
    /// names the first swing in which the ball does not fly.
    ///
    /// # Panics
    /// If the numbers of values and parameters differ.
    pub fn at(&self, x: &[f64], order: Order) -> Result<Taylor> {
        self.at_until(x, order, &AtomicBool::new(false))
    }

    /// Like [`at`](Self::at); interrupted once `stop` is true.
    ///
    /// # Errors
    /// The errors of [`at`](Self::at); [`Error::NotConverged`], with the status `interrupted`,
    /// after an interrupt.
    ///
    /// # Panics
    /// If the numbers of values and parameters differ.
    pub fn at_until(&self, x: &[f64], order: Order, stop: &AtomicBool) -> Result<Taylor> {
        assert_eq!(
            x.len(),
            self.parameters().len(),
            "a value for each parameter"
        );
        for (parameter, value) in self.parameters().iter().zip(x) {
            parameter.check(*value)?;
        }
        let goals = self.problem.goals_until(x, order, stop)?;
        goals.into_iter().next().ok_or(Error::Nothing {
            doing: "look for",
            what: "goal",
        })
    }
}
