//! Two drives beside each other, and what their difference is made of.

mod quadrature;
mod split;
mod way;

pub use way::{Cause, Share};

use crate::drive::{Drive, Outcome, OutcomeGroup};
use crate::error::Result;
use crate::parameters::{LaunchConditions, Setup};
use split::{Found, Split};
use std::f64::consts::FRAC_PI_2;
use way::{Way, value};

/// The names of the two drives in messages, and of those between them.
const NAMES: [&str; 2] = ["drive a", "drive b"];
const BETWEEN: &str = "a drive between a and b";

/// The rounding of a share, a sum of derivatives, as a part of the outcome.
const OF_SHARES: f64 = 1e-11;

/// Differences below this part of a launch condition are rounding.
const ROUNDING: f64 = 1e-12;

/// Two drives, a and b.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Their setups, both integrated in the same way.
    pub setups: [Setup<f64>; 2],
    /// The drives.
    pub drives: [Drive<f64>; 2],
    /// Whether one of them is integrated otherwise than its setup says.
    pub is_refined: bool,
    way: Way,
    /// The way between the balls as they leave; `None` where that is the first way already.
    launches: Option<Way>,
}

/// The difference of an outcome between two drives.
#[derive(Clone, Debug)]
pub struct Difference {
    /// The outcome.
    pub of: Outcome,
    /// Its values in a and b, SI.
    pub values: [f64; 2],
    /// Split into the parameters that differ.
    pub by_parameter: Shares,
    /// An outcome of the flight split into the launch conditions and what else the flight depends
    /// on; `None` where both launches are given, so that these are the parameters that differ.
    pub by_launch: Option<Shares>,
}

/// A difference split into its causes.
#[derive(Clone, Debug)]
pub struct Shares {
    /// The setups between which it is split.
    pub setups: [Setup<f64>; 2],
    /// Each cause with its share, in the order of the table of parameters; what is changed at once
    /// stands last.
    pub shares: Vec<Share>,
    /// What the shares are short of the difference, SI: no more than `error`, unless there is a
    /// corner on the way.
    pub remainder: f64,
    /// How far a share may be off, SI, estimated: rounding, 1e-11 of the outcome, for a smooth law
    /// of drag and lift, and up to 1e-8 for one of pieces.
    pub error: f64,
}

impl Difference {
    /// What the outcome of b has more than that of a, SI; a direction is turned by less than half a
    /// turn.
    pub fn amount(&self) -> f64 {
        let [a, b] = self.values;
        self.of.unwrap_angle(b, a) - a
    }
}

impl Comparison {
    /// Two drives side by side. Both are integrated by the method of the higher order of the two,
    /// in the shorter step of the two.
    ///
    /// ```
    /// use longdrive::{Outcome, Setup, study::Comparison};
    /// let (a, mut b) = (Setup::default(), Setup::default());
    /// b.set("swing.speed", "112 mph").unwrap();
    /// let carry = Comparison::new(&a, &b).unwrap().of(Outcome::Carry).unwrap();
    /// // all of it is due to the speed
    /// assert!((carry.by_parameter.shares[0].amount - carry.amount()).abs() < 1e-10);
    /// ```
    ///
    /// # Errors
    /// [`OfDrive`](crate::Error::OfDrive) with what [`Setup::validate`] and [`Drive::new`] refuse.
    pub fn new(a: &Setup<f64>, b: &Setup<f64>) -> Result<Self> {
        let setups = integrated_alike([*a, *b]);
        let drive = |side: usize| {
            let flown = setups[side]
                .validate()
                .and_then(|()| Drive::new(&setups[side]));
            flown.map_err(|error| error.of_drive(NAMES[side]))
        };
        let drives = [drive(0)?, drive(1)?];
        let launches = [0, 1].map(|side| (&setups[side], &drives[side]));
        let are_given = setups.map(|setup| setup.launch.is_given()) == [true, true];
        let are_alike = setups[0].launch.spin.is_some() == setups[1].launch.spin.is_some();
        let (way, launches) = match (are_given, are_alike) {
            (true, true) => (Way::new(setups), None),
            // the spin in two forms
            (true, false) => (Way::new(as_launched(launches)), None),
            (false, _) => (Way::new(setups), Some(Way::new(as_launched(launches)))),
        };
        Ok(Self {
            setups,
            drives,
            is_refined: setups != [*a, *b],
            way,
            launches,
        })
    }

