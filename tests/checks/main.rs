//! What longdrive promises, held against papers, closed forms, independent computations and measured orders.
//! A test's name says which: `paper_`, `exact_`, `independent_`, `order_`, `differences_`, `measured_`, `published_`, and `regress_` for what may not grow.

mod analysis;
mod calibration;
mod command_line;
mod command_line_calibrate;
mod command_line_certainty;
mod command_line_files;
mod command_line_search;
mod command_line_sweep;
mod command_line_tables;
mod command_line_text;
mod command_line_units;
mod common;
mod compare;
mod delivery;
mod derivatives;
mod directions;
mod documents;
mod drawn;
mod fast_paths;
mod flight;
mod ground;
mod impact;
mod interrupts;
mod json_answers;
mod launch;
mod laws;
mod listening;
mod long_work;
mod messages;
mod optimizer;
mod oracle;
mod own_table;
mod pages;
mod pictures;
mod published;
mod reference;
mod report;
mod reproduce;
#[path = "../schema/mod.rs"]
mod schema;
mod shots;
mod shots_stated;
mod smoothness;
mod sweep;
#[cfg(all(feature = "arrow", feature = "parquet"))]
mod tables;
mod tolerance;
mod uncertainty;
mod validation;
mod verify;
mod verify_ranges;
mod warnings;
mod weather;
mod weight;
