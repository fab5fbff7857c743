use super::pass::COMPONENTS;
use crate::number::{Level, MOST_PER_LANE};
use crate::parameters::Parameter;

/// Division of the parameters into those that affect the launch and those that affect the flight at
/// fixed launch. The flight is then differentiated by the launch and by its own parameters, and the
/// chain rule combines this with the derivatives of the launch.
#[derive(Clone, Debug)]
pub(super) struct Split {
    /// Indices of the parameters of the launch: club, strike and ball, or a given launch.
    pub of_launch: Vec<usize>,
    /// Indices of the parameters of the flight at fixed launch: ball, air, wind, law and ground.
    pub of_flight: Vec<usize>,
}

impl Split {
    /// Divides the parameters. Parameters of the run are included only if an outcome depends on the
    /// run (`runs`).
    pub fn of(wrt: &[&'static Parameter], runs: bool) -> Self {
        let indices = |holds: &dyn Fn(&Parameter) -> bool| {
            (0..wrt.len()).filter(|&index| holds(wrt[index])).collect()
        };
        let is_of_launch =
            |parameter: &Parameter| parameter.is_of_strike() || parameter.is_of_launch();
        Self {
            of_launch: indices(&|parameter| is_of_launch(parameter) || parameter.is_of_ball()),
            of_flight: indices(&|parameter| {
                !is_of_launch(parameter) && (runs || !parameter.affects_only_run())
            }),
        }
    }

    /// True if the chain rule needs fewer or smaller flights than direct differentiation. For
    /// gradients it is also true if the parameters need more than one pass.
    pub fn is_cheaper(&self, parameters: usize, to_second: bool, level: Level) -> bool {
        let most_variables = COMPONENTS + self.of_flight.len();
        if to_second {
            return most_variables < parameters;
        }
        let most = MOST_PER_LANE * level.width();
        // cost: number of passes times directions per lane
        let size = |count: usize| {
            if count <= level.width() {
                1
            } else {
                MOST_PER_LANE * count.div_ceil(most)
            }
        };
        parameters > most || size(most_variables) < size(parameters)
    }
}
