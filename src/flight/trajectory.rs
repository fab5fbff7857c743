use super::ending::Flight;
use super::inputs::Inputs;
use super::septic::Path;
use crate::error::Result;
use crate::ground::Turf;
use crate::launch::Launch;
use crate::number::Vector;
use crate::parameters::Setup;

/// s: points of a path are no farther apart.
const MOST_APART: f64 = 0.05;

/// The path of a flight.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// Where the ball is at launch, after each step, and within long steps every 0.05 s or less;
    /// where it landed, the landing is the last point.
    pub points: Vec<TrajectoryPoint>,
    /// How the flight ends.
    pub flight: Flight<f64>,
    /// The way from the landing through the bounces to where the ball rests, m in the ground frame:
    /// from the last bounce it goes straight to its rest. Empty where it embeds, or does not land.
    pub run: Vec<Vector<f64>>,
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
    setup.flight.check_steps()?;
    let start = TrajectoryPoint {
        time: 0.0,
        position: Vector::zero(),
        velocity: launch.velocity,
    };
    let mut points = vec![start];
    let inputs = Inputs::new(setup, launch, false);
    let (h, parts) = (
        setup.flight.step,
        (setup.flight.step / MOST_APART).ceil().max(1.0),
    );
    let (mut last, mut run) = (None, vec![]);
    let flight = inputs.fly(Some(&mut |begin, step| {
        last = Some((begin, [*step.from, *step.to]));
        if parts > 1.0 {
            let path = Path::new(&inputs, step, h);
            let within = (1..parts as u32).map(|k| f64::from(k) / parts);
            points.extend(within.map(|s| TrajectoryPoint {
                time: begin + s * h,
                position: path.position(s),
                velocity: path.velocity(s),
            }));
        }
        let end = &*step.to;
        points.push(TrajectoryPoint {
            time: begin + h,
            position: end.position,
            velocity: end.velocity,
        });
    }))?;
    if let Flight::Landed(landed) = &flight {
        points.retain(|point| point.time < landed.flight_time);
        points.push(TrajectoryPoint {
            time: landed.flight_time,
            position: Vector::new(setup.ground.height, landed.lateral, landed.carry),
            velocity: landed.velocity,
        });
        if let Some((begin, [from, to])) = last {
            let spin = inputs.spin_within([&from, &to], (landed.flight_time - begin) / h);
            run = Turf::new(setup).path(&inputs.landing(landed, spin));
        }
    }
    Ok(Trajectory {
        points,
        flight,
        run,
    })
}
