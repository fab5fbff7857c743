//! Results as text and JSON: pure functions, which write nowhere. Text is in units a golfer reads,
//! JSON in SI and radians.

mod calibration;
mod certificate;
mod chart;
mod compare;
mod delivery;
mod design;
mod document;
mod drive;
mod effects;
pub mod figures;
mod frame;
mod gradient;
mod json;
mod laws;
mod limits;
mod lines;
mod mae494;
mod optimum;
pub mod page;
mod parameters;
mod pareto;
#[cfg(feature = "parquet")]
mod parquet;
pub mod plot;
mod presets;
mod published;
mod recovered;
mod reply;
mod robust;
mod sensitivity;
mod setup_file;
mod shots;
mod shown;
mod sweep;
mod swings;
mod table;
mod uncertainty;
mod validation;
mod winfield_tan;

pub use calibration::{
    CalibrationReport, calibration_document, calibration_reply, calibration_toml,
};
pub use certificate::{CertificateReport, CertificateRow, certificate_text};
pub use chart::{ChartPointReport, ChartReport, chart_csv, chart_text};
pub use compare::{ComparisonReport, DifferenceReport, comparison_text, difference_text};
pub use delivery::{
    bound_warnings, delivered_text, deliveries_text, delivery_reply, delivery_toml,
};
pub use design::Designed;
pub use document::{Document, document_files};
pub use drive::{DriveReport, air_text, drive_text, known_within};
pub use effects::{EffectsReport, OutcomeEffects, Totals, effects_text};
pub use gradient::{GradientReport, HessianReport, OutcomeReport, gradient_text};
pub use laws::{laws_reply, laws_text};
pub use lines::{by_reason, remark};
pub use mae494::{mae494_document, mae494_reply};
pub use optimum::{
    ConstraintReport, LocalReport, Multipliers, OptimumReport, iteration_line, optima_text,
    optimize_text, optimum_text, optimum_toml,
};
pub use parameters::{parameters_reply, parameters_text};
pub use pareto::{pareto_csv, pareto_reply, pareto_text, pareto_toml};
#[cfg(feature = "parquet")]
pub use parquet::{ParquetGroup, PlacedGroup};
pub use presets::{Change, changes, presets_reply, presets_text};
pub use recovered::{population_warnings, recovered_csv, recovered_toml};
pub use reply::{Empty, Reply};
pub use robust::{robust_reply, robust_text, robust_toml};
pub use sensitivity::{Analysis, AnalysisReport, SensitivityReport, sensitivity_text};
pub use setup_file::{preset_toml, setup_toml, setup_toml_without_step};
#[cfg(feature = "cli")]
pub(crate) use setup_file::{with_step_of, without_step};
#[cfg(feature = "parquet")]
pub use shots::ShotParquet;
pub use shots::{ShotFormat, ShotWriter, ShotsReport, open_connect_answer, shots_text};
pub use shown::{goal as goal_text, outcome as outcome_text, stated as parameter_text};
#[cfg(feature = "parquet")]
pub use sweep::SweepParquet;
pub use sweep::{SweepCsv, SweepJsonLines, summary_text};
pub use swings::{
    IntervalReport, NominalReport, OverSwings, ResampledReport, SamplingReport, ScenariosReport,
    StudiesReport,
};
pub use uncertainty::{UncertaintyReport, uncertainty_text};
pub use validation::{validation_csv, validation_document, validation_reply};
pub use winfield_tan::{winfield_tan_document, winfield_tan_reply};
