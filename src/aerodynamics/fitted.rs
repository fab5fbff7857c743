use crate::units::{Digits, Message, Quantity};

/// The name of what a law was fitted over, its quantity and unit, and the range.
pub type FittedRange = (&'static str, (Quantity, &'static str), Option<[f64; 2]>);

/// A range in words after others: "70000 to 230000", or "at least 71000" where it has no upper end.
pub fn range_in_words(
    before: Message,
    (quantity, unit): (Quantity, &'static str),
    [low, high]: [f64; 2],
) -> Message {
    let digits = Digits::Significant(3);
    if high.is_infinite() {
        return before
            .words("at least ")
            .quantity(quantity, unit, low, digits);
    }
    before
        .quantity(quantity, unit, low, digits)
        .words(" to ")
        .quantity(quantity, unit, high, digits)
}

/// What the measurements cover that a law was fitted to. Outside of it the law's formula goes on as
/// it stands, or a variable is held; nothing tells how well.
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
    /// For each of [`ranges`](Self::ranges), whether the variable is held from about that end on:
    /// below, above. Elsewhere the law is extrapolated.
    pub held: [[bool; 2]; 4],
}

impl Fitted {
    /// Of a law that is fitted to nothing, or whose source does not say to what.
    pub const UNKNOWN: Self = Self {
        spin_ratio: None,
        spin: None,
        reynolds: None,
        speed: None,
        to: "",
        held: [[false; 2]; 4],
    };

    /// The ranges, in the order of a stream: spin ratio, spin, Reynolds number, speed through the
    /// air; each with its name, quantity and unit.
    pub fn ranges(&self) -> [FittedRange; 4] {
        [
            ("spin ratio", (Quantity::NUMBER, ""), self.spin_ratio),
            ("spin", (Quantity::ANGULAR_VELOCITY, "rpm"), self.spin),
            ("Reynolds number", (Quantity::NUMBER, ""), self.reynolds),
            (
                "speed through the air",
                (Quantity::SPEED, "m/s"),
                self.speed,
            ),
        ]
    }

    /// The ranges that are known, in words after others: "spin ratio 0.06 to 0.33, Reynolds number
    /// 70000 to 230000".
    pub fn in_words(&self, before: Message) -> Message {
        let known = self
            .ranges()
            .into_iter()
            .filter_map(|(name, unit, range)| Some((name, unit, range?)));
        known
            .enumerate()
            .fold(before, |message, (i, (name, unit, range))| {
                let comma = if i == 0 { "" } else { ", " };
                range_in_words(message.words(format!("{comma}{name} ")), unit, range)
            })
    }

    /// What becomes of the law beyond these ends of its ranges, below and above: "extrapolated",
    /// "held", or the one here and the other there.
    pub(crate) fn beyond(&self, ends: [[bool; 2]; 4]) -> &'static str {
        let ends = ends
            .as_flattened()
            .iter()
            .zip(self.held.as_flattened())
            .filter(|(is_left, _)| **is_left);
        let (mut held, mut all) = (0, 0);
        for (_, is_held) in ends {
            all += 1;
            held += usize::from(*is_held);
        }
        match held {
            0 => "extrapolated",
            _ if held == all => "held",
            _ => "extrapolated or held",
        }
    }

    /// The ends of its ranges that values lie beyond, below and above, from the least and the
    /// greatest of each.
    pub(crate) fn left(&self, flown: [[f64; 2]; 4]) -> [[bool; 2]; 4] {
        let ranges = self
            .ranges()
            .map(|(.., range)| range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]));
        std::array::from_fn(|k| [flown[k][0] < ranges[k][0], flown[k][1] > ranges[k][1]])
    }

    /// Whether a spin ratio, spin, Reynolds number and speed through the air lie within all ranges
    /// that are known. In no air (a Reynolds number of 0) there is no law to leave.
    #[inline]
    pub fn holds(&self, [spin_ratio, spin, reynolds, speed]: [f64; 4]) -> bool {
        let is_in = |range: Option<[f64; 2]>, value: f64| {
            range.is_none_or(|[low, high]| (low..=high).contains(&value))
        };
        reynolds == 0.0
            || is_in(self.spin_ratio, spin_ratio)
                && is_in(self.spin, spin)
                && is_in(self.reynolds, reynolds)
                && is_in(self.speed, speed)
    }
}
