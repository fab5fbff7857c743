use crate::units::Quantity;

/// The name of what a law was fitted over, its quantity and unit, and the range.
pub type FittedRange = (&'static str, (Quantity, &'static str), Option<[f64; 2]>);

/// What the measurements cover that a law was fitted to. Outside of it the law's formula goes on as it stands, and nothing tells how well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// Spin ratios s = R|ω|/|v|.
    pub spin_ratio: Option<[f64; 2]>,
    /// Reynolds numbers.
    pub reynolds: Option<[f64; 2]>,
    /// Speeds through the air, m/s.
    pub speed: Option<[f64; 2]>,
    /// What it was fitted to.
    pub to: &'static str,
}

impl Fitted {
    /// Of a law that is fitted to nothing, or whose source does not say to what.
    pub const UNKNOWN: Self = Self { spin_ratio: None, reynolds: None, speed: None, to: "" };

    /// The ranges, in the order of a stream: spin ratio, Reynolds number, speed through the air; each with its name, quantity and unit.
    pub fn ranges(&self) -> [FittedRange; 3] {
        [
            ("spin ratio", (Quantity::NUMBER, ""), self.spin_ratio),
            ("Reynolds number", (Quantity::NUMBER, ""), self.reynolds),
            ("speed through the air", (Quantity::SPEED, "m/s"), self.speed),
        ]
    }

    /// Whether a spin ratio, Reynolds number and speed through the air lie within all ranges that are known. In no air (a Reynolds
    /// number of 0) there is no law to leave.
    pub fn holds(&self, [spin_ratio, reynolds, speed]: [f64; 3]) -> bool {
        let is_in = |range: Option<[f64; 2]>, value: f64| range.is_none_or(|[low, high]| (low..=high).contains(&value));
        reynolds == 0.0
            || is_in(self.spin_ratio, spin_ratio) && is_in(self.reynolds, reynolds) && is_in(self.speed, speed)
    }
}
