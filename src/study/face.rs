use super::Vary;
use super::plane::Plane;
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::parameters::Setup;

/// What the place of a strike on the face does to the carry and to the axis of the spin, flown.
#[derive(Clone, Debug)]
pub struct Face {
    /// Half the face that is looked at, m: towards the toe, and up.
    pub half: [f64; 2],
    /// Where the ball is struck, m: towards the toe, above the sweet spot.
    pub strike: [f64; 2],
    /// The carry from there, m; `None` where it does not fly.
    pub carry: Option<f64>,
    /// Carries over `strike.toe` and `strike.high`, SI.
    pub plane: Plane,
    /// The strike of the longest carry among the nodes on the face, and that carry.
    pub longest: ([f64; 2], f64),
    /// Places on the face with the tilt of the spin axis against that of a strike on the sweet spot, rad, + right.
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
    /// Flies strikes all over the face of a setup's club.
    ///
    /// # Errors
    /// As [`Batch::new`](crate::batch::Batch::new), where no club strikes the ball; [`Error::NoFlight`] where no strike flies.
    pub fn of(setup: &Setup<f64>) -> Result<Self> {
        let half = half_of(setup);
        let [toe, high] = [setup.column("strike.toe")?, setup.column("strike.high")?];
        let over = |part: f64| -> Result<[Vary; 2]> {
            let [x, y] = half.map(|half| part * half);
            Ok([Vary::new(toe, -x, x)?, Vary::new(high, -y, y)?])
        };
        let [across, up] = over(1.0)?;
        let plane = Plane::fly(setup, &[Outcome::Carry], across, up, NODES)?;
        let longest = plane.largest(0, |at| is_on(half, at)).ok_or_else(|| Error::NoFlight {
            reason: "no flight: no strike on the face makes a drive that flies and lands".into(),
        })?;
        let [across, up] = over(0.7)?;
        let tilted = Plane::fly(setup, &[Outcome::SpinAxis], across, up, ARROWS)?;
        // the middle one of an odd number of places is the sweet spot
        let straight = tilted.values[0].get(tilted.values[0].len() / 2).copied().flatten().unwrap_or_default();
        let tilt = |(node, axis): (usize, &Option<f64>)| {
            let at = tilted.node(node);
            Some((at, Outcome::SpinAxis.beside((*axis)?, straight) - straight)).filter(|(at, _)| is_on(half, *at))
        };
        let tilts = tilted.values[0].iter().enumerate().filter_map(tilt).collect();
        let carry = Drive::new(setup).ok().and_then(|drive| Outcome::Carry.value(&drive));
        Ok(Self { half, strike: [setup.strike.toe, setup.strike.high], carry, plane, longest, tilts })
    }

    /// The outline of the face: no head has just this one.
    pub fn outline(&self) -> Vec<[f64; 2]> {
        let point = |step: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / 120.0).sin_cos();
            let round = |part: f64, half: f64| part.abs().powf(2.0 / ROUNDNESS).copysign(part) * half;
            [round(cos, self.half[0]), round(sin, self.half[1])]
        };
        (0..=120).map(point).collect()
    }

    /// Whether the strike of the longest carry is at the edge of the face: a node beside it is on the face no more.
    pub fn is_longest_at_edge(&self) -> bool {
        let ([x, y], _) = self.longest;
        let [wide, tall] = [0, 1].map(|axis| 2.0 * self.half[axis] / (NODES[axis] - 1) as f64);
        [[x - wide, y], [x + wide, y], [x, y - tall], [x, y + tall]].into_iter().any(|at| !self.holds(at))
    }

    /// Whether a place lies within that outline.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        is_on(self.half, at)
    }
}

/// The power of the superellipse that is drawn as a face: 2 would be an ellipse.
const ROUNDNESS: f64 = 2.5;

fn is_on(half: [f64; 2], at: [f64; 2]) -> bool {
    (0..2).map(|axis| (at[axis] / half[axis]).abs().powf(ROUNDNESS)).sum::<f64>() <= 1.0
}

/// Half the face: a usual one, or as far as bulge and roll let one reach.
fn half_of(setup: &Setup<f64>) -> [f64; 2] {
    let club = &setup.club;
    let (bulge, roll) = (club.bulge_radius, club.roll_radius);
    let third = club.face_semi_axis.unwrap_or((bulge * roll).sqrt());
    let end = |radius: f64| WITHIN * (radius * third).sqrt();
    [HALF[0].min(end(bulge)), HALF[1].min(end(roll))]
}
