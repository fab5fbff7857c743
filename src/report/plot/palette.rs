use super::figure::Hue;
use std::fmt;

/// The opacity of bands.
pub(super) const BAND_OPACITY: f64 = 0.22;
/// The opacity of bars.
pub(super) const BAR_OPACITY: f64 = 0.85;

/// A colour: red, green and blue, sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub u8, pub u8, pub u8);

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02X}{:02X}{:02X}", self.0, self.1, self.2)
    }
}

/// The colours of a picture. The hues of series remain distinguishable with colour blindness (Okabe
/// & Ito, 2008). They are darkened or lightened to a contrast of 3 : 1 with the background and with
/// the fills of maps and bands. Cross bars distinguish series with the same colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// The background of the picture.
    pub background: Color,
    /// Text and axes.
    pub ink: Color,
    /// Secondary lines and texts.
    pub faint: Color,
    /// Grid lines.
    pub mesh: Color,
    /// The colour of missing values of a field.
    pub nothing: Color,
    series: [Color; Hue::SERIES],
    /// The colours of the lowest, middle and highest region of a field.
    heights: [Color; 3],
}

/// The colours for a bright page and for print.
pub const LIGHT: Palette = Palette {
    background: Color(255, 255, 255),
    ink: Color(28, 33, 40),
    faint: Color(94, 103, 115),
    mesh: Color(222, 226, 231),
    nothing: Color(214, 209, 203),
    series: [
        Color(0, 101, 166),
        Color(192, 76, 0),
        Color(0, 122, 90),
        Color(160, 70, 128),
        Color(134, 104, 0),
        Color(0, 123, 146),
    ],
    heights: [
        Color(246, 249, 237),
        Color(202, 231, 215),
        Color(156, 216, 210),
    ],
};

/// The colours for a dark page.
pub const DARK: Palette = Palette {
    background: Color(20, 24, 29),
    ink: Color(232, 236, 240),
    faint: Color(152, 162, 174),
    mesh: Color(52, 59, 68),
    nothing: Color(62, 56, 50),
    series: [
        Color(98, 180, 240),
        Color(255, 158, 82),
        Color(64, 200, 160),
        Color(228, 152, 202),
        Color(226, 200, 84),
        Color(130, 225, 236),
    ],
    heights: [Color(26, 33, 42), Color(28, 62, 70), Color(30, 90, 92)],
};

/// The share of a series' colour in the fill of a tinted region; the rest is the background.
const TINTED: f64 = 0.28;

/// Number of colour steps of a field.
pub(super) const STEPS: usize = 24;

impl Palette {
    pub(super) fn of(&self, hue: Hue) -> Color {
        match hue {
            Hue::Ink => self.ink,
            Hue::Faint => self.faint,
            Hue::Series(i) => self.series[i % Hue::SERIES],
        }
    }

    /// The colour of a region of a field. `part` is the rank of the region, 0 to 1.
    pub(super) fn height(&self, part: f64) -> Color {
        let part = (part.clamp(0.0, 1.0) * STEPS as f64).round() / STEPS as f64 * 2.0;
        let (low, high) = if part < 1.0 { (0, 1) } else { (1, 2) };
        mixed(self.heights[low], self.heights[high], part - low as f64)
    }

    /// The opaque fill of a tinted region, on a map and in the legend.
    pub(super) fn tint(&self, hue: Hue) -> Color {
        mixed(self.background, self.of(hue), TINTED)
    }

    /// All colours, in the same order for each palette.
    pub(super) fn all(&self) -> Vec<Color> {
        let heights = (0..=STEPS).map(|step| self.height(step as f64 / STEPS as f64));
        let tints = (0..Hue::SERIES).map(|i| self.tint(Hue::Series(i)));
        [
            self.background,
            self.ink,
            self.faint,
            self.mesh,
            self.nothing,
        ]
        .into_iter()
        .chain(self.series)
        .chain(heights)
        .chain(tints)
        .collect()
    }
}

/// The colour at a fraction of the way from one colour to another.
fn mixed(from: Color, to: Color, part: f64) -> Color {
    let mix = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
    Color(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

#[cfg(test)]
mod tests {
    use super::{BAND_OPACITY, Color, DARK, LIGHT, STEPS};

    /// The contrast ratio of two colours, 1 to 21 (WCAG 2.1, relative luminance).
    fn contrast(a: Color, b: Color) -> f64 {
        let linear = |part: u8| {
            let part = f64::from(part) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        };
        let luminance =
            |c: Color| 0.2126 * linear(c.0) + 0.7152 * linear(c.1) + 0.0722 * linear(c.2);
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn contrasts_are_sufficient_for_reading() {
        for palette in [LIGHT, DARK] {
            let mix = |over: u8, under: u8| {
                let (over, under) = (f64::from(over), f64::from(under));
                (BAND_OPACITY * over + (1.0 - BAND_OPACITY) * under).round() as u8
            };
            let band = |c: Color| {
                let background = palette.background;
                Color(
                    mix(c.0, background.0),
                    mix(c.1, background.1),
                    mix(c.2, background.2),
                )
            };
            let heights = (0..=STEPS).map(|step| palette.height(step as f64 / STEPS as f64));
            let fills = heights
                .chain(palette.series.map(band))
                .chain([palette.background, palette.nothing]);
            for fill in fills {
                for color in palette.series.into_iter().chain([palette.ink]) {
                    let found = contrast(color, fill);
                    assert!(found >= 3.0, "{color:?} on {fill:?}: {found}");
                }
            }
            assert!(
                contrast(palette.ink, palette.background) >= 7.0
                    && contrast(palette.faint, palette.background) >= 4.5
            );
            // contrast of labels and lines on a map
            assert!(
                palette
                    .heights
                    .iter()
                    .all(|height| contrast(palette.ink, *height) >= 4.5)
            );
        }
    }

    #[test]
    fn every_colour_of_light_pictures_has_a_dark_one() {
        let light = LIGHT.all();
        assert_eq!(light.len(), DARK.all().len());
        for (i, color) in light.iter().enumerate() {
            assert!(!light[..i].contains(color), "{color:?} stands for two");
        }
    }
}
