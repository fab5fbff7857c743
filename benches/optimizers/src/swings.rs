//! The design of a head for swings that vary: eight variables, in units of their ranges, over scenarios integrated to a micrometre. One
//! objective for longdrive's optimizer and for SciPy's.

use longdrive::optimize::{Domain, Evaluation, Options, Problem, minimize};
use longdrive::study::swings::{Correlation, Goal, Rule, Scenarios, Swings, SwingsSearch, swings_problem};
use longdrive::study::uncertainty::Uncertain;
use longdrive::study::{Sense, Vary, accuracy};
use longdrive::{Outcome, Setup};
use serde::Deserialize;
use serde_json::json;
use std::cell::Cell;
use std::error::Error;
use std::io::{BufRead, Write};
use std::time::{Duration, Instant};

const DISTRIBUTIONS: [&str; 6] = [
    "swing.speed=normal(107mph,3mph)",
    "swing.attack_angle=truncated(-1deg,2deg,-6deg,6deg)",
    "swing.path=normal(0deg,2deg)",
    "swing.face_angle=normal(0deg,2deg)",
    "strike.high=normal(0mm,6mm)",
    "strike.toe=normal(0mm,8mm)",
];
const RANGES: [&str; 8] = [
    "club.loft=6deg..16deg",
    "club.bulge_radius=200mm..600mm",
    "club.roll_radius=200mm..600mm",
    "club.cg_depth=25mm..45mm",
    "club.inertia.xx=4500g cm^2..5700g cm^2",
    "club.inertia.yy=3000g cm^2..4200g cm^2",
    "club.inertia.zz=2000g cm^2..3000g cm^2",
    "club.mass=190g..210g",
];
const GOAL: &str = "mean(carry) - 0.5*std(lateral)";
const TOLERANCE: f64 = 1e-6;

/// The problem over the unit box.
struct Scaled<P> {
    problem: P,
    low: Vec<f64>,
    width: Vec<f64>,
    /// Points evaluated, and the time that it took.
    spent: Cell<(u64, Duration)>,
}

impl<P: Problem> Problem for Scaled<P> {
    fn evaluate(&self, u: &[f64]) -> Result<Evaluation, String> {
        let started = Instant::now();
        let x: Vec<f64> = u.iter().zip(&self.low).zip(&self.width).map(|((u, low), width)| low + u * width).collect();
        let mut at = self.problem.evaluate(&x)?;
        for (i, width) in self.width.iter().enumerate() {
            at.objective.gradient[i] *= width;
            at.objective.hessian[i].iter_mut().zip(&self.width).for_each(|(bend, other)| *bend *= width * other);
        }
        let (points, time) = self.spent.get();
        self.spent.set((points + 1, time + started.elapsed()));
        Ok(at)
    }
}

fn problem(scenarios: usize) -> Result<(Scaled<impl Problem>, Vec<f64>), Box<dyn Error>> {
    let setup = Setup::preset("tour-average")?;
    let vary: Vec<Vary> = RANGES.iter().map(|text| Vary::read(&setup, text)).collect::<Result<_, _>>()?;
    let setup = accuracy(&setup, &vary, &[Outcome::Carry, Outcome::Lateral], TOLERANCE)?.applied_to(&setup);
    let inputs = DISTRIBUTIONS.iter().map(|text| Uncertain::read(&setup, text)).collect::<Result<_, _>>()?;
    let correlation = Correlation::read(&setup, "swing.path,swing.face_angle=0.6")?;
    let swings = Swings::distributed(inputs, &[correlation])?;
    let scenarios = Scenarios::new(&swings, Rule::of(&swings, Some(scenarios), 0)?)?;
    let search = SwingsSearch {
        of: Goal::read(GOAL, None)?,
        sense: Sense::Maximize,
        vary,
        subject_to: vec![],
        options: Options::default(),
    };
    let (problem, Domain { variables, .. }, start) = swings_problem(&setup, &search, scenarios)?;
    let width: Vec<f64> = variables.low.iter().zip(&variables.high).map(|(low, high)| high - low).collect();
    let start = start.iter().zip(&variables.low).zip(&width).map(|((x, low), width)| (x - low) / width).collect();
    Ok((Scaled { problem, low: variables.low, width, spent: Cell::default() }, start))
}

/// Prints where longdrive's optimizer ends, as a line of JSON.
pub fn solve(scenarios: &str) -> Result<(), Box<dyn Error>> {
    let (problem, start) = problem(scenarios.parse()?)?;
    let n = start.len();
    let started = Instant::now();
    let found = minimize(&problem, &Domain::new(vec![0.0; n], vec![1.0; n])?, &start, &Options::default())?;
    let seconds = started.elapsed();
    let (evaluations, spent) = problem.spent.get();
    let own = (seconds - spent).as_secs_f64();
    println!(
        "{}",
        json!({
            "x": found.x, "iterations": found.iterations, "evaluations": evaluations,
            "seconds": seconds.as_secs_f64(), "own": own,
        })
    );
    Ok(())
}

#[derive(Deserialize)]
struct Request {
    #[serde(default)]
    x: Vec<f64>,
}

/// Evaluates the problem for a solver in another process, as `serve` does.
pub fn serve(scenarios: &str) -> Result<(), Box<dyn Error>> {
    let (problem, start) = problem(scenarios.parse()?)?;
    let n = start.len();
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let request: Request = serde_json::from_str(&line?)?;
        let answer = if request.x.is_empty() {
            json!([{
                "name": "swings", "start": start, "low": vec![0.0; n], "high": vec![1.0; n],
                "least": [], "most": [],
            }])
        } else {
            let f = problem.evaluate(&request.x)?.objective;
            json!({ "f": { "value": f.value, "gradient": f.gradient, "hessian": f.hessian }, "c": [] })
        };
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}
