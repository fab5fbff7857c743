use crate::derivative::{Order, evaluate};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{GOLFER, Kind, LAW, Parameter, SPEED_OF, Setup, Ways, given_otherwise};

/// In what two drives differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// A parameter that goes from one value to the other.
    Number(&'static Parameter),
    /// A parameter that is changed at once: it is unset or infinite in one of the two.
    AtOnce(&'static Parameter),
    /// The law of drag and lift with its coefficients, changed at once.
    Law,
    /// The hand of the golfer, changed at once.
    Golfer,
    /// The point of the head whose motion the swing states, changed at once.
    SpeedOf,
    /// Whether a club strikes the ball or its launch is given, with all of the strike and of the
    /// launch, changed at once.
    Launch,
    /// The air or the wind, which the two give by different parameters: all of these, changed at
    /// once.
    Ways(&'static Ways),
}

impl Cause {
    /// The name of the parameter; `aero.law`; `golfer`; `swing.speed_of`; `launch`; `air`; `wind`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Number(parameter) | Self::AtOnce(parameter) => parameter.name,
            Self::Law => LAW,
            Self::Golfer => GOLFER,
            Self::SpeedOf => SPEED_OF,
            Self::Launch => "launch",
            Self::Ways(ways) => ways.name,
        }
    }

    /// Whether it has no values between the two, so that it is changed at once.
    pub fn is_at_once(self) -> bool {
        !matches!(self, Self::Number(_))
    }
}

/// A cause with its share of a difference.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// The cause.
    pub cause: Cause,
    /// Its share, SI.
    pub amount: f64,
}

/// The way from one drive to another: the numbers that differ go straight from the one to the
/// other. Halfway, with the numbers in the middle, what has no values between the two is changed at
/// once.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub ends: [Setup<f64>; 2],
    pub numbers: Vec<&'static Parameter>,
    at_once: Vec<Cause>,
}

impl Way {
    pub fn new(mut ends: [Setup<f64>; 2]) -> Self {
        let mut at_once = vec![];
        let are_given = ends.map(|setup| setup.launch.is_given());
        let differ_in_launch = are_given[0] != are_given[1];
        if differ_in_launch {
            at_once.push(Cause::Launch);
        }
        let differ_in_law = !ends[0].law.is_same(&ends[1].law);
        if differ_in_law {
            at_once.push(Cause::Law);
        }
        // a given launch has no golfer
        if ends[0].golfer != ends[1].golfer && !are_given.contains(&true) {
            at_once.push(Cause::Golfer);
        }
        if ends[0].speed_of != ends[1].speed_of && !are_given.contains(&true) {
            at_once.push(Cause::SpeedOf);
        }
        let otherwise = given_otherwise(&ends);
        at_once.extend(otherwise.iter().map(|ways| Cause::Ways(ways)));
        let mut numbers = vec![];
        for parameter in ends[0].parameters() {
            let is_of_the_whole = (parameter.is_of_strike() && are_given.contains(&true))
                || (parameter.is_of_launch() && differ_in_launch)
                || (parameter.law.is_some() && differ_in_law)
                || otherwise.iter().any(|ways| ways.has(parameter));
            // what is replaced in one is replaced in the other too, by the same parameters
            let is_replaced = ends[0].why_replaced(parameter).is_some();
            if is_of_the_whole || is_replaced || parameter.kind == Kind::Setting {
                continue;
            }
            match ends
                .each_ref()
                .map(|setup| setup.value(parameter).or(parameter.unset))
            {
                [from, to] if from == to => {}
                [Some(from), Some(to)] if from.is_finite() && to.is_finite() => {
                    ends[0].put(&[parameter], |_| from);
                    ends[1].put(&[parameter], |_| to);
                    numbers.push(parameter);
                }
                _ => at_once.push(Cause::AtOnce(parameter)),
            }
        }
        Self {
            ends,
            numbers,
            at_once,
        }
    }

    /// Whether anything differs.
    pub fn is_any(&self) -> bool {
        !(self.numbers.is_empty() && self.at_once.is_empty())
    }

    /// Each thing that differs.
    pub fn causes(&self) -> Vec<Cause> {
        self.numbers
            .iter()
            .map(|parameter| Cause::Number(parameter))
            .chain(self.at_once.iter().copied())
            .collect()
    }

    /// Whether anything is changed at once.
    pub fn has_any_at_once(&self) -> bool {
        !self.at_once.is_empty()
    }

    /// The shares of what is changed at once, halfway. One is changed after the other, in their
    /// order and in the opposite one; a share is the mean of the two, so that the way back gives
    /// the same shares with the other sign.
    pub fn halfway(&self, of: Outcome) -> Result<Vec<Share>> {
        let last = self.at_once.len();
        let mut shares: Vec<Share> = self
            .at_once
            .iter()
            .map(|cause| Share {
                cause: *cause,
                amount: 0.0,
            })
            .collect();
        if last == 0 {
            return Ok(shares);
        }
        let orders: [Vec<usize>; 2] = [(0..last).collect(), (0..last).rev().collect()];
        for order in &orders[..last.min(2)] {
            let mut setup = self.ends[0];
            let middle = self.values(0.5);
            setup.put(&self.numbers, |i| middle[i]);
            let mut before = value(&setup, of)?;
            for &place in order {
                self.change(&mut setup, self.at_once[place]);
                let after = value(&setup, of)?;
                shares[place].amount +=
                    (of.unwrap_angle(after, before) - before) / last.min(2) as f64;
                before = after;
            }
        }
        Ok(shares)
    }

    /// Changes at once what is so in the second drive.
    fn change(&self, setup: &mut Setup<f64>, cause: Cause) {
        let to = &self.ends[1];
        match cause {
            Cause::Law => setup.law = to.law,
            Cause::Golfer => setup.golfer = to.golfer,
            Cause::SpeedOf => setup.speed_of = to.speed_of,
            Cause::Launch => {
                (setup.launch, setup.swing, setup.strike) = (to.launch, to.swing, to.strike);
                (setup.club, setup.impact) = (to.club, to.impact);
                (setup.golfer, setup.speed_of) = (to.golfer, to.speed_of);
            }
            Cause::Number(parameter) | Cause::AtOnce(parameter) => take(setup, to, parameter),
            Cause::Ways(ways) => {
                let of = setup
                    .parameters()
                    .into_iter()
                    .filter(|parameter| ways.has(parameter));
                of.for_each(|parameter| take(setup, to, parameter));
            }
        }
    }

    /// The numbers at a place of the way, from 0 to 1.
    pub fn values(&self, at: f64) -> Vec<f64> {
        let between = |parameter: &&'static Parameter| {
            let [from, to] = self
                .ends
                .each_ref()
                .map(|setup| setup.value(parameter).unwrap_or_default());
            // rounding leads out of no range
            ((1.0 - at) * from + at * to).clamp(from.min(to), from.max(to))
        };
        self.numbers.iter().map(between).collect()
    }
}

/// Takes the value of a parameter from another setup; both have been read within the range.
fn take(setup: &mut Setup<f64>, from: &Setup<f64>, parameter: &Parameter) {
    let _ = setup.set_value(parameter, from.value(parameter));
}

/// The value of an outcome.
pub(super) fn value(setup: &Setup<f64>, of: Outcome) -> Result<f64> {
    Ok(evaluate(setup, &[of], &[], Order::Value)?
        .first()
        .map_or(f64::NAN, |taylor| taylor.value))
}