    /// Whether the two drives differ in anything.
    pub fn differs(&self) -> bool {
        self.way.is_any()
    }

    /// The difference of an outcome, and the share of each cause. The share of a number p is ∫
    /// ∂f/∂p dp on the straight way from a to b, by exact derivatives, so that the shares add up to
    /// the difference. What has no values between a and b is changed at once, halfway.
    ///
    /// # Errors
    /// [`OfDrive`](crate::Error::OfDrive) where one of the drives, or one between them, has no such
    /// outcome.
    pub fn of(&self, of: Outcome) -> Result<Difference> {
        self.difference(of, &mut self.splits(&[of]))
    }

    /// The same of several outcomes, in their order: a drive between a and b is flown once for all
    /// of them.
    ///
    /// ```
    /// use longdrive::{Outcome, Setup, study::Comparison};
    /// let (a, mut b) = (Setup::default(), Setup::default());
    /// b.set("swing.speed", "112 mph").unwrap();
    /// let both = Comparison::new(&a, &b).unwrap();
    /// let found = both.of_each(&[Outcome::Carry, Outcome::BallSpeed]);
    /// assert_eq!(found[0].as_ref().unwrap().amount(), both.of(Outcome::Carry).unwrap().amount());
    /// ```
    ///
    /// # Errors
    /// Those of [`of`](Self::of), for each outcome.
    pub fn of_each(&self, of: &[Outcome]) -> Vec<Result<Difference>> {
        let mut splits = self.splits(of);
        of.iter()
            .map(|of| self.difference(*of, &mut splits))
            .collect()
    }

    /// The shares by the parameters, and those by the launch where that is another way, of the
    /// outcomes that both drives have.
    fn splits(&self, of: &[Outcome]) -> (Split<'_>, Option<Split<'_>>) {
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
            .map(|way| Split::new(way, of_flight()));
        (Split::new(&self.way, of), by_launch)
    }

    fn difference(
        &self,
        of: Outcome,
        (by_parameter, by_launch): &mut (Split<'_>, Option<Split<'_>>),
    ) -> Result<Difference> {
        let at = |side: usize| {
            value(&self.setups[side], of).map_err(|error| error.of_drive(NAMES[side]))
        };
        let values = [at(0)?, at(1)?];
        let unit = of.quantity().size_of(of.unit()).unwrap_or(1.0);
        let size = values
            .iter()
            .fold(unit, |most, value| most.max(value.abs()));
        let amount = of.unwrap_angle(values[1], values[0]) - values[0];
        let shares = |split: &mut Split<'_>, way: &Way| -> Result<Shares> {
            let Found { shares, error } = split
                .shares(of, size)
                .map_err(|error| error.of_drive(BETWEEN))?;
            let remainder = amount - shares.iter().map(|share| share.amount).sum::<f64>();
            Ok(Shares {
                setups: way.ends,
                shares,
                remainder,
                error: error + OF_SHARES * size,
            })
        };
        let by_launch = match (by_launch, &self.launches) {
            (Some(split), Some(way)) if of.group() == OutcomeGroup::Flight => {
                Some(shares(split, way)?)
            }
            _ => None,
        };
        Ok(Difference {
            of,
            values,
            by_parameter: shares(by_parameter, &self.way)?,
            by_launch,
        })
    }
}

/// In what two setups differ.
pub fn causes(a: &Setup<f64>, b: &Setup<f64>) -> Vec<Cause> {
    Way::new([*a, *b]).causes()
}

/// The setups with the method of the higher order, in the shorter step, and with the longer time
/// limit.
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

/// The same balls, given by their launch: spin and its axis or, where that is turned by more than a
/// right angle or there is no spin, backspin and sidespin, which go straight from one to the other
/// there too.
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
    // conditions that rounding alone tells apart are the same
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
