//! A table of measured shots.

use super::shot::Shot;
use super::statistics::Uncertainties;
use crate::parameters::Parameter;
use crate::table::{air_as_given, air_of_rows};
use crate::units::Message;

/// Measured shots, a row each.
///
/// The head names parameters (inputs of the shot), outcomes (what was measured), `sigma OUTCOME`
/// (its standard uncertainty), `stationary` (names of parameters, separated by spaces, in which
/// carry is at its largest there), `sigma stationary`, and `note`; with its unit in brackets.
/// Heads, units, separators and sides may also be those of a launch monitor's export; carry is the
/// distance to the landing point, [`Outcome::CarryDistance`](crate::Outcome::CarryDistance). Where
/// `ball_speed`, `launch_angle` and `spin` or `backspin` stand beside no parameter of swing, club,
/// strike or impact, the rows are launch conditions, and the ball flies from them without an
/// impact.
#[derive(Clone, Debug)]
pub struct ShotTable {
    /// Where it was read from, for messages.
    pub file: String,
    /// The shots.
    pub shots: Vec<Shot>,
    /// Rows are launch conditions.
    pub is_launched: bool,
    /// Notes: outcomes without a sigma column.
    pub remarks: Vec<Message>,
    /// What deserves more than that, of a table that is no launch monitor's export: rows that were
    /// left out, and spins of which one is not used.
    pub warnings: Vec<Message>,
    /// The heads of a measured launch, and of the columns of the club beside it, where both are
    /// there: the rows are then deliveries.
    pub(super) launch_beside_club: Option<[String; 2]>,
    /// Quality of the standard uncertainties.
    pub uncertainties: Uncertainties,
    /// The head of the column of each row's air, of an export that states it.
    pub(super) stated_air: Option<String>,
}

impl ShotTable {
    /// Leaves the air out that an export states of each row, where it is given otherwise.
    pub fn in_given_air(&mut self) {
        let Some(head) = self.stated_air.take() else {
            return;
        };
        let told = air_of_rows(&head);
        for remark in self
            .remarks
            .iter_mut()
            .filter(|remark| remark.to_string() == told)
        {
            *remark = air_as_given(&head).into();
        }
        for shot in &mut self.shots {
            shot.inputs
                .retain(|(parameter, _)| parameter.name != "air.density");
        }
    }

    /// How many residuals there are.
    pub fn residuals(&self) -> usize {
        self.shots.iter().map(Shot::residuals).sum()
    }

    /// Residuals up to this size are rounding: 1e-12 of the largest measured value in units of its
    /// standard uncertainty.
    pub fn rounding(&self) -> f64 {
        let measured = self.shots.iter().flat_map(|shot| &shot.measured);
        1e-12
            * measured
                .map(|measurement| (measurement.value / measurement.sigma).abs())
                .fold(0.0, f64::max)
    }

    /// True if the shots state this parameter.
    pub fn gives(&self, parameter: &'static Parameter) -> bool {
        self.shots
            .iter()
            .any(|shot| shot.inputs.iter().any(|(row, _)| *row == parameter))
    }
}
