//! Output files. One rule holds for every file that the program writes:
//!
//! - An existing file is replaced only with `--overwrite`.
//! - An output is never an input of the same command.
//! - A file is written under a temporary name in the same folder, and renamed once it is complete.
//!
//! The program checks the rule before the work begins, and again when it writes the file.

use crate::atomic_file::{create_beside, folder_of, persist};
use crate::command::interrupt;
use crate::command::running::running;
use crate::external_errors::write_error_text;
use crate::input_file::is_in_memory;
use crate::units::Message;
use crate::{Error, Result};
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Files that the outputs of a command must not replace, and the permission to replace other files.
#[derive(Clone, Debug, Default)]
pub struct OutputRule {
    inputs: Vec<PathBuf>,
    overwrite: bool,
}

impl OutputRule {
    /// The rule for a command. `inputs` are the files that the command reads. A file in which the
    /// command stores its progress counts as an input.
    pub fn new(inputs: impl IntoIterator<Item = PathBuf>, overwrite: bool) -> Self {
        Self {
            inputs: inputs
                .into_iter()
                .filter(|path| !is_in_memory(path))
                .filter_map(|path| canonical(&path))
                .collect(),
            overwrite,
        }
    }

    /// Adds another output of the command to the files that must not be replaced.
    #[must_use]
    pub fn and_not(mut self, output: Option<&Path>) -> Self {
        self.inputs.extend(output.and_then(canonical));
        self
    }

    /// The destination of a file, if the rule allows it.
    ///
    /// # Errors
    /// [`Error::Results`] if `path` is a folder or an input, if the file exists and must not be
    /// replaced, or if it cannot be written.
    pub fn file(&self, path: &Path) -> Result<Destination> {
        if running().host.keeps(path) {
            return Ok(Destination {
                shown: path.into(),
                path: path.into(),
                kind: DestinationKind::Memory,
                may_replace: true,
            });
        }
        refuse_standard_output(path, "file, as in `output mine.toml`")?;
        let destination = self.place(path)?;
        if destination.kind == DestinationKind::File {
            // before the work, report a path that cannot be written
            create_beside(&destination.path).map_err(|error| unwritable(path, &error))?;
        }
        Ok(destination)
    }

    /// The destination of a setup file, which is TOML; `None` without a path. The extension must
    /// not belong to another format.
    ///
    /// # Errors
    /// The errors of [`file`](Self::file), and [`Error::Results`] if the extension belongs to
    /// another format.
    pub fn setup_file(&self, path: Option<&Path>) -> Result<Option<Destination>> {
        let Some(path) = path else { return Ok(None) };
        let destination = self.file(path)?;
        match known_extension(path).filter(|ending| ending != "toml") {
            Some(ending) => {
                let reason = format!(
                    "a setup file is written in TOML, and .{ending} is the extension of another \
                     format; use .toml"
                );
                Err(refused(path, &reason))
            }
            None => Ok(Some(destination)),
        }
    }

    /// The destination of a file, if the rule allows it. Does not check whether the folder can be
    /// written.
    ///
    /// # Errors
    /// The errors of [`file`](Self::file).
    pub fn place(&self, path: &Path) -> Result<Destination> {
        let found = match fs::metadata(path) {
            Ok(found) => Some(found),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(unwritable(path, &error)),
        };
        if found.is_none() && path.is_symlink() {
            return Err(refused(
                path,
                "it is a link to a file that does not exist; name that file itself",
            ));
        }
        let Some(found) = found else {
            in_a_folder(path)?;
            self.refuse_input(path, &canonical(path).unwrap_or_else(|| path.into()))?;
            return Ok(Destination {
                shown: path.into(),
                path: path.into(),
                kind: DestinationKind::File,
                may_replace: self.overwrite,
            });
        };
        if found.is_dir() {
            return Err(refused(path, "it is a folder; name a file"));
        }
        // resolve links: compare and replace the file itself, not a link to it
        let at = fs::canonicalize(path).map_err(|error| match found.is_file() {
            true => unwritable(path, &error),
            false => refused(
                path,
                "it cannot be written, because it is a pipe without a name; name a file",
            ),
        })?;
        self.refuse_input(path, &at)?;
        if found.is_file() && !self.overwrite {
            return Err(exists(path));
        }
        Ok(Destination {
            shown: path.into(),
            path: match path.is_symlink() {
                true => at,
                false => path.into(),
            },
            kind: match found.is_file() {
                true => DestinationKind::File,
                false => DestinationKind::Device,
            },
            may_replace: self.overwrite,
        })
    }

