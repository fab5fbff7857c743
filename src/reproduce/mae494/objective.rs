//! Objective of the searches on the report's problem.

use super::printed;
use super::while_loop::fly_past_the_ground;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::Result;
use crate::optimize::{Domain, Taylor};
use crate::parameters::Setup;
use crate::reproduce::delivery::{ATTACK_ANGLE, LOFT, Ranges, carry, with_delivery};
use serde::Serialize;
use std::cell::Cell;

/// Definition of the landing point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Landing"))]
#[serde(rename_all = "lowercase")]
pub enum LandingDefinition {
    /// The last step of the report's time loop, which is below the ground.
    #[serde(rename = "loop")]
    Overshot,
    /// Interpolated between the last two steps of the report's loop.
    Interpolated,
    /// The landing of this library's flight, a smooth function of the delivery.
    Smooth,
}

/// Optimization method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Method"))]
pub enum SearchMethod {
    /// argmin's L-BFGS with the Moré–Thuente line search; gradients by forward differences.
    #[serde(rename = "lbfgs-differences")]
    LimitedMemory,
    /// argmin's L-BFGS with exact gradients.
    #[serde(rename = "lbfgs-exact-gradients")]
    LimitedMemoryExact,
    /// This library's optimizer with a BFGS Hessian; gradients by forward differences.
    #[serde(rename = "longdrive-differences")]
    QuasiNewton,
    /// This library's optimizer with exact gradients and Hessians.
    #[serde(rename = "longdrive-exact")]
    Exact,
}

/// The report's ranges of loft and attack angle, rad.
pub(super) fn domain() -> Result<Domain> {
    let Ranges { loft, attack_angle } = printed::RANGES;
    let ends = |end: usize| vec![loft[end].to_radians(), attack_angle[end].to_radians()];
    Domain::new(ends(0), ends(1))
}

/// The objective −carry as a function of loft and attack angle. It counts the flights.
pub(super) struct CarryObjective<'a> {
    pub setup: &'a Setup<f64>,
    landing: LandingDefinition,
    pub method: SearchMethod,
    pub domain: Domain,
    /// The exact derivatives; `None` for a method that uses differences.
    exact: Option<Evaluator>,
    pub flights: Cell<u64>,
}

impl<'a> CarryObjective<'a> {
    pub fn new(
        setup: &'a Setup<f64>,
        landing: LandingDefinition,
        method: SearchMethod,
    ) -> Result<Self> {
        let wrt = [setup.variable(LOFT)?, setup.variable(ATTACK_ANGLE)?];
        let order = match method {
            SearchMethod::Exact => Some(Order::Second),
            SearchMethod::LimitedMemoryExact => Some(Order::First),
            SearchMethod::LimitedMemory | SearchMethod::QuasiNewton => None,
        };
        let exact = order
            .map(|order| Evaluator::new(setup, &[Outcome::Carry], &wrt, order))
            .transpose()?;
        Ok(Self {
            setup,
            landing,
            method,
            domain: domain()?,
            exact,
            flights: Cell::new(0),
        })
    }

    /// −carry.
    pub fn value(&self, x: &[f64]) -> Result<f64> {
        self.flights.set(self.flights.get() + 1);
        let at = with_delivery(self.setup, x[0], x[1]);
        Ok(-match self.landing {
            LandingDefinition::Overshot => fly_past_the_ground(&at, at.flight.step)?.overshot,
            LandingDefinition::Interpolated => {
                fly_past_the_ground(&at, at.flight.step)?.interpolated
            }
            LandingDefinition::Smooth => carry(&at)?,
        })
    }

    /// −carry with the derivatives that `method` uses.
    pub fn taylor(&self, x: &[f64]) -> Result<Taylor> {
        if let Some(exact) = &self.exact {
            self.flights.set(self.flights.get() + 1);
            let mut carry = exact.at(x)?;
            return Ok(carry.swap_remove(0).negated());
        }
        let value = self.value(x)?;
        let slope = |i: usize| {
            // forward difference as in fmincon, backward at the upper bound
            let step = f64::EPSILON.sqrt();
            let step = if x[i] + step <= self.domain.variables.high[i] {
                step
            } else {
                -step
            };
            let mut moved = x.to_vec();
            moved[i] += step;
            Ok((self.value(&moved)? - value) / step)
        };
        Ok(Taylor {
            value,
            gradient: (0..x.len()).map(slope).collect::<Result<_>>()?,
            hessian: vec![],
        })
    }
}
