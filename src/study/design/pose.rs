//! The search for a design with all that holds it.

use super::held::{By, Held, Standing};
use super::rules::{Limited, RULES, Rule};
use crate::drive::{Outcome, is_outside_any_face};
use crate::error::{Error, Result};
use crate::impact::Head;
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::swings::Scenarios;
use crate::study::swings::flown::moved;
use crate::study::{Constraint, Optimum, Search};
use crate::units::{Amount, Quantity, counted};

/// What is varied where nothing is asked for: the face.
const USUAL: [&str; 3] = [
    "club.bulge_radius=150mm..1000mm",
    "club.roll_radius=150mm..1000mm",
    "club.loft=6deg..16deg",
];

/// Bulge, roll and loft with usual ranges.
///
/// # Errors
/// As [`Vary::read`], for a face that is flat or a launch that is given.
pub fn usual_vary(setup: &Setup<f64>) -> Result<Vec<Vary>> {
    USUAL.iter().map(|text| Vary::read(setup, text)).collect()
}

/// What the swings, or the ends of their distributions, come to.
const REACHED: &str = "the swings reach";

/// A search for a design, and what holds it.
#[derive(Clone, Debug)]
pub struct Design {
    /// The search with the bounds and limits of the rules.
    pub search: Search,
    /// All that holds the design: rules, conditions, and the limits that were asked for.
    pub held: Vec<Held>,
    /// Whether the Rules of Golf hold it.
    pub is_under_rules: bool,
    /// What was changed or assumed, in sentences.
    pub notes: Vec<String>,
}