    fn refuse_input(&self, path: &Path, at: &Path) -> Result<()> {
        // a folder among the inputs protects all files in it
        if self
            .inputs
            .iter()
            .any(|input| at == input || input.is_dir() && at.starts_with(input))
        {
            return Err(refused(
                path,
                "it is also an input or another output of this command; name another file",
            ));
        }
        Ok(())
    }

    /// The folder for several output files. `names` are the file names that are known in advance. A
    /// missing folder is created when its files are written. A missing parent is an error, because
    /// the path is probably misspelt.
    ///
    /// # Errors
    /// [`Error::Results`] if `path` is a file, if the folder cannot be created or written, or if
    /// the rule protects one of the files `names` in it.
    pub fn folder(&self, path: &Path, names: &[&str]) -> Result<Folder> {
        refuse_standard_output(path, "folder")?;
        let folder = Folder {
            path: path.into(),
            rule: self.clone(),
        };
        if running().host.keeps(path) {
            return Ok(folder);
        }
        if fs::metadata(path).is_ok_and(|found| !found.is_dir()) {
            return Err(refused(
                path,
                "it cannot be written to: it is a file; name a folder",
            ));
        }
        let is_new = !path.exists();
        if !path.is_dir() {
            in_a_folder(path)?;
            if let Some(ending) = known_extension(path) {
                let reason = format!(
                    "a folder is needed, and .{ending} is the extension of a file; name a folder"
                );
                return Err(refused(path, &reason));
            }
            fs::create_dir(path).map_err(|error| unwritable(path, &error))?;
        }
        for name in names {
            self.place(&path.join(name))?;
        }
        create_beside(&path.join("file")).map_err(|error| unwritable(path, &error))?;
        if is_new {
            // delete the folder, which was created only for this check: a command without an answer
            // must leave no folder
            fs::remove_dir(path).map_err(|error| unwritable(path, &error))?;
        }
        Ok(folder)
    }
}

/// Extensions of tables, lower case.
const TABLE_EXTENSIONS: [&str; 7] = [
    "arrow", "arrows", "csv", "feather", "jsonl", "ndjson", "parquet",
];

/// The extension of a file name in lower case, if it is that of a known file format.
fn known_extension(path: &Path) -> Option<String> {
    let extension = ending(path);
    let others = ["html", "json", "md", "pdf", "png", "svg", "toml", "txt"];
    let is_known = is_table(path) || others.contains(&extension.as_str());
    is_known.then_some(extension)
}

/// True if the extension of a file name belongs to a table.
pub fn is_table(path: &Path) -> bool {
    TABLE_EXTENSIONS.contains(&ending(path).as_str())
}

/// The extension of a file name in lower case; empty without one.
pub fn ending(path: &Path) -> String {
    let ending = path.extension().unwrap_or_default();
    ending.to_string_lossy().to_lowercase()
}

/// A path to which the rule allows the program to write.
#[derive(Clone, Debug)]
pub struct Destination {
    /// The name as typed, for messages.
    pub shown: PathBuf,
    /// The path of the file itself. If the typed path is a link, this is the target of the link.
    path: PathBuf,
    pub kind: DestinationKind,
    /// True if an existing file may be replaced. If false, a file that another program creates
    /// after the check is kept too.
    may_replace: bool,
}

/// The kind of a destination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DestinationKind {
    /// A file on disk, new or existing.
    File,
    /// A device or a pipe.
    Device,
    /// A file that the caller of the command keeps in memory.
    Memory,
    StandardOutput,
    /// A destination that discards its content.
    Nowhere,
}

impl Destination {
    /// A destination that is no file: standard output, or a destination that discards its content.
    pub fn without_file(kind: DestinationKind) -> Self {
        Self {
            shown: "-".into(),
            path: "-".into(),
            kind,
            may_replace: false,
        }
    }

