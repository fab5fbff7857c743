use crate::flight::Inputs;
use crate::ground::Turf;
use crate::impact::Unchecked;
use crate::launch::Launch;
use crate::number::{Mask, Numbers};
use crate::parameters::Setup;

/// A ball that leaves, over any numbers, side by side too: the part of a drive before the flight.
pub(crate) struct Struck<T: Numbers> {
    pub launch: Launch<T>,
    /// Speed of the head, m/s, where a club strikes the ball.
    pub club_speed: Option<T>,
    /// What the flight depends on.
    pub inputs: Inputs<T>,
    /// Where [`strike`](crate::impact::strike) gives this launch and no error.
    pub is_sound: T::Mask,
}

impl<T: Numbers> Struck<T> {
    /// The ball of a setup, with what its run depends on where it `runs`; where the setup gives the launch, no club strikes the ball. Called and not taken in: there is one copy
    /// for each number.
    #[inline(always)]
    pub fn new(setup: &Setup<T>, runs: bool) -> Self {
        T::outlined(
            #[inline(always)]
            || {
                let mut struck = Self::of(setup);
                if runs {
                    struck.inputs.turf = Some(Turf::new(setup));
                }
                struck
            },
        )
    }

    #[inline(always)]
    fn of(setup: &Setup<T>) -> Self {
        if let Some(launch) = Launch::given(setup) {
            let inputs = Inputs::new(setup, &launch);
            return Self { launch, club_speed: None, inputs, is_sound: T::Mask::first(usize::MAX) };
        }
        let Unchecked { launch, is_sound } = Unchecked::new(setup);
        Self { launch, club_speed: Some(setup.swing.speed), inputs: Inputs::new(setup, &launch), is_sound }
    }
}