impl Design {
    /// A search with all that holds its design: the Rules of Golf, unless they are left out; of a
    /// head whose inertia is varied that it is a rigid body's; and of a head whose mass is varied a
    /// budget, the mass as set up, where no limit of the search is about the mass.
    ///
    /// # Errors
    /// [`Error::Rule`] for a setup or a range that breaks a rule; [`Error::Unreadable`] for strikes
    /// that no face reaches.
    pub fn new(setup: &Setup<f64>, search: Search, is_under_rules: bool) -> Result<Self> {
        let scenarios = &search.scenarios.clone();
        check_strikes(setup, scenarios, &search.vary)?;
        let mut design = Self {
            search,
            held: vec![],
            is_under_rules,
            notes: vec![],
        };
        let asked = design.search.subject_to.len();
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
                design.limit("a rigid body", expression, of, [0.0, f64::INFINITY], None);
            }
        }
        design.budget(setup);
        let is_said = |held: &Held, k: usize| held.by == By::Limit(k);
        for k in 0..asked {
            if !design.held.iter().any(|held| is_said(held, k)) {
                let limit = &design.search.subject_to[k];
                let (name, goal) = (limit.goal.expression.clone(), &limit.goal);
                let step = goal.quantity.size_of(goal.unit).unwrap_or(1.0);
                let (expression, range) = (limit.expression.clone(), [limit.low, limit.high]);
                let (quantity, unit) = (goal.quantity, goal.unit);
                design.held.push(Held {
                    name,
                    expression,
                    rule: None,
                    by: By::Limit(k),
                    range,
                    quantity,
                    unit,
                    step,
                });
            }
        }
        Ok(design)
    }

    /// How the best design stands to all that holds it.
    pub fn standings(&self, best: &Optimum) -> Vec<Standing> {
        self.held.iter().map(|held| held.at(best)).collect()
    }

    fn varies(&self, is_so: impl Fn(&Parameter) -> bool) -> bool {
        self.search
            .vary
            .iter()
            .any(|vary| vary.low < vary.high && is_so(vary.parameter))
    }

    fn add(
        &mut self,
        setup: &Setup<f64>,
        scenarios: &Scenarios,
        rule: &'static Rule,
    ) -> Result<()> {
        let bound = rule.bound();
        let range = if rule.is_greatest {
            [f64::NEG_INFINITY, bound]
        } else {
            [bound, f64::INFINITY]
        };
        let unit = rule.limit.split_once(' ').map_or("", |(_, unit)| unit);
        let step = rule.quantity().read(rule.step).unwrap_or(1.0);
        let by = match rule.of {
            Limited::Parameter(name) => {
                self.of_parameter(setup, scenarios, rule, setup.parameter(name)?)?
            }
            Limited::Outcome(of) => {
                let begun = Vary::begun(setup, &self.search.vary)?;
                let moves = |row: &Parameter| changes_the_head(&begun, row);
                let places: Vec<_> = (0..scenarios.parameters.len())
                    .filter(|k| moves(scenarios.parameters[*k]))
                    .collect();
                let swung = places.first().map(|k| scenarios.parameters[*k]);
                match (self.varies(moves), swung) {
                    (true, Some(swung)) => {
                        let source = format!(
                            "the swings have values of it, and what is varied changes {} too: the \
                             rule on the {} could be kept on average \
                             only; leave it out of the swings, or leave the rules out with `rules \
                             none`",
                            of.name(),
                            rule.name
                        );
                        return Err(Error::Unreadable {
                            name: swung.name.into(),
                            source: source.into(),
                        });
                    }
                    (true, None) => {
                        self.limit(rule.name, rule.expression(), of, range, Some(rule));
                        return Ok(());
                    }
                    (false, Some(_)) => {
                        let each = scenarios.and_ends(&places).map(|point| {
                            Ok(
                                Head::new(&moved(setup, &scenarios.parameters, &point)?.club)
                                    .inertia[0][0],
                            )
                        });
                        let each = each.collect::<Result<Vec<f64>>>()?;
                        let worst = each.into_iter().reduce(f64::max).unwrap_or(bound);
                        self.note_endless(scenarios, rule, &places);
                        By::Value(checked(
                            rule,
                            worst,
                            REACHED,
                            "give the distribution ends within it",
                        )?)
                    }
                    (false, None) => {
                        let value = Head::new(&setup.club).inertia[0][0];
                        By::Value(checked(rule, value, "the setup has", "change the setup")?)
                    }
                }
            }
            Limited::Relation(name, _) => {
                let stated = self
                    .search
                    .subject_to
                    .iter()
                    .position(|limit| limit.goal.expression == name);
                if let Some(k) = stated {
                    let limit = &self.search.subject_to[k];
                    let [low, high] = [limit.low, limit.high];
                    let value = if rule.is_greatest { high } else { low };
                    let refuse = |why: String| {
                        let (expression, column) = (limit.expression.clone(), 0);
                        Err(Error::Constraint {
                            expression,
                            column,
                            reason: why,
                        })
                    };
                    if limit.goal.quantity != rule.quantity() {
                        return refuse(format!(
                            "a relation named '{name}' is held to the rule on the {}, which is \
                             about {}, and this is {}; check the units, or give \
                             it another name",
                            rule.name,
                            rule.quantity().name,
                            limit.goal.quantity.name
                        ));
                    }
                    if value.is_infinite() {
                        return refuse(format!(
                            "its {} limit is missing: a relation named '{name}' is held to the \
                             rule, {}; write such a limit, or give it another \
                             name",
                            if rule.is_greatest { "upper" } else { "lower" },
                            rule.expression()
                        ));
                    }
                    let advice = format!("lower the limit of the relation '{name}'");
                    checked(rule, value, "the relation allows", &advice)?;
                    let expression = limit.expression.clone();
                    let (name, quantity, by) = (rule.name.into(), rule.quantity(), By::Limit(k));
                    let held = Held {
                        name,
                        expression,
                        rule: Some(rule),
                        by,
                        range: [low, high],
                        quantity,
                        unit,
                        step,
                    };
                    self.held.push(held);
                    return Ok(());
                }
                By::Unknown
            }
        };
        let (name, expression, quantity) = (rule.name.into(), rule.expression(), rule.quantity());
        self.held.push(Held {
            name,
            expression,
            rule: Some(rule),
            by,
            range,
            quantity,
            unit,
            step,
        });
        Ok(())
    }

    /// A rule about a parameter: a bound of it where it is varied; else the setup, or the swings,
    /// must keep it.
    fn of_parameter(
        &mut self,
        setup: &Setup<f64>,
        scenarios: &Scenarios,
        rule: &'static Rule,
        parameter: &'static Parameter,
    ) -> Result<By> {
        let bound = rule.bound();
        if let Some(i) = self
            .search
            .vary
            .iter()
            .position(|vary| vary.parameter == parameter)
        {
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
                *end = bound;
                self.notes.push(format!(
                    "{} is varied up to the rule on the {}: {} (your range ends at {})",
                    parameter.name,
                    rule.name,
                    rule.show(bound),
                    rule.show(worst)
                ));
            }
            return Ok(By::Bound(i));
        }
        if let Some(k) = scenarios
            .parameters
            .iter()
            .position(|swung| *swung == parameter)
        {
            let values = scenarios.and_ends(&[k]).map(|point| point[k]);
            let worst = values
                .reduce(if rule.is_greatest { f64::max } else { f64::min })
                .unwrap_or(bound);
            self.note_endless(scenarios, rule, &[k]);
            return Ok(By::Value(checked(
                rule,
                worst,
                REACHED,
                "give the distribution ends within it",
            )?));
        }
        let value = setup.value(parameter).unwrap_or_default();
        let advice = format!(
            "set it, for example `set {}=\"{}\"`{}",
            parameter.name,
            rule.show(bound),
            rule.hint
        );
        Ok(By::Value(checked(rule, value, "the setup has", &advice)?))
    }

    /// Says of which swung parameters a rule was checked at the swings alone, since their
    /// distributions have no ends.
    fn note_endless(&mut self, scenarios: &Scenarios, rule: &Rule, places: &[usize]) {
        let names = places
            .iter()
            .filter(|k| scenarios.is_endless(**k))
            .map(|k| scenarios.parameters[*k].name);
        let names: Vec<_> = names.collect();
        if !names.is_empty() {
            let count = counted(scenarios.points.len() as u64, "swing");
            self.notes.push(format!(
                "the rule on the {} is checked at {count} only, since the distribution of {} has \
                 no ends; give it ends with \
                 truncated(MEAN,DEVIATION,LOW,HIGH)",
                rule.name,
                names.join(" and ")
            ));
        }
    }

    /// Adds a limit of an outcome of the head.
    fn limit(
        &mut self,
        name: &str,
        expression: String,
        of: Outcome,
        [low, high]: [f64; 2],
        rule: Option<&'static Rule>,
    ) {
        let by = By::Limit(self.search.subject_to.len());
        self.search.subject_to.push(Constraint {
            expression: expression.clone(),
            goal: of.into(),
            low,
            high,
        });
        let (quantity, unit) = (of.quantity(), of.unit());
        let step = rule.map_or(unit, |rule| rule.step);
        let step = Amount::read(step).map_or_else(
            |_| quantity.size_of(unit).unwrap_or(1.0),
            |amount| amount.value,
        );
        self.held.push(Held {
            name: name.into(),
            expression,
            rule,
            by,
            range: [low, high],
            quantity,
            unit,
            step,
        });
    }

    /// Of a head whose mass is varied, no more mass than it has, unless a limit says how much it
    /// may have.
    fn budget(&mut self, setup: &Setup<f64>) {
        let is_mass =
            |row: &Parameter| row.name.starts_with("club.") && row.quantity == Quantity::MASS;
        let is_about_it = |limit: &Constraint| limit.goal.quantity == Quantity::MASS;
        if !self.varies(is_mass) || self.search.subject_to.iter().any(is_about_it) {
            return;
        }
        let most = Head::new(&setup.club).mass;
        let shown = Quantity::MASS.show(most, "g");
        self.notes.push(format!(
            "the head may have as much mass as the one that is set up, \
                                 {shown}; say how much with `subject_to \"head_mass <= 205 g\"`"
        ));
        self.limit(
            "mass budget",
            format!("head_mass <= {shown}"),
            Outcome::HeadMass,
            [f64::NEG_INFINITY, most],
            None,
        );
    }
}

