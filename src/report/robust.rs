use super::document::{Document, DocumentTable, Line};
use super::json::{ByName, JsonNumber, Settings, settings};
use super::limits::{self, Objective, ended_at};
use super::optimum::{ConstraintReport, Multipliers};
use super::reply::{Ending, Report};
use super::setup_file::{CommentedSetup, about_constraint, remarks_on_varied};
use super::shown;
use super::swings::ScenariosReport;
use crate::optimize::Status;
use crate::parameters::SetupFile;
use crate::study::Sense;
use crate::study::swings::{ModelResult, Robust};
use crate::units::{System, counted, is_zero, leading_number};
use serde::Serialize;

const CHANGE: &str = "change of the greatest loss";

/// If the multiplier of a model's loss is above this number, the text says that this loss decides
/// the robust design.
const LEAST_SHARE: f64 = 1e-6;

/// A robust design for several models, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RobustReport<'a> {
    #[serde(skip)]
    found: &'a Robust,
    #[serde(skip)]
    allowed: Option<f64>,
    /// The objective.
    pub objective: String,
    /// `maximize` or `minimize`.
    #[cfg_attr(test, schemars(with = "Sense"))]
    pub sense: &'static str,
    /// The varied parameters of the robust design, SI.
    pub optimum: ByName<JsonNumber>,
    /// For each varied parameter, the multipliers of its two bounds: the decrease of the greatest
    /// loss for each SI unit by which a bound is relaxed. A multiplier is negative if relaxing the
    /// bound improves the best design of a model more than it improves the robust design.
    pub multipliers: ByName<Multipliers>,
    /// The greatest loss of any model, SI.
    pub greatest_loss: JsonNumber,
    /// The allowed loss, SI; `null` without one.
    pub within: JsonNumber,
    /// True if no model loses more than the allowed loss; `null` without an allowed loss.
    pub holds_for_all: Option<bool>,
    /// The models.
    pub models: Vec<ModelReport>,
    /// The swings; `null` for one drive.
    pub swings: Option<ScenariosReport>,
    /// The values of all parameters, with the robust design.
    pub setup: Settings,
    /// The setup file that was written; `null` without one.
    pub file: Option<String>,
}

/// A model with its own best design, and with the robust design.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ModelReport {
    /// The changes of the setup that define the model.
    pub model: String,
    /// The reason to include the model; `null` for a model of the user.
    pub reason: Option<&'static str>,
    /// The objective with the model's best design, SI.
    pub value: JsonNumber,
    /// The model's best design, SI.
    pub optimum: ByName<JsonNumber>,
    /// The loss of the robust design relative to the model's best design, SI.
    pub loss: JsonNumber,
    /// The multiplier of the model's loss, 0 to 1.
    pub share: JsonNumber,
    /// The losses of this model with the best design of each model, in the order of the models, SI;
    /// `null` if that design violates a constraint, or if the ball does not fly in one of the
    /// swings.
    pub losses: Vec<JsonNumber>,
    /// The model's loss with the setup before the search, SI; `null` if this setup violates a
    /// constraint, or if the ball does not fly in one of the swings.
    pub loss_as_set_up: JsonNumber,
    /// The model's constraints with the robust design.
    pub constraints: Vec<ConstraintReport>,
}

impl<'a> RobustReport<'a> {
    /// The report of a robust design; `within` is the allowed loss, SI.
    pub fn new(found: &'a Robust, within: Option<f64>) -> Self {
        let search = &found.search;
        let multipliers = |i: usize| {
            let [lower, upper] = found.bound_prices(i);
            (search.vary[i].parameter.name, Multipliers { lower, upper })
        };
        let swings = found
            .models
            .first()
            .filter(|of| !of.best.search.scenarios.is_one_drive());
        let models = found.models.iter().enumerate();
        Self {
            found,
            allowed: within,
            objective: search.of.expression.clone(),
            sense: search.sense.name(),
            optimum: ByName::of_varied(&search.vary, &found.design),
            multipliers: (0..search.vary.len()).map(multipliers).collect(),
            greatest_loss: found.greatest().into(),
            within: within.into(),
            holds_for_all: within.map(|within| found.greatest() <= within),
            models: models
                .map(|(k, of)| ModelReport::new(found, k, of))
                .collect(),
            swings: swings.map(|of| ScenariosReport::new(&of.best.search.scenarios)),
            setup: settings(&found.setup),
            file: None,
        }
    }
}

