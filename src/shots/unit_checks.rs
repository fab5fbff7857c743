//! Plausibility checks over all rows: likely errors of units and signs.

use super::flown::Flown;
use super::source::Shots;
use crate::drive::Outcome;
use crate::statistics::median;
use crate::units::{Message, Quantity};

/// Maximum number of ratios kept for a median.
const MOST: usize = 4096;

/// Minimum number of rows for a warning.
const LEAST: usize = 2;
/// Minimum number of rows for a warning about a unit that gives a ratio near 1, and for a warning
/// about opposite sides.
const LEAST_NEAR_ONE: usize = 5;

/// Maximum relative difference between the median of predicted/measured and the ratio that a wrong
/// unit gives.
const NEAR: f64 = 0.06;
/// `NEAR` for a wrong unit that gives a ratio near 1.
const NEAR_ONE: f64 = 0.025;

/// The side of a landing counts if the landing point is farther than this from the target line, m.
const LEAST_OFFLINE: f64 = 3.0;

/// Minimum fraction of rows with opposite sides for a warning.
const LEAST_DISAGREE: f64 = 0.8;

/// Pairs of units: values in the first unit may have been read in the second.
const MISTAKEN: [(Quantity, &str, &str); 6] = [
    (Quantity::LENGTH, "yd", "ft"),
    (Quantity::LENGTH, "ft", "yd"),
    (Quantity::LENGTH, "m", "yd"),
    (Quantity::LENGTH, "yd", "m"),
    (Quantity::SPEED, "mph", "m/s"),
    (Quantity::SPEED, "m/s", "mph"),
];

/// Largest plausible ratio of carry to ball speed, s. Computed drives have ratios up to 3.8 s at
/// sea level, and up to 4.4 s at an altitude of 2500 m. If speeds in m/s were read as mph, the
/// ratio is 4.8 s or more for launches of a driver (49 to 90 m/s, up to 5000 rpm).
const MOST_CARRY_PER_SPEED: f64 = 4.6;

/// Ratios predicted/measured of the carry that suggest speeds in km/h read as mph. This mistake
/// makes the ball speed 1.609 times as large. The computed carry of a driver (50 to 75 m/s, 10° to
/// 12°) is then 1.5 to 2.1 times as long.
const IN_KMH: std::ops::Range<f64> = 1.45..2.0;

/// Minimum ball speed of the rows in `carries`, m/s: 49 m/s read as mph. For slower balls the ratio
/// is below [`MOST_CARRY_PER_SPEED`] with either unit.
const SLOW: f64 = 22.0;

/// Ratios and sides of predicted and measured values.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct UnitChecks {
    /// Ratios predicted/measured of each outcome.
    ratios: Vec<Vec<f64>>,
    /// Number of rows whose predicted and measured landings are both farther than
    /// [`LEAST_OFFLINE`] from the target line, and number of those rows with landings on opposite
    /// sides.
    sides: [usize; 2],
    /// Ratios of measured carry to ball speed, s.
    carries: Vec<f64>,
}

impl UnitChecks {
    pub fn new(outcomes: usize) -> Self {
        Self {
            ratios: vec![vec![]; outcomes],
            ..Self::default()
        }
    }

    /// Adds a row.
    pub fn add(&mut self, flown: &Flown, row: usize) {
        for (at, of) in flown.of.iter().enumerate() {
            let (Some(predicted), Some(residual)) =
                (flown.predicted(row, at), flown.residual(row, at))
            else {
                continue;
            };
            let measured = predicted - residual;
            if of.is_lateral() {
                if predicted.abs().min(measured.abs()) > LEAST_OFFLINE && *of == Outcome::Lateral {
                    self.sides[0] += 1;
                    self.sides[1] += usize::from(predicted * measured < 0.0);
                }
            } else if measured > 0.0 && self.ratios[at].len() < MOST {
                self.ratios[at].push(predicted / measured);
            }
        }
        let shot = &flown.shots[row];
        if let (Some(launch), Some(carry)) = (shot.launch(), shot.value(Outcome::CarryDistance))
            && launch[0] > SLOW
            && self.carries.len() < MOST
        {
            self.carries.push(carry.value / launch[0]);
        }
    }

