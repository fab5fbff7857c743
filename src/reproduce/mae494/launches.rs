use crate::derivative::{self, Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::{
    Domain, Evaluation, Observers, Options, Problem, Status, minimize_from, starts,
};
use crate::parameters::Setup;
use crate::reproduce::RecomputedOptimum;
use crate::reproduce::delivery::{ATTACK_ANGLE, DeliveryCarry, LOFT};
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// A straight launch with its carry.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Launched {
    /// The ball speed, m/s.
    #[serde(rename = "ball_speed")]
    pub speed: f64,
    /// The launch angle, rad.
    #[serde(rename = "launch_angle")]
    pub angle: f64,
    /// The backspin, rad/s.
    #[serde(rename = "backspin")]
    pub spin: f64,
    /// The carry, m.
    pub carry: f64,
}

impl Launched {
    /// A launch x = (ball speed, launch angle, backspin) with its carry.
    fn new(x: &[f64], carry: f64) -> Self {
        Self {
            speed: x[0],
            angle: x[1],
            spin: x[2],
            carry,
        }
    }
}

/// Limits that the laws of impact set to the report's distances: the maximum ball speed, and the
/// maximum carry at this speed.
///
/// e is the coefficient of restitution, m the mass of the ball, M the mass of the club head, V the
/// club speed and v the ball speed.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Energy {
    /// Maximum ball speed, (1 + e)/(1 + m/M) V, m/s.
    #[serde(rename = "fastest_ball_speed")]
    pub fastest: f64,
    /// Launch of maximum carry at the maximum ball speed; launch angle and spin are varied.
    pub farthest: Launched,
    /// Derivative of carry by ball speed at that launch, m per m/s.
    pub carry_per_ball_speed: f64,
    /// Slowest launch that reaches the report's longest carry.
    pub needed: Launched,
    /// The club's kinetic energy, ½ M V², J.
    #[serde(rename = "club_energy")]
    pub club: f64,
    /// The ball's kinetic energy at maximum speed, ½ m v², J.
    #[serde(rename = "ball_energy")]
    pub ball: f64,
    /// The ball's kinetic energy for the report's longest carry, J.
    #[serde(rename = "ball_energy_needed")]
    pub ball_needed: f64,
}

/// The report's "subsystem optimum": the best launch of the flight alone, compared with launches
/// that the impact can produce.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Subsystems {
    /// Launch at the optimum of the whole system.
    pub whole: Launched,
    /// Launch that flies farthest at the ball speed of `whole`.
    pub flight: Launched,
    /// Delivery with the largest ball speed at the attack angle of the optimum,
    /// with its carry.
    pub impact: DeliveryCarry,
    /// Derivatives of carry by each launch condition at the optimum: m per m/s, per rad, per rad/s.
    #[serde(rename = "carry_by")]
    pub slopes: ByLaunch,
    /// For each launch condition: the derivative of carry by this condition, times the derivative
    /// of the condition by loft, m/rad. The sum is 0 at the optimum.
    #[serde(rename = "carry_by_loft_through")]
    pub by_loft: ByLaunch,
    /// For each launch condition: the derivative of carry by this condition, times the derivative
    /// of the condition by attack angle, m/rad. The sum is the multiplier of the bound on the
    /// attack angle.
    #[serde(rename = "carry_by_attack_angle_through")]
    pub by_attack_angle: ByLaunch,
}

/// A number for each condition of a straight launch.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ByLaunch {
    /// For the ball speed.
    pub ball_speed: f64,
    /// For the launch angle.
    pub launch_angle: f64,
    /// For the backspin.
    pub backspin: f64,
}

impl ByLaunch {
    /// Ball speed, launch angle, backspin.
    pub fn to_array(self) -> [f64; 3] {
        [self.ball_speed, self.launch_angle, self.backspin]
    }
}

/// Minimum ball speed of the searches, m/s.
const SLOWEST: f64 = 10.0;
/// Maximum ball speed of the searches, m/s: faster than any golf ball.
const MOST_SPEED: f64 = 300.0;
/// Maximum spin of the searches, rad/s: more than any golf ball has.
const MOST_SPIN: f64 = 1000.0;

/// Range of the launch angle, rad: from almost horizontal to almost vertical. The carry is short at
/// both ends.
const ANGLES: [f64; 2] = [0.01, FRAC_PI_2 - 0.01];

impl Energy {
    /// Checks the report's longest carry `distance`, m, for the club of `setup`.
    pub(super) fn new(setup: &Setup<f64>, distance: f64) -> Result<Self> {
        let (head, ball) = (setup.club.mass, setup.ball.mass);
        let fastest = (1.0 + setup.impact.restitution) / (1.0 + ball / head) * setup.swing.speed;
        let alone = FlightAlone::new(setup, None)?;
        let (farthest, prices) = alone.best([SLOWEST, fastest])?;
        let slowest = FlightAlone::new(setup, Some(distance))?;
        let (needed, _) = slowest.best([SLOWEST, MOST_SPEED])?;
        let energy = |mass: f64, speed: f64| 0.5 * mass * speed * speed;
        Ok(Self {
            fastest,
            farthest,
            carry_per_ball_speed: prices[0],
            needed,
            club: energy(head, setup.swing.speed),
            ball: energy(ball, fastest),
            ball_needed: energy(ball, needed.speed),
        })
    }
}

