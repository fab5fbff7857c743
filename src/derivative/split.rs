use super::pass::COMPONENTS;
use crate::number::{Level, MOST_PER_LANE};
use crate::parameters::Parameter;

/// Which parameters the launch depends on, and which the flight depends on beside the launch. A
/// derivative of the flight is then that by the launch and by its own parameters, chained with
/// those of the launch.
#[derive(Clone, Debug)]
pub(super) struct Split {
    /// The indices of the parameters of the launch: club, strike and ball, or the launch where it
    /// is given.
    pub of_launch: Vec<usize>,
    /// The indices of those that change the flight of a ball that leaves the same: ball, air, wind,
    /// law and ground.
    pub of_flight: Vec<usize>,
}

impl Split {
    /// The parameters, divided. Those of the run change nothing unless an outcome is of the run
    /// (`runs`).
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

    /// Whether derivatives take fewer or smaller flights by these variables than by the parameters;
    /// gradients also where these fill more than a pass.
    pub fn pays(&self, parameters: usize, to_second: bool, level: Level) -> bool {
        let most_variables = COMPONENTS + self.of_flight.len();
        if to_second {
            return most_variables < parameters;
        }
        let most = MOST_PER_LANE * level.width();
        // passes times directions in a lane
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
