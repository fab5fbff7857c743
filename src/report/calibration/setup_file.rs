use super::to_its_error;
use crate::error::Result;
use crate::parameters::Preset;
use crate::report::setup_toml;
use crate::report::shown::as_declared;
use crate::study::calibrate::{Calibration, Estimate};

/// The fitted setup as a setup file in TOML, to the last digit, the fitted parameters with their
/// standard errors.
///
/// # Errors
/// As [`setup_toml`].
pub fn calibration_toml(found: &Calibration, preset: &Preset, data: &str) -> Result<String> {
    let about = [
        format!("{}, fitted to {data}", preset.name),
        format!("{}: {}", found.fit.status, found.fit.message),
    ];
    let remarks = found.estimates.iter().map(|estimate| {
        let Estimate {
            parameter,
            value,
            standard_error,
            ..
        } = *estimate;
        let (quantity, unit) = (parameter.quantity, parameter.unit);
        let value = match standard_error {
            Some(error) => {
                let number = |value: f64| to_its_error(quantity, unit, value, standard_error);
                let show = |value: f64| format!("{} {unit}", number(value)).trim_end().to_owned();
                format!("{} ± {}", show(value), show(error))
            }
            None => format!("{} without a standard error", as_declared(parameter, value)),
        };
        (parameter, format!("fitted to {data}: {value}"))
    });
    setup_toml(&found.setup, preset, &about, &remarks.collect::<Vec<_>>())
}
