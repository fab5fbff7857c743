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
/// Minimum number of rows for a warning about a wrong unit that changes the values by less than
/// 25 %.
const LEAST_NEAR_ONE: usize = 5;
/// Minimum number of rows off the target line for a warning about landings on opposite sides.
const LEAST_SIDES: usize = 5;

/// A warning about a wrong unit needs a median of predicted/measured that differs from the ratio of
/// the two units by at most this fraction.
const NEAR: f64 = 0.06;
/// Replaces [`NEAR`] if the ratio of the two units is near 1 (m and yd).
const NEAR_ONE: f64 = 0.025;

/// Slowest launch of a driver, m/s.
const SLOWEST_DRIVE: f64 = 49.0;
/// Largest spin of a driver's launch, rpm. At more spin, as of irons, the laws may miss the carry
/// by about 9 %, the difference between a yard and a metre.
const MOST_SPIN_OF_A_DRIVE: f64 = 5000.0;

/// Smallest distance of a landing point from the target line, m, at which the side of the landing
/// is compared.
const LEAST_OFFLINE: f64 = 3.0;

/// Minimum fraction of rows with opposite sides for a warning.
const LEAST_DISAGREE: f64 = 0.8;

/// Pairs of units that may be confused: the values are in the first unit, but were read in the
/// second.
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

/// Ratios predicted/measured of the carry that suggest a mistake: the ball speeds are in km/h, but
/// were read as mph. The ball speed is then 1.609 times as large, and the computed carry of a
/// driver (50 to 75 m/s, 10° to 12°) is 1.5 to 2.1 times as long.
const IN_KMH: std::ops::Range<f64> = 1.45..2.0;

/// Minimum ball speed of the rows in `carries`, m/s: 49 m/s that were read as 49 mph. The carry of
/// slower balls does not show this mistake, because its ratio to the ball speed is below
/// [`MOST_CARRY_PER_SPEED`] in both units.
const SLOW: f64 = 22.0;

/// Ratios and sides of predicted and measured values.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct UnitChecks {
    /// Ratios predicted/measured of each outcome.
    ratios: Vec<Vec<f64>>,
    /// Ratios predicted/measured of the carry for launches of a driver only.
    carries_of_drives: Vec<f64>,
    /// Two numbers of rows:
    ///
    /// - with predicted and measured landings farther than [`LEAST_OFFLINE`] from the target line
    /// - of these, with landings on opposite sides
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
        let shot = &flown.shots[row];
        let is_drive = shot.launch().is_some_and(is_of_driver);
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
                if is_drive && *of == Outcome::CarryDistance {
                    self.carries_of_drives.push(predicted / measured);
                }
            }
        }
        if let (Some(launch), Some(carry)) = (shot.launch(), shot.value(Outcome::CarryDistance))
            && launch[0] > SLOW
            && self.carries.len() < MOST
        {
            self.carries.push(carry.value / launch[0]);
        }
    }

    /// Merges the values of later rows.
    pub fn merge(&mut self, other: Self) {
        let ratios = self.ratios.iter_mut().chain([&mut self.carries_of_drives]);
        let others = other.ratios.into_iter().chain([other.carries_of_drives]);
        for (own, theirs) in ratios.zip(others) {
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
                let of_drives: &[f64] = match of {
                    Outcome::CarryDistance => &self.carries_of_drives,
                    _ => &[],
                };
                let (ratio, (_, meant, read)) =
                    likely_unit_error(of.quantity(), ratios, of_drives, shots.unit_of(*of))?;
                Some(format!(
                    "{}: predicted values are {ratio:.2} times the measured values in the median, \
                     as if the measured values were in {meant} and read in {read}; {advice}",
                    name(*of)
                ))
            });
            warnings.extend(units);
        }
        let [all, disagree] = self.sides;
        if all >= LEAST_SIDES && disagree as f64 >= LEAST_DISAGREE * all as f64 {
            warnings.push(format!(
                "{}: of {all} rows that end off the target line {disagree} end on the opposite \
                 side of the prediction; positive values of this column, of the launch direction \
                 or of the spin may be to the left",
                name(Outcome::Lateral)
            ));
        }
        warnings.into_iter().map(Message::from).collect()
    }

    /// Describes the fault if the carries do not fit ball speeds that were read in `unit`. For mph,
    /// the text also names the unit that was probably meant. `None` if the carries fit, or if there
    /// are too few carries.
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

/// True for a launch that a driver may give.
fn is_of_driver(launch: &[f64]) -> bool {
    let [speed, _, _, back, side, ..] = launch else {
        return false;
    };
    let rpm = Quantity::ANGULAR_VELOCITY.size_of("rpm").unwrap_or(1.0);
    *speed >= SLOWEST_DRIVE && back.hypot(*side) <= MOST_SPIN_OF_A_DRIVE * rpm
}

/// The median of predicted/measured for values that were read in `unit`, and the pair of units that
/// explains this median. `None` if no pair explains it, or if there are too few values. Two units
/// whose ratio is near 1 need the ratios `of_drives`: the laws are accurate enough only for the
/// carry of drives.
fn likely_unit_error(
    quantity: Quantity,
    ratios: &[f64],
    of_drives: &[f64],
    unit: Option<&str>,
) -> Option<(f64, (Quantity, &'static str, &'static str))> {
    let explains = |(of, meant, read): &(Quantity, &'static str, &'static str)| {
        let size = |unit: &str| of.size_of(unit).unwrap_or(1.0);
        let expected = size(meant) / size(read);
        let is_near_one = (0.8..1.25).contains(&expected);
        let (ratios, near, least) = if is_near_one {
            (of_drives, NEAR_ONE, LEAST_NEAR_ONE)
        } else {
            (ratios, NEAR, LEAST)
        };
        let is_read = |unit| of.size_of(unit) == of.size_of(read);
        let ratio = median(ratios)?;
        let is_explained = *of == quantity
            && unit.is_none_or(is_read)
            && ratios.len() >= least
            && (ratio / expected - 1.0).abs() <= near;
        is_explained.then_some(ratio)
    };
    MISTAKEN
        .iter()
        .find_map(|mistake| Some((explains(mistake)?, *mistake)))
}
