//! The ranges that a fit flies in: what a tolerance is to hold in.

use super::shot_table::ShotTable;
use crate::parameters::Vary;

/// The ranges of the shots' inputs, and those that were given to the parameters fitted. One that is
/// fitted without a range of its own is taken where the setup has it.
pub fn ranges(table: &ShotTable, fit: &[Vary]) -> Vec<Vary> {
    let mut ranges: Vec<Vary> = vec![];
    let mut widen = |parameter, value: f64| match ranges
        .iter_mut()
        .find(|range| range.parameter == parameter)
    {
        Some(range) => (range.low, range.high) = (range.low.min(value), range.high.max(value)),
        None => ranges.push(Vary {
            parameter,
            low: value,
            high: value,
        }),
    };
    for shot in &table.shots {
        for (parameter, value) in &shot.inputs {
            widen(*parameter, *value);
        }
    }
    let is_given = |vary: &&Vary| {
        let own = &vary.parameter.range;
        (vary.low, vary.high) != (own.low, own.high) && (vary.high - vary.low).is_finite()
    };
    ranges.extend(fit.iter().filter(is_given));
    ranges
}
