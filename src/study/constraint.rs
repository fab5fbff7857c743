use super::comparison::{Compared, Part, at, compared, value};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::Setup;

/// Limits of an outcome: `descent_angle >= 38 deg`.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    /// As it was given.
    pub expression: String,
    /// The outcome.
    pub outcome: Outcome,
    /// Least value, SI, or −∞.
    pub low: f64,
    /// Greatest value, SI, or ∞.
    pub high: f64,
}

/// What to do about a limit of a parameter, where a text is the name of one.
pub(super) fn of_parameter(text: &str) -> Option<String> {
    let found = Setup::<f64>::default().parameter(text);
    let is_parameter = matches!(found, Ok(_) | Err(Error::OtherLaw { .. }));
    is_parameter.then(|| {
        format!(
            "{text} is a parameter, and limits are of outcomes; give its range with `vary \
                 {text}=LOW..HIGH`"
        )
    })
}

impl Constraint {
    /// Whether it is an equation, which holds wherever it is met.
    pub fn is_equation(&self) -> bool {
        self.low == self.high
    }

    /// Reads `OUTCOME >= LIMIT`, `OUTCOME <= LIMIT`, `OUTCOME == VALUE` or
    /// `LOW <= OUTCOME <= HIGH`; a limit is a number with its unit.
    ///
    /// ```
    /// use longdrive::study::Constraint;
    /// let steep = Constraint::read("descent_angle >= 38 deg").unwrap();
    /// assert_eq!((steep.low, steep.high), (38.0_f64.to_radians(), f64::INFINITY));
    /// let flat = Constraint::read("10 yd <= apex_height <= 35 yd").unwrap();
    /// assert_eq!((flat.low, flat.high), (9.144, 32.004));
    /// let error = Constraint::read("descent_angel >= 38 deg").unwrap_err().to_string();
    /// assert!(error.contains("did you mean 'descent_angle'?"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Constraint`], which points into the expression.
    pub fn read(expression: &str) -> Result<Self> {
        let example = "descent_angle >= 38deg, lateral == 0m or 20yd <= apex_height <= 35yd";
        if let Some((name, _)) = expression.split_once(':') {
            let reason = "a relation of parameters is a limit over many swings (`swings` or \
                          `distribution`) and of `design()`; for one \
                          drive, give the range of a parameter with `vary`, or limit an outcome";
            return Err(at(
                expression,
                &Part {
                    text: name,
                    column: 0,
                },
                reason,
            ));
        }
        let is_outcome = |text: &str| Outcome::named(text).is_ok();
        let Compared {
            of: outcome,
            low,
            high,
        } = compared(expression, example, is_outcome, |part| {
            let outcome = Outcome::named(part.text).map_err(|e| {
                at(
                    expression,
                    part,
                    &of_parameter(part.text).unwrap_or_else(|| e.to_string()),
                )
            })?;
            Ok((outcome, move |limit: &Part<'_>| {
                value(expression, limit, outcome.quantity())
            }))
        })?;
        Ok(Self {
            expression: expression.trim().into(),
            outcome,
            low,
            high,
        })
    }

    /// Whether its limits are limits, which those of one that was not read need not be.
    ///
    /// # Errors
    /// [`Error::SearchRange`].
    pub(super) fn check(&self) -> Result<()> {
        let Self {
            expression,
            outcome,
            low,
            high,
        } = self;
        if low <= high {
            return Ok(());
        }
        let [low, high] = [*low, *high].map(|limit| outcome.show(limit));
        let reason = format!(
            "its limits are {low} and {high}; the lower must be a number not above the upper"
        );
        Err(Error::SearchRange {
            name: expression.clone(),
            reason,
        })
    }
}
