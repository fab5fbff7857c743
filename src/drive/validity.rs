//! Validity limits of the model: the ranges that a law was fitted to, the largest face, the
//! flattest measured bounce.

use super::{Drive, Outcome};
use crate::aerodynamics::{AerodynamicLaw, Continuation};
use crate::flight::{Inputs, Landed};
use crate::ground::angle_of_impact;
use crate::number::Number;
use crate::parameters::{Law, Setup};
use crate::units::{Digits, Message, Quantity, YARD, counted_of};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::sync::atomic::AtomicBool;

/// Smallest change of the carry, m, that causes a warning: 0.3 yd. The change is the effect of a
/// variable outside the range of the law, or of the temperature of the ball.
pub(super) const LEAST_WARNED_CHANGE: f64 = 0.3 * YARD;

/// A variable that the law itself clamps to its fitted range causes a warning if it is outside this
/// range for at least this share of the flight time.
pub(super) const LEAST_WARNED_SHARE: f64 = 0.01;

/// Width and height of the largest conforming head, m: 5 in from heel to toe, 2.8 in from sole to
/// crown (R&A and USGA, Equipment Rules, part 2, 4b).
const LARGEST_HEAD: [f64; 2] = [0.127, 0.07112];

/// Smallest angle between path and ground, rad, for which a bounce was measured. The bounce of a
/// flatter landing is an assumption (docs/limitations.md).
const FLATTEST_MEASURED: f64 = 25.0 * std::f64::consts::PI / 180.0;

/// True if a strike, m from the face centre, is outside the face of any conforming head.
pub(crate) fn is_outside_any_face(toe: f64, high: f64) -> bool {
    let [width, height] = LARGEST_HEAD;
    toe.abs() > 0.5 * width || high.abs() > 0.5 * height
}

/// Description of the largest face, for messages.
pub(crate) fn any_face() -> String {
    let [width, height] = LARGEST_HEAD.map(|size| Quantity::LENGTH.show(size, "mm"));
    format!(
        "the face of any head that conforms to the Rules of Golf (at most {width} from heel to toe \
         and {height} from sole to crown)"
    )
}

/// Angle between the path of a landing ball and the ground, rad, if it is below
/// [`FLATTEST_MEASURED`]. `None` for a steeper landing, and for a ball that does not bounce or does
/// not come to rest. `slopes` are the slopes of the ground downrange and to the right, rad.
pub(crate) fn flat_landing_angle<T: Number>(slopes: [f64; 2], landed: &Landed<T>) -> Option<f64> {
    landed
        .rest
        .as_ref()
        .filter(|rest| rest.bounces > 0 && rest.downrange.re().is_finite())?;
    let angle = angle_of_impact(slopes, landed.velocity.map(Number::re));
    Some(angle).filter(|angle| *angle < FLATTEST_MEASURED)
}

/// Appends [`FLATTEST_MEASURED`] and the warning about flat landings to a message.
pub(super) fn with_flat_landing_warning(before: Message) -> Message {
    before
        .quantity(
            Quantity::ANGLE,
            "deg",
            FLATTEST_MEASURED,
            Digits::Significant(3),
        )
        .words(
            ": the bounce of so flat a landing is assumed, not measured, so total, run and lateral \
             total may be far off; prefer carry (docs/limitations.md)",
        )
}

/// A field for each validity limit of the model. If T is `bool`, a field is true if a drive exceeds
/// the limit. If T is `u64`, a field is the number of drives that exceed the limit; if `f64`, the
/// share of drives, from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExceededLimits<T = bool> {
    /// Spin ratio, spin, Reynolds number or airspeed outside the ranges that the law was fitted to.
    pub law: T,
    /// Strike outside the face of any conforming head.
    pub face: T,
    /// Landing flatter than any measured bounce. It is only checked if an outcome of the run is
    /// requested.
    pub flat: T,
}

