//! Ends and ticks of an axis.

use super::axis::{Axis, AxisScale, NamedQuantity};
use super::text_width::widest;
use crate::units::{System, printed, significant};

/// An axis with its ends and ticks, in the units of `system`. On a logarithmic axis, `low`, `high`
/// and `ticks` are decimal logarithms.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DrawnAxis {
    axis: Axis,
    system: System,
    /// The size of the unit, SI.
    unit: f64,
    /// The number in the unit of the axis for 0 in SI; only temperatures have a number other than
    /// 0.
    zero: f64,
    pub low: f64,
    pub high: f64,
    pub ticks: Vec<f64>,
    /// Number of decimals on a linear axis.
    decimals: usize,
}

impl DrawnAxis {
    /// An axis for these SI values, with about `count` ticks. `None` if the axis can show none of
    /// the values.
    pub fn new(
        axis: &Axis,
        values: impl Iterator<Item = f64>,
        system: System,
        count: usize,
    ) -> Option<Self> {
        let of = axis.quantity.of;
        let mut drawn = Self {
            axis: axis.clone(),
            system,
            unit: of.size_in(system),
            zero: of.quantity.number_in(0.0, system.unit(of.unit)),
            low: 0.0,
            high: 1.0,
            ticks: vec![],
            decimals: 0,
        };
        if let AxisScale::Names(names) = &axis.scale {
            // the first name is on top; `BarRows` draws the names
            (drawn.low, drawn.high) = (names.len() as f64 - 0.5, -0.5);
            return (!names.is_empty()).then_some(drawn);
        }
        let values: Vec<f64> = match axis.range {
            Some(ends) => ends.to_vec(),
            None => values.collect(),
        };
        let mut positions = values.into_iter().filter_map(|value| drawn.position(value));
        let first = positions.next()?;
        let (low, high) = positions.fold((first, first), |(low, high), position| {
            (low.min(position), high.max(position))
        });
        // a single value needs a range with a positive width
        let (low, high) = if high > low {
            (low, high)
        } else {
            (
                low - 0.5 * low.abs().max(1.0),
                high + 0.5 * high.abs().max(1.0),
            )
        };
        (drawn.low, drawn.high) = (low, high);
        match axis.scale {
            AxisScale::Log => drawn.decades(count),
            _ => drawn.even(count),
        }
        if axis.is_reversed {
            (drawn.low, drawn.high) = (drawn.high, drawn.low);
        }
        Some(drawn)
    }

    fn even(&mut self, count: usize) {
        let step = nice_step((self.high - self.low) / count as f64);
        self.decimals = (-step.log10().floor()).max(0.0) as usize;
        if self.axis.range.is_none() {
            // extend each end to the next tick, unless it is at a tick within rounding
            let slack = 1e-9;
            self.low = (self.low / step + slack).floor() * step;
            self.high = (self.high / step - slack).ceil() * step;
        }
        let from = (self.low / step - 1e-9).ceil() as i64;
        let to = (self.high / step + 1e-9).floor() as i64;
        self.ticks = (from..=to).map(|i| i as f64 * step).collect();
    }

    fn decades(&mut self, count: usize) {
        if self.axis.range.is_none() {
            (self.low, self.high) = (self.low.floor(), self.high.ceil());
        }
        let (from, to) = (
            (self.low - 1e-9).ceil() as i64,
            (self.high + 1e-9).floor() as i64,
        );
        let every = ((to - from) as usize).div_ceil(count.max(1)).max(1);
        self.ticks = (from..=to)
            .step_by(every)
            .map(|decade| decade as f64)
            .collect();
    }

    /// The position of an SI value on the axis: the number in the unit of the axis, or its
    /// logarithm. `None` if the axis cannot show the value.
    pub fn position(&self, value: f64) -> Option<f64> {
        let position = match self.axis.scale {
            AxisScale::Names(_) => value,
            AxisScale::Linear | AxisScale::LeftRight => value / self.unit + self.zero,
            AxisScale::Log => (value / self.unit).log10(),
        };
        position.is_finite().then_some(position)
    }

