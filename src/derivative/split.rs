use super::directions::MOST_PER_LANE;
use crate::number::Level;
use crate::parameters::Parameter;

/// Components of velocity and spin of a ball as it leaves.
const OF_A_LAUNCH: usize = 6;

/// Which parameters the launch depends on, and which the flight depends on beside the launch. A derivative of the flight is then that by
/// the launch and by its own parameters, chained with those of the launch.
#[derive(Clone, Debug)]
pub(super) struct Split {
    parameters: usize,
    /// The indices of the parameters of the launch: club, strike and ball, or the launch where it is given.
    pub of_launch: Vec<usize>,
    /// The indices of those that change the flight of a ball that leaves the same: ball, air, wind, law and ground.
    pub of_flight: Vec<usize>,
}

impl Split {
    /// The parameters, divided. Those of the run change nothing unless an outcome is of the run (`runs`).
    pub fn of(wrt: &[&'static Parameter], runs: bool) -> Self {
        let indices = |holds: &dyn Fn(&Parameter) -> bool| (0..wrt.len()).filter(|&index| holds(wrt[index])).collect();
        let is_of_launch = |parameter: &Parameter| parameter.is_of_strike() || parameter.is_of_launch();
        Self {
            parameters: wrt.len(),
            of_launch: indices(&|parameter| is_of_launch(parameter) || parameter.is_of_ball()),
            of_flight: indices(&|parameter| !is_of_launch(parameter) && (runs || !parameter.is_of_the_run())),
        }
    }

    /// The most variables that a flight has: the launch, and its own parameters.
    fn most_variables(&self) -> usize {
        OF_A_LAUNCH + self.of_flight.len()
    }

    /// Whether gradients take fewer flights, or smaller ones, by these variables than by the parameters; and where one pass is too
    /// small for all parameters.
    pub fn pays_for_gradients(&self, level: Level) -> bool {
        let most = MOST_PER_LANE * level.width();
        // passes times directions in a lane
        let size = |count: usize| if count <= level.width() { 1 } else { MOST_PER_LANE * count.div_ceil(most) };
        self.parameters > most || size(self.most_variables()) < size(self.parameters)
    }

    /// Whether Hessians take fewer flights by these variables than by the parameters.
    pub fn pays_for_hessians(&self) -> bool {
        self.most_variables() < self.parameters
    }
}