    /// Merges the values of later rows.
    pub fn merge(&mut self, other: Self) {
        for (own, theirs) in self.ratios.iter_mut().zip(other.ratios) {
            own.extend(theirs.into_iter().take(MOST.saturating_sub(own.len())));
        }
        self.carries.extend(
            other
                .carries
                .into_iter()
                .take(MOST.saturating_sub(self.carries.len())),
        );
        self.sides = [
            self.sides[0] + other.sides[0],
            self.sides[1] + other.sides[1],
        ];
    }

    /// Warnings about columns of these shots.
    pub fn warnings(&self, of: &[Outcome], shots: &Shots) -> Vec<Message> {
        let name = |of| shots.name_of(of);
        let advice = shots.unit_advice();
        let mut warnings = vec![];
        if let Some(fault) = self.speed_fault(of, shots.unit_of(Outcome::BallSpeed)) {
            let speed = name(Outcome::BallSpeed);
            warnings.push(format!("{speed}: the balls carry {fault}; {advice}"));
        } else {
            let units = of.iter().zip(&self.ratios).filter_map(|(of, ratios)| {
                let (ratio, (_, meant, read)) =
                    likely_unit_error(of.quantity(), ratios, shots.unit_of(*of))?;
                Some(format!(
                    "{}: predicted values are {ratio:.2} times the measured values in the median, \
                     as if the measured values were in {meant} and read in {read}; {advice}",
                    name(*of)
                ))
            });
            warnings.extend(units);
        }
        let [all, disagree] = self.sides;
        if all >= LEAST_NEAR_ONE && disagree as f64 >= LEAST_DISAGREE * all as f64 {
            warnings.push(format!(
                "{}: of {all} rows that end off the target line {disagree} end on the opposite \
                 side of the prediction; positive values of this column, of the launch direction \
                 or of the spin may be to the left",
                name(Outcome::Lateral)
            ));
        }
        warnings.into_iter().map(Message::from).collect()
    }

    /// Words that compare the carries with ball speeds read in `unit`. If the speeds were read in
    /// mph, the words name the unit that was probably meant. `None` if the carries fit the speeds or
    /// are too few.
    fn speed_fault(&self, of: &[Outcome], unit: Option<&str>) -> Option<String> {
        if self.carries.len() < LEAST {
            return None;
        }
        let mph = Quantity::SPEED.size_of("mph");
        let is_mph = unit.is_some_and(|unit| Quantity::SPEED.size_of(unit) == mph);
        let as_if = |meant: &str| match is_mph {
            true => format!(", as if the speeds were in {meant} and read in mph"),
            false => String::new(),
        };
        if median(&self.carries)? > MOST_CARRY_PER_SPEED {
            return Some(format!("farther than such speeds allow{}", as_if("m/s")));
        }
        let carry = of.iter().position(|of| *of == Outcome::CarryDistance)?;
        let ratio = median(&self.ratios[carry])?;
        let is_in_kmh = IN_KMH.contains(&ratio);
        is_in_kmh.then(|| format!("less far than such speeds give{}", as_if("km/h")))
    }
}

/// Median of predicted/measured, and the pair of units that explains this ratio, for values that
/// were read in `unit`. `None` if no pair of units explains it, or if there are too few values.
fn likely_unit_error(
    quantity: Quantity,
    ratios: &[f64],
    unit: Option<&str>,
) -> Option<(f64, (Quantity, &'static str, &'static str))> {
    let ratio = median(ratios)?;
    let is_it = |(of, meant, read): &(Quantity, &'static str, &'static str)| {
        let size = |unit: &str| of.size_of(unit).unwrap_or(1.0);
        let expected = size(meant) / size(read);
        let is_near_one = (0.8..1.25).contains(&expected);
        let (near, least) = if is_near_one {
            (NEAR_ONE, LEAST_NEAR_ONE)
        } else {
            (NEAR, LEAST)
        };
        let is_read = |unit| of.size_of(unit) == of.size_of(read);
        *of == quantity
            && unit.is_none_or(is_read)
            && ratios.len() >= least
            && (ratio / expected - 1.0).abs() <= near
    };
    MISTAKEN
        .iter()
        .find(|mistake| is_it(mistake))
        .map(|mistake| (ratio, *mistake))
}
