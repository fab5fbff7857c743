/// Actual and predicted reduction of the merit by a step.
///
/// Both sides of each comparison carry the rounding of the functions, so that a step within
/// rounding is accepted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reduction {
    /// φ(x) − φ(x + d).
    pub actual: f64,
    /// What the model says of it.
    pub predicted: f64,
    /// The merit's size, by which rounding is measured.
    pub size: f64,
}

/// Rounding of the functions, relative to their sizes φ and γ.
pub(super) const NOISE: f64 = 1e-14;
/// Reductions up to this, relative to the merit's size, are little more than rounding.
const NEARLY_NOISE: f64 = 1e-10;
/// Steps are accepted for at least this ratio of actual to predicted reduction (Conn, Gould & Toint
/// 2000, §6.1: any small positive number) …
const ACCEPT: f64 = 1e-4;
/// … are poor below this, and good above the next.
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// A model is exact if it predicts the reduction to this part.
const EXACT: f64 = 1e-9;

impl Reduction {
    pub fn is_acceptable(&self) -> bool {
        self.ratio_is_at_least(ACCEPT)
    }

    pub fn is_poor(&self) -> bool {
        !self.ratio_is_at_least(POOR)
    }

    pub fn is_good(&self) -> bool {
        self.actual > GOOD * self.predicted
    }

    /// Whether the model predicts the reduction to rounding.
    pub fn is_exact(&self) -> bool {
        (self.actual - self.predicted).abs() <= EXACT * self.predicted.abs()
    }

    pub fn is_nearly_rounding(&self) -> bool {
        let most = NEARLY_NOISE * self.size;
        self.predicted <= most && self.actual.abs() <= most
    }

    fn ratio_is_at_least(&self, ratio: f64) -> bool {
        let noise = NOISE * self.size;
        self.actual + noise >= ratio * (self.predicted + noise)
    }
}
