use super::Drive;
use super::declaration::{ComputedFrom, Instrument, OutcomeGroup, Sign};
use super::outcome_table::{Outcome, OutcomeInputs};
use crate::error::{Error, Result};
use crate::flight::{Flight, RequestedOutputs};
use crate::number::Number;
use crate::units::{DisplayUnit, Quantity};
use serde::{Serialize, Serializer};
use std::fmt;
use std::sync::atomic::AtomicBool;

impl Outcome {
    /// The outcomes of drives; the outcomes of the head are [`OF_HEAD`](Self::OF_HEAD).
    pub const OF_DRIVES: &'static [Self] = Self::ALL.split_at(Self::count_of_drives()).0;

    /// Outcomes of the head, which do not depend on the swing. [`named`](Self::named) also finds
    /// them.
    pub const OF_HEAD: &'static [Self] = Self::ALL.split_at(Self::count_of_drives()).1;

    const fn count_of_drives() -> usize {
        let mut count = 0;
        while !matches!(
            Self::ALL[count].declaration().computed_from,
            ComputedFrom::Head
        ) {
            count += 1;
        }
        count
    }

    /// Name in JSON and on the command line: `carry`.
    pub fn name(self) -> &'static str {
        self.declaration().name
    }

    /// Symbol in docs/model.md.
    pub fn symbol(self) -> &'static str {
        self.declaration().symbol
    }

    /// One line of documentation.
    pub fn doc(self) -> &'static str {
        self.declaration().doc
    }

    /// Kind of quantity, with its SI unit.
    pub fn quantity(self) -> Quantity {
        self.declaration().quantity
    }

    /// Display unit.
    pub fn unit(self) -> &'static str {
        self.declaration().unit
    }

    /// Part of the drive that the formula reads.
    pub(crate) fn computed_from(self) -> ComputedFrom {
        self.declaration().computed_from
    }

    /// Sign of the values of the outcome.
    pub(crate) fn sign(self) -> Sign {
        self.declaration().sign
    }

    /// How launch monitors measure the outcome; `None` for an outcome of the head.
    pub fn instrument(self) -> Option<&'static Instrument> {
        self.declaration().instrument.as_ref()
    }

    /// Standard uncertainty of a launch monitor's measurement, SI; `None` for an outcome of the
    /// head.
    ///
    /// ```
    /// use longdrive::Outcome;
    /// assert_eq!(Outcome::LaunchAngle.measurement_uncertainty(), Some(0.3_f64.to_radians()));
    /// assert_eq!(Outcome::LaunchAngle.instrument().unwrap().sigma, "0.3 deg");
    /// ```
    pub fn measurement_uncertainty(self) -> Option<f64> {
        self.quantity().read(self.instrument()?.sigma).ok()
    }

    /// Column heads of exports, in lower case, without punctuation.
    pub(crate) fn column_heads(self) -> &'static [&'static str] {
        self.instrument()
            .map_or(&[], |instrument| instrument.column_heads)
    }

    /// The part of a drive that the outcome describes.
    pub fn group(self) -> OutcomeGroup {
        match self.computed_from() {
            ComputedFrom::Launch => OutcomeGroup::Launch,
            ComputedFrom::Head => OutcomeGroup::Head,
            ComputedFrom::Landing
            | ComputedFrom::LandingVelocity
            | ComputedFrom::ApexHeight
            | ComputedFrom::ApexTime
            | ComputedFrom::Rest => OutcomeGroup::Flight,
        }
    }

    /// All outcomes of a group.
    pub fn in_group(group: OutcomeGroup) -> impl Iterator<Item = Self> + Clone {
        Self::ALL
            .iter()
            .copied()
            .filter(move |outcome| outcome.group() == group)
    }

    /// True if the outcome depends on the apex.
    pub(crate) fn needs_apex(self) -> bool {
        matches!(
            self.computed_from(),
            ComputedFrom::ApexHeight | ComputedFrom::ApexTime
        )
    }

    /// True if the outcome depends on the run of the ball on the ground after the landing.
    pub fn needs_run(self) -> bool {
        self.computed_from() == ComputedFrom::Rest
    }

    /// Parts of a flight that the outcomes `of` depend on.
    pub(crate) fn requested_outputs<'s>(
        of: &[Self],
        defect: bool,
        stop: Option<&'s AtomicBool>,
    ) -> RequestedOutputs<'s> {
        RequestedOutputs {
            apex: of.iter().any(|outcome| outcome.needs_apex()),
            run: of.iter().any(|outcome| outcome.needs_run()),
            defect,
            stop,
        }
    }

    /// True if the outcome is positive to the right of the target line and negative to the left.
    pub(crate) fn is_to_the_right(self) -> bool {
        self.sign() == Sign::Right
    }

    /// True for a distance to the right of the target line, which depends on launch direction and
    /// spin axis.
    pub(crate) fn is_lateral(self) -> bool {
        self.is_to_the_right() && self.group() == OutcomeGroup::Flight
    }

    /// Reason why a value of this outcome is not finite, for a message.
    pub(crate) fn why_undefined(self) -> &'static str {
        if self.needs_run() {
            return "the ball does not come to rest: the landing area is too steep (ground.slope, \
                    ground.side_slope) for ground.rolling and ground.friction, or falls away more \
                    steeply than the ball comes down";
        }
        match self {
            Self::LaunchDirection | Self::Backspin | Self::Sidespin | Self::SpinAxis => {
                "its direction does not exist: the launch is vertical, or the ball does not spin"
            }
            _ => "its value is not finite: a number of the setup is too large or too small",
        }
    }

    /// The outcome of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`], with the nearest name, if no outcome has this name.
    pub fn named(name: &str) -> Result<Self> {
        Self::ALL
            .iter()
            .copied()
            .find(|outcome| outcome.name() == name)
            .ok_or_else(|| {
                let names = Self::ALL.iter().map(|outcome| outcome.name());
                Error::unknown(
                    "outcome",
                    name,
                    names.clone(),
                    format!("the outcomes are {}", names.collect::<Vec<_>>().join(", ")),
                )
            })
    }

    /// The outcome of a drive, SI, in the number type of the drive.
    ///
    /// # Errors
    /// [`Error::NoFlight`] for an outcome of the flight if the ball does not land;
    /// [`Error::Undefined`] for an outcome of the club if the setup gives the launch, and for a
    /// value that is not finite. An angle is not finite if its direction does not exist (a vertical
    /// launch, no spin).
    pub fn of<T: Number>(self, drive: &Drive<T>) -> Result<T> {
        let landed = match &drive.flight {
            Flight::Landed(landed) => Some(landed),
            Flight::None(_) => None,
        };
        let inputs = OutcomeInputs {
            launch: &drive.launch,
            club_speed: drive.impact.as_ref().map(|impact| impact.club_speed),
            landed,
            head: drive.impact.as_ref().map(|impact| &impact.head),
        };
        let value = self.evaluate(&inputs).ok_or_else(|| match &drive.flight {
            Flight::None(why) if self.group() == OutcomeGroup::Flight => (*why).into(),
            _ => self.unavailable(),
        })?;
        if !value.re().is_finite() {
            return Err(Error::Undefined {
                what: self.name().into(),
                reason: self.why_undefined().into(),
            });
        }
        Ok(value)
    }

    /// Error for an outcome whose inputs are missing: no club strikes the ball, or the apex and the
    /// run were not computed.
    pub(crate) fn unavailable(self) -> Error {
        let reason = match self.group() {
            OutcomeGroup::Launch | OutcomeGroup::Head => {
                "no club strikes the ball: the launch is given"
            }
            OutcomeGroup::Flight => "the apex and the run of this flight were not computed",
        };
        Error::Undefined {
            what: self.name().into(),
            reason: reason.into(),
        }
    }

    /// The value of this outcome; `None` if [`of`](Self::of) fails.
    pub fn value(self, drive: &Drive<f64>) -> Option<f64> {
        self.of(drive).ok()
    }

    /// Unwraps a direction: brings it within half a turn of `reference`, so that differences and
    /// means do not cross the jump from 180° to −180°. Other outcomes are unchanged.
    ///
    /// ```
    /// use longdrive::Outcome;
    /// let (value, reference) = (-179_f64.to_radians(), 179_f64.to_radians());
    /// assert!((Outcome::SpinAxis.unwrap_angle(value, reference).to_degrees() - 181.0).abs() < 1e-12);
    /// assert_eq!(Outcome::Carry.unwrap_angle(-3.0, 3.0), -3.0);
    /// ```
    pub fn unwrap_angle(self, value: f64, reference: f64) -> f64 {
        let turns = ((reference - value) / std::f64::consts::TAU).round();
        let is_direction = self.is_to_the_right() && self.quantity() == Quantity::ANGLE;
        if is_direction && turns.is_finite() {
            value + turns * std::f64::consts::TAU
        } else {
            value
        }
    }

    /// The change `to` − `from` of the outcome. The change of a direction is at most half a turn.
    pub fn change(self, from: f64, to: f64) -> f64 {
        self.unwrap_angle(to, from) - from
    }

    /// The value as text, in the display unit.
    pub fn show(self, value: f64) -> String {
        self.quantity().show(value, self.unit())
    }
}

