use super::Vary;
use super::plane::Plane;
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::impact::Head;
use crate::parameters::{Golfer, Setup, Strike};

/// What the place of a strike on the face does to the carry and to the axis of the spin, flown.
#[derive(Clone, Debug)]
pub struct Face {
    /// The hand of the golfer, on which it depends where the toe is seen.
    pub golfer: Golfer,
    /// Half the face that is looked at, m: towards the toe, and up.
    pub half: [f64; 2],
    /// Whether strikes are measured from the centre of the face, as the centre of mass is not
    /// behind it; else from the sweet spot.
    pub is_from_centre: bool,
    /// Where the normal of the face goes through the centre of mass, m: towards the toe, up; `None`
    /// where it does so nowhere.
    pub sweet_spot: Option<[f64; 2]>,
    /// Where the ball is struck, m: towards the toe, up.
    pub strike: [f64; 2],
    /// The carry from there, m; `None` where it does not fly.
    pub carry: Option<f64>,
    /// [`Face::OUTCOMES`] over `strike.toe` and `strike.high`, SI.
    pub plane: Plane,
    /// The exact derivative of each by `strike.toe` at the sweet spot, or at the centre of the face
    /// where there is none, SI; `None` where one of them has none.
    pub by_toe: Option<[f64; 4]>,
    /// The strike of the longest carry among the nodes on the face, and that carry.
    pub longest: ([f64; 2], f64),
    /// Places on the face with the tilt of the spin axis against that of a strike there, rad, +
    /// right.
    pub tilts: Vec<([f64; 2], f64)>,
}

/// Half the face of a usual driver, m, from heel to toe and from sole to crown.
const HALF: [f64; 2] = [0.055, 0.025];

/// The face ends before its ellipsoid does, by this part.
const WITHIN: f64 = 0.95;

/// Nodes over the face, and places with an arrow.
const NODES: [usize; 2] = [111, 51];
const ARROWS: [usize; 2] = [5, 3];

impl Face {
    /// What is looked at over the face, carry first.
    pub const OUTCOMES: [Outcome; 4] = [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::BallSpeed,
        Outcome::SpinAxis,
    ];

    /// Flies strikes all over the face of a setup's club.
    ///
    /// # Errors
    /// As [`Batch::new`](crate::batch::Batch::new), where no club strikes the ball;
    /// [`Error::NoFlight`] where no strike flies.
    pub fn of(setup: &Setup<f64>) -> Result<Self> {
        let half = half_of(setup);
        let [toe, high] = [setup.column("strike.toe")?, setup.column("strike.high")?];
        let over = |part: f64| -> Result<[Vary; 2]> {
            let [x, y] = half.map(|half| part * half);
            Ok([Vary::new(toe, -x, x)?, Vary::new(high, -y, y)?])
        };
        let [across, up] = over(1.0)?;
        let plane = Plane::fly(setup, &Self::OUTCOMES, across, up, NODES)?;
        let longest = plane
            .largest(0, |at| is_on(half, at))
            .ok_or_else(|| Error::NoFlight {
                reason: "no flight: no strike on the face makes a drive that flies and lands"
                    .into(),
            })?;
        let [across, up] = over(0.7)?;
        let tilted = Plane::fly(setup, &[Outcome::SpinAxis], across, up, ARROWS)?;
        let spot = Strike::on_sweet_spot(&setup.club);
        let centred = Setup {
            strike: spot.unwrap_or(Strike {
                high: 0.0,
                toe: 0.0,
            }),
            ..*setup
        };
        let straight = Drive::new(&centred)
            .ok()
            .and_then(|drive| Outcome::SpinAxis.value(&drive))
            .unwrap_or_default();
        let tilt = |(node, axis): (usize, &Option<f64>)| {
            let at = tilted.node(node);
            Some((
                at,
                Outcome::SpinAxis.unwrap_angle((*axis)?, straight) - straight,
            ))
            .filter(|(at, _)| is_on(half, *at))
        };
        let tilts = tilted.values[0]
            .iter()
            .enumerate()
            .filter_map(tilt)
            .collect();
        let carry = Drive::new(setup)
            .ok()
            .and_then(|drive| Outcome::Carry.value(&drive));
        let by_toe = evaluate(&centred, &Self::OUTCOMES, &[toe], Order::First).ok();
        let by_toe = by_toe
            .and_then(|found| <[_; 4]>::try_from(found).ok())
            .map(|found| found.map(|of| of.gradient[0]));
        Ok(Self {
            golfer: setup.golfer,
            half,
            is_from_centre: Head::new(&setup.club).beside.is_some(),
            sweet_spot: spot.map(|spot| [spot.toe, spot.high]),
            strike: [setup.strike.toe, setup.strike.high],
            carry,
            plane,
            by_toe,
            longest,
            tilts,
        })
    }

    /// The outline of the face: no head has just this one.
    pub fn outline(&self) -> Vec<[f64; 2]> {
        let point = |step: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / 120.0).sin_cos();
            let round =
                |part: f64, half: f64| part.abs().powf(2.0 / ROUNDNESS).copysign(part) * half;
            [round(cos, self.half[0]), round(sin, self.half[1])]
        };
        (0..=120).map(point).collect()
    }

    /// Whether the strike of the longest carry is at the edge of the face: a node beside it is on
    /// the face no more.
    pub fn is_longest_at_edge(&self) -> bool {
        let ([x, y], _) = self.longest;
        let [wide, tall] = [0, 1].map(|axis| 2.0 * self.half[axis] / (NODES[axis] - 1) as f64);
        [[x - wide, y], [x + wide, y], [x, y - tall], [x, y + tall]]
            .into_iter()
            .any(|at| !self.holds(at))
    }

    /// Whether the ball is struck on the sweet spot, to a thousandth of a millimetre.
    pub fn is_struck_sweetly(&self) -> bool {
        self.sweet_spot
            .is_some_and(|spot| (0..2).all(|axis| (spot[axis] - self.strike[axis]).abs() < 1e-6))
    }

    /// Whether a place lies within that outline.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        is_on(self.half, at)
    }
}

/// The power of the superellipse that is drawn as a face: 2 would be an ellipse.
const ROUNDNESS: f64 = 2.5;

fn is_on(half: [f64; 2], at: [f64; 2]) -> bool {
    (0..2)
        .map(|axis| (at[axis] / half[axis]).abs().powf(ROUNDNESS))
        .sum::<f64>()
        <= 1.0
}

/// Half the face: a usual one, or as far as bulge and roll let one reach.
fn half_of(setup: &Setup<f64>) -> [f64; 2] {
    let club = &setup.club;
    let (bulge, roll) = (club.bulge_radius, club.roll_radius);
    let third = club.face_semi_axis.unwrap_or((bulge * roll).sqrt());
    let end = |radius: f64| WITHIN * (radius * third).sqrt();
    [HALF[0].min(end(bulge)), HALF[1].min(end(roll))]
}