    /// The warning that the file is not written, with the reason.
    pub fn not_written(&self, why: &str) -> Message {
        format!("{} is not written: {why}", self.shown.display()).into()
    }

    /// The path of a file on disk itself, not of a link to it; `None` for other kinds.
    pub fn file(&self) -> Option<&Path> {
        (self.kind == DestinationKind::File).then_some(&self.path)
    }

    /// The name of a file on disk or of a device, for messages; `None` for other kinds.
    pub fn shown_on_disk(&self) -> Option<&Path> {
        let is_on_disk = matches!(self.kind, DestinationKind::File | DestinationKind::Device);
        is_on_disk.then_some(&self.shown)
    }

    /// Writes the complete file.
    ///
    /// # Errors
    /// [`Error::Results`] if the file cannot be written. An existing file is then unchanged.
    pub fn write(&self, bytes: &[u8]) -> Result<()> {
        let write = || self.stage(bytes)?.put_in_place();
        // do not hold back Ctrl-C here: a write to a pipe without a reader may block forever
        if self.kind != DestinationKind::File {
            return write();
        }
        interrupt::undisturbed(&self.shown, write)
    }

    /// Opens the output, to write it in pieces. A file on disk has a temporary name until it is
    /// complete.
    ///
    /// # Errors
    /// [`Error::Results`] if the file cannot be written.
    pub fn begin(&self) -> Result<OutputStream> {
        let sink = match self.kind {
            DestinationKind::File => create_beside(&self.path).map(Sink::Beside),
            DestinationKind::Device => fs::OpenOptions::new()
                .write(true)
                .open(&self.path)
                .map(Sink::Device),
            DestinationKind::Memory => Ok(Sink::Memory(vec![])),
            DestinationKind::StandardOutput => Ok(Sink::StandardOutput),
            DestinationKind::Nowhere => Ok(Sink::Nowhere),
        };
        Ok(OutputStream {
            sink: sink.map_err(|error| unwritable(&self.shown, &error))?,
            destination: self.clone(),
        })
    }

    /// Writes the complete file under a temporary name.
    fn stage(&self, bytes: &[u8]) -> Result<OutputStream> {
        let mut file = self.begin()?;
        file.write(bytes)?;
        Ok(file)
    }
}

/// An output that is written piece by piece.
pub struct OutputStream {
    sink: Sink,
    destination: Destination,
}

/// Receives the pieces of an output.
enum Sink {
    /// A temporary file in the same folder. It is deleted unless it is renamed.
    Beside(NamedTempFile),
    Device(fs::File),
    Memory(Vec<u8>),
    StandardOutput,
    Nowhere,
}

impl OutputStream {
    /// Writes the next piece.
    ///
    /// # Errors
    /// If the piece cannot be written: [`Error::Output`] for standard output, [`Error::Results`]
    /// for a file.
    pub fn write(&mut self, bytes: &[u8]) -> Result<()> {
        self.try_write(bytes).map_err(|error| match self.sink {
            Sink::StandardOutput => Error::Output(error),
            _ => unwritable(&self.destination.shown, &error),
        })
    }

    /// Writes the next piece, and returns an error of the system unchanged.
    ///
    /// # Errors
    /// If the piece cannot be written.
    pub fn try_write(&mut self, bytes: &[u8]) -> io::Result<()> {
        match &mut self.sink {
            Sink::Beside(file) => file.write_all(bytes),
            Sink::Device(file) => file.write_all(bytes),
            Sink::Memory(content) => content.write_all(bytes),
            Sink::StandardOutput => running().host.write(bytes),
            Sink::Nowhere => Ok(()),
        }
    }

    /// Moves the complete file to its path. Ctrl-C does not interrupt the move.
    ///
    /// # Errors
    /// [`Error::Results`] if the file cannot be moved. An existing file is then unchanged.
    pub fn finish(self) -> Result<()> {
        if self.destination.kind != DestinationKind::File {
            return self.put_in_place();
        }
        let shown = self.destination.shown.clone();
        interrupt::undisturbed(&shown, || self.put_in_place())
    }

