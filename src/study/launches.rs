use super::Vary;
use super::plane::Plane;
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::parameters::{LaunchConditions, Setup};

/// The carry over launch angle and backspin at a ball speed: what a ball that leaves the club as
/// fast does with another launch.
#[derive(Clone, Debug)]
pub struct Launches {
    /// The setup, its ball launched as its club does it.
    pub setup: Setup<f64>,
    /// The ball speed, m/s.
    pub ball_speed: f64,
    /// Carries over `launch.launch_angle` and `launch.backspin`, SI.
    pub plane: Plane,
    /// The launches of the drives shown, the setup's own first.
    pub launched: Vec<Launched>,
    /// The best launch angle for each backspin, with that backspin, where it lies within the map.
    pub ridge: Vec<[f64; 2]>,
}

/// How a ball leaves.
#[derive(Clone, Debug, PartialEq)]
pub struct Launched {
    /// What the drive is called.
    pub name: String,
    /// Launch angle, rad.
    pub launch_angle: f64,
    /// Backspin, rad/s.
    pub backspin: f64,
    /// Ball speed, m/s: that of the map for the first.
    pub ball_speed: f64,
    /// Its own carry, m; `None` where it does not fly.
    pub carry: Option<f64>,
}

impl Launched {
    fn of(name: &str, drive: &Drive<f64>) -> Self {
        let launch = &drive.launch;
        Self {
            name: name.into(),
            launch_angle: launch.launch_angle(),
            backspin: launch.backspin(),
            ball_speed: launch.ball_speed(),
            carry: Outcome::Carry.value(drive),
        }
    }
}

/// How far a map goes beyond the launches in it, rad and rad/s, and what its ends are multiples of.
const BEYOND: [f64; 2] = [7.0 * DEGREE, 1250.0 * RPM];
const ENDS: [f64; 2] = [DEGREE, 250.0 * RPM];
const DEGREE: f64 = std::f64::consts::PI / 180.0;
const RPM: f64 = std::f64::consts::PI / 30.0;

/// Nodes to each side.
const NODES: usize = 61;

impl Launches {
    /// The map at the ball speed of the first of some drives, with the launches of all.
    ///
    /// # Errors
    /// As [`Drive::new`] and [`Batch::new`](crate::batch::Batch::new); [`Error::Nothing`] without a
    /// drive; [`Error::NoFlight`] where nothing on the map flies.
    pub fn around(drives: &[(&str, &Setup<f64>)]) -> Result<Self> {
        let mut launched = vec![];
        let mut first = None;
        for (name, setup) in drives {
            let drive = Drive::new(setup)?;
            launched.push(Launched::of(name, &drive));
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
        let vary = |name: &str, axis: usize, of: fn(&Launched) -> f64| -> Result<Vary> {
            let values = || launched.iter().map(of);
            let (low, high) = (
                values().fold(f64::INFINITY, f64::min),
                values().fold(f64::NEG_INFINITY, f64::max),
            );
            let end = ENDS[axis];
            // the angle and the backspin of a drive that is hit well are above 0
            let low = (((low - BEYOND[axis]) / end).round() * end).max(low.min(0.0));
            Vary::new(
                setup.column(name)?,
                low,
                ((high + BEYOND[axis]) / end).round() * end,
            )
        };
        let across = vary("launch.launch_angle", 0, |one| one.launch_angle)?;
        let up = vary("launch.backspin", 1, |one| one.backspin)?;
        let plane = Plane::fly(&setup, &[Outcome::Carry], across, up, [NODES; 2])?;
        if plane.values[0].iter().all(Option::is_none) {
            return Err(Error::NoFlight {
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

/// The best place across in each row: the top of the parabola through the best node and its
/// neighbours.
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
        let bend = left - 2.0 * top + right;
        let part = if bend < 0.0 {
            0.5 * (left - right) / bend
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
