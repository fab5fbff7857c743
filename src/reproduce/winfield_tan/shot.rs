use super::printed;
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::impact::strike;
use crate::parameters::Setup;
use crate::units::{MPH, YARD};
use serde::Serialize;

/// Values of the single shot, computed or printed, SI. JSON contains only the values of the flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SingleShot {
    /// Upward ball speed, m/s.
    #[serde(skip)]
    pub up: f64,
    /// Downrange ball speed, m/s.
    #[serde(skip)]
    pub downrange: f64,
    /// Backspin, rad/s.
    #[serde(skip)]
    pub backspin: f64,
    /// Downrange club speed after impact, m/s.
    #[serde(skip)]
    pub club_after: f64,
    /// Launch angle, rad.
    #[serde(skip)]
    pub launch_angle: f64,
    /// Carry, m.
    pub carry: f64,
    /// Flight time, s.
    pub flight_time: f64,
    /// Apex height, m.
    pub apex_height: f64,
    /// Time of apex, s.
    pub apex_time: f64,
}

/// The single shot, computed and printed.
#[derive(Clone, Copy, Debug)]
pub struct ShotComparison {
    /// Club speed before impact, m/s.
    pub club_speed: f64,
    /// Computed values.
    pub computed: SingleShot,
    /// Printed values.
    pub printed: SingleShot,
    /// Mean and standard deviation of the robot's distances, m.
    pub robot: (f64, f64),
}

impl ShotComparison {
    pub(super) fn new(setup: &Setup<f64>) -> Result<Self> {
        let [speed, loft, attack] = printed::SHOT_DELIVERY;
        let mut at = *setup;
        at.swing.speed = speed * MPH;
        (at.club.loft, at.swing.attack_angle) = (loft.to_radians(), attack.to_radians());
        let drive = Drive::new(&at)?;
        let of = |outcome: Outcome| outcome.of(&drive);
        let impact = strike(&at)?;
        let computed = SingleShot {
            up: drive.launch.velocity.x,
            downrange: drive.launch.velocity.z,
            backspin: of(Outcome::Backspin)?,
            club_after: impact.club_velocity.z,
            launch_angle: of(Outcome::LaunchAngle)?,
            carry: of(Outcome::Carry)?,
            flight_time: of(Outcome::FlightTime)?,
            apex_height: of(Outcome::ApexHeight)?,
            apex_time: of(Outcome::ApexTime)?,
        };
        let (
            [up, downrange, revolutions, club_after, angle],
            [carry, flight_time, apex, apex_time],
        ) = (printed::IMPACT, printed::SHOT);
        let printed = SingleShot {
            up: up * MPH,
            downrange: downrange * MPH,
            backspin: revolutions * std::f64::consts::TAU,
            club_after: club_after * MPH,
            launch_angle: angle.to_radians(),
            carry: carry * YARD,
            flight_time,
            apex_height: apex * YARD,
            apex_time,
        };
        let [mean, deviation] = printed::ROBOT;
        Ok(Self {
            club_speed: at.swing.speed,
            computed,
            printed,
            robot: (mean * YARD, deviation * YARD),
        })
    }
}
