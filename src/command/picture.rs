//! Destinations of pictures, and their formats.

use crate::command::args::{stated, whole};
use crate::command::files::{Destination, OutputRule, ending};
use crate::command::output::{Answer, is_json, note, stated_system, warn, warnings};
#[cfg(not(feature = "png"))]
use crate::features::how_to_get;
use crate::report::plot::{Figure, Look, figure_csv, figure_svg};
use crate::report::{Ending, Reply, SetupOrigin};
use crate::units::Message;
use crate::{Error, Result};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Options of a picture.
#[derive(clap::Args)]
pub struct PictureArgs {
    /// The file to write: .svg or .png for a picture, .csv for its data (each column head
    /// names its unit).
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,

    /// Replace files that exist.
    #[arg(long)]
    pub overwrite: bool,

    /// Draw for a dark background.
    #[arg(long)]
    pub dark: bool,

    /// The width of the picture in pixels; a PNG has twice the resolution. The size of the text
    /// does not change [default: 480].
    #[arg(
        long,
        value_name = "PIXELS",
        value_parser = whole::<u32>(240..=4000, "`width 800`"),
        allow_negative_numbers = true,
    )]
    pub width: Option<u32>,
}

/// The default width of a picture, pixels.
const WIDTH: u32 = 480;

/// The format of a plot.
#[derive(Clone, Copy)]
enum PlotFormat {
    Svg,
    #[cfg(feature = "png")]
    Png,
    Csv,
}

impl PlotFormat {
    /// The format of a file, by its extension.
    fn of(file: &Path) -> Result<Self> {
        match ending(file).as_str() {
            "svg" => Ok(Self::Svg),
            #[cfg(feature = "png")]
            "png" => Ok(Self::Png),
            #[cfg(not(feature = "png"))]
            "png" => Err(Error::Plot {
                name: file.display().to_string(),
                reason: how_to_get("png"),
            }),
            "csv" => Ok(Self::Csv),
            _ => Err(Error::Plot {
                name: file.display().to_string(),
                reason: "its extension does not name a format; use .svg or .png for a picture, or \
                         .csv for its data"
                    .into(),
            }),
        }
    }
}

/// The destination of a plot, with its format.
pub struct PlotDestination<'a> {
    drawing: &'a PictureArgs,
    format: PlotFormat,
    destination: Destination,
    /// The status of the command. With a message, the plot does not show all that the request
    /// states.
    pub ending: Ending,
    /// The setup of the plot. Its advice becomes a note, or a member of the JSON.
    pub origin: SetupOrigin,
}

impl<'a> PlotDestination<'a> {
    /// Checks the destination of a plot. `inputs` are the files that the command reads.
    pub fn new(inputs: impl Iterator<Item = PathBuf>, drawing: &'a PictureArgs) -> Result<Self> {
        let format = PlotFormat::of(&drawing.output)?;
        let look = [
            ("`dark`", drawing.dark),
            ("`width`", drawing.width.is_some()),
        ];
        if let (PlotFormat::Csv, Some(option)) = (format, stated(look).next()) {
            let source = "it applies to pictures, and a .csv file has only the data; leave it out, \
                          or write a .svg or .png file";
            return Err(Error::unreadable(option, source));
        }
        let rule = OutputRule::new(inputs, drawing.overwrite);
        Ok(Self {
            drawing,
            format,
            destination: rule.file(&drawing.output)?,
            ending: Ending::DONE,
            origin: SetupOrigin::default(),
        })
    }

    /// Sets the setup of the plot.
    pub fn about(self, origin: SetupOrigin) -> Self {
        Self { origin, ..self }
    }

    /// The error if there is nothing to plot.
    pub fn refused(&self, reason: impl Into<String>) -> Error {
        Error::Plot {
            name: self.drawing.output.display().to_string(),
            reason: reason.into(),
        }
    }

    /// Writes the plot and reports the warnings about its drives.
    pub fn write(&self, figure: &Figure, of_drives: Vec<Message>) -> Result<Answer> {
        let drawing = self.drawing;
        warn(of_drives);
        let look = Look {
            is_dark: drawing.dark,
            width: drawing.width.unwrap_or(WIDTH),
        };
        let bytes = match self.format {
            PlotFormat::Svg => figure_svg(figure, &look)?.into_bytes(),
            #[cfg(feature = "png")]
            PlotFormat::Png => crate::report::plot::figure_png(figure, &look, 2.0)?,
            PlotFormat::Csv => figure_csv(figure, stated_system().into())?.into_bytes(),
        };
        let file = drawing.output.display().to_string();
        self.destination.write(&bytes)?;
        if !is_json() && !self.origin.advice.is_empty() {
            note(&self.origin.advice);
        }
        note(&format!("{file}: {}", figure.title));
        if !figure.note.is_empty() {
            note(&figure.note);
        }
        let is_complete = self.ending.message.is_none();
        let answer = if is_json() {
            let body = PlotFile {
                name: &figure.name,
                file,
                title: &figure.title,
                subtitle: &figure.subtitle,
                note: &figure.note,
                bytes: bytes.len(),
            };
            let reply = Reply::done("plot", warnings(), body).about(&self.origin);
            Answer::json(&reply.ended(self.ending.clone()))
        } else {
            Answer::text(String::new())
        };
        Ok(answer.found(is_complete))
    }
}

/// The file of a plot.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PlotFile<'a> {
    /// Name of the plot.
    name: &'a str,
    /// Path of the file.
    file: String,
    /// Title of the plot.
    title: &'a str,
    /// Line below the title: constant parameters and constraints; may be empty.
    subtitle: &'a str,
    /// Note of the plot.
    note: &'a str,
    /// Size of the file.
    bytes: usize,
}
