//! Tables of weights of the Runge–Kutta methods (docs/model.md, eq. 16).

use crate::parameters::Method;

/// Non-zero weights of a stage, as (j, aᵢⱼ). The last row of a method has the weights bⱼ.
type Weights = &'static [(usize, f64)];

/// Kutta (1901), the classical method of order 4.
const RK4_ROWS: &[Weights] = &[
    &[],
    &[(0, 0.5)],
    &[(1, 0.5)],
    &[(2, 1.0)],
    &[
        (0, 1.0 / 6.0),
        (1, 1.0 / 3.0),
        (2, 1.0 / 3.0),
        (3, 1.0 / 6.0),
    ],
];

/// Hairer, Nørsett & Wanner (1993), Solving Ordinary Differential Equations I, DOP853: the 12
/// stages of the formula of order 8.
#[rustfmt::skip]
const DP8_ROWS: &[Weights] = & [
    &[],
    &[(0, 0.05260015195876773)],
    &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
    &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
    &[(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)],
    &[(0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242)],
    &[(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)],
    &[(0, 0.03709200011850479), (3, 0.17038392571223998), (4, 0.10726203044637328), (5, -0.015319437748624402), (6, 0.008273789163814023)],
    &[(0, 0.6241109587160757), (3, -3.3608926294469414), (4, -0.868219346841726), (5, 27.59209969944671), (6, 20.154067550477894), (7, -43.48988418106996)],
    &[(0, 0.47766253643826434), (3, -2.4881146199716677), (4, -0.590290826836843), (5, 21.230051448181193), (6, 15.279233632882423), (7, -33.28821096898486), (8, -0.020331201708508627)],
    &[(0, -0.9371424300859873), (3, 5.186372428844064), (4, 1.0914373489967295), (5, -8.149787010746927), (6, -18.52006565999696), (7, 22.739487099350505), (8, 2.4936055526796523), (9, -3.0467644718982196)],
    &[(0, 2.273310147516538), (3, -10.53449546673725), (4, -2.0008720582248625), (5, -17.9589318631188), (6, 27.94888452941996), (7, -2.8589982771350235), (8, -8.87285693353063), (9, 12.360567175794303), (10, 0.6433927460157636)],
    &[(0, 0.054293734116568765), (5, 4.450312892752409), (6, 1.8915178993145003), (7, -5.801203960010585), (8, 0.3111643669578199), (9, -0.1521609496625161), (10, 0.20136540080403034), (11, 0.04471061572777259)],
];

/// Largest number of stages of a method.
pub(super) const MOST_STAGES: usize = 12;

/// An explicit Runge–Kutta method for x″ = a(t, x, x′). Positions, like velocities, are weighted
/// sums of accelerations. The weights of the positions follow from the weights of the velocities.
#[derive(Debug)]
pub(super) struct Tableau {
    /// Largest relative change of the airspeed by drag and lift within a step. The stages do not
    /// resolve larger changes; much larger changes make the method unstable.
    pub largest_relative_change: f64,
    /// Number of stages. The end of the step is an additional stage with the weights bⱼ.
    pub stages: usize,
    /// aᵢⱼ: weights of the accelerations in the velocity of stage i, without zeros.
    pub velocity_weights: [Weights; MOST_STAGES + 1],
    /// Entry j of stage i is (j, Σₖ aᵢₖ aₖⱼ): weight of acceleration j in the position of stage i.
    /// Entries from j = i − 1 on are (0, 0).
    pub position_weights: [[(usize, f64); MOST_STAGES]; MOST_STAGES + 1],
    /// cᵢ = Σⱼ aᵢⱼ: time of stage i, in steps.
    pub times: [f64; MOST_STAGES + 1],
}

static RK4: Tableau = Tableau::new(RK4_ROWS, 0.5);
static DP8: Tableau = Tableau::new(DP8_ROWS, 1.0);

impl Tableau {
    /// The tableau of a method.
    pub fn of(method: Method) -> &'static Self {
        match method {
            Method::Rk4 => &RK4,
            Method::DormandPrince8 => &DP8,
        }
    }

    // indexed loops: a const fn cannot use iterators
    const fn new(rows: &[Weights], largest_relative_change: f64) -> Self {
        let stages = rows.len() - 1;
        let mut velocity_weights: [Weights; MOST_STAGES + 1] = [&[]; MOST_STAGES + 1];
        let mut position_weights = [[(0, 0.0); MOST_STAGES]; MOST_STAGES + 1];
        let mut times = [0.0; MOST_STAGES + 1];
        let mut i = 0;
        while i <= stages {
            velocity_weights[i] = rows[i];
            let mut term = 0;
            while term < velocity_weights[i].len() {
                let (k, weight) = velocity_weights[i][term];
                times[i] += weight;
                let mut inner = 0;
                while inner < velocity_weights[k].len() {
                    let (j, inner_weight) = velocity_weights[k][inner];
                    position_weights[i][j] = (j, position_weights[i][j].1 + weight * inner_weight);
                    inner += 1;
                }
                term += 1;
            }
            i += 1;
        }
        Self {
            largest_relative_change,
            stages,
            velocity_weights,
            position_weights,
            times,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DP8, RK4};

    /// Order conditions of a method of order p: Σ bᵢ cᵢᵏ⁻¹ = 1/k and Σ bᵢ aᵢⱼ cⱼᵏ⁻² = 1/(k (k − 1))
    /// for k ≤ p (Hairer, Nørsett & Wanner 1993).
    #[test]
    fn exact_quadrature_conditions_of_each_order() {
        for (order, tableau) in [(4, &RK4), (8, &DP8)] {
            for k in 1..=order {
                let power = |i: usize, n: i32| {
                    if n == 0 {
                        1.0
                    } else {
                        tableau.times[i].powi(n)
                    }
                };
                let velocity: f64 = tableau.velocity_weights[tableau.stages]
                    .iter()
                    .map(|&(i, weight)| weight * power(i, k - 1))
                    .sum();
                assert!(
                    (velocity - 1.0 / f64::from(k)).abs() < 1e-14,
                    "order {k}: {velocity}"
                );
                if k >= 2 {
                    let weights = &tableau.position_weights[tableau.stages][..tableau.stages];
                    let position: f64 = weights
                        .iter()
                        .map(|&(j, weight)| weight * power(j, k - 2))
                        .sum();
                    assert!(
                        (position - 1.0 / f64::from(k * (k - 1))).abs() < 1e-14,
                        "order {k}: {position}"
                    );
                }
            }
        }
    }
}
