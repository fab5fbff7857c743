use crate::Result;
use crate::command::args::SetupArgs;
use crate::command::interrupt;
use crate::command::names::{outcomes, variables};
use crate::command::output::{Answer, note, system, warn, with_bar};
use crate::report::{CertificateReport, by_reason};
use crate::reproduce::while_loop;
use crate::study::certificate::{Certificate, StepError, certify};
use std::sync::atomic::Ordering;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry,lateral"
    )]
    pub of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a value in this setup.
    #[arg(
        long,
        value_name = "NAME,…",
        value_delimiter = ',',
        default_value = "all"
    )]
    pub wrt: Vec<String>,
}

/// Reports the excluded outcomes, with the reasons.
pub fn note_missing_outcomes(certificate: &Certificate) {
    let missing = certificate
        .missing
        .iter()
        .map(|missing| (missing.of.name(), missing.reason.in_units(system())));
    for line in by_reason(missing) {
        note(&format!("left out: {line}"));
    }
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup_within_tolerance()?;
    let of = outcomes(&args.of)?;
    let wrt = variables(&setup, &args.wrt, &of)?;
    let work = interrupt::enable("stopping after the parameters under way");
    let certificate = with_bar("parameters", |show| {
        certify(&setup, &of, &wrt, &|done, all| {
            show(done, all);
            !work.stop.load(Ordering::Relaxed)
        })
    })?;
    let of_step = certificate
        .step
        .iter()
        .filter_map(StepError::warning)
        .collect();
    warn([setup.drive_warnings(&of), of_step].concat());
    note_missing_outcomes(&certificate);
    // after an interruption, skip the loops
    let loops = if certificate.stopped.is_none() {
        while_loop(&setup, &certificate.rows)
    } else {
        vec![]
    };
    // a Ctrl-C before this line stops the work, and the command still prints its answer
    drop(work);
    let report = CertificateReport::new(&certificate, &loops);
    let answer = Answer::report(&report, &request.origin());
    Ok(answer.found(certificate.passed()))
}
