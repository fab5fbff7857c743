use super::measure::Measure;
use super::strokes::Strokes;
use crate::drive::{self, Outcome};
use crate::error::Result;
use crate::study::Constraint;
use crate::study::comparison::{Compared, Part, at, compared, value};
use crate::study::constraint::of_parameter;
use crate::units::Quantity;

/// A weighted sum of measures: `mean(carry) - 0.5*std(lateral)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// As it was given.
    pub expression: String,
    /// Each measure with its weight, SI.
    pub terms: Vec<(f64, Measure)>,
    /// What kind of number it is.
    pub quantity: Quantity,
    /// The unit that it is shown in.
    pub unit: &'static str,
}

/// Limits of a goal: `std(lateral) <= 12 yd`.
#[derive(Clone, Debug, PartialEq)]
pub struct GoalLimit {
    /// As it was given.
    pub expression: String,
    /// What is limited.
    pub goal: Goal,
    /// Least value, SI, or −∞.
    pub low: f64,
    /// Greatest value, SI, or ∞.
    pub high: f64,
}

const MEASURES: &str = "mean(OUTCOME), std(OUTCOME), rms(OUTCOME), lowest(OUTCOME, 10%), \
                        highest(OUTCOME, 10%), \
                        within(OUTCOME, 15yd) and strokes(400yd)";

impl Goal {
    /// The mean of an outcome.
    pub fn mean(of: Outcome) -> Self {
        let measure = Measure::Mean(of);
        let (quantity, unit) = (measure.quantity(), measure.unit());
        Self {
            expression: format!("mean({})", of.name()),
            terms: vec![(1.0, measure)],
            quantity,
            unit,
        }
    }

    /// An outcome of one drive: its mean over that drive alone.
    pub fn outcome(of: Outcome) -> Self {
        Self {
            expression: of.name().into(),
            ..Self::mean(of)
        }
    }

    /// Reads a weighted sum of measures; a weight is a number, or for a share or strokes an amount:
    /// `mean(carry) + 30yd*within(lateral, 15yd)`. `strokes` is the table that `strokes(HOLE)` asks
    /// for.
    ///
    /// ```
    /// use longdrive::study::swings::{Goal, Measure};
    /// use longdrive::Outcome;
    /// let goal = Goal::read("mean(carry) - 0.5*std(lateral)", None).unwrap();
    /// assert_eq!(goal.terms[1], (-0.5, Measure::Deviation(Outcome::Lateral)));
    /// let error = Goal::read("mean(carry) + std(descent_angle)", None).unwrap_err().to_string();
    /// assert!(error.contains("an angle"), "{error}");
    /// assert!(Goal::read("carry", None).unwrap_err().to_string().contains("mean(carry)"));
    /// ```
    ///
    /// # Errors
    /// [`Error::Constraint`](crate::error::Error::Constraint), which points into the expression.
    pub fn read(expression: &str, strokes: Option<&Strokes>) -> Result<Self> {
        Self::read_part(
            expression,
            &Part {
                text: expression.trim(),
                column: lead(expression),
            },
            strokes,
        )
    }

    fn read_part(expression: &str, part: &Part<'_>, strokes: Option<&Strokes>) -> Result<Self> {
        let mut terms: Vec<(f64, Measure, Quantity, &'static str)> = vec![];
        for (sign, term) in summands(part) {
            if term.text.is_empty() {
                return Err(at(
                    expression,
                    &term,
                    "a term is missing here; write for example mean(carry) - 0.5*std(lateral)",
                ));
            }
            terms.push(read_term(expression, &term, sign, strokes)?);
            let (quantity, first) = (terms[terms.len() - 1].2, terms[0].2);
            if quantity.si != first.si {
                let reason = format!(
                    "this is {}, and the first term {}: terms that are added must be of one kind; \
                     weight a share with an amount, for \
                     example 30yd*within(lateral, 15yd)",
                    quantity.name, first.name
                );
                return Err(at(expression, &term, &reason));
            }
        }
        let (quantity, unit) = (terms[0].2, terms[0].3);
        let terms = terms
            .into_iter()
            .map(|(weight, measure, ..)| (weight, measure))
            .collect();
        Ok(Self {
            expression: part.text.into(),
            terms,
            quantity,
            unit,
        })
    }

    /// The tables of strokes in it, each with the length of its hole, m.
    pub fn strokes(&self) -> impl Iterator<Item = (&Strokes, f64)> {
        self.terms.iter().filter_map(|(_, measure)| match measure {
            Measure::Strokes(strokes, hole) => Some((strokes, *hole)),
            _ => None,
        })
    }

    /// Whether one of its measures has an edge: it is then smoothed for the search.
    pub(super) fn has_edge(&self) -> bool {
        self.terms.iter().any(|(_, measure)| measure.has_edge())
    }

    /// The outcomes that it needs.
    pub fn outcomes(&self) -> Vec<Outcome> {
        self.terms
            .iter()
            .flat_map(|(_, measure)| measure.outcomes())
            .collect()
    }
}

impl GoalLimit {
    /// The limits of an outcome of one drive.
    pub fn of_drive(constraint: &Constraint) -> Self {
        let Constraint {
            expression,
            outcome,
            low,
            high,
        } = constraint;
        Self {
            expression: expression.clone(),
            goal: Goal::outcome(*outcome),
            low: *low,
            high: *high,
        }
    }

