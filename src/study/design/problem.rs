//! Builds the optimization problem of a design.

use super::constraints::{ConstraintState, DesignConstraint, Enforcement};
use super::rules::{GolfRule, LimitedQuantity, RULES};
use crate::derivative::{Order, evaluate};
use crate::drive::{Outcome, is_outside_any_face};
use crate::error::{Error, Result};
use crate::impact::{FacePoint, Head};
use crate::parameters::{Parameter, ParameterGroup, Setup, Strike, Vary};
use crate::study::swings::Scenarios;
use crate::study::{Constraint, Optimum, Search};
use crate::units::{DisplayUnit, Quantity, counted};

/// Default variables: the face.
const DEFAULTS: [&str; 3] = [
    "club.bulge_radius=150mm..1000mm",
    "club.roll_radius=150mm..1000mm",
    "club.loft=6deg..16deg",
];

/// Bulge, roll and loft with default ranges.
///
/// # Errors
/// The errors of [`Vary::read`], for a flat face or a given launch.
pub fn default_vary(setup: &Setup<f64>) -> Result<Vec<Vary>> {
    Vary::read_all(setup, DEFAULTS)
}

const REACHED: &str = "the swings reach";

/// An optimization problem with the constraints of a design.
#[derive(Clone, Debug)]
pub struct Design {
    /// The search, with the bounds and constraints that the Rules of Golf add.
    pub search: Search,
    /// All constraints: rules, conditions, and the user's limits.
    pub constraints: Vec<DesignConstraint>,
    /// True if the Rules of Golf apply.
    pub is_under_rules: bool,
    /// Notes on changed bounds and assumptions.
    pub notes: Vec<String>,
}

impl Design {
    /// Adds the constraints of a design. These are the Rules of Golf if `is_under_rules`, and the
    /// conditions of a rigid body if the inertia varies. If the mass of the head varies and the
    /// user limits no mass, the setup's mass is the upper limit.
    ///
    /// # Errors
    /// [`Error::Rule`] for a setup or a range that breaks a rule; [`Error::Unreadable`] for strikes
    /// off the face.
    pub fn new(setup: &Setup<f64>, search: Search, is_under_rules: bool) -> Result<Self> {
        let scenarios = &search.scenarios.clone();
        check_strikes(setup, scenarios, &search.vary)?;
        let mut design = Self {
            search,
            constraints: vec![],
            is_under_rules,
            notes: vec![],
        };
        let requested = design.search.subject_to.len();
        if is_under_rules {
            for rule in &RULES {
                design.add(setup, scenarios, rule)?;
            }
        }
        if design.varies(Parameter::is_of_inertia) {
            for of in [
                Outcome::HeadMinor1,
                Outcome::HeadMinor2,
                Outcome::HeadMinor3,
            ] {
                let expression = format!("{} >= 0 g cm^2", of.name());
                let k = design.limit(expression, of, [0.0, f64::INFINITY]);
                design.list_limit("a rigid body", k);
            }
        }
        design.budget(setup);
        let is_listed = |constraint: &DesignConstraint, k: usize| {
            constraint.enforcement == Enforcement::Limit(k)
        };
        for k in 0..requested {
            let mut listed = design.constraints.iter();
            if !listed.any(|constraint| is_listed(constraint, k)) {
                let name = design.search.subject_to[k].goal.expression.clone();
                design.list_limit(&name, k);
            }
        }
        Ok(design)
    }

    /// State of all constraints at the best design.
    pub fn constraint_states(&self, best: &Optimum) -> Vec<ConstraintState> {
        self.constraints
            .iter()
            .map(|constraint| constraint.at(best))
            .collect()
    }

    fn varies(&self, is_so: impl Fn(&Parameter) -> bool) -> bool {
        self.search
            .vary
            .iter()
            .any(|vary| vary.low < vary.high && is_so(vary.parameter))
    }

