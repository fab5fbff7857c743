//! The reproduction of the MAE 494 report, as a document and as JSON.

mod noise;
mod physics;
mod searches;
mod tables;

use super::document::Document;
use super::json::{ByName, Number};
use super::optimum::Multipliers;
use super::published::{DeliveryPoint, LoftCarry, Published};
use super::reply::Report;
use crate::reproduce::{
    Average, Delivery, Energy, Launched, Mae494, Noise, Parametric, Peak, Regression, Row,
    Searches, Subsystems,
};
use crate::units::System;
use serde::Serialize;

const STUDY: &str = "mae494";

/// The reproduction of the report, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Mae494Report<'a> {
    #[serde(skip)]
    found: &'a Mae494,
    /// `mae494`.
    #[cfg_attr(test, schemars(extend("const" = STUDY)))]
    pub study: &'static str,
    /// The optimum of the report's regression, which evaluates its fitted polynomial with wrong
    /// powers.
    pub slipped_optimum: DeliveryPoint,
    /// The optimum of the report's model.
    pub optimum: OptimumRow,
    /// The optimum at each attack angle of Table 1.
    pub table1: Vec<TableRow>,
    /// The optimum at each loft of Table 2.
    pub table2: Vec<TableRow>,
    /// The loft with the best average carry.
    pub average: AverageReport,
    /// The optimum of the report's regression.
    pub regression: RegressionReport,
    /// The energy of club and ball.
    pub energy: EnergyReport,
    /// Optima of impact and flight, separately.
    pub subsystems: SubsystemsReport,
    /// The sensitivity of the optimum to the constants.
    pub parametric: ParametricReport,
    /// The noise of the while-loop.
    pub noise: NoiseReport,
    /// The numbers that the report prints.
    pub printed: PrintedReport,
}

/// An optimum with the multipliers of its bounds.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OptimumRow {
    /// The optimum.
    #[serde(flatten)]
    pub at: DeliveryPoint,
    /// The multipliers of the bounds, by parameter.
    pub multipliers: ByName<Multipliers>,
    /// The active bounds, `lower` or `upper`, and constraints, `null`.
    pub active: ByName<Option<crate::study::BoundSide>>,
}

/// A row of a table: the exact optimum, and the carry at the printed optimum.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TableRow {
    /// The exact optimum.
    #[serde(flatten)]
    pub optimum: OptimumRow,
    /// The carry at the printed optimum, m.
    pub carry_at_printed: Number,
    /// The carry lost at the printed optimum, m.
    pub cost: Number,
}

/// The loft with the best average carry over the attack angles.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct AverageReport {
    /// The best loft and its average carry.
    #[serde(flatten)]
    pub best: LoftCarry,
    /// The average carry of each loft.
    pub rows: Vec<LoftCarry>,
}

/// The maximum of the report's polynomial in loft, for three choices of powers.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct RegressionReport {
    /// The maximum with the wrong powers, as in the report's listing.
    pub slipped: PeakReport,
    /// The maximum with the fitted powers.
    pub as_fitted: PeakReport,
    /// The maximum of the polynomial with the powers 0 to 4 through the same points.
    pub ordinary: PeakReport,
}

/// The maximum of a polynomial.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PeakReport {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// The distance, m.
    pub distance: f64,
}

/// A launch with its carry.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LaunchedReport {
    /// The ball speed, m/s.
    pub ball_speed: f64,
    /// The launch angle, rad.
    pub launch_angle: f64,
    /// The backspin, rad/s.
    pub backspin: f64,
    /// The carry, m.
    pub carry: f64,
}

/// The energy of club and ball.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct EnergyReport {
    /// The largest ball speed of any delivery, m/s.
    pub fastest_ball_speed: f64,
    /// The launch of the longest carry.
    pub farthest: LaunchedReport,
    /// The derivative of carry by ball speed, s.
    pub carry_per_ball_speed: f64,
    /// The launch needed for the report's carry.
    pub needed: LaunchedReport,
    /// The energy of the club, J.
    pub club_energy: f64,
    /// The energy of the ball, J.
    pub ball_energy: f64,
    /// The energy of the ball that the report's carry needs, J.
    pub ball_energy_needed: f64,
}

/// Optima of impact and flight, separately.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SubsystemsReport {
    /// The launch of the optimum.
    pub whole: LaunchedReport,
    /// The optimum of the flight.
    pub flight: LaunchedReport,
    /// The optimal delivery for the impact.
    pub impact: DeliveryPoint,
    /// The derivative of carry by each launch condition, SI.
    pub carry_by: ByName<Number>,
    /// The derivative of carry by loft through each launch condition, m/rad.
    pub carry_by_loft_through: ByName<Number>,
    /// The derivative of carry by attack angle through each launch condition, m/rad.
    pub carry_by_attack_angle_through: ByName<Number>,
}

