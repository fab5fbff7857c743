use crate::args::Gradient;
use crate::output::{Answer, tell, warn};
use indicatif::{ProgressBar, ProgressStyle};
use longdrive::derivative::{Order, evaluate_with};
use longdrive::parameters::Parameter;
use longdrive::report::{GradientReport, gradient_text};
use longdrive::{Drive, Outcome, Result, Setup};
use serde::Serialize;

pub fn run(args: &Gradient) -> Result<Answer> {
    let setup = args.question.setup()?;
    let of = outcomes(&args.of)?;
    let wrt = parameters(&setup, &args.wrt)?;
    let drive = Drive::new(&setup)?;
    let warnings = [setup.warnings(), drive.corners(&setup)].concat();
    warn(&warnings);

    let order = if args.hessian { Order::Second } else { Order::First };
    let bar = bar();
    let evaluated = evaluate_with(&setup, &of, &wrt, order, |done, passes| {
        bar.set_length(passes as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    let taylors = match evaluated {
        Err(error) if error.is_an_outcome() && args.question.json => {
            tell(&format!("error: {error}"));
            let none = of.iter().map(|of| GradientReport::none(*of, &error, warnings.clone())).collect();
            return Ok(Answer::json(&Rows::of(none)).found(false));
        }
        evaluated => evaluated?,
    };

    let results = of.iter().zip(&taylors);
    if !args.question.json {
        let texts: Vec<_> = results.map(|(of, taylor)| gradient_text(*of, &wrt, taylor)).collect();
        return Ok(Answer::text(texts.join("\n")));
    }
    let reports = results.map(|(of, taylor)| GradientReport::new(*of, &wrt, taylor, warnings.clone())).collect();
    Ok(Answer::json(&Rows::of(reports)))
}

/// One outcome is the answer itself, several are rows of a Jacobian.
#[derive(Serialize)]
#[serde(untagged)]
enum Rows {
    One(Box<GradientReport>),
    Several { jacobian: Vec<GradientReport> },
}

impl Rows {
    fn of(mut reports: Vec<GradientReport>) -> Self {
        match reports.pop() {
            Some(only) if reports.is_empty() => Self::One(Box::new(only)),
            last => Self::Several { jacobian: reports.into_iter().chain(last).collect() },
        }
    }
}

/// The outcomes named, each once: naming one twice asks for the same numbers twice.
fn outcomes(names: &[String]) -> Result<Vec<Outcome>> {
    let mut of = Vec::new();
    for name in names {
        let outcome = Outcome::named(name.trim())?;
        if !of.contains(&outcome) {
            of.push(outcome);
        }
    }
    Ok(of)
}

fn parameters(setup: &Setup<f64>, names: &[String]) -> Result<Vec<&'static Parameter>> {
    if names.iter().any(|name| name.trim() == "all") {
        for name in names.iter().filter(|name| name.trim() != "all") {
            setup.variable(name.trim())?;
        }
        let variables = setup.variables();
        let left_out = setup.parameters().into_iter().filter(|row| !variables.contains(row));
        let left_out: Vec<_> = left_out.map(|row| row.name).collect();
        tell(&format!("without a number to differentiate by here, left out: {}", left_out.join(", ")));
        return Ok(variables);
    }
    let mut rows: Vec<&'static Parameter> = Vec::new();
    for name in names.iter().filter(|name| !name.trim().is_empty()) {
        let row = setup.variable(name.trim())?;
        // naming one twice asks for the same number twice
        if !rows.contains(&row) {
            rows.push(row);
        }
    }
    Ok(rows)
}

/// Progress of a long Hessian, on standard error; nothing where that is no terminal.
fn bar() -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} passes, {eta} left");
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
