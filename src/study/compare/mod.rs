//! Compares two drives, and attributes their difference to the parameters.

mod path;
mod quadrature;
mod split;

pub use path::{Cause, CauseValue, Share, Shares};

use crate::drive::{Drive, Outcome, OutcomeGroup};
use crate::error::Result;
use crate::parameters::{LaunchConditions, Setup};
use crate::statistics::largest_magnitude;
use crate::units::{DisplayUnit, Message};
use path::{SetupPath, value};
use split::DifferenceSplit;
use std::f64::consts::FRAC_PI_2;

const BETWEEN: &str = "a drive between a and b";

/// Threshold for relative differences of launch conditions. Smaller differences count as rounding.
const ROUNDING: f64 = 1e-12;

/// Two drives, a and b.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The setups, with equal integration settings.
    pub setups: [Setup<f64>; 2],
    /// The drives.
    pub drives: [Drive<f64>; 2],
    /// True if the setups had different integration settings, which were made equal.
    pub is_refined: bool,
    path: SetupPath,
    /// Path from one launch to the other; `None` if `path` itself varies the launch conditions.
    launches: Option<SetupPath>,
}

/// Difference of an outcome between two drives.
#[derive(Clone, Debug)]
pub struct Difference {
    /// The outcome.
    pub of: Outcome,
    /// Values of a and b, SI.
    pub values: [f64; 2],
    /// Shares of the differing parameters.
    pub by_parameter: Shares,
    /// For an outcome of the flight: shares of the launch conditions and of the flight's
    /// parameters. `None` for other outcomes. Also `None` if both launches are given, because
    /// `by_parameter` then has these shares.
    pub by_launch: Option<Shares>,
}

impl Difference {
    /// Outcome of b minus outcome of a, SI. For a direction, the difference is at most half a turn.
    pub fn amount(&self) -> f64 {
        let [a, b] = self.values;
        self.of.change(a, b)
    }
}

impl Comparison {
    /// Names of the two drives in messages.
    pub const NAMES: [&str; 2] = ["drive a", "drive b"];

    /// Compares two drives. Both drives use the method of higher order, the shorter step and the
    /// longer time limit of the two setups.
    ///
    /// ```
    /// use longdrive::{Outcome, Setup, study::Comparison};
    /// let (a, mut b) = (Setup::modern_driver(), Setup::modern_driver());
    /// b.set("swing.speed", "112 mph").unwrap();
    /// let carry = Comparison::new(&a, &b).unwrap().of(Outcome::Carry).unwrap();
    /// // the whole difference is due to the speed
    /// assert!((carry.by_parameter.shares[0].amount - carry.amount()).abs() < 1e-10);
    /// ```
    ///
    /// # Errors
    /// [`OfDrive`](crate::Error::OfDrive) with the errors of [`Setup::validate`] and
    /// [`Drive::new`].
    pub fn new(a: &Setup<f64>, b: &Setup<f64>) -> Result<Self> {
        let setups = integrated_alike([*a, *b]);
        let drive = |side: usize| {
            let flown = setups[side]
                .validate()
                .and_then(|()| Drive::new(&setups[side]));
            flown.map_err(|error| error.of_drive(Self::NAMES[side]))
        };
        let drives = [drive(0)?, drive(1)?];
        let launches = [0, 1].map(|side| (&setups[side], &drives[side]));
        let are_given = setups.map(|setup| setup.launch.is_given()) == [true, true];
        let are_alike = setups[0].launch.spin.is_some() == setups[1].launch.spin.is_some();
        let (path, launches) = match (are_given, are_alike) {
            (true, true) => (SetupPath::new(setups), None),
            // both launches are given, but only one of them states its total spin
            (true, false) => (SetupPath::new(as_launched(launches)), None),
            (false, _) => (
                SetupPath::new(setups),
                Some(SetupPath::new(as_launched(launches))),
            ),
        };
        Ok(Self {
            setups,
            drives,
            is_refined: setups != [*a, *b],
            path,
            launches,
        })
    }

    /// True if the setups differ in a parameter or choice that their drives use. Settings of the
    /// computation do not count.
    pub fn differs(&self) -> bool {
        !self.path.causes().is_empty()
    }

    /// The warnings of both drives about these outcomes. Each begins with the name of its drive.
    pub fn warnings(&self, of: &[Outcome]) -> Vec<Message> {
        let of_drive = |side: usize| {
            let name = Self::NAMES[side];
            let warnings = self.drives[side].warnings_about(&self.setups[side], of);
            warnings
                .into_iter()
                .map(move |warning| Message::from(format!("{name}: ")).message(warning))
        };
        of_drive(0).chain(of_drive(1)).collect()
    }

    /// Difference of an outcome, with the share of each cause. The share of a parameter p is ∫
    /// ∂f/∂p dp along the straight line from a to b. The derivatives are exact, so that the shares
    /// add up to the difference. Discrete changes happen at the middle of the line.
    ///
    /// # Errors
    /// [`OfDrive`](crate::Error::OfDrive) if one of the two drives, or a drive between them, does
    /// not have the outcome.
    pub fn of(&self, of: Outcome) -> Result<Difference> {
        self.difference(of, &mut self.splits(&[of]))
    }

