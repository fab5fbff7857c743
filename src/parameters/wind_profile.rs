//! Warnings about a wind profile without effect or meaning.

use super::table::Setup;
use crate::units::Message;

impl Setup<f64> {
    /// Warning about a roughness or reference height without effect, and about a wind stated below
    /// the roughness. Valid for a single drive only, so not part of [`warnings`](Self::warnings):
    /// if wind or roughness varies from drive to drive, they have an effect.
    pub fn wind_profile_warning(&self) -> Option<Message> {
        let wind = &self.wind;
        let stated = self.parameter("wind.reference_height").ok()?;
        let Some(roughness) = wind.roughness else {
            let is_usual = stated
                .default_value()
                .is_none_or(|usual| wind.reference_height == usual);
            let warning = "wind.reference_height has no effect without wind.roughness: the wind \
                           is the same at every height";
            return (!is_usual).then(|| warning.into());
        };
        let along = wind
            .speed
            .unwrap_or_else(|| wind.right.hypot(wind.downrange));
        if along == 0.0 && wind.up == 0.0 {
            let warning = "wind.roughness has no effect without a wind: give wind.downrange and \
                           wind.right, or wind.speed and wind.from";
            return Some(warning.into());
        }
        let low = stated.append_value("wind.reference_height = ".into(), wind.reference_height);
        (wind.reference_height <= roughness).then(|| {
            low.words(
                " is not above wind.roughness: a logarithmic profile says nothing of the wind there",
            )
        })
    }
}
