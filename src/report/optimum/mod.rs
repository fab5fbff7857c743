//! The best drive, or the best design over swings: JSON, text, and setup file.

mod answer;
mod best_drive;
mod bounds;
mod report;
mod setup_file;
mod text;
mod windows;

pub use answer::OptimizeReport;
pub(super) use best_drive::{drive_lines, gain_lines};
pub(super) use bounds::bound_in_words;
pub use report::{
    ConstraintReport, DesignLimits, LimitReport, LocalReport, Multipliers, OptimumReport,
};
pub use setup_file::optimum_setup;
pub(super) use text::{
    add_convergence, add_varied_and_constraints, ended_line, optimum_document, varied_table,
};
pub use text::{iteration_line, optima_document};
