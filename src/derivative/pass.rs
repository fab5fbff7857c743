use super::Taylor;
use super::directions::{Directions, pairs};
use crate::drive::{LaunchState, Outcome, OutcomeGroup, OutcomeInputs};
use crate::error::{Error, Result};
use crate::flight::{Inputs, RequestedOutputs};
use crate::impact::{Head, strike};
use crate::launch::Launch;
use crate::number::{
    Derivatives, Lanes, Level, Mask, Number, OverNumbers, Task, Vector, in_lane, inlined,
    over_directions,
};
use crate::parameters::{Parameter, Setup};

/// Components of a launch: of its velocity, then of its spin.
pub(super) const COMPONENTS: usize = 6;

/// A point at which outcomes and their derivatives are taken. Variables are numbered: first the
/// parameters, then the components of the launch.
pub(super) struct Point<'a> {
    /// The setup at this point.
    pub setup: &'a Setup<f64>,
    pub of: &'a [Outcome],
    pub wrt: &'a [&'static Parameter],
    /// The parameters' values.
    pub x: &'a [f64],
    /// How many parameters are differentiated by: all, or none for values.
    pub columns: usize,
    /// The first row of the Hessians that is computed, with its column, where they are asked for.
    pub first_row: Option<usize>,
    /// Whether an outcome is of the flight, whether one is of its apex, and whether one is of the
    /// run after it.
    pub flies: bool,
    pub has_apex: bool,
    pub has_run: bool,
    /// The most that is used of what the processor can do.
    pub level: Level,
}

/// How much of a drive is computed.
#[derive(Clone, Copy)]
pub(super) enum Leg<'a> {
    /// All of it.
    Whole,
    /// The impact, with the components of the launch after the outcomes.
    Impact,
    /// The flight of a ball that leaves like this.
    Flight(&'a [Taylor]),
}

impl Leg<'_> {
    fn shows(self, outcome: Outcome) -> bool {
        match self {
            Self::Whole => true,
            Self::Impact => outcome.group() != OutcomeGroup::Flight,
            Self::Flight(_) => outcome.group() == OutcomeGroup::Flight,
        }
    }
}

impl Point<'_> {
    /// Fills in the derivatives by some variables, telling `progress` how many passes of how many
    /// are done.
    pub fn differentiate(
        &self,
        leg: Leg<'_>,
        variables: &[usize],
        taylors: &mut [Taylor],
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<()> {
        let pairs = self.first_row.map(|row| pairs(variables, row));
        let directions = Directions {
            variables: pairs.as_deref().unwrap_or(variables),
            are_pairs: pairs.is_some(),
        };
        let passes = directions.passes(self.level);
        let all = passes.len();
        for (done, directions) in passes.enumerate() {
            directions.level(self.level).run(Pass {
                point: self,
                leg,
                directions,
                taylors,
            })?;
            progress(done + 1, all);
        }
        Ok(())
    }

    /// Why there is no drive, where a pass has found none.
    fn refusal(&self) -> Error {
        strike(self.setup)
            .err()
            .unwrap_or_else(|| Error::Undefined {
                what: "the impact".into(),
                reason: "it lies on the edge of where the club strikes the ball".into(),
            })
    }
}

/// Derivatives of outcomes in as many directions as there are.
struct Pass<'a> {
    point: &'a Point<'a>,
    leg: Leg<'a>,
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
    fn over<J: Lanes<Lane: Derivatives>>(&mut self, per_lane: usize) -> Result<()> {
        let Self {
            point,
            leg,
            directions,
            ..
        } = *self;
        let taylors = &mut *self.taylors;
        let (parameters, lanes) = (point.wrt.len(), directions.lanes(per_lane));
        let given = if let Leg::Flight(launch) = leg {
            launch
        } else {
            &[]
        };
        let mut setup = point.setup.constant::<J>();
        let mut components: [J; COMPONENTS] = std::array::from_fn(|i| {
            given
                .get(i)
                .map_or(J::zero(), |component| J::constant(component.value))
        });
        directions.seeded(
            per_lane,
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
        let launched = if let Leg::Flight(_) = leg {
            let [up, right, downrange, spin @ ..] = components;
            let launch = Launch {
                velocity: Vector::new(up, right, downrange),
                spin: Vector::from_array(spin),
            };
            LaunchState {
                launch,
                club_speed: None,
                is_valid: J::Mask::first(lanes),
            }
        } else {
            LaunchState::new(&setup)
        };
        if !launched.is_valid.holds(0) {
            return Err(point.refusal());
        }
        let has_head = launched.club_speed.is_some()
            && point
                .of
                .iter()
                .any(|outcome| outcome.group() == OutcomeGroup::Head);
        let head = has_head.then(|| J::outlined(|| Head::new(&setup.club)));
        let mut ended = None;
        if point.flies && !matches!(leg, Leg::Impact) {
            let inputs = Inputs::new(&setup, &launched.launch, point.has_run);
            let found = ended.insert(inputs.integrate(
                J::Mask::first(lanes),
                RequestedOutputs {
                    apex: point.has_apex,
                    defect: false,
                },
                None,
            ));
            // the drive is the same in all lanes
            if let Some(why) = found.no_landing_reason(&inputs, |number| number.lane(0).re())? {
                return Err(Error::NoFlight {
                    reason: why.message(),
                });
            }
        }
        for lane in 0..lanes {
            let read = in_lane(lane);
            let LaunchState {
                launch, club_speed, ..
            } = &launched;
            let landed = ended.as_ref().map(|ended| &ended.landed);
            let drive = OutcomeInputs {
                launch,
                club_speed: *club_speed,
                landed,
                head: head.as_ref(),
                read,
            };
            let variables = directions.in_lane(lane, per_lane);
            for (outcome, taylor) in point
                .of
                .iter()
                .zip(&mut *taylors)
                .filter(|(outcome, _)| leg.shows(**outcome))
            {
                put(
                    taylor,
                    variables,
                    &outcome
                        .evaluate(&drive)
                        .ok_or_else(|| outcome.unavailable())?,
                );
            }
            let Launch {
                velocity: v,
                spin: s,
            } = launch;
            let components = [&v.x, &v.y, &v.z, &s.x, &s.y, &s.z];
            for (taylor, number) in taylors[point.of.len()..].iter_mut().zip(components) {
                put(taylor, variables, &read(*number));
            }
        }
        Ok(())
    }
}

/// Writes what a number tells of its directions to the indices of their variables.
fn put<J: Derivatives>(taylor: &mut Taylor, variables: &[usize], number: &J) {
    taylor.value = number.re();
    for (i, &variable) in variables.iter().enumerate() {
        taylor.gradient[variable] = number.first(i);
    }
    if let (&[i, j], false) = (variables, taylor.hessian.is_empty()) {
        (taylor.hessian[i][j], taylor.hessian[j][i]) = (number.second(), number.second());
    }
}