    /// The text of a tick.
    pub fn text(&self, tick: f64) -> String {
        match &self.axis.scale {
            // an axis of names has no ticks
            AxisScale::Linear | AxisScale::Names(_) => {
                format!("{tick:.*}", self.decimals).replace('-', "\u{2212}")
            }
            AxisScale::LeftRight => {
                let side = if tick.abs() < 1e-9 {
                    ""
                } else if tick > 0.0 {
                    " R"
                } else {
                    " L"
                };
                format!("{:.*}{side}", self.decimals, tick.abs())
            }
            AxisScale::Log if (-2.5..=3.5).contains(&tick) => significant(10.0_f64.powf(tick), 3),
            AxisScale::Log => format!("1e{tick:.0}").replace('-', "\u{2212}"),
        }
    }

    /// The title of the axis, with its unit: `carry [yd]`, `club loft [°]`.
    pub fn title(&self) -> String {
        let NamedQuantity { label, of } = &self.axis.quantity;
        let titled = match printed(self.system.unit(of.unit)).as_str() {
            "" => label.clone(),
            unit => format!("{label} [{unit}]"),
        };
        if self.axis.scale == AxisScale::LeftRight {
            format!("L, R: left and {titled}")
        } else {
            titled
        }
    }

    /// The width of the widest text at a tick, pixels.
    pub fn widest(&self) -> f64 {
        widest(self.ticks.iter().map(|tick| self.text(*tick)), false)
    }

    /// True if all adjacent ticks are far enough apart on an axis of this length, pixels. `least`
    /// computes the minimum distance, pixels, from the texts of two ticks.
    pub fn is_readable(&self, length: f64, least: impl Fn(&str, &str) -> f64) -> bool {
        let place = |tick: f64| length * (tick - self.low) / (self.high - self.low);
        self.ticks.windows(2).all(|pair| {
            (place(pair[1]) - place(pair[0])).abs()
                >= least(&self.text(pair[0]), &self.text(pair[1]))
        })
    }
}

/// The smallest number ≥ `step` that is 1, 2 or 5 times a power of ten.
pub(in crate::report) fn nice_step(step: f64) -> f64 {
    round_step(step, &[1.0, 2.0, 5.0, 10.0]).unwrap_or(step)
}

/// The smallest number ≥ `step` that is one of `digits` times a power of ten. `None` if `step` is
/// not positive, or if the result overflows or underflows.
pub(super) fn round_step(step: f64, digits: &[f64]) -> Option<f64> {
    let power = 10.0_f64.powf(step.log10().floor());
    digits
        .iter()
        .map(|digit| digit * power)
        .find(|round| *round >= step * (1.0 - 1e-9) && round.is_finite() && *round > 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::axis::NamedQuantity;
    use super::{Axis, DrawnAxis, System, nice_step};
    use crate::units::Quantity;

    #[test]
    fn steps_are_one_two_or_five() {
        for (step, nice) in [
            (0.9, 1.0),
            (1.1, 2.0),
            (3.0, 5.0),
            (7.0, 10.0),
            (0.03, 0.05),
            (20.0, 20.0),
        ] {
            assert!((nice_step(step) - nice).abs() < 1e-12 * nice, "{step}");
        }
    }

    #[test]
    fn an_axis_ends_on_ticks_in_the_unit_read() {
        let axis = Axis::linear(NamedQuantity::new("carry", Quantity::LENGTH, "yd"));
        let drawn = DrawnAxis::new(&axis, [0.0, 255.3].into_iter(), System::Us, 6).unwrap();
        assert_eq!(
            (drawn.low, drawn.high, drawn.text(50.0), drawn.title()),
            (0.0, 300.0, "50".into(), "carry [yd]".into())
        );
        let drawn = DrawnAxis::new(&axis, [0.0, 255.3].into_iter(), System::Metric, 6).unwrap();
        assert_eq!((drawn.high, drawn.title()), (300.0, "carry [m]".into()));
        let log = Axis::log(NamedQuantity::plain("error"));
        let drawn = DrawnAxis::new(&log, [3e-12, 0.0, 0.5].into_iter(), System::Us, 5).unwrap();
        assert_eq!((drawn.low, drawn.high), (-12.0, 0.0));
        assert_eq!(drawn.position(0.0), None);
        assert!(DrawnAxis::new(&log, [0.0].into_iter(), System::Us, 5).is_none());
    }
}
