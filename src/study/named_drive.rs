use crate::drive::Drive;
use crate::error::Result;
use crate::flight::{Trajectory, trajectory};
use crate::parameters::Setup;

/// The role of a drive among the drives of a plot or a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DriveRole {
    /// The only drive, which needs no name.
    Alone,
    /// The drive before a search.
    AsSetUp,
    /// The drive at an optimum.
    Optimum,
}

impl DriveRole {
    /// The name of the drive; empty for the only drive.
    pub fn name(self) -> &'static str {
        match self {
            Self::Alone => "",
            Self::AsSetUp => NamedDrive::AS_SET_UP,
            Self::Optimum => NamedDrive::OPTIMUM,
        }
    }
}

/// A drive with its path and its role.
#[derive(Clone, Debug)]
pub struct NamedDrive {
    /// The role.
    pub role: DriveRole,
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
    pub fn new(role: DriveRole, setup: &Setup<f64>) -> Result<Self> {
        let drive = Drive::new(setup)?;
        let path = trajectory(setup, &drive.launch)?;
        Ok(Self { role, drive, path })
    }
}
