use super::lbfgs::search_by_lbfgs;
use super::tables::{carried, carried_if_flown};
use super::while_loop::fly_past_the_ground;
use super::{ATTACK_ANGLE, Delivery, LOFT, printed};
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::Result;
use crate::optimize::{Domain, Evaluation, Options, Taylor, minimize, starts};
use crate::parameters::Setup;
use std::cell::Cell;

/// Where the ball is taken to land.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Landing {
    /// Where the report's loop stops, below the ground.
    Overshot,
    /// Interpolated between the last two steps of that loop.
    Interpolated,
    /// The smooth landing.
    Smooth,
}

impl Landing {
    /// Its name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Overshot => "loop",
            Self::Interpolated => "interpolated",
            Self::Smooth => "smooth",
        }
    }
}

/// How the best drive is searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// argmin's L-BFGS with the line search of Moré and Thuente; gradients by forward differences.
    LimitedMemory,
    /// The same with exact gradients.
    LimitedMemoryExact,
    /// This library's optimizer with a Hessian of its own making (BFGS); gradients by forward differences.
    QuasiNewton,
    /// This library's optimizer with exact gradients and Hessians.
    Exact,
}

impl Method {
    /// Its name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::LimitedMemory => "lbfgs-differences",
            Self::LimitedMemoryExact => "lbfgs-exact-gradients",
            Self::QuasiNewton => "longdrive-differences",
            Self::Exact => "longdrive-exact",
        }
    }
}

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
    for x in starts(&domain, &[setup.club.loft, setup.swing.attack_angle], 8 * STARTS)? {
        let start = Delivery { loft: x[0], attack_angle: x[1], carry: 0.0 };
        if let Some(carry) = carried_if_flown(&start.set(setup))? {
            begun.push(Delivery { carry, ..start });
        }
    }
    begun.truncate(STARTS);
    let one = |(landing, method): (Landing, Method)| {
        let ends = begun.iter().map(|start| Sought::new(setup, landing, method)?.search(*start));
        Ok(Searches { landing, method, ends: ends.collect::<Result<_>>()? })
    };
    KINDS.into_iter().map(one).collect()
}

/// The report's ranges of loft and attack angle.
fn domain() -> Result<Domain> {
    let [loft, attack] = [printed::LOFT, printed::ATTACK].map(|ends| ends.map(f64::to_radians));
    Domain::new(vec![loft[0], attack[0]], vec![loft[1], attack[1]])
}

/// −carry over loft and attack angle, counting the flights.
pub(super) struct Sought<'a> {
    setup: &'a Setup<f64>,
    landing: Landing,
    method: Method,
    pub domain: Domain,
    exact: Evaluator,
    flights: Cell<u64>,
}

impl<'a> Sought<'a> {
    fn new(setup: &'a Setup<f64>, landing: Landing, method: Method) -> Result<Self> {
        let wrt = [setup.variable(LOFT)?, setup.variable(ATTACK_ANGLE)?];
        let order = if method == Method::Exact { Order::Second } else { Order::First };
        let exact = Evaluator::new(setup, &[Outcome::Carry], &wrt, order)?;
        Ok(Self { setup, landing, method, domain: domain()?, exact, flights: Cell::new(0) })
    }

    fn search(&self, start: Delivery) -> Result<End> {
        let x = [start.loft, start.attack_angle];
        let (x, message) = match self.method {
            Method::LimitedMemory | Method::LimitedMemoryExact => search_by_lbfgs(self, &x),
            Method::QuasiNewton | Method::Exact => {
                let problem = |x: &[f64]| {
                    let objective = self.taylor(x).map_err(|error| error.to_string())?;
                    Ok(Evaluation { objective, constraints: vec![] })
                };
                let found = minimize(&problem, &self.domain, &x, &Options::default())?;
                (found.x, format!("{}: {}", found.status, found.message))
            }
        };
        let at = Delivery { loft: x[0], attack_angle: x[1], carry: 0.0 };
        let at = Delivery { carry: carried_if_flown(&at.set(self.setup))?.unwrap_or_default(), ..at };
        Ok(End { start, at, flights: self.flights.get(), message })
    }

    /// −carry.
    pub fn value(&self, x: &[f64]) -> Result<f64> {
        self.flights.set(self.flights.get() + 1);
        let at = Delivery { loft: x[0], attack_angle: x[1], carry: 0.0 }.set(self.setup);
        Ok(-match self.landing {
            Landing::Overshot => fly_past_the_ground(&at, at.flight.step)?.overshot,
            Landing::Interpolated => fly_past_the_ground(&at, at.flight.step)?.interpolated,
            Landing::Smooth => carried(&at)?,
        })
    }

    /// −carry with the derivatives that the method asks for.
    pub fn taylor(&self, x: &[f64]) -> Result<Taylor> {
        if matches!(self.method, Method::Exact | Method::LimitedMemoryExact) {
            self.flights.set(self.flights.get() + 1);
            let mut carry = self.exact.at(x)?;
            return Ok(carry.swap_remove(0).negated());
        }
        let value = self.value(x)?;
        let slope = |i: usize| {
            // forward as fmincon's, backward where that would leave the range
            let step = f64::EPSILON.sqrt();
            let step = if x[i] + step <= self.domain.variables.high[i] { step } else { -step };
            let mut moved = x.to_vec();
            moved[i] += step;
            Ok((self.value(&moved)? - value) / step)
        };
        Ok(Taylor { value, gradient: (0..x.len()).map(slope).collect::<Result<_>>()?, hessian: vec![] })
    }
}

impl Searches {
    /// How many ended within so many metres of the best carry.
    pub fn within(&self, distance: f64, best: f64) -> usize {
        self.ends.iter().filter(|end| best - end.at.carry <= distance).count()
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