    fn put_in_place(self) -> Result<()> {
        let Destination {
            shown,
            path,
            may_replace,
            ..
        } = self.destination;
        let rename = |file: NamedTempFile| -> io::Result<()> {
            file.as_file().sync_all()?;
            Ok(persist(file.into_temp_path(), &path, may_replace)?)
        };
        match self.sink {
            Sink::Device(_) | Sink::StandardOutput | Sink::Nowhere => Ok(()),
            Sink::Memory(content) => {
                running().host.keep(&shown, content);
                Ok(())
            }
            Sink::Beside(file) => rename(file).map_err(|error| match error.kind() {
                ErrorKind::AlreadyExists => refused(
                    &shown,
                    "it was made by another program while this command ran; use `overwrite` to \
                     replace it",
                ),
                _ => unwritable(&shown, &error),
            }),
        }
    }
}

/// A folder for output files, which follow the rule.
#[derive(Clone, Debug)]
pub struct Folder {
    pub path: PathBuf,
    rule: OutputRule,
}

impl Folder {
    /// Writes files, and returns their number. All destinations are checked before the first file
    /// is written. After an error, a folder that was created for the files is deleted if it is
    /// empty.
    ///
    /// # Errors
    /// The errors of [`OutputRule::file`] and [`Destination::write`].
    pub fn write<'a>(&self, files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> Result<usize> {
        let host = &running().host;
        if host.keeps(&self.path) {
            let keep = |(name, bytes): (&str, &[u8])| {
                host.keep(&self.path.join(name), bytes.to_vec());
            };
            return Ok(files.into_iter().map(keep).count());
        }
        let ancestors = self.path.ancestors();
        let created: Vec<_> = ancestors.take_while(|folder| !folder.exists()).collect();
        let written = self.write_files(files);
        if written.is_err() {
            for folder in created {
                // a folder with files stays
                let _ = fs::remove_dir(folder);
            }
        }
        written
    }

    fn write_files<'a>(
        &self,
        files: impl IntoIterator<Item = (&'a str, &'a [u8])>,
    ) -> Result<usize> {
        fs::create_dir_all(&self.path).map_err(|error| unwritable(&self.path, &error))?;
        let place = |(name, bytes)| Ok((self.rule.place(&self.path.join(name))?, bytes));
        let files = files.into_iter().map(place).collect::<Result<Vec<_>>>()?;
        interrupt::undisturbed(&self.path, || {
            // write all files before the first is renamed, so that a full disk replaces no file
            let staged = files
                .iter()
                .map(|(destination, bytes)| destination.stage(bytes))
                .collect::<Result<Vec<_>>>()?;
            staged
                .into_iter()
                .try_for_each(OutputStream::put_in_place)?;
            Ok(files.len())
        })
    }
}

/// Refuses "-", which stands for standard output. `what` is the needed output: a file or a folder.
fn refuse_standard_output(path: &Path, what: &str) -> Result<()> {
    match path == Path::new("-") {
        true => Err(refused(
            path,
            format!("this command does not write to standard output; name a {what}"),
        )),
        false => Ok(()),
    }
}

/// Refuses a path whose folder does not exist.
fn in_a_folder(path: &Path) -> Result<()> {
    let folder = folder_of(path);
    match folder.is_dir() {
        true => Ok(()),
        false => Err(refused(
            path,
            format!(
                "it cannot be written: there is no folder '{}'",
                folder.display()
            ),
        )),
    }
}

/// The canonical path of a file that exists or will be made.
fn canonical(path: &Path) -> Option<PathBuf> {
    fs::canonicalize(path).ok().or_else(|| {
        Some(
            fs::canonicalize(folder_of(path))
                .ok()?
                .join(path.file_name()?),
        )
    })
}

pub fn refused(path: &Path, reason: impl Into<String>) -> Error {
    Error::Results {
        file: path.display().to_string(),
        reason: reason.into(),
    }
}

pub fn exists(path: &Path) -> Error {
    refused(path, "it already exists; use `overwrite` to replace it")
}

pub fn unwritable(path: &Path, error: &io::Error) -> Error {
    refused(
        path,
        format!(
            "it cannot be written ({}); name another place",
            write_error_text(error)
        ),
    )
}