    /// Differences of several outcomes, in their order. Each intermediate drive is flown once for
    /// all of them.
    ///
    /// ```
    /// use longdrive::{Outcome, Setup, study::Comparison};
    /// let (a, mut b) = (Setup::modern_driver(), Setup::modern_driver());
    /// b.set("swing.speed", "112 mph").unwrap();
    /// let both = Comparison::new(&a, &b).unwrap();
    /// let found = both.of_each(&[Outcome::Carry, Outcome::BallSpeed]);
    /// assert_eq!(found[0].as_ref().unwrap().amount(), both.of(Outcome::Carry).unwrap().amount());
    /// ```
    ///
    /// # Errors
    /// The errors of [`of`](Self::of), for each outcome.
    pub fn of_each(&self, of: &[Outcome]) -> Vec<Result<Difference>> {
        let mut splits = self.splits(of);
        of.iter()
            .map(|of| self.difference(*of, &mut splits))
            .collect()
    }

    /// Prepares the split of the outcomes that both drives have. They are split by parameter, and
    /// also by launch condition if `launches` is a separate path.
    fn splits(&self, of: &[Outcome]) -> (DifferenceSplit<'_>, Option<DifferenceSplit<'_>>) {
        let has = |of: &Outcome| self.drives.iter().all(|drive| of.value(drive).is_some());
        let of: Vec<Outcome> = of.iter().copied().filter(has).collect();
        let of_flight = || {
            of.iter()
                .copied()
                .filter(|of| of.group() == OutcomeGroup::Flight)
                .collect()
        };
        let by_launch = self
            .launches
            .as_ref()
            .map(|path| DifferenceSplit::new(path, of_flight()));
        (DifferenceSplit::new(&self.path, of), by_launch)
    }

    fn difference(
        &self,
        of: Outcome,
        (by_parameter, by_launch): &mut (DifferenceSplit<'_>, Option<DifferenceSplit<'_>>),
    ) -> Result<Difference> {
        let at = |side: usize| {
            value(&self.setups[side], of).map_err(|error| error.of_drive(Self::NAMES[side]))
        };
        let values = [at(0)?, at(1)?];
        let unit = DisplayUnit::from(of).size();
        let size = largest_magnitude(values).max(unit);
        let amount = of.change(values[0], values[1]);
        let shares = |split: &mut DifferenceSplit<'_>| {
            let found = split.shares(of, amount, size);
            found.map_err(|error| error.of_drive(BETWEEN))
        };
        let by_launch = match by_launch {
            Some(split) if of.group() == OutcomeGroup::Flight => Some(shares(split)?),
            _ => None,
        };
        Ok(Difference {
            of,
            values,
            by_parameter: shares(by_parameter)?,
            by_launch,
        })
    }
}

/// The differences between two setups.
pub fn causes(a: &Setup<f64>, b: &Setup<f64>) -> Vec<Cause> {
    SetupPath::new([*a, *b]).causes()
}

/// Gives both setups the higher-order method, the shorter step, and the longer time limit.
fn integrated_alike(mut setups: [Setup<f64>; 2]) -> [Setup<f64>; 2] {
    let [a, b] = setups;
    let method = if a.method.order() < b.method.order() {
        b.method
    } else {
        a.method
    };
    for setup in &mut setups {
        setup.method = method;
        setup.flight.step = a.flight.step.min(b.flight.step);
        setup.flight.time_limit = a.flight.time_limit.max(b.flight.time_limit);
    }
    setups
}

/// Setups that give the launches of two drives. If the spin axes of the drives differ by less than
/// a right angle, the setups state spin and spin axis. Otherwise they state backspin and sidespin,
/// which vary linearly even if the spin passes through zero.
fn as_launched(drives: [(&Setup<f64>, &Drive<f64>); 2]) -> [Setup<f64>; 2] {
    let [from, to] = drives.map(|(_, drive)| drive.launch.spin_axis());
    let has_axis = (from - to).abs() < FRAC_PI_2;
    let [a, mut b] = drives.map(|(_, Drive { launch, .. })| {
        let spin = if has_axis {
            [launch.total_spin(), launch.spin_axis()]
        } else {
            [launch.backspin(), launch.sidespin()]
        };
        [
            launch.ball_speed(),
            launch.launch_angle(),
            launch.launch_direction(),
            spin[0],
            spin[1],
        ]
    });
    // remove differences that are only rounding
    for (b, a) in b.iter_mut().zip(a) {
        if (*b - a).abs() < ROUNDING * a.abs().max(1.0) {
            *b = a;
        }
    }
    [(drives[0].0, a), (drives[1].0, b)].map(
        |(setup, [ball_speed, launch_angle, launch_direction, spin, side])| {
            let (in_one, in_two) = if has_axis {
                (Some((spin, side)), None)
            } else {
                (None, Some((spin, side)))
            };
            let launch = LaunchConditions {
                ball_speed: Some(ball_speed),
                launch_angle: Some(launch_angle),
                launch_direction: Some(launch_direction),
                backspin: in_two.map(|(back, _)| back),
                sidespin: in_two.map(|(_, side)| side),
                spin: in_one.map(|(total, _)| total),
                spin_axis: in_one.map(|(_, axis)| axis),
            };
            Setup { launch, ..*setup }
        },
    )
}