    /// How far a value is beyond the limits: above the upper > 0, below the lower < 0.
    pub fn violation(&self, value: f64) -> f64 {
        value - value.clamp(self.low, self.high)
    }

    /// Whether a value is between the limits, but for the rounding of a search: a millionth of it,
    /// or of one.
    pub fn is_met(&self, value: f64) -> bool {
        let rounding = 1e-6 * value.abs().max(1.0);
        (self.low - rounding..=self.high + rounding).contains(&value)
    }

    /// Reads `GOAL >= LIMIT`, `GOAL <= LIMIT`, `GOAL == VALUE` or `LOW <= GOAL <= HIGH`.
    ///
    /// # Errors
    /// [`Error::Constraint`](crate::error::Error::Constraint), which points into the expression.
    pub fn read(expression: &str, strokes: Option<&Strokes>) -> Result<Self> {
        let example = "std(lateral) <= 12yd or mean(carry) >= 240yd";
        let Compared {
            of: goal,
            low,
            high,
        } = compared(
            expression,
            example,
            |text| text.contains('(') || Outcome::named(text.trim()).is_ok(),
            |part| {
                let goal = Goal::read_part(expression, part, strokes)?;
                let quantity = goal.quantity;
                Ok((goal, move |limit: &Part<'_>| {
                    value(expression, limit, quantity)
                }))
            },
        )?;
        Ok(Self {
            expression: expression.trim().into(),
            goal,
            low,
            high,
        })
    }
}

fn lead(text: &str) -> usize {
    text.chars().take_while(|c| c.is_whitespace()).count()
}

/// The terms between the signs + and − that stand outside of parentheses, each with its sign.
pub(super) fn summands<'a>(whole: &Part<'a>) -> Vec<(f64, Part<'a>)> {
    let text = whole.text;
    let (mut depth, mut from, mut sign, mut terms) = (0_i32, 0, 1.0, vec![]);
    let part = |from: usize, to: usize| {
        let piece = &text[from..to];
        let column = whole.column + text[..from].chars().count() + lead(piece);
        Part {
            text: piece.trim(),
            column,
        }
    };
    let mut before = None;
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            // not the sign of an exponent, and not the sign of what follows
            '+' | '-' if depth == 0 && !matches!(before, Some('e' | 'E' | '^')) => {
                let term = part(from, at);
                if !(term.text.is_empty() && terms.is_empty()) {
                    terms.push((sign, term));
                }
                (sign, from) = (if c == '-' { -1.0 } else { 1.0 }, at + 1);
            }
            _ => {}
        }
        before = Some(c).filter(|c| !c.is_whitespace());
    }
    terms.push((sign, part(from, text.len())));
    terms
}

