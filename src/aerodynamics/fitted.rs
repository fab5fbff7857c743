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
}
