//! The published points to which the laws were fitted.

use super::AerodynamicLaw;
use crate::parameters::{Law, LawTable, LawVariable};
use std::f64::consts::PI;

/// A measured point. `spin_ratio` or `reynolds` is `None` if the source does not state it, for
/// instance because the coefficients are means over this quantity.
pub(crate) struct MeasuredCoefficients {
    /// The spin ratio.
    pub spin_ratio: Option<f64>,
    /// The Reynolds number.
    pub reynolds: Option<f64>,
    /// C_D and C_L.
    pub values: [Option<f64>; 2],
}

impl Law<f64> {
    /// The published points to which a law was fitted, or the nodes of a user's table. Empty for a
    /// law whose points are not in `tests/data`. `reynolds_per_speed` is Re/|v|, s/m, and `radius`
    /// that of the ball, m.
    pub(crate) fn measured_points(
        &self,
        reynolds_per_speed: f64,
        radius: f64,
    ) -> Vec<MeasuredCoefficients> {
        let fitted = self.properties().fitted;
        let of_speed = |speed: f64, spin: f64, values: [f64; 2]| MeasuredCoefficients {
            spin_ratio: Some(spin * radius / speed),
            reynolds: Some(reynolds_per_speed * speed),
            values: values.map(Some),
        };
        match self {
            Law::BearmanHarvey(_) => rows(include_str!("../../tests/data/bearman_harvey_1976.csv"))
                .filter(|[speed, ..]| fitted.speed.is_none_or(|[_, most]| *speed <= most))
                .map(|[speed, rpm, drag, lift]| of_speed(speed, rpm * PI / 30.0, [drag, lift]))
                .collect(),
            Law::NaruoMizota(_) => rows(include_str!("../../tests/data/naruo_2004.csv"))
                .map(|[s, drag, lift, _]| MeasuredCoefficients {
                    spin_ratio: Some(s),
                    reynolds: None,
                    values: [Some(drag), Some(lift)],
                })
                .collect(),
            // lift is the mean of several balls at each spin ratio, without a Reynolds number; drag
            // is that of one ball at each Reynolds number, without a spin ratio
            Law::Lyu(_) => cells(include_str!("../../tests/data/lyu_2018.csv"))
                .map(|[reynolds, spin_ratio, drag, lift]| MeasuredCoefficients {
                    spin_ratio,
                    reynolds,
                    values: [drag, lift],
                })
                .collect(),
            Law::UsgaItr(_) => rows(include_str!("../../tests/data/usga_itr_test_ball.csv"))
                .map(|[re, s, drag, lift]| MeasuredCoefficients {
                    spin_ratio: Some(s),
                    reynolds: Some(re),
                    values: [Some(drag), Some(lift)],
                })
                .collect(),
            Law::Table(law) => tabulated(law.table, reynolds_per_speed, radius),
            Law::Robinson(_)
            | Law::Linear(_)
            | Law::SmitsSmith(_)
            | Law::Ferguson(_)
            | Law::LaunchMonitor(_)
            | Law::WinfieldTan(_)
            | Law::MacdonaldHanzely(_)
            | Law::Nathan(_) => vec![],
        }
    }
}

fn tabulated(table: &LawTable, reynolds_per_speed: f64, radius: f64) -> Vec<MeasuredCoefficients> {
    let has = |variable: LawVariable| table.axes().any(|axis| axis.variable == variable);
    let node = |[speed, spin, drag, lift]: &[f64; 4]| {
        let reynolds = if has(LawVariable::Reynolds) {
            Some(*speed)
        } else {
            has(LawVariable::Speed).then_some(reynolds_per_speed * speed)
        };
        // the spin ratio follows from the spin if the speed is known
        let at_speed = reynolds.map(|reynolds| reynolds / reynolds_per_speed);
        let by_spin = at_speed
            .filter(|_| has(LawVariable::Spin))
            .map(|speed| spin * radius / speed);
        let spin_ratio = if has(LawVariable::SpinRatio) {
            Some(*spin)
        } else {
            by_spin
        };
        MeasuredCoefficients {
            spin_ratio,
            reynolds,
            values: [Some(*drag), Some(*lift)],
        }
    };
    table.nodes.iter().map(node).collect()
}

/// The rows of a table of numbers, without its head. Only the first four cells of a row are read. A
/// row is omitted if one of these cells is empty.
fn rows(table: &str) -> impl Iterator<Item = [f64; 4]> + '_ {
    cells(table).filter_map(|[a, b, c, d]| Some([a?, b?, c?, d?]))
}

/// Rows of a table whose cells may be empty.
fn cells(table: &str) -> impl Iterator<Item = [Option<f64>; 4]> + '_ {
    table.lines().skip(1).map(|line| {
        let mut cells = line.split(',').map(|cell| cell.trim().parse::<f64>().ok());
        std::array::from_fn(|_| cells.next().flatten())
    })
}
