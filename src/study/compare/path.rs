use crate::derivative::{Order, evaluate};
use crate::drive::Outcome;
use crate::error::Result;
use crate::json::{JsonNumber, by_name, number};
use crate::parameters::{
    Alternatives, GOLFER, Kind, LAW, Parameter, SPEED_OF, Setup, TABLE, described_differently,
};
use serde::{Serialize, Serializer};

/// A difference between two setups.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// A parameter that varies continuously.
    Continuous(&'static Parameter),
    /// A parameter that changes discretely: it is unset or infinite in one setup.
    Discrete(&'static Parameter),
    /// The aerodynamic law with its coefficients (discrete).
    Law,
    /// The golfer's handedness (discrete).
    Golfer,
    /// The point of the club head whose speed the swing states (discrete).
    SpeedOf,
    /// The choice between a club strike and a given launch, with all parameters of both (discrete).
    Launch,
    /// Air or wind, if the setups state it by different parameters (discrete).
    Alternatives(&'static Alternatives),
}

impl Cause {
    /// The name of the parameter, or one of `aero.law`, `golfer`, `swing.speed_of`, `launch`,
    /// `air`, `wind`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Continuous(parameter) | Self::Discrete(parameter) => parameter.name,
            Self::Law => LAW,
            Self::Golfer => GOLFER,
            Self::SpeedOf => SPEED_OF,
            Self::Launch => "launch",
            Self::Alternatives(alternatives) => alternatives.name,
        }
    }

    /// The value of the cause in a setup.
    fn value_in(self, setup: &Setup<f64>) -> CauseValue {
        match self {
            Self::Continuous(parameter) | Self::Discrete(parameter) => {
                CauseValue::Number(setup.value(parameter).into())
            }
            Self::Golfer | Self::SpeedOf => {
                CauseValue::Choice(setup.choice(self.name()).unwrap_or_default())
            }
            Self::Law => {
                let law = setup.choice(TABLE).or(setup.choice(LAW));
                CauseValue::Choice(law.unwrap_or_default())
            }
            Self::Launch if setup.launch.is_given() => CauseValue::Choice("given"),
            Self::Launch => CauseValue::Choice("struck by a club"),
            Self::Alternatives(alternatives) => {
                let given = alternatives.given_in(setup).into_iter();
                let numbers = given.map(|parameter| (parameter, setup.value(parameter).into()));
                CauseValue::Numbers(numbers.collect())
            }
        }
    }
}

/// Serialized as its name.
impl Serialize for Cause {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// The share of a cause.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ShareReport"))]
pub struct Share {
    /// The parameter or choice that differs: `aero.law`, `golfer`, `swing.speed_of`; `launch`, if
    /// only one of the drives has a club; `air` or `wind`, if the drives state it by different
    /// parameters.
    #[cfg_attr(test, schemars(with = "String"))]
    pub cause: Cause,
    /// The value of the cause in each drive.
    pub values: [CauseValue; 2],
    /// The share of the cause in the difference, SI.
    #[serde(rename = "share", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub amount: f64,
    /// True if the cause changes in one step halfway, because it has no intermediate values.
    pub at_once: bool,
}

/// The value of a cause in a drive.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum CauseValue {
    /// A number in SI, or radians.
    Number(JsonNumber),
    /// The name of a choice: the law (or the file of the user's table), the golfer, the point of
    /// the head, or `given` or `struck by a club` for the launch.
    Choice(&'static str),
    /// The stated numbers of a quantity that may be stated in several ways.
    #[serde(serialize_with = "by_name")]
    Numbers(
        #[cfg_attr(
            test,
            schemars(with = "std::collections::BTreeMap<String, JsonNumber>")
        )]
        Vec<(&'static Parameter, JsonNumber)>,
    ),
}

/// A difference split into its causes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "SharesReport"))]
pub struct Shares {
    /// The share of each cause, in the order of the parameters. The shares of causes that change at
    /// once, such as another law, come last.
    pub shares: Vec<Share>,
    /// The difference minus the sum of the shares, SI. Its magnitude is at most `integration_error`
    /// times the number of shares, unless the model has a corner between the drives.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub remainder: f64,
    /// The error estimate of a share, SI: 1e-11 of the outcome (rounding) for a smooth law, up to
    /// 1e-8 of the outcome for a piecewise law.
    #[serde(rename = "integration_error", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub error: f64,
}

impl Shares {
    /// True if the errors of the shares can explain the remainder.
    pub fn is_within_error(&self) -> bool {
        self.remainder.abs() <= self.shares.len() as f64 * self.error
    }
}

/// Path between two setups: continuous parameters vary linearly; discrete parameters change at the
/// middle.
#[derive(Clone, Debug)]
pub(super) struct SetupPath {
    pub ends: [Setup<f64>; 2],
    pub continuous: Vec<&'static Parameter>,
    pub discrete: Vec<Cause>,
}