impl Subsystems {
    /// The launch at the optimum of the whole system, the best launch of the flight alone, and the
    /// delivery with the largest ball speed.
    pub(super) fn new(optimum: &RecomputedOptimum) -> Result<Self> {
        let setup = &optimum.best.setup;
        let quantities = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Backspin];
        let wrt = [setup.variable(LOFT)?, setup.variable(ATTACK_ANGLE)?];
        let impact = derivative::evaluate(setup, &quantities, &wrt, Order::First)?;
        let launch: Vec<f64> = impact.iter().map(|quantity| quantity.value).collect();
        let alone = FlightAlone::new(setup, None)?;
        let failed = |message| Error::Undefined {
            what: "the carry of the launch".into(),
            reason: message,
        };
        let flight: Taylor = alone
            .evaluate(&launch)
            .map(|all: Evaluation| all.objective)
            .map_err(failed)?
            .negated();
        let slopes = ByLaunch {
            ball_speed: flight.gradient[0],
            launch_angle: flight.gradient[1],
            backspin: flight.gradient[2],
        };
        let through = |parameter: usize| ByLaunch {
            ball_speed: slopes.ball_speed * impact[0].gradient[parameter],
            launch_angle: slopes.launch_angle * impact[1].gradient[parameter],
            backspin: slopes.backspin * impact[2].gradient[parameter],
        };
        let (own_choice, _) = alone.best([launch[0], launch[0]])?;
        let attack_angle = optimum.exact().attack_angle;
        Ok(Self {
            whole: Launched::new(&launch, flight.value),
            flight: own_choice,
            impact: DeliveryCarry::flown(setup, 0.0, attack_angle)?,
            slopes,
            by_loft: through(0),
            by_attack_angle: through(1),
        })
    }
}

/// The flight without a club, as a function of its launch x = (ball speed, launch angle, backspin).
struct FlightAlone {
    carry: Evaluator,
    /// If set, the search minimizes the ball speed of launches with at least this carry, m. If
    /// `None`, the search maximizes the carry.
    least_carry: Option<f64>,
}

impl FlightAlone {
    fn new(setup: &Setup<f64>, least_carry: Option<f64>) -> Result<Self> {
        let mut setup = *setup;
        let given = &mut setup.launch;
        (given.ball_speed, given.launch_angle, given.backspin) =
            (Some(MOST_SPEED), Some(ANGLES[0]), Some(0.0));
        let conditions = [
            "launch.ball_speed",
            "launch.launch_angle",
            "launch.backspin",
        ];
        let wrt = setup.variables_named(conditions)?;
        Ok(Self {
            carry: Evaluator::new(&setup, &[Outcome::Carry], &wrt, Order::Second)?,
            least_carry,
        })
    }

    /// The best launch with a ball speed within `speeds`, m/s, and the multipliers of the upper
    /// bounds.
    fn best(&self, speeds: [f64; 2]) -> Result<(Launched, Vec<f64>)> {
        let domain = Domain::new(
            vec![speeds[0], ANGLES[0], 0.0],
            vec![speeds[1], ANGLES[1], MOST_SPIN],
        )?;
        let domain = match self.least_carry {
            None => domain,
            Some(carry) => domain.with_constraints(vec![carry], vec![f64::INFINITY])?,
        };
        let middle: Vec<f64> = (0..3)
            .map(|i| 0.5 * (domain.variables.low[i] + domain.variables.high[i]))
            .collect();
        let starts = starts(&domain, &middle, 16)?;
        let found = minimize_from(
            self,
            &domain,
            &starts,
            &Options::default(),
            &Observers::default(),
        )?;
        let best = found
            .into_iter()
            .map(|local| local.solution)
            .find(|best| best.status == Status::Converged);
        let best = best.ok_or(Error::Nothing {
            doing: "find",
            what: "best launch",
        })?;
        let carry = match self.least_carry {
            None => -best.value.unwrap_or_default(),
            Some(_) => best.constraints[0].value,
        };
        Ok((Launched::new(&best.x, carry), best.upper_multipliers))
    }
}

impl Problem for FlightAlone {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        let carry = self
            .carry
            .at(x)
            .map_err(|error| error.to_string())?
            .swap_remove(0);
        Ok(match self.least_carry {
            None => Evaluation::unconstrained(carry.negated()),
            Some(_) => {
                let speed = Taylor {
                    value: x[0],
                    gradient: vec![1.0, 0.0, 0.0],
                    ..Taylor::zero(3, 3)
                };
                Evaluation {
                    objective: speed,
                    constraints: vec![carry],
                }
            }
        })
    }
}
