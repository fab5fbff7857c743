use crate::args::Validate;
use crate::files::Rule;
use crate::output::{Answer, system};
use crate::reproduce::{DOCUMENT, chosen, write};
use longdrive::Result;
use longdrive::report::{validation_csv, validation_document, validation_reply};
use longdrive::study::validation::validation;
use longdrive::units::System;

pub fn run(args: &Validate) -> Result<Answer> {
    let rule = Rule::new([], args.overwrite);
    let folder = args.output.as_ref().map(|folder| rule.folder(folder, &DOCUMENT)).transpose()?;
    let found = validation()?;
    let documents = System::ALL.map(|system| validation_document(&found, system));
    if let Some(folder) = &folder {
        write(folder, &documents, system())?;
    }
    Ok(if args.json {
        Answer::json(&validation_reply(&found))
    } else if args.csv {
        Answer::text(validation_csv(&found)?)
    } else {
        Answer::text(chosen(&documents, system()).text())
    })
}
