//! One drive: outcomes, derivatives, and the path of the ball.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{CheckedSetup, SetupRequest};
use longdrive::derivative::{Taylor, diagonal};
use longdrive::flight::{Flight, Trajectory, trajectory};
use longdrive::number::Vector;
use longdrive::parameters::{Parameter, idle_warnings};
use longdrive::units::System;
use longdrive::{Drive, Error, Outcome};
use serde::{Deserialize, Serialize};

/// The head of a request: the setup, and the requested derivatives.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: System,
    #[serde(default)]
    of: Vec<String>,
    #[serde(default)]
    wrt: Vec<String>,
    /// False if only derivatives are requested.
    #[serde(default = "yes")]
    outcomes: bool,
    #[serde(default)]
    path: bool,
}

fn yes() -> bool {
    true
}

#[derive(Serialize)]
struct Head<'a> {
    status: &'static str,
    message: Option<String>,
    outcomes: Vec<&'static str>,
    of: &'a [String],
    wrt: &'a [String],
    path: usize,
    run: usize,
    stated: Vec<&'a str>,
    missing: Vec<Missing>,
    warnings: Vec<String>,
}

/// The reason for missing derivatives: of the outcome `of` by all parameters, or of all outcomes by
/// the parameter `wrt`. The other field is `None`.
#[derive(Serialize)]
struct Missing {
    of: Option<&'static str>,
    wrt: Option<String>,
    message: String,
}

/// Answers with the values of the outcomes, the derivatives, and the path of the ball.
///
/// # Errors
/// The message of the program, if there is no drive.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let of = checked.outcomes(&request.of)?;
    let derivatives = Derivatives::new(&checked, request)?;
    if request.path && !request.outcomes {
        return Err(Refusal::of_request("a path needs outcomes"));
    }
    let mut numbers = vec![];
    let mut head = Head {
        status: "done",
        message: None,
        outcomes: vec![],
        of: &request.of,
        wrt: &request.wrt,
        path: 0,
        run: 0,
        stated: vec![],
        missing: vec![],
        warnings: vec![],
    };
    let drive = request.outcomes.then(|| Drive::new(&checked.setup));
    let drive = drive.transpose().map_err(|error| checked.refused(&error))?;
    if let Some(drive) = &drive {
        head.append_outcomes(drive, &checked, &mut numbers);
    }
    head.missing = derivatives.append(&of, &mut numbers)?;
    if let Some(drive) = drive.filter(|_| request.path) {
        let path = trajectory(&checked.setup, &drive.launch);
        let path = path.map_err(|error| checked.refused(&error))?;
        (head.path, head.run) = (path.points.len(), path.run.len());
        append(&path, &mut numbers);
    }
    if request.outcomes {
        for (name, value) in checked.stated() {
            head.stated.push(name);
            numbers.push(value);
        }
    }
    Ok(message::with_numbers(&head, &numbers))
}

impl Head<'_> {
    /// Appends the value of every outcome, and copies status and warnings of the drive.
    fn append_outcomes(
        &mut self,
        drive: &Drive<f64>,
        checked: &CheckedSetup<'_>,
        numbers: &mut Vec<f64>,
    ) {
        let setup = &checked.setup;
        let mut warnings = drive.warnings_about(setup, Outcome::OF_DRIVES);
        let names = setup
            .parameters()
            .into_iter()
            .map(|parameter| parameter.name);
        warnings.extend(idle_warnings(names, &[*setup]));
        self.warnings = warnings.iter().map(|text| checked.text(text)).collect();
        self.outcomes = Outcome::OF_DRIVES.iter().map(|of| of.name()).collect();
        let values = Outcome::OF_DRIVES.iter().map(|of| of.of(drive));
        numbers.extend(values.map(|value| value.unwrap_or(f64::NAN)));
        self.status = "landed";
        if let Flight::None(why) = &drive.flight {
            self.status = why.status();
            self.message = Some(checked.text(&why.message()));
        }
    }
}

