//! Law of a user's own table of drag and lift (`aero.table`): splines through its nodes.

mod check;
mod grid;
mod read;
mod surface;

pub(crate) use grid::CoefficientGrid;
pub use grid::{LawTableAxis, LawVariable};
pub(crate) use surface::{DRAG_START, LIFT_START, Surface, bicubic, cells};

use super::number_table::TableFault;
use crate::error::{Error, Result};
use crate::external_errors::read_error_text;
use crate::fingerprint::Fingerprint;
use crate::input_file::InputFile;
use crate::lock::lock;
use std::fmt;
use std::path::{Path, absolute};
use std::sync::Mutex;

/// Name of the setting for a table: `aero.table = "mine.csv"`.
pub const TABLE: &str = "aero.table";

/// Name of the law in `aero.law`.
pub const TABLE_LAW: &str = "table";

/// A table of C_D and C_L over spin and speed, with the splines through it. A setup is copied for
/// each drive, so the setup has a static reference to the table. The table is stored until the
/// program ends. Reading an unchanged file again returns the stored table.
pub struct LawTable {
    /// Absolute path of the file.
    pub file: String,
    /// Description for messages.
    pub(crate) description: String,
    /// The nodes in ascending order, each as speed, spin, C_D and C_L. Speed and spin are the
    /// coordinates on the two axes, SI; 0 if the table does not have the axis.
    pub nodes: Vec<[f64; 4]>,
    fingerprint: u64,
    pub(crate) grid: CoefficientGrid,
}

/// Tables read so far.
static TABLES: Mutex<Vec<&'static LawTable>> = Mutex::new(vec![]);

impl LawTable {
    /// Reads the table of a CSV file. Its columns are `cd`, `cl`, one of `spin_ratio` (`s`) and
    /// `spin [rpm]`, and one of `reynolds` (`re`) and `speed [m/s]`; one of the two axes may be
    /// left out. The rows are the nodes of a full grid, in any order.
    ///
    /// # Errors
    /// [`Error::Table`], with line and advice, if the file cannot be read or is not such a table.
    pub fn open(path: &Path) -> Result<&'static Self> {
        let file = path.display().to_string();
        let refuse = |fault: TableFault| Error::table(&file, fault.place, fault.reason);
        let text = InputFile::read_to_string(path)
            .map_err(|error| refuse(TableFault::of_file(read_error_text(&error))))?;
        let nodes = read::nodes(&text).map_err(refuse)?;
        let absolute_path = absolute(path)
            .ok()
            .and_then(|path| path.to_str().map(str::to_owned))
            .unwrap_or_else(|| file.clone());
        let mut rows: Vec<[f64; 4]> = nodes
            .rows
            .iter()
            .map(|node| [node.speed, node.spin, node.drag, node.lift])
            .collect();
        // tables that differ only in the order of their rows are equal
        rows.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let fingerprint = fingerprint(nodes.speed.iter().chain(&nodes.spin), &rows);

        let mut tables = lock(&TABLES);
        // a command may open a setup file more than once
        let is_same = |other: &&&Self| {
            other.fingerprint == fingerprint && other.nodes == rows && other.file == absolute_path
        };
        if let Some(same) = tables.iter().find(is_same) {
            return Ok(*same);
        }
        let grid = check::grid(&nodes).map_err(refuse)?;
        let name = path.file_name().map_or(absolute_path.clone(), |name| {
            name.to_string_lossy().into_owned()
        });
        let table: &'static Self = Box::leak(Box::new(Self {
            file: absolute_path,
            description: format!("the table {name}"),
            nodes: rows,
            fingerprint,
            grid,
        }));
        tables.push(table);
        Ok(table)
    }

    /// The axes: speed and spin, or one of them.
    pub fn axes(&self) -> impl Iterator<Item = &LawTableAxis> {
        self.grid.speed.iter().chain(&self.grid.spin)
    }
}

fn fingerprint<'a>(axes: impl Iterator<Item = &'a LawVariable>, nodes: &[[f64; 4]]) -> u64 {
    let mut fingerprint = Fingerprint::new();
    for variable in axes {
        fingerprint.add(f64::from(*variable as u8));
    }
    for number in nodes.as_flattened() {
        fingerprint.add(*number);
    }
    fingerprint.0
}

/// Tables with equal axes and equal nodes are equal, even if they come from different files.
impl PartialEq for LawTable {
    fn eq(&self, other: &Self) -> bool {
        self.fingerprint == other.fingerprint && self.nodes == other.nodes
    }
}

/// Writes the hash of the content, so that setups with different tables differ in their debug form.
impl fmt::Debug for LawTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.fingerprint)
    }
}
