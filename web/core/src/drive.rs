//! One drive: outcomes, derivatives, and the path of the ball.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{CheckedSetup, SetupRequest, Units};
use longdrive::derivative::{Order, Taylor, evaluate};
use longdrive::flight::{Flight, Trajectory, trajectory};
use longdrive::number::Vector;
use longdrive::parameters::Parameter;
use longdrive::{Drive, Outcome};
use serde::{Deserialize, Serialize};

/// The request.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: Units,
    #[serde(default)]
    of: Vec<String>,
    #[serde(default)]
    wrt: Vec<String>,
    #[serde(default)]
    order: u8,
    #[serde(default)]
    path: bool,
}

/// The head of the answer.
#[derive(Serialize)]
struct Head<'a> {
    status: &'static str,
    message: Option<String>,
    outcomes: Vec<&'static str>,
    of: &'a [String],
    wrt: &'a [String],
    order: u8,
    path: usize,
    run: usize,
    missing: Vec<Missing>,
    warnings: Vec<String>,
}

/// An outcome without a value or derivative.
#[derive(Serialize)]
struct Missing {
    of: &'static str,
    message: String,
}

/// The answer.
///
/// # Errors
/// The message of the program, if there is no drive.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let of = checked.outcomes(&request.of)?;
    let wrt = checked.variables(&request.wrt)?;
    let order = order(request)?;
    let setup = &checked.setup;
    let drive = Drive::new(setup).map_err(|error| checked.refused(&error))?;
    let mut warnings = drive.warnings_about(setup, Outcome::ALL);
    warnings.extend(setup.wind_profile_warning());
    let mut numbers: Vec<f64> = Outcome::ALL
        .iter()
        .map(|outcome| outcome.of(&drive).unwrap_or(f64::NAN))
        .collect();
    let missing = differentiate(&checked, &of, &wrt, order, &mut numbers)?;
    let mut head = Head {
        status: "landed",
        message: None,
        outcomes: Outcome::ALL.iter().map(|of| of.name()).collect(),
        of: &request.of,
        wrt: &request.wrt,
        order: request.order,
        path: 0,
        run: 0,
        missing,
        warnings: warnings.iter().map(|text| checked.text(text)).collect(),
    };
    if let Flight::None(why) = &drive.flight {
        head.status = why.status();
        head.message = Some(checked.text(&why.message()));
    }
    if request.path {
        let path = trajectory(setup, &drive.launch).map_err(|error| checked.refused(&error))?;
        (head.path, head.run) = (path.points.len(), path.run.len());
        append(&path, &mut numbers);
    }
    Ok(message::with_numbers(&head, &numbers))
}

fn order(request: &Request) -> Result<Order, Refusal> {
    match request.order {
        0 => Ok(Order::Value),
        1 => Ok(Order::First),
        2 => Ok(Order::Second),
        other => {
            let why = format!("order is {other}; expected 0, 1 or 2");
            Err(Refusal::of_request(&why))
        }
    }
}

/// Appends gradients and Hessians, NaN where they do not exist. Returns the outcomes without them.
fn differentiate(
    checked: &CheckedSetup<'_>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    order: Order,
    numbers: &mut Vec<f64>,
) -> Result<Vec<Missing>, Refusal> {
    if of.is_empty() || wrt.is_empty() || order == Order::Value {
        return Ok(vec![]);
    }
    let evaluated = |of: &[Outcome]| evaluate(&checked.setup, of, wrt, order);
    let refused = |error| checked.refused(&error);
    let each: Vec<_> = match evaluated(of) {
        // an outcome without a value does not prevent the others
        Err(error) if error.is_an_outcome() => of.iter().map(|of| evaluated(&[*of])).collect(),
        all => all
            .map_err(refused)?
            .into_iter()
            .map(|one| Ok(vec![one]))
            .collect(),
    };
    let mut missing = vec![];
    for (of, taylors) in of.iter().zip(each) {
        let taylors = taylors.unwrap_or_else(|error| {
            let message = checked.refused(&error).message;
            missing.push(Missing {
                of: of.name(),
                message,
            });
            vec![undefined(wrt.len())]
        });
        for taylor in taylors {
            numbers.extend(taylor.gradient);
            if order == Order::Second {
                numbers.extend(taylor.hessian.into_iter().flatten());
            }
        }
    }
    Ok(missing)
}

/// Derivatives that do not exist.
fn undefined(parameters: usize) -> Taylor {
    let none = vec![f64::NAN; parameters];
    Taylor {
        value: f64::NAN,
        hessian: vec![none.clone(); parameters],
        gradient: none,
    }
}

/// Appends the path of the flight and of the run.
fn append(path: &Trajectory, numbers: &mut Vec<f64>) {
    for point in &path.points {
        numbers.push(point.time);
        numbers.extend(coordinates(&point.position));
    }
    // the run begins at the landing, the last point of the flight
    if let Some(landing) = path.points.last() {
        let run = path
            .run
            .iter()
            .map(|from_landing| landing.position + *from_landing);
        numbers.extend(run.flat_map(|position| coordinates(&position)));
    }
}

/// Height, right of the target line, downrange.
fn coordinates(position: &Vector<f64>) -> [f64; 3] {
    [position.x, position.y, position.z]
}
