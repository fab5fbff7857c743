use super::lines::paragraph;
use super::swings::ScenariosReport;
use super::table::table;
use super::{Reply, json, shown};
use crate::error::{Error, Result};
use crate::parameters::Preset;
use crate::study::Active;
use crate::study::swings::{Pareto, ParetoPoint};
use crate::units::{Message, System, counted, per, significant};
use serde_json::{Value, json};

/// The role of a point of a front: an end, or the knee.
pub(super) fn role(found: &Pareto, place: usize) -> Option<String> {
    let [first, second] = found.search.goals.each_ref().map(|(goal, sense)| {
        let (adjective, goal) = (sense.adjective(), &goal.expression);
        format!("{adjective} {goal}")
    });
    match place {
        _ if found.knee == Some(place) => Some("knee".into()),
        _ if found.points.len() == 1 => Some(format!("{first}, {second}")),
        0 => Some(first),
        // the last point of an interrupted front is not its end
        _ if place + 1 == found.points.len() && !found.interrupted => Some(second),
        _ => None,
    }
}

/// The answer of `pareto`.
pub fn pareto_reply(found: &Pareto, warnings: Vec<Message>, file: Option<String>) -> Reply<Value> {
    let search = &found.search;
    let names = || search.vary.iter().map(|vary| vary.parameter.name);
    let values = |values: &[f64; 2]| values.map(|value| json::number(Some(value)));
    let goals = search
        .goals
        .iter()
        .map(|(goal, sense)| json!({ "expression": goal.expression, "sense": sense.name(), "unit": goal.quantity.si }));
    let point = |(place, point): (usize, &ParetoPoint)| {
        let bounds = point
            .active
            .iter()
            .filter_map(|active| Some((active.name.clone(), active.end?.into())));
        json!({
            "values": values(&point.goals),
            "design": json::named(names().zip(point.design.iter().map(|x| Some(*x)))),
            "slope": json::number(point.slope),
            "role": role(found, place),
            "active": point.active.iter().map(|active| active.name.as_str()).collect::<Vec<_>>(),
            "bounds": Value::Object(bounds.collect()),
            "event": point.event,
        })
    };
    let swings = (!found.scenarios.is_one_drive()).then(|| ScenariosReport::new(&found.scenarios));
    let body = json!({
        "goals": goals.collect::<Vec<_>>(),
        "points": found.points.iter().enumerate().map(point).collect::<Vec<_>>(),
        "knee": found.knee,
        "bend": json::number(Some(found.bend)),
        "as_set_up": found.as_set_up.as_ref().map(values),
        "dominated": found.dominated,
        "swings": swings,
        "file": file,
    });
    let message = found.ended.clone().or_else(|| found.no_knee());
    Reply::done("pareto", warnings, body).ended(found.status(), message)
}

/// The front as a table, with notes on its knee and slope.
pub fn pareto_text(found: &Pareto, system: System) -> String {
    let search = &found.search;
    let [first, second] = search.goals.each_ref().map(|(goal, _)| goal);
    let kinds = [first, second].map(|goal| (goal.quantity, goal.unit));
    let slope_of = |point: &ParetoPoint| {
        point.slope.map_or(shown::NONE.into(), |slope| {
            shown::quotient(kinds[0], kinds[1], slope, system, 3).0
        })
    };
    let rows = found.points.iter().enumerate().map(|(place, point)| {
        let mut words: Vec<String> = role(found, place).into_iter().collect();
        words.extend(point.active.iter().map(Active::to_string));
        words.extend(point.event.as_ref().map(|event| format!("<- {event}")));
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
    let right: Vec<usize> = (0..head.len() - 1).collect();
    let mut notes = vec![];
    if !found.scenarios.is_one_drive() {
        notes.push(format!(
            "goals over {}",
            counted(found.scenarios.points.len() as u64, "swing")
        ));
    }
    if found.points.len() > 1 {
        let [of, by] = [first, second].map(|goal| system.unit(goal.unit));
        notes.push(format!(
            "slope: what {} changes by for each unit of {}, along the front{}",
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
            "the knee is point {}: of all it lies farthest, {} % of the distance between the ends, \
             off the straight line between them, with \
             both goals scaled from one end to the other",
            knee + 1,
            significant(100.0 * found.bend, 2)
        )),
        None => notes.extend(found.no_knee()),
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
            "left out, since other points are better in both goals: {left_out}"
        ));
    }
    notes.extend(found.ended.clone());
    let notes: String = notes.iter().map(|note| paragraph(note)).collect();
    format!("{}\n{notes}", table(&head, &right, rows))
}

/// The front as CSV, SI and radians; the head names the unit of each column.
///
/// # Errors
/// [`Error::Output`].
pub fn pareto_csv(found: &Pareto) -> Result<String> {
    let failed = |error: csv::Error| Error::Output(error.into());
    let search = &found.search;
    let mut writer = csv::Writer::from_writer(vec![]);
    let goals = search
        .goals
        .iter()
        .map(|(goal, _)| goal.quantity.head(&goal.expression));
    let varied = search
        .vary
        .iter()
        .map(|vary| vary.parameter.quantity.head(vary.parameter.name));
    let words = ["slope", "role", "active", "event"].map(str::to_owned);
    writer
        .write_record(goals.chain(varied).chain(words))
        .map_err(failed)?;
    for (place, point) in found.points.iter().enumerate() {
        let numbers = point
            .goals
            .iter()
            .chain(&point.design)
            .copied()
            .chain([point.slope.unwrap_or(f64::NAN)]);
        let numbers = numbers.map(|number| {
            if number.is_nan() {
                String::new()
            } else {
                format!("{number:?}")
            }
        });
        let active = point
            .active
            .iter()
            .map(Active::to_string)
            .collect::<Vec<_>>()
            .join("; ");
        let event = point.event.clone().unwrap_or_default();
        writer
            .write_record(numbers.chain([role(found, place).unwrap_or_default(), active, event]))
            .map_err(failed)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| Error::Output(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The setup of one point of a front as a setup file in TOML, to the last digit.
///
/// # Errors
/// As [`setup_toml`](super::setup_toml).
pub fn pareto_toml(found: &Pareto, place: usize, preset: &Preset) -> Result<String> {
    let search = &found.search;
    let Some(point) = found.points.get(place) else {
        return Err(Error::Nothing {
            doing: "write",
            what: "point of the front",
        });
    };
    let [first, second] = search
        .goals
        .each_ref()
        .map(|(goal, sense)| format!("{} {}", sense.adjective(), goal.expression));
    let of = |k: usize| shown::goal(&search.goals[k].0, point.goals[k], System::default());
    let what = role(found, place).map_or(String::new(), |role| format!(", {role}"));
    let mut about = vec![
        format!(
            "{}, between the {first} and the {second}: point {} of {}{what}",
            preset.name,
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
    about.extend(
        search
            .subject_to
            .iter()
            .map(|limit| format!("subject to {}", limit.expression)),
    );
    let remarks = search.vary.iter().zip(&point.design).map(|(vary, x)| {
        let show = |value: f64| vary.parameter.show(Some(value));
        let chosen = shown::as_declared(vary.parameter, *x);
        (
            vary.parameter,
            format!(
                "chosen: {chosen} in {} .. {}",
                show(vary.low),
                show(vary.high)
            ),
        )
    });
    super::setup_toml(&point.setup, preset, &about, &remarks.collect::<Vec<_>>())
}