/// The sensitivity of the optimum to the constants.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ParametricReport {
    /// Each constant.
    pub sensitivity: Vec<ConstantReport>,
    /// The optima after changes of a constant.
    pub changes: Vec<ChangeReport>,
}

/// The sensitivity of the optimum to a constant.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ConstantReport {
    /// The constant.
    pub parameter: &'static str,
    /// The value of the constant, SI.
    pub at: f64,
    /// The derivative of the carry, SI.
    pub value: f64,
    /// The derivative of the optimum, SI.
    pub optimum: ByName<f64>,
}

/// The optimum after a change of a constant.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ChangeReport {
    /// The constant.
    pub parameter: &'static str,
    /// The change of the constant, SI.
    pub change: f64,
    /// The optimum by derivatives.
    pub predicted: ChangedOptimum,
    /// The optimum of a new search.
    pub resolved: ChangedOptimum,
}

/// An optimum after a change.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ChangedOptimum {
    /// The carry, m.
    pub value: Number,
    /// The varied parameters, rad.
    pub optimum: ByName<f64>,
}

/// The noise of the while-loop, from its landing.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct NoiseReport {
    /// The attack angle, rad.
    #[serde(rename = "swing.attack_angle")]
    pub attack_angle: f64,
    /// The time step, s.
    pub step: f64,
    /// The step of the finite differences by loft, rad.
    pub difference: f64,
    /// The steps (teeth) in the curve of carry over loft.
    pub teeth: TeethReport,
    /// The derivative of carry by loft at each loft, m/rad.
    pub slopes: Vec<SlopesReport>,
    /// Number of lofts where the sign of the difference is wrong.
    pub wrong_signs: usize,
    /// The finite difference of the while-loop for shorter time steps.
    pub shorter_steps: Vec<ShorterStep>,
    /// The finite differences for longer steps of the loft.
    pub longer_differences: Vec<LongerDifference>,
    /// Carry over a small range of loft.
    pub zoom: Vec<LandingReport>,
    /// Searches for each way to compute the landing and each method.
    pub searches: Vec<SearchesReport>,
}

/// The steps (teeth) in the curve of carry over loft.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TeethReport {
    /// The number of teeth.
    pub count: usize,
    /// The width of a tooth, rad.
    pub width: f64,
    /// The height of a tooth, m.
    pub height: f64,
}

/// The derivative of carry by loft, by each method.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SlopesReport {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// The exact derivative, m/rad.
    pub exact: f64,
    /// The derivative with a constant landing time, m/rad.
    pub at_fixed_time: f64,
    /// The finite difference of the while-loop, m/rad.
    #[serde(rename = "loop")]
    pub overshot: f64,
    /// The finite difference of the while-loop with an interpolated landing, m/rad.
    pub interpolated: f64,
    /// True if the sign of the while-loop's finite difference is wrong.
    pub sign_is_wrong: bool,
}

/// The while-loop's finite difference for a shorter time step.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ShorterStep {
    /// The time step, s.
    pub step: f64,
    /// The finite difference of the while-loop, m/rad.
    #[serde(rename = "loop")]
    pub overshot: f64,
}

/// The finite differences for a longer step of the loft.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LongerDifference {
    /// The step of the loft, rad.
    pub difference: f64,
    /// The finite difference of the while-loop, m/rad.
    #[serde(rename = "loop")]
    pub overshot: f64,
    /// The finite difference with an interpolated landing, m/rad.
    pub interpolated: f64,
    /// The finite difference with the smooth landing, m/rad.
    pub smooth: f64,
}

/// The carry at a loft, for each way to compute the landing.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LandingReport {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// The carry of the while-loop, m.
    #[serde(rename = "loop")]
    pub overshot: f64,
    /// The carry with an interpolated landing, m.
    pub interpolated: f64,
    /// The carry with the smooth landing, m.
    pub smooth: f64,
}

/// Searches with one way to compute the landing and one method.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SearchesReport {
    /// The way to compute the landing.
    pub landing: &'static str,
    /// The method.
    pub method: &'static str,
    /// The results of the search from each start.
    pub ends: Vec<EndReport>,
}

/// The result of a search.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct EndReport {
    /// The start.
    pub start: DeliveryPoint,
    /// The end.
    pub end: DeliveryPoint,
    /// Number of flights.
    pub flights: u64,
    /// The message of the method.
    pub message: String,
}

