//! Plots on a page, each drawn for several widths and for both systems of units.

use super::chosen;
use crate::error::Result;
use crate::report::in_both::InBoth;
use crate::report::plot::{Figure, Look, figure_csv, figure_svg};
use crate::units::{System, TableUnits};
use maud::{Markup, PreEscaped, html};
use std::borrow::Borrow;

/// A file of a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextFile {
    /// The file name.
    pub name: String,
    /// The content.
    pub text: String,
}

/// The CSS classes of pictures with their widths, pixels: narrow for a phone or a printed column,
/// and broad for a screen. A narrow picture is not shrunk, so that its text keeps its normal size.
const WIDTHS: [(&str, u32); 2] = [("narrow", 340), ("broad", 560)];

/// The file name of a plot's picture.
pub(in crate::report) fn svg_name(figure: &Figure) -> String {
    format!("{}-{}.svg", figure.name, figure.system)
}

/// The file name of a plot's data.
pub(in crate::report) fn csv_name(figure: &Figure) -> String {
    format!("{}.csv", figure.name)
}

/// The files of plots: a picture in each system of units, and the data in SI. The name of a layer
/// may contain a value; in the data it is in the units of `data_of`.
///
/// # Errors
/// The errors of [`figure_svg`] and [`figure_csv`].
pub(in crate::report) fn picture_files<'a, F: Borrow<Figure> + 'a>(
    plots: impl IntoIterator<Item = &'a InBoth<F>>,
    data_of: System,
) -> Result<Vec<TextFile>> {
    let mut files = vec![];
    for plot in plots {
        for system in System::ALL {
            let figure = plot.get(system).borrow();
            files.push(TextFile {
                name: svg_name(figure),
                text: figure_svg(figure, &Look::default())?,
            });
            if system == data_of {
                files.push(TextFile {
                    name: csv_name(figure),
                    text: figure_csv(figure, TableUnits::Si)?,
                });
            }
        }
    }
    Ok(files)
}

/// Plots, side by side if the page is wide enough.
///
/// # Errors
/// The errors of [`figure_svg`].
pub(in crate::report) fn pictures<'a, F: Borrow<Figure> + 'a>(
    plots: impl IntoIterator<Item = &'a InBoth<F>>,
) -> Result<Markup> {
    let drawn = plots
        .into_iter()
        .map(|plot| {
            let (metric, us) = (plot.metric.borrow(), plot.us.borrow());
            let plot = InBoth { metric, us };
            let drawings = drawings(&plot)?;
            Ok((plot, drawings))
        })
        .collect::<Result<Vec<_>>>()?;
    Ok(html! {
        @if !drawn.is_empty() {
            div.figures {
                @for (InBoth { metric, us }, drawings) in drawn {
                    figure class=[(metric.columns > 1).then_some("whole")] {
                        @for (class, svg) in &drawings { div class=(class) { (PreEscaped(svg)) } }
                        figcaption {
                            (chosen(&metric.note, &us.note)) " "
                            a.us href=(svg_name(us)) { "SVG" }
                            a.metric href=(svg_name(metric)) { "SVG" }
                            " " a href=(csv_name(us)) { "data" }
                        }
                    }
                }
            }
        }
    })
}

/// The pictures of a plot as pairs of CSS classes and SVG. If the metric and the US picture are
/// equal, only one of them is returned.
fn drawings(plot: &InBoth<&Figure>) -> Result<Vec<(String, String)>> {
    let mut drawings = vec![];
    for (place, width) in WIDTHS {
        let look = Look {
            width,
            ..Look::default()
        };
        let (metric, us) = (figure_svg(plot.metric, &look)?, figure_svg(plot.us, &look)?);
        if metric == us {
            drawings.push((place.into(), us));
        } else {
            drawings.push((format!("{place} us"), us));
            drawings.push((format!("{place} metric"), metric));
        }
    }
    Ok(drawings)
}
