use super::footer::{Footer, Manifest};
use super::hash::Hash;
use super::question::Question;
use super::share::{file_name, rows_of};
use crate::error::{Error, Result};
use crate::external_errors::read_error_text;
use crate::statistics::Summary;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;

/// What is wrong with a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FaultKind {
    /// It cannot be read to its end, or its rows are not those that were written.
    Damaged,
    /// A part of another sweep.
    OtherQuestion,
    /// The same sweep by another version of longdrive.
    OtherVersion,
    /// The same sweep with other instructions of the processor, or another C library.
    OtherInstructions,
    /// A part that is there under its own name too.
    Doubled,
    /// A Parquet file that is no part, or not under its name.
    Foreign,
}

/// A file of the folder that is not what it should be.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// Its name.
    pub file: String,
    /// In a word.
    pub kind: FaultKind,
    /// In a sentence.
    pub reason: String,
}

/// What a folder of parts holds.
#[derive(Clone, Debug, Serialize)]
pub struct Checked {
    /// The question of its parts.
    pub question: Question,
    /// Parts that are there and sound.
    pub present: u64,
    /// The numbers of those that are not, from 1.
    pub missing: Vec<u64>,
    /// Files that are not what they should be.
    pub faults: Vec<Fault>,
    /// Files of writers that are at work or were killed: they count for nothing.
    pub unfinished: Vec<String>,
    /// Rows of the parts that are there.
    pub rows: u64,
    /// Their bytes.
    pub bytes: u64,
    /// SHA-256 of the lines `SHA-256 of the file, two spaces, name of the file` of all parts in
    /// their order, what `sha256sum part-*.parquet | sha256sum` prints. Only of a complete set
    /// whose contents were read.
    pub sha256: Option<String>,
    /// What the rows are like in all.
    #[serde(flatten)]
    pub summary: Summary,
}

impl Checked {
    /// Whether every part is there, and nothing else that could be taken for one.
    pub fn is_complete(&self) -> bool {
        self.missing.is_empty() && self.faults.is_empty()
    }
}

/// Looks through the footers of a folder of parts: which are there, which are missing, and what
/// else there is. The question is `wanted`, where its number of parts and its instructions are
/// those of the files, or else that of most files. With `contents` the rows are read too, held
/// against the SHA-256 in each footer, and the SHA-256 of the set is found.
///
/// # Errors
/// [`Error::Results`] for a folder that cannot be read, and one without a part that can be.
pub fn check(folder: &Path, wanted: Option<&Question>, contents: bool) -> Result<Checked> {
    let refuse = |reason: String| Error::Results {
        file: folder.display().to_string(),
        reason,
    };
    let unreadable = |error: std::io::Error| {
        refuse(format!(
            "{}; name the folder of the parts",
            read_error_text(&error)
        ))
    };
    let mut names = vec![];
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        names.push(
            entry
                .map_err(unreadable)?
                .file_name()
                .to_string_lossy()
                .into_owned(),
        );
    }
    names.sort();
    let unfinished = names
        .iter()
        .filter(|name| name.starts_with(".longdrive-"))
        .cloned()
        .collect();
    let mut faults = vec![];
    let mut found = vec![];
    for name in names.into_iter().filter(|name| name.ends_with(".parquet")) {
        match Footer::read(&folder.join(&name)) {
            Ok(footer) => found.push((name, footer)),
            Err(reason) => {
                let kind = if name.starts_with("part-") {
                    FaultKind::Damaged
                } else {
                    FaultKind::Foreign
                };
                faults.push(Fault {
                    file: name,
                    kind,
                    reason,
                });
            }
        }
    }
    let Some(question) = question(&found, wanted) else {
        let reason = match faults.first() {
            Some(fault) => format!(
                "no part of a sweep in it can be read; {}: {}",
                fault.file, fault.reason
            ),
            None => {
                "there is no part of a sweep in it; name the folder that sweep `part` wrote into"
                    .into()
            }
        };
        return Err(refuse(reason));
    };
    let (mut sound, mut misnamed) = (BTreeMap::new(), vec![]);
    let hash = question.hash();
    for (name, footer) in found {
        let number = footer.part.part;
        if let Some((kind, reason)) = fault(&question, &hash, &footer) {
            faults.push(Fault {
                file: name,
                kind,
                reason,
            });
        } else if name == file_name(number, question.parts) {
            sound.insert(number, (name, footer));
        } else {
            misnamed.push((number, name));
        }
    }
    for (part, file) in misnamed {
        let name = file_name(part, question.parts);
        faults.push(match sound.contains_key(&part) {
            true => Fault {
                file,
                kind: FaultKind::Doubled,
                reason: format!("it is part {part}, as {name} is too"),
            },
            false => Fault {
                file,
                kind: FaultKind::Foreign,
                reason: format!("it is part {part}; rename it to {name}"),
            },
        });
    }
    let mut merged: Option<Summary> = None;
    let (mut hashes, mut rows, mut bytes) = (Hash::default(), 0, 0);
    let mut present = std::collections::BTreeSet::new();
    for (number, (name, footer)) in sound {
        let (summary, of_rows, of_bytes) =
            (footer.part.summary.clone(), footer.part.rows, footer.bytes);
        if contents {
            match footer.manifest(&folder.join(&name)) {
                Ok(Manifest { sha256, .. }) => hashes.add(format!("{sha256}  {name}\n").as_bytes()),
                Err(reason) => {
                    faults.push(Fault {
                        file: name,
                        kind: FaultKind::Damaged,
                        reason,
                    });
                    continue;
                }
            }
        }
        present.insert(number);
        (rows, bytes) = (rows + of_rows, bytes + of_bytes);
        match &mut merged {
            Some(merged) => merged.merge(&summary),
            None => merged = Some(summary),
        }
    }
    let missing: Vec<u64> = (1..=question.parts)
        .filter(|part| !present.contains(part))
        .collect();
    let is_whole = contents && missing.is_empty();
    Ok(Checked {
        present: present.len() as u64,
        missing,
        faults,
        unfinished,
        rows,
        bytes,
        sha256: is_whole.then(|| hashes.hex()),
        summary: merged.unwrap_or_default(),
        question,
    })
}

