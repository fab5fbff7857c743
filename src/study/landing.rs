use super::Sigma;
use super::named_drive::DriveRole;
use super::uncertainty::{
    LandingEllipse, MOST_LOST, SHARES, SaltelliDesign, SamplePlan, Uncertain, varies,
};
use crate::batch::{Batch, Block, CHUNK};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::Setup;
use rayon::prelude::*;

/// Landing point and rest position of a drive, with the scatter of the landing point.
#[derive(Clone, Debug)]
pub struct Landing {
    /// Role of the drive.
    pub role: DriveRole,
    /// Landing point, m: lateral and carry.
    pub at: [f64; 2],
    /// Rest position, m: right of the target line and downrange; `None` if the ball does not come
    /// to rest.
    pub rest: Option<[f64; 2]>,
    /// Uncertain parameters, with their standard deviations.
    pub sigmas: Vec<Sigma>,
    /// Landing ellipses for each of [`SHARES`], from [`Landing::SAMPLED`] drives with normally
    /// distributed parameters; empty if nothing varies, or the scatter is too large.
    pub ellipses: Vec<LandingEllipse>,
    /// True if the ellipses are omitted, because more than 2 % of the sampled drives have a value
    /// outside of its allowed range or do not land.
    pub is_too_wide: bool,
}

/// Each of the two independent sets of the sample has this many drives.
const PLAN: SamplePlan = SamplePlan {
    samples: 2000,
    seed: 0,
};

impl Landing {
    /// Number of drives in the sample for the ellipses.
    pub const SAMPLED: usize = 2 * PLAN.samples;

    /// Landing of a setup with independently varying parameters. These are all parameters with a
    /// stated uncertainty, and the golfer's parameters with a default uncertainty (swing, strike
    /// and club, or a given launch).
    ///
    /// # Errors
    /// The errors of [`Drive::new`] and [`Batch::new`]; [`Error::NoFlight`](crate::Error::NoFlight)
    /// if the drive does not land; [`Error::Unreadable`](crate::Error::Unreadable) for an
    /// uncertainty that is not positive and finite.
    pub fn of(role: DriveRole, setup: &Setup<f64>, sigmas: &[Sigma]) -> Result<Self> {
        sigmas.iter().try_for_each(|sigma| sigma.check(setup))?;
        let drive = Drive::new(setup)?;
        let landed = drive.landed()?;
        // keep stated uncertainties, and default uncertainties of parameters that the golfer
        // controls
        let sigmas: Vec<Sigma> = sigmas
            .iter()
            .filter(|sigma| sigma.source.is_none() || sigma.parameter.is_controlled())
            .copied()
            .collect();
        let landings = match sigmas[..] {
            [] => vec![],
            _ => sampled_landings(setup, &sigmas)?,
        };
        let lost = Self::SAMPLED - landings.len();
        let is_too_wide = !sigmas.is_empty() && lost as f64 > MOST_LOST * Self::SAMPLED as f64;
        let is_spread = [0, 1].into_iter().any(|axis| {
            let along: Vec<f64> = landings.iter().map(|landing| landing[axis]).collect();
            varies(&along)
        });
        let ellipses = SHARES
            .into_iter()
            .filter(|_| is_spread && !is_too_wide)
            .map(|share| LandingEllipse::of_sample(share, &landings));
        let rest = [Outcome::LateralTotal, Outcome::Total].map(|of| of.value(&drive));
        Ok(Self {
            role,
            at: [landed.lateral, landed.carry],
            rest: rest[0]
                .zip(rest[1])
                .map(|(right, downrange)| [right, downrange]),
            sigmas,
            ellipses: ellipses.collect(),
            is_too_wide,
        })
    }
}

/// The coordinates of a landing.
const LANDING: [Outcome; 2] = [Outcome::Lateral, Outcome::Carry];

/// Landings [lateral, carry], m, of the sampled drives that land.
fn sampled_landings(setup: &Setup<f64>, sigmas: &[Sigma]) -> Result<Vec<[f64; 2]>> {
    let parameters: Vec<_> = sigmas.iter().map(|sigma| sigma.parameter).collect();
    let distributions: Vec<_> = sigmas
        .iter()
        .map(|sigma| Uncertain::normal(setup, sigma).distribution)
        .collect();
    let batch = Batch::new(setup, &parameters, &LANDING, &[])?;
    // the first two sets of the design are independent
    let points = SaltelliDesign::new(&distributions, PLAN)?.points;
    let blocks: Vec<Block> = points[..2]
        .concat()
        .par_chunks(CHUNK)
        .map(|chunk| batch.evaluate(0, chunk.concat()))
        .collect();
    let landings = blocks
        .iter()
        .flat_map(|block| block.result(0).zip(block.result(1)));
    Ok(landings
        .filter_map(|(lateral, carry)| Some([lateral?, carry?]))
        .collect())
}
