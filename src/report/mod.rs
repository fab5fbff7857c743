//! Results as text, JSON, CSV, Parquet, plots and pages; nothing here writes a file.
//!
//! A result is a struct that implements [`Report`]. The serialized struct is the body of the JSON,
//! in SI and radians. Its [`Document`] shows the result to readers, in a chosen system of units.

mod by_reason;
mod calibration;
mod certificate;
mod chart;
mod compare;
mod conditions;
mod csv_text;
mod delivery;
mod design;
mod document;
mod drive;
mod explorer;
pub mod figures;
mod frame;
mod gradient;
mod in_both;
mod json;
mod laws;
mod limits;
mod lines;
mod mae494;
mod optimum;
mod optimum_sensitivity;
mod origin;
pub mod page;
mod parameters;
mod pareto;
#[cfg(feature = "parquet")]
mod parquet;
pub mod plot;
mod presets;
mod published;
mod reply;
mod robust;
mod sensitivity;
mod setup_file;
mod shots;
mod shown;
mod sweep;
mod swings;
mod uncertainty;
mod validation;
mod winfield_tan;

pub use by_reason::by_reason;
pub use calibration::{CalibrationReport, DataReport, HeldOutReport};
pub use certificate::{CertificateReport, CertificateRow, NegativeControl};
pub use chart::{ChartPointReport, ChartReport};
pub use compare::{ComparedDrive, ComparisonReport, DifferenceReport};
pub use delivery::{
    DeliveryReport, DeliveryRow, bound_warnings, delivery_setup, difference_warnings,
    population_warnings, recovered_csv, recovered_toml, unusual_warnings,
};
pub use design::DesignReport;
pub use document::{Document, Line, TextOptions, document_files};
pub use drive::{ClubReport, DriveReport, LaunchReport, LawRanges, total_uncertainty_note};
pub use explorer::explorer_state;
pub use frame::TextFile;
pub use gradient::{GradientReport, OutcomeReport};
pub use in_both::InBoth;
pub use json::{ByName, JsonNumber, JsonRange, Matrix, Setting, Settings};
pub use laws::{LawReport, LawsReport};
pub use lines::{remark, wrapped};
pub use mae494::Mae494Report;
pub use optimum::{
    ConstraintReport, DesignLimits, LimitReport, LocalReport, Multipliers, OptimizeReport,
    OptimumReport, iteration_line, optima_document, optimum_setup,
};
pub use optimum_sensitivity::{
    OptimumSensitivityReport, PredictedOptimum, ResolvedOptimum, SensitivityOf, StatedChangeReport,
};
pub use origin::SetupOrigin;
pub use parameters::{ParameterReport, ParametersReport};
pub use pareto::{ParetoGoalReport, ParetoPointReport, ParetoReport, pareto_csv, pareto_setup};
#[cfg(feature = "parquet")]
pub(crate) use parquet::DEFINITION_KEY;
#[cfg(feature = "parquet")]
pub use parquet::{PARQUET_MAGIC, ParquetGroup, RowGroups};
pub use presets::{ChangedSetting, PresetReport, PresetsReport, changes};
pub use reply::{Empty, Ending, Reply, Report};
pub use robust::{ModelReport, RobustReport, robust_setup};
pub use sensitivity::{EffectReport, OutcomeEffects, SensitivityReport};
#[cfg(feature = "commands")]
pub(crate) use setup_file::setting_text;
pub use setup_file::{CommentedSetup, given_toml, preset_toml, setup_toml};
#[cfg(test)]
pub(crate) use shots::FlyRow;
#[cfg(feature = "parquet")]
pub use shots::ShotParquet;
pub use shots::{
    BandReport, ClubOutcome, ClubShotsReport, OutcomeResiduals, ShotWriter, ShotsReport,
    SumsReport, open_connect_answer,
};
pub use shown::{
    goal as goal_text, outcome as outcome_text, parameter as computed_text,
    stated as parameter_text, stated_difference as parameter_difference_text, with_constraints,
};
#[cfg(feature = "parquet")]
pub use sweep::SweepParquet;
#[cfg(test)]
pub(crate) use sweep::SweepRow;
pub use sweep::{SweepCsv, SweepJsonLines, summary_document};
pub use swings::{NominalReport, ScenariosReport, StudiesReport};
pub use uncertainty::{InputReport, UncertaintyReport};
pub use validation::ValidationReport;
pub use winfield_tan::WinfieldTanReport;
