use crate::args::{Published, Reproduce};
use crate::output::{Answer, tell};
use longdrive::report::plot::{Look, figure_csv, figure_svg};
use longdrive::report::{Document, mae494_document, mae494_reply, winfield_tan_document, winfield_tan_reply};
use longdrive::reproduce::{mae494, winfield_tan};
use longdrive::units::System;
use longdrive::{Error, Result};
use std::fs;
use std::path::Path;

pub fn run(args: &Reproduce) -> Result<Answer> {
    let (document, reply, system) = match args.study {
        Published::Mae494 => {
            let found = mae494(|what| tell(&format!("computing {what}")))?;
            (mae494_document(&found), mae494_reply(&found), System::Metric)
        }
        Published::WinfieldTan => {
            let found = winfield_tan(|what| tell(&format!("computing {what}")))?;
            (winfield_tan_document(&found), winfield_tan_reply(&found), System::Us)
        }
    };
    if let Some(folder) = &args.output {
        write(folder, &document, &Look { system, ..Look::default() })?;
    }
    Ok(if args.json { Answer::json(&reply) } else { Answer::text(document.text()) })
}

/// Writes a document with its figures and their data into a folder, which is made where it is not there.
pub fn write(folder: &Path, document: &Document, look: &Look) -> Result<()> {
    let mut files = vec![
        ("report.md".to_owned(), document.markdown()),
        ("index.html".to_owned(), document.html(&Look { width: 720, ..*look })?),
    ];
    for figure in document.figures() {
        files.push((format!("{}.svg", figure.name), figure_svg(figure, look)?));
        files.push((format!("{}.csv", figure.name), figure_csv(figure)?));
    }
    let failed = |file: &Path, error: std::io::Error| Error::Results {
        file: file.display().to_string(),
        reason: format!("{error}; name a folder that can be written to"),
    };
    fs::create_dir_all(folder).map_err(|error| failed(folder, error))?;
    for (name, text) in &files {
        let file = folder.join(name);
        fs::write(&file, text).map_err(|error| failed(&file, error))?;
    }
    tell(&format!("wrote {} files into {}", files.len(), folder.display()));
    Ok(())
}
