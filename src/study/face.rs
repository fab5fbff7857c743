use super::Vary;
use super::plane::Plane;
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::impact::Head;
use crate::parameters::{Golfer, Setup, Strike};

/// Carry and spin axis as functions of the impact point on the face.
#[derive(Clone, Debug)]
pub struct Face {
    /// Handedness of the golfer, which determines the side of the toe.
    pub golfer: Golfer,
    /// Half-width (towards the toe) and half-height of the face, m.
    pub half: [f64; 2],
    /// True if impact points are relative to the face centre: `club.cg_high`, `club.cg_toe` or a
    /// movable weight is set. False if impact points are relative to the sweet spot.
    pub is_from_centre: bool,
    /// Point where the face normal passes through the centre of mass, m: towards the toe, up;
    /// `None` if there is no such point.
    pub sweet_spot: Option<[f64; 2]>,
    /// Impact point of the setup, m: towards the toe, up.
    pub strike: [f64; 2],
    /// Carry of the setup's drive, m; `None` if the ball does not fly.
    pub carry: Option<f64>,
    /// [`Face::OUTCOMES`] over `strike.toe` and `strike.high`, SI.
    pub plane: Plane,
    /// Derivatives of [`Face::OUTCOMES`] by `strike.toe` at the sweet spot, or at the face centre
    /// if there is no sweet spot, SI. `None` if a derivative does not exist.
    pub by_toe: Option<[f64; 4]>,
    /// Impact point of the longest carry among the grid nodes on the face, with that carry, m.
    pub longest: ([f64; 2], f64),
    /// Points on the face, with the tilt of the spin axis relative to a strike on the sweet spot
    /// (on the face centre if there is no sweet spot), rad, + right.
    pub tilts: Vec<([f64; 2], f64)>,
}

/// Half-width and half-height of a typical driver face, m.
const HALF: [f64; 2] = [0.055, 0.025];

/// Largest half-width and half-height of the face, as a fraction of the semi-axes of the ellipsoid
/// that models the face.
const WITHIN: f64 = 0.95;

/// Numbers of points of [`Face::plane`], across and up the face.
const NODES: [usize; 2] = [111, 51];
/// Numbers of points of [`Face::tilts`], across and up the face.
const ARROWS: [usize; 2] = [5, 3];

impl Face {
    /// Outcomes computed over the face, carry first.
    pub const OUTCOMES: [Outcome; 4] = [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::BallSpeed,
        Outcome::SpinAxis,
    ];

    /// Computes the drives of strikes all over the face.
    ///
    /// # Errors
    /// The errors of [`Batch::new`](crate::batch::Batch::new) if the launch is given;
    /// [`Error::NoFlight`] if no strike flies.
    pub fn of(setup: &Setup<f64>) -> Result<Self> {
        let club = &setup.club;
        let (bulge, roll) = (club.bulge_radius, club.roll_radius);
        let third = club.face_semi_axis.unwrap_or((bulge * roll).sqrt());
        let end = |radius: f64| WITHIN * (radius * third).sqrt();
        // half-width and half-height: typical values, limited by bulge and roll
        let half = [HALF[0].min(end(bulge)), HALF[1].min(end(roll))];
        let [across, up] = ranges(setup, half)?;
        let plane = Plane::fly(setup, &Self::OUTCOMES, across, up, NODES, Order::First)?;
        let longest = plane
            .largest(0, |at| is_on(half, at))
            .ok_or_else(|| Error::NoFlight {
                status: "no-flight",
                reason: "no flight: no strike on the face makes a drive that flies and lands"
                    .into(),
            })?;
        let spot = Strike::on_sweet_spot(&setup.club);
        let centred = Setup {
            strike: spot.unwrap_or(Strike {
                high: 0.0,
                toe: 0.0,
            }),
            ..*setup
        };
        let tilts = tilts(setup, &centred, half)?;
        let carry = Drive::new(setup)
            .ok()
            .and_then(|drive| Outcome::Carry.value(&drive));
        let by_toe = evaluate(&centred, &Self::OUTCOMES, &[across.parameter], Order::First).ok();
        let by_toe = by_toe
            .and_then(|found| <[_; 4]>::try_from(found).ok())
            .map(|found| found.map(|of| of.gradient[0]));
        Ok(Self {
            golfer: setup.golfer,
            half,
            is_from_centre: Head::new(&setup.club).cg_offset.is_some(),
            sweet_spot: spot.map(|spot| [spot.toe, spot.high]),
            strike: [setup.strike.toe, setup.strike.high],
            carry,
            plane,
            by_toe,
            longest,
            tilts,
        })
    }