impl ModelReport {
    fn new(found: &Robust, k: usize, of: &ModelResult) -> Self {
        let ModelResult { model, best, .. } = of;
        Self {
            model: model.name.clone(),
            reason: Some(model.reason).filter(|reason| !reason.is_empty()),
            value: best.value().into(),
            optimum: ByName::of_varied(&found.search.vary, &best.solution.x),
            loss: of.loss.into(),
            share: of.multiplier.into(),
            losses: of
                .losses_of_bests
                .iter()
                .copied()
                .map(JsonNumber::from)
                .collect(),
            loss_as_set_up: of.loss_as_set_up.into(),
            constraints: found
                .constraints(k)
                .map(|limit| ConstraintReport::new(&limit))
                .collect(),
        }
    }
}

impl Report for RobustReport<'_> {
    const COMMAND: &'static str = "robust";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &Status::NAMES;

    fn ending(&self) -> Ending {
        Ending {
            status: self.found.status(),
            message: Some(verdict(self.found, self.allowed, System::default())),
        }
    }

    /// The robust design, the models, and the loss of each model with each design.
    fn document(&self, system: System) -> Document {
        let found = self.found;
        let mut document = Document::default();
        document.paragraph(format!(
            "{}: {} ({}, {} of {})",
            found.status(),
            verdict(found, self.allowed, system),
            counted(found.solution.iterations, "iteration"),
            counted(found.solution.effort.evaluations, "evaluation"),
            counted(found.models.len() as u64, "model")
        ));
        document.list(models(found, system));
        add_design(&mut document, found, system);
        document.add(designs(found, system));
        document.add(losses(found, system));
        document
    }
}

/// A sentence on the greatest loss of the robust design. With an allowed loss `within`, the
/// sentence first says whether each model loses at most this.
fn verdict(found: &Robust, within: Option<f64>, system: System) -> String {
    let goal = &found.search.of;
    let show = |value: f64| shown::goal_difference(goal, value, system);
    let least = format!(
        "the design loses at most {} of {} with any of the models, and no design with a smaller \
         greatest loss was found",
        show(found.greatest()),
        goal.expression
    );
    let stopped = found
        .interrupted()
        .map_or(String::new(), |stopped| format!("{stopped}; so far "));
    stopped
        + &match within {
            Some(within) if found.greatest() <= within => {
                format!(
                    "one design is within {} of the best for every model; {least}",
                    show(within)
                )
            }
            Some(within) => format!(
                "no design was found within {} of the best for every model; {least}",
                show(within)
            ),
            None => least,
        }
}

fn models(found: &Robust, system: System) -> Vec<Line> {
    let goal = &found.search.of;
    let mut lines = vec![Line::flush("models")];
    for (k, of) in found.models.iter().enumerate() {
        let model = &of.model;
        let value = shown::goal_or_dash(goal, of.best.value(), system);
        let decides = if of.multiplier > LEAST_SHARE {
            "; its loss decides the robust design"
        } else {
            ""
        };
        let reason = if model.reason.is_empty() {
            String::new()
        } else {
            format!(" ({})", model.reason)
        };
        lines.push(Line::item(format!(
            "{}: {}{reason}: {} at best {value}{decides}",
            k + 1,
            model.name,
            goal.expression
        )));
    }
    lines
}

/// The column heads for the best designs of the models.
fn heads_of_bests(found: &Robust) -> impl Iterator<Item = String> {
    (1..=found.models.len()).map(|k| format!("best for {k}"))
}

fn designs(found: &Robust, system: System) -> DocumentTable {
    let head = std::iter::once("vary".to_owned()).chain(heads_of_bests(found));
    let rows = found.search.vary.iter().enumerate().map(|(i, vary)| {
        let bests = found.models.iter();
        let bests = bests.map(|of| shown::within(vary, of.best.solution.x[i], system));
        std::iter::once(vary.parameter.name.into())
            .chain(bests)
            .collect()
    });
    DocumentTable::new(head, rows).right(1..=found.models.len())
}

/// The loss of each model (rows) with each design (columns).
fn losses(found: &Robust, system: System) -> DocumentTable {
    let goal = &found.search.of;
    let show = |loss: f64| shown::goal_difference(goal, loss, system);
    let or_dash = |loss: Option<f64>| loss.map_or(shown::NONE.into(), show);
    let head = ["", "robust", "as set up"].map(str::to_owned);
    let head = head.into_iter().chain(heads_of_bests(found));
    let rows = found.models.iter().enumerate().map(|(k, of)| {
        let own = [
            (k + 1).to_string(),
            show(of.loss),
            or_dash(of.loss_as_set_up),
        ];
        let of_bests = of.losses_of_bests.iter().copied().map(or_dash);
        own.into_iter().chain(of_bests).collect()
    });
    let mut table = DocumentTable::new(head, rows).right(1..found.models.len() + 3);
    table.caption = format!(
        "losses of {} against each model's own best design, by design; {} if the design violates a \
         limit, or if the ball does not fly{}",
        goal.expression,
        shown::NONE,
        if found.search.scenarios.is_one_drive() {
            ""
        } else {
            " in one of the swings"
        }
    );
    table
}

