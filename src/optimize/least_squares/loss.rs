/// Loss ρ(r) of a residual.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Loss {
    /// Squares: ½ r².
    #[default]
    Squares,
    /// Huber (1964): ½ r² for |r| ≤ k, and k |r| − ½ k² for |r| > k. An outlier has no more
    /// influence than a residual of size k.
    Huber(f64),
}

impl Loss {
    /// Huber's loss with k = 1.345, which has an efficiency of 95 % for normal noise (Huber 1964;
    /// Holland & Welsch 1977).
    pub const HUBER: Self = Self::Huber(1.345);

    /// Loss ρ(r).
    pub fn of(self, r: f64) -> f64 {
        match self {
            Self::Huber(k) if r.abs() > k => k * r.abs() - 0.5 * k * k,
            _ => 0.5 * r * r,
        }
    }

    /// Weight ρ′(r)/r of the residual in the Gauss–Newton model.
    pub fn weight(self, r: f64) -> f64 {
        match self {
            Self::Huber(k) if r.abs() > k => k / r.abs(),
            _ => 1.0,
        }
    }

    /// Second derivative ρ″(r).
    pub fn second_derivative(self, r: f64) -> f64 {
        match self {
            Self::Huber(k) if r.abs() > k => 0.0,
            _ => 1.0,
        }
    }
}
