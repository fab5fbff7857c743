use crate::impact::LaneImpact;
use crate::launch::Launch;
use crate::number::{Mask, Numbers, inlined};
use crate::parameters::Setup;

/// A ball that leaves, over any numbers, side by side too: the part of a drive before the flight.
pub(crate) struct LaunchState<T: Numbers> {
    pub launch: Launch<T>,
    /// Speed of the head, m/s, where a club strikes the ball.
    pub club_speed: Option<T>,
    /// Where [`strike`](crate::impact::strike) gives this launch and no error.
    pub is_valid: T::Mask,
}

impl<T: Numbers> LaunchState<T> {
    /// The ball of a setup; where that gives the launch, no club strikes the ball. Not inlined:
    /// there is one compiled copy for each number type.
    #[inline(always)]
    pub fn new(setup: &Setup<T>) -> Self {
        T::outlined(inlined!(|| {
            if let Some(launch) = Launch::given(setup) {
                return Self {
                    launch,
                    club_speed: None,
                    is_valid: T::Mask::first(usize::MAX),
                };
            }
            let LaneImpact { launch, is_valid } = LaneImpact::new(setup);
            Self {
                launch,
                club_speed: Some(setup.swing.speed),
                is_valid,
            }
        }))
    }
}
