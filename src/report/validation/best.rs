//! The laws that stand out.

use crate::study::validation::{LawScores, Score, SetScores};

/// The independent law that the default one is held against.
pub(super) const ALTERNATIVE: &str = "ferguson";

/// The smallest mean absolute error of the first quantity of a set, and the law that has it.
pub(super) fn best(set: &SetScores) -> Option<(f64, &'static str)> {
    let of = |law: &LawScores| law.scores.first().and_then(Score::mean_absolute);
    set.laws
        .iter()
        .filter_map(|law| Some((of(law)?, law.law)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}
