use super::agreement::Agreement;
use super::landing::AT_LANDING;
use super::rows::{Row, demand};
use crate::derivative::check::Verdict;
use crate::derivative::gradient;
use crate::drive::{Drive, Outcome};
use crate::parameters::{Parameter, Setup};

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
    /// The rows it was planted in: derivatives that passed and are more than next to nothing, and
    /// that it changes.
    pub rows: usize,
    /// In how many of them differences caught it.
    pub caught: usize,
    /// In how many of them the derivative over num-dual did.
    pub caught_by_num_dual: usize,
}

impl Planted {
    /// Whether both caught it wherever it was planted.
    pub fn is_caught(&self) -> bool {
        self.caught == self.rows && self.caught_by_num_dual == self.rows
    }
}

/// How the landing answers to each parameter: velocity there, and the derivative of its time.
pub(super) struct LandingTerms {
    per_time: [f64; 3],
    times: Vec<(&'static Parameter, f64)>,
}

impl LandingTerms {
    /// The terms of a drive by some parameters; `None` where it does not land.
    pub fn new(setup: &Setup<f64>, wrt: &[&'static Parameter]) -> Option<Self> {
        let velocity = Drive::new(setup).ok()?.landed().ok()?.velocity;
        let time = gradient(setup, Outcome::FlightTime, wrt).ok()?;
        let times = wrt.iter().copied().zip(time.gradient).collect();
        Some(Self {
            per_time: [velocity.z, velocity.y, 1.0],
            times,
        })
    }

    /// What of a derivative is the landing's.
    fn of(&self, row: &Row) -> Option<f64> {
        let place = AT_LANDING.iter().position(|of| *of == row.of)?;
        let (_, time) = self
            .times
            .iter()
            .find(|(parameter, _)| *parameter == row.parameter)?;
        Some(self.per_time[place] * time)
    }
}

/// Plants each error in every row that passed, and judges again.
pub(super) fn planted(
    setup: &Setup<f64>,
    rows: &[Row],
    landing: Option<&LandingTerms>,
) -> [Planted; 3] {
    Plant::ALL.map(|plant| {
        let mut planted = Planted {
            plant,
            rows: 0,
            caught: 0,
            caught_by_num_dual: 0,
        };
        for row in rows
            .iter()
            .filter(|row| row.first.verdict == Verdict::Pass && row.num_dual.holds())
        {
            let Some(wrong) = wrong(plant, row, landing).filter(|wrong| *wrong != row.first.exact)
            else {
                continue;
            };
            planted.rows += 1;
            planted.caught += usize::from(row.ladder.judge(wrong, demand(setup)).failed());
            planted.caught_by_num_dual +=
                usize::from(!Agreement::new(wrong, row.num_dual.num_dual, &row.ladder).holds());
        }
        planted
    })
}

fn wrong(plant: Plant, row: &Row, landing: Option<&LandingTerms>) -> Option<f64> {
    let exact = row.first.exact;
    let (size, wrong) = match plant {
        Plant::Sign => (exact, -exact),
        Plant::Millionth => (exact, exact * (1.0 + 1e-6)),
        Plant::LandingTerm => {
            let term = landing?.of(row)?;
            (term, exact - term)
        }
    };
    Some(wrong).filter(|_| size.abs() >= row.ladder.next_to_nothing())
}
