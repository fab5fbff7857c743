use crate::Result;
use crate::command::args::{Published, Reproduce};
use crate::command::files::{Folder, Rule};
use crate::command::output::{Answer, stated_system, tell};
use crate::report::{
    Document, document_files, mae494_document, mae494_reply, winfield_tan_document,
    winfield_tan_reply,
};
use crate::reproduce::{Mae494, WinfieldTan, mae494, winfield_tan};
use crate::units::{System, counted};

/// Files that every document has.
pub const DOCUMENT: [&str; 2] = ["report.md", "index.html"];

pub fn run(args: &Reproduce) -> Result<Answer> {
    let rule = Rule::new([], args.overwrite);
    let folder = args
        .output
        .as_ref()
        .map(|folder| rule.folder(folder, &DOCUMENT))
        .transpose()?;
    let (documents, reply, system) = match args.study {
        Published::Mae494 => {
            let found = mae494(|what| tell(&format!("computing {what}")))?;
            let documents = System::ALL.map(|system| mae494_document(&found, system));
            (
                documents,
                mae494_reply(&found),
                stated_system().unwrap_or(Mae494::UNITS),
            )
        }
        Published::WinfieldTan => {
            let found = winfield_tan(|what| tell(&format!("computing {what}")))?;
            let documents = System::ALL.map(|system| winfield_tan_document(&found, system));
            (
                documents,
                winfield_tan_reply(&found),
                stated_system().unwrap_or(WinfieldTan::UNITS),
            )
        }
    };
    if let Some(folder) = &folder {
        write(folder, &documents, system)?;
    }
    Ok(if args.json {
        Answer::json(&reply)
    } else {
        Answer::text(chosen(&documents, system).text())
    })
}

/// The document in a system, of the two in [`System::ALL`].
pub fn chosen(documents: &[Document; 2], system: System) -> &Document {
    &documents[usize::from(system == System::ALL[1])]
}

/// Writes a document, that is there in both systems, with its figures and their data into a folder.
pub fn write(folder: &Folder, documents: &[Document; 2], system: System) -> Result<()> {
    let mut files = document_files(documents, system)?;
    files.push((
        DOCUMENT[0].into(),
        chosen(documents, system).markdown(system),
    ));
    let count = folder.write(
        files
            .iter()
            .map(|(name, text)| (name.as_str(), text.as_bytes())),
    )?;
    tell(&format!(
        "wrote {} into {}",
        counted(count as u64, "file"),
        folder.path().display()
    ));
    Ok(())
}