impl SetupPath {
    pub fn new(mut ends: [Setup<f64>; 2]) -> Self {
        let mut discrete = vec![];
        let are_given = ends.map(|setup| setup.launch.is_given());
        let differ_in_launch = are_given[0] != are_given[1];
        if differ_in_launch {
            discrete.push(Cause::Launch);
        }
        let differ_in_law = !ends[0].law.is_same(&ends[1].law);
        if differ_in_law {
            discrete.push(Cause::Law);
        }
        // if a launch is given, the golfer and the point of the head have no effect
        if ends[0].golfer != ends[1].golfer && !are_given.contains(&true) {
            discrete.push(Cause::Golfer);
        }
        if ends[0].speed_of != ends[1].speed_of && !are_given.contains(&true) {
            discrete.push(Cause::SpeedOf);
        }
        let otherwise = described_differently(&ends);
        discrete.extend(otherwise.iter().map(|one| Cause::Alternatives(one)));
        let mut continuous = vec![];
        for parameter in ends[0].parameters() {
            let is_of_the_whole = (parameter.is_of_strike() && are_given.contains(&true))
                || (parameter.is_of_launch() && differ_in_launch)
                || (parameter.law.is_some() && differ_in_law)
                || otherwise.iter().any(|one| one.concerns(parameter));
            // it is enough to look at one setup: a parameter that is replaced in the other setup
            // alone is given in different ways, and is then in `otherwise`
            let is_replaced = ends[0].why_replaced(parameter).is_some();
            if is_of_the_whole || is_replaced || parameter.kind == Kind::Setting {
                continue;
            }
            match ends.each_ref().map(|setup| setup.value_or_unset(parameter)) {
                [from, to] if from == to => {}
                [Some(from), Some(to)] if from.is_finite() && to.is_finite() => {
                    ends[0].put(&[parameter], |_| from);
                    ends[1].put(&[parameter], |_| to);
                    continuous.push(parameter);
                }
                _ => discrete.push(Cause::Discrete(parameter)),
            }
        }
        Self {
            ends,
            continuous,
            discrete,
        }
    }

    /// The share of a cause in the difference between the ends.
    pub fn share(&self, cause: Cause, amount: f64) -> Share {
        Share {
            cause,
            values: self.ends.each_ref().map(|setup| cause.value_in(setup)),
            amount,
            at_once: !matches!(cause, Cause::Continuous(_)),
        }
    }

    /// All causes, the continuous ones first.
    pub fn causes(&self) -> Vec<Cause> {
        self.continuous
            .iter()
            .map(|parameter| Cause::Continuous(parameter))
            .chain(self.discrete.iter().copied())
            .collect()
    }

    /// Shares of the discrete changes, at the middle of the path: for each change, the mean of its
    /// effects when all changes are applied in order and in the reverse order. Exchanging the ends
    /// of the path then reverses the signs of the shares and changes nothing else.
    pub fn halfway(&self, of: Outcome) -> Result<Vec<Share>> {
        let count = self.discrete.len();
        let mut shares: Vec<Share> = self
            .discrete
            .iter()
            .map(|cause| self.share(*cause, 0.0))
            .collect();
        if count == 0 {
            return Ok(shares);
        }
        let mut orders: Vec<Vec<usize>> = vec![(0..count).collect()];
        if count > 1 {
            orders.push((0..count).rev().collect());
        }
        for order in &orders {
            let mut setup = self.ends[0];
            let middle = self.values(0.5);
            setup.put(&self.continuous, |i| middle[i]);
            let mut before = value(&setup, of)?;
            for &place in order {
                self.change(&mut setup, self.discrete[place]);
                let after = value(&setup, of)?;
                shares[place].amount += of.change(before, after) / orders.len() as f64;
                before = after;
            }
        }
        Ok(shares)
    }

    /// Applies a discrete change.
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
            Cause::Continuous(parameter) | Cause::Discrete(parameter) => take(setup, to, parameter),
            Cause::Alternatives(alternatives) => {
                let of = setup
                    .parameters()
                    .into_iter()
                    .filter(|parameter| alternatives.concerns(parameter));
                of.for_each(|parameter| take(setup, to, parameter));
            }
        }
    }

    /// Values of the continuous parameters at a position from 0 to 1.
    pub fn values(&self, at: f64) -> Vec<f64> {
        let between = |parameter: &&'static Parameter| {
            let [from, to] = self
                .ends
                .each_ref()
                .map(|setup| setup.value(parameter).unwrap_or_default());
            // clamp: rounding may leave the range
            ((1.0 - at) * from + at * to).clamp(from.min(to), from.max(to))
        };
        self.continuous.iter().map(between).collect()
    }
}

/// Copies a parameter's value from another setup. The value is valid there, so setting it cannot
/// fail.
fn take(setup: &mut Setup<f64>, from: &Setup<f64>, parameter: &Parameter) {
    let _ = setup.set_value(parameter, from.value(parameter));
}

/// Value of outcome `of` for the drive of a setup, SI.
pub(super) fn value(setup: &Setup<f64>, of: Outcome) -> Result<f64> {
    Ok(evaluate(setup, &[of], &[], Order::Value)?
        .first()
        .map_or(f64::NAN, |taylor| taylor.value))
}
