use crate::units::{Digits, Message, Quantity};

/// The name of what a law was fitted over, its quantity and unit, and the range.
pub type FittedRange = (&'static str, (Quantity, &'static str), Option<[f64; 2]>);

/// A range in words after others: "70000 to 230000", or "at least 71000" where it has no upper end.
pub fn range_in_words(before: Message, (quantity, unit): (Quantity, &'static str), [low, high]: [f64; 2]) -> Message {
    let digits = Digits::Significant(3);
    if high.is_infinite() {
        return before.words("at least ").quantity(quantity, unit, low, digits);
    }
    before.quantity(quantity, unit, low, digits).words(" to ").quantity(quantity, unit, high, digits)
}

/// What the measurements cover that a law was fitted to. Outside of it the law's formula goes on as it stands, and nothing tells how well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// Spin ratios s = R|ω|/|v|.
    pub spin_ratio: Option<[f64; 2]>,
    /// Spins |ω|, rad/s.
    pub spin: Option<[f64; 2]>,
    /// Reynolds numbers.
    pub reynolds: Option<[f64; 2]>,
    /// Speeds through the air, m/s.
    pub speed: Option<[f64; 2]>,
    /// What it was fitted to.
    pub to: &'static str,
}

impl Fitted {
    /// Of a law that is fitted to nothing, or whose source does not say to what.
    pub const UNKNOWN: Self = Self { spin_ratio: None, spin: None, reynolds: None, speed: None, to: "" };

    /// The ranges, in the order of a stream: spin ratio, spin, Reynolds number, speed through the air; each with its name, quantity and unit.
    pub fn ranges(&self) -> [FittedRange; 4] {
        [
            ("spin ratio", (Quantity::NUMBER, ""), self.spin_ratio),
            ("spin", (Quantity::ANGULAR_VELOCITY, "rpm"), self.spin),
            ("Reynolds number", (Quantity::NUMBER, ""), self.reynolds),
            ("speed through the air", (Quantity::SPEED, "m/s"), self.speed),
        ]
    }

    /// The ranges that are known, in words after others: "spin ratio 0.06 to 0.33, Reynolds number 70000 to 230000".
    pub fn in_words(&self, before: Message) -> Message {
        let known = self.ranges().into_iter().filter_map(|(name, unit, range)| Some((name, unit, range?)));
        known.enumerate().fold(before, |message, (i, (name, unit, range))| {
            let comma = if i == 0 { "" } else { ", " };
            range_in_words(message.words(format!("{comma}{name} ")), unit, range)
        })
    }

    /// Whether a spin ratio, spin, Reynolds number and speed through the air lie within all ranges that are known. In no air (a Reynolds
    /// number of 0) there is no law to leave.
    #[inline]
    pub fn holds(&self, [spin_ratio, spin, reynolds, speed]: [f64; 4]) -> bool {
        let is_in = |range: Option<[f64; 2]>, value: f64| range.is_none_or(|[low, high]| (low..=high).contains(&value));
        reynolds == 0.0
            || is_in(self.spin_ratio, spin_ratio)
                && is_in(self.spin, spin)
                && is_in(self.reynolds, reynolds)
                && is_in(self.speed, speed)
    }
}
