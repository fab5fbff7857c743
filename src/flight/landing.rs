use super::ending::Landed;
use super::inputs::Inputs;
use super::motion::Node;
use super::result::{FlightResult, RequestedOutputs};
use super::septic::Path;
use super::step::{Observer, Step, Stepper};
use super::tableau::Tableau;
use crate::ground::Landing;
use crate::number::{Mask, Numbers, Vector, inlined};

/// How many times more the defect of the last step counts. Within it the path is interpolated: at
/// the same defect, its error is 30 to 110 times that of a step.
const INTERPOLATED: f64 = 100.0;

/// What may be found within a step, and for which flights.
#[derive(Clone, Copy)]
struct Within<M> {
    flying: M,
    has_been_above: M,
    /// Whose vertical speed changes its sign.
    has_top: M,
    may_land: M,
    /// Whether anything depends on where that top is.
    needs_top: bool,
    /// Whether the time limit lies in the step.
    is_last: bool,
}

impl<T: Numbers> Inputs<T> {
    /// Flies the balls of those lanes that start above the ground or upwards. Not inlined: there is
    /// one compiled copy for each number type.
    #[inline(always)]
    pub(crate) fn integrate(
        &self,
        lanes: T::Mask,
        asked: RequestedOutputs,
        mut observer: Observer<'_, T>,
    ) -> FlightResult<T> {
        T::outlined(inlined!(|| self.integrate_inlined(
            lanes,
            asked,
            &mut observer
        )))
    }

    #[inline(always)]
    fn integrate_inlined(
        &self,
        lanes: T::Mask,
        asked: RequestedOutputs,
        observer: &mut Observer<'_, T>,
    ) -> FlightResult<T> {
        let (tableau, h, ground) = (Tableau::of(self.method), self.step, self.ground);
        let mut stepper = Stepper::new(self, tableau, h);
        let mut nodes = [self.launch(); 2];
        // no step yet: both ends are where the flight begins
        let [from, to] = &mut nodes;
        let mut step = Step {
            from,
            to,
            deflection: Vector::zero(),
            gained: Vector::zero(),
        };
        let mut has_been_above = ground.below(0.0);
        let mut flying = lanes & (has_been_above | is_rising(step.to));
        let mut ended: FlightResult<T> = FlightResult::initial(asked);
        while flying.any() && ended.time < self.time_limit {
            stepper.advance(&mut step);
            if let Some(observe) = observer {
                // the address of the loop's own step is not handed on: it stays in registers
                observe(
                    ended.time,
                    &Step {
                        from: &mut *step.from,
                        to: &mut *step.to,
                        ..step
                    },
                );
            }
            // a comparison with NaN does not hold: what is lost is not followed
            let is_followed =
                self.is_fine(step.from, h, tableau.reach) & step.to.position.x.is_finite();
            ended.diverges = ended.diverges | flying & !is_followed;
            flying = flying & is_followed;

            if let Some(sum) = &mut ended.landed.defect {
                *sum = (*sum + step.defect(h).without_derivatives()).blend(*sum, flying);
            }

            let is_above = (ground - step.to.position.x).below(0.0);
            let has_top = flying & is_rising(step.from) & !is_rising(step.to);
            let may_land = flying & !is_above & (has_been_above | has_top);
            let top_decides = has_top & !(has_been_above & is_above);
            // the path within the step is needed where the ball may land, where its top lies in the
            // step and decides whether the ball clears the ground, and where the apex is asked for
            let needs_top = top_decides.any() || asked.apex && has_top.any();
            // and where the time limit lies in the step: how high is the ball then?
            let end = (ended.landed.steps + 1) as f64 * h;
            let is_last = end >= self.time_limit;
            if may_land.any() || needs_top || is_last {
                let within = Within {
                    flying,
                    has_been_above,
                    has_top,
                    may_land,
                    needs_top,
                    is_last,
                };
                let step = Step {
                    from: &mut *step.from,
                    to: &mut *step.to,
                    ..step
                };
                // few steps come here; inlined, it would be more code than all the rest. Again with
                // a step of its own
                (flying, has_been_above) =
                    T::outlined(inlined!(|| self.look_within(&step, within, &mut ended)));
            }
            has_been_above = has_been_above | is_above;
            ended.landed.steps += 1;
            ended.time = end;
        }
        ended.is_aloft = flying;
        if let Some(turf) = &self.turf {
            ended.landed.rest =
                Some(turf.rest(&self.landing(&ended.landed, ended.spin), ended.has_landed));
        }
        ended
    }

