//! Evaluates problems for a solver in another process. One request a line: `{}` returns all
//! problems; `{"problem": "HS71", "x": [1, 5, 5, 1]}` returns f, c and their derivatives at x. A
//! number that is not finite is null: a missing limit or bound, or an undefined value.

use crate::all;
use crate::oracle::{evaluate, start};
use crate::problems::Case;
use longdrive::number::Taylor;
use serde::Deserialize;
use serde_json::{Value, json};
use std::error::Error;
use std::io::{BufRead, Write};

#[derive(Deserialize)]
struct Request {
    problem: Option<String>,
    #[serde(default)]
    x: Vec<f64>,
}

pub fn serve() -> Result<(), Box<dyn Error>> {
    let cases = all();
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let request: Request = serde_json::from_str(&line?)?;
        let answer = match request.problem {
            None => cases.iter().map(describe).collect(),
            Some(name) => {
                let case = cases
                    .iter()
                    .find(|case| case.name == name)
                    .ok_or("no such problem")?;
                let at = evaluate(case, &request.x);
                json!({
                    "f": derivatives(&at.objective),
                    "c": at.constraints.iter().map(derivatives).collect::<Value>(),
                })
            }
        };
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}

fn describe(case: &Case) -> Value {
    json!({
        "name": case.name, "start": start(case), "low": case.low, "high": case.high,
        "least": case.least, "most": case.most,
    })
}

fn derivatives(function: &Taylor) -> Value {
    json!({ "value": function.value, "gradient": function.gradient, "hessian": function.hessian })
}
