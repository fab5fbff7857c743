use super::kkt::Kkt;
use super::symmetric::Symmetric;
use crate::optimize::known::SparseDerivatives;
use crate::optimize::scaling::{Point, Scaling};

/// Multipliers larger than this, in units of φ, are those of slopes that nearly depend on each other (Wächter & Biegler 2006, section 3.6).
const LARGEST: f64 = 1e3;

/// The multipliers to begin with: those of the equations that leave least of the Lagrangian's gradient, in scaled variables (least
/// squares); 0 for all others, and where they would be very large. With many variables and a linear objective a search that begins with
/// none knows of no curvature, and its first step leads far from where the linearised constraints mean anything.
pub(in crate::optimize) fn first_multipliers(
    scaling: &Scaling,
    at: &Point,
    derivatives: &SparseDerivatives,
) -> Vec<f64> {
    let mut multipliers = vec![0.0; derivatives.constraints.len()];
    let domain = &scaling.domain;
    let free: Vec<usize> = (0..at.x.len()).filter(|&i| !domain.variables.is_fixed(i)).collect();
    let equations: Vec<usize> = (0..multipliers.len()).filter(|&j| domain.constraints.is_fixed(j)).collect();
    let mut place = vec![None; at.x.len()];
    free.iter().enumerate().for_each(|(k, &i)| place[i] = Some(k));
    let mut entries: Vec<_> = (0..free.len()).map(|k| (k, k, 1.0)).collect();
    for (k, &j) in equations.iter().enumerate() {
        let slopes = derivatives.constraints[j].gradient.iter();
        let normal = slopes.map(|(i, slope)| (*i, slope * scaling.scale[*i] / scaling.gamma[j]));
        entries.extend(normal.filter_map(|(i, a)| Some((place[i]?, free.len() + k, a))));
    }
    let size = scaling.size(at);
    let mut right: Vec<f64> = free.iter().map(|&i| -at.f.objective.gradient[i] * scaling.scale[i]).collect();
    right.resize(free.len() + equations.len(), 0.0);
    let solution = Kkt::new(free.len(), &Symmetric::sum(right.len(), entries)).and_then(|mut kkt| kkt.solve(&right));
    if let Some(found) = solution.map(|solution| solution[free.len()..].to_vec())
        && found.iter().all(|multiplier| multiplier.abs() <= LARGEST * size)
    {
        equations.iter().zip(found).for_each(|(&j, multiplier)| multipliers[j] = multiplier / scaling.gamma[j]);
    }
    multipliers
}
