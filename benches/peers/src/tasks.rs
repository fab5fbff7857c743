//! The tasks of a single drive.

use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::integration::accuracy;
use longdrive::optimize::{Observer, Status};
use longdrive::parameters::Parameter;
use longdrive::study::{Optimum, Search, Vary, optimum};
use longdrive::{Error, Outcome, Result, Setup};
use std::hint::black_box;

/// The tasks of a single drive, by name.
pub const SINGLE: [&str; 10] = [
    "T1", "T2", "T3", "T4", "T5", "all", "3-D", "3-D-all", "W&T", "W&T-1um",
];

/// The twelve parameters of T4. In the other peers they are lam, eps, M, m, R, Ib, d, Iyy, e, V,
/// rho, delta.
const TWELVE: [&str; 12] = [
    "club.loft",
    "swing.attack_angle",
    "club.mass",
    "ball.mass",
    "ball.radius",
    "ball.inertia",
    "club.cg_depth",
    "club.inertia.yy",
    "impact.restitution",
    "swing.speed",
    "air.density",
    "aero.spin_decay",
];

/// Method and step of the flight; `None` keeps those of the preset.
#[derive(Clone, Debug, Default)]
pub struct Discretization {
    pub method: Option<String>,
    pub step: Option<String>,
}

impl Discretization {
    pub fn new(method: &str, step: f64) -> Self {
        Self {
            method: Some(method.into()),
            step: Some(format!("{step}")),
        }
    }

    pub fn apply(&self, mut setup: Setup<f64>) -> Result<Setup<f64>> {
        if let Some(method) = &self.method {
            setup.set("flight.method", method)?;
        }
        if let Some(step) = &self.step {
            setup.set("flight.step", &format!("{step} s"))?;
        }
        Ok(setup)
    }
}

/// The drive of the peers: loft 10°, attack angle 0°.
pub fn mae494(by: &Discretization) -> Result<Setup<f64>> {
    by.apply(Setup::preset("mae494")?)
}

/// A drive without mirror symmetry: its path leaves the vertical plane of the target line.
fn in_space(by: &Discretization) -> Result<Setup<f64>> {
    let mut setup = Setup::preset("modern-driver")?;
    setup.set_all([
        ("swing.path", "2 deg"),
        ("strike.toe", "5 mm"),
        ("wind.right", "2 m/s"),
    ])?;
    by.apply(setup)
}

pub fn named(setup: &Setup<f64>, names: &[&str]) -> Result<Vec<&'static Parameter>> {
    setup.variables_named(names)
}

/// Loft and attack angle.
pub fn two(setup: &Setup<f64>) -> Result<Vec<&'static Parameter>> {
    named(setup, &TWELVE[..2])
}

/// Lofts, deg, for which table 1 of Winfield & Tan (1994) gives the best attack angle.
const TABLE_1: [f64; 9] = [5.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 15.0];
/// Attack angles, deg, for which table 2 of Winfield & Tan (1994) gives the best loft.
const TABLE_2: [f64; 13] = [
    -10.0, -5.0, -4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 10.0,
];

/// The task that computes 23 optima: those of the two tables of Winfield & Tan, and the optimum
/// over both angles, searched from 10° of loft and 0° of attack angle. Each search of a table
/// starts from the previous optimum. `within` is a tolerance of carry, m: method and step are
/// chosen for it. Without a tolerance they are those of the preset.
fn winfield_tan(within: Option<f64>) -> Result<Operation> {
    let mut setup = Setup::preset("winfield-tan")?;
    let vary = ["club.loft=2deg..18deg", "swing.attack_angle=-10deg..30deg"];
    let vary = Vary::read_all(&setup, vary)?;
    if let Some(tolerance) = within {
        let found = accuracy(&setup, &vary, &[Outcome::Carry], tolerance)?;
        (setup.method, setup.flight.step) = (found.method, found.step);
    }
    (setup.club.loft, setup.swing.attack_angle) = (10_f64.to_radians(), 0.0);
    let of_both = Search::longest_drive(&setup)?;
    let [of_loft, of_attack_angle] = [0, 1].map(|i| Search {
        vary: vec![vary[i]],
        ..of_both.clone()
    });
    let of_both = Search { vary, ..of_both };
    let converged = |setup: &Setup<f64>, search: &Search| {
        let found = optimum(black_box(setup), search.clone(), Observer::default())?;
        match found.solution.status {
            Status::Converged => Ok(found),
            _ => Err(Error::NotConverged {
                status: found.status(),
                message: found.message(),
            }),
        }
    };
    Ok(Box::new(move || {
        let mut at = setup;
        for loft in TABLE_1 {
            at.club.loft = loft.to_radians();
            at = converged(&at, &of_attack_angle)?.setup;
        }
        at = setup;
        for attack_angle in TABLE_2 {
            at.swing.attack_angle = attack_angle.to_radians();
            at = converged(&at, &of_loft)?.setup;
        }
        converged(&setup, &of_both).map(|best| Answer::Optimum(Box::new(best)))
    }))
}

