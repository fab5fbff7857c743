use super::landing::{Flight, Wanted};
use super::node::State;
use super::pace::Pace;
use super::shot::Shot;
use crate::error::Result;
use crate::launch::Launch;
use crate::number::Vector;
use crate::parameters::Setup;

/// The path of a flight, node by node.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// Where the ball is at launch and after each step; where it landed, the landing is the last point.
    pub points: Vec<TrajectoryPoint>,
    /// How the flight ends.
    pub flight: Flight<f64>,
}

/// One point of a path, in the ground frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrajectoryPoint {
    /// Time from launch, s.
    pub time: f64,
    /// Position, m.
    pub position: Vector<f64>,
    /// Velocity, m/s.
    pub velocity: Vector<f64>,
}

/// Flies the ball and keeps its path.
///
/// ```
/// use longdrive::{Setup, flight, impact};
/// let setup = Setup::default();
/// let path = flight::trajectory(&setup, &impact::strike(&setup).unwrap().launch).unwrap();
/// assert_eq!(path.points[0].position.x, 0.0);
/// assert!(path.points.last().unwrap().position.x.abs() < 1e-12); // on the ground again
/// ```
///
/// # Errors
/// As [`fly`](super::fly).
pub fn trajectory(setup: &Setup<f64>, launch: &Launch<f64>) -> Result<Trajectory> {
    let mut points = Vec::new();
    let shot = Shot::new(setup, launch);
    let flight = shot.fly::<Vector<f64>>(&Pace::of(setup), Wanted::Apex, |node| {
        let State { time, position, velocity, .. } = node.state;
        points.push(TrajectoryPoint { time, position, velocity });
    })?;
    if let Flight::Landed(landed) = &flight {
        points.push(TrajectoryPoint {
            time: landed.flight_time,
            position: Vector::new(setup.ground.height, landed.lateral, landed.carry),
            velocity: landed.velocity,
        });
    }
    Ok(Trajectory { points, flight })
}
