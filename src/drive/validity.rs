//! Drives outside of what the model is made for: of what their law was fitted to, of any face, of
//! the landings that were measured.

use super::flat::{assumed, flat_landing_angle};
use super::{Drive, Outcome};
use crate::aerodynamics::AerodynamicLaw;
use crate::flight::Inputs;
use crate::parameters::{Law, Setup};
use crate::units::{Message, Quantity, counted_of};

/// The largest head that conforms, m: 5 in from heel to toe, 2.8 in from sole to crown (R&A and
/// USGA, Equipment Rules, part 2, 4b). No face is larger.
const LARGEST_HEAD: [f64; 2] = [0.127, 0.07112];

/// Whether a strike, m from the middle of the face, lies beside the face of any head that conforms.
pub(crate) fn is_outside_any_face(toe: f64, high: f64) -> bool {
    let [wide, tall] = LARGEST_HEAD;
    toe.abs() > 0.5 * wide || high.abs() > 0.5 * tall
}

/// The face of the largest head, in words.
pub(crate) fn any_face() -> String {
    let [wide, tall] = LARGEST_HEAD.map(|size| Quantity::LENGTH.show(size, "mm"));
    format!(
        "the face of any head that conforms to the Rules of Golf (at most {wide} from heel to toe \
         and {tall} from sole to crown)"
    )
}

/// In what a drive is outside of what the model is made for, by its launch or by its whole flight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExceededLimits {
    /// The ball has a spin ratio, a Reynolds number or a speed through the air that its law was not
    /// fitted to.
    pub law: bool,
    /// The strike lies beside the face of any head that conforms.
    pub face: bool,
    /// The ball bounces and landed flatter than any whose bounce was measured; looked at where an
    /// outcome of the run is asked for.
    pub flat: bool,
}

/// How much of a drive is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckScope {
    /// The launch alone: cheap enough for every drive of a batch.
    Launch,
    /// The whole flight, flown once more.
    Flight,
}

impl Drive<f64> {
    /// In what the drive of a setup is outside of what the model is made for, where these outcomes
    /// are asked for.
    pub fn exceeded_limits(
        &self,
        setup: &Setup<f64>,
        looked: CheckScope,
        of: &[Outcome],
    ) -> ExceededLimits {
        let law = match looked {
            CheckScope::Launch => !setup
                .law
                .fitted()
                .holds(Inputs::new(setup, &self.launch, false).stream()),
            CheckScope::Flight => !self.law_warnings(setup).is_empty(),
        };
        let slopes = [setup.ground.slope, setup.ground.side_slope];
        let is_flat = || {
            self.landed()
                .is_ok_and(|landed| flat_landing_angle(slopes, landed).is_some())
        };
        ExceededLimits {
            law,
            face: self.impact.is_some() && is_outside_any_face(setup.strike.toe, setup.strike.high),
            flat: of.iter().any(|of| of.needs_run()) && is_flat(),
        }
    }
}

/// How many of some drives are outside of what the model is made for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExceededCount {
    /// All that flew and landed.
    pub all: u64,
    /// Those launched with what the law was not fitted to.
    pub law: u64,
    /// Those struck beside any face.
    pub face: u64,
    /// Those that landed flatter than any whose bounce was measured.
    pub flat: u64,
}

impl ExceededCount {
    /// Counts a drive.
    pub fn add(&mut self, drive: ExceededLimits) {
        self.all += 1;
        self.law += u64::from(drive.law);
        self.face += u64::from(drive.face);
        self.flat += u64::from(drive.flat);
    }

    /// Adds other drives.
    pub fn merge(&mut self, other: Self) {
        self.all += other.all;
        self.law += other.law;
        self.face += other.face;
        self.flat += other.flat;
    }

    /// Warnings: a sentence for each kind of which there are any. `of` is what they are: "drive",
    /// "optimum".
    pub fn warnings(&self, law: &Law<f64>, of: [&str; 2], looked: CheckScope) -> Vec<Message> {
        let some = |count: u64| (count > 0).then(|| counted_of(count, self.all, of));
        in_words(
            [self.law, self.face, self.flat].map(some),
            self.flat == 1,
            law,
            looked,
        )
    }
}

/// Which shares of some drives, from 0 to 1, are outside of what the model is made for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExceededShare {
    /// The share that flies with what the law was not fitted to.
    pub law: f64,
    /// The share struck beside any face.
    pub face: f64,
    /// The share that lands flatter than any whose bounce was measured.
    pub flat: f64,
}

impl ExceededShare {
    /// Less than this share of drives that vary is not worth a word, as less than 1 % of a flight
    /// is not.
    const WORTH_A_WORD: f64 = 0.01;

    /// Adds a drive that is this share of all.
    pub fn add(&mut self, drive: ExceededLimits, share: f64) {
        self.law += share * f64::from(u8::from(drive.law));
        self.face += share * f64::from(u8::from(drive.face));
        self.flat += share * f64::from(u8::from(drive.flat));
    }

    /// The kinds that 1 % of the drives or more are of.
    pub fn worth_a_word(&self) -> ExceededLimits {
        let is = |share: f64| share >= Self::WORTH_A_WORD;
        ExceededLimits {
            law: is(self.law),
            face: is(self.face),
            flat: is(self.flat),
        }
    }

    /// Warnings about drives that were looked at along their flights: a sentence for each kind that
    /// 1 % of them or more are of. `of` is what they are: "the swings".
    pub fn warnings(&self, law: &Law<f64>, of: &str) -> Vec<Message> {
        let ExceededLimits {
            law: of_law,
            face,
            flat,
        } = self.worth_a_word();
        let shares = [(of_law, self.law), (face, self.face), (flat, self.flat)];
        let which = shares
            .map(|(is_told, share)| is_told.then(|| format!("{:.0} % of {of}", 100.0 * share)));
        in_words(which, false, law, CheckScope::Flight)
    }
}

/// A sentence for each kind of which there are any: those beyond the law, beside any face, and
/// landed flat.
fn in_words(
    which: [Option<String>; 3],
    is_one_flat: bool,
    law: &Law<f64>,
    looked: CheckScope,
) -> Vec<Message> {
    let [of_law, face, flat] = which;
    let mut warnings = vec![];
    if let Some(which) = of_law {
        let fitted = law.fitted();
        let (when, rest) = match looked {
            CheckScope::Launch => ("at launch", "; the rest of the flight was not checked"),
            CheckScope::Flight => ("in 1 % of the flight or more", ""),
        };
        let name = law.name();
        let before = Message::from(format!(
            "{which}: {when} outside of what the law {name} was fitted to ("
        ));
        let how = fitted.beyond(fitted.left([[f64::NEG_INFINITY, f64::INFINITY]; 4]));
        warnings.push(
            fitted
                .in_words(before)
                .words(format!("; {}), where it is {how}{rest}", fitted.to)),
        );
    }
    if let Some(which) = face {
        warnings.push(
            format!(
                "{which}: the strike lies outside {}: no club strikes the ball there",
                any_face()
            )
            .into(),
        );
    }
    if let Some(which) = flat {
        let lands = if is_one_flat {
            "the ball lands"
        } else {
            "the balls land"
        };
        warnings.push(assumed(format!("{which}: {lands} at less than ").into()));
    }
    warnings
}
