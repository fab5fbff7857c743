use crate::error::Result;
use crate::json::{by_name, number};
use crate::parameters::Parameter;
use crate::reproduce::RecomputedOptimum;
use crate::reproduce::delivery::{ATTACK_ANGLE, LOFT};
use crate::study::{Change, change, sensitivity};
use serde::Serialize;

/// Parametric study that the report proposes: influence of its constants on the optimum.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ParametricReport"))]
pub struct Parametric {
    /// Each constant.
    // sorted by the change of carry for a change of 1 %, the largest first
    #[serde(rename = "sensitivity")]
    pub sensitivities: Vec<Constant>,
    /// The optima after changes of a constant.
    pub changes: Vec<ConstantChange>,
}

/// The optimum after a change of a constant.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ChangeReport"))]
pub struct ConstantChange {
    /// The constant.
    pub parameter: &'static Parameter,
    /// The change of the constant, SI.
    pub change: f64,
    /// The optimum that the derivatives predict.
    pub predicted: ChangedOptimum,
    /// The optimum from a new search with the changed constant.
    pub resolved: ChangedOptimum,
}

/// An optimum after a change.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ChangedOptimum {
    /// The carry, m.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub value: Option<f64>,
    /// The varied parameters, rad.
    // only the loft: the best attack angle stays at its bound
    #[serde(serialize_with = "by_name")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<String, f64>"))]
    pub optimum: [(&'static str, f64); 1],
}

impl ChangedOptimum {
    /// The best loft, rad.
    pub fn loft(&self) -> f64 {
        let [(_, loft)] = self.optimum;
        loft
    }
}

/// The sensitivity of the optimum to a constant.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(
    test,
    derive(schemars::JsonSchema),
    schemars(rename = "ConstantReport")
)]
pub struct Constant {
    /// The constant.
    pub parameter: &'static Parameter,
    /// The value of the constant, SI.
    pub at: f64,
    /// The derivative of the optimal carry by the constant, SI.
    pub value: f64,
    /// The derivatives of the optimal parameters by the constant, SI.
    #[serde(serialize_with = "by_name")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<String, f64>"))]
    pub optimum: [(&'static str, f64); 2],
}

impl Constant {
    /// Change of the best carry if the constant increases by 1 %, m.
    pub fn carry_per_cent(&self) -> f64 {
        0.01 * self.at * self.value
    }

    /// Change of the best loft if the constant increases by 1 %, rad.
    pub fn loft_per_cent(&self) -> f64 {
        let [(_, loft), _] = self.optimum;
        0.01 * self.at * loft
    }
}

/// Constants of the model, including coefficients of the aerodynamic law.
const CONSTANTS: [&str; 17] = [
    "swing.speed",
    "club.mass",
    "club.cg_depth",
    "club.inertia.xx",
    "club.inertia.yy",
    "club.inertia.zz",
    "ball.mass",
    "ball.radius",
    "ball.inertia",
    "impact.restitution",
    "air.density",
    "gravity",
    "aero.spin_decay",
    "aero.cd0",
    "aero.cd1",
    "aero.cl_max",
    "aero.cl_rate",
];

/// Relative changes of constants that the report proposes.
const CHANGES: [(&str, f64); 4] = [
    ("ball.mass", -0.1),
    ("ball.mass", 0.1),
    ("club.inertia.yy", -0.1),
    ("club.inertia.yy", 0.1),
];

impl Parametric {
    /// The parametric study at `optimum`.
    pub(super) fn new(optimum: &RecomputedOptimum) -> Result<Self> {
        let best = &optimum.best;
        let constant = |name: &&str| {
            let parameter = best.setup.variable(name)?;
            let found = sensitivity(best, parameter)?;
            Ok(Constant {
                parameter,
                at: best.setup.value(parameter).unwrap_or_default(),
                value: found.value,
                optimum: [(LOFT, found.optimum[0]), (ATTACK_ANGLE, found.optimum[1])],
            })
        };
        let mut sensitivities = CONSTANTS.iter().map(constant).collect::<Result<Vec<_>>>()?;
        sensitivities.sort_by(|a, b| {
            b.carry_per_cent()
                .abs()
                .total_cmp(&a.carry_per_cent().abs())
        });
        let changed = |(name, part): &(&str, f64)| {
            let parameter = best.setup.variable(name)?;
            let delta = part * best.setup.value(parameter).unwrap_or_default();
            let changed = change(best, Change { parameter, delta }, &Ok)?;
            Ok(ConstantChange {
                parameter,
                change: delta,
                predicted: ChangedOptimum {
                    value: Some(changed.second_order),
                    optimum: [(LOFT, changed.predicted[0])],
                },
                resolved: ChangedOptimum {
                    value: changed.resolved.value(),
                    optimum: [(LOFT, changed.resolved.solution.x[0])],
                },
            })
        };
        Ok(Self {
            sensitivities,
            changes: CHANGES.iter().map(changed).collect::<Result<_>>()?,
        })
    }
}
