//! Laws of drag and lift of a spinning ball (docs/model.md, eq. 14), one file per law. The
//! coefficients of the laws, with names, ranges and sources, are in the parameter table.
//!
//! F_D = ½ ρ A C_D |v|², F_L = ½ ρ A C_L |v|².

mod bearman_harvey;
mod ferguson;
mod fitted;
mod gridded;
mod launch_monitor;
mod linear;
mod lyu;
mod macdonald_hanzely;
mod measured;
mod naruo_mizota;
mod nathan;
mod origin;
mod robinson;
mod smits_smith;
mod table;
mod usga_itr;
mod winfield_tan;

pub(crate) use fitted::Continuation;
pub use fitted::{Fitted, RangeEnd};

use crate::number::Numbers;
use crate::parameters::{Law, LawVariable, with_law};
use serde::Serialize;

/// Flow of the air past the ball, from which a law computes its variables.
#[derive(Clone, Copy, Debug)]
pub struct Stream<T> {
    /// Spin |ω|, rad/s.
    pub spin: T,
    /// Airspeed |v|, m/s.
    pub speed: T,
    /// |v|², m²/s². A law computes 1/|v| from |v|², without waiting for the square root |v|.
    pub(crate) square: T,
    /// Radius of the ball R, m.
    pub radius: T,
    /// Re/|v| = ρ 2R/μ, s/m.
    pub reynolds_per_speed: T,
}

impl<T: Numbers> Stream<T> {
    /// The flow with the spin |ω|, rad/s, the airspeed |v|, m/s, the radius R of the ball, m, and
    /// Re/|v|, s/m.
    ///
    /// ```
    /// use longdrive::aerodynamics::Stream;
    /// let stream = Stream::new(300.0, 60.0, 0.02, 3000.0);
    /// assert!((stream.spin_ratio() - 0.1_f64).abs() < 1e-15 && stream.reynolds() == 180_000.0);
    /// ```
    pub fn new(spin: T, speed: T, radius: T, reynolds_per_speed: T) -> Self {
        Self {
            spin,
            speed,
            square: speed * speed,
            radius,
            reynolds_per_speed,
        }
    }

    /// Spin ratio s = R |ω|/|v|.
    #[inline(always)]
    pub fn spin_ratio(&self) -> T {
        let (_, per_speed) = self.square.sqrt_recip();
        self.radius * self.spin * per_speed
    }

    /// Reynolds number Re = ρ |v| 2R/μ.
    #[inline(always)]
    pub fn reynolds(&self) -> T {
        self.reynolds_per_speed * self.speed
    }

    /// A variable of the law.
    #[inline(always)]
    pub fn value(&self, variable: LawVariable) -> T {
        match variable {
            LawVariable::SpinRatio => self.spin_ratio(),
            LawVariable::Spin => self.spin,
            LawVariable::Reynolds => self.reynolds(),
            LawVariable::Speed => self.speed,
        }
    }

    /// The variables in the order of [`LawVariable::ALL`].
    #[inline(always)]
    pub fn variables(&self) -> [T; 4] {
        [self.spin_ratio(), self.spin, self.reynolds(), self.speed]
    }
}

/// Coefficients of drag and lift.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients<T> {
    /// Drag coefficient C_D.
    pub drag: T,
    /// Lift coefficient C_L.
    pub lift: T,
}

/// Source of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Published {
    /// Authors of the publication, or of the fit to published data.
    pub authors: &'static str,
    /// Year of the publication.
    pub year: Option<u16>,
    /// The measured ball, if the source names it.
    pub ball: Option<&'static str>,
    /// The publication, and how its numbers were obtained.
    pub source: &'static str,
}

/// The source of a law, the ranges that it was fitted to, and its smoothness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawProperties {
    /// The source.
    pub published: Published,
    /// The ranges that the law was fitted to.
    pub fitted: Fitted,
    /// Number of continuous derivatives of C_D and C_L at the joins of a piecewise law; `None` for
    /// a law without joins. A join limits the order of the integration step that crosses the join.
    pub continuous_derivatives: Option<u32>,
    /// True if C_D has a slope in |ω| at zero spin. Outcomes then have a corner at zero spin.
    pub has_corner_at_zero_spin: bool,
}

/// A law of drag and lift. A drive uses one of [`Law`]; implementing this trait adds none. A law of
/// your own is a table: [`Setup::set_table`](crate::Setup::set_table).
pub trait AerodynamicLaw<T: Numbers> {
    /// C_D and C_L in this flow. C_L must tend to 0 with the spin, because the lift has no
    /// direction without spin.
    ///
    /// All laws are inlined into the equation of motion. A long law calls [`Numbers::not_inlined`]
    /// with a `move` closure, so that it does not slow down the other laws (`src/number/mod.rs`,
    /// "Pipelines").
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T>;

    /// The source of the law, the ranges that it was fitted to, and its smoothness.
    fn properties(&self) -> LawProperties;
}

/// Delegates to the law of each variant.
impl<T: Numbers> AerodynamicLaw<T> for Law<T> {
    #[inline(always)]
    fn coefficients(&self, stream: Stream<T>) -> Coefficients<T> {
        // A law that is not inlined returns its `Coefficients` in memory. Copying the fields keeps
        // the coefficients of the inlined laws in registers.
        let (drag, lift) = with_law!(self, |law| {
            let found = law.coefficients(stream);
            (found.drag, found.lift)
        });
        Coefficients { drag, lift }
    }

    fn properties(&self) -> LawProperties {
        with_law!(self, |law| law.properties())
    }
}