    /// Looks within a step for the height at the time limit, the top and the landing. Returns which
    /// flights go on, and which have been above the ground.
    #[inline(always)]
    fn look_within(
        &self,
        step: &Step<'_, T>,
        within: Within<T::Mask>,
        ended: &mut FlightResult<T>,
    ) -> (T::Mask, T::Mask) {
        let (h, ground, begin) = (self.step, self.ground, ended.time);
        let Within {
            mut flying,
            mut has_been_above,
            has_top,
            may_land,
            needs_top,
            is_last,
        } = within;
        let path = Path::new(self, step, h);
        if is_last {
            let s = T::constant((self.time_limit - begin) / h);
            ended.height = path.up.value(s).blend(ended.height, flying);
        }
        let mut from_top = T::zero();
        if needs_top {
            let s = path.up.top(has_top);
            let top = path.position(s);
            from_top = s.blend(from_top, has_top);
            if let Some(apex) = &mut ended.landed.apex {
                let is_higher = has_top & (apex.height - top.x).below(0.0);
                apex.height = top.x.blend(apex.height, is_higher);
                apex.time = (s * h + begin).blend(apex.time, is_higher);
                apex.downrange = top.z.blend(apex.downrange, is_higher);
                // An error of the velocity moves the top along the path, the further the flatter
                // the path is there. That of a path whose error goes with s⁴ (1 − s)⁴ is up to four
                // times as large, by s.
                if ended.landed.defect.is_some() {
                    let per_error =
                        path.velocity(s).norm() * (4.0 * INTERPOLATED * h) / -path.up.bend(s);
                    let moved = step.defect(h) * per_error;
                    ended.defect_of_apex = moved
                        .without_derivatives()
                        .blend(ended.defect_of_apex, is_higher);
                }
            }
            let is_over = has_top & (ground - top.x).below(0.0);
            let stays_below = has_top & !is_over & !has_been_above;
            ended.height = top.x.blend(ended.height, stays_below);
            ended.stays_below = ended.stays_below | stays_below;
            flying = flying & !stays_below;
            has_been_above = has_been_above | is_over;
        }
        let lands = flying & may_land & has_been_above;
        if lands.any() {
            let s = path.up.falls_to(ground, from_top, lands);
            // a landing after the time limit, within the step that passes it, is none
            let time = s * h + begin;
            let lands = lands & !(-time).below(-self.time_limit);
            let (x, v) = (path.position(s), path.velocity(s));
            let old = &mut ended.landed;
            old.carry = x.z.blend(old.carry, lands);
            old.lateral = x.y.blend(old.lateral, lands);
            old.flight_time = time.blend(old.flight_time, lands);
            old.velocity = v.blend(old.velocity, lands);
            // an error of the height is one of the landing place, the larger the flatter the ball
            // comes down
            if let Some(sum) = &mut old.defect {
                let per_sine = (v.norm() / -v.x).without_derivatives();
                let defect = step.defect(h).without_derivatives();
                let here = defect
                    .scale_add(INTERPOLATED, *sum)
                    .mul_add(per_sine, ended.defect_of_apex);
                *sum = here.blend(*sum, lands);
            }
            if self.turf.is_some() {
                ended.spin = self
                    .spin_within([step.from, step.to], s)
                    .blend(ended.spin, lands);
            }
            ended.has_landed = ended.has_landed | lands;
            flying = flying & !lands;
        }
        (flying, has_been_above)
    }

    /// The ball as it lands with this spin, rad/s.
    #[inline(always)]
    pub(super) fn landing(&self, landed: &Landed<T>, spin: T) -> Landing<T> {
        let Landed {
            carry: downrange,
            lateral: right,
            velocity,
            ..
        } = *landed;
        let (radius, gravity, force_per_mass) = (self.radius, self.gravity, self.force_per_mass);
        Landing {
            downrange,
            right,
            velocity,
            spin: self.axis * spin,
            radius,
            gravity,
            force_per_mass,
        }
    }

    /// Where drag and lift change the airspeed within a step by less than this part of itself.
    #[inline(always)]
    fn is_fine(&self, node: &Node<T>, h: f64, reach: f64) -> T::Mask {
        let (a, reached) = (node.rate.acceleration, node.rate.speed * reach);
        let pull = Vector::new(a.x + self.gravity, a.y, a.z);
        (pull.dot(pull) * (h * h) - reached * reached).below(0.0)
    }
}

#[inline(always)]
fn is_rising<T: Numbers>(node: &Node<T>) -> T::Mask {
    (-node.velocity.x).below(0.0)
}
