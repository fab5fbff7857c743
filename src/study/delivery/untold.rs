use crate::parameters::Parameter;
use nalgebra::{DMatrix, SymmetricEigen};

/// Below this part of the variance that a shot removes along a direction it does not tell the
/// direction.
const HALF: f64 = 0.5;
/// A parameter whose part of a direction is smaller than this is left out of it.
const SMALL: f64 = 0.1;

/// A change of parameters together that leaves the launch as it is, or nearly so.
#[derive(Clone, Debug, PartialEq)]
pub struct Untold {
    /// What part of the variance along it the shot has removed: less than a half.
    pub told: f64,
    /// Each parameter with its change, SI: one standard uncertainty before the shot in all, the
    /// first positive.
    pub changes: Vec<(&'static Parameter, f64)>,
}

/// The directions that a launch does not tell, by the eigenvectors of what it tells, each parameter
/// in units of its uncertainty before. `jacobian` are the slopes of the residuals by parameters in
/// these units.
pub(super) fn untold(jacobian: &DMatrix<f64>, sought: &[(&'static Parameter, f64)]) -> Vec<Untold> {
    // where bounds hold every parameter, nothing is left to tell apart
    if sought.is_empty() {
        return vec![];
    }
    let SymmetricEigen {
        eigenvalues,
        eigenvectors,
    } = (jacobian.transpose() * jacobian).symmetric_eigen();
    let mut all: Vec<Untold> = (0..sought.len())
        .map(|k| {
            let eigenvalue = eigenvalues[k].max(0.0);
            let direction = eigenvectors.column(k);
            let part = sought.iter().zip(direction.iter());
            let large: Vec<_> = part.filter(|(_, part)| part.abs() >= SMALL).collect();
            let sign = large.first().map_or(1.0, |(_, part)| part.signum());
            let changes = large
                .into_iter()
                .map(|((parameter, sigma), part)| (*parameter, sign * part * sigma));
            Untold {
                told: eigenvalue / (1.0 + eigenvalue),
                changes: changes.collect(),
            }
        })
        .filter(|untold| untold.told < HALF)
        .collect();
    all.sort_by(|a, b| a.told.total_cmp(&b.told));
    all
}
