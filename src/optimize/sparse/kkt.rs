//! Sparse symmetric systems of a quadratic program's KKT conditions, by the LDLᵀ factors of QDLDL (Stellato et al. 2020), which
//! Clarabel brings along: the signs of D are those of the eigenvalues (Sylvester).

use super::symmetric::Symmetric;
use clarabel::qdldl::{QDLDLFactorisation, QDLDLSettings};

/// What is added to the variables' diagonal and taken off that of the multipliers, after balancing, so that no pivot vanishes; it is
/// refined away.
const REGULARIZATION: f64 = 1e-10;
/// Steps of refinement at most.
const REFINEMENTS: u32 = 30;
/// Refinement ends where this part of the right-hand side is left over.
const ENOUGH: f64 = 1e-16;
/// What may be left over of the right-hand side.
const CONTRADICTS: f64 = 1e-10;

/// The factors of [H Nᵀ; N −C], with its rows and columns multiplied by `lengths`.
pub(super) struct Kkt {
    matrix: Symmetric,
    lengths: Vec<f64>,
    factors: QDLDLFactorisation<f64>,
    variables: usize,
}

impl Kkt {
    /// Of so many variables, and multipliers behind them; `None` where it cannot be factorised.
    pub fn new(variables: usize, matrix: &Symmetric) -> Option<Self> {
        let size = matrix.size();
        if size == 0 || !matrix.largest().is_finite() {
            return None;
        }
        let lengths = balance(matrix);
        let balanced =
            Symmetric::sum(size, matrix.entries().map(|(i, j, value)| (i, j, value * lengths[i] * lengths[j])));
        let sign = |i: usize| if i < variables { 1.0 } else { -1.0 };
        let shifts = (0..size).map(|i| (i, i, REGULARIZATION * sign(i)));
        let regularized = Symmetric::sum(size, balanced.entries().chain(shifts));
        let settings = QDLDLSettings { regularize_enable: false, ..QDLDLSettings::default() };
        let factors = QDLDLFactorisation::new(regularized.upper(), Some(settings)).ok()?;
        let is_finite = factors.D.iter().all(|pivot| pivot.is_finite());
        is_finite.then_some(Self { matrix: balanced, lengths, factors, variables })
    }

    /// Whether H is positive definite in the directions that N leaves free (Gould 1985), or H + NᵀC⁻¹N altogether.
    pub fn is_convex(&self) -> bool {
        self.factors.positive_inertia() == self.variables
    }

    /// Solves the system; `None` where its equations contradict each other, or not accurately enough.
    pub fn solve(&mut self, right: &[f64]) -> Option<Vec<f64>> {
        let (x, left) = self.refined(right);
        (left <= CONTRADICTS).then_some(x)
    }

    /// Solves the system as far as that goes; and the part of the right-hand side that is left over.
    pub fn refined(&mut self, right: &[f64]) -> (Vec<f64>, f64) {
        let size = |a: &[f64]| a.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
        let right: Vec<f64> = right.iter().zip(&self.lengths).map(|(right, length)| right * length).collect();
        let whole = size(&right);
        let mut x = vec![0.0; right.len()];
        let (mut rest, mut left) = (right.clone(), whole);
        for _ in 0..REFINEMENTS {
            if left <= ENOUGH * whole {
                break;
            }
            let mut change = rest.clone();
            self.factors.solve(&mut change);
            let better: Vec<f64> = x.iter().zip(&change).map(|(x, change)| x + change).collect();
            let product = self.matrix.times(&better);
            let over: Vec<f64> = right.iter().zip(&product).map(|(right, product)| right - product).collect();
            let over_size = size(&over);
            if !over.iter().all(|over| over.is_finite()) || over_size >= left {
                break;
            }
            (x, rest, left) = (better, over, over_size);
        }
        let part = if whole > 0.0 { left / whole } else { 0.0 };
        (x.iter().zip(&self.lengths).map(|(x, length)| x * length).collect(), part)
    }
}

/// Factors for rows and columns that make the largest entry of each about 1 (Ruiz 2001).
fn balance(matrix: &Symmetric) -> Vec<f64> {
    let mut lengths = vec![1.0; matrix.size()];
    for _ in 0..4 {
        let mut largest = vec![0.0_f64; lengths.len()];
        for (i, j, value) in matrix.entries() {
            let entry = (value * lengths[i] * lengths[j]).abs();
            (largest[i], largest[j]) = (largest[i].max(entry), largest[j].max(entry));
        }
        for (length, largest) in lengths.iter_mut().zip(largest).filter(|(_, largest)| *largest > 0.0) {
            *length /= largest.sqrt();
        }
    }
    lengths
}
