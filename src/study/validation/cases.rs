use super::compared::Compared;
use crate::error::{Error, Result};
use crate::json::numbers_by_name;
use crate::units::Quantity;
use serde::Serialize;

/// Published drives with sources. Column heads contain units; an empty cell means not stated.
const CASES: &str = include_str!("cases.csv");

/// A published drive.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "CaseReport"))]
pub struct Case {
    /// The name of the drive.
    pub name: String,
    /// The publication.
    pub source: String,
    /// Preset of the club.
    #[serde(skip)]
    pub preset: Option<String>,
    /// Club speed, m/s.
    #[serde(skip)]
    pub club_speed: Option<f64>,
    /// Attack angle, rad.
    #[serde(skip)]
    pub attack_angle: Option<f64>,
    /// Face angle minus path, rad.
    #[serde(skip)]
    pub face_to_path: Option<f64>,
    /// Ball speed, m/s.
    #[serde(skip)]
    pub ball_speed: Option<f64>,
    /// Launch angle, rad.
    #[serde(skip)]
    pub launch_angle: Option<f64>,
    /// Spin, rad/s.
    #[serde(skip)]
    pub spin: Option<f64>,
    /// Air density, kg/m³.
    #[serde(skip)]
    pub density: Option<f64>,
    /// The published quantities, SI.
    // in the order of [`Compared::ALL`]
    #[serde(serialize_with = "numbers_by_name")]
    #[cfg_attr(
        test,
        schemars(with = "std::collections::BTreeMap<Compared, crate::json::JsonNumber>")
    )]
    published: Vec<(Compared, f64)>,
}

impl Case {
    /// Published value of a quantity, SI; `None` if it was not published.
    pub fn published(&self, of: Compared) -> Option<f64> {
        let mut published = self.published.iter();
        let (_, value) = published.find(|(known, _)| *known == of)?;
        Some(*value)
    }
}

pub(super) fn cases(set: &str) -> Result<Vec<Case>> {
    let unreadable = |source: Box<dyn std::error::Error + Send + Sync>| {
        Error::unreadable(format!("the published drives of {set}"), source)
    };
    let mut reader = csv::Reader::from_reader(CASES.as_bytes());
    let heads = reader
        .headers()
        .map_err(|error| unreadable(error.into()))?
        .clone();
    let mut cases = vec![];
    for record in reader.records() {
        let record = record.map_err(|error| unreadable(error.into()))?;
        let text = |name: &str| {
            let at = heads
                .iter()
                .position(|head| head.split(" [").next() == Some(name));
            at.and_then(|at| Some((heads.get(at)?, record.get(at)?)))
                .filter(|(_, cell)| !cell.is_empty())
        };
        let words = |name: &str| text(name).map(|(_, cell)| cell.to_owned());
        if words("set").as_deref() != Some(set) {
            continue;
        }
        let number = |name: &str, quantity: Quantity| {
            let Some((head, cell)) = text(name) else {
                return Ok(None);
            };
            let unit = head
                .split_once('[')
                .map_or("", |(_, unit)| unit.trim_end_matches(']'));
            quantity
                .read(&format!("{cell} {unit}"))
                .map(Some)
                .map_err(|error| unreadable(error.into()))
        };
        let mut published = vec![];
        for of in Compared::ALL {
            let value = number(of.name(), of.unit().quantity)?;
            published.extend(value.map(|value| (of, value)));
        }
        cases.push(Case {
            name: words("case").unwrap_or_default(),
            source: words("source").unwrap_or_default(),
            preset: words("preset"),
            club_speed: number("club_speed", Quantity::SPEED)?,
            attack_angle: number("attack_angle", Quantity::ANGLE)?,
            face_to_path: number("face_to_path", Quantity::ANGLE)?,
            ball_speed: number("ball_speed", Quantity::SPEED)?,
            launch_angle: number("launch_angle", Quantity::ANGLE)?,
            spin: number("spin", Quantity::ANGULAR_VELOCITY)?,
            density: number("density", Quantity::DENSITY)?,
            published,
        });
    }
    Ok(cases)
}
