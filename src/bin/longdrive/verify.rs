use crate::args::Verify;
use crate::names::{outcomes, variables};
use crate::output::{Answer, bar, show, tell, warn};
use longdrive::Result;
use longdrive::report::{CertificateReport, certificate_text};
use longdrive::reproduce::while_loop;
use longdrive::study::certificate::certify;

pub fn run(args: &Verify) -> Result<Answer> {
    let setup = args.question.within_tolerance(args.question.setup()?, &[])?;
    let of = outcomes(&args.of)?;
    let wrt = variables(&setup, &args.wrt)?;
    let bar = bar("parameters");
    let certificate = certify(&setup, &of, &wrt, |done, all| show(&bar, done, all));
    bar.finish_and_clear();
    let certificate = certificate?;
    let warnings = [setup.warnings(), certificate.corners.clone()].concat();
    warn(&warnings);
    for (of, why) in &certificate.missing {
        tell(&format!("left out: {}: {why}", of.name()));
    }
    let loops = while_loop(&setup, &certificate.rows);
    let answer = if args.question.json {
        Answer::json(&CertificateReport::reply(&certificate, &loops, warnings))
    } else {
        Answer::text(certificate_text(&certificate, &loops))
    };
    Ok(answer.found(certificate.passed()))
}