/// The numbers in the printed report.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PrintedReport {
    /// The printed optimum at the attack angle of the regression: the last row of Table 1.
    pub slipped_optimum: Option<DeliveryPoint>,
    /// The optimum.
    pub optimum: DeliveryPoint,
    /// Table 1.
    pub table1: Vec<DeliveryPoint>,
    /// Table 2.
    pub table2: Vec<DeliveryPoint>,
    /// The loft with the best average carry.
    pub average: ByName<f64>,
}

impl<'a> Mae494Report<'a> {
    /// The report of this reproduction.
    pub fn new(found: &'a Mae494) -> Self {
        let rows = |rows: &[Row]| rows.iter().map(TableRow::new).collect();
        let printed = |rows: &[Row]| rows.iter().map(|row| row.printed.into()).collect();
        let slipped = found.table1.last();
        Self {
            found,
            study: STUDY,
            slipped_optimum: found.slipped.into(),
            optimum: OptimumRow::new(&found.optimum),
            table1: rows(&found.table1),
            table2: rows(&found.table2),
            average: AverageReport::new(&found.average),
            regression: RegressionReport::new(&found.regression),
            energy: EnergyReport::new(&found.energy),
            subsystems: SubsystemsReport::new(&found.subsystems),
            parametric: ParametricReport::new(&found.parametric),
            noise: NoiseReport::new(&found.noise, &found.searches),
            printed: PrintedReport {
                slipped_optimum: slipped.map(|row| row.printed.into()),
                optimum: found.optimum.printed.into(),
                table1: printed(&found.table1),
                table2: printed(&found.table2),
                average: [("club.loft", found.average.printed)].into_iter().collect(),
            },
        }
    }
}

impl Report for Mae494Report<'_> {
    const COMMAND: &'static str = "reproduce";

    /// Computed numbers in the units of `system`. Printed numbers are in the units of the report,
    /// with the units of `system` in parentheses.
    fn document(&self, system: System) -> Document {
        let found = self.found;
        let shown = Published {
            paper: Mae494::UNITS,
            system,
        };
        let mut document = Document::new("The MAE 494 report, reproduced");
        document.paragraph(
            "A student report of the course MAE 494, \"Optimization of a Golf Driver\", repeated \
             Winfield & Tan (1994). Here its constants are used in \
             Winfield & Tan's equations (the preset mae494), and each printed number is compared with \
             what that model gives. All numbers \
             except the printed ones are computed by this command.",
        );
        tables::optimum(&mut document, found, shown);
        tables::tables(&mut document, found, shown);
        tables::average(&mut document, found, shown);
        tables::regression(&mut document, found, shown);
        physics::energy(&mut document, found, shown);
        physics::subsystems(&mut document, found, shown);
        physics::parametric(&mut document, found, shown);
        noise::noise(&mut document, &found.noise, shown);
        searches::searches(&mut document, found, shown);
        document
    }
}

impl From<Delivery> for DeliveryPoint {
    fn from(delivery: Delivery) -> Self {
        Self {
            loft: delivery.loft.into(),
            attack_angle: delivery.attack_angle.into(),
            carry: delivery.carry.into(),
        }
    }
}

impl From<Launched> for LaunchedReport {
    fn from(launched: Launched) -> Self {
        Self {
            ball_speed: launched.speed,
            launch_angle: launched.angle,
            backspin: launched.spin,
            carry: launched.carry,
        }
    }
}

impl From<Peak> for PeakReport {
    fn from(peak: Peak) -> Self {
        Self {
            loft: peak.loft,
            distance: peak.distance,
        }
    }
}

impl OptimumRow {
    fn new(row: &Row) -> Self {
        let solution = &row.best.solution;
        let vary = row.best.search.vary.iter().enumerate();
        let multipliers = vary.map(|(i, vary)| {
            let multipliers = Multipliers {
                lower: solution.lower_multipliers[i],
                upper: solution.upper_multipliers[i],
            };
            (vary.parameter.name, multipliers)
        });
        let active = row.active.iter();
        Self {
            at: row.exact().into(),
            multipliers: multipliers.collect(),
            active: active
                .map(|active| (active.name.clone(), active.end))
                .collect(),
        }
    }
}

impl TableRow {
    fn new(row: &Row) -> Self {
        Self {
            optimum: OptimumRow::new(row),
            carry_at_printed: row.at_printed.into(),
            cost: row.cost().into(),
        }
    }
}

