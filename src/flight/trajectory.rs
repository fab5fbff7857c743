use super::inputs::Inputs;
use super::result::{Flight, RequestedOutputs};
use super::septic::StepPath;
use crate::error::Result;
use crate::launch::Launch;
use crate::number::Vector;
use crate::parameters::Setup;
use std::sync::atomic::AtomicBool;

/// Largest time between two points of a trajectory, s.
const LARGEST_INTERVAL: f64 = 0.05;

/// Path of a flight and of the run after it.
#[derive(Clone, Debug)]
pub struct Trajectory {
    /// The launch and the end of each step. Steps longer than 0.05 s have points in between. If the
    /// ball lands, the last point is the landing.
    pub points: Vec<TrajectoryPoint>,
    /// Result of the flight.
    pub flight: Flight<f64>,
    /// Points of the path from the landing to rest, m, relative to the landing point, in the ground
    /// frame: the hops, then a straight line. Empty if the ball embeds or does not land.
    pub run: Vec<Vector<f64>>,
}

/// One point of a trajectory, in the ground frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrajectoryPoint {
    /// Time from launch, s.
    pub time: f64,
    /// Position, m.
    pub position: Vector<f64>,
    /// Velocity, m/s.
    pub velocity: Vector<f64>,
    /// Angular velocity, rad/s.
    pub spin: Vector<f64>,
}

/// Flies the ball and records its path.
///
/// ```
/// use longdrive::{Setup, flight, impact};
/// let setup = Setup::modern_driver();
/// let path = flight::trajectory(&setup, &impact::strike(&setup).unwrap().launch).unwrap();
/// assert_eq!(path.points[0].position.x, 0.0);
/// assert!(path.points.last().unwrap().position.x.abs() < 1e-12); // on the ground
/// ```
///
/// # Errors
/// The errors of [`fly`](super::fly).
pub fn trajectory(setup: &Setup<f64>, launch: &Launch<f64>) -> Result<Trajectory> {
    trajectory_until(setup, launch, &AtomicBool::new(false))
}

/// Like [`trajectory`]; interrupted once `stop` is true.
///
/// # Errors
/// The errors of [`fly`](super::fly); [`Error::Stopped`](crate::Error::Stopped) after an interrupt.
pub fn trajectory_until(
    setup: &Setup<f64>,
    launch: &Launch<f64>,
    stop: &AtomicBool,
) -> Result<Trajectory> {
    setup.flight.check_steps()?;
    let start = TrajectoryPoint {
        time: 0.0,
        position: Vector::zero(),
        velocity: launch.velocity,
        spin: launch.spin,
    };
    let mut points = vec![start];
    let inputs = Inputs::new(setup, launch);
    let h = setup.flight.step;
    let intervals = (h / LARGEST_INTERVAL).ceil().max(1.0);
    let mut last_step = None;
    let outputs = RequestedOutputs::without_run(stop);
    let flight = inputs.fly(
        outputs,
        Some(&mut |begin, step| {
            last_step = Some((begin, [*step.from, *step.to]));
            if intervals > 1.0 {
                let path = StepPath::new(&inputs, step);
                let within = (1..intervals as u32).map(|k| f64::from(k) / intervals);
                points.extend(within.map(|s| TrajectoryPoint {
                    time: begin + s * h,
                    position: path.position(s),
                    velocity: path.velocity(s),
                    spin: inputs.axis * inputs.spin_within([&*step.from, &*step.to], s),
                }));
            }
            let end = &*step.to;
            points.push(TrajectoryPoint {
                time: begin + h,
                position: end.position,
                velocity: end.velocity,
                spin: inputs.axis * end.spin,
            });
        }),
    )?;
    let mut run = vec![];
    if let Flight::Landed(landed) = &flight {
        points.retain(|point| point.time < landed.flight_time);
        let mut spin = launch.spin;
        if let Some((begin, [from, to])) = last_step {
            let landing_spin = inputs.spin_within([&from, &to], (landed.flight_time - begin) / h);
            spin = inputs.axis * landing_spin;
            run = inputs.turf.path(&inputs.landing(landed, landing_spin));
        }
        points.push(TrajectoryPoint {
            time: landed.flight_time,
            position: Vector::new(setup.ground.height, landed.lateral, landed.carry),
            velocity: landed.velocity,
            spin,
        });
    }
    Ok(Trajectory {
        points,
        flight,
        run,
    })
}
