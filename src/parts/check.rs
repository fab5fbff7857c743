use super::footer::{Footer, Manifest, hex};
use super::share::{file_name, rows_of};
use crate::batch::SweepDefinition;
use crate::error::{Error, Result};
use crate::external_errors::read_error_text;
use crate::statistics::Summary;
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::Path;

/// Kind of a file's fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum FaultKind {
    /// The file cannot be read completely, or its rows have changed.
    Damaged,
    /// A part of another sweep.
    OtherQuestion,
    /// A part of this or another sweep, computed by another version of longdrive.
    OtherVersion,
    /// A part of this or another sweep, computed on a processor with another instruction set, or
    /// with another C library.
    OtherInstructions,
    /// A second copy of a part.
    Doubled,
    /// A Parquet file that is not a part, or has the name of another part.
    Foreign,
}

/// A fault of a file in the folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Fault {
    /// File name.
    pub file: String,
    /// Kind of the fault.
    pub kind: FaultKind,
    /// Reason, a sentence.
    pub reason: String,
}

/// Result of the check of a folder of parts.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "CheckedParts"))]
pub struct Checked {
    /// The folder.
    pub folder: String,
    /// The definition of the sweep, which each file contains under the key `longdrive`.
    #[serde(rename = "question")]
    pub definition: SweepDefinition,
    /// Number of valid parts.
    pub present: u64,
    /// Numbers of the missing parts, from 1.
    pub missing: Vec<u64>,
    /// Faults of files.
    pub faults: Vec<Fault>,
    /// Temporary files of writers that are running or were killed. The check ignores them.
    pub unfinished: Vec<String>,
    /// Number of rows of the valid parts.
    pub rows: u64,
    /// Size of the valid parts, bytes.
    pub bytes: u64,
    /// SHA-256 of the lines `SHA-256 of the file, two spaces, name of the file` of all parts in
    /// order: the output of `sha256sum part-*.parquet | sha256sum`. `null` if a part is missing, or
    /// if the contents were not read.
    pub sha256: Option<String>,
    /// Statistics of the rows.
    #[serde(flatten)]
    pub summary: Summary,
}

impl Checked {
    /// True if no part is missing, and no file has a fault.
    pub fn is_complete(&self) -> bool {
        self.missing.is_empty() && self.faults.is_empty()
    }

    /// Adds the parts in the order of their numbers. If `contents` is true, reads the rows too; a
    /// part whose rows have changed becomes a fault.
    fn add_parts(
        &mut self,
        folder: &Path,
        mut parts: BTreeMap<u64, (String, Footer)>,
        contents: bool,
    ) {
        let mut hashes = Sha256::default();
        for number in 1..=self.definition.parts {
            let Some((name, footer)) = parts.remove(&number) else {
                self.missing.push(number);
                continue;
            };
            let summary = footer.part.summary.clone();
            let (rows, bytes) = (footer.part.rows, footer.bytes);
            if contents {
                match footer.manifest(&folder.join(&name)) {
                    Ok(Manifest { sha256, .. }) => {
                        hashes.update(format!("{sha256}  {name}\n"));
                    }
                    Err(reason) => {
                        self.missing.push(number);
                        self.faults.push(Fault {
                            file: name,
                            kind: FaultKind::Damaged,
                            reason,
                        });
                        continue;
                    }
                }
            }
            match self.present {
                0 => self.summary = summary,
                _ => self.summary.merge(&summary),
            }
            self.present += 1;
            self.rows += rows;
            self.bytes += bytes;
        }
        if contents && self.missing.is_empty() {
            self.sha256 = Some(hex(hashes));
        }
    }
}

