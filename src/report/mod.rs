//! Results as text and JSON: pure functions, which write nowhere. Text is in units a golfer reads, JSON in SI
//! and radians.

mod certificate;
mod chart;
mod drive;
mod effects;
mod gradient;
mod json;
mod optimum;
mod parameters;
mod presets;
mod sensitivity;
mod sweep;
mod table;
mod uncertainty;

pub use certificate::{CertificateReport, CertificateRow, certificate_text};
pub use chart::{ChartPointReport, ChartReport, chart_csv, chart_text};
pub use drive::{DriveReport, drive_text};
pub use effects::{EffectsReport, Totals, effects_text};
pub use gradient::{GradientReport, HessianReport, gradient_text};
pub use optimum::{
    ConstraintReport, LocalReport, Multipliers, OptimumReport, iteration_line, optima_text, optimum_text,
};
pub use parameters::{parameters_json, parameters_text};
pub use presets::{preset_toml, presets_json, presets_text};
pub use sensitivity::{Analysis, SensitivityReport, sensitivity_text};
#[cfg(feature = "parquet")]
pub use sweep::{ParquetGroup, PlacedGroup, SweepParquet};
pub use sweep::{SweepCsv, SweepJsonLines};
pub use uncertainty::{UncertaintyReport, uncertainty_text};