    /// Adds the constraint of a rule. If the design can break the rule, the search enforces it.
    fn add(
        &mut self,
        setup: &Setup<f64>,
        scenarios: &Scenarios,
        rule: &'static GolfRule,
    ) -> Result<()> {
        let by = match rule.of {
            LimitedQuantity::Parameter(name) => {
                self.of_parameter(setup, scenarios, rule, setup.parameter(name)?)?
            }
            LimitedQuantity::Outcome(of) => match self.of_head(setup, scenarios, rule, of)? {
                Some(by) => by,
                None => Enforcement::Limit(self.limit(rule.expression(), of, rule.range())),
            },
            LimitedQuantity::Relation(name, _) => {
                let stated = self
                    .search
                    .subject_to
                    .iter()
                    .position(|limit| limit.goal.expression == name);
                match stated {
                    Some(k) => return self.of_relation(rule, name, k),
                    None => Enforcement::Unknown,
                }
            }
        };
        self.push(rule, rule.expression(), rule.range(), by);
        Ok(())
    }

    /// Appends the constraint of a rule to the list.
    fn push(
        &mut self,
        rule: &'static GolfRule,
        expression: String,
        range: [f64; 2],
        enforcement: Enforcement,
    ) {
        self.constraints.push(DesignConstraint {
            name: rule.name.into(),
            expression,
            rule: Some(rule),
            enforcement,
            range,
            unit: rule.unit(),
            reported_change: rule.quantity().read(rule.reported_change).unwrap_or(1.0),
        });
    }

    /// Checks a rule on an outcome of the head. If the swings change the head, all swings are
    /// checked, otherwise the setup is checked. `None` if the varied parameters change the head:
    /// nothing is checked, and the rule becomes a constraint of the search.
    ///
    /// # Errors
    /// [`Error::Rule`] for a broken rule; [`Error::Unreadable`] if both swings and varied
    /// parameters change the head.
    fn of_head(
        &mut self,
        setup: &Setup<f64>,
        scenarios: &Scenarios,
        rule: &'static GolfRule,
        of: Outcome,
    ) -> Result<Option<Enforcement>> {
        let begun = Vary::initialized(setup, &self.search.vary)?;
        let has_weights = begun.club.weights().iter().any(Option::is_some);
        let moves_weights = ["club.mass", "club.cg_", "club.weight_", "club.loft"];
        // a change of the mass distribution of the head, or of the orientation of its weights
        let changes_the_head = |row: &Parameter| {
            row.is_of_inertia()
                || has_weights && moves_weights.iter().any(|part| row.name.starts_with(part))
        };
        let places: Vec<_> = (0..scenarios.parameters.len())
            .filter(|k| changes_the_head(scenarios.parameters[*k]))
            .collect();
        let swung = places.first().map(|k| scenarios.parameters[*k]);
        let value = |setup: &Setup<f64>| -> Result<f64> {
            Ok(evaluate(setup, &[of], &[], Order::Value)?[0].value)
        };
        match (self.varies(changes_the_head), swung) {
            (true, Some(swung)) => {
                let source = format!(
                    "the swings have values of it, and a varied parameter changes {} too: the \
                     search could meet the rule on the {} only on average over the swings; remove \
                     this parameter from the swings, or leave the rules out with `rules none`",
                    of.name(),
                    rule.name
                );
                Err(Error::unreadable(swung.name, source))
            }
            (true, None) => Ok(None),
            (false, Some(_)) => {
                let each = scenarios
                    .with_bounds(&places)
                    .map(|point| value(&setup.with_values(&scenarios.parameters, &point)?))
                    .collect::<Result<Vec<f64>>>()?;
                let worst = rule.worst(each).unwrap_or(rule.bound());
                self.note_endless(scenarios, rule, &places);
                let advice = "limit the distribution to values that the rule allows";
                let value = checked(rule, worst, REACHED, advice)?;
                Ok(Some(Enforcement::Value(value)))
            }
            (false, None) => {
                let value = checked(rule, value(setup)?, "the setup has", "change the setup")?;
                Ok(Some(Enforcement::Value(value)))
            }
        }
    }

