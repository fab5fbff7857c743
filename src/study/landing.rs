use super::Sigma;
use super::uncertainty::{LandingEllipse, SHARES, covariance};
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::Setup;

/// Landing point and rest position of a drive, with the scatter of the landing point.
#[derive(Clone, Debug)]
pub struct Landing {
    /// Name of the drive: "as set up", "optimum".
    pub name: String,
    /// Landing point, m: lateral and carry.
    pub at: [f64; 2],
    /// Rest position, m: right of the target line and downrange; `None` if the ball does not come
    /// to rest.
    pub rest: Option<[f64; 2]>,
    /// Parameters that vary from drive to drive, with their standard deviations.
    pub sigmas: Vec<Sigma>,
    /// Landing ellipses for each of [`SHARES`], from exact derivatives; empty if nothing varies, or
    /// the scatter is too large.
    pub ellipses: Vec<LandingEllipse>,
    /// True if the ellipses are omitted, because the scatter is too large for a linear model. The
    /// standard deviation of the speed then exceeds a third of the speed, or a half-axis of an
    /// ellipse is longer than the distance to the landing point.
    pub is_too_wide: bool,
}

impl Landing {
    /// Landing of a setup with independently varying parameters. These are all parameters with a
    /// stated uncertainty, and the golfer's parameters with a default uncertainty (swing, strike
    /// and club, or a given launch).
    ///
    /// # Errors
    /// The errors of [`Drive::new`] and [`evaluate`]; [`Error::NoFlight`](crate::Error::NoFlight)
    /// if the drive does not land; [`Error::Unreadable`](crate::Error::Unreadable) for an
    /// uncertainty that is not positive and finite.
    pub fn of(name: impl Into<String>, setup: &Setup<f64>, sigmas: &[Sigma]) -> Result<Self> {
        sigmas.iter().try_for_each(|sigma| sigma.check(setup))?;
        let drive = Drive::new(setup)?;
        drive.landed()?;
        // keep stated uncertainties, and default uncertainties of parameters that the golfer
        // controls
        let sigmas: Vec<Sigma> = sigmas
            .iter()
            .filter(|sigma| sigma.source.is_none() || sigma.parameter.is_controlled())
            .copied()
            .collect();
        let parameters: Vec<_> = sigmas.iter().map(|sigma| sigma.parameter).collect();
        let order = match parameters.len() {
            0 => Order::Value,
            _ => Order::First,
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
