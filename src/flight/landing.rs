//! Integration of a flight up to its landing: the loop over the steps, and the events within a step
//! (docs/model.md, eqs. 16a–18).

use super::inputs::Inputs;
use super::motion::StepNode;
use super::result::{FlightResult, Landed, RequestedOutputs};
use super::septic::StepPath;
use super::step::{Step, StepObserver, Stepper};
use super::tableau::Tableau;
use crate::aerodynamics::AerodynamicLaw;
use crate::ground::LandingState;
use crate::number::{Mask, Numbers, Vector, inlined};

/// Additional weight of the defect of the last step (eq. 16a), in which the landing is
/// interpolated. The error of this interpolation is 30 to 110 times the integration error of a step
/// with the same defect.
const INTERPOLATION_WEIGHT: f64 = 100.0;

/// State of the lanes between two steps.
#[derive(Clone, Copy)]
struct LaneStates<M> {
    /// Lanes in flight.
    flying: M,
    /// Lanes that have been above the ground.
    has_been_above: M,
}

/// Events that a step may contain.
#[derive(Clone, Copy)]
struct StepEvents<M> {
    /// Lanes whose vertical velocity changes its sign: the apex is in the step.
    has_apex: M,
    /// Lanes that may land.
    may_land: M,
    /// True if the position of the apex must be found: it is requested, or it decides whether the
    /// ball clears the ground.
    needs_apex: bool,
    /// True if the time limit is in the step.
    has_time_limit: bool,
}

impl<T: Numbers, L: AerodynamicLaw<T>> Inputs<T, L> {
    /// Integrates the flights of `lanes` up to the landing. A ball flies if it is above the landing
    /// area at launch, or if it rises.
    #[inline(always)]
    pub(crate) fn integrate(
        &self,
        lanes: T::Mask,
        outputs: RequestedOutputs<'_>,
        mut observer: StepObserver<'_, T>,
    ) -> FlightResult<T> {
        T::not_inlined(inlined!(|| self.integrate_inlined(
            lanes,
            outputs,
            &mut observer
        )))
    }

    #[inline(always)]
    fn integrate_inlined(
        &self,
        lanes: T::Mask,
        outputs: RequestedOutputs<'_>,
        observer: &mut StepObserver<'_, T>,
    ) -> FlightResult<T> {
        let mut stepper = Stepper::new(self);
        let mut nodes = [self.launch(); 2];
        let [from, to] = &mut nodes;
        let mut step = Step {
            from,
            to,
            position_increment: Vector::zero(),
            velocity_increment: Vector::zero(),
        };
        let has_been_above = self.ground.below(0.0);
        let mut lanes = LaneStates {
            flying: lanes & (has_been_above | is_rising(step.to)),
            has_been_above,
        };
        let mut result: FlightResult<T> = FlightResult::initial(outputs);
        while lanes.flying.any() && result.time < self.time_limit {
            stepper.advance(&mut step);
            if let Some(observe) = observer {
                // a copy, so that the original `step` can stay in registers
                let step = Step {
                    from: &mut *step.from,
                    to: &mut *step.to,
                    ..step
                };
                observe(result.time, &step);
            }
            lanes.flying = self.check_step(&step, stepper.tableau, lanes.flying, &mut result);

            let end = (result.landed.steps + 1) as f64 * self.step;
            let is_above = (self.ground - step.to.position.x).below(0.0);
            let events = self.step_events(&step, lanes, is_above, outputs.apex, end);
            if events.may_land.any() || events.needs_apex || events.has_time_limit {
                let step = Step {
                    from: &mut *step.from,
                    to: &mut *step.to,
                    ..step
                };
                // copies for the closure, so that the originals can stay in registers
                let lanes_before = lanes;
                let expected = events;
                lanes = T::not_inlined(inlined!(|| self.locate_events(
                    &step,
                    lanes_before,
                    expected,
                    &mut result
                )));
            }
            lanes.has_been_above = lanes.has_been_above | is_above;
            result.landed.steps += 1;
            result.time = end;
            if outputs.stops_at(result.landed.steps) {
                result.is_stopped = true;
                break;
            }
        }
        result.is_aloft = lanes.flying;
        if let Some(spin) = result.spin {
            let landing = self.landing(&result.landed, spin);
            result.landed.rest = Some(self.turf.rest(&landing, result.has_landed));
        }
        result
    }

