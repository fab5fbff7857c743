use super::mae494::fly_past_the_ground;
use crate::atmosphere::in_effect;
use crate::derivative::check::{Check, Demand, Ladder, STEPS};
use crate::drive::Outcome;
use crate::parameters::{Parameter, Setup};
use crate::study::certificate::Row;

/// What differences make of the MAE 494 report's while-loop, by a parameter by which carry was
/// certified.
#[derive(Clone, Debug)]
pub struct LoopRow {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The size of the parameter: steps are parts of it.
    pub scale: f64,
    /// Differences of the loop's carry beside the exact derivative of carry.
    pub check: Check,
}

impl LoopRow {
    /// The plain difference of the loop's carry at the step nearest to 1e-8 of the scale: what an
    /// optimizer takes.
    pub fn small_difference(&self) -> Option<f64> {
        let distance = |step: f64| (step / self.scale / 1e-8).ln().abs();
        let nearest = self
            .check
            .curve
            .iter()
            .min_by(|a, b| distance(a.step).total_cmp(&distance(b.step)));
        nearest.map(|point| point.difference)
    }

    /// Whether that difference points the other way than carry goes.
    pub fn has_wrong_sign(&self) -> bool {
        self.small_difference()
            .is_some_and(|difference| difference * self.check.exact < 0.0)
    }
}

/// The report's loop, which stops at the first step below the ground, under the differences of a
/// certificate: for each row of carry, those of the loop. Nothing where there is what the loop does
/// not know: wind, damping of the spin by the air, a ground that is not at the tee.
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
