use super::delivery::Delivery;
use super::lbfgs::search_by_lbfgs;
use super::sought::{Landing, Method, Sought, domain};
use super::tables::carried_if_flown;
use crate::error::Result;
use crate::optimize::{Evaluation, Options, minimize, starts};
use crate::parameters::Setup;

/// Searches of one kind, from the same starts as all others.
#[derive(Clone, Debug)]
pub struct Searches {
    /// The landing searched on.
    pub landing: Landing,
    /// The method.
    pub method: Method,
    /// How each ended, in the order of the starts.
    pub ends: Vec<End>,
}

/// How a search ended.
#[derive(Clone, Debug)]
pub struct End {
    /// Where it began.
    pub start: Delivery,
    /// Where it ended, with the carry of the smooth landing there.
    pub at: Delivery,
    /// Flights asked for; one with exact derivatives counts once.
    pub flights: u64,
    /// How the method says that it ended.
    pub message: String,
}

/// How many starts.
const STARTS: usize = 20;

/// What is searched, and how.
const KINDS: [(Landing, Method); 7] = [
    (Landing::Overshot, Method::LimitedMemory),
    (Landing::Interpolated, Method::LimitedMemory),
    (Landing::Smooth, Method::LimitedMemoryExact),
    (Landing::Overshot, Method::QuasiNewton),
    (Landing::Interpolated, Method::QuasiNewton),
    (Landing::Smooth, Method::QuasiNewton),
    (Landing::Smooth, Method::Exact),
];

/// All kinds of searches from the same starts, every one of which flies.
pub(super) fn searches(setup: &Setup<f64>) -> Result<Vec<Searches>> {
    let domain = domain()?;
    let mut begun = vec![];
    for x in starts(
        &domain,
        &[setup.club.loft, setup.swing.attack_angle],
        8 * STARTS,
    )? {
        let start = Delivery {
            loft: x[0],
            attack_angle: x[1],
            carry: 0.0,
        };
        if let Some(carry) = carried_if_flown(&start.set(setup))? {
            begun.push(Delivery { carry, ..start });
        }
    }
    begun.truncate(STARTS);
    let one = |(landing, method): (Landing, Method)| {
        let ends = begun
            .iter()
            .map(|start| search(&Sought::new(setup, landing, method)?, *start));
        Ok(Searches {
            landing,
            method,
            ends: ends.collect::<Result<_>>()?,
        })
    };
    KINDS.into_iter().map(one).collect()
}

/// A search from a start.
fn search(sought: &Sought<'_>, start: Delivery) -> Result<End> {
    let x = [start.loft, start.attack_angle];
    let (x, message) = match sought.method {
        Method::LimitedMemory | Method::LimitedMemoryExact => search_by_lbfgs(sought, &x),
        Method::QuasiNewton | Method::Exact => {
            let problem = |x: &[f64]| {
                let objective = sought.taylor(x).map_err(|error| error.to_string())?;
                Ok(Evaluation {
                    objective,
                    constraints: vec![],
                })
            };
            let found = minimize(&problem, &sought.domain, &x, &Options::default())?;
            (found.x, format!("{}: {}", found.status, found.message))
        }
    };
    let at = Delivery {
        loft: x[0],
        attack_angle: x[1],
        carry: 0.0,
    };
    let at = Delivery {
        carry: carried_if_flown(&at.set(sought.setup))?.unwrap_or_default(),
        ..at
    };
    Ok(End {
        start,
        at,
        flights: sought.flights.get(),
        message,
    })
}

impl Searches {
    /// How many ended within so many metres of the best carry.
    pub fn within(&self, distance: f64, best: f64) -> usize {
        self.ends
            .iter()
            .filter(|end| best - end.at.carry <= distance)
            .count()
    }

    /// What the ends miss of the best carry, m, least first.
    pub fn missed(&self, best: f64) -> Vec<f64> {
        let mut missed: Vec<f64> = self.ends.iter().map(|end| best - end.at.carry).collect();
        missed.sort_by(f64::total_cmp);
        missed
    }

    /// Flights asked for, all searches together.
    pub fn flights(&self) -> u64 {
        self.ends.iter().map(|end| end.flights).sum()
    }
}