/// Adds the varied parameters and the constraints at the robust design to a document. Each row has
/// the change of the greatest loss if the bound or limit is relaxed.
fn add_design(document: &mut Document, found: &Robust, system: System) {
    let rows = found.search.vary.iter().enumerate().map(|(i, vary)| {
        vec![
            vary.parameter.name.into(),
            shown::within(vary, found.design[i], system),
            shown::range(vary, system),
            bound_in_words_of_loss(found, i, system),
        ]
    });
    let head = [
        "vary",
        ended_at(found.solution.status, "robust"),
        "range",
        CHANGE,
    ];
    document.add(DocumentTable::new(head, rows).right([1]));
    add_constraints(document, found, system);
}

/// The greatest loss as an objective.
fn greatest_loss(found: &Robust) -> Objective {
    let goal = &found.search.of;
    Objective {
        of: goal.into(),
        value: found.solution.value.unwrap_or_default(),
        sense: Sense::Minimize,
        is_converged: found.solution.status == Status::Converged,
    }
}

/// Describes the change of the greatest loss if a bound of varied parameter `i` is relaxed.
fn bound_in_words_of_loss(found: &Robust, i: usize, system: System) -> String {
    let (vary, solution) = (found.search.vary[i], &found.solution);
    let objective = greatest_loss(found);
    if vary.low == vary.high {
        return "fixed".into();
    }
    if !objective.is_converged {
        return String::new();
    }
    let price = |amount: f64| objective.price(amount, vary.parameter, system);
    let multipliers = [solution.lower_multipliers[i], solution.upper_multipliers[i]];
    let prices = found.bound_prices(i);
    let [lower, upper] = prices.map(|amount| price_of_single_models(multipliers, price(amount)));
    let mut words = limits::bound(multipliers, prices, price);
    if let Some(lower) = lower {
        words += &format!("; {lower} that its lower bound is lowered");
    }
    if let Some(upper) = upper {
        words += &format!("; {upper} that its upper bound is raised");
    }
    words
}

fn add_constraints(document: &mut Document, found: &Robust, system: System) {
    let objective = greatest_loss(found);
    let models = 0..found.models.len();
    let limits = models.flat_map(|model| found.constraints(model).map(move |limit| (model, limit)));
    let rows = limits.map(|(model, limit)| {
        let (constraint, at) = (limit.constraint, limit.at);
        let price = objective.price(limit.gain, &constraint.goal, system);
        let single =
            price_of_single_models([at.multiplier; 2], price).filter(|_| objective.is_converged);
        let words = single.map_or(String::new(), |price| {
            format!("; {price} that the limit is relaxed")
        });
        vec![
            constraint.expression.clone(),
            (model + 1).to_string(),
            shown::goal(&constraint.goal, at.value, system),
            objective.limit(&limit, system) + &words,
        ]
    });
    let rows: Vec<_> = rows.collect();
    if !rows.is_empty() {
        let head = ["subject to", "model", "value", CHANGE];
        document.add(DocumentTable::new(head, rows).right([1, 2]));
    }
}

/// Returns the text `price` of a bound or constraint that is active at the best design of a model,
/// but not at the robust design: its `multipliers` are 0, and its price is not 0.
fn price_of_single_models(multipliers: [f64; 2], price: String) -> Option<String> {
    let is_nonzero = !is_zero(leading_number(&price));
    (multipliers == [0.0; 2] && is_nonzero).then_some(price)
}

/// The setup with the robust design for a setup file. `file` is the setup of the request. Comments
/// are in the units of `system`.
pub fn robust_setup(
    found: &Robust,
    within: Option<f64>,
    file: &SetupFile,
    system: System,
) -> CommentedSetup {
    let search = &found.search;
    let mut about = vec![format!(
        "{}, {}",
        file.name,
        search.sense.best_of(&search.of)
    )];
    about.push(verdict(found, within, system));
    about.extend(
        found
            .models
            .iter()
            .map(|of| format!("model: {}", of.model.name)),
    );
    about.extend(search.subject_to.iter().map(about_constraint));
    CommentedSetup {
        setup: found.setup,
        about,
        remarks: remarks_on_varied("robust", &search.vary, &found.design),
    }
}
