use super::csv_text::csv_text;
use super::document::{Document, DocumentTable, Line};
use super::json::{ByName, JsonNumber};
use super::plot::NamedQuantity;
use super::reply::{Ending, Report};
use super::setup_file::{CommentedSetup, about_constraint, remarks_on_varied};
use super::shown;
use super::swings::ScenariosReport;
use crate::error::{Error, Result};
use crate::parameters::SetupFile;
use crate::study::swings::{Pareto, ParetoPoint};
use crate::study::{Active, BoundSide};
use crate::units::{DerivativeUnit, System, TableUnits, counted, per, significant};
use serde::Serialize;

/// The role of a point of a front: an end, or the knee; `None` for all other points.
pub(super) fn role(found: &Pareto, place: usize) -> Option<String> {
    let [first, second] = bests(found);
    match place {
        _ if found.knee == Some(place) => Some("knee".into()),
        _ if found.points.len() == 1 => Some(format!("{first}, {second}")),
        0 => Some(first),
        // an interrupted front has no second end
        _ if place + 1 == found.points.len() && !found.interrupted => Some(second),
        _ => None,
    }
}

/// The two ends of a front in words, for example "largest carry" and "smallest abs(lateral)".
fn bests(found: &Pareto) -> [String; 2] {
    let goals = found.search.goals.each_ref();
    goals.map(|(goal, sense)| sense.best_of(goal))
}

/// The Pareto front of two goals, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ParetoReport<'a> {
    #[serde(skip)]
    found: &'a Pareto,
    /// The two goals.
    pub goals: Vec<ParetoGoalReport>,
    /// The points, from the optimum of the first goal to the optimum of the second.
    pub points: Vec<ParetoPointReport>,
    /// The index of the knee in `points`, from 0; `null` without one.
    pub knee: Option<usize>,
    /// The distance of the knee from the chord between the ends, relative to the length of the
    /// chord. Each goal is scaled by its difference between the ends.
    pub bend: JsonNumber,
    /// The goals before the search, SI; `null` if the ball does not fly in one of the swings.
    pub as_set_up: Option<[JsonNumber; 2]>,
    /// Number of omitted points that other points dominate.
    pub dominated: usize,
    /// The swings; `null` for one drive.
    pub swings: Option<ScenariosReport>,
    /// The file that was written; `null` without one.
    pub file: Option<String>,
    /// True if a requested file was not written, so that the answer is partial.
    #[serde(skip)]
    pub lacks_file: bool,
}

/// A goal of a front.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ParetoGoalReport {
    /// The goal.
    pub expression: String,
    /// `maximize` or `minimize`.
    #[cfg_attr(test, schemars(with = "crate::study::Sense"))]
    pub sense: &'static str,
    /// The SI unit.
    pub unit: &'static str,
}

/// A point of a front.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ParetoPointReport {
    /// The values of the goals, SI.
    pub values: [JsonNumber; 2],
    /// The varied parameters, SI.
    pub design: ByName<JsonNumber>,
    /// The derivative of the first goal by the second along the front, SI; `null` if the front has
    /// no unique slope at this point.
    pub slope: JsonNumber,
    /// The role: an end, or the knee; `null` for all other points.
    pub role: Option<String>,
    /// The active bounds and constraints.
    pub active: Vec<String>,
    /// The active bound of each parameter that is at a bound.
    pub bounds: ByName<BoundSide>,
    /// A change of the active bounds and constraints at this point, or a jump to another branch;
    /// `null` if there is neither.
    pub event: Option<String>,
}

impl<'a> ParetoReport<'a> {
    /// The report of a front.
    pub fn new(found: &'a Pareto) -> Self {
        let goals = found.search.goals.iter();
        let goals = goals.map(|(goal, sense)| ParetoGoalReport {
            expression: goal.expression.clone(),
            sense: sense.name(),
            unit: goal.quantity.si,
        });
        let points = found.points.iter().enumerate();
        let points = points.map(|(place, point)| ParetoPointReport::new(found, place, point));
        let has_swings = !found.search.scenarios.is_one_drive();
        Self {
            found,
            goals: goals.collect(),
            points: points.collect(),
            knee: found.knee,
            bend: found.relative_bulge.into(),
            as_set_up: found.as_set_up.map(|goals| goals.map(JsonNumber::from)),
            dominated: found.dominated,
            swings: has_swings.then(|| ScenariosReport::new(&found.search.scenarios)),
            file: None,
            lacks_file: false,
        }
    }
}