pub enum Answer {
    Drive(Taylor),
    Optimum(Box<Optimum>),
}

impl Answer {
    /// Value, derivatives and a note. The derivatives of a drive are the gradient and the upper
    /// triangle of the Hessian. An optimum has its position, deg, in their place.
    pub fn parts(self) -> (f64, Vec<f64>, String) {
        match self {
            Self::Drive(taylor) => {
                let rows = taylor.hessian.iter().enumerate();
                let upper = rows.flat_map(|(i, row)| row[i..].iter().copied());
                let derivatives: Vec<f64> = taylor.gradient.iter().copied().chain(upper).collect();
                let parameters = taylor.gradient.len();
                let note = if parameters > 12 {
                    format!("{parameters} parameters")
                } else {
                    String::new()
                };
                (taylor.value, derivatives, note)
            }
            Self::Optimum(best) => {
                let place = best.solution.x.iter().map(|x| x.to_degrees()).collect();
                let note = format!(
                    "{} evaluations, {}",
                    best.solution.effort.evaluations,
                    best.solution.status.name()
                );
                (best.value().unwrap_or(f64::NAN), place, note)
            }
        }
    }
}

/// Computes a task once. The clock calls it repeatedly.
type Operation = Box<dyn Fn() -> Result<Answer>>;

/// The operation of a task of a single drive; `None` for another task. Arguments are checked here,
/// and not at each repetition.
pub fn operation(task: &str, by: &Discretization) -> Result<Option<Operation>> {
    match task {
        "W&T" => return winfield_tan(None).map(Some),
        "W&T-1um" => return winfield_tan(Some(1e-6)).map(Some),
        _ => {}
    }
    let setup = if task.starts_with("3-D") {
        in_space(by)?
    } else {
        mae494(by)?
    };
    let (wrt, order) = match task {
        "T1" | "3-D" => (two(&setup)?, Order::Value),
        "T2" => (two(&setup)?, Order::First),
        "T3" => (two(&setup)?, Order::Second),
        "T4" => (named(&setup, &TWELVE)?, Order::First),
        "all" | "3-D-all" => (setup.variables(), Order::First),
        "T5" => {
            let ranges = ["club.loft=0deg..25deg", "swing.attack_angle=-10deg..10deg"];
            let vary = Vary::read_all(&setup, ranges)?;
            let search = Search {
                vary,
                ..Search::longest_drive(&setup)?
            };
            return Ok(Some(Box::new(move || {
                let best = optimum(black_box(&setup), search.clone(), Observer::default())?;
                Ok(Answer::Optimum(Box::new(best)))
            })));
        }
        _ => return Ok(None),
    };
    let evaluator = Evaluator::new(&setup, &[Outcome::Carry], &wrt, order)?;
    let x: Vec<f64> = wrt
        .iter()
        .map(|parameter| setup.value(parameter).unwrap_or(f64::NAN))
        .collect();
    Ok(Some(Box::new(move || {
        let mut taylors = evaluator.at(black_box(&x))?;
        Ok(Answer::Drive(taylors.swap_remove(0)))
    })))
}
