use crate::report::plot::{Axis, Bar, Figure, Hue, Layer, Measure};
use crate::report::shown::{self, words};
use crate::study::{Difference, Share, Shares};
use crate::units::{System, counted};

/// Maximum number of bars of each split. The note counts the omitted smaller bars.
const MOST: usize = 12;

/// The difference of an outcome between two drives as bars, one for each share, the largest on top.
/// The upper bars are the parameters that differ; the lower bars are the launch conditions and the
/// other inputs of the flight. The note is in the units of `system`.
pub fn difference_figure(difference: &Difference, system: System) -> Figure {
    let of = difference.of;
    let measure = Measure::outcome(of);
    let mut rows = Rows::default();
    let by_parameter = rows.bars(difference, &difference.by_parameter);
    let by_launch = difference.by_launch.as_ref();
    let by_launch = by_launch.map(|split| rows.bars(difference, split));
    let layer = |name: &str, hue: usize, bars: Vec<Bar>| Layer::Bars {
        name: name.into(),
        hue: Hue::Series(hue),
        bars,
    };
    let x = Axis::linear(Measure {
        label: format!("share of the difference of {}", measure.label),
        ..measure.clone()
    });
    let title = format!("Difference of {} between two drives", measure.label);
    let mut figure = Figure::new(
        format!("difference-{}", of.name()),
        title,
        x,
        Axis::names(rows.names),
    )
    .with(layer("by parameter", 2, by_parameter));
    if let Some(bars) = by_launch {
        figure = figure.with(layer("by launch and air", 3, bars));
    }
    let [a, b] = difference.values;
    let mut note = format!(
        "{} of b minus its value of a: {}, from {} to {}. The bars of a colour add up to this \
         difference.",
        super::capital(&measure.label),
        measure.show_difference(difference.amount(), system),
        measure.show(a, system),
        measure.show(b, system),
    );
    if rows.left_out > 0 {
        let left_out = counted(rows.left_out as u64, "smaller share");
        note += &format!(" Not shown: {left_out}.");
    }
    figure.noted(note)
}

/// The rows of an axis that shows names instead of numbers.
#[derive(Default)]
struct Rows {
    names: Vec<String>,
    /// Number of shares without a row.
    left_out: usize,
}

impl Rows {
    /// Adds a row below the others for each of the largest shares of a split, and returns the bars.
    fn bars(&mut self, difference: &Difference, split: &Shares) -> Vec<Bar> {
        let is_rounding =
            |share: &&Share| shown::is_rounding(difference.of, difference.values[0], share.amount);
        let mut shares: Vec<&Share> = split.shares.iter().collect();
        shares.retain(|share| !is_rounding(share));
        shares.sort_by(|a, b| b.amount.abs().total_cmp(&a.amount.abs()));
        self.left_out += shares.len().saturating_sub(MOST);
        shares.truncate(MOST);
        let mut bars = vec![];
        for share in shares {
            bars.push(Bar {
                place: self.names.len(),
                from: 0.0,
                to: share.amount,
            });
            self.names.push(words(share.cause.name()));
        }
        bars
    }
}