/// Part of a drive in which the variables of the law are compared with its fitted ranges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckScope {
    /// The launch only: cheap enough for every drive of a batch.
    Launch,
    /// The whole flight, which must be computed again for the check.
    Flight,
}

impl Drive<f64> {
    /// Validity limits that this drive exceeds. `scope` is the part of the drive in which the
    /// ranges of the law are checked. A flat landing counts only if an outcome in `of` depends on
    /// the run. Once `stop` is true, the check of the flight ends, and the ranges of the law count
    /// as not exceeded.
    pub fn exceeded_limits(
        &self,
        setup: &Setup<f64>,
        scope: CheckScope,
        of: &[Outcome],
        stop: &AtomicBool,
    ) -> ExceededLimits {
        let law = match scope {
            CheckScope::Launch => !setup
                .law
                .properties()
                .fitted
                .contains(Inputs::new(setup, &self.launch).launch_stream().variables()),
            CheckScope::Flight => !self.extrapolated(setup, stop).is_empty(),
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

/// Validity limits that the drive of a setup exceeds. [`Drive::exceeded_limits`] checks the whole
/// flight. `None` if the ball does not land, or if the drive is interrupted because `stop` is true.
#[cfg(feature = "studies")]
pub(crate) fn exceeded_in_flight(
    setup: &Setup<f64>,
    of: &[Outcome],
    stop: &AtomicBool,
) -> Option<ExceededLimits> {
    setup.flight.check_steps().ok()?;
    // the result of an interrupted search is checked too: a short drive ignores `stop`
    let drive = Drive::without_step_check(setup, Some(stop)).ok()?;
    drive.landed().ok()?;
    Some(drive.exceeded_limits(setup, CheckScope::Flight, of, stop))
}

impl ExceededLimits<u64> {
    /// Counts a drive.
    pub fn add(&mut self, drive: ExceededLimits) {
        self.law += u64::from(drive.law);
        self.face += u64::from(drive.face);
        self.flat += u64::from(drive.flat);
    }

    /// Adds the counts of other drives.
    pub fn merge(&mut self, other: Self) {
        self.law += other.law;
        self.face += other.face;
        self.flat += other.flat;
    }
}

/// Written as a list, in the order of the fields.
impl Serialize for ExceededLimits<u64> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        [self.law, self.face, self.flat].serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for ExceededLimits<u64> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let [law, face, flat] = Deserialize::deserialize(deserializer)?;
        Ok(Self { law, face, flat })
    }
}

/// Number of drives that landed, and number of those that exceed each validity limit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExceededCount {
    /// All drives that landed.
    pub all: u64,
    /// Number of drives that exceed each limit.
    pub limits: ExceededLimits<u64>,
}

impl ExceededCount {
    /// Counts a drive.
    pub fn add(&mut self, drive: ExceededLimits) {
        self.all += 1;
        self.limits.add(drive);
    }

    /// Adds the counts of other drives.
    pub fn merge(&mut self, other: Self) {
        self.all += other.all;
        self.limits.merge(other.limits);
    }

    /// A warning for each limit that a drive exceeds. `noun` names the drives, in singular and
    /// plural: "shot", "shots".
    pub fn warnings(&self, law: &Law<f64>, noun: [&str; 2], scope: CheckScope) -> Vec<Message> {
        let subject = |count: u64| (count > 0).then(|| counted_of(count, self.all, noun));
        let subjects = ExceededLimits {
            law: subject(self.limits.law),
            face: subject(self.limits.face),
            flat: subject(self.limits.flat),
        };
        subjects.warnings(law, scope, self.limits.flat == 1)
    }
}

impl ExceededLimits<f64> {
    /// Smallest share of drives that causes a warning.
    const LEAST_WARNED: f64 = 0.01;