    /// Generic outline of the face (a superellipse).
    pub fn outline(&self) -> Vec<[f64; 2]> {
        let point = |step: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / 120.0).sin_cos();
            let round =
                |part: f64, half: f64| part.abs().powf(2.0 / ROUNDNESS).copysign(part) * half;
            [round(cos, self.half[0]), round(sin, self.half[1])]
        };
        (0..=120).map(point).collect()
    }

    /// True if the longest carry is at the edge of the face: a neighbour of its node is off the
    /// face.
    pub fn is_longest_at_edge(&self) -> bool {
        let ([x, y], _) = self.longest;
        let [wide, tall] = [0, 1].map(|axis| 2.0 * self.half[axis] / (NODES[axis] - 1) as f64);
        [[x - wide, y], [x + wide, y], [x, y - tall], [x, y + tall]]
            .into_iter()
            .any(|at| !self.holds(at))
    }

    /// True if the setup strikes the sweet spot, within 1 µm.
    pub fn is_struck_sweetly(&self) -> bool {
        self.sweet_spot
            .is_some_and(|spot| (0..2).all(|axis| (spot[axis] - self.strike[axis]).abs() < 1e-6))
    }

    /// True if a point lies within the outline.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        is_on(self.half, at)
    }
}

/// Exponent of the superellipse; 2 is an ellipse.
const ROUNDNESS: f64 = 2.5;

fn is_on(half: [f64; 2], at: [f64; 2]) -> bool {
    (0..2)
        .map(|axis| (at[axis] / half[axis]).abs().powf(ROUNDNESS))
        .sum::<f64>()
        <= 1.0
}

/// Half-width and half-height of the area in which tilts are computed, as a fraction of the
/// half-width and half-height of the face.
const TILTED: f64 = 0.7;

/// Ranges of `strike.toe` and `strike.high`.
fn ranges(setup: &Setup<f64>, [x, y]: [f64; 2]) -> Result<[Vary; 2]> {
    let [toe, high] = [setup.column("strike.toe")?, setup.column("strike.high")?];
    Ok([Vary::new(toe, -x, x)?, Vary::new(high, -y, y)?])
}

/// Points on the face, each with the tilt of the spin axis relative to the drive `centred`, rad.
fn tilts(setup: &Setup<f64>, centred: &Setup<f64>, half: [f64; 2]) -> Result<Vec<([f64; 2], f64)>> {
    let [across, up] = ranges(setup, half.map(|half| TILTED * half))?;
    let plane = Plane::fly(
        setup,
        &[Outcome::SpinAxis],
        across,
        up,
        ARROWS,
        Order::Value,
    )?;
    let straight = Drive::new(centred)
        .ok()
        .and_then(|drive| Outcome::SpinAxis.value(&drive))
        .unwrap_or_default();
    let tilt = |(node, axis): (usize, &Option<f64>)| {
        let at = plane.node(node);
        let axis = Outcome::SpinAxis.unwrap_angle((*axis)?, straight);
        is_on(half, at).then_some((at, axis - straight))
    };
    let nodes = plane.values[0].iter().enumerate();
    Ok(nodes.filter_map(tilt).collect())
}
