use super::landing::AT_LANDING;
use super::rows::{Row, demand};
use crate::derivative::check::Verdict;
use crate::drive::{Drive, Outcome};
use crate::parameters::Setup;

/// A wrong derivative, planted where a right one stood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plant {
    /// The sign is turned.
    Sign,
    /// It is a millionth too large.
    Millionth,
    /// The landing stays at its time: the derivative of a flight loop that stops at a fixed step.
    LandingTerm,
}

impl Plant {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Sign, Self::Millionth, Self::LandingTerm];

    /// Its name in JSON: `sign`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::Millionth => "factor 1 + 1e-6",
            Self::LandingTerm => "no landing term",
        }
    }
}

/// What became of a planted error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Planted {
    /// The error.
    pub plant: Plant,
    /// The rows it was planted in: derivatives that passed and are more than next to nothing, and that it changes.
    pub rows: usize,
    /// In how many of them it was caught.
    pub caught: usize,
}

impl Planted {
    /// Whether it was caught wherever it was planted.
    pub fn is_caught(&self) -> bool {
        self.caught == self.rows
    }
}

/// Plants each error in every row that passed, and judges again.
pub(super) fn planted(setup: &Setup<f64>, rows: &[Row]) -> [Planted; 3] {
    Plant::ALL.map(|plant| {
        let mut planted = Planted { plant, rows: 0, caught: 0 };
        for row in rows.iter().filter(|row| row.first.verdict == Verdict::Pass) {
            let Some(wrong) = wrong(setup, plant, row, rows).filter(|wrong| *wrong != row.first.exact) else {
                continue;
            };
            planted.rows += 1;
            planted.caught += usize::from(row.ladder.judge(wrong, demand(setup)).verdict == Verdict::Fail);
        }
        planted
    })
}

fn wrong(setup: &Setup<f64>, plant: Plant, row: &Row, rows: &[Row]) -> Option<f64> {
    let exact = row.first.exact;
    let least = row.ladder.next_to_nothing();
    match plant {
        Plant::Sign => Some(-exact).filter(|_| exact.abs() >= least),
        Plant::Millionth => Some(exact * (1.0 + 1e-6)).filter(|_| exact.abs() >= least),
        Plant::LandingTerm => {
            let velocity = Drive::new(setup).ok()?.landed().ok()?.velocity;
            let place = AT_LANDING.iter().position(|of| *of == row.of)?;
            let per_time = [velocity.z, velocity.y, 1.0][place];
            let is_time = |other: &&Row| other.of == Outcome::FlightTime && other.parameter == row.parameter;
            let term = per_time * rows.iter().find(is_time)?.first.exact;
            Some(exact - term).filter(|_| term.abs() >= least)
        }
    }
}
