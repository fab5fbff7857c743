use crate::report::compare::by_size;
use crate::report::plot::{Axis, Figure, HorizontalBar, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown::{self, capital, words};
use crate::study::Difference;
use crate::units::{System, counted};

/// Maximum number of bars of one colour. The bars by parameter and the bars by launch and air have
/// different colours. The note counts the omitted smaller bars.
const MOST: usize = 12;

/// The difference of an outcome between two drives as bars, one for each share, the largest on top.
/// The upper bars are the parameters that differ; the lower bars are the launch conditions and the
/// other inputs of the flight. The note is in the units of `system`.
pub fn difference_figure(difference: &Difference, system: System) -> Figure {
    let of = difference.of;
    let quantity = NamedQuantity::outcome(of);
    let by_launch = difference.by_launch.as_ref();
    let splits = [("by parameter", 2, &difference.by_parameter)]
        .into_iter()
        .chain(by_launch.map(|split| ("by launch and air", 3, split)));
    let (mut names, mut layers, mut left_out) = (vec![], vec![], 0);
    for (name, hue, split) in splits {
        let (mut shares, _) = by_size(difference, split);
        left_out += shares.len().saturating_sub(MOST);
        shares.truncate(MOST);
        let bars = (names.len()..)
            .zip(&shares)
            .map(|(row, share)| HorizontalBar {
                row,
                to: share.amount,
            });
        layers.push(Layer::new(
            name,
            Hue::Series(hue),
            Shape::Bars(bars.collect()),
        ));
        names.extend(shares.iter().map(|share| words(share.cause.name())));
    }
    let x = Axis::linear(NamedQuantity {
        label: format!("share of the difference of {}", quantity.label),
        ..quantity.clone()
    });
    let mut figure = Figure::new(
        system,
        format!("difference-{}", of.name()),
        format!("Difference of {} between two drives", quantity.label),
        x,
        Axis::names(names),
    );
    figure.layers = layers;
    let [a, b] = difference.values;
    let mut note = format!(
        "{} of b minus its value of a: {}, from {} to {}. The bars of a colour add up to this \
         difference.",
        capital(&quantity.label),
        shown::difference(of, difference.amount(), system),
        quantity.of.read_off(a, system),
        quantity.of.read_off(b, system),
    );
    if left_out > 0 {
        let left_out = counted(left_out as u64, "smaller share");
        note += &format!(" Not shown: {left_out}.");
    }
    figure.noted(note)
}