/// `[WEIGHT *] MEASURE(OUTCOME[, AMOUNT])`.
fn read_term(
    expression: &str,
    term: &Part<'_>,
    sign: f64,
    strokes: Option<&Strokes>,
) -> Result<(f64, Measure, Quantity, &'static str)> {
    let refuse = |reason: &str| Err(at(expression, term, reason));
    let (weight, call) = match term.text.split_once('*') {
        Some((weight, call)) if !weight.contains('(') => (Some(weight.trim()), call.trim()),
        _ => (None, term.text),
    };
    let Some((name, rest)) = call.split_once('(') else {
        return match Outcome::named(call) {
            // no swing changes it: its mean is its value
            Ok(of) if of.group() == drive::OutcomeGroup::Head => {
                let text = term.text.replace(call, &format!("mean({call})"));
                read_term(
                    expression,
                    &Part {
                        text: &text,
                        column: term.column,
                    },
                    sign,
                    strokes,
                )
            }
            Ok(_) => refuse(&format!(
                "over many swings an outcome has many values; say what of them, for example \
                 mean({call}): {MEASURES}"
            )),
            Err(_) => refuse(
                &of_parameter(call)
                    .unwrap_or_else(|| format!("'{call}' is no measure; there are {MEASURES}")),
            ),
        };
    };
    let Some((inside, behind)) = rest.split_once(')') else {
        return refuse("its closing ) is missing");
    };
    match behind.trim() {
        "" => {}
        behind if behind.starts_with('/') => {
            return refuse(&format!(
                "there is no division; a weight stands before the measure, for example \
                 0.5*{}({inside})",
                name.trim()
            ));
        }
        behind if behind.contains('(') => {
            return refuse(&format!("a + or - is missing before '{behind}'"));
        }
        behind => {
            return refuse(&format!(
                "'{behind}' stands behind the ); a weight stands before the measure, for example \
                 0.5*{}({inside})",
                name.trim()
            ));
        }
    }
    let words: Vec<&str> = inside.split(',').map(str::trim).collect();
    let outcome =
        || Outcome::named(words[0]).map_err(|error| at(expression, term, &error.to_string()));
    let share = || {
        let share = words[1]
            .strip_suffix('%')
            .map(|part| part.trim().parse::<f64>().map(|part| part / 100.0));
        match share.unwrap_or_else(|| words[1].parse()) {
            Ok(share) if share > 0.0 && share < 1.0 => Ok(share),
            _ => Err(at(
                expression,
                term,
                &format!(
                    "'{}' is no share above 0 and below 100%, for example 10%",
                    words[1]
                ),
            )),
        }
    };
    let amount = |quantity: Quantity, text: &str| match quantity.read_difference(text) {
        Ok(amount) if amount > 0.0 && amount.is_finite() => Ok(amount),
        Ok(_) => Err(at(expression, term, &format!("'{text}' must be above 0"))),
        Err(error) => Err(at(expression, term, &error.to_string())),
    };
    let measure = match (name.trim(), words.len()) {
        ("mean", 1) => Measure::Mean(outcome()?),
        ("std", 1) => Measure::Deviation(outcome()?),
        ("rms", 1) => Measure::RootMeanSquare(outcome()?),
        ("lowest", 2) => Measure::Lowest(outcome()?, share()?),
        ("highest", 2) => Measure::Highest(outcome()?, share()?),
        ("within", 2) => {
            let of = outcome()?;
            Measure::Within(of, amount(of.quantity(), words[1])?)
        }
        ("strokes", 1) => match strokes {
            Some(strokes) => Measure::Strokes(strokes.clone(), amount(Quantity::LENGTH, words[0])?),
            None => {
                return refuse(
                    "expected strokes need a table of them; give it with `strokes FILE`",
                );
            }
        },
        ("mean" | "std" | "rms" | "lowest" | "highest" | "within" | "strokes", _) => {
            return refuse(&format!(
                "it has not the values that it needs; there are {MEASURES}"
            ));
        }
        (name, _) => {
            // "0.5 std(…)"
            let weighted = name
                .split_once(char::is_whitespace)
                .filter(|(weight, _)| weight.parse::<f64>().is_ok());
            return refuse(&match weighted {
                Some((weight, name)) => {
                    format!(
                        "a * is missing between a weight and its measure; write \
                         {weight}*{}({inside})",
                        name.trim()
                    )
                }
                None => format!("'{name}' is no measure; there are {MEASURES}"),
            });
        }
    };
    let (quantity, unit) = (measure.quantity(), measure.unit());
    let Some(weight) = weight else {
        return Ok((sign, measure, quantity, unit));
    };
    if let Ok(number) = weight.parse::<f64>()
        && number.is_finite()
    {
        return Ok((sign * number, measure, quantity, unit));
    }
    if quantity.si.is_empty() {
        for of in Outcome::ALL {
            let (kind, unit) = (of.quantity(), of.unit());
            if let Ok(amount) = kind.read_difference(weight) {
                return Ok((sign * amount, measure, kind, unit));
            }
        }
    }
    refuse(&format!(
        "'{weight}' is no weight; write a number, or for a share an amount with its unit, for \
         example 30yd"
    ))
}