/// The question of a set of files.
fn question(found: &[(String, Footer)], wanted: Option<&Question>) -> Option<Question> {
    let like_wanted = |of: &&Question| {
        wanted.is_none_or(|wanted| {
            let wanted = Question {
                parts: of.parts,
                instructions: of.instructions.clone(),
                functions: of.functions.clone(),
                ..wanted.clone()
            };
            wanted.difference(of).is_none()
        })
    };
    let mut counts: BTreeMap<String, (usize, &Question)> = BTreeMap::new();
    for (_, footer) in found {
        counts
            .entry(footer.part.question.clone())
            .or_insert((0, &footer.question))
            .0 += 1;
    }
    let most = counts
        .values()
        .filter(|(_, of)| like_wanted(of))
        .max_by_key(|(count, _)| *count);
    // where no file is of the question, its parts are as many as there are of another
    let of_none = || {
        found
            .first()
            .zip(wanted)
            .map(|((_, other), wanted)| Question {
                parts: other.question.parts,
                instructions: other.question.instructions.clone(),
                functions: other.question.functions.clone(),
                ..wanted.clone()
            })
    };
    most.map(|(_, of)| (*of).clone()).or_else(of_none)
}

/// What is wrong with a file that is a part of some sweep.
fn fault(question: &Question, hash: &str, footer: &Footer) -> Option<(FaultKind, String)> {
    if footer.part.question != hash {
        let theirs = &footer.question;
        let difference = question.difference(theirs).unwrap_or_default();
        let kind = match () {
            () if theirs.version != question.version => FaultKind::OtherVersion,
            () if (&theirs.instructions, &theirs.functions)
                != (&question.instructions, &question.functions) =>
            {
                FaultKind::OtherInstructions
            }
            () => FaultKind::OtherQuestion,
        };
        return Some((kind, format!("it belongs to another sweep ({difference})")));
    }
    let part = footer.part.part;
    let expected = rows_of(part, question.parts, question.rows).ok();
    let is_off = |rows: std::ops::Range<u64>| {
        rows.start != footer.part.first_row || rows.end - rows.start != footer.part.rows
    };
    expected.is_none_or(is_off).then(|| {
        (
            FaultKind::Damaged,
            format!("it has other rows than part {part} of {}", question.parts),
        )
    })
}

/// The summary of all rows of some parts, in the order of their numbers; each counts once, however
/// often it is given.
///
/// # Errors
/// [`Error::Together`] for parts of different questions.
pub fn merge(manifests: &[Manifest]) -> Result<Summary> {
    let mut by_number: BTreeMap<u64, &Manifest> = BTreeMap::new();
    for manifest in manifests {
        let first = by_number.values().next().unwrap_or(&manifest);
        if first.part.question != manifest.part.question {
            return Err(Error::Together {
                given: format!("the parts {} and {}", first.part.part, manifest.part.part),
                reason: "they belong to different sweeps; merge the parts of one".into(),
            });
        }
        by_number.insert(manifest.part.part, manifest);
    }
    let mut all: Option<Summary> = None;
    for manifest in by_number.values() {
        match &mut all {
            Some(all) => all.merge(&manifest.part.summary),
            None => all = Some(manifest.part.summary.clone()),
        }
    }
    Ok(all.unwrap_or_default())
}
