use super::agreement::Agreement;
use super::landing::{AT_LANDING, changes_per_time};
use super::rows::{DerivativeRow, demand};
use crate::derivative::check::Verdict;
use crate::derivative::gradient;
use crate::drive::{Drive, Outcome};
use crate::parameters::{Parameter, Setup};
use serde::Serialize;

/// A wrong derivative that is planted in place of the right derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlantedError {
    /// Sign changed.
    Sign,
    /// Too large by the factor 1 + 1e-6.
    Millionth,
    /// Landing time treated as constant, as in a flight loop that stops after a fixed step.
    LandingTerm,
}

variant_names! {
    /// Name in JSON, for example `sign`.
    PlantedError as "PlantedError" {
        Sign = "sign",
        Millionth = "factor 1 + 1e-6",
        LandingTerm = "no landing term",
    }
}

/// Detection rate of a planted error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct DetectionTest {
    /// The planted error.
    pub error: PlantedError,
    /// Number of rows in which the error was planted. Each row passes without the error and has a
    /// significant derivative, which the error changes.
    pub rows: usize,
    /// Number of rows where differences detected the error.
    pub caught: usize,
    /// Number of rows where num-dual detected the error.
    pub caught_by_num_dual: usize,
}

impl DetectionTest {
    /// True if both methods detected the error in every row.
    pub fn is_caught(&self) -> bool {
        self.caught == self.rows && self.caught_by_num_dual == self.rows
    }
}

/// Landing term of the derivative in each row: the derivative of the outcome by the landing time,
/// times the derivative of the landing time by the parameter. `None` for an outcome without a
/// landing term. The list is `None` if the ball does not land.
fn landing_terms(
    setup: &Setup<f64>,
    wrt: &[&'static Parameter],
    rows: &[DerivativeRow],
) -> Option<Vec<Option<f64>>> {
    let per_time = changes_per_time(Drive::new(setup).ok()?.landed().ok()?.velocity);
    let time = gradient(setup, Outcome::FlightTime, wrt).ok()?.gradient;
    let term = |row: &DerivativeRow| {
        let outcome = AT_LANDING.iter().position(|of| *of == row.of)?;
        let parameter = wrt.iter().position(|one| *one == row.parameter)?;
        Some(per_time[outcome] * time[parameter])
    };
    Some(rows.iter().map(term).collect())
}

/// Plants each error in the passing rows, and judges the wrong derivatives. Rows that the error
/// does not change, and rows whose derivative or landing term is negligible, are left out.
pub(super) fn detection_tests(
    setup: &Setup<f64>,
    wrt: &[&'static Parameter],
    rows: &[DerivativeRow],
) -> [DetectionTest; 3] {
    let landing_terms = landing_terms(setup, wrt, rows).unwrap_or(vec![None; rows.len()]);
    let is_passed =
        |row: &DerivativeRow| [row.first.verdict, row.num_dual.verdict] == [Verdict::Pass; 2];
    PlantedError::ALL.map(|error| {
        let mut test = DetectionTest {
            error,
            rows: 0,
            caught: 0,
            caught_by_num_dual: 0,
        };
        let rows = rows.iter().zip(&landing_terms);
        for (row, term) in rows.filter(|(row, _)| is_passed(row)) {
            let Some(wrong) = wrong(error, row, *term).filter(|wrong| *wrong != row.first.exact)
            else {
                continue;
            };
            test.rows += 1;
            test.caught += usize::from(row.ladder.judge(wrong, demand(setup)).failed());
            let agreement = Agreement::new(wrong, row.num_dual.num_dual, &row.ladder);
            test.caught_by_num_dual += usize::from(agreement.verdict == Verdict::Fail);
        }
        test
    })
}

fn wrong(error: PlantedError, row: &DerivativeRow, landing_term: Option<f64>) -> Option<f64> {
    let exact = row.first.exact;
    let (size, wrong) = match error {
        PlantedError::Sign => (exact, -exact),
        PlantedError::Millionth => (exact, exact * (1.0 + 1e-6)),
        PlantedError::LandingTerm => {
            let term = landing_term?;
            (term, exact - term)
        }
    };
    Some(wrong).filter(|_| size.abs() >= row.ladder.negligible_size())
}
