//! A user's own table of drag and lift (`aero.table`): a law of splines through it.

mod check;
mod grid;
mod read;
mod surface;

pub(crate) use grid::Grid;
pub use grid::{Along, Axis};
pub(crate) use surface::{Cell, Surface, cells_of};

use crate::error::{Error, Result};
use crate::external_errors::read_error_text;
use crate::fingerprint::Fingerprint;
use std::fmt;
use std::path::{Path, absolute};
use std::sync::{Mutex, PoisonError};

/// The name by which a table is given: `aero.table = "mine.csv"`.
pub const TABLE: &str = "aero.table";

/// The name of the law that a table makes, as `aero.law` has it.
pub const TABLE_LAW: &str = "table";

/// A table of C_D and C_L over spin and speed, with the splines through it. Setups are copied for
/// every drive and hold it by reference: each content of a file is kept once, until the program
/// ends.
pub struct LawTable {
    file: String,
    told: String,
    nodes: Vec<[f64; 4]>,
    fingerprint: u64,
    grid: Grid,
}

/// The tables that have been read.
static READ: Mutex<Vec<&'static LawTable>> = Mutex::new(vec![]);

impl LawTable {
    /// Reads the table of a CSV file. Its columns are `cd`, `cl`, one of `spin_ratio` (`s`) and
    /// `spin [rpm]`, and one of `reynolds` (`re`) and `speed [m/s]`; one of these two may be left
    /// out. Each row is a node of a full grid, in any order.
    ///
    /// # Errors
    /// [`Error::Table`] with the line and what to do.
    pub fn open(path: &Path) -> Result<&'static Self> {
        let file = path.display().to_string();
        let refuse = |place: String, reason: String| Error::Table {
            file: file.clone(),
            place,
            reason,
        };
        let text = std::fs::read_to_string(path)
            .map_err(|error| refuse(String::new(), read_error_text(&error)))?;
        let nodes = read::nodes(&text).map_err(|(place, reason)| refuse(place, reason))?;
        let whole = absolute(path)
            .ok()
            .and_then(|path| path.to_str().map(str::to_owned));
        let whole = whole.unwrap_or_else(|| file.clone());
        let rows = nodes
            .rows
            .iter()
            .map(|node| [node.speed, node.spin, node.drag, node.lift]);
        let rows: Vec<[f64; 4]> = rows.collect();
        let mut fingerprint = Fingerprint::new();
        for along in nodes.speed.iter().chain(&nodes.spin) {
            fingerprint.add(f64::from(*along as u8));
        }
        rows.iter()
            .flatten()
            .for_each(|number| fingerprint.add(*number));
        let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        // commands open a setup file more than once
        let is_same = |other: &&&Self| {
            other.fingerprint == fingerprint.0 && other.nodes == rows && other.file == whole
        };
        if let Some(same) = read.iter().find(is_same) {
            return Ok(*same);
        }
        let grid = check::grid(&nodes).map_err(|(place, reason)| refuse(place, reason))?;
        let name = path
            .file_name()
            .map_or(whole.clone(), |name| name.to_string_lossy().into_owned());
        let told = format!("the table {name}");
        let table = Self {
            file: whole,
            told,
            nodes: rows,
            fingerprint: fingerprint.0,
            grid,
        };
        let kept: &'static Self = Box::leak(Box::new(table));
        read.push(kept);
        Ok(kept)
    }

    /// The file, from the root.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// What messages call it.
    pub(crate) fn told(&self) -> &str {
        &self.told
    }

    /// What it goes along, and how far: the axis of the speed and that of the spin, where it has
    /// them.
    pub fn axes(&self) -> impl Iterator<Item = &Axis> {
        self.grid.axes()
    }

    /// Its nodes as in the file: place along the axes of speed and spin (0 where there is no such
    /// axis), C_D, C_L.
    pub fn nodes(&self) -> &[[f64; 4]] {
        &self.nodes
    }

    pub(crate) fn grid(&self) -> &Grid {
        &self.grid
    }
}

/// Tables are equal that say the same, whatever file they are from.
impl PartialEq for LawTable {
    fn eq(&self, other: &Self) -> bool {
        self.fingerprint == other.fingerprint && self.nodes == other.nodes
    }
}

/// Its content in a number, so that a setup in its debug form tells a table from another.
impl fmt::Debug for LawTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.fingerprint)
    }
}