/// The first derivatives of one drive, and the second derivatives by each parameter alone.
struct Derivatives<'a> {
    checked: &'a CheckedSetup<'a>,
    /// The requested parameters; `None` for one without derivatives in this setup.
    parameters: Vec<Option<&'static Parameter>>,
    missing: Vec<Missing>,
}

impl<'a> Derivatives<'a> {
    /// Finds the requested parameters in the setup.
    ///
    /// # Errors
    /// For an unknown name.
    fn new(checked: &'a CheckedSetup<'a>, request: &Request) -> Result<Self, Refusal> {
        let mut derivatives = Self {
            checked,
            parameters: vec![],
            missing: vec![],
        };
        for name in &request.wrt {
            let parameter = match checked.setup.variable(name) {
                Ok(parameter) => Some(parameter),
                Err(error @ Error::NotVariable { .. }) => {
                    derivatives.missing.push(Missing {
                        of: None,
                        wrt: Some(name.clone()),
                        message: checked.refused(&error).message,
                    });
                    None
                }
                Err(error) => return Err(checked.refused(&error)),
            };
            derivatives.parameters.push(parameter);
        }
        Ok(derivatives)
    }

    /// Expands derivatives by the known parameters to the columns of all requested parameters; the
    /// other columns are NaN.
    fn widened(&self, mut known: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
        let columns = self.parameters.iter();
        columns.map(move |parameter| match parameter {
            Some(_) => known.next().unwrap_or(f64::NAN),
            None => f64::NAN,
        })
    }

    /// Appends first, then second derivatives of each outcome, with NaN for derivatives that do not
    /// exist. Returns the reasons for the missing ones.
    fn append(mut self, of: &[Outcome], numbers: &mut Vec<f64>) -> Result<Vec<Missing>, Refusal> {
        if of.is_empty() || self.parameters.is_empty() {
            return Ok(vec![]);
        }
        let mut missing = std::mem::take(&mut self.missing);
        for taylor in self.each(of, &mut missing)? {
            let second = taylor.hessian.iter().enumerate().map(|(k, row)| row[k]);
            numbers.extend(self.widened(taylor.gradient.iter().copied()));
            numbers.extend(self.widened(second));
        }
        Ok(missing)
    }

    /// The derivatives of each outcome; an empty gradient and Hessian if they do not exist. If one
    /// outcome has no value, the other outcomes still have derivatives.
    fn each(&self, of: &[Outcome], missing: &mut Vec<Missing>) -> Result<Vec<Taylor>, Refusal> {
        if self.parameters.iter().all(Option::is_none) {
            return Ok(vec![Taylor::default(); of.len()]);
        }
        match self.evaluated(of) {
            Ok(taylors) => Ok(taylors),
            Err(error) if error.has_valid_input() => {
                Ok(of.iter().map(|of| self.one(*of, missing)).collect())
            }
            Err(error) => Err(self.checked.refused(&error)),
        }
    }

    fn one(&self, of: Outcome, missing: &mut Vec<Missing>) -> Taylor {
        match self.evaluated(&[of]) {
            Ok(mut taylors) => taylors.swap_remove(0),
            Err(error) => {
                missing.push(Missing {
                    of: Some(of.name()),
                    wrt: None,
                    message: self.checked.refused(&error).message,
                });
                Taylor::default()
            }
        }
    }

    fn evaluated(&self, of: &[Outcome]) -> Result<Vec<Taylor>, Error> {
        let wrt: Vec<_> = self.parameters.iter().flatten().copied().collect();
        diagonal(&self.checked.setup, of, &wrt)
    }
}

/// Appends the points of the flight, each with its time, and those of the run. The components of a
/// position are up, right of the target line, downrange, m.
fn append(path: &Trajectory, numbers: &mut Vec<f64>) {
    for point in &path.points {
        numbers.push(point.time);
        numbers.extend(point.position.to_array());
    }
    // the run begins at the landing, the last point of the flight
    if let Some(landing) = path.points.last() {
        let run = path
            .run
            .iter()
            .map(|from_landing| landing.position + *from_landing);
        numbers.extend(run.flat_map(Vector::to_array));
    }
}