impl AverageReport {
    fn new(average: &Average) -> Self {
        let row = |(loft, carry): (f64, f64)| LoftCarry { loft, carry };
        Self {
            best: row(average.best),
            rows: average.rows.iter().copied().map(row).collect(),
        }
    }
}

impl RegressionReport {
    fn new(regression: &Regression) -> Self {
        Self {
            slipped: regression.slipped.into(),
            as_fitted: regression.as_fitted.into(),
            ordinary: regression.ordinary.into(),
        }
    }
}

impl EnergyReport {
    fn new(energy: &Energy) -> Self {
        Self {
            fastest_ball_speed: energy.fastest,
            farthest: energy.farthest.into(),
            carry_per_ball_speed: energy.price_of_speed,
            needed: energy.needed.into(),
            club_energy: energy.club,
            ball_energy: energy.ball,
            ball_energy_needed: energy.ball_needed,
        }
    }
}

impl SubsystemsReport {
    fn new(subsystems: &Subsystems) -> Self {
        let by_quantity = |parts: [f64; 3]| {
            let names = ["ball_speed", "launch_angle", "backspin"];
            names.into_iter().zip(parts).collect()
        };
        Self {
            whole: subsystems.whole.into(),
            flight: subsystems.flight.into(),
            impact: subsystems.impact.into(),
            carry_by: by_quantity(subsystems.slopes),
            carry_by_loft_through: by_quantity(subsystems.by_loft),
            carry_by_attack_angle_through: by_quantity(subsystems.by_attack_angle),
        }
    }
}

impl ParametricReport {
    fn new(study: &Parametric) -> Self {
        let sensitivity = study.sensitivities.iter().map(|constant| {
            let sensitivity = &constant.sensitivity;
            let names = ["club.loft", "swing.attack_angle"];
            ConstantReport {
                parameter: sensitivity.parameter.name,
                at: constant.value,
                value: sensitivity.value,
                optimum: names
                    .into_iter()
                    .zip([sensitivity.optimum[0], sensitivity.optimum[1]])
                    .collect(),
            }
        });
        let loft = |loft: f64| [("club.loft", loft)].into_iter().collect();
        let changes = study.changes.iter().map(|changed| ChangeReport {
            parameter: changed.change.parameter.name,
            change: changed.change.delta,
            predicted: ChangedOptimum {
                value: changed.second_order.into(),
                optimum: loft(changed.predicted[0]),
            },
            resolved: ChangedOptimum {
                value: changed.resolved.value().into(),
                optimum: loft(changed.resolved.solution.x[0]),
            },
        });
        Self {
            sensitivity: sensitivity.collect(),
            changes: changes.collect(),
        }
    }
}

impl NoiseReport {
    fn new(noise: &Noise, searches: &[Searches]) -> Self {
        let slopes = noise.slopes.iter().map(|at| SlopesReport {
            loft: at.loft,
            exact: at.exact,
            at_fixed_time: at.at_fixed_time,
            overshot: at.overshot,
            interpolated: at.interpolated,
            sign_is_wrong: at.overshot * at.exact < 0.0,
        });
        let shorter_steps = noise
            .shorter_steps
            .iter()
            .map(|&(step, overshot)| ShorterStep { step, overshot });
        let longer_differences = noise
            .longer_differences
            .iter()
            .map(|&(difference, slopes)| {
                let [overshot, interpolated, smooth] = slopes;
                LongerDifference {
                    difference,
                    overshot,
                    interpolated,
                    smooth,
                }
            });
        let zoom = noise.zoom.iter().map(|at| LandingReport {
            loft: at.loft,
            overshot: at.overshot,
            interpolated: at.interpolated,
            smooth: at.smooth,
        });
        Self {
            attack_angle: 0.0,
            step: noise.step,
            difference: noise.difference,
            teeth: TeethReport {
                count: noise.teeth.count,
                width: noise.teeth.width,
                height: noise.teeth.height,
            },
            slopes: slopes.collect(),
            wrong_signs: noise.wrong_signs(),
            shorter_steps: shorter_steps.collect(),
            longer_differences: longer_differences.collect(),
            zoom: zoom.collect(),
            searches: searches.iter().map(SearchesReport::new).collect(),
        }
    }
}

impl SearchesReport {
    fn new(searches: &Searches) -> Self {
        let ends = searches.ends.iter().map(|end| EndReport {
            start: end.start.into(),
            end: end.at.into(),
            flights: end.flights,
            message: end.message.clone(),
        });
        Self {
            landing: searches.landing.name(),
            method: searches.method.name(),
            ends: ends.collect(),
        }
    }
}