/// Reads the footers of the files in a folder of parts. Reports valid, missing and faulty parts.
///
/// - `wanted` is the definition of the sweep to check. The files determine its number of parts,
///   instruction set and C library. Without `wanted`, the sweep that most files belong to is
///   checked.
/// - With `contents`, the rows are read too, their SHA-256 is compared with the footers, and the
///   SHA-256 of the set is computed.
///
/// # Errors
/// [`Error::Results`] if `folder` cannot be read or has no readable part.
pub fn check(folder: &Path, wanted: Option<&SweepDefinition>, contents: bool) -> Result<Checked> {
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
        let entry = entry.map_err(unreadable)?;
        names.push(entry.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    let unfinished = names
        .iter()
        .filter(|name| name.starts_with(".longdrive-"))
        .cloned()
        .collect();
    let mut faults = vec![];
    let found = footers(folder, names, &mut faults);
    let Some(definition) = definition_of_most(&found, wanted) else {
        let reason = match faults.first() {
            Some(fault) => format!(
                "none of the files in it can be read as a part of a sweep; {}: {}",
                fault.file, fault.reason
            ),
            None => {
                "it has no part of a sweep; name the folder into which `sweep()` wrote parts".into()
            }
        };
        return Err(refuse(reason));
    };
    let parts = valid_parts(&definition, found, &mut faults);
    let mut checked = Checked {
        folder: folder.display().to_string(),
        definition,
        present: 0,
        missing: vec![],
        faults,
        unfinished,
        rows: 0,
        bytes: 0,
        sha256: None,
        summary: Summary::default(),
    };
    checked.add_parts(folder, parts, contents);
    Ok(checked)
}

/// Footers of the Parquet files; files without a readable footer become faults.
fn footers(folder: &Path, names: Vec<String>, faults: &mut Vec<Fault>) -> Vec<(String, Footer)> {
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
    found
}

/// Valid parts of the sweep by number; other files become faults.
fn valid_parts(
    definition: &SweepDefinition,
    found: Vec<(String, Footer)>,
    faults: &mut Vec<Fault>,
) -> BTreeMap<u64, (String, Footer)> {
    let (mut valid, mut misnamed) = (BTreeMap::new(), vec![]);
    let hash = definition.hash();
    for (name, footer) in found {
        let number = footer.part.part;
        if let Some((kind, reason)) = fault(definition, &hash, &footer) {
            faults.push(Fault {
                file: name,
                kind,
                reason,
            });
        } else if name == file_name(number, definition.parts) {
            valid.insert(number, (name, footer));
        } else {
            misnamed.push((number, name));
        }
    }
    let named = |(part, (name, _)): (&u64, &(String, Footer))| (*part, name.clone());
    let mut first_copies: BTreeMap<u64, String> = valid.iter().map(named).collect();
    for (part, file) in misnamed {
        let (kind, reason) = match first_copies.get(&part) {
            Some(first) => (
                FaultKind::Doubled,
                format!("it is a second copy of part {part}; the first is {first}"),
            ),
            None => {
                first_copies.insert(part, file.clone());
                let name = file_name(part, definition.parts);
                let reason = format!("it is part {part}; rename it to {name}");
                (FaultKind::Foreign, reason)
            }
        };
        faults.push(Fault { file, kind, reason });
    }
    valid
}

/// The definition of the sweep that most files belong to, among the files that agree with `wanted`.
/// If no file agrees, the definition is `wanted` with the number of parts, the instruction set and
/// the C library of the first file. `None` without files.
fn definition_of_most(
    found: &[(String, Footer)],
    wanted: Option<&SweepDefinition>,
) -> Option<SweepDefinition> {
    // `wanted`, but with three values of a file: number of parts, instruction set, C library
    let wanted_as = |of: &SweepDefinition| {
        wanted.map(|wanted| SweepDefinition {
            parts: of.parts,
            instructions: of.instructions.clone(),
            functions: of.functions.clone(),
            ..wanted.clone()
        })
    };
    let like_wanted =
        |of: &SweepDefinition| wanted_as(of).is_none_or(|wanted| wanted.difference(of).is_none());
    let mut counts: BTreeMap<String, (usize, &SweepDefinition)> = BTreeMap::new();
    for (_, footer) in found {
        counts
            .entry(footer.part.question.clone())
            .or_insert((0, &footer.definition))
            .0 += 1;
    }
    let most = counts
        .values()
        .filter(|(_, of)| like_wanted(of))
        .max_by_key(|(count, _)| *count);
    let of_none = || wanted_as(&found.first()?.1.definition);
    most.map(|(_, of)| (*of).clone()).or_else(of_none)
}

/// The fault of a file with a readable footer; `None` for a valid part of the sweep `definition`.
fn fault(definition: &SweepDefinition, hash: &str, footer: &Footer) -> Option<(FaultKind, String)> {
    if footer.part.question != hash {
        let theirs = &footer.definition;
        let difference = definition.difference(theirs).unwrap_or_default();
        let kind = match () {
            () if theirs.version != definition.version => FaultKind::OtherVersion,
            () if (&theirs.instructions, &theirs.functions)
                != (&definition.instructions, &definition.functions) =>
            {
                FaultKind::OtherInstructions
            }
            () => FaultKind::OtherQuestion,
        };
        return Some((kind, format!("it belongs to another sweep ({difference})")));
    }
    let part = footer.part.part;
    let expected = rows_of(part, definition.parts, definition.rows).ok();
    let is_off = |rows: std::ops::Range<u64>| {
        rows.start != footer.part.first_row || rows.end - rows.start != footer.part.rows
    };
    expected.is_none_or(is_off).then(|| {
        (
            FaultKind::Damaged,
            format!(
                "its footer names it part {part} of {}, but its rows are not the rows of this part",
                definition.parts
            ),
        )
    })
}

/// Merges the summaries of parts in the order of their numbers. Duplicates of a part count once.
///
/// # Errors
/// [`Error::Together`] if the parts belong to different sweeps.
pub fn merge(manifests: &[Manifest]) -> Result<Summary> {
    let mut by_number: BTreeMap<u64, &Manifest> = BTreeMap::new();
    for manifest in manifests {
        let first = by_number.values().next().unwrap_or(&manifest);
        if first.part.question != manifest.part.question {
            return Err(Error::Together {
                given: format!("the parts {} and {}", first.part.part, manifest.part.part),
                reason: "they belong to different sweeps; merge the parts of one sweep".into(),
            });
        }
        by_number.insert(manifest.part.part, manifest);
    }
    let mut summaries = by_number.values().map(|manifest| &manifest.part.summary);
    let mut all = summaries.next().cloned().unwrap_or_default();
    summaries.for_each(|later| all.merge(later));
    Ok(all)
}
