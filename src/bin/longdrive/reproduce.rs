use crate::args::{Published, Reproduce};
use crate::files::{Folder, Rule};
use crate::output::{Answer, stated_system, tell};
use longdrive::Result;
use longdrive::report::plot::{Look, figure_csv, figure_svg};
use longdrive::report::{Document, mae494_document, mae494_reply, winfield_tan_document, winfield_tan_reply};
use longdrive::reproduce::{Mae494, WinfieldTan, mae494, winfield_tan};
use longdrive::units::counted;

/// Files that every document has.
pub const DOCUMENT: [&str; 2] = ["report.md", "index.html"];

pub fn run(args: &Reproduce) -> Result<Answer> {
    let rule = Rule::new([], args.overwrite);
    let folder = args.output.as_ref().map(|folder| rule.folder(folder, &DOCUMENT)).transpose()?;
    let (document, reply, system) = match args.study {
        Published::Mae494 => {
            let found = mae494(|what| tell(&format!("computing {what}")))?;
            let system = stated_system().unwrap_or(Mae494::UNITS);
            (mae494_document(&found, system), mae494_reply(&found), system)
        }
        Published::WinfieldTan => {
            let found = winfield_tan(|what| tell(&format!("computing {what}")))?;
            let system = stated_system().unwrap_or(WinfieldTan::UNITS);
            (winfield_tan_document(&found, system), winfield_tan_reply(&found), system)
        }
    };
    if let Some(folder) = &folder {
        write(folder, &document, &Look { system, ..Look::default() })?;
    }
    Ok(if args.json { Answer::json(&reply) } else { Answer::text(document.text()) })
}

/// Writes a document with its figures and their data into a folder.
pub fn write(folder: &Folder, document: &Document, look: &Look) -> Result<()> {
    let [markdown, page] = DOCUMENT.map(str::to_owned);
    let mut files = vec![(markdown, document.markdown()), (page, document.html(&Look { width: 720, ..*look })?)];
    for figure in document.figures() {
        files.push((format!("{}.svg", figure.name), figure_svg(figure, look)?));
        files.push((format!("{}.csv", figure.name), figure_csv(figure)?));
    }
    let count = folder.write(files.iter().map(|(name, text)| (name.as_str(), text.as_bytes())))?;
    tell(&format!("wrote {} into {}", counted(count as u64, "file"), folder.path().display()));
    Ok(())
}
