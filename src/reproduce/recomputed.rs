use super::delivery::{DeliveryCarry, Ranges, carry_if_flown, with_delivery};
use crate::error::Result;
use crate::optimize::Observers;
use crate::parameters::Setup;
use crate::study::{Optimum, optima};

/// A printed optimum compared with the exact optimum of the same model.
#[derive(Clone, Debug)]
pub struct RecomputedOptimum {
    /// The printed optimum.
    pub printed: DeliveryCarry,
    /// The exact optimum of the varied parameters.
    pub best: Optimum,
    /// Carry that the same model gives for the printed optimum, m; `None` if the ball does not fly.
    pub at_printed: Option<f64>,
}

impl RecomputedOptimum {
    /// Searches from `starts` starting points for the optimum over the parameters `names` within
    /// `ranges`. A loft or attack angle that is not in `names` has its printed value.
    pub(super) fn new(
        setup: &Setup<f64>,
        printed: DeliveryCarry,
        names: &[&str],
        ranges: Ranges,
        starts: usize,
    ) -> Result<Self> {
        let at = with_delivery(setup, printed.loft, printed.attack_angle);
        let search = ranges.longest_carry(setup, names)?;
        let best = optima(&at, &search, starts, &Observers::default())?.best;
        best.check_converged()?;
        Ok(Self {
            printed,
            best,
            at_printed: carry_if_flown(&at)?,
        })
    }

    /// Loss of carry at the printed optimum, m. If the ball does not fly there, this is the whole
    /// carry of the exact optimum.
    pub fn cost(&self) -> f64 {
        self.best.value().unwrap_or_default() - self.at_printed.unwrap_or_default()
    }

    /// Delivery and carry of the exact optimum.
    pub fn exact(&self) -> DeliveryCarry {
        DeliveryCarry::of(&self.best)
    }
}
