use super::analysis::SwingsAnalysis;
use super::bootstrap_optimum::BootstrapOptimum;

/// Results of a search over swings in addition to the optimum.
#[derive(Clone, Debug)]
pub struct OverSwings {
    /// The best design for the mean swing, and the estimated errors of the goals.
    pub analysis: Option<SwingsAnalysis>,
    /// The optima of resamples of recorded swings.
    pub resampled: Option<BootstrapOptimum>,
}
