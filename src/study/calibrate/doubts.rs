//! What deserves a word about a fit that came to an end.

use super::calibration::{Calibration, Estimate};
use super::shot_table::ShotTable;
use super::statistics::Uncertainties;
use crate::optimize::least_squares::Status;
use crate::units::{Message, counted, significant};

/// Values that miss a fit by so many of their standard uncertainties (root mean square, with as
/// many degrees of freedom) are not described by it: noise makes this 1.
const MUCH: f64 = 3.0;

impl Calibration {
    /// Warnings about the fit: what the table is taken for, a model that does not describe it, a
    /// value that a bound holds, and an interval that reaches to what cannot be.
    pub fn warnings(&self, table: &ShotTable) -> Vec<Message> {
        let of_values = self
            .estimates
            .iter()
            .filter_map(|estimate| self.of_value(estimate));
        self.of_table(table)
            .into_iter()
            .chain(self.of_sum(table))
            .chain(of_values)
            .collect()
    }

    /// A club beside measured launches, where nothing of the impact is fitted: the launch is then
    /// computed, and measured too.
    fn of_table(&self, table: &ShotTable) -> Option<Message> {
        let [launch, club] = table.launch_beside_club.as_ref()?;
        let is_of_flight = self
            .estimates
            .iter()
            .all(|estimate| !estimate.parameter.is_of_strike());
        is_of_flight.then(|| {
            format!(
                "the rows are read as deliveries of a club, since the table has {club}: each \
                 launch is computed by the impact, and {launch} are \
                 measured values that it is compared with; to fly the measured launches, leave \
                 {club} out"
            )
            .into()
        })
    }

    /// Values that miss the fit by far more than their uncertainties.
    fn of_sum(&self, table: &ShotTable) -> Option<Message> {
        let (chi, freedom) = (
            self.statistics.chi_square,
            self.statistics.degrees_of_freedom,
        );
        // a misfit and an outlier are told as how the fit ended
        let is_told = !matches!(self.fit.status, Status::Outweighed | Status::Misfit);
        let is_told = is_told && table.uncertainties != Uncertainties::Weights;
        let off = self
            .statistics
            .misfit()
            .filter(|off| is_told && *off > MUCH)?;
        Some(
            format!(
                "the values miss the fit by {} of their standard uncertainties (root mean square; \
                 χ² = {} with {} of freedom), where noise makes \
                 1: the fitted model does not describe them, or their uncertainties are too small; \
                 look at the largest residuals",
                significant(off, 3),
                significant(chi, 5),
                counted(freedom as u64, "degree")
            )
            .into(),
        )
    }

    fn of_value(&self, estimate: &Estimate) -> Option<Message> {
        let (parameter, name) = (estimate.parameter, estimate.parameter.name);
        let show = |value: f64| parameter.show(Some(value));
        if estimate.is_at_bound && estimate.is_determined {
            let ends = [parameter.range.low, parameter.range.high];
            let advice = match ends.contains(&estimate.value) {
                true => "the end of what it may be: the fitted model does not describe the data",
                false => {
                    "the end of its range: the sum would fall further beyond it; give it a wider \
                     range, or look at the data"
                }
            };
            return Some(format!("{name} ended at {}, {advice}", show(estimate.value)).into());
        }
        let reach = self.statistics.reach * estimate.standard_error?;
        let interval = [estimate.value - reach, estimate.value + reach];
        let is_beyond = interval
            .iter()
            .any(|end| *end < parameter.range.low || *end > parameter.range.high);
        is_beyond.then(|| {
            let [low, high] = interval.map(show);
            let allowed = parameter.range.show(parameter.quantity, parameter.unit);
            format!(
                "the 95 % interval of {name}, {low} to {high}, reaches beyond what it may be \
                 ({allowed}): the data tell little of it; measure \
                 more, or fit less"
            )
            .into()
        })
    }
}
