use super::figure::Figure;
use super::svg::{Look, figure_svg};
use crate::error::{Error, Result};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// A plot as PNG, drawn from its SVG with an embedded font, so that the picture is the same on
/// every machine. `scale` is the number of image pixels per pixel of [`Look::width`].
///
/// # Errors
/// The errors of [`figure_svg`]; [`Error::Plot`] if the picture is too large for the memory.
pub fn figure_png(figure: &Figure, look: &Look, scale: f64) -> Result<Vec<u8>> {
    let failed = |reason: String| Error::Plot {
        name: figure.name.clone(),
        reason,
    };
    let svg = figure_svg(figure, look)?;
    let mut options = Options {
        font_family: FONT.into(),
        ..Options::default()
    };
    let fonts = options.fontdb_mut();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.load_font_data(dejavu::sans::bold().to_vec());
    fonts.set_sans_serif_family(FONT);
    let tree = Tree::from_str(&svg, &options).map_err(|error| failed(error.to_string()))?;
    let size = tree.size();
    let [width, height] =
        [size.width(), size.height()].map(|side| (f64::from(side) * scale).ceil() as u32);
    let mut dots = Pixmap::new(width, height).ok_or_else(|| {
        failed(format!(
            "a picture of {width} × {height} dots cannot be made; choose a width from 240 to 4000"
        ))
    })?;
    resvg::render(
        &tree,
        Transform::from_scale(scale as f32, scale as f32),
        &mut dots.as_mut(),
    );
    dots.encode_png().map_err(|error| failed(error.to_string()))
}

const FONT: &str = "DejaVu Sans";