/// A value that a rule allows.
fn checked(rule: &Rule, value: f64, found: &str, advice: &str) -> Result<f64> {
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

/// Whether a parameter moves mass in the head, or turns the weights on it.
fn changes_the_head(setup: &Setup<f64>, row: &Parameter) -> bool {
    let has_weights = setup.club.weights().iter().any(Option::is_some);
    let moves_weights = ["club.mass", "club.cg_", "club.weight_", "club.loft"];
    row.is_of_inertia()
        || has_weights && moves_weights.iter().any(|part| row.name.starts_with(part))
}

/// Strikes that no face reaches, or that the faces that are varied do not.
fn check_strikes(setup: &Setup<f64>, scenarios: &Scenarios, vary: &[Vary]) -> Result<()> {
    let of = |name: &str, point: &[f64]| -> Result<f64> {
        let parameter = setup.parameter(name)?;
        let swung = scenarios
            .parameters
            .iter()
            .position(|swung| *swung == parameter);
        Ok(swung.map_or_else(|| setup.value(parameter).unwrap_or_default(), |k| point[k]))
    };
    // the widest face of the ranges
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
            let advice = "give the strikes ends with truncated(MEAN,DEVIATION,LOW,HIGH), or leave \
                          such swings out";
            Err(Error::Unreadable {
                name: "the strikes".into(),
                source: format!("{strike}, {why}; {advice}").into(),
            })
        };
        if is_outside_any_face(toe, high) {
            return refuse(format!("beside {}", crate::drive::any_face()));
        }
        let club = &widest.club;
        let (bulge, roll) = (club.bulge_radius, club.roll_radius);
        let third = club.face_semi_axis.unwrap_or((bulge * roll).sqrt());
        if (high * high / roll + toe * toe / bulge) / third >= 1.0 {
            let (bulge, roll) = (mm(bulge), mm(roll));
            return refuse(format!(
                "where a face with a bulge of {bulge} and a roll of {roll} ends"
            ));
        }
    }
    Ok(())
}