impl ParetoPointReport {
    fn new(found: &Pareto, place: usize, point: &ParetoPoint) -> Self {
        let active = point.active.iter();
        Self {
            values: point.goals.map(JsonNumber::from),
            design: ByName::of_varied(&found.search.vary, &point.design),
            slope: point.slope.into(),
            role: role(found, place),
            bounds: ByName::of_bounds(&point.active),
            active: active.map(|active| active.name.clone()).collect(),
            event: point.event_text.clone(),
        }
    }
}

impl Report for ParetoReport<'_> {
    const COMMAND: &'static str = "pareto";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["done", "partial", "interrupted"];

    fn ending(&self) -> Ending {
        let found = self.found;
        Ending {
            status: match found.status() {
                "done" if self.lacks_file => "partial",
                status => status,
            },
            message: found.ended.clone().or_else(|| found.no_knee()),
        }
    }

    /// The front, with notes on its knee and slope.
    fn document(&self, system: System) -> Document {
        let mut document = Document::default();
        document.add(front(self.found, system));
        document.list(notes(self.found, system).into_iter().map(Line::flush));
        document
    }
}

fn front(found: &Pareto, system: System) -> DocumentTable {
    let search = &found.search;
    let [first, second] = search.goals.each_ref().map(|(goal, _)| goal);
    let slope_of = |point: &ParetoPoint| {
        point.slope.map_or(shown::NONE.into(), |slope| {
            shown::quotient(first, second, slope, system, 3)
        })
    };
    let rows = found.points.iter().enumerate().map(|(place, point)| {
        let mut words: Vec<String> = role(found, place).into_iter().collect();
        words.extend(point.active.iter().map(Active::to_string));
        words.extend(point.event_text.as_ref().map(|event| format!("<- {event}")));
        let values = [
            shown::goal(first, point.goals[0], system),
            shown::goal(second, point.goals[1], system),
        ];
        let design = search.vary.iter().zip(&point.design);
        let design = design.map(|(vary, x)| shown::parameter(vary.parameter, *x, system));
        let ends = [
            slope_of(point),
            if words.is_empty() {
                shown::NONE.into()
            } else {
                words.join("\n")
            },
        ];
        std::iter::once((place + 1).to_string())
            .chain(values)
            .chain(design)
            .chain(ends)
            .collect()
    });
    let names = search.vary.iter().map(|vary| vary.parameter.name);
    let head: Vec<&str> = ["", &first.expression, &second.expression]
        .into_iter()
        .chain(names)
        .chain(["slope", "remarks"])
        .collect();
    let remarks = head.len() - 1;
    DocumentTable::new(head, rows).right(0..remarks)
}

