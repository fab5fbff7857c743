//! The parameters by which outcomes are differentiated if the user names none.

use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};

/// All parameters by which these outcomes can be differentiated in this setup. If no outcome
/// depends on the run, the parameters that affect only the run are omitted.
pub fn all_variables(setup: &Setup<f64>, of: &[Outcome]) -> Vec<&'static Parameter> {
    let needs_run = of.iter().any(|of| of.needs_run());
    let mut parameters = setup.variables();
    parameters.retain(|parameter| needs_run || !parameter.affects_only_run());
    parameters
}

/// The default parameters of derivatives: loft and attack angle, or the given launch conditions.
///
/// # Errors
/// The errors of [`Setup::variable`].
pub fn default_variables(setup: &Setup<f64>) -> Result<Vec<&'static Parameter>> {
    if setup.launch.is_given() {
        return Ok(setup.given_launch_conditions());
    }
    setup.variables_named(["club.loft", "swing.attack_angle"])
}