    /// Enforces a rule by the user's relation with index `k`. The limits of the relation must
    /// conform to the rule.
    fn of_relation(&mut self, rule: &'static GolfRule, name: &str, k: usize) -> Result<()> {
        let limit = &self.search.subject_to[k];
        let [low, high] = [limit.low, limit.high];
        let refuse = |reason: String| {
            Err(Error::Constraint {
                expression: limit.expression.clone(),
                column: 0,
                reason,
            })
        };
        if limit.goal.quantity != rule.quantity() {
            return refuse(format!(
                "a relation named '{name}' must meet the rule on the {}, which limits {}, but this \
                 is {}; check the units, or give it another name",
                rule.name,
                rule.quantity().name,
                limit.goal.quantity.name
            ));
        }
        let value = if rule.is_greatest { high } else { low };
        if value.is_infinite() {
            return refuse(format!(
                "its {} limit is missing: a relation named '{name}' must meet the rule, {}; write \
                 such a limit, or give it another name",
                if rule.is_greatest { "upper" } else { "lower" },
                rule.expression()
            ));
        }
        let advice = format!("lower the limit of the relation '{name}'");
        checked(rule, value, "the relation allows", &advice)?;
        let expression = limit.expression.clone();
        self.push(rule, expression, [low, high], Enforcement::Limit(k));
        Ok(())
    }

    /// Enforces a rule on a parameter: by a bound if the parameter varies, otherwise by a check of
    /// the setup or the swings.
    fn of_parameter(
        &mut self,
        setup: &Setup<f64>,
        scenarios: &Scenarios,
        rule: &'static GolfRule,
        parameter: &'static Parameter,
    ) -> Result<Enforcement> {
        let bound = rule.bound();
        if let Some(i) = self
            .search
            .vary
            .iter()
            .position(|vary| vary.parameter == parameter)
        {
            self.bound(rule, i)?;
            return Ok(Enforcement::Bound(i));
        }
        if let Some(k) = scenarios
            .parameters
            .iter()
            .position(|swung| *swung == parameter)
        {
            let values = scenarios.with_bounds(&[k]).map(|point| point[k]);
            let worst = rule.worst(values).unwrap_or(bound);
            self.note_endless(scenarios, rule, &[k]);
            return Ok(Enforcement::Value(checked(
                rule,
                worst,
                REACHED,
                "limit the distribution to values that the rule allows",
            )?));
        }
        let value = setup.value(parameter).unwrap_or_default();
        let advice = format!(
            "set it, for example `set {}=\"{}\"`{}",
            parameter.name,
            rule.show(bound),
            rule.hint
        );
        Ok(Enforcement::Value(checked(
            rule,
            value,
            "the setup has",
            &advice,
        )?))
    }

    /// Limits the range of the varied parameter `i` according to a rule.
    fn bound(&mut self, rule: &GolfRule, i: usize) -> Result<()> {
        let vary = &mut self.search.vary[i];
        let [best, worst] = if rule.is_greatest {
            [vary.low, vary.high]
        } else {
            [vary.high, vary.low]
        };
        let reach = if rule.is_greatest {
            "the range begins at"
        } else {
            "the range ends at"
        };
        checked(rule, best, reach, "vary it within the rule")?;
        if !rule.allows(worst) {
            let end = if rule.is_greatest {
                &mut vary.high
            } else {
                &mut vary.low
            };
            *end = rule.bound();
            self.notes.push(format!(
                "the range of {} stops at the limit of the rule on the {}: {} (yours reaches {})",
                vary.parameter.name,
                rule.name,
                rule.show(rule.bound()),
                rule.show(worst)
            ));
        }
        Ok(())
    }

    /// Adds a note if the distributions of some parameters are unbounded: the rule is then checked
    /// at the sampled swings only.
    fn note_endless(&mut self, scenarios: &Scenarios, rule: &GolfRule, places: &[usize]) {
        let names = places
            .iter()
            .filter(|k| scenarios.is_unbounded(**k))
            .map(|k| scenarios.parameters[*k].name);
        let names: Vec<_> = names.collect();
        if !names.is_empty() {
            let count = counted(scenarios.points.len() as u64, "swing");
            self.notes.push(format!(
                "the rule on the {} is checked at {count} only, since the distribution of {} is \
                 unbounded; limit it with truncated(MEAN,DEVIATION,LOW,HIGH)",
                rule.name,
                names.join(" and ")
            ));
        }
    }

