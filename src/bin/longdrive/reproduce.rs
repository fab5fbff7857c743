use crate::args::{Published, Reproduce};
use crate::output::{Answer, tell};
use longdrive::report::{Document, mae494_document, mae494_json};
use longdrive::reproduce::mae494;
use longdrive::{Error, Result};
use std::fs;
use std::path::Path;

pub fn run(args: &Reproduce) -> Result<Answer> {
    let (document, json) = match args.study {
        Published::Mae494 => {
            let found = mae494(|what| tell(&format!("computing {what}")))?;
            (mae494_document(&found), mae494_json(&found))
        }
    };
    if let Some(folder) = &args.output {
        write(folder, &document)?;
    }
    Ok(if args.json { Answer::json(&json) } else { Answer::text(document.text()) })
}

/// Writes a document's files into a folder, which is made where it is not there.
fn write(folder: &Path, document: &Document) -> Result<()> {
    let failed = |file: &Path, error: std::io::Error| Error::Results {
        file: file.display().to_string(),
        reason: format!("{error}; name a folder that can be written to"),
    };
    fs::create_dir_all(folder).map_err(|error| failed(folder, error))?;
    for (name, text) in [("index.md", document.markdown())] {
        let file = folder.join(name);
        fs::write(&file, text).map_err(|error| failed(&file, error))?;
        tell(&format!("wrote {}", file.display()));
    }
    Ok(())
}
