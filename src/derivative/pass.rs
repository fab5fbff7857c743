use super::Taylor;
use super::directions::{Directions, Entries, pairs};
use crate::drive::{Outcome, OutcomeGroup, OutcomeInputs, check_defect};
use crate::error::{Error, Result};
use crate::flight::{FlightResult, Inputs};
use crate::impact::{Head, LaunchState, strike};
use crate::launch::Launch;
use crate::number::{
    Derivatives, Lanes, Level, Mask, Number, OverNumbers, Task, Vector, inlined, over_directions,
};
use crate::parameters::{Parameter, Setup};
use std::sync::atomic::AtomicBool;

/// Number of components of a launch: velocity, then spin.
pub(super) const COMPONENTS: usize = 6;

/// Point of evaluation. Variables are numbered: parameters first, then the components of the
/// launch.
pub(super) struct EvaluationPoint<'a> {
    /// Setup at this point.
    pub setup: &'a Setup<f64>,
    pub of: &'a [Outcome],
    pub wrt: &'a [&'static Parameter],
    /// Values of the parameters.
    pub x: &'a [f64],
    /// Number of first derivatives by parameters: one for each of `wrt`, or 0 if only values are
    /// computed.
    pub columns: usize,
    /// Entries of the Hessians to compute; `None` without second derivatives.
    pub entries: Option<Entries>,
    /// Largest accepted defect of the integration, m.
    pub largest_defect: f64,
    /// Interrupt flag.
    pub stop: Option<&'a AtomicBool>,
    /// Instruction level.
    pub level: Level,
}

/// Stage of a drive that is differentiated.
#[derive(Clone, Copy)]
pub(super) enum Stage<'a> {
    /// The whole drive.
    Whole,
    /// Impact only. The components of the launch come after the outcomes in `Pass::taylors`.
    Impact,
    /// Flight only, from a launch with these components.
    Flight(&'a [Taylor]),
}

impl Stage<'_> {
    fn has(self, outcome: Outcome) -> bool {
        match self {
            Self::Whole => true,
            Self::Impact => outcome.group() != OutcomeGroup::Flight,
            Self::Flight(_) => outcome.group() == OutcomeGroup::Flight,
        }
    }
}

impl EvaluationPoint<'_> {
    /// True if an outcome of the flight is requested.
    pub fn flies(&self) -> bool {
        self.of
            .iter()
            .any(|outcome| outcome.group() == OutcomeGroup::Flight)
    }

    /// Writes the derivatives by `variables` to `taylors`. `progress` receives the number of
    /// completed passes and the number of all passes.
    pub fn differentiate(
        &self,
        stage: Stage<'_>,
        variables: &[usize],
        taylors: &mut [Taylor],
        progress: &dyn Fn(usize, usize),
    ) -> Result<()> {
        let pairs = self.entries.map(|entries| pairs(variables, entries));
        let directions = Directions {
            variables: pairs.as_deref().unwrap_or(variables),
            are_pairs: pairs.is_some(),
        };
        let passes = directions.passes(self.level);
        let all = passes.len();
        for (done, directions) in passes.enumerate() {
            self.level.run_one_drive(Pass {
                point: self,
                stage,
                directions,
                taylors,
            })?;
            progress(done + 1, all);
        }
        Ok(())
    }

    /// The error for an impact that is not valid in the lanes. [`strike`] computes the impact again
    /// and returns the error. If `strike` returns no error, the strike is exactly on the limit,
    /// where rounding decides.
    fn impact_error(&self) -> Error {
        strike(self.setup)
            .err()
            .unwrap_or_else(|| Error::Undefined {
                what: "the impact".into(),
                reason: "the strike is exactly on the limit between hitting and missing the ball"
                    .into(),
            })
    }
}

/// One pass: derivatives of the outcomes by the variables of all lanes.
struct Pass<'a> {
    point: &'a EvaluationPoint<'a>,
    stage: Stage<'a>,
    directions: Directions<'a>,
    taylors: &'a mut [Taylor],
}

impl Task for Pass<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn run<V: Lanes<Lane = f64>>(&mut self) -> Result<()> {
        let Directions {
            variables,
            are_pairs,
        } = self.directions;
        over_directions::<V, Self>(self, variables.len(), are_pairs)
    }
}