    /// Ends the flights that diverge: the step is too long for their drag and lift, or a number
    /// overflows. For the other flights, adds the defect of the step (eq. 16a). Returns the lanes
    /// still in flight.
    #[inline(always)]
    fn check_step(
        &self,
        step: &Step<'_, T>,
        tableau: &Tableau,
        flying: T::Mask,
        result: &mut FlightResult<T>,
    ) -> T::Mask {
        // comparisons with NaN are false, so a flight with an overflow diverges
        let is_resolved = self.is_resolved(step.from, tableau.largest_relative_change)
            & step.to.position.x.is_finite();
        result.diverges = result.diverges | flying & !is_resolved;
        let flying = flying & is_resolved;
        if let Some(sum) = &mut result.defect_sum {
            let defect = step.defect(self.step).without_derivatives();
            *sum = (*sum + defect).select(*sum, flying);
        }
        flying
    }

    /// Events that a step may contain, from its two nodes. `end` is the time at the end of the
    /// step, s.
    #[inline(always)]
    fn step_events(
        &self,
        step: &Step<'_, T>,
        lanes: LaneStates<T::Mask>,
        is_above: T::Mask,
        is_apex_requested: bool,
        end: f64,
    ) -> StepEvents<T::Mask> {
        let LaneStates {
            flying,
            has_been_above,
        } = lanes;
        let has_apex = flying & is_rising(step.from) & !is_rising(step.to);
        let may_land = flying & !is_above & (has_been_above | has_apex);
        let apex_decides = has_apex & !(has_been_above & is_above);
        StepEvents {
            has_apex,
            may_land,
            needs_apex: apex_decides.any() || is_apex_requested && has_apex.any(),
            has_time_limit: end >= self.time_limit,
        }
    }

    /// Locates the events of a step on the interpolated path: the height at the time limit, the
    /// apex, the landing. Returns the state of the lanes at the end of the step.
    #[inline(always)]
    fn locate_events(
        &self,
        step: &Step<'_, T>,
        mut lanes: LaneStates<T::Mask>,
        events: StepEvents<T::Mask>,
        result: &mut FlightResult<T>,
    ) -> LaneStates<T::Mask> {
        let path = StepPath::new(self, step);
        if events.has_time_limit {
            let s = T::constant((self.time_limit - result.time) / self.step);
            result.height = path.up.value(s).select(result.height, lanes.flying);
        }
        let mut from_apex = T::zero();
        if events.needs_apex {
            let s = path.up.find_maximum(events.has_apex);
            from_apex = s.select(from_apex, events.has_apex);
            lanes = self.record_apex(step, &path, s, lanes, events.has_apex, result);
        }
        let lands = lanes.flying & events.may_land & lanes.has_been_above;
        if lands.any() {
            let s = path.up.find_crossing(self.ground, from_apex, lands);
            let lands = self.record_landing(step, &path, s, lands, result);
            lanes.flying = lanes.flying & !lands;
        }
        lanes
    }

