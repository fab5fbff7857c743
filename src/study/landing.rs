use super::Sigma;
use super::uncertainty::{LandingEllipse, SHARES, covariance};
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::Setup;

/// Where a drive lands and comes to rest, and where it does when its parameters are a little off.
#[derive(Clone, Debug)]
pub struct Landing {
    /// What the drive is called: "as set up", "optimum".
    pub name: String,
    /// Lateral and carry, m.
    pub at: [f64; 2],
    /// Where it comes to rest, m: right of the target line and downrange; `None` where it does not.
    pub rest: Option<[f64; 2]>,
    /// The parameters that vary from drive to drive, each by its standard deviation.
    pub sigmas: Vec<Sigma>,
    /// The ellipses of the landings, by exact derivatives, that hold each of [`SHARES`]; empty
    /// where nothing varies, or too much does.
    pub ellipses: Vec<LandingEllipse>,
    /// Whether the ellipses are left out since too much varies beside the drive for its derivatives
    /// to tell the landings: the standard deviation of its speed is more than a third of it, or an
    /// ellipse reaches further than the ball carries.
    pub is_too_wide: bool,
}

impl Landing {
    /// The landing of a setup whose parameters vary independently. Of the usual uncertainties only
    /// those that a golfer controls are taken: of the swing, the strike and the club, or of a
    /// launch that is given. Those that were stated are all taken.
    ///
    /// # Errors
    /// As [`Drive::new`] and [`evaluate`]; [`Error::NoFlight`](crate::Error::NoFlight) where
    /// nothing lands; [`Error::Unreadable`](crate::Error::Unreadable) for an uncertainty that is
    /// not above 0 and finite.
    pub fn of(name: impl Into<String>, setup: &Setup<f64>, sigmas: &[Sigma]) -> Result<Self> {
        sigmas.iter().try_for_each(|sigma| sigma.check(setup))?;
        let drive = Drive::new(setup)?;
        drive.landed()?;
        let sigmas: Vec<Sigma> = sigmas
            .iter()
            .filter(|sigma| is_of_the_golfer(sigma))
            .copied()
            .collect();
        let parameters: Vec<_> = sigmas.iter().map(|sigma| sigma.parameter).collect();
        let order = if parameters.is_empty() {
            Order::Value
        } else {
            Order::First
        };
        let taylors = evaluate(
            setup,
            &[Outcome::Lateral, Outcome::Carry],
            &parameters,
            order,
        )?;
        let at = [taylors[0].value, taylors[1].value];
        let variances: Vec<f64> = sigmas
            .iter()
            .map(|sigma| sigma.value * sigma.value)
            .collect();
        let covariance = covariance([&taylors[0], &taylors[1]], &variances);
        let is_spread = covariance.iter().flatten().any(|entry| *entry > 0.0);
        let ellipse = |share: f64| LandingEllipse::new(share, at, covariance);
        let ellipses: Vec<_> = SHARES
            .into_iter()
            .filter(|_| is_spread)
            .map(ellipse)
            .collect();
        let is_fast =
            |sigma: &Sigma| ["swing.speed", "launch.ball_speed"].contains(&sigma.parameter.name);
        let is_of_most = |sigma: &Sigma| {
            setup
                .value(sigma.parameter)
                .is_some_and(|speed| 3.0 * sigma.value > speed)
        };
        let carry = at[0].hypot(at[1]);
        let is_large =
            |ellipse: &LandingEllipse| ellipse.half_axes.iter().any(|[x, y]| x.hypot(*y) > carry);
        let is_too_wide = sigmas
            .iter()
            .any(|sigma| is_fast(sigma) && is_of_most(sigma))
            || ellipses.iter().any(is_large);
        let rest = [Outcome::LateralTotal, Outcome::Total].map(|of| of.value(&drive));
        Ok(Self {
            name: name.into(),
            at,
            rest: rest[0]
                .zip(rest[1])
                .map(|(right, downrange)| [right, downrange]),
            sigmas,
            ellipses: if is_too_wide { vec![] } else { ellipses },
            is_too_wide,
        })
    }
}

/// Whether what is uncertain is a golfer's own from drive to drive, or was stated.
fn is_of_the_golfer(sigma: &Sigma) -> bool {
    let is_stated = sigma.source.is_none();
    is_stated
        || ["swing.", "strike.", "club.", "launch."]
            .iter()
            .any(|group| sigma.parameter.name.starts_with(group))
}
