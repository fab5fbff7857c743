//! Every file that the program writes, under one rule: nothing that exists is replaced unless
//! `--overwrite` says so, no output is an input of the same command, and a file is written beside
//! its place and put there when it is whole. All of this is checked before the work begins, and
//! again for what was made since then.

use crate::atomic_file::{create_beside, folder_of, persist};
use crate::command::interrupt;
use crate::{Error, Result};
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Files that the outputs of a command must not replace.
#[derive(Clone, Debug, Default)]
pub struct Rule {
    inputs: Vec<PathBuf>,
    overwrite: bool,
}

impl Rule {
    /// The rule of a command that reads these files, or keeps its work in them.
    pub fn new(inputs: impl IntoIterator<Item = PathBuf>, overwrite: bool) -> Self {
        Self {
            inputs: inputs
                .into_iter()
                .filter_map(|path| located(&path))
                .collect(),
            overwrite,
        }
    }

    /// Adds another output of the command to the files not to replace.
    #[must_use]
    pub fn and_not(mut self, output: Option<&Path>) -> Self {
        self.inputs.extend(output.and_then(located));
        self
    }

    /// A file to be written, if it may be.
    ///
    /// # Errors
    /// [`Error::Results`] for a folder, an input, a file that exists, and a place that cannot be
    /// written to.
    pub fn file(&self, path: &Path) -> Result<Destination> {
        refuse_standard_output(path, "file, as in `output mine.toml`")?;
        let destination = self.place(path)?;
        if destination.is_file {
            // what cannot be written there is said now, not after the work
            create_beside(&destination.at).map_err(|error| unwritable(path, &error))?;
        }
        Ok(destination)
    }

    /// A setup file to be written, if it may be. It is TOML, and its name must not say that it is
    /// something else.
    ///
    /// # Errors
    /// As [`file`](Self::file); for the ending of another kind of file.
    pub fn setup_file(&self, path: &Path) -> Result<Destination> {
        let destination = self.file(path)?;
        match ending_of_a_file(path).filter(|ending| ending != "toml") {
            Some(ending) => {
                let reason = format!(
                    "a setup file is written in TOML, and .{ending} is the ending of another kind \
                     of file; use .toml"
                );
                Err(refused(path, &reason))
            }
            None => Ok(destination),
        }
    }

    /// Checks a destination without the permissions of its folder.
    ///
    /// # Errors
    /// As [`file`](Self::file).
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
            self.refuse_input(path, &located(path).unwrap_or_else(|| path.into()))?;
            return Ok(Destination {
                shown: path.into(),
                at: path.into(),
                is_file: true,
                may_replace: self.overwrite,
            });
        };
        if found.is_dir() {
            return Err(refused(path, "it is a folder; name a file"));
        }
        // through links, so that the file itself is compared and replaced, and not a link to it
        let at = fs::canonicalize(path).map_err(|error| match found.is_file() {
            true => unwritable(path, &error),
            false => refused(
                path,
                "it cannot be written: it is a pipe without a name in any folder; name a file",
            ),
        })?;
        self.refuse_input(path, &at)?;
        if found.is_file() && !self.overwrite {
            return Err(exists(path));
        }
        Ok(Destination {
            shown: path.into(),
            at,
            is_file: found.is_file(),
            may_replace: self.overwrite,
        })
    }

    fn refuse_input(&self, path: &Path, at: &Path) -> Result<()> {
        // a folder in the inputs means all files in it
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

    /// A folder for several files, some of whose names are known. If it does not exist, it is made
    /// with the files, but its parent is not: a misspelt path is an error, as for a file.
    ///
    /// # Errors
    /// [`Error::Results`] for a file, a folder that cannot be made or written to, and a file in it
    /// that may not be replaced.
    pub fn folder(&self, path: &Path, names: &[&str]) -> Result<Folder> {
        refuse_standard_output(path, "folder")?;
        if fs::metadata(path).is_ok_and(|found| !found.is_dir()) {
            return Err(refused(
                path,
                "it cannot be written to: it is a file; name a folder",
            ));
        }
        let is_new = !path.exists();
        if !path.is_dir() {
            in_a_folder(path)?;
            if let Some(ending) = ending_of_a_file(path) {
                let reason = format!(
                    "this is to be a folder, and .{ending} is the ending of a file; name a folder"
                );
                return Err(refused(path, &reason));
            }
            fs::create_dir(path).map_err(|error| unwritable(path, &error))?;
        }
        let folder = Folder {
            path: path.into(),
            rule: self.clone(),
        };
        for name in names {
            self.place(&path.join(name))?;
        }
        create_beside(&path.join("file")).map_err(|error| unwritable(path, &error))?;
        if is_new {
            // it was a trial: where the work ends without an answer there is no folder
            fs::remove_dir(path).map_err(|error| unwritable(path, &error))?;
        }
        Ok(folder)
    }
}

