//! What is said of a wind's profile that has no effect, or means nothing.

use super::table::Setup;
use crate::units::Message;

impl Setup<f64> {
    /// Where roughness and reference height have no effect, and where the wind is stated below the
    /// roughness. It is of this drive alone: where wind or roughness varies from drive to drive,
    /// they have an effect. So [`warnings`](Self::warnings) leaves it out.
    pub fn wind_profile_warning(&self) -> Option<Message> {
        let wind = &self.wind;
        let stated = self.parameter("wind.reference_height").ok()?;
        let Some(roughness) = wind.roughness else {
            let is_usual = stated
                .default_value()
                .is_none_or(|usual| wind.reference_height == usual);
            let told = "wind.reference_height has no effect without wind.roughness: the wind is \
                        the same at every height";
            return (!is_usual).then(|| told.into());
        };
        let along = wind
            .speed
            .unwrap_or_else(|| wind.right.hypot(wind.downrange));
        if along == 0.0 && wind.up == 0.0 {
            let told = "wind.roughness has no effect without a wind: give wind.downrange and \
                        wind.right, or wind.speed and wind.from";
            return Some(told.into());
        }
        let low = stated.place("wind.reference_height = ".into(), wind.reference_height);
        (wind.reference_height <= roughness).then(|| {
            low.words(
                " is not above wind.roughness: a logarithmic profile says nothing \
                                of the wind there",
            )
        })
    }
}
