use super::mae494::fly_past_the_ground;
use crate::atmosphere::in_effect;
use crate::derivative::check::{Check, Demand, Ladder, STEPS};
use crate::drive::Outcome;
use crate::parameters::{Parameter, Setup};
use crate::study::certificate::Row;

/// Finite differences of the MAE 494 report's flight loop, for a parameter of a certificate.
#[derive(Clone, Debug)]
pub struct LoopRow {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Characteristic size of the parameter, which scales the difference steps.
    pub scale: f64,
    /// Differences of the loop's carry compared with the exact derivative.
    pub check: Check,
}

impl LoopRow {
    /// Difference of the loop's carry at the step nearest to 1e-8 of `scale`, a step that
    /// optimizers use.
    pub fn small_difference(&self) -> Option<f64> {
        let distance = |step: f64| (step / self.scale / 1e-8).ln().abs();
        let nearest = self
            .check
            .curve
            .iter()
            .min_by(|a, b| distance(a.step).total_cmp(&distance(b.step)));
        nearest.map(|point| point.difference)
    }

    /// True if [`small_difference`](Self::small_difference) has the wrong sign.
    pub fn has_wrong_sign(&self) -> bool {
        self.small_difference()
            .is_some_and(|difference| difference * self.check.exact < 0.0)
    }
}

/// Differences of the report's loop for each carry row of a certificate. Empty for setups that the
/// loop does not model: wind, spin damping, or a ground below the tee.
pub fn while_loop(setup: &Setup<f64>, rows: &[Row]) -> Vec<LoopRow> {
    let wind = in_effect(setup).wind;
    let is_calm = [wind.up, wind.right, wind.downrange] == [0.0; 3];
    if !is_calm || setup.aero.spin_damping.is_some() || setup.ground.height != 0.0 {
        return vec![];
    }
    let known = |row: &&Row| {
        row.of == Outcome::Carry
            && !row.parameter.name.starts_with("wind")
            && row.parameter.name != "ground.height"
    };
    rows.iter()
        .filter(known)
        .filter_map(|row| {
            let (parameter, scale) = (row.parameter, row.ladder.scale);
            let mut carry = |x: f64| {
                let mut moved = *setup;
                let flown = moved
                    .set_value(parameter, Some(x))
                    .and_then(|()| moved.validate())
                    .and_then(|()| fly_past_the_ground(&moved, setup.flight.step));
                vec![flown.map_or(f64::NAN, |stop| stop.overshot)]
            };
            let ladder = Ladder::sample(setup.value(parameter)?, scale, STEPS, &mut carry).pop()?;
            Some(LoopRow {
                parameter,
                scale,
                check: ladder.judge(row.first.exact, Demand::FIRST),
            })
        })
        .collect()
}