/// The ending of a name by which files are known that this program writes.
fn ending_of_a_file(path: &Path) -> Option<String> {
    let ending = path.extension()?.to_str()?.to_lowercase();
    let files = [
        "csv", "html", "json", "jsonl", "md", "parquet", "pdf", "png", "svg", "toml", "txt",
    ];
    files.contains(&ending.as_str()).then_some(ending)
}

/// A file that may be written.
#[derive(Clone, Debug)]
pub struct Destination {
    /// The name as typed, for messages.
    shown: PathBuf,
    /// The file itself, where the name was a link.
    at: PathBuf,
    /// True for a file, new or existing; false for a device or a pipe.
    is_file: bool,
    /// True if a file that appeared meanwhile may be replaced.
    may_replace: bool,
}

impl Destination {
    /// The file itself.
    pub fn path(&self) -> &Path {
        &self.at
    }

    /// Returns true for a file; a device or a pipe keeps nothing.
    pub fn is_file(&self) -> bool {
        self.is_file
    }

    /// Puts the whole file in its place.
    ///
    /// # Errors
    /// [`Error::Results`]; what stood there before then still does.
    pub fn write(&self, bytes: &[u8]) -> Result<()> {
        // a pipe without a reader may be waited for without end
        if !self.is_file {
            return self.put(bytes);
        }
        interrupt::undisturbed(&[&self.shown], || self.put(bytes))
    }

    /// Begins a file that is written piece by piece, and put in its place once it is whole.
    ///
    /// # Errors
    /// [`Error::Results`] where it cannot be written.
    pub fn begin(&self) -> Result<Pieces> {
        let to = match self.is_file {
            true => create_beside(&self.at).map(To::Beside),
            false => fs::OpenOptions::new()
                .write(true)
                .open(&self.at)
                .map(To::Device),
        };
        Ok(Pieces {
            to: to.map_err(|error| unwritable(&self.shown, &error))?,
            destination: self.clone(),
        })
    }

    fn put(&self, bytes: &[u8]) -> Result<()> {
        let written = || -> io::Result<()> {
            if !self.is_file {
                return fs::OpenOptions::new()
                    .write(true)
                    .open(&self.at)?
                    .write_all(bytes);
            }
            let mut file = create_beside(&self.at)?;
            file.write_all(bytes)?;
            self.end(file)
        };
        written().map_err(|error| self.failed(&error))
    }

    /// Puts a file that is whole in its place.
    fn end(&self, file: NamedTempFile) -> io::Result<()> {
        file.as_file().sync_all()?;
        Ok(persist(file.into_temp_path(), &self.at, self.may_replace)?)
    }

    fn failed(&self, error: &io::Error) -> Error {
        match error.kind() {
            ErrorKind::AlreadyExists => refused(
                &self.shown,
                "it was made by another program while this command ran; use `overwrite` to replace \
                 it",
            ),
            _ => unwritable(&self.shown, error),
        }
    }
}

/// A file that is written piece by piece.
pub struct Pieces {
    to: To,
    destination: Destination,
}

enum To {
    /// Beside its place, where it is gone again unless it is put there.
    Beside(NamedTempFile),
    Device(fs::File),
}

impl Pieces {
    /// Writes the next piece.
    ///
    /// # Errors
    /// [`Error::Results`], with why.
    pub fn write(&mut self, bytes: &[u8]) -> Result<()> {
        let written = match &mut self.to {
            To::Beside(file) => file.write_all(bytes),
            To::Device(file) => file.write_all(bytes),
        };
        written.map_err(|error| unwritable(&self.destination.shown, &error))
    }

    /// Puts the whole file in its place.
    ///
    /// # Errors
    /// [`Error::Results`]; what stood there before then still does.
    pub fn finish(self) -> Result<()> {
        let Self {
            to: To::Beside(file),
            destination,
        } = self
        else {
            return Ok(());
        };
        interrupt::undisturbed(&[&destination.shown], || {
            destination
                .end(file)
                .map_err(|error| destination.failed(&error))
        })
    }
}

/// A folder that may be written to.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
    rule: Rule,
}

impl Folder {
    /// Writes files, none before all of them may be.
    ///
    /// # Errors
    /// As [`Rule::file`] and [`Destination::write`].
    pub fn write<'a>(&self, files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> Result<usize> {
        fs::create_dir_all(&self.path).map_err(|error| unwritable(&self.path, &error))?;
        let place = |(name, bytes)| Ok((self.rule.place(&self.path.join(name))?, bytes));
        let files = files.into_iter().map(place).collect::<Result<Vec<_>>>()?;
        interrupt::undisturbed(&[&self.path], || {
            for (destination, bytes) in &files {
                destination.put(bytes)?;
            }
            Ok(files.len())
        })
    }

    /// Its name.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Refuses "-": several files, and a file put in place when whole, need names.
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
fn located(path: &Path) -> Option<PathBuf> {
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
            Error::why_unwritten(error)
        ),
    )
}