impl OverNumbers for Pass<'_> {
    type Output = Result<()>;

    #[inline(always)]
    fn over<J: Lanes>(&mut self) -> Result<()> {
        let (point, lanes) = (self.point, self.directions.lanes::<J>());
        let mut setup = point.setup.constant::<J>();
        let mut components = self.launch_constants::<J>();
        self.seed(&mut setup, &mut components);
        let launched = self.launch_state(&setup, components, lanes);
        if !launched.is_valid.holds(0) {
            return Err(point.impact_error());
        }
        let has_head = launched.club_speed.is_some()
            && point
                .of
                .iter()
                .any(|outcome| outcome.group() == OutcomeGroup::Head);
        let head = has_head.then(|| J::not_inlined(|| Head::new(&setup.club)));
        let mut flight_result = None;
        if point.flies() && !matches!(self.stage, Stage::Impact) {
            let inputs = Inputs::new(&setup, &launched.launch);
            let has_defect = point.largest_defect.is_finite();
            let found = flight_result.insert(inputs.integrate(
                J::Mask::first(lanes),
                Outcome::requested_outputs(point.of, has_defect, point.stop),
                None,
            ));
            // all lanes compute the same drive
            let value = inlined!(|number: J| number.lane(0).re());
            if let Some(why) = found.no_landing_reason(&inputs, value)? {
                return Err(why.into());
            }
            check_defect(&found.landed, value, point.largest_defect, inputs.step)?;
        }
        for lane in 0..lanes {
            let in_lane = inlined!(|number: J| number.lane(lane));
            let launch = launched.launch.map(in_lane);
            let landed = flight_result
                .as_ref()
                .map(inlined!(|result: &FlightResult<J>| result
                    .landed
                    .map(in_lane)));
            let head_in_lane = head
                .as_ref()
                .map(inlined!(|head: &Head<J>| head.map(in_lane)));
            let drive = OutcomeInputs {
                launch: &launch,
                club_speed: launched.club_speed.map(in_lane),
                landed: landed.as_ref(),
                head: head_in_lane.as_ref(),
            };
            let directions = self.directions;
            let variables = directions.in_lane::<J>(lane);
            self.put_outcomes(variables, &drive)?;
            self.put_launch(variables, &launch);
        }
        Ok(())
    }
}

impl Pass<'_> {
    /// The given launch, if only the flight is differentiated; otherwise empty.
    fn given_launch(&self) -> &[Taylor] {
        match self.stage {
            Stage::Flight(launch) => launch,
            _ => &[],
        }
    }

    /// Components of the given launch, without derivatives; zeros if no launch is given.
    #[inline(always)]
    fn launch_constants<J: Lanes>(&self) -> [J; COMPONENTS] {
        let given = self.given_launch();
        std::array::from_fn(|i| {
            given
                .get(i)
                .map_or(J::zero(), |component| J::constant(component.value))
        })
    }

    /// The launch of all lanes: from `components` if only the flight is differentiated, otherwise
    /// from `setup`.
    #[inline(always)]
    fn launch_state<J: Lanes>(
        &self,
        setup: &Setup<J>,
        components: [J; COMPONENTS],
        lanes: usize,
    ) -> LaunchState<J> {
        if !matches!(self.stage, Stage::Flight(_)) {
            return LaunchState::new(setup);
        }
        let [up, right, downrange, spin @ ..] = components;
        LaunchState {
            launch: Launch {
                velocity: Vector::new(up, right, downrange),
                spin: Vector::from_array(spin),
            },
            club_speed: None,
            is_valid: J::Mask::first(lanes),
        }
    }

    fn put_outcomes<L: Derivatives>(
        &mut self,
        variables: &[usize],
        drive: &OutcomeInputs<'_, L>,
    ) -> Result<()> {
        let outcomes = self.point.of.iter().zip(&mut *self.taylors);
        for (outcome, taylor) in outcomes.filter(|(outcome, _)| self.stage.has(**outcome)) {
            let number = outcome
                .evaluate(drive)
                .ok_or_else(|| outcome.unavailable())?;
            put(taylor, variables, &number);
        }
        Ok(())
    }

    /// Writes the derivatives of the components of the launch, which come after the outcomes in
    /// `taylors`.
    fn put_launch<L: Derivatives>(&mut self, variables: &[usize], launch: &Launch<L>) {
        let (v, s) = (&launch.velocity, &launch.spin);
        let numbers = [&v.x, &v.y, &v.z, &s.x, &s.y, &s.z];
        let components = &mut self.taylors[self.point.of.len()..];
        for (taylor, number) in components.iter_mut().zip(numbers) {
            put(taylor, variables, number);
        }
    }

    #[inline(always)]
    fn seed<J: Lanes>(&self, setup: &mut Setup<J>, components: &mut [J; COMPONENTS]) {
        let (point, given) = (self.point, self.given_launch());
        let parameters = point.wrt.len();
        self.directions.seeded(
            |variable| {
                if variable < parameters {
                    point.x[variable]
                } else {
                    given[variable - parameters].value
                }
            },
            inlined!(
                |variable, number| match point.wrt.get(variable..=variable) {
                    Some(parameter) => setup.put(parameter, |_| number),
                    None => components[variable - parameters] = number,
                }
            ),
        );
    }
}

/// Writes the value of `number`, and its derivatives to the entries of their variables.
fn put<J: Derivatives>(taylor: &mut Taylor, variables: &[usize], number: &J) {
    taylor.value = number.re();
    for (i, &variable) in variables.iter().enumerate() {
        taylor.gradient[variable] = number.first(i);
    }
    if let (&[i, j], false) = (variables, taylor.hessian.is_empty()) {
        (taylor.hessian[i][j], taylor.hessian[j][i]) = (number.second(), number.second());
    }
}