    /// Adds a constraint on an outcome of the head to the search, and returns its index.
    fn limit(&mut self, expression: String, of: Outcome, [low, high]: [f64; 2]) -> usize {
        self.search.subject_to.push(Constraint {
            expression,
            goal: of.into(),
            low,
            high,
        });
        self.search.subject_to.len() - 1
    }

    /// Appends constraint `k` of the search to the list of constraints, without a rule.
    fn list_limit(&mut self, name: &str, k: usize) {
        let limit = &self.search.subject_to[k];
        let unit = DisplayUnit::from(&limit.goal);
        self.constraints.push(DesignConstraint {
            name: name.into(),
            expression: limit.expression.clone(),
            rule: None,
            enforcement: Enforcement::Limit(k),
            range: [limit.low, limit.high],
            unit,
            reported_change: unit.size(),
        });
    }

    /// Limits the mass of the head to its initial value if the mass varies and the user limits no
    /// mass.
    fn budget(&mut self, setup: &Setup<f64>) {
        let is_mass =
            |row: &Parameter| row.group == ParameterGroup::Club && row.quantity == Quantity::MASS;
        let is_about_it = |limit: &Constraint| limit.goal.quantity == Quantity::MASS;
        if !self.varies(is_mass) || self.search.subject_to.iter().any(is_about_it) {
            return;
        }
        let most = Head::new(&setup.club).mass;
        let shown = Quantity::MASS.show(most, "g");
        self.notes.push(format!(
            "the mass of the head is limited to the setup's, {shown}; for another limit use \
             `subject_to \"head_mass <= 205 g\"`"
        ));
        let k = self.limit(
            format!("head_mass <= {shown}"),
            Outcome::HeadMass,
            [f64::NEG_INFINITY, most],
        );
        self.list_limit("mass budget", k);
    }
}

/// Returns the value if the rule allows it.
fn checked(rule: &GolfRule, value: f64, found: &str, advice: &str) -> Result<f64> {
    if rule.allows(value) {
        return Ok(value);
    }
    Err(Error::Rule {
        rule: format!("the {} ({})", rule.name, rule.source),
        found: format!("{found} {} = {}", rule.limited(), rule.show(value)),
        limit: rule.expression(),
        advice: advice.into(),
    })
}

/// Rejects strikes that lie outside the face of any conforming head, or outside the largest face
/// that the search can choose.
fn check_strikes(setup: &Setup<f64>, scenarios: &Scenarios, vary: &[Vary]) -> Result<()> {
    let of = |name: &str, point: &[f64]| -> Result<f64> {
        let parameter = setup.parameter(name)?;
        let swung = scenarios
            .parameters
            .iter()
            .position(|swung| *swung == parameter);
        Ok(swung.map_or_else(|| setup.value(parameter).unwrap_or_default(), |k| point[k]))
    };
    // the largest face within the ranges
    let mut widest = *setup;
    for vary in vary.iter().filter(|vary| {
        [
            "club.bulge_radius",
            "club.roll_radius",
            "club.face_semi_axis",
        ]
        .contains(&vary.parameter.name)
    }) {
        widest.set_value(vary.parameter, Some(vary.high))?;
    }
    let mm = |value: f64| Quantity::LENGTH.show(value, "mm");
    for point in &scenarios.points {
        let (toe, high) = (of("strike.toe", point)?, of("strike.high", point)?);
        let strike = format!(
            "a swing strikes at strike.toe = {} and strike.high = {}",
            mm(toe),
            mm(high)
        );
        let refuse = |why: String| {
            let advice = "limit the strikes with truncated(MEAN,DEVIATION,LOW,HIGH), or remove \
                          such swings";
            Err(Error::unreadable(
                "the strikes",
                format!("{strike}, {why}; {advice}"),
            ))
        };
        if is_outside_any_face(toe, high) {
            return refuse(format!("beside {}", crate::drive::any_face()));
        }
        let club = &widest.club;
        let (bulge, roll) = (club.bulge_radius, club.roll_radius);
        if FacePoint::new(club, &Strike { high, toe }).is_err() {
            let (bulge, roll) = (mm(bulge), mm(roll));
            return refuse(format!(
                "beyond the edge of a face with a bulge of {bulge} and a roll of {roll}"
            ));
        }
    }
    Ok(())
}
