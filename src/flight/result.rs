use super::divergence::advice;
use super::ending::{Apex, Landed, NoFlight};
use super::inputs::Inputs;
use crate::error::{Error, Result};
use crate::launch::Launch;
use crate::number::{Mask, Numbers, Vector};

/// What is asked of flights beside where and how they land.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RequestedOutputs {
    /// The highest point.
    pub apex: bool,
    /// What tells of the error of the integration.
    pub defect: bool,
}

/// Flights side by side, or one, that have ended.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlightResult<T: Numbers> {
    /// The landings, where `has_landed`.
    pub landed: Landed<T>,
    pub has_landed: T::Mask,
    /// Where the apex stays below the ground.
    pub stays_below: T::Mask,
    /// Where drag and lift change the velocity too much within a step to be followed, or numbers
    /// overflow.
    pub diverges: T::Mask,
    /// Where the ball is still in the air when the time is over.
    pub is_aloft: T::Mask,
    /// The height of an apex that stays below the ground, and of a ball still in the air, m.
    pub height: T,
    /// The spin at landing, rad/s, where the run is asked for.
    pub spin: T,
    /// How much of the defect is of the place of the apex, m, where both are asked for.
    pub defect_of_apex: T,
    /// When the last step ended, s: that of the longest flight, where there are several.
    pub time: f64,
}

impl<T: Numbers> FlightResult<T> {
    /// Before the first step.
    #[inline(always)]
    pub(super) fn initial(asked: RequestedOutputs) -> Self {
        let (zero, none) = (T::zero(), T::Mask::none());
        let landed = Landed {
            carry: zero,
            lateral: zero,
            flight_time: zero,
            velocity: Vector::zero(),
            apex: asked.apex.then_some(Apex {
                height: zero,
                time: zero,
                downrange: zero,
            }),
            rest: None,
            defect: asked.defect.then_some(zero),
            steps: 0,
        };
        Self {
            landed,
            has_landed: none,
            stays_below: none,
            diverges: none,
            is_aloft: none,
            height: zero,
            spin: zero,
            defect_of_apex: zero,
            time: 0.0,
        }
    }

    /// Why the flight in the first lane has no landing; `None` where it has one. `value` takes the
    /// value in this lane out of a number.
    ///
    /// # Errors
    /// [`Error::Diverged`] where drag and lift change the airspeed too much within a step, or
    /// numbers overflow.
    #[inline(always)]
    pub(crate) fn no_landing_reason(
        &self,
        inputs: &Inputs<T>,
        value: impl Fn(T) -> f64 + Copy,
    ) -> Result<Option<NoFlight>> {
        if self.has_landed.holds(0) {
            return Ok(None);
        }
        let (velocity, height) = (inputs.velocity.map(value), value(self.height));
        if self.diverges.holds(0) {
            let (step, wind) = (inputs.step, inputs.wind.at(inputs.ground).map(value));
            let found = [
                velocity.norm(),
                value(inputs.spin),
                value(inputs.force_per_mass),
                wind.norm(),
            ];
            let advice = advice(step, found, inputs.law.name());
            return Err(Error::Diverged {
                time: self.time - step,
                step,
                advice,
            });
        }
        Ok(Some(if self.stays_below.holds(0) {
            NoFlight::BelowGround {
                apex_height: height,
                ground_height: value(inputs.ground),
            }
        } else if self.is_aloft.holds(0) {
            NoFlight::Aloft {
                time: inputs.time_limit,
                height,
            }
        } else {
            // the angle does not ask for the spin
            NoFlight::LaunchedDown {
                launch_angle: Launch {
                    velocity,
                    spin: velocity,
                }
                .launch_angle(),
            }
        }))
    }
}