    /// Records the apex at s = (t − t₀)/h within a step. Ends a flight that has never been above
    /// the ground if its apex does not clear the ground.
    #[inline(always)]
    fn record_apex(
        &self,
        step: &Step<'_, T>,
        path: &StepPath<T>,
        s: T,
        mut lanes: LaneStates<T::Mask>,
        has_apex: T::Mask,
        result: &mut FlightResult<T>,
    ) -> LaneStates<T::Mask> {
        let h = self.step;
        let top = path.position(s);
        if let Some(apex) = &mut result.landed.apex {
            let is_higher = has_apex & (apex.height - top.x).below(0.0);
            apex.height = top.x.select(apex.height, is_higher);
            apex.time = (s * h + result.time).select(apex.time, is_higher);
            apex.downrange = top.z.select(apex.downrange, is_higher);
            // D_A = 400 d |v_A|/(h a_A), eq. 16a, with the defect d of the step, and the velocity
            // v_A and the downward acceleration a_A at the apex. 400 = 4 · 100: an error of the
            // path proportional to s⁴(1 − s)⁴ has a derivative by s of up to 4 times its maximum,
            // and this derivative shifts the apex.
            if result.defect_sum.is_some() {
                let per_defect = path.velocity(s).norm() * (4.0 * INTERPOLATION_WEIGHT * h)
                    / -path.up.second_derivative(s);
                let apex_defect = step.defect(h) * per_defect;
                result.apex_defect = apex_defect
                    .without_derivatives()
                    .select(result.apex_defect, is_higher);
            }
        }
        let clears = has_apex & (self.ground - top.x).below(0.0);
        let stays_below = has_apex & !clears & !lanes.has_been_above;
        result.height = top.x.select(result.height, stays_below);
        result.stays_below = result.stays_below | stays_below;
        lanes.flying = lanes.flying & !stays_below;
        lanes.has_been_above = lanes.has_been_above | clears;
        lanes
    }

    /// Records the landing at s = (t − t₀)/h within a step. Returns the lanes that land before the
    /// time limit.
    #[inline(always)]
    fn record_landing(
        &self,
        step: &Step<'_, T>,
        path: &StepPath<T>,
        s: T,
        lands: T::Mask,
        result: &mut FlightResult<T>,
    ) -> T::Mask {
        let h = self.step;
        let time = s * h + result.time;
        let lands = lands & !(-time).below(-self.time_limit);
        let (x, v) = (path.position(s), path.velocity(s));
        let landed = &mut result.landed;
        landed.carry = x.z.select(landed.carry, lands);
        landed.lateral = x.y.select(landed.lateral, lands);
        landed.flight_time = time.select(landed.flight_time, lands);
        landed.velocity = v.select(landed.velocity, lands);
        // D = (sum + 100 d) |v_L|/|v_L,up| + D_A, eq. 16a, with the defect d of the last step
        if let (Some(total), Some(sum)) = (&mut landed.defect, result.defect_sum) {
            let per_sine = (v.norm() / -v.x).without_derivatives();
            let defect = step.defect(h).without_derivatives();
            let here = defect
                .scale_add(INTERPOLATION_WEIGHT, sum)
                .mul_add(per_sine, result.apex_defect);
            *total = here.select(*total, lands);
        }
        if let Some(spin) = &mut result.spin {
            let landing_spin = self.spin_within([step.from, step.to], s);
            *spin = landing_spin.select(*spin, lands);
        }
        result.has_landed = result.has_landed | lands;
        lands
    }

    /// State of the ball at landing; `spin` is |ω| at landing, rad/s.
    #[inline(always)]
    pub(super) fn landing(&self, landed: &Landed<T>, spin: T) -> LandingState<T> {
        LandingState {
            downrange: landed.carry,
            right: landed.lateral,
            velocity: landed.velocity,
            spin: self.axis * spin,
            radius: self.radius,
            gravity: self.gravity,
            force_per_mass: self.force_per_mass,
        }
    }

    /// Lanes in which the step is short enough: drag and lift change the airspeed within the step
    /// by less than the fraction `largest_relative_change`.
    #[inline(always)]
    fn is_resolved(&self, node: &StepNode<T>, largest_relative_change: f64) -> T::Mask {
        let h = self.step;
        let a = node.rate.acceleration;
        let largest_change = node.rate.speed * largest_relative_change;
        let aerodynamic = Vector::new(a.x + self.gravity, a.y, a.z);
        (aerodynamic.dot(aerodynamic) * (h * h) - largest_change * largest_change).below(0.0)
    }
}

#[inline(always)]
fn is_rising<T: Numbers>(node: &StepNode<T>) -> T::Mask {
    (-node.velocity.x).below(0.0)
}
