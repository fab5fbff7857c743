//! Plots. A [`Figure`] is data: axes and layers, in SI. SVG, PNG and CSV are views of it, in either
//! system of units, light or dark.
//!
//! ```
//! use longdrive::report::plot::{Axis, Figure, Layer, Look, NamedQuantity, figure_csv, figure_svg};
//! use longdrive::units::{Quantity, System, TableUnits};
//!
//! let distance = NamedQuantity::new("downrange", Quantity::LENGTH, "yd");
//! let height = NamedQuantity::new("height", Quantity::LENGTH, "yd");
//! let [x, y] = [distance, height].map(Axis::linear);
//! let figure = Figure::new(System::Us, "stone", "A thrown stone", x, y)
//!     .with(Layer::line("path", 0, vec![[0.0, 0.0], [10.0, 5.0], [20.0, 0.0]]));
//! let svg = figure_svg(&figure, &Look::default()).unwrap();
//! assert!(svg.starts_with("<svg") && svg.contains("downrange [yd]"));
//! assert!(figure_csv(&figure, TableUnits::Si).unwrap().contains("downrange [m]"));
//! ```

mod axis;
mod bars;
mod canvas;
mod contour;
mod csv;
mod end_names;
mod figure;
mod hatching;
mod hover;
mod interpolation;
mod layers;
mod layout;
mod legend;
mod marks;
mod palette;
#[cfg(feature = "png")]
mod png;
mod simplify;
mod svg;
mod text_width;
mod ticks;

pub use axis::{Axis, AxisScale, NamedQuantity};
pub use csv::figure_csv;
pub use figure::{Field, Figure, HorizontalBar, Hue, Layer, LineNames, Shape};
#[cfg(feature = "png")]
pub use png::figure_png;
pub use svg::{Look, dark_rules, figure_svg};
pub(in crate::report) use ticks::nice_step;
