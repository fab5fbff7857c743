use super::problem::SwingsProblem;
use super::read::{Goal, GoalLimit};
use super::scenarios::Scenarios;
use crate::error::{Error, Result};
use crate::optimize::{Follow, Options, Solution, Status, minimize_from};
use crate::parameters::{Setup, Vary};
use crate::study::Sense;

/// What to look for over many swings.
#[derive(Clone, Debug)]
pub struct SwingsSearch {
    /// The goal to make as large or as small as possible.
    pub of: Goal,
    /// Which of the two.
    pub sense: Sense,
    /// The parameters of the design to vary.
    pub vary: Vec<Vary>,
    /// Goals to hold between limits.
    pub subject_to: Vec<GoalLimit>,
    /// The optimizer's settings.
    pub options: Options,
}

/// The design that is best for all swings.
#[derive(Clone, Debug)]
pub struct SwingsOptimum {
    /// What was asked.
    pub search: SwingsSearch,
    /// The swings.
    pub scenarios: Scenarios,
    /// How the search ended; its objective is the goal times [`Sense::sign`].
    pub solution: Solution,
    /// The setup with the best design.
    pub setup: Setup<f64>,
    /// The goals over the swings with the setup's own design: the objective, then what is limited; `None` where a swing does not fly.
    pub as_set_up: Option<Vec<f64>>,
    /// The share of the swings whose ball ends at the optimum where the table of strokes does not reach, and is continued straight.
    pub beyond_strokes: Option<f64>,
}

impl SwingsOptimum {
    /// The goal at the optimum, SI.
    pub fn value(&self) -> Option<f64> {
        self.solution.value.map(|value| self.search.sense.sign() * value)
    }

    /// The goal's gradient at the optimum by what is varied, SI.
    pub fn gradient(&self) -> Vec<f64> {
        self.solution.gradient.iter().map(|slope| self.search.sense.sign() * slope).collect()
    }

    /// The goals at the optimum: the objective, then what is limited.
    pub fn goals(&self) -> Option<Vec<f64>> {
        let limited = self.solution.constraints.iter().map(|constraint| constraint.value);
        Some([self.value()?].into_iter().chain(limited).collect())
    }

    /// How the search ended, in a sentence.
    pub fn message(&self) -> String {
        match self.solution.status {
            Status::Undefined => {
                let why = self.solution.undefined_at_start.as_deref().unwrap_or("no drive flies");
                format!("no design was found with which every swing flies; at the start: {why}")
            }
            Status::Infeasible => {
                let missed = self.search.subject_to.iter().zip(&self.solution.constraints);
                let missed =
                    missed.filter(|(_, constrained)| constrained.violation != 0.0).map(|(limit, constrained)| {
                        format!(
                            "{} (it is {})",
                            limit.expression,
                            limit.goal.quantity.show(constrained.value, limit.goal.unit)
                        )
                    });
                let missed: Vec<_> = missed.collect();
                format!("the limits cannot all be met; the nearest design found violates {}", missed.join(" and "))
            }
            Status::Converged if self.is_flat() => {
                format!(
                    "{} does not depend on what is varied here: every design is equally good",
                    self.search.of.expression
                )
            }
            _ => self.solution.message.clone(),
        }
    }

    /// Whether the goal does not change within the ranges, to second order, by more than rounding.
    fn is_flat(&self) -> bool {
        const ROUNDING: f64 = 1e-10;
        let width = |i: usize| self.search.vary[i].high - self.search.vary[i].low;
        let n = self.search.vary.len();
        let slopes = self.solution.gradient.iter().enumerate().map(|(i, slope)| slope * width(i));
        let bends = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let bends = bends.filter_map(|(i, j)| Some(self.solution.hessian.get(i)?[j] * width(i) * width(j)));
        slopes.chain(bends).all(|change| change.abs() < ROUNDING)
    }

    /// The status in a word.
    pub fn status(&self) -> &'static str {
        match self.solution.status {
            Status::Undefined => "no-flight",
            status => status.name(),
        }
    }
}

/// Finds the design that makes a goal over many swings largest or smallest, from the setup's own values. The scenarios are the same for
/// every design, so that the goal is a smooth function of it, with exact gradients and Hessians.
///
/// ```
/// use longdrive::Setup;
/// use longdrive::optimize::{Follow, Options};
/// use longdrive::study::swings::{Goal, Rule, Scenarios, Swings, SwingsSearch, swings_optimum};
/// use longdrive::study::{Sense, Vary, uncertainty::Uncertain};
///
/// let setup = Setup::preset("mae494").unwrap();
/// let attack = Uncertain::read(&setup, "swing.attack_angle=uniform(0deg, 10deg)").unwrap();
/// let swings = Swings::distributed(vec![attack], &[]).unwrap();
/// let search = SwingsSearch {
///     of: Goal::read("mean(carry)", None).unwrap(),
///     sense: Sense::Maximize,
///     vary: vec![Vary::read(&setup, "club.loft=4deg..20deg").unwrap()],
///     subject_to: vec![],
///     options: Options::default(),
/// };
/// let scenarios = Scenarios::new(&swings, Rule::of(&swings, None, 0).unwrap()).unwrap();
/// let best = swings_optimum(&setup, search, scenarios, &Follow::default()).unwrap();
/// assert_eq!(best.status(), "converged");
/// ```
///
/// # Errors
/// [`Error::Nothing`] where nothing is varied; [`Error::SearchRange`] for a parameter that is varied twice, or that the swings have values
/// of; what [`Setup::validate`] refuses.
pub fn swings_optimum(
    setup: &Setup<f64>,
    search: SwingsSearch,
    scenarios: Scenarios,
    follow: &Follow,
) -> Result<SwingsOptimum> {
    let problem = posed(setup, &search, scenarios)?;
    let start = problem.domain.variables.project(&problem.start());
    let found = minimize_from(&problem, &problem.domain, &[start], &search.options, follow)?;
    let solution = found.into_iter().next().ok_or(Error::Nothing { doing: "search from", what: "start" })?.solution;
    let as_set_up = problem.values(&problem.start()).ok();
    let beyond_strokes = match solution.value {
        Some(_) => problem.beyond_strokes(&solution.x)?,
        None => None,
    };
    let setup = problem.moved(&solution.x)?;
    Ok(SwingsOptimum { search, scenarios: problem.scenarios().clone(), solution, setup, as_set_up, beyond_strokes })
}

/// The search as a problem, if it makes sense.
pub(super) fn posed(setup: &Setup<f64>, search: &SwingsSearch, scenarios: Scenarios) -> Result<SwingsProblem> {
    if search.vary.iter().all(|vary| vary.low == vary.high) {
        return Err(Error::Nothing { doing: "vary", what: "parameter" });
    }
    for (i, vary) in search.vary.iter().enumerate() {
        if search.vary[..i].iter().any(|before| before.parameter == vary.parameter) {
            let reason = "it is varied twice; give it one range".into();
            return Err(Error::SearchRange { name: vary.parameter.name.into(), reason });
        }
    }
    SwingsProblem::new(setup, (&search.of, search.sense), &search.subject_to, &search.vary, scenarios)
}
