use crate::drive::Drive;
use crate::error::Result;
use crate::flight::{Trajectory, trajectory};
use crate::parameters::Setup;

/// A drive with its path and a name.
#[derive(Clone, Debug)]
pub struct NamedDrive {
    /// The name, such as "as set up" or "optimum".
    pub name: String,
    /// The drive.
    pub drive: Drive<f64>,
    /// The path of the drive.
    pub path: Trajectory,
}

impl NamedDrive {
    /// The name of the drive before a search.
    pub const AS_SET_UP: &str = "as set up";

    /// The name of the drive at an optimum.
    pub const OPTIMUM: &str = "optimum";

    /// Flies a setup and keeps the path.
    ///
    /// # Errors
    /// The errors of [`Drive::new`].
    pub fn new(name: impl Into<String>, setup: &Setup<f64>) -> Result<Self> {
        let drive = Drive::new(setup)?;
        let path = trajectory(setup, &drive.launch)?;
        Ok(Self {
            name: name.into(),
            drive,
            path,
        })
    }
}