/// The notes of a front: number of swings, slope, knee, goals before the search, omitted points.
fn notes(found: &Pareto, system: System) -> Vec<String> {
    let [first, second] = found.search.goals.each_ref().map(|(goal, _)| goal);
    let mut notes = vec![];
    if !found.search.scenarios.is_one_drive() {
        notes.push(format!(
            "goals over {}",
            counted(found.search.scenarios.points.len() as u64, "swing")
        ));
    }
    if found.points.len() > 1 {
        let [of, by] = [first, second].map(|goal| system.unit(goal.unit));
        notes.push(format!(
            "slope: change of {} for each unit of {}, along the front{}; – where it is not unique",
            first.expression,
            second.expression,
            if of.is_empty() && by.is_empty() {
                String::new()
            } else {
                format!(" [{}]", per(of, by).trim())
            }
        ));
    }
    match found.knee {
        Some(knee) => notes.push(format!(
            "the knee is point {}, the farthest from the straight line between the ends: by {} % \
             of the length of this line, with each goal scaled by its difference between the ends",
            knee + 1,
            significant(100.0 * found.relative_bulge, 2)
        )),
        None => notes.extend(found.no_knee()),
    }
    if !found.idle.is_empty() {
        let names: Vec<_> = found.idle.iter().map(|parameter| parameter.name).collect();
        notes.push(format!(
            "fixed, because the effect on the goals is negligible: {}",
            names.join(", ")
        ));
    }
    if let Some([own, against]) = found.as_set_up {
        notes.push(format!(
            "as set up: {} {}, {} {}",
            first.expression,
            shown::goal(first, own, system),
            second.expression,
            shown::goal(second, against, system)
        ));
    }
    if found.dominated > 0 {
        let left_out = counted(found.dominated as u64, "point");
        notes.push(format!(
            "{left_out} left out, because other points are better in both goals"
        ));
    }
    notes.extend(found.ended.clone());
    notes
}

/// The front as CSV. The column heads contain the units.
///
/// # Errors
/// [`Error::Output`].
pub fn pareto_csv(found: &Pareto, units: TableUnits) -> Result<String> {
    let search = &found.search;
    let goals = search.goals.iter().map(|(goal, _)| NamedQuantity {
        label: goal.expression.clone(),
        of: goal.into(),
    });
    let varied = search.vary.iter().map(|vary| NamedQuantity {
        label: vary.parameter.name.into(),
        of: vary.parameter.into(),
    });
    let [first, second] = search.goals.each_ref().map(|(goal, _)| goal);
    let slope_unit = DerivativeUnit::new(first.into(), second.into(), units);
    let columns: Vec<NamedQuantity> = goals
        .chain(varied)
        .chain([NamedQuantity::plain(slope_unit.head("slope"))])
        .collect();
    let heads = columns.iter().map(|column| column.head(units));
    let words = ["role", "active", "event"].map(str::to_owned);
    let head = heads.chain(words).collect();
    let rows = found.points.iter().enumerate().map(|(place, point)| {
        let values = point.goals.iter().chain(&point.design);
        let slope = point.slope.map(|slope| slope / slope_unit.size);
        let values = values.copied().map(Some).chain([slope]);
        let numbers = columns
            .iter()
            .zip(values)
            .map(|(column, value)| column.cell(value, units));
        let active = point
            .active
            .iter()
            .map(Active::to_string)
            .collect::<Vec<_>>()
            .join("; ");
        let event = point.event_text.clone().unwrap_or_default();
        let words = [role(found, place).unwrap_or_default(), active, event];
        numbers.chain(words).collect()
    });
    csv_text(head, rows)
}

/// The setup of one point of a front for a setup file. `file` is the setup file or preset that the
/// request names. Comments are in the units of `system`.
///
/// # Errors
/// [`Error::Nothing`] if the front does not have the point `place`.
pub fn pareto_setup(
    found: &Pareto,
    place: usize,
    file: &SetupFile,
    system: System,
) -> Result<CommentedSetup> {
    let search = &found.search;
    let Some(point) = found.points.get(place) else {
        return Err(Error::Nothing {
            doing: "write",
            what: "point of the front",
        });
    };
    let [first, second] = bests(found);
    let of = |k: usize| shown::goal(&search.goals[k].0, point.goals[k], system);
    let what = role(found, place).map_or(String::new(), |role| format!(", {role}"));
    let mut about = vec![
        format!(
            "{}, between the {first} and the {second}: point {} of {}{what}",
            file.name,
            place + 1,
            found.points.len()
        ),
        format!(
            "{} {}, {} {}",
            search.goals[0].0.expression,
            of(0),
            search.goals[1].0.expression,
            of(1)
        ),
    ];
    about.extend(search.subject_to.iter().map(about_constraint));
    Ok(CommentedSetup {
        setup: point.setup,
        about,
        remarks: remarks_on_varied("chosen", &search.vary, &point.design),
    })
}