    /// Adds a drive with the weight `share`. The weights of all drives add up to 1.
    pub fn add(&mut self, drive: ExceededLimits, share: f64) {
        self.law += share * f64::from(u8::from(drive.law));
        self.face += share * f64::from(u8::from(drive.face));
        self.flat += share * f64::from(u8::from(drive.flat));
    }

    /// Validity limits that at least 1 % of the drives exceed.
    pub fn exceeded_limits(&self) -> ExceededLimits {
        ExceededLimits {
            law: self.law >= Self::LEAST_WARNED,
            face: self.face >= Self::LEAST_WARNED,
            flat: self.flat >= Self::LEAST_WARNED,
        }
    }

    /// A warning for each limit that at least 1 % of the drives exceed. The drives were checked
    /// along their whole flights. `noun` names the drives: "the swings".
    pub fn warnings(&self, law: &Law<f64>, noun: &str) -> Vec<Message> {
        let exceeded = self.exceeded_limits();
        let subject = |is_exceeded: bool, share: f64| {
            is_exceeded.then(|| format!("{:.0} % of {noun}", 100.0 * share))
        };
        let subjects = ExceededLimits {
            law: subject(exceeded.law, self.law),
            face: subject(exceeded.face, self.face),
            flat: subject(exceeded.flat, self.flat),
        };
        subjects.warnings(law, CheckScope::Flight, false)
    }
}

impl ExceededLimits<Option<String>> {
    /// The warnings. Each field of `self` is the beginning of a warning, such as "3 of 10 drives";
    /// `None` if no drive exceeds the limit. `is_one_flat` is true if exactly one drive lands flat.
    fn warnings(self, law: &Law<f64>, scope: CheckScope, is_one_flat: bool) -> Vec<Message> {
        let mut warnings = vec![];
        if let Some(subject) = &self.law {
            warnings.push(law_range_warning(subject, law, scope));
        }
        if let Some(subject) = &self.face {
            let face = any_face();
            let warning = format!(
                "{subject}: the strike lies outside {face}; no conforming club strikes the ball there"
            );
            warnings.push(warning.into());
        }
        if let Some(subject) = &self.flat {
            let lands = if is_one_flat {
                "the ball lands"
            } else {
                "the balls land"
            };
            let beginning = format!("{subject}: {lands} at less than ");
            warnings.push(with_flat_landing_warning(beginning.into()));
        }
        warnings
    }
}

fn law_range_warning(subject: &str, law: &Law<f64>, scope: CheckScope) -> Message {
    let fitted = law.properties().fitted;
    let how = fitted.continuation_of_all(|_| [f64::NEG_INFINITY, f64::INFINITY]);
    let outside = match scope {
        CheckScope::Launch => "the launch is outside of",
        CheckScope::Flight => "the flight leaves",
    };
    let beginning = format!(
        "{subject}: {outside} the ranges that the law {} was fitted to (",
        law.name()
    );
    let message = fitted
        .in_words(beginning.into())
        .words(format!("; {}), where it is {how}", fitted.to));
    match scope {
        CheckScope::Launch => message.words("; the rest of the flight was not checked"),
        CheckScope::Flight => with_thresholds(message, how),
    }
}

/// Adds the thresholds of [`Drive::extrapolated`] in words to a warning, such as ", for at least
/// 1 % of the flight time".
fn with_thresholds(message: Message, how: Continuation) -> Message {
    let lasts = format!(
        "at least {:.0} % of the flight time",
        100.0 * LEAST_WARNED_SHARE
    );
    let with_change = |message: Message| {
        message
            .words(", which changes carry by more than ")
            .quantity(
                Quantity::LENGTH,
                "yd",
                LEAST_WARNED_CHANGE,
                Digits::Significant(1),
            )
    };
    match (how.is_extrapolated, how.is_held) {
        (true, true) => with_change(message).words(format!(" or lasts {lasts}")),
        (false, true) => message.words(format!(", for {lasts}")),
        (_, false) => with_change(message),
    }
}
