use super::lbfgs::search_by_lbfgs;
use super::objective::{CarryObjective, LandingDefinition, SearchMethod, domain};
use crate::error::Result;
use crate::optimize::{Evaluation, Options, minimize, starts};
use crate::parameters::Setup;
use crate::reproduce::delivery::{DeliveryCarry, carry_if_flown, with_delivery};
use serde::Serialize;

/// Searches with one definition of the landing and one method. All combinations of landing and
/// method use the same starts.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Searches {
    /// Definition of the landing.
    pub landing: LandingDefinition,
    /// The method.
    pub method: SearchMethod,
    /// Result from each start.
    pub ends: Vec<End>,
}

/// Result of a search.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct End {
    /// Starting point.
    pub start: DeliveryCarry,
    /// End point, with the carry of this library's flight.
    pub end: DeliveryCarry,
    /// Number of computed flights. A flight with exact derivatives counts as one.
    pub flights: u64,
    /// Termination message of the method.
    pub message: String,
}

const STARTS: usize = 20;

const KINDS: [(LandingDefinition, SearchMethod); 7] = [
    (LandingDefinition::Overshot, SearchMethod::LimitedMemory),
    (LandingDefinition::Interpolated, SearchMethod::LimitedMemory),
    (LandingDefinition::Smooth, SearchMethod::LimitedMemoryExact),
    (LandingDefinition::Overshot, SearchMethod::QuasiNewton),
    (LandingDefinition::Interpolated, SearchMethod::QuasiNewton),
    (LandingDefinition::Smooth, SearchMethod::QuasiNewton),
    (LandingDefinition::Smooth, SearchMethod::Exact),
];

/// Runs the searches of each kind in `KINDS`, all from the same starts. The ball flies at every
/// start.
pub(super) fn searches(setup: &Setup<f64>) -> Result<Vec<Searches>> {
    let domain = domain()?;
    let mut begun = vec![];
    for x in starts(
        &domain,
        &[setup.club.loft, setup.swing.attack_angle],
        8 * STARTS,
    )? {
        if begun.len() == STARTS {
            break;
        }
        if let Some(carry) = carry_if_flown(&with_delivery(setup, x[0], x[1]))? {
            begun.push(DeliveryCarry {
                loft: x[0],
                attack_angle: x[1],
                carry,
            });
        }
    }
    let one = |(landing, method): (LandingDefinition, SearchMethod)| {
        let ends = begun
            .iter()
            .map(|start| search(&CarryObjective::new(setup, landing, method)?, *start));
        Ok(Searches {
            landing,
            method,
            ends: ends.collect::<Result<_>>()?,
        })
    };
    KINDS.into_iter().map(one).collect()
}

fn search(objective: &CarryObjective<'_>, start: DeliveryCarry) -> Result<End> {
    let x = [start.loft, start.attack_angle];
    let (x, message) = match objective.method {
        SearchMethod::LimitedMemory | SearchMethod::LimitedMemoryExact => {
            search_by_lbfgs(objective, &x)
        }
        SearchMethod::QuasiNewton | SearchMethod::Exact => {
            let problem = |x: &[f64]| {
                let objective = objective.taylor(x).map_err(|error| error.to_string())?;
                Ok(Evaluation::unconstrained(objective))
            };
            let found = minimize(&problem, &objective.domain, &x, &Options::default())?;
            (found.x, format!("{}: {}", found.status, found.message))
        }
    };
    let carry = carry_if_flown(&with_delivery(objective.setup, x[0], x[1]))?;
    Ok(End {
        start,
        end: DeliveryCarry {
            loft: x[0],
            attack_angle: x[1],
            carry: carry.unwrap_or_default(),
        },
        flights: objective.flights.get(),
        message,
    })
}

impl Searches {
    /// The loss of each search, m, in ascending order: `best` minus the carry of the search.
    pub fn losses(&self, best: f64) -> Vec<f64> {
        let mut losses: Vec<f64> = self
            .ends
            .iter()
            .map(|search| best - search.end.carry)
            .collect();
        losses.sort_by(f64::total_cmp);
        losses
    }

    /// Number of flights of all searches.
    pub fn flights(&self) -> u64 {
        self.ends.iter().map(|end| end.flights).sum()
    }
}
