use crate::error::Result;
use crate::parameters::Preset;
use crate::report::setup_toml;
use crate::study::calibrate::Calibration;

/// The fitted setup as a setup file in TOML, to the last digit, the fitted parameters with their standard errors.
///
/// # Errors
/// As [`setup_toml`].
pub fn calibration_toml(found: &Calibration, preset: &Preset, data: &str) -> Result<String> {
    let about = [format!("{}, fitted to {data}", preset.name), format!("{}: {}", found.fit.status, found.fit.message)];
    let remarks = found.estimates.iter().map(|estimate| {
        let parameter = estimate.parameter;
        let error = match estimate.standard_error {
            Some(error) => format!("± {}", parameter.show(Some(error))),
            None => "without a standard error".into(),
        };
        (parameter, format!("fitted to {data}: {} {error}", parameter.show(Some(estimate.value))))
    });
    setup_toml(&found.setup, preset, &about, &remarks.collect::<Vec<_>>())
}