impl From<Outcome> for DisplayUnit {
    fn from(outcome: Outcome) -> Self {
        Self {
            quantity: outcome.quantity(),
            unit: outcome.unit(),
        }
    }
}

/// The name: `carry`.
impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The name.
impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
impl schemars::JsonSchema for Outcome {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Outcome".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let names: Vec<_> = Self::ALL.iter().map(|outcome| outcome.name()).collect();
        schemars::json_schema!({
            "description": "The name of an outcome.",
            "type": "string",
            "enum": names
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{ComputedFrom, Drive, Flight, Outcome, OutcomeGroup};
    use crate::flight::Landed;
    use crate::number::Vector;
    use crate::parameters::Setup;
    use crate::units::System;

    /// Outcomes that have no value after `without` has removed a part of a drive.
    fn lost(without: impl Fn(&mut Drive<f64>, &mut Landed<f64>)) -> Vec<Outcome> {
        let mut drive = Drive::new(&Setup::modern_driver()).unwrap();
        let mut landed = *drive.landed().unwrap();
        without(&mut drive, &mut landed);
        drive.flight = Flight::Landed(landed);
        let every = Outcome::ALL.iter().copied();
        every.filter(|of| of.value(&drive).is_none()).collect()
    }

    #[test]
    fn every_unit_of_an_outcome_is_a_unit_of_its_quantity() {
        for of in Outcome::ALL {
            for system in [System::Metric, System::Us] {
                let unit = system.unit(of.unit());
                let is_known = unit.is_empty() || of.quantity().size_of(unit).is_some();
                assert!(is_known, "{} {unit}", of.name());
            }
        }
    }

    fn declared(is: impl Fn(Outcome) -> bool) -> Vec<Outcome> {
        Outcome::ALL.iter().copied().filter(|of| is(*of)).collect()
    }

    #[test]
    fn every_outcome_has_an_uncertainty_above_0_with_a_source() {
        for outcome in Outcome::OF_DRIVES {
            let sigma = outcome.measurement_uncertainty().unwrap_or_default();
            let source = outcome.instrument().unwrap().source();
            let text = source.to_string();
            assert!(
                sigma > 0.0 && sigma.is_finite() && !text.is_empty(),
                "{outcome}"
            );
            // quantities in braces are parsed and then printed in the units of either system
            assert!(!text.contains(['{', '}']), "{text}");
            let metric = source.in_units(System::Metric);
            assert!(
                !metric.contains(" yd") && !metric.contains(" mph"),
                "{metric}"
            );
        }
    }

    #[test]
    fn only_outcomes_of_a_direction_at_launch_are_undefined_for_lack_of_it() {
        assert_eq!(
            declared(|of| of
                .why_undefined()
                .starts_with("its direction does not exist")),
            [
                Outcome::LaunchDirection,
                Outcome::Backspin,
                Outcome::Sidespin,
                Outcome::SpinAxis
            ]
        );
    }

    #[test]
    fn each_formula_reads_the_part_that_its_declaration_names() {
        assert_eq!(lost(|_, _| {}), []);
        assert_eq!(
            lost(|_, landed| landed.apex = None),
            declared(Outcome::needs_apex)
        );
        assert_eq!(
            lost(|_, landed| landed.rest = None),
            declared(Outcome::needs_run)
        );
        let unknown = Vector::new(f64::NAN, f64::NAN, f64::NAN);
        assert_eq!(
            lost(|_, landed| landed.velocity = unknown),
            declared(|of| of.computed_from() == ComputedFrom::LandingVelocity)
        );
        assert_eq!(
            lost(|drive, _| {
                drive.launch.velocity = unknown;
                drive.launch.spin = unknown;
            }),
            declared(|of| of.group() == OutcomeGroup::Launch)
        );
        assert_eq!(
            lost(|drive, _| drive.impact = None),
            declared(|of| of.group() == OutcomeGroup::Head || of == Outcome::SmashFactor)
        );
    }
}
