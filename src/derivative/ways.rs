use super::pass::MOST_PER_LANE;
use crate::number::Level;
use crate::parameters::Parameter;

/// Components of velocity and spin of a ball as it leaves.
const OF_A_LAUNCH: usize = 6;

/// How parameters change a flight: through the launch, besides it, or both ways.
#[derive(Clone, Debug)]
pub(super) struct Ways {
    parameters: usize,
    /// The places of those that change how the ball leaves: club, strike and ball, or the launch where it is given.
    pub through_launch: Vec<usize>,
    /// The places of those that change the flight of a ball that leaves the same: ball, air, wind, law and ground.
    pub besides: Vec<usize>,
}

impl Ways {
    pub fn of(wrt: &[&'static Parameter]) -> Self {
        let places = |holds: &dyn Fn(&Parameter) -> bool| (0..wrt.len()).filter(|&place| holds(wrt[place])).collect();
        let is_of_launch = |parameter: &Parameter| parameter.is_of_strike() || parameter.is_of_launch();
        Self {
            parameters: wrt.len(),
            through_launch: places(&|parameter| is_of_launch(parameter) || parameter.is_of_ball()),
            besides: places(&|parameter| !is_of_launch(parameter)),
        }
    }

    /// The most variables that a flight has: the launch, and what changes it besides.
    fn most_variables(&self) -> usize {
        OF_A_LAUNCH + self.besides.len()
    }

    /// Whether gradients take fewer flights, or smaller ones, by these variables than by the parameters; and where one pass is too
    /// small for all parameters.
    pub fn pay_for_gradients(&self, level: Level) -> bool {
        let most = MOST_PER_LANE * level.width();
        // passes times directions in a lane
        let size = |count: usize| if count <= level.width() { 1 } else { MOST_PER_LANE * count.div_ceil(most) };
        self.parameters > most || size(self.most_variables()) < size(self.parameters)
    }

    /// Whether Hessians take fewer flights by these variables than by the parameters.
    pub fn pay_for_hessians(&self) -> bool {
        self.most_variables() < self.parameters
    }
}
