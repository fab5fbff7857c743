use super::Vary;
use super::named_drive::DriveRole;
use super::plane::Plane;
use crate::derivative::Order;
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::parameters::{LaunchConditions, Setup};
use crate::statistics::extent;
use crate::units::{DEGREE, RPM};

/// Carry as a function of launch angle and backspin at constant ball speed.
#[derive(Clone, Debug)]
pub struct Launches {
    /// The setup of the first drive. It gives the launch of this drive in place of its impact.
    pub setup: Setup<f64>,
    /// The ball speed, m/s.
    pub ball_speed: f64,
    /// Carries over `launch.launch_angle` and `launch.backspin`, SI.
    pub plane: Plane,
    /// Launches of the drives shown; the first belongs to the setup.
    pub launched: Vec<NamedLaunch>,
    /// Launch angle of longest carry for each backspin of [`plane`](Self::plane): launch angle
    /// (rad) and backspin (rad/s). A backspin is omitted if its best launch angle lies at an end of
    /// the range.
    pub ridge: Vec<[f64; 2]>,
}

/// Launch of a drive.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedLaunch {
    /// Role of the drive.
    pub role: DriveRole,
    /// Launch angle, rad.
    pub launch_angle: f64,
    /// Backspin, rad/s.
    pub backspin: f64,
    /// Ball speed of this drive, m/s. The carries in [`Launches::plane`] are for the ball speed of
    /// the first drive.
    pub ball_speed: f64,
    /// Carry of this drive, m; `None` if the ball does not fly.
    pub carry: Option<f64>,
}

impl NamedLaunch {
    fn of(role: DriveRole, drive: &Drive<f64>) -> Self {
        let launch = &drive.launch;
        Self {
            role,
            launch_angle: launch.launch_angle(),
            backspin: launch.backspin(),
            ball_speed: launch.ball_speed(),
            carry: Outcome::Carry.value(drive),
        }
    }
}

/// Margin of [`Launches::plane`] around the launches, rad and rad/s. The ends of the plane's ranges
/// are rounded to multiples of `ENDS`.
const BEYOND: [f64; 2] = [7.0 * DEGREE, 1250.0 * RPM];
const ENDS: [f64; 2] = [DEGREE, 250.0 * RPM];

/// Nodes per side of [`Launches::plane`].
const NODES: usize = 61;

impl Launches {
    /// Computes the drives of [`plane`](Self::plane) at the ball speed of the first drive. The
    /// plane contains the launches of all drives.
    ///
    /// # Errors
    /// The errors of [`Drive::new`] and [`Batch::new`](crate::batch::Batch::new);
    /// [`Error::Nothing`] if `drives` is empty; [`Error::NoFlight`] if no launch of the plane
    /// flies.
    pub fn around(drives: &[(DriveRole, &Setup<f64>)]) -> Result<Self> {
        let mut launched = vec![];
        let mut first = None;
        for (role, setup) in drives {
            let drive = Drive::new(setup)?;
            launched.push(NamedLaunch::of(*role, &drive));
            first.get_or_insert((*setup, drive.launch));
        }
        let (own, launch) = first.ok_or(Error::Nothing {
            doing: "draw the launches of",
            what: "drive",
        })?;
        let mut setup = *own;
        setup.launch = LaunchConditions {
            ball_speed: Some(launch.ball_speed()),
            launch_angle: Some(launch.launch_angle()),
            launch_direction: Some(launch.launch_direction()),
            backspin: Some(launch.backspin()),
            sidespin: Some(launch.sidespin()),
            spin: None,
            spin_axis: None,
        };
        let vary = |name: &str, axis: usize, of: fn(&NamedLaunch) -> f64| -> Result<Vary> {
            let [low, high] = extent(launched.iter().map(of));
            let end = ENDS[axis];
            // a range begins below 0 only if a launch is below 0: launch angle and backspin of a
            // good drive are positive
            let low = (((low - BEYOND[axis]) / end).round() * end).max(low.min(0.0));
            Vary::new(
                setup.column(name)?,
                low,
                ((high + BEYOND[axis]) / end).round() * end,
            )
        };
        let across = vary("launch.launch_angle", 0, |one| one.launch_angle)?;
        let up = vary("launch.backspin", 1, |one| one.backspin)?;
        let plane = Plane::fly(
            &setup,
            &[Outcome::Carry],
            across,
            up,
            [NODES; 2],
            Order::First,
        )?;
        if plane.values[0].iter().all(Option::is_none) {
            return Err(Error::NoFlight {
                status: "no-flight",
                reason: "no flight: no launch of the map flies and lands".into(),
            });
        }
        let ridge = ridge(&plane);
        Ok(Self {
            setup,
            ball_speed: launch.ball_speed(),
            plane,
            launched,
            ridge,
        })
    }
}

/// Position of the maximum of each row: vertex of the parabola through the best node and its
/// neighbours. A row is omitted if its best node is at an end, or beside a node without a value.
fn ridge(plane: &Plane) -> Vec<[f64; 2]> {
    let width = (plane.across.high - plane.across.low) / (plane.columns - 1) as f64;
    let best = |(row, values): (usize, &[Option<f64>])| {
        let known = values
            .iter()
            .enumerate()
            .filter_map(|(i, value)| Some((i, (*value)?)));
        let (column, top) = known.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let (left, right) = (
            values.get(column.checked_sub(1)?)?.as_ref()?,
            values.get(column + 1)?.as_ref()?,
        );
        let curvature = left - 2.0 * top + right;
        let part = if curvature < 0.0 {
            0.5 * (left - right) / curvature
        } else {
            0.0
        };
        let [x, y] = plane.node(row * plane.columns + column);
        Some([x + part * width, y])
    };
    plane.values[0]
        .chunks(plane.columns)
        .enumerate()
        .filter_map(best)
        .collect()
}
